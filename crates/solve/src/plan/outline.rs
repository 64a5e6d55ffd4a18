//! What of a model decides its numbering, as a row of numbers.

use slideline_mech::kept_shape::KeptShape;
use slideline_model::{
    ContactFace, ContactPair, ElementBlock, Formulation, Friction, Master, Model, Presence,
    Section, Step,
};
use std::fmt;

/// A part of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The number of its nodes.
    Nodes,
    /// Type, dofs or connectivity of an element block, by its index.
    Elements(usize),
    /// The section of an element block, which is not one of its type.
    Section(usize),
    /// Which nodes have axes of their own.
    Transforms,
    /// Which nodes belong to rigid bodies; where some of these are only tied in part, what moves them.
    RigidLinks,
    /// Which dofs follow others linearly.
    LinearConstraints,
    /// Nodes, kind of master or state variables of a contact pair, by its index.
    Contact(usize),
    /// A master that has no extent, of a contact pair by its index.
    Master(usize),
    /// A node of a plane model that does not stand in the plane of x and y, by its label.
    OutOfPlane(u64),
    /// The number of steps.
    Steps,
    /// Prescribed dofs, kinematics, or what is absent of a step, by its number from 1.
    Step(usize),
}

/// A model is not of the outline that a plan was made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlanMismatch {
    /// The first part in which it differs.
    pub part: Part,
}

impl fmt::Display for PlanMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the model does not fit the plan: it differs in ")?;
        match self.part {
            Part::Nodes => f.write_str("the number of nodes"),
            Part::Elements(index) => {
                write!(f, "the type or the nodes of the elements of block {}", index + 1)
            }
            Part::Section(index) => write!(f, "the kind of section of block {}", index + 1),
            Part::Transforms => f.write_str("the nodes with axes of their own"),
            Part::RigidLinks => f.write_str("the nodes of rigid bodies, or what moves their dofs"),
            Part::LinearConstraints => f.write_str("the dofs of equations and ties"),
            Part::Contact(index) => {
                write!(f, "the nodes or the kind of master of contact pair {}", index + 1)
            }
            Part::Master(index) => {
                write!(f, "contact pair {}, whose master has no extent", index + 1)
            }
            Part::OutOfPlane(label) => {
                write!(f, "node {label}, whose z is not zero though all elements are plane")
            }
            Part::Steps => f.write_str("the number of steps"),
            Part::Step(number) => {
                write!(f, "the prescribed dofs, NLGEOM or what is absent of step {number}")
            }
        }?;
        f.write_str("; make a plan of this model")
    }
}

impl std::error::Error for PlanMismatch {}

/// The outline of a model.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Outline(Vec<usize>);

impl Outline {
    pub fn of(model: &Model) -> Self {
        let mut count = 0;
        draw(model, &mut |_, _| count += 1);
        let mut numbers = Vec::with_capacity(count);
        draw(model, &mut |_, number| numbers.push(number));
        Self(numbers)
    }

    /// The first part in which a model has another outline.
    pub fn mismatch(&self, model: &Model) -> Option<PlanMismatch> {
        let mut known = self.0.iter();
        let mut first = None;
        draw(model, &mut |part, number| {
            if first.is_none() && known.next() != Some(&number) {
                first = Some(PlanMismatch { part });
            }
        });
        first
    }
}

/// Calls back with every number of the outline and the part that it belongs to. Each list
/// follows its length, so that no two outlines are the same row.
fn draw(model: &Model, note: &mut impl FnMut(Part, usize)) {
    note(Part::Nodes, model.nodes.len());
    note(Part::Transforms, model.transforms.len());
    for transform in &model.transforms {
        note(Part::Transforms, transform.nodes.len());
        transform.nodes.iter().for_each(|&node| note(Part::Transforms, node));
    }
    note(Part::Elements(0), model.blocks.len());
    for (index, block) in model.blocks.iter().enumerate() {
        draw_block(block, &mut |number| note(Part::Elements(index), number));
    }
    draw_links(model, &mut |number| note(Part::RigidLinks, number));
    note(Part::LinearConstraints, model.linear_constraints.len());
    for constraint in &model.linear_constraints {
        note(Part::LinearConstraints, constraint.terms.len());
        let terms = constraint.terms.iter().map(|&(node, dof, _)| (node, dof));
        for (node, dof) in std::iter::once(constraint.dependent).chain(terms) {
            [node, dof as usize]
                .into_iter()
                .for_each(|number| note(Part::LinearConstraints, number));
        }
    }
    note(Part::LinearConstraints, model.shapes.len());
    for own in &model.shapes {
        let kind = match own.shape {
            KeptShape::Line(i, j) => 3 * i + j,
            KeptShape::Plane => 9,
            KeptShape::MeanTurn(_) => 10,
            KeptShape::Distance => 11,
        };
        let angle = own.angle.map_or(0, |node| node + 1);
        [own.constraint, kind, own.nodes.len(), angle]
            .into_iter()
            .chain(own.nodes.iter().copied())
            .for_each(|number| note(Part::LinearConstraints, number));
    }
    draw_means(model, &mut |number| note(Part::LinearConstraints, number));
    note(Part::Contact(0), model.contact_pairs.len());
    for (index, pair) in model.contact_pairs.iter().enumerate() {
        draw_pair(pair, &mut |number| note(Part::Contact(index), number));
    }
    note(Part::Contact(0), model.edge_pairs.len());
    for edges in &model.edge_pairs {
        let mut note = |number| note(Part::Contact(edges.of), number);
        [edges.nodes.len(), usize::from(edges.is_of_master)].into_iter().for_each(&mut note);
        let met = edges.met.deforming_nodes();
        edges.nodes.iter().chain(&met).for_each(|&node| note(node));
    }
    draw_crossings(model, note);
    note(Part::Steps, model.steps.len());
    for (index, step) in model.steps.iter().enumerate() {
        draw_step(step, &mut |number| note(Part::Step(index + 1), number));
    }
}

