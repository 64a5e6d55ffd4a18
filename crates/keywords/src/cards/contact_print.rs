//! `*CONTACT PRINT`: tables of contact results.

use slideline_deck::normalise;
use slideline_model::{self as model, ContactVariable};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::requests::{self, Kind, Variable};

/// `*CONTACT PRINT`.
pub(crate) struct ContactPrint;

impl Keyword for ContactPrint {
    fn name(&self) -> &'static str {
        "CONTACT PRINT"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("NSET"),
            Rule::value("FREQUENCY"),
            Rule::maybe("TOTALS"),
            Rule::maybe("SUMMARY"),
            Rule::value("SLAVE"),
            Rule::value("MASTER"),
            Rule::value("SET"),
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
        page!("CONTACT-PRINT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if card.has("SET") {
            let message = "SET changes nothing here: NSET names nodes";
            draft.log.note("SL0253", message, card.span_of("SET"));
        }
        request(card, Kind::Print, draft);
    }
}

/// Takes in a request for contact results.
pub(crate) fn request(card: &Reading<'_>, kind: Kind, draft: &mut Draft) {
    let asked = requests::read(card, kind, &mut |_| false, draft);
    if let (Some(asked), Some(step)) = (asked, draft.step()) {
        let (request, variables) = (asked.request, asked.variables);
        let surfaces = ["SLAVE", "MASTER"].map(|side| card.name(side).unwrap_or_default());
        let print = model::ContactPrint { request, nodes: Vec::new(), surfaces, variables };
        step.contact_prints.push((print, asked.set));
    }
}

impl Variable for ContactVariable {
    const KIND: &'static str = "contact variable";
    const KNOWN: &'static str =
        "CSTRESS, CDISP, CFORCE; of pairs CFN, CFS, CFT, CMN, CMS, CMT, CAREA, CNUM, CELS";
    const SET: &'static str = "NSET";
    const PRESELECTED: &'static [Self] = &[Self::CSTRESS, Self::CDISP];

    /// Abaqus' words and CalculiX' shorter ones, or a component.
    fn named(text: &str) -> Option<Self> {
        match normalise(text).as_str() {
            "CSTRESS" | "CSTR" | "CPRESS" | "CSHEAR1" => Some(Self::CSTRESS),
            "CDISP" | "CDIS" | "COPEN" | "CSLIP1" => Some(Self::CDISP),
            "CFORCE" | "CNORMF" | "CSHEARF" => Some(Self::CFORCE),
            "CFN" | "CFNM" | "CFN1" | "CFN2" | "CFN3" => Some(Self::CFN),
            "CFS" | "CFSM" | "CFS1" | "CFS2" | "CFS3" => Some(Self::CFS),
            "CF" | "CFT" | "CFTM" | "CFT1" | "CFT2" | "CFT3" => Some(Self::CFT),
            "CMN" | "CMNM" | "CMN1" | "CMN2" | "CMN3" => Some(Self::CMN),
            "CMS" | "CMSM" | "CMS1" | "CMS2" | "CMS3" => Some(Self::CMS),
            "CMT" | "CMTM" | "CMT1" | "CMT2" | "CMT3" => Some(Self::CMT),
            "CAREA" => Some(Self::CAREA),
            "CELS" => Some(Self::CELS),
            "CNUM" => Some(Self::CNUM),
            _ => None,
        }
    }
}
