//! `*CREEP`: the power law by which a material flows with time.

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic};
use slideline_mech::material::{CreepHardening, PowerLaw};
use slideline_model::Dialect;

use crate::draft::{CreepLaw, Draft, Table};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*CREEP`.
pub(crate) struct Creep;

impl Keyword for Creep {
    fn name(&self) -> &'static str {
        "CREEP"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("LAW"), Rule::value("TIME")];
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
        page!("CREEP")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.owning_material(self.name(), card.span()).is_none() {
            return;
        }
        let hardening = hardening(card, draft);
        let law = hardening.and_then(|hardening| {
            let table = table(card, draft)?;
            let beyond_yield = draft.dialect == Dialect::Calculix;
            Some(CreepLaw { hardening, table, beyond_yield })
        });
        let own = (self.name(), card.span());
        draft.give_material(own, |material| &mut material.creep, law);
    }
}

const LAWS: &[&str] = &["STRAIN", "TIME", "NORTON"];

/// What slows creep down: CalculiX' one law goes by time.
fn hardening(card: &Reading<'_>, draft: &mut Draft) -> Option<CreepHardening> {
    let given = card.word("LAW").is_some();
    let law = match (card.choice("LAW", LAWS, &mut draft.log), draft.dialect) {
        (None, _) if given => return None,
        (Some(law), _) => law,
        (None, Dialect::Abaqus) => "STRAIN",
        (None, Dialect::Calculix) => "NORTON",
    };
    if card.has("TIME") && card.choice("TIME", &["TOTAL", "CREEP"], &mut draft.log)? == "CREEP" {
        let message = "TIME=CREEP, the time of *VISCO steps alone, is not supported";
        let error = Diagnostic::error(Code("SL0221"), message).at(card.span_of("TIME"));
        let help = "leave TIME out: it is the total time; give *STATIC steps a short time";
        draft.log.push(error.help(help));
        return None;
    }
    Some(if law == "STRAIN" { CreepHardening::Strain } else { CreepHardening::Time })
}

/// A, n and m over temperature.
fn table(card: &Reading<'_>, draft: &mut Draft) -> Option<Table<PowerLaw>> {
    card.first_line("A, n, m", &mut draft.log)?;
    let mut table = Table::new();
    for line in card.data() {
        draft.log.at_most(line, 4);
        let law = constants(line, draft)?;
        let temperature = draft.log.number_or(line, 3, 0.0)?;
        if !draft.log.ascends(table.last().map(|last| last.0), temperature, line, 3) {
            return None;
        }
        table.push((temperature, law));
    }
    Some(table)
}

fn constants(line: &DataLine, draft: &mut Draft) -> Option<PowerLaw> {
    let factor = draft.log.number(line, 0, "A")?;
    let stress = draft.log.number(line, 1, "the power n of the stress")?;
    let time = draft.log.number_or(line, 2, 0.0)?;
    let at = |field: usize| line.fields.get(field).map_or(line.span, |field| field.span);
    let fault = if factor < 0.0 {
        Some((0, "A must not be negative"))
    } else if stress <= 0.0 {
        Some((1, "the power n of the stress must be positive"))
    } else if time <= -1.0 {
        Some((2, "the power m of the time must be above -1: else creep is endless at once"))
    } else {
        None
    };
    if let Some((field, message)) = fault {
        draft.log.error("SL0234", message, at(field));
        return None;
    }
    Some(PowerLaw { factor, stress, time })
}
