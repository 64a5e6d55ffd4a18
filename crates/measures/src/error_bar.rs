//! How far a curve is from the limit of ever finer meshes.
//!
//! ```text
//!   coarse ------- x        error of the coarse curve:
//!   half   ---- x             what two halvings took away
//!   quarter -- x              + what is left, at most as much as the
//!   limit  -- ?                 second halving took away hereabouts
//! ```

/// Error bars of a curve from the same curve on meshes of half and a quarter
/// of the width, a value each [unit of the curve]. `None` where the lengths
/// differ.
///
/// Richardson: with an error c w^p the quarter mesh is off by
/// (half - quarter)/(2^p - 1), which for p >= 1 is at most half - quarter.
/// That is the order assumed: contact loses the order of the beam where it
/// passes nodes. Differences change sign along a curve without the error being
/// zero there, so that of the second halving is the largest within
/// `REACH` values on both sides. (choice) The whole is taken 1.25 times:
/// docs/theory.md eq. (12.2).
pub fn error_bar(coarse: &[f64], half: &[f64], quarter: &[f64]) -> Option<Vec<f64>> {
    if coarse.len() != half.len() || half.len() != quarter.len() {
        return None;
    }
    let second: Vec<f64> = half.iter().zip(quarter).map(|(h, q)| (h - q).abs()).collect();
    let bar = |k: usize| {
        let near = &second[k.saturating_sub(REACH)..(k + REACH + 1).min(second.len())];
        SAFETY * ((coarse[k] - quarter[k]).abs() + near.iter().copied().fold(0.0, f64::max))
    };
    Some((0..coarse.len()).map(bar).collect())
}

/// Safety factor on three meshes, as Roache advises for grid convergence [1].
const SAFETY: f64 = 1.25;
/// Over how many values on either side the second difference is looked at.
pub const REACH: usize = 1;

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: a bar covers any error that falls by half or more at each
    /// halving, whatever its sign. Exact algebra: the quarter mesh is off by a
    /// third of the second difference at p = 2, by all of it at p = 1.
    #[test]
    fn covers_errors_of_first_and_second_order() {
        for factor in [0.5, 0.25, -0.25, 0.1] {
            let error = |level: i32| -> Vec<f64> {
                (0..9).map(|k| (f64::from(k) - 4.3) * f64::powi(factor, level)).collect()
            };
            let bar = error_bar(&error(0), &error(1), &error(2)).unwrap_or_default();
            assert_eq!(bar.len(), 9);
            for (bar, error) in bar.iter().zip(error(0)) {
                assert!(*bar >= error.abs() * (1.0 - 1e-12), "{factor}: {bar} {error}");
            }
        }
        assert_eq!(error_bar(&[1.0], &[], &[1.0]), None);
    }

    #[test]
    fn by_hand() {
        let bar = error_bar(&[1.0, 2.0, 3.0], &[1.5, 2.0, 3.0], &[1.25, 2.0, 3.0]);
        assert_eq!(bar, Some(vec![0.625, 0.3125, 0.0]));
    }
}
