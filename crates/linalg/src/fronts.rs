//! Symbolic factorisation for a symmetric pattern: elimination tree, column counts, and the dense
//! fronts in which columns with nearly the same rows are eliminated together.
//!
//! ```text
//!   matrix            elimination tree      front of columns 2, 3     its rows
//!   x . x . .              4                        | 2 3 | 4 |
//!   . x . x .              |                     2  | x x | x |       columns  |  rows
//!   x . x x x              3                     3  | x x | x |     (eliminated)| (handed to
//!   . x x x x             / \                       +-----+---+                | the parent)
//!   . . x x x            2   1                   4  | x x | x |
//!                        |
//!                        0
//! ```
//!
//! [liu1990] for the tree, [gilbert1994] for the counts, [ashcraft1989]
//! for fronts that are joined although that stores zeros.

use crate::ordering::positions;
use crate::pattern::Pattern;

/// Not a column or front.
pub(crate) const NONE: u32 = u32::MAX;

/// Up to so many columns together, so large a part of the entries may be zeros that are stored for
/// joining two fronts.
const RELAXED: [(usize, f64); 4] = [(4, 1.0), (16, 0.8), (48, 0.1), (usize::MAX, 0.05)];

/// Elimination tree in an order, with the order changed such that subtrees are contiguous.
pub(crate) struct Tree {
    /// Caller's equation at each position.
    pub order: Vec<usize>,
    /// Parent of each column.
    parent: Vec<u32>,
    /// Entries of each column of the factor, with the diagonal.
    count: Vec<u32>,
}

impl Tree {
    pub fn new(pattern: &Pattern, order: &[usize]) -> Self {
        let first = elimination_tree(pattern, order);
        let post = postorder(&first);
        let order: Vec<usize> = post.iter().map(|&k| order[k as usize]).collect();
        let mut new_position = vec![0u32; order.len()];
        post.iter().enumerate().for_each(|(new, &old)| new_position[old as usize] = new as u32);
        let renamed = |old: u32| if old == NONE { NONE } else { new_position[old as usize] };
        let parent: Vec<u32> = post.iter().map(|&old| renamed(first[old as usize])).collect();
        let count = column_counts(pattern, &order, &parent);
        Self { order, parent, count }
    }

    /// Entries of the triangular factor, and the multiplications and additions of a symmetric
    /// factorisation (an unsymmetric one needs twice as many of both).
    pub fn predicted(&self) -> (f64, f64) {
        let add = |(entries, operations): (f64, f64), &count: &u32| {
            (entries + f64::from(count), operations + f64::from(count).powi(2))
        };
        self.count.iter().fold((0.0, 0.0), add)
    }
}

impl Tree {
    /// Entries of the columns of some equations and of all above them.
    pub fn entries_above(&self, equations: &[usize]) -> f64 {
        let position = positions(self.order.len(), &self.order);
        let mut is_on = vec![false; self.order.len()];
        equations.iter().for_each(|&equation| is_on[position[equation]] = true);
        let mut entries = 0.0;
        for k in 0..is_on.len() {
            if !is_on[k] {
                continue;
            }
            entries += f64::from(self.count[k]);
            if self.parent[k] != NONE {
                is_on[self.parent[k] as usize] = true;
            }
        }
        entries
    }
}

/// Parent of each column in the elimination tree.
fn elimination_tree(pattern: &Pattern, order: &[usize]) -> Vec<u32> {
    let n = order.len();
    let position = positions(n, order);
    let mut parent = vec![NONE; n];
    let mut ancestor = vec![NONE; n];
    for (k, &equation) in order.iter().enumerate() {
        for &neighbour in pattern.row(equation) {
            let mut at = position[neighbour];
            while at < k && ancestor[at] != k as u32 {
                let above = ancestor[at];
                ancestor[at] = k as u32;
                if above == NONE {
                    parent[at] = k as u32;
                    break;
                }
                at = above as usize;
            }
        }
    }
    parent
}

/// Order in which every subtree is contiguous and ends with its root.
fn postorder(parent: &[u32]) -> Vec<u32> {
    let n = parent.len();
    let (mut child, mut sibling) = (vec![NONE; n], vec![NONE; n]);
    for k in (0..n).rev().filter(|&k| parent[k] != NONE) {
        let above = parent[k] as usize;
        sibling[k] = child[above];
        child[above] = k as u32;
    }
    let mut order = Vec::with_capacity(n);
    let mut stack = Vec::new();
    for root in (0..n).filter(|&k| parent[k] == NONE) {
        stack.push(root as u32);
        while let Some(&top) = stack.last() {
            let next = child[top as usize];
            if next == NONE {
                order.push(top);
                stack.pop();
            } else {
                child[top as usize] = sibling[next as usize];
                stack.push(next);
            }
        }
    }
    order
}

