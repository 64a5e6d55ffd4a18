//! What corrections that hardly lessen tell of stiffness that the tangent does not know.
//!
//! ```text
//!   |d|  x                       corrections d of an iteration whose tangent lacks something
//!        |  x  x                 fall by one and the same factor, or turn to and fro;
//!        |        x  x           the changes of the last ones, by the ways that were gone, say
//!        |   secants: '--x       how they go on: the step goes there at once
//!        +-------------------- iterations
//! ```
//!
//! docs/theory.md section 9, slow convergence. [anderson1965]

use crate::linearised::LinearPoints;
use slideline_mech::contact::tangential::Tangential;

/// Changes that are remembered. (choice)
const DEPTH: usize = 3;
/// A correction that is no smaller than this part of the one before converges slowly [1]. (choice)
const SLOW: f64 = 0.25;
/// Part of a correction that the changes may leave unexplained for a step by them [1]. (choice)
const UNEXPLAINED: f64 = 0.5;
/// Part of its square that of a change may be in the others for it to be one of its own [1]. (choice)
const DEPENDENT: f64 = 1e-8;

/// One iteration.
#[derive(Clone, Debug, Default)]
struct Iteration {
    /// The correction, an equation each.
    correction: Vec<f64>,
    /// What was gone of it, or instead of it.
    way: Vec<f64>,
    /// Pressures to which the linear solution came, a contact point each [F/L2].
    pressures: Vec<f64>,
    /// Tractions likewise.
    tractions: Vec<Tangential>,
}

/// The last iterations of an attempt.
#[derive(Clone, Debug, Default)]
pub(super) struct Secants {
    /// The newest is the last of those that are used.
    all: [Iteration; DEPTH + 1],
    used: usize,
    /// Whether they are to be followed.
    pub(super) is_wanted: bool,
    /// Whether a step went along them in this attempt.
    pub(super) were_followed: bool,
}

impl Secants {
    /// Begins an attempt: of an increment that is attempted for the first time they are wanted where the last one
    /// ended by them, and later where an attempt was too slow.
    pub(super) fn begin(&mut self, is_first: bool, ended_by_them: bool) {
        self.forget();
        self.were_followed = false;
        if is_first {
            self.is_wanted = ended_by_them;
        }
    }

    /// The equations have changed: what was before tells nothing.
    pub(super) fn forget(&mut self) {
        self.used = 0;
    }

    /// Notes an iteration: its correction, and the multipliers to which the linear solution came, those of `points`
    /// and for the others these pressures and tractions.
    pub(super) fn note(
        &mut self,
        correction: &[f64],
        points: &LinearPoints,
        (pressures, tractions): (&[f64], &[Tangential]),
    ) {
        let own = self.next();
        correction.clone_into(&mut own.correction);
        pressures.clone_into(&mut own.pressures);
        tractions.clone_into(&mut own.tractions);
        for linear in points.iter() {
            own.pressures[linear.place] = linear.pressure;
            own.tractions[linear.place] = linear.traction();
        }
    }

    /// Turns the correction that was noted last, and the multipliers, into a step by the secants where iterations
    /// converge slowly, and says whether it did; `counts`: which equations are asked.
    pub(super) fn follow(
        &mut self,
        counts: impl Fn(usize) -> bool,
        correction: &mut [f64],
        points: &mut LinearPoints,
    ) -> bool {
        let factors = self.factors(counts).filter(|factors| *factors != [0.0; DEPTH]);
        if let Some(factors) = factors {
            self.turn(&factors, correction);
            for place in 0..points.len() {
                let (pressure, traction) = self.change(&factors, points[place].place);
                points[place].move_by(pressure, traction);
            }
        }
        correction.clone_into(&mut self.all[self.used - 1].way);
        factors.is_some()
    }

    /// The correction that was noted last after all, with its multipliers.
    pub(super) fn take_back(&mut self, correction: &mut [f64], points: &mut LinearPoints) {
        let own = &mut self.all[self.used - 1];
        correction.copy_from_slice(&own.correction);
        correction.clone_into(&mut own.way);
        for place in 0..points.len() {
            let of = points[place].place;
            points[place].take(own.pressures[of], own.tractions[of]);
        }
    }

