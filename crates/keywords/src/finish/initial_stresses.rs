//! `*INITIAL CONDITIONS`: stresses and plastic strains of elements before the first step.

use std::collections::{HashMap, HashSet};

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::material::{Conditions, Prestressed};
use slideline_model::{
    Dialect, ElementBlock, ElementIndex, InitialHardening, InitialStress, Kinematics, Material,
    Section,
};

use crate::draft::{Draft, HardeningLine, StressLine};
use crate::log::Target;
use crate::rule::Subject;

/// Gives the elements their stresses, and their materials room to keep them.
pub(super) fn stresses(draft: &mut Draft) {
    let lines = std::mem::take(&mut draft.initial_stresses);
    let hardened = std::mem::take(&mut draft.initial_hardening);
    if lines.is_empty() && hardened.is_empty() {
        return;
    }
    let blocks = draft.model.blocks.iter().enumerate();
    let places: HashMap<u64, ElementIndex> = blocks
        .flat_map(|(block, own)| {
            let elements = own.elements.iter().enumerate();
            elements.map(move |(member, element)| (element.label, (block, member)))
        })
        .collect();
    harden(&hardened, &places, draft);
    let hardened: HashMap<ElementIndex, InitialHardening> =
        draft.model.initial_hardening.iter().map(|own| (own.element, own.clone())).collect();
    let mut refused = HashSet::new();
    let mut all = Vec::new();
    for line in &lines {
        for label in labels(&line.target, line.target_span, draft) {
            let Some(&element) = places.get(&label) else { continue };
            if refused.contains(&element.0) {
                continue;
            }
            match stress(line, element, &hardened, draft) {
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

/// Gives the elements their plastic strains.
fn harden(lines: &[HardeningLine], places: &HashMap<u64, ElementIndex>, draft: &mut Draft) {
    let mut refused = HashSet::new();
    for line in lines {
        for label in labels(&line.target, line.target_span, draft) {
            let Some(&element) = places.get(&label) else { continue };
            if refused.contains(&element.0) {
                continue;
            }
            match hardening(line, element, draft) {
                Some(own) => draft.model.initial_hardening.push(own),
                None => {
                    refused.insert(element.0);
                }
            }
        }
    }
}

/// The plastic strain of one element; complains where it has none.
fn hardening(
    line: &HardeningLine,
    element: ElementIndex,
    draft: &mut Draft,
) -> Option<InitialHardening> {
    let block = &draft.model.blocks[element.0];
    let places = components(block);
    let mut back_stress = [0.0; 6];
    places.iter().zip(&line.values).for_each(|(&place, value)| back_stress[place] = *value);
    // a back stress has no mean: what a line cannot say follows
    match places.len() {
        1 => (back_stress[1], back_stress[2]) = (-0.5 * back_stress[0], -0.5 * back_stress[0]),
        3 => back_stress[2] = -back_stress[0] - back_stress[1],
        _ => {}
    }
    let own = InitialHardening {
        element,
        plastic_strain: line.plastic_strain,
        back_stress,
        origin: line.origin,
    };
    if line.values.iter().skip(places.len()).any(|part| *part != 0.0) {
        let (word, count) = (block.word(), places.len());
        let message = format!("{word} has {count} components of a back stress");
        let error = Diagnostic::error(Code("SL0209"), message).at(line.origin);
        draft.consequence(Subject::Elements, error);
        return None;
    }
    if begun(block, Some(&own)).is_none() {
        let why = match back_stress == [0.0; 6] {
            true => "does not yield",
            false => "has no yield surface that moves",
        };
        let message =
            format!("the material of {} {why}: it has no such initial hardening", block.name);
        let error = Diagnostic::error(Code("SL0385"), message).at(line.origin);
        let help =
            "plastic strain belongs to *PLASTIC, a back stress to HARDENING=KINEMATIC or COMBINED";
        draft.consequence(Subject::Properties, error.help(help));
        return None;
    }
    Some(own)
}

/// The state of the law of a block with this hardening; `None`: it has none.
fn begun(block: &ElementBlock, own: Option<&InitialHardening>) -> Option<Vec<f64>> {
    let Section::Solid(section) = &block.section else { return None };
    let mut state = vec![0.0; section.material.states()];
    let sound = own.is_none_or(|own| {
        section.material.harden(own.plastic_strain, &own.back_stress, &mut state)
    });
    sound.then_some(state)
}

/// The numbers of the elements that a line names.
fn labels(target: &Target, span: Span, draft: &mut Draft) -> Vec<u64> {
    let found = draft.elements_at(target, span);
    found.into_iter().map(|own| draft.elements[own].label).collect()
}

/// The stress of one element; complains where it has none.
fn stress(
    line: &StressLine,
    element: ElementIndex,
    hardened: &HashMap<ElementIndex, InitialHardening>,
    draft: &mut Draft,
) -> Option<InitialStress> {
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
    let left = if line.strains { left_by(&stress, &section.material) } else { Some(stress) };
    let stress = left.unwrap_or_default();
    let state = begun(block, hardened.get(&element)).unwrap_or_default();
    let bears = left.is_some()
        && [false, true].into_iter().all(|large| {
            let under = Conditions { large, ..Conditions::default() };
            section.material.strain_to(&stress, &under, &state).is_some()
        });
    if !bears {
        let message = format!("the material of {} does not bear this initial stress", block.name);
        let error = Diagnostic::error(Code("SL0385"), message).at(line.origin);
        let help = "an initial stress must lie within the yield surface, and far below the modulus; so must \
                    what an initial strain leaves";
        draft.consequence(Subject::Properties, error.help(help));
        return None;
    }
    Some(InitialStress { element, point: line.point, stress, origin: line.origin })
}

/// The stress that an inelastic strain leaves in a body that keeps its shape; `None`: it yields.
fn left_by(strain: &[f64; 6], material: &Material) -> Option<[f64; 6]> {
    const PLACES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
    let mut gradient = [[0.0; 3]; 3];
    for ((i, j), own) in PLACES.into_iter().zip(strain) {
        (gradient[i][j], gradient[j][i]) = (-own, -own);
    }
    let mut state = vec![0.0; material.states()];
    let rest = state.clone();
    let answer = material.respond(&gradient, &Conditions::default(), &rest, &mut state);
    (state == rest).then_some(answer.stress)
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