/// Entries of every column of the factor, for an order in which subtrees are contiguous: each row
/// of the factor is a subtree of the elimination tree, whose leaves are counted.
fn column_counts(pattern: &Pattern, order: &[usize], parent: &[u32]) -> Vec<u32> {
    let n = order.len();
    let position = positions(n, order);
    let mut first: Vec<u32> = (0..n as u32).collect();
    let mut change = vec![1i64; n];
    for k in 0..n {
        if parent[k] != NONE {
            let above = parent[k] as usize;
            first[above] = first[above].min(first[k]);
            change[above] = 0; // not a leaf
        }
    }
    let mut last_leaf = vec![NONE; n];
    let mut ancestor: Vec<u32> = (0..n as u32).collect();
    for k in 0..n {
        if parent[k] != NONE {
            change[parent[k] as usize] -= 1;
        }
        for &neighbour in pattern.row(order[k]) {
            let row = position[neighbour];
            let before = last_leaf[row];
            if row <= k || (before != NONE && before >= first[k]) {
                continue; // not in the column, or below it in the row's subtree already
            }
            change[k] += 1;
            if before != NONE {
                change[root_of(&mut ancestor, before) as usize] -= 1;
            }
            last_leaf[row] = k as u32;
        }
        if parent[k] != NONE {
            ancestor[k] = parent[k];
        }
    }
    for k in 0..n {
        if parent[k] != NONE {
            change[parent[k] as usize] += change[k];
        }
    }
    change.into_iter().map(|count| count as u32).collect()
}

fn root_of(ancestor: &mut [u32], from: u32) -> u32 {
    let mut root = from;
    while ancestor[root as usize] != root {
        root = ancestor[root as usize];
    }
    let mut at = from;
    while at != root {
        at = std::mem::replace(&mut ancestor[at as usize], root);
    }
    root
}

/// One front.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Front {
    /// First of its columns.
    pub first: usize,
    /// Number of its columns.
    pub columns: usize,
    /// Where its rows begin in the list of all.
    pub rows_start: usize,
    /// Number of rows that it hands to its parent.
    pub rows: usize,
    /// Front that receives them.
    pub parent: u32,
}

/// Fronts in the order of their elimination: children before parents, subtrees contiguous.
#[derive(Clone, Debug, Default)]
pub(crate) struct Fronts {
    /// Caller's equation at each position.
    pub order: Vec<usize>,
    pub front: Vec<Front>,
    /// Positions of the rows of every front, ascending, front after front.
    pub row: Vec<u32>,
    /// Where each of them stands in the parent: among its columns, then among its rows.
    pub in_parent: Vec<u32>,
    /// For each of them, how many of the following ones, itself included, stand side by side
    /// there too.
    pub together: Vec<u32>,
}

impl Fronts {
    pub fn new(pattern: &Pattern, tree: &Tree) -> Self {
        let joined = join_fronts(tree);
        let mut fronts = Self::in_order(tree, &joined);
        fronts.find_rows(pattern);
        fronts
    }

    pub fn rows_of(&self, front: &Front) -> &[u32] {
        &self.row[front.rows_start..front.rows_start + front.rows]
    }

    /// Lays the joined fronts out, children before parents.
    fn in_order(tree: &Tree, joined: &Joined) -> Self {
        let post = postorder(&joined.parent);
        let mut new_number = vec![NONE; joined.parent.len()];
        let mut fronts = Self { order: Vec::with_capacity(tree.order.len()), ..Self::default() };
        for &old in &post {
            let columns = &joined.columns[old as usize];
            if columns.is_empty() {
                continue; // joined to another
            }
            new_number[old as usize] = fronts.front.len() as u32;
            fronts.front.push(Front {
                first: fronts.order.len(),
                columns: columns.len(),
                parent: joined.parent[old as usize],
                ..Front::default()
            });
            fronts.order.extend(columns.iter().map(|&k| tree.order[k as usize]));
        }
        for front in &mut fronts.front {
            if front.parent != NONE {
                front.parent = new_number[front.parent as usize];
            }
        }
        fronts
    }

