//! The paper's figures, drawn from our own runs.

mod beams;
mod curves;
mod formulations;
mod models;
mod normals;
mod schematics;

pub(crate) use normals::{tilts, worst_increment};

use crate::study::Study;
use slideline_figures::{Scene, Unit};

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
    fn new(name: &'static str, scene: Scene, caption: impl Into<String>) -> Self {
        Self { name, scene, caption: caption.into() }
    }
}

/// An empty figure of full width, in points of 1/72 inch.
fn scene(height: f64, title: &str) -> Scene {
    Scene::new(Unit::Point, [WIDTH, height], title)
}

/// How many there are.
pub(crate) const COUNT: usize = 12;

/// Width of a figure on paper, in points: 160 mm.
pub(crate) const WIDTH: f64 = 453.5;

/// All figures, in the paper's order; the last two are ours.
pub(crate) fn all(study: &Study) -> Vec<Figure> {
    vec![
        schematics::figure_1(),
        models::figure_2(study),
        curves::figure_3(study),
        curves::figure_4(study),
        normals::figure_5(study),
        curves::figure_6a(study),
        curves::figure_6b(study),
        models::figure_7(study),
        curves::figure_8a(study),
        curves::figure_8b(study),
        curves::linear_theory(study),
        formulations::figure(study),
    ]
}
