//! How an attempt goes on and how it ends.

use crate::contact::Missed;
use crate::convergence::FieldHistory;
use crate::increments::Verdict;
use crate::observe::reports::{FieldReport, IterationReport};
use slideline_linalg::SolveError;

/// How an attempt ended.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// For the increment control.
    pub verdict: Verdict,
    /// Severe discontinuity iterations.
    pub severe: usize,
    /// Equilibrium iterations.
    pub equilibrium: usize,
    /// What the linear solver said, where it failed.
    pub fault: Option<SolveError>,
    /// The last iteration, where there was one.
    pub last: Option<IterationReport>,
    /// Contact that was passed through on the way to an equilibrium.
    pub missed: Option<Missed>,
    /// Whether the state was found downhill: a jump, at no rate that the next increment could go on with.
    pub leapt: bool,
}

/// Counts and histories of an attempt.
#[derive(Debug, Default)]
pub(super) struct Progress {
    pub(super) severe: u32,
    pub(super) equilibrium: u32,
    pub(super) since_change: u32,
    /// Iterations after which multipliers were moved: they tell nothing of the increment.
    pub(super) moves: u32,
    pub(super) force: FieldHistory,
    pub(super) moment: FieldHistory,
    pub(super) last: Option<IterationReport>,
}

impl Progress {
    /// Ends with a verdict.
    pub(super) fn end(self, verdict: Verdict, fault: Option<SolveError>) -> Outcome {
        let (severe, equilibrium) = (self.severe as usize, self.equilibrium as usize);
        Outcome { verdict, severe, equilibrium, fault, last: self.last, missed: None, leapt: false }
    }

    /// What the last iteration may leave of a force [F].
    pub(super) fn allowed_force(&self) -> f64 {
        self.last.as_ref().map_or(0.0, |report| report.force.allowed)
    }

    /// The equations have changed: what was before tells nothing of convergence.
    pub(super) fn begin_anew(&mut self) {
        self.since_change = 0;
        (self.force, self.moment) = (FieldHistory::default(), FieldHistory::default());
    }

    /// Equilibrium was found beyond contact that was passed through.
    /// Ends with contact that was passed through.
    pub(super) fn end_with(self, missed: Missed) -> Outcome {
        let percent = (100.0 * missed.fraction).clamp(1.0, 100.0) as u8;
        Outcome { missed: Some(missed), ..self.end(Verdict::PassedThrough { percent }, None) }
    }

    /// Whether the attempt is over. Semantics of increments: divergence is
    /// looked for from I_0 on, the rate from I_R on.
    pub(super) fn verdict(
        &self,
        report: &IterationReport,
        limits: &slideline_model::TimeIncrementation,
    ) -> Option<Verdict> {
        if !report.force.residual.is_finite() || !report.moment.residual.is_finite() {
            return Some(Verdict::Broken);
        }
        if report.converged {
            let iterations = self.equilibrium.saturating_sub(self.moves);
            return Some(Verdict::Converged { iterations });
        }
        if report.severe {
            return (self.severe > limits.i_s).then_some(Verdict::Discontinuous);
        }
        let i = self.since_change;
        let fields = [(&self.force, &report.force), (&self.moment, &report.moment)];
        let open = || fields.iter().filter(|(_, report)| !report.converged);
        if i >= limits.i_0 && open().any(|(history, _)| history.growing >= 2) {
            return Some(Verdict::Diverging);
        }
        if i >= limits.i_c {
            return Some(Verdict::TooSlow);
        }
        let promised = |(history, report): &(&FieldHistory, &FieldReport)| {
            let rate = history.rate().unwrap_or(0.0);
            if report.residual <= report.allowed || rate <= 0.0 {
                return 0.0;
            }
            if rate >= 1.0 {
                return f64::INFINITY;
            }
            f64::from(i) + (report.allowed / report.residual).ln() / rate.ln()
        };
        let slow = i >= limits.i_r && open().any(|f| promised(f) > f64::from(limits.i_c));
        slow.then_some(Verdict::TooSlow)
    }
}
