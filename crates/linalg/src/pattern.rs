//! Sparse patterns and the matrices that use them.
//!
//! ```text
//!   element 1  element 2        x x .     every element (clique) couples
//!   o---------o---------o  -->  x x x     all its dofs with one another
//!   1         2         3       . x x
//! ```

use std::sync::Arc;

/// Structurally symmetric sparse pattern of a square matrix: compressed rows, columns ascending in
/// each row, the diagonal always present. A copy shares the memory of the original.
#[derive(Clone, Debug, Eq)]
pub struct Pattern {
    rows: Arc<Rows>,
}

#[derive(Debug, PartialEq, Eq)]
struct Rows {
    start: Vec<usize>,
    column: Vec<usize>,
}

impl PartialEq for Pattern {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.rows, &other.rows) || self.rows == other.rows
    }
}

impl Pattern {
    /// Pattern of `n` equations from coupled pairs (row, column). Transposes and the diagonal are
    /// added, repetitions removed; pairs outside `0..n` are ignored.
    pub fn from_pairs(n: usize, pairs: impl Iterator<Item = (usize, usize)>) -> Self {
        let inside: Vec<(usize, usize)> = pairs.filter(|&pair| Self::couples(n, pair)).collect();
        Self::from_couplings(n, &inside)
    }

    /// Whether a pair is one of different equations that there are.
    fn couples(n: usize, (i, j): (usize, usize)) -> bool {
        i < n && j < n && i != j
    }

    /// Pattern of `n` equations from pairs that all couple.
    fn from_couplings(n: usize, inside: &[(usize, usize)]) -> Self {
        let mut start = vec![0usize; n + 1];
        for &(i, j) in inside {
            start[i + 1] += 1;
            start[j + 1] += 1;
        }
        for i in 0..n {
            start[i + 1] += start[i] + 1;
        }
        let mut all = vec![0usize; start[n]];
        let mut next = start.clone();
        let mut put = |i: usize, j: usize| {
            all[next[i]] = j;
            next[i] += 1;
        };
        for i in 0..n {
            put(i, i);
        }
        for &(i, j) in inside {
            put(i, j);
            put(j, i);
        }
        Self::from_unsorted_rows(n, &start, &mut all)
    }

    /// Pattern of `n` equations in which every clique (the dofs of an element, a contact stencil)
    /// couples all its members with one another. Members outside `0..n` are ignored.
    pub fn from_cliques(n: usize, cliques: impl Iterator<Item = impl AsRef<[usize]>>) -> Self {
        let cliques = Cliques::new(n, cliques);
        let (mut start, mut column) = (Vec::with_capacity(n + 1), Vec::with_capacity(16 * n));
        start.push(0);
        let mut row_of = vec![usize::MAX; n];
        for i in 0..n {
            let begin = column.len();
            if i > 0 && cliques.are_those_of(i - 1, i) {
                column.extend_from_within(start[i - 1]..);
            } else {
                let members = cliques.of(i).iter().flat_map(|&clique| cliques.members(clique));
                for &j in std::iter::once(&i).chain(members) {
                    if std::mem::replace(&mut row_of[j], i) != i {
                        column.push(j);
                    }
                }
                column[begin..].sort_unstable();
            }
            start.push(column.len());
        }
        column.shrink_to_fit();
        Self { rows: Arc::new(Rows { start, column }) }
    }

    fn from_unsorted_rows(n: usize, start: &[usize], all: &mut [usize]) -> Self {
        let mut row_start = Vec::with_capacity(n + 1);
        let mut column = Vec::with_capacity(all.len());
        row_start.push(0);
        for i in 0..n {
            let row = &mut all[start[i]..start[i + 1]];
            row.sort_unstable();
            let mut last = usize::MAX;
            for &j in row.iter() {
                if j != last {
                    column.push(j);
                    last = j;
                }
            }
            row_start.push(column.len());
        }
        column.shrink_to_fit();
        Self { rows: Arc::new(Rows { start: row_start, column }) }
    }

