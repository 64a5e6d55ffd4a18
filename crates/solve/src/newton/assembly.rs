//! The tangent of an iteration: elements, geometry of contact, augmentation stiffness.

use super::hold::hold_loose;
use super::multipliers::context;
use super::scratch::{Scratch, solver};
use crate::contact::{SEGMENT_POINTS, SlavePoint};
use crate::linearised::{Augmentation, LinearPoint, LinearRows, Sliding, Stiffness};
use crate::moments;
use crate::problem::Problem;
use crate::state::{PointState, State};
use slideline_linalg::{SolveError, Use};
use slideline_mech::contact::enforcement::Enforcement;
use slideline_mech::contact::tangential::Tangential;

/// How far apart, in sizes of the model, points still count as touching.
pub const TOUCH: f64 = 1e-9;
/// Part of the augmentation stiffness below which the one that a point feels of its own
/// equations is none: a chain has none across its line [1].
const NOTHING: f64 = 1e-3;
/// Rows from which on the condensed contact problem is solved without its matrix.
const DENSE_ROWS: f64 = 100.0;
/// And where solutions read but a part of the factors (judged by blocks slid on foundations).
const DENSE_ROWS_ON_INTERFACE: f64 = 24.0;
/// Rows that a touching integration point adds to it: those of its element are shared.
const INTEGRATED_ROWS: f64 = 6.0 / SEGMENT_POINTS as f64;
/// Augmentation stiffness of a closed point, as a fraction of the stiffest element.
pub(super) const AUGMENTATION: f64 = 0.1;

impl Scratch {
    /// Assembles and factors. Where nothing but contact that is still open
    /// would hold the model, every point that faces its master is augmented,
    /// and the contact step closes the gap.
    pub(super) fn factor(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
    ) -> Result<(), SolveError> {
        loop {
            self.linearise_points(plan, committed);
            self.note_met(plan);
            if self.outside() {
                return Ok(());
            }
            self.assemble(plan, committed);
            self.choose_enforcement(plan, committed);
            match self.factor_assembled(plan, committed) {
                Ok(()) => {
                    self.count_negative_pivots();
                    return Ok(());
                }
                Err(fault @ SolveError::Singular { .. }) => self.augment(plan, committed, fault)?,
                Err(fault) => return Err(fault),
            }
        }
    }

    /// Augments every point that faces its master from now on, for a tangent that was singular.
    ///
    /// Errors: the fault, where that is done already.
    pub(super) fn augment(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        fault: SolveError,
    ) -> Result<(), SolveError> {
        if self.augment_all || plan.inserts_laws() {
            return Err(fault);
        }
        self.augment_all = true;
        self.evaluation.look.forget();
        self.evaluate(plan, committed, self.dt);
        Ok(())
    }

    /// Takes note of what touches beyond the pattern.
    fn note_met(&mut self, plan: &Problem<'_>) {
        let Self { met, points, evaluation, .. } = self;
        met.clear();
        let counts = |point: &LinearRows<'_>| point.stiffness > 0.0 || point.pressure > 0.0;
        let left = points.with_rows().filter(counts).filter(|&point| !plan.holds(point));
        met.extend(left.map(|point| evaluation.kinematics.at(point.place).rows.unknowns.to_vec()));
    }

    /// Whether contact couples what the pattern does not hold.
    pub fn outside(&self) -> bool {
        !self.met.is_empty()
    }

    /// Takes note of the directions in which the structure gave way.
    pub(super) fn count_negative_pivots(&mut self) {
        let negative = solver(&mut self.systems).negative_pivots();
        self.negative_pivots = self.negative_pivots.max(negative);
    }

    /// Factors what was assembled; after the first iteration of an attempt and where no point asks
    /// for more than one solution, the factors of the iteration before may do.
    fn factor_assembled(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
    ) -> Result<(), SolveError> {
        if plan.inserts_laws() {
            return self.factor_inserted(plan, committed).map(|_| ());
        }
        let near = std::mem::replace(&mut self.factored, true) && self.points.is_empty();
        let Self { values, augmented, systems, points, .. } = self;
        let (symmetrised, solver) = (plan.symmetrised(), solver(systems));
        let pattern = plan.pattern;
        let mut stiffness = Stiffness { pattern, values, augmented, solver, symmetrised };
        match near && stiffness.follow()? {
            true => Ok(()),
            false => stiffness.factor(points).map(|_| ()),
        }
    }

