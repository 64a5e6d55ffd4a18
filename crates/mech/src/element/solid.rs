//! Solids: cell x quadrature x kinematics x formulation x material, one kernel.
//!
//! ```text
//!    4-------3        displacements q --> H = du/dX at every integration point
//!    | x   x |                              |  formulation: mean dilation, incompatible modes,
//!    | x   x |                              v  hourglass control, or none
//!    1-------2        material: stress tau, moduli c, state
//!                                           |
//!                                           v
//!        force  sum w tau : grad,   tangent  sum w grad : (c + 1 tau) : grad
//! ```
//!
//! grad: derivatives by position in the deformed body, w: undeformed volume of a point;
//! docs/theory.md section 3.5. Small displacements are the same with F = 1 and without the stress
//! in the tangent. Generic in the dimension `D`, the nodes `N` and the points `P`.

mod bending;
mod centre;
mod dilation;
mod enhancement;
mod evaluate;
mod fields;
mod gather;
mod heat;
mod incompatible;
mod kernel;
mod modes;
mod pivoted;
mod place;
mod plane_stress;
mod point;
mod pressures;
mod recipe;
mod response;
mod results;
mod solids;
mod told;
mod turned;

pub use place::{Reference, smallest_jacobian, worst_node};
pub use recipe::{Formulation, Interpolation, Kinematics, Recipe, states};
pub use solids::Solids;
pub use told::Told;
