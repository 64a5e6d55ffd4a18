//! Sets and elements refer to things that exist.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{Dialect, NodeSet, NumberedSet};

use super::unknown::unknown_set;
use crate::draft::Draft;
use crate::rule::Subject;
use crate::sets::{Item, Sets};

/// Node sets become part of the model; members and named sets must exist.
pub(super) fn sets(draft: &mut Draft) {
    of_elements(draft);
    let sets = std::mem::take(&mut draft.node_sets);
    check_inner(&sets, "node", Subject::Nodes, draft);
    for set in sets.iter() {
        let members = sets.members(&set.name).unwrap_or_default();
        if !draft.expand(members.len(), set.origin) {
            break;
        }
        let mut found = Vec::with_capacity(members.len());
        for &(label, span) in &members {
            match draft.model.nodes.find(label) {
                Some(index) => found.push(index),
                None => missing("node", label, &set.name, span, Subject::Nodes, draft),
            }
        }
        warn_empty("node", &set.name, members.is_empty(), set.origin, Subject::Nodes, draft);
        let (name, origin) = (set.name.clone(), set.origin);
        draft.model.node_sets.push(NodeSet { name, members: found, origin });
    }
    draft.node_sets = sets;
    let sets = std::mem::take(&mut draft.element_sets);
    check_inner(&sets, "element", Subject::Elements, draft);
    for set in sets.iter() {
        let members = sets.members(&set.name).unwrap_or_default();
        if !draft.expand(members.len(), set.origin) {
            break;
        }
        for &(label, span) in &members {
            if !draft.element_by_label.contains_key(&label) {
                missing("element", label, &set.name, span, Subject::Elements, draft);
            }
        }
        warn_empty("element", &set.name, members.is_empty(), set.origin, Subject::Elements, draft);
    }
    draft.element_sets = sets;
    out_of_plane(draft);
}

/// `*NSET, ELSET=`: the nodes of elements join node sets, each once.
fn of_elements(draft: &mut Draft) {
    for (name, elements) in std::mem::take(&mut draft.node_sets_of_elements) {
        let mut seen = NumberedSet::default();
        for index in draft.elements_of(&elements.name, elements.span).unwrap_or_default() {
            let element = draft.elements[index];
            for &node in element.nodes() {
                if draft.model.nodes.find(node).is_some() && seen.insert(node) {
                    draft.node_sets.join(&name, Item::One(node), elements.span);
                }
            }
        }
    }
}

fn check_inner(sets: &Sets, kind: &str, subject: Subject, draft: &mut Draft) {
    let inner = sets.iter().flat_map(|set| &set.items);
    for (item, span) in inner {
        if let Item::Set(name) = item
            && !sets.contains(name)
        {
            let names = sets.names().take(draft.log.names_to_compare());
            draft.consequence(subject, unknown_set(kind, name, *span, names));
        }
    }
}

fn missing(kind: &str, label: u64, set: &str, span: Span, subject: Subject, draft: &mut Draft) {
    let code = if subject == Subject::Nodes { "SL0304" } else { "SL0308" };
    let message = format!("{kind} {label} in the set {set} is not defined");
    let severity = match draft.dialect {
        Dialect::Abaqus => Diagnostic::error,
        // which leaves it out
        Dialect::Calculix => Diagnostic::warning,
    };
    draft.consequence(subject, severity(Code(code), message).at(span));
}

fn warn_empty(
    kind: &str,
    name: &str,
    empty: bool,
    origin: Span,
    subject: Subject,
    draft: &mut Draft,
) {
    if empty {
        let message = format!("the {kind} set {name} is empty");
        draft.consequence(subject, Diagnostic::warning(Code("SL0305"), message).at(origin));
    }
}

/// Every node of every element must exist; said once for each data line.
pub(super) fn elements(draft: &mut Draft) {
    let mut missing: Vec<(u64, u64, Span)> = Vec::new();
    for element in &draft.elements {
        for &node in element.nodes() {
            if draft.model.nodes.find(node).is_none() {
                missing.push((element.label, node, element.origin));
            }
        }
    }
    for (element, node, origin) in missing {
        let message = format!("element {element} needs node {node}, which is not defined");
        let error = Diagnostic::error(Code("SL0303"), message).at(origin);
        draft.consequence(Subject::Nodes, error);
    }
}

/// In a plane model a third coordinate means nothing: it is set to zero. An instance that was
/// turned out of the plane is none of it.
fn out_of_plane(draft: &mut Draft) {
    if draft.is_spatial() {
        return;
    }
    for (name, origin) in std::mem::take(&mut draft.tilted) {
        let message = format!("the instance {name} is turned out of the plane of this model");
        let error = Diagnostic::error(Code("SL0258"), message).at(origin);
        draft.log.push(error.help("turn it about an axis along z"));
    }
    // elements that are not read may be those in space
    let known = draft.is_complete(Subject::Elements);
    let outside = draft.model.nodes.iter().find(|node| known && node.position[2] != 0.0);
    if let Some(node) = outside {
        let message =
            format!("node {} has z = {}; the model is plane", node.label, node.position[2]);
        let warning = Diagnostic::warning(Code("SL0228"), message).at(node.origin);
        draft.consequence(Subject::Nodes, warning.help("z is not used; set it to zero"));
    }
    for node in 0..draft.model.nodes.len() {
        let [x, y, _] = draft.model.nodes.position(node);
        draft.model.nodes.place(node, [x, y, 0.0]);
    }
}
