//! Contact that no increment allowed catches.

use super::case::Case;
use crate::contact::Missed;
use crate::increments::Verdict;
use slideline_diag::{Code, Diagnostic, Place};

/// Least part of an increment that is asked for in its place.
const LEAST: f64 = 1e-3;
/// Part of a step below which an increment would have caught what increments catch. (choice)
const SHORTEST: f64 = 1e-6;

impl Case<'_> {
    /// An equilibrium was found, but a body went through its master on the way,
    /// and no shorter increment is allowed.
    pub(super) fn passed_through(&self) -> Option<Diagnostic> {
        let missed = self.outcome.missed.as_ref()?;
        Some(match missed.between {
            true => self.between_nodes(missed),
            false => self.through(missed),
        })
    }

    /// An equilibrium was found, but creep changes too fast over the increment, and no shorter one is
    /// allowed.
    pub(super) fn too_coarse(&self) -> Option<Diagnostic> {
        let Verdict::TooCoarse { percent } = self.outcome.verdict else { return None };
        let procedure = &self.plan.step.procedure;
        let times = f64::from(percent) / 100.0;
        let message = format!(
            "creep changes too fast {}: over an increment of {:.4e} the creep strains by the \
             conditions at its two ends differ by {times:.1} times CETOL, and no shorter increment \
             is allowed",
            self.beyond(),
            self.dt
        );
        let said = Diagnostic::error(Code("SL0523"), message).at(procedure.origin).help(format!(
            "the results up to that time are kept; allow increments of {:.2e} on the data line of \
             *VISCO, or a CETOL {times:.1} times as large",
            0.1 * self.dt / times.sqrt()
        ));
        let Some((origin, allowed)) = procedure.origin.zip(procedure.creep_tolerance) else {
            return Some(said);
        };
        let card = format!(
            "*VISCO, CETOL={:.1E}\n{:?}, {:?}, {:?}, {:?}\n",
            1.2 * times * allowed,
            procedure.initial,
            procedure.period,
            procedure.minimum,
            procedure.maximum,
        );
        Some(said.card(Place::Instead(origin), card))
    }

    /// Two rigid masters that press on the same slave points from both sides
    /// overlap: no line fits between them.
    pub(super) fn no_room(&self) -> Option<Diagnostic> {
        let pairs = &self.plan.model.contact_pairs;
        let found = self.plan.contact.without_room(&self.work.u, &self.work.evaluation.points);
        let ([first, second], overlap) = found?;
        let message = format!(
            "the masters of pairs {} and {} overlap by {overlap:.3e} {}: no slave line fits between \
             them",
            pairs[first].name,
            pairs[second].name,
            self.beyond()
        );
        let said = Diagnostic::error(Code("SL0521"), message).at(pairs[second].origin);
        Some(said.help(
            "everything up to that time is kept; contact acts at the centre line of the beam, so \
             leave at least its thickness of room between both masters at the end of the stroke",
        ))
    }

    fn through(&self, missed: &Missed) -> Diagnostic {
        let pair = &self.plan.model.contact_pairs[missed.pair];
        let node = self.label(self.plan.contact.points[missed.points[0]].node);
        let procedure = &self.plan.step.procedure;
        let message = format!(
            "node {node} goes through its master (pair {}) {}: within one increment of {:.4e} it \
             enters it and is behind it, and no shorter increment is allowed",
            pair.name,
            self.beyond(),
            self.dt
        );
        // one that enters at the beginning of its increment needs some increment still
        let needed = 0.1 * missed.fraction.max(LEAST) * self.dt;
        let said = Diagnostic::error(Code("SL0519"), message).at(procedure.origin);
        let (step, reached) = (self.plan.step, self.committed.step_time);
        if step.at_once && reached == 0.0 && !step.prescribed.is_empty() {
            return said.at(step.origin).help(
                "the results up to that time are kept; shorter increments will not mend it: in this step motions without \
                 an amplitude are there at once, in the first increment, however short that is. Let them grow over the \
                 step with *STEP, AMPLITUDE=RAMP, or give *BOUNDARY an *AMPLITUDE that begins at 0",
            );
        }
        if needed < SHORTEST * procedure.period {
            return said.help(format!(
                "the results up to that time are kept; shorter increments will not mend it, these are \
                 short enough. Look at node {node} in the last state: most often a coarse slave comes \
                 off a sharp edge of its master there. Round that edge, or make the slave finer"
            ));
        }
        let said = said.help(format!(
            "the results up to that time are kept; begin *STATIC with an increment of \
             {needed:.2e} and allow smaller ones"
        ));
        match procedure.origin {
            Some(origin) => said.card(
                Place::Instead(origin),
                format!("*STATIC\n{needed:.6E}, {:?}, {:.6E}\n", procedure.period, 1e-3 * needed),
            ),
            None => said,
        }
    }

    fn between_nodes(&self, missed: &Missed) -> Diagnostic {
        let pair = &self.plan.model.contact_pairs[missed.pair];
        let points = missed.points.map(|place| &self.plan.contact.points[place]);
        let [a, b] = points.map(|point| self.plan.model.nodes.position(point.node));
        let [first, second] = points.map(|point| self.label(point.node));
        let distance = (b[0] - a[0]).hypot(b[1] - a[1]);
        let message = format!(
            "the master of pair {} goes through the slave surface between nodes {first} and \
             {second} {}: they are {distance:.3e} apart, too far for its corners and arcs",
            pair.name,
            self.beyond()
        );
        Diagnostic::error(Code("SL0520"), message).at(pair.origin).help(
            "the results up to that time are kept; give the slave surface shorter elements than \
             the narrowest part of the master, or integrate contact along them with *CONTACT \
             PAIR, TYPE=SURFACE TO SURFACE",
        )
    }
}
