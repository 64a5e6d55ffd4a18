//! What the law of an interaction means to a pair.

use slideline_model::{Dialect, Formulation, NormalLaw};

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
