//! Couplings: the nodes of a surface, or named ones, and a reference node.

use std::collections::{HashMap, HashSet};

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::axes::{Axes, PLAIN};
use slideline_mech::vector::cross;
use slideline_model::{Dialect, Dof, NodeIndex, RigidLink, System};

use super::distributing::{Mean, distribute};
use super::equations::{add, solve};
use super::orientations::of_section;
use super::rigid_link::tie;
use super::{steps, tributary};
use crate::constraints::{Coupling, CouplingKind, Fading, Points};
use crate::draft::Draft;
use crate::log::Target;
use crate::rule::Subject;

/// Factors of weights below this are rounding [1].
const NOUGHT: f64 = 1e-9;

/// Parts of unit vectors below this are rounding [1].
const ROUNDING: f64 = 1e-12;

/// The node of the only element of a set, which is one of a coupling.
fn reference_element(set: &str, span: Span, draft: &mut Draft) -> Option<NodeIndex> {
    let found = draft.elements_of(set, span)?;
    let references = found.iter().filter(|&&index| draft.elements[index].kind.is_reference());
    let nodes: Vec<u64> = references.map(|&index| draft.elements[index].nodes[0]).collect();
    if let [label] = *nodes
        && found.len() == 1
    {
        return draft.model.nodes.find(label);
    }
    let message = format!("the set {set} must have one element, of type DCOUP2D or DCOUP3D");
    let error = Diagnostic::error(Code("SL0317"), message).at(span);
    draft.consequence(Subject::Elements, error.help("each coupling has an element of its own"));
    None
}

/// Gives the reference nodes of `*DISTRIBUTING` the axes of their coupling: in the dialect of CalculiX
/// forces and moments on them are along these.
pub(super) fn axes_of_references(draft: &mut Draft) {
    if draft.dialect != Dialect::Calculix {
        return;
    }
    let mut named = None;
    for coupling in draft.couplings.clone() {
        let distributes = matches!(coupling.kind, CouplingKind::Distributing(..));
        let Some((_, span)) = coupling.axes.as_ref().filter(|_| distributes) else { continue };
        let Some(Some(orientation)) = of_section(coupling.axes.as_ref(), draft) else { continue };
        let Some(node) = draft.reference_of(&coupling.reference, coupling.reference_span) else {
            continue;
        };
        let axes = orientation.at(&[], draft.model.nodes.position(node));
        match draft.axes.get(&node) {
            Some(known) if *known == axes => continue,
            Some(_) => {
                two_systems(node, *span, draft);
                continue;
            }
            None if are_plain(&axes) => continue,
            None => {
                let named = named.get_or_insert_with(|| nodes_of_equations(draft));
                if let Some(&at) = named.get(&node) {
                    in_equations(node, (at, *span), draft);
                }
            }
        }
        let system = System::Rectangular(axes);
        super::axes::give(vec![node], system, *span, draft);
    }
}

/// The axes of a coupling are those of its reference node, which may have others.
fn two_systems(node: NodeIndex, span: Span, draft: &mut Draft) {
    let name = draft.model.nodes.name(node);
    let message =
        format!("the reference node {name} has axes of its own, and its coupling has others");
    let error = Diagnostic::error(Code("SL0349"), message).at(span);
    let help = "give both the same axes, or leave out *TRANSFORM of that node or ORIENTATION of the coupling";
    draft.consequence(Subject::Nodes, error.help(help));
}

/// Whether axes are those of the model.
fn are_plain(axes: &Axes) -> bool {
    let own = axes.iter().flatten().zip(PLAIN.as_flattened());
    own.into_iter().all(|(own, plain)| (own - plain).abs() <= ROUNDING)
}

/// The nodes that equations name, with the first place.
fn nodes_of_equations(draft: &mut Draft) -> HashMap<NodeIndex, Span> {
    let terms = draft.equations.iter().flat_map(|own| &own.terms);
    let terms: Vec<(Target, Span)> = terms.map(|term| (term.node.clone(), term.span)).collect();
    let mut named = HashMap::new();
    for (target, at) in terms {
        for node in draft.nodes_of(&target, at) {
            named.entry(node).or_insert(at);
        }
    }
    named
}

