//! The contact problem of one Newton iteration, solved exactly.
//!
//! ```text
//!        structure + geometry: linear          laws: as they are
//!     K du + r + sum A (p a + tau b) = 0       p = p(h),  tau = tau(slip, p)
//!                 \                             /
//!                  h = h0 + a.du ,  slip = s0 + b.du
//! ```
//!
//! A Newton iteration linearises the structure and the geometry of contact,
//! but not the contact laws: a softened law climbs by decades within one
//! clearance, a hard one has no slope at all, and a linearised law therefore
//! overshoots from iteration to iteration. Here the laws are kept. With the
//! responses W = K^-1 A (a, b) of the few points that may touch, overclosures
//! and slips are linear in the multipliers, and a small dense system remains,
//! one row a pressure or a traction, which a semismooth Newton method solves
//! to round-off. See docs/theory.md, "The contact step".
//!
//! Points that are closed already augment K a moderate stiffness s (it enters K
//! and leaves the multipliers again: lambda = q + s (e - e0)), so that a body
//! held by contact alone has a regular K. The laws of friction, and with them
//! the coupling of traction and pressure, stand in the condensed contact problem; K itself
//! is unsymmetric only by the turning of the tractions with the surface.

mod augment_anew;
mod augmentation;
mod compliance;
mod condensed;
mod context;
mod contradiction;
mod convex;
mod descent;
mod inserted;
mod integration_points;
mod iterate;
mod jam;
mod laws;
mod matrix_free;
mod pivoting;
mod points;
mod rows;
mod settle;
mod slopes;
mod solve;
mod step_room;
mod system;

pub use augmentation::Stiffness;
pub use condensed::LinearisedContact;
pub use context::LawContext;
pub use contradiction::Contradiction;
pub use inserted::HeldMultipliers;
pub use points::{Augmentation, LinearPoint, LinearPoints, LinearRows, Sliding};

#[cfg(test)]
mod tests;
