//! `*INITIAL CONDITIONS`: the state before the first step.

use slideline_deck::{DataLine, normalise};
use slideline_diag::{Code, Diagnostic};
use slideline_model::Dialect;

use crate::draft::{Draft, HardeningLine, StressLine};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::temperatures;

/// `*INITIAL CONDITIONS`.
pub(crate) struct InitialConditions;

impl Keyword for InitialConditions {
    fn name(&self) -> &'static str {
        "INITIAL CONDITIONS"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::required("TYPE"),
            Rule::value("INPUT"),
            Rule::value("NUMBER BACKSTRESSES"),
            Rule::value("VARIABLE"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Other
    }

    fn page(&self) -> &'static str {
        page!("INITIAL-CONDITIONS")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        match card.name("TYPE").as_deref() {
            Some("TEMPERATURE") => {
                let lines = temperatures::lines(card, draft);
                draft.initial_temperatures.extend(lines);
            }
            Some("STRESS") => stresses(false, card, draft),
            Some("PLASTICSTRAIN") if draft.dialect == Dialect::Calculix => {
                stresses(true, card, draft);
            }
            Some("HARDENING") if draft.dialect == Dialect::Abaqus => hardened(card, draft),
            Some("DISPLACEMENT") if draft.dialect == Dialect::Calculix => {
                let message = "initial displacements have no effect in a static step";
                draft.log.note("SL0257", message, card.span());
            }
            other => otherwise(other.unwrap_or_default(), card, draft),
        }
    }
}

/// Kinds that change no result of a static step, and why.
const WITHOUT_EFFECT: [(&str, &str); 3] = [
    ("VELOCITY", "initial velocities have no effect in a static step"),
    ("ROTATING VELOCITY", "initial velocities have no effect in a static step"),
    ("FIELD", "nothing here depends on a field variable"),
];

/// Kinds of other programs or analyses, and what to do instead.
const NOT_READ: [(&str, &str); 16] = [
    ("PLASTIC STRAIN", "Abaqus gives the equivalent one: TYPE=HARDENING"),
    ("HARDENING", "CalculiX has none: leave it out, or read the deck in Abaqus' dialect"),
    ("DISPLACEMENT", "move the nodes in a first step: *BOUNDARY"),
    ("SOLUTION", "state variables of a user material begin as that material says"),
    ("REF COORDINATE", OF_ANOTHER_ANALYSIS),
    ("INITIAL GAP", "the gap is that of the geometry; *CLEARANCE gives another one"),
    (
        "CONTACT",
        "pairs begin as their geometry stands; *CLEARANCE and *CONTACT INTERFERENCE change it",
    ),
    ("VOID RATIO", OF_ANOTHER_ANALYSIS),
    ("RATIO", OF_ANOTHER_ANALYSIS),
    ("PORE PRESSURE", OF_ANOTHER_ANALYSIS),
    ("SATURATION", OF_ANOTHER_ANALYSIS),
    ("CONCENTRATION", OF_ANOTHER_ANALYSIS),
    ("MASS FLOW", OF_ANOTHER_ANALYSIS),
    ("TOTAL PRESSURE", OF_ANOTHER_ANALYSIS),
    ("FLUID VELOCITY", OF_ANOTHER_ANALYSIS),
    ("ENRICHMENT", OF_ANOTHER_ANALYSIS),
];

const OF_ANOTHER_ANALYSIS: &str = "it belongs to another kind of analysis: leave it out";

/// A kind that is not read: without effect, known and refused, or unknown.
fn otherwise(kind: &str, card: &Reading<'_>, draft: &mut Draft) {
    let of = |list: &[(&'static str, &'static str)]| {
        list.iter().find(|own| normalise(own.0) == kind).copied()
    };
    if let Some((_, message)) = of(&WITHOUT_EFFECT) {
        draft.log.note("SL0257", message, card.span());
        return;
    }
    let (code, message, help) = match of(&NOT_READ) {
        Some((name, help)) => {
            ("SL0221", format!("*INITIAL CONDITIONS, TYPE={name} is not supported"), help)
        }
        None => {
            let message = format!("`{kind}` is no kind of initial condition");
            ("SL0207", message, "given here: TEMPERATURE, STRESS, HARDENING")
        }
    };
    let error = Diagnostic::error(Code(code), message).at(card.span_of("TYPE"));
    draft.log.push(error.help(help));
}

/// Reads the lines of TYPE=HARDENING.
fn hardened(card: &Reading<'_>, draft: &mut Draft) {
    if card.name("NUMBER BACKSTRESSES").is_some_and(|count| count != "1") {
        let message = "initial hardening has one back stress here";
        let error = Diagnostic::error(Code("SL0221"), message);
        let help = "give the first back stress alone, or begin with a step that strains the part";
        draft.log.push(error.at(card.span_of("NUMBER BACKSTRESSES")).help(help));
        return;
    }
    let lines: Vec<HardeningLine> =
        card.data().iter().filter_map(|line| hardening(line, draft)).collect();
    draft.initial_hardening.extend(lines);
}

/// `element or set, equivalent plastic strain, components of the back stress`.
fn hardening(line: &DataLine, draft: &mut Draft) -> Option<HardeningLine> {
    let target = draft.log.target(line, 0, "the element or set")?;
    let plastic_strain = draft.log.number(line, 1, "the equivalent plastic strain")?;
    if plastic_strain < 0.0 {
        let message = "an equivalent plastic strain is not negative";
        draft.log.error("SL0210", message, line.fields[1].span);
        return None;
    }
    draft.log.at_most(line, 8);
    let count = line.fields.len().clamp(2, 8);
    let values: Vec<Option<f64>> =
        (2..count).map(|at| draft.log.number_or(line, at, 0.0)).collect();
    Some(HardeningLine {
        target,
        target_span: line.fields.first()?.span,
        plastic_strain,
        values: values.into_iter().collect::<Option<_>>()?,
        origin: line.span,
    })
}

/// Reads the lines of TYPE=STRESS, or of strains.
fn stresses(strains: bool, card: &Reading<'_>, draft: &mut Draft) {
    let lines: Vec<StressLine> =
        card.data().iter().filter_map(|line| stress(line, strains, draft)).collect();
    draft.initial_stresses.extend(lines);
}

/// `element or set, components`, in the dialect of CalculiX `element or set, point, components`.
fn stress(line: &DataLine, strains: bool, draft: &mut Draft) -> Option<StressLine> {
    let target = draft.log.target(line, 0, "the element or set")?;
    let calculix = draft.dialect == Dialect::Calculix;
    let point = match calculix {
        true => Some(draft.log.label(line, 1, "the integration point")? as usize - 1),
        false => None,
    };
    let first = if calculix { 2 } else { 1 };
    draft.log.at_most(line, first + 6);
    let count = line.fields.len().clamp(first + 1, first + 6);
    let values = (first..count).map(|at| draft.log.number_or(line, at, 0.0));
    let values: Vec<Option<f64>> = values.collect();
    Some(StressLine {
        target,
        target_span: line.fields.first()?.span,
        point,
        strains,
        values: values.into_iter().collect::<Option<_>>()?,
        origin: line.span,
    })
}
