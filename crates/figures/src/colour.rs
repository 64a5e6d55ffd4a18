//! Colours of paper and of pages.

/// A colour: red, green, blue.
pub type Colour = [u8; 3];

/// A grey, 0 black to 255 white.
pub const fn grey(level: u8) -> Colour {
    [level; 3]
}

/// Lines and letters on paper.
pub const BLACK: Colour = grey(0);
/// A dark grey that still reads as grey beside black.
pub const DARK: Colour = grey(90);
/// Grey of secondary lines.
pub const GREY: Colour = grey(140);
/// Grey of fills and grids on paper.
pub const LIGHT: Colour = grey(215);
/// Paper.
pub const WHITE: Colour = grey(255);

/// Letters and axes of plots; `--ink` of a page.
pub const INK: Colour = [27, 31, 36];
/// Grids of plots; `--line` of a page.
pub const GRID: Colour = [222, 226, 231];
/// Curves, told apart by everybody; `--c0`, `--c1` ... of a page.
pub const CURVES: [Colour; 6] =
    [[0, 96, 168], [196, 60, 0], [0, 122, 90], [154, 63, 143], [138, 106, 0], [59, 127, 158]];
