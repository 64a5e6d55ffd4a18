//! A step to be solved: model and plan, with the values that were taken.
//!
//! ```text
//!   Model (what)  Plan (numbering)  Values (numbers)
//!        \_____________|_______________/
//!                   Problem --> evaluate(problem, committed, trial)
//! ```

mod held_points;

use crate::constraints::{Constraints, Rows};
use crate::contact::{Candidates, Contact};
use crate::continued::Continued;
use crate::dofs::DofMap;
use crate::linear_systems::LinearSystems;
use crate::linearised::LinearRows;
use crate::loads::FaceLoads;
use crate::plan::{Coupling, Numbering};
use crate::restraint::loose::{Firmness, LooseBodies};
use crate::start::Start;
use crate::structure::{Gather, Structure};
use crate::values::Values;
use rayon::ThreadPool;
use slideline_linalg::{Kind, Pattern, Solver};
use slideline_mech::contact::enforcement::Enforcement;
use slideline_mech::contact::pair::Laws;
use slideline_mech::turn::Turn;
use slideline_model::{ContactPair, Model, Step};

/// Everything about a step that does not change from increment to increment.
#[derive(Clone, Copy)]
pub struct Problem<'a> {
    /// The model.
    pub model: &'a Model,
    /// The step.
    pub step: &'a Step,
    /// The step before it.
    pub before: Option<&'a Step>,
    /// Dofs of all nodes.
    pub dofs: &'a DofMap,
    /// Which of them are unknown, and how the others follow.
    pub constraints: Constraints<'a>,
    /// Elements.
    pub structure: Structure<'a>,
    /// Contact.
    pub contact: &'a Contact,
    /// Sparsity of the tangent.
    pub pattern: &'a Pattern,
    /// Parts of their masters that it lets points touch, where these are not all.
    pub near: &'a [Candidates],
    /// Dofs that belong to elements.
    pub elastic: &'a [bool],
    /// Bodies that contact alone holds.
    pub loose: &'a LooseBodies,
    /// How firm each of them is.
    pub firmness: &'a [Firmness],
    /// Largest coordinate of the model [L].
    pub reach: f64,
    /// Length of the stiffest element, or else of the model [L].
    pub lever: f64,
    /// Natural unit of each unknown: 1 for displacements, 1/l for rotations,
    /// with l the length of the stiffest element (or of the model), so that
    /// all entries of the tangent are stiffnesses F/L.
    pub units: &'a [f64],
    /// Whether couplings of contact may be missing from the pattern.
    pub is_lenient: bool,
    /// How contact is solved, where not by its size.
    pub enforcement: Option<Enforcement>,
    /// Largest concentrated load at the beginning or the end of the step, moments over the size of the model [F].
    pub largest_load: f64,
    /// Faces that are pressed.
    pub faces: &'a FaceLoads,
    /// What the step begins from.
    pub start: &'a Start<'a>,
    /// How it is solved.
    pub means: Means<'a>,
}

/// With what a step is solved.
#[derive(Clone, Copy)]
pub struct Means<'a> {
    /// Threads for element loops; none: this one.
    pub pool: Option<&'a ThreadPool>,
    /// What makes the linear systems.
    pub linear_systems: &'a LinearSystems,
}

