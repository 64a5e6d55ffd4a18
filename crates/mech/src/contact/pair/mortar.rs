//! Contact of surface with surface in the plane: a slave face against all that faces it.
//!
//! ```text
//!        n_a          n(t)         n_b       normals of the slave, means at its nodes
//!         \     ________|_________ /
//!     -----o---'        |         o-----     master
//!           \  segment  |  segment|
//!   o--------o----------x---------o------o   slave face; every projected end of a master
//!                                            face bounds a segment
//! ```
//!
//! Gaps are weighted with the shape functions of the slave, none of which is negative.
//! [docs/theory.md, section 5.10]

mod cover;
mod curve;
mod face;
mod integrals;
mod normals;
mod pull;
mod reference;
mod sweep;

pub use cover::Cover;
pub use curve::{Curve, MOST_CONTROLS, Place};
pub use face::{FIRST_MASTER, FacePlaces, MortarFace};
pub use integrals::{Bound, Integrals, Segment, Shares};
pub use pull::Direction;
pub use reference::Reference;
pub use sweep::{FaceTangent, SweepRoom};

#[cfg(test)]
mod tests;
