//! Dofs that follow so that a reference node keeps the mean motion of a cloud, however far it turns.
//!
//! ```text
//!     o   o                  shift   x_ref = x_c + R L
//!       +---R                fit     sum w (R r) x (x - x_c) = 0
//!     o   o                  turning s = (R p) . u of a node that follows
//! ```
//!
//! As many equations as dofs follow, solved together; docs/theory.md section 4.2.

use super::cloud::CloudNumbers;
use super::mean_slopes::{At, Equation, Member, Part, What};
use crate::dofs::DofMap;
use slideline_linalg::DenseLu;
use slideline_mech::turn::Turn;
use slideline_mech::vector::{Vector, add, dot, scale};
use slideline_model::{Dof, Model, NodeIndex};

/// The rows of a mean motion.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct MeanRow {
    /// Its place among the clouds.
    pub place: usize,
    /// The node whose turn counts; none where the turn of the cloud is no dof.
    node: Option<NodeIndex>,
    /// Whether it turns about all axes.
    in_space: bool,
    /// Nodes of the cloud, then the reference node.
    members: Vec<Member>,
    /// All that takes part.
    parts: Vec<Part>,
    /// Those of them that follow, and the others.
    follows: Vec<usize>,
    free: Vec<usize>,
    equations: Vec<Equation>,
}

/// Corrections of what follows at most.
const MOST: usize = 30;
/// Part of the size of a cloud, and angle, within which the mean is kept [1].
const KEPT: f64 = 1e-9;
/// Followed dofs up to which all of them are coupled by the turning of forces: for more the matrix would be
/// full of them, and iterations go on without.
const COUPLED: usize = 1500;

impl MeanRow {
    /// That of a mean motion of the model, with the dofs that follow and those along axes that turn.
    pub fn new(
        (model, place): (&Model, usize),
        dofs: &DofMap,
        (dependents, turning): (Vec<usize>, Vec<usize>),
    ) -> Self {
        let mean = &model.mean_motions[place];
        let (shifts, turns) = ([Dof::U1, Dof::U2, Dof::U3], [Dof::UR1, Dof::UR2, Dof::UR3]);
        let coupled =
            |dof: Dof| mean.coupled[dof as usize].then(|| dofs.named(mean.reference, dof));
        let member = |node: NodeIndex, own: [Option<usize>; 3]| Member {
            dofs: own,
            axes: dofs.place_of_turned(node),
        };
        let of_cloud =
            |&(node, _): &(NodeIndex, f64)| member(node, shifts.map(|dof| dofs.named(node, dof)));
        let mut members: Vec<Member> = mean.cloud.iter().map(of_cloud).collect();
        members.push(member(mean.reference, shifts.map(|dof| coupled(dof).flatten())));
        let angles = turns.map(|dof| coupled(dof).flatten());
        let node = angles[2].map(|_| mean.reference);
        let in_space = model.is_in_space();
        let mut new = Self {
            place,
            node,
            in_space,
            members,
            parts: Vec::new(),
            follows: Vec::new(),
            free: Vec::new(),
            equations: Vec::new(),
        };
        new.add_parts(angles, &turning);
        let of_turning = mean.turning.iter().enumerate().filter_map(|(place, &(node, dof))| {
            let member = mean.cloud.iter().position(|own| own.0 == node)?;
            Some(Equation::Turning(place, member, dof as usize))
        });
        new.add_equations(of_turning.collect());
        let follows = |part: &Part| part.dof.is_none_or(|dof| dependents.contains(&dof));
        (new.follows, new.free) = (0..new.parts.len()).partition(|&own| follows(&new.parts[own]));
        new
    }

