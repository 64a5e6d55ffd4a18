//! One attempt at an increment: Newton's method with contact solved exactly
//! in every linearisation.
//!
//! ```text
//!   predict -> evaluate -> [ assemble -> factor -> linearised contact
//!                            -> move -> evaluate -> judge ] ... -> verdict
//! ```
//!
//! Newton knows nothing of time: it is told the state to start from and the
//! values to reach.

mod advance;
mod assembly;
mod attempt;
mod begin;
mod falls;
mod hold;
mod iterate;
mod measures;
mod multipliers;
mod near;
mod outcome;
mod questions;
mod recall;
mod relax;
mod relaxation;
mod scratch;
mod search;
mod secants;
mod stresses;
mod trial;
mod turns;

pub use assembly::{TOUCH, augmentation_stiffness};
pub use attempt::attempt;
pub use near::{Rates, WholeTangent};
pub use outcome::Outcome;
pub use questions::Jammed;
pub use recall::recall_points;
pub use relax::relax;
pub use scratch::Scratch;