/// Equations that name a reference node mean axes that the coupling has not: nothing says which.
fn in_equations(node: NodeIndex, (at, span): (Span, Span), draft: &mut Draft) {
    let name = draft.model.nodes.name(node);
    let message = format!(
        "the reference node {name} has the axes of its coupling, and an equation names it: along which axes \
         is not said"
    );
    let error = Diagnostic::error(Code("SL0349"), message).at(at);
    let error = error.label(span, "the axes of the coupling");
    let help =
        "leave out ORIENTATION, or give the node these axes by *TRANSFORM, which equations follow";
    draft.consequence(Subject::Nodes, error.help(help));
}

/// Couples the nodes of a coupling with its reference node.
pub(super) fn couple(coupling: &Coupling, draft: &mut Draft) {
    let reference = match &coupling.reference {
        Target::Set(set) if coupling.of_element => {
            reference_element(set, coupling.reference_span, draft)
        }
        node => draft.reference_of(node, coupling.reference_span),
    };
    let before = draft.log.errors();
    let mut nodes = nodes_of(&coupling.points, draft);
    let Some(master) = reference else { return };
    let mut seen = HashSet::from([master]);
    nodes.retain(|&(node, _)| seen.insert(node));
    let distance = |node| distance(master, node, draft);
    let found = !nodes.is_empty();
    nodes.retain(|&(node, _)| coupling.within.is_none_or(|radius| distance(node) <= radius));
    let origin = coupling.origin;
    if nodes.is_empty() {
        if draft.log.errors() == before {
            let error = Diagnostic::error(Code("SL0317"), "this coupling has no nodes").at(origin);
            let help = match found {
                true => "none is within INFLUENCE RADIUS of the reference node",
                false => "name nodes other than the reference node",
            };
            draft.consequence(Subject::Links, error.help(help));
        }
        return;
    }
    match coupling.kind {
        CouplingKind::Kinematic(follows) => {
            let nodes: Vec<NodeIndex> = nodes.into_iter().map(|(node, _)| node).collect();
            kinematic(coupling, master, (&nodes, follows), draft);
        }
        CouplingKind::Distributing(dofs, fading) => {
            fade(&mut nodes, (fading, master), draft);
            let older = coupling.of_element && draft.dialect == Dialect::Calculix;
            let mean = if older { Mean::Displacement } else { Mean::Motion };
            distribute((master, mean), coupled(dofs), &nodes, origin, draft);
        }
        CouplingKind::Open => {
            let message = "*COUPLING does not say how: *KINEMATIC or *DISTRIBUTING must follow";
            let error = Diagnostic::error(Code("SL0205"), message).at(origin);
            draft.consequence(Subject::Links, error);
        }
    }
}

/// The nodes with their weights: the areas of a surface of elements, else what is given.
fn nodes_of(points: &[Points], draft: &mut Draft) -> Vec<(NodeIndex, f64)> {
    let mut nodes: Vec<(NodeIndex, f64)> = Vec::new();
    for points in points {
        match points {
            Points::Nodes { target, span, weight } => {
                let found = draft.nodes_of(target, *span);
                nodes.extend(found.into_iter().map(|node| (node, *weight)));
            }
            Points::Surface(named) => {
                let Some(surface) = draft.surface(named) else { continue };
                nodes.extend(tributary::areas(&surface, named.span, draft));
            }
        }
    }
    nodes
}

