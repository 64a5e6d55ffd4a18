//! Multifrontal factorisation, L D L' or L U, over a symmetric pattern.
//!
//! ```text
//!   front 0   front 1        each front eliminates its columns and hands the Schur complement of
//!        \     /             its rows up; those that wait lie on a stack, whose height is known
//!        front 2
//! ```
//!
//! [duff1983], [liu1992]. Everything is sized by the analysis: but for the first, a factorisation
//! allocates nothing, and the same values give the same bits, on any number of threads: these take
//! subtrees of about the same work, each with a stack of its own, and share the large products of
//! the fronts above, which are divided in the same way for any number of them.

mod layout;
mod path;
mod substitution;

use crate::dense_fronts::{DenseFront, Pivots};
use crate::error::SolveError;
use crate::fronts::{Front, Tree};
use crate::kernel::widened;
use crate::pattern::Pattern;
use crate::precision::Real;
use crate::system::Kind;
use layout::{Layout, Part, Path, Storage, entry_positions};
use rayon::ThreadPool;
use rayon::iter::{IndexedParallelIterator, IntoParallelRefMutIterator, ParallelIterator};
use std::sync::Arc;

/// A multifrontal factorisation.
pub(crate) struct Multifrontal<T = f64> {
    layout: Arc<Layout>,
    /// Where each entry of the matrix goes in the factor; entries above the diagonal of a symmetric
    /// matrix go to a place behind it.
    entry: Arc<[u32]>,
    pool: Option<Arc<ThreadPool>>,
    /// Fronts of the equations that most solutions are wanted on; none: all.
    path: Option<Arc<Path>>,
    /// Empty until something is scattered.
    factor: Vec<T>,
    /// Of the subtrees that threads take, one after the other, then of the fronts above them.
    rooms: Vec<Room<T>>,
    exchange: Vec<u32>,
    /// Sizes of the equations in the order of elimination.
    size: Vec<f64>,
    /// Right-hand sides in the order of elimination.
    x: Vec<T>,
    /// Rows of one front of them.
    rows: Vec<T>,
}

/// What the factorisation of fronts one after the other needs beside the factor.
struct Room<T> {
    stack: Vec<T>,
    scratch: Vec<T>,
}

/// Fronts that are factored one after the other, with what is written.
struct Share<'a, T> {
    /// Their part of the factor, and where it begins.
    factor: &'a mut [T],
    factor_start: usize,
    /// Their exchanges, and the position of the first.
    exchange: &'a mut [u32],
    first: usize,
    room: &'a mut Room<T>,
}

impl<T: Real> Multifrontal<T> {
    /// Lays the factorisation out; `None` where it is beyond 32-bit places.
    pub fn new(
        pattern: &Pattern,
        kind: Kind,
        tree: &Tree,
        pool: Option<Arc<ThreadPool>>,
    ) -> Option<Self> {
        let layout = Layout::new(pattern, kind, tree, pool.is_some());
        if layout.length >= u32::MAX as usize {
            return None;
        }
        let entry = entry_positions(pattern, &layout).into();
        Some(Self::with(Arc::new(layout), entry, pool))
    }

    /// The same factorisation in another precision.
    pub fn in_precision<U: Real>(&self) -> Multifrontal<U> {
        let other = Multifrontal::with(self.layout.clone(), self.entry.clone(), self.pool.clone());
        Multifrontal { path: self.path.clone(), ..other }
    }

    /// The same for solutions that are wanted on these equations alone, none of them: on all.
    pub fn with_path(mut self, interface: &[usize]) -> Self {
        let path = || Arc::new(Path::new(&self.layout, interface));
        self.path = (!interface.is_empty()).then(path);
        self
    }

    fn with(layout: Arc<Layout>, entry: Arc<[u32]>, pool: Option<Arc<ThreadPool>>) -> Self {
        let n = layout.fronts.order.len();
        let largest = layout.fronts.front.iter().map(|front| front.rows).max().unwrap_or(0);
        Self {
            layout,
            entry,
            pool,
            path: None,
            factor: Vec::new(),
            rooms: Vec::new(),
            exchange: vec![0; n],
            size: vec![0.0; n],
            x: vec![T::ZERO; n],
            rows: vec![T::ZERO; largest],
        }
    }

