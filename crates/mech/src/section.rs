//! Beam sections and the stiffnesses that beams need of them.
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
//! `section/space.rs`. The axis of a beam need not be the centroid of its section:
//! `section/profile.rs`.

mod plane;
mod profile;
mod shape;
mod space;
mod taper;
mod trapezoid;
mod walls;

pub use plane::{BeamStiffness, TransverseShear, stiffness};
pub use profile::Profile;
pub use shape::Shape;
pub use space::{SpaceStiffness, space_stiffness};
pub use walls::{Fault, Wall};
