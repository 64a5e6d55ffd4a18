//! Gaps with their clearance and direction become blocks.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::contact::normal::NormalLaw;
use slideline_model::{
    Dialect, ElementBlock, Kinematics, NodeIndex, Section, SpringLaw, SpringSection, SpringWay,
    types,
};

use super::sections::without;
use crate::draft::{Draft, Element, ElementKind, Gap};
use crate::rule::Subject;

/// How much stiffer a closed gap is than the elements at its nodes, where its card does not say:
/// the compliance of contact is then a thousandth of theirs.
const STIFFER: f64 = 1e3;

/// CalculiX' stiffness of a gap, in the deck's units.
const CALCULIX_STIFFNESS: f64 = 1e12;

/// Its pull of an open gap.
const CALCULIX_TENSION: f64 = 1e-3;

/// `*GAP` with its elements.
pub(super) fn gaps(draft: &mut Draft) {
    let mut owned = vec![false; draft.elements.len()];
    for gap in draft.gaps.clone() {
        let Some(found) = draft.elements_of(&gap.set, gap.set_span) else { continue };
        let own = |element: &Element| element.kind == ElementKind::Structural(&types::GAPUNI);
        if let Some(foreign) = found.iter().map(|&at| draft.elements[at]).find(|e| !own(e)) {
            let (label, name) = (foreign.label, foreign.kind.name());
            let message = format!(
                "element {label} of the set {} is of type {name}, which is not a gap",
                gap.set
            );
            let error = Diagnostic::error(Code("SL0325"), message).at(gap.set_span);
            draft.consequence(Subject::Elements, error);
        }
        let found: Vec<usize> = found.into_iter().filter(|&at| own(&draft.elements[at])).collect();
        found.iter().for_each(|&at| owned[at] = true);
        if let Some(block) = block(&gap, &found, draft) {
            draft.model.blocks.push(block);
        }
    }
    without(&types::GAPUNI, "*GAP", &owned, draft);
}

/// The block of a card; `None` after an error.
fn block(gap: &Gap, found: &[usize], draft: &mut Draft) -> Option<ElementBlock> {
    let in_space = draft.is_spatial();
    if gap.direction.is_some_and(|[x, y, _]| !in_space && x == 0.0 && y == 0.0) {
        let message = "the direction of the gap leaves the plane of the model";
        draft.log.error("SL0210", message, gap.origin);
        return None;
    }
    let direction = gap.direction.map(|[x, y, z]| match in_space {
        true => [x, y, z],
        false => [x / x.hypot(y), y / x.hypot(y), 0.0],
    });
    let mut elements: Vec<(u64, [NodeIndex; 2], Span)> = Vec::with_capacity(found.len());
    for &at in found {
        let element = draft.elements[at];
        let labels = element.nodes().iter();
        let nodes: Option<Vec<NodeIndex>> =
            labels.map(|&label| draft.model.nodes.find(label)).collect();
        let Some(&[a, b]) = nodes.as_deref() else { continue };
        if direction.is_none() && draft.model.nodes.position(a) == draft.model.nodes.position(b) {
            no_direction(&element, gap, draft);
            return None;
        }
        elements.push((element.label, [a, b], element.origin));
    }
    let law = Box::new(law(gap, &elements, draft)?);
    let law = SpringLaw::Gap { clearance: gap.clearance, law };
    let way = SpringWay::Direction { direction, in_space };
    let section = Section::Spring(SpringSection { law, way });
    let mut block = ElementBlock::new(&types::GAPUNI, &gap.set, section, gap.origin);
    for (label, nodes, origin) in elements {
        block.elements.push(label, &nodes, origin);
    }
    Some(block)
}

fn no_direction(element: &Element, gap: &Gap, draft: &mut Draft) {
    let message = format!(
        "the gap element {} has no direction: its nodes are at one place, and *GAP gives none",
        element.label
    );
    let error = Diagnostic::error(Code("SL0208"), message).at(gap.origin);
    let help = "give the direction from the first to the second node behind the clearance";
    draft.log.push(error.label(element.origin, "the element").help(help));
}

/// Force of the closed gap by its overclosure; `None` after an error.
fn law(
    gap: &Gap,
    elements: &[(u64, [NodeIndex; 2], Span)],
    draft: &mut Draft,
) -> Option<NormalLaw> {
    if draft.dialect == Dialect::Calculix {
        let stiffness = gap.stiffness.unwrap_or(CALCULIX_STIFFNESS);
        let tension = gap.tension.unwrap_or(CALCULIX_TENSION);
        return Some(NormalLaw::CalculixLinear { stiffness, tension });
    }
    if let Some(stiffness) = gap.stiffness {
        return Some(NormalLaw::Linear { stiffness });
    }
    let ends: Vec<NodeIndex> = elements.iter().flat_map(|(_, nodes, _)| *nodes).collect();
    let around = stiffest_about(&ends, draft);
    if around > 0.0 {
        return Some(NormalLaw::Linear { stiffness: STIFFER * around });
    }
    if !elements.is_empty() {
        let message = "the stiffness of the gap is missing: no elastic element is at its nodes";
        let error = Diagnostic::error(Code("SL0208"), message).at(gap.origin);
        let help = "give it as the sixth number: clearance, three of the direction, blank, force \
                    per length";
        draft.consequence(Subject::Sections, error.help(help));
    }
    None
}

/// The largest stiffness of an element at one of the nodes [F/L].
fn stiffest_about(ends: &[NodeIndex], draft: &Draft) -> f64 {
    let ends: std::collections::HashSet<NodeIndex> = ends.iter().copied().collect();
    let mut stiffest = 0.0_f64;
    for block in &draft.model.blocks {
        let Some(elastic) = block.section.elastic() else { continue };
        for element in block.elements.iter() {
            if !element.nodes.iter().any(|node| ends.contains(node)) {
                continue;
            }
            let places = element.nodes.iter().map(|&node| draft.model.nodes.position(node));
            stiffest = stiffest.max(elastic.modulus * width(block, places));
        }
    }
    stiffest
}

/// What a modulus times it is the stiffness of an element: area over length [L].
fn width(block: &ElementBlock, places: impl Iterator<Item = [f64; 3]>) -> f64 {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for place in places {
        for (axis, at) in place.into_iter().enumerate() {
            (low[axis], high[axis]) = (low[axis].min(at), high[axis].max(at));
        }
    }
    let size = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::hypot);
    match &block.section {
        Section::Beam(section) => section.shape.area() / size,
        Section::Solid(section) if block.kind.kinematics == Kinematics::Truss => {
            section.thickness / size
        }
        Section::Solid(section) if !block.kind.is_spatial() && !block.kind.is_ring() => {
            section.thickness
        }
        _ => size,
    }
}
