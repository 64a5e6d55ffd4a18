//! `*INSTANCE`: a copy of a part at its place in the assembly.

use slideline_deck::DataLine;

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::motion::Motion;
use crate::reading::Reading;

/// `*INSTANCE`.
pub(crate) struct Instance;

impl Keyword for Instance {
    fn name(&self) -> &'static str {
        "INSTANCE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("NAME"), Rule::required("PART")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Nodes
    }

    fn page(&self) -> &'static str {
        page!("INSTANCE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 2, self.name());
        let motion = motion(card, draft);
        let (Some(name), Some(part)) = (card.name("NAME"), card.name("PART")) else { return };
        let (name, part) = ((name, card.span_of("NAME")), (part, card.span_of("PART")));
        draft.open_instance(name, part, motion, card.span());
    }
}

/// The translation of the first line and the rotation of the second; nothing moves where
/// they are missing, or broken, which is said.
pub(super) fn motion(card: &Reading<'_>, draft: &mut Draft) -> Motion {
    let mut motion = Motion { translation: [0.0; 3], rotation: None };
    if let Some(line) = card.data().first() {
        draft.log.at_most(line, 3);
        motion.translation = point(line, 0, draft);
    }
    if let Some(line) = card.data().get(1) {
        draft.log.at_most(line, 7);
        let (a, b) = (point(line, 0, draft), point(line, 3, draft));
        let angle = draft.log.number_or(line, 6, 0.0).unwrap_or(0.0);
        motion.rotation = Motion::rotation(a, b, angle);
        if motion.rotation.is_none() {
            draft.log.error("SL0232", "the points a and b of the axis coincide", line.span);
        }
    }
    motion
}

fn point(line: &DataLine, at: usize, draft: &mut Draft) -> [f64; 3] {
    [0, 1, 2].map(|k| draft.log.number_or(line, at + k, 0.0).unwrap_or(0.0))
}
