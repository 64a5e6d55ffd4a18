//! Energy that an increment leaves over: a jump, or a force that changes more
//! between two increments than the trapezoidal rule can follow.
//!
//! ```text
//!   load |      ___ o - - - - - -> o     halves, and the half again that
//!        |    /      \           /       leaves more over: what the rule
//!        |  /          \_______/         misses fades, what a jump
//!        '------------------------- u    releases stays
//! ```
//!
//! docs/theory.md section 10.

use super::analysis::{Analysis, Left};
use crate::commit::{commit, recall_points};
use crate::constraints::Role;
use crate::increments::Verdict;
use crate::newton::{Scratch, attempt};
use crate::observe::Event;
use crate::problem::Problem;
use crate::stabilise;
use crate::state::State;
use crate::target::Target;
use slideline_diag::{Code, Diagnostic, Place};
use slideline_model::{ElementBlock, NodeIndex};

/// Part of the energy turned over from which on a jump is looked for.
const NOTABLE: f64 = 0.01;
/// Part of the energy of its own increment from which on it is.
const SHARP: f64 = 0.02;
/// Part of the energy turned over that a run may leave unbalanced unsaid.
const MUCH: f64 = 0.2;
/// How often an increment is halved: nothing but a jump keeps more than
/// 2^-8 of what it left over.
const HALVINGS: usize = 8;
/// Halvings that are made at least: by then the rest of a smooth path has
/// fallen to a 32nd.
const FEWEST: usize = 5;
/// How near a limit is walked up to, as a part of what was to be halved.
const SHORTEST: f64 = 1.0 / 256.0;
/// Part of what an increment left over that its halves leave where no jump is:
/// the rule's error falls by four.
const FALLS: f64 = 0.4;
/// Rounding of energies, in roundings of the stiffest element moved as far
/// as the model reaches.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

impl Analysis<'_> {
    /// Enters what the increment that was just committed left over into the
    /// sums of its step. Where it jumped, what the jump released is counted
    /// apart, and said.
    pub(super) fn balance_books(
        &mut self,
        plan: &Problem<'_>,
        target: &Target,
        work: &mut Scratch,
    ) -> Option<Diagnostic> {
        // The dashpots of stabilisation hold what would fall: no equilibrium
        // path that energies could be held against.
        let stabilised = stabilise::settings(plan, self.committed).is_some();
        let books = self.committed.books;
        if stabilised || books.left.abs() <= rounding(plan, self.committed) {
            self.committed.books.left = 0.0;
        }
        let own = books.turned_over - self.trial.books.turned_over;
        // a jump releases energy: what gains some is none
        let left = self.committed.books.left;
        let looked_for = left > NOTABLE * books.turned_over && left > SHARP * own;
        let jump = looked_for.then(|| find(plan, (self.trial, self.committed), target, work));
        if looked_for {
            recall_points(self.committed, work);
        }
        let said = jump.flatten().map(|jump| {
            jump.enter(self.trial, self.committed);
            jump.told(plan, target, self.committed)
        });
        self.committed.books.enter(target);
        said
    }

    /// Says so where the increments of the run left much energy unbalanced.
    pub(super) fn judge_balance(
        &mut self,
        plan: &Problem<'_>,
        target: &Target,
    ) -> Result<(), Left> {
        let books = self.committed.books;
        let unbalanced = books.unbalanced();
        let much = MUCH * books.turned_over + rounding(plan, self.committed);
        let [step, increment] = books.worst_at;
        let Some(worst_step) = step.checked_sub(1).and_then(|step| plan.model.steps.get(step))
        else {
            return Ok(());
        };
        if target.step < plan.model.steps.len() || unbalanced <= much {
            return Ok(());
        }
        let message = format!(
            "energy does not balance: the error is {unbalanced:.3e}, {:.0} % of the energy \
             converted, most of it ({:.3e}) in increment {increment} of step {step}: forces \
             change more within an increment than its two ends show, and work and peak forces are \
             not reliable",
            100.0 * unbalanced / books.turned_over,
            books.worst,
        );
        let procedure = &worst_step.procedure;
        let shorter = 0.25 * books.worst_dt;
        let direct = if procedure.direct { ", DIRECT" } else { "" };
        let card = format!(
            "*STATIC{direct}\n{shorter:.4E}, {:?}, {:.4E}, {shorter:.4E}\n",
            procedure.period,
            procedure.minimum.min(1e-3 * shorter),
        );
        let said = Diagnostic::warning(Code("SL0604"), message)
            .at(procedure.origin.unwrap_or(worst_step.origin))
            .help(format!(
                "use increments of at most {shorter:.3e} in step {step}, and compare the forces"
            ));
        let said = match procedure.origin {
            Some(origin) => said.card(Place::Instead(origin), card),
            None => said,
        };
        self.tell(Event::Diagnosed(&said))
    }
}

