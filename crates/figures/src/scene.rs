//! What a figure consists of.

use crate::colour::{BLACK, Colour};
use crate::font;

/// What lengths of a figure are counted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// 1/72 inch.
    Point,
    /// 1/96 inch.
    Pixel,
}

impl Unit {
    /// How many there are to an inch.
    pub fn per_inch(self) -> f64 {
        match self {
            Self::Point => 72.0,
            Self::Pixel => 96.0,
        }
    }
}

/// A figure, y down.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Of all its lengths.
    pub unit: Unit,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
    /// What it shows, for those who cannot see it.
    pub title: String,
    /// In drawing order.
    pub items: Vec<Item>,
}

/// One thing drawn.
#[derive(Clone, Debug)]
pub enum Item {
    /// Straight pieces through points, open or closed.
    Path {
        /// The points.
        points: Vec<[f64; 2]>,
        /// Whether the last is joined with the first.
        closed: bool,
        /// What it is filled with.
        fill: Option<Colour>,
        /// How its line is drawn.
        pen: Option<Pen>,
    },
    /// A circle.
    Circle {
        /// Its centre.
        centre: [f64; 2],
        /// Its radius.
        radius: f64,
        /// What it is filled with.
        fill: Option<Colour>,
        /// How its line is drawn.
        pen: Option<Pen>,
    },
    /// Words.
    Text(Text),
}

impl Item {
    /// The same further down.
    fn lowered(mut self, by: f64) -> Self {
        match &mut self {
            Self::Path { points, .. } => points.iter_mut().for_each(|point| point[1] += by),
            Self::Circle { centre, .. } => centre[1] += by,
            Self::Text(text) => text.at[1] += by,
        }
        self
    }
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Pen {
    /// Width.
    pub width: f64,
    /// Colour.
    pub colour: Colour,
    /// Pattern.
    pub dash: Dash,
}

impl Pen {
    /// A black line.
    pub const fn solid(width: f64) -> Self {
        Self { width, colour: BLACK, dash: Dash::None }
    }
    /// The same in a colour.
    pub const fn colour(self, colour: Colour) -> Self {
        Self { colour, ..self }
    }
    /// The same in a pattern.
    pub const fn dash(self, dash: Dash) -> Self {
        Self { dash, ..self }
    }
}

/// Pattern of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dash {
    /// Unbroken.
    None,
    /// Long pieces.
    Long,
    /// Short pieces.
    Short,
    /// Long and short in turn: centre lines.
    Centre,
}

impl Dash {
    /// Lengths of piece and gap in turn [point]; empty where unbroken.
    pub fn lengths(self) -> &'static [f32] {
        match self {
            Self::None => &[],
            Self::Long => &[6.0, 3.0],
            Self::Short => &[2.0, 2.0],
            Self::Centre => &[8.0, 2.5, 1.5, 2.5],
        }
    }
}

/// Which point of a text is placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// Its left end.
    Start,
    /// Its middle.
    Middle,
    /// Its right end.
    End,
}

/// Size of letters unless said.
const LETTERS: f64 = 10.0;

/// A line of words. In the content `*` switches oblique letters on and off,
/// and `_{...}` is an index, unless it is plain.
#[derive(Clone, Debug)]
pub struct Text {
    /// The anchor, on the base line.
    pub at: [f64; 2],
    /// What is written.
    pub content: String,
    /// Size of the letters.
    pub size: f64,
    /// Which point of it stands at `at`.
    pub anchor: Anchor,
    /// Whether it reads upwards.
    pub upwards: bool,
    /// Bold letters.
    pub bold: bool,
    /// Whether every sign stands for itself: names of people's own. Viewers
    /// set such words with whatever letters they have.
    pub plain: bool,
}

impl Text {
    /// Words of normal size that begin at a point.
    pub fn new(at: [f64; 2], content: impl Into<String>) -> Self {
        Self {
            at,
            content: content.into(),
            size: LETTERS,
            anchor: Anchor::Start,
            upwards: false,
            bold: false,
            plain: false,
        }
    }
    /// The same, every sign standing for itself.
    pub fn plain(self) -> Self {
        Self { plain: true, ..self }
    }
    /// The same, anchored otherwise.
    pub fn anchor(self, anchor: Anchor) -> Self {
        Self { anchor, ..self }
    }
    /// The same in another size.
    pub fn size(self, size: f64) -> Self {
        Self { size, ..self }
    }
    /// The same in bold letters.
    pub fn bold(self) -> Self {
        Self { bold: true, ..self }
    }
    /// The same, read upwards.
    pub fn upwards(self) -> Self {
        Self { upwards: true, ..self }
    }

