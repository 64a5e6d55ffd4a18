//! Numbers of the states that are there.

use serde::{Deserialize, Serialize};

/// Ascending numbers, kept as runs of equal distance: first, distance, count.
/// A long run costs no more to save than a short one.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct StateNumbers(Vec<[usize; 3]>);

impl StateNumbers {
    /// Whether runs that were saved make sense.
    pub fn are_sound(&self) -> bool {
        self.0.iter().all(|&[_, distance, count]| {
            (count == 1 && distance == 0) || (count > 1 && distance > 0)
        })
    }

    /// Appends a number larger than all others.
    pub fn push(&mut self, number: usize) {
        match self.0.last_mut() {
            Some([first, distance, count]) if *count == 1 && number > *first => {
                (*distance, *count) = (number - *first, 2);
            }
            Some([first, distance, count])
                if *count > 1 && number == *first + *distance * *count =>
            {
                *count += 1;
            }
            _ => self.0.push([number, 0, 1]),
        }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.0.iter().map(|[_, _, count]| count).fold(0, |sum, count| sum.saturating_add(*count))
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// All of them; a number that is too large for any run stays the largest.
    pub fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        self.0.iter().flat_map(|&[first, distance, count]| {
            (0..count).map(move |k| first.saturating_add(distance.saturating_mul(k)))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: what went in comes out, and equal distances take one run.
    #[test]
    fn numbers_come_back_from_their_runs() {
        for list in [&[][..], &[0], &[0, 1, 2, 3], &[0, 5, 10, 15, 17, 22, 27], &[0, 3, 4, 6, 8]] {
            let mut numbers = StateNumbers::default();
            list.iter().for_each(|&number| numbers.push(number));
            assert_eq!(numbers.iter().collect::<Vec<_>>(), list);
            assert_eq!(numbers.len(), list.len());
            assert!(numbers.are_sound());
        }
        let mut long = StateNumbers::default();
        (0..100_000).for_each(|number| long.push(number));
        assert_eq!(long.0, [[0, 1, 100_000]]);
        // a run without distance would name one state for ever
        assert!(!StateNumbers(vec![[0, 0, usize::MAX]]).are_sound());
    }
}
