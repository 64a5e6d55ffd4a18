//! Charts: axes with ticks, lines, symbols, legends.

use super::view::Rectangle;
use super::{Anchor, Dash, Pen, Scene, Text};
use super::{BLACK, LIGHT, SMALL, WHITE};

/// An axis; `from` stands at the left or lower end, whichever number is larger.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    /// What is plotted, with its unit.
    pub title: String,
    /// Value at the left or lower end.
    pub from: f64,
    /// Value at the right or upper end.
    pub to: f64,
    /// Distance of ticks, positive.
    pub step: f64,
    /// Decimals of the numbers.
    pub decimals: usize,
}

impl Axis {
    /// Place of a value, 0 at the lower end, 1 at the upper.
    fn place(&self, value: f64) -> f64 {
        (value - self.from) / (self.to - self.from)
    }

    fn ticks(&self) -> Vec<f64> {
        let count = ((self.to - self.from).abs() / self.step + 1e-9).floor() as i32;
        let sign = (self.to - self.from).signum();
        (0..=count).map(|i| self.from + sign * self.step * f64::from(i)).collect()
    }

    fn number(&self, value: f64) -> String {
        // the tick next to zero may carry a rounding error
        let value = if value.abs() < 1e-9 * self.step { 0.0 } else { value };
        format!("{value:.*}", self.decimals).replace('-', "\u{2212}")
    }
}

/// A symbol at a computed point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Marker {
    /// Black disc.
    Disc,
    /// Open square.
    Square,
    /// Open triangle.
    Triangle,
    /// Upright cross.
    Plus,
    /// Slanted cross.
    Cross,
}

impl Marker {
    /// Draws it.
    pub fn draw(self, scene: &mut Scene, [x, y]: [f64; 2]) {
        let r = 2.7;
        let pen = Pen::solid(0.9);
        let around = |points: &[[f64; 2]]| -> Vec<[f64; 2]> {
            points.iter().map(|[dx, dy]| [x + r * dx, y + r * dy]).collect()
        };
        match self {
            Self::Disc => scene.circle([x, y], 0.8 * r, Some(BLACK), Some(pen)),
            Self::Square => {
                let corners = around(&[[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]]);
                scene.polygon(corners, Some(WHITE), Some(pen));
            }
            Self::Triangle => {
                let corners = around(&[[0.0, -1.2], [1.1, 0.8], [-1.1, 0.8]]);
                scene.polygon(corners, Some(WHITE), Some(pen));
            }
            Self::Plus => {
                scene.line(around(&[[-1.2, 0.0], [1.2, 0.0]]), pen);
                scene.line(around(&[[0.0, -1.2], [0.0, 1.2]]), pen);
            }
            Self::Cross => {
                scene.line(around(&[[-0.9, -0.9], [0.9, 0.9]]), pen);
                scene.line(around(&[[-0.9, 0.9], [0.9, -0.9]]), pen);
            }
        }
    }
}

/// A line of the legend: how it is drawn, and what it is.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    /// Line, where there is one.
    pub pen: Option<Pen>,
    /// Symbol, where there is one.
    pub marker: Option<Marker>,
    /// What it is.
    pub words: String,
}

/// A frame with two axes.
#[derive(Clone, Debug)]
pub(crate) struct Chart {
    /// The frame on the paper.
    pub frame: Rectangle,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
}

impl Chart {
    /// Where a point of the chart lies on the paper.
    pub fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let frame = &self.frame;
        [
            frame.left + frame.width * self.x.place(x),
            frame.top + frame.height * (1.0 - self.y.place(y)),
        ]
    }

    /// Frame, ticks, numbers, titles; a grey line at zero where it crosses.
    pub fn draw(&self, scene: &mut Scene) {
        let f = self.frame;
        let bottom = f.top + f.height;
        let pen = Pen::solid(0.8);
        let zero = self.y.place(0.0);
        if zero > 1e-9 && zero < 1.0 - 1e-9 {
            let [_, y] = self.at([self.x.from, 0.0]);
            scene.line(vec![[f.left, y], [f.left + f.width, y]], Pen::solid(0.7).colour(LIGHT));
        }
        for value in self.x.ticks() {
            let [x, _] = self.at([value, self.y.from]);
            scene.line(vec![[x, bottom], [x, bottom - 4.0]], pen);
            scene.line(vec![[x, f.top], [x, f.top + 4.0]], pen);
            let number = Text::new([x, bottom + 12.0], self.x.number(value));
            scene.text(number.size(SMALL).anchor(Anchor::Middle));
        }
        for value in self.y.ticks() {
            let [_, y] = self.at([self.x.from, value]);
            scene.line(vec![[f.left, y], [f.left + 4.0, y]], pen);
            scene.line(vec![[f.left + f.width, y], [f.left + f.width - 4.0, y]], pen);
            let number = Text::new([f.left - 5.0, y + 3.2], self.y.number(value));
            scene.text(number.size(SMALL).anchor(Anchor::End));
        }
        scene.polygon(f.corners(), None, Some(pen));
        let middle = [f.left + 0.5 * f.width, f.top + 0.5 * f.height];
        scene.text(
            Text::new([middle[0], bottom + 27.0], self.x.title.clone()).anchor(Anchor::Middle),
        );
        let title = Text::new([f.left - 38.0, middle[1]], self.y.title.clone());
        scene.text(title.anchor(Anchor::Middle).upwards());
    }

    /// A line through points of the chart.
    pub fn line(&self, scene: &mut Scene, points: &[[f64; 2]], pen: Pen) {
        let placed: Vec<[f64; 2]> = points.iter().map(|&p| self.at(p)).collect();
        for part in self.frame.parts(&placed) {
            scene.line(part, pen);
        }
    }

    /// A symbol at each point of the chart.
    pub fn markers(&self, scene: &mut Scene, points: &[[f64; 2]], marker: Marker) {
        for &point in points {
            let place = self.at(point);
            if self.frame.contains(place) {
                marker.draw(scene, place);
            }
        }
    }

    /// A thin line through the symbols and the symbols themselves.
    pub fn series(&self, scene: &mut Scene, points: &[[f64; 2]], marker: Marker) {
        self.line(scene, points, Pen::solid(0.6).dash(Dash::None).colour(super::GREY));
        self.markers(scene, points, marker);
    }

    /// The legend, its upper left corner `[right, down]` of the frame's.
    pub fn legend(&self, scene: &mut Scene, [right, down]: [f64; 2], entries: &[Entry]) {
        let left = self.frame.left + right;
        for (place, entry) in entries.iter().enumerate() {
            let y = self.frame.top + down + 14.0 * place as f64;
            if let Some(pen) = entry.pen {
                scene.line(vec![[left, y], [left + 26.0, y]], pen);
            }
            if let Some(marker) = entry.marker {
                marker.draw(scene, [left + 13.0, y]);
            }
            scene.text(Text::new([left + 33.0, y + 3.3], entry.words.clone()).size(SMALL));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_run_from_one_end_to_the_other_either_way() {
        let axis = |from, to| Axis { title: String::new(), from, to, step: 10.0, decimals: 0 };
        assert_eq!(axis(0.0, -30.0).ticks(), [0.0, -10.0, -20.0, -30.0]);
        assert_eq!(axis(-30.0, 5.0).ticks(), [-30.0, -20.0, -10.0, 0.0]);
        assert_eq!(axis(0.0, 1.0).number(-10.0), "\u{2212}10");
        assert_eq!(axis(0.0, -30.0).place(-15.0), 0.5);
    }
}
