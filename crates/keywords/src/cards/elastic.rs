//! `*ELASTIC`: linear elasticity of a material.

use slideline_deck::DataLine;
use slideline_mech::material::{self, Unsound};

use crate::draft::{Draft, Elasticity, Table};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*ELASTIC`.
pub(crate) struct Elastic;

impl Keyword for Elastic {
    fn name(&self) -> &'static str {
        "ELASTIC"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("TYPE"), Rule::value("MODULI")];
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
        page!("ELASTIC")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.owning_material(self.name(), card.span()).is_none() {
            return;
        }
        moduli(card, draft);
        let given = card.word("TYPE").is_some();
        let elasticity = match card.choice("TYPE", TYPES, &mut draft.log) {
            None if given => None,
            None | Some("ISOTROPIC") => isotropic(card, draft).map(Elasticity::Isotropic),
            Some(kind) => anisotropic(card, kind, draft).map(|own| match kind {
                "LAMINA" => Elasticity::Ply(Box::new(own)),
                _ => Elasticity::Anisotropic(Box::new(own)),
            }),
        };
        let elasticity = elasticity.unwrap_or(Elasticity::Unread);
        let own = (self.name(), card.span());
        draft.give_material(own, |material| &mut material.elasticity, elasticity);
    }
}

/// Takes in which moduli the constants of a material that relaxes are.
pub(super) fn moduli(card: &Reading<'_>, draft: &mut Draft) {
    let known = &["LONG TERM", "INSTANTANEOUS"];
    let at_once = card.choice("MODULI", known, &mut draft.log) == Some("INSTANTANEOUS");
    if let Some(material) = draft.owning_material("ELASTIC", card.span()) {
        material.at_once |= at_once;
    }
}

/// What the constants are; CalculiX has the short names.
const TYPES: &[&str] = &[
    "ISOTROPIC",
    "ENGINEERING CONSTANTS",
    "ORTHO",
    "ORTHOTROPIC",
    "ANISO",
    "ANISOTROPIC",
    "LAMINA",
];

/// E and nu over temperature.
fn isotropic(card: &Reading<'_>, draft: &mut Draft) -> Option<Table<material::Elastic>> {
    card.first_line("E, nu", &mut draft.log)?;
    let mut table = Table::new();
    for line in card.data() {
        match (card.data(), line.field(2)) {
            // one line holds for all temperatures and all values of fields
            ([_], None) if line.fields.len() > 3 => {
                let message = "values of fields have no effect without DEPENDENCIES";
                draft.log.note("SL0257", message, line.fields[3].span);
            }
            _ => draft.log.at_most(line, 3),
        }
        let elastic = constants(line, draft)?;
        let temperature = draft.log.number_or(line, 2, 0.0)?;
        if !draft.log.ascends(table.last().map(|last| last.0), temperature, line, 2) {
            return None;
        }
        table.push((temperature, elastic));
    }
    Some(table)
}

/// E and nu, the first two values of a line.
pub(super) fn constants(line: &DataLine, draft: &mut Draft) -> Option<material::Elastic> {
    let modulus = draft.log.number(line, 0, "Young's modulus E");
    let poisson = draft.log.number_or(line, 1, 0.0);
    let (modulus, poisson) = (modulus?, poisson?);
    if modulus <= 0.0 {
        draft.log.error("SL0234", "Young's modulus must be positive", line.fields[0].span);
        return None;
    }
    if poisson <= -1.0 || poisson >= 0.5 {
        let message = format!("Poisson's ratio {poisson} is not between -1 and 0.5");
        draft.log.error("SL0234", message, line.fields[1].span);
        return None;
    }
    Some(material::Elastic { modulus, poisson })
}

/// The constants of a type; a temperature may follow, one set holds for all.
fn anisotropic(card: &Reading<'_>, kind: &str, draft: &mut Draft) -> Option<material::Anisotropic> {
    let (count, what) = match kind {
        "ENGINEERING CONSTANTS" => (9, "E1, E2, E3, nu12, nu13, nu23, G12, G13, G23"),
        "LAMINA" => (6, "E1, E2, nu12, G12, G13, G23"),
        "ANISO" | "ANISOTROPIC" => (21, "D1111, D1122, D2222, ... D2323"),
        _ => (9, "D1111, D1122, D2222, D1133, D2233, D3333, D1212, D1313, D2323"),
    };
    card.first_line(what, &mut draft.log)?;
    let mut values = card.numbers(&mut draft.log)?;
    // CalculiX' line of 21 may end with blank fields
    let blank = |values: &[f64]| values.len() > count + 1 && values.last() == Some(&0.0);
    while blank(&values) {
        values.pop();
    }
    if values.len() < count || values.len() > count + 1 {
        let message = format!("{count} constants are needed, here are {}: {what}", values.len());
        draft.log.error("SL0208", message, card.span());
        return None;
    }
    match made(kind, &values) {
        Ok(made) => Some(made),
        Err(unsound) => {
            draft.log.error("SL0234", said(unsound), card.data()[0].span);
            None
        }
    }
}

fn made(kind: &str, values: &[f64]) -> Result<material::Anisotropic, Unsound> {
    let at = |k: usize| values.get(k).copied().unwrap_or_default();
    match kind {
        "ENGINEERING CONSTANTS" => material::Anisotropic::engineering(&std::array::from_fn(at)),
        "LAMINA" => material::Anisotropic::lamina(&std::array::from_fn(at)),
        "ANISO" | "ANISOTROPIC" => {
            // column by column, each down to the diagonal
            let entry = |row: usize, column: usize| {
                let (low, high) = (row.min(column), row.max(column));
                at(high * (high + 1) / 2 + low)
            };
            material::Anisotropic::general(&std::array::from_fn(|row| {
                std::array::from_fn(|column| entry(row, column))
            }))
        }
        _ => {
            let [d11, d12, d22, d13, d23, d33] = std::array::from_fn(at);
            let block = [[d11, d12, d13], [d12, d22, d23], [d13, d23, d33]];
            material::Anisotropic::orthotropic(&block, &[at(6), at(7), at(8)])
        }
    }
}

/// The bound that constants break, in words.
fn said(unsound: Unsound) -> String {
    const NAMES: [&str; 6] = ["11", "22", "33", "12", "13", "23"];
    match unsound {
        Unsound::NotPositive(name) => format!("{name} must be positive"),
        Unsound::Ratio { name, most } => {
            let [i, j] = [&name[2..3], &name[3..4]];
            format!("{name} must be below sqrt(E{i}/E{j}) = {most:.6} in size")
        }
        Unsound::Determinant(left) => format!(
            "1 - nu12 nu21 - nu23 nu32 - nu31 nu13 - 2 nu21 nu32 nu13 = {left:.3e} must be \
             positive, with nu_ji = nu_ij Ej/Ei"
        ),
        Unsound::Energy(count) => format!(
            "the energy of the material is not positive: its moduli of the components {} are not \
             positive definite",
            NAMES[..count.min(NAMES.len())].join(", ")
        ),
    }
}
