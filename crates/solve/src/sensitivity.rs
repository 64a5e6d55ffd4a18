//! Derivatives of a run by the parameters of its model, by direct differentiation.
//!
//! ```text
//!   converged increment: R(u_n, s_{n-1}, p) = 0
//!   K du/dp = - ( dR/dp + dR/ds ds_{n-1}/dp )      K with the laws of contact in it, factored once
//!   ds_n/dp = dS/dp + dS/ds ds_{n-1}/dp + dS/du du/dp
//! ```
//!
//! The partial derivatives are differences of the pure evaluation between neighbours: the model at
//! p + kh with the state s_{n-1} + kh ds_{n-1}/dp. No neighbour is solved. docs/theory.md
//! section 13.

mod border;
mod neighbour;
mod numbers;
mod parameter;
mod stencil;
mod touched;
mod tries;
mod varied;

pub use border::{Border, leaves_hard_branch};
pub use neighbour::{Level, Surroundings};
pub use numbers::{
    Bend, bend, combine_starts, combine_states, is_same_branch, move_start, move_state,
    rates_between,
};
pub use parameter::{Parameter, SensitivityFault};
pub use stencil::{OFFSETS, PAIR, Side, Sides, Weights};
pub use touched::{Touch, Touched};
pub use tries::{Tries, Try};
pub use varied::Varied;
