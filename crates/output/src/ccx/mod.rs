//! Files as ccx itself writes them, for programs that start this one in its place (docs/ccx.md).
//!
//! ```text
//!   JOB.sta   a line an increment          JOB.cvg   a line an iteration
//! ```
//!
//! Formats measured with ccx 2.20.

mod cvg;
mod sta;

pub(crate) use cvg::Cvg;
pub(crate) use sta::{STA_HEADER, push_attempt};
