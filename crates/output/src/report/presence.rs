//! When contact pairs have rows in `JOB.contact.csv`: those that `*MODEL CHANGE` removes have none.

use std::collections::HashMap;

/// Of each pair the last increment with rows, and those from which on it had none for a while.
#[derive(Clone, Debug, Default)]
pub(super) struct Presence(HashMap<String, (usize, Vec<usize>)>);

impl Presence {
    /// A pair has rows in an increment.
    pub fn note(&mut self, pair: &str, now: usize) {
        let Some((last, left)) = self.0.get_mut(pair) else {
            self.0.insert(pair.to_owned(), (now, Vec::new()));
            return;
        };
        if now > *last + 1 {
            left.push(*last + 1);
        }
        *last = now;
    }

    /// Whether a pair that comes back later left in this increment.
    pub fn has_left(&self, pair: &str, place: usize) -> bool {
        self.0.get(pair).is_some_and(|(_, left)| left.contains(&place))
    }
}