    /// Rows of all fronts: neighbours of their columns and rows of their children beyond them.
    fn find_rows(&mut self, pattern: &Pattern) {
        let n = self.order.len();
        let position = positions(n, &self.order);
        let mut children: Vec<Vec<u32>> = vec![Vec::new(); self.front.len()];
        let mut seen = vec![NONE; n];
        for f in 0..self.front.len() {
            let Front { first, columns, parent, .. } = self.front[f];
            let (end, start) = (first + columns, self.row.len());
            for k in first..end {
                for &neighbour in pattern.row(self.order[k]) {
                    let at = position[neighbour];
                    if at >= end && seen[at] != f as u32 {
                        seen[at] = f as u32;
                        self.row.push(at as u32);
                    }
                }
            }
            for child in std::mem::take(&mut children[f]) {
                let Front { rows_start, rows, .. } = self.front[child as usize];
                for i in rows_start..rows_start + rows {
                    let at = self.row[i];
                    if at as usize >= end && seen[at as usize] != f as u32 {
                        seen[at as usize] = f as u32;
                        self.row.push(at);
                    }
                }
            }
            self.row[start..].sort_unstable();
            let front = &mut self.front[f];
            (front.rows_start, front.rows) = (start, self.row.len() - start);
            if parent != NONE {
                children[parent as usize].push(f as u32);
            }
        }
        self.find_in_parents(n);
    }

    fn find_in_parents(&mut self, n: usize) {
        self.in_parent = vec![0; self.row.len()];
        let mut local = vec![0u32; n];
        let mut children: Vec<Vec<usize>> = vec![Vec::new(); self.front.len()];
        for (f, front) in self.front.iter().enumerate() {
            if front.parent != NONE {
                children[front.parent as usize].push(f);
            }
        }
        for (f, front) in self.front.iter().enumerate() {
            let own = (front.first..front.first + front.columns).map(|k| k as u32);
            let rows = self.row[front.rows_start..front.rows_start + front.rows].iter().copied();
            own.chain(rows).enumerate().for_each(|(at, k)| local[k as usize] = at as u32);
            for &child in &children[f] {
                let Front { rows_start, rows, .. } = self.front[child];
                for i in rows_start..rows_start + rows {
                    self.in_parent[i] = local[self.row[i] as usize];
                }
            }
        }
        self.together = vec![1; self.row.len()];
        for front in &self.front {
            for i in (front.rows_start + 1..front.rows_start + front.rows).rev() {
                if self.in_parent[i] == self.in_parent[i - 1] + 1 {
                    self.together[i - 1] = self.together[i] + 1;
                }
            }
        }
    }
}

/// Fronts after joining: those that went into another have no columns.
struct Joined {
    columns: Vec<Vec<u32>>,
    parent: Vec<u32>,
}

/// Columns that follow one another with the same rows become fronts; a front joins its parent where
/// few zeros are stored for it.
fn join_fronts(tree: &Tree) -> Joined {
    let n = tree.order.len();
    let mut children = vec![0u32; n];
    tree.parent.iter().filter(|&&above| above != NONE).for_each(|&p| children[p as usize] += 1);
    let mut columns: Vec<Vec<u32>> = Vec::new();
    let mut front_of = vec![0u32; n];
    for k in 0..n {
        let continues = k > 0
            && tree.parent[k - 1] == k as u32
            && children[k] == 1
            && tree.count[k - 1] == tree.count[k] + 1;
        match columns.last_mut().filter(|_| continues) {
            Some(last) => last.push(k as u32),
            None => columns.push(vec![k as u32]),
        }
        front_of[k] = columns.len() as u32 - 1;
    }
    let last = |f: usize, columns: &[Vec<u32>]| columns[f].last().map_or(0, |&k| k as usize);
    let above = |f: usize| tree.parent[last(f, &columns)];
    let parent: Vec<u32> = (0..columns.len())
        .map(|f| if above(f) == NONE { NONE } else { front_of[above(f) as usize] })
        .collect();
    let rows: Vec<usize> =
        (0..columns.len()).map(|f| tree.count[last(f, &columns)] as usize - 1).collect();
    join(columns, parent, &rows)
}

