//! Elements: one folder each. An element is its strain energy.

pub mod b21;
pub mod spring;

pub use b21::{Beam21, BeamSectionForces, BeamStrains};
pub use spring::{AxialSpring, GroundSpring};
