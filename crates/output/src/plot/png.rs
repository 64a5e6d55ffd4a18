//! A figure as dots, 192 an inch.

use super::drawing::{Anchor, Colour, Drawing, INK, Item, LETTERS};
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash,
    Transform,
};
use ttf_parser::{Face, OutlineBuilder};

/// Dots for each unit of the drawing.
const SCALE: f32 = 2.0;

const FONT: &[u8] = include_bytes!("../../fonts/DejaVuSans.ttf");

/// The file; `None` if it cannot be encoded.
pub(super) fn png(drawing: &Drawing) -> Option<Vec<u8>> {
    let size = |length: f64| (length * f64::from(SCALE)).round() as u32;
    let mut dots = Pixmap::new(size(drawing.width), size(drawing.height))?;
    dots.fill(Color::WHITE);
    let font = Face::parse(FONT, 0).ok()?;
    for item in &drawing.items {
        push(&mut dots, &font, item);
    }
    encode(&dots).ok()
}

fn encode(dots: &Pixmap) -> Result<Vec<u8>, png::EncodingError> {
    // nothing shines through: three channels say it
    let colours: Vec<u8> =
        dots.data().as_chunks::<4>().0.iter().flat_map(|dot| [dot[0], dot[1], dot[2]]).collect();
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, dots.width(), dots.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&colours)?;
    writer.finish()?;
    Ok(file)
}

fn push(dots: &mut Pixmap, font: &Face<'_>, item: &Item) {
    match item {
        Item::Line { points, width, colour, dashed } => {
            let mut path = PathBuilder::new();
            for (place, [x, y]) in points.iter().enumerate() {
                let (x, y) = (*x as f32, *y as f32);
                if place == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
            }
            let Some(path) = path.finish() else { return };
            let stroke = Stroke {
                width: *width as f32,
                line_join: LineJoin::Round,
                line_cap: LineCap::Butt,
                dash: if *dashed { StrokeDash::new(vec![7.0, 4.0], 0.0) } else { None },
                ..Stroke::default()
            };
            dots.stroke_path(&path, &ink(*colour), &stroke, scale(), None);
        }
        Item::Disc { at: [x, y], radius, colour } => {
            fill(dots, PathBuilder::from_circle(*x as f32, *y as f32, *radius as f32), *colour);
        }
        Item::Words { at, text, anchor, upwards, .. } => {
            let mut letters = Letters {
                path: PathBuilder::new(),
                at: [at[0] as f32, at[1] as f32],
                scale: LETTERS as f32 / f32::from(font.units_per_em()),
                x: 0.0,
                upwards: *upwards,
            };
            letters.write(font, text, *anchor);
            fill(dots, letters.path.finish(), INK);
        }
    }
}

fn scale() -> Transform {
    Transform::from_scale(SCALE, SCALE)
}

fn ink([red, green, blue]: Colour) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(red, green, blue, 255);
    paint.anti_alias = true;
    paint
}

fn fill(dots: &mut Pixmap, path: Option<Path>, colour: Colour) {
    if let Some(path) = path {
        dots.fill_path(&path, &ink(colour), FillRule::Winding, scale(), None);
    }
}

/// Puts outlines of letters where a text stands.
struct Letters {
    path: PathBuilder,
    at: [f32; 2],
    scale: f32,
    /// Where the next letter begins, in units of the font.
    x: f32,
    upwards: bool,
}

impl Letters {
    fn write(&mut self, font: &Face<'_>, text: &str, anchor: Anchor) {
        let glyph = |letter: char| font.glyph_index(letter).or_else(|| font.glyph_index('?'));
        let width = |glyph| f32::from(font.glyph_hor_advance(glyph).unwrap_or_default());
        let glyphs: Vec<_> = text.chars().filter_map(glyph).collect();
        let total: f32 = glyphs.iter().map(|glyph| width(*glyph)).sum();
        self.x = match anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => -0.5 * total,
            Anchor::End => -total,
        };
        for glyph in glyphs {
            let _ = font.outline_glyph(glyph, self); // a blank has none
            self.x += width(glyph);
        }
    }

    fn place(&self, x: f32, y: f32) -> (f32, f32) {
        let (x, y) = (self.scale * (self.x + x), -self.scale * y);
        let (x, y) = if self.upwards { (y, -x) } else { (x, y) };
        (self.at[0] + x, self.at[1] + y)
    }
}

impl OutlineBuilder for Letters {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.place(x, y);
        self.path.move_to(x, y);
    }
    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.place(x, y);
        self.path.line_to(x, y);
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.place(x1, y1), self.place(x, y));
        self.path.quad_to(x1, y1, x, y);
    }
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2)) = (self.place(x1, y1), self.place(x2, y2));
        let (x, y) = self.place(x, y);
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }
    fn close(&mut self) {
        self.path.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_font_has_the_letters_of_numbers_and_columns() {
        let font = Face::parse(FONT, 0).unwrap();
        let known: Vec<char> = (' '..='~').chain(['\u{2212}']).collect();
        let missing: String =
            known.into_iter().filter(|letter| font.glyph_index(*letter).is_none()).collect();
        assert!(missing.is_empty(), "{missing}");
    }
}
