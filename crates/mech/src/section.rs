//! Beam sections and the three stiffnesses a plane beam needs.
//!
//! ```text
//!      +---------------+  -          ___          +-------+        =======  b2, t2
//!      |       2       |  |         / 2 \         | +---+ |           |
//!      |       ^       |  | height |  ^  |        | | ^ | |           | t3
//!      |       +--> 1  |  |         \___/         | +---+ |           |
//!      +---------------+  -         radius        +-------+        =======  b1, t1
//!      |<--- width --->|
//! ```
//!
//! Axis 2 is in the plane of bending, axis 1 out of it. Beams in space bend about both and twist:
//! `section/space.rs`.

mod plane;
mod shape;
mod space;

pub use plane::{BeamStiffness, TransverseShear, stiffness};
pub use shape::Shape;
pub use space::{SpaceStiffness, space_stiffness};
