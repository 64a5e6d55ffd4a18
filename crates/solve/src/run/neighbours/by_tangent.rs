//! A converged increment differentiated by its tangent.
//!
//! ```text
//!   unknowns held:   what differs at p -+ h, s -+ h s'            -->  R', c'
//!   border           K u' + F lambda' = -R',  G u' = -c'          -->  u', lambda'
//!   laws of points   at p -+ h, along u' and lambda'              -->  pressures, tractions
//!   K u'             at dofs that are prescribed or follow others -->  reactions
//!   commit           of both neighbours                           -->  s'
//! ```
//!
//! Nothing is evaluated at displacements that were moved, so that elements cost what a parameter
//! touches of them and rounding of places has no part in it. docs/theory.md section 13.

use super::increment::{Increment, Linear};
use super::room::{Moves, Room};
use crate::commit::commit;
use crate::constraints::{Role, Rows};
use crate::evaluate::zero;
use crate::moments::turn_moments;
use crate::newton::Scratch;
use crate::problem::Problem;
use crate::sensitivity::{
    Bend, PAIR, Sides, Touch, Touched, is_same_branch, leaves_hard_branch, rates_between,
};
use crate::state::PointState;
use crate::structure::{Ambient, Configuration};
use crate::tangent::{Kept, Place};
use slideline_mech::contact::tangential::Tangential;

/// How much pressures and tractions may bend over the pair [1]: of a smooth law it is the step over the
/// length on which the law changes.
const SMOOTH: f64 = 1e-3;

/// Two neighbours, with their step.
pub struct Pair<'a> {
    pub problems: &'a [Problem<'a>; 2],
    pub touched: &'a Touched,
    /// Rates of the state before.
    pub known: &'a [f64],
    pub h: f64,
}

impl Pair<'_> {
    /// What each counts.
    pub fn weights(&self) -> Sides {
        PAIR.map(|side| 0.5 * side / self.h)
    }

    fn steps(&self) -> Sides {
        PAIR.map(|side| side * self.h)
    }
}

