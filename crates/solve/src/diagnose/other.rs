//! Ends that no mechanics explain: a law of the embedding program, the number of increments, nothing.

use super::case::{Case, reason, step_card};
use crate::increments::StopReason;
use slideline_diag::{Code, Diagnostic, Place};
use slideline_model::{Friction, NormalLaw};

impl Case<'_> {
    pub(super) fn unknown(&self) -> Diagnostic {
        let ended = match self.stop {
            StopReason::TooManyAttempts => "every shorter increment failed as well",
            StopReason::TooSmall => "the next increment would be shorter than the smallest allowed",
            StopReason::Fixed => "shorter increments than *STATIC, DIRECT fixes failed as well",
            StopReason::TooManyIncrements => "the limit of increments was reached",
        };
        let place = self.outcome.last.as_ref().and_then(|report| {
            let (node, dof) = report.force.residual_at?;
            Some(format!(
                "; the largest residual force, {:.3e}, is at node {}, {}",
                report.force.residual,
                self.label(node),
                dof.name()
            ))
        });
        let message = format!(
            "no equilibrium was found {}, and the cause is not known: {}, and {ended}{}",
            self.beyond(),
            reason(self.plan, self.outcome),
            place.unwrap_or_default()
        );
        let said = Diagnostic::error(Code("SL0501"), message).at(self.plan.step.origin);
        let model = self.plan.model;
        let mut laws = model.contact_pairs.iter().map(|pair| &pair.interaction.normal);
        let contact = if laws.any(|law| *law == NormalLaw::Hard) {
            format!(", or soften the contact with {}", model.vocabulary().softened())
        } else if model.contact_pairs.is_empty() {
            String::new()
        } else {
            ", or round sharp corners of what touches, mesh them finer, or make the law of the contact softer"
                .to_owned()
        };
        said.help(format!(
            "the results up to that time are kept; let *STATIC start with a shorter increment \
             and allow smaller ones{contact}"
        ))
    }

    /// The embedding program's friction law failed.
    pub(super) fn user_fault(&self) -> Option<Diagnostic> {
        let fault = self.work.evaluation.fault.as_ref()?;
        let message = format!("the user friction law failed {}: {}", self.beyond(), fault.message);
        let mut pairs = self.plan.model.contact_pairs.iter();
        let user = pairs.find(|p| matches!(p.interaction.friction, Friction::User { .. }));
        let said = Diagnostic::error(Code("SL0505"), message)
            .at(user.and_then(|pair| pair.interaction.friction_origin));
        Some(said.help(
            "the results up to that time are kept; the law must return a result for any pressure \
             and slip",
        ))
    }

    pub(super) fn too_many_increments(&self) -> Diagnostic {
        let step = self.plan.step;
        let (reached, period) = (self.committed.step_time, step.procedure.period);
        let message = format!(
            "INC={} increments were made and the step has only reached time {reached:.6} of \
             {period:.6}",
            step.max_increments
        );
        let each = reached / step.max_increments.max(1) as f64;
        let needed = (2.0 * period / each).min(1e6).ceil() as usize; // a card, not a promise
        Diagnostic::error(Code("SL0502"), message)
            .at(step.origin)
            .help(format!("raise INC on *STEP to {needed}, or allow longer increments on *STATIC"))
            .card(Place::Instead(step.origin), step_card(step, None, needed))
    }
}
