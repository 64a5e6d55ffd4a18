//! How much of a face counts at a node that meets a master there.
//!
//! ```text
//!      |  aside: none                 /\      both look at it alike: both count, at any angle
//!      |______ looks at it: whole    /  \
//!      x                            / x  \        __x__  what is round counts, wherever it is met
//!   -------------- master        -------------- master
//! ```
//!
//! docs/theory.md eq. (5.59).

use crate::vector::{Vector, dot};

/// Cosine from which on a face counts whole: of 45 degrees, where an edge is sharp [1].
pub const WHOLE: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Cosine down to which it does not count: of 75 degrees [1].
const NOTHING: f64 = 0.258_819_045_102_520_74;

/// The part of a face that counts, by its outward normal, that of the face about the node which looks at the
/// master most, and the way to the master, all of length one. That face counts whole. Where it does not look at
/// the master nothing is known of the sides, and all count.
pub fn counted(face: Vector, most: Vector, way: Vector) -> f64 {
    let largest = dot(most, way);
    if largest <= 0.0 {
        return 1.0;
    }
    let alike = (dot(face, way) / largest).max(dot(face, most));
    ((alike - NOTHING) / (WHOLE - NOTHING)).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    const DOWN: Vector = [0.0, -1.0, 0.0];

    /// A normal that is turned by that angle from the way down.
    fn turned(degrees: f64) -> Vector {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        [sine, -cosine, 0.0]
    }

    /// Requirement: faces about one that looks straight at the master count whole up to 45 degrees, not at all from 75
    /// degrees on, and half where the cosine is in the middle. Source: docs/theory.md eq. (5.59). Tolerance: rounding.
    #[test]
    fn sides_do_not_count() {
        for degrees in [0.0, 22.5, 44.99, -44.99] {
            assert_eq!(counted(turned(degrees), DOWN, DOWN), 1.0);
        }
        for degrees in [75.01, 90.0, 135.0, 180.0, -90.0] {
            assert_eq!(counted(turned(degrees), DOWN, DOWN), 0.0);
        }
        let middle = 0.5 * (45_f64.to_radians().cos() + 75_f64.to_radians().cos());
        let half = counted(turned(middle.acos().to_degrees()), DOWN, DOWN);
        assert!((half - 0.5).abs() < 1e-14, "{half}");
    }

    /// Requirement: of the faces of a wedge that stands on its edge both count, however steep; as the wedge tips over, the
    /// one that turns away counts less and less. Source: docs/theory.md eq. (5.59).
    #[test]
    fn a_wedge_stands_on_both_faces() {
        for steep in [10.0, 45.0, 80.0, 89.9] {
            let part = counted(turned(-steep), turned(steep), DOWN);
            assert!((part - 1.0).abs() < 1e-12, "{part}");
        }
        let tipped = |turn: f64| counted(turned(-45.0 - turn), turned(45.0 - turn), DOWN);
        assert_eq!([0.0, 9.0].map(tipped), [1.0, 1.0]);
        assert!(tipped(20.0) < 1.0 && tipped(20.0) > tipped(25.0) && tipped(25.0) > 0.0);
        assert_eq!(tipped(30.6), 0.0);
    }

    /// Requirement: what turns by less than 45 degrees is round and counts whole, however it stands to the master. Source:
    /// docs/theory.md eq. (5.59).
    #[test]
    fn what_is_round_counts_whole() {
        for leaning in [0.0, 30.0, 60.0, 85.0] {
            assert_eq!(counted(turned(leaning + 44.9), turned(leaning), DOWN), 1.0);
        }
    }

    /// Requirement: a node none of whose faces looks at its master keeps its area, which divides stiffnesses.
    #[test]
    fn what_looks_away_keeps_its_area() {
        let (up, aside) = ([0.0, 1.0, 0.0], [1.0, 0.0, 0.0]);
        assert_eq!([counted(up, up, DOWN), counted(up, aside, DOWN)], [1.0, 1.0]);
    }
}
