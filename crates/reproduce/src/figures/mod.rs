//! The paper's figures, drawn from our own runs.

mod beams;
mod curves;
mod figure;
mod formulations;
mod models;
mod normals;
mod schematics;

pub(crate) use figure::Figure;
pub(crate) use normals::{tilts, worst_increment};

use crate::study::Study;

/// How many there are.
pub(crate) const COUNT: usize = 12;

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
