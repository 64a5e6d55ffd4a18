//! A frame with two axes: ticks or a grid, lines, symbols, a legend.

use crate::axis::{Axis, Scale};
use crate::colour::{BLACK, GREY, GRID, INK, LIGHT, WHITE};
use crate::scene::{Anchor, Pen, Scene, Text};
use crate::view::Rectangle;

/// Size of letters along axes and in legends on paper [point].
pub const SMALL: f64 = 9.0;
/// Size of letters of plots on a screen [dot].
pub(crate) const LETTERS: f64 = 13.0;

/// A symbol at a computed point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marker {
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
pub struct Entry {
    /// Line, where there is one.
    pub pen: Option<Pen>,
    /// Symbol, where there is one.
    pub marker: Option<Marker>,
    /// What it is.
    pub words: String,
}

/// A frame with two axes.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Where it stands on the paper.
    pub window: Rectangle,
    axes: [Axis; 2],
    scales: [Scale; 2],
}

impl Frame {
    /// A frame in a window of the paper, around points where an axis is not
    /// fixed.
    pub fn new<'a>(
        window: Rectangle,
        axes: [Axis; 2],
        points: impl Iterator<Item = &'a [f64; 2]> + Clone,
    ) -> Self {
        let [x, y] = &axes;
        let seen = points.filter(|point| x.shows(point[0]) && y.shows(point[1]));
        let scales =
            [x.around(seen.clone().map(|point| point[0])), y.around(seen.map(|point| point[1]))];
        Self { window, axes, scales }
    }

    /// Where a point lies on the paper.
    pub fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let Rectangle { left, top, width, height } = self.window;
        let [along, up] = &self.scales;
        [left + width * along.place(x), top + height * (1.0 - up.place(y))]
    }

    /// The same; `None` for a point that has no place.
    pub(crate) fn placed(&self, point: [f64; 2]) -> Option<[f64; 2]> {
        let [x, y] = &self.axes;
        (x.shows(point[0]) && y.shows(point[1])).then(|| self.at(point))
    }

    /// The frame as plots on a screen have it: a grid, numbers, the title of the
    /// vertical axis.
    pub(crate) fn grid(&self, scene: &mut Scene) {
        let Rectangle { left, top, width, height } = self.window;
        let (right, bottom, pen) = (left + width, top + height, Pen::solid(1.0).colour(GRID));
        let words = |at, words: &str| Text::new(at, words).size(LETTERS).plain();
        for (value, number) in self.scales[0].ticks(7.0) {
            let x = left + width * self.scales[0].place(value);
            scene.line(vec![[x, top], [x, bottom]], pen);
            scene.text(words([x, bottom + 18.0], &number).anchor(Anchor::Middle));
        }
        for (value, number) in self.scales[1].ticks(if height > 200.0 { 7.0 } else { 4.0 }) {
            let y = top + height * (1.0 - self.scales[1].place(value));
            scene.line(vec![[left, y], [right, y]], pen);
            scene.text(words([left - 7.0, y + 4.5], &number).anchor(Anchor::End));
        }
        scene.polygon(self.window.corners(), None, Some(Pen::solid(1.0).colour(INK)));
        let title = words([22.0, top + 0.5 * height], &self.axes[1].title);
        scene.text(title.anchor(Anchor::Middle).upwards());
    }

    /// The frame as drawings on paper have it: ticks, numbers, titles; a grey
    /// line at zero where it crosses.
    pub fn ticks(&self, scene: &mut Scene) {
        let Rectangle { left, top, width, height } = self.window;
        let (right, bottom, pen) = (left + width, top + height, Pen::solid(0.8));
        let zero = self.scales[1].place(0.0);
        if zero > 1e-9 && zero < 1.0 - 1e-9 {
            let y = top + height * (1.0 - zero);
            scene.line(vec![[left, y], [right, y]], Pen::solid(0.7).colour(LIGHT));
        }
        for (value, number) in self.scales[0].ticks(7.0) {
            let x = left + width * self.scales[0].place(value);
            scene.line(vec![[x, bottom], [x, bottom - 4.0]], pen);
            scene.line(vec![[x, top], [x, top + 4.0]], pen);
            let number = Text::new([x, bottom + 12.0], number).size(SMALL);
            scene.text(number.anchor(Anchor::Middle));
        }
        for (value, number) in self.scales[1].ticks(7.0) {
            let y = top + height * (1.0 - self.scales[1].place(value));
            scene.line(vec![[left, y], [left + 4.0, y]], pen);
            scene.line(vec![[right, y], [right - 4.0, y]], pen);
            scene.text(Text::new([left - 5.0, y + 3.2], number).size(SMALL).anchor(Anchor::End));
        }
        scene.polygon(self.window.corners(), None, Some(pen));
        let [x, y] = &self.axes;
        let below = Text::new([left + 0.5 * width, bottom + 27.0], &x.title);
        scene.text(below.anchor(Anchor::Middle));
        let beside = Text::new([left - 38.0, top + 0.5 * height], &y.title);
        scene.text(beside.anchor(Anchor::Middle).upwards());
    }

    /// A line through points, where it lies in the frame; one that has no place
    /// is a gap.
    pub fn line(&self, scene: &mut Scene, points: &[[f64; 2]], pen: Pen) {
        let placed: Vec<Option<[f64; 2]>> = points.iter().map(|&p| self.placed(p)).collect();
        for part in placed.split(Option::is_none) {
            let part: Vec<[f64; 2]> = part.iter().flatten().copied().collect();
            for part in self.window.parts(&part) {
                scene.line(part, pen);
            }
        }
    }

    /// A thin line through symbols, and a symbol at each point in the frame.
    pub fn series(&self, scene: &mut Scene, points: &[[f64; 2]], marker: Marker) {
        self.line(scene, points, Pen::solid(0.6).colour(GREY));
        let placed = points.iter().filter_map(|&point| self.placed(point));
        for place in placed.filter(|place| self.window.contains(*place)) {
            marker.draw(scene, place);
        }
    }

    /// The legend, its upper left corner `[right, down]` of the frame's.
    pub fn legend(&self, scene: &mut Scene, [right, down]: [f64; 2], entries: &[Entry]) {
        let left = self.window.left + right;
        for (place, entry) in entries.iter().enumerate() {
            let y = self.window.top + down + 14.0 * place as f64;
            if let Some(pen) = entry.pen {
                scene.line(vec![[left, y], [left + 26.0, y]], pen);
            }
            if let Some(marker) = entry.marker {
                marker.draw(scene, [left + 13.0, y]);
            }
            scene.text(Text::new([left + 33.0, y + 3.3], &entry.words).size(SMALL));
        }
    }
}
