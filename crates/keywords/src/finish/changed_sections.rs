//! `*CHANGE SOLID SECTION`, `*CHANGE MATERIAL`: what elements are made of from step to step.
//!
//! ```text
//!   section card   [ EL, elements 1 to 4            ]
//!   a step names         elements 2 and 3             as another material
//!   blocks         [ 1 and 4 ]   [ 2 and 3 ]          each of one section in every step
//! ```

use std::collections::BTreeMap;

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::material::Prestressed;
use slideline_model::{ChangedSection, Material};

use super::axes_of_elements::SectionAxes;
use super::fibres;
use super::materials::{in_plane_stress, lines_have_no_axes, material, no_material};
use crate::draft::{Body, Draft, PropertyChange, Section, StepDraft, Yielding};
use crate::rule::Subject;
use crate::surfaces::Named;

/// Sections that are not those of the model, by their blocks, each with its card.
#[derive(Default)]
pub(super) struct ChangedSections(BTreeMap<usize, (Section, ChangedSection)>);

/// Section cards and their elements, so parted that every step changes all elements of a part or
/// none.
pub(super) fn parted(
    sections: &[Section],
    named: Vec<Option<Vec<usize>>>,
    draft: &mut Draft,
) -> Vec<(Section, Vec<usize>)> {
    let sets = changing_sets(draft);
    let mut parted = Vec::with_capacity(sections.len());
    for (section, found) in sections.iter().zip(named) {
        let Some(found) = found else { continue };
        if sets.is_empty() {
            parted.push((section.clone(), found));
            continue;
        }
        let mut parts: BTreeMap<Vec<bool>, Vec<usize>> = BTreeMap::new();
        for element in found {
            let of = sets.iter().map(|set| set.binary_search(&element).is_ok()).collect();
            parts.entry(of).or_default().push(element);
        }
        if parts.is_empty() {
            parted.push((section.clone(), Vec::new()));
        }
        parted.extend(parts.into_values().map(|part| (section.clone(), part)));
    }
    parted
}

/// The elements that each `*CHANGE SOLID SECTION` names, ascending.
fn changing_sets(draft: &mut Draft) -> Vec<Vec<usize>> {
    let cards = draft.steps.iter().flat_map(|step| &step.properties);
    let sets = cards.filter_map(|card| match card {
        PropertyChange::Section { set, .. } => Some(set.clone()),
        PropertyChange::Material { .. } => None,
    });
    let sets: Vec<Named> = sets.collect();
    let found = sets.iter().map(|set| draft.elements_of(&set.name, set.span).unwrap_or_default());
    let mut found: Vec<Vec<usize>> = found.collect();
    found.iter_mut().for_each(|set| set.sort_unstable());
    found
}

impl ChangedSections {
    /// How much a further step copies.
    pub fn size(&self) -> usize {
        self.0.len()
    }

    /// Follows the cards of a step: the sections in it.
    pub fn change(&mut self, step: &StepDraft, draft: &mut Draft) -> Vec<ChangedSection> {
        for card in &step.properties {
            match card {
                PropertyChange::Section { set, material, orientation, origin } => {
                    self.of_elements(set, (material, orientation.as_ref()), *origin, draft);
                }
                PropertyChange::Material { material, yielding, origin } => {
                    self.of_material(material, yielding.as_ref(), *origin, draft);
                }
            }
        }
        self.0.values().map(|(_, changed)| changed.clone()).collect()
    }

    /// Other material and axes of the solids of a set.
    fn of_elements(
        &mut self,
        set: &Named,
        (material, orientation): (&Named, Option<&(String, Span)>),
        origin: Span,
        draft: &mut Draft,
    ) {
        let Some(found) = draft.elements_of(&set.name, set.span) else { return };
        let mut labels: Vec<u64> = found.iter().map(|&own| draft.elements[own].label).collect();
        labels.sort_unstable();
        let of_set = |block: &slideline_model::ElementBlock| {
            block.elements.iter().any(|own| labels.binary_search(&own.label).is_ok())
        };
        let blocks = draft.model.blocks.iter().enumerate();
        let blocks: Vec<usize> = blocks.filter(|own| of_set(own.1)).map(|own| own.0).collect();
        for block in blocks {
            let Some(card) = self.card_of(block, draft) else { continue };
            let other = Section {
                material: material.name.clone(),
                material_span: material.span,
                orientation: orientation.cloned(),
                ..card
            };
            self.take(block, other, origin, draft);
        }
    }

