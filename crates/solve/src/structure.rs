//! The elements of a step: numbered by the plan, made of their kernels, gathered.
//!
//! ```text
//!   u --> element 1 --> [force | tangent]  \
//!   u --> element 2 --> [force | tangent]   >-- gather in fixed order --> f, K
//!   u --> element 3 --> [force | tangent]  /
//! ```
//!
//! Elements write forces of their own and a gather in fixed order sums them, so that
//! the sum has the same bits on any number of threads. Tangents are gathered a few
//! elements at a time, and never all stored. The dofs of all elements lie behind one
//! another: an element takes as much as it needs. What an element is, only its block's
//! kernel knows.

mod block;
mod contributions;
mod elements;
mod evaluate;
mod flux;
mod kernels;
mod nodal_forces;
mod numbering;
mod partial;
mod presence;
mod reference;
mod stresses;
mod sums;
#[cfg(test)]
mod tests;

pub use contributions::Contributions;
pub use elements::{Ambient, Configuration, Structure};
pub use evaluate::{FailedElement, Gather, Keep, Product};
pub use flux::Flux;
pub use kernels::Kernels;
pub use numbering::ElementNumbering;
pub use presence::Held;
pub use reference::Reference;
