//! `*BEAM SECTION`: the section of beams.

use slideline_diag::{Code, Diagnostic};
use slideline_model::ShearRule;

use crate::draft::Draft;
use crate::draft::{Body, Owner, Section};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*BEAM SECTION`.
pub(crate) struct BeamSection;

impl Keyword for BeamSection {
    fn name(&self) -> &'static str {
        "BEAM SECTION"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::required("SECTION"),
            Rule::required("ELSET"),
            Rule::required("MATERIAL"),
            Rule::value("POISSON"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Sections
    }

    fn page(&self) -> &'static str {
        page!("BEAM-SECTION")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Some(("RECT", set, material)) = card
            .choice("SECTION", &["RECT"], &mut draft.log)
            .zip(card.name("ELSET"))
            .zip(card.name("MATERIAL"))
            .map(|((section, set), material)| (section, set, material))
        else {
            draft.owner = Owner::Broken;
            return;
        };
        draft.owner = Owner::Broken;
        let poisson = poisson(card, draft);
        let Some([width, height]) = dimensions(card, draft) else { return };
        let Some(poisson) = poisson else { return };
        draft.owner = Owner::Section(draft.sections.len());
        draft.sections.push(Section {
            set,
            material,
            material_span: card.span_of("MATERIAL"),
            set_span: card.span_of("ELSET"),
            body: Body::Beam { width, height, poisson, shear: ShearRule::default() },
            orientation: None,
            origin: card.span(),
        });
    }
}

fn poisson(card: &Reading<'_>, draft: &mut Draft) -> Option<f64> {
    let value = card.number("POISSON", &mut draft.log)?.unwrap_or(0.0);
    let span = card.span_of("POISSON");
    if !(-1.0..=0.5).contains(&value) {
        let message = format!("the section Poisson ratio {value} is not between -1 and 0.5");
        draft.log.error("SL0234", message, span);
        return None;
    }
    if value != 0.0 && draft.log.first_time("section poisson") {
        let message = format!(
            "POISSON={value} is read, but the section keeps its size: at an axial strain of 0.001 \
             this neglects {:.3} % of its area",
            100.0 * (1.0 - (-2.0 * value * 1e-3_f64).exp()).abs()
        );
        draft.log.note("SL0235", message, span);
    }
    Some(value)
}

fn dimensions(card: &Reading<'_>, draft: &mut Draft) -> Option<[f64; 2]> {
    let line = card.first_line("width, height", &mut draft.log)?;
    draft.log.at_most(line, 2);
    draft.log.at_most_lines(card.data(), 2, "BEAM SECTION");
    let width = draft.log.number(line, 0, "the width")?;
    let height = draft.log.number(line, 1, "the height")?;
    for (at, (value, name)) in [(width, "width"), (height, "height")].into_iter().enumerate() {
        if value <= 0.0 {
            let message = format!("the {name} of the section must be positive");
            draft.log.error("SL0210", message, line.fields[at].span);
            return None;
        }
    }
    if height > 5.0 * width {
        let message = format!("the section is {} times as high as wide", (height / width).round());
        let warning = Diagnostic::warning(Code("SL0233"), message).at(line.span);
        let help = "first the width out of the plane, then the height in the plane: swapped?";
        draft.log.push(warning.help(help));
    }
    Some([width, height])
}
