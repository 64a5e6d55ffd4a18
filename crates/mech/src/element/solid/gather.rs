//! Force and tangent of an element from its points.
//!
//! ```text
//!   f_ai  = sum w tau_ij g_aj                     K_aibk = sum w g_aj (c_ijkl + 1_ik tau_jl) g_bl
//! ```
//!
//! For a pair of axes (i, k) the products with g_b of all points are made first; then every row is
//! a sum over points and axes of rows as long as the element has nodes, which compilers turn into
//! vector instructions. docs/theory.md eqs. (3.37) and (3.38).

use super::fields::MOST_FIELDS;
use super::point::Point;
use crate::material::tensor::INDEX;

/// Writes the force.
#[inline(always)]
pub(super) fn force<const D: usize, const N: usize>(points: &[Point<D, N>], into: &mut [f64]) {
    let mut sums = [[0.0; N]; D];
    for point in points {
        for (i, sum) in sums.iter_mut().enumerate() {
            for (j, slopes) in point.slopes.iter().enumerate() {
                add(sum, point.weight * point.stress[INDEX[i][j]], slopes);
            }
        }
        if D == 2 {
            add(&mut sums[0], point.weight * point.stress[2], &point.hoop);
        }
    }
    for (a, node) in into.chunks_exact_mut(D).enumerate() {
        node.iter_mut().zip(&sums).for_each(|(force, sum)| *force = sum[a]);
    }
}

/// sum += factor * row.
#[inline(always)]
fn add<const N: usize>(sum: &mut [f64; N], factor: f64, row: &[f64; N]) {
    for (sum, entry) in sum.iter_mut().zip(row) {
        *sum += factor * entry;
    }
}

/// What joins all nodes beside the points for one field of changes of volume: x y' + y x' is added
/// to the tangent.
#[derive(Debug, Clone, Copy)]
pub(super) struct Joint<const D: usize, const N: usize> {
    /// x, axis by axis: e of docs/theory.md eq. (3.50).
    pub left: [[f64; N]; D],
    /// y, axis by axis: rho, and once closed half of what every gamma makes of every e beside it.
    pub right: [[f64; N]; D],
    /// gamma with every field [F L].
    pub square: [f64; MOST_FIELDS],
}

/// Those of all fields of an element.
#[derive(Debug, Clone, Copy)]
pub(super) struct Joints<const D: usize, const N: usize> {
    all: [Joint<D, N>; MOST_FIELDS],
    count: usize,
    /// The undeformed volume [L3].
    pub volume: f64,
}

impl<const D: usize, const N: usize> Joints<D, N> {
    /// Of so many fields, nothing yet.
    #[inline(always)]
    pub fn new(volume: f64, count: usize) -> Self {
        let none = Joint { left: [[0.0; N]; D], right: [[0.0; N]; D], square: [0.0; MOST_FIELDS] };
        Self { all: [none; MOST_FIELDS], count, volume }
    }

    /// One a field.
    #[inline(always)]
    pub fn each(&self) -> &[Joint<D, N>] {
        self.all.get(..self.count).unwrap_or(&[])
    }

    /// One a field.
    #[inline(always)]
    pub fn each_mut(&mut self) -> &mut [Joint<D, N>] {
        self.all.get_mut(..self.count).unwrap_or_default()
    }

    /// Adds to every y half of what gamma makes of every x.
    #[inline(always)]
    pub fn close(&mut self) {
        for a in 0..self.count {
            for b in 0..self.count {
                let half = 0.5 * self.all[a].square[b];
                let left = self.all[b].left;
                for (right, left) in self.all[a].right.iter_mut().zip(&left) {
                    add(right, half, left);
                }
            }
        }
    }
}

/// Products of a pair of axes at every point, overwritten by the next pair.
struct Room<const D: usize, const N: usize, const P: usize> {
    products: [[[f64; N]; D]; P],
    of_hoop: [[f64; N]; P],
}

/// Writes the tangent, row-major; `ring`: hoop strains count.
#[inline(always)]
pub(super) fn tangent<const D: usize, const N: usize, const P: usize>(
    points: &[Point<D, N>; P],
    ring: bool,
    joints: &[Joint<D, N>],
    into: &mut [f64],
) {
    let mut room = Room { products: [[[0.0; N]; D]; P], of_hoop: [[0.0; N]; P] };
    for i in 0..D {
        for k in i..D {
            block(points, ring, [i, k], (joints, &mut room), into);
        }
    }
}

