//! What a figure consists of, in dots of 1/96 inch, y down.

/// A colour: red, green, blue.
pub(super) type Colour = [u8; 3];

/// Letters and axes.
pub(super) const INK: Colour = [27, 31, 36];
/// Grids.
pub(super) const LIGHT: Colour = [222, 226, 231];
/// Curves, told apart by everybody.
pub(super) const CURVES: [Colour; 6] =
    [[0, 96, 168], [196, 60, 0], [0, 122, 90], [154, 63, 143], [138, 106, 0], [59, 127, 158]];

/// Which point of a text is placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// One thing drawn.
#[derive(Clone, Debug)]
pub(super) enum Item {
    /// Straight pieces through points.
    Line { points: Vec<[f64; 2]>, width: f64, colour: Colour, dashed: bool },
    /// A disc.
    Disc { at: [f64; 2], radius: f64, colour: Colour },
    /// Words on a base line.
    Words { at: [f64; 2], text: String, anchor: Anchor, upwards: bool, bold: bool },
}

/// Size of letters.
pub(super) const LETTERS: f64 = 13.0;

/// A figure.
#[derive(Clone, Debug)]
pub(super) struct Drawing {
    pub width: f64,
    pub height: f64,
    /// What it shows, for those who cannot see it.
    pub title: String,
    pub items: Vec<Item>,
}

impl Drawing {
    pub fn line(&mut self, points: Vec<[f64; 2]>, width: f64, colour: Colour) {
        self.items.push(Item::Line { points, width, colour, dashed: false });
    }

    pub fn words(&mut self, at: [f64; 2], text: impl Into<String>, anchor: Anchor) {
        let text = text.into();
        self.items.push(Item::Words { at, text, anchor, upwards: false, bold: false });
    }
}
