//! `*BOUNDARY`: prescribed motions.

use slideline_deck::{DataLine, normalise};
use slideline_diag::{Code, Diagnostic};
use slideline_model::Dof;

use crate::draft;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*BOUNDARY`.
pub(crate) struct Boundary;

impl Keyword for Boundary {
    fn name(&self) -> &'static str {
        "BOUNDARY"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("OP"),
            Rule::value("OPT"),
            Rule::value("TYPE"),
            Rule::value("AMPLITUDE"),
            Rule::value("TIME DELAY"),
            Rule::flag("FIXED"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["REAL", "LOAD CASE", "REGION TYPE", "USER LOAD CASE"]
    }

    fn level(&self) -> Level {
        Level::Both
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("BOUNDARY")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if card.has("OPT") && draft.log.first_time("OPT") {
            let message = "OPT is read as OP, as Diehl (1995) prints it";
            draft.log.note("SL0219", message, card.span_of("OPT"));
        }
        let op = if card.has("OPT") { "OPT" } else { "OP" };
        let new = card.choice(op, &["MOD", "NEW"], &mut draft.log) == Some("NEW");
        if let Some(kind @ ("VELOCITY" | "ACCELERATION")) =
            card.choice("TYPE", &["DISPLACEMENT", "VELOCITY", "ACCELERATION"], &mut draft.log)
        {
            let message = format!("*BOUNDARY, TYPE={kind} is not supported: DISPLACEMENT only");
            draft.log.error("SL0221", message, card.span_of("TYPE"));
        }
        let amplitude = crate::curves::of_card(card, draft);
        let mut lines = Vec::new();
        for line in card.data() {
            if let Some(mut line) = condition(line, draft) {
                line.amplitude.clone_from(&amplitude);
                line.fixed = card.has("FIXED");
                lines.push(line);
            }
        }
        match draft.step() {
            Some(step) => {
                step.new_boundary |= new;
                step.boundary.extend(lines);
            }
            None => initial(lines, draft),
        }
    }
}

/// Before the first step only zeros can be prescribed.
fn initial(lines: Vec<draft::Boundary>, draft: &mut Draft) {
    for line in &lines {
        if line.fixed {
            let message = "FIXED holds what a step before has moved: there is none";
            let error = Diagnostic::error(Code("SL0214"), message).at(line.origin);
            draft.log.push(error.help("leave FIXED out, or move the card into a later step"));
        }
        if line.value != 0.0 && draft.dialect == slideline_model::Dialect::Abaqus {
            let message = "before the first step only zero can be prescribed";
            let error = Diagnostic::error(Code("SL0214"), message).at(line.origin);
            draft.log.push(error.help("move this line into the step of the motion"));
        }
    }
    draft.initial.extend(lines);
}

/// Supports with a name of their own, and the dofs they hold.
const NAMED: [(&str, &[Dof]); 8] = [
    ("ENCASTRE", &Dof::ALL),
    ("PINNED", &[Dof::U1, Dof::U2, Dof::U3]),
    ("XSYMM", &[Dof::U1, Dof::UR2, Dof::UR3]),
    ("YSYMM", &[Dof::U2, Dof::UR1, Dof::UR3]),
    ("ZSYMM", &[Dof::U3, Dof::UR1, Dof::UR2]),
    ("XASYMM", &[Dof::U2, Dof::U3, Dof::UR1]),
    ("YASYMM", &[Dof::U1, Dof::U3, Dof::UR2]),
    ("ZASYMM", &[Dof::U1, Dof::U2, Dof::UR3]),
];

fn condition(line: &DataLine, draft: &mut Draft) -> Option<draft::Boundary> {
    draft.log.at_most(line, 4);
    let target = draft.log.target(line, 0, "the node or set")?;
    let target_span = line.fields[0].span;
    let (dofs, value, is_named) = match named(line, draft) {
        Some(dofs) => (dofs?, 0.0, true),
        None => (dofs(line, draft)?, draft.log.number_or(line, 3, 0.0)?, false),
    };
    let amplitude = None;
    let (fixed, origin) = (false, line.span);
    Some(draft::Boundary { target, target_span, dofs, value, amplitude, fixed, is_named, origin })
}

/// A named support: `Some(None)` where the word is unknown.
fn named(line: &DataLine, draft: &mut Draft) -> Option<Option<Vec<Dof>>> {
    let field = line.field(1).filter(|field| field.text.starts_with(char::is_alphabetic))?;
    let name = normalise(&field.text);
    if let Some((_, dofs)) = NAMED.iter().find(|(known, _)| *known == name) {
        return Some(Some(dofs.to_vec()));
    }
    let message = format!("`{}` is neither a degree of freedom nor a named support", field.text);
    let known = NAMED.map(|(name, _)| name).join(", ");
    let error = Diagnostic::error(Code("SL0248"), message).at(field.span);
    draft.log.push(error.help(format!("named supports: {known}")));
    Some(None)
}

fn dofs(line: &DataLine, draft: &mut Draft) -> Option<Vec<Dof>> {
    let range = draft.dof_range(line, 1)?;
    Some(Dof::ALL.into_iter().filter(|dof| range.contains(dof)).collect())
}
