//! `*BEAM GENERAL SECTION`: the section of beams with moduli of its own, of one size or from end to end of
//! each element.

use slideline_deck::DataLine;
use slideline_mech::material::Elastic;
use slideline_model::{Shape, ShearRule};

use super::beam_section::{first_axis, poisson};
use crate::beam_shape::{SHAPES, shape};
use crate::draft::Draft;
use crate::draft::{Body, Owner, Section};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*BEAM GENERAL SECTION`.
pub(crate) struct BeamGeneralSection;

const GENERAL: &str = "GENERAL";

const KINDS: [&str; SHAPES.len() + 1] = {
    let mut kinds = [GENERAL; SHAPES.len() + 1];
    let mut place = 0;
    while place < SHAPES.len() {
        kinds[place + 1] = SHAPES[place];
        place += 1;
    }
    kinds
};

impl Keyword for BeamGeneralSection {
    fn name(&self) -> &'static str {
        "BEAM GENERAL SECTION"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("SECTION"),
            Rule::required("ELSET"),
            Rule::value("POISSON"),
            Rule::value("MATERIAL"),
            Rule::value("DENSITY"),
            Rule::flag("TAPER"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["LUMPED", "ZERO", "ROTARY INERTIA"]
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Sections
    }

    fn page(&self) -> &'static str {
        page!("BEAM-GENERAL-SECTION")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.owner = Owner::Broken;
        let kind = match card.choice("SECTION", &KINDS, &mut draft.log) {
            None if card.has("SECTION") => return,
            kind => kind.unwrap_or(GENERAL),
        };
        let Some(set) = card.name("ELSET") else { return };
        let poisson = poisson(card, draft);
        let density = density(card, draft);
        if card.first_line("A, I11, I12, I22, J", &mut draft.log).is_none() {
            return;
        }
        let found = match card.has("TAPER") {
            true => tapered((card, kind), draft),
            false => one_end(kind, card.data(), draft),
        };
        let Some((shape, lines)) = found else { return };
        draft.log.at_most_lines(card.data(), lines + 2, self.name());
        let material = card.name("MATERIAL");
        let elastic = match material {
            Some(_) => None,
            None => moduli((card, lines), draft),
        };
        // a line of moduli comes last
        let sizes_and_axis = card.data().len() - usize::from(elastic.is_some());
        let direction = card.data().get(lines).filter(|_| sizes_and_axis > lines);
        let first_axis = first_axis(direction, draft);
        let (Some(poisson), Some(first_axis), Some(density)) = (poisson, first_axis, density)
        else {
            return;
        };
        if elastic.is_none() && material.is_none() {
            return; // its moduli could not be read
        }
        draft.owner = Owner::Section(draft.sections.len());
        draft.sections.push(Section {
            set,
            material: material.unwrap_or_default(),
            material_span: card.span_of("MATERIAL"),
            set_span: card.span_of("ELSET"),
            body: Body::Beam {
                shape,
                poisson,
                shear: ShearRule::default(),
                first_axis,
                elastic,
                density,
            },
            orientation: None,
            origin: card.span(),
        });
    }
}

/// Mass per volume, if the card gives one; `None` where that cannot be.
fn density(card: &Reading<'_>, draft: &mut Draft) -> Option<Option<f64>> {
    let density = card.number("DENSITY", &mut draft.log)?;
    if density.is_some_and(|density| density < 0.0) {
        draft.log.error("SL0234", "the density must not be negative", card.span_of("DENSITY"));
        return None;
    }
    Some(density)
}

/// The section of one end, with the number of data lines that it takes.
fn one_end(kind: &str, lines: &[DataLine], draft: &mut Draft) -> Option<(Shape, usize)> {
    match kind {
        GENERAL => general(lines.first()?, draft).map(|shape| (shape, 1)),
        _ => shape(kind, lines, draft),
    }
}

/// Those of both ends, one after the other: the even section that stands for them.
fn tapered((card, kind): (&Reading<'_>, &str), draft: &mut Draft) -> Option<(Shape, usize)> {
    let (first, lines) = one_end(kind, card.data(), draft)?;
    let others = &card.data()[lines..];
    if others.is_empty() {
        let message = "TAPER asks for the sizes of both ends: those of the second end are missing";
        draft.log.error("SL0208", message, card.span());
        return None;
    }
    let (second, further) = one_end(kind, others, draft)?;
    if first.points().len() != second.points().len() {
        let message = "the sections of both ends must have the same walls";
        draft.log.error("SL0210", message, others[0].span);
        return None;
    }
    Some((Shape::tapered([&first, &second]), lines + further))
}

/// A, I11, I12, I22, J: a plane beam bends about axis 1 alone.
fn general(line: &DataLine, draft: &mut Draft) -> Option<Shape> {
    draft.log.at_most(line, 7);
    let area = draft.log.number(line, 0, "the area A")?;
    let second_moment = draft.log.number(line, 1, "the second moment of area I11")?;
    let mixed = draft.log.number_or(line, 2, 0.0)?;
    let across = draft.log.number_or(line, 3, 0.0)?;
    let torsion = draft.log.number_or(line, 4, 0.0)?;
    if area <= 0.0 || second_moment <= 0.0 {
        draft.log.error("SL0210", "A and I11 of the section must be positive", line.span);
        return None;
    }
    let second_moments = [second_moment, mixed, across];
    let [centroid, shear_center] = [[0.0; 2]; 2];
    Some(Shape::General { area, second_moments, torsion, centroid, shear_center })
}

/// E, G and the coefficient of expansion of the last line; a blank line before it is not kept by the
/// deck.
fn moduli((card, sizes): (&Reading<'_>, usize), draft: &mut Draft) -> Option<(Elastic, f64)> {
    let Some(line) = card.data().last().filter(|_| card.data().len() > sizes) else {
        draft.log.error("SL0208", "the moduli E and G are missing: the third line", card.span());
        return None;
    };
    let modulus = draft.log.number(line, 0, "Young's modulus E")?;
    let shear = draft.log.number(line, 1, "the shear modulus G")?;
    draft.log.at_most(line, 4);
    let expansion = draft.log.number_or(line, 2, 0.0)?;
    if modulus <= 0.0 || shear <= 0.0 {
        draft.log.error("SL0234", "E and G must be positive", line.span);
        return None;
    }
    Some((Elastic { modulus, poisson: 0.5 * modulus / shear - 1.0 }, expansion))
}
