//! Maps whose keys are numbers, such as labels, places, dofs, or names of a deck.
//!
//! A deck is read of tens of such maps, and the hash of the standard library, made against keys that
//! an adversary chooses, costs more than all else that is done with an entry. Labels and names of a
//! deck are its author's own.

use std::collections::{HashMap, HashSet};
use std::hash::{BuildHasherDefault, Hasher};

/// A map from numbers or names.
pub type Numbered<K, V> = HashMap<K, V, BuildHasherDefault<Mixed>>;
/// A set of numbers or names.
pub type NumberedSet<K> = HashSet<K, BuildHasherDefault<Mixed>>;

/// 2^64 over the golden ratio, odd: neighbours come to lie far apart (Knuth, The Art of Computer
/// Programming 3, 6.4).
const SPREAD: u64 = 0x9e37_79b9_7f4a_7c15;

/// Numbers multiplied into one word, both halves of each product folded together.
#[derive(Clone, Copy, Debug, Default)]
pub struct Mixed(u64);

impl Hasher for Mixed {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        for part in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..part.len()].copy_from_slice(part);
            self.write_u64(u64::from_le_bytes(word));
        }
    }

    #[inline]
    fn write_u64(&mut self, number: u64) {
        let product = u128::from(self.0 ^ number) * u128::from(SPREAD);
        self.0 = product as u64 ^ (product >> 64) as u64;
    }

    #[inline]
    fn write_usize(&mut self, number: usize) {
        self.write_u64(number as u64);
    }

    #[inline]
    fn write_isize(&mut self, number: isize) {
        self.write_u64(number as u64);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::hash::Hash;

    /// Requirement: labels in steps of whatever size fall into as many of 1024 places as chance would
    /// have it, and so do the bits by which a map tells its entries apart.
    #[test]
    fn labels_are_spread() {
        let hash = |label: u64| {
            let mut own = Mixed::default();
            label.hash(&mut own);
            own.finish()
        };
        for step in [1, 10, 1000, 1024, 1 << 20, 100_000, 1 << 32] {
            let all = (0..1024_u64).map(|k| hash(k * step));
            let places: HashSet<u64> = all.clone().map(|own| own % 1024).collect();
            let words: HashSet<u64> = all.map(|own| own >> 57).collect();
            assert!(places.len() > 500, "{step}: {} places", places.len());
            assert!(words.len() > 100, "{step}: {} words", words.len());
        }
    }

    #[test]
    fn numbers_of_a_pair_count_by_their_places() {
        let pairs: NumberedSet<(u64, u64)> = (0..50).map(|k| (k, 49 - k)).collect();
        assert_eq!(pairs.len(), 50);
        let hash = |pair: (u64, u64)| {
            let mut own = Mixed::default();
            pair.hash(&mut own);
            own.finish()
        };
        assert_ne!(hash((1, 2)), hash((2, 1)));
    }
}