    /// Other yield stresses of all that is of a material.
    fn of_material(
        &mut self,
        named: &Named,
        yielding: Option<&Yielding>,
        origin: Span,
        draft: &mut Draft,
    ) {
        let Some(yielding) = yielding else {
            let message = "*CHANGE MATERIAL has no *CHANGE PLASTIC behind it";
            let error = Diagnostic::error(Code("SL0208"), message).at(origin);
            let help = "put *CHANGE PLASTIC with the new yield stresses behind it";
            draft.consequence(Subject::Steps, error.help(help));
            return;
        };
        let Some(own) = draft.materials.iter_mut().find(|own| own.name == named.name) else {
            no_material(&named.name, named.span, draft);
            return;
        };
        let Some((hardening, _)) = &mut own.hardening else {
            let message = format!("the material {} does not yield: it has no *PLASTIC", own.name);
            let error = Diagnostic::error(Code("SL0309"), message).at(named.span);
            let help =
                "give it *PLASTIC before the first step: a yield stress that is never reached";
            draft.consequence(Subject::Properties, error.help(help));
            return;
        };
        *hardening = Some(yielding.clone());
        for block in 0..draft.model.blocks.len() {
            let card = self.card_of(block, draft).filter(|card| card.material == named.name);
            if let Some(card) = card {
                self.take(block, card, origin, draft);
            }
        }
    }

    /// The section card of a block as it stands; `None`: it has none.
    fn card_of(&self, block: usize, draft: &Draft) -> Option<Section> {
        if let Some((card, _)) = self.0.get(&block) {
            return Some(card.clone());
        }
        let origin = draft.model.blocks[block].origin;
        draft.sections.iter().find(|own| own.origin == origin).cloned()
    }

    /// Gives a block a section, where its elements can go on with it.
    fn take(&mut self, block: usize, card: Section, origin: Span, draft: &mut Draft) {
        let own = draft.model.blocks[block].clone();
        if !matches!(card.body, Body::Solid { .. }) {
            let message = format!("{} elements have no solid section to change", own.word());
            let error = Diagnostic::error(Code("SL0325"), message).at(origin);
            draft.consequence(Subject::Elements, error.label(own.origin, "their section"));
            return;
        }
        let Some(axes) = SectionAxes::named(card.orientation.as_ref(), draft) else { return };
        let claimed = [(own.kind, own.elements.clone())];
        in_plane_stress(&card, &claimed, draft);
        lines_have_no_axes(&card, &claimed, draft);
        let made = material(&card, draft).and_then(|made| fibres::laid(&card, made, draft));
        let Some(made) = made else { return };
        let made = axes.put_on(made, &own.elements, draft);
        let slideline_model::Section::Solid(before) = &own.section else { return };
        let slideline_model::Section::Solid(mut after) = made else { return };
        if before.material.begins_under_stress() {
            let law = after.material;
            after.material = Material::Prestressed(Box::new(Prestressed { law }));
        }
        if !goes_on_with(&before.material, &after.material) {
            let message = format!(
                "the elements of {} cannot go on as {}: it keeps another history than their material",
                own.name, card.material
            );
            let error = Diagnostic::error(Code("SL0309"), message).at(origin);
            let help = "both materials must yield, creep or relax alike; one that shall not yield has \
                        a *PLASTIC whose stress is never reached";
            draft.consequence(
                Subject::Properties,
                error.label(own.origin, "their section").help(help),
            );
            return;
        }
        let section = slideline_model::Section::Solid(after);
        self.0.insert(block, (card, ChangedSection { block, section, origin }));
    }
}

/// Whether the state variables of one material mean the same to another one.
fn goes_on_with(before: &Material, after: &Material) -> bool {
    match (before, after) {
        (Material::Expanding(one), other) => goes_on_with(&one.law, other),
        (one, Material::Expanding(other)) => goes_on_with(one, &other.law),
        (Material::Prestressed(one), Material::Prestressed(other)) => {
            goes_on_with(&one.law, &other.law)
        }
        _ if before.states() == 0 && after.states() == 0 => true,
        (Material::Graded(_), _) | (_, Material::Graded(_)) => before.states() == after.states(),
        _ => {
            std::mem::discriminant(before) == std::mem::discriminant(after)
                && before.states() == after.states()
        }
    }
}
