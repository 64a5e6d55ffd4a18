//! Contact points along rates: where they stand in the neighbours, and what their laws say there.
//!
//! ```text
//!   h' = a u' + (dh/dxi) xi'       xi' of integration points that follow the closed part of a cell
//!   p', tau'                       by the laws at p -+ h, s -+ h s'
//! ```
//!
//! docs/theory.md section 13.

use super::increment::{Increment, Pair};
use super::room::{Moves, Room};
use crate::contact::Before;
use crate::newton::Scratch;
use crate::state::PointState;
use crate::tangent::{Kept, Place};
use slideline_mech::contact::tangential::Tangential;

impl Increment<'_> {
    /// Moves points that are asked for, and that face their masters, along their rows.
    pub(super) fn move_points(
        &self,
        pair: &Pair<'_>,
        base: &Scratch,
        (room, moves): (&mut Room, impl Fn(usize) -> bool),
    ) {
        let Room { sides, before, moving, tangent: Moves { moved, ends, slips, .. }, .. } = room;
        let facing = base.evaluation.kinematics.points().iter().enumerate();
        let facing = facing.filter(|(place, point)| point.faces && moves(*place));
        for (place, _) in facing {
            let from = base.evaluation.kinematics.at(place);
            let along = |row: &[f64]| -> f64 {
                from.rows.unknowns.iter().zip(row).map(|(&dof, own)| own * moved[dof]).sum()
            };
            let (mut closes, slides) = (along(from.rows.normal()), along(from.rows.slip(0)));
            let mut coordinates = Tangential([slides, 0.0]);
            let (mut xi, mut stretch) = (0.0, 0.0);
            if let Some(own) = moving.of(place) {
                (xi, stretch) = (own.moves(ends), own.stretches(ends));
                closes += xi * own.closes;
                coordinates += xi * own.along;
                slips[place] = moving.slides(own, (slides, xi), pair.known);
            }
            let contact = &self.plan.contact;
            let whole = contact.area_of_node(place, (&base.u, Before::of(self.old)), &from);
            for (k, (side, step)) in sides.iter_mut().zip(pair.steps()).enumerate() {
                let point = &mut side.evaluation.kinematics.points_mut()[place];
                let (contact, at) =
                    (pair.problems[k].contact, (&side.u[..], Before::of(&before[k])));
                let own = contact.area_of_node(place, at, point);
                let wider = if own == whole { 1.0 } else { own / whole };
                point.overclosure = from.overclosure + step * closes;
                point.along = from.along + step * coordinates;
                point.area = from.area * (wider + step * stretch);
                point.xi = from.xi + step * xi;
            }
        }
    }

    /// Pressures and tractions of the closed points, what contact holds exactly left as it is: by the laws
    /// of the neighbours where the points stand, and along their rows by the slopes that the tangent
    /// has: what is stiff cancels there, to the bit.
    pub(super) fn hold_laws(
        &self,
        pair: &Pair<'_>,
        (base, kept): (&Scratch, &Kept),
        room: &mut Room,
    ) {
        let Room { sides, before, moving, tangent: Moves { slips: rates, .. }, .. } = room;
        let (plan, committed, dt) = (self.plan, self.old, self.target.dt);
        let trial = base.trial(committed, dt);
        let at = Place { plan, committed, trial, evaluation: &base.evaluation };
        for &(place, _) in &kept.points {
            let from = &base.evaluation.kinematics.points()[place];
            let along = moving.of(place).map(|own| own.slip);
            let law = |of: &Place<'_>| match along {
                Some(slip) => of.law_with(place, from, slip),
                None => of.law(place, from),
            };
            let ((_, traction), slope) = law(&at);
            let slips: [Tangential; 2] = std::array::from_fn(|k| match along {
                Some(slip) => slip + Tangential::along(pair.steps()[k] * rates[place]),
                None => {
                    let (history, u) = (before[k].points[place].history(), &before[k].displacement);
                    let moved = &sides[k].evaluation.kinematics.points()[place];
                    pair.problems[k].contact.slip(place, &history, moved, u)
                }
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
                let ((pressure, traction), _) = law(&own);
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

    /// Histories of all points, the unknowns moved; `None`: one stands on another branch.
    pub(super) fn follow_laws(
        &self,
        pair: &Pair<'_>,
        base: &Scratch,
        room: &mut Room,
    ) -> Option<()> {
        let Room { sides, before, moving, tangent: Moves { slips, .. }, .. } = room;
        for (k, plan) in pair.problems.iter().enumerate() {
            let (side, before) = (&mut sides[k], &before[k]);
            side.evaluation.points.clone_from(&base.evaluation.points);
            let closed = base.evaluation.points.iter().enumerate();
            let closed = closed.filter(|(_, own)| own.closed).map(|(place, _)| place);
            let step = pair.steps()[k];
            let closed = closed.map(|place| {
                let slip = moving.of(place).map(|own| own.slip);
                (place, slip.map(|slip| slip + Tangential::along(step * slips[place])))
            });
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
}
