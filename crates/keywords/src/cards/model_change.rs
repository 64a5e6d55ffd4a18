//! `*MODEL CHANGE`: elements and contact pairs leave the model and come back.

use slideline_diag::{Code, Diagnostic};

use super::contact_pair::surface;
use crate::changes::{Act, Changed, ModelChange as Change};
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*MODEL CHANGE`.
pub(crate) struct ModelChange;

impl Keyword for ModelChange {
    fn name(&self) -> &'static str {
        "MODEL CHANGE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("TYPE"),
            Rule::flag("REMOVE"),
            Rule::maybe("ADD"),
            Rule::flag("MECHSTRAINTORESIDUAL"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["ACTIVATE"]
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("MODEL-CHANGE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let kind = card.choice("TYPE", &["ELEMENT", "CONTACT PAIR"], &mut draft.log);
        let Some(act) = act(card, draft) else { return };
        let of = match kind {
            Some("CONTACT PAIR") => pairs(card, draft),
            _ => elements(card, draft),
        };
        let origin = card.span();
        if let Some(step) = draft.step() {
            step.changes.push(Change { act, of, origin });
        }
    }
}

/// What the card does; `None` where it does nothing, or what is wrong has been said.
fn act(card: &Reading<'_>, draft: &mut Draft) -> Option<Act> {
    if card.has("MECHSTRAINTORESIDUAL") {
        let message = "MECHSTRAINTORESIDUAL is not supported";
        let error = Diagnostic::error(Code("SL0221"), message);
        let error = error.at(card.span_of("MECHSTRAINTORESIDUAL"));
        let help = "remove the elements in one step and add them free of strain in the next";
        draft.log.push(error.help(help));
        return None;
    }
    match (card.has("REMOVE"), card.has("ADD")) {
        (true, true) => {
            let message = "REMOVE and ADD exclude one another";
            let error = Diagnostic::error(Code("SL0215"), message).at(card.span_of("ADD"));
            draft.log.push(error.help("give a *MODEL CHANGE card for each"));
            None
        }
        (true, false) => Some(Act::Remove),
        (false, true) => {
            let known = &["STRAIN FREE", "WITH STRAIN"];
            match card.choice("ADD", known, &mut draft.log) {
                Some("WITH STRAIN") => Some(Act::Return),
                _ => Some(Act::Begin),
            }
        }
        // ACTIVATE alone: later jobs may change the model in any case
        (false, false) if card.data().is_empty() && !card.has("TYPE") => None,
        (false, false) => {
            let message = "*MODEL CHANGE needs REMOVE or ADD";
            draft.log.error("SL0205", message, card.span());
            None
        }
    }
}

/// Elements and sets, any number on a line.
fn elements(card: &Reading<'_>, draft: &mut Draft) -> Changed {
    card.first_line("elements or element sets", &mut draft.log);
    let mut all = Vec::new();
    for line in card.data() {
        for (at, field) in line.fields.iter().enumerate().filter(|(_, own)| !own.text.is_empty()) {
            let target = draft.log.target(line, at, "the element or set");
            all.extend(target.map(|target| (target, field.span)));
        }
    }
    Changed::Elements(all)
}

fn pairs(card: &Reading<'_>, draft: &mut Draft) -> Changed {
    card.first_line("slave surface, master surface", &mut draft.log);
    let mut all = Vec::new();
    for line in card.data() {
        draft.log.at_most(line, 2);
        let slave = surface(line, 0, "the slave surface", &mut draft.log);
        // one surface alone meets itself
        let master = match line.field(1) {
            Some(_) => surface(line, 1, "the master surface", &mut draft.log),
            None => slave.clone(),
        };
        all.extend(slave.zip(master).map(|(slave, master)| ([slave, master], line.span)));
    }
    Changed::Pairs(all)
}
