//! Roles of all dofs, equations of the unknowns, and which dofs the others follow.

use super::deserted::deserted;
use super::joined::joined;
use super::linear::{self, Kept, LinearConstraint};
use super::rigid::{self, RigidLink};
use crate::dofs::DofMap;
use slideline_model::{Dialect, Dof, Model, NodeIndex, Step};

/// What a dof is in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Nothing uses it that is there; it stays where it is.
    Inactive,
    /// Unknown; its equation.
    Free(usize),
    /// Prescribed; its index in the step's list.
    Prescribed(usize),
    /// Follows others; its row among those of the constraints.
    Dependent(usize),
}

/// Roles of all dofs, equations of the unknowns, and which dofs the others follow:
/// what a plan holds of the constraints of a step.
#[derive(Clone, Debug, PartialEq)]
pub struct ConstraintNumbering {
    /// Role of every dof.
    pub roles: Vec<Role>,
    /// Dof of every equation.
    pub dof_of_equation: Vec<usize>,
    /// Dofs that only absent elements and contact pairs use, and that follow nothing that is there,
    /// ascending.
    pub deserted: Vec<usize>,
    pub(super) rigid: Vec<RigidLink>,
    pub(super) linear: Vec<LinearConstraint>,
    /// How many linear constraints come before the rigid bodies.
    pub(super) leading: usize,
    /// Nodes with axes of their own, each with its transform.
    pub(super) turned: Vec<(NodeIndex, usize)>,
    /// Dofs, along the axes in which the deck names them, that equations name and that follow rigid
    /// bodies; none where the dialect does not ask for them.
    pub joined: Vec<usize>,
    /// Dofs of the nodes that rigid bodies follow, asked for as those.
    pub of_bodies: Vec<usize>,
    /// Nodes of the shapes of the model, shape by shape.
    pub(super) shape_nodes: Vec<NodeIndex>,
    /// Dependent dof of every row.
    pub(super) dependent_dofs: Vec<usize>,
    /// Those that their row leads, with it, in the order of the rows.
    pub(super) led: Vec<(usize, usize)>,
    /// Where the row of each dependent dof begins; behind the last, the end.
    pub(super) row_start: Vec<usize>,
    /// The dofs of the rows.
    pub(super) row_dofs: Vec<usize>,
    /// The node whose dofs carry a node.
    pub(super) carrier: Vec<NodeIndex>,
}

impl ConstraintNumbering {
    /// That of a step of a model.
    pub fn new(model: &Model, step: &Step, dofs: &DofMap) -> Self {
        let (rigid, carrier) = rigid::resolve(model, dofs);
        let (linear, leading) = linear::resolve((model, step.nlgeom), dofs, &rigid);
        let mut new = Self {
            roles: vec![Role::Inactive; dofs.len()],
            dof_of_equation: Vec::new(),
            deserted: Vec::new(),
            rigid,
            linear,
            leading,
            turned: dofs.turned().to_vec(),
            joined: Vec::new(),
            of_bodies: Vec::new(),
            shape_nodes: model.shapes.iter().flat_map(|own| own.nodes.iter().copied()).collect(),
            dependent_dofs: Vec::new(),
            led: Vec::new(),
            row_start: vec![0],
            row_dofs: Vec::new(),
            carrier,
        };
        new.roles
            .iter_mut()
            .enumerate()
            .filter(|(dof, _)| dofs.is_active(*dof))
            .for_each(|(_, role)| *role = Role::Free(0));
        new.add_rows();
        let rows = new.dependent_dofs.iter().zip(new.row_start.windows(2));
        let rows = rows.map(|(&dof, row)| (dof, &new.row_dofs[row[0]..row[1]]));
        new.deserted = deserted((model, step), dofs, rows);
        for &dof in &new.deserted {
            if matches!(new.roles[dof], Role::Free(_)) {
                new.roles[dof] = Role::Inactive;
            }
        }
        for (place, prescribed) in step.prescribed.iter().enumerate() {
            if let Some(dof) = dofs.named(prescribed.node, prescribed.dof) {
                new.roles[dof] = Role::Prescribed(place);
            }
        }
        new.number_unknowns();
        new.led = new.dependents().collect();
        if model.dialect == Dialect::Calculix {
            [new.joined, new.of_bodies] = joined(&new.linear, &new.rigid);
        }
        new
    }

