//! A step, prepared once: numbering, pattern, symbolic factorisation.

use crate::constraints::{Constraints, Role, Rows};
use crate::contact::{Cliques, Contact, PointRows};
use crate::dofs::DofMap;
use crate::linear_systems::LinearSystems;
use crate::structure::{Contributions, Structure};
use crate::users::UserFrictions;
use rayon::ThreadPool;
use serde::{Deserialize, Serialize};
use slideline_linalg::{Kind, Pattern, Solver};
use slideline_mech::contact::enforcement::Enforcement;
use slideline_mech::contact::pair::Laws;
use slideline_model::{Amplitude, Master, Model, Step, SurfaceSegment};
use std::borrow::Cow;

/// Everything about a step that does not change from increment to increment.
pub struct Plan<'a> {
    /// The model.
    pub model: &'a Model,
    /// The step.
    pub step: &'a Step,
    /// Dofs of all nodes.
    pub dofs: DofMap,
    /// Which of them are unknown, and how the others follow.
    pub constraints: Constraints,
    /// Elements.
    pub structure: Structure,
    /// Contact.
    pub contact: Contact,
    /// Sparsity of the tangent.
    pub pattern: Pattern,
    /// Dofs that belong to elements.
    pub elastic: Vec<bool>,
    /// Largest coordinate of the model [L].
    pub reach: f64,
    /// Length of the stiffest element, or else of the model [L].
    pub lever: f64,
    /// Natural unit of each unknown: 1 for displacements, 1/l for rotations,
    /// with l the length of the stiffest element (or of the model), so that
    /// all entries of the tangent are stiffnesses F/L.
    pub units: Vec<f64>,
    /// Whether couplings of contact may be missing from the pattern.
    pub is_lenient: bool,
    /// How contact is solved, where not by its size.
    pub enforcement: Option<Enforcement>,
    /// Largest load of the step [F or F L].
    pub largest_load: f64,
    /// Threads for element loops; none: this one.
    pub pool: Option<&'a ThreadPool>,
    start: Start<'static>,
    linear_systems: LinearSystems,
}

/// What a step begins from, a dof each.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Start<'a> {
    /// Displacements and rotations [L or 1].
    pub displacement: Cow<'a, [f64]>,
    /// Applied loads [F or F L].
    pub load: Cow<'a, [f64]>,
    /// Reactions of supports that the step releases; they ramp off over it
    /// [F or F L].
    pub released: Cow<'a, [f64]>,
}

impl Start<'_> {
    /// Of an undeformed model without loads.
    pub fn undeformed(dofs: usize) -> Start<'static> {
        let zero = || Cow::Owned(vec![0.0; dofs]);
        Start { displacement: zero(), load: zero(), released: zero() }
    }

    /// The same, to be kept.
    pub fn owned(&self) -> Start<'static> {
        Start {
            displacement: Cow::Owned(self.displacement.clone().into_owned()),
            load: Cow::Owned(self.load.clone().into_owned()),
            released: Cow::Owned(self.released.clone().into_owned()),
        }
    }

    /// The same, borrowed.
    pub fn borrowed(&self) -> Start<'_> {
        Start {
            displacement: Cow::Borrowed(&self.displacement),
            load: Cow::Borrowed(&self.load),
            released: Cow::Borrowed(&self.released),
        }
    }
}

impl<'a> Plan<'a> {
    /// Prepares a step that begins from the state given. Of the reactions that
    /// `start` names as released, those of dofs that the step leaves free
    /// become loads that ramp off.
    pub fn new(
        model: &'a Model,
        step: &'a Step,
        start: Start<'static>,
        users: &UserFrictions,
        pool: Option<&'a ThreadPool>,
    ) -> Self {
        let displacement = start.displacement.clone();
        let mut plan = Self::without_pattern(model, step, start, users, pool);
        plan.take_in(&[&*displacement]);
        plan
    }

