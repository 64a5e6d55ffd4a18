//! Where something stands in a deck, and what is to be said about it.
//!
//! ```text
//!   deck text ---- span (file, bytes) ----> location (file, line, columns)
//!                      |
//!   diagnostic = code + severity + message + span + labels + help + edit
//! ```
//!
//! Plain data: nothing here renders, prints or exits. Every crate that reads
//! a deck or judges a model speaks through these types.

mod catalogue;
mod diagnostic;
mod listing;
mod source;

pub use catalogue::{CATALOGUE, Entry, entry};
pub use diagnostic::{Code, Diagnostic, Edit, Label, Place, Severity, Suggestion, has_errors};
pub use listing::{Listing, MAX_DIAGNOSTICS, MAX_OF_ONE_CODE};
pub use source::{FileId, Location, Source, Sources, Span};
