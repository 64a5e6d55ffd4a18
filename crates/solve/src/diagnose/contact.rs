//! Causes that lie in contact.

use super::case::{Case, second_coefficient, step_card};
use crate::constraints::Role;
use crate::linearised::Contradiction;
use crate::newton::{Jammed, TOUCH};
use crate::problem::Problem;
use crate::state::State;
use slideline_diag::{Code, Diagnostic, Place, Severity};
use slideline_model::{
    ContactPair, Friction, Master, Model, NodeIndex, RigidSurface, SlideLine, StickRule,
    SurfaceSegment, Vocabulary,
};

/// Part of the coefficient of friction that jams: below it parts meet head on. (choice)
const HEAD_ON: f64 = 0.2;

impl Case<'_> {
    fn pair_of(&self, place: usize) -> &ContactPair {
        self.plan.pair_of(place)
    }

    /// Hard points that cannot all close.
    pub(super) fn overconstrained(&self) -> Option<Diagnostic> {
        let (found, why) = match self.work.told_apart(self.plan) {
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

    /// The run ends where a point has slid off the end of its master.
    pub(super) fn off_the_end(&self) -> Option<Diagnostic> {
        let now = State {
            points: self.work.evaluation.points.clone(),
            displacement: self.work.u.clone(),
            total_time: self.committed.total_time + self.dt,
            ..State::default()
        };
        let (_, last) = slid_off(self.plan, self.committed, &now).pop()?;
        Some(Diagnostic { severity: Severity::Error, ..last })
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

/// Points that carried pressure at the last commit, now face no master, and
/// would touch it were its end prolonged: they have slid off. A word a node, with its pair.
pub fn slid_off(plan: &Problem<'_>, committed: &State, now: &State) -> Vec<(usize, Diagnostic)> {
    // Hard contact touches with a gap of nothing but rounding.
    let slack = TOUCH * plan.reach;
    let mut left = Vec::new();
    let mut last = None;
    for (place, point) in plan.contact.points.iter().enumerate() {
        let before = &committed.points[place];
        let gone = before.closed
            && !plan.contact.is_edge(place)
            && now.points[place].along.is_none()
            && last != Some((point.pair, point.node))
            && plan.contact.has_slid_off(place, (before.xi, slack), &now.displacement);
        if !gone {
            continue;
        }
        last = Some((point.pair, point.node));
        let pair = plan.pair_of(place);
        let label = plan.model.nodes.name(point.node);
        let end = master_end(plan, pair, before.along.unwrap_or_default()[0]);
        let message = format!(
            "node {label} has slid off the end of {} between total time {:.6} and {:.6}",
            end.what, committed.total_time, now.total_time
        );
        let mut said = Diagnostic::warning(Code("SL0504"), message).at(end.origin).help(end.remedy);
        if let Some((place, card)) = end.card {
            said = said.card(place, card);
        }
        left.push((point.pair, said));
    }
    left
}

/// The end of a master, and how it is prolonged.
struct End {
    what: &'static str,
    remedy: String,
    origin: slideline_diag::Span,
    card: Option<(Place, String)>,
}

/// The end of the master of a pair that is nearer to a place on it.
fn master_end(plan: &Problem<'_>, pair: &ContactPair, along: f64) -> End {
    match &pair.master {
        Master::SlideLine(line) => line_end(plan.model, line, pair, along),
        Master::RigidSurface(surface) => surface_end(surface, pair, along),
        Master::Itself(surface) => End {
            what: "the surface",
            remedy: "name the faces beyond its end in *SURFACE too".to_owned(),
            origin: surface.origin,
            card: None,
        },
        Master::Faces(faces) => End {
            what: "the surface",
            remedy: "name the faces beyond its edge in *SURFACE too, or prolong it with EXTENSION \
                     ZONE"
                .to_owned(),
            origin: faces.origin,
            card: None,
        },
    }
}

/// The beam's own nodes beyond the end prolong a slide line; where there are
/// none, its longest extension zone does.
fn line_end(model: &Model, line: &SlideLine, pair: &ContactPair, along: f64) -> End {
    let at = |node: NodeIndex| model.nodes.get(node).position;
    let sides = line.nodes.windows(2).map(|w| {
        let (a, b) = (at(w[0]), at(w[1]));
        (b[0] - a[0]).hypot(b[1] - a[1])
    });
    let in_front = along < 0.5 * sides.sum::<f64>();
    let mut nodes = line.nodes.clone();
    if in_front {
        nodes.reverse();
    }
    while let Some(next) = nodes.last().and_then(|&end| neighbour(model, end, &nodes)) {
        nodes.push(next);
    }
    let extension = if nodes.len() > line.nodes.len() { line.extension } else { 0.2 };
    if in_front {
        nodes.reverse();
    }
    let known = nodes.len() == line.nodes.len() && line.extension >= extension;
    let card = (!known && pair.vocabulary == Vocabulary::Elements).then(|| {
        let head = format!("*SLIDE LINE, TYPE=LINEAR, ELSET={}", pair.name);
        let mut text = format!("{head}, SMOOTH={}, EXTENSION ZONE={extension}\n", line.smooth);
        let labels: Vec<String> = nodes.iter().map(|&n| model.nodes.name(n).to_string()).collect();
        for row in labels.chunks(16) {
            text.push_str(&row.join(", "));
            text.push('\n');
        }
        (Place::Instead(line.origin), text)
    });
    let lengthen = pair.vocabulary.lengthen_chain();
    let remedy = format!("{lengthen}, or extend its ends with EXTENSION ZONE");
    End { what: "the slide line", remedy, origin: line.origin, card }
}

/// The other end of a beam at a node that is not among the nodes known.
fn neighbour(model: &Model, end: NodeIndex, known: &[NodeIndex]) -> Option<NodeIndex> {
    let beams = model.blocks.iter().filter_map(|block| block.beams());
    let mut elements = beams.flat_map(|block| block.elements);
    elements.find_map(|beam| {
        let [a, b] = beam.ends();
        let other = if a == end { b } else { a };
        ((a == end || b == end) && !known.contains(&other)).then_some(other)
    })
}

/// One more data line prolongs a rigid surface by twice its length.
fn surface_end(surface: &RigidSurface, pair: &ContactPair, along: f64) -> End {
    let remedy = format!("extend {} beyond the stroke", pair.vocabulary.rigid_surface());
    let end = End { what: "the rigid surface", remedy, origin: surface.origin, card: None };
    let mut from = surface.start;
    let mut length = 0.0;
    let mut last = None;
    for segment in &surface.segments {
        let to = match *segment {
            SurfaceSegment::Line { end } => {
                last = Some((from, end));
                end
            }
            SurfaceSegment::Circle { end, .. } | SurfaceSegment::Parabola { end, .. } => {
                last = None;
                end
            }
        };
        length += (to[0] - from[0]).hypot(to[1] - from[1]);
        from = to;
    }
    let Some((a, b)) = last else { return end };
    if along < 0.5 * length {
        return end; // it left at the start, where no data line can be added
    }
    let size = (b[0] - a[0]).hypot(b[1] - a[1]);
    let [x, y] = [0, 1].map(|k| b[k] + (b[k] - a[k]) / size * 2.0 * length);
    End { card: Some((Place::After(surface.origin), format!("LINE, {x:.6E}, {y:.6E}\n"))), ..end }
}
