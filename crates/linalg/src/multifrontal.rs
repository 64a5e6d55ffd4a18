//! Multifrontal factorisation, L D L' or L U, over a symmetric pattern.
//!
//! ```text
//!   front 0   front 1        each front eliminates its columns and hands the Schur complement of
//!        \     /             its rows up; those that wait lie on a stack, whose height is known
//!        front 2
//! ```
//!
//! [duff1983], [liu1992]. Everything is sized by the analysis: a factorisation allocates
//! nothing, and the same values give the same bits.

mod substitution;

use crate::dense_fronts::{DenseFront, Pivots};
use crate::fronts::{Front, Fronts, NONE, Tree};
use crate::ordering::positions;
use crate::pattern::Pattern;
use crate::system::Kind;

/// Where the parts of a front are.
#[derive(Clone, Copy, Debug, Default)]
struct Storage {
    /// Its columns, in the factor.
    panel: usize,
    /// U12, behind them; empty for symmetric systems.
    above: usize,
    /// What is behind both.
    end: usize,
    /// Its Schur complement while it is at work, on the stack.
    work: usize,
    /// And while it waits for the parent.
    update: usize,
}

/// A multifrontal factorisation.
pub(crate) struct Multifrontal {
    symmetric: bool,
    fronts: Fronts,
    storage: Vec<Storage>,
    /// Children of each front, those of front f from `child_start[f]` on.
    child: Vec<u32>,
    child_start: Vec<usize>,
    /// Where each entry of the matrix goes in the factor; entries above the diagonal of a symmetric
    /// matrix go to a place behind it.
    entry: Vec<u32>,
    factor: Vec<f64>,
    stack: Vec<f64>,
    scratch: Vec<f64>,
    exchange: Vec<u32>,
    /// Sizes of the equations in the order of elimination.
    size: Vec<f64>,
    /// Right-hand sides in the order of elimination.
    x: Vec<f64>,
    /// Rows of one front of them.
    rows: Vec<f64>,
}

impl Multifrontal {
    /// Lays the factorisation out; `None` where it is beyond 32-bit places.
    pub fn new(pattern: &Pattern, kind: Kind, tree: &Tree) -> Option<Self> {
        let symmetric = kind == Kind::Symmetric;
        let fronts = Fronts::new(pattern, tree);
        let (child, child_start) = children(&fronts);
        let (storage, stack) = lay_out(&fronts, symmetric, &child, &child_start);
        let length = storage.last().map_or(0, |last| last.end);
        if length >= u32::MAX as usize {
            return None;
        }
        let n = pattern.size();
        let panel = |front: &Front| front.columns * (front.columns + front.rows);
        let scratch = fronts.front.iter().map(panel).max().unwrap_or(0);
        let entry = entry_positions(pattern, &fronts, &storage, symmetric);
        Some(Self {
            symmetric,
            storage,
            child,
            child_start,
            entry,
            factor: vec![0.0; length + 1],
            stack: vec![0.0; stack],
            scratch: if symmetric { vec![0.0; scratch] } else { Vec::new() },
            exchange: vec![0; n],
            size: vec![0.0; n],
            x: vec![0.0; n],
            rows: vec![0.0; fronts.front.iter().map(|front| front.rows).max().unwrap_or(0)],
            fronts,
        })
    }

    /// Caller's equation at a position of the order of elimination.
    pub fn equation(&self, position: usize) -> usize {
        self.fronts.order[position]
    }

    pub fn scatter(&mut self, values: &[f64]) {
        self.factor.fill(0.0);
        for (&value, &at) in values.iter().zip(&self.entry) {
            self.factor[at as usize] = value;
        }
    }

    /// Factors what was scattered. Small pivots are replaced; the smallest tells.
    pub fn factor(&mut self, row_size: &[f64]) -> Pivots {
        for (size, &equation) in self.size.iter_mut().zip(&self.fronts.order) {
            *size = row_size[equation];
        }
        let mut pivots = Pivots::NONE;
        for f in 0..self.storage.len() {
            self.factor_front(f, &mut pivots);
        }
        pivots
    }

