//! Faces of rigid meshes: every element is a face with two sides.
//!
//! ```text
//!    4-----3
//!    |     |    SPOS: the side from which the nodes run counter-clockwise,
//!    1-----2    in the plane the one to the left of the way from 1 to 2
//! ```

use slideline_model::NodeIndex;

use crate::draft::Draft;
use crate::surfaces::{Side, Stretch};

/// The elements of rigid meshes among those of a list, and the others.
pub(super) fn apart(elements: &[usize], draft: &Draft) -> (Vec<usize>, Vec<usize>) {
    elements.iter().partition(|&&index| is_rigid(index, draft))
}

/// Whether an element is one of a rigid mesh.
pub(super) fn is_rigid(index: usize, draft: &Draft) -> bool {
    draft.elements[index].kind.bare().is_some()
}

/// The nodes of a rigid element in space, counter-clockwise as seen from the side that a surface
/// names, else as seen from its positive side; `None` where one is undefined, which has been said.
pub(super) fn of(index: usize, stretch: &Stretch, draft: &Draft) -> Option<Vec<NodeIndex>> {
    let element = draft.elements[index];
    let own = element.nodes().iter().map(|&label| draft.model.nodes.find(label));
    let mut nodes: Vec<NodeIndex> = own.collect::<Option<_>>()?;
    if stretch.side == Some(Side::Negative) {
        nodes.reverse();
    }
    Some(nodes)
}
