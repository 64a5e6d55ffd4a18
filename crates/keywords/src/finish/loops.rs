//! Outlines of plane parts as open chains, which masters are.
//!
//! ```text
//!    o---o---o          a closed outline is opened at the face that is farthest
//!    |       x  <-      from the other part
//!    o---o---o
//! ```

use std::collections::HashMap;

use slideline_model::NodeIndex;

use super::skin::{Patch, Skin};
use crate::draft::Draft;

/// The outlines of a patch of the plane, each an open chain; `about` is what they meet.
pub(super) fn open_chains(patch: &Patch, about: &Patch, skin: &Skin, draft: &Draft) -> Vec<Patch> {
    let centre = centre(about, skin, draft);
    let ends = |face: usize| {
        let nodes = &skin.faces[face].nodes;
        [nodes[0], nodes[nodes.len() - 1]]
    };
    let mut at: HashMap<NodeIndex, Vec<usize>> = HashMap::new();
    for &face in patch {
        ends(face).into_iter().for_each(|node| at.entry(node).or_default().push(face));
    }
    let (mut left, mut chains) = (patch.clone(), Vec::new());
    while let Some(first) = left.pop_first() {
        let (mut chain, mut open) = (Patch::from([first]), vec![first]);
        while let Some(face) = open.pop() {
            for next in ends(face).into_iter().flat_map(|node| &at[&node]) {
                if left.remove(next) {
                    chain.insert(*next);
                    open.push(*next);
                }
            }
        }
        let has_end = chain.iter().flat_map(|&face| ends(face)).any(|node| at[&node].len() == 1);
        if !has_end {
            let distance = |&face: &usize| distance_to(face, centre, skin, draft);
            let farthest = |a: &usize, b: &usize| distance(a).total_cmp(&distance(b));
            let drop = chain.iter().copied().max_by(|a, b| farthest(a, b));
            drop.inspect(|face| {
                chain.remove(face);
            });
        }
        chains.push(chain);
    }
    chains
}

/// The centre of the box about a patch [L].
fn centre(patch: &Patch, skin: &Skin, draft: &Draft) -> [f64; 3] {
    let mut bounds = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for &node in patch.iter().flat_map(|&face| &skin.faces[face].nodes) {
        for (k, x) in draft.model.nodes.position(node).into_iter().enumerate() {
            bounds.0[k] = bounds.0[k].min(x);
            bounds.1[k] = bounds.1[k].max(x);
        }
    }
    std::array::from_fn(|k| 0.5 * (bounds.0[k] + bounds.1[k]))
}

/// Distance of a face's nearer end from a place [L].
fn distance_to(face: usize, place: [f64; 3], skin: &Skin, draft: &Draft) -> f64 {
    let away = |node: &NodeIndex| {
        let at = draft.model.nodes.position(*node);
        (0..3).map(|k| (at[k] - place[k]).powi(2)).sum::<f64>().sqrt()
    };
    skin.faces[face].nodes.iter().map(away).fold(f64::INFINITY, f64::min)
}
