//! Sections of beams by their names and sizes.

use slideline_deck::{DataLine, Field};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{Dialect, Shape};
use slideline_model::{Fault, Profile, Wall};
use std::f64::consts::PI;

use crate::draft::Draft;

/// Their names.
pub(crate) const SHAPES: [&str; 10] =
    ["RECT", "CIRC", "PIPE", "BOX", "I", "L", "TRAPEZOID", "HEX", "THICK PIPE", "ARBITRARY"];

/// What a size may be.
#[derive(Clone, Copy, PartialEq)]
enum Bound {
    Positive,
    /// A flange or a side may be missing.
    NotNegative,
    /// A place: the axis may be outside.
    Any,
}

use Bound::{Any, NotNegative, Positive};

/// Names of the sizes of a section, with what they may be.
fn sizes_of(kind: &str) -> &'static [(&'static str, Bound)] {
    match kind {
        "CIRC" => &[("radius", Positive)],
        "PIPE" | "THICK PIPE" => &[("outer radius", Positive), ("thickness of the wall", Positive)],
        "BOX" => &[
            ("width a", Positive),
            ("height b", Positive),
            ("thickness t1", Positive),
            ("thickness t2", Positive),
            ("thickness t3", Positive),
            ("thickness t4", Positive),
        ],
        "I" => &[
            ("distance l", Any),
            ("height h", Positive),
            ("width b1", NotNegative),
            ("width b2", NotNegative),
            ("thickness t1", NotNegative),
            ("thickness t2", NotNegative),
            ("thickness t3", Positive),
        ],
        "L" => &[
            ("width a", Positive),
            ("height b", Positive),
            ("thickness t1", Positive),
            ("thickness t2", Positive),
        ],
        "TRAPEZOID" => &[
            ("width a", NotNegative),
            ("height b", Positive),
            ("width c", NotNegative),
            ("distance d", Any),
        ],
        "HEX" => &[("radius d", Positive), ("thickness t", Positive)],
        _ => &[("width", Positive), ("height", Positive)],
    }
}

/// A section from its sizes, with the number of data lines that they take.
pub(crate) fn shape(kind: &str, lines: &[DataLine], draft: &mut Draft) -> Option<(Shape, usize)> {
    let line = lines.first()?;
    if kind == "ARBITRARY" {
        return arbitrary(lines, draft);
    }
    let made = match kind {
        "CIRC" if draft.dialect == Dialect::Calculix => ellipse(line, draft)?,
        _ => {
            let names = sizes_of(kind);
            draft.log.at_most(line, names.len());
            let mut sizes: Vec<f64> = Vec::with_capacity(names.len());
            // CalculiX takes one thickness for both of a square
            let square = kind == "RECT" && draft.dialect == Dialect::Calculix;
            for (at, (name, bound)) in names.iter().enumerate() {
                let same = sizes.first().copied().filter(|_| square);
                sizes.push(size(line, (at, name), *bound, same, draft)?);
            }
            made(kind, &sizes)
        }
    };
    if let Err(fault) = &made {
        complain(fault, line, draft);
    }
    let shape = made.ok()?;
    warn_of_swapped(&shape, line, draft);
    Some((shape, 1))
}

fn complain(fault: &str, line: &DataLine, draft: &mut Draft) {
    let error = Diagnostic::error(Code("SL0210"), fault).at(line.span);
    draft.log.push(error.help("docs/keywords/BEAM-SECTION.md shows the sizes of each shape"));
}

/// A size of a line, which may stand for another one where it is missing.
fn size(
    line: &DataLine,
    (at, name): (usize, &str),
    bound: Bound,
    else_: Option<f64>,
    draft: &mut Draft,
) -> Option<f64> {
    let value = match else_ {
        Some(other) => draft.log.number_or(line, at, other)?,
        None => draft.log.number(line, at, &format!("the {name}"))?,
    };
    let sound = match bound {
        Positive => value > 0.0,
        NotNegative => value >= 0.0,
        Any => true,
    };
    if !sound {
        let message = format!("the {name} of the section must be positive");
        let span = line.fields.get(at).map_or(line.span, |field: &Field| field.span);
        draft.log.error("SL0210", message, span);
    }
    sound.then_some(value)
}

fn warn_of_swapped(shape: &Shape, line: &DataLine, draft: &mut Draft) {
    let Shape::Rectangle { width, height } = *shape else { return };
    if height > 5.0 * width {
        let message = format!("the section is {} times as high as wide", (height / width).round());
        let warning = Diagnostic::warning(Code("SL0233"), message).at(line.span);
        let help = "first the width out of the plane, then the height in the plane: swapped?";
        draft.log.push(warning.help(help));
    }
}

