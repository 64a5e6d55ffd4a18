//! Named sets of node or element numbers while the deck is read.

use std::collections::{HashMap, HashSet};

use slideline_diag::Span;
use slideline_model::NumberedSet;

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
    by_name: HashMap<String, usize>,
}

impl Sets {
    /// Makes the set known, empty if it is new.
    pub fn open(&mut self, name: &str, origin: Span) -> &mut NamedSet {
        let index = match self.by_name.get(name) {
            Some(&index) => index,
            None => {
                self.by_name.insert(name.to_owned(), self.list.len());
                self.list.push(NamedSet { name: name.to_owned(), items: Vec::new(), origin });
                self.list.len() - 1
            }
        };
        &mut self.list[index]
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
        let mut seen = NumberedSet::default();
        let mut open = HashSet::new();
        let mut members = Vec::new();
        let mut waiting = vec![(name.to_owned(), 0)];
        open.insert(name.to_owned());
        while let Some((current, next)) = waiting.pop() {
            let Some(set) = self.get(&current) else { continue };
            for (at, (item, span)) in set.items.iter().enumerate().skip(next) {
                match item {
                    Item::One(label) => {
                        if seen.insert(*label) {
                            members.push((*label, *span));
                        }
                    }
                    Item::Range(first, last, step) => {
                        let range = (*first..=*last).step_by(usize::try_from(*step).unwrap_or(1));
                        members.extend(range.filter(|&k| seen.insert(k)).map(|k| (k, *span)));
                    }
                    Item::Set(inner) => {
                        if open.insert(inner.clone()) {
                            waiting.push((current, at + 1));
                            waiting.push((inner.clone(), 0));
                            break;
                        }
                    }
                }
            }
        }
        Some(members)
    }

    /// The numbers alone.
    pub fn labels(&self, name: &str) -> Option<Vec<u64>> {
        self.members(name).map(|members| members.into_iter().map(|(label, _)| label).collect())
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
    }
}
