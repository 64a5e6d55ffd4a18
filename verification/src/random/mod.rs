//! Random small models: what a user might draw, and what nobody should.
//!
//! ```text
//!   number -> Sequence -> deck text -> slideline -> Judge -> Verdict
//! ```
//!
//! The numbers come from a fixed sequence, so that every model can be made
//! again from its number alone. One generator presses a body into a beam: four
//! of five of its models are well-posed by construction ([`Kind::WellPosed`]),
//! the fifth is spoilt in one named way. The others draw whole [`classes`] of
//! models, whose runs are judged from their files alone ([`trial`]).

pub mod classes;
mod deck;
mod files;
mod judge;
mod label;
mod passing;
mod physics;
mod sequence;
mod shapes;
pub mod solids;
pub mod trial;

pub use deck::{Kind, Model, model};
pub use judge::{Outcome, Tally, Verdict, judge};
pub use sequence::Sequence;