/// The entries of a pair of axes, and those of the pair turned round; two rows at a time.
#[inline(always)]
fn block<const D: usize, const N: usize, const P: usize>(
    points: &[Point<D, N>; P],
    ring: bool,
    [i, k]: [usize; 2],
    (joints, room): (&[Joint<D, N>], &mut Room<D, N, P>),
    into: &mut [f64],
) {
    let ring = D == 2 && ring;
    let hoop = ring && i == 0;
    let Room { products, of_hoop } = room;
    for (point, rows) in points.iter().zip(&mut *products) {
        for (j, row) in rows.iter_mut().enumerate() {
            multiply(point, ring, [i, j, k], row);
        }
    }
    if hoop {
        for (point, row) in points.iter().zip(&mut *of_hoop) {
            multiply_hoop(point, k, row);
        }
    }
    let mut a = 0;
    while a < N {
        // the last row of an odd number is made twice
        let both = [a, (a + 1).min(N - 1)];
        let mut rows = [[0.0; N]; 2];
        for (point, products) in points.iter().zip(&*products) {
            for (slopes, product) in point.slopes.iter().zip(products) {
                add_twice(&mut rows, both.map(|a| slopes[a]), product);
            }
        }
        if hoop {
            for (point, product) in points.iter().zip(&*of_hoop) {
                add_twice(&mut rows, both.map(|a| point.hoop[a]), product);
            }
        }
        for joint in joints {
            add_twice(&mut rows, both.map(|a| joint.left[i][a]), &joint.right[k]);
            add_twice(&mut rows, both.map(|a| joint.right[i][a]), &joint.left[k]);
        }
        for (a, row) in both.into_iter().zip(&rows) {
            write(row, [D * a + i, k], D, into);
            if i != k {
                write_turned(row, [D * a + i, k], D, into);
            }
        }
        a += 2;
    }
}

/// rows += factors of the same row.
#[inline(always)]
fn add_twice<const N: usize>(rows: &mut [[f64; N]; 2], factors: [f64; 2], row: &[f64; N]) {
    let [first, second] = rows;
    for ((first, second), entry) in first.iter_mut().zip(second).zip(row) {
        *first += factors[0] * entry;
        *second += factors[1] * entry;
    }
}

/// Writes a row of an axis, each `stride` th entry from the `first` on.
#[inline(always)]
fn write<const N: usize>(
    row: &[f64; N],
    [place, first]: [usize; 2],
    stride: usize,
    into: &mut [f64],
) {
    let width = stride * N;
    let Some(into) = into.get_mut(width * place..width * (place + 1)) else { return };
    into.chunks_exact_mut(stride).zip(row).for_each(|(node, entry)| node[first] = *entry);
}

/// Writes a row as a column.
#[inline(always)]
fn write_turned<const N: usize>(
    row: &[f64; N],
    [place, first]: [usize; 2],
    stride: usize,
    into: &mut [f64],
) {
    let width = stride * N;
    let rows = into.chunks_exact_mut(width * stride);
    rows.zip(row).for_each(|(node, entry)| node[width * first + place] = *entry);
}

/// Writes w (c_ijkl + 1_ik tau_jl) g_bl.
#[inline(always)]
fn multiply<const D: usize, const N: usize>(
    point: &Point<D, N>,
    ring: bool,
    [i, j, k]: [usize; 3],
    row: &mut [f64; N],
) {
    let (w, moduli) = (point.weight, &point.moduli[INDEX[i][j]]);
    for (l, slopes) in point.slopes.iter().enumerate() {
        let turning = if i == k { point.turning[INDEX[j][l]] } else { 0.0 };
        let factor = w * (moduli[INDEX[k][l]] + turning);
        if l == 0 { set(row, factor, slopes) } else { add(row, factor, slopes) }
    }
    if ring && k == 0 {
        add(row, w * moduli[2], &point.hoop);
    }
}

/// Writes the same of the hoop strain.
#[inline(always)]
fn multiply_hoop<const D: usize, const N: usize>(
    point: &Point<D, N>,
    k: usize,
    row: &mut [f64; N],
) {
    let (w, moduli) = (point.weight, &point.moduli[2]);
    for (l, slopes) in point.slopes.iter().enumerate() {
        let factor = w * moduli[INDEX[k][l]];
        if l == 0 { set(row, factor, slopes) } else { add(row, factor, slopes) }
    }
    if k == 0 {
        add(row, w * (moduli[2] + point.turning[2]), &point.hoop);
    }
}

/// row = factor * other.
#[inline(always)]
fn set<const N: usize>(row: &mut [f64; N], factor: f64, other: &[f64; N]) {
    for (entry, other) in row.iter_mut().zip(other) {
        *entry = factor * other;
    }
}
