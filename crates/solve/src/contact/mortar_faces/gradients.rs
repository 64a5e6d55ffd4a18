//! Derivatives of the integrals of all overlaps, each taken once.
//!
//! ```text
//!   an overlap: gap of corner 0, area of corner 0, gap of corner 1, ... then, where there is
//!   friction, both ways that were carried of corner 0, ...; a list over its nodes each
//! ```

use super::place::{FaceRoom, FaceState};
use super::rooms::{Asked, FaceMortarRooms};
use super::slave::FaceMortar;
use slideline_mech::contact::pair::mortar_faces::{
    Carried, Couple, Load, MOST_CORNERS, MOST_NODES, Overlap, Place,
};

/// Lists of an overlap: gap and area of every corner.
const PLAIN: usize = 2 * MOST_CORNERS;
/// Lists of an overlap with friction.
const ALL: usize = 2 * PLAIN;

/// Lists of an overlap in all.
pub fn lists(rubs: bool) -> usize {
    if rubs { ALL } else { PLAIN }
}

/// Derivatives of an overlap: of its gaps, areas, and carried ways.
#[derive(Clone, Copy)]
pub struct OverlapGradients<'a> {
    all: &'a [Place<f64>],
    nodes: usize,
}

impl<'a> OverlapGradients<'a> {
    /// Those that begin there.
    pub fn new(all: &'a [Place<f64>], nodes: usize) -> Self {
        Self { all, nodes }
    }

    /// Of the weighted gap of a corner.
    pub fn gap(&self, corner: usize) -> &'a [Place<f64>] {
        self.list(2 * corner)
    }

    /// Of its area.
    pub fn area(&self, corner: usize) -> &'a [Place<f64>] {
        self.list(2 * corner + 1)
    }

    /// Of its slip along a direction.
    pub fn slip(&self, corner: usize, direction: usize) -> &'a [Place<f64>] {
        self.list(PLAIN + 2 * corner + direction)
    }

    fn list(&self, place: usize) -> &'a [Place<f64>] {
        &self.all[place * self.nodes..][..self.nodes]
    }
}

impl FaceMortarRooms {
    /// Takes all derivatives, those of slips where there is friction.
    pub(super) fn take_gradients(&mut self, mortar: &FaceMortar, rubs: bool) {
        let Self { now, before, gradients, asked, begins, .. } = self;
        let asked = rubs.then_some(&asked[..]);
        gradients.clear();
        begins.clear();
        let sides = Sides { mortar, now, before };
        for face in 0..now.faces.len() {
            begins.push(gradients.len());
            for overlap in &now.faces[face].overlaps {
                sides.add((face, overlap), asked, gradients);
            }
        }
    }
}

struct Sides<'a> {
    mortar: &'a FaceMortar,
    now: &'a FaceRoom,
    before: &'a FaceRoom,
}

impl Sides<'_> {
    fn add(
        &self,
        (face, overlap): (usize, &Overlap),
        asked: Option<&[Asked]>,
        into: &mut Vec<Place<f64>>,
    ) {
        let state = &self.now.faces[face];
        let couple = state.couple(&self.mortar.faces[face], overlap);
        let (begin, nodes) = (into.len(), couple.count());
        into.resize(begin + lists(asked.is_some()) * nodes, [0.0; 3]);
        let (plain, slips) = into[begin..].split_at_mut(PLAIN * nodes);
        couple.pull(overlap, &plain_loads(), apart(plain, nodes));
        if let Some(asked) = asked {
            self.carry((face, overlap), &couple, asked, apart(slips, nodes));
        }
    }

    fn carry(
        &self,
        (face, overlap): (usize, &Overlap),
        couple: &Couple<'_, f64>,
        asked: &[Asked],
        into: [&mut [Place<f64>]; PLAIN],
    ) {
        let (own, state) = (&self.mortar.faces[face], &self.now.faces[face]);
        let (slave, master) = self.before((face, overlap), state);
        let carried: [Carried<'_>; PLAIN] = std::array::from_fn(|k| {
            let (corner, direction) = (k / 2, k % 2);
            let point = state.given[corner].map(|given| asked[own.points[given]]);
            let asked = point.unwrap_or_default();
            let by_area = if asked.area > 0.0 { 1.0 / asked.area } else { 0.0 };
            Carried {
                corner,
                direction: asked.directions[direction],
                factor: by_area,
                area: -asked.ways.0[direction] * by_area,
                slave: &slave,
                master: &master,
            }
        });
        couple.pull_carried(overlap, &carried, into);
    }

    /// Nodes of both sides of an overlap at the last commit.
    fn before(
        &self,
        (face, overlap): (usize, &Overlap),
        state: &FaceState,
    ) -> ([Place<f64>; MOST_NODES], [Place<f64>; MOST_NODES]) {
        before((self.mortar, self.before), (face, overlap), state)
    }
}

/// Nodes of both sides of an overlap of `state` at the last commit.
pub fn before(
    (mortar, before): (&FaceMortar, &FaceRoom),
    (face, overlap): (usize, &Overlap),
    state: &FaceState,
) -> ([Place<f64>; MOST_NODES], [Place<f64>; MOST_NODES]) {
    let slave = mortar.faces[face].places(&before.nodes).nodes;
    (slave, before.master_places(state.masters[overlap.master].nodes()))
}

/// Gap and area of every corner.
fn plain_loads() -> [Load<f64>; PLAIN] {
    std::array::from_fn(|k| {
        let mut load = Load::nothing();
        match k % 2 {
            0 => load.gap[k / 2] = 1.0,
            _ => load.area[k / 2] = 1.0,
        }
        load
    })
}

/// A list in parts of so many nodes.
fn apart(list: &mut [Place<f64>], nodes: usize) -> [&mut [Place<f64>]; PLAIN] {
    let mut parts = list.chunks_exact_mut(nodes);
    std::array::from_fn(|_| parts.next().unwrap_or_default())
}
