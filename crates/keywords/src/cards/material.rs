//! `*MATERIAL`: opens a material.

use slideline_diag::{Code, Diagnostic};

use crate::draft;
use crate::draft::Draft;
use crate::draft::Owner;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*MATERIAL`.
pub(crate) struct Material;

impl Keyword for Material {
    fn name(&self) -> &'static str {
        "MATERIAL"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("NAME")];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["DESCRIPTION", "RTOL", "SRATE FACTOR", "STRAIN RATE REGULARIZATION"]
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Sections
    }

    fn page(&self) -> &'static str {
        page!("MATERIAL")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        let Some(name) = card.name("NAME") else { return };
        if let Some(old) = draft.materials.iter().find(|old| old.name == name) {
            let message = format!("the material {name} is defined twice");
            let error = Diagnostic::error(Code("SL0250"), message).at(card.span_of("NAME"));
            let error = error.label(old.origin, "defined here first");
            draft.log.push(error);
        }
        draft.owner = Owner::Material(draft.materials.len());
        let origin = card.span();
        draft.materials.push(draft::Material::new(name, origin));
    }
}
