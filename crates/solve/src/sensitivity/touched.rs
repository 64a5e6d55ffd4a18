//! What a parameter touches of a model.

use super::stencil::Sides;
use slideline_mech::element::spring::SpringLaw;
use slideline_mech::material::Material;
use slideline_model::{ChangedSection, ContactPair, ElementBlock, Model, Section, Step};

/// How a section differs between a model and its pair of neighbours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Touch {
    /// Not at all.
    Not,
    /// Its stresses are the larger by these factors in the neighbours.
    Stresses(Sides),
    /// By something else, or in some step only.
    Other,
}

/// What differs between a model and its neighbours, of what the tangent of a converged increment
/// does not tell.
#[derive(Clone, Debug)]
pub struct Touched {
    /// How the section of each block of the model differs.
    pub blocks: Vec<Touch>,
    /// Whether steps begin with nothing but what those before left: no element or pair comes or leaves,
    /// and there are no stresses before the first one.
    pub begins_simply: bool,
}

impl Touched {
    /// That of the pair of neighbours `near` a model; `None` where places differ, and where elements of the
    /// model are not of the house, or have kinks.
    pub fn of(model: &Model, near: [&Model; 2]) -> Option<Self> {
        let alike = near.iter().all(|other| is_placed_alike(model, other));
        if !alike || !model.blocks.iter().all(is_smooth) {
            return None;
        }
        let blocks = (0..model.blocks.len()).map(|block| touch(model, near, block)).collect();
        let simple = |step: &Step| {
            let own = &step.presence;
            own.absent.is_empty() && own.begun.is_empty() && own.absent_pairs.is_empty()
        };
        let changes = |step: &Step| !simple(step) || !step.sections.is_empty();
        let begins_simply = model.initial_stresses.is_empty() && !model.steps.iter().any(changes);
        Some(Self { blocks, begins_simply })
    }
}

/// How the section of a block differs in the neighbours.
fn touch(model: &Model, near: [&Model; 2], block: usize) -> Touch {
    let changes = |own: &&ChangedSection| own.block == block;
    let in_steps = |model: &'_ Model| {
        let of_steps = model.steps.iter().flat_map(|step| step.sections.iter().filter(changes));
        of_steps.cloned().collect::<Vec<_>>()
    };
    let (section, in_steps_of_model) = (&model.blocks[block].section, in_steps(model));
    let others = near.map(|other| &other.blocks[block].section);
    let same_steps = near.iter().all(|other| in_steps(other) == in_steps_of_model);
    if same_steps && others.iter().all(|other| *other == section) {
        return Touch::Not;
    }
    match others.map(|other| section.stresses_of(other)) {
        [Some(below), Some(above)] if same_steps && in_steps_of_model.is_empty() => {
            Touch::Stresses([below, above])
        }
        _ => Touch::Other,
    }
}

/// Whether nodes, constraints and masters stand alike in two models, and all that steps change is
/// there alike.
fn is_placed_alike(one: &Model, other: &Model) -> bool {
    let alike = |(one, other): (&ContactPair, &ContactPair)| {
        one.master == other.master && one.offset == other.offset
    };
    let steps = one.steps.iter().zip(&other.steps);
    one.nodes == other.nodes
        && one.transforms == other.transforms
        && one.rigid_links == other.rigid_links
        && one.linear_constraints == other.linear_constraints
        && one.shapes == other.shapes
        && one.mean_motions == other.mean_motions
        && one.initial_stresses == other.initial_stresses
        && one.initial_hardening == other.initial_hardening
        && one.contact_pairs.iter().zip(&other.contact_pairs).all(alike)
        && steps.into_iter().all(|(one, other)| one.interferences == other.interferences)
}

/// Whether the forces of elements follow displacements without kinks, with a tangent of the house.
fn is_smooth(block: &ElementBlock) -> bool {
    match &block.section {
        Section::Beam(_) => true,
        Section::Spring(section) => matches!(section.law, SpringLaw::Linear(_)),
        Section::Solid(section) => !matches!(section.material, Material::User(_)),
        Section::Properties(_) => false,
    }
}
