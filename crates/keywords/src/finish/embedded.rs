//! `*EMBEDDED ELEMENT`: nodes follow the solids that they lie in.
//!
//! ```text
//!   o--------o       e: u_e = sum N_i(xi_e) u_i      xi_e: where e is in its host
//!   |   e....|...    displacements alone; a node that stands in a host's place is none of its own
//!   o--------o
//! ```
//! docs/theory.md section 4.2. The host keeps its own stiffness where it is filled.

use std::collections::HashSet;

use slideline_diag::{Code, Diagnostic};
use slideline_mech::contact::search::tree::BoxTree;
use slideline_mech::element::cell::{Cell, Within, within};
use slideline_model::{Dof, NodeIndex};

use super::equations::add;
use crate::constraints::{Embedment, Outside};
use crate::draft::{Draft, ElementKind};
use crate::rule::Subject;

/// Shares of a host's nodes below this are rounding [1]. (manual)
const ROUNDING: f64 = 1e-6;

/// A solid that others may lie in.
struct Host {
    cell: &'static Cell,
    nodes: Vec<NodeIndex>,
    places: Vec<[f64; 3]>,
    low: [f64; 3],
    high: [f64; 3],
}

impl Host {
    fn new(cell: &'static Cell, nodes: Vec<NodeIndex>, draft: &Draft) -> Self {
        let at = nodes.iter().map(|&node| draft.model.nodes.position(node));
        let places: Vec<[f64; 3]> = at.collect();
        let bound = |least: fn(f64, f64) -> f64| -> [f64; 3] {
            std::array::from_fn(|k| places.iter().map(|x| x[k]).reduce(least).unwrap_or(0.0))
        };
        let (low, high) = (bound(f64::min), bound(f64::max));
        Self { cell, nodes, places, low, high }
    }

    /// The mean of its extents [L].
    fn size(&self) -> f64 {
        let axes = self.cell.dimension;
        (0..axes).map(|k| self.high[k] - self.low[k]).sum::<f64>() / axes as f64
    }

    fn is_near(&self, point: [f64; 3], reach: f64) -> bool {
        (0..self.cell.dimension)
            .all(|k| self.low[k] - reach <= point[k] && point[k] <= self.high[k] + reach)
    }
}

/// Makes the nodes of all embedded elements follow.
pub(super) fn embed(draft: &mut Draft) {
    let (mut done, all) = (HashSet::new(), std::mem::take(&mut draft.embedments));
    let mut inner = |own: &Embedment| -> Vec<usize> {
        let targets = own.embedded.iter();
        targets.flat_map(|(target, span)| draft.elements_at(target, *span)).collect()
    };
    let inner: Vec<Vec<usize>> = all.iter().map(&mut inner).collect();
    let embedded: HashSet<usize> = inner.iter().flatten().copied().collect();
    for (embedment, inner) in all.iter().zip(&inner) {
        one((embedment, inner), &embedded, &mut done, draft);
    }
}

fn one(
    (embedment, inner): (&Embedment, &[usize]),
    embedded: &HashSet<usize>,
    done: &mut HashSet<NodeIndex>,
    draft: &mut Draft,
) {
    let Some(hosts) = hosts(embedment, embedded, draft) else { return };
    let own: HashSet<NodeIndex> = hosts.iter().flat_map(|host| host.nodes.clone()).collect();
    let mut nodes: Vec<NodeIndex> =
        inner.iter().flat_map(|&index| nodes_of(index, draft)).collect();
    nodes.retain(|node| !own.contains(node) && done.insert(*node));
    nodes.sort_unstable();
    let reach = reach(&hosts, embedment.outside);
    let tree = BoxTree::<3>::new(hosts.len(), |host| (hosts[host].low, hosts[host].high));
    let mut lost = Vec::new();
    for node in nodes {
        match found((&hosts, &tree), draft.model.nodes.position(node), reach) {
            Some((host, place)) => follow(node, (host, &place), embedment, draft),
            None => lost.push(node),
        }
    }
    if let Some(&node) = lost.first() {
        let name = draft.model.nodes.name(node);
        let message = format!("{} embedded nodes lie in no host, as node {name}", lost.len());
        let error = Diagnostic::error(Code("SL0317"), message).at(embedment.origin);
        let help = "name all solids they lie in: HOST ELSET, or give a larger EXTERIOR TOLERANCE";
        draft.consequence(Subject::Links, error.help(help));
    }
}

