//! Axes of materials and of surfaces: from names and nodes to systems.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::element::solid::Kinematics as Strains;
use slideline_mech::orientation::{Basis, Orientation, of_nodes};
use slideline_model::{ElementType, Kinematics, Master, MasterFaces, NodeIndex};

use crate::axes::{Given, Orientation as Draught, system_of};
use crate::draft::{Draft, Element};
use crate::rule::Subject;
use crate::surfaces::Pairing;

/// The axes that a section names: `Some(None)` without, `None` after an error.
pub(super) fn of_section(
    named: Option<&(String, Span)>,
    draft: &mut Draft,
) -> Option<Option<Orientation>> {
    let Some((name, span)) = named else { return Some(None) };
    let found = of_name((name, *span), draft)?;
    let basis = match found.given {
        Given::Distribution(..) => {
            let message =
                format!("the axes {name} are those of elements: a *SOLID SECTION takes them");
            let error = Diagnostic::error(Code("SL0221"), message).at(*span);
            draft.consequence(Subject::Sections, error.help("name axes that are given by points"));
            return None;
        }
        Given::System(system) => Basis::System(system),
        Given::Own(nodes) => Basis::Nodes(nodes),
        Given::Nodes(system, labels) => {
            let mut points = [[0.0; 3]; 3];
            for (point, label) in points.iter_mut().zip(labels) {
                let Some(label) = label else { continue };
                let Some(node) = draft.model.nodes.find(label) else {
                    let message = format!("node {label} is not defined");
                    let error = Diagnostic::error(Code("SL0304"), message).at(found.line);
                    draft.consequence(Subject::Nodes, error);
                    return None;
                };
                *point = draft.model.nodes.position(node);
            }
            let Some(system) = system_of(system, points) else {
                let message = "these nodes give no direction, or the same one";
                let error = Diagnostic::error(Code("SL0232"), message).at(found.line);
                draft.consequence(Subject::Nodes, error);
                return None;
            };
            Basis::System(system)
        }
    };
    Some(Some(Orientation { basis, turn: found.turn }))
}

/// The orientation of that name; a part may use axes that stand outside of it.
pub(super) fn of_name((name, span): (&str, Span), draft: &mut Draft) -> Option<Draught> {
    let plain = name.rsplit('.').next().unwrap_or(name);
    let find = |name: &str| draft.orientations.iter().find(|own| own.name == name).cloned();
    let found = find(name).or_else(|| find(plain));
    if found.is_none() {
        let names = draft.orientations.iter().map(|own| own.name.as_str());
        let error = unknown("orientation", (name, span), names);
        draft.consequence(Subject::Sections, error);
    }
    found
}

/// That there is no such thing, with the nearest name there is.
pub(super) fn unknown<'a>(
    what: &str,
    (name, span): (&str, Span),
    names: impl Iterator<Item = &'a str>,
) -> Diagnostic {
    let error = Diagnostic::error(Code("SL0308"), format!("there is no {what} {name}")).at(span);
    match slideline_deck::nearest(name, names) {
        Some(near) => error.help(format!("did you mean {near}?")),
        None => error,
    }
}

/// The axes that the pair names for its surfaces; `None` after an error. Those of an analytical surface
/// are its profile and what stands across it.
pub(super) fn of_pair(
    pairing: &Pairing,
    master: &Master,
    draft: &mut Draft,
) -> Option<[Option<Orientation>; 2]> {
    let is_analytical = matches!(
        master,
        Master::RigidSurface(_) | Master::Faces(MasterFaces { swept: Some(_), .. })
    );
    let mut all = [None; 2];
    for (into, named) in all.iter_mut().zip(&pairing.axes) {
        let Some((name, span)) = named else { continue };
        *into = of_section(Some(&(name.clone(), *span)), draft)?;
        let of_nodes = into.is_some_and(|own| matches!(own.basis, Basis::Nodes(_)));
        if is_analytical || of_nodes {
            let why = match is_analytical {
                true => "axes of a pair with an analytical surface are those of its profile",
                false => "axes of a surface are not given by nodes of an element",
            };
            let error = Diagnostic::error(Code("SL0221"), format!("{why}: leave {name} out"));
            draft.consequence(Subject::Contact, error.at(*span));
            return None;
        }
    }
    Some(all)
}

/// Complains about axes that an element cannot have: nodes that give none, or axes out of its
/// plane; false if so.
pub(super) fn suits(
    orientation: &Orientation,
    (element, row): (&Element, &ElementType),
    (nodes, span): (&[NodeIndex], Span),
    draft: &mut Draft,
) -> bool {
    let at: Vec<[f64; 3]> = nodes.iter().map(|&node| draft.model.nodes.position(node)).collect();
    let fault = match orientation.basis {
        Basis::Nodes(own) if of_nodes(&at, own).is_none() => {
            "the nodes of its orientation are on one line, or it has not so many"
        }
        _ if is_tilted(orientation, row, &at) => {
            "axis 3 of its orientation is not along z: the element is plane"
        }
        _ => return true,
    };
    let message = format!("element {}: {fault}", element.label);
    let error = Diagnostic::error(Code("SL0232"), message).at(span);
    draft.consequence(
        Subject::Sections,
        error.help("give a and b so that 1 and 2 are in its plane"),
    );
    false
}

fn is_tilted(orientation: &Orientation, row: &ElementType, nodes: &[[f64; 3]]) -> bool {
    let plane =
        matches!(row.kinematics, Kinematics::Solid { strains, .. } if strains != Strains::Space);
    plane && nodes.iter().any(|&node| orientation.at(nodes, node)[2][2].abs() < 1.0 - 1e-12)
}
