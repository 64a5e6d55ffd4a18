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

use super::increment::{Increment, Linear, Pair};
use super::room::{Moves, Room};
use crate::commit::commit;
use crate::constraints::{Role, Rows};
use crate::contact::{Before, MovingPoints, PointKinematics};
use crate::evaluate::zero;
use crate::moments::turn_moments;
use crate::newton::Scratch;
use crate::problem::Problem;
use crate::sensitivity::{Bend, Touch, is_same_branch, leaves_hard_branch, rates_between};
use crate::state::PointState;
use crate::structure::{Ambient, Configuration};
use crate::tangent::Kept;
use slideline_mech::contact::tangential::Tangential;

/// How much pressures and tractions may bend over the pair [1]: of a smooth law it is the step over the
/// length on which the law changes.
const SMOOTH: f64 = 1e-3;

impl Increment<'_> {
    /// Whether the tangent tells all of this increment: of elements without histories, of contact at
    /// nodes and along beams in the plane.
    pub fn is_told_by_tangent(&self, base: &Scratch) -> bool {
        let (plan, new) = (self.plan, self.new);
        new.elements.is_empty()
            && new.turns.is_empty()
            && plan.structure.references.is_empty()
            && plan.contact.is_told_by_rows()
            && plan.contact.edges_are_open(&base.evaluation.points)
            && !base.is_stabilised()
            && !self.turns_areas(base)
    }

    /// Whether areas of slave nodes follow how their faces and masters turn, before the increment or behind it: what turns is
    /// known to evaluations alone.
    fn turns_areas(&self, base: &Scratch) -> bool {
        let mut points = base.evaluation.kinematics.points().iter().enumerate();
        let ends = [Before::of(self.old), Before::NOTHING];
        points.any(|(place, now)| {
            ends.iter().any(|&end| self.plan.contact.counts_in_part(place, (&base.u, end), now))
        })
    }

    /// How integration points follow the closed parts of their cells; whether that can be told.
    pub fn moves_along(&self, base: &Scratch, moving: &mut MovingPoints) -> bool {
        let (u, evaluation) = ([&base.u[..], &self.old.displacement[..]], &base.evaluation);
        let points = (&evaluation.kinematics, &evaluation.points[..]);
        moving.take(self.plan.contact, u, points).is_some()
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
        zero(&mut room.tangent.ends, room.moving.ends().len());
        zero(&mut room.tangent.slips, self.new.points.len());
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
        self.is_smooth_there(pair, (base, room)).then_some(())?;
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
        let [one, other, ..] = after;
        rates_between([(below, one), (above, other)], lists, into);
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

    /// Rates of all forces with the rates of displacements, pressures and tractions at hand: right at
    /// dofs that are prescribed or follow others, and elsewhere what is not of the unknowns; handed to
    /// those that they follow.
    fn collect_forces(&self, pair: &Pair<'_>, (base, kept): (&Scratch, &Kept), room: &mut Room) {
        let Room { sides, tangent, moving, .. } = room;
        let Moves { moved, touched, force, pair: both, .. } = tangent;
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
            let sum = |of: fn(&PointKinematics) -> f64| -> f64 {
                let all = sides.iter().zip(pair.weights());
                all.map(|(own, w)| w * of(&own.evaluation.kinematics.points()[place])).sum()
            };
            let (wider, own) = (sum(|own| own.area), &base.evaluation.points[place]);
            if wider != 0.0 {
                kinematics.push(wider * own.pressure, wider * own.traction, force);
            }
            if let Some(own) = moving.of(place) {
                let xi = sum(|own| own.xi);
                moving.turned(own).iter().for_each(|&(dof, turned)| force[dof] += xi * turned);
            }
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
        let Room { sides, before, rates, residual, defects, tangent, moving, .. } = room;
        let Linear { border, base, solver } = linear;
        let equations = &self.plan.constraints.dof_of_equation;
        residual.clear();
        residual.extend(equations.iter().map(|&dof| tangent.force[dof]));
        zero(defects, border.len());
        for (k, weight) in pair.weights().into_iter().enumerate() {
            border.add_defects(weight, (&before[k], &sides[k].evaluation.points), defects);
        }
        let begins = |of: usize| {
            let all = pair.problems.iter().zip(pair.weights());
            all.map(|(own, weight)| weight * own.contact.laws[of].normal.contact_begins()).sum()
        };
        moving.rates_of_ends(&tangent.moved, begins, &mut tangent.ends);
        border.ends(defects).copy_from_slice(&tangent.ends);
        border.solve(solver, (&mut *residual, &mut *defects)).ok()?;
        tangent.ends.copy_from_slice(border.ends(defects));
        equations.iter().zip(&*residual).for_each(|(&dof, rate)| tangent.moved[dof] = *rate);
        self.plan.constraints.expand(&base.evaluation.rows, &mut tangent.moved);
        border.give(defects, &mut rates.pressures, &mut rates.tractions);
        if border.multipliers() > 0 {
            for (side, step) in sides.iter_mut().zip(pair.steps()) {
                side.move_estimates(base, (rates, step));
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
    fn is_smooth_there(&self, pair: &Pair<'_>, (base, room): (&Scratch, &Room)) -> bool {
        let (new, [below, above]) =
            (&self.new.points, [&room.after[0].points, &room.after[1].points]);
        let is_on_branch = |k: usize, points: &[PointState]| {
            points.iter().zip(new).all(|(one, other)| is_same_branch(one, other))
                && !leaves_hard_branch(&pair.problems[k], &room.before[k], points, |place| {
                    base.stands_held(self.plan, self.old, place)
                })
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
