//! A figure as SVG.

use super::drawing::{Anchor, Colour, Drawing, Item, LETTERS};
use crate::report::escaped;
use std::fmt::Write as _;

/// The document; a String takes any text.
pub(super) fn svg(drawing: &Drawing) -> String {
    let (width, height) = (drawing.width, drawing.height);
    let title = escaped(&drawing.title);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" role=\"img\" font-family=\"DejaVu Sans, Verdana, \
         sans-serif\" font-size=\"{LETTERS}\">\n<title>{title}</title>\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n"
    );
    for item in &drawing.items {
        push(&mut text, item);
    }
    text.push_str("</svg>\n");
    text
}

fn push(text: &mut String, item: &Item) {
    match item {
        Item::Line { points, width, colour, dashed } => {
            text.push_str("<polyline points=\"");
            for [x, y] in points {
                let _ = write!(text, "{x:.2},{y:.2} ");
            }
            let dash = if *dashed { " stroke-dasharray=\"7 4\"" } else { "" };
            let _ = writeln!(
                text,
                "\" fill=\"none\" stroke=\"{}\" stroke-width=\"{width}\"{dash} \
                 stroke-linejoin=\"round\"/>",
                hex(*colour)
            );
        }
        Item::Disc { at: [x, y], radius, colour } => {
            let colour = hex(*colour);
            let _ = writeln!(
                text,
                "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius}\" fill=\"{colour}\"/>"
            );
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

fn hex([red, green, blue]: Colour) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}
