//! `*HYPERELASTIC`: rubber, from coefficients or from test data.

use slideline_deck::DataLine;
use slideline_diag::Span;
use slideline_mech::material::hyperelastic::Form;
use slideline_mech::material::{MOST_TERMS, Rubber};
use slideline_model::Dialect;

use crate::draft::{Draft, Elasticity, Table, Wanted};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*HYPERELASTIC`.
pub(crate) struct Hyperelastic;

/// The forms, each a parameter without value.
const FORMS: [&str; 7] = [
    "NEO HOOKE",
    "MOONEY-RIVLIN",
    "YEOH",
    "POLYNOMIAL",
    "REDUCED POLYNOMIAL",
    "OGDEN",
    "ARRUDA-BOYCE",
];

/// Ratio of bulk to shear modulus of a rubber that the deck calls incompressible [1].
const INCOMPRESSIBLE: f64 = 1e4;
/// The same as CalculiX has it, measured with ccx 2.20.
const OF_CALCULIX: f64 = 20.0;

impl Keyword for Hyperelastic {
    fn name(&self) -> &'static str {
        "HYPERELASTIC"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::flag("NEO HOOKE"),
            Rule::flag("MOONEY-RIVLIN"),
            Rule::flag("YEOH"),
            Rule::flag("POLYNOMIAL"),
            Rule::flag("REDUCED POLYNOMIAL"),
            Rule::flag("OGDEN"),
            Rule::flag("ARRUDA-BOYCE"),
            Rule::value("N"),
            Rule::flag("TEST DATA INPUT"),
            Rule::value("POISSON"),
            Rule::value("MODULI"),
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
        page!("HYPERELASTIC")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.owning_material(self.name(), card.span()).is_none() {
            return;
        }
        super::elastic::moduli(card, draft);
        let elasticity = match card.has("TEST DATA INPUT") {
            true => wanted(card, draft).map(Elasticity::Tested),
            false => read(card, draft).map(Elasticity::Rubber),
        };
        let elasticity = elasticity.unwrap_or(Elasticity::Unread);
        let own = (self.name(), card.span());
        draft.give_material(own, |material| &mut material.elasticity, elasticity);
    }
}

/// The form and its order.
fn form(card: &Reading<'_>, draft: &mut Draft) -> Option<(&'static str, usize)> {
    let given: Vec<&str> = FORMS.into_iter().filter(|form| card.has(form)).collect();
    let form = match *given {
        [] => "POLYNOMIAL",
        [form] => form,
        _ => {
            let message = format!("a rubber has one form, here are {}", given.join(", "));
            draft.log.error("SL0234", message, card.span());
            return None;
        }
    };
    let order = card.at_least(1, "N", 1, &mut draft.log);
    if order > MOST_TERMS {
        let message = format!("at most {MOST_TERMS} terms are read, here are {order}");
        draft.log.error("SL0234", message, card.span_of("N"));
        return None;
    }
    Some((form, order))
}

/// Rubbers from their coefficients.
fn read(card: &Reading<'_>, draft: &mut Draft) -> Option<Table<Rubber>> {
    let form = form(card, draft)?;
    if card.has("POISSON") {
        let message = "POISSON belongs to TEST DATA INPUT: here D1 gives the change of volume";
        draft.log.error("SL0282", message, card.span_of("POISSON"));
        return None;
    }
    card.first_line("the coefficients", &mut draft.log)?;
    table(form, card, draft)
}

/// Numbers on a data line.
const LINE: usize = 8;

/// Rubbers over temperature: every set of coefficients begins on a line of its own.
fn table(form: (&str, usize), card: &Reading<'_>, draft: &mut Draft) -> Option<Table<Rubber>> {
    let (shapes, volumes) = counts(form);
    let lines = (shapes + volumes + 1).div_ceil(LINE);
    let mut table = Table::new();
    for set in card.data().chunks(lines) {
        let fields = set.iter().flat_map(|line| (0..line.fields.len()).map(move |k| (line, k)));
        let read: Vec<_> = fields.map(|(line, k)| draft.log.number_or(line, k, 0.0)).collect();
        let values = read.into_iter().collect::<Option<Vec<f64>>>()?;
        let temperature = values.get(shapes + volumes).copied().unwrap_or(0.0);
        let last = &set[set.len() - 1];
        let at = last.fields.len().saturating_sub(1);
        if !draft.log.ascends(table.last().map(|own: &(f64, Rubber)| own.0), temperature, last, at)
        {
            return None;
        }
        table.push((temperature, rubber(form, &values, (card, set), draft)?));
    }
    Some(table)
}

/// A rubber that test data are to give.
fn wanted(card: &Reading<'_>, draft: &mut Draft) -> Option<Wanted> {
    let (name, order) = form(card, draft)?;
    if let Some(line) = card.data().first() {
        let message = "the law comes from test data, and here are coefficients as well";
        draft.log.error("SL0282", message, line.span);
        return None;
    }
    let poisson = card.number("POISSON", &mut draft.log)?;
    if poisson.is_some_and(|own| own <= -1.0 || own > 0.5) {
        let message = "Poisson's ratio of a rubber lies above -1 and at most at 0.5";
        draft.log.error("SL0234", message, card.span_of("POISSON"));
        return None;
    }
    let form = match name {
        "OGDEN" => Form::Ogden(order),
        "ARRUDA-BOYCE" => Form::ArrudaBoyce,
        _ => Form::Polynomial(powers(name, order)),
    };
    let (_, volumes) = counts((name, order));
    Some(Wanted { form, volumes, poisson })
}

/// How many numbers a form has: of shape, and of volume.
fn counts((form, order): (&str, usize)) -> (usize, usize) {
    let shapes = match form {
        "OGDEN" => 2 * order,
        "ARRUDA-BOYCE" => 2,
        _ => powers(form, order).len(),
    };
    let volumes = match form {
        "YEOH" => 3,
        "OGDEN" | "POLYNOMIAL" | "REDUCED POLYNOMIAL" => order,
        _ => 1,
    };
    (shapes, volumes)
}

/// The rubber of a form; complains where it has no stiffness at small strain.
fn rubber(
    (form, order): (&str, usize),
    values: &[f64],
    (card, set): (&Reading<'_>, &[DataLine]),
    draft: &mut Draft,
) -> Option<Rubber> {
    let (shapes, volumes) = counts((form, order));
    if values.len() > shapes + volumes + 1 || values.len() < shapes {
        let message = format!("{} numbers are needed, here are {}", shapes + volumes, values.len());
        draft.log.error("SL0208", message, card.span());
        return None;
    }
    let of = |k: usize| values.get(k).copied().unwrap_or(0.0);
    let mut volume = [0.0; MOST_TERMS];
    for (k, inverse) in volume.iter_mut().enumerate().take(volumes) {
        let d = of(shapes + k);
        *inverse = if d == 0.0 { 0.0 } else { 1.0 / d };
    }
    let made = match form {
        "OGDEN" => Rubber::Ogden {
            terms: (0..order).map(|k| [of(2 * k), of(2 * k + 1)]).collect(),
            volume,
        },
        "ARRUDA-BOYCE" => Rubber::ArrudaBoyce { shear: of(0), locking: of(1), volume: volume[0] },
        _ => {
            let powers = powers(form, order);
            let terms = powers.iter().enumerate().map(|(k, &(i, j))| (i, j, of(k))).collect();
            Rubber::Polynomial { terms, volume }
        }
    };
    sound(made, set.first().map_or(card.span(), |line| line.span), draft)
}

/// Powers of I1 - 3 and I2 - 3 in the order of the deck.
fn powers(form: &str, order: usize) -> Vec<(u8, u8)> {
    let most = u8::try_from(order).unwrap_or(u8::MAX);
    match form {
        "NEO HOOKE" => vec![(1, 0)],
        "MOONEY-RIVLIN" => vec![(1, 0), (0, 1)],
        "YEOH" => vec![(1, 0), (2, 0), (3, 0)],
        "REDUCED POLYNOMIAL" => (1..=most).map(|i| (i, 0)).collect(),
        "POLYNOMIAL" => (1..=most).flat_map(|n| (0..=n).map(move |j| (n - j, j))).collect(),
        _ => Vec::new(),
    }
}

/// The rubber with a bulk modulus; `None` where it has no positive shear modulus.
pub(crate) fn sound(made: Rubber, line: Span, draft: &mut Draft) -> Option<Rubber> {
    let finite = !matches!(&made, Rubber::Ogden { terms, .. } if terms.iter().any(|t| t[1] == 0.0))
        && !matches!(&made, Rubber::ArrudaBoyce { locking, .. } if *locking <= 0.0);
    let shear = if finite { made.shear_modulus() } else { 0.0 };
    if !(shear > 0.0 && shear.is_finite()) {
        let message = "these coefficients give no positive shear modulus at small strain";
        draft.log.error("SL0234", message, line);
        return None;
    }
    let bulk = made.bulk_modulus();
    if bulk < 0.0 {
        draft.log.error("SL0234", "D1 must not be negative", line);
        return None;
    }
    if bulk > 0.0 {
        return Some(made);
    }
    let message = "an incompressible rubber is taken as next to incompressible";
    let ratio = match draft.model.dialect {
        Dialect::Abaqus => INCOMPRESSIBLE,
        Dialect::Calculix => OF_CALCULIX,
    };
    let help = format!(
        "its bulk modulus is {ratio} times its shear modulus; give D1 = 2/K for another one"
    );
    let note = slideline_diag::Diagnostic::note(slideline_diag::Code("SL0272"), message);
    draft.log.push(note.at(line).help(help));
    let inverse = 0.5 * ratio * shear;
    Some(match made {
        Rubber::Polynomial { terms, mut volume } => {
            volume[0] = inverse;
            Rubber::Polynomial { terms, volume }
        }
        Rubber::Ogden { terms, mut volume } => {
            volume[0] = inverse;
            Rubber::Ogden { terms, volume }
        }
        Rubber::ArrudaBoyce { shear, locking, .. } => {
            Rubber::ArrudaBoyce { shear, locking, volume: inverse }
        }
    })
}
