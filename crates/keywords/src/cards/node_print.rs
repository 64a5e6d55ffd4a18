//! `*NODE PRINT`: tables of nodal values.

use slideline_deck::normalise;
use slideline_model::{self as model, NodeVariable};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::requests::{self, Kind, Variable};

/// `*NODE PRINT`.
pub(crate) struct NodePrint;

impl Keyword for NodePrint {
    fn name(&self) -> &'static str {
        "NODE PRINT"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("NSET"),
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
        page!("NODE-PRINT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        request(card, Kind::Print, draft);
    }
}

/// Takes in a request for nodal values.
pub(crate) fn request(card: &Reading<'_>, kind: Kind, draft: &mut Draft) {
    let asked = requests::read(card, kind, &mut |_| false, draft);
    // tables are along the axes of the nodes, files along those of the model
    let own_axes = match card.yes("GLOBAL", &mut draft.log) {
        Some(global) => !global,
        None => kind == Kind::Print,
    };
    if let (Some(asked), Some(step)) = (asked, draft.step()) {
        let (request, variables) = (asked.request, asked.variables);
        let print = model::NodePrint { request, nodes: Vec::new(), variables, own_axes };
        step.prints.push((print, asked.set));
    }
}

impl Variable for NodeVariable {
    const KIND: &'static str = "nodal variable";
    const KNOWN: &'static str = "U, RF, CF, COORD, NT";
    const SET: &'static str = "NSET";
    const PRESELECTED: &'static [Self] = &[Self::U, Self::RF];

    fn named(text: &str) -> Option<Self> {
        let name = normalise(text);
        match name.trim_end_matches(|c: char| c.is_ascii_digit()) {
            "U" | "UR" | "UT" => Some(Self::U),
            "RF" | "RM" | "RT" => Some(Self::RF),
            "CF" | "CM" => Some(Self::CF),
            "COORD" | "COOR" => Some(Self::COORD),
            "NT" => Some(Self::NT),
            _ => None,
        }
    }
}
