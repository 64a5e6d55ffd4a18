//! Curves in a frame, and their difference in a second one below.

use super::curve::{Curve, Question, difference};
use super::drawing::{Anchor, CURVES, Drawing, INK, Item, LIGHT};
use crate::number::general;

/// A finished figure.
#[derive(Clone, Debug)]
pub struct Figure {
    pub(super) drawing: Drawing,
}

impl Figure {
    /// As SVG.
    pub fn svg(&self) -> String {
        super::svg::svg(&self.drawing)
    }

    /// As PNG, 192 dots an inch; `None` if it cannot be encoded. Letters that
    /// the built-in font lacks are shown as question marks.
    pub fn png(&self) -> Option<Vec<u8>> {
        super::png::png(&self.drawing)
    }
}

/// A frame on the paper with the values at its edges.
struct Frame {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
    x: [f64; 2],
    y: [f64; 2],
}

/// Draws a curve, or two over each other with the difference below.
pub fn figure(question: &Question, one: &Curve, other: Option<&Curve>) -> Figure {
    let title = match other {
        Some(other) => {
            format!("{} against {}: {} and {}", question.y, question.x, one.name, other.name)
        }
        None => format!("{} against {}: {}", question.y, question.x, one.name),
    };
    let height = if other.is_some() { 680.0 } else { 460.0 };
    let mut drawing = Drawing { width: 720.0, height, title, items: Vec::new() };
    let mut shown = vec![(&one.x[..], &one.y[..])];
    shown.extend(other.map(|other| (&other.x[..], &other.y[..])));
    let upper = Frame::around(&shown, 50.0, 350.0);
    upper.draw(&mut drawing, &question.y);
    for (place, (x, y)) in shown.iter().enumerate().rev() {
        upper.curve(&mut drawing, x, y, place);
    }
    let names = std::iter::once(&one.name).chain(other.map(|other| &other.name));
    for (place, name) in names.enumerate() {
        let y = 22.0 + 16.0 * place as f64;
        drawing.line(vec![[90.0, y - 4.0], [118.0, y - 4.0]], 2.0, CURVES[place]);
        drawing.words([126.0, y], name.as_str(), Anchor::Start);
    }
    let mut lowest = upper;
    if let Some(other) = other {
        let values = difference(one, other);
        lowest = Frame::around(&[(&one.x, &values)], 440.0, 170.0);
        lowest.draw(&mut drawing, "difference");
        lowest.curve(&mut drawing, &one.x, &values, 2);
    }
    let middle = lowest.left + 0.5 * lowest.width;
    let below = lowest.top + lowest.height + 40.0;
    drawing.words([middle, below], question.x.as_str(), Anchor::Middle);
    Figure { drawing }
}

impl Frame {
    fn around(curves: &[(&[f64], &[f64])], top: f64, height: f64) -> Self {
        let points = || curves.iter().flat_map(|(x, y)| x.iter().zip(*y));
        let seen = || points().filter(|(x, y)| x.is_finite() && y.is_finite());
        let x = padded(seen().map(|(x, _)| *x));
        let y = padded(seen().map(|(_, y)| *y));
        Self { left: 90.0, top, width: 600.0, height, x, y }
    }

    fn at(&self, x: f64, y: f64) -> [f64; 2] {
        let part = |value: f64, [low, high]: [f64; 2]| (value - low) / (high - low);
        [self.left + self.width * part(x, self.x), self.top + self.height * (1.0 - part(y, self.y))]
    }

    fn draw(&self, drawing: &mut Drawing, title: &str) {
        let (right, bottom) = (self.left + self.width, self.top + self.height);
        for value in ticks(self.x, 7.0) {
            let [x, _] = self.at(value, self.y[0]);
            drawing.line(vec![[x, self.top], [x, bottom]], 1.0, LIGHT);
            drawing.words([x, bottom + 18.0], number(value), Anchor::Middle);
        }
        for value in ticks(self.y, if self.height > 200.0 { 7.0 } else { 4.0 }) {
            let [_, y] = self.at(self.x[0], value);
            drawing.line(vec![[self.left, y], [right, y]], 1.0, LIGHT);
            drawing.words([self.left - 7.0, y + 4.5], number(value), Anchor::End);
        }
        let corners = [
            [self.left, self.top],
            [right, self.top],
            [right, bottom],
            [self.left, bottom],
            [self.left, self.top],
        ];
        drawing.line(corners.to_vec(), 1.0, INK);
        drawing.items.push(Item::Words {
            at: [22.0, self.top + 0.5 * self.height],
            text: title.to_owned(),
            anchor: Anchor::Middle,
            upwards: true,
            bold: false,
        });
    }

    /// A gap in the numbers is a gap in the line.
    fn curve(&self, drawing: &mut Drawing, x: &[f64], y: &[f64], place: usize) {
        let colour = CURVES[place];
        let dashed = place == 1;
        let points: Vec<Option<[f64; 2]>> = x
            .iter()
            .zip(y)
            .map(|(x, y)| (x.is_finite() && y.is_finite()).then(|| self.at(*x, *y)))
            .collect();
        for part in points.split(Option::is_none) {
            let points: Vec<[f64; 2]> = part.iter().flatten().copied().collect();
            if points.len() <= 120 {
                let discs = points.iter().map(|at| Item::Disc { at: *at, radius: 2.4, colour });
                drawing.items.extend(discs);
            }
            drawing.items.push(Item::Line { points, width: 1.8, colour, dashed });
        }
    }
}

fn padded(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let (low, high) =
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    if low > high {
        return [0.0, 1.0];
    }
    let pad = if high > low { 0.04 * (high - low) } else { (0.1 * high.abs()).max(1e-12) };
    [low - pad, high + pad]
}

/// Round numbers between the ends.
fn ticks([low, high]: [f64; 2], count: f64) -> Vec<f64> {
    let raw = (high - low) / count;
    let power = 10_f64.powf(raw.log10().floor());
    let lead = raw / power;
    let step = power * [1.0, 2.0, 5.0].into_iter().find(|s| lead <= *s).unwrap_or(10.0);
    let first = (low / step).ceil() as i64;
    (0..30).map(|k| (first + k) as f64 * step).take_while(|value| *value <= high).collect()
}

fn number(value: f64) -> String {
    general(value, 6).replace('-', "\u{2212}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        let found = ticks([-0.0312, 0.0012], 7.0);
        let expected = [-0.03, -0.025, -0.02, -0.015, -0.01, -0.005, 0.0];
        assert_eq!(found.len(), expected.len(), "{found:?}");
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
    }

    #[test]
    fn figures_escape_names_and_survive_curves_without_extent() {
        let question = Question { x: "U2".into(), y: "RF2".into(), node: None, unfinished: false };
        let name = "</title><script>\u{44f}".to_owned();
        let flat = Curve { name, times: vec![0.0, 1.0], x: vec![0.0; 2], y: vec![f64::NAN, 0.0] };
        let figure = figure(&question, &flat, Some(&flat));
        let svg = figure.svg();
        assert!(!svg.contains("<script>") && svg.contains("&lt;script&gt;\u{44f}"), "{svg}");
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        let png = figure.png().unwrap();
        assert_eq!(&png[1..4], b"PNG");
    }
}
