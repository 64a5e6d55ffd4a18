//! `*SOLID SECTION`: the thickness of solids.

use crate::draft::{Body, Draft, Owner, Section};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*SOLID SECTION`.
pub(crate) struct SolidSection;

impl Keyword for SolidSection {
    fn name(&self) -> &'static str {
        "SOLID SECTION"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::required("ELSET"),
            Rule::required("MATERIAL"),
            Rule::value("ORIENTATION"),
            Rule::flag("NODAL THICKNESS"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        // hourglass control, layers of a stack, the offset of an area in its own plane
        &["CONTROLS", "STACK DIRECTION", "SYMMETRIC", "LAYUP", "ORDER", "OFFSET"]
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Sections
    }

    fn page(&self) -> &'static str {
        page!("SOLID-SECTION")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.owner = Owner::Broken;
        let Some((set, material)) = card.name("ELSET").zip(card.name("MATERIAL")) else { return };
        let Some(thickness) = thickness(card, draft) else { return };
        draft.owner = Owner::Section(draft.sections.len());
        draft.sections.push(Section {
            set,
            material,
            material_span: card.span_of("MATERIAL"),
            set_span: card.span_of("ELSET"),
            body: Body::Solid { thickness, by_nodes: card.has("NODAL THICKNESS") },
            orientation: card.name("ORIENTATION").map(|name| (name, card.span_of("ORIENTATION"))),
            origin: card.span(),
        });
    }
}

/// The thickness out of the plane [L], if it is given; `None` after an error.
fn thickness(card: &Reading<'_>, draft: &mut Draft) -> Option<Option<f64>> {
    let Some(line) = card.data().first() else { return Some(None) };
    draft.log.at_most_lines(card.data(), 1, "SOLID SECTION");
    if let Some(more) = line.fields.get(1) {
        let message = "numbers behind the thickness have no effect on solids and are ignored";
        draft.log.note("SL0257", message, more.span);
    }
    let thickness = draft.log.maybe_number(line, 0)?;
    if thickness.is_some_and(|own| own <= 0.0) {
        let message = "the thickness of the section must be positive";
        draft.log.error("SL0210", message, line.fields[0].span);
        return None;
    }
    Some(thickness)
}
