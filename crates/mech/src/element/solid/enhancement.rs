//! What incompatible modes do at a point, and what they add up to over an element.
//!
//! ```text
//!    M = x_a y_b      a mode moves the point along F0 x_a as fast as one goes along F^-T y_b
//!
//!    own   = sum M:c:M + M tau M'      joint = sum M:c:grad N + ...
//! ```
//!
//! docs/theory.md eqs. (3.51) to (3.53).

use super::pivoted::MOST;
use super::place::invert;
use super::point::Point;
use crate::material::tensor::{INDEX, Matrix, Symmetric};

/// What the modes do at a point. Each is a product of two vectors, M = x_a y_b, of its first and of
/// its second index: M by deformed position is so too, and what is made of all modes is made of
/// these. docs/theory.md eq. (3.52)
#[derive(Clone, Copy)]
pub(super) struct Modes<const D: usize, const N: usize> {
    /// F0 x_a: where the mode moves the point.
    pub ends: [[f64; D]; D],
    /// F^-T y_b: along which.
    pub ways: [[f64; D]; D],
    /// x_a grad0, a node each: what turns along y_b when a mode and a node move together [1/L].
    pub carried: [[f64; N]; D],
}

/// Forces and tangents of nodes and modes.
pub(super) struct Sums<const D: usize, const N: usize> {
    pub force: [f64; MOST],
    pub own: [[f64; MOST]; MOST],
    /// By the displacements of the nodes, axis by axis.
    pub joint: [[[f64; N]; D]; MOST],
}

/// Makes the ways of modes those by deformed position: F^-T y.
#[inline(always)]
pub(super) fn turn<const D: usize>(gradient: &Matrix, ways: &mut [[f64; D]; D]) {
    let mut f = [[0.0; D]; D];
    for (i, (row, gradient)) in f.iter_mut().zip(gradient).enumerate() {
        row.iter_mut().zip(gradient).for_each(|(entry, own)| *entry = *own);
        row[i] += 1.0;
    }
    let (back, _) = invert(&f);
    for way in ways {
        let before = *way;
        *way = [0.0; D];
        before.iter().zip(&back).for_each(|(own, back)| add(way, *own, back));
    }
}

/// Stress and moduli of a point along a way.
struct Along<const D: usize> {
    /// w tau y.
    pull: [f64; D],
    /// The part of it that turns.
    turning: [f64; D],
    /// w c_ijkl y_l.
    moduli: [[[f64; D]; D]; D],
    /// The same of the hoop stress.
    hoop: [f64; D],
}

impl<const D: usize> Along<D> {
    #[inline(always)]
    fn new<const N: usize>(point: &Point<D, N>, way: &[f64; D]) -> Self {
        let mut weighted = *way;
        weighted.iter_mut().for_each(|entry| *entry *= point.weight);
        let way = &weighted;
        let mut moduli = [[[0.0; D]; D]; D];
        for i in 0..D {
            for j in i..D {
                moduli[i][j] = times(&point.moduli[INDEX[i][j]], way);
                moduli[j][i] = moduli[i][j];
            }
        }
        let hoop = if D == 2 { times(&point.moduli[2], way) } else { [0.0; D] };
        Self { pull: times(&point.stress, way), turning: times(&point.turning, way), moduli, hoop }
    }

    /// w (c_ijkl + 1_ik tau_jl) x_k y_l of the mode that ends there.
    #[inline(always)]
    fn product(&self, end: &[f64; D]) -> [[f64; D]; D] {
        let mut product = [[0.0; D]; D];
        for (i, row) in product.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = dot(&self.moduli[i][j], end) + end[i] * self.turning[j];
            }
        }
        product
    }
}

/// A symmetric tensor times a vector.
#[inline(always)]
fn times<const D: usize>(tensor: &Symmetric, vector: &[f64; D]) -> [f64; D] {
    let mut product = [0.0; D];
    for (entry, row) in product.iter_mut().zip(&INDEX) {
        for (at, own) in row.iter().zip(vector) {
            *entry += tensor[*at] * own;
        }
    }
    product
}

#[inline(always)]
pub(super) fn dot<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    let mut sum = 0.0;
    a.iter().zip(b).for_each(|(a, b)| sum += a * b);
    sum
}

impl<const D: usize, const N: usize> Sums<D, N> {
    /// Nothing yet.
    pub const ZERO: Self =
        Self { force: [0.0; MOST], own: [[0.0; MOST]; MOST], joint: [[[0.0; N]; D]; MOST] };

    /// Writes the lower triangle of what the modes do to one another: points add to the upper one.
    #[inline(always)]
    pub fn mirror(&mut self) {
        for m in 0..D * D {
            for other in 0..m {
                self.own[m][other] = self.own[other][m];
            }
        }
    }

    /// Adds a point: docs/theory.md eq. (3.53).
    #[inline(always)]
    pub fn add(&mut self, point: &Point<D, N>, modes: &Modes<D, N>) {
        for (b, way) in modes.ways.iter().enumerate() {
            let along = Along::new(point, way);
            for (a, end) in modes.ends.iter().enumerate() {
                let (m, product) = (a * D + b, along.product(end));
                self.force[m] += dot(&along.pull, end);
                let others = self.own[m].chunks_exact_mut(D).zip(&modes.ends).skip(a);
                for (of_end, end) in others {
                    let mut ahead = [0.0; D];
                    product.iter().zip(end).for_each(|(row, own)| add(&mut ahead, *own, row));
                    for (own, way) in of_end.iter_mut().zip(&modes.ways) {
                        *own += dot(&ahead, way);
                    }
                }
                for (i, row) in self.joint[m].iter_mut().enumerate() {
                    for (factor, slopes) in product[i].iter().zip(&point.slopes) {
                        add(row, *factor, slopes);
                    }
                    add(row, along.turning[i], &modes.carried[a]);
                }
                if D == 2 {
                    add(&mut self.joint[m][0], dot(&along.hoop, end), &point.hoop);
                }
            }
        }
    }
}

/// sum += factor * row.
#[inline(always)]
pub(super) fn add<const N: usize>(sum: &mut [f64; N], factor: f64, row: &[f64; N]) {
    sum.iter_mut().zip(row).for_each(|(sum, entry)| *sum += factor * entry);
}
