//! Orderings: narrow bands by reverse Cuthill-McKee, dense rows to a border, zero diagonals behind
//! their neighbours.
//!
//! ```text
//!   x x . . . | x      chain of elements (band) and a rigid body's reference node that sees
//!   x x x . . | .      many of them (border): without the border the band would be as wide
//!   . x x x . | x      as the chain is long
//!   . . x x x | .
//!   . . . x x | x
//!   ----------+--
//!   x . x . x | x
//! ```

use crate::pattern::Pattern;
use crate::system::Kind;

/// Largest number of rows that are set apart as a border.
const LARGEST_BORDER: usize = 48;

/// Order of elimination for the banded factorisation: band first, border last.
#[derive(Clone, Debug)]
pub(crate) struct Layout {
    /// Caller's equation at each place of the order.
    pub order: Vec<usize>,
    /// Number of equations in the band; the others are the border.
    pub band: usize,
    pub half_bandwidth: usize,
}

impl Layout {
    /// The layout with the fewest predicted operations.
    pub fn cheapest(pattern: &Pattern, kind: Kind) -> Self {
        let n = pattern.size();
        let mut best = Self::with_border(pattern, &[]);
        let mut degrees: Vec<usize> = (0..n).map(|i| pattern.row(i).len()).collect();
        degrees.sort_unstable();
        let median = degrees.get(n / 2).copied().unwrap_or(0);
        let mut last_border = 0;
        for threshold in [4 * median, 2 * median, median + median / 2] {
            let border: Vec<usize> = (0..n).filter(|&i| pattern.row(i).len() > threshold).collect();
            if border.len() > LARGEST_BORDER.min(n / 2) {
                break;
            }
            if border.len() > last_border {
                last_border = border.len();
                let layout = Self::with_border(pattern, &border);
                if layout.operations(kind) < best.operations(kind) {
                    best = layout;
                }
            }
        }
        best
    }

    /// Layout with the named equations as border; the rest in its own order or by reverse
    /// Cuthill-McKee, whichever band is narrower.
    pub fn with_border(pattern: &Pattern, border: &[usize]) -> Self {
        let mut keep = vec![true; pattern.size()];
        border.iter().for_each(|&i| keep[i] = false);
        let natural: Vec<usize> = (0..pattern.size()).filter(|&i| keep[i]).collect();
        let reordered = reverse_cuthill_mckee(pattern, &keep);
        let widths = [half_bandwidth(pattern, &natural), half_bandwidth(pattern, &reordered)];
        let (mut order, half_bandwidth) =
            if widths[0] <= widths[1] { (natural, widths[0]) } else { (reordered, widths[1]) };
        let band = order.len();
        order.extend_from_slice(border);
        Self { order, band, half_bandwidth }
    }

    /// Predicted multiplications and additions of one factorisation.
    pub fn operations(&self, kind: Kind) -> f64 {
        let (n, b) = (self.band as f64, self.half_bandwidth as f64);
        let k = (self.order.len() - self.band) as f64;
        let (factor, solve) = match kind {
            Kind::Symmetric => (n * b * (b + 3.0), 4.0 * n * b),
            Kind::Unsymmetric => (3.0 * n * b * (b + 3.0), 5.0 * n * b),
        };
        factor + k * solve + 2.0 * n * k * k + k * k * k
    }

    /// Predicted number of stored entries.
    pub fn entries(&self, kind: Kind) -> f64 {
        let (n, b) = (self.band as f64, self.half_bandwidth as f64);
        let k = (self.order.len() - self.band) as f64;
        let band = match kind {
            Kind::Symmetric => n * (b + 1.0),
            Kind::Unsymmetric => n * (4.0 * b + 1.0),
        };
        band + 3.0 * n * k + k * k
    }
}

/// Place of every equation in an order; `usize::MAX` for those left out.
pub(crate) fn positions(n: usize, order: &[usize]) -> Vec<usize> {
    let mut place = vec![usize::MAX; n];
    order.iter().enumerate().for_each(|(at, &i)| place[i] = at);
    place
}

/// Largest distance from the diagonal when the equations of `order` alone are numbered so.
pub(crate) fn half_bandwidth(pattern: &Pattern, order: &[usize]) -> usize {
    let place = positions(pattern.size(), order);
    let mut widest = 0;
    for (at, &i) in order.iter().enumerate() {
        for &j in pattern.row(i) {
            if place[j] != usize::MAX {
                widest = widest.max(at.abs_diff(place[j]));
            }
        }
    }
    widest
}

/// Reverse Cuthill-McKee order of the equations marked in `keep`, each connected part begun at an
/// end of it (George and Liu's pseudo-peripheral node). Ties go to the lower number.
pub(crate) fn reverse_cuthill_mckee(pattern: &Pattern, keep: &[bool]) -> Vec<usize> {
    let n = pattern.size();
    let mut order = Vec::with_capacity(n);
    let mut placed: Vec<bool> = keep.iter().map(|&k| !k).collect();
    let mut walk = Walk { pattern, stamp: vec![0; n], current: 0, queue: Vec::with_capacity(n) };
    for first in 0..n {
        if placed[first] {
            continue;
        }
        let (mut depth, mut end) = walk.run(first, &placed);
        for _ in 0..6 {
            let (deeper, next_end) = walk.run(end, &placed);
            if deeper <= depth {
                break;
            }
            (depth, end) = (deeper, next_end);
        }
        for &i in &walk.queue {
            placed[i] = true;
            order.push(i);
        }
    }
    order.reverse();
    order
}

/// Breadth-first walks over one connected part.
struct Walk<'a> {
    pattern: &'a Pattern,
    stamp: Vec<u32>,
    current: u32,
    queue: Vec<usize>,
}

