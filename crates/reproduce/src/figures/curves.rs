//! Figures 3, 4, 6 and 8: force and moment curves, theory as lines, finite
//! elements as symbols.

use super::figure::{Figure, WIDTH, scene};
use crate::cases::{FRICTION, ModelKind, Stick};
use crate::curve::Curve;
use crate::study::Study;
use crate::theory::Theory;
use slideline::Onset;
use slideline_figures::{
    Anchor, Axis, DARK, Dash, Entry, Frame, GREY, Marker, Pen, Rectangle, SMALL, Scene, Text,
};
use std::f64::consts::PI;

const HEIGHT: f64 = 300.0;
const SMOOTH: Pen = Pen::solid(1.2);
const DASHED: Pen = Pen::solid(1.2).dash(Dash::Long);

/// Millimetre and newton, or degree and newton millimetre.
fn in_units(problem: u8, [motion, reaction]: [f64; 2]) -> [f64; 2] {
    if problem == 1 { [1e3 * motion, reaction] } else { [motion * 180.0 / PI, 1e3 * reaction] }
}

fn points(curve: Option<&Curve>) -> Vec<[f64; 2]> {
    let Some(curve) = curve else { return Vec::new() };
    let problem = curve.case.model.problem();
    curve.increments.iter().map(|row| in_units(problem, [row.motion, row.reaction])).collect()
}

/// Linear theory as a fine line.
fn theory(study: &Study, problem: u8, with_friction: bool) -> Vec<[f64; 2]> {
    let place = 2 * usize::from(problem - 1) + usize::from(with_friction);
    study.references.lines[place].iter().map(|&point| in_units(problem, point)).collect()
}

fn frame(x: Axis, y: Axis) -> Frame {
    let window = Rectangle { left: 52.0, top: 10.0, width: WIDTH - 62.0, height: HEIGHT - 46.0 };
    Frame::new(window, [x, y], std::iter::empty())
}

fn displacement() -> Axis {
    Axis::fixed("vertical displacement of the circle  *\u{3b4}y*  (mm)", [0.0, -31.5], 5.0, 0)
}

/// F_y over the displacement, to `top` newton; a step of room below zero.
fn force_chart(top: f64, step: f64) -> Frame {
    let decimals = usize::from(step < 5.0);
    let title = "vertical force  *F*_{y}  (N)";
    frame(displacement(), Axis::fixed(title, [step, -top], step, decimals))
}

fn moment_chart() -> Frame {
    let y = Axis::fixed("drive moment  *M*_{z}  (N mm)", [40.0, -120.0], 20.0, 0);
    frame(Axis::fixed("rotation of the cam  (\u{b0})", [0.0, -62.0], 10.0, 0), y)
}

fn line(pen: Pen, words: &str) -> Entry {
    Entry { pen: Some(pen), marker: None, words: words.to_owned() }
}

fn symbol(marker: Marker, words: &str) -> Entry {
    Entry { pen: Some(Pen::solid(0.6).colour(GREY)), marker: Some(marker), words: words.to_owned() }
}

fn friction(mu: f64) -> String {
    format!("*\u{3bc}* = {mu}")
}

/// Theory of the first problem.
pub(super) fn figure_3(study: &Study) -> Figure {
    let mut scene = scene(HEIGHT, "Vertical force over displacement, theory");
    let chart = force_chart(40.0, 5.0);
    chart.ticks(&mut scene);
    chart.line(&mut scene, &theory(study, 1, true), DASHED);
    chart.line(&mut scene, &theory(study, 1, false), SMOOTH);
    let entries = [
        line(DASHED, &format!("theory, {}", friction(FRICTION))),
        line(SMOOTH, "theory, *\u{3bc}* = 0"),
    ];
    chart.legend(&mut scene, [16.0, 20.0], &entries);
    Figure::new(
        "fig3",
        scene,
        "Theoretical answer of the first problem with and without friction: linear \
                  theory, equations (1) to (8).",
    )
}

const MODELS: [(ModelKind, Marker, &str); 3] = [
    (ModelKind::IrsCoarse, Marker::Square, "IRS, coarse mesh (24 beams)"),
    (ModelKind::IrsFine, Marker::Cross, "IRS, fine mesh (99 beams)"),
    (ModelKind::Isl, Marker::Disc, "ISL, coarse mesh (24 beams)"),
];

