//! Text to a lossless tree of cards.
//!
//! ```text
//!   *FRICTION, TAUMAX=2.E6      <- keyword line: keyword, parameters
//!   0.3, ,                      <- data line: fields
//!   ** a comment                <- trivia, kept
//!   *INCLUDE, INPUT=beam.inp    <- read in place
//! ```
//!
//! [`parse`] is total: it takes any bytes, never fails and reports every
//! error at once. [`Deck::print`] gives back the bytes that were read. The
//! crate knows syntax only; what a card means is known to `slideline-keywords`.

mod card;
mod edit;
mod include;
mod limits;
mod lines;
mod parse;
mod spelling;
mod split;
mod values;

pub use card::{Card, Comment, DataLine, Deck, Field, FileLines, Line, LineKind, Parameter, Word};
pub use edit::{Applied, apply};
pub use include::{FromDisk, LoadError, Loaded, Loader, NoFiles, PathKind, Texts};
pub use limits::{
    MAX_BYTES, MAX_DEPTH, MAX_FILES, MAX_LINE_BYTES, MAX_LINES, MAX_NULS, MAX_PARAMETERS,
    MAX_VALUES, MAX_VALUES_PER_LINE,
};
pub use parse::{Parsed, parse};
pub use spelling::{nearest, normalise};
pub use split::comment_as_card;
pub use values::{Problem, integer, number, parse_integer, parse_number, text};
