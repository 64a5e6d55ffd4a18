//! Contact of surface with surface in the plane: a point a slave node, spread over the faces about
//! it and over all that these face.
//!
//! ```text
//!        curves of the master           row of node j: nodes of both faces, of their
//!     ---o------o------o---             neighbours, which turn the normals,
//!   o------o---(j)---o------o           and of what faces them
//! ```
//!
//! docs/theory.md section 5.10

pub mod curves;
pub mod depth;
pub mod near;
pub mod place;
pub mod rooms;
pub mod rows;
pub mod slave;
pub mod tangent;
