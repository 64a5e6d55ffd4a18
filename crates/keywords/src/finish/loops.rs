//! Outlines of plane parts, one by one, which masters are.
//!
//! ```text
//!    o-------o
//!    | o---o |      a plate with a hole has two
//!    | o---o |
//!    o-------o
//! ```

use slideline_model::NodeIndex;

use super::hollows::{Outlines, joined};
use super::skin::{Patch, Skin};
use crate::draft::Draft;

/// The outlines of a patch of the plane: faces that are joined at their ends.
fn outlines(patch: &Patch, skin: &Skin) -> Vec<Patch> {
    let faces: Vec<usize> = patch.iter().copied().collect();
    let ends: Vec<_> = faces.iter().map(|&face| skin.faces[face].ends()).collect();
    let pieces = joined(&ends).into_iter();
    pieces.map(|piece| piece.into_iter().map(|place| faces[place]).collect()).collect()
}

/// The outlines of a master, each with the slaves that may meet it: what stands outside a hollow never
/// meets its wall, nor what stands in it anything else.
pub(super) fn within_reach(
    (slave, master): (&Patch, &Patch),
    skin: &Skin,
    draft: &Draft,
) -> Vec<(Patch, Patch)> {
    let nodes = &draft.model.nodes;
    let [slaves, masters] = [slave, master].map(|patch| outlines(patch, skin));
    let known = |all: &[Patch]| {
        let piece = |own: &Patch| {
            let ends = own.iter().map(|&face| skin.faces[face].ends()).collect();
            (ends, own.iter().all(|&face| skin.faces[face].face.is_some()))
        };
        Outlines::new(&all.iter().map(piece).collect::<Vec<_>>(), nodes)
    };
    let met = |by: &Outlines, all: &[Patch]| {
        let nodes_of = |own: &Patch| -> Vec<NodeIndex> {
            own.iter().flat_map(|&face| skin.faces[face].ends()).collect()
        };
        all.iter().map(|own| by.met_by(&nodes_of(own), nodes)).collect::<Vec<_>>()
    };
    let (of_masters, of_slaves) = (met(&known(&masters), &slaves), met(&known(&slaves), &masters));
    let with = masters.into_iter().enumerate().map(|(place, master)| {
        let own = slaves.iter().enumerate();
        let may = own.filter(|(own, _)| of_masters[*own][place] && of_slaves[place][*own]);
        (may.flat_map(|(_, slave)| slave.iter().copied()).collect::<Patch>(), master)
    });
    with.filter(|(slave, _)| !slave.is_empty()).collect()
}
