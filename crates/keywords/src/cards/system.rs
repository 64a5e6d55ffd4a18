//! `*SYSTEM`: the axes in which the coordinates of the next nodes are given.

use slideline_deck::DataLine;

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Subject};
use crate::motion::Frame;
use crate::reading::Reading;

/// `*SYSTEM`.
pub(crate) struct System;

impl Keyword for System {
    fn name(&self) -> &'static str {
        "SYSTEM"
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Nodes
    }

    fn page(&self) -> &'static str {
        page!("SYSTEM")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 2, self.name());
        let Some(line) = card.data().first() else {
            draft.node_frame = None;
            return;
        };
        draft.log.at_most(line, 6);
        let origin = point(line, 0, draft);
        let first = point(line, 3, draft);
        let second = card.data().get(1).map(|line| {
            draft.log.at_most(line, 3);
            point(line, 0, draft)
        });
        // an origin alone moves the axes, a second point turns them about one along z
        let (first, second) = match line.fields.len() {
            0..=3 => (shifted(origin, 0), shifted(origin, 1)),
            _ => (first, second.unwrap_or_else(|| beside(origin, first))),
        };
        draft.node_frame = Frame::through(origin, first, second);
        if draft.node_frame.is_none() {
            let message = "the three points of the system lie on one line";
            draft.log.error("SL0232", message, line.span);
        }
    }
}

fn point(line: &DataLine, at: usize, draft: &mut Draft) -> [f64; 3] {
    [0, 1, 2].map(|k| draft.log.number_or(line, at + k, 0.0).unwrap_or(0.0))
}

/// A point on a global axis through another one.
fn shifted(origin: [f64; 3], axis: usize) -> [f64; 3] {
    std::array::from_fn(|k| if k == axis { origin[k] + 1.0 } else { origin[k] })
}

/// A point on the left of the way from one to another in the plane of x and y.
fn beside(origin: [f64; 3], first: [f64; 3]) -> [f64; 3] {
    [origin[0] - (first[1] - origin[1]), origin[1] + (first[0] - origin[0]), origin[2]]
}
