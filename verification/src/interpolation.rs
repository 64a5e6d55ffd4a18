//! Finite element fields between their nodes, and how far they are from exact ones.
//!
//! ```text
//!   places of the nodes, powers x^i y^j z^k of the cell --> shape functions --> u, grad u
//!                                                    Gauss points -----------------'
//! ```
//!
//! Shape functions are solved for, not written down: they share nothing with those of the program.

use crate::solids::{Meshed, Solid};

/// An exact field: displacements [L] and their gradient [1] (row: component) at a place.
pub type Field = fn([f64; 3]) -> ([f64; 3], [[f64; 3]; 3]);

/// Lame's constants [F/L2].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elasticity {
    /// Lambda.
    pub lame: f64,
    /// Shear modulus.
    pub shear: f64,
}

impl Elasticity {
    /// Twice the energy of a displacement gradient [F/L2].
    fn energy(&self, h: &[[f64; 3]; 3]) -> f64 {
        let trace = h[0][0] + h[1][1] + h[2][2];
        let strain = |i: usize, j: usize| 0.5 * (h[i][j] + h[j][i]);
        let squares: f64 = (0..9).map(|k| strain(k / 3, k % 3).powi(2)).sum();
        self.lame * trace * trace + 2.0 * self.shear * squares
    }
}

/// Errors relative to the norms of the exact field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// Of the displacements, in the mean square [1].
    pub displacement: f64,
    /// Of the strains, in the norm of the energy [1].
    pub energy: f64,
}

/// Integrates the difference between nodal displacements and an exact field over all elements.
pub fn errors(
    solid: &Solid<'_>,
    mesh: &Meshed,
    displacement: impl Fn(u64) -> [f64; 3],
    exact: Field,
    elasticity: Elasticity,
) -> Errors {
    let cells: Vec<Shapes> =
        solid.places().iter().map(|places| Shapes::new(solid, places)).collect();
    let points: Vec<Vec<Point>> = cells.iter().map(Shapes::points).collect();
    let [mut off, mut all] = [[0.0; 2]; 2];
    for (number, nodes) in mesh.elements.iter().enumerate() {
        let at: Vec<[f64; 3]> =
            nodes.iter().map(|&label| mesh.nodes[label as usize - 1].2).collect();
        let u: Vec<[f64; 3]> = nodes.iter().map(|&label| displacement(label)).collect();
        for point in &points[number % cells.len()] {
            let mut jacobian = gradient(&at, &point.slopes);
            if !solid.is_spatial() {
                jacobian[2][2] = 1.0;
            }
            let (inverse, volume) = inverse(&jacobian);
            let raw = gradient(&u, &point.slopes);
            let own = product(&raw, &inverse);
            let (exact_u, exact_h) = exact(sum(&at, &point.shapes));
            let own_u = sum(&u, &point.shapes);
            let weight = point.weight * volume.abs();
            let squares = |a: [f64; 3]| a.iter().map(|x| x * x).sum::<f64>();
            let apart = std::array::from_fn(|k| own_u[k] - exact_u[k]);
            let strained =
                std::array::from_fn(|i| std::array::from_fn(|j| own[i][j] - exact_h[i][j]));
            off[0] += weight * squares(apart);
            all[0] += weight * squares(exact_u);
            off[1] += weight * elasticity.energy(&strained);
            all[1] += weight * elasticity.energy(&exact_h);
        }
    }
    let [displacement, energy] = [0, 1].map(|k| (off[k] / all[k]).sqrt());
    Errors { displacement, energy }
}

/// Shape functions and their slopes at an integration point of the reference cell.
struct Point {
    weight: f64,
    shapes: Vec<f64>,
    slopes: Vec<[f64; 3]>,
}

/// What a cell is: the cube, a simplex, or a triangle drawn along z.
#[derive(Clone, Copy, PartialEq)]
enum Form {
    Cube,
    Simplex,
    Wedge,
}