    fn factor_front(&mut self, f: usize, pivots: &mut Pivots) {
        let Front { first, columns, rows, .. } = self.fronts.front[f];
        let Storage { panel, above, end, work, update } = self.storage[f];
        let (waiting, own) = self.stack.split_at_mut(work);
        let own = &mut own[..rows * rows];
        own.fill(0.0);
        let (panel, above) = self.factor[panel..end].split_at_mut(above - panel);
        let mut front = DenseFront { panel, above, update: own, columns, rows, first };
        for &child in &self.child[self.child_start[f]..self.child_start[f + 1]] {
            let Front { rows_start, rows, .. } = self.fronts.front[child as usize];
            let in_parent = &self.fronts.in_parent[rows_start..rows_start + rows];
            let update = &waiting[self.storage[child as usize].update..][..rows * rows];
            match self.symmetric {
                true => extend_symmetric(&mut front, update, in_parent),
                false => extend(&mut front, update, in_parent),
            }
        }
        let size = &self.size[first..first + columns];
        if self.symmetric {
            front.factor_ldlt(size, &mut self.scratch, pivots);
        } else {
            front.factor_lu(size, &mut self.exchange[first..first + columns], pivots);
        }
        self.stack.copy_within(work..work + rows * rows, update);
    }
}

/// Adds a child's Schur complement.
fn extend(front: &mut DenseFront<'_>, update: &[f64], in_parent: &[u32]) {
    let (k, r) = (front.columns, front.rows);
    let split = in_parent.partition_point(|&at| (at as usize) < k);
    for (column, &to) in update.chunks_exact(in_parent.len().max(1)).zip(in_parent) {
        let to = to as usize;
        if to < k {
            let target = &mut front.panel[to * (k + r)..(to + 1) * (k + r)];
            add_at(target, in_parent, column, 0);
            continue;
        }
        let above = &mut front.above[(to - k) * k..(to - k + 1) * k];
        add_at(above, &in_parent[..split], &column[..split], 0);
        let own = &mut front.update[(to - k) * r..(to - k + 1) * r];
        add_at(own, &in_parent[split..], &column[split..], k);
    }
}

/// Adds the lower triangle of a child's Schur complement.
fn extend_symmetric(front: &mut DenseFront<'_>, update: &[f64], in_parent: &[u32]) {
    let (k, r) = (front.columns, front.rows);
    let columns = update.chunks_exact(in_parent.len().max(1)).zip(in_parent).enumerate();
    for (j, (column, &to)) in columns {
        let to = to as usize;
        let (target, offset) = if to < k {
            (&mut front.panel[to * (k + r)..(to + 1) * (k + r)], 0)
        } else {
            (&mut front.update[(to - k) * r..(to - k + 1) * r], k)
        };
        add_at(target, &in_parent[j..], &column[j..], offset);
    }
}

fn add_at(target: &mut [f64], at: &[u32], source: &[f64], offset: usize) {
    for (&at, value) in at.iter().zip(source) {
        target[at as usize - offset] += value;
    }
}

fn children(fronts: &Fronts) -> (Vec<u32>, Vec<usize>) {
    let mut start = vec![0; fronts.front.len() + 1];
    let parents = || fronts.front.iter().map(|front| front.parent);
    parents().filter(|&parent| parent != NONE).for_each(|parent| start[parent as usize + 1] += 1);
    for f in 1..start.len() {
        start[f] += start[f - 1];
    }
    let mut child = vec![0; start.last().copied().unwrap_or(0)];
    let mut next = start.clone();
    for (f, parent) in parents().enumerate().filter(|&(_, parent)| parent != NONE) {
        child[next[parent as usize]] = f as u32;
        next[parent as usize] += 1;
    }
    (child, start)
}

/// Places of all fronts, and the height of the stack.
fn lay_out(
    fronts: &Fronts,
    symmetric: bool,
    child: &[u32],
    child_start: &[usize],
) -> (Vec<Storage>, usize) {
    let mut storage: Vec<Storage> = Vec::with_capacity(fronts.front.len());
    let (mut factor, mut top, mut highest) = (0, 0, 0);
    for (f, front) in fronts.front.iter().enumerate() {
        let (k, r) = (front.columns, front.rows);
        let panel = factor;
        let above = panel + k * (k + r);
        let end = above + if symmetric { 0 } else { k * r };
        let first_child = child[child_start[f]..child_start[f + 1]].first();
        let update = first_child.map_or(top, |&child| storage[child as usize].update);
        storage.push(Storage { panel, above, end, work: top, update });
        highest = highest.max(top + r * r);
        top = update + r * r;
        factor = end;
    }
    (storage, highest)
}

