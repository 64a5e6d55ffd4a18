//! Letters: widths for the layout, outlines for the dots.

use ttf_parser::OutlineBuilder;

/// A cut of the letters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Face {
    /// Upright.
    Regular,
    /// Bold.
    Bold,
    /// Slanted: variables.
    Oblique,
}

/// Family by which an SVG asks for the letters; the second has the same widths.
pub(crate) const FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";

const REGULAR: &[u8] = include_bytes!("../fonts/DejaVuSans.ttf");
const BOLD: &[u8] = include_bytes!("../fonts/DejaVuSans-Bold.ttf");
const OBLIQUE: &[u8] = include_bytes!("../fonts/DejaVuSans-Oblique.ttf");

fn parsed(face: Face) -> Option<ttf_parser::Face<'static>> {
    let bytes = match face {
        Face::Regular => REGULAR,
        Face::Bold => BOLD,
        Face::Oblique => OBLIQUE,
    };
    ttf_parser::Face::parse(bytes, 0).ok()
}

/// The glyph of a letter, that of a question mark where the face has none.
fn glyph(font: &ttf_parser::Face<'_>, letter: char) -> Option<ttf_parser::GlyphId> {
    font.glyph_index(letter).or_else(|| font.glyph_index('?'))
}

/// Width of letters of that size, in its unit.
pub(crate) fn width(face: Face, letters: &str, size: f64) -> f64 {
    let Some(font) = parsed(face) else { return 0.0 };
    let advance = |letter| font.glyph_hor_advance(glyph(&font, letter)?);
    let units: f64 = letters.chars().filter_map(advance).map(f64::from).sum();
    units * size / f64::from(font.units_per_em())
}

#[cfg(test)]
/// Whether the face has every one of these letters.
pub(crate) fn has(face: Face, letters: &str) -> bool {
    parsed(face).is_some_and(|font| letters.chars().all(|l| font.glyph_index(l).is_some()))
}

/// Takes the pieces of an outline: points of the plane, y up, with the origin
/// at the left end of the base line.
pub(crate) trait Pieces {
    /// A new contour.
    fn move_to(&mut self, p: [f64; 2]);
    /// A straight piece.
    fn line_to(&mut self, p: [f64; 2]);
    /// A parabola with its middle control point.
    fn quad_to(&mut self, middle: [f64; 2], p: [f64; 2]);
    /// The contour ends.
    fn close(&mut self);
}

/// Outlines of letters of that size.
pub(crate) fn outline(face: Face, letters: &str, size: f64, into: &mut dyn Pieces) {
    let Some(font) = parsed(face) else { return };
    let scale = size / f64::from(font.units_per_em());
    let mut pen = Placed { x: 0.0, scale, into };
    for letter in letters.chars() {
        let Some(glyph) = glyph(&font, letter) else { continue };
        let _ = font.outline_glyph(glyph, &mut pen); // a blank has none
        pen.x += f64::from(font.glyph_hor_advance(glyph).unwrap_or_default()) * scale;
    }
}

struct Placed<'a> {
    x: f64,
    scale: f64,
    into: &'a mut dyn Pieces,
}

impl Placed<'_> {
    fn at(&self, x: f32, y: f32) -> [f64; 2] {
        [self.x + self.scale * f64::from(x), self.scale * f64::from(y)]
    }
}

impl OutlineBuilder for Placed<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        let p = self.at(x, y);
        self.into.move_to(p);
    }
    fn line_to(&mut self, x: f32, y: f32) {
        let p = self.at(x, y);
        self.into.line_to(p);
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let (middle, p) = (self.at(x1, y1), self.at(x, y));
        self.into.quad_to(middle, p);
    }
    fn curve_to(&mut self, _: f32, _: f32, _: f32, _: f32, x: f32, y: f32) {
        // TrueType outlines have parabolas only
        let p = self.at(x, y);
        self.into.line_to(p);
    }
    fn close(&mut self) {
        self.into.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_faces_have_the_letters_of_figures() {
        for face in [Face::Regular, Face::Bold, Face::Oblique] {
            assert!(has(face, "Fyδαθξηφμrω0123456789.,%°()=→−×–"), "{face:?}");
            assert!(!has(face, "漢"));
            assert_eq!(width(face, "漢", 10.0), width(face, "?", 10.0));
        }
        let plain: String = (' '..='~').chain(['\u{2212}']).collect();
        assert!(has(Face::Regular, &plain), "numbers and columns of plots");
        let em = width(Face::Regular, "M", 10.0);
        assert!(em > 7.0 && em < 10.0, "{em}");
    }
}
