//! Sharp edges that cross sharp edges in space, as contact points of their own.
//!
//! ```text
//!          | master line
//!    o----x|----o-----o  slave line      x: a crossing, a point of the slave line that goes along with it
//!          |
//! ```
//!
//! docs/theory.md section 5.18

mod allowed;
mod near;
mod places;
mod prepare;
mod rows;
pub(super) mod sides;
mod tangent;
