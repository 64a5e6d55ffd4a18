//! The contact of a step: pairs that are absent have nothing to slide on, and friction and
//! pressure may follow other laws than those of the model.
//!
//! ```text
//!   mu |  step 1   step 2   step 3
//!      |  ______            ______     a change leads over the step,
//!      |        \__________/           and stays
//! ```

use super::before::Before;
use super::interference::allowed_in;
use super::kinematics::ContactKinematics;
use super::laws::{friction, mean_length, normal};
use super::master::MasterSurface;
use super::pairs::Contact;
use super::positions::MasterPositions;
use crate::state::{PointState, State};
use slideline_mech::contact::friction::{Decay, Ellipse, FrictionLaw};
use slideline_model::{Dialect, Model, Step};
use std::borrow::Cow;

/// Energy of contact that is let go [F L].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Released {
    /// That of the normal laws.
    pub laws: f64,
    /// That of elastic slip.
    pub slip: f64,
}

impl Contact {
    /// The contact of a step of a model with so many dofs.
    pub fn of_step(&self, (model, dofs): (&Model, usize), place: usize) -> Cow<'_, Self> {
        let step = &model.steps[place];
        let presence = &step.presence;
        let is_whole = presence.absent_pairs.is_empty();
        let same_laws = step.frictions.is_empty() && step.pressures.is_empty();
        if is_whole && same_laws && allowed_in(model, place).is_empty() {
            return Cow::Borrowed(self);
        }
        let mut own = self.clone();
        own.change_pressure(model, step);
        own.change_friction(model, step);
        own.take_bonds();
        own.take_interferences((model, dofs), place);
        for (pair, _) in self.masters.iter().enumerate() {
            if !presence.has_pair(self.parent(pair)) {
                own.masters[pair] = MasterSurface::Nothing;
            }
        }
        for crossings in &mut own.crossings {
            crossings.is_absent = !presence.has_pair(crossings.of);
        }
        own.opposed.retain(|pairs| pairs.iter().all(|&pair| presence.has_pair(pair)));
        own.chain_nodes = 0;
        for master in &mut own.masters {
            if let MasterSurface::Line { offset, .. } | MasterSurface::Faces { offset, .. } = master
            {
                *offset = own.chain_nodes;
            }
            own.chain_nodes += master.nodes().len();
        }
        Cow::Owned(own)
    }

    /// Pressure laws are there at once.
    fn change_pressure(&mut self, model: &Model, step: &Step) {
        for changed in &step.pressures {
            let pair = &model.contact_pairs[changed.pair];
            let law = normal((model, pair), &changed.normal, mean_length(model, pair));
            self.laws[changed.pair].normal = law.into_owned();
            self.keeps[changed.pair] = changed.no_separation;
            for own in self.edges_of(changed.pair) {
                self.keeps[own] = changed.no_separation;
                self.laws[own].normal = self.laws[changed.pair].normal.clone();
            }
        }
    }

    /// Where friction leads from one law to another, both count until [`Contact::at`] has the time:
    /// the one that acts, if one does.
    fn change_friction(&mut self, model: &Model, step: &Step) {
        let at_once = step.at_once || model.dialect == Dialect::Calculix;
        for changed in &step.frictions {
            let pair = &model.contact_pairs[changed.pair];
            let length = mean_length(model, pair);
            let [from, to] =
                [&changed.from, &changed.to].map(|law| friction((model, pair, law), length));
            for own in std::iter::once(changed.pair).chain(self.edges_of(changed.pair)) {
                let laws = &mut self.laws[own];
                if at_once || from == to || !is_between(&from, &to) {
                    laws.friction = to.clone();
                    continue;
                }
                laws.friction = if to == FrictionLaw::None { from.clone() } else { to.clone() };
                self.changing.push((own, [from.clone(), to.clone()]));
            }
        }
    }

    /// The same at the end of an increment between two times of the step, of that length [T], where
    /// that makes a difference.
    pub fn at(&self, times: (f64, f64), period: f64) -> Option<Self> {
        if self.changing.is_empty() && self.allowances.is_empty() {
            return None;
        }
        let mut own = self.clone();
        for (pair, laws) in std::mem::take(&mut own.changing) {
            own.laws[pair].friction = between(laws, (times.1 / period).clamp(0.0, 1.0));
        }
        own.take_bonds();
        if !own.allowances.is_empty() {
            own.allow(times, period);
        }
        Some(own)
    }

    /// Adds `factor` times the forces of the points of some pairs in a committed state [F], and
    /// lets these points forget what they did; the energy that they held.
    pub fn release(
        &self,
        pairs: &[usize],
        (state, factor): (&mut State, f64),
        force: &mut [f64],
    ) -> Released {
        let mut held = Released::default();
        if pairs.is_empty() {
            return held;
        }
        let (mut positions, mut kinematics) = (MasterPositions::default(), self.nowhere());
        let at = (&state.displacement[..], Before::of(state));
        self.locate(at, &[], &mut positions, &mut kinematics);
        for (place, point) in self.points.iter().enumerate() {
            if pairs.contains(&self.parent(point.pair)) {
                let own = self.push_out(place, (state, factor), &kinematics, force);
                held.laws += own.laws;
                held.slip += own.slip;
                let own = point.state_variables..point.state_variables + point.state_size;
                state.state_variables[own].fill(0.0);
                state.points[place] = PointState::default();
            }
        }
        held
    }

    fn push_out(
        &self,
        place: usize,
        (state, factor): (&State, f64),
        kinematics: &ContactKinematics,
        force: &mut [f64],
    ) -> Released {
        let now = &state.points[place];
        if !now.closed {
            return Released::default();
        }
        let tangential = now.area * now.traction;
        let normal = now.area * now.pressure;
        kinematics.at(place).push(factor * normal, factor * tangential, force);
        let law = &self.laws_of(self.points[place].pair, now).normal;
        let laws = now.area * law.energy(-now.opening);
        Released { laws, slip: 0.5 * tangential.dot(now.elastic_slip) }
    }
}

