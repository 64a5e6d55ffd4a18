//! Gaps with their clearance and direction become blocks.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::contact::normal::NormalLaw;
use slideline_model::{
    Dialect, ElementBlock, ElementType, Kinematics, NodeIndex, Section, SpringLaw, SpringSection,
    SpringWay, types,
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
        let own = |element: &Element| ROWS.iter().any(|row| is_of(element, row));
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
        for row in ROWS {
            let is_own = |at: &usize| is_of(&draft.elements[*at], row);
            let own: Vec<usize> = found.iter().copied().filter(is_own).collect();
            // a set without gaps is a block of the first row
            if own.is_empty() && !(found.is_empty() && row == ROWS[0]) {
                continue;
            }
            if let Some(block) = block((&gap, row), &own, draft) {
                draft.model.blocks.push(block);
            }
        }
    }
    for row in ROWS {
        without(row, "*GAP", &owned, draft);
    }
}

/// The types of gaps.
static ROWS: [&ElementType; 3] = [&types::GAPUNI, &types::GAPCYL, &types::GAPSPHER];

fn is_of(element: &Element, row: &'static ElementType) -> bool {
    element.kind == ElementKind::Structural(row)
}

/// How a gap measures its opening; `None` after an error.
fn way(gap: &Gap, row: &ElementType, draft: &mut Draft) -> Option<SpringWay> {
    let in_space = draft.is_spatial();
    let off_plane = |[x, y, z]: [f64; 3]| !in_space && x == 0.0 && y == 0.0 && z != 0.0;
    let (inside, radius) = (gap.clearance > 0.0, gap.clearance.abs());
    let refused = match row.name() {
        "GAPUNI" if gap.direction.is_some_and(off_plane) => {
            "the direction of the gap leaves the plane of the model"
        }
        "GAPCYL" if in_space && gap.direction.is_none() => {
            "the axis of the gap is missing: the numbers behind the clearance"
        }
        "GAPCYL" if gap.direction.is_some_and(|axis| !in_space && !off_plane(axis)) => {
            "in the plane the axis of the gap is 0, 0, 1"
        }
        "GAPCYL" | "GAPSPHER" if radius == 0.0 => {
            "the clearance of a round gap is a distance: positive where one node stays within it \
             of the other, negative where it stays outside"
        }
        name => {
            return Some(match name {
                "GAPUNI" => {
                    let direction = gap.direction.map(|[x, y, z]| match in_space {
                        true => [x, y, z],
                        false => [x / x.hypot(y), y / x.hypot(y), 0.0],
                    });
                    SpringWay::Direction { direction, in_space }
                }
                "GAPCYL" => SpringWay::Around { axis: gap.direction, inside, radius, in_space },
                _ => SpringWay::Around { axis: None, inside, radius, in_space },
            });
        }
    };
    draft.log.error("SL0210", refused, gap.origin);
    None
}

/// Whether nothing says which way a gap closes: its nodes meet.
fn has_no_direction(way: SpringWay, [a, b]: [[f64; 3]; 2]) -> bool {
    match way {
        SpringWay::Direction { direction, .. } => direction.is_none() && a == b,
        SpringWay::Around { axis, inside: false, .. } => {
            let apart: [f64; 3] = std::array::from_fn(|k| b[k] - a[k]);
            let axis = axis.unwrap_or_default();
            let along: f64 = axis.iter().zip(apart).map(|(a, x)| a * x).sum();
            (0..3).all(|k| apart[k] - along * axis[k] == 0.0)
        }
        _ => false,
    }
}

/// The block of a card and a type; `None` after an error.
fn block(
    (gap, row): (&Gap, &'static ElementType),
    found: &[usize],
    draft: &mut Draft,
) -> Option<ElementBlock> {
    let way = way(gap, row, draft)?;
    let mut elements: Vec<(u64, [NodeIndex; 2], Span)> = Vec::with_capacity(found.len());
    for &at in found {
        let element = draft.elements[at];
        let labels = element.nodes().iter();
        let nodes: Option<Vec<NodeIndex>> =
            labels.map(|&label| draft.model.nodes.find(label)).collect();
        let Some(&[a, b]) = nodes.as_deref() else { continue };
        let ends = [a, b].map(|node| draft.model.nodes.position(node));
        if has_no_direction(way, ends) {
            no_direction(&element, gap, draft);
            return None;
        }
        elements.push((element.label, [a, b], element.origin));
    }
    let law = Box::new(law(gap, &elements, draft)?);
    let clearance = match way {
        SpringWay::Around { radius, .. } => radius,
        _ => gap.clearance,
    };
    let law = SpringLaw::Gap { clearance, law };
    let section = Section::Spring(SpringSection { law, way });
    let mut block = ElementBlock::new(row, &gap.set, section, gap.origin);
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
        return Some(NormalLaw::CalculixLinear { stiffness, tension, pulls: true });
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
