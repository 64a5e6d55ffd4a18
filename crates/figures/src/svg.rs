//! A scene as SVG: no styles, no identifiers, so that it can stand in a page
//! beside others.

use crate::colour::{CURVES, Colour, GRID, INK};
use crate::font::{FAMILY, Face};
use crate::scene::{Anchor, Item, Pen, Scene, Text, Unit};
use std::fmt::Write as _;

/// Whose colours a figure has.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Colours {
    /// Its own, on white paper.
    Own,
    /// Those of the style sheet of the page it stands in.
    Page,
}

impl Scene {
    /// The figure as an SVG document.
    pub fn svg(&self) -> String {
        let [width, height] = [self.width, self.height].map(short);
        let unit = match self.unit {
            Unit::Point => "pt",
            Unit::Pixel => "", // a unit of SVG is 1/96 inch
        };
        let attributes = format!(
            " xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}{unit}\" \
             height=\"{height}{unit}\" font-family=\"{FAMILY}\""
        );
        self.document(&attributes, Colours::Own)
    }

    /// The figure as a part of an HTML page, in the colours and letters of the
    /// page: its style sheet sets `--ink`, `--line` and `--c0` to `--c5`.
    pub fn inline(&self) -> String {
        self.document("", Colours::Page)
    }

    fn document(&self, attributes: &str, colours: Colours) -> String {
        let mut text = String::with_capacity(1 << 15);
        let [width, height] = [self.width, self.height].map(short);
        // a String takes any text, here and below
        let _ = write!(
            text,
            "<svg{attributes} viewBox=\"0 0 {width} {height}\" role=\"img\" \
             stroke-linejoin=\"round\">\n<title>{title}</title>\n",
            title = escaped(&self.title),
        );
        if colours == Colours::Own {
            let _ =
                writeln!(text, "<rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>"); // as above
        }
        for item in &self.items {
            push(&mut text, item, colours);
        }
        text.push_str("</svg>\n");
        text
    }
}

fn push(text: &mut String, item: &Item, colours: Colours) {
    match item {
        Item::Path { points, closed, fill, pen } => {
            text.push_str("<path d=\"");
            for (place, [x, y]) in points.iter().enumerate() {
                let letter = if place == 0 { 'M' } else { 'L' };
                let _ = write!(text, "{letter}{} {}", short(*x), short(*y)); // as above
            }
            text.push_str(if *closed { "Z\"" } else { "\"" });
            push_paint(text, (*fill, *pen), colours);
        }
        Item::Circle { centre: [x, y], radius, fill, pen } => {
            let (x, y, r) = (short(*x), short(*y), short(*radius));
            let _ = write!(text, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\""); // as above
            push_paint(text, (*fill, *pen), colours);
        }
        Item::Text(words) if words.plain => push_plain(text, words),
        Item::Text(words) => push_text(text, words),
    }
}

fn push_paint(text: &mut String, (fill, pen): (Option<Colour>, Option<Pen>), colours: Colours) {
    match fill {
        Some(colour) => {
            let _ = write!(text, " {}", paint("fill", colour, colours)); // as above
        }
        None => text.push_str(" fill=\"none\""),
    }
    if let Some(pen) = pen {
        let (stroke, width) = (paint("stroke", pen.colour, colours), short(pen.width));
        let _ = write!(text, " {stroke} stroke-width=\"{width}\""); // as above
        let lengths: Vec<String> = pen.dash.lengths().iter().map(f32::to_string).collect();
        if !lengths.is_empty() {
            let _ = write!(text, " stroke-dasharray=\"{}\"", lengths.join(" ")); // as above
        }
    }
    text.push_str("/>\n");
}

/// Where a text stands and which way it reads.
fn placed(words: &Text) -> String {
    let [x, y] = words.at.map(short);
    let turn = if words.upwards { " rotate(-90)" } else { "" };
    format!("transform=\"translate({x} {y}){turn}\"")
}

/// Words with letters that we may not have: whoever shows them measures them.
fn push_plain(text: &mut String, words: &Text) {
    let anchor = match words.anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    let weight = if words.bold { " font-weight=\"bold\"" } else { "" };
    let _ = writeln!(
        text,
        "<text {} text-anchor=\"{anchor}\" font-size=\"{}\"{weight}>{}</text>",
        placed(words),
        short(words.size),
        escaped(&words.content),
    ); // as above
}

fn push_text(text: &mut String, words: &Text) {
    let _ = write!(text, "<g {}>", placed(words)); // as above
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

/// The attribute that paints in a colour.
fn paint(attribute: &str, colour: Colour, colours: Colours) -> String {
    let [red, green, blue] = colour;
    let own = format!("#{red:02x}{green:02x}{blue:02x}");
    let name = match colour {
        INK => Some("ink".to_owned()),
        GRID => Some("line".to_owned()),
        _ => CURVES.iter().position(|curve| *curve == colour).map(|place| format!("c{place}")),
    };
    match (colours, name) {
        (Colours::Page, Some(name)) => format!("style=\"{attribute}:var(--{name},{own})\""),
        _ => format!("{attribute}=\"{own}\""),
    }
}

/// Text as it may stand in SVG and HTML, in an attribute too.
pub fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            c if c.is_control() && c != '\n' && c != '\t' => safe.push('\u{FFFD}'),
            c => safe.push(c),
        }
    }
    safe
}

/// Two decimals at most.
fn short(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_text_ends_an_element() {
        assert_eq!(escaped("</script>'\"&\u{1}"), "&lt;/script&gt;&#39;&quot;&amp;\u{FFFD}");
    }
}
