//! Peaks, and what they mean for a snap-fit.

use crate::paired::paired;

/// A value and the time at which it is taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// The value, in the units of the curve.
    pub value: f64,
    /// Its time [T].
    pub time: f64,
}

/// Smallest and largest value of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peaks {
    /// The smallest value.
    pub min: Peak,
    /// The largest value.
    pub max: Peak,
}

/// Smallest and largest value with their times, the earliest where they are taken
/// twice; NaN is passed over. `None` for lengths that differ or no values.
pub fn peaks(values: &[f64], times: &[f64]) -> Option<Peaks> {
    let mut points = paired(values, times)?
        .filter(|(v, _)| !v.is_nan())
        .map(|(value, time)| Peak { value, time });
    let first = points.next()?;
    let widen = |found: Peaks, p: Peak| Peaks {
        min: if p.value < found.min.value { p } else { found.min },
        max: if p.value > found.max.value { p } else { found.max },
    };
    Some(points.fold(Peaks { min: first, max: first }, widen))
}

/// Largest forces of the two ways through a snap-fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SnapForces {
    /// Largest force with which the mover must be driven on its way in [F].
    pub insertion: f64,
    /// Largest force with which it must be driven on its way out [F].
    pub retention: f64,
}

/// Insertion and retention force of a driven part from its reaction `reaction` [F] and
/// its displacement `motion` [L] along the same axis.
///
/// The reaction RF is the force of the driver on the part. In the step from i - 1 to i
/// the part moves by du; where RF_i du > 0 the driver pushes it along, with the force
/// |RF_i|. Steps away from the first position (|u| grows from the start in the
/// direction first taken) are insertion, steps back are retention. Where
/// RF_i du <= 0 the driver holds the part back and nothing is counted, so that
/// a snap-in that pulls counts in neither. `None` for lengths that differ, fewer than two
/// values, or no motion.
pub fn snap_forces(reaction: &[f64], motion: &[f64]) -> Option<SnapForces> {
    let points: Vec<(f64, f64)> = paired(reaction, motion)?.collect();
    let inward = points.windows(2).map(|w| w[1].1 - w[0].1).find(|du| *du != 0.0)?.signum();
    let mut forces = SnapForces { insertion: 0.0, retention: 0.0 };
    for w in points.windows(2) {
        let (du, rf) = (w[1].1 - w[0].1, w[1].0);
        if du * rf > 0.0 {
            let way = if du * inward > 0.0 { &mut forces.insertion } else { &mut forces.retention };
            *way = way.max(rf.abs());
        }
    }
    Some(forces)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_with_times() {
        let found = peaks(&[0.0, -3.0, 2.0, -3.0], &[0.0, 0.1, 0.2, 0.3]).unwrap();
        assert_eq!((found.min.value, found.min.time), (-3.0, 0.1));
        assert_eq!((found.max.value, found.max.time), (2.0, 0.2));
        assert_eq!(peaks(&[], &[]), None);
        assert_eq!(peaks(&[f64::NAN], &[0.0]), None);
    }

    /// Pushed down (RF < 0), pulled in over the crest (RF > 0), drawn out again (RF > 0 upwards).
    #[test]
    fn insertion_and_retention() {
        let motion = [0.0, -1.0, -2.0, -3.0, -2.0, -1.0, 0.0];
        let reaction = [0.0, -5.0, -8.0, 2.0, 12.0, -1.0, 0.0];
        let found = snap_forces(&reaction, &motion).unwrap();
        assert_eq!((found.insertion, found.retention), (8.0, 12.0));
        // property: the mirror image has the same forces
        let mirrored = snap_forces(&reaction.map(|v| -v), &motion.map(|v| -v)).unwrap();
        assert_eq!(mirrored, found);
        assert_eq!(snap_forces(&[1.0, 1.0], &[2.0, 2.0]), None);
    }
}
