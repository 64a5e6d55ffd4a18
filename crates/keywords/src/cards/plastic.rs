//! `*PLASTIC`: yield stress and hardening of a metal.

use slideline_deck::DataLine;
use slideline_mech::material::{BackStress, Hardening};
use slideline_model::Dialect;

use crate::draft::{Draft, Table, Yielding};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*PLASTIC`.
pub(crate) struct Plastic;

impl Keyword for Plastic {
    fn name(&self) -> &'static str {
        "PLASTIC"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("HARDENING"),
            Rule::value("DATA TYPE"),
            Rule::value("NUMBER BACKSTRESSES"),
        ];
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
        page!("PLASTIC")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.owning_material(self.name(), card.span()).is_none() {
            return;
        }
        let yielding = read_yielding(card, draft);
        let own = (self.name(), card.span());
        draft.give_material(own, |material| &mut material.hardening, yielding);
    }
}

const KINDS: &[&str] = &["ISOTROPIC", "KINEMATIC", "COMBINED"];

/// How a metal yields, as a card says it; `None` after an error.
pub(super) fn read_yielding(card: &Reading<'_>, draft: &mut Draft) -> Option<Yielding> {
    let given = card.word("HARDENING").is_some();
    let kind = card.choice("HARDENING", KINDS, &mut draft.log);
    let kind = if given { kind } else { Some("ISOTROPIC") };
    let line = card.first_line("yield stress, plastic strain", &mut draft.log);
    kind.filter(|_| line.is_some()).and_then(|kind| yielding(kind, card, draft))
}

/// The same by the kind of its hardening.
fn yielding(kind: &str, card: &Reading<'_>, draft: &mut Draft) -> Option<Yielding> {
    let of_parts = kind == "COMBINED" && draft.dialect == Dialect::Abaqus;
    for name in ["DATA TYPE", "NUMBER BACKSTRESSES"] {
        if card.has(name) && !of_parts {
            let message = format!("{name} belongs to HARDENING=COMBINED in Abaqus' dialect");
            draft.log.error("SL0234", message, card.span_of(name));
            return None;
        }
    }
    if of_parts {
        return parts(card, draft);
    }
    let table = table(card, draft)?;
    if kind == "ISOTROPIC" {
        return Some(Yielding { table, back_stresses: Vec::new(), combined: false });
    }
    let [(temperature, lines)] = &table[..] else {
        let message = "a yield surface that moves has constants of one temperature alone";
        draft.log.error("SL0234", message, card.span());
        return None;
    };
    let back_stress = match (draft.dialect, &lines[..]) {
        (Dialect::Calculix, lines) => BackStress::Table(lines.to_vec()),
        (Dialect::Abaqus, [_]) => BackStress::Evolving { modulus: 0.0, recall: 0.0 },
        (Dialect::Abaqus, [low, high]) => {
            let modulus = (high[0] - low[0]) / (high[1] - low[1]);
            BackStress::Evolving { modulus, recall: 0.0 }
        }
        (Dialect::Abaqus, _) => {
            let message = "linear kinematic hardening has two lines: the yield stress, and a stress \
                           at a plastic strain";
            draft.log.error("SL0234", message, card.data().get(2)?.span);
            return None;
        }
    };
    let start = lines.first().copied().into_iter().collect();
    let (table, combined) = (vec![(*temperature, start)], kind == "COMBINED");
    Some(Yielding { table, back_stresses: vec![back_stress], combined })
}

/// Yield stress, then modulus and recall of every back stress.
fn parts(card: &Reading<'_>, draft: &mut Draft) -> Option<Yielding> {
    if card.choice("DATA TYPE", DATA_TYPES, &mut draft.log) != Some("PARAMETERS") {
        let message = "combined hardening is read from its parameters alone: write DATA \
                       TYPE=PARAMETERS and `yield stress, C1, gamma1, C2, gamma2, ...`";
        draft.log.error("SL0234", message, card.span());
        return None;
    }
    let count = card.count("NUMBER BACKSTRESSES", 1, &mut draft.log);
    let numbers = card.numbers(&mut draft.log)?;
    let expected = count.saturating_mul(2).saturating_add(1);
    if numbers.len() != expected && numbers.len() != expected.saturating_add(1) {
        let message = format!(
            "{count} back stresses take {expected} numbers of one temperature, not {}",
            numbers.len()
        );
        draft.log.error("SL0234", message, card.span());
        return None;
    }
    let sound = numbers[0] > 0.0 && numbers[1..expected].iter().all(|number| *number >= 0.0);
    if !sound {
        let message = "the yield stress must be positive, moduli and recalls not negative";
        draft.log.error("SL0234", message, card.span());
        return None;
    }
    let pairs = numbers[1..expected].as_chunks::<2>().0.iter();
    let back_stresses = pairs.map(|&[modulus, recall]| BackStress::Evolving { modulus, recall });
    let table = vec![(0.0, vec![[numbers[0], 0.0]])];
    Some(Yielding { table, back_stresses: back_stresses.collect(), combined: true })
}

const DATA_TYPES: &[&str] = &["PARAMETERS", "HALF CYCLE", "STABILIZED"];

/// Yield stresses over plastic strains that start at zero and ascend, for every temperature.
pub(super) fn table(card: &Reading<'_>, draft: &mut Draft) -> Option<Table<Hardening>> {
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
    // zero is CalculiX' word for creep at any stress
    let may_vanish = draft.dialect == Dialect::Calculix;
    if stress < 0.0 || (stress == 0.0 && !may_vanish) {
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
