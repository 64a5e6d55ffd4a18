//! Dense elimination and systems for the tests; shares no code with the crate.
#![allow(dead_code)]

use slideline_linalg::Pattern;

/// A small generator of reproducible numbers (Knuth's 64-bit linear congruence).
pub struct Numbers(pub u64);

impl Numbers {
    /// Uniform in (-1, 1).
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
    pub fn below(&mut self, n: usize) -> usize {
        (((self.next() + 1.0) / 2.0) * n as f64) as usize % n
    }
}

pub type Dense = Vec<Vec<f64>>;

pub fn dense(pattern: &Pattern, values: &[f64]) -> Dense {
    let n = pattern.size();
    let mut a = vec![vec![0.0; n]; n];
    let mut at = 0;
    for (i, row) in a.iter_mut().enumerate() {
        for &j in pattern.row(i) {
            row[j] = values[at];
            at += 1;
        }
    }
    a
}

/// Gauss elimination with complete row exchange.
pub fn eliminate(mut a: Dense, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for j in 0..n {
        let p = (j..n).max_by(|&p, &q| a[p][j].abs().total_cmp(&a[q][j].abs())).unwrap();
        a.swap(j, p);
        b.swap(j, p);
        for i in j + 1..n {
            let l = a[i][j] / a[j][j];
            let (above, below) = a.split_at_mut(i);
            for (entry, pivot_entry) in below[0].iter_mut().zip(&above[j]) {
                *entry -= l * pivot_entry;
            }
            b[i] -= l * b[j];
        }
    }
    for j in (0..n).rev() {
        for c in j + 1..n {
            b[j] -= a[j][c] * b[c];
        }
        b[j] /= a[j][j];
    }
    b
}

/// Values of a pattern from a function of (i, j).
pub fn fill(pattern: &Pattern, mut value: impl FnMut(usize, usize) -> f64) -> Vec<f64> {
    let mut values = Vec::new();
    for i in 0..pattern.size() {
        for &j in pattern.row(i) {
            values.push(value(i, j));
        }
    }
    values
}

/// Makes values symmetric by the lower triangle.
pub fn symmetrise(pattern: &Pattern, values: &mut [f64]) {
    for i in 0..pattern.size() {
        for &j in pattern.row(i).iter().filter(|&&j| j < i) {
            values[pattern.position(j, i).unwrap()] = values[pattern.position(i, j).unwrap()];
        }
    }
}

/// Plane grid, five-point stencil: pattern and Laplacian with identity added.
pub fn grid(side: usize) -> (Pattern, Vec<f64>) {
    let n = side * side;
    let right = (0..n).filter(move |i| i % side + 1 < side).map(|i| (i, i + 1));
    let up = (0..n - side).map(|i| (i, i + side));
    let pattern = Pattern::from_pairs(n, right.chain(up));
    let values = fill(&pattern, |i, j| if i == j { 4.01 } else { -1.0 });
    (pattern, values)
}

/// Bricks of three dofs a node, and a definite matrix on them.
pub fn bricks(side: usize) -> (Pattern, Vec<f64>) {
    let node = |[x, y, z]: [usize; 3]| x + side * (y + side * z);
    let cells = (0..(side - 1).pow(3))
        .map(|c| [c % (side - 1), c / (side - 1) % (side - 1), c / (side - 1).pow(2)]);
    let clique = |[x, y, z]: [usize; 3]| -> Vec<usize> {
        let corners = (0..8).map(|c| node([x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)]));
        corners.flat_map(|corner| 3 * corner..3 * corner + 3).collect()
    };
    let cliques: Vec<Vec<usize>> = cells.map(clique).collect();
    let pattern = Pattern::from_cliques(3 * side.pow(3), cliques.iter());
    let rows = (0..pattern.size()).map(|i| (i, pattern.row(i)));
    let own = |i: usize, row: &[usize]| {
        let size = row.len() as f64 + 1e-3;
        row.iter().map(|&j| if i == j { size } else { -1.0 }).collect::<Vec<f64>>()
    };
    let values = rows.flat_map(|(i, row)| own(i, row)).collect();
    (pattern, values)
}

/// Largest error relative to the largest component.
pub fn error(x: &[f64], reference: &[f64]) -> f64 {
    let scale = reference.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    x.iter().zip(reference).fold(0.0f64, |m, (a, b)| m.max((a - b).abs())) / scale
}