/// Energy that rounding alone may leave over [F L].
fn rounding(plan: &Problem<'_>, state: &State) -> f64 {
    let moved = state.displacement.iter().fold(0.0, |largest: f64, u| largest.max(u.abs()));
    ROUNDING * plan.structure.stiffest * plan.reach * moved.min(plan.reach)
}

/// A part of an increment with the states at both ends.
struct Part {
    from: State,
    to: State,
    /// Time in the step at its end, and its length [T].
    end: f64,
    dt: f64,
    /// What the rest of the increment turned over.
    rest: Rest,
}

/// Sums over the parts of an increment that hold no jump [F L].
#[derive(Clone, Copy, Debug, Default)]
struct Rest {
    work: f64,
    dissipation: f64,
    left: f64,
}

impl Rest {
    fn with(mut self, part: &Part) -> Self {
        self.work += part.change(|state| state.energy.external_work);
        self.dissipation += part.change(|state| state.energy.friction_dissipation);
        self.left += part.to.books.left;
        self
    }
}

impl Part {
    fn change(&self, of: impl Fn(&State) -> f64) -> f64 {
        of(&self.to) - of(&self.from)
    }

    /// What it leaves over if points that opened did not slide on before:
    /// in a jump they do not.
    fn left(&self) -> f64 {
        self.to.books.left + self.to.books.opening
    }

    /// A part from a state on; `None` where it has no end.
    fn walk(
        plan: &Problem<'_>,
        from: &State,
        aim: &Target,
        rest: Rest,
        work: &mut Scratch,
    ) -> Option<Self> {
        let outcome = attempt(plan, from, aim, work, &mut |_| {});
        let found = matches!(outcome.verdict, Verdict::Converged { .. }).then(|| {
            let mut to = work.copy(from);
            commit(plan, from, aim, work, &mut to);
            Self { from: work.copy(from), to, end: aim.step_time, dt: aim.dt, rest }
        });
        work.take_back(outcome);
        found
    }

    /// Its states are no longer needed.
    fn spare(self, work: &mut Scratch) {
        [self.from, self.to].into_iter().for_each(|state| work.spare(state));
    }

    /// The jump of a part whose halves have no end: the path is walked up to
    /// its limit, and from the end back to the loads and supports of there.
    fn over_the_limit(
        &self,
        plan: &Problem<'_>,
        target: &Target,
        work: &mut Scratch,
        enough: f64,
    ) -> Option<Self> {
        let (mut limit, mut rest) = (self.from.clone(), self.rest);
        let mut dt = 0.5 * self.dt;
        while dt > SHORTEST * self.dt {
            let aim = Target { step_time: limit.step_time + dt, dt, ..*target };
            let nearer = match aim.step_time < self.end {
                true => Self::walk(plan, &limit, &aim, rest, work),
                false => None,
            };
            match nearer.filter(|nearer| nearer.left().abs() <= enough) {
                Some(nearer) => {
                    rest = rest.with(&nearer);
                    limit = nearer.to;
                }
                None => dt *= 0.5,
            }
        }
        let end = limit.step_time;
        let back = Target { step_time: end, dt: end - self.end, ..*target };
        // Not guessed from the increment that jumped: that would lead back.
        let from = State { increment_time: (0.0, 0.0), ..self.to.clone() };
        let back = Self::walk(plan, &from, &back, Rest::default(), work)?;
        let beyond = Rest::default().with(&back);
        rest.work -= beyond.work;
        rest.dissipation -= beyond.dissipation;
        rest.left -= beyond.left;
        let mut landed = back.to;
        let done = done_between(plan, &limit, &landed);
        landed.books.left = done - (kept(&landed) - kept(&limit));
        (landed.books.opening, landed.books.opening_dissipation) = (0.0, 0.0);
        landed.energy.external_work = limit.energy.external_work + done;
        landed.energy.friction_dissipation = limit.energy.friction_dissipation;
        Some(Self { from: limit, to: landed, end, dt: 0.0, rest })
    }

