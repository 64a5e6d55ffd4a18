//! How long the next increment is: a pure machine.
//!
//! ```text
//!   (control, what Newton said) -> accept (next dt) | cut (shorter dt) | stop
//! ```
//!
//! Rules: semantics of Newton and increments (manual, recalled values named
//! there). The machine knows nothing of the mechanics, Newton nothing of time.

use serde::{Deserialize, Serialize};
use slideline_model::{Static, TimeIncrementation};

/// Where a step stands in time.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Control {
    /// Committed time in the step [T].
    pub time: f64,
    /// Increment to be tried next [T].
    pub dt: f64,
    /// Increments committed in the step.
    pub committed: usize,
    /// Attempts made at the present increment.
    pub attempts: u32,
    /// Consecutive increments that converged quickly.
    pub quick: u32,
}

/// How an attempt ended, as far as time is concerned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Converged in that many equilibrium iterations.
    Converged {
        /// Equilibrium iterations.
        iterations: u32,
    },
    /// The residual grew twice running.
    Diverging,
    /// The rate of convergence promises too many iterations.
    TooSlow,
    /// Contact went on changing.
    Discontinuous,
    /// The equations could not be solved, or gave no number.
    Broken,
    /// An element has no answer where the iteration led it.
    Collapsed,
    /// An equilibrium was found, but metal has flowed away to it: nothing but rounding holds it.
    FlowsAway,
    /// An equilibrium was found, but the creep strains of its increment, taken by the conditions at
    /// its two ends, differ by more than `CETOL` allows.
    TooCoarse {
        /// The difference in hundredths of what is allowed.
        percent: u32,
    },
    /// An equilibrium was found, but on the way to it a body went through its
    /// master.
    PassedThrough {
        /// Where in the increment contact began, in hundredths.
        percent: u8,
    },
}

impl Verdict {
    /// Whether iterations with a line search may end otherwise: not those of
    /// equations that could not be solved.
    pub fn may_be_searched(self) -> bool {
        matches!(self, Self::Diverging | Self::TooSlow | Self::Discontinuous | Self::Collapsed)
    }
}

/// What to do next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Decision {
    /// Commit; the step goes on.
    Continue(Control),
    /// Commit; the step is done.
    StepDone,
    /// Give the attempt up and try a shorter increment.
    Cut(Control),
    /// Give up.
    Stop(StopReason),
}

/// Why no shorter increment is tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopReason {
    /// I_A attempts were made.
    TooManyAttempts,
    /// The increment would fall below the smallest one.
    TooSmall,
    /// `DIRECT`: increments are fixed.
    Fixed,
    /// `INC` increments were made.
    TooManyIncrements,
}

/// Part of the increment that creep allows that is taken [1].
const CAUTION: f64 = 0.9;
/// What is left of an increment at most where creep asks for a shorter one [1].
const MOST_CUT: f64 = 0.8;
/// Shortest cut to where contact began, or to what creep allows [1].
const SHORTEST_CUT: f64 = 0.1;
/// Fraction of the period by which the end of a step may be missed.
const END: f64 = 1e-12;

impl Control {
    /// The beginning of a step.
    pub fn begin(procedure: &Static) -> Self {
        let dt = procedure.initial.min(procedure.maximum).min(procedure.period);
        Self { time: 0.0, dt, committed: 0, attempts: 0, quick: 0 }
    }

    /// Time at the end of the increment to be tried: the last one ends
    /// exactly with the step.
    pub fn target(&self, procedure: &Static) -> f64 {
        let target = self.time + self.dt;
        if target > procedure.period * (1.0 - END) { procedure.period } else { target }
    }

    /// What follows from an attempt.
    pub fn after(
        &self,
        verdict: Verdict,
        procedure: &Static,
        limits: &TimeIncrementation,
        max_increments: usize,
    ) -> Decision {
        match verdict {
            Verdict::Converged { iterations } => {
                self.accept(iterations, procedure, limits, max_increments)
            }
            Verdict::Diverging
            | Verdict::Discontinuous
            | Verdict::Broken
            | Verdict::Collapsed
            | Verdict::FlowsAway => self.cut(limits.d_f, procedure, limits),
            Verdict::TooSlow => self.cut(limits.d_c, procedure, limits),
            Verdict::TooCoarse { percent } => {
                let part =
                    (CAUTION * kept(f64::from(percent) / 100.0)).clamp(SHORTEST_CUT, MOST_CUT);
                self.shorten(part, procedure)
            }
            Verdict::PassedThrough { percent } => self.cut_to_contact(percent, procedure),
        }
    }