fn distance(from: NodeIndex, to: NodeIndex, draft: &Draft) -> f64 {
    let [a, b] = [from, to].map(|node| draft.model.nodes.position(node));
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

/// Weights that fall with the distance from the reference node.
fn fade(nodes: &mut [(NodeIndex, f64)], (fading, master): (Fading, NodeIndex), draft: &Draft) {
    let largest = nodes.iter().map(|&(node, _)| distance(master, node, draft)).fold(0.0, f64::max);
    let factors: Vec<f64> = nodes
        .iter()
        .map(|&(node, _)| fading.at(distance(master, node, draft) / largest.max(f64::MIN_POSITIVE)))
        .collect();
    // nodes of one distance count alike, though each is the farthest
    if factors.iter().any(|factor| *factor > NOUGHT) {
        nodes.iter_mut().zip(factors).for_each(|((_, weight), factor)| *weight *= factor);
    }
}

/// The dofs of the reference node that follow the mean: rotations alone can be left out.
fn coupled(dofs: [bool; 6]) -> [bool; 6] {
    std::array::from_fn(|k| dofs[k] || k < 3)
}

/// Nodes that follow rigidly; along axes that are given, if these make a difference.
fn kinematic(
    coupling: &Coupling,
    master: NodeIndex,
    (nodes, follows): (&[NodeIndex], [bool; 6]),
    draft: &mut Draft,
) {
    let origin = coupling.origin;
    let directions = draft.model.directions();
    let displacements = directions.iter().filter(|dof| !dof.is_rotation());
    let count = displacements.clone().filter(|dof| follows[**dof as usize]).count();
    let differs = count > 0 && count < displacements.count();
    let Some((_, span)) = coupling.axes.as_ref().filter(|_| differs) else {
        for &dependent in nodes {
            tie(RigidLink { dependent, master, follows, turn: None, origin }, draft);
        }
        return;
    };
    if draft.steps.iter().any(|step| step.nlgeom) {
        let message = "*COUPLING, ORIENTATION= of some displacements is not supported with NLGEOM";
        let error = Diagnostic::error(Code("SL0221"), message).at(*span);
        let help = "couple all displacements, or turn the dofs of the nodes by *TRANSFORM";
        draft.consequence(Subject::Links, error.help(help));
        return;
    }
    along_axes(coupling, master, (nodes, follows), draft);
}

/// Displacements along given axes follow a small rigid motion: a.(u - u_ref - theta x r) = 0.
fn along_axes(
    coupling: &Coupling,
    master: NodeIndex,
    (nodes, follows): (&[NodeIndex], [bool; 6]),
    draft: &mut Draft,
) {
    let Some(Some(orientation)) = of_section(coupling.axes.as_ref(), draft) else { return };
    let directions = draft.model.directions();
    let (turns, moves): (Vec<Dof>, Vec<Dof>) =
        directions.iter().copied().partition(|dof| dof.is_rotation());
    let prescribed = steps::prescribed(draft);
    for &node in nodes {
        let [x, centre] = [node, master].map(|node| draft.model.nodes.position(node));
        let arm: [f64; 3] = std::array::from_fn(|k| x[k] - centre[k]);
        let mut names: Vec<(NodeIndex, Dof)> = moves.iter().map(|&dof| (node, dof)).collect();
        names.extend(moves.iter().chain(&turns).map(|&dof| (master, dof)));
        let axes = orientation.at(&[], x);
        let row = |axis: [f64; 3]| {
            let lever = cross(arm, axis);
            let of = |&(own, dof): &(NodeIndex, Dof)| {
                let along = if dof.is_rotation() { lever } else { axis };
                let part = slideline_mech::vector::dot(along, draft.direction(own, dof));
                if own == node { part } else { -part }
            };
            names.iter().map(of).collect::<Vec<f64>>()
        };
        let wanted = moves.iter().filter(|dof| follows[**dof as usize]);
        let rows: Vec<Vec<f64>> = wanted.map(|&dof| row(axes[dof as usize])).collect();
        let is_taken = |name: &(NodeIndex, Dof)| {
            name.0 == master || draft.dependents.contains_key(name) || prescribed.contains(name)
        };
        let taken: Vec<bool> = names.iter().map(is_taken).collect();
        let Some(solved) = solve(rows, moves.len(), &taken) else {
            let label = draft.model.nodes.name(node);
            let message =
                format!("dofs of node {label} are prescribed or follow others, and are coupled");
            let error = Diagnostic::error(Code("SL0315"), message).at(coupling.origin);
            draft.consequence(Subject::Links, error.help("leave the node out of one of them"));
            return;
        };
        for (pivot, row) in &solved {
            let others = row.iter().enumerate().filter(|(c, a)| c != pivot && **a != 0.0);
            let terms = others.map(|(c, a)| (names[c].0, names[c].1, -a)).collect();
            add(draft, names[*pivot], terms, coupling.origin);
        }
    }
}
