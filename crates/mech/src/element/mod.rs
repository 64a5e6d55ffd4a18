//! Elements: cell, quadrature, kinematics and material, multiplied in a kernel.
//!
//! ```text
//!   cell (shape functions, faces)  x  quadrature  x  kinematics  x  section or material
//!                \______________ a Kernel: the elements of one block ______________/
//! ```
//!
//! An element is its strain energy; where speed asks for it its derivatives are written by hand and
//! tested against it.

pub mod b21;
pub mod b22;
pub mod b23;
mod beam_strains;
pub mod cell;
pub mod heated;
mod instances;
mod kernel;
pub mod mixed;
pub mod quadrature;
pub mod solid;
pub mod space_beam;
pub mod spring;
pub mod truss;

pub use b21::Beam21;
pub use b22::Beam22;
pub use b23::Beam23;
pub use beam_strains::{BeamSectionForces, BeamStrains};
pub use heated::{BeamHeat, HeatedBeams};
pub use instances::Instances;
pub use kernel::{
    Element, Failure, Kernel, MOST_NODES, MOST_VARIABLES, Response, Scale, Strains, Surroundings,
    Temperature,
};
pub use mixed::Mixed;
pub use solid::Solids;
pub use space_beam::{SpaceBeam, SpaceBeams};
pub use spring::{
    AxialSpring, DirectedSpring, GroundSpring, RadialSpring, RelativeSpring, SpringLaw,
};
pub use truss::{Bar, Trusses};
