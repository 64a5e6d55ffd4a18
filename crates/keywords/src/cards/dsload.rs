//! `*DSLOAD`: loads on surfaces.

use slideline_deck::{DataLine, normalise};

use super::dload::{direction, take, unknown};
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
    let kind = match label.as_str() {
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
    let on = On::Surface(Named { name: normalise(&field.text), span: field.span });
    Some(Distributed::new(on, (kind, None), value, line.span))
}
