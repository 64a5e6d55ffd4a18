//! Elements that have no answer where the iteration led them.

use super::case::Case;
use crate::increments::Verdict;
use slideline_diag::{Code, Diagnostic};
use slideline_mech::element::Failure;

impl Case<'_> {
    /// The last attempt ended at an element that is turned inside out, or the like.
    pub(super) fn failed_element(&self) -> Option<Diagnostic> {
        let failed = self.work.evaluation.failed?;
        if self.outcome.verdict != Verdict::Collapsed {
            return None;
        }
        let block = &self.plan.model.blocks[failed.block];
        let element = block.elements.get(failed.member);
        let (what, help) = words(failed.failure);
        let message = format!(
            "element {} ({}) collapses {}: {what}; increments down to {:.3e} were tried",
            element.label,
            block.word(),
            self.beyond(),
            self.dt
        );
        Some(Diagnostic::error(Code("SL0522"), message).at(element.origin).help(format!(
            "the results up to that time are kept; look at the deformed shape there: {help}"
        )))
    }
}

/// What happened to the element, and what may be done about it.
fn words(failure: Failure) -> (String, &'static str) {
    let mesh = "elements that are long in the direction of compression bear more of it, and no body \
                bears a load or a stroke beyond its limit";
    match failure {
        Failure::InsideOut(point) => {
            (format!("its integration point {} is turned inside out", point + 1), mesh)
        }
        Failure::OnAxis(point) => (
            format!("its integration point {} has come to the axis of symmetry", point + 1),
            "support the nodes on the axis in direction 1",
        ),
        Failure::NoThickness(point) => (
            format!("at its integration point {} no thickness is free of stress", point + 1),
            "the stretch is beyond what the material can bear in plane stress",
        ),
        Failure::NoEquilibrium => (
            "its incompatible modes find no equilibrium".to_owned(),
            "an element without them (no I in its name) bears more distortion",
        ),
        Failure::NotFinite => (
            "its force, stiffness or energy is no finite number".to_owned(),
            "the strain there is beyond what the material is made for",
        ),
    }
}