fn join(mut columns: Vec<Vec<u32>>, parent: Vec<u32>, rows: &[usize]) -> Joined {
    let mut zeros = vec![0.0; columns.len()];
    let mut into: Vec<u32> = (0..columns.len() as u32).collect();
    for f in 0..columns.len() {
        if parent[f] == NONE {
            continue;
        }
        let p = parent[f] as usize;
        let (own, above) = (columns[f].len(), columns[p].len());
        let together = own + above;
        let added = own as f64 * (above + rows[p] - rows[f]) as f64;
        let all = zeros[f] + zeros[p] + added;
        let entries = together as f64 * ((together + 1) as f64 / 2.0 + rows[p] as f64);
        let allowed = |&(size, part): &(usize, f64)| together <= size && all < part * entries;
        if RELAXED.iter().any(allowed) {
            let mut moved = std::mem::take(&mut columns[f]);
            moved.append(&mut columns[p]);
            columns[p] = moved;
            zeros[p] = all;
            into[f] = p as u32;
        }
    }
    let mut joined = Joined { columns, parent };
    for f in (0..into.len()).rev() {
        // Parents come later, so that what they joined is known.
        let own = joined.parent[f];
        if own != NONE {
            joined.parent[f] = root_of(&mut into, own);
        }
        if into[f] != f as u32 {
            joined.parent[f] = NONE;
        }
    }
    joined
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Rows of each column of the factor, by elimination on the pattern itself.
    fn eliminated(pattern: &Pattern, order: &[usize]) -> Vec<Vec<usize>> {
        let n = order.len();
        let position = positions(n, order);
        let mut rows: Vec<Vec<bool>> = vec![vec![false; n]; n];
        for (k, &equation) in order.iter().enumerate() {
            pattern.row(equation).iter().for_each(|&j| rows[k][position[j]] = true);
        }
        for k in 0..n {
            let below: Vec<usize> = (k + 1..n).filter(|&i| rows[k][i]).collect();
            for &i in &below {
                below.iter().for_each(|&j| rows[i][j] = true);
            }
        }
        (0..n).map(|k| (k..n).filter(|&i| rows[k][i]).collect()).collect()
    }

    proptest! {
        // Requirement: predicted entries are those of an elimination by hand; every front holds the
        // rows that the elimination gives its columns, and no row that none of its columns or
        // children could have; its parent holds its rows, where `in_parent` says.
        #[test]
        fn fronts_are_those_of_the_elimination(
            n in 1usize..50,
            pairs in prop::collection::vec((0usize..50, 0usize..50), 0..120),
            turn in 1usize..50,
        ) {
            let pattern = Pattern::from_pairs(n, pairs.into_iter());
            let mut order: Vec<usize> = (0..n).collect();
            order.sort_by_key(|&i| (i * 37 + turn) % 53);
            let tree = Tree::new(&pattern, &order);
            let exact = eliminated(&pattern, &tree.order);
            let counts: Vec<usize> = tree.count.iter().map(|&count| count as usize).collect();
            prop_assert_eq!(counts, exact.iter().map(Vec::len).collect::<Vec<_>>());
            let fronts = Fronts::new(&pattern, &tree);
            let exact = eliminated(&pattern, &fronts.order);
            let mut next = 0;
            for (f, front) in fronts.front.iter().enumerate() {
                prop_assert_eq!(front.first, next);
                next += front.columns;
                let rows: Vec<usize> =
                    fronts.rows_of(front).iter().map(|&row| row as usize).collect();
                let mut wanted: Vec<usize> = (front.first..next)
                    .flat_map(|k| exact[k].iter().copied().filter(|&i| i >= next))
                    .collect();
                wanted.sort_unstable();
                wanted.dedup();
                prop_assert_eq!(&rows, &wanted);
                if front.parent == NONE {
                    prop_assert!(rows.is_empty());
                    continue;
                }
                prop_assert!(front.parent as usize > f);
                let parent = &fronts.front[front.parent as usize];
                let own = (parent.first..parent.first + parent.columns).map(|k| k as u32);
                let of_parent: Vec<u32> =
                    own.chain(fronts.rows_of(parent).iter().copied()).collect();
                let at = &fronts.in_parent[front.rows_start..front.rows_start + front.rows];
                for (&row, &at) in fronts.rows_of(front).iter().zip(at) {
                    prop_assert_eq!(of_parent[at as usize], row);
                }
            }
            prop_assert_eq!(next, n);
        }
    }

    /// Requirement: fronts are joined: a chain of 400 equations, whose exact fronts have one column
    /// each, becomes fronts of several; a dense matrix is one front.
    #[test]
    fn small_fronts_are_joined() {
        let chain = Pattern::from_pairs(400, (0..399).map(|i| (i, i + 1)));
        let natural: Vec<usize> = (0..400).collect();
        let fronts = Fronts::new(&chain, &Tree::new(&chain, &natural));
        assert!(fronts.front.len() <= 100, "{}", fronts.front.len());
        let all: Vec<usize> = (0..30).collect();
        let dense = Pattern::from_cliques(30, [&all].into_iter());
        assert_eq!(Fronts::new(&dense, &Tree::new(&dense, &all)).front.len(), 1);
    }
}
