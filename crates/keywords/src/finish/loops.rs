//! Outlines of plane parts, one by one, which masters are.
//!
//! ```text
//!    o-------o
//!    | o---o |      a plate with a hole has two
//!    | o---o |
//!    o-------o
//! ```

use std::collections::HashMap;

use slideline_model::NodeIndex;

use super::skin::{Patch, Skin};

/// The outlines of a patch of the plane: faces that are joined at their ends.
pub(super) fn outlines(patch: &Patch, skin: &Skin) -> Vec<Patch> {
    let ends = |face: usize| skin.faces[face].ends();
    let mut at: HashMap<NodeIndex, Vec<usize>> = HashMap::new();
    for &face in patch {
        ends(face).into_iter().for_each(|node| at.entry(node).or_default().push(face));
    }
    let (mut left, mut outlines) = (patch.clone(), Vec::new());
    while let Some(first) = left.pop_first() {
        let (mut outline, mut open) = (Patch::from([first]), vec![first]);
        while let Some(face) = open.pop() {
            for next in ends(face).into_iter().flat_map(|node| &at[&node]) {
                if left.remove(next) {
                    outline.insert(*next);
                    open.push(*next);
                }
            }
        }
        outlines.push(outline);
    }
    outlines
}
