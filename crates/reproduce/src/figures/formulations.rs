//! The three ways of sampling contact on the same 24 beams: how far each is
//! from theory, increment by increment. Not in the paper.

use super::figure::{Figure, scene};
use crate::cases::{FINE, FRICTION, ModelKind};
use crate::fine::Errors;
use crate::study::Study;
use slideline_figures::{Anchor, Axis, Dash, Frame, GREY, Pen, Rectangle, SMALL, Scene, Text};

/// Model, its line, its words.
const LINES: [(ModelKind, Pen, &str); 3] = [
    (ModelKind::IrsCoarse, Pen::solid(1.0).colour(GREY), "IRS"),
    (ModelKind::Isl, Pen::solid(1.0).dash(Dash::Short), "ISL"),
    (ModelKind::Integrated, Pen::solid(1.6), "integrated"),
];

/// A panel up to errors of `most` [% of the peak], with ticks `step` apart.
fn chart(window: Rectangle, [most, step]: [f64; 2], decimals: usize, [x, y]: [&str; 2]) -> Frame {
    let x = Axis::fixed(x, [0.0, -31.5], 10.0, 0);
    Frame::new(window, [x, Axis::fixed(y, [-most, most], step, decimals)], std::iter::empty())
}

fn of(study: &Study, friction: f64) -> impl Iterator<Item = &Errors> {
    study.fine.iter().filter(move |errors| errors.friction == friction)
}

/// The errors of the three, without and with friction; below, the same with
/// the scale of the two smooth ones.
pub(super) fn figure(study: &Study) -> Figure {
    let title = "Errors of the force of three formulations on the same mesh";
    let mut scene = scene(330.0, title);
    // without friction the peak is smaller, and errors in percent of it larger
    let columns =
        [(0.0, 50.0, 60.0, "error of  *F*_{y}  (% of peak)"), (FRICTION, 276.0, 30.0, "")];
    for (friction, left, most, y) in columns {
        let words = Text::new([left + 84.0, 14.0], format!("*\u{3bc}* = {friction}"));
        scene.text(words.anchor(Anchor::Middle));
        let x = "displacement  *\u{3b4}y*  (mm)";
        let (whole, near) = ([most, 0.5 * most], [1.0, 0.5]);
        for (top, range, decimals, x) in [(22.0, whole, 0, ""), (166.0, near, 1, x)] {
            let window = Rectangle { left, top, width: 168.0, height: 116.0 };
            let chart = chart(window, range, decimals, [x, y]);
            chart.ticks(&mut scene);
            draw(&mut scene, &chart, study, friction);
        }
    }
    legend(&mut scene);
    Figure::new(
        "formulations",
        scene,
        format!(
            "Error of the vertical force of the first problem in {FINE} equal increments, 24 \
             beams in every model, against the shear-flexible beam with pressure spread along \
             it. Below: the same curves, their scale enlarged; the coarse IRS model leaves it."
        ),
    )
}

fn draw(scene: &mut Scene, chart: &Frame, study: &Study, friction: f64) {
    for (model, pen, _) in LINES {
        for errors in of(study, friction).filter(|errors| errors.model == model) {
            let points = errors.motions.iter().zip(&errors.errors);
            let points: Vec<[f64; 2]> = points.map(|(x, y)| [1e3 * x, *y]).collect();
            chart.line(scene, &points, pen);
        }
    }
}

fn legend(scene: &mut Scene) {
    for (place, (_, pen, words)) in LINES.into_iter().enumerate() {
        let [left, y] = [130.0 + 84.0 * place as f64, 322.0];
        scene.line(vec![[left, y - 3.3], [left + 26.0, y - 3.3]], pen);
        scene.text(Text::new([left + 33.0, y], words).size(SMALL));
    }
}