    /// Caller's equation at a position of the order of elimination.
    pub fn equation(&self, position: usize) -> usize {
        self.layout.fronts.order[position]
    }

    /// Memory of the factors and of the work on them [bytes].
    pub fn bytes(&self) -> f64 {
        let rooms = self.layout.parts.iter().chain([&self.layout.above]);
        let values =
            self.layout.length + rooms.map(|part| part.stack + part.scratch).sum::<usize>();
        size_of::<T>() as f64 * values as f64 + 4.0 * self.entry.len() as f64
    }

    /// Takes the memory of the factors, once.
    fn make_room(&mut self) -> Result<(), SolveError> {
        if !self.factor.is_empty() {
            return Ok(());
        }
        zeros(&mut self.factor, self.layout.length + 1)?;
        for part in self.layout.parts.iter().chain([&self.layout.above]) {
            let mut room = Room { stack: Vec::new(), scratch: Vec::new() };
            zeros(&mut room.stack, part.stack)?;
            zeros(&mut room.scratch, part.scratch)?;
            self.rooms.push(room);
        }
        Ok(())
    }

    /// Gives the memory of the factors back.
    pub fn release(&mut self) {
        (self.factor, self.rooms) = (Vec::new(), Vec::new());
    }

    /// Takes the values of a matrix, in the order of its entries.
    ///
    /// Errors: [`SolveError::OutOfMemory`].
    pub fn scatter(&mut self, values: impl Iterator<Item = T>) -> Result<(), SolveError> {
        if let Err(fault) = self.make_room() {
            self.release();
            return Err(fault);
        }
        self.factor.fill(T::ZERO);
        let (factor, mut entries) = (&mut self.factor[..], self.entry.iter());
        // rows that are made on the way are walked one by one
        values.for_each(|value| {
            if let Some(&at) = entries.next() {
                factor[at as usize] = value;
            }
        });
        Ok(())
    }

    /// Factors what was scattered. Small pivots are replaced; the smallest tells.
    pub fn factor(&mut self, row_size: impl Fn(usize) -> f64) -> Pivots {
        for (size, &equation) in self.size.iter_mut().zip(&self.layout.fronts.order) {
            *size = row_size(equation);
        }
        match self.pool.clone() {
            Some(pool) => pool.install(|| self.factor_all()),
            None => self.factor_all(),
        }
    }

    fn factor_all(&mut self) -> Pivots {
        let Self { layout, factor, rooms, exchange, size, .. } = self;
        let (rooms, above) = rooms.split_at_mut(layout.parts.len());
        let (layout, size) = (&**layout, &size[..]);
        let mut pivots = Pivots::NONE;
        if !layout.parts.is_empty() {
            let mut shares = cut(layout, (&mut factor[..], &mut exchange[..]), rooms);
            let own = shares.par_iter_mut().zip(&layout.parts);
            let own = own.map(|(share, part)| layout.factor(part, size, share, &[]));
            pivots = own.reduce(|| Pivots::NONE, Pivots::with);
        }
        let Some(room) = above.first_mut() else { return pivots };
        let mut all = Share { factor, factor_start: 0, exchange, first: 0, room };
        pivots.with(layout.factor(&layout.above, size, &mut all, rooms))
    }
}

/// Gives every part of the fronts its share.
fn cut<'a, T>(
    layout: &Layout,
    (mut factor, mut exchange): (&'a mut [T], &'a mut [u32]),
    rooms: &'a mut [Room<T>],
) -> Vec<Share<'a, T>> {
    let (mut factor_start, mut first) = (0, 0);
    let mut shares = Vec::with_capacity(rooms.len());
    for (part, room) in layout.parts.iter().zip(rooms) {
        let (values, positions) = layout.extent(part);
        let behind = std::mem::take(&mut factor).split_at_mut(values.start - factor_start).1;
        let (own, rest) = behind.split_at_mut(values.len());
        let behind = std::mem::take(&mut exchange).split_at_mut(positions.start - first).1;
        let (swaps, rest_of_swaps) = behind.split_at_mut(positions.len());
        (factor, factor_start, exchange, first) = (rest, values.end, rest_of_swaps, positions.end);
        let (factor_start, first) = (values.start, positions.start);
        shares.push(Share { factor: own, factor_start, exchange: swaps, first, room });
    }
    shares
}