impl<'a> Problem<'a> {
    /// The pair of the model that a contact point belongs to, or whose edge it is.
    pub fn pair_of(&self, place: usize) -> &'a ContactPair {
        &self.model.contact_pairs[self.contact.parent(self.contact.points[place].pair)]
    }

    /// A step of a model, by its index, that begins from `start`: with the values that were
    /// taken from the model, and a coupling of the plan.
    pub fn new(
        (model, index): (&'a Model, usize),
        (plan, values): (&'a Numbering, &'a Values),
        coupling: &'a Coupling,
        start: &'a Start<'a>,
        means: Means<'a>,
    ) -> Self {
        let step = &model.steps[index];
        let numbered = plan.of_step[index];
        let numbering = &plan.steps[numbered];
        let constraints = Constraints { numbering: &numbering.constraints, motion: &values.motion };
        let structure = Structure {
            numbering: &plan.elements,
            kernels: &values.kernels,
            dependent: &numbering.dependent,
            entries: &coupling.entries,
            absent: &plan.absent[index],
            references: &start.references,
            initial: &model.initial_temperatures,
            nlgeom: step.nlgeom,
            stiffest: values.kernels.stiffest,
            stiffest_length: values.kernels.stiffest_length,
        };
        let before = index.checked_sub(1).and_then(|index| model.steps.get(index));
        let continued = Continued { amplitudes: &model.amplitudes, before };
        Self {
            model,
            step,
            before,
            dofs: &plan.dofs,
            constraints,
            structure,
            contact: &values.contact,
            pattern: &coupling.pattern,
            near: &coupling.near,
            elastic: &plan.elastic,
            loose: &plan.loose[index],
            firmness: values.loose.get(index).map_or(&[], Vec::as_slice),
            reach: values.reach,
            lever: values.lever,
            units: &values.units[numbered],
            is_lenient: false,
            enforcement: None,
            largest_load: continued.largest_load(step, values.reach),
            faces: &values.faces[index],
            start,
            means,
        }
    }

    /// Symbolic factorisation: unsymmetric where there is friction, unless
    /// the deck says `UNSYMM=NO`.
    pub fn analyse(&self) -> Solver {
        let mut solver =
            Solver::analyse(self.pattern, self.kind(), self.means.linear_systems.factory());
        solver.set_units(self.units);
        solver
    }

    /// The symmetry of the tangent as it is factored.
    pub fn kind(&self) -> Kind {
        kind(self.model, self.step, self.contact)
    }

    /// Whether contact laws stand in the equations of the structure.
    pub fn inserts_laws(&self) -> bool {
        self.enforcement.is_some_and(Enforcement::inserts_laws)
    }

    /// Whether contact makes the tangent unsymmetric and the deck wants a symmetric one.
    pub fn symmetrised(&self) -> bool {
        let contact = &self.contact;
        let rubs = || contact.laws.iter().any(Laws::has_friction);
        self.step.unsymmetric == Some(false) && (rubs() || contact.has_unsymmetric_mortar())
    }

    /// Whether the deck wants the symmetric part of a tangent that is none: the solution is found by it, its
    /// derivatives are not.
    pub fn is_solved_by_symmetric_part(&self) -> bool {
        let as_it_is = kind_of((self.model, self.step), self.contact, None);
        as_it_is == Kind::Unsymmetric && self.kind() == Kind::Symmetric
    }

    /// Whether the pattern holds all couplings of a point.
    pub fn holds(&self, point: LinearRows<'_>) -> bool {
        if self.is_lenient || !self.contact.is_selective(point.pair) {
            return true;
        }
        let own = point.rows.unknowns;
        let pairs =
            own.iter().enumerate().flat_map(|(k, &i)| own[..k].iter().map(move |&j| (i, j)));
        pairs.into_iter().all(|(i, j)| self.pattern.position(i, j).is_some())
    }

    /// Average length of the contact elements of a pair [L].
    pub fn contact_length(&self, pair: &slideline_model::ContactPair) -> f64 {
        crate::contact::mean_length(self.model, pair)
    }

    /// Where tangents of elements are summed, at a configuration with these rows.
    pub fn gather<'b>(&'b self, rows: &'b Rows, values: &'b mut [f64]) -> Gather<'b> {
        let (constraints, pattern) = (self.constraints, self.pattern);
        Gather { constraints, rows, pattern, values, product: None, keep: None }
    }

    /// Adds what the turning of constraints makes of forces `f` on all dofs; uses
    /// them up.
    pub fn stiffen_by_turning(
        &self,
        rows: &Rows,
        (at, f): ((&[f64], &[Turn]), &mut [f64]),
        values: &mut [f64],
    ) {
        let (constraints, pattern) = (self.constraints, self.pattern);
        constraints.turning(rows, at, f, |row, column, stiffness| {
            constraints.for_each_equation(rows, row, &mut |row, a| {
                constraints.for_each_equation(rows, column, &mut |column, b| {
                    if let Some(at) = pattern.position(row, column) {
                        values[at] += a * b * stiffness;
                    }
                });
            });
        });
    }

    /// Takes the derivative of the forces of pressures and tractions on faces and beams from the tangent.
    pub fn stiffen_by_faces(&self, rows: &Rows, at: (&[f64], &[f64], &[Turn]), values: &mut [f64]) {
        self.faces.stiffen((self.constraints, self.pattern, self.kind()), rows, at, values);
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
        self.constraints.scatter((rows, self.pattern), dofs, tangent, values);
    }
}

/// The symmetry of the tangent of a step: none where there is friction, a pressure or traction that follows
/// its face, softened contact spread over faces, contact over faces in space, or a moment about a fixed axis in space, unless the deck says otherwise.
pub fn kind(model: &Model, step: &Step, contact: &Contact) -> Kind {
    kind_of((model, step), contact, step.unsymmetric)
}

fn kind_of((model, step): (&Model, &Step), contact: &Contact, wanted: Option<bool>) -> Kind {
    let rubs = || contact.laws.iter().any(Laws::has_friction);
    let unsymmetric = || follows(model, step) || rubs() || contact.has_unsymmetric_mortar();
    if wanted.unwrap_or_else(unsymmetric) { Kind::Unsymmetric } else { Kind::Symmetric }
}

/// Whether an unsymmetric tangent is symmetric but for what contact makes of it: its laws are kept apart,
/// and what is left is the turning of tractions.
pub fn is_nearly_symmetric(model: &Model, step: &Step, contact: &Contact) -> bool {
    kind(model, step, contact) == Kind::Unsymmetric && !follows(model, step)
}

/// Whether loads follow the motion.
fn follows(model: &Model, step: &Step) -> bool {
    let turns = || model.is_in_space() && step.loads.iter().any(|load| load.dof.is_rotation());
    let follows = || step.distributed.pressures.iter().any(|own| !own.on.is_turning());
    step.nlgeom && (follows() || turns())
}
