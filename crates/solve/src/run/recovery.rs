//! What is tried before a run gives up, and what is said when it does.
//!
//! ```text
//!   attempt fails --> body held by open contact alone? stabilise, again
//!                 --> shorter increments (the increment control)
//!                 --> used up: the cause is found, then once more with a
//!                     line search --> state of the last attempt, diagnosis
//! ```

use super::analysis::{Analysis, Left};
use super::shown::{Numbers, frame};
use crate::commit::commit;
use crate::contact::{EdgeInside, Found};
use crate::diagnose::{self, Case};
use crate::increments::{StopReason, Verdict};
use crate::newton::{Outcome, Scratch, attempt, relax};
use crate::observe::{Event, Unconverged};
use crate::problem::Problem;
use crate::restraint::Restraint;
use crate::stabilise;
use crate::state::State;
use crate::target::Target;
use slideline_diag::{Code, Diagnostic};
use slideline_linalg::SolveError;
use slideline_model::NodeIndex;

/// Energy of stabilisation, as a part of all energy, from which on it is told.
const MUCH: f64 = 0.05;

/// The attempt at an increment from which on what is not held is taken for the cause: shorter ones did not help.
const LATER: usize = 2;

/// The same of a body that nothing presses yet: gaps that an increment closes exactly take a shorter one or two.
const MUCH_LATER: usize = 5;

/// What is said of a body that nothing presses yet.
const UNPRESSED: &str = "is supported only by contact that is open or presses nothing yet";

/// Turn of a motion, over the size of the model, from which on a body turns, and part of it along an axis that counts [1].
const TURNS: f64 = 1e-3;

