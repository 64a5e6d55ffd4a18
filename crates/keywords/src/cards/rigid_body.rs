//! `*RIGID BODY`: nodes, elements and an analytical surface that move with a
//! reference node.

use slideline_deck::{Field, integer, parse_integer};
use slideline_diag::{Code, Diagnostic};
use slideline_model::Dialect;

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::log::{MAX_LABEL, Target};
use crate::reading::Reading;
use crate::surfaces;

/// `*RIGID BODY`.
pub(crate) struct RigidBody;

impl Keyword for RigidBody {
    fn name(&self) -> &'static str {
        "RIGID BODY"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("REF NODE"),
            Rule::value("ANALYTICAL SURFACE"),
            Rule::value("TIE NSET"),
            Rule::value("ELSET"),
            Rule::value("PIN NSET"),
            Rule::value("NSET"),
            Rule::value("ROT NODE"),
            Rule::value("ISOTHERMAL"),
            Rule::value("POSITION"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Links
    }

    fn page(&self) -> &'static str {
        page!("RIGID-BODY")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        unsupported(card, draft);
        let (tied, elements) = (card.named("TIE NSET").or(card.named("NSET")), card.named("ELSET"));
        if card.has("TIE NSET") && card.has("NSET") {
            let message = "NSET and TIE NSET mean the same: give one of them";
            draft.log.error("SL0215", message, card.span_of("NSET"));
        }
        let pinned = card.named("PIN NSET");
        let surface = card.named("ANALYTICAL SURFACE");
        let parts = ["TIE NSET", "NSET", "ELSET", "ANALYTICAL SURFACE", "PIN NSET"];
        if !parts.into_iter().any(|part| card.has(part)) {
            let message =
                "*RIGID BODY needs ANALYTICAL SURFACE=, TIE NSET=, PIN NSET=, NSET= or ELSET=";
            draft.log.error("SL0205", message, card.span());
            return;
        }
        let has_reference = card.has("REF NODE");
        let reference = match node(card, "REF NODE", draft) {
            Some(reference) => reference,
            None if has_reference => return,
            // one stands in the middle of its nodes; a profile alone has none
            None if draft.dialect == Dialect::Calculix && surface.is_none() => {
                Target::Set(String::new())
            }
            None => {
                let message = "*RIGID BODY needs the parameter REF NODE=";
                draft.log.error("SL0205", message, card.span());
                return;
            }
        };
        let turn = node(card, "ROT NODE", draft).map(|node| (node, card.span_of("ROT NODE")));
        let (reference_span, origin) = (card.span_of("REF NODE"), card.span());
        draft.bodies.push(surfaces::RigidBody {
            reference,
            reference_span: if has_reference { reference_span } else { origin },
            has_reference,
            turn,
            tied,
            pinned,
            elements,
            surface,
            markers: None,
            origin,
        });
    }
}

fn unsupported(card: &Reading<'_>, draft: &mut Draft) {
    let known = &["INPUT", "CENTER OF MASS"];
    if let Some("CENTER OF MASS") = card.choice("POSITION", known, &mut draft.log) {
        let message = "POSITION=CENTER OF MASS is not supported";
        let error = Diagnostic::error(Code("SL0221"), message).at(card.span_of("POSITION"));
        draft.log.push(error.help("the reference node stays where *NODE puts it: leave it out"));
    }
}

/// A node, or the name of a set of one node.
pub(super) fn node(card: &Reading<'_>, parameter: &str, draft: &mut Draft) -> Option<Target> {
    let word = card.word(parameter)?;
    if parse_integer(&word.raw).is_err() {
        return card.name(parameter).map(|name| draft.log.instances.target(name));
    }
    let value = draft.log.take(integer(&Field { text: word.raw.clone(), span: word.span }))?;
    let label = u64::try_from(value).ok().filter(|_| (1..=MAX_LABEL).contains(&value));
    if label.is_none() {
        let message = format!("{value} is not a node or element number: 1 to {MAX_LABEL}");
        draft.log.error("SL0224", message, word.span);
    }
    label.map(Target::Label)
}
