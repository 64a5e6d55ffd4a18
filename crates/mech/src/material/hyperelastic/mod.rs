//! Rubber: energies of the invariants of the isochoric deformation, or of its principal stretches,
//! and of the change of volume.
//!
//! ```text
//!   W = sum C_ij (I1 - 3)^i (I2 - 3)^j + sum (J - 1)^2i / D_i      neo-Hooke, Mooney-Rivlin, Yeoh
//!   W = mu sum c_i (I1^i - 3^i)/lm^(2i-2) + ((J^2 - 1)/2 - ln J)/D         Arruda, Boyce
//!   W = sum 2 mu_i/alpha_i^2 (sum_a l_a^alpha_i - 3) + sum (J - 1)^2i / D_i        Ogden
//! ```
//!
//! The energy is differentiated by its three invariants in forward arithmetic, tensors are made by
//! hand: docs/theory.md eqs. (3.42) and (3.43).

mod fit;
mod least_squares;
mod paths;
mod rubber;
mod stability;
#[cfg(test)]
mod tests;

pub use fit::{Form, Measured, NoFit};
pub use paths::Mode;
pub use rubber::{MOST_TERMS, Rubber, Volume};
