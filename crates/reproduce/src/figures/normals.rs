//! Figure 5: where the normal contact forces point in IRS and ISL models.

use super::beams::{beam, body, driver, edge, flat};
use super::figure::{Figure, scene};
use crate::cases::{INCREMENTS, ModelKind, Stick};
use crate::curve::Curve;
use crate::study::Study;
use slideline::Onset;
use slideline::model::Master;
use slideline_figures::{Anchor, DARK, Dash, GREY, Pen, Rectangle, SMALL, Scene, Text, View};
use slideline_theory::{FirstProblem, Reference, Stroke};

/// The exact contact: its point, and the direction of its force on the beam.
#[derive(Clone, Copy)]
struct Exact {
    point: [f64; 2],
    force: [f64; 2],
}

fn exact(increment: usize) -> Option<Exact> {
    let problem = FirstProblem::diehl();
    let u2 = problem.stroke * increment as f64 / INCREMENTS as f64;
    let found = problem.equilibrium(u2, 0.0, Reference::Reissner, Stroke::Push).ok()??;
    let size = found.reaction[0].hypot(found.reaction[1]);
    Some(Exact { point: found.point, force: found.reaction.map(|f| f / size) })
}

/// Contact forces on the beam at an increment: place and force, without friction.
fn forces(curve: &Curve, increment: usize) -> Vec<([f64; 2], [f64; 2])> {
    let Some(row) = curve.increments.get(increment - 1) else { return Vec::new() };
    // a normal points from the master outwards: to the beam where the circle is master
    let on_beam = match curve.model.contact_pairs.first().map(|pair| &pair.master) {
        Some(Master::RigidSurface(_)) => 1.0,
        _ => -1.0,
    };
    let closed = row.contact.iter().filter(|point| point.pressure > 0.0);
    closed
        .map(|point| {
            let size = on_beam * point.pressure * point.area;
            (flat(point.position), flat(point.normal).map(|n| size * n))
        })
        .collect()
}

fn sum(forces: &[([f64; 2], [f64; 2])]) -> [f64; 2] {
    forces.iter().fold([0.0; 2], |[x, y], (_, f)| [x + f[0], y + f[1]])
}

/// Angle from the exact direction to that of the resultant [degree].
fn tilt(curve: &Curve, increment: usize) -> Option<f64> {
    let exact = exact(increment)?.force;
    // what holds the circle is the force on the beam: the circle is in equilibrium
    let [x, y] = curve.increments.get(increment - 1)?.resultant;
    let angle = (exact[0] * y - exact[1] * x).atan2(exact[0] * x + exact[1] * y);
    Some(angle.to_degrees())
}

/// The increment of the second half of the stroke in which the coarse IRS
/// model is off most.
pub(crate) fn worst_increment(study: &Study) -> Option<usize> {
    let irs = irs(study)?;
    let off = |increment: &usize| tilt(irs, *increment).unwrap_or_default().abs();
    (INCREMENTS / 2..=INCREMENTS).max_by(|a, b| off(a).total_cmp(&off(b)))
}

/// Tilt of the resultant normal force of the coarse IRS, the ISL and the
/// integrated model in that increment [degree].
pub(crate) fn tilts(study: &Study) -> Option<[f64; 3]> {
    let increment = worst_increment(study)?;
    let integrated = study.curve(ModelKind::Integrated, Stick::Frictionless, Onset::Immediate)?;
    let [irs, isl] = [irs(study)?, isl(study)?].map(|curve| tilt(curve, increment));
    Some([irs?, isl?, tilt(integrated, increment)?])
}

fn irs(study: &Study) -> Option<&Curve> {
    study.curve(ModelKind::IrsCoarse, Stick::Frictionless, Onset::Immediate)
}

fn isl(study: &Study) -> Option<&Curve> {
    study.curve(ModelKind::Isl, Stick::Frictionless, Onset::Immediate)
}

