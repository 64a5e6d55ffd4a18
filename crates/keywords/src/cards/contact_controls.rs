//! `*CONTACT CONTROLS`: when friction begins to act, and stabilisation.

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic};
use slideline_model::{Onset, Stabilisation};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*CONTACT CONTROLS`.
pub(crate) struct ContactControls;

impl Keyword for ContactControls {
    fn name(&self) -> &'static str {
        "CONTACT CONTROLS"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("FRICTION ONSET"),
            Rule::maybe("STABILIZE"),
            Rule::value("TANGENT FRACTION"),
            Rule::maybe("MASTER"),
            Rule::maybe("SLAVE"),
            Rule::maybe("RESET"),
            Rule::maybe("AUTOMATIC TOLERANCES"),
            Rule::maybe("ABSOLUTE PENETRATION TOLERANCE"),
            Rule::maybe("RELATIVE PENETRATION TOLERANCE"),
            Rule::maybe("STIFFNESS SCALE FACTOR"),
            Rule::maybe("LAGRANGE MULTIPLIER"),
            Rule::maybe("MAXCHP"),
            Rule::maybe("UERRMX"),
            Rule::maybe("PERRMX"),
            Rule::maybe("PERTURBATION"),
            Rule::maybe("CPSET"),
            Rule::maybe("FASTLOCALTRK"),
            Rule::maybe("GLOBTRKINC"),
            Rule::maybe("SCALE PENALTY"),
            Rule::maybe("TYPE"),
            Rule::maybe("WARP CHECK PERIOD"),
            Rule::maybe("WARP CUT OFF"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::Both
    }

    fn subject(&self) -> Subject {
        Subject::Contact
    }

    fn page(&self) -> &'static str {
        page!("CONTACT-CONTROLS")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if card.has("STABILIZE") {
            inert(card, draft);
            stabilise(card, draft);
        } else {
            draft.log.at_most_lines(card.data(), 0, self.name());
            if card.has("TANGENT FRACTION") {
                let message = "TANGENT FRACTION belongs to STABILIZE";
                draft.log.error("SL0236", message, card.span_of("TANGENT FRACTION"));
            }
        }
        if !card.has("FRICTION ONSET") {
            if !card.has("STABILIZE") && !inert(card, draft) {
                let message = "*CONTACT CONTROLS needs FRICTION ONSET or STABILIZE";
                draft.log.error("SL0205", message, card.span());
            }
            return;
        }
        if draft.in_step {
            let message = "the friction onset is a property of the model";
            let error = Diagnostic::error(Code("SL0214"), message).at(card.span());
            draft.log.push(error.help("put *CONTACT CONTROLS before the first *STEP"));
        }
        let known = &["IMMEDIATE", "DELAYED", "MATFRU"];
        match card.choice("FRICTION ONSET", known, &mut draft.log) {
            Some("IMMEDIATE") => draft.model.friction_onset = Onset::Immediate,
            Some("DELAYED") => draft.model.friction_onset = Onset::Delayed,
            Some("MATFRU") => draft.model.friction_onset = Onset::Matfru,
            _ => {}
        }
    }
}

/// Parameters without effect: of one pair or of all, what stabilises vanishes at the end of the
/// step, and tolerances are those of the program.
const INERT: [&str; 19] = [
    "MASTER",
    "SLAVE",
    "RESET",
    "AUTOMATIC TOLERANCES",
    "ABSOLUTE PENETRATION TOLERANCE",
    "RELATIVE PENETRATION TOLERANCE",
    "STIFFNESS SCALE FACTOR",
    "LAGRANGE MULTIPLIER",
    "MAXCHP",
    "UERRMX",
    "PERRMX",
    "PERTURBATION",
    "CPSET",
    "FASTLOCALTRK",
    "GLOBTRKINC",
    "SCALE PENALTY",
    "TYPE",
    "WARP CHECK PERIOD",
    "WARP CUT OFF",
];

/// Whether the card has parameters without effect, which is said.
fn inert(card: &Reading<'_>, draft: &mut Draft) -> bool {
    let mut found = false;
    for name in INERT.into_iter().filter(|name| card.has(name)) {
        let message = format!("{name} of *CONTACT CONTROLS has no effect here and is ignored");
        draft.log.note("SL0257", message, card.span_of(name));
        found = true;
    }
    found
}

/// `STABILIZE[=factor]`; data `coefficient, fraction at the end, clearance`.
fn stabilise(card: &Reading<'_>, draft: &mut Draft) {
    draft.log.at_most_lines(card.data(), 1, "CONTACT CONTROLS, STABILIZE");
    let mut found = Stabilisation::automatic(card.span());
    let values =
        [("STABILIZE", &mut found.factor), ("TANGENT FRACTION", &mut found.tangent_fraction)];
    for (name, value) in values {
        let Some(given) = card.number(name, &mut draft.log) else { return };
        *value = given.unwrap_or(*value);
        if *value < 0.0 || *value == 0.0 && name == "STABILIZE" {
            let message = format!("{name} must be positive");
            draft.log.error("SL0210", message, card.span_of(name));
            return;
        }
    }
    if let Some(line) = card.data().first() {
        draft.log.at_most(line, 3);
        found.coefficient = positive(line, 0, draft);
        found.range = positive(line, 2, draft);
        if draft.log.maybe_number(line, 1).flatten().is_some_and(|fraction| fraction != 0.0) {
            let message = "stabilisation that stays at the end of the step would change the result";
            let error = Diagnostic::error(Code("SL0221"), message).at(line.fields[1].span);
            draft.log.push(error.help("leave the fraction at the end out: it is zero"));
        }
    }
    match draft.step() {
        Some(step) => step.stabilisation = Some(found),
        None => {
            let message = "contact is stabilised in a step";
            let error = Diagnostic::error(Code("SL0214"), message).at(card.span());
            draft.log.push(error.help("put *CONTACT CONTROLS, STABILIZE below a *STEP"));
        }
    }
}

/// A value that is blank or positive.
fn positive(line: &DataLine, at: usize, draft: &mut Draft) -> Option<f64> {
    let value = draft.log.maybe_number(line, at)??;
    if value <= 0.0 {
        draft.log.error("SL0210", "this value must be positive", line.fields[at].span);
        return None;
    }
    Some(value)
}