    /// Contact points as the condensed problem wants them.
    pub(super) fn linearise_points(&mut self, plan: &Problem<'_>, committed: &State) {
        self.points.clear(plan.contact.directions);
        for (place, point) in plan.contact.points.iter().enumerate() {
            if self.evaluation.look.idle[place] {
                continue;
            }
            let kinematics = &self.evaluation.kinematics.at(place);
            if point.is_integration_point() && !kinematics.faces {
                self.pressures[place] = 0.0;
                self.tractions[place] = Tangential::ZERO;
                continue;
            }
            let before = &committed.points[place];
            let law = plan.contact.law_of(point.pair, before);
            let laws = &plan.contact.laws[law];
            if self.is_held(plan, committed, (place, law)) {
                // what pressed before both sides were held presses on
                if !before.closed {
                    (self.pressures[place], self.tractions[place]) = (0.0, Tangential::ZERO);
                }
                continue;
            }
            let touching = kinematics.faces
                && (self.augment_all
                    || self.pressures[place] > 0.0
                    || kinematics.overclosure > laws.normal.contact_begins() - TOUCH * plan.reach);
            let augmentation = if touching { augmentation_stiffness(plan, point) } else { 0.0 };
            let called = laws.has_friction() && laws.onset.called(before.closed, true);
            let (history, from) = (before.history(), &committed.displacement);
            let sliding = (called && kinematics.faces).then(|| Sliding {
                slip: plan.contact.slip(place, &history, kinematics, from),
                elastic_slip: before.elastic_slip,
                traction: self.tractions[place],
                stiffness: augmentation,
                state_variables: (point.state_variables, point.state_size),
            });
            let linear = LinearPoint {
                place,
                pair: point.pair,
                law,
                area: kinematics.area,
                integrated: point.is_integration_point(),
                overclosure: kinematics.overclosure,
                pressure: if kinematics.faces { self.pressures[place] } else { 0.0 },
                stiffness: augmentation,
                least: NOTHING * augmentation_stiffness(plan, point),
                sliding,
            };
            let following = (&plan.constraints, &self.evaluation.rows);
            self.points.push(linear, kinematics.rows, following);
            if laws.friction.needs_multiplier() {
                self.points.hold_slip_of_last(plan.units);
            }
            // lent stiffness is taken back by the rows of the point alone
            let added = self.points.len() - 1;
            if !self.points.at(added).takes_part(laws) {
                self.points[added].set_augmentation(Augmentation::default());
            }
        }
    }

    /// Whether hard contact of a point has nothing that it could move.
    fn is_held(&self, plan: &Problem<'_>, committed: &State, (place, law): (usize, usize)) -> bool {
        let kinematics = &self.evaluation.kinematics.at(place);
        let is_hard = plan.contact.laws[law].normal.pressure(0.0).is_none();
        let ways = (&self.u[..], &committed.displacement[..]);
        is_hard
            && kinematics.faces
            && (!plan.contact_yields(kinematics, &self.evaluation.rows)
                || plan.is_joined(place, kinematics, &self.evaluation.rows)
                || plan.touches_held_node(place, kinematics, ways))
    }

    /// Elements and geometry of contact: the tangent without the stiffness that
    /// closed points are augmented with.
    pub(super) fn assemble(&mut self, plan: &Problem<'_>, committed: &State) {
        self.take_tangents(plan, committed);
        self.stiffen(plan);
        if self.holds_loose(plan) {
            hold_loose(plan, (&self.evaluation.rows, self.hold), &mut self.values);
        }
        self.dashpots.stiffen(plan, &self.evaluation.rows, &mut self.values);
        let at = (&self.faces[..], &self.u[..], &self.turns[..]);
        plan.stiffen_by_faces(&self.evaluation.rows, at, &mut self.values);
        let at = (&self.u[..], &self.turns[..]);
        moments::stiffen(plan, &self.evaluation.rows, &self.load, at, &mut self.values);
        self.turn(plan);
        for k in 0..self.points.len() {
            let point = &self.points[k];
            let presses = point.pressure != 0.0 || point.stiffness != 0.0;
            if !presses || self.opened[point.pair] {
                continue;
            }
            let place = self.points[k].place;
            self.add_geometry(plan, &committed.points[place], place);
        }
        self.add_faces(plan);
    }

    /// Adds the geometry of faces in space that contact is spread over.
    fn add_faces(&mut self, plan: &Problem<'_>) {
        let Self { evaluation, pressures, tractions, geometry, values, opened, .. } = self;
        let kinematics = &evaluation.kinematics;
        let forces = |place: usize| {
            if opened[plan.contact.points[place].pair] {
                return None;
            }
            let area = kinematics.points()[place].area;
            Some((area * pressures[place], area * tractions[place]))
        };
        plan.contact.tangents_of_faces(kinematics, forces, geometry, |dofs, tangent| {
            let at = |i: usize, j: usize| tangent[dofs.len() * i + j];
            plan.scatter(&evaluation.rows, dofs, at, values);
        });
    }