    /// Displacements of the reference node, the turn, displacements of the cloud, and dofs along axes that turn.
    fn add_parts(&mut self, angles: [Option<usize>; 3], turning: &[usize]) {
        let Self { parts, members, in_space, .. } = self;
        let (cloud, reference) = members.split_at(members.len() - 1);
        let named = |dofs: [Option<usize>; 3]| {
            dofs.into_iter().enumerate().filter_map(|(axis, dof)| Some((axis, Some(dof?))))
        };
        let shifts = named(reference[0].dofs);
        parts.extend(shifts.map(|(axis, dof)| Part { what: What::Shift(axis), dof }));
        let about = if *in_space { 0..3 } else { 2..3 };
        parts.extend(about.map(|axis| Part { what: What::Angle(axis), dof: angles[axis] }));
        for (member, own) in cloud.iter().enumerate() {
            let places = named(own.dofs);
            parts.extend(places.map(|(axis, dof)| Part { what: What::Place(member, axis), dof }));
        }
        let turning = turning.iter().enumerate();
        parts.extend(turning.map(|(k, &dof)| Part { what: What::Turning(k), dof: Some(dof) }));
    }

    fn add_equations(&mut self, of_turning: Vec<Equation>) {
        let of_parts = self.parts.iter().filter_map(|part| match part.what {
            What::Shift(axis) => Some(Equation::Shift(axis)),
            What::Angle(axis) => Some(Equation::Fit(axis)),
            What::Place(..) | What::Turning(_) => None,
        });
        self.equations = of_parts.chain(of_turning).collect();
    }