/// The three models of the first problem against theory.
fn three_models(
    study: &Study,
    scene: &mut Scene,
    chart: &Frame,
    stick: Stick,
    onset: Onset,
) -> Vec<Entry> {
    let mut entries = Vec::new();
    for (model, marker, words) in MODELS {
        chart.series(scene, &points(study.curve(model, stick, onset)), marker);
        entries.push(symbol(marker, words));
    }
    entries
}

/// The three models without friction.
pub(super) fn figure_4(study: &Study) -> Figure {
    let mut scene = scene(HEIGHT, "Three models without friction against theory");
    let chart = force_chart(15.0, 2.5);
    chart.ticks(&mut scene);
    chart.line(&mut scene, &theory(study, 1, false), SMOOTH);
    let mut entries = vec![line(SMOOTH, "theory, *\u{3bc}* = 0")];
    entries.extend(three_models(study, &mut scene, &chart, Stick::Frictionless, Onset::Immediate));
    chart.legend(&mut scene, [16.0, 20.0], &entries);
    Figure::new(
        "fig4",
        scene,
        "Finite element models of the first problem without friction, 20 equal \
                  increments, a symbol at each.",
    )
}

fn figure_6(study: &Study, onset: Onset, title: &str) -> (Scene, Frame) {
    let mut scene = scene(HEIGHT, title);
    let chart = force_chart(40.0, 5.0);
    chart.ticks(&mut scene);
    chart.line(&mut scene, &theory(study, 1, true), DASHED);
    chart.line(&mut scene, &theory(study, 1, false), SMOOTH);
    let mut entries = vec![
        line(DASHED, &format!("theory, {}", friction(FRICTION))),
        line(SMOOTH, "theory, *\u{3bc}* = 0"),
    ];
    entries.extend(three_models(study, &mut scene, &chart, Stick::Penalty, onset));
    chart.legend(&mut scene, [16.0, 20.0], &entries);
    (scene, chart)
}

/// With friction, under the logic of 1995.
pub(super) fn figure_6a(study: &Study) -> Figure {
    let title = "Three models with friction, friction logic of 1995";
    let (mut scene, chart) = figure_6(study, Onset::Matfru, title);
    let note = |scene: &mut Scene, model, lost: bool, words: [&str; 2], at: [f64; 2]| {
        if let Some(point) = remarkable(study, model, lost) {
            let target = chart.at(point);
            let from = [chart.window.left + at[0], chart.window.top + at[1]];
            let [dx, dy] = [target[0] - from[0], target[1] - from[1]];
            let reach = 1.0 - 5.0 / dx.hypot(dy);
            let tip = [from[0] + reach * dx, from[1] + reach * dy];
            scene.arrow([from[0] + 3.0, from[1]], tip, Pen::solid(0.7).colour(DARK));
            for (line, words) in words.into_iter().enumerate() {
                let base = [from[0], from[1] - 7.0 + 11.0 * line as f64];
                scene.text(Text::new(base, words).size(SMALL).anchor(Anchor::End));
            }
        }
    };
    let words = ["ISL: a new slave closes,", "its friction is omitted"];
    note(&mut scene, ModelKind::Isl, true, words, [232.0, 104.0]);
    let words = ["IRS coarse: the slave was closed", "already, its friction acts"];
    note(&mut scene, ModelKind::IrsCoarse, false, words, [232.0, 142.0]);
    Figure::new(
        "fig6a",
        scene,
        format!(
            "a) First problem, {}, friction logic of 1995 (FRICTION ONSET=MATFRU, penalty): no \
             friction in an increment in which a slave node closes.",
            friction(FRICTION).replace('*', "")
        ),
    )
}

/// The point at which most friction was lost; or, where nearly all of it is
/// lost, the largest that kept it whole.
fn remarkable(study: &Study, model: ModelKind, lost: bool) -> Option<[f64; 2]> {
    let matfru = study.curve(model, Stick::Penalty, Onset::Matfru)?;
    let full = study.curve(model, Stick::Penalty, Onset::Immediate)?.reactions();
    let none = study.curve(model, Stick::Frictionless, Onset::Immediate)?.reactions();
    let found = matfru.reactions();
    let weight = |k: usize| {
        let (kept, whole) = (found[k] - none[k], full[k] - none[k]);
        if lost {
            (whole - kept).abs()
        } else if kept / whole > 0.9 {
            kept.abs()
        } else {
            0.0
        }
    };
    let most = (0..found.len()).max_by(|&a, &b| weight(a).total_cmp(&weight(b)))?;
    points(Some(matfru)).get(most).copied()
}

