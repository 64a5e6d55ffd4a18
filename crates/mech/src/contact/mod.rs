//! Contact: seven small things, multiplied in one place.
//!
//! ```text
//!   slave point        x        points/       where is contact sampled, with which area?
//!                      |  g     search/       which part of the master faces it?
//!   master      -------+-----   gap/          how far, how much has it slid?
//!                       sigma   normal/       overclosure -> pressure
//!                               friction/     slip, pressure -> traction
//!                               onset/        is friction called at all?
//!                               enforcement/  how is a law imposed?
//! ```
//!
//! The seven are siblings that never import one another; [`pair`] composes them and is the only file
//! that imports more than one; [`tangential`] holds the vectors that they hand to each other. Signs: gap g open > 0, overclosure h = -g, pressure p >= 0, virtual
//! work A (p dh + tau d sigma) with tau of the sign of the slip, so that friction dissipates.

pub mod enforcement;
pub mod friction;
pub mod gap;
pub mod normal;
pub mod onset;
pub mod pair;
pub mod points;
pub mod search;
pub mod tangential;
