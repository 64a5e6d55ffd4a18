//! `*CONTACT PAIR`: which surfaces meet, and how their contact is sampled.

use slideline_deck::{DataLine, normalise};
use slideline_diag::{Code, Diagnostic};
use slideline_model::Formulation;

use super::slide_line::{extension, smooth};
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::log::Log;
use crate::reading::Reading;
use crate::surfaces::{Named, Pairing};

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
            Rule::value("HCRIT"),
            Rule::flag("SMALL SLIDING"),
        ];
        RULES
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
        unsupported(card, draft);
        let known = &["NODE TO SURFACE", "SURFACE TO SURFACE"];
        let formulation = match card.choice("TYPE", known, &mut draft.log) {
            Some("SURFACE TO SURFACE") => Formulation::SurfaceToSurface,
            _ => Formulation::NodeToSurface,
        };
        let smooth = smooth(card, DEFAULT_SMOOTH, draft);
        let extension = extension(card, draft);
        let Some(name) = card.name("INTERACTION") else { return };
        let interaction = Named { name, span: card.span_of("INTERACTION") };
        if card.first_line("slave surface, master surface", &mut draft.log).is_none() {
            return;
        }
        let given = ["SMOOTH", "EXTENSION ZONE"].into_iter().find(|name| card.has(name));
        for line in card.data() {
            draft.log.at_most(line, 2);
            let slave = surface(line, 0, "the slave surface", &mut draft.log);
            let master = surface(line, 1, "the master surface", &mut draft.log);
            let Some((slave, master)) = slave.zip(master) else { continue };
            draft.pairings.push(Pairing {
                slave,
                master,
                interaction: interaction.clone(),
                formulation,
                smooth,
                extension,
                chain_parameter: given.map(|name| (name, card.span_of(name))),
                no_thickness: card.has("NO THICKNESS"),
                origin: line.span,
            });
        }
    }
}

/// `SMOOTH` of a contact pair where it is absent (manual).
const DEFAULT_SMOOTH: f64 = 0.2;

fn surface(line: &DataLine, at: usize, what: &str, log: &mut Log) -> Option<Named> {
    let Some(field) = line.field(at) else {
        let span = line.fields.get(at).map_or(line.end(), |field| field.span);
        log.error("SL0119", format!("{what} is missing"), span);
        return None;
    };
    Some(Named { name: normalise(&field.text), span: field.span })
}

/// Parameters that would give another problem if they were passed over.
fn unsupported(card: &Reading<'_>, draft: &mut Draft) {
    let refused = [
        (
            "ADJUST",
            "leave it out: nodes keep their coordinates, and an overclosure at the start is \
             resolved in the first increment, with strain; or change the coordinates of the nodes",
        ),
        (
            "HCRIT",
            "leave it out: an increment that does not converge is cut; to bound the penetration \
             give *STATIC a largest time increment",
        ),
        ("SMALL SLIDING", "leave it out: sliding is always finite here"),
    ];
    for (name, help) in refused {
        if card.has(name) {
            let message = format!("{name} of *CONTACT PAIR is not supported");
            let error = Diagnostic::error(Code("SL0221"), message).at(card.span_of(name));
            draft.log.push(error.help(help));
        }
    }
}
