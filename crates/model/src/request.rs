//! What requests for results have in common.

use slideline_diag::Span;

/// Whether a request with that FREQUENCY is due: every so many increments and
/// at the end of a step; with 0 never. (manual)
pub(crate) fn is_due(frequency: usize, increment: usize, last_of_step: bool) -> bool {
    frequency > 0 && (last_of_step || increment.is_multiple_of(frequency))
}

/// What requests for nodes, beams and contact have in common.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// Name of the set as written; empty for all there are.
    pub set: String,
    /// Every how many increments; the last one of a step always; 0 never.
    pub frequency: usize,
    /// Where it goes.
    pub target: PrintTarget,
    /// `TOTALS`: the sum of each column below its table, or in its place.
    pub totals: Totals,
    /// `SUMMARY=YES`: the extremes of each column below its table.
    pub summary: bool,
    /// The card.
    pub origin: Span,
}

impl Request {
    /// Whether it is for that file and due in that increment.
    pub fn is_due(&self, is_target: fn(PrintTarget) -> bool, increment: usize, last: bool) -> bool {
        is_target(self.target) && is_due(self.frequency, increment, last)
    }
}

/// Whether the sums of a table are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Totals {
    /// The table alone.
    #[default]
    No,
    /// The sums below the table.
    Yes,
    /// The sums alone.
    Only,
}

/// Which file a request is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PrintTarget {
    /// `*NODE PRINT`, `*EL PRINT`, `*CONTACT PRINT`: the printed table.
    Table,
    /// `*NODE FILE` and the like, cards below `*OUTPUT, FIELD`: states and
    /// element results.
    Field,
    /// Cards below `*OUTPUT, HISTORY`: histories and element results.
    History,
}

impl PrintTarget {
    /// The printed table.
    pub fn is_table(self) -> bool {
        self == Self::Table
    }

    /// The result files.
    pub fn is_file(self) -> bool {
        self != Self::Table
    }
}
