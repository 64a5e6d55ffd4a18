//! Axes of nodes while the deck is read.

use slideline_deck::DataLine;
use slideline_diag::Span;
use slideline_model::System;

use crate::draft::Draft;

/// `*TRANSFORM`.
#[derive(Clone, Debug)]
pub(crate) struct Transform {
    pub set: String,
    pub set_span: Span,
    pub system: System,
    pub origin: Span,
}

/// The points of a line, three numbers each; blank ones are zero.
pub(crate) fn read_points<const N: usize>(
    line: &DataLine,
    draft: &mut Draft,
) -> Option<[[f64; 3]; N]> {
    let mut points = [[0.0; 3]; N];
    for (at, value) in points.as_flattened_mut().iter_mut().enumerate() {
        *value = draft.log.number_or(line, at, 0.0)?;
    }
    Some(points)
}
