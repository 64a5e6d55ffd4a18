//! Results of elements without a section.
//!
//! ```text
//!   4-------3     points: quantities at integration points, as fields give them or made of them
//!   | x   x |     nodes:  carried there, the mean of the elements that meet, material by material
//!   | x   x |
//!   1-------2
//! ```

mod lines;
mod nodes;
mod points;

pub use nodes::{AtNodes, NodalResults, nodal_results, regions};
pub use points::{Quantity, Solid, mises, solids};
