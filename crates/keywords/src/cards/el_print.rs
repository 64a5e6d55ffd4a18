//! `*EL PRINT`: tables of beams and solids.

use slideline_deck::normalise;
use slideline_model::{self as model, ElementVariable, SECTION_POINTS};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::requests::{self, Kind, Variable};

/// `*EL PRINT`.
pub(crate) struct ElPrint;

impl Keyword for ElPrint {
    fn name(&self) -> &'static str {
        "EL PRINT"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("ELSET"),
            Rule::value("FREQUENCY"),
            Rule::value("GLOBAL"),
            Rule::maybe("TOTALS"),
            Rule::maybe("SUMMARY"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        crate::requests::WITHOUT_EFFECT
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("EL-PRINT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        request(card, Kind::Print, draft);
    }
}

/// Takes in a request for results of beams and solids: section points, where numbers are
/// listed, and variables.
pub(crate) fn request(card: &Reading<'_>, kind: Kind, draft: &mut Draft) {
    let mut section_points = Vec::new();
    let mut point = |text: &str| {
        let point = section_point(text);
        section_points.extend(point.filter(|point| !section_points.contains(point)));
        point.is_some()
    };
    let own_axes = card.yes("GLOBAL", &mut draft.log) != Some(true);
    let Some(asked) = requests::read(card, kind, &mut point, draft) else { return };
    if section_points.is_empty() {
        section_points = vec![1, SECTION_POINTS];
    }
    if let Some(step) = draft.step() {
        let (request, variables) = (asked.request, asked.variables);
        let elements = Vec::new();
        let print = model::ElementPrint { request, elements, variables, section_points, own_axes };
        step.element_prints.push((print, asked.set));
    }
}

fn section_point(text: &str) -> Option<usize> {
    text.trim().parse().ok().filter(|point| (1..=SECTION_POINTS).contains(point))
}

impl Variable for ElementVariable {
    const KIND: &'static str = "variable of elements";
    const KNOWN: &'static str = "SF, SM, SE, SK, S, MISES of beams, S, E, LE, PE, PEEQ, CE, CEEQ, MISES, SP, ENER, PENER, COORD, ELSE, ELPD, EVOL of solids; numbers from 1 to 5 are section points";
    const SET: &'static str = "ELSET";
    const PRESELECTED: &'static [Self] = &[Self::SF, Self::SM, Self::S];

    fn named(text: &str) -> Option<Self> {
        let name = normalise(text);
        match name.trim_end_matches(|c: char| c.is_ascii_digit()) {
            "SF" => Some(Self::SF),
            "SM" => Some(Self::SM),
            "SE" => Some(Self::SE),
            "SK" => Some(Self::SK),
            "S" => Some(Self::S),
            "E" => Some(Self::E),
            "LE" => Some(Self::LE),
            "PE" => Some(Self::PE),
            "PEEQ" => Some(Self::PEEQ),
            "CE" => Some(Self::CE),
            "CEEQ" => Some(Self::CEEQ),
            "MISES" => Some(Self::MISES),
            "SP" => Some(Self::SP),
            "ENER" => Some(Self::ENER),
            "PENER" => Some(Self::PENER),
            "COORD" | "COOR" => Some(Self::COORD),
            "ELSE" => Some(Self::ELSE),
            "ELPD" => Some(Self::ELPD),
            "EVOL" => Some(Self::EVOL),
            _ => None,
        }
    }

    /// It has no components of what has yielded and crept, and writes how much that is.
    fn in_calculix(self) -> Self {
        match self {
            Self::PE => Self::PEEQ,
            Self::CE => Self::CEEQ,
            own => own,
        }
    }
}