/// Shape functions as sums of powers.
struct Shapes {
    form: Form,
    dimension: usize,
    powers: Vec<[i32; 3]>,
    /// Coefficient of every power in every shape function.
    factors: Vec<Vec<f64>>,
}

impl Shapes {
    fn new(solid: &Solid<'_>, places: &[[f64; 3]]) -> Self {
        let dimension = if solid.is_spatial() { 3 } else { 2 };
        let (form, corners) = match (dimension, places.len()) {
            (2, 3 | 6) => (Form::Simplex, 3),
            (2, _) => (Form::Cube, 4),
            (_, 4 | 10) => (Form::Simplex, 4),
            (_, 6 | 15) => (Form::Wedge, 6),
            _ => (Form::Cube, 8),
        };
        let order = if places.len() > corners { 2 } else { 1 };
        let powers = powers(form, dimension, order);
        assert_eq!(powers.len(), places.len(), "as many powers as nodes");
        // the reference cell: corners where the form has them, middles between
        let own = reference(form, dimension, places, corners);
        let table: Vec<Vec<f64>> =
            own.iter().map(|at| powers.iter().map(|power| monomial(at, power)).collect()).collect();
        Self { form, dimension, powers, factors: inverted(table) }
    }

    fn points(&self) -> Vec<Point> {
        let line = [
            (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
            (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
            (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
            (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
        ];
        let count = 4usize.pow(self.dimension as u32);
        let of = |k: usize| {
            let along = [k % 4, k / 4 % 4, k / 16].map(|index| line[index]);
            let [x, y, z] = along.map(|(at, _)| at);
            let weight: f64 = along.iter().take(self.dimension).map(|(_, weight)| weight).product();
            // a cube that is folded into a simplex
            let (at, folded) = match (self.form, self.dimension) {
                (Form::Cube, 2) => ([x, y, 0.0], 1.0),
                (Form::Cube, _) => ([x, y, z], 1.0),
                (Form::Simplex, 2) => ([x, y * (1.0 - x), 0.0], 1.0 - x),
                (Form::Wedge, _) => ([x, y * (1.0 - x), z], 1.0 - x),
                (Form::Simplex, _) => {
                    let rest = (1.0 - x) * (1.0 - y);
                    ([x, y * (1.0 - x), z * rest], (1.0 - x) * rest)
                }
            };
            self.at(&at, weight * folded)
        };
        (0..count).map(of).collect()
    }

    fn at(&self, at: &[f64; 3], weight: f64) -> Point {
        let value: Vec<f64> = self.powers.iter().map(|power| monomial(at, power)).collect();
        let slope: Vec<[f64; 3]> = self.powers.iter().map(|power| slopes(at, power)).collect();
        let nodes = 0..self.powers.len();
        let shapes = |node: usize| value.iter().zip(&self.factors).map(|(v, f)| v * f[node]).sum();
        let slopes = |node: usize| {
            let pairs = || slope.iter().zip(&self.factors);
            std::array::from_fn(|axis| pairs().map(|(s, f)| s[axis] * f[node]).sum())
        };
        Point {
            weight,
            shapes: nodes.clone().map(shapes).collect(),
            slopes: nodes.map(slopes).collect(),
        }
    }
}

/// Corners and middles of the reference cell.
fn reference(form: Form, dimension: usize, places: &[[f64; 3]], corners: usize) -> Vec<[f64; 3]> {
    const SIMPLEX: [[f64; 3]; 4] =
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let own: Vec<[f64; 3]> = match form {
        Form::Cube => return places.to_vec(),
        Form::Simplex => SIMPLEX[..=dimension].to_vec(),
        Form::Wedge => (0..6)
            .map(|k| [SIMPLEX[k % 3][0], SIMPLEX[k % 3][1], if k < 3 { 0.0 } else { 1.0 }])
            .collect(),
    };
    // a middle stands between the corners that it stands between in its cell
    let middle = |at: &[f64; 3]| {
        for a in 0..corners {
            for b in 0..a {
                let between = |k: usize| (0.5 * (places[a][k] + places[b][k]) - at[k]).abs();
                // diagonals of the sides of a wedge meet in no node
                if (0..3).all(|k| between(k) < 1e-12) {
                    return std::array::from_fn(|k| 0.5 * (own[a][k] + own[b][k]));
                }
            }
        }
        [f64::NAN; 3]
    };
    own.iter().copied().chain(places[corners..].iter().map(middle)).collect()
}

fn powers(form: Form, dimension: usize, order: i32) -> Vec<[i32; 3]> {
    let most = if dimension == 2 { 0 } else { 2 };
    let all = (0..=most).flat_map(|k| (0..=2).flat_map(move |j| (0..=2).map(move |i| [i, j, k])));
    let belongs = |&[i, j, k]: &[i32; 3]| match (form, order) {
        (Form::Simplex, _) => i + j + k <= order,
        (Form::Cube, 1) => i.max(j).max(k) <= 1,
        // serendipity: powers of two and more add up to two at most
        (Form::Cube, _) => [i, j, k].iter().filter(|power| **power > 1).sum::<i32>() <= 2,
        (Form::Wedge, 1) => i + j <= 1 && k <= 1,
        (Form::Wedge, _) => (i + j <= 2 && k <= 1) || (i + j <= 1 && k == 2),
    };
    all.filter(belongs).collect()
}

fn monomial(at: &[f64; 3], power: &[i32; 3]) -> f64 {
    (0..3).map(|k| at[k].powi(power[k])).product()
}

fn slopes(at: &[f64; 3], power: &[i32; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| {
        let mut lower = *power;
        lower[axis] -= 1;
        if power[axis] == 0 { 0.0 } else { f64::from(power[axis]) * monomial(at, &lower) }
    })
}

/// Sum of vectors by factors.
fn sum(vectors: &[[f64; 3]], factors: &[f64]) -> [f64; 3] {
    std::array::from_fn(|k| vectors.iter().zip(factors).map(|(v, f)| v[k] * f).sum())
}

/// Derivatives (row: component) of vectors at nodes.
fn gradient(vectors: &[[f64; 3]], slopes: &[[f64; 3]]) -> [[f64; 3]; 3] {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| vectors.iter().zip(slopes).map(|(v, s)| v[i] * s[j]).sum())
    })
}

fn product(a: &[[f64; 3]; 3], b: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

/// Inverse and determinant, by cofactors.
fn inverse(a: &[[f64; 3]; 3]) -> ([[f64; 3]; 3], f64) {
    let minor = |i: usize, j: usize| {
        let [p, q] = [(i + 1) % 3, (i + 2) % 3];
        let [r, s] = [(j + 1) % 3, (j + 2) % 3];
        a[p][r] * a[q][s] - a[p][s] * a[q][r]
    };
    let determinant: f64 = (0..3).map(|j| a[0][j] * minor(0, j)).sum();
    (std::array::from_fn(|i| std::array::from_fn(|j| minor(j, i) / determinant)), determinant)
}

/// Inverse of a small matrix, by elimination with the largest pivot of each column.
fn inverted(mut a: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let n = a.len();
    for (i, row) in a.iter_mut().enumerate() {
        row.extend((0..n).map(|j| f64::from(u8::from(i == j))));
    }
    for column in 0..n {
        let largest =
            (column..n).max_by(|&p, &q| a[p][column].abs().total_cmp(&a[q][column].abs()));
        a.swap(column, largest.unwrap_or(column));
        let pivot = a[column].clone();
        for (i, row) in a.iter_mut().enumerate() {
            let factor =
                if i == column { 1.0 - 1.0 / pivot[column] } else { row[column] / pivot[column] };
            row.iter_mut().zip(&pivot).for_each(|(own, other)| *own -= factor * other);
        }
    }
    a.into_iter().map(|row| row[n..].to_vec()).collect()
}