    /// The dofs that follow, in the order of the rows.
    pub fn dependents(&self) -> impl Iterator<Item = usize> + '_ {
        self.follows.iter().filter_map(|&part| self.parts[part].dof)
    }

    /// The dofs that they follow.
    pub fn followed(&self) -> impl Iterator<Item = usize> + '_ {
        self.free.iter().filter_map(|&part| self.parts[part].dof)
    }

    /// Whether what is followed is coupled by the turning of forces.
    pub fn couples(&self) -> bool {
        self.free.len() <= COUPLED
    }

    /// Where the turn of the reference node counts from.
    fn start(&self, turns: &[Turn]) -> Turn {
        let own = self.node.filter(|_| self.in_space).and_then(|node| turns.get(node));
        own.copied().unwrap_or_default()
    }

    /// The configuration at displacements.
    fn at<'a>(&'a self, of: CloudNumbers<'a>, (u, turns): (&[f64], &[Turn])) -> At<'a> {
        let mut at = At::new((of, &self.members), self.start(turns), u);
        match self.node {
            Some(_) => at.turn(self.angles(&at, u)),
            None => _ = at.fit([0.0; 3], self.in_space),
        }
        at
    }

    /// The rotation vector of the reference node.
    fn angles(&self, at: &At<'_>, u: &[f64]) -> Vector {
        let angles = self.parts.iter().filter_map(|part| match (part.what, part.dof) {
            (What::Angle(axis), Some(dof)) => Some(scale(at.axis_of_reference(axis), u[dof])),
            _ => None,
        });
        angles.fold([0.0; 3], add)
    }

    /// Moves what follows until the mean motion is kept; where it cannot be, it is no number, and the
    /// attempt ends.
    pub fn enforce(&self, of: CloudNumbers<'_>, turns: &[Turn], u: &mut [f64]) {
        self.fit_angles(of, turns, u);
        let mut before = f64::INFINITY;
        let mut at = self.at(of, (u, turns));
        for _ in 0..MOST {
            let step = self.correction(&at, u);
            let largest = step.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
            if largest.is_nan() {
                break;
            }
            for (&part, step) in self.follows.iter().zip(&step) {
                if let Some(dof) = self.parts[part].dof {
                    u[dof] -= step * self.scale(of, part);
                }
            }
            if largest <= f64::EPSILON || largest < KEPT && largest >= 0.5 * before {
                return;
            }
            before = largest;
            if self.moves_cloud() || self.node.is_some() {
                at = self.at(of, (u, turns));
            }
        }
        if before.is_nan() || before >= KEPT {
            self.dependents().for_each(|dof| u[dof] = f64::NAN);
        }
    }

    /// Whether nodes of the cloud follow.
    fn moves_cloud(&self) -> bool {
        self.follows.iter().any(|own| matches!(self.parts[*own].what, What::Place(..)))
    }

    /// Where the turn follows, it is that of the cloud as it stands.
    fn fit_angles(&self, of: CloudNumbers<'_>, turns: &[Turn], u: &mut [f64]) {
        let is_angle = |own: &usize| matches!(self.parts[*own].what, What::Angle(_));
        if self.node.is_none() || self.free.iter().any(is_angle) {
            return;
        }
        let mut at = self.at(of, (u, turns));
        let angles = self.angles(&at, u);
        let fitted = at.fit(angles, self.in_space);
        for &part in self.follows.iter().filter(|own| is_angle(own)) {
            let Part { what: What::Angle(axis), dof: Some(dof) } = self.parts[part] else {
                continue;
            };
            let along = at.axis_of_reference(axis);
            u[dof] = fitted.map_or(f64::NAN, |angles| dot(along, angles));
        }
    }

    /// What a part is measured in: the size of the cloud, or an angle.
    fn scale(&self, of: CloudNumbers<'_>, part: usize) -> f64 {
        if matches!(self.parts[part].what, What::Angle(_)) { 1.0 } else { of.cloud.size }
    }

    /// Derivatives of all equations by parts, a row an equation, without dimensions; by columns if asked for.
    fn factored(&self, at: &At<'_>, transposed: bool) -> Option<DenseLu> {
        let (mut factors, count) = (DenseLu::default(), self.follows.len());
        let matrix = factors.matrix_mut(count);
        for (i, &equation) in self.equations.iter().enumerate() {
            for (j, &part) in self.follows.iter().enumerate() {
                let place = if transposed { count * j + i } else { count * i + j };
                matrix[place] = at.slope(equation, self.parts[part].what);
            }
        }
        (factors.factor() == 0).then_some(factors)
    }

    /// The step of Newton's method, without dimensions; that of a turn that is no dof counts for nothing.
    fn correction(&self, at: &At<'_>, u: &[f64]) -> Vec<f64> {
        let own = |what: What| {
            let part = self.parts.iter().find(|part| part.what == what);
            part.and_then(|part| part.dof).map_or(0.0, |dof| u[dof])
        };
        let values = self.equations.iter().map(|&equation| {
            at.value(
                equation,
                match equation {
                    Equation::Shift(axis) => own(What::Shift(axis)),
                    Equation::Turning(place, ..) => own(What::Turning(place)),
                    Equation::Fit(_) => 0.0,
                },
            )
        });
        let mut step: Vec<f64> = values.collect();
        let solved = self.factored(at, false).is_some_and(|own| own.solve(&mut step).is_ok());
        if !solved {
            step.fill(f64::NAN);
        }
        step
    }

    /// Coefficients of everything that follows, a row each over what is followed.
    fn coefficients(&self, at: &At<'_>, of: CloudNumbers<'_>) -> Vec<Vec<f64>> {
        let mut rows = vec![vec![f64::NAN; self.free.len()]; self.follows.len()];
        let Some(factors) = self.factored(at, false) else { return rows };
        let mut column = vec![0.0; self.equations.len()];
        for (j, &part) in self.free.iter().enumerate() {
            let slopes = self.equations.iter().map(|&own| at.slope(own, self.parts[part].what));
            column.iter_mut().zip(slopes).for_each(|(entry, slope)| *entry = -slope);
            let solved = factors.solve(&mut column).is_ok();
            let by = self.scale(of, part);
            for ((row, &own), value) in rows.iter_mut().zip(&self.follows).zip(&column) {
                row[j] = if solved { value * self.scale(of, own) / by } else { f64::NAN };
            }
        }
        rows
    }

    /// Adds the coefficients of all rows.
    pub fn push_coefficients(
        &self,
        of: CloudNumbers<'_>,
        at: (&[f64], &[Turn]),
        into: &mut Vec<f64>,
    ) {
        let rows = self.coefficients(&self.at(of, at), of);
        let named =
            self.follows.iter().zip(rows).filter(|(own, _)| self.parts[**own].dof.is_some());
        named.for_each(|(_, row)| into.extend(row));
    }

    /// Hands the forces on what follows to what it follows, and calls back with pairs of these and what
    /// the turning of the forces makes of them.
    pub fn turning(
        &self,
        of: CloudNumbers<'_>,
        at: (&[f64], &[Turn]),
        f: &mut [f64],
        call: &mut impl FnMut(usize, usize, f64),
    ) {
        let take =
            |&part: &usize| self.parts[part].dof.map_or(0.0, |dof| std::mem::take(&mut f[dof]));
        let forces: Vec<f64> = self.follows.iter().map(take).collect();
        if forces.iter().all(|own| *own == 0.0) {
            return;
        }
        let at = self.at(of, at);
        let rows = self.coefficients(&at, of);
        for (row, force) in rows.iter().zip(&forces) {
            let followed = self.followed().zip(row);
            followed.for_each(|(dof, a)| f[dof] += a * force);
        }
        if !self.couples() {
            return;
        }
        let Some(halves) = self.curvature((&at, of), &forces, &rows) else { return };
        for (i, one) in self.followed().enumerate() {
            for (j, other) in self.followed().enumerate() {
                let terms = halves.iter().map(|[p, c]| p[i] * c[j] + c[i] * p[j]);
                let value: f64 = terms.sum();
                if value != 0.0 {
                    call(one, other, value);
                }
            }
        }
    }

    /// The second derivatives of the work of forces on what follows, as a sum of p c' + c p' over what is
    /// followed: p is how the turn changes, c what changes with it.
    fn curvature(
        &self,
        (at, of): (&At<'_>, CloudNumbers<'_>),
        forces: &[f64],
        rows: &[Vec<f64>],
    ) -> Option<[[Vec<f64>; 2]; 3]> {
        let multipliers = self.multipliers((at, of), forces)?;
        let pull = at.pull(&self.equations, &multipliers);
        let gather = |part: usize, factor: f64, into: &mut [f64]| match self
            .follows
            .iter()
            .position(|own| *own == part)
        {
            Some(row) => into.iter_mut().zip(&rows[row]).for_each(|(sum, a)| *sum += factor * a),
            None => {
                let place = self.free.binary_search(&part).unwrap_or(0);
                into[place] += factor;
            }
        };
        let none = || [vec![0.0; self.free.len()], vec![0.0; self.free.len()]];
        let mut halves = [none(), none(), none()];
        for (place, part) in self.parts.iter().enumerate() {
            for (about, [turn, change]) in halves.iter_mut().enumerate() {
                match part.what {
                    What::Angle(axis) => gather(place, at.axis_of_reference(axis)[about], turn),
                    What::Place(member, axis) => {
                        gather(place, at.bend(&pull, about, (member, axis)), change);
                    }
                    What::Shift(_) | What::Turning(_) => {}
                }
            }
        }
        let turns = [0, 1, 2].map(|about| halves[about][0].clone());
        for (about, [_, change]) in halves.iter_mut().enumerate() {
            for (other, turn) in turns.iter().enumerate() {
                let half = 0.5 * at.bend_of_turn(&pull, [about, other]);
                change.iter_mut().zip(turn).for_each(|(sum, p)| *sum += half * p);
            }
        }
        Some(halves)
    }

    /// The multipliers of the equations that forces on what follows mean: G' l = - f.
    fn multipliers(
        &self,
        (at, of): (&At<'_>, CloudNumbers<'_>),
        forces: &[f64],
    ) -> Option<Vec<f64>> {
        let scaled = self.follows.iter().zip(forces);
        let mut own: Vec<f64> =
            scaled.map(|(&part, force)| -force * self.scale(of, part)).collect();
        self.factored(at, true)?.solve(&mut own).ok()?;
        let scaled = self.equations.iter().zip(&mut own);
        scaled.for_each(|(&equation, own)| *own *= at.row_scale(equation));
        Some(own)
    }
}
