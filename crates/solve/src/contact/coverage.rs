//! Slave nodes of which the master covers next to nothing: let go step by step, not at once.
//!
//! ```text
//!       master  |
//!   ------------'          the function of b is small on what is covered. Where a has it too, nothing
//!   a==========.---b       holds the corner any more: it goes down, covers more, is held again, ...
//!       slave
//! ```
//!
//! docs/theory.md section 5.19

/// Part of the area of the node of a face that has most of it, which a node must have to carry
/// contact of its own there [1].
pub(super) const LEAST_AREA: f64 = 0.05;

/// The same from which on a node is held whole, as is one with as much as one of its faces has of it [1].
const HELD_AREA: f64 = 0.5;

/// How deep at most a node may stand unheld, by the size of its faces [1].
const DEEPEST: f64 = 0.05;

/// What a node is let go by while less and less of it is covered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Release {
    /// The area with which it is held whole, and the one with which it is let go [L2].
    held: f64,
    free: f64,
    /// How deep it may stand then [L].
    depth: f64,
}

/// What hard contact allows a point, for it and for the potential of its area `A(D)`:
/// docs/theory.md eqs. (5.54) and (5.55).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Allowed {
    /// The overclosure `a` [L].
    pub overclosure: f64,
    /// `dA/dD` of `A = D a` [L].
    pub by_area: f64,
    /// `d2A/dD2` [1/L].
    pub bend: f64,
}

impl Release {
    /// That of a node which is held however little of it is covered.
    pub const HELD: Self = Self { held: 0.0, free: -1.0, depth: 0.0 };

    /// That of a node on a face that has so much of it, whole, beside one of which so much was covered at the last
    /// commit [L2]; `size` of the face [L].
    pub fn beside(own: f64, most: f64, size: f64) -> Self {
        let (held, free) = (own.min(HELD_AREA * most), LEAST_AREA * most);
        if held > free { Self { held, free, depth: DEEPEST * size } } else { Self::HELD }
    }

    /// Takes in those of the nodes of a face, given its points with their areas, whole, and whether it was covered;
    /// `areas` that were covered of all points [L2]; `size` of the face [L].
    pub fn of_face(
        (points, whole, was_covered): (&[usize], &[f64], bool),
        areas: &[f64],
        size: f64,
        into: &mut [Option<Self>],
    ) {
        let by_area = |&&a: &&usize, &&b: &&usize| areas[a].total_cmp(&areas[b]);
        let Some(&most) = points.iter().max_by(by_area).filter(|&&most| areas[most] > 0.0) else {
            return;
        };
        for (&point, &own) in points.iter().zip(whole) {
            if point != most {
                Self::beside(own, areas[most], size).take_into(&mut into[point]);
            } else if was_covered {
                Self::HELD.take_into(&mut into[point]);
            }
        }
    }

    /// The one that holds more of two.
    pub fn or(self, other: Self) -> Self {
        if other.held < self.held { other } else { self }
    }

    /// Takes it in where it holds more than what is known.
    pub fn take_into(self, known: &mut Option<Self>) {
        *known = Some(known.map_or(self, |known| known.or(self)));
    }

    /// What a node is allowed of which so much is covered [L2].
    pub fn at(&self, area: f64) -> Allowed {
        let Self { held, free, depth } = *self;
        let left = ((held - area) / (held - free)).clamp(0.0, 1.0);
        let overclosure = depth * left * left;
        if left == 0.0 || left == 1.0 {
            return Allowed { overclosure, by_area: overclosure, bend: 0.0 };
        }
        let slope = -2.0 * depth * left / (held - free);
        let turn = 2.0 * depth / ((held - free) * (held - free));
        Allowed {
            overclosure,
            by_area: overclosure + area * slope,
            bend: 2.0 * slope + area * turn,
        }
    }
}

impl Allowed {
    /// With as much more of a step [L].
    pub fn and(self, by_step: f64) -> Self {
        Self {
            overclosure: self.overclosure + by_step,
            by_area: self.by_area + by_step,
            bend: self.bend,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: f64 = 0.7;
    const MOST: f64 = 1.5;

    /// Requirement: what has a whole face is held, whatever its size, and what has half of what the other one has;
    /// less and less is held as it comes out from under the master, without a leap.
    #[test]
    fn nodes_are_let_go_step_by_step() {
        for own in [0.2, 0.5, 1.0, 3.0] {
            let release = Release::beside(own, MOST, SIZE);
            let held = own.min(0.5 * MOST);
            assert_eq!(release.at(held), Allowed::default());
            assert_eq!(release.at(LEAST_AREA * MOST).overclosure, DEEPEST * SIZE);
            let depths = (0..=1000).map(|k| release.at(1e-3 * held * f64::from(k)).overclosure);
            let depths: Vec<f64> = depths.collect();
            assert!(depths.windows(2).all(|own| own[1] <= own[0]));
            assert!(depths.windows(2).all(|own| own[0] - own[1] < 0.02 * DEEPEST * SIZE));
        }
        assert_eq!(Release::beside(0.07, MOST, SIZE), Release::HELD);
        assert_eq!(Release::HELD.at(0.0), Allowed::default());
    }

    /// Requirement: a node that has most of a covered face is held; beside a node that had nothing nobody is let
    /// go; of two faces the one counts that holds more.
    #[test]
    fn the_face_that_holds_more_counts() {
        let areas = [1.0, 0.2, 0.0];
        let mut into = [None; 3];
        Release::of_face((&[1, 2], &[0.5, 0.5], false), &areas, SIZE, &mut into);
        assert_eq!(into, [None, None, Some(Release::beside(0.5, 0.2, SIZE))]);
        Release::of_face((&[0, 1], &[0.5, 0.5], true), &areas, SIZE, &mut into);
        assert_eq!(into[..2], [Some(Release::HELD), Some(Release::beside(0.5, 1.0, SIZE))]);
        Release::of_face((&[1, 2], &[0.5, 0.5], true), &areas, SIZE, &mut into);
        assert_eq!(into[1], Some(Release::HELD));
        let mut none = [None; 3];
        Release::of_face((&[0, 1], &[0.5, 0.5], true), &[0.0; 3], SIZE, &mut none);
        assert_eq!(none, [None; 3]);
    }

    /// Requirement: the derivatives of the potential are those of differences.
    #[test]
    fn derivatives_are_those_of_differences() {
        let (own, step) = (Release::beside(0.8, MOST, SIZE), 1e-6);
        let potential = |area: f64| area * own.at(area).overclosure;
        for area in [0.1, 0.2, 0.4, 0.7] {
            let Allowed { by_area, bend, .. } = own.at(area);
            let first = (potential(area + step) - potential(area - step)) / (2.0 * step);
            let second = (own.at(area + step).by_area - own.at(area - step).by_area) / (2.0 * step);
            assert!((first - by_area).abs() < 1e-9 && (second - bend).abs() < 1e-8, "{area}");
        }
    }
}
