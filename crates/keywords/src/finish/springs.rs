//! Springs with their laws become blocks.
//!
//! ```text
//!   SPRING2 between dof a of node 1 and dof b of node 2:   1 a o/\/\/o a h,  u_h,a = u_2,b
//! ```
//! with a node h of its own that stands where node 2 does.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{
    Dof, ElementBlock, ElementType, LinearConstraint, Node, NodeIndex, SpringLaw, SpringSection,
    SpringWay, types,
};

use super::sections::without;
use crate::draft::{Draft, ElementKind, Spring};
use crate::rule::Subject;

const ROWS: [&ElementType; 3] = [&types::SPRING1, &types::SPRING2, &types::SPRINGA];

/// `*SPRING` with its elements.
pub(super) fn springs(draft: &mut Draft) {
    let mut owned = vec![false; draft.elements.len()];
    for spring in draft.springs.clone() {
        let Some(found) = draft.elements_of(&spring.set, spring.set_span) else { continue };
        for row in ROWS {
            block(&spring, row, &found, &mut owned, draft);
        }
        let foreign = |index: &&usize| draft.elements[**index].kind.card() != Some("*SPRING");
        if let Some(&index) = found.iter().find(foreign) {
            let element = draft.elements[index];
            let message = format!(
                "element {} of the set {} is of type {}, which is not a spring",
                element.label,
                spring.set,
                element.kind.name()
            );
            let error = Diagnostic::error(Code("SL0325"), message).at(spring.set_span);
            draft.consequence(Subject::Elements, error);
        }
    }
    for row in ROWS {
        without(row, "*SPRING", &owned, draft);
    }
}

fn block(
    spring: &Spring,
    row: &'static ElementType,
    found: &[usize],
    owned: &mut [bool],
    draft: &mut Draft,
) {
    let own = |index: &&usize| draft.elements[**index].kind == ElementKind::Structural(row);
    let found: Vec<usize> = found.iter().filter(own).copied().collect();
    if found.is_empty() {
        return;
    }
    found.iter().for_each(|&index| owned[index] = true);
    let Some((section, second)) = section(spring, row, draft) else { return };
    let crossed = match section.way {
        SpringWay::Dof(dof) => second.filter(|other| *other != dof).map(|other| (dof, other)),
        _ => None,
    };
    let has_length = matches!(section.way, SpringWay::Line { .. });
    let section = slideline_model::Section::Spring(section);
    let mut block = ElementBlock::new(row, &spring.set, section, spring.origin);
    let labels = || draft.model.nodes.iter().map(|node| node.label);
    let mut last = crossed.map_or(0, |_| labels().max().unwrap_or(0));
    for index in found {
        let element = draft.elements[index];
        let labels = element.nodes().iter();
        let nodes: Option<Vec<NodeIndex>> =
            labels.map(|&label| draft.model.nodes.find(label)).collect();
        let Some(mut nodes) = nodes else { continue };
        if let (Some(dofs), [_, end]) = (crossed, &mut nodes[..]) {
            last += 1;
            *end = stand_in((*end, last), dofs, spring.origin, draft);
        }
        if let [a, b] = *nodes
            && has_length
            && draft.has_no_length(&element, [a, b])
        {
            continue;
        }
        block.elements.push(element.label, &nodes, element.origin);
    }
    draft.model.blocks.push(block);
}

/// A node of a label that is free whose first dof follows the other dof of a node.
fn stand_in(
    (node, label): (NodeIndex, u64),
    (dof, other): (Dof, Dof),
    origin: Span,
    draft: &mut Draft,
) -> NodeIndex {
    let position = draft.model.nodes.position(node);
    draft.cut_nodes.insert(label, draft.uncut(draft.model.nodes.label(node)));
    let own = draft.model.nodes.insert(Node { label, position, origin });
    let (dependent, terms) = ((own, dof), vec![(node, other, 1.0)]);
    draft.crossed_springs.push(LinearConstraint { dependent, terms, constant: 0.0, origin });
    own
}

