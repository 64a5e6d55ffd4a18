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
/// How much answers may bend [1], eq (13.6): at a kink the derivative is wrong by half of it at most.
const SMOOTH: f64 = 1e-6;
/// The same where no step shows less, because of rounding [1].
const ROUGH: f64 = 1e-4;
/// By how much a bend grows with a step of a tenth where it is of rounding, at least [1]; tenfold as a
/// rule. That of a smooth function falls a thousandfold, that of a kink at the base stays.
const GROWS: f64 = 2.0;
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
    /// The one before, and how much it bent.
    before: Option<(usize, f64)>,
    /// The one that bent least, where smaller ones show rounding.
    best: Option<usize>,
    /// How many were asked on one side.
    sides: usize,
}

impl Tries {
    /// Those that begin with the step at a place.
    pub fn from(place: usize) -> Self {
        Self { place, before: None, best: None, sides: 0 }
    }

    /// Whether a try is taken whose answers bend by so much.
    pub fn accepts(&mut self, tried: Try, bend: f64) -> bool {
        if tried.side != Side::Both || tried.smooth > SMOOTH {
            return bend <= tried.smooth;
        }
        if let Some((place, before)) = self.before
            && before <= ROUGH
            && bend > GROWS * before
        {
            (self.best, self.place) = (Some(place), STEPS.len());
            return false;
        }
        self.before = Some((tried.place, bend));
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
        if let Some(place) = self.best.take() {
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

    /// The tries of a course whose answers bend as listed, until one is taken or all were asked on both
    /// sides.
    fn after(bends: &[f64]) -> Tries {
        let mut tries = Tries::from(0);
        for (place, &bend) in bends.iter().enumerate() {
            let own = tries.next().filter(|own| own.side == Side::Both);
            assert_eq!(own.map(|own| own.place), Some(place));
            assert!(own.is_some_and(|own| !tries.accepts(own, bend)));
        }
        tries
    }

    fn are_one_sided(left: &[Try]) -> bool {
        left.len() == 2 * ONE_SIDED.len() + 1
            && left.iter().all(|own| own.side != Side::Both)
            && left.iter().filter(|own| own.is_last).count() == 1
    }

    /// Requirement: steps become smaller while that makes answers smoother; where it does not, the
    /// smoothest is taken; then one side, the last as it is.
    #[test]
    fn the_smoothest_step_is_taken() {
        let mut tries = after(&[4e-4, 2e-6, 9e-6]);
        let taken = tries.next();
        assert_eq!(taken.map(|own| own.place), Some(1));
        assert!(taken.is_some_and(|own| tries.accepts(own, 2e-6)));
        assert!(are_one_sided(&tries.collect::<Vec<_>>()));
    }

    /// Requirement: answers that bend as much with every step have a kink at the base: one side is asked.
    #[test]
    fn a_kink_is_not_taken_for_rounding() {
        let tries = after(&[3e-5; STEPS.len()]);
        assert!(are_one_sided(&tries.collect::<Vec<_>>()));
    }
}
