//! Where the parts of a multifrontal factorisation are, and which fronts threads take.

use crate::fronts::{Front, Fronts, NONE, Tree};
use crate::ordering::positions;
use crate::pattern::Pattern;
use crate::system::Kind;
use std::ops::Range;

/// Threads take subtrees with at most one in so many operations of all: enough of them to be
/// shared out evenly.
const SUBTREES: f64 = 24.0;
/// And with at least one in so many: smaller ones are not worth it.
const WORTH: f64 = 1000.0;
/// Operations of a factorisation from which on threads pay.
const PARALLEL: f64 = 1e8;

/// Where the parts of a front are.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Storage {
    /// Its columns, in the factor.
    pub panel: usize,
    /// U12, behind them; empty for symmetric systems.
    pub above: usize,
    /// What is behind both.
    pub end: usize,
    /// Its Schur complement while it is at work, on the stack.
    pub work: usize,
    /// And while it waits for the parent, packed.
    pub update: usize,
}

/// Fronts that are factored one after the other on a stack of their own.
#[derive(Clone, Debug, Default)]
pub(super) struct Part {
    pub fronts: Range<usize>,
    /// Height of the stack, and room for the products of a front.
    pub stack: usize,
    pub scratch: usize,
}

/// What the analysis knows of a factorisation.
pub(super) struct Layout {
    pub symmetric: bool,
    pub fronts: Fronts,
    pub storage: Vec<Storage>,
    /// Children of each front, those of front f from `child_start[f]` on.
    pub child: Vec<u32>,
    pub child_start: Vec<usize>,
    /// Subtrees that threads take, ascending; none without threads.
    pub parts: Vec<Part>,
    /// All fronts, of which those of the parts are left out.
    pub above: Part,
    /// Entries of the factor.
    pub length: usize,
    /// Whether products are shared by threads.
    pub threads: bool,
}

impl Layout {
    pub fn new(pattern: &Pattern, kind: Kind, tree: &Tree, threads: bool) -> Self {
        let symmetric = kind == Kind::Symmetric;
        let fronts = Fronts::new(pattern, tree);
        let (child, child_start) = children(&fronts);
        let parts = if threads { subtrees(&fronts) } else { Vec::new() };
        let above = Part { fronts: 0..fronts.front.len(), ..Part::default() };
        let storage = vec![Storage::default(); fronts.front.len()];
        let threads = !parts.is_empty();
        let mut layout = Self {
            symmetric,
            fronts,
            storage,
            child,
            child_start,
            parts,
            above,
            length: 0,
            threads,
        };
        layout.place_factors();
        for at in 0..layout.parts.len() {
            let mut part = layout.parts[at].clone();
            layout.place_on_stack(&mut part, &[]);
            layout.parts[at] = part;
        }
        let (mut above, parts) = (layout.above.clone(), std::mem::take(&mut layout.parts));
        layout.place_on_stack(&mut above, &parts);
        (layout.above, layout.parts) = (above, parts);
        layout
    }

    fn place_factors(&mut self) {
        for (storage, front) in self.storage.iter_mut().zip(&self.fronts.front) {
            let (k, r) = (front.columns, front.rows);
            storage.panel = self.length;
            storage.above = storage.panel + k * (k + r);
            storage.end = storage.above + if self.symmetric { 0 } else { k * r };
            self.length = storage.end;
        }
    }

    /// Places on the stack for fronts of a part, those of `others` left out, and its height.
    fn place_on_stack(&mut self, part: &mut Part, others: &[Part]) {
        let mut top = 0;
        for f in part.fronts.clone() {
            if part_of(others, f).is_some() {
                continue;
            }
            let Front { columns: k, rows: r, .. } = self.fronts.front[f];
            let mut own = self.child[self.child_start[f]..self.child_start[f + 1]].iter();
            let first = own.find(|&&child| part_of(others, child as usize).is_none());
            let update = first.map_or(top, |&child| self.storage[child as usize].update);
            (self.storage[f].work, self.storage[f].update) = (top, update);
            part.stack = part.stack.max(top + r * r);
            part.scratch = part.scratch.max(if self.symmetric { k * (k + r) } else { 0 });
            top = update + self.packed(r);
        }
    }

