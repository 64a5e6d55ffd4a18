//! Contact of surface with surface in space: a point a slave corner, spread over the faces about it
//! and over all that these face.
//!
//! ```text
//!     /____/____/____/     faces of the master        row of corner j: nodes of the faces about
//!   o-----o-----o                                     it and of what faces these
//!   |     |(j)  |
//! ```
//!
//! docs/theory.md section 5.11

pub mod depth;
pub mod gradients;
pub mod near;
pub mod place;
pub mod rooms;
pub mod rows;
pub mod slave;
pub mod standing;
pub mod tangent;
