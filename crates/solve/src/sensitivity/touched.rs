//! What a parameter touches of a model.

use slideline_mech::element::spring::SpringLaw;
use slideline_mech::material::Material;
use slideline_model::{ContactPair, ElementBlock, Model, Section, Step};

/// What differs between a model and its neighbours, of what the tangent of a converged increment
/// does not tell.
#[derive(Clone, Debug)]
pub struct Touched {
    /// Whether the section of each block of the model differs in some step.
    pub blocks: Vec<bool>,
    /// Whether steps begin with nothing but what those before left: no element or pair comes or leaves,
    /// and there are no stresses before the first one.
    pub begins_simply: bool,
}

impl Touched {
    /// That of the neighbours `near` a model; `None` where places differ, and where elements of the
    /// model are not of the house, or have kinks.
    pub fn of<'a>(model: &Model, near: impl Iterator<Item = &'a Model>) -> Option<Self> {
        if !model.blocks.iter().all(is_smooth) {
            return None;
        }
        let mut blocks = vec![false; model.blocks.len()];
        for other in near {
            if !is_placed_alike(model, other) {
                return None;
            }
            let pairs = model.blocks.iter().zip(&other.blocks);
            for (touched, (own, other)) in blocks.iter_mut().zip(pairs) {
                *touched |= own.section != other.section;
            }
            for (own, other) in model.steps.iter().zip(&other.steps) {
                let changed = own.sections.iter().chain(&other.sections);
                let differ = own.sections != other.sections;
                changed.filter(|_| differ).for_each(|own| blocks[own.block] = true);
            }
        }
        let simple = |step: &Step| {
            let own = &step.presence;
            own.absent.is_empty() && own.begun.is_empty() && own.absent_pairs.is_empty()
        };
        let changes = |step: &Step| !simple(step) || !step.sections.is_empty();
        let begins_simply = model.initial_stresses.is_empty() && !model.steps.iter().any(changes);
        Some(Self { blocks, begins_simply })
    }
}

/// Whether nodes, constraints and masters stand alike in two models, and all that steps change is
/// there alike.
fn is_placed_alike(one: &Model, other: &Model) -> bool {
    let alike = |(one, other): (&ContactPair, &ContactPair)| {
        one.master == other.master
            && one.offset == other.offset
            && one.interaction.width == other.interaction.width
    };
    let steps = one.steps.iter().zip(&other.steps);
    one.nodes == other.nodes
        && one.transforms == other.transforms
        && one.rigid_links == other.rigid_links
        && one.linear_constraints == other.linear_constraints
        && one.shapes == other.shapes
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
