//! `*CYCLIC HARDENING`: how the yield surface of combined hardening grows.

use slideline_mech::material::Hardening;

use super::plastic::table;
use crate::draft::{Draft, Table};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*CYCLIC HARDENING`.
pub(crate) struct CyclicHardening;

impl Keyword for CyclicHardening {
    fn name(&self) -> &'static str {
        "CYCLIC HARDENING"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::flag("PARAMETERS")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Properties
    }

    fn is_suboption(&self) -> bool {
        true
    }

    fn page(&self) -> &'static str {
        page!("CYCLIC-HARDENING")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.owning_material(self.name(), card.span()).is_none() {
            return;
        }
        let by_parameters = card.has("PARAMETERS");
        let what =
            if by_parameters { "yield stress, Q, b" } else { "yield stress, plastic strain" };
        let line = card.first_line(what, &mut draft.log);
        let read = |_| if by_parameters { exponential(card, draft) } else { table(card, draft) };
        let table = line.and_then(read).filter(|table| {
            let one = table.len() == 1;
            if !one {
                let message = "a yield surface that moves has constants of one temperature alone";
                draft.log.error("SL0234", message, card.span());
            }
            one
        });
        let own = (self.name(), card.span());
        draft.give_material(own, |material| &mut material.growth, table);
    }
}

/// Points on the curve, at equal steps of exp(-b p/2).
const POINTS: u32 = 500;

/// The curve `s + Q (1 - exp(-b p))` as a table, which it leaves by less than 2e-6 Q: a chord over a
/// step D of y = exp(-b p/2) is off by Q D^2/2.
fn exponential(card: &Reading<'_>, draft: &mut Draft) -> Option<Table<Hardening>> {
    draft.log.at_most_lines(card.data(), 1, "CYCLIC HARDENING");
    let line = card.data().first()?;
    draft.log.at_most(line, 3);
    let start = draft.log.number(line, 0, "the yield stress")?;
    let growth = draft.log.number_or(line, 1, 0.0)?;
    let rate = draft.log.number_or(line, 2, 0.0)?;
    if start <= 0.0 || growth < 0.0 || rate < 0.0 {
        let message = "the yield stress must be positive, Q and b not negative";
        draft.log.error("SL0234", message, line.span);
        return None;
    }
    let mut table = vec![[start, 0.0]];
    if growth > 0.0 && rate > 0.0 {
        table.extend((1..POINTS).map(|k| {
            let y = 1.0 - f64::from(k) / f64::from(POINTS);
            [start + growth * (1.0 - y * y), -2.0 * y.ln() / rate]
        }));
    }
    Some(vec![(0.0, table)])
}
