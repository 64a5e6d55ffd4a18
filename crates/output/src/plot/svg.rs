//! A figure as SVG.

use super::drawing::{Anchor, CURVES, Colour, Drawing, INK, Item, LETTERS, LIGHT};
use crate::report::escaped;
use std::fmt::Write as _;

/// Whose colours a figure has.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Colours {
    /// Its own, on white paper.
    Own,
    /// Those of the style sheet of the page it stands in.
    Page,
}

/// The document.
pub(super) fn svg(drawing: &Drawing) -> String {
    let (width, height) = (drawing.width, drawing.height);
    let attributes = format!(
        " xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         font-family=\"DejaVu Sans, Verdana, sans-serif\" font-size=\"{LETTERS}\""
    );
    document(drawing, &attributes, Colours::Own)
}

/// A part of an HTML page; letters are the page's as well.
pub(super) fn inline(drawing: &Drawing) -> String {
    document(drawing, "", Colours::Page)
}

fn document(drawing: &Drawing, attributes: &str, colours: Colours) -> String {
    let (width, height) = (drawing.width, drawing.height);
    let title = escaped(&drawing.title);
    let mut text = format!(
        "<svg{attributes} viewBox=\"0 0 {width} {height}\" role=\"img\">\n\
         <title>{title}</title>\n"
    );
    if colours == Colours::Own {
        let _ = writeln!(text, "<rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>");
    }
    for item in &drawing.items {
        push(&mut text, item, colours); // a String takes any text, here and below
    }
    text.push_str("</svg>\n");
    text
}

fn push(text: &mut String, item: &Item, colours: Colours) {
    match item {
        Item::Line { points, width, colour, dashed } => {
            text.push_str("<polyline points=\"");
            for [x, y] in points {
                let _ = write!(text, "{x:.2},{y:.2} ");
            }
            let dash = if *dashed { " stroke-dasharray=\"7 4\"" } else { "" };
            let _ = writeln!(
                text,
                "\" fill=\"none\" {} stroke-width=\"{width}\"{dash} stroke-linejoin=\"round\"/>",
                paint("stroke", *colour, colours)
            );
        }
        Item::Disc { at: [x, y], radius, colour } => {
            let colour = paint("fill", *colour, colours);
            let _ = writeln!(text, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius}\" {colour}/>");
        }
        Item::Words { at: [x, y], text: words, anchor, upwards, bold } => {
            let anchor = match anchor {
                Anchor::Start => "start",
                Anchor::Middle => "middle",
                Anchor::End => "end",
            };
            let turn = if *upwards { " rotate(-90)" } else { "" };
            let weight = if *bold { " font-weight=\"bold\"" } else { "" };
            let words = escaped(words);
            let _ = writeln!(
                text,
                "<text transform=\"translate({x:.2} {y:.2}){turn}\" \
                 text-anchor=\"{anchor}\"{weight}>{words}</text>"
            );
        }
    }
}

/// The attribute that paints in a colour.
fn paint(attribute: &str, colour: Colour, colours: Colours) -> String {
    let [red, green, blue] = colour;
    let own = format!("#{red:02x}{green:02x}{blue:02x}");
    let name = match colour {
        INK => Some("ink".to_owned()),
        LIGHT => Some("line".to_owned()),
        _ => CURVES.iter().position(|curve| *curve == colour).map(|place| format!("c{place}")),
    };
    match (colours, name) {
        (Colours::Page, Some(name)) => format!("style=\"{attribute}:var(--{name},{own})\""),
        _ => format!("{attribute}=\"{own}\""),
    }
}
