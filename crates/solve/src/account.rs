//! Where the work of an increment went, and what the account leaves over.
//!
//! ```text
//!   R |    ____o            work:        trapezoid of reactions and loads
//!     |   /   :             dissipation: trapezoid of tractions and slip
//!     o--'    :             left over:   the rounding of the curve between
//!     |       :                          two increments, or a jump
//!     '-------'----- u
//! ```
//!
//! docs/theory.md section 10.

use crate::books::Books;
use crate::contact::SlavePoint;
use crate::moments::turn_moments;
use crate::newton::Scratch;
use crate::observe::results::Energies;
use crate::problem::Problem;
use crate::state::{PointState, State};
use crate::structure::{Ambient, Configuration};
use slideline_mech::contact::tangential::Tangential;
use slideline_mech::element::Temperature;
use slideline_mech::material::Clock;

/// Roundings that energies may be off by [1]. (choice)
const ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Part of the heat that bodies follow freely which (10.8) may err by: strains of an increment.
const FREE_HEAT: f64 = 0.02;

/// Energies after the increment: work by the trapezoidal rule, dissipation
/// as the mean of the traction forces at both ends times the slip, eqs (10.1)
/// to (10.3).
pub fn account(plan: &Problem<'_>, committed: &State, work: &Scratch, trial: &mut State) {
    let before = &committed.energy;
    let ambient =
        Ambient { temperatures: &work.temperatures, turns: &work.turns, clock: Clock::default() };
    let dissipated = plan.structure.dissipated(&work.u, (&trial.elements, ambient));
    let mut energy = Energies {
        strain_energy: work.evaluation.strain_energy - dissipated,
        material_dissipation: dissipated,
        contact_energy: work.evaluation.contact_energy,
        friction_elastic: work.evaluation.elastic_slip_energy,
        stabilisation: before.stabilisation + damped(committed, trial),
        ..*before
    };
    let reactions = committed.reaction.iter().zip(&trial.reaction);
    let loads = committed.load.iter().zip(&trial.load);
    for ((reaction, load), increment) in reactions.zip(loads).zip(&trial.increment) {
        let mean_reaction = 0.5 * (reaction.0 + reaction.1);
        let mean_load = 0.5 * (load.0 + load.1);
        energy.external_work += (mean_reaction + mean_load) * increment;
    }
    energy.external_work += plan.contact.interference_work(committed, trial);
    let brought = brought(plan, committed, trial);
    energy.removed_energy -= brought;
    let heat = thermal_work(plan, committed, work);
    energy.thermal_work += heat.work;
    for state in [committed, trial as &State] {
        let at = (&state.displacement[..], &committed.turns[..]);
        turn_moments(plan, &state.load, at, |dof, beyond| {
            energy.external_work += 0.5 * beyond * trial.increment[dof];
        });
    }
    let friction = Friction::of(plan, committed, work, trial);
    energy.friction_dissipation += friction.dissipated;
    energy.dropped_friction += friction.dropped;
    let unbalanced = energy.supplied() - energy.taken();
    let origin = *trial.balance_origin.insert(committed.balance_origin.unwrap_or(unbalanced));
    energy.balance = unbalanced - origin;
    trial.energy = energy;
    let gained = energy.supplied() - before.supplied();
    let taken = energy.taken() - before.taken();
    let stored =
        energy.of_the_model() - before.of_the_model() + energy.stabilisation - before.stabilisation;
    trial.books = Books {
        // what a pair brings is supplied, though no support gives it
        turned_over: committed.books.turned_over
            + (gained + brought).abs().max((taken + brought).abs()),
        left: gained + brought - stored - friction.work,
        held: (before.of_the_model(), energy.of_the_model()),
        opening: friction.opening,
        opening_dissipation: friction.opening_dissipation,
        heat: committed.books.heat + if plan.structure.nlgeom { heat.taken_back } else { 0.0 },
        ..committed.books
    };
    if committed.balance_origin.is_none() {
        trial.books.left = from_the_start(plan, committed, trial.books.left);
    }
    trial.books.unsure = committed.books.unsure.max(unsure(plan, trial));
}

/// Energy that rounding alone may leave over: the stiffest element rounds as it is moved as far as
/// the model reaches, docs/theory.md eq. (10.10) [F L].
pub fn rounding(plan: &Problem<'_>, state: &State) -> f64 {
    let moved = state.displacement.iter().fold(0.0, |largest: f64, u| largest.max(u.abs()));
    ROUNDING * plan.structure.stiffest * plan.reach * moved.min(plan.reach)
}

/// What energies that do not balance say nothing: rounding, and what the work of heat is not known by
/// where bodies follow it freely, docs/theory.md eqs (10.8) and (10.10) [F L].
fn unsure(plan: &Problem<'_>, state: &State) -> f64 {
    rounding(plan, state) + FREE_HEAT * state.books.heat
}

/// The work of heat in an increment.
#[derive(Default)]
struct Heat {
    /// What it adds to the energy of the elements [F L].
    work: f64,
    /// What it would have added before the displacements and was taken back by them, or the other way
    /// round [F L].
    taken_back: f64,
}

