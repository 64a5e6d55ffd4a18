//! Surfaces of space as faces: their places, tangents and normals; analytical ones too.
//!
//! ```text
//!     o-------o-------o      a face is a patch over its nodes;
//!     | patch |       |      normals at the nodes, means of the faces that
//!     o-------o-------o      meet there, may smooth it
//! ```

pub mod axes;
mod drawn_edges;
mod edges;
pub mod jet;
pub mod lone;
pub mod meridian;
pub mod mesh;
pub mod mirror;
pub mod patch;
pub(crate) mod round;
mod smoothing;
pub mod star;
pub mod swept;