/// Both models in that increment.
pub(super) fn figure_5(study: &Study) -> Figure {
    let mut scene = scene(300.0, "Normal contact forces of IRS and ISL models");
    let increment = worst_increment(study).unwrap_or(INCREMENTS);
    let panels = [(irs(study), "a) IRS method"), (isl(study), "b) ISL method")];
    for (place, (curve, title)) in panels.into_iter().enumerate() {
        let window =
            Rectangle { left: 6.0 + 226.0 * place as f64, top: 24.0, width: 216.0, height: 216.0 };
        scene.text(Text::new([window.left, 15.0], title).bold());
        if let (Some(curve), Some(exact)) = (curve, exact(increment)) {
            panel(&mut scene, window, curve, increment, exact);
        }
        edge(&mut scene, window);
    }
    legend(&mut scene);
    Figure::new(
        "fig5",
        scene,
        format!(
            "Normal contact forces on the beam in increment {increment} of our runs without \
             friction, to scale. In a master/slave algorithm a slave node does not penetrate the \
             master surface, but nothing keeps the master from penetrating between slave nodes: \
             with IRS the force acts where a beam node happens to be and points away from the \
             centre of the circle; with ISL it is normal to the beam."
        ),
    )
}

fn panel(scene: &mut Scene, window: Rectangle, curve: &Curve, increment: usize, exact: Exact) {
    let Some(row) = curve.increments.get(increment - 1) else { return };
    let view = View { window, middle: exact.point, scale: 38e3 };
    // the exact line of force, through the tangent point
    let at = |s: f64| [exact.point[0] + s * exact.force[0], exact.point[1] + s * exact.force[1]];
    view.line(scene, &[at(-1.0), at(1.0)], Pen::solid(0.8).colour(GREY).dash(Dash::Centre));
    beam(scene, &view, &curve.model, &row.places, 2.6);
    body(scene, &view, curve, &row.places, 2.6);
    let acting = forces(curve, increment);
    let [x, y] = sum(&acting);
    let total = x.hypot(y);
    for (point, force) in &acting {
        let length = 1.9e-3 / total;
        let tip = [point[0] + length * force[0], point[1] + length * force[1]];
        view.arrow(scene, *point, tip, Pen::solid(1.8).colour(DARK));
    }
    if let Some(tilt) = tilt(curve, increment) {
        let words = format!("{:.1}\u{b0} off theory", tilt.abs());
        let at = [window.left + window.width, window.top - 9.0];
        scene.text(Text::new(at, words).size(SMALL).anchor(Anchor::End));
    }
    if let Some(node) = driver(&curve.model).filter(|&node| !view.sees(row.places[node])) {
        // the centre is out of sight: say on which side the circle lies
        let centre = row.places[node];
        let way = [centre[0] - exact.point[0], centre[1] - exact.point[1]];
        let size = way[0].hypot(way[1]);
        let label = [0, 1].map(|i| exact.point[i] + 1.9e-3 * way[i] / size);
        view.label(scene, label, [-18.0, -26.0], "circle");
    }
}

fn legend(scene: &mut Scene) {
    let y = 262.0;
    scene.arrow([10.0, y], [36.0, y], Pen::solid(1.8).colour(DARK));
    scene.text(Text::new([43.0, y + 3.3], "normal force on the beam").size(SMALL));
    scene.line(vec![[190.0, y], [216.0, y]], Pen::solid(0.8).colour(GREY).dash(Dash::Centre));
    scene
        .text(Text::new([223.0, y + 3.3], "line of force, shear-flexible beam theory").size(SMALL));
    let y = 282.0;
    scene.circle([23.0, y], 2.6, Some(slideline_figures::BLACK), Some(Pen::solid(0.7)));
    scene.text(Text::new([43.0, y + 3.3], "slave node").size(SMALL));
    scene.circle([203.0, y], 2.6, Some(slideline_figures::WHITE), Some(Pen::solid(0.7)));
    scene.text(Text::new([223.0, y + 3.3], "node of the master surface").size(SMALL));
}