impl Analysis<'_> {
    /// Stabilises contact where a body that only open contact would hold has made the tangent singular, or where what
    /// presses leaves a body a motion, and no shorter increment helped; says whether it did.
    pub(super) fn stabilise(
        &mut self,
        plan: &Problem<'_>,
        (target, outcome): (&Target, &Outcome),
        work: &Scratch,
    ) -> Result<bool, Left> {
        if stabilise::settings(plan, self.committed).is_some() {
            return Ok(false);
        }
        let found = match outcome.fault {
            Some(SolveError::Singular { equation, .. }) => self.loose(plan, equation, work),
            None if target.attempt >= LATER
                && !matches!(outcome.verdict, Verdict::Converged { .. }) =>
            {
                self.unopposed(plan, target, work)
            }
            _ => None,
        };
        let Some((node, what)) = found else { return Ok(false) };
        self.committed.stabilised = true;
        let message = format!(
            "the body of node {} {what}: contact is stabilised from total time {:.6} on, by tractions that fade to zero \
             at the end of the step",
            plan.model.nodes.name(node),
            self.committed.total_time
        );
        let said = Diagnostic::warning(Code("SL0517"), message)
            .at(plan.model.nodes.get(node).origin)
            .help(
                "no action is needed; *CONTACT CONTROLS, STABILIZE=factor in the step sets its \
                 strength; with *BOUNDARY or a *SPRING on the body it is not needed",
            );
        self.tell(Event::Diagnosed(&said))?;
        Ok(true)
    }

    /// A body that only open contact would hold, given the equation at which the tangent is singular.
    fn loose(
        &self,
        plan: &Problem<'_>,
        equation: usize,
        work: &Scratch,
    ) -> Option<(NodeIndex, String)> {
        let mode = work.null_mode(plan, equation)?;
        if !stabilise::would_hold(plan, self.committed, &mode) {
            return None;
        }
        let (node, _) = plan.dofs.name(plan.constraints.dof_of_equation[equation]);
        let heaviest = work.moves_most(plan, &mode).unwrap_or(node);
        let is_held = Restraint::of(plan.model, plan.step).holds(heaviest);
        (!is_held).then(|| (node, UNPRESSED.to_owned()))
    }

    /// A body to which contact without friction leaves a motion.
    fn unopposed(
        &self,
        plan: &Problem<'_>,
        target: &Target,
        work: &Scratch,
    ) -> Option<(NodeIndex, String)> {
        let found = stabilise::unopposed(plan, self.committed, &work.evaluation.points)?;
        let (motion, is_pressed) = (found.motion, found.is_pressed);
        if !is_pressed {
            let is_late = target.attempt >= MUCH_LATER;
            return is_late.then(|| (motion.node, UNPRESSED.to_owned()));
        }
        let turns = plan.reach * motion.turn.iter().fold(0.0_f64, |sum, x| sum.hypot(*x)) > TURNS;
        // no minus before nothing
        let [x, y, z] = motion.way.map(|own| if own.abs() < TURNS { 0.0 } else { own });
        let how = match (turns, plan.model.is_in_space()) {
            (true, _) => "turn".to_owned(),
            (false, true) => format!("slide along ({x:.3}, {y:.3}, {z:.3})"),
            (false, false) => format!("slide along ({x:.3}, {y:.3})"),
        };
        Some((
            motion.node,
            format!("can {how}, which neither supports nor contact without friction oppose"),
        ))
    }

    /// Says so where stabilisation took much of the energy until now.
    pub(super) fn judge_stabilisation(&mut self, plan: &Problem<'_>) -> Result<(), Left> {
        let energy = &self.committed.energy;
        let stored = energy.of_the_model() + energy.friction_dissipation;
        // what heat adds and free motions take back goes through the run too
        let all = energy.external_work.abs().max(stored) + self.committed.books.heat;
        if energy.stabilisation.abs() <= MUCH * all {
            return Ok(());
        }
        let message = format!(
            "contact stabilisation has dissipated {:.3e}, {:.0} % of the energy of the run: \
             increments before the end of the step are damped, the end of the step is not",
            energy.stabilisation,
            100.0 * energy.stabilisation / all
        );
        let origin = stabilise::settings(plan, self.committed).map(|settings| settings.origin);
        let said = Diagnostic::warning(Code("SL0618"), message)
            .at(origin)
            .help("if the path matters, lower it: *CONTACT CONTROLS, STABILIZE=0.1");
        self.tell(Event::Diagnosed(&said))
    }

    /// Says so once where two rigid masters of the same slaves overlap.
    pub(super) fn judge_room(&mut self, plan: &Problem<'_>) -> Result<(), Left> {
        if self.room_is_judged {
            return Ok(());
        }
        let committed = &*self.committed;
        let found = plan.contact.without_room(&committed.displacement, &committed.points);
        let Some(([first, second], overlap)) = found else { return Ok(()) };
        self.room_is_judged = true;
        let pairs = &plan.model.contact_pairs;
        let message = format!(
            "the masters of pairs {} and {} overlap by {overlap:.3e} at total time {:.6}: where the \
             slave line lies between them it goes through one of them",
            pairs[first].name, pairs[second].name, committed.total_time
        );
        let said = Diagnostic::warning(Code("SL0619"), message).at(pairs[second].origin).help(
            "check the results there; leave at least the thickness of the beam between both masters \
             at the end of the stroke",
        );
        self.tell(Event::Diagnosed(&said))
    }

    /// Says so once where an edge or a node of a master stands in a face between slave nodes.
    pub(super) fn judge_edges(&mut self, plan: &Problem<'_>, work: &Scratch) -> Result<(), Left> {
        if self.edges_are_judged {
            return Ok(());
        }
        let committed = &*self.committed;
        let u = &committed.displacement;
        let found = plan.contact.edge_inside(u, &committed.points);
        let found = found.or_else(|| {
            let (positions, room) = (work.evaluation.positions(), &mut self.rows.heaviest.room);
            plan.contact.surface_inside((u, &committed.points), positions, room)
        });
        // nodes of the slave in the master have told the same
        let look = !self.strayed_are_told;
        let inside = || look.then(|| plan.contact.master_inside(plan, committed)).flatten();
        let found = found.or_else(inside);
        let Some(found) = found else { return Ok(()) };
        self.edges_are_judged = true;
        let said = edge_inside(plan, &found, committed.total_time);
        self.tell(Event::Diagnosed(&said))
    }

    /// The last attempts at an increment that no shorter one replaces: with a
    /// line search, then, where contact acts and no cause forbids it, downhill to
    /// another equilibrium. Where contact leaves the pattern they are to be made again.
    pub(super) fn last_resorts(
        &mut self,
        plan: &Problem<'_>,
        (target, cause): (&mut Target, &Diagnostic),
        work: &mut Scratch,
    ) -> Result<Outcome, Left> {
        work.line_search = true;
        let searched = self.attempt(plan, target, work);
        work.line_search = false;
        let searched = searched?;
        if work.outside() {
            return Ok(searched);
        }
        let acts = |point: &crate::state::PointState| point.ever_closed;
        let touched = self.committed.points.iter().chain(&work.evaluation.points).any(acts);
        // a contradiction has no other equilibrium to go to
        let may_go_on = touched && diagnose::may_end_elsewhere(cause);
        if matches!(searched.verdict, Verdict::Converged { .. }) || !may_go_on {
            return Ok(searched);
        }
        self.fail(plan, (target, &searched), Some(target.dt))?;
        target.attempt += 1;
        let relaxed = self.watched(|from, watch| relax(plan, from, target, work, watch))?;
        match relaxed.verdict {
            Verdict::Converged { .. } => Ok(relaxed),
            _ => Ok(Outcome { last: searched.last, ..relaxed }),
        }
    }

    /// The state in which the last attempt was given up.
    pub(super) fn show_unconverged(
        &mut self,
        plan: &Problem<'_>,
        target: &Target,
        outcome: &Outcome,
        work: &Scratch,
    ) -> Result<(), Left> {
        commit(plan, self.committed, target, work, self.trial);
        self.rows.fill(plan, (self.trial, Some(&work.evaluation.kinematics)));
        let residual = work.residuals(plan);
        let numbers = Numbers::of(target, outcome);
        let frame = frame(plan, self.trial, &numbers, self.rows);
        match self.observer.event(Event::Unconverged(&Unconverged { frame, residual: &residual })) {
            std::ops::ControlFlow::Continue(()) => Ok(()),
            std::ops::ControlFlow::Break(stop) => Err(Left::Stopped(stop)),
        }
    }

    /// Why no increment was found. Fixed increments are walked in shorter ones
    /// as well: where these reach the end the size was the cause, and where
    /// they do not they come closer to it.
    pub(super) fn diagnosis(
        &self,
        plan: &Problem<'_>,
        target: &Target,
        outcome: &Outcome,
        stop: StopReason,
        work: &mut Scratch,
    ) -> Diagnostic {
        let (committed, dt) = (&*self.committed, target.dt);
        let mut shown = diagnose::failure(&Case { plan, committed, work, outcome, stop, dt });
        if diagnose::may_be_a_jam(&shown) {
            let jammed = work.jammed_at_first(plan, committed, target);
            let case = Case { plan, committed, work, outcome, stop, dt };
            shown = diagnose::jam_at_first(&case, &jammed).unwrap_or(shown);
        }
        if stop != StopReason::Fixed {
            return shown;
        }
        match solve_shorter(plan, committed, target, work) {
            Shorter::Reached(needed) => diagnose::step_too_large(plan, committed, outcome, needed),
            Shorter::Lost { committed, outcome, dt } => {
                let (committed, outcome) = (&committed, &outcome);
                let nearer = diagnose::failure(&Case { plan, committed, work, outcome, stop, dt });
                if diagnose::is_unknown(&nearer) { shown } else { nearer }
            }
        }
    }
}

