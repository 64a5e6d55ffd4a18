//! Cards to model: what a deck means.
//!
//! ```text
//!   *NODE ...        Keyword::read         Draft               finish
//!   *ELEMENT ...   ----------------->  sets, elements,  ------------------> Model
//!   *STEP ...       one file each      cards by name     references, checks
//! ```
//!
//! [`interpret`] reads every card once, in order; generators act on what is
//! stored at that moment, references by name are resolved at the end. All
//! errors of a deck are reported in one pass, and an error is not followed by
//! complaints about what it caused.

mod axes;
mod beam_shape;
mod cards;
mod changes;
mod constraints;
mod crossing;
mod curves;
mod distributed;
mod draft;
mod earlier;
mod expression;
mod fillet;
mod finish;
mod instances;
mod interpret;
mod keyword;
mod log;
mod motion;
mod overrides;
mod parameters;
mod parts;
mod paths;
mod reading;
mod registry;
mod requests;
mod rule;
mod scopes;
mod section_places;
mod sets;
mod surfaces;
mod temperatures;
mod test_data;
mod traps;
mod unsupported;

pub use draft::{MAX_EXPANDED, MAX_GENERATED};
pub use earlier::{Earlier, ReadRequest, read_request};
pub use interpret::{Interpreted, Prepared, interpret, interpret_after, interpret_with, read};
pub use overrides::Setting;
pub use registry::{Description, describe, keywords};
pub use rule::{Level, Rule, Takes};
pub use unsupported::not_read;