    /// Gives every dependent dof its role and a row of the dofs it follows.
    fn add_rows(&mut self) {
        let Self { roles, rigid, linear, leading, dependent_dofs, row_start, row_dofs, .. } = self;
        let of_links = rigid.iter().map(|link| link.dependent_dofs().count()).sum::<usize>();
        let dependents = of_links + linear.len();
        dependent_dofs.reserve_exact(dependents);
        row_start.reserve_exact(dependents);
        let followed = linear.iter().map(|constraint| constraint.terms.len());
        row_dofs.reserve(2 * of_links + followed.sum::<usize>());
        let mut add = |dependent: usize, followed: &mut dyn Iterator<Item = usize>| {
            roles[dependent] = Role::Dependent(row_start.len() - 1);
            dependent_dofs.push(dependent);
            row_dofs.extend(followed);
            row_start.push(row_dofs.len());
        };
        let (leading, linear) = linear.split_at(*leading);
        for constraint in leading {
            add(constraint.dependent, &mut constraint.terms.iter().map(|&(dof, _)| dof));
        }
        for link in rigid {
            for (component, dependent) in link.dependent_dofs() {
                add(dependent, &mut link.followed(component).into_iter().flatten());
            }
        }
        for constraint in linear {
            add(constraint.dependent, &mut constraint.terms.iter().map(|&(dof, _)| dof));
        }
    }

    fn dependents(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let all = self.dependent_dofs.iter().enumerate().map(|(row, &dof)| (dof, row));
        all.filter(|&(dof, row)| self.roles[dof] == Role::Dependent(row))
    }

    fn number_unknowns(&mut self) {
        let is_free = |role: &&Role| matches!(role, Role::Free(_));
        self.dof_of_equation.reserve_exact(self.roles.iter().filter(is_free).count());
        for (dof, role) in self.roles.iter_mut().enumerate() {
            if matches!(role, Role::Free(_)) {
                *role = Role::Free(self.dof_of_equation.len());
                self.dof_of_equation.push(dof);
            }
        }
    }

    /// Whether some dofs follow others.
    pub fn has_dependents(&self) -> bool {
        !self.dependent_dofs.is_empty()
    }

    /// Number of unknowns.
    pub fn equations(&self) -> usize {
        self.dof_of_equation.len()
    }

    /// The equation of a dof that is unknown.
    pub fn equation(&self, dof: usize) -> Option<usize> {
        match self.roles[dof] {
            Role::Free(equation) => Some(equation),
            _ => None,
        }
    }

    /// Whether a dof follows others.
    pub fn is_dependent(&self, dof: usize) -> bool {
        matches!(self.roles[dof], Role::Dependent(_))
    }

    /// The node whose dofs carry this one, as part of a rigid body.
    pub fn carrier(&self, node: NodeIndex) -> NodeIndex {
        self.carrier[node]
    }

    /// Dependent dofs that keep a shape or a mean motion: what each follows is coupled.
    pub fn kept(&self) -> impl Iterator<Item = &usize> {
        let coupling = |own: &&LinearConstraint| match &own.kept {
            Kept::Shape(_) => true,
            // its rows follow the same
            Kept::Mean(mean) => mean.as_ref().is_some_and(|own| own.couples()),
            Kept::Nothing => false,
        };
        self.linear.iter().filter(coupling).map(|own| &own.dependent)
    }

    /// Adds the equations that a dof depends on.
    pub fn equations_of(&self, dof: usize, into: &mut Vec<usize>) {
        match self.roles[dof] {
            Role::Free(equation) => into.push(equation),
            Role::Dependent(row) => {
                for &followed in &self.row_dofs[self.row_start[row]..self.row_start[row + 1]] {
                    self.equations_of(followed, into);
                }
            }
            Role::Inactive | Role::Prescribed(_) => {}
        }
    }

    /// Whether the rotations of a node in space may count from a new start. What holds some of them
    /// and not others, or links them by an equation, means rotation vectors from the old start:
    /// from a new one its forces would point elsewhere, and nothing would balance them.
    pub fn may_turn_anew(&self, node: NodeIndex, dofs: &DofMap) -> bool {
        let node = self.carrier(node);
        let rotations = [Dof::UR1, Dof::UR2, Dof::UR3].map(|kind| dofs.named(node, kind));
        let role = |dof: Option<usize>| dof.map(|dof| self.roles[dof]);
        if rotations.iter().all(|&dof| matches!(role(dof), Some(Role::Prescribed(_)))) {
            return true;
        }
        let free = rotations.iter().all(|&dof| matches!(role(dof), Some(Role::Free(_))));
        (free || self.follow_a_mean(&rotations))
            && !self.linear.iter().any(|constraint| constraint.links(&rotations))
    }

    /// Whether all of some dofs follow the mean motion of a cloud.
    fn follow_a_mean(&self, dofs: &[Option<usize>]) -> bool {
        let means = self.linear.iter().filter(|own| matches!(own.kept, Kept::Mean(_)));
        let follow: Vec<usize> = means.map(|own| own.dependent).collect();
        dofs.iter().all(|dof| dof.is_some_and(|dof| follow.contains(&dof)))
    }

    /// Whether T turns with the unknowns.
    pub fn turns(&self) -> bool {
        !self.rigid.is_empty() || self.linear.iter().any(|own| !own.kept.is_nothing())
    }

    /// Whether T may turn where the dofs move so.
    pub fn turns_along(&self, moved: &[f64]) -> bool {
        self.linear.iter().any(|own| !own.kept.is_nothing())
            || self.rigid.iter().any(|link| link.turns_along(moved))
    }
}
