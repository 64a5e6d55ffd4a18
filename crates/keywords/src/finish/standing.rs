//! What stands in force from step to step.
//!
//! ```text
//!   step 1   A: 2, A: 3   B: 1        A acts with 5, B with 1
//!   step 2   A: 4                     A acts with 4, B with 1   (OP=MOD)
//! ```

use std::collections::{HashMap, HashSet};
use std::hash::Hash;

/// Loads by what they rest on, in the order in which they were said. Those that one step gives one
/// place act together; they replace what steps before gave it.
#[derive(Clone)]
pub(super) struct Standing<K, T> {
    list: Vec<(K, T)>,
}

impl<K, T> Default for Standing<K, T> {
    fn default() -> Self {
        Self { list: Vec::new() }
    }
}

impl<K: Eq + Hash, T> Standing<K, T> {
    /// How many.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Puts the loads of a step into force.
    pub fn take(&mut self, new: Vec<(K, T)>) {
        let named: HashSet<&K> = new.iter().map(|(key, _)| key).collect();
        self.list.retain(|(key, _)| !named.contains(key));
        self.list.extend(new);
    }

    /// Keeps those whose key is wanted.
    pub fn retain(&mut self, wanted: impl Fn(&K) -> bool) {
        self.list.retain(|(key, _)| wanted(key));
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = &T> {
        self.list.iter().map(|(_, load)| load)
    }

    /// All of them, to be changed.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.list.iter_mut().map(|(_, load)| load)
    }
}

/// Values of which each place has one, in the order in which they were said.
#[derive(Clone)]
pub(super) struct InForce<T, K> {
    pub list: Vec<T>,
    place: HashMap<K, usize>,
}

impl<T, K> Default for InForce<T, K> {
    fn default() -> Self {
        Self { list: Vec::new(), place: HashMap::new() }
    }
}

impl<T, K: Hash + Eq> InForce<T, K> {
    pub fn set(&mut self, key: K, value: T) {
        match self.place.get(&key) {
            Some(&at) => self.list[at] = value,
            None => {
                self.place.insert(key, self.list.len());
                self.list.push(value);
            }
        }
    }
}
