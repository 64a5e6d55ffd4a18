//! `*BEAM SECTION`: the section of beams.

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic};
use slideline_model::{BeamSection as ModelSection, ShearRule};

use crate::beam_shape::{SHAPES, shape};
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
            Rule::value("TEMPERATURE"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        // inertia
        &["LUMPED", "ROTARY INERTIA"]
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
        draft.owner = Owner::Broken;
        let kind = card.choice("SECTION", &SHAPES, &mut draft.log);
        let named = card.name("ELSET").zip(card.name("MATERIAL"));
        let Some((kind, (set, material))) = kind.zip(named) else { return };
        temperatures(card, draft);
        let poisson = poisson(card, draft);
        if card.first_line("the size of the section", &mut draft.log).is_none() {
            return;
        }
        let Some((shape, lines)) = shape(kind, card.data(), draft) else { return };
        // the last one, points of a section that is integrated, changes no elastic beam
        draft.log.at_most_lines(card.data(), lines + 2, self.name());
        let first_axis = first_axis(card.data().get(lines), draft);
        let (Some(poisson), Some(first_axis)) = (poisson, first_axis) else { return };
        draft.owner = Owner::Section(draft.sections.len());
        draft.sections.push(Section {
            set,
            material,
            material_span: card.span_of("MATERIAL"),
            set_span: card.span_of("ELSET"),
            body: Body::Beam {
                shape,
                poisson,
                shear: ShearRule::default(),
                first_axis,
                elastic: None,
                density: None,
            },
            orientation: None,
            origin: card.span(),
        });
    }
}

/// Temperatures are given as a value and its slopes, as `GRADIENTS` says.
fn temperatures(card: &Reading<'_>, draft: &mut Draft) {
    if card.choice("TEMPERATURE", &["GRADIENTS", "VALUES"], &mut draft.log) == Some("VALUES") {
        let message = "TEMPERATURE=VALUES of *BEAM SECTION is not supported";
        let error = Diagnostic::error(Code("SL0221"), message).at(card.span_of("TEMPERATURE"));
        let help = "leave it out, and give *TEMPERATURE as value and slope: TEMPERATURE=GRADIENTS";
        draft.log.push(error.help(help));
    }
}

/// Axis 1 of the section: the line's direction, or the default where it is blank or there is none.
pub(super) fn first_axis(line: Option<&DataLine>, draft: &mut Draft) -> Option<[f64; 3]> {
    let Some(line) = line else { return Some(ModelSection::FIRST_AXIS) };
    draft.log.at_most(line, 3);
    let mut axis = [0.0; 3];
    for (at, part) in axis.iter_mut().enumerate() {
        *part = draft.log.number_or(line, at, 0.0)?;
    }
    Some(if axis == [0.0; 3] { ModelSection::FIRST_AXIS } else { axis })
}

pub(super) fn poisson(card: &Reading<'_>, draft: &mut Draft) -> Option<f64> {
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
