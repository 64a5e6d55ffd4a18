//! How is a law imposed?
//!
//! ```text
//!   inserted:  p = p(h) goes straight into the residual        (penalty)
//!   mixed:     p is an unknown lambda; p = P(h + lambda/kappa), lambda = p at the solution
//! ```

pub mod inserted;
pub mod mixed;

/// How pressure and stick are imposed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Enforcement {
    /// The law is inserted; not for hard contact or Lagrange stick.
    Inserted,
    /// Pressure, and the traction of Lagrange stick, are unknowns.
    Mixed {
        /// Reference stiffness of the pressure [F/L3]; changes the path of Newton, not the solution.
        normal: f64,
        /// Reference stiffness of the traction [F/L3], likewise.
        tangential: f64,
    },
}
