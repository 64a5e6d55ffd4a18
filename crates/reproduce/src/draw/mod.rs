//! Drawings of black and grey, in points of 1/72 inch: charts, and views of
//! models; a [`View`] draws in the coordinates of a model.

mod axes;
mod view;

pub(crate) use axes::{Axis, Chart, Entry, Marker};
pub(crate) use slideline::output::draw::{Anchor, Colour, Dash, Pen, Scene, Text, escaped};
pub(crate) use view::{Rectangle, View};

use slideline::output::draw::{Unit, grey};

pub(crate) const BLACK: Colour = grey(0);
/// A dark grey that still reads as grey beside black.
pub(crate) const DARK: Colour = grey(90);
/// Grey of secondary lines.
pub(crate) const GREY: Colour = grey(140);
/// Grey of fills and grids.
pub(crate) const LIGHT: Colour = grey(215);
/// Paper.
pub(crate) const WHITE: Colour = grey(255);

/// Size of letters along axes and in legends [point].
pub(crate) const SMALL: f64 = 9.0;

/// Dots an inch of the PNG twins.
pub(crate) const DOTS: f64 = 300.0;

/// An empty figure.
pub(crate) fn scene(width: f64, height: f64, title: &str) -> Scene {
    Scene::new(Unit::Point, [width, height], title)
}
