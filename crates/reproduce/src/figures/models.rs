//! Figures 2 and 7: the finite element models, with blow-ups of the contact.

use super::beams::{at_rest, beam, beam_nodes, body, clamp, driver, edge, flat};
use super::figure::{Figure, scene};
use crate::cases::{ModelKind, Stick};
use crate::curve::Curve;
use crate::study::Study;
use slideline::Onset;
use slideline_figures::{Anchor, BLACK, Dash, GREY, Pen, Rectangle, SMALL, Scene, Text, View};

/// A model at rest in a window.
fn panel(scene: &mut Scene, view: &View, curve: &Curve, dot: f64) {
    let places = at_rest(&curve.model);
    beam(scene, view, &curve.model, &places, dot);
    body(scene, view, curve, &places, dot);
    let nodes = beam_nodes(&curve.model);
    if let [first, second, ..] = nodes[..] {
        let [a, b] = [places[first], places[second]];
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        clamp(scene, view, a, [(b[0] - a[0]) / length, (b[1] - a[1]) / length], 4e-3);
    }
    if let Some(node) = driver(&curve.model) {
        let p = places[node];
        let arm = 1.5e-3;
        view.line(scene, &[[p[0] - arm, p[1]], [p[0] + arm, p[1]]], Pen::solid(0.6));
        view.line(scene, &[[p[0], p[1] - arm], [p[0], p[1] + arm]], Pen::solid(0.6));
    }
}

/// The three models of the first problem.
pub(super) fn figure_2(study: &Study) -> Figure {
    let mut scene = scene(358.0, "Three finite element models of the first problem");
    let titles = [
        (ModelKind::IrsCoarse, "IRS, coarse mesh", "24 beams, slaves on the beam"),
        (ModelKind::IrsFine, "IRS, fine mesh", "99 beams, slaves on the beam"),
        (ModelKind::Isl, "ISL, coarse mesh", "24 beams, slaves on the circle"),
    ];
    let width = 143.0;
    for (place, (model, title, below)) in titles.into_iter().enumerate() {
        let left = 6.0 + 149.0 * place as f64;
        let middle = left + 0.5 * width;
        scene.text(Text::new([middle, 14.0], title).bold().anchor(Anchor::Middle));
        scene.text(Text::new([middle, 27.0], below).size(SMALL).anchor(Anchor::Middle));
        let Some(curve) = study.curve(model, Stick::Frictionless, Onset::Immediate) else {
            continue;
        };
        let window = Rectangle { left, top: 34.0, width, height: 182.0 };
        let whole = View { window, middle: [0.5e-3, 25.2e-3], scale: 3.1e3 };
        let dot = if model == ModelKind::IrsFine { 0.7 } else { 1.3 };
        panel(&mut scene, &whole, curve, dot);
        let window = Rectangle { left, top: 226.0, width, height: 126.0 };
        let near = View { window, middle: [8.0e-3, 44.7e-3], scale: 17.0e3 };
        // what the blow-up shows, marked in the whole
        let half = [0.5 * width / near.scale, 63.0 / near.scale];
        let corner = |sx: f64, sy: f64| {
            whole.at([near.middle[0] + sx * half[0], near.middle[1] + sy * half[1]])
        };
        let outline =
            vec![corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0), corner(-1.0, -1.0)];
        scene.polygon(outline, None, Some(Pen::solid(0.6).colour(GREY)));
        panel(&mut scene, &near, curve, 2.3);
        edge(&mut scene, window);
    }
    Figure::new(
        "fig2",
        scene,
        "Finite element models of the first problem, and blow-ups of the contact region \
                  as the decks have it. Discs are slave nodes, open circles the nodes of the \
                  slide line.",
    )
}

/// The model of the second problem.
pub(super) fn figure_7(study: &Study) -> Figure {
    let mut scene = scene(196.0, "Finite element model of the second problem");
    if let Some(curve) = study.curve(ModelKind::Cam, Stick::Penalty, Onset::Immediate) {
        let window = Rectangle { left: 4.0, top: 4.0, width: 268.0, height: 188.0 };
        let whole = View { window, middle: [25.0e-3, 8.6e-3], scale: 4.75e3 };
        turned(&mut scene, &whole, curve);
        panel(&mut scene, &whole, curve, 1.4);
        pivot(&mut scene, &whole, curve);
        blow_up(&mut scene, curve);
    }
    Figure::new(
        "fig7",
        scene,
        "ISL model of the second problem: a rigid cam, turned clockwise into a flexible \
                  member. Grey: the last increment, with friction. Right: the contact in the \
                  middle of the stroke. The dimensions are ours; the paper does not give any.",
    )
}

/// The end of the stroke, in grey.
fn turned(scene: &mut Scene, view: &View, curve: &Curve) {
    let Some(last) = curve.increments.last() else { return };
    let pen = Pen::solid(0.9).colour(GREY);
    let along = |nodes: &[usize]| -> Vec<[f64; 2]> {
        nodes.iter().map(|&node| last.places[node]).collect()
    };
    view.line(scene, &along(&beam_nodes(&curve.model)), pen);
    for pair in &curve.model.contact_pairs {
        view.line(scene, &along(&pair.slave_nodes()), pen);
    }
}

fn pivot(scene: &mut Scene, view: &View, curve: &Curve) {
    let Some(node) = driver(&curve.model) else { return };
    let p = flat(curve.model.nodes.position(node));
    let slaves: Vec<usize> =
        curve.model.contact_pairs.iter().flat_map(|pair| pair.slave_nodes()).collect();
    let thin = Pen::solid(0.5).colour(GREY).dash(Dash::Long);
    for end in [slaves.first(), slaves.last()].into_iter().flatten() {
        view.line(scene, &[p, flat(curve.model.nodes.position(*end))], thin);
    }
    view.dot(scene, p, 2.6, Some(BLACK), None);
    // clockwise, over the pivot
    let radius = 3.6e-3;
    view.arc(scene, p, radius, [0.35, 2.4], Pen::solid(0.9));
    let at = |angle: f64| [p[0] + radius * angle.cos(), p[1] + radius * angle.sin()];
    view.arrow(scene, at(0.45), at(0.05), Pen::solid(0.9));
    view.label(scene, p, [34.0, -10.0], "pivot");
}

fn blow_up(scene: &mut Scene, curve: &Curve) {
    let Some(middle) = curve.increments.get(curve.increments.len() / 2) else { return };
    let closed = middle.contact.iter().max_by(|a, b| a.pressure.total_cmp(&b.pressure));
    let Some(closed) = closed else { return };
    let window = Rectangle { left: 284.0, top: 36.0, width: 164.0, height: 112.0 };
    let view = View { window, middle: flat(closed.position), scale: 36e3 };
    beam(scene, &view, &curve.model, &middle.places, 2.4);
    body(scene, &view, curve, &middle.places, 2.4);
    edge(scene, window);
    let words = format!("increment {}", curve.increments.len() / 2 + 1);
    let at = [window.left + 0.5 * window.width, window.top - 7.0];
    scene.text(Text::new(at, words).anchor(Anchor::Middle));
    let below = window.top + window.height + 14.0;
    let left = window.left + 6.0;
    scene.circle([left + 4.0, below - 3.0], 2.4, Some(BLACK), Some(Pen::solid(0.7)));
    scene.text(Text::new([left + 12.0, below], "slave nodes").size(SMALL));
    let left = left + 82.0;
    let open = Some(slideline_figures::WHITE);
    scene.circle([left, below - 3.0], 2.4, open, Some(Pen::solid(0.7)));
    scene.text(Text::new([left + 8.0, below], "slide line").size(SMALL));
}
