//! What stands in a slave face beyond what the mean gap over the face shows.
//!
//! ```text
//!     ----o-----------o----  slave face: the mean of its gap is nothing
//!          `-.     .-'
//!             `---'  master: this far in, unseen
//! ```

use crate::start::{length, less};
use slideline_mech::surface::mesh::area_between;
use slideline_model::{ContactPair, Formulation, Master, Model, NodeIndex};
use slideline_solve::observe::PairRow;
use std::collections::HashMap;

/// Depth beyond the mean over a slave face above which a face does not see what lies in it, in sizes of
/// the face [1]: edges and corners make 0.1 and more, round parts on coarse meshes up to 0.085 (measured).
const DEEP: f64 = 0.1;
/// The same while the pair is open [1], beside the corner of an analytical surface, which has no node that holds it: a
/// fifth, as straight sides show nothing then, and round parts with a corner elsewhere up to l/5R at a radius R. So much
/// is said of any pair that never closes: whatever its parts are, they stand in one another without a force.
const DEEP_AND_OPEN: f64 = 0.02;
/// Part of the way by which the parts have come together that they may have gone into one another before the pair closed
/// first [1]: forces are off by about that.
const LATE: f64 = 0.1;
/// The same where the pair carries most, and no more nodes are closed than a face has [1]: a flexible part gives way by so
/// much less than the parts are driven, and forces are too small by as much; where parts are stiff, meshes so coarse are off
/// by less. Where many faces carry, as in press fits, the mean is right whatever stands in each. (choice)
const SUNK: f64 = 0.25;

/// Part of a face by which sides that only touch stand in one another [1].
const ROUNDING: f64 = 1e-9;

/// A depth, where it is, and when.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Deep {
    /// In sizes of the slave face [1].
    pub depth: f64,
    /// Label of a node of the face.
    pub node: u64,
    pub increment: usize,
}

/// What a pair over faces does not see, over a run.
#[derive(Clone, Debug, Default)]
pub(super) struct Unseen {
    /// Whether its master has a sharp corner that stands out and that no node holds.
    pub has_corner: bool,
    /// Corners of a slave face.
    corners: usize,
    /// Sizes of the slave faces about each node [L].
    faces: HashMap<NodeIndex, f64>,
    deepest: Deep,
    /// The deepest of increments in which the pair is open.
    deepest_and_open: Deep,
    /// How far its sides stood in one another before it closed first, where that was most [L].
    before_it_closed: (f64, Deep),
    /// The same where it carries most.
    where_most: (f64, Deep),
}

impl Unseen {
    pub fn of(model: &Model, pair: &ContactPair) -> Self {
        let (faces, has_corner) = (face_sizes(model, pair), has_corner(&pair.master));
        let corners = if pair.faces.is_empty() { 2 } else { 4 };
        Self { has_corner, corners, faces, ..Self::default() }
    }

    /// Takes a committed increment in: whether the pair was ever closed, and whether it carries more than before.
    pub fn follow(
        &mut self,
        model: &Model,
        row: &PairRow,
        increment: usize,
        [touched, carries_most]: [bool; 2],
    ) {
        let node = row.unseen.map_or(0, |node| model.nodes.label(node));
        let now = Deep { depth: row.unseen_depth, node, increment };
        self.deepest = deeper(self.deepest, now);
        if row.closed == 0 {
            self.deepest_and_open = deeper(self.deepest_and_open, now);
        }
        let size = row.unseen.and_then(|node| self.faces.get(&node));
        let way = row.unseen_depth * size.copied().unwrap_or_default();
        if !touched && way > self.before_it_closed.0 {
            self.before_it_closed = (way, now);
        }
        if carries_most {
            let is_in_one = row.closed <= self.corners;
            self.where_most = if is_in_one { (way, now) } else { Default::default() };
        }
    }

    /// What is to be told, and what it means for the forces, of a pair whose sides have come together by `approach` [L].
    pub fn told(&self, touched: bool, approach: Option<f64>) -> Option<(Deep, String)> {
        let is_more = |own: Deep| own.depth > ROUNDING;
        let beyond = |(way, deep): (f64, Deep), part: f64| {
            approach.filter(|own| way > part * own && is_more(deep))
        };
        if self.deepest.depth > DEEP {
            return Some((self.deepest, "contact forces there are too small".into()));
        }
        if let Some(approach) = beyond(self.where_most, SUNK) {
            let (way, deep) = self.where_most;
            let part = 100.0 * way / (way + approach);
            let effect = format!(
                "that is {way:.3e}, and the parts have come together by {approach:.3e}: contact forces may be too small by \
                 about {part:.0} %"
            );
            return Some((deep, effect));
        }
        if self.deepest_and_open.depth <= DEEP_AND_OPEN {
            return None;
        }
        if self.has_corner {
            return Some((self.deepest_and_open, "the pair is open".into()));
        }
        if !touched {
            let effect = "the pair never closes, and no force acts";
            return Some((self.deepest_and_open, effect.into()));
        }
        let before = self.before_it_closed;
        let late = before.1.depth > DEEP_AND_OPEN && beyond(before, LATE).is_some();
        late.then(|| (before.1, "the pair is open: it closes late".into()))
    }

    /// One for tests, with a face of size one about the first node.
    #[cfg(test)]
    pub fn example() -> Self {
        Self { has_corner: true, corners: 2, faces: HashMap::from([(0, 1.0)]), ..Self::default() }
    }
}

/// Whether a master has a sharp corner that stands out and is no node: one of an analytical surface.
fn has_corner(master: &Master) -> bool {
    let Master::RigidSurface(surface) = master else { return false };
    slideline_solve::rigid_surface(surface).is_some_and(|own| own.is_sharp())
}

/// Mean sizes of the slave faces about each node, where contact is spread over them: their length in the plane, the root of
/// their area in space [L].
fn face_sizes(model: &Model, pair: &ContactPair) -> HashMap<NodeIndex, f64> {
    if pair.formulation != Formulation::Mortar {
        return HashMap::new();
    }
    let place = |node: NodeIndex| model.nodes.position(node);
    let lines = pair
        .elements
        .iter()
        .map(|own| (&own.nodes[..], length(less(place(own.nodes[1]), place(own.nodes[0])))));
    let faces = pair.faces.iter().map(|face| {
        let corners = face.cell().map_or(0, |cell| cell.faces.len());
        (&face.nodes[..], length(area_between(corners, |k| place(face.nodes[k]))).sqrt())
    });
    let mut all: HashMap<NodeIndex, (f64, f64)> = HashMap::new();
    for (nodes, size) in lines.chain(faces) {
        for &node in nodes {
            let (sum, count) = all.entry(node).or_default();
            (*sum, *count) = (*sum + size, *count + 1.0);
        }
    }
    all.into_iter().map(|(node, (sum, count))| (node, sum / count)).collect()
}

/// The deeper one of two places.
fn deeper(known: Deep, now: Deep) -> Deep {
    if now.depth > known.depth { now } else { known }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: of sides that only touch, what stands in a face and what they have come together are rounding, and nothing
    /// is told; of one that stands in a face by a twentieth, and has come together by less, it is.
    #[test]
    fn sides_that_only_touch_are_not_told() {
        let told = |depth: f64, approach: f64| {
            let deep = Deep { depth, ..Deep::default() };
            let own = Unseen { where_most: (depth, deep), ..Unseen::example() };
            own.told(true, Some(approach)).is_some()
        };
        assert!(!told(1e-16, 1e-17));
        assert!(told(0.05, 0.1));
    }
}
