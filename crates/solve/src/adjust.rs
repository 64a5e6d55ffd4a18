//! Slave nodes that begin on their master: `ADJUST`.
//!
//! ```text
//!      o  o  o          the nodes near the master move along its normal onto it,
//!     _____________     as the contact sees it: smoothed, with its arcs; nothing is strained
//! ```

use crate::commit::initial_contact;
use crate::observe::ContactRow;
use slideline_diag::{Code, Diagnostic};
use slideline_model::{Adjust, ContactPair, Model, NodeIndex};

/// Most moves of a node: a curved master is met by Newton's method, mean gaps of faces one by one.
const MOST: usize = 100;
/// Gaps that are left, over the size of the model [1].
const CLOSE: f64 = 1e-13;

/// Moves the slave nodes of every pair that asks for it, and says which.
pub fn adjust(model: &mut Model) -> Vec<Diagnostic> {
    let asked = |pair: &ContactPair| pair.adjust != Adjust::Nothing;
    let pairs: Vec<usize> =
        (0..model.contact_pairs.len()).filter(|&p| asked(&model.contact_pairs[p])).collect();
    pairs.into_iter().filter_map(|pair| adjust_pair(pair, model)).collect()
}

fn adjust_pair(place: usize, model: &mut Model) -> Option<Diagnostic> {
    let positions = model.nodes.iter().flat_map(|node| node.position);
    let reach = positions.fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let pair = &model.contact_pairs[place];
    let moves = |row: &&ContactRow| {
        let open = row.opening;
        row.pair == place
            && open.is_finite()
            && match &pair.adjust {
                Adjust::Nothing => false,
                Adjust::Within(distance) => open <= *distance,
                Adjust::Nodes(nodes) => nodes.contains(&row.node),
            }
    };
    let rows = initial_contact(model);
    let moved: Vec<NodeIndex> = rows.iter().filter(moves).map(|row| row.node).collect();
    let before: Vec<[f64; 3]> = moved.iter().map(|&node| model.nodes.position(node)).collect();
    for _ in 0..MOST {
        let mut largest = 0.0_f64;
        for row in initial_contact(model) {
            if row.pair != place || !row.opening.is_finite() || !moved.contains(&row.node) {
                continue;
            }
            largest = largest.max(row.opening.abs());
            let at = model.nodes.position(row.node);
            let onto = std::array::from_fn(|k| at[k] - row.opening * row.normal[k]);
            model.nodes.place(row.node, onto);
        }
        if largest <= CLOSE * reach {
            break;
        }
    }
    said(&model.contact_pairs[place], model, (&moved, &before))
}

/// How many nodes were moved, and the furthest one.
fn said(
    pair: &ContactPair,
    model: &Model,
    (moved, before): (&[NodeIndex], &[[f64; 3]]),
) -> Option<Diagnostic> {
    let way = |(&node, before): (&NodeIndex, &[f64; 3])| {
        let now = model.nodes.position(node);
        let way = (0..3).map(|k| (now[k] - before[k]).powi(2)).sum::<f64>().sqrt();
        (way, node)
    };
    let ways = moved.iter().zip(before).map(way).filter(|(way, _)| *way > 0.0);
    let (count, (furthest, node)) = ways.fold((0, (0.0, 0)), |(count, most), own| {
        (count + 1, if own.0 > most.0 { own } else { most })
    });
    let label = model.nodes.name(node);
    let message = format!(
        "ADJUST moved {count} slave node{} of {} onto the master, node {label} by {furthest:.4e}",
        if count == 1 { "" } else { "s" },
        pair.name,
    );
    let help = "the nodes are moved before the first step, without strain; check that no element \
                is out of shape where the way is long";
    (count > 0).then(|| Diagnostic::note(Code("SL0417"), message).at(pair.origin).help(help))
}