/// CalculiX' `CIRC`: the thicknesses along both axes of an ellipse, one alone for a circle.
fn ellipse(line: &DataLine, draft: &mut Draft) -> Option<Result<Shape, &'static str>> {
    draft.log.at_most(line, 2);
    let first = size(line, (0, "thickness along axis 1"), Positive, None, draft)?;
    let second = size(line, (1, "thickness along axis 2"), Positive, Some(first), draft)?;
    let (a, b) = (0.5 * first, 0.5 * second);
    if a == b {
        return Some(Ok(Shape::Circle(a)));
    }
    let area = PI * a * b;
    Some(Ok(Shape::General {
        area,
        second_moments: [0.25 * area * b * b, 0.0, 0.25 * area * a * a],
        torsion: area * a * a * b * b / (a * a + b * b),
        centroid: [0.0; 2],
        shear_center: [0.0; 2],
    }))
}

fn made(kind: &str, sizes: &[f64]) -> Result<Shape, &'static str> {
    let profile = match (kind, sizes) {
        ("CIRC", &[radius]) => return Ok(Shape::Circle(radius)),
        ("RECT", &[width, height]) => return Ok(Shape::Rectangle { width, height }),
        ("PIPE" | "THICK PIPE", &[radius, wall]) if wall > radius => {
            return Err("the wall is thicker than the radius");
        }
        ("PIPE", &[radius, wall]) => return Ok(Shape::Pipe { radius, wall }),
        ("THICK PIPE", &[radius, wall]) => Profile::thick_pipe(radius, wall),
        ("BOX", &[a, b, right, top, left, bottom]) => {
            if right + left >= a || top + bottom >= b {
                return Err("the walls leave no room inside");
            }
            Profile::tube([a, b], [right, top, left, bottom])
                .map_err(|_| "the walls make no tube")?
        }
        ("I", &[origin, height, bottom, top, low, high, web]) => {
            let flanges = bottom * low + top * high;
            if low + high >= height || flanges < 0.0 {
                return Err("flanges and web do not make an I of this height");
            }
            Profile::flanged((origin, height), [bottom, top], [low, high, web])
        }
        ("L", &[a, b, along, up]) => {
            if along >= b || up >= a {
                return Err("a leg is thicker than the other one is long");
            }
            Profile::angle([a, b], [along, up])
        }
        ("TRAPEZOID", &[bottom, height, top, origin]) => {
            if bottom + top <= 0.0 {
                return Err("one of the parallel sides must have a length");
            }
            Profile::trapezoid([bottom, top], height, origin)
        }
        ("HEX", &[radius, wall]) => {
            if wall > 0.75_f64.sqrt() * radius {
                return Err("the walls leave no room inside");
            }
            Profile::hexagon(radius, wall)
        }
        _ => return Err("these are not the sizes of a section"),
    };
    Ok(Shape::Profile(Box::new(profile)))
}

/// Thin walls one after the other: the number of them, both ends and the thickness of the first one,
/// then a line with the next end and thickness for each other.
fn arbitrary(lines: &[DataLine], draft: &mut Draft) -> Option<(Shape, usize)> {
    let line = lines.first()?;
    let count = draft.log.label(line, 0, "the number of segments")?;
    let count = usize::try_from(count).ok().filter(|&count| count > 0 && count <= lines.len());
    let Some(count) = count else {
        let message = "there are not as many data lines as segments";
        draft.log.error("SL0208", message, line.span);
        return None;
    };
    let mut from = [coordinate(line, 1, draft)?, coordinate(line, 2, draft)?];
    let mut walls = Vec::with_capacity(count);
    for (number, line) in lines.iter().take(count).enumerate() {
        let first = if number == 0 { 3 } else { 0 };
        draft.log.at_most(line, first + 3);
        let to = [coordinate(line, first, draft)?, coordinate(line, first + 1, draft)?];
        let named = (first + 2, "thickness of the segment");
        // one without thickness leads back to where another branch begins
        let thickness = size(line, named, NotNegative, None, draft)?;
        walls.push(Wall { ends: [from, to], thickness });
        from = to;
    }
    match Profile::of_walls(&walls) {
        Ok(profile) => Some((Shape::Profile(Box::new(profile)), count)),
        Err(fault) => {
            let fault = match fault {
                Fault::Apart => "the segments do not hang together",
                Fault::Cells => "the segments enclose more than one cell",
                Fault::Straight => "all segments lie on one line, and nothing resists bending",
            };
            complain(fault, line, draft);
            None
        }
    }
}

fn coordinate(line: &DataLine, at: usize, draft: &mut Draft) -> Option<f64> {
    draft.log.number(line, at, "a coordinate of the segment")
}
