//! Random small models: what a user might draw, and what nobody should.
//!
//! ```text
//!   number -> Sequence -> deck text -> slideline -> Judge -> Verdict
//! ```
//!
//! The numbers come from a fixed sequence, so that every model can be made
//! again from its number alone. Four of five models are well-posed by
//! construction ([`Kind::WellPosed`]); the fifth is spoilt in one named way.

mod deck;
mod judge;
mod sequence;
mod shapes;

pub use deck::{Kind, Model, model};
pub use judge::{Outcome, Tally, Verdict, judge};
pub use sequence::Sequence;
