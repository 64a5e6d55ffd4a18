//! When contact pairs have rows in `JOB.contact.csv`, and how many.
//!
//! A point that was in contact keeps its row, so that a pair never has fewer rows than before; pairs that
//! `*MODEL CHANGE` removes have none, and begin anew when they are back.

use std::collections::HashMap;

/// What is known of the rows of each pair.
#[derive(Clone, Debug, Default)]
pub(super) struct Presence(HashMap<String, Rows>);

/// The rows of a pair.
#[derive(Clone, Copy, Debug)]
struct Rows {
    /// The last increment with some, by its place in the list of all.
    last: usize,
    /// How many it has there.
    count: usize,
    /// How many it had in the increment before, where it had some.
    before: usize,
}

impl Presence {
    /// A pair has a row in an increment.
    pub fn note(&mut self, pair: &str, now: usize) {
        let Some(rows) = self.0.get_mut(pair) else {
            self.0.insert(pair.to_owned(), Rows { last: now, count: 1, before: 0 });
            return;
        };
        if now == rows.last {
            rows.count += 1;
            return;
        }
        let is_next = now == rows.last + 1;
        *rows = Rows { last: now, count: 1, before: if is_next { rows.count } else { 0 } };
    }

    /// Whether a pair has rows.
    pub fn has(&self, pair: &str) -> bool {
        self.0.contains_key(pair)
    }

    /// Behind which increment rows are missing, of `count` increments: the rows of a pair end where it still `has` some, or
    /// are fewer than before.
    pub fn missing_from(&self, count: usize, has: impl Fn(&str, usize) -> bool) -> Option<usize> {
        let ends = self.0.iter().filter_map(|(pair, rows)| {
            let end = rows.last + 1;
            let is_short = end < count && has(pair, end);
            (is_short || rows.count < rows.before).then_some(if is_short { end } else { rows.last })
        });
        ends.min()
    }
}
