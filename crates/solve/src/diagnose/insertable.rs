//! Laws that cannot be inserted: they are no functions of overclosure and slip.

use crate::problem::Problem;
use slideline_diag::{Code, Diagnostic};
use slideline_mech::contact::enforcement::Enforcement;

/// What is said of the first pair whose laws the prescribed enforcement cannot insert.
pub fn not_insertable(plan: &Problem<'_>) -> Option<Diagnostic> {
    if plan.enforcement != Some(Enforcement::Penalty) {
        return None;
    }
    let place = plan.contact.laws.iter().position(|laws| !laws.are_functions())?;
    let pair = &plan.model.contact_pairs[place];
    let is_hard = plan.contact.laws[place].normal.pressure(0.0).is_none();
    let (what, origin, other) = match is_hard {
        true => (
            "hard contact has no pressure that follows from an overclosure",
            pair.interaction.normal_origin,
            "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR with a stiffness",
        ),
        false => (
            "exact stick has no traction that follows from a slip",
            pair.interaction.friction_origin,
            "*FRICTION without LAGRANGE and without ROUGH",
        ),
    };
    let message = format!(
        "contact cannot be enforced by penalty at pair {}: {what}, and a stiffness of the program's \
         own would change the result",
        pair.name
    );
    let help = format!(
        "prescribe the enforcement augmented, which keeps the law, or none, so that the size of \
         the problem decides; or give the deck a law that is a function: {other}"
    );
    Some(Diagnostic::error(Code("SL0422"), message).at(origin.or(Some(pair.origin))).help(help))
}
