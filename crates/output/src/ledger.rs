//! The ledger: friction that the onset did not call.

use crate::number::general;
use slideline_diag::{Code, Diagnostic};
use slideline_model::Onset;

/// What is to be said at the end of a run in which closed points went without
/// friction: in how many point-increments, and how much work
/// A min(mu p, tau_max) |change of slip coordinate| [F L] was dropped.
/// `None` where nothing was. [contract: the ledger]
pub fn dropped_friction(onset: Onset, point_increments: usize, work: f64) -> Option<Diagnostic> {
    if point_increments == 0 && work <= 0.0 {
        return None;
    }
    let plural = if point_increments == 1 { "" } else { "s" };
    let message = format!(
        "friction was not called in {point_increments} point-increment{plural}: friction work of \
         {} (force times length) was dropped by FRICTION ONSET={}",
        general(work, 6),
        onset_word(onset).to_ascii_uppercase(),
    );
    Some(Diagnostic::warning(Code("SL0601"), message).help(
        "Write *CONTACT CONTROLS, FRICTION ONSET=IMMEDIATE before the first step, or run with \
         --friction-onset immediate: friction then acts whenever a point is closed.",
    ))
}

/// The word of the command line and of files.
pub fn onset_word(onset: Onset) -> &'static str {
    match onset {
        Onset::Immediate => "immediate",
        Onset::Delayed => "delayed",
        Onset::Matfru => "matfru",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_dropped_is_nothing_said() {
        assert!(dropped_friction(Onset::Immediate, 0, 0.0).is_none());
        let said = dropped_friction(Onset::Matfru, 1, 1.25e-4).unwrap();
        assert!(said.message.contains("1 point-increment:"), "{}", said.message);
        assert!(said.message.contains("1.25e-4") || said.message.contains("0.000125"));
        assert!(said.message.contains("ONSET=MATFRU"));
        assert!(said.help.unwrap().contains("*CONTACT CONTROLS, FRICTION ONSET=IMMEDIATE"));
    }
}