    /// The pattern of some equations alone, given ascending.
    pub(crate) fn among(&self, kept: &[usize]) -> Self {
        let mut number = vec![usize::MAX; self.size()];
        kept.iter().enumerate().for_each(|(new, &old)| number[old] = new);
        let (mut start, mut column) = (Vec::with_capacity(kept.len() + 1), Vec::new());
        start.push(0);
        for &i in kept {
            column.extend(self.row(i).iter().map(|&j| number[j]).filter(|&j| j != usize::MAX));
            start.push(column.len());
        }
        Self { rows: Arc::new(Rows { start, column }) }
    }

    /// Number of equations.
    pub fn size(&self) -> usize {
        self.rows.start.len() - 1
    }

    /// Number of stored entries, both triangles and the diagonal.
    pub fn entries(&self) -> usize {
        self.rows.column.len()
    }

    /// Columns of row `i`, ascending.
    pub fn row(&self, i: usize) -> &[usize] {
        &self.rows.column[self.rows.start[i]..self.rows.start[i + 1]]
    }

    /// Where each row begins among the entries; length `size() + 1`.
    pub fn row_start(&self) -> &[usize] {
        &self.rows.start
    }

    /// Columns of all entries, row after row.
    pub fn columns(&self) -> &[usize] {
        &self.rows.column
    }

    /// Index of entry (i, j) in the array of values, `None` when the pattern does not hold it.
    pub fn position(&self, i: usize, j: usize) -> Option<usize> {
        if i >= self.size() {
            return None;
        }
        self.row(i).binary_search(&j).ok().map(|at| self.rows.start[i] + at)
    }

    /// The same where the entry may be the one at `next`, as columns of a node follow one another, or one of the
    /// three before it, as those of a node with axes of its own come again; then `next` is the one behind it.
    pub fn position_at(&self, (i, j): (usize, usize), next: &mut usize) -> Option<usize> {
        let row = (i < self.size()).then(|| self.rows.start[i]..self.rows.start[i + 1])?;
        let near = [0, 3, 2, 1].map(|back| next.wrapping_sub(back));
        let is_there = |at: &usize| row.contains(at) && self.rows.column[*at] == j;
        let found = near.into_iter().find(is_there).or_else(|| self.position(i, j));
        *next = found.map_or(*next, |at| at + 1);
        found
    }
}

/// Sets of equations that couple, and the sets that each equation is in.
struct Cliques {
    member: Vec<usize>,
    /// Where the members of each set end.
    end: Vec<usize>,
    clique: Vec<u32>,
    /// Where the sets of each equation begin.
    start: Vec<usize>,
}

impl Cliques {
    fn new(n: usize, cliques: impl Iterator<Item = impl AsRef<[usize]>>) -> Self {
        let (mut member, mut end) = (Vec::with_capacity(4 * n), Vec::with_capacity(n));
        for clique in cliques {
            member.extend(clique.as_ref().iter().copied().filter(|&i| i < n));
            end.push(member.len());
        }
        let mut start = vec![0; n + 1];
        member.iter().for_each(|&i| start[i + 1] += 1);
        for i in 0..n {
            start[i + 1] += start[i];
        }
        let (mut clique, mut next) = (vec![0; member.len()], start.clone());
        let mut begin = 0;
        for (number, &end) in end.iter().enumerate() {
            for &i in &member[begin..end] {
                clique[next[i]] = number as u32;
                next[i] += 1;
            }
            begin = end;
        }
        Self { member, end, clique, start }
    }

    /// The sets that an equation is in, ascending.
    fn of(&self, i: usize) -> &[u32] {
        &self.clique[self.start[i]..self.start[i + 1]]
    }

    fn members(&self, clique: u32) -> &[usize] {
        let clique = clique as usize;
        let begin = clique.checked_sub(1).map_or(0, |before| self.end[before]);
        &self.member[begin..self.end[clique]]
    }

    /// Whether two equations are in the same sets, and so have the same row.
    fn are_those_of(&self, i: usize, j: usize) -> bool {
        !self.of(i).is_empty() && self.of(i) == self.of(j)
    }
}