/// SL0620: what of a master stands in a face of the slave, between its nodes.
fn edge_inside(plan: &Problem<'_>, found: &EdgeInside, time: f64) -> Diagnostic {
    let pair = &plan.model.contact_pairs[found.pair];
    let nodes = &plan.model.nodes;
    let place = match found.what {
        Found::Edge(place) | Found::Node(place) => Some(place),
        Found::Surface => None,
    };
    let node = place.and_then(|place| pair.master.deforming_nodes().get(place).copied());
    let node = node.map(|node| nodes.name(node).to_string()).unwrap_or_default();
    let mut face: Vec<String> =
        found.face.iter().map(|&node| nodes.name(node).to_string()).collect();
    let last = face.pop().unwrap_or_default();
    let (what, why, help) = match found.what {
        Found::Edge(_) => (
            format!("an edge of the master of {}, at node {node},", pair.name),
            "nodes of sharp edges are held, what lies between two of them is not, and a slave node may \
             catch on its side",
            "mesh the edge with elements no longer than the faces that it stands in: its nodes are then \
             held where it meets them",
        ),
        Found::Node(_) => (
            format!("node {node} of the master of {}", pair.name),
            "contact is at the nodes of the slave, none of that face is held, and the parts go through \
             one another",
            "name the narrower side, or that with the finer mesh, first on *CONTACT PAIR, spread the \
             contact over faces with TYPE=SURFACE TO SURFACE, or make the slave elements there shorter \
             than the master is wide",
        ),
        Found::Surface => (
            format!("a ridge or round of the master of {}", pair.name),
            "contact is at the nodes of the slave, what lies between them is not held, and forces come \
             out too small",
            "make the slave elements there shorter than the ridge or round is wide, spread the contact \
             over faces with TYPE=SURFACE TO SURFACE, or round the edge with FILLET RADIUS",
        ),
    };
    let message = format!(
        "{what} stands {:.3e} deep in the face between slave nodes {} and {last} at total time \
         {time:.6}: {why}",
        found.depth,
        face.join(", "),
    );
    Diagnostic::warning(Code("SL0620"), message).at(pair.origin).help(help)
}

/// What shorter increments made of one that failed.
enum Shorter {
    /// They lead to its end; the shortest of them [T].
    Reached(f64),
    /// They do not.
    Lost { committed: Box<State>, outcome: Box<Outcome>, dt: f64 },
}

/// Shortest increment that is tried, as a fraction of the one that failed.
const SHORTEST: f64 = 1.0 / 256.0;

/// Walks an increment that failed in shorter ones, unseen.
fn solve_shorter(
    plan: &Problem<'_>,
    committed: &State,
    target: &Target,
    work: &mut Scratch,
) -> Shorter {
    let mut from = Box::new(committed.clone());
    let mut to = from.clone();
    let mut needed = 0.25 * target.dt;
    loop {
        let left = target.step_time - from.step_time;
        let dt = if needed > left * (1.0 - 1e-9) { left } else { needed };
        let step_time = if dt == left { target.step_time } else { from.step_time + dt };
        let aim = Target { step_time, dt, ..*target };
        let outcome = attempt(plan, &from, &aim, work, &mut |_| {});
        if matches!(outcome.verdict, Verdict::Converged { .. }) {
            commit(plan, &from, &aim, work, &mut to);
            std::mem::swap(&mut from, &mut to);
            if dt == left {
                return Shorter::Reached(needed);
            }
        } else if needed <= SHORTEST * target.dt {
            return Shorter::Lost { committed: from, outcome: Box::new(outcome), dt };
        } else {
            needed *= 0.25;
        }
    }
}