fn nodes_of(index: usize, draft: &Draft) -> Vec<NodeIndex> {
    let element = draft.elements[index];
    element.nodes().iter().filter_map(|&label| draft.model.nodes.find(label)).collect()
}

/// The solids of the set, or all, without those that are embedded; `None` after an error.
fn hosts(embedment: &Embedment, inner: &HashSet<usize>, draft: &mut Draft) -> Option<Vec<Host>> {
    let named = match &embedment.hosts {
        Some(set) => draft.elements_of(&set.name, set.span)?,
        None => (0..draft.elements.len()).collect(),
    };
    let mut hosts: Vec<Host> = Vec::new();
    for index in named.into_iter().filter(|index| !inner.contains(index)) {
        let ElementKind::Structural(row) = draft.elements[index].kind else { continue };
        if row.cell.dimension >= 2 && row.joins() {
            hosts.push(Host::new(row.cell, nodes_of(index, draft), draft));
        }
    }
    hosts.retain(|host| host.nodes.len() == host.cell.nodes);
    if hosts.is_empty() {
        let span = embedment.hosts.as_ref().map_or(embedment.origin, |set| set.span);
        let message = "the hosts of *EMBEDDED ELEMENT are solids, and here is none";
        let error = Diagnostic::error(Code("SL0317"), message).at(span);
        draft.consequence(Subject::Elements, error.help("name solids with HOST ELSET"));
        return None;
    }
    Some(hosts)
}

/// How far from a host a node may lie [L].
fn reach(hosts: &[Host], outside: Outside) -> f64 {
    let size = hosts.iter().map(Host::size).sum::<f64>() / hosts.len() as f64;
    outside.distance.min(outside.part * size)
}

/// The host that a point lies in, or the nearest one within reach.
fn found<'a>(
    (hosts, tree): (&'a [Host], &BoxTree<3>),
    point: [f64; 3],
    reach: f64,
) -> Option<(&'a Host, Within)> {
    let mut near = Vec::new();
    let window = (point.map(|x| x - reach), point.map(|x| x + reach));
    tree.overlapping(window, |host| near.push(host));
    near.sort_unstable();
    let mut best: Option<(&Host, Within)> = None;
    for host in near.into_iter().map(|host| &hosts[host]).filter(|host| host.is_near(point, reach))
    {
        let Some(place) = within(host.cell, &host.places, point) else { continue };
        let nearer = best.as_ref().is_none_or(|(_, known)| place.distance < known.distance);
        if place.distance <= reach && nearer {
            best = Some((host, place));
        }
        if best.as_ref().is_some_and(|(host, known)| known.distance <= ROUNDING * host.size()) {
            break;
        }
    }
    best
}

fn follow(
    node: NodeIndex,
    (host, found): (&Host, &Within),
    embedment: &Embedment,
    draft: &mut Draft,
) {
    let mut shapes = vec![0.0; host.cell.nodes];
    (host.cell.shapes)(&found.place, &mut shapes);
    shapes.iter_mut().filter(|share| share.abs() < ROUNDING).for_each(|share| *share = 0.0);
    let sum: f64 = shapes.iter().sum();
    let moves: Vec<Dof> =
        draft.model.directions().iter().copied().filter(|dof| !dof.is_rotation()).collect();
    for dof in moves {
        let terms = draft.followed((node, dof), |dof| {
            let shares = host.nodes.iter().zip(&shapes).filter(|(_, share)| **share != 0.0);
            shares.map(|(&leader, share)| (leader, dof, share / sum)).collect()
        });
        add(draft, (node, dof), terms, embedment.origin);
    }
}