    /// Makes room for the newest iteration.
    fn next(&mut self) -> &mut Iteration {
        if self.used == self.all.len() {
            self.all.rotate_left(1);
            self.used -= 1;
        }
        self.used += 1;
        &mut self.all[self.used - 1]
    }

    /// The factors of the changes between iterations that explain most of the last correction, the newest
    /// first; `None` where iterations converge well, or the changes explain too little.
    /// docs/theory.md section 9
    fn factors(&self, counts: impl Fn(usize) -> bool) -> Option<[f64; DEPTH]> {
        let of = |k: usize| &self.all[k].correction[..];
        let last = self.used.checked_sub(1)?;
        let product = |a: &dyn Fn(usize) -> f64, b: &dyn Fn(usize) -> f64| -> f64 {
            (0..of(last).len()).filter(|&k| counts(k)).map(|k| a(k) * b(k)).sum()
        };
        let size = |k: usize| product(&|e| of(k)[e], &|e| of(k)[e]);
        let slow = |k: usize| size(k) >= SLOW * SLOW * size(k - 1);
        if last < 2 || !slow(last) || !slow(last - 1) {
            return None;
        }
        let change = |k: usize| move |e: usize| of(last - k)[e] - of(last - k - 1)[e];
        let mut gram = [[0.0; DEPTH]; DEPTH];
        let mut right = [0.0; DEPTH];
        for (row, (products, right)) in gram.iter_mut().zip(&mut right).take(last).enumerate() {
            *right = product(&change(row), &|e| of(last)[e]);
            for (column, entry) in products[..=row].iter_mut().enumerate() {
                *entry = product(&change(row), &change(column));
            }
        }
        let (factors, explained) = least_squares(gram, right);
        let left = size(last) - explained;
        (left <= UNEXPLAINED * UNEXPLAINED * size(last)).then_some(factors)
    }

    /// Turns the last correction into a step by the secants.
    fn turn(&self, factors: &[f64; DEPTH], correction: &mut [f64]) {
        self.changes(factors).for_each(|(factor, before, after)| {
            let ways = before.way.iter().zip(&before.correction).zip(&after.correction);
            for (into, ((way, from), to)) in correction.iter_mut().zip(ways) {
                *into -= factor * (way + to - from);
            }
        });
    }

    /// By how much the pressure and the traction of a point go with that [F/L2].
    fn change(&self, factors: &[f64; DEPTH], place: usize) -> (f64, Tangential) {
        let none = (0.0, Tangential::ZERO);
        self.changes(factors).fold(none, |(pressure, traction), (factor, before, after)| {
            let pressed = after.pressures[place] - before.pressures[place];
            let rubbed = after.tractions[place] - before.tractions[place];
            (pressure - factor * pressed, traction - factor * rubbed)
        })
    }

    /// The changes between iterations that have a factor, the newest first.
    fn changes(
        &self,
        factors: &[f64; DEPTH],
    ) -> impl Iterator<Item = (f64, &Iteration, &Iteration)> {
        let last = self.used - 1;
        let used = factors.iter().enumerate().filter(|own| *own.1 != 0.0);
        used.map(move |(k, &factor)| (factor, &self.all[last - k - 1], &self.all[last - k]))
    }
}