/// Where each entry of the matrix goes: both entries of a pair go to the front that eliminates the
/// first of its two equations.
fn entry_positions(
    pattern: &Pattern,
    fronts: &Fronts,
    storage: &[Storage],
    symmetric: bool,
) -> Vec<u32> {
    let n = pattern.size();
    let position = positions(n, &fronts.order);
    let transposed = transposed_entries(pattern);
    let nowhere = storage.last().map_or(0, |last| last.end);
    let mut entry = vec![nowhere as u32; pattern.entries()];
    let mut local = vec![0usize; n];
    for (front, storage) in fronts.front.iter().zip(storage) {
        let (k, height) = (front.columns, front.columns + front.rows);
        let own = front.first..front.first + k;
        let rows = fronts.rows_of(front).iter().map(|&row| row as usize);
        own.clone().chain(rows).enumerate().for_each(|(at, position)| local[position] = at);
        for at in own {
            let equation = fronts.order[at];
            let row = local[at];
            let start = pattern.row_start()[equation];
            for (e, &neighbour) in (start..).zip(pattern.row(equation)) {
                if position[neighbour] < front.first {
                    continue;
                }
                let column = local[position[neighbour]];
                let lower = |i: usize, j: usize| storage.panel + j * height + i;
                if column >= k {
                    entry[transposed[e]] = lower(column, row) as u32;
                    if !symmetric {
                        entry[e] = (storage.above + (column - k) * k + row) as u32;
                    }
                } else if !symmetric || row >= column {
                    entry[e] = lower(row, column) as u32;
                }
            }
        }
    }
    entry
}

