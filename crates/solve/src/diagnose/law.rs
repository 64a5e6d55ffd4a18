//! A friction law of the embedding program whose derivatives are not those of
//! its traction: the only part of the tangent that a user can get wrong.

use super::case::Case;
use slideline_diag::{Code, Diagnostic, Place};
use slideline_mech::contact::enforcement::TangentialComplementarity;
use slideline_mech::contact::pair::UserState;
use slideline_mech::contact::tangential::Tangential;
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
        let pair = plan.pair_of(place);
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
        let mu = now.traction.size() / now.pressure;
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
        let kinematics = &self.work.evaluation.kinematics.points()[place];
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
        let answer = |slip: Tangential, pressure: f64| self.ask(place, slip, pressure);
        let told = answer(slip, now.pressure);
        let step = 1e-6 * (slip.size() + before.elastic_slip.size());
        let directions = 0..self.plan.contact.directions;
        let mut steps = vec![("p", Tangential::ZERO, 1e-6 * now.pressure, told.by_pressure)];
        for direction in directions.clone() {
            let mut unit = Tangential::ZERO;
            unit.0[direction] = 1.0;
            steps.push(("slip", step * unit, 0.0, told.by_value.apply(unit)));
        }
        // by the slip first
        let each = steps.iter().rev().flat_map(|step| directions.clone().map(move |k| (step, k)));
        each.into_iter().find_map(|(&(by, ds, dp, claim), k)| {
            let (h, claim) = (ds.size() + dp, claim[k]);
            let up = (answer(slip + ds, now.pressure + dp).value - told.value)[k] / h;
            let down = (told.value - answer(slip - ds, now.pressure - dp).value)[k] / h;
            let off = (up.min(down) - claim).max(claim - up.max(down));
            let size = claim.abs().max(up.abs()).max(down.abs());
            let found = if (up - claim).abs() < (down - claim).abs() { up } else { down };
            (h > 0.0 && off > WRONG * size).then_some(Slope { by, told: claim, found })
        })
    }

    /// Traction and its derivatives by slip and pressure.
    fn ask(&self, place: usize, slip: Tangential, pressure: f64) -> TangentialComplementarity {
        let point = &self.plan.contact.points[place];
        let laws = &self.plan.contact.laws[point.pair];
        let state_variables = point.state_variables..point.state_variables + point.state_size;
        laws.complementarity_of_traction(
            (Tangential::ZERO, slip, pressure),
            self.committed.points[place].elastic_slip,
            (f64::INFINITY, self.dt),
            &mut UserState {
                time: self.committed.total_time + self.dt,
                committed: &self.committed.state_variables[state_variables],
                state: &mut vec![0.0; point.state_size],
                fault: &mut None,
            },
        )
    }
}
