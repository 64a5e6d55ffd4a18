//! Rigid meshes in contact: they are the master, and turn a side to their slaves.

use std::collections::{HashMap, HashSet};

use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactFace, NodeIndex};

use super::rigid_faces::is_rigid;
use super::surfaces::Found;
use crate::draft::{Draft, Element, ElementKind};
use crate::rule::Subject;
use crate::surfaces::{Extent, NamedSurface, Pairing, Side};

/// So many products of slaves and faces are looked at to tell the side of the slaves.
const LOOKED_AT: usize = 10_000_000;

/// Whether a side is rigid: it has no points of contact and must be the master. Complains.
pub(super) fn cannot_be_slave(pairing: &Pairing, slave: &Found, draft: &mut Draft) -> bool {
    let labels: Vec<u64> = match slave {
        Found::Faces(faces) => faces.iter().map(|face| face.label).collect(),
        Found::Facets(facets) => facets.iter().map(|facet| facet.label).collect(),
        _ => return false,
    };
    let rigid = |label: &u64| {
        draft.element_by_label.get(label).is_some_and(|&index| is_rigid(index, draft))
    };
    let Some(label) = labels.into_iter().find(rigid) else { return false };
    let message = format!("element {label} of the slave surface {} is rigid", pairing.slave.name);
    let error = Diagnostic::error(Code("SL0332"), message).at(pairing.slave.span);
    let help = "name the part that deforms first, as the slave, and the rigid mesh second";
    draft.consequence(Subject::Contact, error.help(help));
    true
}

/// Turns a master in space whose rigid elements have no side, or both, to where its slaves are; `None` where
/// they are on both sides, which is said.
pub(super) fn turned(
    pairing: &Pairing,
    surface: &NamedSurface,
    (slave, master): (&Found, &mut Found),
    draft: &mut Draft,
) -> Option<()> {
    let Found::Faces(faces) = master else { return Some(()) };
    if !is_open(surface, draft) {
        return Some(());
    }
    let slaves: Vec<NodeIndex> = match slave {
        Found::Faces(own) => own.iter().flat_map(|face| face.nodes.iter().copied()).collect(),
        Found::Nodes(nodes) => nodes.clone(),
        Found::Facets(own) => own.iter().flat_map(|facet| facet.nodes).collect(),
        _ => return Some(()),
    };
    let (signed, size) = distances(&places(&slaves, draft), faces, draft);
    let [name, other] = [&pairing.master.name, &pairing.slave.name];
    if signed.abs() <= 1e-6 * size {
        let message = format!("{other} lies on both sides of {name}, which has no face label");
        let error = Diagnostic::error(Code("SL0331"), message).at(pairing.master.span);
        draft.consequence(Subject::Contact, error.help("give its elements a face: SPOS or SNEG"));
        return None;
    }
    let side = if signed > 0.0 { Side::Positive } else { Side::Negative };
    if side == Side::Negative {
        faces.iter_mut().for_each(|face| face.nodes.reverse());
    }
    let message = format!("{name} turns its face {} to {other}", side.name());
    let note = Diagnostic::note(Code("SL0330"), message).at(pairing.master.span);
    let help = "a face label on the data line of *SURFACE, SPOS or SNEG, overrides this";
    draft.log.push(note.help(help));
    Some(())
}

/// Whether a surface has rigid elements of which it says no side, or both.
fn is_open(surface: &NamedSurface, draft: &mut Draft) -> bool {
    let Extent::Elements(stretches) = &surface.extent else { return false };
    let mut sides: HashMap<usize, Option<Side>> = HashMap::new();
    for stretch in stretches {
        for index in draft.elements_at(&stretch.elements, stretch.span) {
            let known = *sides.entry(index).or_insert(stretch.side);
            if is_rigid(index, draft) && (stretch.side.is_none() || known != stretch.side) {
                return true;
            }
        }
    }
    false
}

/// Where slaves are that a master turns to: the middles of the solids that have these nodes, which do not
/// move to the other side where a surface lies in the master or on it; of lines the nodes themselves [L].
pub(super) fn places(slaves: &[NodeIndex], draft: &Draft) -> Vec<[f64; 3]> {
    let nodes: HashSet<NodeIndex> = slaves.iter().copied().collect();
    let position = |label: &u64| Some(draft.model.nodes.position(draft.model.nodes.find(*label)?));
    let own =
        |label: &u64| draft.model.nodes.find(*label).is_some_and(|node| nodes.contains(&node));
    let solids = draft.elements.iter().filter(|element| is_solid(element.kind));
    let middle = |element: &Element| -> Option<[f64; 3]> {
        let all: Vec<[f64; 3]> = element.nodes().iter().filter_map(position).collect();
        let sum = |k: usize| all.iter().map(|at| at[k]).sum::<f64>() / all.len() as f64;
        (!all.is_empty()).then(|| std::array::from_fn(sum))
    };
    let found: Vec<_> =
        solids.filter(|one| one.nodes().iter().any(own)).filter_map(middle).collect();
    if found.is_empty() {
        return slaves.iter().map(|&node| draft.model.nodes.position(node)).collect();
    }
    found
}

fn is_solid(kind: ElementKind) -> bool {
    matches!(kind, ElementKind::Structural(row) if !row.cell.faces.is_empty())
}

/// The sum of the distances of slaves from the nearest faces, with the sign of the side, and of
/// their sizes [L].
fn distances(slaves: &[[f64; 3]], faces: &[ContactFace], draft: &Draft) -> (f64, f64) {
    let centres: Vec<([f64; 3], [f64; 3])> = faces.iter().map(|face| plane(face, draft)).collect();
    let most = (LOOKED_AT / faces.len().max(1)).max(1);
    let (mut signed, mut size) = (0.0, 0.0);
    for place in slaves.iter().step_by(slaves.len().div_ceil(most).max(1)) {
        let away = |centre: &[f64; 3]| (0..3).map(|k| (place[k] - centre[k]).powi(2)).sum::<f64>();
        let nearest = centres.iter().min_by(|a, b| away(&a.0).total_cmp(&away(&b.0)));
        let Some((centre, normal)) = nearest else { continue };
        let distance = (0..3).map(|k| (place[k] - centre[k]) * normal[k]).sum::<f64>();
        signed += distance;
        size += away(centre).sqrt();
    }
    (signed, size)
}

/// The centre of a face and its unit normal.
fn plane(face: &ContactFace, draft: &Draft) -> ([f64; 3], [f64; 3]) {
    let at = |k: usize| draft.model.nodes.position(face.nodes[k % face.nodes.len()]);
    let count = face.nodes.len();
    let mut centre = [0.0; 3];
    for k in 0..count {
        (0..3).for_each(|i| centre[i] += at(k)[i] / count as f64);
    }
    // the diagonals of four corners, two edges of three
    let [a, b, c, d] =
        if count == 3 { [at(0), at(1), at(0), at(2)] } else { [at(0), at(2), at(1), at(3)] };
    let [p, q]: [[f64; 3]; 2] =
        [std::array::from_fn(|i| b[i] - a[i]), std::array::from_fn(|i| d[i] - c[i])];
    let cross: [f64; 3] =
        std::array::from_fn(|i| p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3]);
    let length = cross.iter().map(|x| x * x).sum::<f64>().sqrt();
    (centre, cross.map(|x| if length > 0.0 { x / length } else { 0.0 }))
}
