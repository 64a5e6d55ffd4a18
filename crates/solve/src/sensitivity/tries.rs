//! With which neighbours an increment is asked, one try behind the other.
//!
//! ```text
//!   h            |----------x----------|        as long as all is smooth there
//!   h/10                 |--x--|                where the law of large steps ends
//!   one side                x--|                at a kink
//! ```
//!
//! docs/theory.md section 13.

use super::stencil::Side;

/// Steps that are tried, in scales of the parameter. The fourth power of the first is truncation, the
/// more the stiffer a part is one way than another; rounding grows with their inverse; smaller ones
/// find back to the branch of the base.
pub const STEPS: [f64; 5] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7];
/// Part by which differences with one and two steps may disagree: they are right to the square of
/// it [1].
const SMOOTH: f64 = 1e-5;
/// The same where no step shows less, because of rounding [1].
const ROUGH: f64 = 1e-3;
/// What a step of a tenth leaves of a bend at most, where it is of truncation [1]; a hundredth as a
/// rule. Where more is left it is of rounding, which is less with the larger step.
const FALLS: f64 = 0.1;
/// Places of the steps with which one side is asked.
const ONE_SIDED: [usize; 2] = [2, 4];

/// A choice of neighbours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Try {
    /// Place of the step.
    pub place: usize,
    /// On which sides they stand.
    pub side: Side,
    /// How much their answers may bend [1].
    smooth: f64,
    /// Whether it is taken as it is: there is no other.
    pub is_last: bool,
}

/// The tries of an increment.
#[derive(Clone, Debug)]
pub struct Tries {
    /// Place of the next step that is asked on both sides.
    place: usize,
    /// The one that bent least, and by how much.
    best: Option<(usize, f64)>,
    /// How many were asked on one side.
    sides: usize,
}

impl Tries {
    /// Those that begin with the step at a place.
    pub fn from(place: usize) -> Self {
        Self { place, best: None, sides: 0 }
    }

    /// Whether a try is taken whose answers bend by so much.
    pub fn accepts(&mut self, tried: Try, bend: f64) -> bool {
        if tried.side != Side::Both || tried.smooth > SMOOTH {
            return bend <= tried.smooth;
        }
        if self.best.is_some_and(|(_, least)| least <= ROUGH && bend > FALLS * least) {
            self.place = STEPS.len();
            return false;
        }
        if bend > SMOOTH {
            self.best = Some((tried.place, bend));
        }
        bend <= SMOOTH
    }
}

impl Iterator for Tries {
    type Item = Try;

    fn next(&mut self) -> Option<Try> {
        let of = |place, side, smooth| Try { place, side, smooth, is_last: false };
        if self.place < STEPS.len() {
            self.place += 1;
            return Some(of(self.place - 1, Side::Both, SMOOTH));
        }
        if let Some((place, _)) = self.best.take().filter(|(_, bend)| *bend <= ROUGH) {
            return Some(of(place, Side::Both, ROUGH));
        }
        self.sides += 1;
        let side = if self.sides % 2 == 1 { Side::Above } else { Side::Below };
        let place = ONE_SIDED.get((self.sides - 1) / 2);
        match place {
            Some(&place) => Some(of(place, side, ROUGH)),
            None if self.sides == 2 * ONE_SIDED.len() + 1 => {
                Some(Try { is_last: true, ..of(ONE_SIDED[0], Side::Above, ROUGH) })
            }
            None => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: steps become smaller while that makes answers smoother; where it does not, the
    /// smoothest is taken; then one side, the last as it is.
    #[test]
    fn the_smoothest_step_is_taken() {
        let mut tries = Tries::from(0);
        // the second still falls, the third shows rounding, though it is small enough
        for (place, bend) in [4e-4, 2e-5, 7e-6].into_iter().enumerate() {
            let own = tries.next().filter(|own| own.side == Side::Both);
            assert_eq!(own.map(|own| own.place), Some(place));
            assert!(own.is_some_and(|own| !tries.accepts(own, bend)));
        }
        let taken = tries.next();
        assert_eq!(taken.map(|own| own.place), Some(1));
        assert!(taken.is_some_and(|own| tries.accepts(own, 2e-5)));
        let left: Vec<Try> = tries.collect();
        assert_eq!(left.len(), 2 * ONE_SIDED.len() + 1);
        assert!(left.iter().all(|own| own.side != Side::Both));
        assert_eq!(left.iter().filter(|own| own.is_last).count(), 1);
    }
}
