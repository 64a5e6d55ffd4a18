//! What the law of an interaction means to a pair.

use slideline_diag::{Code, Diagnostic};
use slideline_model::{Dialect, Formulation, Interaction, NormalLaw};

use crate::draft::Draft;
use crate::rule::Subject;
use crate::surfaces::Pairing;

/// The pressure law of a pair. In CalculiX a linear law of contact between faces presses alone,
/// whatever pull its second number names (measured with ccx 2.20, docs/benchmarks.md).
pub(super) fn as_read(formulation: Formulation, law: &NormalLaw, dialect: Dialect) -> NormalLaw {
    match *law {
        NormalLaw::CalculixLinear { stiffness, .. }
            if dialect == Dialect::Calculix && formulation != Formulation::NodeToSurface =>
        {
            NormalLaw::Linear { stiffness }
        }
        _ => law.clone(),
    }
}

/// Complains where contact that is integrated along beams is not to separate.
pub(super) fn refuse_bonds(
    pairing: &Pairing,
    (formulation, interaction): (Formulation, &Interaction),
    draft: &mut Draft,
) {
    if formulation == Formulation::SurfaceToSurface && interaction.no_separation {
        let message = "NO SEPARATION of contact that is integrated along beams is not supported";
        let error = Diagnostic::error(Code("SL0221"), message).at(pairing.origin);
        draft.consequence(Subject::Contact, error.help("give TYPE=NODE TO SURFACE"));
    }
}