/// Whether one law leads to another by its coefficients: Coulomb's to Coulomb's, with the same way of
/// sticking and either a limit or none, or to none at all.
fn is_between(from: &FrictionLaw, to: &FrictionLaw) -> bool {
    use FrictionLaw::{Coulomb, None};
    match (from, to) {
        (None, Coulomb { .. }) | (Coulomb { .. }, None) => true,
        (Coulomb { stick, limit, .. }, Coulomb { stick: other, limit: end, .. }) => {
            stick == other && limit.is_some() == end.is_some()
        }
        _ => false,
    }
}

/// The law at a part of the way.
fn between([from, to]: [FrictionLaw; 2], part: f64) -> FrictionLaw {
    use FrictionLaw::{Coulomb, None};
    if part >= 1.0 {
        return to;
    }
    let mean = |a: f64, b: f64| a + part * (b - a);
    match (from, to) {
        (None, Coulomb { coefficient, ellipse, limit, decay, stick }) => {
            let decay = decay.map(|own| Decay { kinetic: part * own.kinetic, ..own });
            Coulomb { coefficient: part * coefficient, ellipse, limit, decay, stick }
        }
        (Coulomb { coefficient, ellipse, limit, decay, stick }, None) => {
            let left = 1.0 - part;
            let decay = decay.map(|own| Decay { kinetic: left * own.kinetic, ..own });
            Coulomb { coefficient: left * coefficient, ellipse, limit, decay, stick }
        }
        (
            Coulomb { coefficient: a, ellipse: one, limit: first, decay: fading, stick },
            Coulomb { coefficient: b, ellipse: two, limit: last, decay: other, .. },
        ) => {
            let still = |mu: f64, rate: f64| Decay { kinetic: mu, rate };
            let decays = match (fading, other) {
                (Option::None, Option::None) => Option::None,
                (Some(one), Option::None) => Some((one, still(b, one.rate))),
                (Option::None, Some(two)) => Some((still(a, two.rate), two)),
                (Some(one), Some(two)) => Some((one, two)),
            };
            let decay = decays.map(|(one, two)| Decay {
                kinetic: mean(one.kinetic, two.kinetic),
                rate: mean(one.rate, two.rate),
            });
            let limit = first.zip(last).map(|(first, last)| mean(first, last));
            let (coefficient, ellipse) = match one == two {
                true => (mean(a, b), one),
                false => {
                    let [one, two] = [one.coefficients(a), two.coefficients(b)];
                    Ellipse::of([mean(one[0], two[0]), mean(one[1], two[1])])
                }
            };
            Coulomb { coefficient, ellipse, limit, decay, stick }
        }
        (_, to) => to,
    }
}