impl Increment<'_> {
    /// Whether the tangent tells all of this increment: of elements without histories, of contact at
    /// nodes of the plane.
    pub fn is_told_by_tangent(&self, base: &Scratch) -> bool {
        let (plan, new) = (self.plan, self.new);
        new.elements.is_empty()
            && new.turns.is_empty()
            && plan.structure.references.is_empty()
            && plan.contact.is_at_nodes_of_the_plane()
            && plan.contact.edges_are_open(&base.evaluation.points)
            && !base.is_stabilised()
    }

    /// The rates of the unknowns and of the state, the latter into `into`; `None`: a neighbour stands on
    /// another branch, or has no answer.
    pub fn by_tangent(
        &self,
        pair: &Pair<'_>,
        (linear, kept): (&mut Linear<'_>, &Kept),
        room: &mut Room,
        into: &mut Vec<f64>,
    ) -> Option<()> {
        for (k, problem) in pair.problems.iter().enumerate() {
            room.sides[k].stand_near(problem, &room.before[k], self.target, linear.base);
        }
        let base = linear.base;
        self.move_prescribed(pair, base, room);
        let stored = self.touch_elements(pair, base, room)?;
        self.move_points(pair, base, (room, |place| base.evaluation.points[place].closed));
        self.hold_laws(pair, (base, kept), room);
        self.collect_forces(pair, (base, kept), room);
        self.solve(pair, linear, room)?;
        self.move_points(pair, base, (room, |_| true));
        self.follow_laws(pair, base, room)?;
        for (k, step) in pair.steps().into_iter().enumerate() {
            move_by(&base.u, (step, &room.tangent.moved), &mut room.sides[k].u);
        }
        self.collect_forces(pair, (base, kept), room);
        let worked = dot(&kept.force, &room.tangent.moved);
        self.commit_both(pair, (base, stored + worked), room);
        self.is_smooth_there(pair, room).then_some(())?;
        self.collect_rates(pair, room, into)?;
        let Moves { moved, force, .. } = &room.tangent;
        moved.iter().chain(force).all(|rate| rate.is_finite()).then_some(())
    }

    /// The rates of the state: those of the lists of dofs are known without a difference.
    fn collect_rates(&self, pair: &Pair<'_>, room: &mut Room, into: &mut Vec<f64>) -> Option<()> {
        let Room { after, tangent: Moves { moved, force, pair: [increment, load], .. }, .. } = room;
        let (before, rest) = pair.known.split_at_checked(moved.len())?;
        let increment_before = rest.get(..moved.len())?;
        move_by(moved, (-1.0, before), increment);
        for (force, role) in force.iter_mut().zip(&self.plan.constraints.roles) {
            if !matches!(role, Role::Prescribed(_)) {
                *force = 0.0;
            }
        }
        let [below, above] = pair.weights();
        let loads = after[0].load.iter().zip(&after[1].load);
        load.clear();
        load.extend(loads.map(|(one, other)| below * one + above * other));
        let lists = [&moved[..], increment, increment_before, force, load];
        rates_between(pair.weights().into_iter().zip(after), lists, into);
        Some(())
    }

    /// Rates of the prescribed dofs and of those that follow them.
    fn move_prescribed(&self, pair: &Pair<'_>, base: &Scratch, room: &mut Room) {
        let constraints = &self.plan.constraints;
        let Room { sides, tangent: Moves { moved, .. }, rates, .. } = room;
        zero(moved, self.plan.dofs.len());
        for (dof, role) in constraints.roles.iter().enumerate() {
            if let Role::Prescribed(_) = role {
                let both = pair.weights().into_iter().zip(&*sides);
                moved[dof] = both.map(|(weight, side)| weight * side.u[dof]).sum();
            }
        }
        constraints.expand(&base.evaluation.rows, moved);
        rates.still(self.new.points.len());
        for (step, side) in pair.steps().into_iter().zip(sides) {
            move_by(&base.u, (step, moved), &mut side.u);
        }
    }

    /// Forces that the parameter makes of the elements, displacements held; the rate of their energy.
    fn touch_elements(&self, pair: &Pair<'_>, base: &Scratch, room: &mut Room) -> Option<f64> {
        let Room { sides, before, tangent: Moves { touched, .. }, .. } = room;
        zero(touched, self.plan.dofs.len());
        let heated = sides[0].temperatures != sides[1].temperatures;
        let mut stored = 0.0;
        for (number, block) in self.plan.structure.blocks() {
            match pair.touched.blocks[block] {
                Touch::Not if !heated => continue,
                Touch::Stresses(factors) if !heated => {
                    let both = pair.weights().into_iter().zip(factors);
                    let rate = both.map(|(weight, factor)| weight * factor).sum();
                    let forces = (rate, &base.evaluation.contributions);
                    stored += self.plan.structure.add_block(number, forces, touched)?;
                    continue;
                }
                _ => {}
            }
            for (k, weight) in pair.weights().into_iter().enumerate() {
                let structure = &pair.problems[k].structure;
                let Scratch { temperatures, turns, clock, evaluation, .. } = &mut sides[k];
                let ambient = Ambient { temperatures, turns, clock: *clock };
                let state = &before[k].elements[..];
                let at = Configuration { u: &base.u, stresses: None, state, ambient };
                let into = &mut evaluation.contributions;
                structure.evaluate_block(number, &at, into, self.plan.means.pool);
                stored += structure.add_block(number, (weight, &*into), touched)?;
            }
        }
        Some(stored)
    }

    /// Moves points that are asked for, and that face their masters, along their rows.
    fn move_points(
        &self,
        pair: &Pair<'_>,
        base: &Scratch,
        (room, moves): (&mut Room, impl Fn(usize) -> bool),
    ) {
        let Room { sides, tangent: Moves { moved, .. }, .. } = room;
        for (place, from) in base.evaluation.kinematics.iter().enumerate() {
            if !from.faces || !moves(place) {
                continue;
            }
            let along = |row: &[f64]| -> f64 {
                from.rows.unknowns.iter().zip(row).map(|(&dof, own)| own * moved[dof]).sum()
            };
            let (closes, slides) = (along(from.rows.normal()), along(from.rows.slip(0)));
            for (side, step) in sides.iter_mut().zip(pair.steps()) {
                let point = &mut side.evaluation.kinematics.points_mut()[place];
                point.overclosure = from.overclosure + step * closes;
                point.along = from.along + Tangential([step * slides, 0.0]);
            }
        }
    }

    /// Pressures and tractions of the closed points, what contact holds exactly left as it is: by the laws
    /// of the neighbours where the points stand, and along their rows by the slopes that the tangent
    /// has: what is stiff cancels there, to the bit.
    fn hold_laws(&self, pair: &Pair<'_>, (base, kept): (&Scratch, &Kept), room: &mut Room) {
        let Room { sides, before, .. } = room;
        let (plan, committed, dt) = (self.plan, self.old, self.target.dt);
        let trial = base.trial(committed, dt);
        let at = Place { plan, committed, trial, evaluation: &base.evaluation };
        for &(place, _) in &kept.points {
            let from = &base.evaluation.kinematics.points()[place];
            let ((_, traction), slope) = at.law(place, from);
            let slips: [Tangential; 2] = std::array::from_fn(|k| {
                let (history, u) = (before[k].points[place].history(), &before[k].displacement);
                let moved = &sides[k].evaluation.kinematics.points()[place];
                pair.problems[k].contact.slip(place, &history, moved, u)
            });
            let (mut closes, mut slides) = (0.0, 0.0);
            for (k, weight) in pair.weights().into_iter().enumerate() {
                closes += weight * sides[k].evaluation.kinematics.points()[place].overclosure;
                slides += weight * slips[k][0];
            }
            let presses = slope * closes;
            let rubs =
                traction.d_tau_d_slip.at(0, 0) * slides + traction.d_tau_d_pressure[0] * presses;
            for (k, step) in pair.steps().into_iter().enumerate() {
                let along = before[k].points[place].along;
                before[k].points[place].along = committed.points[place].along;
                let (plan, committed) = (&pair.problems[k], &before[k]);
                let (trial, evaluation) = (sides[k].trial(committed, dt), &sides[k].evaluation);
                let own = Place { plan, committed, trial, evaluation };
                let ((pressure, traction), _) = own.law(place, from);
                let moved = PointState {
                    pressure: pressure + step * presses,
                    traction: traction.tau + Tangential([step * rubs, 0.0]),
                    opening: -evaluation.kinematics.points()[place].overclosure,
                    allowed: evaluation.kinematics.points()[place].allowed,
                    slip: committed.points[place].slip + slips[k],
                    ..base.evaluation.points[place]
                };
                sides[k].evaluation.points[place] = moved;
                before[k].points[place].along = along;
            }
        }
    }

    /// Rates of all forces with the rates of displacements, pressures and tractions at hand: right at
    /// dofs that are prescribed or follow others, and elsewhere what is not of the unknowns; handed to
    /// those that they follow.
    fn collect_forces(&self, pair: &Pair<'_>, (base, kept): (&Scratch, &Kept), room: &mut Room) {
        let Room { sides, tangent, .. } = room;
        let Moves { moved, touched, force, pair: both } = tangent;
        force.clone_from(touched);
        self.plan.structure.multiply_kept((&kept.elements, &kept.tangents), moved, force);
        for (place, geometry) in kept.points() {
            let kinematics = base.evaluation.kinematics.at(place);
            let rates = sides.iter().zip(pair.weights()).fold(
                (0.0, Tangential::ZERO),
                |(pressure, traction), (side, weight)| {
                    let own = &side.evaluation.points[place];
                    (pressure + weight * own.pressure, traction + weight * own.traction)
                },
            );
            kinematics.press(rates.0, rates.1, force);
            let unknowns = kinematics.rows.unknowns;
            for (&dof, row) in unknowns.iter().zip(geometry.chunks_exact(unknowns.len().max(1))) {
                let turned = row.iter().zip(unknowns).map(|(own, &by)| own * moved[by]);
                force[dof] += turned.sum::<f64>();
            }
        }
        for (k, weight) in pair.weights().into_iter().enumerate() {
            load(&pair.problems[k], &sides[k], -weight, force);
        }
        self.carry((pair, base), &kept.force, (moved, force, both));
    }

    /// Hands rates of forces on dependent dofs to those that they follow, which may turn.
    fn carry(
        &self,
        (pair, base): (&Pair<'_>, &Scratch),
        of_elements: &[f64],
        (moved, rates, both): (&[f64], &mut Vec<f64>, &mut [Vec<f64>; 2]),
    ) {
        let constraints = &self.plan.constraints;
        if !constraints.has_dependents() {
            return;
        }
        if !constraints.turns_along(moved) {
            return constraints.carry(&base.evaluation.rows, rates);
        }
        let mut all = of_elements.to_vec();
        for (place, own) in base.evaluation.points.iter().enumerate().filter(|(_, own)| own.closed)
        {
            base.evaluation.kinematics.at(place).press(own.pressure, own.traction, &mut all);
        }
        load(self.plan, base, -1.0, &mut all);
        let (mut u, mut rows) = (Vec::new(), Rows::default());
        for (step, into) in pair.steps().into_iter().zip(&mut *both) {
            move_by(&base.u, (step, moved), &mut u);
            constraints.linearise((&u, &base.turns), &mut rows);
            move_by(&all, (step, rates), into);
            constraints.carry(&rows, into);
        }
        let [below, above] = pair.weights();
        let each = both[0].iter().zip(&both[1]);
        rates.iter_mut().zip(each).for_each(|(rate, (a, b))| *rate = below * a + above * b);
    }

    /// Rates of the unknowns, and of what contact holds exactly.
    fn solve(&self, pair: &Pair<'_>, linear: &mut Linear<'_>, room: &mut Room) -> Option<()> {
        let Room { sides, before, rates, residual, defects, tangent, .. } = room;
        let Linear { border, base, solver } = linear;
        let equations = &self.plan.constraints.dof_of_equation;
        residual.clear();
        residual.extend(equations.iter().map(|&dof| tangent.force[dof]));
        zero(defects, border.len());
        for (k, weight) in pair.weights().into_iter().enumerate() {
            border.add_defects(weight, (&before[k], &sides[k].evaluation.points), defects);
        }
        border.solve(solver, (&mut *residual, &mut *defects)).ok()?;
        equations.iter().zip(&*residual).for_each(|(&dof, rate)| tangent.moved[dof] = *rate);
        self.plan.constraints.expand(&base.evaluation.rows, &mut tangent.moved);
        border.give(defects, &mut rates.pressures, &mut rates.tractions);
        for (side, step) in sides.iter_mut().zip(pair.steps()) {
            side.move_estimates(base, (rates, step));
        }
        Some(())
    }

    /// Histories of all points, the unknowns moved; `None`: one stands on another branch.
    fn follow_laws(&self, pair: &Pair<'_>, base: &Scratch, room: &mut Room) -> Option<()> {
        let Room { sides, before, .. } = room;
        for (k, plan) in pair.problems.iter().enumerate() {
            let (side, before) = (&mut sides[k], &before[k]);
            side.evaluation.points.clone_from(&base.evaluation.points);
            let closed = base.evaluation.points.iter().enumerate();
            let closed = closed.filter(|(_, own)| own.closed).map(|(place, _)| place);
            side.follow_laws_at(plan, before, closed);
            let evaluation = &mut side.evaluation;
            (evaluation.contact_energy, evaluation.elastic_slip_energy) = (0.0, 0.0);
            for (place, from) in before.points.iter().enumerate() {
                let kinematics = &evaluation.kinematics.points()[place];
                let now = &mut evaluation.points[place];
                let normal = &plan.contact.laws_of(plan.contact.points[place].pair, from).normal;
                if base.evaluation.points[place].closed {
                    let elastic = now.traction.dot(now.elastic_slip);
                    evaluation.elastic_slip_energy += 0.5 * now.area * elastic;
                    evaluation.contact_energy += now.area * normal.energy(kinematics.overclosure);
                    continue;
                }
                now.slip = from.slip;
                if kinematics.faces {
                    now.opening = -kinematics.overclosure;
                    now.along = Some(kinematics.along);
                    let presses = normal.pressure(kinematics.overclosure);
                    presses.is_none_or(|(pressure, _)| pressure == 0.0).then_some(())?;
                }
            }
        }
        Some(())
    }

    /// The states that both neighbours would commit; `stored` is the rate of the energy of the elements.
    fn commit_both(&self, pair: &Pair<'_>, (base, stored): (&Scratch, f64), room: &mut Room) {
        let Room { sides, before, after, tangent, .. } = room;
        let from = &base.evaluation;
        for (k, step) in pair.steps().into_iter().enumerate() {
            let (problem, side) = (&pair.problems[k], &mut sides[k]);
            let into = &mut side.evaluation;
            into.contact.fill(0.0);
            for (dof, role) in self.plan.constraints.roles.iter().enumerate() {
                if let Role::Prescribed(_) = role {
                    into.structure[dof] = from.unbalanced(dof) + step * tangent.force[dof];
                }
            }
            into.strain_energy = from.strain_energy + step * stored;
            into.flux = from.flux;
            into.damping.fill(0.0);
            into.pressed.fill(0.0);
            let mut pressed = std::mem::take(&mut into.pressed);
            problem.faces.press(side.faces(), (&side.u, &side.turns), &mut pressed);
            side.evaluation.pressed = pressed;
            if !after[k].has_room_of(&before[k]) {
                after[k].copy_from(&before[k]);
            }
            commit(problem, &before[k], self.target, side, &mut after[k]);
        }
    }

    /// Whether both neighbours stand on the branch of the base, with laws that do not bend.
    fn is_smooth_there(&self, pair: &Pair<'_>, room: &Room) -> bool {
        let (new, [below, above]) =
            (&self.new.points, [&room.after[0].points, &room.after[1].points]);
        let is_on_branch = |k: usize, points: &[PointState]| {
            points.iter().zip(new).all(|(one, other)| is_same_branch(one, other))
                && !leaves_hard_branch(&pair.problems[k], &room.before[k], points)
        };
        let mut bends = [Bend::default(); 2];
        for (own, (below, above)) in new.iter().zip(below.iter().zip(above)) {
            bends[0].note_pair([below.pressure, own.pressure, above.pressure]);
            bends[1].note_pair([below.traction[0], own.traction[0], above.traction[0]]);
        }
        is_on_branch(0, below)
            && is_on_branch(1, above)
            && bends.into_iter().all(|bend| bend.of_pair() <= SMOOTH)
    }
}

/// Adds `weight` times all that acts from outside to forces on all dofs.
fn load(plan: &Problem<'_>, at: &Scratch, weight: f64, into: &mut [f64]) {
    into.iter_mut().zip(&at.load).for_each(|(force, load)| *force += weight * load);
    let place = (&at.u[..], &at.turns[..]);
    turn_moments(plan, &at.load, place, |dof, beyond| into[dof] += weight * beyond);
    let pressures: Vec<f64> = at.faces().iter().map(|pressure| weight * pressure).collect();
    plan.faces.press(&pressures, place, into);
}

fn move_by(from: &[f64], (step, by): (f64, &[f64]), into: &mut Vec<f64>) {
    into.clear();
    into.extend(from.iter().zip(by).map(|(from, by)| from + step * by));
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}
