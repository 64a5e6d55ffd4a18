//! Causes that lie in contact.

use super::case::{Case, second_coefficient, step_card};
use super::ends::master_end;
use crate::constraints::Role;
use crate::linearised::Contradiction;
use crate::newton::Jammed;
use slideline_diag::{Code, Diagnostic, Place};
use slideline_model::{ContactPair, Friction, StickRule};

/// Part of the coefficient of friction that jams: below it parts meet head on. (choice)
const HEAD_ON: f64 = 0.2;

impl Case<'_> {
    fn pair_of(&self, place: usize) -> &ContactPair {
        self.plan.pair_of(place)
    }

    /// Hard points that cannot all close.
    pub(super) fn overconstrained(&self) -> Option<Diagnostic> {
        let (found, why) = match self.work.told_apart(self.plan, self.committed) {
            Some(found) => (found, "neither they nor their master can move"),
            None => (
                self.work.contradiction(self.plan, self.committed, self.dt)?,
                "opening one of them closes another",
            ),
        };
        let Contradiction { places, left } = found;
        let pair = self.pair_of(*places.first()?);
        let message = format!(
            "hard contact of {} is contradictory {}: {} would have to close, but {why}; an \
             overclosure of {left:.3e} remains",
            pair.name,
            self.beyond(),
            self.nodes(&places),
        );
        let said = Diagnostic::error(Code("SL0514"), message).at(pair.interaction.origin);
        Some(self.soften(said, pair))
    }

    /// The clearance of a softer law: ten times what there is, or a small part of an element [L].
    fn softer_clearance(&self, pair: &ContactPair) -> f64 {
        let begins = -pair.interaction.normal.contact_begins();
        match begins > 0.0 && begins.is_finite() {
            true => 10.0 * begins,
            false => 0.02 * self.plan.contact_length(pair),
        }
    }

    /// Suggests an exponential law, or one of ten times the clearance.
    fn soften(&self, said: Diagnostic, pair: &ContactPair) -> Diagnostic {
        let interaction = &pair.interaction;
        let clearance = self.softer_clearance(pair);
        let pressure = self.pressure_scale(pair);
        let card = pair.vocabulary.softened_card(clearance, pressure);
        let help = format!(
            "the results up to that time are kept; soften the contact: {} with a clearance of \
             {clearance:.3E} and a pressure of {pressure:.3E}",
            pair.vocabulary.softened()
        );
        let place = match interaction.normal_origin {
            Some(law) => Place::Instead(law),
            None => Place::After(interaction.origin),
        };
        said.help(help).card(place, card)
    }

    /// The largest pressure that points of the pair have carried, or a
    /// thousandth of the largest modulus [F/L2].
    fn pressure_scale(&self, pair: &ContactPair) -> f64 {
        let model = self.plan.model;
        let own = |place: &usize| std::ptr::eq(self.plan.pair_of(*place), pair);
        let carried = (0..self.committed.points.len())
            .filter(own)
            .map(|place| self.committed.points[place].pressure)
            .fold(0.0, f64::max);
        if carried > 0.0 && carried.is_finite() {
            return carried;
        }
        let materials = model.blocks.iter().filter_map(|block| block.section.elastic());
        let modulus = materials.map(|material| material.modulus).fold(0.0, f64::max);
        if modulus > 0.0 { 1e-3 * modulus } else { 1.0 }
    }

    /// Points at which more pressure brings more friction than it opens.
    pub(super) fn jam(&self) -> Option<Diagnostic> {
        self.jam_of(&self.work.jammed(self.plan, self.committed))
    }

    /// The same where the points are known already.
    pub(super) fn jam_of(&self, jammed: &[Jammed]) -> Option<Diagnostic> {
        let pair = self.pair_of(jammed.first()?.place);
        let places: Vec<usize> = jammed.iter().map(|jammed| jammed.place).collect();
        let from = jammed.iter().map(|jammed| jammed.from).fold(f64::INFINITY, f64::min);
        let origin = pair.interaction.friction_origin;
        let [_, given] = pair.interaction.friction.coefficients();
        let is_head_on = from < HEAD_ON * given;
        let why = match is_head_on {
            true => {
                "there the parts meet head on, and a higher contact pressure does not open the \
                     contact"
                    .to_owned()
            }
            false => format!(
                "there a higher contact pressure adds more friction than it opens the contact, as it \
                 does from a coefficient of {from:.3} on"
            ),
        };
        let message = format!(
            "the contact jams at {} {}: {why}, so no force moves it on{}",
            self.nodes(&places),
            self.beyond(),
            self.force_reached()
        );
        let said =
            Diagnostic::error(Code("SL0506"), message).at(origin.unwrap_or(self.plan.step.origin));
        if is_head_on {
            return Some(said.help(
                "the results up to that time are kept; hardly any friction would let the parts pass, \
                 as at an upright wall: make the slope at which they meet flatter, or push from \
                 another side",
            ));
        }
        let said = said.help(
            "the results up to that time are kept; lower the coefficient of *FRICTION or the slope \
             at which the parts meet (mu tan a must stay below 1), or push from another side",
        );
        let card = lower_friction(&pair.interaction.friction, from);
        Some(match origin.zip(card) {
            Some((origin, card)) => said.card(Place::Instead(origin), card),
            None => said,
        })
    }

    /// The largest force of a support that moved in the last increment: how far
    /// a part that locks was pulled.
    fn force_reached(&self) -> String {
        let (plan, committed) = (self.plan, self.committed);
        let drives = |dof: &usize| {
            matches!(plan.constraints.roles[*dof], Role::Prescribed(_))
                && committed.increment[*dof] != 0.0
                && !plan.dofs.is_rotation(*dof)
        };
        let size = |dof: usize| committed.reaction[dof].abs();
        let largest =
            (0..plan.dofs.len()).filter(drives).max_by(|&a, &b| size(a).total_cmp(&size(b)));
        largest.map_or(String::new(), |dof| {
            let force = committed.reaction[dof];
            let (node, dof) = plan.dofs.name(dof);
            format!(
                "; the force reached at node {}, {}, is {force:.4e}",
                self.label(node),
                dof.name()
            )
        })
    }

    /// Points that went on opening and closing.
    pub(super) fn chattering(&self) -> Option<Diagnostic> {
        let iteration_history = &self.work.iteration_history;
        let places = iteration_history.chattering();
        let worst = *places.first()?;
        let pair = self.pair_of(worst);
        let point = &iteration_history.points[worst];
        let message = format!(
            "contact of {} chatters at {} {}: {} opened or closed in {} of the last {} \
             iterations, in the last one from {} to {}",
            pair.name,
            self.nodes(&places),
            self.beyond(),
            self.nodes(&places[..1]),
            point.changes(),
            iteration_history.window(),
            stands(point.overclosure.1),
            stands(point.overclosure.0),
        );
        let said = Diagnostic::error(Code("SL0513"), message);
        if point.overclosure.0.min(point.overclosure.1) == f64::NEG_INFINITY {
            // It goes to and fro over an end of its master.
            let along = self.work.evaluation.kinematics.points()[worst].along;
            let end = master_end(self.plan, pair, along[0]);
            let said = said.at(end.origin).help(end.remedy);
            return Some(match end.card {
                Some((place, card)) => said.card(place, card),
                None => said,
            });
        }
        let said = said.at(pair.interaction.origin);
        let swings = (point.overclosure.0 - point.overclosure.1).abs();
        Some(if self.plan.symmetrised() {
            self.steady(said, pair)
        } else if swings > self.softer_clearance(pair) {
            said.help(
                "the results up to that time are kept; the point goes to and fro by more than a softer \
                 law would reach, between parts of its master whose normals differ: round the corner \
                 there (FILLET RADIUS, SMOOTH, an arc), refine the slave, or use shorter increments",
            )
        } else {
            self.soften(said, pair)
        })
    }

    /// Closed points that went on changing between stick and slip, or the way
    /// they slide.
    pub(super) fn stick_slip_cycling(&self) -> Option<Diagnostic> {
        let iteration_history = &self.work.iteration_history;
        let places = iteration_history.stick_slip_cycling();
        let worst = *places.first()?;
        let pair = self.pair_of(worst);
        let point = &iteration_history.points[worst];
        let message = format!(
            "friction of {} cycles at {} {}: {} changed between stick and slip or its direction \
             in {} of the last {} iterations, at a traction of up to {:.3e} under a pressure of \
             {:.3e}",
            pair.name,
            self.nodes(&places),
            self.beyond(),
            self.nodes(&places[..1]),
            point.flips(),
            iteration_history.window(),
            point.dragged.0,
            point.dragged.1,
        );
        let origin = pair.interaction.friction_origin;
        let said = Diagnostic::error(Code("SL0515"), message).at(origin);
        Some(self.steady(said, pair))
    }

    /// The card that steadies friction: the whole tangent, or elastic slip.
    fn steady(&self, said: Diagnostic, pair: &ContactPair) -> Diagnostic {
        let step = self.plan.step;
        if self.plan.symmetrised() {
            return said
                .help(
                    "the results up to that time are kept; UNSYMM=NO uses the friction limit of \
                     the previous iteration: give UNSYMM=YES on *STEP",
                )
                .card(
                    Place::Instead(step.origin),
                    step_card(step, Some(true), step.max_increments),
                );
        }
        let slip = 0.02 * self.plan.contact_length(pair);
        if pair.interaction.friction.elastic_slip().is_some_and(|given| given >= 0.5 * slip) {
            return said.help(
                "the results up to that time are kept; points move before they slide already (ELASTIC \
                 SLIP), and that does not steady it: name the other side first on *CONTACT PAIR, let \
                 contact be at the nodes (TYPE=NODE TO SURFACE), round the corner that passes there, \
                 or use other increments",
            );
        }
        let help = format!(
            "the results up to that time are kept; let points move a little before they slide: \
             *FRICTION, ELASTIC SLIP={slip:.3E}"
        );
        match (&pair.interaction.friction, pair.interaction.friction_origin) {
            (friction @ Friction::Coulomb { second, .. }, Some(origin)) => {
                let [_, mu] = friction.coefficients();
                let (axes, more) = second_coefficient(*second);
                let card = format!("*FRICTION, ELASTIC SLIP={slip:.3E}{axes}\n{mu}{more}\n");
                said.help(help).card(Place::Instead(origin), card)
            }
            _ => said.help(help),
        }
    }
}

/// Coulomb's law with half the coefficient, or less where it would jam still.
fn lower_friction(friction: &Friction, from: f64) -> Option<String> {
    let Friction::Coulomb { coefficient, second, stick, decay, .. } = friction else { return None };
    let exact = if *stick == StickRule::Lagrange { ", LAGRANGE" } else { "" };
    let share = 0.5_f64.min(0.8 * from / coefficient);
    let (decays, further) = decay.map_or_else(Default::default, |decay| {
        let kinetic = share * decay.kinetic;
        (", EXPONENTIAL DECAY", format!(", {kinetic:.4}, {:E}", decay.rate))
    });
    let (axes, more) = second_coefficient(second.map(|second| share * second));
    let lower = share * coefficient;
    Some(format!("*FRICTION{exact}{decays}{axes}\n{lower:.4}{more}{further}\n"))
}

/// An overclosure in words.
fn stands(overclosure: f64) -> String {
    match overclosure {
        none if none == f64::NEG_INFINITY => "no master in front of it".to_string(),
        gap if gap < 0.0 => format!("a gap of {:.3e}", -gap),
        deep => format!("an overclosure of {deep:.3e}"),
    }
}
