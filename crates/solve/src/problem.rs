//! A step to be solved: model and plan, with the values that were taken.
//!
//! ```text
//!   Model (what)  Plan (numbering)  Values (numbers)
//!        \_____________|_______________/
//!                   Problem --> evaluate(problem, committed, trial)
//! ```

use crate::constraints::{Constraints, Role, Rows};
use crate::contact::{Candidates, Contact, PointRows};
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

/// Part of a gap's change with its own nodes that unknowns must reach for contact to hold it [1]: less is the
/// turning of normals, or rounding. (choice)
const LEAST_LEVER: f64 = 1e-6;

/// Part of what a point's own node does to its gap that constraints may leave of it for the node to be one with the master [1].
/// (choice)
const JOINED: f64 = 1e-2;

/// Part of the largest factor of a gap from which on a dof of its node counts [1]. (choice)
const ALONG: f64 = 0.1;

/// Part of a slave face by which held surfaces may overlap where the normals beside them turn [1]. (choice)
const LITTLE: f64 = 0.01;

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

    /// Whether some unknown moves a point towards or from its master. Where slave and master are both held, or one follows
    /// the other, what is left is how the normal turns about a gap that is there already, and no force closes that.
    pub fn contact_yields(&self, kinematics: &PointRows<'_>, rows: &Rows) -> bool {
        let (unknowns, normal) = (kinematics.rows.unknowns, kinematics.rows.normal());
        let least = LEAST_LEVER * normal.iter().fold(0.0_f64, |whole, g| whole.max(g.abs()));
        let own = || unknowns.iter().copied().zip(normal.iter().copied());
        let is_free = |dof: usize| matches!(self.constraints.roles[dof], Role::Free(_));
        let follows = own().any(|(dof, g)| g != 0.0 && !is_free(dof));
        own().any(|(dof, g)| {
            let mut yields = false;
            self.constraints.for_each_equation(rows, dof, &mut |equation: usize, a: f64| {
                let lever = |x: f64| (x * self.units[equation]).abs();
                // what follows an unknown may move along with another one that is that unknown, or follows it
                yields |= lever(a * g) > least
                    && (!follows || lever(self.moved_by(own(), rows, equation)) > least);
            });
            yields
        })
    }

    /// What an equation moves of dofs by these factors.
    fn moved_by(
        &self,
        factors: impl Iterator<Item = (usize, f64)>,
        rows: &Rows,
        equation: usize,
    ) -> f64 {
        let mut sum = 0.0;
        for (dof, g) in factors {
            self.constraints.for_each_equation(rows, dof, &mut |other: usize, a: f64| {
                sum += if other == equation { a * g } else { 0.0 };
            });
        }
        sum
    }

    /// Whether the own node of a point is one with its master there already, as constraints have it: what is left of its gap is
    /// that of nodes beside it, which are held by themselves.
    pub fn is_joined(&self, place: usize, kinematics: &PointRows<'_>, rows: &Rows) -> bool {
        let (unknowns, normal) = (kinematics.rows.unknowns, kinematics.rows.normal());
        let node = self.contact.points[place].node;
        let all = || unknowns.iter().copied().zip(normal.iter().copied());
        let follows = |(dof, _)| matches!(self.constraints.roles[dof], Role::Dependent(_));
        if !all().any(follows) {
            return false;
        }
        let (mut whole, mut left) = (0.0, 0.0);
        for (dof, g) in all().filter(|own| self.dofs.name(own.0).0 == node) {
            self.constraints.for_each_equation(rows, dof, &mut |equation: usize, a: f64| {
                let lever = |x: f64| (x * self.units[equation]).abs();
                whole += lever(a * g);
                left += lever(self.moved_by(all(), rows, equation));
            });
        }
        left < JOINED * whole || self.follows_master(node, (all, rows))
    }

    /// Whether a node follows nodes on the other side of the gap with these factors alone, a dof each.
    fn follows_master<I: Iterator<Item = (usize, f64)>>(
        &self,
        node: usize,
        (all, rows): (impl Fn() -> I, &Rows),
    ) -> bool {
        let most = all().fold(0.0_f64, |most, own| most.max(own.1.abs()));
        let mut followed = 0;
        for (dof, g) in all().filter(|own| own.1.abs() > ALONG * most) {
            if self.dofs.name(dof).0 != node {
                continue;
            }
            let mut all_across = matches!(self.constraints.roles[dof], Role::Dependent(_));
            self.constraints.for_each_equation(rows, dof, &mut |equation: usize, a: f64| {
                let leader = self.constraints.dof_of_equation[equation];
                let is_across = all().any(|(other, factor)| other == leader && factor * g < 0.0);
                all_across &= is_across || a.abs() < LEAST_LEVER;
                followed += 1;
            });
            if !all_across {
                return false;
            }
        }
        followed > 0
    }

    /// Whether a point and its master are held where they are: what little it overlaps by is of normals that turn
    /// beside it, and nothing can part them. What a prescribed motion brings closer is not, nor what overlaps by
    /// more.
    pub fn stands_held(
        &self,
        place: usize,
        (kinematics, rows): (&PointRows<'_>, &Rows),
        (u, from): (&[f64], &[f64]),
    ) -> bool {
        if self.touches_held_node(place, kinematics, (u, from))
            || self.is_joined(place, kinematics, rows)
        {
            return true;
        }
        let little = LITTLE * self.contact.spacing[self.contact.points[place].pair];
        if kinematics.overclosure > little || self.contact_yields(kinematics, rows) {
            return false;
        }
        let unknowns = kinematics.rows.unknowns.iter().zip(kinematics.rows.normal());
        let closer: f64 = unknowns
            .filter(|(dof, _)| !matches!(self.constraints.roles[**dof], Role::Free(_)))
            .map(|(&dof, g)| g * (u[dof] - from[dof]))
            .sum();
        closer <= LEAST_LEVER * little
    }

    /// Whether a slave node stands at a node of its master, as far as their surfaces are away, and both are held
    /// where they are: between them nothing gives way, whatever the faces beside them do.
    pub fn touches_held_node(
        &self,
        place: usize,
        kinematics: &PointRows<'_>,
        (u, from): (&[f64], &[f64]),
    ) -> bool {
        let point = &self.contact.points[place];
        if !point.is_node() || !self.is_held(point.node) {
            return false;
        }
        let little = LITTLE * self.contact.spacing[point.pair];
        let of = |u: &[f64], node: usize| self.dofs.translation(u, node);
        let apart = |node: usize, u: &[f64]| -> f64 {
            let [x, y] =
                [point.node, node].map(|node| (self.model.nodes.position(node), of(u, node)));
            let along = |k: usize| (x.0[k] + x.1[k]) - (y.0[k] + y.1[k]);
            (0..3).map(|k| along(k) * along(k)).sum::<f64>().sqrt()
        };
        let moves_alike = |node: usize| {
            let way = |node: usize, k: usize| of(u, node)[k] - of(from, node)[k];
            (0..3).all(|k| (way(node, k) - way(point.node, k)).abs() <= LEAST_LEVER * little)
        };
        let thick = self.contact.offset_of(point.pair);
        let nodes = kinematics.rows.unknowns.iter().map(|&dof| self.dofs.name(dof).0);
        nodes.filter(|&node| node != point.node).any(|node| {
            (apart(node, u) - thick).abs() <= little && self.is_held(node) && moves_alike(node)
        })
    }

    /// Whether supports hold a node along all axes.
    fn is_held(&self, node: usize) -> bool {
        self.dofs.of_node(node).all(|dof| {
            let is_held =
                matches!(self.constraints.roles[dof], Role::Prescribed(_) | Role::Inactive);
            is_held || self.dofs.is_rotation(dof)
        })
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
