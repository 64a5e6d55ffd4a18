//! Figures: one scene, one chart, written twice.
//!
//! ```text
//!   curves --> Frame (axes, lines, symbols, legend) --+
//!   models --> View (a window, true to scale) --------+--> Scene --+--> svg: on paper, or in
//!   anything: lines, discs, words --------------------'            |    the colours of a page
//!                                                                  '--> png: dots, so many an inch
//! ```
//!
//! Both writers get the same list and the same metrics of the letters, so that
//! the twins look alike wherever they are opened. The origin is the upper left
//! corner, y points down.

mod axis;
mod chart;
mod colour;
mod font;
mod frame;
mod png;
mod scene;
mod svg;
mod view;

pub use axis::{Axis, Span};
pub use chart::{Mark, Panel, Series, chart};
pub use colour::{BLACK, CURVES, Colour, DARK, GREY, GRID, INK, LIGHT, WHITE, grey};
pub use frame::{Entry, Frame, Marker, SMALL};
pub use scene::{Anchor, Dash, Item, Pen, Scene, Text, Unit};
pub use svg::escaped;
pub use view::{Rectangle, View};