/// Nodes that follow others rigidly, and what of these moves them where some follow in part.
fn draw_links(model: &Model, note: &mut impl FnMut(usize)) {
    note(model.rigid_links.len());
    for link in &model.rigid_links {
        let turn = link.turn.map_or(0, |node| node + 1);
        let own = [link.dependent, link.master, turn].into_iter();
        let follows = link.follows.iter().map(|&follows| usize::from(follows));
        own.chain(follows).for_each(&mut *note);
    }
    if crate::leading::is_partial(model) {
        for (master, used) in crate::leading::masters(model) {
            note(master);
            used.iter().for_each(|&own| note(usize::from(own)));
        }
    }
}

/// Clouds that may turn far.
fn draw_means(model: &Model, note: &mut impl FnMut(usize)) {
    note(model.mean_motions.len());
    for own in &model.mean_motions {
        [own.reference, own.constraints.start, own.cloud.len(), own.dependents.len()]
            .into_iter()
            .chain([own.turning.len()])
            .chain(own.cloud.iter().map(|(node, _)| *node))
            .chain(own.coupled.map(usize::from))
            .for_each(&mut *note);
        for &(node, dof) in own.dependents.iter().chain(&own.turning) {
            [node, dof as usize].into_iter().for_each(&mut *note);
        }
    }
}

/// Lines of edges that may cross.
fn draw_crossings(model: &Model, note: &mut impl FnMut(Part, usize)) {
    note(Part::Contact(0), model.crossing_edges.len());
    for own in &model.crossing_edges {
        let mut note = |number| note(Part::Contact(own.of), number);
        for side in [&own.slave, &own.master] {
            note(side.len());
            for line in side {
                [line.edges.len(), usize::from(line.is_closed)].into_iter().for_each(&mut note);
                line.edges.iter().flat_map(|edge| edge.nodes).for_each(&mut note);
            }
        }
    }
}

fn draw_block(block: &ElementBlock, note: &mut impl FnMut(usize)) {
    let kind = block.kind;
    kind.name().bytes().for_each(|byte| note(byte.into()));
    let section = match &block.section {
        Section::Beam(_) => 0,
        Section::Spring(_) => 1,
        Section::Solid(_) => 2,
        Section::Properties(_) => 3,
    };
    [section, kind.cell.nodes, block.states(), kind.all_values()].into_iter().for_each(&mut *note);
    let dofs = block.dofs();
    note(dofs.len());
    dofs.iter().for_each(|&dof| note(dof as usize));
    note(block.elements.len());
    block.elements.iter().flat_map(|element| element.nodes).for_each(|&node| note(node));
}

fn draw_pair(pair: &ContactPair, note: &mut impl FnMut(usize)) {
    note(match pair.formulation {
        Formulation::NodeToSurface => 0,
        Formulation::SurfaceToSurface => 1,
        Formulation::Mortar => 2,
    });
    note(usize::from(pair.offset.slave != 0.0));
    note(pair.corners.len());
    pair.corners.iter().for_each(|&node| note(node));
    note(match &pair.interaction.friction {
        Friction::User { state_size, .. } => *state_size,
        _ => 0,
    });
    note(pair.elements.len());
    pair.elements.iter().flat_map(|element| element.nodes).for_each(&mut *note);
    note(pair.faces.len());
    draw_faces(&pair.faces, note);
    note(pair.slaves.len());
    pair.slaves.iter().for_each(|&node| note(node));
    note(pair.profile.as_ref().map_or(0, |own| own.segments.len()));
    match &pair.master {
        Master::RigidSurface(surface) => [0, surface.reference].into_iter().for_each(note),
        Master::SlideLine(line) => {
            [1, line.nodes.len(), line.middles.len()].into_iter().for_each(&mut *note);
            line.nodes.iter().for_each(|&node| note(node));
            line.middles.iter().for_each(|&is_middle| note(usize::from(is_middle)));
        }
        Master::Itself(surface) => {
            [3, surface.runs.len()].into_iter().for_each(&mut *note);
            for run in &surface.runs {
                [run.nodes.len(), usize::from(run.is_closed)].into_iter().for_each(&mut *note);
                run.nodes.iter().for_each(|&node| note(node));
            }
        }
        Master::Faces(faces) => {
            [2, faces.faces.len(), usize::from(faces.smooth)].into_iter().for_each(&mut *note);
            draw_faces(&faces.faces, note);
            note(usize::from(faces.meets_itself));
            note(faces.swept.as_ref().map_or(0, |swept| 1 + swept.reference));
        }
    }
}

fn draw_faces(faces: &[ContactFace], note: &mut impl FnMut(usize)) {
    for face in faces {
        note(face.nodes.len());
        face.nodes.iter().for_each(|&node| note(node));
    }
}

fn draw_step(step: &Step, note: &mut impl FnMut(usize)) {
    note(usize::from(step.nlgeom));
    note(step.prescribed.len());
    for prescribed in &step.prescribed {
        [prescribed.node, prescribed.dof as usize].into_iter().for_each(&mut *note);
    }
    let Presence { absent, begun, absent_pairs, .. } = &step.presence;
    for list in [absent, begun] {
        note(list.len());
        list.iter().flat_map(|&(block, member)| [block, member]).for_each(&mut *note);
    }
    note(absent_pairs.len());
    absent_pairs.iter().for_each(|&pair| note(pair));
}