/// A pattern together with its values, borrowed.
#[derive(Clone, Copy, Debug)]
pub struct Matrix<'a> {
    /// Where the entries are.
    pub pattern: &'a Pattern,
    /// Values in the order of the pattern's entries.
    pub values: &'a [f64],
}

impl<'a> Matrix<'a> {
    /// The matrix of a pattern and its values (`values.len() == pattern.entries()`).
    pub fn new(pattern: &'a Pattern, values: &'a [f64]) -> Self {
        Self { pattern, values }
    }

    /// Columns and values of row `i`.
    pub fn row(&self, i: usize) -> (&'a [usize], &'a [f64]) {
        let range = self.pattern.rows.start[i]..self.pattern.rows.start[i + 1];
        (&self.pattern.rows.column[range.clone()], &self.values[range])
    }

    /// y = A x.
    pub fn multiply(&self, x: &[f64], y: &mut [f64]) {
        for (i, y_i) in y.iter_mut().enumerate().take(self.pattern.size()) {
            *y_i = self.row_times(i, x);
        }
    }

    /// y = A' x.
    pub fn multiply_transpose(&self, x: &[f64], y: &mut [f64]) {
        y.fill(0.0);
        for (i, &x_i) in x.iter().enumerate().take(self.pattern.size()) {
            let (columns, values) = self.row(i);
            for (&j, &a) in columns.iter().zip(values) {
                y[j] += a * x_i;
            }
        }
    }

    /// Row `i` times x, summed in two interleaved halves to shorten the chain of additions.
    pub(crate) fn row_times(&self, i: usize, x: &[f64]) -> f64 {
        let (columns, values) = self.row(i);
        let (mut even, mut odd) = (0.0, 0.0);
        let mut column_pairs = columns.chunks_exact(2);
        let mut value_pairs = values.chunks_exact(2);
        for (j, a) in column_pairs.by_ref().zip(value_pairs.by_ref()) {
            even += a[0] * x[j[0]];
            odd += a[1] * x[j[1]];
        }
        if let ([j], [a]) = (column_pairs.remainder(), value_pairs.remainder()) {
            even += a * x[*j];
        }
        even + odd
    }

    /// Sum of magnitudes of row `i`: the size of equation `i`.
    pub(crate) fn row_size(&self, i: usize) -> f64 {
        let (_, values) = self.row(i);
        let mut lanes = [0.0; 4];
        let mut fours = values.chunks_exact(4);
        for four in fours.by_ref() {
            for (lane, value) in lanes.iter_mut().zip(four) {
                *lane += value.abs();
            }
        }
        for (lane, value) in lanes.iter_mut().zip(fours.remainder()) {
            *lane += value.abs();
        }
        (lanes[0] + lanes[1]) + (lanes[2] + lanes[3])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        // Requirement: cliques couple exactly their pairs; members that are no equations couple
        // nothing, repeated ones once.
        #[test]
        fn cliques_are_their_pairs(
            n in 1usize..30,
            cliques in prop::collection::vec(prop::collection::vec(0usize..32, 0..7), 0..20),
        ) {
            let pairs = cliques.iter().flat_map(|own| {
                own.iter().flat_map(move |&i| own.iter().map(move |&j| (i, j)))
            });
            let from_pairs = Pattern::from_pairs(n, pairs);
            prop_assert_eq!(Pattern::from_cliques(n, cliques.iter()), from_pairs);
        }

        // Requirement: whatever entry is expected next, the same one is found.
        #[test]
        fn what_is_expected_changes_nothing(
            n in 1usize..12,
            cliques in prop::collection::vec(prop::collection::vec(0usize..12, 0..7), 0..9),
            asked in prop::collection::vec((0usize..13, 0usize..13), 0..40),
            first in 0usize..200,
        ) {
            let pattern = Pattern::from_cliques(n, cliques.iter());
            let mut next = first;
            for (i, j) in asked {
                prop_assert_eq!(pattern.position_at((i, j), &mut next), pattern.position(i, j));
            }
        }
    }
}
