//! `*STEP`: opens a step.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{Dialect, Extrapolation};

use crate::draft::Draft;
use crate::draft::Elasticity;
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
        let nlgeom = card.yes("NLGEOM", &mut draft.log).unwrap_or_else(|| is_large(card, draft));
        let perturbation = card.has("PERTURBATION").then(|| card.span_of("PERTURBATION"));
        // what the steps before did does not count
        let alone = perturbation.is_some_and(|span| perturbs(span, nlgeom, draft));
        let guess = card.choice("EXTRAPOLATION", &["LINEAR", "PARABOLIC", "NO"], &mut draft.log);
        let amplitude = card.choice("AMPLITUDE", &["RAMP", "STEP"], &mut draft.log);
        let max_increments = increments(card, draft);
        draft.in_step = true;
        draft.steps.push(StepDraft {
            title: lines.join("\n"),
            nlgeom,
            perturbation,
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
            new_loads: alone,
            new_distributed: [alone; 2],
            distributed: Vec::new(),
            boundary: Vec::new(),
            loads: Vec::new(),
            new_temperatures: alone,
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

/// Whether kinematics are nonlinear where a step does not say so: once on they stay on, in both dialects, until a step says NO; in
/// that of CalculiX some materials turn them on.
fn is_large(card: &Reading<'_>, draft: &mut Draft) -> bool {
    // a step that answers to its own loads alone leaves nothing to those behind it
    if let Some(before) = draft.steps.iter().rfind(|step| step.perturbation.is_none()) {
        return before.nlgeom;
    }
    let law = draft.materials.iter().find_map(|material| {
        let card = match &material.elasticity.as_ref()?.0 {
            Elasticity::Rubber(_) | Elasticity::Tested(_) => "*HYPERELASTIC",
            Elasticity::Foam(_) => "*HYPERFOAM",
            Elasticity::Deformation(_) => "*DEFORMATION PLASTICITY",
            _ => return None,
        };
        Some((card, material.name.clone()))
    });
    let may = draft.dialect == Dialect::Calculix && !card.has("PERTURBATION");
    let Some((law, material)) = law.filter(|_| may) else {
        return false;
    };
    let message = format!("{law} of material {material} turns NLGEOM on, as in CalculiX");
    let note = Diagnostic::note(Code("SL0247"), message).at(card.span());
    draft.log.push(note.help("write *STEP, NLGEOM to say so"));
    true
}

/// Whether the step is a linear answer to its own loads, behind others like it in the dialect of Abaqus.
/// The first step of a job without NLGEOM is the same with and without PERTURBATION; complains about
/// one that would be linear about a loaded state.
fn perturbs(span: Span, nlgeom: bool, draft: &mut Draft) -> bool {
    let first = draft.steps.is_empty();
    let among_others = draft.dialect == Dialect::Abaqus
        && draft.earlier_steps == 0
        && draft.steps.iter().all(|step| step.perturbation.is_some());
    if nlgeom || !(first || among_others) {
        let message = "PERTURBATION about a loaded state is not supported";
        let error = Diagnostic::error(Code("SL0221"), message).at(span);
        draft.log.push(error.help("make it a step of its own kind: leave PERTURBATION out"));
        return false;
    }
    let message = match first {
        true => "PERTURBATION has no effect in a first step with linear kinematics",
        false => "the loads, motions and temperatures of the steps before do not count in this one",
    };
    draft.log.note("SL0257", message, span);
    !first
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
