//! `*NSET`: a named set of nodes.

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic, Span};

use crate::draft::Draft;
use crate::instances::Placement;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::log::Target;
use crate::parts::Place;
use crate::reading::Reading;
use crate::sets::Item;

/// `*NSET`.
pub(crate) struct Nset;

impl Keyword for Nset {
    fn name(&self) -> &'static str {
        "NSET"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::required("NSET"),
            Rule::flag("GENERATE"),
            Rule::flag("UNSORTED"),
            Rule::value("INSTANCE"),
            Rule::flag("INTERNAL"),
            Rule::value("ELSET"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["SORTED", "FREQUENCY"]
    }

    fn level(&self) -> Level {
        Level::Both
    }

    fn subject(&self) -> Subject {
        Subject::Nodes
    }

    fn page(&self) -> &'static str {
        page!("NSET")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Some(name) = card.name("NSET") else { return };
        draft.node_sets.open(&name, card.span());
        for (item, span) in read_members(card, draft) {
            draft.node_sets.join(&name, item, span);
        }
        if let Some(elements) = card.named("ELSET") {
            let placement =
                card.name("INSTANCE").and_then(|name| draft.log.instances.placement(&name));
            let elements = match placement {
                Some(by) => elements.placed(&by),
                None => elements,
            };
            draft.node_sets_of_elements.push((name, elements));
        }
    }
}

/// The members listed on the data lines of `*NSET` and `*ELSET`.
pub(crate) fn read_members(card: &Reading<'_>, draft: &mut Draft) -> Vec<(Item, Span)> {
    let mut members = Vec::new();
    let placement = instance(card, draft);
    for line in card.data() {
        if card.has("GENERATE") {
            members.extend(range(line, draft).map(|item| (item, line.span)));
            continue;
        }
        for at in (0..line.fields.len()).filter(|&at| line.field(at).is_some()) {
            let item = match draft.log.target(line, at, "a member") {
                Some(Target::Label(label)) => Item::One(label),
                Some(Target::Set(set)) => Item::Set(set),
                None => continue,
            };
            members.push((item, line.fields[at].span));
        }
    }
    match placement {
        Some(by) => members.into_iter().map(|(item, span)| (item.placed(&by), span)).collect(),
        None => members,
    }
}

/// The instance whose numbers and names the data lines use, where `INSTANCE` says one.
fn instance(card: &Reading<'_>, draft: &mut Draft) -> Option<Placement> {
    let name = card.name("INSTANCE")?;
    let found = draft.log.instances.placement(&name);
    if found.is_none() && draft.is_complete(Subject::Nodes) {
        let message = format!("there is no instance {name}");
        let error = Diagnostic::error(Code("SL0258"), message).at(card.span_of("INSTANCE"));
        let help = match slideline_deck::nearest(&name, draft.log.instances.names()) {
            Some(near) => format!("did you mean {near}?"),
            None => format!("define it before: *INSTANCE, NAME={name}, PART=..."),
        };
        draft.log.push(error.help(help));
    }
    found
}

/// `first, last, increment`.
pub(crate) fn range(line: &DataLine, draft: &mut Draft) -> Option<Item> {
    draft.log.at_most(line, 3);
    let first = draft.log.label(line, 0, "the first number")?;
    let last = draft.log.label(line, 1, "the last number")?;
    let step = draft.log.integer_or(line, 2, 1)?;
    let step = u64::try_from(step).ok().filter(|&step| step > 0);
    let fits = step.is_some_and(|step| last >= first && (last - first).is_multiple_of(step));
    let (Some(step), true) = (step, fits) else {
        let message = format!("{first} to {last} cannot be counted with this increment");
        draft.log.error("SL0226", message, line.span);
        return None;
    };
    let count = u128::from((last - first) / step + 1);
    draft.reserve(count, "members", line.span).then_some(Item::Range(first, last, step))
}