/// What a change of temperature adds to the energy of the elements, the mean of adding it before
/// and behind the displacements: docs/theory.md eq. (10.8). With the trapezoidal rule of the
/// external work it is exact where the energy is quadratic.
fn thermal_work(plan: &Problem<'_>, committed: &State, work: &Scratch) -> Heat {
    let before = match committed.temperatures.is_empty() {
        true => &plan.model.initial_temperatures,
        false => &committed.temperatures,
    };
    let after = &work.temperatures;
    if before == after {
        return Heat::default();
    }
    let mut room = plan.structure.room();
    let mut energy = |u: &[f64], temperatures: &[Temperature]| {
        let turns = &committed.turns[..];
        let ambient = Ambient { temperatures, turns, clock: work.clock };
        let at = Configuration { u, stresses: None, state: &committed.elements, ambient };
        plan.structure.evaluate_forces(&at, &mut room, plan.means.pool);
        room.energy()
    };
    let (from, to) = (&committed.displacement[..], &work.u[..]);
    let first = energy(from, after) - energy(from, before);
    let last = energy(to, after) - energy(to, before);
    let work = 0.5 * (first + last);
    Heat { work, taken_back: 0.5 * (first.abs() + last.abs()) - work.abs() }
}

/// What contact pairs bring that come to a step overclosed: their points stand open in the state before,
/// and what resolves the overclosure is work of no support; and what areas bring that change. docs/theory.md section 10
fn brought(plan: &Problem<'_>, committed: &State, trial: &State) -> f64 {
    if committed.balance_origin.is_none() {
        return 0.0;
    }
    let states = committed.points.iter().zip(&trial.points);
    let of_point = |(point, (before, now)): (&SlavePoint, (&PointState, &PointState))| {
        if before.closed || !now.closed || before.along.is_none() {
            return 0.0;
        }
        let law = &plan.contact.laws_of(point.pair, now).normal;
        let (from, to) = (-before.opening, -now.opening);
        let begins = law.contact_begins();
        match begins.is_finite() && from > begins {
            true => now.area * (0.5 * now.pressure * (from - to) + law.energy(to)),
            false => 0.0,
        }
    };
    let paired = plan.contact.points.iter().zip(states).map(of_point).sum::<f64>();
    paired + turned_to(plan, committed, trial)
}

/// What the laws of closed nodes hold more as other faces about them look at the master: no force of theirs does it.
/// docs/theory.md section 10
fn turned_to(plan: &Problem<'_>, committed: &State, trial: &State) -> f64 {
    let states = committed.points.iter().zip(&trial.points);
    let of_point = |(point, (before, now)): (&SlavePoint, (&PointState, &PointState))| {
        let wider = now.area - before.area;
        if wider == 0.0 || !point.has_shares() || !before.closed || !now.closed {
            return 0.0;
        }
        let law = &plan.contact.laws_of(point.pair, now).normal;
        let held =
            |at: &PointState| law.energy(-at.opening) + 0.5 * at.traction.dot(at.elastic_slip);
        0.5 * wider * (held(before) + held(now))
    };
    plan.contact.points.iter().zip(states).map(of_point).sum()
}

/// What the first increment of a run left over: a model that begins
/// overclosed holds energy that it may give up before anything moves.
fn from_the_start(plan: &Problem<'_>, start: &State, left: f64) -> f64 {
    let mut held = 0.0;
    for (point, now) in plan.contact.points.iter().zip(&start.points) {
        let law = &plan.contact.laws[point.pair].normal;
        let overclosure = -now.opening;
        if overclosure <= law.contact_begins() || now.along.is_none() {
            continue;
        }
        if law.pressure(overclosure).is_none() {
            return 0.0;
        }
        held += now.area * law.energy(overclosure);
    }
    if left < 0.0 { (left + held).min(0.0) } else { left }
}

/// Energy that the dashpots of stabilisation took, by the trapezoidal rule as
/// the external work.
fn damped(committed: &State, trial: &State) -> f64 {
    let at = |state: &State, dof: usize| state.damping.get(dof).copied().unwrap_or(0.0);
    let dofs = 0..committed.damping.len().max(trial.damping.len());
    let mean = |dof| 0.5 * (at(committed, dof) + at(trial, dof));
    dofs.map(|dof| mean(dof) * trial.increment[dof]).sum()
}

/// What friction did in an increment, of all points [F L].
#[derive(Clone, Copy, Debug, Default)]
struct Friction {
    /// Mean of the magnitudes of both ends times the dissipated slip.
    dissipated: f64,
    /// The trapezoid of traction and slip, both with their signs: what the
    /// external work has of it.
    work: f64,
    /// Of `work`, what belongs to points that opened.
    opening: f64,
    /// Of `dissipated`, likewise.
    opening_dissipation: f64,
    /// What the onset dropped.
    dropped: f64,
}

impl Friction {
    fn of(plan: &Problem<'_>, committed: &State, work: &Scratch, trial: &State) -> Self {
        let mut sum = Self::default();
        for place in 0..plan.contact.points.len() {
            let (old, new) = (&committed.points[place], &trial.points[place]);
            sum.dropped += new.dropped_work;
            if old.traction == Tangential::ZERO && new.traction == Tangential::ZERO {
                continue;
            }
            let [before, after] = [old, new].map(|point| point.area * point.traction);
            if before == Tangential::ZERO && after == Tangential::ZERO {
                continue;
            }
            let magnitude = 0.5 * (before.size() + after.size());
            let mean = 0.5 * (before + after);
            if new.closed {
                sum.dissipated += magnitude * new.dissipated;
                sum.work += mean.dot(new.slip - old.slip);
                continue;
            }
            // A point that opened slid until then: counted as the points are
            // that closed, which have slid only since.
            let ways = (&committed.displacement[..], &work.u[..]);
            let slip = plan.contact.opening_slip(place, (old, new), ways);
            let opening = mean.dot(slip);
            sum.opening += opening;
            sum.opening_dissipation += opening.max(0.0);
        }
        sum.work += sum.opening;
        sum.dissipated += sum.opening_dissipation;
        sum
    }
}
