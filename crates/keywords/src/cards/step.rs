//! `*STEP`: opens a step.

use slideline_diag::{Code, Diagnostic};
use slideline_model::Extrapolation;

use crate::draft::Draft;
use crate::draft::StepDraft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*STEP`.
pub(crate) struct Step;

impl Keyword for Step {
    fn name(&self) -> &'static str {
        "STEP"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::maybe("NLGEOM"),
            Rule::value("INC"),
            Rule::maybe("UNSYMM"),
            Rule::value("EXTRAPOLATION"),
            Rule::value("AMPLITUDE"),
            Rule::value("NAME"),
            Rule::flag("PERTURBATION"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["INCF", "CONVERT SDI", "SOLVER", "SUBSTRUCTURE", "THERMAL TYPE"]
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("STEP")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.in_step {
            let message = "the step before has no *END STEP";
            let error = Diagnostic::error(Code("SL0302"), message).at(card.span());
            let before = draft.steps.last().map_or(card.span(), |step| step.origin);
            draft.log.push(error.label(before, "this step is still open"));
        }
        let lines: Vec<&str> = card.data().iter().map(|line| line.text.as_str()).collect();
        // once on it stays on, in both dialects, until a step says NO
        let before = draft.steps.last().is_some_and(|step| step.nlgeom);
        let nlgeom = card.yes("NLGEOM", &mut draft.log).unwrap_or(before);
        if card.has("PERTURBATION") {
            perturbation(card, nlgeom, draft);
        }
        let guess = card.choice("EXTRAPOLATION", &["LINEAR", "PARABOLIC", "NO"], &mut draft.log);
        let amplitude = card.choice("AMPLITUDE", &["RAMP", "STEP"], &mut draft.log);
        let max_increments = increments(card, draft);
        draft.in_step = true;
        draft.steps.push(StepDraft {
            title: lines.join("\n"),
            nlgeom,
            max_increments,
            unsymmetric: card.yes("UNSYMM", &mut draft.log),
            extrapolation: match guess {
                Some("PARABOLIC") => Extrapolation::Parabolic,
                Some("NO") => Extrapolation::None,
                _ => Extrapolation::Linear,
            },
            at_once: amplitude.map(|own| own == "STEP"),
            procedure: None,
            new_boundary: false,
            new_loads: false,
            new_distributed: [false; 2],
            distributed: Vec::new(),
            boundary: Vec::new(),
            loads: Vec::new(),
            new_temperatures: false,
            temperatures: Vec::new(),
            controls: None,
            restart: None,
            stabilisation: None,
            changes: Vec::new(),
            frictions: Vec::new(),
            pressures: Vec::new(),
            properties: Vec::new(),
            interferences: Vec::new(),
            prints: Vec::new(),
            element_prints: Vec::new(),
            contact_prints: Vec::new(),
            section_prints: Vec::new(),
            output: None,
            states_every: Vec::new(),
            contact_changes: false,
            origin: card.span(),
        });
    }
}

/// The first step of a job without NLGEOM is the same with and without it; any other would be
/// linear about a loaded state.
fn perturbation(card: &Reading<'_>, nlgeom: bool, draft: &mut Draft) {
    let span = card.span_of("PERTURBATION");
    if draft.steps.is_empty() && !nlgeom {
        let message = "PERTURBATION has no effect in a first step with linear kinematics";
        draft.log.note("SL0257", message, span);
        return;
    }
    let message = "PERTURBATION about a loaded state is not supported";
    let error = Diagnostic::error(Code("SL0221"), message).at(span);
    draft.log.push(error.help("make it a step of its own kind: leave PERTURBATION out"));
}

/// Most increments of a step; only a ceiling, for decks set it high to be
/// rid of it.
const MAX_INCREMENTS: usize = 1_000_000_000;

fn increments(card: &Reading<'_>, draft: &mut Draft) -> usize {
    let count = card.count("INC", 100, &mut draft.log);
    if count > MAX_INCREMENTS {
        let message = format!("INC={count} is more than {MAX_INCREMENTS} increments in a step");
        draft.log.error("SL0210", message, card.span_of("INC"));
    }
    count.min(MAX_INCREMENTS)
}
