//! `*CLOAD`: concentrated forces and moments.

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic};

use crate::draft::Boundary;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*CLOAD`.
pub(crate) struct Cload;

impl Keyword for Cload {
    fn name(&self) -> &'static str {
        "CLOAD"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("OP"),
            Rule::value("AMPLITUDE"),
            Rule::value("TIME DELAY"),
            Rule::maybe("FOLLOWER"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["LOAD CASE", "REGION TYPE", "CYCLIC MODE", "REAL"]
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("CLOAD")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        follower(card, draft);
        let new = card.choice("OP", &["MOD", "NEW"], &mut draft.log) == Some("NEW");
        let amplitude = crate::curves::of_card(card, draft);
        let mut lines = Vec::new();
        for line in card.data() {
            if let Some(mut load) = load(line, draft) {
                load.amplitude.clone_from(&amplitude);
                lines.push(load);
            }
        }
        if let Some(step) = draft.step() {
            step.new_loads |= new;
            step.loads.extend(lines);
        }
    }
}

/// Forces that turn with their node: in a step without NLGEOM nothing turns.
fn follower(card: &Reading<'_>, draft: &mut Draft) {
    if card.yes("FOLLOWER", &mut draft.log) != Some(true) {
        return;
    }
    let span = card.span_of("FOLLOWER");
    if draft.step().is_some_and(|step| !step.nlgeom) {
        let message = "FOLLOWER has no effect in a step without NLGEOM: nothing turns there";
        draft.log.note("SL0257", message, span);
        return;
    }
    let error = Diagnostic::error(Code("SL0221"), "FOLLOWER of *CLOAD is not supported").at(span);
    let help = "forces keep their direction: leave FOLLOWER out where the node hardly turns";
    draft.log.push(error.help(help));
}

fn load(line: &DataLine, draft: &mut Draft) -> Option<Boundary> {
    draft.log.at_most(line, 3);
    let target = draft.log.target(line, 0, "the node or set")?;
    if line.field(1).is_none() {
        let span = line.fields.get(1).map_or(line.end(), |field| field.span);
        draft.log.error("SL0119", "the degree of freedom is missing", span);
        return None;
    }
    let number = draft.log.integer_or(line, 1, 1)?;
    let value = draft.log.number(line, 2, "the size of the load")?;
    let dof = draft.dof(number, line, 1)?;
    let target_span = line.fields[0].span;
    let (dofs, amplitude) = (vec![dof], None);
    let (fixed, is_named, origin) = (false, false, line.span);
    Some(Boundary { target, target_span, dofs, value, amplitude, fixed, is_named, origin })
}