    fn accept(
        &self,
        iterations: u32,
        procedure: &Static,
        limits: &TimeIncrementation,
        max_increments: usize,
    ) -> Decision {
        let time = self.target(procedure);
        if time >= procedure.period {
            return Decision::StepDone;
        }
        if self.committed + 1 >= max_increments {
            return Decision::Stop(StopReason::TooManyIncrements);
        }
        let quick = if iterations <= limits.i_g { self.quick + 1 } else { 0 };
        let mut dt = self.dt;
        let mut next_quick = quick;
        if !procedure.direct {
            if iterations > limits.i_l {
                dt *= limits.d_b;
            } else if quick >= 2 {
                dt *= limits.d_d;
                next_quick = 0;
            }
            dt = dt.min(procedure.maximum).max(procedure.minimum);
        }
        let committed = self.committed + 1;
        let dt = even_end(dt, procedure.period - time);
        Decision::Continue(Self { time, dt, committed, attempts: 0, quick: next_quick })
    }

    /// What follows from an accepted increment where the difference of its creep strains is a part of
    /// what is allowed: the next one is as long as that promises.
    pub fn as_creep_allows(
        &self,
        decision: Decision,
        part: f64,
        procedure: &Static,
        limits: &TimeIncrementation,
    ) -> Decision {
        let Decision::Continue(next) = decision else { return decision };
        if procedure.direct {
            return decision;
        }
        let allowed = self.dt * (CAUTION * kept(part)).min(limits.d_d);
        // what took many iterations stays shorter
        let dt = if next.dt < self.dt { allowed.min(next.dt) } else { allowed };
        let dt = dt.min(procedure.maximum).max(procedure.minimum);
        Decision::Continue(Self { dt: even_end(dt, procedure.period - next.time), ..next })
    }

    /// To where contact began, at least halving.
    fn cut_to_contact(&self, percent: u8, procedure: &Static) -> Decision {
        self.shorten((f64::from(percent) / 100.0).clamp(SHORTEST_CUT, 0.5), procedure)
    }

    /// To a part of the increment. It is no failure of Newton: only the smallest increment ends it.
    fn shorten(&self, part: f64, procedure: &Static) -> Decision {
        if procedure.direct {
            return Decision::Stop(StopReason::Fixed);
        }
        let dt = self.dt * part;
        if dt < procedure.minimum {
            return Decision::Stop(StopReason::TooSmall);
        }
        Decision::Cut(Self { dt, quick: 0, ..*self })
    }

    fn cut(&self, factor: f64, procedure: &Static, limits: &TimeIncrementation) -> Decision {
        if procedure.direct {
            return Decision::Stop(StopReason::Fixed);
        }
        let attempts = self.attempts + 1;
        if attempts >= limits.i_a {
            return Decision::Stop(StopReason::TooManyAttempts);
        }
        let dt = self.dt * factor;
        if dt < procedure.minimum {
            return Decision::Stop(StopReason::TooSmall);
        }
        Decision::Cut(Self { dt, attempts, quick: 0, ..*self })
    }
}

/// Part of an increment for which the difference of creep strains is as large as allowed, of what it
/// is now [1]: it grows with the square of the increment, docs/theory.md eq. (3.97).
fn kept(difference: f64) -> f64 {
    difference.max(f64::MIN_POSITIVE).sqrt().recip()
}