    /// Its pieces from left to right, placed as if it read to the right.
    pub(crate) fn runs(&self) -> Vec<Run> {
        let mut runs = if self.plain {
            vec![Run::new(&self.content, self.size, self.bold, false)]
        } else {
            split(&self.content, self.size, self.bold)
        };
        let total: f64 = runs.iter().map(|run| run.width).sum();
        let mut x = match self.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => -0.5 * total,
            Anchor::End => -total,
        };
        for run in &mut runs {
            run.offset[0] = x;
            x += run.width;
        }
        runs
    }
}

/// Letters of one face and size.
#[derive(Clone, Debug)]
pub(crate) struct Run {
    /// From the anchor, before turning.
    pub offset: [f64; 2],
    /// Letters.
    pub letters: String,
    /// Their size.
    pub size: f64,
    /// Their face.
    pub face: font::Face,
    /// Their width.
    pub width: f64,
}

impl Run {
    fn new(letters: &str, size: f64, bold: bool, oblique: bool) -> Self {
        let face = match (bold, oblique) {
            (true, _) => font::Face::Bold,
            (false, true) => font::Face::Oblique,
            (false, false) => font::Face::Regular,
        };
        let width = font::width(face, letters, size);
        Self { offset: [0.0; 2], letters: letters.to_owned(), size, face, width }
    }
}

fn split(content: &str, size: f64, bold: bool) -> Vec<Run> {
    let mut runs = Vec::new();
    let (mut oblique, mut index) = (false, false);
    let mut letters = String::new();
    let mut rest = content.chars().peekable();
    let mut close = |letters: &mut String, oblique: bool, index: bool| {
        let letters = std::mem::take(letters);
        if letters.is_empty() {
            return;
        }
        let (size, drop) = if index { (0.75 * size, 0.25 * size) } else { (size, 0.0) };
        let run = Run::new(&letters, size, bold, oblique);
        runs.push(Run { offset: [0.0, drop], ..run });
    };
    while let Some(letter) = rest.next() {
        match letter {
            '*' => {
                close(&mut letters, oblique, index);
                oblique = !oblique;
            }
            '_' if rest.peek() == Some(&'{') => {
                close(&mut letters, oblique, index);
                index = true;
                rest.next();
            }
            '}' if index => {
                close(&mut letters, oblique, index);
                index = false;
            }
            other => letters.push(other),
        }
    }
    close(&mut letters, oblique, index);
    runs
}

impl Scene {
    /// An empty figure.
    pub fn new(unit: Unit, [width, height]: [f64; 2], title: &str) -> Self {
        Self { unit, width, height, title: title.to_owned(), items: Vec::new() }
    }

    /// The same with another figure below it, of the same unit.
    pub fn above(mut self, other: Self) -> Self {
        let down = self.height;
        self.items.extend(other.items.into_iter().map(|item| item.lowered(down)));
        self.width = self.width.max(other.width);
        self.height += other.height;
        self
    }

    /// A line through points.
    pub fn line(&mut self, points: Vec<[f64; 2]>, pen: Pen) {
        self.items.push(Item::Path { points, closed: false, fill: None, pen: Some(pen) });
    }

    /// A filled or outlined polygon.
    pub fn polygon(&mut self, points: Vec<[f64; 2]>, fill: Option<Colour>, pen: Option<Pen>) {
        self.items.push(Item::Path { points, closed: true, fill, pen });
    }

    /// A circle.
    pub fn circle(
        &mut self,
        centre: [f64; 2],
        radius: f64,
        fill: Option<Colour>,
        pen: Option<Pen>,
    ) {
        self.items.push(Item::Circle { centre, radius, fill, pen });
    }

    /// Words.
    pub fn text(&mut self, text: Text) {
        self.items.push(Item::Text(text));
    }

    /// An arrow with a slender head.
    pub fn arrow(&mut self, from: [f64; 2], to: [f64; 2], pen: Pen) {
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let length = dx.hypot(dy);
        if length == 0.0 {
            return;
        }
        let [ux, uy] = [dx / length, dy / length];
        let head = (3.0 + 3.0 * pen.width).min(length);
        let half = 0.35 * head;
        let neck = [to[0] - head * ux, to[1] - head * uy];
        self.line(vec![from, neck], pen);
        let corner = |side: f64| [neck[0] - side * half * uy, neck[1] + side * half * ux];
        self.polygon(vec![to, corner(1.0), corner(-1.0)], Some(pen.colour), None);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_and_oblique_letters_are_runs_of_their_own() {
        let runs = Text::new([0.0; 2], "*F*_{y} (N)").anchor(Anchor::End).runs();
        let letters: Vec<&str> = runs.iter().map(|run| run.letters.as_str()).collect();
        assert_eq!(letters, ["F", "y", " (N)"]);
        assert!(runs[1].size < runs[0].size && runs[1].offset[1] > 0.0);
        let end = runs[2].offset[0] + runs[2].width;
        assert!(end.abs() < 1e-12, "anchored at its end, {end}");
    }
}
