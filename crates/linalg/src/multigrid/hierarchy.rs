//! The levels of a multigrid cycle.

use super::aggregates::{aggregate, motions_of_sets};
use super::rows::Rows;
use crate::banded::Banded;
use crate::ordering::Layout;
use crate::orders::Graph;
use crate::pattern::Pattern;
use crate::solver::Solver;
use crate::sparse::Sparse;
use crate::system::{Kind, LinearSystem};
use std::sync::Mutex;

/// Unknowns up to which a level is factored.
const COARSEST: usize = 2500;
/// The most levels; each has a tenth of the unknowns of the one before, or fewer.
const MOST_LEVELS: usize = 12;
/// Steps of the power iteration for the largest eigenvalue, and by how much that may exceed what
/// they find.
const STEPS: usize = 12;
const MARGIN: f64 = 1.1;
/// Products of the polynomial smoother, and the part of the spectrum that it smooths.
const DEGREE: usize = 3;
const SMOOTHED: f64 = 1.0 / 12.0;

/// A level: its matrix and the way to the next.
struct Level {
    matrix: Rows,
    /// One over the diagonal.
    inverse: Vec<f64>,
    /// Upper bound of the eigenvalues of D^-1 A.
    largest: f64,
    prolongation: Rows,
}

/// The levels, and the coarsest one's factorisation.
pub(super) struct Hierarchy {
    levels: Vec<Level>,
    coarsest: Mutex<Solver>,
    threads: bool,
}

/// Vectors of every level: right-hand side, solution and two for the smoother.
pub(super) type Room = Vec<[Vec<f64>; 5]>;

impl Hierarchy {
    /// Of a matrix with rigid motions of its unknowns, column after column; `None` where a
    /// diagonal is not positive, there are no motions, unknowns do not become fewer, or are few.
    pub fn new(pattern: &Pattern, values: &[f64], motions: &[f64], threads: bool) -> Option<Self> {
        let n = pattern.size();
        let mut motions: Vec<Vec<f64>> =
            motions.chunks_exact(n.max(1)).map(<[f64]>::to_vec).collect();
        if motions.is_empty() {
            return None;
        }
        let mut matrix = Rows {
            start: pattern.row_start().to_vec(),
            column: pattern.columns().iter().map(|&j| j as u32).collect(),
            value: values.to_vec(),
            width: n,
        };
        let graph = Graph::new(pattern)?;
        let mut vertices: Vec<Vec<usize>> = graph.vertices().map(<[usize]>::to_vec).collect();
        let (mut start, mut neighbour) = (graph.start, graph.neighbour);
        let mut levels = Vec::new();
        while matrix.size() > COARSEST {
            let near = |v: usize| &neighbour[start[v] as usize..start[v + 1] as usize];
            let (set, count) = aggregate(vertices.len(), near);
            let mut unknowns = vec![Vec::new(); count];
            vertices.iter().zip(&set).for_each(|(own, &set)| unknowns[set].extend(own));
            let (tentative, coarse, first) = motions_of_sets(&unknowns, &motions, matrix.size());
            if tentative.width * 3 > matrix.size() * 2 || levels.len() == MOST_LEVELS {
                return None;
            }
            let level = Level::new(matrix, &tentative, threads)?;
            let of_both = level.matrix.times(&level.prolongation, threads);
            matrix = level.prolongation.transposed().times(&of_both, threads);
            (start, neighbour) = neighbours_of_sets(&matrix, &first)?;
            vertices = first.windows(2).map(|pair| (pair[0]..pair[1]).collect()).collect();
            motions = coarse;
            levels.push(level);
        }
        if levels.is_empty() {
            return None;
        }
        let coarsest = Mutex::new(factored(&matrix)?);
        Some(Self { levels, coarsest, threads })
    }

    pub fn room(&self) -> Room {
        let last = self.levels.last().map_or(0, |level| level.prolongation.width);
        let sizes = self.levels.iter().map(|level| level.matrix.size()).chain([last]);
        sizes.map(|n| std::array::from_fn(|_| vec![0.0; n])).collect()
    }

    /// y = A x on the finest level.
    pub fn multiply(&self, x: &[f64], y: &mut [f64]) {
        if let Some(finest) = self.levels.first() {
            finest.matrix.multiply(x, y, self.threads);
        }
    }

    /// z = one cycle for the right-hand side r.
    pub fn precondition(&self, r: &[f64], z: &mut [f64], room: &mut Room) {
        room[0][0].copy_from_slice(r);
        self.cycle(0, room);
        z.copy_from_slice(&room[0][1]);
    }

    fn cycle(&self, at: usize, room: &mut [[Vec<f64>; 5]]) {
        let Some(level) = self.levels.get(at) else {
            let [b, x, ..] = &mut room[0];
            x.copy_from_slice(b);
            let mut solver = match self.coarsest.lock() {
                Ok(solver) => solver,
                Err(poisoned) => poisoned.into_inner(),
            };
            if solver.respond(x).is_err() {
                x.fill(f64::NAN); // the iteration ends, and the direct factorisation takes over
            }
            return;
        };
        let Some((own, coarser)) = room.split_first_mut() else { return };
        own[1].fill(0.0);
        level.smooth(own, self.threads, true);
        let [b, x, work, ..] = own;
        level.matrix.multiply(x, work, self.threads);
        work.iter_mut().zip(&*b).for_each(|(w, b)| *w = b - *w);
        level.prolongation.multiply_transposed(work, &mut coarser[0][0]);
        self.cycle(at + 1, coarser);
        level.prolongation.multiply(&coarser[0][1], work, self.threads);
        x.iter_mut().zip(&*work).for_each(|(x, w)| *x += w);
        level.smooth(own, self.threads, false);
    }
}

