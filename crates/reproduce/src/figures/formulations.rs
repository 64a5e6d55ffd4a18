//! The three ways of sampling contact on the same 24 beams: how far each is
//! from theory, increment by increment. Not in the paper.

use super::{Figure, WIDTH};
use crate::draw::{Anchor, Axis, Chart, Dash, GREY, Pen, Rectangle, SMALL, Scene, Text, scene};
use crate::fine::{Errors, FINE};
use crate::study::{FRICTION, ModelKind, Study};

/// Model, its line, its words.
const LINES: [(ModelKind, Pen, &str); 3] = [
    (ModelKind::IrsCoarse, Pen::solid(1.0).colour(GREY), "IRS"),
    (ModelKind::Isl, Pen::solid(1.0).dash(Dash::Short), "ISL"),
    (ModelKind::Integrated, Pen::solid(1.6), "integrated"),
];

/// The scale of a panel.
struct Range {
    /// Largest error [% of the peak].
    most: f64,
    /// Distance of ticks.
    step: f64,
    /// Decimals of the numbers.
    decimals: usize,
}

fn chart(frame: Rectangle, range: &Range, [x, y]: [&str; 2]) -> Chart {
    let x = Axis { title: x.to_owned(), from: 0.0, to: -31.5, step: 10.0, decimals: 0 };
    let y = Axis {
        title: y.to_owned(),
        from: -range.most,
        to: range.most,
        step: range.step,
        decimals: range.decimals,
    };
    Chart { frame, x, y }
}

fn of(study: &Study, friction: f64) -> impl Iterator<Item = &Errors> {
    study.fine.iter().filter(move |errors| errors.friction == friction)
}

/// The errors of the three, without and with friction; below, the same with
/// the scale of the two smooth ones.
pub(super) fn figure(study: &Study) -> Figure {
    let title = "Errors of the force of three formulations on the same mesh";
    let mut scene = scene(WIDTH, 330.0, title);
    // without friction the peak is smaller, and errors in percent of it larger
    let columns =
        [(0.0, 50.0, 60.0, "error of  *F*_{y}  (% of peak)"), (FRICTION, 276.0, 30.0, "")];
    for (friction, left, most, y) in columns {
        let words = Text::new([left + 84.0, 14.0], format!("*\u{3bc}* = {friction}"));
        scene.text(words.anchor(Anchor::Middle));
        let whole = Range { most, step: 0.5 * most, decimals: 0 };
        let near = Range { most: 1.0, step: 0.5, decimals: 1 };
        let x = "displacement  *\u{3b4}y*  (mm)";
        for (top, range, x) in [(22.0, whole, ""), (166.0, near, x)] {
            let frame = Rectangle { left, top, width: 168.0, height: 116.0 };
            let chart = chart(frame, &range, [x, y]);
            chart.draw(&mut scene);
            draw(&mut scene, &chart, study, friction);
        }
    }
    legend(&mut scene);
    Figure {
        name: "formulations",
        scene,
        caption: format!(
            "Error of the vertical force of the first problem in {FINE} equal increments, 24 \
             beams in every model, against the shear-flexible beam with pressure spread along \
             it. Below: the same curves, their scale enlarged; the coarse IRS model leaves it."
        ),
    }
}

fn draw(scene: &mut Scene, chart: &Chart, study: &Study, friction: f64) {
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