impl Layout {
    /// Factors fronts one after the other; those that were factored before have left what they
    /// hand up in rooms of their own.
    fn factor<T: Real>(
        &self,
        part: &Part,
        size: &[f64],
        share: &mut Share<'_, T>,
        others: &[Room<T>],
    ) -> Pivots {
        let mut pivots = Pivots::NONE;
        let mut next = part.fronts.start;
        let end = part.fronts.end;
        for skipped in self.skipped_in(part).chain(std::iter::once(end..end)) {
            (next..skipped.start)
                .for_each(|f| self.factor_front(f, size, share, (others, &mut pivots)));
            next = skipped.end;
        }
        pivots
    }

    fn factor_front<T: Real>(
        &self,
        f: usize,
        size: &[f64],
        share: &mut Share<'_, T>,
        (others, pivots): (&[Room<T>], &mut Pivots),
    ) {
        let Front { first, columns, rows, .. } = self.fronts.front[f];
        let Storage { panel, above, end, work, update } = self.storage[f];
        let Room { stack, scratch } = &mut *share.room;
        let (waiting, own) = stack.split_at_mut(work);
        let own = &mut own[..rows * rows];
        for j in 0..rows {
            own[j * rows + self.first_row(j)..(j + 1) * rows].fill(T::ZERO);
        }
        let start = share.factor_start;
        let (panel, above) = share.factor[panel - start..end - start].split_at_mut(above - panel);
        let threads = self.threads;
        let mut front = DenseFront { panel, above, update: own, columns, rows, first, threads };
        for &child in &self.child[self.child_start[f]..self.child_start[f + 1]] {
            let Front { rows_start, rows, .. } = self.fronts.front[child as usize];
            let in_parent = &self.fronts.in_parent[rows_start..rows_start + rows];
            let update = match self.part_below(child, others.len()) {
                Some(part) => &others[part].stack[..self.packed(rows)],
                None => &waiting[self.storage[child as usize].update..][..self.packed(rows)],
            };
            match self.symmetric {
                true => {
                    let together = &self.fronts.together[rows_start..rows_start + rows];
                    widened(
                        #[inline(always)]
                        || extend_symmetric(&mut front, update, (in_parent, together)),
                    );
                }
                false => extend(&mut front, update, in_parent),
            }
        }
        let size = &size[first..first + columns];
        if self.symmetric {
            front.factor_ldlt(size, scratch, pivots);
        } else {
            let own = first - share.first..first - share.first + columns;
            front.factor_lu(size, &mut share.exchange[own], pivots);
        }
        let mut to = update;
        for j in 0..rows {
            let column = work + j * rows + self.first_row(j)..work + (j + 1) * rows;
            let length = column.len();
            stack.copy_within(column, to); // what waits is below what is at work
            to += length;
        }
    }

    /// First row of a column of a Schur complement that is used: that of the diagonal where it is
    /// symmetric.
    fn first_row(&self, column: usize) -> usize {
        if self.symmetric { column } else { 0 }
    }
}

/// So many zeros.
fn zeros<T: Real>(list: &mut Vec<T>, count: usize) -> Result<(), SolveError> {
    list.try_reserve_exact(count).map_err(|_| SolveError::OutOfMemory)?;
    list.resize(count, T::ZERO);
    Ok(())
}

