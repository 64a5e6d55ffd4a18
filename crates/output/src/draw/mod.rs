//! Drawings, written twice: as SVG and as PNG.
//!
//! ```text
//!   figure --> Scene (lines, discs, words)
//!                |--> svg:  text, on paper or in the colours of a page
//!                '--> png:  dots, so many an inch
//! ```
//!
//! Both writers get the same list and the same metrics of the letters, so that
//! the twins look alike wherever they are opened. The origin is the upper left
//! corner, y points down.

mod font;
mod png;
mod scene;
mod svg;

pub use crate::report::escaped;
pub use scene::{Anchor, Colour, Dash, Item, Pen, Scene, Text, Unit, grey};

/// Letters and axes of plots; `--ink` of a page.
pub const INK: Colour = [27, 31, 36];
/// Grids of plots; `--line` of a page.
pub const GRID: Colour = [222, 226, 231];
/// Curves, told apart by everybody; `--c0`, `--c1` ... of a page.
pub const CURVES: [Colour; 6] =
    [[0, 96, 168], [196, 60, 0], [0, 122, 90], [154, 63, 143], [138, 106, 0], [59, 127, 158]];
