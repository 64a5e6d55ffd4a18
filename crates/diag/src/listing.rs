//! Diagnostics while they are collected: as many as a person reads.

use std::collections::HashMap;

use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::source::Span;

/// Most diagnostics of one pass over a deck; the last one then says that more
/// was found.
pub const MAX_DIAGNOSTICS: usize = 1000;

/// Most diagnostics of one code in one pass. One fault may touch every line of
/// a mesh; a note then says how many more there are.
pub const MAX_OF_ONE_CODE: usize = 50;

/// Diagnostics in the order in which they were found, bounded in number.
#[derive(Clone, Debug, Default)]
pub struct Listing {
    kept: Vec<Diagnostic>,
    counts: HashMap<Code, Count>,
    is_full: bool,
}

#[derive(Clone, Copy, Debug, Default)]
struct Count {
    found: usize,
    /// Where the first one stands that is not listed.
    first_left: Option<Span>,
}

impl Listing {
    /// Takes a diagnostic in, or counts it.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        let count = self.counts.entry(diagnostic.code).or_default();
        count.found += 1;
        if count.found > MAX_OF_ONE_CODE {
            if count.found == MAX_OF_ONE_CODE + 1 {
                count.first_left = diagnostic.span;
            }
            return;
        }
        if self.kept.len() < MAX_DIAGNOSTICS {
            self.kept.push(diagnostic);
        } else if !std::mem::replace(&mut self.is_full, true) {
            let text = format!("more than {MAX_DIAGNOSTICS} problems; the rest is not listed");
            self.kept.push(Diagnostic::error(Code("SL0115"), text).at(diagnostic.span));
        }
    }

    /// Forgets everything but errors.
    pub fn keep_errors(&mut self) {
        self.kept.retain(|said| said.severity == Severity::Error);
        self.counts.clear();
    }

    /// The list, with a note for every code that has more than are listed.
    pub fn into_diagnostics(self) -> Vec<Diagnostic> {
        let mut all = self.kept;
        let mut left: Vec<(Code, Count)> = self.counts.into_iter().collect();
        left.retain(|(_, count)| count.found > MAX_OF_ONE_CODE);
        left.sort_by_key(|(code, _)| *code);
        for (code, count) in left {
            let more = count.found - MAX_OF_ONE_CODE;
            let text = format!("{more} more of {code} from here on are not listed");
            all.push(Diagnostic::note(Code("SL0115"), text).at(count.first_left));
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_fault_on_every_line_is_told_fifty_times_and_then_counted() {
        let mut listing = Listing::default();
        for _ in 0..3812 {
            listing.push(Diagnostic::error(Code("SL0223"), "again"));
        }
        listing.push(Diagnostic::error(Code("SL0101"), "another fault is still heard"));
        let all = listing.into_diagnostics();
        assert_eq!(all.len(), MAX_OF_ONE_CODE + 2);
        assert!(all[MAX_OF_ONE_CODE + 1].message.starts_with("3762 more of SL0223"));
    }
}
