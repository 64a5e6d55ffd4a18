//! How much of an end counts that went into a master through another side than the one that it faces from within.
//!
//! ```text
//!         |  slave  |             counts
//!     ----o---------o----       1 |-----.
//!     |     master   |wide|       |      '.
//!     |<--- deep --->|          0 +-------'---  deep / wide
//!                                       1  2
//! ```
//!
//! docs/theory.md section 5.11, an end that went in elsewhere

/// Times as deep as it is wide at which such an end counts no more [1]. (choice)
const NO_MORE: f64 = 2.0;

/// How much of an end counts that stands so deep in a master and is so wide [L]: all of it up to as deep as wide. Where it
/// came and went as a whole, forces leapt.
pub fn counts(depth: f64, width: f64) -> f64 {
    if depth <= width {
        return 1.0;
    }
    fading((depth - width) / ((NO_MORE - 1.0) * width))
}

/// All up to zero, nothing from one on, and without a leap or a kink between.
pub fn fading(beyond: f64) -> f64 {
    let beyond = beyond.clamp(0.0, 1.0);
    1.0 - beyond * beyond * (3.0 - 2.0 * beyond)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: all counts up to as deep as wide, nothing from twice that on, and between it falls without a leap;
    /// what has no width counts not.
    #[test]
    fn an_end_counts_less_and_less() {
        for width in [1e-9, 0.3, 1e6] {
            assert!(counts(-width, width) == 1.0 && counts(width, width) == 1.0);
            assert!(counts(2.0 * width, width) == 0.0 && counts(9.0 * width, width) == 0.0);
            let all: Vec<f64> =
                (0..=1000).map(|k| counts((1.0 + f64::from(k) / 1000.0) * width, width)).collect();
            assert!(all.windows(2).all(|two| two[0] >= two[1] && two[0] - two[1] < 2e-3));
        }
        assert!(counts(1e-9, 0.0) == 0.0 && counts(0.0, 0.0) == 1.0);
        assert!(counts(1.0, f64::INFINITY) == 1.0);
    }
}
