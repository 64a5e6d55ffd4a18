//! What a section says of beams: those in space need axes and torsion, those in the plane do not.

use slideline_diag::{Code, Diagnostic};
use slideline_mech::element::space_beam::section_axes;
use slideline_model::{ElementBlock, ElementType, Elements, NodeIndex, Shape};

use crate::draft::{Body, Draft, Element, Section};
use crate::rule::Subject;

/// Elements of a section whose axis 1 has a direction of their own.
pub(super) struct Pointing {
    first_axis: [f64; 3],
    pub kind: &'static ElementType,
    elements: Elements,
}

impl Pointing {
    /// The block of the elements.
    pub fn block(&self, section: &Section, made: &slideline_model::Section) -> ElementBlock {
        let mut own = made.clone();
        if let slideline_model::Section::Beam(beam) = &mut own {
            beam.first_axis = self.first_axis;
        }
        let mut block = ElementBlock::new(self.kind, &section.set, own, section.origin);
        block.elements = self.elements.clone();
        block
    }
}

/// The elements of that direction and type.
pub(super) fn pointing<'a>(
    first_axis: [f64; 3],
    kind: &'static ElementType,
    all: &'a mut Vec<Pointing>,
) -> Option<&'a mut Elements> {
    let near = |own: &Pointing| {
        let size = own.first_axis.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        own.first_axis.iter().zip(first_axis).all(|(a, b)| (a - b).abs() <= SAME * size)
    };
    let known = all.iter().position(|own| near(own) && own.kind == kind);
    let place = known.unwrap_or_else(|| {
        all.push(Pointing { first_axis, kind, elements: Elements::new(kind.cell.nodes) });
        all.len() - 1
    });
    all.get_mut(place).map(|own| &mut own.elements)
}

/// Part of a direction below which another one is the same but for rounding [1].
const SAME: f64 = 1e-14;

/// The direction to the node that axis 1 of an element's section points to, if it names one; `None`
/// after an error.
pub(super) fn direction(
    element: &Element,
    nodes: &[NodeIndex],
    draft: &mut Draft,
) -> Option<Option<[f64; 3]>> {
    let (Some(label), Some(&first)) = (element.pointed_at(), nodes.first()) else {
        return Some(None);
    };
    let Some(node) = draft.model.nodes.find(label) else {
        let message = format!("node {label}, which axis 1 of this beam points to, is not defined");
        let error = Diagnostic::error(Code("SL0303"), message).at(element.origin);
        draft.consequence(Subject::Nodes, error);
        return None;
    };
    let [to, from] = [node, first].map(|node| draft.model.nodes.position(node));
    Some(Some(std::array::from_fn(|k| to[k] - from[k])))
}

/// Complains about a beam in space whose section has no axes or no stiffness in space; notes what
/// of a section a plane beam does not use. False if the element cannot be.
pub(super) fn is_sound(
    (section, own): (&Section, Option<[f64; 3]>),
    (element, row): (&Element, &ElementType),
    nodes: &[NodeIndex],
    draft: &mut Draft,
) -> bool {
    let Body::Beam { shape, first_axis, .. } = &section.body else { return true };
    if !row.is_space_beam() {
        note_mixed_moment(section, shape, draft);
        return true;
    }
    has_axes(section, element, (nodes, own.unwrap_or(*first_axis)), draft)
        && resists(section, shape, draft)
}

/// Directions of the axis at the ends of the elements: chords of its parts.
fn has_axes(
    section: &Section,
    element: &Element,
    (nodes, first_axis): (&[NodeIndex], [f64; 3]),
    draft: &mut Draft,
) -> bool {
    let at: Vec<[f64; 3]> = nodes.iter().map(|&node| draft.model.nodes.position(node)).collect();
    let chord = |ends: &[[f64; 3]]| std::array::from_fn(|k| ends[1][k] - ends[0][k]);
    let sound = at.windows(2).all(|ends| section_axes(chord(ends), first_axis).is_some());
    if !sound && draft.log.first_time(&format!("axis 1 of {}", section.set)) {
        let [x, y, z] = first_axis;
        let message = format!(
            "axis 1 of the section, ({x}, {y}, {z}), runs along element {} of the set {}",
            element.label, section.set
        );
        let error = Diagnostic::error(Code("SL0375"), message).at(section.origin);
        let help = "give a direction across the beam on the second data line of the section";
        let error = error.label(element.origin, "the element").help(help);
        draft.consequence(Subject::Elements, error);
    }
    sound
}

/// Complains about a general section without second moments about both axes or without torsion
/// constant.
fn resists(section: &Section, shape: &Shape, draft: &mut Draft) -> bool {
    let Shape::General { second_moments: [first, mixed, second], torsion, .. } = *shape else {
        return true;
    };
    let sound = second > 0.0 && torsion > 0.0 && first * second > mixed * mixed;
    if !sound && draft.log.first_time(&format!("moments of {}", section.set)) {
        let message = format!(
            "the section of {} has I11 = {first}, I12 = {mixed}, I22 = {second}, J = {torsion}: a \
             beam in space bends about both axes and twists",
            section.set
        );
        let error = Diagnostic::error(Code("SL0210"), message).at(section.origin);
        let help = "I22 and J must be positive, I11 I22 greater than I12^2";
        draft.consequence(Subject::Sections, error.help(help));
    }
    sound
}

/// Part of I11 below which I12 is rounding [1].
const NO_MOMENT: f64 = 1e-9;

/// A plane beam bends about axis 1 alone.
fn note_mixed_moment(section: &Section, shape: &Shape, draft: &mut Draft) {
    let [_, mixed, _] = shape.second_moments();
    if mixed.abs() > NO_MOMENT * shape.second_moment()
        && draft.log.first_time(&format!("I12 of {}", section.set))
    {
        let message = format!("I12 = {mixed} is not used: the beam stays in its plane");
        let note = Diagnostic::note(Code("SL0253"), message).at(section.origin);
        draft.log.push(note);
    }
}
