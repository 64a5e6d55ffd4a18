//! The workbench: a deck whose numbers are sliders, and a solver that follows them.
//!
//! ```text
//!   page  <-- JSON texts -->  Bench::answer  -->  Parametric -> Model -> Workspace -> rows, frames
//!     |                                                                     `-> verdict, figures
//!     `-- over a WebSocket (server), or within a worker (WebAssembly)
//! ```
//!
//! [`Bench`] needs no file, no thread and no clock; what it says goes to a function. The exchange
//! is described in `protocol.md` beside this crate.

mod aim;
mod answers;
mod band;
mod bench;
mod bracket;
mod complete;
mod curves;
mod deck;
mod drawing;
mod formula;
mod found;
mod found_bodies;
mod found_surfaces;
mod kinds;
pub mod markdown;
mod outcome;
mod parameters;
mod places;
mod plane;
mod profile;
mod quiet;
mod rates;
mod save;
mod search;
#[cfg(feature = "server")]
pub mod server;
#[cfg(feature = "server")]
mod single;
mod slider;
mod solve;
mod values;

pub use bench::{Bench, Reader};
pub use kinds::{KINDS, Kind, kind};
pub use parameters::range;
#[cfg(feature = "server")]
pub use single::{asset, single_page};
pub use slider::Range;