impl Level {
    fn new(matrix: Rows, tentative: &Rows, threads: bool) -> Option<Self> {
        let diagonal = matrix.diagonal();
        if diagonal.iter().any(|&d| d.is_nan() || d <= 0.0) {
            return None;
        }
        let inverse: Vec<f64> = diagonal.iter().map(|d| 1.0 / d).collect();
        let largest = MARGIN * largest_eigenvalue(&matrix, &inverse, threads);
        if !(largest.is_finite() && largest > 0.0) {
            return None;
        }
        // P = (I - omega D^-1 A) P0
        let omega = 4.0 / (3.0 * largest);
        let mut prolongation = matrix.times(tentative, threads);
        for (i, inverse) in inverse.iter().enumerate() {
            let range = prolongation.start[i]..prolongation.start[i + 1];
            let by = -omega * inverse;
            prolongation.value[range.clone()].iter_mut().for_each(|p| *p *= by);
            for (j, own) in tentative.row(i) {
                let at =
                    prolongation.column[range.clone()].iter().position(|&k| k as usize == j)?;
                prolongation.value[range.start + at] += own;
            }
        }
        Some(Self { matrix, inverse, largest, prolongation })
    }

    /// Chebyshev iteration for A x = b with D as preconditioner, over the upper part of the
    /// spectrum; a symmetric polynomial, so that the cycle is symmetric too.
    fn smooth(&self, room: &mut [Vec<f64>; 5], threads: bool, from_zero: bool) {
        let [b, x, product, residual, direction] = room;
        let (upper, lower) = (self.largest, SMOOTHED * self.largest);
        let (centre, half) = (0.5 * (upper + lower), 0.5 * (upper - lower));
        let sigma = centre / half;
        let mut rho = 1.0 / sigma;
        if from_zero {
            residual.copy_from_slice(b);
        } else {
            self.matrix.multiply(x, product, threads);
            let all = residual.iter_mut().zip(&*b).zip(&*product);
            all.for_each(|((r, b), p)| *r = b - p);
        }
        for ((d, r), inverse) in direction.iter_mut().zip(&*residual).zip(&self.inverse) {
            *d = inverse * r / centre;
        }
        for step in 1.. {
            x.iter_mut().zip(&*direction).for_each(|(x, d)| *x += d);
            if step == DEGREE {
                return;
            }
            self.matrix.multiply(direction, product, threads);
            residual.iter_mut().zip(&*product).for_each(|(r, p)| *r -= p);
            let next = 1.0 / (2.0 * sigma - rho);
            let (keep, add) = (next * rho, 2.0 * next / half);
            for ((d, r), inverse) in direction.iter_mut().zip(&*residual).zip(&self.inverse) {
                *d = keep * *d + add * inverse * r;
            }
            rho = next;
        }
    }
}

/// Largest eigenvalue of D^-1 A, from below, by the power iteration.
fn largest_eigenvalue(matrix: &Rows, inverse: &[f64], threads: bool) -> f64 {
    let mut x: Vec<f64> =
        (0..matrix.size()).map(|i| 1.0 + ((i * 7919) % 997) as f64 / 997.0).collect();
    x.iter_mut().skip(1).step_by(2).for_each(|x| *x = -*x);
    let mut y = vec![0.0; x.len()];
    let mut found = 0.0;
    for _ in 0..STEPS {
        matrix.multiply(&x, &mut y, threads);
        y.iter_mut().zip(inverse).for_each(|(y, d)| *y *= d);
        let size = |v: &[f64]| v.iter().map(|v| v * v).sum::<f64>().sqrt();
        let grown = size(&y);
        found = grown / size(&x);
        x.iter_mut().zip(&y).for_each(|(x, y)| *x = y / grown);
    }
    found
}

/// The sets that each set of the next level couples with.
fn neighbours_of_sets(matrix: &Rows, first: &[usize]) -> Option<(Vec<i32>, Vec<i32>)> {
    let mut set_of = vec![0; matrix.size()];
    for (set, pair) in first.windows(2).enumerate() {
        set_of[pair[0]..pair[1]].fill(set);
    }
    let sets = first.len() - 1;
    let (mut start, mut neighbour) = (vec![0], Vec::new());
    let mut met = vec![usize::MAX; sets];
    for (set, pair) in first.windows(2).enumerate() {
        met[set] = set;
        for i in pair[0]..pair[1] {
            for (j, _) in matrix.row(i) {
                if std::mem::replace(&mut met[set_of[j]], set) != set {
                    neighbour.push(set_of[j] as i32);
                }
            }
        }
        start.push(i32::try_from(neighbour.len()).ok()?);
    }
    Some((start, neighbour))
}

/// The factorisation of the coarsest matrix.
fn factored(matrix: &Rows) -> Option<Solver> {
    let pairs = (0..matrix.size()).flat_map(|i| matrix.row(i).map(move |(j, _)| (i, j)));
    let pattern = Pattern::from_pairs(matrix.size(), pairs);
    let mut values = vec![0.0; pattern.entries()];
    for i in 0..matrix.size() {
        for (j, a) in matrix.row(i) {
            values[pattern.position(i, j)?] = a;
        }
    }
    let system: Box<dyn LinearSystem> = match Sparse::new(&pattern, Kind::Symmetric, &[], None) {
        Some(sparse) => Box::new(sparse),
        None => {
            let layout = Layout::cheapest(&pattern, Kind::Symmetric);
            Box::new(Banded::new(&pattern, Kind::Symmetric, layout))
        }
    };
    let mut solver = Solver::new(&pattern, system);
    let report = solver.refactor(&pattern, &values).ok()?;
    (report.negative_pivots == Some(0)).then_some(solver)
}
