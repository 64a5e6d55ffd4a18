//! Small tensors by hand: symmetric ones as six numbers, 11, 22, 33, 12, 13, 23.
//!
//! ```text
//!   F = 1 + H       b - 1 = H + H' + H H'       C - 1 = H + H' + H' H       J - 1
//! ```
//!
//! Deformations are given by their displacement gradient H and measured from one, so that small
//! strains keep all their digits.

/// A symmetric tensor: 11, 22, 33, 12, 13, 23 (components, no angles).
pub type Symmetric = [f64; 6];
/// Any tensor of second order, by rows.
pub type Matrix = [[f64; 3]; 3];
/// A tensor of fourth order with both minor symmetries, its components by two indices of
/// [`Symmetric`].
pub type Moduli = [[f64; 6]; 6];

/// Index of a pair of axes in [`Symmetric`].
pub const INDEX: [[usize; 3]; 3] = [[0, 3, 4], [3, 1, 5], [4, 5, 2]];
/// The pair of axes of an index.
pub const PAIRS: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]];
/// The unit tensor.
pub const UNIT: Symmetric = [1.0, 1.0, 1.0, 0.0, 0.0, 0.0];
/// How often an index stands in a double contraction.
pub const COUNTS: Symmetric = [1.0, 1.0, 1.0, 2.0, 2.0, 2.0];

/// A tensor from its components.
#[inline(always)]
pub fn from_fn(of: impl Fn(usize, usize) -> f64) -> Symmetric {
    [of(0, 0), of(1, 1), of(2, 2), of(0, 1), of(0, 2), of(1, 2)]
}

/// The symmetric part of H.
pub fn symmetric(h: &Matrix) -> Symmetric {
    from_fn(|i, j| 0.5 * (h[i][j] + h[j][i]))
}

/// b - 1 = H + H' + H H'.
#[inline(always)]
pub fn left(h: &Matrix) -> Symmetric {
    from_fn(|i, j| h[i][j] + h[j][i] + (h[i][0] * h[j][0] + h[i][1] * h[j][1] + h[i][2] * h[j][2]))
}

/// C - 1 = H + H' + H' H, twice Green's strain.
#[inline(always)]
pub fn right(h: &Matrix) -> Symmetric {
    from_fn(|i, j| h[i][j] + h[j][i] + (h[0][i] * h[0][j] + h[1][i] * h[1][j] + h[2][i] * h[2][j]))
}

/// J - 1 = det(1 + H) - 1.
#[inline(always)]
pub fn dilation(h: &Matrix) -> f64 {
    let minor = |i: usize, j: usize| h[i][i] * h[j][j] - h[i][j] * h[j][i];
    trace_of(h) + (minor(0, 1) + minor(0, 2) + minor(1, 2)) + determinant(h)
}

#[inline(always)]
fn trace_of(h: &Matrix) -> f64 {
    h[0][0] + h[1][1] + h[2][2]
}

/// The determinant.
#[inline(always)]
pub fn determinant(h: &Matrix) -> f64 {
    h[0][0] * (h[1][1] * h[2][2] - h[1][2] * h[2][1])
        - h[0][1] * (h[1][0] * h[2][2] - h[1][2] * h[2][0])
        + h[0][2] * (h[1][0] * h[2][1] - h[1][1] * h[2][0])
}

/// Inverse and determinant; the inverse of a singular matrix is not finite.
pub fn inverse(m: &Matrix) -> (Matrix, f64) {
    let det = determinant(m);
    let scale = 1.0 / det;
    let minor = |i: usize, j: usize| {
        let (a, b) = ((i + 1) % 3, (i + 2) % 3);
        let (c, d) = ((j + 1) % 3, (j + 2) % 3);
        m[a][c] * m[b][d] - m[a][d] * m[b][c]
    };
    (std::array::from_fn(|i| std::array::from_fn(|j| scale * minor(j, i))), det)
}

/// F = 1 + H.
pub fn deformation(h: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| h[i][j] + f64::from(u8::from(i == j))))
}

/// a b.
pub fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j])
    })
}

/// F A F'.
pub fn carried(f: &Matrix, a: &Symmetric) -> Symmetric {
    let half = product(f, &full(a));
    from_fn(|i, j| half[i][0] * f[j][0] + half[i][1] * f[j][1] + half[i][2] * f[j][2])
}

/// F F F F C.
pub fn pushed(f: &Matrix, moduli: &Moduli) -> Moduli {
    // T[ij][IJ]: a symmetric tensor's component IJ goes to ij
    let carry: Moduli =
        PAIRS.map(|[i, j]| {
            PAIRS.map(|[a, b]| {
                if a == b { f[i][a] * f[j][a] } else { f[i][a] * f[j][b] + f[i][b] * f[j][a] }
            })
        });
    let half: Moduli = carry
        .map(|row| std::array::from_fn(|k| (0..6).map(|m| row[m] * moduli[m][k]).sum::<f64>()));
    std::array::from_fn(|i| {
        std::array::from_fn(|j| (0..6).map(|m| half[i][m] * carry[j][m]).sum::<f64>())
    })
}

