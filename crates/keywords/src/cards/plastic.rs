//! `*PLASTIC`: yield stress and hardening of a metal.

use slideline_deck::DataLine;
use slideline_mech::material::Hardening;

use crate::draft::{Draft, Table};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*PLASTIC`.
pub(crate) struct Plastic;

impl Keyword for Plastic {
    fn name(&self) -> &'static str {
        "PLASTIC"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("HARDENING")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Sections
    }

    fn is_suboption(&self) -> bool {
        true
    }

    fn page(&self) -> &'static str {
        page!("PLASTIC")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.owning_material(self.name(), card.span()).is_none() {
            return;
        }
        let given = card.word("HARDENING").is_some();
        let known = card.choice("HARDENING", &["ISOTROPIC"], &mut draft.log).is_some() || !given;
        let line = card.first_line("yield stress, plastic strain", &mut draft.log);
        let table = line.filter(|_| known).and_then(|_| table(card, draft));
        let own = (self.name(), card.span());
        draft.give_material(own, |material| &mut material.hardening, table);
    }
}

/// Yield stresses over plastic strains that start at zero and ascend, for every temperature.
fn table(card: &Reading<'_>, draft: &mut Draft) -> Option<Table<Hardening>> {
    let mut tables: Table<Hardening> = Vec::new();
    for line in card.data() {
        draft.log.at_most(line, 3);
        let temperature = draft.log.number_or(line, 2, 0.0)?;
        if tables.last().is_none_or(|last| last.0 != temperature) {
            if !draft.log.ascends(tables.last().map(|last| last.0), temperature, line, 2) {
                return None;
            }
            tables.push((temperature, Hardening::new()));
        }
        let (_, table) = tables.last_mut()?;
        read(line, table, draft)?;
    }
    Some(tables)
}

/// Takes a line into the table of its temperature; `None` where it does not go on there.
fn read(line: &DataLine, table: &mut Hardening, draft: &mut Draft) -> Option<()> {
    let stress = draft.log.number(line, 0, "the yield stress")?;
    let strain = draft.log.number_or(line, 1, 0.0)?;
    let at = |field: usize| line.fields.get(field).map_or(line.span, |field| field.span);
    if stress <= 0.0 {
        draft.log.error("SL0234", "the yield stress must be positive", at(0));
        return None;
    }
    let sound = table.last().map_or(strain == 0.0, |last| strain > last[1]);
    if !sound {
        let message = match table.is_empty() {
            true => "the first plastic strain must be zero".to_owned(),
            false => format!("the plastic strain {strain} does not ascend"),
        };
        draft.log.error("SL0234", message, at(1));
        return None;
    }
    if table.last().is_some_and(|last| stress < last[0]) {
        let message = "the yield stress falls: such a material has no unique answer";
        draft.log.error("SL0234", message, at(0));
        return None;
    }
    table.push([stress, strain]);
    Some(())
}