/// With friction, called whenever a node is closed.
pub(super) fn figure_6b(study: &Study) -> Figure {
    let title = "Three models with friction, modified friction logic";
    let (scene, _) = figure_6(study, Onset::Immediate, title);
    Figure::new(
        "fig6b",
        scene,
        "b) The same with the modified logic (FRICTION ONSET=IMMEDIATE, the default): \
             friction whenever a node is closed.",
    )
}

fn figure_8(study: &Study, onset: Onset, title: &str) -> Scene {
    let mut scene = scene(HEIGHT, title);
    let chart = moment_chart();
    chart.ticks(&mut scene);
    chart.line(&mut scene, &theory(study, 2, true), DASHED);
    chart.line(&mut scene, &theory(study, 2, false), SMOOTH);
    let curve = |model, stick, onset| points(study.curve(model, stick, onset));
    let none = curve(ModelKind::Cam, Stick::Frictionless, Onset::Immediate);
    chart.series(&mut scene, &none, Marker::Plus);
    let wide = curve(ModelKind::CamWide, Stick::Penalty, onset);
    chart.series(&mut scene, &wide, Marker::Triangle);
    chart.series(&mut scene, &curve(ModelKind::Cam, Stick::Penalty, onset), Marker::Disc);
    let left = [
        line(DASHED, &format!("theory, {}", friction(FRICTION))),
        line(SMOOTH, "theory, *\u{3bc}* = 0"),
        symbol(Marker::Plus, "ISL, *\u{3bc}* = 0"),
    ];
    let right = [
        symbol(Marker::Disc, &format!("ISL, {}, slaves every 3\u{b0}", friction(FRICTION))),
        symbol(Marker::Triangle, &format!("ISL, {}, slaves every 4\u{b0}", friction(FRICTION))),
    ];
    chart.legend(&mut scene, [16.0, 16.0], &left);
    chart.legend(&mut scene, [180.0, 16.0], &right);
    scene
}

/// The second problem under the logic of 1995.
pub(super) fn figure_8a(study: &Study) -> Figure {
    let title = "Drive moment of the cam, friction logic of 1995";
    Figure::new(
        "fig8a",
        figure_8(study, Onset::Matfru, title),
        "a) Second problem, friction logic of 1995: as the cam turns, a new slave node \
                  closes in nearly every increment, and its friction is omitted.",
    )
}

/// The second problem, friction called whenever a node is closed.
pub(super) fn figure_8b(study: &Study) -> Figure {
    let title = "Drive moment of the cam, modified friction logic";
    Figure::new(
        "fig8b",
        figure_8(study, Onset::Immediate, title),
        "b) The same with the modified logic.",
    )
}

/// How far linear theory is from the exact references: not in the paper.
pub(super) fn linear_theory(study: &Study) -> Figure {
    let mut scene = scene(HEIGHT, "Linear theory against exact references");
    let title = "linear theory too high by  (% of peak)";
    let chart = frame(displacement(), Axis::fixed(title, [-0.5, 3.5], 0.5, 1));
    chart.ticks(&mut scene);
    let linear = study.references.get(ModelKind::Isl, Theory::Linear, 0.0);
    let peak = linear.iter().fold(0.0, |most: f64, value| value.abs().max(most));
    let lines = [
        (Theory::Elastica, DASHED, "large deflections"),
        (Theory::Reissner, SMOOTH, "and shear and stretching"),
        (Theory::Softened, Pen::solid(1.2).dash(Dash::Short), "and softened contact, one point"),
        (Theory::Continuum, Pen::solid(1.2).dash(Dash::Centre), "and pressure along the beam"),
    ];
    for (theory, pen, _) in lines {
        let exact = study.references.get(ModelKind::Isl, theory, 0.0);
        let off = linear.iter().zip(exact).enumerate();
        let points: Vec<[f64; 2]> = off
            .map(|(k, (a, b))| [-1.5 * (k + 1) as f64, 100.0 * (a.abs() - b.abs()) / peak])
            .collect();
        chart.line(&mut scene, &points, pen);
    }
    let entries: Vec<Entry> = lines.iter().map(|(_, pen, words)| line(*pen, words)).collect();
    chart.legend(&mut scene, [16.0, 20.0], &entries);
    Figure::new(
        "linear_theory",
        scene,
        "Error of the linear theory of the first problem, without friction, against more \
                  and more complete references.",
    )
}
