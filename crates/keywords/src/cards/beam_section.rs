//! `*BEAM SECTION`: the section of beams.

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic};
use slideline_model::{BeamSection as ModelSection, Dialect, Shape, ShearRule};
use std::f64::consts::PI;

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
        let kind = card.choice("SECTION", SHAPES, &mut draft.log);
        let named = card.name("ELSET").zip(card.name("MATERIAL"));
        let Some((kind, (set, material))) = kind.zip(named) else { return };
        temperatures(card, draft);
        let poisson = poisson(card, draft);
        // the third one, points of a section that is integrated, changes no elastic beam
        draft.log.at_most_lines(card.data(), 3, self.name());
        let Some(line) = card.first_line("the size of the section", &mut draft.log) else { return };
        let Some(shape) = shape(kind, line, draft) else { return };
        let first_axis = first_axis(card.data().get(1), draft);
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

/// The shapes of sections.
pub(super) const SHAPES: &[&str] = &["RECT", "CIRC", "PIPE", "BOX", "I"];

/// A section from its sizes.
pub(super) fn shape(kind: &str, line: &DataLine, draft: &mut Draft) -> Option<Shape> {
    let elliptical = kind == "CIRC" && draft.dialect == Dialect::Calculix;
    let names: &[&str] = match kind {
        _ if elliptical => &["thickness along axis 1", "thickness along axis 2"],
        "CIRC" => &["radius"],
        "PIPE" => &["outer radius", "thickness of the wall"],
        "BOX" => {
            &["width a", "height b", "thickness t1", "thickness t2", "thickness t3", "thickness t4"]
        }
        "I" => &[
            "distance l",
            "height h",
            "width b1",
            "width b2",
            "thickness t1",
            "thickness t2",
            "thickness t3",
        ],
        _ => &["width", "height"],
    };
    draft.log.at_most(line, names.len());
    let mut sizes = Vec::with_capacity(names.len());
    for (at, name) in names.iter().enumerate() {
        // one thickness of an ellipse alone is that of a circle
        let same = sizes.first().copied().filter(|_| elliptical);
        let value = match same {
            Some(first) => draft.log.number_or(line, at, first)?,
            None => draft.log.number(line, at, &format!("the {name}"))?,
        };
        // a T is an I without a flange, and the axis may be at the bottom
        let least = if kind == "I" { value >= 0.0 } else { value > 0.0 };
        if !least {
            let message = format!("the {name} of the section must be positive");
            draft.log.error("SL0210", message, line.fields[at].span);
            return None;
        }
        sizes.push(value);
    }
    let made = made(kind, &sizes);
    if let Err(fault) = &made {
        let error = Diagnostic::error(Code("SL0210"), *fault).at(line.span);
        draft.log.push(error.help("docs/keywords/BEAM-SECTION.md shows the sizes of each shape"));
    }
    let shape = made.ok()?;
    let (width, height) = (shape.width(), shape.height());
    if kind == "RECT" && height > 5.0 * width {
        let message = format!("the section is {} times as high as wide", (height / width).round());
        let warning = Diagnostic::warning(Code("SL0233"), message).at(line.span);
        let help = "first the width out of the plane, then the height in the plane: swapped?";
        draft.log.push(warning.help(help));
    }
    Some(shape)
}

fn made(kind: &str, sizes: &[f64]) -> Result<Shape, &'static str> {
    match *sizes {
        [radius] => Ok(Shape::Circle(radius)),
        [radius, wall] if kind == "PIPE" => {
            if wall > radius {
                return Err("the wall is thicker than the radius");
            }
            Ok(Shape::Pipe { radius, wall })
        }
        [along_1, along_2] if kind == "CIRC" => Ok(ellipse(0.5 * along_1, 0.5 * along_2)),
        [width, height] => Ok(Shape::Rectangle { width, height }),
        [a, b, right, top, left, bottom] => {
            if right + left >= a || top + bottom >= b {
                return Err("the walls leave no room inside");
            }
            if right != left || top != bottom {
                return Err("opposite walls must be alike: the axis runs through the centroid");
            }
            Ok(Shape::Box { size: [a, b], walls: [right, top] })
        }
        [origin, height, bottom, top, low, high, web] => {
            let shape = Shape::Flanged { height, widths: [bottom, top], walls: [low, high, web] };
            if low + high >= height || web <= 0.0 || shape.area() <= 0.0 {
                return Err("flanges and web do not make an I of this height");
            }
            // sizes are written with six digits or so
            if (origin - shape.centroid()).abs() > 1e-5 * height {
                return Err(
                    "the axis must run through the centroid: l is its distance from the bottom",
                );
            }
            Ok(shape)
        }
        _ => Err("these are not the sizes of a section"),
    }
}

/// An ellipse of half axes a and b [L], which CalculiX calls CIRC; a circle is one.
fn ellipse(a: f64, b: f64) -> Shape {
    if a == b {
        return Shape::Circle(a);
    }
    let area = PI * a * b;
    let torsion = area * a * a * b * b / (a * a + b * b);
    Shape::General {
        area,
        second_moments: [0.25 * area * b * b, 0.0, 0.25 * area * a * a],
        torsion,
    }
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