/// Solves the normal equations of changes, the newest first, whose products are the lower part of `gram`; changes that
/// the newer ones hold are left out. Also what is explained of the square of the right side.
fn least_squares(mut gram: [[f64; DEPTH]; DEPTH], mut right: [f64; DEPTH]) -> ([f64; DEPTH], f64) {
    let whole: [f64; DEPTH] = std::array::from_fn(|k| gram[k][k]);
    let mut explained = 0.0;
    // L D L^T, without those that depend on others
    for k in 0..DEPTH {
        let pivot = gram[k][k];
        if pivot <= DEPENDENT * whole[k] {
            (gram[k][k], right[k]) = (0.0, 0.0);
            (k + 1..DEPTH).for_each(|row| gram[row][k] = 0.0);
            continue;
        }
        explained += right[k] * right[k] / pivot;
        let below: [f64; DEPTH] = std::array::from_fn(|row| gram[row][k]);
        for row in k + 1..DEPTH {
            let factor = below[row] / pivot;
            let entries = gram[row][k + 1..=row].iter_mut().zip(&below[k + 1..]);
            entries.for_each(|(entry, other)| *entry -= factor * other);
            right[row] -= factor * right[k];
            gram[row][k] = factor;
        }
    }
    let mut factors = [0.0; DEPTH];
    for k in (0..DEPTH).rev() {
        if gram[k][k] > 0.0 {
            let later: f64 = (k + 1..DEPTH).map(|row| gram[row][k] * factors[row]).sum();
            factors[k] = right[k] / gram[k][k] - later;
        }
    }
    (factors, explained)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: usize = 7;

    /// Corrections of c - A x by a tangent of ones, which lacks what A has beside.
    fn correction(missing: &[[f64; SIZE]], x: &[f64]) -> Vec<f64> {
        let by = |row: usize| {
            let dot = |own: &[f64; SIZE]| own.iter().zip(x).map(|(a, x)| a * x).sum::<f64>();
            missing.iter().map(|own| 0.9 * own[row] * dot(own)).sum::<f64>()
        };
        (0..SIZE).map(|row| 1.0 + row as f64 - x[row] - by(row)).collect()
    }

    /// Requirement: where the tangent lacks stiffness along one way, two or three, each with a rate of -0.9 by
    /// itself, steps by the secants end in rounding after some iterations more than ways, and without them not after
    /// twenty.
    #[test]
    fn what_the_tangent_lacks_is_found() {
        let across = |k: usize| {
            let mut own = [0.0; SIZE];
            (own[2 * k], own[2 * k + 1]) = (0.6, 0.8);
            own
        };
        for ways in 1..=3 {
            let missing: Vec<_> = (0..ways).map(across).collect();
            let iterate = |follows: bool, most: usize| {
                let (mut secants, mut x) = (Secants::default(), vec![0.0; SIZE]);
                let mut points = LinearPoints::default();
                for iteration in 0..most {
                    let mut step = correction(&missing, &x);
                    let size = step.iter().fold(0.0_f64, |most, d| most.max(d.abs()));
                    if size < 1e-10 {
                        return Some(iteration);
                    }
                    secants.note(&step, &points, (&[], &[]));
                    if follows {
                        secants.follow(|_| true, &mut step, &mut points);
                    }
                    x.iter_mut().zip(&step).for_each(|(x, step)| *x += step);
                }
                None
            };
            assert!(iterate(false, 20).is_none());
            let iterations = iterate(true, 20);
            assert!(iterations.is_some_and(|own| own <= 4 + 2 * ways), "{ways} {iterations:?}");
        }
    }

    /// Requirement: the first attempt at an increment follows secants where the state says that the last increment ended by
    /// them, whatever was attempted before it; later attempts go on as the one before was told.
    #[test]
    fn what_is_wanted_comes_from_the_state() {
        let mut secants = Secants { is_wanted: true, were_followed: true, ..Secants::default() };
        secants.begin(true, false);
        assert!(!secants.is_wanted && !secants.were_followed);
        secants.is_wanted = true; // an attempt was too slow
        secants.begin(false, false);
        assert!(secants.is_wanted);
        secants.begin(true, true);
        assert!(secants.is_wanted);
    }

    /// Requirement: changes that depend on newer ones are left out, and explain nothing twice.
    #[test]
    fn changes_that_depend_on_others() {
        let gram = [[4.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 9.0]];
        let (factors, explained) = least_squares(gram, [8.0, 4.0, 18.0]);
        assert_eq!((factors, explained), ([2.0, 0.0, 2.0], 52.0));
        let gram = [[4.0, 0.0, 0.0], [2.0, 3.0, 0.0], [1.0, -1.0, 5.0]];
        let right = [4.0 + 4.0 + 3.0, 2.0 + 6.0 - 3.0, 1.0 - 2.0 + 15.0];
        let (factors, _) = least_squares(gram, right);
        let near = factors.iter().zip([1.0, 2.0, 3.0]).all(|(a, b)| (a - b).abs() < 1e-14);
        assert!(near, "{factors:?}");
    }
}
