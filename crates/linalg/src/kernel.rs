//! Loops over contiguous memory that all factorisations share.

use crate::precision::Real;

/// Length of the blocks in which rows are subtracted; storages are padded to whole blocks.
pub(crate) const BLOCK: usize = 4;

/// Smallest number of whole blocks that holds `length`, in entries.
pub(crate) fn padded(length: usize) -> usize {
    length.div_ceil(BLOCK) * BLOCK
}

/// target -= factor * source, block by block; both have the same whole number of blocks.
/// Long rows are left to the compiler, which unrolls further.
pub(crate) fn subtract(target: &mut [f64], factor: f64, source: &[f64]) {
    if target.len() > 8 * BLOCK {
        for (t, &s) in target.iter_mut().zip(source) {
            *t -= factor * s;
        }
        return;
    }
    let blocks = target.as_chunks_mut::<BLOCK>().0.iter_mut().zip(source.as_chunks::<BLOCK>().0);
    for (t, s) in blocks {
        for k in 0..BLOCK {
            t[k] -= factor * s[k];
        }
    }
}

/// Runs a loop with the widest vectors that the processor has. What it calls is to be inlined; the
/// results have the same bits with any vectors.
pub(crate) fn widened<R>(work: impl FnOnce() -> R) -> R {
    pulp::Arch::new().dispatch(work)
}

/// target -= sum of factor * column, column after column for every entry.
#[inline(always)]
pub(crate) fn subtract_columns<T: Real, const M: usize>(
    target: &mut [T],
    columns: [&[T]; M],
    factors: [T; M],
) {
    let length = target.len();
    let columns = columns.map(|column| &column[..length]);
    for i in 0..length {
        let mut entry = target[i];
        for (column, factor) in columns.iter().zip(factors) {
            entry -= factor * column[i];
        }
        target[i] = entry;
    }
}

/// Scalar products of several columns with the same array, in interleaved parts like [`dot`].
#[inline(always)]
pub(crate) fn dot_columns<T: Real, const M: usize>(columns: [&[T]; M], x: &[T]) -> [T; M] {
    const PART: usize = 2 * BLOCK;
    let (blocks, rest) = x.as_chunks::<PART>();
    let columns = columns.map(|column| column[..x.len()].as_chunks::<PART>());
    let mut part = [[T::ZERO; PART]; M];
    for (b, x) in blocks.iter().enumerate() {
        for (part, (column, _)) in part.iter_mut().zip(&columns) {
            let column = &column[b];
            for k in 0..PART {
                part[k] += column[k] * x[k];
            }
        }
    }
    std::array::from_fn(|m| {
        let p = &part[m];
        let near = (p[0] + p[4]) + (p[1] + p[5]);
        let sum = near + ((p[2] + p[6]) + (p[3] + p[7]));
        columns[m].1.iter().zip(rest).fold(sum, |sum, (&l, &x)| sum + l * x)
    })
}

/// Scalar product of equally long arrays, in interleaved parts to shorten the chain of additions.
pub(crate) fn dot<T: Real>(a: &[T], b: &[T]) -> T {
    let (a_blocks, a_rest) = a.as_chunks::<BLOCK>();
    let (b_blocks, b_rest) = b.as_chunks::<BLOCK>();
    let mut part = [T::ZERO; BLOCK];
    for (p, q) in a_blocks.iter().zip(b_blocks) {
        for k in 0..BLOCK {
            part[k] += p[k] * q[k];
        }
    }
    let mut sum = (part[0] + part[1]) + (part[2] + part[3]);
    for (&p, &q) in a_rest.iter().zip(b_rest) {
        sum += p * q;
    }
    sum
}

/// Right-hand sides that are substituted together: their loops share the factors' entries, and the
/// sums of each are made in the order in which they are made for it alone.
pub(crate) const LANES: usize = 4;

/// x -= factor * y for every lane.
#[inline(always)]
pub(crate) fn subtract_lanes<const M: usize>(x: &mut [f64; M], factor: f64, y: &[f64; M]) {
    for lane in 0..M {
        x[lane] -= factor * y[lane];
    }
}

/// Scalar products of a row with every lane of x, in interleaved parts like [`dot`].
#[inline(always)]
pub(crate) fn dot_lanes<const M: usize>(row: &[f64], x: &[[f64; M]]) -> [f64; M] {
    let (row_blocks, row_rest) = row.as_chunks::<BLOCK>();
    let (x_blocks, x_rest) = x.as_chunks::<BLOCK>();
    let mut part = [[0.0; M]; BLOCK];
    for (p, q) in row_blocks.iter().zip(x_blocks) {
        for k in 0..BLOCK {
            for lane in 0..M {
                part[k][lane] += p[k] * q[k][lane];
            }
        }
    }
    let mut sum: [f64; M] = std::array::from_fn(|lane| {
        (part[0][lane] + part[1][lane]) + (part[2][lane] + part[3][lane])
    });
    for (p, q) in row_rest.iter().zip(x_rest) {
        for lane in 0..M {
            sum[lane] += p * q[lane];
        }
    }
    sum
}

/// Scalar products for back substitution: the nearest unknowns, which have just been found, enter
/// last, so that the processor need not wait for them.
#[inline(always)]
pub(crate) fn dot_from_far<const M: usize>(row: &[f64], x: &[[f64; M]]) -> [f64; M] {
    let near = row.len().min(2 * BLOCK);
    let mut sum = dot_lanes(&row[near..], &x[near..]);
    for (u, x_i) in row[..near].iter().zip(&x[..near]).rev() {
        for lane in 0..M {
            sum[lane] += u * x_i[lane];
        }
    }
    sum
}
