//! Drawings of black and grey, written twice: as SVG and as PNG.
//!
//! ```text
//!   figure --> Scene (lines, discs, words, in points of 1/72 inch)
//!                |--> svg:  text
//!                '--> png:  dots, 300 an inch
//! ```
//!
//! Both writers get the same list and the same metrics of the letters, so that
//! the twins look alike wherever they are opened. The origin is the upper left
//! corner, y points down; a [`View`] draws in the coordinates of a model.

mod axes;
mod font;
mod png;
mod scene;
mod svg;
mod view;

pub(crate) use axes::{Axis, Chart, Entry, Marker};
pub(crate) use scene::{Anchor, Dash, Pen, Scene, Text};
pub(crate) use svg::escaped;
pub(crate) use view::{Rectangle, View};

/// Grey levels, 0 black to 255 white.
pub(crate) const BLACK: u8 = 0;
/// A dark grey that still reads as grey beside black.
pub(crate) const DARK: u8 = 90;
/// Grey of secondary lines.
pub(crate) const GREY: u8 = 140;
/// Grey of fills and grids.
pub(crate) const LIGHT: u8 = 215;
/// Paper.
pub(crate) const WHITE: u8 = 255;

/// Size of letters along axes and in legends [point].
pub(crate) const SMALL: f64 = 9.0;
/// Size of axis titles and labels [point].
pub(crate) const NORMAL: f64 = 10.0;
