//! Linear systems of the solver: `analyse(pattern) -> refactor(values) -> solve`.
//!
//! ```text
//!   beam chain with contact          its matrix
//!
//!   |o--o--o--o--o                   band of the chain  . . .
//!            (  )  rigid circle        .  .  .  .  .  | border: dofs of the
//!             o    reference node      - - - - - - -  + reference node
//! ```
//!
//! Factorisations stand behind the trait [`LinearSystem`]; those of this crate are chosen by the
//! predicted number of operations: a contiguous band with dense border ([`BackEnd::Banded`]), a
//! sparse factorisation ([`BackEnd::Sparse`]), and for large definite systems whose rigid motions
//! are known an iteration with a multigrid cycle ([`BackEnd::Multigrid`]). Others (of many processes, say) come with a factory,
//! [`Analyse`]. Every solution is checked by its residual; failures are typed and name the equation
//! in the caller's numbering.
//!
//! ```
//! use slideline_linalg::{Kind, Pattern, analyse};
//! let pattern = Pattern::from_pairs(2, [(0, 1)].into_iter());
//! let mut solver = analyse(&pattern, Kind::Symmetric);
//! solver.refactor(&pattern, &[2.0, -1.0, -1.0, 2.0])?;
//! let mut x = [1.0, 0.0];
//! solver.solve(&mut x)?;
//! assert!((x[0] - 2.0 / 3.0).abs() < 1e-15);
//! # Ok::<(), slideline_linalg::SolveError>(())
//! ```

mod band_ldlt;
mod band_lu;
mod banded;
mod border;
mod choice;
mod conjugate;
mod dense;
mod dense_fronts;
mod error;
mod followed;
mod fronts;
mod kernel;
pub mod krylov;
mod multifrontal;
mod multigrid;
mod near;
mod ordering;
mod orders;
mod pattern;
mod precision;
mod refused;
mod residual;
mod scaling;
mod single;
mod skew;
mod solver;
mod sparse;
mod system;

pub use choice::{BuiltIn, OnThreads, analyse, analyse_with};
pub use dense::{DenseLu, reduce_rows};
pub use error::{FactorReport, SolveError};
pub use near::Use;
pub use pattern::{Matrix, Pattern};
pub use solver::Solver;
pub use system::{Analyse, BackEnd, Description, Interface, Kind, LinearSystem};
