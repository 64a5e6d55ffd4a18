//! Elements: one folder each. An element is its strain energy.

pub mod b21;
pub mod b22;
pub mod b23;
pub mod mixed;
pub mod spring;

pub use b21::{Beam21, BeamSectionForces, BeamStrains};
pub use b22::Beam22;
pub use b23::Beam23;
pub use mixed::Mixed;
pub use spring::{AxialSpring, GroundSpring};
