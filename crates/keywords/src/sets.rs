//! Named sets of node or element numbers while the deck is read.

use std::collections::HashSet;

use slideline_diag::Span;
use slideline_model::Numbered;

/// What a set is made of, in the order in which it joined.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Item {
    One(u64),
    /// first, last, step (> 0)
    Range(u64, u64, u64),
    Set(String),
}

/// One set.
#[derive(Clone, Debug)]
pub(crate) struct NamedSet {
    pub name: String,
    pub items: Vec<(Item, Span)>,
    pub origin: Span,
}

/// All sets of one kind, in the order in which they were first named.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sets {
    list: Vec<NamedSet>,
    by_name: Numbered<String, usize>,
    /// Place of the set that was opened last: lines of a card join the same one.
    last: usize,
}

impl Sets {
    /// Makes the set known, empty if it is new.
    pub fn open(&mut self, name: &str, origin: Span) -> &mut NamedSet {
        if self.list.get(self.last).is_none_or(|own| own.name != name) {
            self.last = self.by_name.get(name).copied().unwrap_or(self.list.len());
        }
        if self.last == self.list.len() {
            self.by_name.insert(name.to_owned(), self.last);
            self.list.push(NamedSet { name: name.to_owned(), items: Vec::new(), origin });
        }
        &mut self.list[self.last]
    }

    /// Adds to a set.
    pub fn join(&mut self, name: &str, item: Item, span: Span) {
        self.open(name, span).items.push((item, span));
    }

    pub fn get(&self, name: &str) -> Option<&NamedSet> {
        self.by_name.get(name).map(|&index| &self.list[index])
    }

    pub fn contains(&self, name: &str) -> bool {
        self.by_name.contains_key(name)
    }

    pub fn iter(&self) -> impl Iterator<Item = &NamedSet> {
        self.list.iter()
    }

    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.list.iter().map(|set| set.name.as_str())
    }

    /// The numbers of a set, each once, with where each was said; `None` for
    /// a name that was never given. Sets within sets are followed, unknown
    /// ones passed over.
    pub fn members(&self, name: &str) -> Option<Vec<(u64, Span)>> {
        self.get(name)?;
        let mut members = Members::default();
        let mut open = HashSet::new();
        let mut waiting = vec![(name, 0)];
        while let Some((current, next)) = waiting.pop() {
            let Some(set) = self.get(current) else { continue };
            for (at, (item, span)) in set.items.iter().enumerate().skip(next) {
                match item {
                    Item::One(label) => members.take(*label, *span),
                    Item::Range(first, last, step) => {
                        let range = (*first..=*last).step_by(usize::try_from(*step).unwrap_or(1));
                        range.for_each(|label| members.take(label, *span));
                    }
                    Item::Set(inner) => {
                        if inner != name && open.insert(inner.as_str()) {
                            waiting.push((current, at + 1));
                            waiting.push((inner, 0));
                            break;
                        }
                    }
                }
            }
        }
        Some(members.list)
    }

    /// The numbers alone.
    pub fn labels(&self, name: &str) -> Option<Vec<u64>> {
        self.members(name).map(|members| members.into_iter().map(|(label, _)| label).collect())
    }
}

/// Numbers in the order in which they come, each once. What came is a bit of a word of 64 neighbours;
/// most numbers are of the same word as the one before.
#[derive(Default)]
struct Members {
    list: Vec<(u64, Span)>,
    /// Words by their places, but the one at hand.
    words: Numbered<u64, u64>,
    /// Place of the word at hand, and its bits.
    at_hand: (u64, u64),
}

impl Members {
    fn take(&mut self, label: u64, span: Span) {
        let (place, bit) = (label / 64, 1 << (label % 64));
        if place != self.at_hand.0 {
            self.words.insert(self.at_hand.0, self.at_hand.1);
            self.at_hand = (place, self.words.get(&place).copied().unwrap_or(0));
        }
        if self.at_hand.1 & bit == 0 {
            self.at_hand.1 |= bit;
            self.list.push((label, span));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn members_keep_their_order_and_come_once() {
        let mut sets = Sets::default();
        let here = Span::default();
        sets.join("A", Item::One(7), here);
        sets.join("A", Item::Set("B".into()), here);
        sets.join("A", Item::One(3), here);
        sets.join("B", Item::Range(2, 8, 3), here);
        sets.join("B", Item::Set("A".into()), here);
        assert_eq!(sets.labels("A"), Some(vec![7, 2, 5, 8, 3]));
        assert_eq!(sets.labels("C"), None);
        // far apart, and again what was there
        for label in [0, 63, 64, 9000, 63, 1, 64, 9000, 0, 9001] {
            sets.join("D", Item::One(label), here);
        }
        assert_eq!(sets.labels("D"), Some(vec![0, 63, 64, 9000, 1, 9001]));
    }
}
