//! `*FRICTION`: law of friction of a contact.

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic};
use slideline_model::{self as model, Decay, Dialect, StickRule};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*FRICTION`.
pub(crate) struct Friction;

impl Keyword for Friction {
    fn name(&self) -> &'static str {
        "FRICTION"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("SLIP TOLERANCE"),
            Rule::value("ELASTIC SLIP"),
            Rule::flag("LAGRANGE"),
            Rule::flag("ROUGH"),
            Rule::value("TAUMAX"),
            Rule::flag("EXPONENTIAL DECAY"),
            Rule::flag("ANISOTROPIC"),
            Rule::value("USER"),
            Rule::value("PROPERTIES"),
            Rule::value("DEPVAR"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::Both
    }

    fn subject(&self) -> Subject {
        Subject::Contact
    }

    fn is_suboption(&self) -> bool {
        true
    }
    fn page(&self) -> &'static str {
        page!("FRICTION")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let span = card.span();
        if draft.owning_interaction(self.name(), span).is_none() {
            return;
        }
        exclusions(card, draft);
        let law = law(card, draft);
        let Some((interaction, owner)) = draft.owning_interaction(self.name(), span) else {
            return;
        };
        let before = interaction.friction_origin.replace(span);
        if let Some(law) = law {
            interaction.friction = law;
        }
        if let Some(before) = before {
            let message = format!("a second *FRICTION for one {owner}");
            let error = Diagnostic::error(Code("SL0242"), message);
            draft.log.push(error.at(span).label(before, "the first one"));
        }
    }
}

/// Parameters that exclude one another. [semantics: friction]
fn exclusions(card: &Reading<'_>, draft: &mut Draft) {
    let kinds = ["LAGRANGE", "ROUGH", "ELASTIC SLIP", "SLIP TOLERANCE", "USER"];
    let given: Vec<&str> = kinds.into_iter().filter(|name| card.has(name)).collect();
    if given.len() > 1 {
        let message = format!("{} exclude one another", given.join(" and "));
        draft.log.error("SL0215", message, card.span_of(given[1]));
    }
    for (first, second) in [
        ("EXPONENTIAL DECAY", "TAUMAX"),
        ("ROUGH", "TAUMAX"),
        ("ROUGH", "EXPONENTIAL DECAY"),
        ("USER", "TAUMAX"),
        ("USER", "EXPONENTIAL DECAY"),
        ("ANISOTROPIC", "ROUGH"),
        ("ANISOTROPIC", "USER"),
        ("ANISOTROPIC", "EXPONENTIAL DECAY"),
    ] {
        if card.has(first) && card.has(second) {
            let message = format!("{first} and {second} exclude one another");
            draft.log.error("SL0215", message, card.span_of(second));
        }
    }
    for name in ["PROPERTIES", "DEPVAR"] {
        if card.has(name) && !card.has("USER") {
            let message = format!("{name} belongs to USER");
            draft.log.error("SL0215", message, card.span_of(name));
        }
    }
}

fn law(card: &Reading<'_>, draft: &mut Draft) -> Option<model::Friction> {
    if card.has("USER") {
        return user(card, draft);
    }
    if card.has("ROUGH") {
        draft.log.at_most_lines(card.data(), 0, "FRICTION, ROUGH");
        return Some(model::Friction::Rough);
    }
    coulomb(card, draft)
}

fn coulomb(card: &Reading<'_>, draft: &mut Draft) -> Option<model::Friction> {
    let limit = positive(card, "TAUMAX", true, draft);
    let line = card.first_line("the coefficient of friction", &mut draft.log)?;
    if let Some(second) = card.data().get(1) {
        varies(second, draft);
        return None;
    }
    let stick = stick_rule(card, line, draft);
    let coefficient = coefficient(line, 0, draft);
    let decay = if card.has("EXPONENTIAL DECAY") {
        draft.log.at_most(line, 3);
        Some(decay(line, coefficient, draft)?)
    } else {
        let two = card.has("ANISOTROPIC") || draft.dialect == Dialect::Calculix;
        draft.log.at_most(line, if two { 2 } else { 1 });
        None
    };
    let second = match card.has("ANISOTROPIC") {
        true => Some(self::coefficient(line, 1, draft)?),
        false => None,
    };
    let coefficient = coefficient?;
    let law = model::Friction::Coulomb { coefficient, second, limit: limit?, decay, stick: stick? };
    Some(if law.acts() { law } else { model::Friction::Frictionless })
}

/// A table of coefficients: refused under its own name.
fn varies(second: &DataLine, draft: &mut Draft) {
    let message = "a coefficient of friction that depends on slip rate, pressure or temperature is not supported: \
                   one data line";
    let error = Diagnostic::error(Code("SL0221"), message).at(second.span);
    draft.log.push(error.help(
        "give one coefficient, that of the pressures of the part; one that falls with the slip rate is \
         EXPONENTIAL DECAY with `mu_s, mu_k, d`, a limit of the shear stress TAUMAX",
    ));
}

fn coefficient(line: &DataLine, at: usize, draft: &mut Draft) -> Option<f64> {
    let value = draft.log.number(line, at, "the coefficient of friction")?;
    let span = line.fields[at].span;
    if value < 0.0 {
        draft.log.error(
            "SL0216",
            format!("the coefficient of friction is negative: {value}"),
            span,
        );
        return None;
    }
    if value > 10.0 {
        let message = format!("a coefficient of friction of {value} is very large");
        let warning = Diagnostic::warning(Code("SL0217"), message).at(span);
        draft.log.push(warning.help("ROUGH forbids slip altogether"));
    }
    Some(value)
}

fn decay(line: &DataLine, fixed: Option<f64>, draft: &mut Draft) -> Option<Decay> {
    let kinetic = coefficient(line, 1, draft);
    let rate = draft.log.number(line, 2, "the decay constant");
    let (kinetic, rate) = (kinetic?, rate?);
    if rate < 0.0 {
        draft.log.error("SL0210", "the decay constant must not be negative", line.fields[2].span);
    }
    if fixed.is_some_and(|fixed| kinetic > fixed) {
        let message = "the kinetic coefficient is larger than the static one";
        draft.log.warning("SL0210", message, line.fields[1].span);
    }
    Some(Decay { kinetic, rate })
}

/// How sticking is imposed; CalculiX has its stick slope behind the coefficient.
fn stick_rule(card: &Reading<'_>, line: &DataLine, draft: &mut Draft) -> Option<StickRule> {
    if card.has("LAGRANGE") {
        return Some(StickRule::Lagrange);
    }
    if draft.dialect == Dialect::Calculix
        && line.field(1).is_some()
        && !card.has("EXPONENTIAL DECAY")
        && !card.has("ANISOTROPIC")
    {
        let slope = draft.log.number(line, 1, "the stick slope")?;
        if slope <= 0.0 {
            let message = "the stick slope, traction by slip, must be positive";
            draft.log.error("SL0210", message, line.fields[1].span);
            return None;
        }
        return Some(StickRule::Slope(slope));
    }
    if let Some(slip) = positive(card, "ELASTIC SLIP", false, draft)? {
        return Some(StickRule::ElasticSlip(slip));
    }
    let tolerance = positive(card, "SLIP TOLERANCE", false, draft)?;
    Some(tolerance.map_or_else(StickRule::default, StickRule::SlipTolerance))
}

/// A parameter that must be positive; where `zero_is_none`, zero stands for
/// "none".
fn positive(
    card: &Reading<'_>,
    name: &str,
    zero_is_none: bool,
    draft: &mut Draft,
) -> Option<Option<f64>> {
    let value = card.number(name, &mut draft.log)?;
    match value {
        Some(0.0) if zero_is_none => Some(None),
        Some(value) if value <= 0.0 => {
            let message = format!("{name} must be positive");
            draft.log.error("SL0210", message, card.span_of(name));
            None
        }
        _ => Some(value),
    }
}

/// A law of the embedding program, by name; eight constants a line.
fn user(card: &Reading<'_>, draft: &mut Draft) -> Option<model::Friction> {
    let name = card.name("USER")?;
    let state_size = if card.has("DEPVAR") { card.count("DEPVAR", 0, &mut draft.log) } else { 0 };
    let mut properties = Vec::new();
    for line in card.data() {
        draft.log.at_most(line, 8);
        for at in 0..line.fields.len().min(8) {
            properties.push(draft.log.number_or(line, at, 0.0)?);
        }
    }
    let expected = card.count("PROPERTIES", properties.len(), &mut draft.log);
    if expected != properties.len() {
        let message = format!("PROPERTIES={expected}, but {} values follow", properties.len());
        draft.log.error("SL0208", message, card.span_of("PROPERTIES"));
        return None;
    }
    Some(model::Friction::User { name, properties, state_size })
}