/// Index of the entry (j, i) for every entry (i, j).
fn transposed_entries(pattern: &Pattern) -> Vec<usize> {
    let mut next = pattern.row_start().to_vec();
    let at = |&j: &usize| {
        let entry = next[j];
        next[j] += 1;
        entry
    };
    pattern.columns().iter().map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::Matrix;

    /// Plane grid of blocks of three dofs whose diagonals are weak within the block: unsymmetric
    /// values need exchanges among a front's columns. The symmetric ones are indefinite.
    fn system(side: usize, kind: Kind) -> (Pattern, Vec<f64>) {
        let node = |x: usize, y: usize| x * side + y;
        let cells = (0..side - 1).flat_map(|x| (0..side - 1).map(move |y| (x, y)));
        let clique = |(x, y): (usize, usize)| -> Vec<usize> {
            let corners = [node(x, y), node(x + 1, y), node(x, y + 1), node(x + 1, y + 1)];
            corners.into_iter().flat_map(|corner| 3 * corner..3 * corner + 3).collect()
        };
        let cliques: Vec<Vec<usize>> = cells.map(clique).collect();
        let pattern = Pattern::from_cliques(3 * side * side, cliques.iter());
        let value = |i: usize, j: usize| {
            let random = ((i * 7919 + j * 104_729) % 1009) as f64 / 1009.0 - 0.5;
            match (i / 3 == j / 3, i == j, kind) {
                (_, true, Kind::Symmetric) => {
                    if i.is_multiple_of(5) {
                        -40.0
                    } else {
                        35.0
                    }
                }
                (_, true, Kind::Unsymmetric) => 0.01 * random,
                // A cyclic exchange of the dofs of a node carries the size.
                (true, _, Kind::Unsymmetric) if (i + 1) % 3 == j % 3 => 40.0 + random,
                _ => random,
            }
        };
        let rows = (0..pattern.size()).flat_map(|i| pattern.row(i).iter().map(move |&j| (i, j)));
        let of_kind = |(i, j): (usize, usize)| match kind {
            Kind::Symmetric => value(i.min(j), i.max(j)),
            Kind::Unsymmetric => value(i, j),
        };
        let values = rows.map(of_kind).collect();
        (pattern, values)
    }

    fn factored(pattern: &Pattern, values: &[f64], kind: Kind) -> (Multifrontal, Pivots) {
        let natural: Vec<usize> = (0..pattern.size()).rev().collect();
        let tree = Tree::new(pattern, &natural);
        let mut factors = Multifrontal::new(pattern, kind, &tree).unwrap();
        let matrix = Matrix::new(pattern, values);
        let size: Vec<f64> = (0..pattern.size()).map(|i| matrix.row_size(i)).collect();
        factors.scatter(values);
        let pivots = factors.factor(&size);
        (factors, pivots)
    }

    /// Requirement: solutions, transposed ones and blocks meet their equations to rounding, with
    /// fronts wide enough for every branch (halved columns) and with exchanges.
    #[test]
    fn solutions_meet_their_equations() {
        for kind in [Kind::Symmetric, Kind::Unsymmetric] {
            let (pattern, values) = system(14, kind);
            let n = pattern.size();
            let (mut factors, pivots) = factored(&pattern, &values, kind);
            let widest = factors.fronts.front.iter().map(|front| front.columns).max();
            assert!(widest > Some(24), "{widest:?}");
            assert!(pivots.smallest_ratio > 1e-3, "{pivots:?}");
            let exchanged = factors.fronts.front.iter().any(|front| {
                let own = &factors.exchange[front.first..front.first + front.columns];
                own.iter().enumerate().any(|(j, &row)| row as usize != j)
            });
            assert!(exchanged || kind == Kind::Symmetric);
            let matrix = Matrix::new(&pattern, &values);
            for (columns, transposed) in [(1, false), (1, true), (5, false), (5, true)] {
                let b: Vec<f64> = (0..n * columns).map(|i| ((i * 31) % 17) as f64 - 8.0).collect();
                let mut x = b.clone();
                factors.solve(&mut x, columns, transposed);
                let mut product = vec![0.0; n];
                for (x, b) in x.chunks(n).zip(b.chunks(n)) {
                    match transposed {
                        true => matrix.multiply_transpose(x, &mut product),
                        false => matrix.multiply(x, &mut product),
                    }
                    let worst =
                        product.iter().zip(b).map(|(p, b)| (p - b).abs()).fold(0.0, f64::max);
                    assert!(worst < 1e-11, "{kind:?} {columns} {transposed}: {worst:e}");
                }
            }
        }
    }

    /// Requirement: the number of negative pivots is that of negative eigenvalues; Gershgorin gives
    /// their signs here (every diagonal exceeds the rest of its row).
    #[test]
    fn negative_pivots_are_counted() {
        let (pattern, values) = system(8, Kind::Symmetric);
        let (_, pivots) = factored(&pattern, &values, Kind::Symmetric);
        assert_eq!(pivots.negative, (0..pattern.size()).filter(|i| i.is_multiple_of(5)).count());
    }

    /// Requirement: an equation without pivot is named by both factorisations, wherever it is, and
    /// the others are eliminated all the same.
    #[test]
    fn equations_without_pivot_are_named() {
        for kind in [Kind::Symmetric, Kind::Unsymmetric] {
            for missing in [0, 100, 190] {
                let (pattern, mut values) = system(8, kind);
                for i in 0..pattern.size() {
                    let start = pattern.row_start()[i];
                    for (e, &j) in (start..).zip(pattern.row(i)) {
                        if i == missing || j == missing {
                            values[e] = if i == j { 1e-18 } else { 0.0 };
                        }
                    }
                }
                let mut reference = values.clone();
                let natural: Vec<usize> = (0..pattern.size()).rev().collect();
                let tree = Tree::new(&pattern, &natural);
                let mut factors = Multifrontal::new(&pattern, kind, &tree).unwrap();
                reference.iter_mut().for_each(|v| *v *= 2.0);
                factors.scatter(&reference);
                factors.factor(&vec![60.0; pattern.size()]);
                factors.scatter(&values);
                let pivots = factors.factor(&vec![60.0; pattern.size()]);
                assert_eq!(factors.equation(pivots.smallest), missing, "{kind:?}");
                assert!(
                    pivots.smallest_ratio < 1e-16 && factors.factor.iter().all(|l| l.is_finite())
                );
            }
        }
    }
}
