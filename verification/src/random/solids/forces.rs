//! What acts on every part by itself: supports, loads and the pairs it belongs to.
//!
//! ```text
//!     RF, loads                   on every part:  sum RF + sum loads + sum of its pairs = 0
//!       |  |
//!    [ part 1 ]
//!      ^  ^  pair 1/0
//!    [ part 0 ]
//! ```

use super::case::Case;
use super::draft::{Draft, Surface, World};
use crate::random::files::Rows;

/// The force of a pair on its slave, and the parts of slave and master.
#[derive(Clone, Copy, Debug)]
pub struct PairForce {
    parts: [usize; 2],
    force: [f64; 3],
}

/// The force in a row of the table of pairs, in the units and axes of the draft; `None` where a side
/// is no part.
pub fn pair_force(case: &Case, rows: &Rows, row: usize) -> Option<PairForce> {
    let draft = &case.draft;
    let (slave, master) = rows.text(row, "pair").split_once('/')?;
    let third = if draft.world == World::Space { rows.number(row, "force_z") } else { 0.0 };
    let force = [rows.number(row, "force_x"), rows.number(row, "force_y"), third];
    let force = case.placed.back(force).map(|x| x / case.placed.units.force);
    Some(PairForce { parts: [part(draft, slave)?, part(draft, master)?], force })
}

/// The part that a surface belongs to.
fn part(draft: &Draft, name: &str) -> Option<usize> {
    let number = |prefix: &str| {
        let rest = name.strip_prefix(prefix)?;
        rest.split(':').next()?.parse::<usize>().ok()
    };
    let of = |surface: Surface| match surface {
        Surface::Side(part, _) => Some(part),
        Surface::Disc(_) => None,
    };
    number("P")
        .or_else(|| number("SL").and_then(|pair| of(draft.pairs[pair].slave)))
        .or_else(|| number("MA").and_then(|pair| of(draft.pairs[pair].master)))
}

/// A force on a node.
pub type NodeForce = (usize, [f64; 3]);

/// A part whose forces do not balance: how far, in the largest force of all.
pub fn unbalanced(
    draft: &Draft,
    (reactions, loads): (&[[f64; 3]], &[NodeForce]),
    pairs: &[PairForce],
) -> Option<(usize, f64, f64)> {
    if !draft.discs.is_empty() || draft.world == World::Rings {
        return None;
    }
    draft.parts.iter().enumerate().find_map(|(own, (part, _))| {
        let mut nodes: Vec<usize> = part.cells.iter().flatten().copied().collect();
        nodes.sort_unstable();
        nodes.dedup();
        let (mut sum, mut size) = ([0.0; 3], 0.0_f64);
        let mut act = |force: [f64; 3], sign: f64| {
            for k in 0..3 {
                sum[k] += sign * force[k];
                size += force[k].abs();
            }
        };
        nodes.iter().for_each(|&node| act(reactions[node], 1.0));
        let on_part = loads.iter().filter(|(node, _)| nodes.binary_search(node).is_ok());
        on_part.for_each(|(_, load)| act(*load, 1.0));
        for pair in pairs {
            for (side, sign) in pair.parts.into_iter().zip([1.0, -1.0]) {
                if side == own {
                    act(pair.force, sign);
                }
            }
        }
        let off = sum.iter().map(|x| x * x).sum::<f64>().sqrt();
        (off > 0.0).then_some((own, off, size)).filter(|&(_, off, size)| off > 1e-6 * size)
    })
}