    /// The tangents of the elements, as the matrix begins. With contact a copy of them: its
    /// multipliers may move while the elements stay.
    fn take_tangents(&mut self, plan: &Problem<'_>, committed: &State) {
        if self.tangent_is_behind || self.evaluation.tangent.is_empty() {
            self.evaluate_tangents(plan, committed, self.dt);
        }
        if !plan.contact.points.is_empty() {
            return self.values.copy_from_slice(&self.evaluation.tangent);
        }
        self.values = std::mem::take(&mut self.evaluation.tangent);
    }

    /// Many rows are solved without their matrix, and augmented by their laws.
    fn choose_enforcement(&mut self, plan: &Problem<'_>, committed: &State) {
        let rows = |point: &LinearPoint| match point.stiffness > 0.0 {
            true if point.integrated => INTEGRATED_ROWS,
            true if point.sliding.is_some() => 1.0 + plan.contact.directions as f64,
            true => 1.0,
            false => 0.0,
        };
        let rows: f64 = self.points.iter().map(rows).sum();
        let few = match solver(&mut self.systems).answers_on_interface() {
            true => DENSE_ROWS_ON_INTERFACE,
            false => DENSE_ROWS,
        };
        let by_size = match rows < few || self.only_dense {
            true => Enforcement::Dense,
            false => Enforcement::MatrixFree,
        };
        self.enforcement = plan.enforcement.unwrap_or(by_size);
        let is_free = self.enforcement == Enforcement::MatrixFree;
        if !plan.contact.points.is_empty() {
            let wanted = if is_free { Use::Interface } else { Use::Many };
            solver(&mut self.systems).set_use(wanted);
        }
        if is_free {
            let context = context(plan, committed, self.dt);
            let Self { values, augmented, systems, points, .. } = self;
            let (pattern, symmetrised, solver) =
                (plan.pattern, plan.symmetrised(), solver(systems));
            let stiffness = Stiffness { pattern, values, augmented, solver, symmetrised };
            context.augment(points, &stiffness);
        }
    }

    pub(super) fn add_geometry(&mut self, plan: &Problem<'_>, before: &PointState, place: usize) {
        let kinematics = &self.evaluation.kinematics.at(place);
        let width = kinematics.rows.width();
        let forces =
            (kinematics.area * self.pressures[place], kinematics.area * self.tractions[place]);
        let at = (&self.u[..], self.evaluation.positions(), before);
        let geometry = &mut self.geometry;
        plan.contact.geometric_tangent(place, at, kinematics, forces, geometry);
        let at = |i: usize, j: usize| geometry.tangent[width * i + j];
        plan.scatter(&self.evaluation.rows, kinematics.rows.unknowns, at, &mut self.values);
    }

    /// Adds what the turning of rigid links makes of the forces that the
    /// tangent is taken at: of estimated stresses, pressures and tractions.
    fn turn(&mut self, plan: &Problem<'_>) {
        if !plan.constraints.turns() {
            return;
        }
        let (evaluation, turning) = (&self.evaluation, &mut self.turning);
        turning.iter_mut().zip(&self.load).for_each(|(force, load)| *force = -load);
        turning.iter_mut().zip(&evaluation.pressed).for_each(|(force, load)| *force -= load);
        let stresses = Some(&self.stresses[..]);
        let at = (&self.u[..], &self.turns[..]);
        plan.structure.turning_forces(at, stresses, &evaluation.contributions, turning);
        for linear in self.points.iter().filter(|point| !self.opened[point.pair]) {
            let (p, tau) = (self.pressures[linear.place], self.tractions[linear.place]);
            evaluation.kinematics.at(linear.place).press(p, tau, turning);
        }
        plan.stiffen_by_turning(&evaluation.rows, (at, turning), &mut self.values);
    }
}

/// Augmentation stiffness per area of a point [F/L3]: a part of that of the stiffest
/// element. Without elements, of one that the largest load would shorten by the
/// size of the model; where nothing has a size, any.
pub fn augmentation_stiffness(plan: &Problem<'_>, point: &SlavePoint) -> f64 {
    let load = plan.largest_load;
    let scale = match plan.structure.stiffest > 0.0 {
        true => AUGMENTATION * plan.structure.stiffest,
        false if plan.reach > 0.0 => load / plan.reach,
        false => load,
    };
    if scale > 0.0 && point.area > 0.0 {
        let points = if point.is_integration_point() { SEGMENT_POINTS as f64 } else { 1.0 };
        scale / (points * point.area)
    } else {
        1.0
    }
}