/// Makes the nodes that stand in for others follow them.
pub(super) fn cross(draft: &mut Draft) {
    for own in std::mem::take(&mut draft.crossed_springs) {
        super::equations::add(draft, own.dependent, own.terms, own.origin);
    }
}

/// What its lines mean for elements of a row, and the dof of a second node; `None` after an error.
fn section(
    spring: &Spring,
    row: &ElementType,
    draft: &mut Draft,
) -> Option<(SpringSection, Option<Dof>)> {
    let in_space = draft.is_spatial();
    let (way, second, lines) = if *row == types::SPRINGA {
        // of two lines the first is to be blank
        let begin = usize::from(!spring.nonlinear && spring.lines.len() > 1);
        (SpringWay::Line { in_space }, None, &spring.lines[begin..])
    } else {
        let first = dof(spring, row, 0, draft)?;
        let second = match *row == types::SPRING2 {
            true => Some(dof(spring, row, 1, draft)?),
            false => None,
        };
        (SpringWay::Dof(first), second, &spring.lines[1..])
    };
    let law =
        if spring.nonlinear { table(lines, spring, draft)? } else { linear(lines, spring, draft)? };
    Some((SpringSection { law, way }, second))
}

/// The dof of a node, on the first line.
fn dof(spring: &Spring, row: &ElementType, at: usize, draft: &mut Draft) -> Option<Dof> {
    let said = |message: String, help: &str, span: Span, draft: &mut Draft| {
        let error = Diagnostic::error(Code("SL0251"), message).at(span);
        draft.consequence(Subject::Sections, error.help(help));
    };
    let Some((first, span)) = spring.lines.first().filter(|_| spring.lines.len() > 1) else {
        let message = format!("{} needs its degree of freedom on the first data line", row.name());
        said(message, "the second line is the stiffness", spring.origin, draft);
        return None;
    };
    let number = first.get(at).copied().unwrap_or_default();
    // a whole number from 1 to 6
    let known = |value: f64| Dof::ALL.into_iter().find(|dof| dof.number() as f64 == value);
    let Some(dof) = known(number) else {
        let message = format!("{number} is not a degree of freedom: 1 to 6");
        draft.log.error("SL0248", message, *span);
        return None;
    };
    if !draft.is_spatial() && !dof.is_plane() {
        let message = format!("a plane model has no dof {}", dof.number());
        said(message, "the plane has the dofs 1, 2 and 6", spring.origin, draft);
        return None;
    }
    Some(dof)
}

fn linear(lines: &[(Vec<f64>, Span)], spring: &Spring, draft: &mut Draft) -> Option<SpringLaw> {
    let Some((stiffness, span)) =
        lines.first().and_then(|(own, span)| Some((*own.first()?, *span)))
    else {
        draft.log.error("SL0208", "the stiffness of the spring is missing", spring.origin);
        return None;
    };
    if stiffness < 0.0 {
        draft.log.warning("SL0210", "a negative spring stiffness", span);
    }
    Some(SpringLaw::Linear(stiffness))
}

/// Lines of force and relative displacement, ascending.
fn table(lines: &[(Vec<f64>, Span)], spring: &Spring, draft: &mut Draft) -> Option<SpringLaw> {
    let mut table = Vec::with_capacity(lines.len());
    let mut last = f64::NEG_INFINITY;
    for (line, span) in lines {
        let &[force, u, ..] = line.as_slice() else {
            draft.log.error("SL0208", "force and relative displacement are two numbers", *span);
            return None;
        };
        if u <= last {
            let message = format!("the relative displacement {u} does not ascend");
            draft.log.error("SL0210", message, *span);
            return None;
        }
        table.push([u, force]);
        last = u;
    }
    if table.len() < 2 {
        let message = "a nonlinear spring needs two lines at least: force, relative displacement";
        draft.log.error("SL0208", message, spring.origin);
        return None;
    }
    Some(SpringLaw::Table(table.into()))
}