    /// Its second half without a walk: from the end of the first to its own, where nothing that
    /// the way leaves behind stands between them and both halves leave what a smooth path leaves.
    fn known_half(&self, plan: &Problem<'_>, first: &Self, work: &mut Scratch) -> Option<Self> {
        let (middle, end) = (&first.to, &self.to);
        let states = [&self.from, middle, end];
        let forgets = !plan.model.blocks.iter().any(ElementBlock::remembers);
        let apart = |state: &&State| {
            state.temperatures.is_empty() && state.points.iter().all(|point| !point.closed)
        };
        let left = done_between(plan, middle, end) - (kept(end) - kept(middle));
        let smooth = (first.left() + left).abs() <= FALLS * self.left().abs();
        (smooth && forgets && states.iter().all(apart)).then(|| {
            let (from, mut to) = (work.copy(middle), work.copy(end));
            to.books.left = left;
            Self { from, to, end: self.end, dt: first.dt, rest: self.rest }
        })
    }

    /// Its half that leaves more over, and what both leave [F L]; `None` where a
    /// half has no end.
    fn sharper_half(
        &self,
        plan: &Problem<'_>,
        target: &Target,
        work: &mut Scratch,
    ) -> Option<(Self, f64)> {
        let dt = 0.5 * self.dt;
        let aim = |step_time: f64| Target { step_time, dt, ..*target };
        let first = Self::walk(plan, &self.from, &aim(self.end - dt), self.rest, work)?;
        let known = self.known_half(plan, &first, work);
        let walked = || Self::walk(plan, &first.to, &aim(self.end), self.rest, work);
        let Some(second) = known.or_else(walked) else {
            first.spare(work);
            return None;
        };
        let both = first.left() + second.left();
        let (mut sharper, other) = match first.left().abs() >= second.left().abs() {
            true => (first, second),
            false => (second, first),
        };
        sharper.rest = self.rest.with(&other);
        other.spare(work);
        Some((sharper, both))
    }

    /// Whether something that is prescribed or applied makes most of its own
    /// change in this part of `whole`: not the structure jumps then.
    fn is_driven(&self, plan: &Problem<'_>, whole: &Self) -> bool {
        let change = |part: &Self, dof: usize| match plan.constraints.roles[dof] {
            Role::Prescribed(_) => part.to.displacement[dof] - part.from.displacement[dof],
            _ => {
                let force = |state: &State| state.load[dof] + state.reaction[dof];
                force(&part.to) - force(&part.from)
            }
        };
        let mut dofs = 0..plan.dofs.len().min(self.from.load.len());
        dofs.any(|dof| change(self, dof).abs() > 0.5 * change(whole, dof).abs())
    }
}

/// Work of loads and supports from one state to another by the trapezoidal rule [F L].
fn done_between(plan: &Problem<'_>, from: &State, to: &State) -> f64 {
    let force = |state: &State, dof: usize| state.load[dof] + state.reaction[dof];
    let done = |dof: usize| {
        let mean = 0.5 * (force(from, dof) + force(to, dof));
        mean * (to.displacement[dof] - from.displacement[dof])
    };
    (0..plan.dofs.len()).map(done).sum()
}

/// Energy that a state keeps [F L].
fn kept(state: &State) -> f64 {
    state.energy.of_the_model()
}

/// Looks for a jump between two states that an increment joins.
fn find(
    plan: &Problem<'_>,
    (from, to): (&State, &State),
    target: &Target,
    work: &mut Scratch,
) -> Option<Jump> {
    let (end, dt) = (target.step_time, target.dt);
    let (from, to) = (work.copy(from), work.copy(to));
    let whole = Part { from, to, end, dt, rest: Rest::default() };
    let mut part = None;
    let found = narrow(plan, (&whole, &mut part), target, work);
    part.into_iter().chain([whole]).for_each(|part| part.spare(work));
    found
}

/// Halves the whole, and of its halves the one that leaves more over, again and again: `part` is
/// the last of them. The jump, where what is left over stays.
fn narrow(
    plan: &Problem<'_>,
    (whole, part): (&Part, &mut Option<Part>),
    target: &Target,
    work: &mut Scratch,
) -> Option<Jump> {
    let enough = NOTABLE * whole.to.books.turned_over;
    let mut left = [whole.left(); HALVINGS + 1];
    let (mut count, mut steady) = (1, 0);
    while count <= HALVINGS && (steady < 2 || count <= FEWEST) {
        let longer = part.as_ref().unwrap_or(whole);
        let before = longer.left();
        let Some((half, both)) = longer.sharper_half(plan, target, work) else {
            // Where not even halves are found the structure itself must say
            // that it gave way.
            if work.negative_pivots == 0 {
                return None;
            }
            if let Some(over) = longer.over_the_limit(plan, target, work, enough) {
                return (over.left() > enough).then(|| Jump::of(plan, &over));
            }
            break;
        };
        let now = half.left();
        let last = part.replace(half);
        last.into_iter().for_each(|part| part.spare(work));
        // what the rule misses falls by four with every halving
        if now.abs() <= enough || both.abs() <= FALLS * before.abs() {
            return None;
        }
        steady = if (now - before).abs() <= 0.1 * before.abs() { steady + 1 } else { 0 };
        left[count] = now;
        count += 1;
    }
    // What is no jump falls by half at least with every halving.
    let fades = match left[..count] {
        [.., two_before, _, last] => last <= 0.5 * two_before,
        [.., before, last] => last <= 0.75 * before,
        _ => false,
    };
    let driven = part.as_ref().is_some_and(|part| part.is_driven(plan, whole));
    let part = part.as_ref().unwrap_or(whole);
    // A jump releases energy; what gains some is none.
    (!fades && !driven && part.left() > enough).then(|| Jump::of(plan, part))
}

