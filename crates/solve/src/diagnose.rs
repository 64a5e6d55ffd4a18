//! Why an increment could not be found, in physical words.
//!
//! ```text
//!   iterations --> iteration_history (status, way and gap of every point; residual;
//!                  pivots; null motion; contradictions)  --> the first cause
//!                                                            that it proves
//! ```
//!
//! What nothing proves is called unknown.

mod case;
mod contact;
mod element;
mod ends;
mod insertable;
mod law;
mod left_behind;
mod limit_load;
mod other;
mod passed;
mod structure;

pub use case::{Case, reason};
pub use ends::slid_off;
pub use insertable::not_insertable;
pub use structure::step_too_large;

use crate::increments::StopReason;
use crate::newton::Jammed;
use slideline_diag::{Code, Diagnostic};

/// The diagnosis of a run that ends early: the first cause that is proved.
pub fn failure(case: &Case<'_>) -> Diagnostic {
    if case.stop == StopReason::TooManyIncrements {
        return case.too_many_increments();
    }
    let causes: [fn(&Case<'_>) -> Option<Diagnostic>; 16] = [
        |case| case.too_coarse(),
        |case| case.passed_through(),
        |case| case.no_room(),
        |case| case.user_fault(),
        |case| case.failed_element(),
        |case| case.off_the_end(),
        |case| case.left_behind(),
        |case| case.unheld(),
        |case| case.limit_load(),
        |case| case.overconstrained(),
        |case| case.wrong_law(),
        |case| case.jam(),
        |case| case.snap_through(),
        |case| case.chattering(),
        |case| case.stick_slip_cycling(),
        |case| case.mechanism(),
    ];
    causes.iter().find_map(|cause| cause(case)).unwrap_or_else(|| case.unknown())
}

/// Whether what is said of an attempt's end is but what a jam may do: contact
/// that wavers, or nothing.
pub fn may_be_a_jam(said: &Diagnostic) -> bool {
    ["SL0501", "SL0513", "SL0515", "SL0519"].contains(&said.code.0)
}

/// Whether an attempt that ended for this cause may have another equilibrium:
/// nothing, a jam that parts which give way may leave with a jump, a snap-through,
/// contact that wavers, an element that collapses or too long an increment was proved.
pub fn may_end_elsewhere(said: &Diagnostic) -> bool {
    let codes = ["SL0501", "SL0506", "SL0511", "SL0512", "SL0513", "SL0515", "SL0522"];
    codes.contains(&said.code.0)
}

/// A jam at points that the first iteration of an attempt showed locked.
pub fn jam_at_first(case: &Case<'_>, jammed: &[Jammed]) -> Option<Diagnostic> {
    case.jam_of(jammed)
}

/// Whether a diagnosis proves no cause.
pub fn is_unknown(said: &Diagnostic) -> bool {
    said.code == Code("SL0501")
}