    /// The same with an empty pattern: enough to look at contact.
    pub fn without_pattern(
        model: &'a Model,
        step: &'a Step,
        mut start: Start<'static>,
        users: &UserFrictions,
        pool: Option<&'a ThreadPool>,
    ) -> Self {
        let dofs = DofMap::new(model);
        let constraints = Constraints::new(model, step, &dofs);
        let structure = Structure::new(model, (&dofs, &constraints), step.nlgeom);
        let contact = Contact::new(model, &dofs, users);
        let pattern = Pattern::from_pairs(0, std::iter::empty());
        let elastic = structure.touched(dofs.len());
        let reach = model
            .nodes
            .iter()
            .flat_map(|node| node.position)
            .chain(surface_points(model))
            .fold(0.0, |largest: f64, x| largest.max(x.abs()));
        for (dof, force) in start.released.to_mut().iter_mut().enumerate() {
            if constraints.equation(dof).is_none() {
                *force = 0.0;
            }
        }
        let lever = match structure.stiffest_length > 0.0 {
            true => structure.stiffest_length,
            false => reach,
        };
        let unit = |dof: &usize| match dofs.is_rotation(*dof) {
            true if lever > 0.0 => 1.0 / lever,
            _ => 1.0,
        };
        let units = constraints.dof_of_equation.iter().map(unit).collect();
        Self {
            model,
            step,
            dofs,
            constraints,
            structure,
            contact,
            pattern,
            elastic,
            reach,
            lever,
            units,
            is_lenient: false,
            largest_load: step.loads.iter().fold(0.0, |most, load| load.value.abs().max(most)),
            enforcement: None,
            pool,
            start,
            linear_systems: LinearSystems::default(),
        }
    }

    /// Makes the pattern anew, with the contact that is near in these states.
    pub fn take_in(&mut self, states: &[&[f64]]) {
        self.pattern = coupled(&self.structure, &self.contact, &self.constraints, states);
        self.structure.find_entries(&self.constraints, &self.pattern);
    }

    /// The same with linear systems made elsewhere.
    pub fn with_linear_systems(mut self, systems: &LinearSystems) -> Self {
        self.linear_systems = systems.clone();
        self
    }