/// All nine components.
#[inline(always)]
pub fn full(a: &Symmetric) -> Matrix {
    let [xx, yy, zz, xy, xz, yz] = *a;
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}

/// a b + b a over 2, for a = b the square.
#[inline(always)]
pub fn square(a: &Symmetric) -> Symmetric {
    let m = full(a);
    from_fn(|i, j| m[i][0] * m[0][j] + m[i][1] * m[1][j] + m[i][2] * m[2][j])
}

/// Sum of the diagonal.
#[inline]
pub fn trace(a: &Symmetric) -> f64 {
    a[0] + a[1] + a[2]
}

/// a : b.
#[inline(always)]
pub fn contract(a: &Symmetric, b: &Symmetric) -> f64 {
    (0..6).map(|k| COUNTS[k] * a[k] * b[k]).sum()
}

/// a less a third of its trace.
pub fn deviator(a: &Symmetric) -> Symmetric {
    let mean = trace(a) / 3.0;
    [a[0] - mean, a[1] - mean, a[2] - mean, a[3], a[4], a[5]]
}

/// The equivalent stress of von Mises, sqrt(3/2 s:s).
pub fn mises(stress: &Symmetric) -> f64 {
    let s = deviator(stress);
    (1.5 * contract(&s, &s)).sqrt()
}

/// Entry by entry, a + factor b.
#[inline(always)]
pub fn add(a: &Symmetric, factor: f64, b: &Symmetric) -> Symmetric {
    std::array::from_fn(|k| a[k] + factor * b[k])
}

/// Adds `factor` a a to a tensor of fourth order.
#[inline(always)]
pub fn add_dyad(moduli: &mut Moduli, factor: f64, a: &Symmetric) {
    for (row, a_i) in moduli.iter_mut().zip(a) {
        row.iter_mut().zip(a).for_each(|(entry, a_j)| *entry += factor * a_i * a_j);
    }
}

/// Adds `factor` (a b + b a) to a tensor of fourth order.
pub fn add_pair(moduli: &mut Moduli, factor: f64, a: &Symmetric, b: &Symmetric) {
    for (i, row) in moduli.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            *entry += factor * (a[i] * b[j] + b[i] * a[j]);
        }
    }
}

/// Adds `factor` times the tensor that leaves symmetric ones as they are.
pub fn add_unit(moduli: &mut Moduli, factor: f64) {
    for (k, row) in moduli.iter_mut().enumerate() {
        row[k] += factor / COUNTS[k];
    }
}

/// Eigenvalues, ascending or not, and unit eigenvectors as rows. The one that stands farthest from
/// the others comes from its cubic in closed form, the other two from a turn in the plane across
/// it, so that equal eigenvalues cost no digits.
pub fn eigen(a: &Symmetric) -> ([f64; 3], Matrix) {
    let mean = trace(a) / 3.0;
    let deviator = deviator(a);
    let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let largest = deviator.iter().fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
    if largest <= f64::MIN_POSITIVE || largest.is_nan() {
        return ([a[0], a[1], a[2]], unit);
    }
    let mut scaled = deviator;
    scaled.iter_mut().for_each(|entry| *entry /= largest);
    let norm = (contract(&scaled, &scaled) / 6.0).sqrt();
    let size = largest * norm;
    scaled.iter_mut().for_each(|entry| *entry /= norm);
    let k = full(&scaled);
    let half = (0.5 * determinant(&k)).clamp(-1.0, 1.0);
    let angle = half.acos() / 3.0;
    let far = if half >= 0.0 {
        2.0 * angle.cos()
    } else {
        2.0 * (angle + 2.0 * std::f64::consts::FRAC_PI_3).cos()
    };
    let w = null_vector(&k, far);
    let (u, v) = across(&w);
    let times = |x: &[f64; 3]| [dot(&k[0], x), dot(&k[1], x), dot(&k[2], x)];
    let (ku, kv, kw) = (times(&u), times(&v), times(&w));
    let (uu, uv, vv) = (dot(&u, &ku), dot(&u, &kv), dot(&v, &kv));
    // Jacobi's rotation
    let (c, s, lean) = turn(uu, uv, vv);
    let first = [c * u[0] - s * v[0], c * u[1] - s * v[1], c * u[2] - s * v[2]];
    let second = [s * u[0] + c * v[0], s * u[1] + c * v[1], s * u[2] + c * v[2]];
    let values = [uu - lean, vv + lean, dot(&w, &kw)].map(|value| mean + size * value);
    (values, [first, second, w])
}

