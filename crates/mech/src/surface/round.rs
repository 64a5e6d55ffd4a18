//! What tells chords of something round from corners that are drawn as they are, in the plane and in space.
//!
//! ```text
//!     o----o_                  o-----o
//!            `o    turns on           \    turns once
//!              \                       o
//! ```
//!
//! docs/theory.md sections 5.3 and 5.9. (derived)

/// Turn up to which two segments or faces are taken for flat: more than what rounding makes of a plane [rad].
pub(crate) const FLAT: f64 = 1e-3;
/// Part of a turn by which a line or surface turns at the next node or edge at least, where it goes on turning [1].
pub(crate) const ONWARD: f64 = 0.25;