/// Adds a child's Schur complement.
fn extend<T: Real>(front: &mut DenseFront<'_, T>, update: &[T], in_parent: &[u32]) {
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

/// Adds the lower triangle of a child's Schur complement, column after column.
#[inline(always)]
fn extend_symmetric<T: Real>(
    front: &mut DenseFront<'_, T>,
    update: &[T],
    (in_parent, together): (&[u32], &[u32]),
) {
    let (k, r) = (front.columns, front.rows);
    let mut rest = update;
    for (j, &to) in in_parent.iter().enumerate() {
        let (column, behind) = rest.split_at(in_parent.len() - j);
        rest = behind;
        let to = to as usize;
        let (target, offset) = if to < k {
            (&mut front.panel[to * (k + r)..(to + 1) * (k + r)], 0)
        } else {
            (&mut front.update[(to - k) * r..(to - k + 1) * r], k)
        };
        let mut i = 0;
        while i < column.len() {
            let (at, count) = (in_parent[j + i] as usize - offset, together[j + i] as usize);
            let own = target[at..at + count].iter_mut().zip(&column[i..i + count]);
            own.for_each(|(sum, &value)| *sum += value);
            i += count;
        }
    }
}

fn add_at<T: Real>(target: &mut [T], at: &[u32], source: &[T], offset: usize) {
    for (&at, &value) in at.iter().zip(source) {
        target[at as usize - offset] += value;
    }
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

    fn factored(pattern: &Pattern, values: &[f64], kind: Kind) -> (Multifrontal<f64>, Pivots) {
        let natural: Vec<usize> = (0..pattern.size()).rev().collect();
        let tree = Tree::new(pattern, &natural);
        let mut factors = Multifrontal::<f64>::new(pattern, kind, &tree, None).unwrap();
        let matrix = Matrix::new(pattern, values);
        let size: Vec<f64> = (0..pattern.size()).map(|i| matrix.row_size(i)).collect();
        factors.scatter(values.iter().copied()).unwrap();
        let pivots = factors.factor(|i| size[i]);
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
            let widest = factors.layout.fronts.front.iter().map(|front| front.columns).max();
            assert!(widest > Some(24), "{widest:?}");
            assert!(pivots.smallest_ratio > 1e-3, "{pivots:?}");
            let exchanged = factors.layout.fronts.front.iter().any(|front| {
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

    /// Requirement: factors and pivots have the same bits without threads and on any number of
    /// them, which do share subtrees and products.
    #[test]
    fn threads_change_no_bit() {
        for kind in [Kind::Symmetric, Kind::Unsymmetric] {
            let (pattern, values) = system(70, kind);
            let tree = crate::orders::best_tree(&pattern).unwrap();
            let matrix = Matrix::new(&pattern, &values);
            let size: Vec<f64> = (0..pattern.size()).map(|i| matrix.row_size(i)).collect();
            let factored = |threads: usize| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
                let pool = (threads > 0).then(|| Arc::new(pool));
                let mut factors = Multifrontal::<f64>::new(&pattern, kind, &tree, pool).unwrap();
                factors.scatter(values.iter().copied()).unwrap();
                let pivots = factors.factor(|i| size[i]);
                (factors.layout.parts.len(), factors.factor, factors.exchange, pivots)
            };
            let (parts, alone, exchange, pivots) = factored(0);
            assert_eq!(parts, 0);
            for threads in 1..4 {
                let (parts, shared, swaps, found) = factored(threads);
                assert!(parts > 8, "{parts}");
                assert!(shared.iter().zip(&alone).all(|(a, b)| a.to_bits() == b.to_bits()));
                assert_eq!(
                    (swaps, found.negative, found.smallest),
                    (exchange.clone(), pivots.negative, pivots.smallest)
                );
                assert_eq!(found.smallest_ratio.to_bits(), pivots.smallest_ratio.to_bits());
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
                let mut factors = Multifrontal::<f64>::new(&pattern, kind, &tree, None).unwrap();
                reference.iter_mut().for_each(|v| *v *= 2.0);
                factors.scatter(reference.iter().copied()).unwrap();
                factors.factor(|_| 60.0);
                factors.scatter(values.iter().copied()).unwrap();
                let pivots = factors.factor(|_| 60.0);
                assert_eq!(factors.equation(pivots.smallest), missing, "{kind:?}");
                assert!(
                    pivots.smallest_ratio < 1e-16 && factors.factor.iter().all(|l| l.is_finite())
                );
            }
        }
    }
}
