//! A scene as SVG: no styles, no identifiers, so that it can stand in a page
//! beside others.

use super::font::{FAMILY, Face};
use super::scene::{Item, Pen, Scene, Text};
use std::fmt::Write as _;

impl Scene {
    /// The figure as an SVG document.
    pub fn svg(&self) -> String {
        let mut text = String::with_capacity(1 << 15);
        let (width, height) = (short(self.width), short(self.height));
        // a String takes any text, here and below
        let _ = write!(
            text,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}pt\" height=\"{height}pt\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\" font-family=\"{FAMILY}\" \
             stroke-linejoin=\"round\">\n<title>{title}</title>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n",
            title = escaped(&self.title),
        );
        for item in &self.items {
            push(&mut text, item);
        }
        text.push_str("</svg>\n");
        text
    }
}

fn push(text: &mut String, item: &Item) {
    match item {
        Item::Path { points, closed, fill, pen } => {
            text.push_str("<path d=\"");
            for (place, [x, y]) in points.iter().enumerate() {
                let letter = if place == 0 { 'M' } else { 'L' };
                let _ = write!(text, "{letter}{} {}", short(*x), short(*y)); // as above
            }
            text.push_str(if *closed { "Z\"" } else { "\"" });
            push_paint(text, *fill, *pen);
        }
        Item::Circle { centre: [x, y], radius, fill, pen } => {
            let (x, y, r) = (short(*x), short(*y), short(*radius));
            let _ = write!(text, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\""); // as above
            push_paint(text, *fill, *pen);
        }
        Item::Text(words) => push_text(text, words),
    }
}

fn push_paint(text: &mut String, fill: Option<u8>, pen: Option<Pen>) {
    match fill {
        Some(grey) => {
            let _ = write!(text, " fill=\"{}\"", colour(grey)); // as above
        }
        None => text.push_str(" fill=\"none\""),
    }
    if let Some(pen) = pen {
        let width = short(pen.width);
        let _ = write!(text, " stroke=\"{}\" stroke-width=\"{width}\"", colour(pen.grey)); // as above
        let lengths: Vec<String> = pen.dash.lengths().iter().map(f32::to_string).collect();
        if !lengths.is_empty() {
            let _ = write!(text, " stroke-dasharray=\"{}\"", lengths.join(" ")); // as above
        }
    }
    text.push_str("/>\n");
}

fn push_text(text: &mut String, words: &Text) {
    let [x, y] = words.at;
    let turn = if words.upwards { " rotate(-90)" } else { "" };
    let _ = write!(text, "<g transform=\"translate({} {}){turn}\">", short(x), short(y)); // as above
    for run in words.runs() {
        let style = match run.face {
            Face::Regular => "",
            Face::Bold => " font-weight=\"bold\"",
            Face::Oblique => " font-style=\"oblique\"",
        };
        // the width keeps the layout where other letters stand in for ours
        let _ = write!(
            text,
            "<text x=\"{}\" y=\"{}\" font-size=\"{}\"{style} textLength=\"{}\" \
             lengthAdjust=\"spacingAndGlyphs\" xml:space=\"preserve\">{}</text>",
            short(run.offset[0]),
            short(run.offset[1]),
            short(run.size),
            short(run.width),
            escaped(&run.letters),
        ); // as above
    }
    text.push_str("</g>\n");
}

fn colour(grey: u8) -> String {
    format!("#{grey:02x}{grey:02x}{grey:02x}")
}

/// Two decimals at most.
fn short(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// Text as it may stand in XML.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
