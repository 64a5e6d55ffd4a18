//! Small dense systems by elimination with row pivots.

/// Most unknowns: three times three modes.
pub(super) const MOST: usize = 9;

/// Factors of a matrix.
pub(super) struct Factors {
    size: usize,
    /// Those of both triangles, rows as they were picked.
    entries: [[f64; MOST]; MOST],
    /// Which row stands where.
    order: [usize; MOST],
}

impl Factors {
    /// Those of the first `size` rows and columns; `None`: they are singular.
    #[inline(always)]
    pub fn new(size: usize, matrix: &[[f64; MOST]; MOST]) -> Option<Self> {
        let mut own = Self { size, entries: *matrix, order: std::array::from_fn(|k| k) };
        let a = &mut own.entries;
        for k in 0..size {
            let pivot = (k..size).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))?;
            a.swap(k, pivot);
            own.order.swap(k, pivot);
            let row = a[k];
            if row[k] == 0.0 || row[k].is_nan() {
                return None;
            }
            for entries in a.iter_mut().take(size).skip(k + 1) {
                let factor = entries[k] / row[k];
                // whole rows, and what stands left of the pivot is put back
                let before = *entries;
                entries.iter_mut().zip(&row).for_each(|(entry, own)| *entry -= factor * own);
                entries[..k].copy_from_slice(&before[..k]);
                entries[k] = factor;
            }
        }
        Some(own)
    }

    /// Solves for `S` right sides; zeros for what is beyond the size.
    #[inline(always)]
    pub fn solve<const S: usize>(&self, sides: &[[f64; S]; MOST]) -> [[f64; S]; MOST] {
        let mut x = [[0.0; S]; MOST];
        for k in 0..self.size {
            let mut row = sides[self.order[k]];
            for (factor, known) in self.entries[k].iter().zip(&x).take(k) {
                row.iter_mut().zip(known).for_each(|(entry, own)| *entry -= factor * own);
            }
            x[k] = row;
        }
        for k in (0..self.size).rev() {
            let mut row = x[k];
            for (factor, known) in self.entries[k].iter().zip(&x).take(self.size).skip(k + 1) {
                row.iter_mut().zip(known).for_each(|(entry, own)| *entry -= factor * own);
            }
            let head = self.entries[k][k];
            x[k] = row.map(|entry| entry / head);
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: what is solved for gives the right sides back, where heads are zero too.
    #[test]
    fn products_give_right_sides_back() {
        for size in [4, MOST] {
            let matrix: [[f64; MOST]; MOST] = std::array::from_fn(|i| {
                std::array::from_fn(|j| if i == j { 0.0 } else { ((7 * i + 3 * j) as f64).sin() })
            });
            let sides: [[f64; 2]; MOST] = std::array::from_fn(|i| [i as f64 + 1.0, -1.0]);
            let found = Factors::new(size, &matrix).map(|own| own.solve(&sides));
            assert!(found.is_some());
            let Some(x) = found else { return };
            for (row, side) in matrix.iter().zip(&sides).take(size) {
                for s in 0..2 {
                    let sum: f64 = (0..size).map(|j| row[j] * x[j][s]).sum();
                    assert!((sum - side[s]).abs() < 1e-12, "{sum} {side:?}");
                }
            }
            assert!(x[size..].iter().flatten().all(|own| *own == 0.0));
        }
        assert!(Factors::new(3, &[[1.0; MOST]; MOST]).is_none());
    }
}
