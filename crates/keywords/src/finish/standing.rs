//! What stands in force from step to step, and from what it goes on.
//!
//! ```text
//!   step 1   A: 2, A: 3   B: 1        A acts with 5, B with 1
//!   step 2   A: 4                     A acts with 4, B with 1   (OP=MOD)
//!              '- goes on from 2; 3 has no successor and ramps off
//! ```
//!
//! docs/theory.md eq. (9.5).

use std::collections::{HashMap, HashSet};
use std::hash::Hash;

/// What may follow a curve.
pub(super) trait Curved {
    /// Amplitude by place in the model's list.
    fn amplitude(&self) -> Option<usize>;
}

/// A load as it was in the step before.
#[derive(Clone)]
pub(super) struct Before<T> {
    pub load: T,
    /// Place in the list of that step.
    pub place: usize,
}

#[derive(Clone)]
struct Item<K, T> {
    key: K,
    load: T,
    before: Option<Before<T>>,
}

/// Loads by what they rest on, in the order in which they were said. Those that one step gives one
/// place act together; they replace what steps before gave it.
#[derive(Clone)]
pub(super) struct Standing<K, T> {
    list: Vec<Item<K, T>>,
    /// What the step has removed or replaced.
    removed: Vec<(K, Before<T>)>,
}

impl<K, T> Default for Standing<K, T> {
    fn default() -> Self {
        Self { list: Vec::new(), removed: Vec::new() }
    }
}

impl<K: Eq + Hash + Copy, T: Clone + Curved> Standing<K, T> {
    /// How many.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Puts the loads of a step into force.
    pub fn take(&mut self, new: Vec<(K, T)>) {
        let named: HashSet<K> = new.iter().map(|(key, _)| *key).collect();
        self.remove(|key| named.contains(key));
        self.list.extend(new.into_iter().map(|(key, load)| Item { key, load, before: None }));
    }

    /// Removes those on such a key.
    pub fn remove(&mut self, gone: impl Fn(&K) -> bool) {
        for item in self.list.extract_if(.., |item| gone(&item.key)) {
            self.removed.extend(item.before.map(|before| (item.key, before)));
        }
    }

    /// All of them, with what they go on from.
    pub fn iter(&self) -> impl Iterator<Item = (&T, Option<&Before<T>>)> {
        self.list.iter().map(|item| (&item.load, item.before.as_ref()))
    }

    /// All of them, with what they rest on.
    pub fn keyed(&self) -> impl Iterator<Item = (K, &T)> {
        self.list.iter().map(|item| (item.key, &item.load))
    }

    /// All of them, to be changed.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.list.iter_mut().map(|item| &mut item.load)
    }

    /// Lets the new loads go on from those that they replace, by their keys; gives back what is
    /// left to ramp off. `same` compares the curves of an old and a new load.
    pub fn succeed(
        &mut self,
        same: impl Fn(Option<usize>, Option<usize>) -> bool,
    ) -> Vec<Before<T>> {
        let mut new: HashMap<K, Vec<&mut Item<K, T>>> = HashMap::new();
        for item in self.list.iter_mut().filter(|item| item.before.is_none()) {
            new.entry(item.key).or_default().push(item);
        }
        let mut old: Vec<(K, Vec<Before<T>>)> = Vec::new();
        let mut place: HashMap<K, usize> = HashMap::new();
        for (key, before) in self.removed.drain(..) {
            let at = *place.entry(key).or_insert_with(|| {
                old.push((key, Vec::new()));
                old.len() - 1
            });
            old[at].1.push(before);
        }
        let mut successors = |key| new.remove(&key).unwrap_or_default();
        old.into_iter().flat_map(|(key, old)| hand_over(old, successors(key), &same)).collect()
    }

    /// What stands is that of the step before from now on.
    pub fn pass(&mut self) {
        for (place, item) in self.list.iter_mut().enumerate() {
            item.before = Some(Before { load: item.load.clone(), place });
        }
    }
}

/// Loads of one key. Those of one curve, or of none, go on from one another in their order. Of the
/// others, what has no curve goes on from what is left, which ramps off where nothing takes it over;
/// curves alone replace it at once.
fn hand_over<K, T: Curved>(
    mut old: Vec<Before<T>>,
    mut new: Vec<&mut Item<K, T>>,
    same: &impl Fn(Option<usize>, Option<usize>) -> bool,
) -> Vec<Before<T>> {
    new.retain_mut(|item| {
        let own = item.load.amplitude();
        let found = old.iter().position(|before| same(before.load.amplitude(), own));
        item.before = found.map(|at| old.remove(at));
        found.is_none()
    });
    let replaced = !new.is_empty() && new.iter().all(|item| item.load.amplitude().is_some());
    if replaced {
        return Vec::new();
    }
    new.retain(|item| item.load.amplitude().is_none());
    let taken = old.len().min(new.len());
    for (item, before) in new.into_iter().zip(old.drain(..taken)) {
        item.before = Some(before);
    }
    old
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
