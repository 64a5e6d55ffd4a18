//! What is fuzzed: entry points that take any bytes.
//!
//! ```text
//!   bytes -> deck           parses, and prints back to itself
//!         -> keywords       is interpreted to its end
//!         -> contact_point  numbers in, no NaN out
//!         -> restart        a saved state, which the run goes on from
//!         -> results        result files, which the report and plots are made from
//!         -> whole_run      a small deck: read, advised, run, reported
//! ```
//!
//! An entry point panics where a requirement is broken. The targets of cargo
//! fuzz call them, and so does a test of the library with the kept inputs.

pub mod contact_point;
pub mod deck;
pub mod keywords;
pub mod restart;
pub mod results;
pub mod whole_run;

mod bounded;
