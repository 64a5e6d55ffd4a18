//! A scene as dots: one byte of grey each, 300 an inch.

use super::font::{self, Pieces};
use super::scene::{Item, Pen, Scene, Text};
use tiny_skia::{
    Color, FillRule, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform,
};

/// Dots per point: 300 an inch.
const SCALE: f64 = 300.0 / 72.0;
/// 300 dots an inch, in dots per metre.
const DOTS_PER_METRE: u32 = 11811;

impl Scene {
    /// The figure as a PNG file; `None` for a figure without extent.
    pub fn png(&self) -> Option<Vec<u8>> {
        let size = |length: f64| (length * SCALE).round() as u32;
        let mut dots = Pixmap::new(size(self.width), size(self.height))?;
        dots.fill(Color::WHITE);
        for item in &self.items {
            draw(&mut dots, item);
        }
        // all colours are grey and nothing shines through: one channel says it
        let grey: Vec<u8> = dots.data().iter().step_by(4).copied().collect();
        encode(&grey, dots.width(), dots.height()).ok()
    }
}

fn encode(grey: &[u8], width: u32, height: u32) -> Result<Vec<u8>, png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_pixel_dims(Some(png::PixelDimensions {
        xppu: DOTS_PER_METRE,
        yppu: DOTS_PER_METRE,
        unit: png::Unit::Meter,
    }));
    let mut writer = encoder.write_header()?;
    writer.write_image_data(grey)?;
    writer.finish()?;
    Ok(file)
}

fn draw(dots: &mut Pixmap, item: &Item) {
    match item {
        Item::Path { points, closed, fill, pen } => {
            let mut path = PathBuilder::new();
            for (place, [x, y]) in points.iter().enumerate() {
                let (x, y) = (*x as f32, *y as f32);
                if place == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
            }
            if *closed {
                path.close();
            }
            paint(dots, path.finish(), *fill, *pen);
        }
        Item::Circle { centre: [x, y], radius, fill, pen } => {
            let circle = PathBuilder::from_circle(*x as f32, *y as f32, *radius as f32);
            paint(dots, circle, *fill, *pen);
        }
        Item::Text(words) => write(dots, words),
    }
}

fn scale() -> Transform {
    Transform::from_scale(SCALE as f32, SCALE as f32)
}

fn ink(grey: u8) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(grey, grey, grey, 255);
    paint.anti_alias = true;
    paint
}

fn paint(dots: &mut Pixmap, path: Option<Path>, fill: Option<u8>, pen: Option<Pen>) {
    let Some(path) = path else { return };
    if let Some(grey) = fill {
        dots.fill_path(&path, &ink(grey), FillRule::Winding, scale(), None);
    }
    if let Some(pen) = pen {
        let stroke = Stroke {
            width: pen.width as f32,
            line_join: LineJoin::Round,
            dash: StrokeDash::new(pen.dash.lengths().to_vec(), 0.0),
            ..Stroke::default()
        };
        dots.stroke_path(&path, &ink(pen.grey), &stroke, scale(), None);
    }
}

fn write(dots: &mut Pixmap, words: &Text) {
    let mut letters = Letters { path: PathBuilder::new(), origin: [0.0; 2], words };
    for run in words.runs() {
        letters.origin = run.offset;
        font::outline(run.face, &run.letters, run.size, &mut letters);
    }
    if let Some(path) = letters.path.finish() {
        dots.fill_path(&path, &ink(super::BLACK), FillRule::Winding, scale(), None);
    }
}

/// Puts outlines of letters where the text stands.
struct Letters<'a> {
    path: PathBuilder,
    origin: [f64; 2],
    words: &'a Text,
}

impl Letters<'_> {
    fn at(&self, [x, y]: [f64; 2]) -> (f32, f32) {
        let [x, y] = [self.origin[0] + x, self.origin[1] - y];
        let [x, y] = if self.words.upwards { [y, -x] } else { [x, y] };
        ((self.words.at[0] + x) as f32, (self.words.at[1] + y) as f32)
    }
}

impl Pieces for Letters<'_> {
    fn move_to(&mut self, p: [f64; 2]) {
        let (x, y) = self.at(p);
        self.path.move_to(x, y);
    }
    fn line_to(&mut self, p: [f64; 2]) {
        let (x, y) = self.at(p);
        self.path.line_to(x, y);
    }
    fn quad_to(&mut self, middle: [f64; 2], p: [f64; 2]) {
        let ((x1, y1), (x, y)) = (self.at(middle), self.at(p));
        self.path.quad_to(x1, y1, x, y);
    }
    fn close(&mut self) {
        self.path.close();
    }
}