impl Walk<'_> {
    /// Walks from `first`, neighbours of low degree first; returns the number of levels and the
    /// equation of lowest degree in the last of them. The order is left in the queue.
    fn run(&mut self, first: usize, excluded: &[bool]) -> (usize, usize) {
        self.current += 1;
        self.queue.clear();
        self.queue.push(first);
        self.stamp[first] = self.current;
        let (mut levels, mut level_start, mut at) = (0, 0, 0);
        while at < self.queue.len() {
            let level_end = self.queue.len();
            (level_start, levels) = (at, levels + 1);
            while at < level_end {
                self.visit(self.queue[at], excluded);
                at += 1;
            }
        }
        let last = &self.queue[level_start..];
        let end = last.iter().copied().min_by_key(|&i| (self.pattern.row(i).len(), i));
        (levels, end.unwrap_or(first))
    }

    fn visit(&mut self, i: usize, excluded: &[bool]) {
        let begin = self.queue.len();
        for &j in self.pattern.row(i) {
            if !excluded[j] && self.stamp[j] != self.current {
                self.stamp[j] = self.current;
                self.queue.push(j);
            }
        }
        let pattern = self.pattern;
        self.queue[begin..].sort_unstable_by_key(|&j| (pattern.row(j).len(), j));
    }
}

/// The order changed so that each equation with a zero diagonal (a multiplier) comes directly behind
/// the last eliminated of its neighbours: by then the diagonal has been filled, and elimination
/// without pivoting can use it.
pub(crate) fn behind_neighbours(pattern: &Pattern, order: &[usize], zero: &[bool]) -> Vec<usize> {
    let n = pattern.size();
    let place = positions(n, order);
    let mut followers: Vec<(usize, usize)> = Vec::new();
    for &i in order.iter().filter(|&&i| zero[i]) {
        let neighbours = pattern.row(i).iter().filter(|&&j| !zero[j]);
        let last = neighbours.map(|&j| place[j]).max().unwrap_or(n);
        followers.push((last, i));
    }
    followers.sort_by_key(|&(last, _)| last);
    let mut moved = Vec::with_capacity(n);
    let mut next = followers.into_iter().peekable();
    for (at, &i) in order.iter().enumerate() {
        if !zero[i] {
            moved.push(i);
        }
        while let Some((_, follower)) = next.next_if(|&(last, _)| last == at) {
            moved.push(follower);
        }
    }
    moved.extend(next.map(|(_, follower)| follower));
    moved
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn is_permutation(order: &[usize], n: usize) -> bool {
        let mut sorted = order.to_vec();
        sorted.sort_unstable();
        sorted.into_iter().eq(0..n)
    }

    proptest! {
        // Requirement: every order names every equation once, whatever the pattern; the layout's
        // half-bandwidth holds and no order of the band is wider than the natural one.
        #[test]
        fn orders_are_permutations(
            n in 1usize..60,
            pairs in prop::collection::vec((0usize..60, 0usize..60), 0..200),
            zero in prop::collection::vec(any::<bool>(), 60),
        ) {
            let pattern = Pattern::from_pairs(n, pairs.into_iter());
            let order = reverse_cuthill_mckee(&pattern, &vec![true; n]);
            prop_assert!(is_permutation(&order, n));
            let moved = behind_neighbours(&pattern, &order, &zero[..n]);
            prop_assert!(is_permutation(&moved, n));
            let layout = Layout::cheapest(&pattern, Kind::Unsymmetric);
            prop_assert!(is_permutation(&layout.order, n));
            let width = half_bandwidth(&pattern, &layout.order[..layout.band]);
            prop_assert_eq!(width, layout.half_bandwidth);
            let natural: Vec<usize> = (0..n).collect();
            let plain = Layout::with_border(&pattern, &[]);
            prop_assert!(plain.half_bandwidth <= half_bandwidth(&pattern, &natural));
        }

        // Requirement: a zero diagonal comes behind at least one neighbour that has a diagonal, and
        // behind all of them; such neighbours keep their order.
        #[test]
        fn zero_diagonals_follow_their_neighbours(
            n in 2usize..40,
            pairs in prop::collection::vec((0usize..40, 0usize..40), 0..120),
            zero in prop::collection::vec(any::<bool>(), 40),
        ) {
            let pattern = Pattern::from_pairs(n, pairs.into_iter());
            let natural: Vec<usize> = (0..n).collect();
            let place = positions(n, &behind_neighbours(&pattern, &natural, &zero[..n]));
            for i in (0..n).filter(|&i| zero[i]) {
                for &j in pattern.row(i).iter().filter(|&&j| !zero[j]) {
                    prop_assert!(place[j] < place[i]);
                }
            }
        }
    }

    #[test]
    fn a_shuffled_chain_becomes_a_narrow_band() {
        // A path graph has bandwidth 1 in the right order; source: definition.
        let n = 101;
        let shuffle = |i: usize| i * 37 % n;
        let pairs = (0..n - 1).map(|i| (shuffle(i), shuffle(i + 1)));
        let pattern = Pattern::from_pairs(n, pairs);
        assert_eq!(Layout::with_border(&pattern, &[]).half_bandwidth, 1);
    }

    #[test]
    fn a_dense_row_becomes_the_border() {
        let n = 200;
        let chain = (0..n - 2).map(|i| (i, i + 1));
        let star = (0..n - 1).map(|i| (i, n - 1));
        let pattern = Pattern::from_pairs(n, chain.chain(star));
        let layout = Layout::cheapest(&pattern, Kind::Unsymmetric);
        assert_eq!((layout.band, layout.half_bandwidth), (n - 1, 1));
        assert_eq!(layout.order[n - 1], n - 1);
    }
}
