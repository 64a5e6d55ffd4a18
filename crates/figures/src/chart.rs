//! Curves in frames that stand below one another.

use crate::axis::Axis;
use crate::colour::{CURVES, Colour};
use crate::frame::{Frame, LETTERS};
use crate::scene::{Anchor, Dash, Pen, Scene, Text, Unit};
use crate::view::Rectangle;

/// How points are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A line, with a disc at each point where there are not too many.
    Curve,
    /// The same, dashed.
    Dashed,
    /// A dashed line alone.
    Guide,
    /// Discs alone.
    Discs,
}

/// Points that belong together. A point that has no place, such as one that
/// is not a number, is a gap in the line.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// What the legend calls it; without a name it is not in the legend.
    pub name: String,
    /// Abscissa and ordinate of each point.
    pub points: Vec<[f64; 2]>,
    /// How they are shown.
    pub mark: Mark,
    /// Which of the colours of curves they have, from 0; series of one colour
    /// belong together.
    pub colour: usize,
}

/// A frame with its curves.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Height of the frame, in dots of 1/96 inch.
    pub height: f64,
    /// What is drawn in it.
    pub series: Vec<Series>,
}

const LEFT: f64 = 90.0;
const WIDTH: f64 = 600.0;
const LINE: f64 = 16.0;

/// Draws panels below one another, the legend of all above. In a frame the
/// first series stands above the others, guides above all.
pub fn chart(title: impl Into<String>, panels: &[Panel]) -> Scene {
    let series = panels.iter().flat_map(|panel| &panel.series);
    let named: Vec<&Series> = series.filter(|series| !series.name.is_empty()).collect();
    let mut scene = Scene::new(Unit::Pixel, [LEFT + WIDTH + 30.0, 0.0], &title.into());
    for (line, series) in named.iter().enumerate() {
        legend(&mut scene, series, 22.0 + LINE * line as f64);
    }
    let mut top = 18.0 + LINE * named.len().max(1) as f64;
    for (place, panel) in panels.iter().enumerate() {
        let window = Rectangle { left: LEFT, top, width: WIDTH, height: panel.height };
        let points = panel.series.iter().flat_map(|series| &series.points);
        let frame = Frame::new(window, [panel.x.clone(), panel.y.clone()], points);
        frame.grid(&mut scene);
        let (guides, others): (Vec<&Series>, Vec<&Series>) =
            panel.series.iter().partition(|series| series.mark == Mark::Guide);
        for series in others.iter().rev().chain(&guides) {
            draw(&frame, &mut scene, series);
        }
        let bottom = top + panel.height;
        let shared = panels.get(place + 1).is_some_and(|next| next.x.title == panel.x.title);
        if !shared {
            let middle = [LEFT + 0.5 * WIDTH, bottom + 40.0];
            scene.text(words(middle, &panel.x.title).anchor(Anchor::Middle));
        }
        top = bottom + if shared { 40.0 } else { 60.0 };
    }
    scene.height = top;
    scene
}

fn pen(series: &Series, width: f64) -> Pen {
    let dashed = matches!(series.mark, Mark::Dashed | Mark::Guide);
    let dash = if dashed { Dash::Long } else { Dash::None };
    Pen::solid(width).colour(colour(series)).dash(dash)
}

fn colour(series: &Series) -> Colour {
    CURVES[series.colour % CURVES.len()]
}

/// Words of the size of plots, every sign standing for itself.
fn words(at: [f64; 2], content: &str) -> Text {
    Text::new(at, content).size(LETTERS).plain()
}

fn legend(scene: &mut Scene, series: &Series, y: f64) {
    let (from, to) = ([LEFT, y - 4.0], [LEFT + 28.0, y - 4.0]);
    if series.mark == Mark::Discs {
        let at = [LEFT + 14.0, y - 4.0];
        scene.circle(at, 3.2, Some(colour(series)), None);
    } else {
        scene.line(vec![from, to], pen(series, 2.0));
    }
    scene.text(words([LEFT + 36.0, y], &series.name));
}

fn draw(frame: &Frame, scene: &mut Scene, series: &Series) {
    let colour = colour(series);
    let discs = match series.mark {
        Mark::Curve | Mark::Dashed => (series.points.len() <= 120).then_some(2.4),
        Mark::Guide => None,
        Mark::Discs => Some(3.2),
    };
    if let Some(radius) = discs {
        let placed = series.points.iter().filter_map(|&point| frame.placed(point));
        placed.for_each(|at| scene.circle(at, radius, Some(colour), None));
    }
    if series.mark != Mark::Discs {
        let width = if series.mark == Mark::Guide { 1.2 } else { 1.8 };
        frame.line(scene, &series.points, pen(series, width));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: points without a place are left out, and nothing that is
    /// not a number reaches the paper.
    #[test]
    fn logarithms_are_drawn_of_what_has_one() {
        let points = vec![[12.0, 1e-3], [24.0, 0.0], [48.0, f64::NAN], [96.0, 1e-5]];
        let series = [Mark::Curve, Mark::Dashed, Mark::Guide, Mark::Discs].map(|mark| Series {
            name: "error".into(),
            points: points.clone(),
            mark,
            colour: 7,
        });
        let panel = Panel {
            x: Axis::logarithmic("elements"),
            y: Axis::logarithmic("error"),
            height: 300.0,
            series: series.to_vec(),
        };
        let svg = chart("order", &[panel.clone(), panel]).svg();
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        assert_eq!(svg.matches(">error</text>").count(), 8 + 2, "legend and axes");
    }
}
