//! Contact of surface with surface in the plane: a point a slave node, spread over the faces about
//! it and over all that these face.
//!
//! ```text
//!        curves of the master           row of node j: nodes of both faces, of their
//!     ---o------o------o---             neighbours, which turn the normals, of what faces them,
//!   o------o---(j)---o------o           and of what faced them at the last commit
//! ```
//!
//! docs/theory.md section 5.10

mod curves;
mod near;
mod place;
mod rows;
mod slave;
mod tangent;

pub use place::MortarRoom;
pub use rows::MortarRooms;
pub use slave::Mortar;
pub use tangent::MortarScratch;
