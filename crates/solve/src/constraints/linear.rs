//! Dofs that follow others linearly, u = c + sum a u_k.
//!
//! ```text
//!   o a      o b        of an *EQUATION: as it says
//!    \____o___/         of a tie: the shape functions of the face
//!
//!     own 2 ^  ^ y  own 1      of a node with axes of its own: their cosines
//!            \ | /
//!             \|/--> x
//! ```

use super::mean::MeanRow;
use super::rigid::RigidLink;
use super::shapes::ShapeRow;
use crate::dofs::DofMap;
use slideline_model::{Axes, Model};
use std::collections::{HashMap, HashSet};

/// A dof that follows others.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct LinearConstraint {
    /// The dof that follows.
    pub dependent: usize,
    /// Dofs that it follows, each with the index of its term.
    pub terms: Vec<(usize, usize)>,
    /// Where the coefficients come from.
    pub source: Source,
    /// What it keeps in large motion; then its coefficients are those of the configuration.
    pub kept: Kept,
}

/// What a constraint keeps in large motion.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kept {
    /// Nothing: it is linear.
    Nothing,
    /// A shape.
    Shape(ShapeRow),
    /// With others the mean motion of a cloud: the first of these holds what all of them are.
    Mean(Option<Box<MeanRow>>),
}

impl Kept {
    /// Whether nothing is kept.
    pub fn is_nothing(&self) -> bool {
        *self == Self::Nothing
    }
}

impl LinearConstraint {
    /// Whether an equation of the model names one of these dofs.
    pub fn links(&self, dofs: &[Option<usize>]) -> bool {
        let named = |dof: usize| dofs.contains(&Some(dof));
        // of a cloud that turns far rotations mean what they mean from any start
        matches!(self.source, Source::Said(_))
            && !matches!(self.kept, Kept::Mean(_))
            && (named(self.dependent) || self.terms.iter().any(|&(dof, _)| named(dof)))
    }
}

/// Where the coefficients of a constraint come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Source {
    /// A constraint of the model, by its index.
    Said(usize),
    /// The own axes of a node, by its place among those that have some: the component along an
    /// axis of the model.
    Axes { place: usize, component: usize },
    /// None: it is another dof.
    Equal,
}

impl Source {
    /// The coefficient of a term.
    pub fn coefficient(self, model: &Model, axes: &[Axes], term: usize) -> f64 {
        match self {
            Self::Said(index) => model.linear_constraints[index].terms[term].2,
            Self::Axes { place, component } => axes[place][term][component],
            Self::Equal => 1.0,
        }
    }

    /// What is added [L or 1].
    pub fn constant(self, model: &Model) -> f64 {
        match self {
            Self::Said(index) => model.linear_constraints[index].constant,
            Self::Axes { .. } | Self::Equal => 0.0,
        }
    }
}

/// The linear constraints of a model, each behind those that it follows; one
/// that follows itself by way of others is left out. So many of the first are of nodes that
/// follow nothing but their own axes: rigid bodies may hang on these.
pub(super) fn resolve(
    (model, nlgeom): (&Model, bool),
    dofs: &DofMap,
    rigid: &[RigidLink],
) -> (Vec<LinearConstraint>, usize) {
    let mut open: Vec<LinearConstraint> = Vec::new();
    for (index, said) in model.linear_constraints.iter().enumerate() {
        let Some(dependent) = dofs.named(said.dependent.0, said.dependent.1) else { continue };
        let terms = said.terms.iter().enumerate();
        let terms =
            terms.filter_map(|(term, &(node, dof, _))| Some((dofs.named(node, dof)?, term)));
        open.push(LinearConstraint {
            dependent,
            terms: terms.collect(),
            source: Source::Said(index),
            kept: Kept::Nothing,
        });
    }
    match nlgeom {
        true => {
            keep_shapes(model, dofs, &mut open);
            keep_means(model, dofs, &mut open);
        }
        false => open.extend(resting(model, dofs)),
    }
    let linked = rigid.iter().flat_map(|link| link.dependent_dofs().map(|(_, dof)| dof));
    let follows: HashSet<usize> = open.iter().map(|own| own.dependent).chain(linked).collect();
    let mut ordered = Vec::with_capacity(open.len());
    for (place, &(node, _)) in dofs.turned().iter().enumerate() {
        let leads = dofs.named_of_node(node).all(|own| !follows.contains(&own));
        let into = if leads { &mut ordered } else { &mut open };
        into.extend(of_axes(dofs, place));
    }
    let leading = ordered.len();
    ordered.extend(in_order(open));
    (ordered, leading)
}

/// Lets the constraints of a model that keep a shape follow all dofs of its nodes.
fn keep_shapes(model: &Model, dofs: &DofMap, open: &mut [LinearConstraint]) {
    let said = |own: &LinearConstraint| match own.source {
        Source::Said(index) => Some(index),
        Source::Axes { .. } | Source::Equal => None,
    };
    let mut first = 0;
    for (place, shape) in model.shapes.iter().enumerate() {
        let row = ShapeRow::new(model, dofs, (place, first));
        first += shape.nodes.len();
        let Some(own) = open.iter_mut().find(|own| said(own) == Some(shape.constraint)) else {
            continue;
        };
        own.terms = row.followed(own.dependent).map(|dof| (dof, 0)).collect();
        own.kept = Kept::Shape(row);
    }
}

