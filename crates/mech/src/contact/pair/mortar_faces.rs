//! Contact of surface with surface in space: a slave face against the faces that it faces.
//!
//! ```text
//!      ___________            pieces of the master, seen along the normal of a piece of the
//!     /    /     /|           slave; every overlap is a polygon on the slave, and its corners
//!    o----o-----o |           follow both sides
//!    | ___|____ | |
//!    o---------o--'
//! ```
//!
//! Gaps are weighted with the linear functions of the corners of the slave, none of which is
//! negative. [docs/theory.md, section 5.11]

mod clip;
mod couple;
mod cover;
mod ends;
mod face_places;
mod over;
mod places;
mod pull;
mod shapes;
mod standing;
mod station;
mod sums;
mod sweep;

pub use clip::{Corner, Overlap};
pub use couple::Couple;
pub use cover::{Cover, Faced, Looking};
pub use ends::{Ends, FaceEnds};
pub use face_places::FacePlaces;
pub use places::Place;
pub use pull::{Carried, Load};
pub use shapes::{MOST_CORNERS, MOST_NODES, corners, pieces};
pub use standing::Standing;
pub use station::reference_areas;
pub use sums::{Sums, Weights};
pub use sweep::{SweepRoom, Swept};

#[cfg(test)]
mod tests;
