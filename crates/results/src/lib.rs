//! What a frame offers: named fields with components, units and locations.
//!
//! ```text
//!   Frame --+--> nodes:           U  RF  CF  COORD
//!           |--> elements:        the fields of their types: SF  SM  S  E ...
//!           '--> contact points:  CSTRESS  CDISP  CFORCE  ...
//!                     |
//!                     '--> components: name, unit, value --> every file format
//! ```
//!
//! Writers ask for fields by what decks call them and iterate over their
//! components: a field that is added here appears wherever fields are written.

mod contact;
pub mod element;
mod node;

pub use contact::{CONTACT_FIELDS, ContactComponent, ContactField, contact_component, shown};
pub use node::{NodeComponent, NodeField, place};
