//! `*INITIAL CONDITIONS, TYPE=STRESS`: stresses of elements before the first step.

use std::collections::{HashMap, HashSet};

use slideline_diag::{Code, Diagnostic};
use slideline_mech::material::{Conditions, Prestressed};
use slideline_model::{
    Dialect, ElementBlock, ElementIndex, InitialStress, Kinematics, Material, Section,
};

use crate::draft::{Draft, StressLine};
use crate::log::Target;
use crate::rule::Subject;

/// Gives the elements their stresses, and their materials room to keep them.
pub(super) fn stresses(draft: &mut Draft) {
    let lines = std::mem::take(&mut draft.initial_stresses);
    if lines.is_empty() {
        return;
    }
    let blocks = draft.model.blocks.iter().enumerate();
    let places: HashMap<u64, ElementIndex> = blocks
        .flat_map(|(block, own)| {
            let elements = own.elements.iter().enumerate();
            elements.map(move |(member, element)| (element.label, (block, member)))
        })
        .collect();
    let mut refused = HashSet::new();
    let mut all = Vec::new();
    for line in &lines {
        for label in labels(line, draft) {
            let Some(&element) = places.get(&label) else { continue };
            if refused.contains(&element.0) {
                continue;
            }
            match stress(line, element, draft) {
                Some(own) => all.push(own),
                None => {
                    refused.insert(element.0);
                }
            }
        }
    }
    // zeros need no room; a later line counts where two name one point
    for own in &all {
        let block = &mut draft.model.blocks[own.element.0];
        if let Section::Solid(section) = &mut block.section
            && !section.material.begins_under_stress()
        {
            let law = section.material.clone();
            section.material = Material::Prestressed(Box::new(Prestressed { law }));
        }
    }
    draft.model.initial_stresses = all;
}

fn labels(line: &StressLine, draft: &mut Draft) -> Vec<u64> {
    match &line.target {
        Target::Set(set) => {
            let found = draft.elements_of(set, line.target_span).unwrap_or_default();
            found.into_iter().map(|own| draft.elements[own].label).collect()
        }
        Target::Label(label) => {
            if !draft.element_by_label.contains_key(label) {
                let message = format!("element {label} is not defined");
                let error = Diagnostic::error(Code("SL0308"), message).at(line.target_span);
                draft.consequence(Subject::Elements, error);
            }
            vec![*label]
        }
    }
}

/// The stress of one element; complains where it has none.
fn stress(line: &StressLine, element: ElementIndex, draft: &mut Draft) -> Option<InitialStress> {
    let block = &draft.model.blocks[element.0];
    let (word, points) = (block.word(), block.kind.points);
    if let Some((what, help)) = refusal(block, draft.model.dialect) {
        let message = format!("initial stresses of {what} are not supported");
        let error = Diagnostic::error(Code("SL0221"), message).at(line.origin);
        draft.consequence(Subject::Elements, error.help(help));
        return None;
    }
    if line.point.is_some_and(|point| point >= points) {
        let message = format!("{word} has the integration points 1 to {points}");
        let error = Diagnostic::error(Code("SL0210"), message).at(line.origin);
        draft.consequence(Subject::Elements, error);
        return None;
    }
    let places = components(block);
    if line.values.len() > places.len() && line.values[places.len()..].iter().any(|s| *s != 0.0) {
        let message =
            format!("{word} has {} components of stress, not {}", places.len(), line.values.len());
        let error = Diagnostic::error(Code("SL0209"), message).at(line.origin);
        draft.consequence(Subject::Elements, error);
        return None;
    }
    let mut stress = [0.0; 6];
    places.iter().zip(&line.values).for_each(|(&place, value)| stress[place] = *value);
    let Section::Solid(section) = &block.section else { return None };
    let bears = [false, true].into_iter().all(|large| {
        let under = Conditions { large, ..Conditions::default() };
        section.material.strain_to(&stress, &under).is_some()
    });
    if !bears {
        let message = format!("the material of {} does not bear this initial stress", block.name);
        let error = Diagnostic::error(Code("SL0385"), message).at(line.origin);
        let help = "an initial stress must lie within the yield surface, and far below the modulus";
        draft.consequence(Subject::Properties, error.help(help));
        return None;
    }
    Some(InitialStress { element, point: line.point, stress, origin: line.origin })
}

/// Why elements of a block have no initial stress, and what to do.
fn refusal(block: &ElementBlock, dialect: Dialect) -> Option<(String, &'static str)> {
    let Section::Solid(section) = &block.section else {
        let help = "solids and trusses have them; a beam is strained by *BOUNDARY or *TEMPERATURE";
        return Some((format!("{} elements", block.word()), help));
    };
    if section.material.relaxes() {
        let help = "strain it in a first step instead: *BOUNDARY or *TEMPERATURE";
        return Some(("materials that relax".to_owned(), help));
    }
    let calculix = dialect == Dialect::Calculix;
    if calculix && section.orientation.is_some() {
        let help = "CalculiX gives them along the axes of the model: leave the orientation out";
        return Some(("materials with axes of their own".to_owned(), help));
    }
    let plane = block.kind.is_truss() || !block.kind.is_spatial();
    (calculix && plane).then(|| {
        let help =
            "CalculiX gives them at the points of the bricks that it makes of these elements";
        (format!("{} elements in the dialect of CalculiX", block.word()), help)
    })
}

/// The components that a line gives, by their places among 11, 22, 33, 12, 13, 23.
fn components(block: &ElementBlock) -> &'static [usize] {
    use slideline_mech::element::solid::Kinematics::{PlaneStress, Space};
    match block.kind.kinematics {
        Kinematics::Truss => &[0],
        Kinematics::Solid { strains: PlaneStress, .. } => &[0, 1, 3],
        Kinematics::Solid { strains: Space, .. } => &[0, 1, 2, 3, 4, 5],
        _ => &[0, 1, 2, 3],
    }
}
