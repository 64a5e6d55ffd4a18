//! `*SECTION PRINT`: what passes through a surface.

use slideline_deck::normalise;
use slideline_model::{SectionPrint as Print, SectionVariable};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::requests::{self, Kind, Variable};

/// `*SECTION PRINT`.
pub(crate) struct SectionPrint;

impl Keyword for SectionPrint {
    fn name(&self) -> &'static str {
        "SECTION PRINT"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::required("SURFACE"),
            Rule::value("NAME"),
            Rule::value("FREQUENCY"),
            Rule::value("AXES"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["FREQUENCYF", "TIME POINTS", "UPDATE"]
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("SECTION-PRINT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if card.choice("AXES", &["GLOBAL", "LOCAL"], &mut draft.log) == Some("LOCAL") {
            let message = "forces of a section are printed along the axes of the model";
            draft.log.warning("SL0252", message, card.span_of("AXES"));
        }
        let asked = requests::read(card, Kind::Print, &mut |_| card.has("AXES"), draft);
        let Some(surface) = card.named("SURFACE") else { return };
        if let (Some(asked), Some(step)) = (asked, draft.step()) {
            let (request, variables) = (asked.request, asked.variables);
            let name = card.name("NAME").unwrap_or_else(|| surface.name.clone());
            let (faces, shares) = (Vec::new(), Vec::new());
            let print = Print { request, name, is_tied: false, faces, shares, variables };
            step.section_prints.push((print, surface));
        }
    }
}

impl Variable for SectionVariable {
    const KIND: &'static str = "section variable";
    const KNOWN: &'static str = "SOF, SOM, SOAREA";
    const SET: &'static str = "SURFACE";
    const PRESELECTED: &'static [Self] = &[];

    /// A sum, or a component of it.
    fn named(text: &str) -> Option<Self> {
        match normalise(text).as_str() {
            "SOF" | "SOFM" | "SOF1" | "SOF2" | "SOF3" => Some(Self::SOF),
            "SOM" | "SOMM" | "SOM1" | "SOM2" | "SOM3" => Some(Self::SOM),
            "SOAREA" => Some(Self::SOAREA),
            _ => None,
        }
    }
}
