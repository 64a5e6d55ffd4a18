//! What the drawings of models have in common: meshes at a moment of a run.

use crate::curve::Curve;
use slideline::Model;
use slideline::model::{Master, NodeIndex};
use slideline_figures::{BLACK, GREY, Pen, Rectangle, Scene, View, WHITE};

/// A place in the plane of the drawing.
pub(super) fn flat([x, y, _]: [f64; 3]) -> [f64; 2] {
    [x, y]
}

/// Undeformed places of all nodes [L].
pub(super) fn at_rest(model: &Model) -> Vec<[f64; 2]> {
    (0..model.nodes.len()).map(|node| flat(model.nodes.position(node))).collect()
}

/// Nodes of the flexible beam, in order: those of beams that are not tied to
/// a rigid body.
pub(super) fn beam_nodes(model: &Model) -> Vec<NodeIndex> {
    let tied = |node| model.rigid_links.iter().any(|link| link.dependent == node);
    let mut nodes = Vec::new();
    for block in &model.blocks {
        let Some(block) = block.beams() else { continue };
        for element in block.elements.iter().filter(|element| !tied(element.nodes[0])) {
            let begun = usize::from(nodes.last() == Some(&element.nodes[0]));
            nodes.extend(element.nodes.iter().skip(begun));
        }
    }
    nodes
}

/// The node whose motion drives the model.
pub(super) fn driver(model: &Model) -> Option<NodeIndex> {
    let moving = model.steps.iter().flat_map(|step| &step.prescribed).find(|p| p.moves());
    moving.map(|prescribed| prescribed.node)
}

/// Draws the beam's line and its nodes: discs where they are slaves, open
/// circles where they are masters.
pub(super) fn beam(
    scene: &mut Scene,
    view: &View,
    model: &Model,
    places: &[[f64; 2]],
    radius: f64,
) {
    let nodes = beam_nodes(model);
    let line: Vec<[f64; 2]> = nodes.iter().map(|&node| places[node]).collect();
    view.line(scene, &line, Pen::solid(1.1));
    let slaves = slaves(model);
    for node in nodes {
        let fill = if slaves.contains(&node) { BLACK } else { WHITE };
        view.dot(scene, places[node], radius, Some(fill), Some(Pen::solid(0.7)));
    }
}

/// Draws the slave nodes of a rigid body and the polygon they make, with the
/// circle they lie on in grey; the circle itself where the surface is analytic.
pub(super) fn body(
    scene: &mut Scene,
    view: &View,
    curve: &Curve,
    places: &[[f64; 2]],
    radius: f64,
) {
    let model = &curve.model;
    for pair in &model.contact_pairs {
        match &pair.master {
            Master::Faces(_) | Master::Itself(_) => {} // the paper's models are plane
            Master::RigidSurface(surface) => {
                view.circle(scene, places[surface.reference], 9e-3, Pen::solid(1.1));
            }
            Master::SlideLine(_) => {
                let nodes = pair.slave_nodes();
                let on_rim = [0, nodes.len() / 2, nodes.len() - 1].map(|i| places[nodes[i]]);
                if let Some((centre, size)) = circle_through(on_rim) {
                    view.circle(scene, centre, size, Pen::solid(0.7).colour(GREY));
                }
                let line: Vec<[f64; 2]> = nodes.iter().map(|&node| places[node]).collect();
                view.line(scene, &line, Pen::solid(1.1));
                for node in nodes {
                    let pen = Some(Pen::solid(0.7));
                    view.dot(scene, places[node], radius, Some(BLACK), pen);
                }
            }
        }
    }
}

/// Centre and radius of the circle through three points.
fn circle_through([a, b, c]: [[f64; 2]; 3]) -> Option<([f64; 2], f64)> {
    let [p, q] = [[b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]];
    let twice = 2.0 * (p[0] * q[1] - p[1] * q[0]);
    let [pp, qq] = [p, q].map(|v| v[0] * v[0] + v[1] * v[1]);
    let [x, y] = [(q[1] * pp - p[1] * qq) / twice, (p[0] * qq - q[0] * pp) / twice];
    (twice != 0.0).then(|| ([a[0] + x, a[1] + y], x.hypot(y)))
}

fn slaves(model: &Model) -> Vec<NodeIndex> {
    model.contact_pairs.iter().flat_map(|pair| pair.slave_nodes()).collect()
}

/// Hatching beside a clamped end; `along` points along the beam.
pub(super) fn clamp(scene: &mut Scene, view: &View, at: [f64; 2], along: [f64; 2], half: f64) {
    let across = [-along[1], along[0]];
    let point = |s: f64, d: f64| {
        [at[0] + s * across[0] - d * along[0], at[1] + s * across[1] - d * along[1]]
    };
    view.line(scene, &[point(-half, 0.0), point(half, 0.0)], Pen::solid(1.4));
    for place in 0..=6 {
        let s = half * (f64::from(place) / 3.0 - 1.0);
        view.line(scene, &[point(s, 0.0), point(s - 0.3 * half, 0.5 * half)], Pen::solid(0.6));
    }
}

/// The edge of a window.
pub(super) fn edge(scene: &mut Scene, window: Rectangle) {
    scene.polygon(window.corners(), None, Some(Pen::solid(0.6)));
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)] // a test may fail where it stands

    use super::*;
    use slideline::{Job, ReadOptions};

    /// Requirement: the line of the beam passes through every node in order,
    /// whichever type its elements are.
    #[test]
    fn every_type_of_beam_is_drawn_through_its_nodes() {
        let b21 = include_str!("../../../../corpus/diehl1995/surface_coarse.inp");
        let b22 =
            b21.replace("101, 1, 2\n", "101, 1, 2, 3\n").replace("101, 24, 1, 1", "101, 12, 2, 1");
        for (kind, text) in [("B21", b21), ("B22", &b22), ("B23", b21)] {
            let text = text.replace("TYPE=B21", &format!("TYPE={kind}"));
            let model = Job::read_text("beams", &text, &ReadOptions::default()).model.unwrap();
            let labels: Vec<u64> =
                beam_nodes(&model).into_iter().map(|node| model.nodes.get(node).label).collect();
            assert_eq!(labels, (1..=25).collect::<Vec<u64>>(), "{kind}");
        }
    }
}