    /// Entries of a Schur complement of `r` rows that waits: a triangle where it is symmetric,
    /// column after column.
    pub fn packed(&self, r: usize) -> usize {
        if self.symmetric { r * (r + 1) / 2 } else { r * r }
    }

    /// Places of a part in the factor and in the order of elimination.
    pub fn extent(&self, part: &Part) -> (Range<usize>, Range<usize>) {
        let (begin, last) = (part.fronts.start, part.fronts.end - 1);
        let Front { first, columns, .. } = self.fronts.front[last];
        let values = self.storage[begin].panel..self.storage[last].end;
        (values, self.fronts.front[begin].first..first + columns)
    }

    /// Fronts within a part that others take.
    pub fn skipped_in(&self, part: &Part) -> impl Iterator<Item = Range<usize>> {
        let is_above = part.fronts == self.above.fronts;
        let parts = if is_above { &self.parts[..] } else { &[] };
        parts.iter().map(|part| part.fronts.clone())
    }

    /// Which of the first `count` parts a front is in.
    pub fn part_below(&self, front: u32, count: usize) -> Option<usize> {
        part_of(&self.parts[..count], front as usize)
    }
}

/// The fronts of some equations and all above them.
pub(super) struct Path {
    /// Ascending.
    pub fronts: Vec<u32>,
    /// Positions of the equations in the order of elimination, and the equations.
    pub equations: Vec<(u32, u32)>,
}

impl Path {
    pub fn new(layout: &Layout, interface: &[usize]) -> Self {
        let fronts = &layout.fronts;
        let position = positions(fronts.order.len(), &fronts.order);
        let mut is_on = vec![false; fronts.front.len()];
        for &equation in interface {
            let at = position[equation];
            is_on[fronts.front.partition_point(|front| front.first <= at) - 1] = true;
        }
        for f in 0..is_on.len() {
            let parent = fronts.front[f].parent;
            if is_on[f] && parent != NONE {
                is_on[parent as usize] = true;
            }
        }
        let place = |&equation: &usize| (position[equation] as u32, equation as u32);
        Self {
            fronts: (0..is_on.len()).filter(|&f| is_on[f]).map(|f| f as u32).collect(),
            equations: interface.iter().map(place).collect(),
        }
    }
}

fn part_of(parts: &[Part], front: usize) -> Option<usize> {
    let at = parts.partition_point(|part| part.fronts.end <= front);
    parts.get(at).filter(|part| part.fronts.start <= front).map(|_| at)
}

/// Largest subtrees of no more than their share of the operations.
fn subtrees(fronts: &Fronts) -> Vec<Part> {
    let mut first: Vec<usize> = (0..fronts.front.len()).collect();
    let mut operations: Vec<f64> = fronts.front.iter().map(work).collect();
    for (f, parent) in fronts.front.iter().map(|front| front.parent).enumerate() {
        if parent != NONE {
            operations[parent as usize] += operations[f];
            first[parent as usize] = first[parent as usize].min(first[f]);
        }
    }
    let roots = || (0..first.len()).filter(|&f| fronts.front[f].parent == NONE);
    let all: f64 = roots().map(|f| operations[f]).sum();
    if all < PARALLEL {
        return Vec::new();
    }
    let small = |f: usize| operations[f] <= all / SUBTREES;
    let largest = |&f: &usize| {
        let parent = fronts.front[f].parent;
        let alone = parent == NONE || !small(parent as usize);
        small(f) && alone && operations[f] >= all / WORTH
    };
    let part = |f: usize| Part { fronts: first[f]..f + 1, ..Part::default() };
    (0..first.len()).filter(largest).map(part).collect()
}

/// Multiplications and additions of a symmetric front.
fn work(front: &Front) -> f64 {
    let (k, r) = (front.columns as f64, front.rows as f64);
    k * (k * k / 3.0 + k * r + r * r)
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

/// Where each entry of the matrix goes: both entries of a pair go to the front that eliminates the
/// first of its two equations.
pub(super) fn entry_positions(pattern: &Pattern, layout: &Layout) -> Vec<u32> {
    let Layout { fronts, storage, symmetric, .. } = layout;
    let n = pattern.size();
    let position = positions(n, &fronts.order);
    let transposed = transposed_entries(pattern);
    let nowhere = layout.length;
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
                    if !*symmetric {
                        entry[e] = (storage.above + (column - k) * k + row) as u32;
                    }
                } else if !*symmetric || row >= column {
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
