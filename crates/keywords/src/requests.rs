//! Requests for results: what the PRINT, FILE and OUTPUT cards of nodes,
//! beams and contact have in common.
//!
//! ```text
//!   *NODE PRINT   *EL PRINT   *CONTACT PRINT     JOB.dat
//!   *NODE FILE    *EL FILE    *CONTACT FILE      result files
//!   *OUTPUT, FIELD | HISTORY, FREQUENCY=n        result files
//!     *NODE OUTPUT, *ELEMENT OUTPUT, *CONTACT OUTPUT
//! ```

use slideline_deck::Field;
use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{Dialect, PrintTarget, Request, Totals};

use crate::draft::Draft;
use crate::reading::Reading;
use crate::unsupported;

/// Parameters of output cards that change no result.
pub(crate) const WITHOUT_EFFECT: &[&str] = &[
    "OUTPUT",
    "OUTPUT ALL",
    "SECOND SURFACE",
    "GENERAL CONTACT",
    "MICROSCALE",
    "DIAGNOSTIC",
    "MODE LIST",
    "ALL NODES",
    "GLOBAL",
    "TIME POINTS",
    "POSITION",
    "LAST ITERATIONS",
    "CONTACT ELEMENTS",
    "CONTACT ELEMENT",
    "FREQUENCYF",
    "NUMBER INTERVAL",
    "TIME INTERVAL",
    "TIME MARKS",
    "NAME",
    "OP",
    "MODE",
    "LAST MODE",
    "DIRECTIONS",
    "SECTION POINTS",
    "REBAR",
    "EXTERIOR",
    "TRACER SET",
    "SENSOR",
    "FILTER",
    "MASTER",
    "SLAVE",
    "SURFACE",
    "ELSET",
    "NSET",
    "SECTION FORCES",
    "TOTALS",
    "SUMMARY",
    "INTERACTION PROPERTIES",
    "CPSET",
];

/// A result that cards list by its name.
pub(crate) trait Variable: Copy + PartialEq + 'static {
    /// What such a name is called.
    const KIND: &'static str;
    /// All there are, as a help says it.
    const KNOWN: &'static str;
    /// The parameter that names the set.
    const SET: &'static str;
    /// Those of `VARIABLE=PRESELECT`.
    const PRESELECTED: &'static [Self];

    /// The variable, or the one that a component such as `RF2` belongs to.
    fn named(text: &str) -> Option<Self>;

    /// What CalculiX takes it for.
    fn in_calculix(self) -> Self {
        self
    }
}

/// What a card asks for.
pub(crate) struct Asked<V> {
    pub request: Request,
    /// Where the set is named.
    pub set: Option<Span>,
    pub variables: Vec<V>,
}

/// Which kind of card it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Print,
    File,
    /// A card below `*OUTPUT`, which says which file and how often.
    Output,
}

/// Reads a request; `other` takes fields that are no variables and says
/// whether it could. `None` where nothing is asked for.
pub(crate) fn read<V: Variable>(
    card: &Reading<'_>,
    kind: Kind,
    other: &mut dyn FnMut(&str) -> bool,
    draft: &mut Draft,
) -> Option<Asked<V>> {
    let (target, frequency) = file(card, kind, draft);
    let variables = variables(card, other, draft);
    if variables.is_empty() {
        if card.data().is_empty() {
            let message = "no variables are listed: nothing is asked for";
            draft.log.note("SL0257", message, card.span());
        }
        return None;
    }
    let set = card.name(V::SET);
    let span = set.is_some().then(|| card.span_of(V::SET));
    let request = Request {
        set: set.unwrap_or_default(),
        frequency,
        target,
        totals: totals(card, draft),
        summary: card.yes("SUMMARY", &mut draft.log).unwrap_or_default(),
        origin: card.span(),
    };
    Some(Asked { request, set: span, variables })
}

/// `TOTALS`, which may be `ONLY`.
fn totals(card: &Reading<'_>, draft: &mut Draft) -> Totals {
    if !card.has("TOTALS") {
        return Totals::No;
    }
    if card.word("TOTALS").is_none() {
        return Totals::Yes;
    }
    match card.choice("TOTALS", &["YES", "NO", "ON", "OFF", "ONLY"], &mut draft.log) {
        Some("ONLY") => Totals::Only,
        Some("YES" | "ON") => Totals::Yes,
        _ => Totals::No,
    }
}

/// Which file a card is for, and how often.
fn file(card: &Reading<'_>, kind: Kind, draft: &mut Draft) -> (PrintTarget, usize) {
    if kind == Kind::Output {
        let above = draft.step().and_then(|step| step.output);
        let (target, frequency) = above.unwrap_or((PrintTarget::Field, 1));
        if target == PrintTarget::Field {
            ask_for_states(frequency, draft);
        }
        return (target, frequency);
    }
    // CalculiX has one frequency for all, which *OUTPUT may say
    let above = draft.step().and_then(|step| step.output).map(|own| own.1);
    let usual = above.filter(|_| draft.dialect == Dialect::Calculix).unwrap_or(1);
    let frequency = card.at_least(0, "FREQUENCY", usual, &mut draft.log);
    if kind == Kind::Print {
        return (PrintTarget::Table, frequency);
    }
    ask_for_states(frequency, draft);
    (PrintTarget::Field, frequency)
}

/// Notes how often a card wants states.
pub(crate) fn ask_for_states(frequency: usize, draft: &mut Draft) {
    if let Some(step) = draft.step()
        && !step.states_every.contains(&frequency)
    {
        step.states_every.push(frequency);
    }
}

/// The variables of the data lines, each once.
fn variables<V: Variable>(
    card: &Reading<'_>,
    other: &mut dyn FnMut(&str) -> bool,
    draft: &mut Draft,
) -> Vec<V> {
    let mut found = Vec::new();
    let fields = card.data().iter().flat_map(|line| &line.fields);
    for field in fields.filter(|field| !field.text.is_empty()) {
        let named = V::named(&field.text).map(|own| match draft.dialect {
            Dialect::Calculix => own.in_calculix(),
            Dialect::Abaqus => own,
        });
        match named {
            Some(variable) if !found.contains(&variable) => found.push(variable),
            Some(_) => {}
            None if other(&field.text) => {}
            None => unknown::<V>(field, draft),
        }
    }
    if card.has("VARIABLE") && found.is_empty() {
        found.extend(V::PRESELECTED);
    }
    found
}

/// No result changes: a note of what another program writes, a warning of a name that none knows;
/// once for each name.
fn unknown<V: Variable>(field: &Field, draft: &mut Draft) {
    if !draft.log.first_time(&format!("{} {}", V::KIND, field.text)) {
        return;
    }
    let said = if unsupported::variable(&field.text) {
        let message = format!("`{}` is not written by this program", field.text);
        Diagnostic::note(Code("SL0257"), message)
    } else {
        let message = format!("`{}` is not a {}: it is not written", field.text, V::KIND);
        Diagnostic::warning(Code("SL0252"), message)
    };
    draft.log.push(said.at(field.span).help(format!("known: {}", V::KNOWN)));
}