/// Puts what clouds are that turn far in place of the constraints that they are in small motion.
fn keep_means(model: &Model, dofs: &DofMap, open: &mut Vec<LinearConstraint>) {
    let mut turning = dofs.turning_dofs();
    let replaced: HashSet<usize> =
        model.mean_motions.iter().flat_map(|own| own.constraints.clone()).collect();
    open.retain(|own| match own.source {
        Source::Said(index) => !replaced.contains(&index),
        Source::Axes { .. } | Source::Equal => true,
    });
    for (place, mean) in model.mean_motions.iter().enumerate() {
        let (named, slots) = (mean.dependents.iter(), turning.by_ref().take(mean.turning.len()));
        let dependents = named.filter_map(|&(node, dof)| dofs.named(node, dof)).collect();
        let row = MeanRow::new((model, place), dofs, (dependents, slots.collect()));
        let terms: Vec<(usize, usize)> = row.followed().map(|dof| (dof, 0)).collect();
        let dependents: Vec<usize> = row.dependents().collect();
        let mut row = Some(Box::new(row));
        open.extend(dependents.into_iter().map(|dependent| LinearConstraint {
            dependent,
            terms: terms.clone(),
            source: Source::Said(mean.constraints.start),
            kept: Kept::Mean(row.take()),
        }));
    }
}

/// In small motion the dofs along axes that turn are those that they stand for.
fn resting<'a>(
    model: &'a Model,
    dofs: &'a DofMap,
) -> impl Iterator<Item = LinearConstraint> + use<'a> {
    let names = model.mean_motions.iter().flat_map(|own| &own.turning);
    dofs.turning_dofs().zip(names).filter_map(|(dependent, &(node, dof))| {
        let terms = vec![(dofs.named(node, dof)?, 0)];
        Some(LinearConstraint { dependent, terms, source: Source::Equal, kept: Kept::Nothing })
    })
}

/// Constraints behind those that they follow, level by level; those of a circle are left out.
fn in_order(open: Vec<LinearConstraint>) -> Vec<LinearConstraint> {
    let places = open.iter().enumerate().map(|(place, own)| (own.dependent, place));
    let places: HashMap<usize, usize> = places.collect();
    let mut followers: Vec<Vec<usize>> = vec![Vec::new(); open.len()];
    let (mut waits_for, mut level) = (vec![0_usize; open.len()], vec![0_usize; open.len()]);
    for (place, own) in open.iter().enumerate() {
        for &leader in own.terms.iter().filter_map(|(dof, _)| places.get(dof)) {
            followers[leader].push(place);
            waits_for[place] += 1;
        }
    }
    let mut ready: Vec<usize> = (0..open.len()).filter(|&place| waits_for[place] == 0).collect();
    let mut order: Vec<(usize, usize)> = Vec::with_capacity(open.len());
    while let Some(taken) = ready.pop() {
        order.push((level[taken], taken));
        for &follower in &followers[taken] {
            level[follower] = level[follower].max(level[taken] + 1);
            waits_for[follower] -= 1;
            if waits_for[follower] == 0 {
                ready.push(follower);
            }
        }
    }
    order.sort_unstable();
    let mut open: Vec<Option<LinearConstraint>> = open.into_iter().map(Some).collect();
    order.into_iter().filter_map(|(_, place)| open[place].take()).collect()
}

/// The components of a node along the axes of the model follow those along its own.
fn of_axes(dofs: &DofMap, place: usize) -> impl Iterator<Item = LinearConstraint> + '_ {
    let (node, _) = dofs.turned()[place];
    dofs.of_node(node).map(move |dependent| {
        let (_, kind) = dofs.name(dependent);
        let alike = dofs.named_of_node(node).filter(move |&own| {
            let (_, other) = dofs.name(own);
            other.is_rotation() == kind.is_rotation()
        });
        let terms = alike.map(|own| (own, dofs.name(own).1 as usize % 3)).collect();
        let source = Source::Axes { place, component: kind as usize % 3 };
        LinearConstraint { dependent, terms, source, kept: Kept::Nothing }
    })
}

impl LinearConstraint {
    /// Moves the dependent dof to where the others take it: u = c + sum a u_k.
    pub fn enforce(&self, coefficients: &[f64], constant: f64, u: &mut [f64]) {
        let terms = self.terms.iter().zip(coefficients);
        let sum: f64 = terms.map(|(&(dof, _), a)| a * u[dof]).sum();
        u[self.dependent] = constant + sum;
    }

    /// Hands a force on the dependent dof to those that it follows.
    pub fn carry(&self, coefficients: &[f64], force: &mut [f64]) {
        let own = std::mem::take(&mut force[self.dependent]);
        let terms = self.terms.iter().zip(coefficients);
        terms.for_each(|(&(dof, _), a)| force[dof] += a * own);
    }
}