/// The tensor of such values along unit vectors that stand as rows.
pub fn of_principal(values: &[f64; 3], directions: &Matrix) -> Symmetric {
    from_fn(|i, j| (0..3).map(|k| values[k] * directions[k][i] * directions[k][j]).sum())
}

/// Cosine and sine of the turn that makes [[uu, uv], [uv, vv]] diagonal, and tan * uv.
fn turn(uu: f64, uv: f64, vv: f64) -> (f64, f64, f64) {
    if uv == 0.0 {
        return (1.0, 0.0, 0.0);
    }
    let theta = 0.5 * (vv - uu) / uv;
    let tangent = theta.signum() / (theta.abs() + (1.0 + theta * theta).sqrt());
    let c = 1.0 / (1.0 + tangent * tangent).sqrt();
    (c, tangent * c, tangent * uv)
}

/// Unit vector that a symmetric matrix takes to `value` times itself, by the largest cross product
/// of two rows of the difference.
fn null_vector(k: &Matrix, value: f64) -> [f64; 3] {
    let row = |i: usize| {
        let mut row = k[i];
        row[i] -= value;
        row
    };
    let rows = [row(0), row(1), row(2)];
    let crosses = [cross(&rows[0], &rows[1]), cross(&rows[0], &rows[2]), cross(&rows[1], &rows[2])];
    let mut best = ([1.0, 0.0, 0.0], 0.0);
    for cross in crosses {
        let size = dot(&cross, &cross);
        if size > best.1 {
            best = (cross, size);
        }
    }
    let scale = if best.1 > 0.0 { 1.0 / best.1.sqrt() } else { 1.0 };
    best.0.map(|x| x * scale)
}

/// Two unit vectors across a unit vector and one another.
fn across(w: &[f64; 3]) -> ([f64; 3], [f64; 3]) {
    let u = if w[0].abs() > w[1].abs() { [-w[2], 0.0, w[0]] } else { [0.0, w[2], -w[1]] };
    let scale = 1.0 / dot(&u, &u).sqrt();
    let u = u.map(|x| x * scale);
    (u, cross(w, &u))
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn check(a: &Symmetric) {
        let (values, vectors) = eigen(a);
        let size = a.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        for i in 0..3 {
            for j in 0..3 {
                let exact = f64::from(u8::from(i == j));
                assert!((dot(&vectors[i], &vectors[j]) - exact).abs() < 4e-15, "{a:?}");
                let sum: f64 = (0..3).map(|k| values[k] * vectors[k][i] * vectors[k][j]).sum();
                assert!((sum - a[INDEX[i][j]]).abs() <= 1e-14 * size, "{a:?} {values:?}");
            }
        }
    }

    proptest! {
        /// Requirement: eigenvectors are orthonormal and make up the tensor again, also where
        /// eigenvalues are equal or nearly so. Tolerance: rounding.
        #[test]
        fn eigenvectors_make_up_the_tensor(
            a in prop::array::uniform6(-1.0..1.0_f64), near in 0.0..17.0_f64, even in -1.0..1.0_f64
        ) {
            check(&a);
            // a tensor with two or three nearly equal eigenvalues
            let small = a.map(|x| x * f64::powf(10.0, -near));
            let mut almost = small;
            (0..3).for_each(|k| almost[k] += even);
            check(&almost);
            let n = [a[0], a[1], a[2]];
            let dyad = from_fn(|i, j| n[i] * n[j] + small[INDEX[i][j]]);
            check(&dyad);
        }
    }

    #[test]
    fn special_tensors() {
        check(&[0.0; 6]);
        check(&UNIT);
        check(&[1.0, 1.0, 2.0, 0.0, 0.0, 0.0]);
        check(&[2.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
        check(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
        check(&[1e-200, 0.0, 0.0, 3e-200, 0.0, 0.0]);
    }

    /// Requirement: J - 1 keeps its digits at small strains.
    #[test]
    fn dilation_of_small_strains() {
        let h = [[1e-12, 2e-12, 0.0], [0.0, 3e-12, 0.0], [0.0, 0.0, -1e-12]];
        assert!((dilation(&h) - 3e-12).abs() < 2e-23);
        let (back, det) =
            inverse(&deformation(&[[0.3, 0.2, 0.1], [0.0, 0.1, 0.4], [0.2, 0.0, 0.0]]));
        assert!(
            (det - 1.0 - dilation(&[[0.3, 0.2, 0.1], [0.0, 0.1, 0.4], [0.2, 0.0, 0.0]])).abs()
                < 1e-15
        );
        assert!((determinant(&back) - 1.0 / det).abs() < 1e-15);
    }
}
