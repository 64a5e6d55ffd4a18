//! Steps with PERTURBATION: linear answers to their own loads, about what is not loaded.
//!
//! ```text
//!   load |   1 /      / 2      each begins anew at nothing; what bends, or was left behind, has no place there
//!        |    /   ___/
//!        +---/---/------ step
//! ```

use slideline_diag::{Code, Diagnostic};
use slideline_model::{Dialect, ElementBlock, Material, Section, SpringLaw};

use crate::draft::{Draft, StepDraft};
use crate::rule::Subject;

/// A step with PERTURBATION is linear in all, and leaves nothing to a step behind it that is not one: complains about
/// what is otherwise.
pub(super) fn check((step, was_alone): (&StepDraft, bool), draft: &mut Draft) {
    let Some(span) = step.perturbation else {
        if draft.dialect == Dialect::Abaqus && was_alone {
            let message =
                "a step behind one with PERTURBATION that has none itself is not supported";
            let error = Diagnostic::error(Code("SL0221"), message).at(step.origin);
            let help = "it would begin where the steps before PERTURBATION left off: give it a deck of its own";
            draft.consequence(Subject::Steps, error.help(help));
        }
        return;
    };
    let remembers = |block: &ElementBlock| match &block.section {
        Section::Solid(own) => {
            own.material.states() > 0 || matches!(own.material, Material::RambergOsgood(_))
        }
        _ => false,
    };
    let bends = |block: &ElementBlock| match &block.section {
        Section::Spring(own) => !matches!(own.law, SpringLaw::Linear(_)),
        _ => false,
    };
    let blocks = || draft.model.blocks.iter();
    let what = match () {
        () if !draft.model.contact_pairs.is_empty() => "contact",
        () if blocks().any(remembers) => "a material that yields, creeps or relaxes",
        () if blocks().any(bends) => "springs or gaps that are not linear",
        () => return,
    };
    let message = format!("PERTURBATION of a model with {what} is not supported");
    let error = Diagnostic::error(Code("SL0221"), message).at(span);
    draft.consequence(
        Subject::Steps,
        error.help("leave PERTURBATION out: the step is then solved in full"),
    );
}
