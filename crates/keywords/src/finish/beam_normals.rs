//! Normals of beams that a deck gives: which way axis 1 of their sections then points.
//!
//! ```text
//!        n2 given      n2 its part across the axis      n1 = n2 x t
//!         \   ^ n2
//!     o----\--|-----> t      at every node; the direction of the element is their mean
//! ```
//! docs/theory.md section 3.9.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::element::space_beam::section_axes;
use slideline_mech::vector::{add, cross, dot, scale, size, sub};
use slideline_model::{ElementType, NodeIndex, Numbered};

use crate::draft::{Body, Draft, Element, ElementKind, Normal, Section};
use crate::rule::Subject;

/// The normals at nodes of elements, by the place of the element in the draft.
#[derive(Default)]
pub(super) struct Normals(Numbered<(usize, NodeIndex), ([f64; 3], Span)>);

impl Normals {
    /// Those of the cards; complains about what has no normal.
    pub fn of(draft: &mut Draft) -> Self {
        let mut all = Self::default();
        for line in draft.normals.clone() {
            let elements = draft.elements_at(&line.elements, line.origin);
            let nodes = draft.nodes_of(&line.nodes, line.origin);
            if elements.is_empty() || nodes.is_empty() {
                continue; // which has been said
            }
            let mut found = false;
            for index in elements {
                let element = draft.elements[index];
                if !is_beam(&element, &line, draft) {
                    found = true;
                    continue;
                }
                for &node in &nodes {
                    let own = element
                        .nodes()
                        .iter()
                        .any(|&label| draft.model.nodes.find(label) == Some(node));
                    if own {
                        all.0.insert((index, node), (line.direction, line.origin));
                        found = true;
                    }
                }
            }
            if !found {
                let message = "no node of this line belongs to its elements";
                let error = Diagnostic::error(Code("SL0304"), message).at(line.origin);
                let help = "give an element and one of its nodes: element, node, n1, n2, n3";
                draft.consequence(Subject::Elements, error.help(help));
            }
        }
        all
    }

    /// Axis 1 of the section of an element, where normals say it; else the `direction` it has without.
    /// `None` after an error.
    pub fn turned(
        &self,
        index: usize,
        (row, nodes): (&ElementType, &[NodeIndex]),
        (section, direction): (&Section, Option<[f64; 3]>),
        draft: &mut Draft,
    ) -> Option<Option<[f64; 3]>> {
        let Body::Beam { first_axis, .. } = section.body else { return Some(direction) };
        if self.0.is_empty() {
            return Some(direction);
        }
        let given: Vec<_> = nodes.iter().map(|&node| self.0.get(&(index, node)).copied()).collect();
        let Some(&(_, origin)) = given.iter().flatten().next() else { return Some(direction) };
        let at: Vec<[f64; 3]> =
            nodes.iter().map(|&node| draft.model.nodes.position(node)).collect();
        if !row.is_space_beam() {
            stands_across(&draft.elements[index].clone(), &at, &given, draft)?;
            return Some(direction);
        }
        let plain = direction.unwrap_or(first_axis);
        let each: Option<Vec<[f64; 3]>> = (0..at.len())
            .map(|place| {
                let along = tangent(&at, place);
                match given[place] {
                    Some((normal, _)) => section_axes(along, normal).map(|[t, n2, _]| cross(n2, t)),
                    None => section_axes(along, plain).map(|[_, n1, _]| n1),
                }
            })
            .collect();
        let label = draft.elements[index].label;
        let Some(each) = each else {
            let message = format!("the normal of element {label} runs along it");
            let error = Diagnostic::error(Code("SL0375"), message).at(origin);
            draft.consequence(Subject::Elements, error.help("give a direction across the beam"));
            return None;
        };
        let mean = each.iter().fold([0.0; 3], |sum, own| add(sum, *own));
        let twist = each.iter().map(|own| size(sub(*own, each[0]))).fold(0.0, f64::max);
        // one point of integration has the mean of both ends; two would each have another one
        if (each.len() > 2 && twist > TWISTED) || size(mean) < 1e-3 {
            let message = format!("the normals of element {label} twist it between its nodes");
            let error = Diagnostic::error(Code("SL0221"), message).at(origin);
            let help =
                "give all nodes of the element normals that turn with its axis alone, or use B31";
            draft.consequence(Subject::Elements, error.help(help));
            return None;
        }
        Some(Some(scale(mean, 1.0 / size(mean))))
    }
}

/// Difference of unit vectors above which they are not the same [1].
const TWISTED: f64 = 1e-6;

/// Complains about an element that has no section to turn; false if so.
fn is_beam(element: &Element, line: &Normal, draft: &mut Draft) -> bool {
    if let ElementKind::Structural(row) = element.kind
        && (row.is_beam() || row.is_space_beam())
    {
        return true;
    }
    if draft.log.first_time(&format!("normal at {:?}", line.origin)) {
        let (label, name) = (element.label, element.kind.name());
        let message =
            format!("element {label} of type {name} has no normal to give: it is no beam");
        let error = Diagnostic::error(Code("SL0325"), message).at(line.origin);
        draft.consequence(Subject::Elements, error.help("leave the line out"));
    }
    false
}

/// Direction of the axis at a node: that of the parabola through three nodes, or the chord.
fn tangent(at: &[[f64; 3]], place: usize) -> [f64; 3] {
    let &[first, middle, last] = at else { return sub(at[at.len() - 1], at[0]) };
    let along = scale(sub(last, first), 0.5);
    let bent = sub(add(first, last), scale(middle, 2.0));
    add(along, scale(bent, place as f64 - 1.0))
}

/// Sections of beams in the plane stand across their axis: complains about a normal that does not, and
/// notes that it says nothing else; `None` after an error.
fn stands_across(
    element: &Element,
    at: &[[f64; 3]],
    given: &[Option<([f64; 3], Span)>],
    draft: &mut Draft,
) -> Option<()> {
    for (place, &own) in given.iter().enumerate() {
        let Some((normal, origin)) = own else { continue };
        let [x, y, _] = tangent(at, place);
        let left = [-y, x, 0.0];
        if dot(normal, left) < NEAR * size(normal) * size(left) {
            let message = format!(
                "the normal at a node of beam {} is not to the left of its way, across it",
                element.label
            );
            let error = Diagnostic::error(Code("SL0221"), message).at(origin);
            let help = "sections of beams in the plane stand across their axis: leave the line out, or \
                        turn the order of the nodes";
            draft.consequence(Subject::Elements, error.help(help));
            return None;
        }
        if draft.log.first_time("normals in the plane") {
            let message =
                "normals of beams in the plane have no effect: sections stand across the axis";
            draft.log.note("SL0253", message, origin);
        }
    }
    Some(())
}

/// Cosine of 20 degrees, within which Abaqus takes normals of neighbours for one.
const NEAR: f64 = 0.939_692_620_785_908_4;
