//! The nodes of chains: those of a line with what continues it, and those of a surface that meets itself.

use super::beyond::{Beyond, ChainNode};
use crate::dofs::DofMap;
use slideline_mech::contact::search::chain::Chain;
use slideline_mech::contact::search::itself::{Itself, Run, listed};
use slideline_model::{Model, NodeIndex, OwnSurface, SlideLine, SurfaceRun, SymmetryPlane};

/// The nodes of a line with those that continue it, where something may, in a list that is used again.
pub(super) fn continued(
    (model, dofs): (&Model, &DofMap),
    (line, planes): (&SlideLine, Option<&[SymmetryPlane]>),
    nodes: &mut Vec<ChainNode>,
) -> Beyond {
    let at = |node: NodeIndex| (model.nodes.get(node).position, dofs.translations(node));
    nodes.clear();
    nodes.extend(line.nodes.iter().map(|&node| at(node)));
    let beyond = planes.map(|planes| Beyond::continued(nodes, line.is_ring(), planes));
    beyond.unwrap_or_default()
}

/// The nodes of a surface that meets itself in the order of its list.
pub(super) fn listed_nodes(surface: &OwnSurface) -> Vec<NodeIndex> {
    let nodes: Vec<NodeIndex> = surface.nodes().collect();
    listed(&runs(surface)).into_iter().map(|number| nodes[number]).collect()
}

fn runs(surface: &OwnSurface) -> Vec<Run> {
    let run = |own: &SurfaceRun| Run { nodes: own.nodes.len(), is_closed: own.is_closed };
    surface.runs.iter().map(run).collect()
}

/// Its parts and its chain at the undeformed positions of a model.
pub(super) fn own_parts(
    model: &Model,
    surface: &OwnSurface,
    list: &[NodeIndex],
) -> Option<(Itself, Chain)> {
    let reference: Vec<_> = list.iter().map(|&node| model.nodes.get(node).position).collect();
    Itself::new(&runs(surface), &reference, (surface.smooth, surface.extension))
}