/// Clips an increment to the end of the step. Sums of binary fractions of a
/// step miss its end by rounding; a remainder of that size is not walked.
fn even_end(dt: f64, left: f64) -> f64 {
    if dt > left * (1.0 - 1e-9) { left } else { dt }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideline_model::Passage;

    fn seed() -> Static {
        Static {
            initial: 0.05,
            period: 1.0,
            minimum: 1e-6,
            maximum: 0.05,
            direct: false,
            passage: Passage::default(),
            creep_tolerance: None,
            origin: None,
        }
    }

    /// The paper's `0.05, 1.0, 1.0E-6, 0.05` are 20 equal increments.
    #[test]
    fn the_papers_increments_are_twenty_equal_ones() {
        let procedure = seed();
        let mut control = Control::begin(&procedure);
        let mut times = vec![];
        loop {
            times.push(control.target(&procedure));
            let verdict = Verdict::Converged { iterations: 3 };
            match control.after(verdict, &procedure, &TimeIncrementation::default(), 100) {
                Decision::Continue(next) => control = next,
                Decision::StepDone => break,
                other => panic!("{other:?}"),
            }
        }
        assert_eq!(times.len(), 20);
        assert_eq!(times[19], 1.0);
        assert!(times.iter().enumerate().all(|(k, t)| (t - 0.05 * (k + 1) as f64).abs() < 1e-12));
    }

    /// Semantics, section 9: D_f = 0.25 after divergence, D_C = 0.5 after a
    /// slow rate, stop at the fifth attempt or below the smallest increment.
    #[test]
    fn cutbacks_follow_the_table() {
        let (procedure, limits) = (seed(), TimeIncrementation::default());
        let begin = Control::begin(&procedure);
        let Decision::Cut(cut) = begin.after(Verdict::Diverging, &procedure, &limits, 100) else {
            panic!()
        };
        assert_eq!((cut.dt, cut.attempts), (0.0125, 1));
        let Decision::Cut(cut) = begin.after(Verdict::TooSlow, &procedure, &limits, 100) else {
            panic!()
        };
        assert_eq!(cut.dt, 0.025);
        let Decision::Cut(cut) = begin.after(Verdict::Collapsed, &procedure, &limits, 100) else {
            panic!()
        };
        assert_eq!(cut.dt, 0.0125);
        let last = Control { attempts: 4, ..begin };
        let stop = last.after(Verdict::Broken, &procedure, &limits, 100);
        assert_eq!(stop, Decision::Stop(StopReason::TooManyAttempts));
        let small = Control { dt: 2e-6, ..begin };
        let stop = small.after(Verdict::Discontinuous, &procedure, &limits, 100);
        assert_eq!(stop, Decision::Stop(StopReason::TooSmall));
    }

    /// I_G = 4 twice running lengthens by D_D = 1.5, I_L = 10 shortens by 0.75.
    #[test]
    fn increments_adapt_to_the_iterations() {
        let procedure = Static { maximum: 1.0, initial: 0.1, ..seed() };
        let limits = TimeIncrementation::default();
        let begin = Control::begin(&procedure);
        let quick = Verdict::Converged { iterations: 4 };
        let Decision::Continue(one) = begin.after(quick, &procedure, &limits, 100) else {
            panic!()
        };
        assert_eq!(one.dt, 0.1);
        let Decision::Continue(two) = one.after(quick, &procedure, &limits, 100) else { panic!() };
        assert!((two.dt - 0.15).abs() < 1e-15);
        let slow = Verdict::Converged { iterations: 11 };
        let Decision::Continue(three) = begin.after(slow, &procedure, &limits, 100) else {
            panic!()
        };
        assert!((three.dt - 0.075).abs() < 1e-15);
    }

    /// `CETOL`: an increment whose creep strains differ too much is shortened by the root of how much,
    /// and the next one is as long as the difference promises, 1.5 times at most.
    #[test]
    fn creep_rules_increments() {
        let procedure = Static { maximum: 1.0, initial: 0.1, ..seed() };
        let limits = TimeIncrementation::default();
        let begin = Control::begin(&procedure);
        let coarse = Verdict::TooCoarse { percent: 400 };
        let Decision::Cut(cut) = begin.after(coarse, &procedure, &limits, 100) else { panic!() };
        assert!((cut.dt - 0.045).abs() < 1e-15 && cut.attempts == 0);
        let quick = Verdict::Converged { iterations: 3 };
        let accepted = begin.after(quick, &procedure, &limits, 100);
        for (part, dt) in [(0.0, 0.15), (0.64, 0.1125), (1.0, 0.09)] {
            let next = begin.as_creep_allows(accepted, part, &procedure, &limits);
            let Decision::Continue(next) = next else { panic!() };
            assert!((next.dt - dt).abs() < 1e-15, "{part} {}", next.dt);
        }
        let fixed = Static { direct: true, ..procedure };
        let kept = begin.as_creep_allows(accepted, 0.0, &fixed, &limits);
        assert_eq!(kept, accepted);
        let small = Control { dt: 1.5e-6, ..begin };
        let stop = small.after(coarse, &procedure, &limits, 100);
        assert_eq!(stop, Decision::Stop(StopReason::TooSmall));
    }

    #[test]
    fn inc_limits_the_number_of_increments() {
        let procedure = seed();
        let begin = Control::begin(&procedure);
        let verdict = Verdict::Converged { iterations: 1 };
        let stop = begin.after(verdict, &procedure, &TimeIncrementation::default(), 1);
        assert_eq!(stop, Decision::Stop(StopReason::TooManyIncrements));
    }
}