    /// What the step begins from.
    pub fn start(&self) -> &Start<'static> {
        &self.start
    }

    /// Symbolic factorisation: unsymmetric where there is friction, unless
    /// the deck says `UNSYMM=NO`.
    pub fn analyse(&self) -> Solver {
        let kind = if self.unsymmetric() { Kind::Unsymmetric } else { Kind::Symmetric };
        let factory = self.linear_systems.factory();
        Solver::analyse(&self.pattern, kind, factory).with_units(self.units.clone())
    }

    /// Whether the tangent is factored as an unsymmetric matrix.
    pub fn unsymmetric(&self) -> bool {
        match self.step.unsymmetric {
            Some(said) => said,
            None => self.contact.laws.iter().any(Laws::has_friction),
        }
    }

    /// Whether friction is there and the deck wants a symmetric tangent.
    pub fn symmetrised(&self) -> bool {
        self.step.unsymmetric == Some(false) && self.contact.laws.iter().any(Laws::has_friction)
    }

    /// Whether some unknown moves a point towards or from its master.
    pub fn contact_yields(&self, kinematics: &PointRows<'_>, rows: &Rows) -> bool {
        let mut yields = false;
        for (&dof, &g) in kinematics.rows.unknowns.iter().zip(kinematics.rows.normal()) {
            let note = &mut |_: usize, a: f64| yields |= a * g != 0.0;
            self.constraints.for_each_equation(rows, dof, note);
        }
        yields
    }

    /// Average length of the contact elements of a pair [L].
    pub fn contact_length(&self, pair: &slideline_model::ContactPair) -> f64 {
        crate::contact::average_element(self.model, pair)
    }

    /// Sums the tangents of the elements into matrix values.
    pub fn gather_tangent(&self, from: &Contributions, rows: &Rows, values: &mut [f64]) {
        self.structure.gather_tangent(from, (&self.constraints, rows, &self.pattern), values);
    }

    /// Adds what the turning of constraints makes of forces `f` on all dofs; uses
    /// them up.
    pub fn stiffen_by_turning(&self, u: &[f64], f: &mut [f64], values: &mut [f64]) {
        self.constraints.turning(u, f, |row, column, stiffness| {
            let equations = [row, column].map(|dof| self.constraints.equation(dof));
            let [Some(row), Some(column)] = equations else { return };
            if let Some(at) = self.pattern.position(row, column) {
                values[at] += stiffness;
            }
        });
    }

    /// Adds T' K T of a stencil to matrix values: `dofs` are its own, `tangent`
    /// by row and column.
    pub fn scatter(
        &self,
        rows: &Rows,
        dofs: &[usize],
        tangent: impl Fn(usize, usize) -> f64,
        values: &mut [f64],
    ) {
        self.constraints.scatter((rows, &self.pattern), dofs, tangent, values);
    }

    /// Puts the prescribed values of a time of the step into `u`.
    pub fn prescribe(&self, step_time: f64, u: &mut [f64]) {
        for (dof, role) in self.constraints.roles.iter().enumerate() {
            if let Role::Prescribed(place) = *role {
                let prescribed = &self.step.prescribed[place];
                let amplitude = prescribed.amplitude.map(|a| &self.model.amplitudes[a]);
                u[dof] =
                    self.at(step_time, self.start.displacement[dof], prescribed.value, amplitude);
            }
        }
    }

    /// Puts the loads of a time of the step into `load`.
    pub fn load(&self, step_time: f64, load: &mut [f64]) {
        load.fill(0.0);
        for (dof, value) in load.iter_mut().enumerate() {
            // What the step before applied and this one does not fades out.
            *value = self.at(step_time, self.start.load[dof], 0.0, None);
        }
        for entry in &self.step.loads {
            let Some(dof) = self.dofs.find(entry.node, entry.dof) else { continue };
            let amplitude = entry.amplitude.map(|a| &self.model.amplitudes[a]);
            load[dof] = self.at(step_time, self.start.load[dof], entry.value, amplitude);
        }
        // A support that is released lets go over the step (manual).
        for (value, &reaction) in load.iter_mut().zip(&*self.start.released) {
            *value += self.at(step_time, reaction, 0.0, None);
        }
    }

    /// A value between the start of the step and its end.
    fn at(&self, step_time: f64, start: f64, end: f64, amplitude: Option<&Amplitude>) -> f64 {
        let period = self.step.procedure.period;
        match amplitude {
            Some(amplitude) => end * amplitude.at(step_time),
            None if self.step.at_once || step_time >= period => end,
            None => start + (end - start) * (step_time / period),
        }
    }
}

/// The pattern of elements and of the contact that is near in some states.
fn coupled(
    structure: &Structure,
    contact: &Contact,
    constraints: &Constraints,
    states: &[&[f64]],
) -> Pattern {
    // many points with prescribed dofs couple the same unknowns of their master
    let near = contact.cliques(states, constraints);
    let coupling = || near.iter().filter(|own| own.len() > 1);
    let mut several: Vec<&[usize]> = Vec::with_capacity(coupling().count());
    several.extend(coupling());
    several.sort_unstable();
    several.dedup();
    let (elements, dofs) = structure.size_of_cliques();
    let mut own = Cliques::with_room(elements, dofs);
    structure.cliques().for_each(|dofs| own.add(constraints, dofs));
    Pattern::from_cliques(constraints.equations(), own.iter().chain(several))
}

/// Coordinates of the points of all rigid surfaces.
fn surface_points(model: &Model) -> impl Iterator<Item = f64> {
    let surfaces = model.contact_pairs.iter().filter_map(|pair| match &pair.master {
        Master::RigidSurface(surface) => Some(surface),
        Master::SlideLine(_) => None,
    });
    surfaces.flat_map(|surface| {
        let ends = surface.segments.iter().flat_map(|segment| match *segment {
            SurfaceSegment::Line { end } => [end, end],
            SurfaceSegment::Circle { end, centre } => [end, centre],
            SurfaceSegment::Parabola { middle, end } => [middle, end],
        });
        std::iter::once(surface.start).chain(ends).flatten()
    })
}