/// A jump from one equilibrium to another.
struct Jump {
    /// Energy that it released [F L].
    released: f64,
    /// Work of supports and loads in the increment, and what friction
    /// dissipated, from the parts in which it was walked [F L].
    work: f64,
    dissipation: f64,
    /// What the parts without the jump left over [F L].
    left: f64,
    /// Total time before it [T].
    time: f64,
    /// The node that it moved most, and how far [L].
    node: Option<(NodeIndex, f64)>,
    /// Places of the pairs that carried pressure before it and none after.
    lost: Vec<usize>,
}

impl Jump {
    fn of(plan: &Problem<'_>, part: &Part) -> Self {
        let (from, to) = (&part.from, &part.to);
        // What is driven does not spring.
        let moved = |node: usize| {
            let own = plan.dofs.named_of_node(node).filter(|&dof| !plan.dofs.is_rotation(dof));
            let way = own.map(|dof| match plan.constraints.roles[dof] {
                Role::Prescribed(_) => 0.0,
                _ => to.displacement[dof] - from.displacement[dof],
            });
            way.fold(0.0, f64::hypot)
        };
        let nodes = (0..plan.model.nodes.len()).map(|node| (node, moved(node)));
        let closed = |state: &State, pair: usize| {
            let mut points = plan.contact.points.iter().zip(&state.points);
            points.any(|(point, now)| point.pair == pair && now.closed)
        };
        let pairs = 0..plan.contact.laws.len();
        let whole = part.rest.with(part);
        Self {
            released: part.left(),
            work: whole.work,
            dissipation: whole.dissipation - to.books.opening_dissipation,
            left: part.rest.left,
            time: from.total_time,
            node: nodes.max_by(|a, b| a.1.total_cmp(&b.1)),
            lost: pairs.filter(|&pair| closed(from, pair) && !closed(to, pair)).collect(),
        }
    }

    /// Counts it in the energies of the state that it led to: the work of its
    /// increment is that of the parts, which enclose the jump.
    fn enter(&self, before: &State, state: &mut State) {
        let energy = &mut state.energy;
        energy.released_energy += self.released;
        energy.external_work = before.energy.external_work + self.work;
        energy.friction_dissipation = before.energy.friction_dissipation + self.dissipation;
        let unbalanced = energy.supplied() - energy.taken();
        let origin = *state.balance_origin.insert(before.balance_origin.unwrap_or(unbalanced));
        energy.balance = unbalanced - origin;
        state.books.left = self.left;
    }

    fn told(&self, plan: &Problem<'_>, target: &Target, state: &State) -> Diagnostic {
        let mut message = format!(
            "the structure jumps to another equilibrium in increment {} of step {}, at total time \
             {:.6}",
            target.increment, target.step, self.time
        );
        if let Some((node, moved)) = self.node {
            let label = plan.model.nodes.name(node);
            message.push_str(&format!(": node {label} springs by {moved:.4e}"));
        }
        for &pair in &self.lost {
            let name = &plan.model.contact_pairs[pair].name;
            message.push_str(&format!(", the contact of {name} opens"));
        }
        message.push_str(&format!(
            ", and {:.4e} of energy is released, {:.1} % of the energy converted",
            self.released,
            100.0 * self.released / state.books.turned_over
        ));
        let node = self.node.map(|(node, _)| plan.model.nodes.get(node).origin);
        Diagnostic::note(Code("SL0603"), message).at(node).help(
            "a hook that springs off an edge does this, and no action is needed; released_energy \
             in JOB.energy.csv contains this energy, and the motion during the jump is not in \
             equilibrium",
        )
    }
}
