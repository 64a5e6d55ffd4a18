//! `*EXPANSION`: thermal expansion of a material.

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic};
use slideline_mech::material;
use slideline_mech::material::tensor::Symmetric;
use slideline_model::Dialect;

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*EXPANSION`.
pub(crate) struct Expansion;

impl Keyword for Expansion {
    fn name(&self) -> &'static str {
        "EXPANSION"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("TYPE"), Rule::value("ZERO")];
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
        page!("EXPANSION")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.owning_material(self.name(), card.span()).is_none() {
            return;
        }
        let expansion = expansion(card, draft);
        let own = (self.name(), card.span());
        draft.give_material(own, |material| &mut material.expansion, expansion);
    }
}

fn expansion(card: &Reading<'_>, draft: &mut Draft) -> Option<material::Expansion> {
    let given = card.word("TYPE").is_some();
    let width = match card.choice("TYPE", TYPES, &mut draft.log) {
        None if given => return None,
        None | Some("ISO" | "ISOTROPIC") => 1,
        Some("ANISO" | "ANISOTROPIC") => 6,
        Some(_) => 3,
    };
    let zero = card.number("ZERO", &mut draft.log)?.unwrap_or(0.0);
    card.first_line("the coefficient of expansion", &mut draft.log)?;
    let mut table: Vec<(f64, Symmetric)> = Vec::new();
    for line in card.data() {
        let (temperature, row) = row(line, width, draft)?;
        if !draft.log.ascends(table.last().map(|last| last.0), temperature, line, width) {
            return None;
        }
        table.push((temperature, row));
    }
    Some(material::Expansion { zero, table })
}

const TYPES: &[&str] = &["ISO", "ISOTROPIC", "ORTHO", "ORTHOTROPIC", "ANISO", "ANISOTROPIC"];

/// Coefficients about the axes of the material, and their temperature.
fn row(line: &DataLine, width: usize, draft: &mut Draft) -> Option<(f64, Symmetric)> {
    draft.log.at_most(line, width + 1);
    let mut row = [0.0; 6];
    for (axis, entry) in row.iter_mut().enumerate().take(width.max(3)) {
        *entry = draft.log.number(line, axis.min(width - 1), "the coefficient of expansion")?;
    }
    angles_are_plain(line, &row, draft)?;
    Some((draft.log.number_or(line, width, 0.0)?, row))
}

/// In the dialect of CalculiX a12 is a component of the tensor; whether it is that or the whole
/// angle in the other one is nowhere said, so that it is refused there.
fn angles_are_plain(line: &DataLine, row: &Symmetric, draft: &mut Draft) -> Option<()> {
    let Some(at) = (3..6).find(|&at| row[at] != 0.0) else { return Some(()) };
    if draft.dialect == Dialect::Calculix {
        return Some(());
    }
    let message = "coefficients of expansion that shear (a12, a13, a23) are not read";
    let error = Diagnostic::error(Code("SL0221"), message).at(line.fields[at].span);
    let help = "give those along the three axes without shear: TYPE=ORTHO, with an *ORIENTATION";
    draft.log.push(error.help(help));
    None
}
