//! A figure of the study.

use slideline_figures::{Scene, Unit};

/// Width of a figure on paper, in points: 160 mm.
pub(super) const WIDTH: f64 = 453.5;

/// A figure and the name of its files.
#[derive(Clone, Debug)]
pub(crate) struct Figure {
    /// Such as `fig6a`.
    pub name: &'static str,
    /// The drawing.
    pub scene: Scene,
    /// What the page says below it.
    pub caption: String,
}

impl Figure {
    pub fn new(name: &'static str, scene: Scene, caption: impl Into<String>) -> Self {
        Self { name, scene, caption: caption.into() }
    }
}

/// An empty figure of full width, in points of 1/72 inch.
pub(super) fn scene(height: f64, title: &str) -> Scene {
    Scene::new(Unit::Point, [WIDTH, height], title)
}
