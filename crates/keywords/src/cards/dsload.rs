//! `*DSLOAD`: loads on surfaces.

use slideline_deck::{DataLine, normalise};
use slideline_model::Dialect;

use super::dload::{self, direction, take, unknown};
use crate::distributed::{Distributed, Kind, On};
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::surfaces::Named;

/// `*DSLOAD`.
pub(crate) struct Dsload;

impl Keyword for Dsload {
    fn name(&self) -> &'static str {
        "DSLOAD"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("OP"),
            Rule::value("AMPLITUDE"),
            Rule::value("TIME DELAY"),
            Rule::value("ORIENTATION"),
            Rule::value("FOLLOWER"),
            Rule::value("CONSTANT RESULTANT"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["LOAD CASE", "REGION TYPE", "REAL"]
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("DSLOAD")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        take(card, line_of, draft);
    }
}

fn line_of(line: &DataLine, draft: &mut Draft) -> Option<Distributed> {
    let Some(field) = line.field(0) else {
        draft.log.error("SL0119", "the surface is missing", line.span);
        return None;
    };
    let label = line.field(1).map_or(String::new(), |field| normalise(&field.text));
    let name = normalise(&field.text);
    // CalculiX takes P with the number of a face: of a surface it is P, of elements that of *DLOAD
    let numbered = draft.dialect == Dialect::Calculix && is_numbered(&label);
    if numbered && !draft.named_surfaces.iter().any(|own| own.named.name == name) {
        return dload::line_of(line, draft);
    }
    let label = if numbered { "P" } else { &label };
    let kind = match label {
        "P" => {
            draft.log.at_most(line, 3);
            Kind::Pressure
        }
        "TRVEC" => Kind::Traction(direction(line, 3, draft)?),
        "TRSHR" => Kind::Shear(direction(line, 3, draft)?),
        _ => {
            unknown(line, "P, TRVEC, TRSHR", draft);
            return None;
        }
    };
    let value = draft.log.number(line, 2, "the size of the load")?;
    let on = On::Surface(Named { name, span: field.span });
    Some(Distributed::new(on, (kind, None), value, line.span))
}

fn is_numbered(label: &str) -> bool {
    label.strip_prefix('P').is_some_and(|number| ["1", "2", "3", "4", "5", "6"].contains(&number))
}
