//! A friction law of the embedding program whose derivatives are not those of
//! its traction: the only part of the tangent that a user can get wrong.

use super::Case;
use slideline_diag::{Code, Diagnostic, Place};
use slideline_mech::contact::pair::UserState;
use slideline_model::Friction;

/// A disagreement beyond this fraction of the larger slope is a fault.
const WRONG: f64 = 1e-2;

/// What a law says of a derivative, and what differences say.
struct Slope {
    by: &'static str,
    told: f64,
    found: f64,
}

impl Case<'_> {
    /// Asks the law at every closed point of the last iteration.
    pub(super) fn wrong_law(&self) -> Option<Diagnostic> {
        let plan = self.plan;
        let points = plan.contact.points.iter().enumerate();
        let (place, slope) = points
            .filter(|(_, point)| plan.contact.laws[point.pair].user.is_some())
            .find_map(|(place, _)| Some((place, self.wrong_slope(place)?)))?;
        let now = &self.work.evaluation.points[place];
        let point = &plan.contact.points[place];
        let pair = &plan.model.contact_pairs[point.pair];
        let Friction::User { name, .. } = &pair.interaction.friction else { return None };
        let message = format!(
            "the derivatives of the user friction law {name} are not those of its traction, and \
             Newton's method does not converge {}: at node {}, under a pressure of {:.3e}, it \
             gives d tau/d {} = {:.4e}, differences of its tractions give {:.4e}",
            self.beyond(),
            self.label(point.node),
            now.pressure,
            slope.by,
            slope.told,
            slope.found,
        );
        let mu = now.traction.abs() / now.pressure;
        let help = format!(
            "the results up to that time are kept; correct the derivatives in the program that \
             registers the law, or use Coulomb's law with the coefficient it reached: *FRICTION \
             with {mu:.4}"
        );
        let origin = pair.interaction.friction_origin;
        let said = Diagnostic::error(Code("SL0516"), message).at(origin).help(help);
        Some(match origin {
            Some(origin) => said.card(Place::Instead(origin), format!("*FRICTION\n{mu:.6}\n")),
            None => said,
        })
    }

    /// The first derivative that lies outside what differences on both sides
    /// allow.
    fn wrong_slope(&self, place: usize) -> Option<Slope> {
        let now = &self.work.evaluation.points[place];
        let kinematics = &self.work.evaluation.kinematics[place];
        let before = &self.committed.points[place];
        if !now.closed || now.pressure <= 0.0 {
            return None;
        }
        let slip = self.plan.contact.slip(
            place,
            &before.history(),
            kinematics,
            &self.committed.displacement,
        );
        let answer = |slip: f64, pressure: f64| self.ask(place, slip, pressure);
        let (told, by_slip, by_pressure) = answer(slip, now.pressure);
        let steps = [
            ("slip", by_slip, 1e-6 * (slip.abs() + before.elastic_slip.abs()), 0.0),
            ("p", by_pressure, 0.0, 1e-6 * now.pressure),
        ];
        steps.into_iter().find_map(|(by, claim, ds, dp)| {
            let h = ds + dp;
            let up = (answer(slip + ds, now.pressure + dp).0 - told) / h;
            let down = (told - answer(slip - ds, now.pressure - dp).0) / h;
            let off = (up.min(down) - claim).max(claim - up.max(down));
            let size = claim.abs().max(up.abs()).max(down.abs());
            let found = if (up - claim).abs() < (down - claim).abs() { up } else { down };
            (h > 0.0 && off > WRONG * size).then_some(Slope { by, told: claim, found })
        })
    }

    /// Traction and its derivatives by slip and pressure.
    fn ask(&self, place: usize, slip: f64, pressure: f64) -> (f64, f64, f64) {
        let point = &self.plan.contact.points[place];
        let laws = &self.plan.contact.laws[point.pair];
        let state_variables = point.state_variables..point.state_variables + point.state_size;
        let complementarity = laws.complementarity_of_traction(
            [0.0, slip, pressure],
            self.committed.points[place].elastic_slip,
            (f64::INFINITY, self.dt),
            &mut UserState {
                time: self.committed.total_time + self.dt,
                committed: &self.committed.state_variables[state_variables],
                state: &mut vec![0.0; point.state_size],
                fault: &mut None,
            },
        );
        (complementarity.value, complementarity.by_value, complementarity.by_pressure)
    }
}
