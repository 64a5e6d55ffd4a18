//! Is friction called at all? The finding of the 1995 paper, alone in its file.
//!
//! ```text
//!   last commit   now       Immediate    Delayed, Matfru
//!   open          open      no           no
//!   open          closed    FRICTION     no       <- the increment the 1995 logic loses
//!   closed        closed    friction     friction
//!   closed        open      no           no
//! ```

/// When friction is called for a point. [semantics: friction onset]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Onset {
    /// Whenever the point is closed: the paper's modified logic, and the default.
    #[default]
    Immediate,
    /// Not in the increment in which the point closes.
    Delayed,
    /// The logic of subroutine MATFRU in 1995: not called when the point was open in the previous
    /// increment. On (committed, trial) states this is the same table as `Delayed`.
    Matfru,
}

impl Onset {
    /// Whether friction acts, given the status at the last commit and now.
    pub fn called(self, was_closed: bool, is_closed: bool) -> bool {
        match self {
            Self::Immediate => is_closed,
            Self::Delayed | Self::Matfru => was_closed && is_closed,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Onset::{self, Delayed, Immediate, Matfru};

    /// Requirement: the truth table of semantics, section 4, all twelve rows.
    #[test]
    fn truth_table() {
        let rows: [(Onset, bool, bool, bool); 12] = [
            (Immediate, false, false, false),
            (Immediate, false, true, true),
            (Immediate, true, true, true),
            (Immediate, true, false, false),
            (Delayed, false, false, false),
            (Delayed, false, true, false),
            (Delayed, true, true, true),
            (Delayed, true, false, false),
            (Matfru, false, false, false),
            (Matfru, false, true, false),
            (Matfru, true, true, true),
            (Matfru, true, false, false),
        ];
        for (onset, was, is, called) in rows {
            assert_eq!(onset.called(was, is), called, "{onset:?} {was} {is}");
        }
    }
}
