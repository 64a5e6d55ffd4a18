//! `*CONTACT PAIR`: which surfaces meet, and how their contact is sampled.

use slideline_deck::{DataLine, normalise};
use slideline_diag::Span;
use slideline_model::{Dialect, Formulation};

use super::slide_line::{extension, smooth};
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::log::Log;
use crate::log::Target;
use crate::reading::Reading;
use crate::surfaces::{Adjusted, Named, Pairing};

/// `*CONTACT PAIR`.
pub(crate) struct ContactPair;

impl Keyword for ContactPair {
    fn name(&self) -> &'static str {
        "CONTACT PAIR"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::required("INTERACTION"),
            Rule::value("TYPE"),
            Rule::value("SMOOTH"),
            Rule::value("EXTENSION ZONE"),
            Rule::flag("NO THICKNESS"),
            Rule::value("ADJUST"),
            Rule::flag("SMALL SLIDING"),
            Rule::flag("TIED"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &[
            "MINIMUM DISTANCE",
            "MECHANICAL CONSTRAINT",
            "HCRIT",
            "CPSET",
            "TRACKING",
            "SUPPLEMENTARY CONSTRAINTS",
            "SLIDING TRANSITION",
        ]
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Contact
    }

    fn page(&self) -> &'static str {
        page!("CONTACT-PAIR")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if card.has("SMALL SLIDING") {
            let message = "SMALL SLIDING: sliding is finite here, of which small sliding is a part";
            draft.log.note("SL0257", message, card.span_of("SMALL SLIDING"));
        }
        let formulation = formulation(card, draft);
        let adjust = adjust(card, &mut draft.log);
        // that program knows no rounding
        let absent = (draft.dialect == Dialect::Calculix).then_some(0.0);
        let smooth = smooth(card, draft).or(absent);
        let extension = extension(card, draft);
        let Some(interaction) = card.named("INTERACTION") else { return };
        if card.first_line("slave surface, master surface", &mut draft.log).is_none() {
            return;
        }
        let given = ["SMOOTH", "EXTENSION ZONE"].into_iter().find(|name| card.has(name));
        for line in card.data() {
            draft.log.at_most(line, 4);
            let slave = surface(line, 0, "the slave surface", &mut draft.log);
            let Some(slave) = slave else { continue };
            // one surface alone meets itself
            let alone = line.field(1).is_none();
            let master = match alone {
                true => slave.clone(),
                false => match surface(line, 1, "the master surface", &mut draft.log) {
                    Some(master) => master,
                    None => continue,
                },
            };
            draft.pairings.push(Pairing {
                slave,
                master,
                interaction: interaction.clone(),
                formulation,
                smooth,
                extension,
                alone,
                chain_parameter: given.map(|name| (name, card.span_of(name))),
                adjust: adjust.clone(),
                no_thickness: card.has("NO THICKNESS"),
                is_tied: card.has("TIED"),
                axes: [2, 3].map(|at| line.field(at).map(|own| (normalise(&own.text), own.span))),
                left_out: Vec::new(),
                origin: line.span,
            });
        }
    }
}

/// A surface named at a place of a line; complains where it is missing.
pub(super) fn surface(line: &DataLine, at: usize, what: &str, log: &mut Log) -> Option<Named> {
    let Some(field) = line.field(at) else {
        let span = line.fields.get(at).map_or(line.end(), |field| field.span);
        log.error("SL0119", format!("{what} is missing"), span);
        return None;
    };
    Some(Named { name: normalise(&field.text), span: field.span })
}

/// Where contact is sampled, by `TYPE`.
fn formulation(card: &Reading<'_>, draft: &mut Draft) -> Formulation {
    let known = &[
        "NODE TO SURFACE",
        "SURFACE TO SURFACE",
        "MORTAR",
        "LINMORTAR",
        "PGLINMORTAR",
        "MASSLESS",
    ];
    match card.choice("TYPE", known, &mut draft.log) {
        Some("MASSLESS") => {
            let message = "TYPE=MASSLESS: without time in it this is hard contact at the nodes";
            draft.log.note("SL0257", message, card.span_of("TYPE"));
            Formulation::NodeToSurface
        }
        None | Some("NODE TO SURFACE") => Formulation::NodeToSurface,
        Some(_) => Formulation::SurfaceToSurface,
    }
}

/// A distance, or the name of a set of nodes.
fn adjust(card: &Reading<'_>, log: &mut Log) -> Option<(Adjusted, Span)> {
    let word = card.word("ADJUST")?;
    let span = card.span_of("ADJUST");
    if !word.raw.starts_with(|first: char| first.is_ascii_digit() || "+-.".contains(first)) {
        return Some((Adjusted::Set(Target::Set(normalise(&word.raw))), span));
    }
    let within = card.number("ADJUST", log)??;
    if within < 0.0 {
        log.error("SL0210", "ADJUST must not be negative", span);
        return None;
    }
    Some((Adjusted::Within(within), span))
}
