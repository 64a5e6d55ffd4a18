//! A slave face and a face of the master in a configuration.

use super::clip::Overlap;
use super::ends::Ends;
use super::face_places::{FacePlaces, Plane};
use super::shapes::MOST_NODES;
use crate::differentiate::Real;

/// A slave face and a face of the master.
#[derive(Debug, Clone, Copy)]
pub struct Couple<'a, R> {
    /// The slave face.
    pub slave: &'a FacePlaces<R>,
    /// Undeformed area by the coordinates of the cell, at the nodes of the slave [L2].
    pub measure: &'a [f64; MOST_NODES],
    /// The face of the master.
    pub master: &'a FacePlaces<R>,
    /// Where they are at ends of their surfaces.
    pub ends: Ends,
}

impl<R: Real> Couple<'_, R> {
    /// The plane that an overlap is seen in.
    pub(super) fn plane(&self, overlap: &Overlap) -> Option<Plane<R>> {
        self.slave.plane(overlap.piece)
    }
}
