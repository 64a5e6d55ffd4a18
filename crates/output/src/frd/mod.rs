//! `JOB.frd`: mesh and nodal results in the ASCII format of CalculiX, which
//! cgx and PrePoMax open. Written where the deck asks for states.
//!
//! ```text
//!     1C title      2C nodes      3C elements (types 1 to 11)
//!   100C DISP, FORC, STRESS, TOSTRAIN, PE, ENER, S11, SECTION, CONTACT for each increment due
//!  9999
//! ```
//!
//! Points of rigid surfaces are nodes of their own, numbered behind the
//! deck's, so that a viewer shows the surfaces moving.

mod mesh;
mod results;
mod writer;

pub(crate) use writer::Frd;
