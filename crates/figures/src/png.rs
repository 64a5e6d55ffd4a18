//! A scene as dots.

use crate::colour::{BLACK, Colour};
use crate::font::{self, Pieces};
use crate::scene::{Item, Pen, Scene, Text};
use tiny_skia::{
    Color, FillRule, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform,
};

/// Metres to an inch.
const INCH: f64 = 0.0254;

impl Scene {
    /// The figure as a PNG file of so many dots an inch; `None` for one without
    /// extent. Letters that the built-in fonts lack are shown as question marks.
    pub fn png(&self, dots_per_inch: f64) -> Option<Vec<u8>> {
        let scale = dots_per_inch / self.unit.per_inch();
        let size = |length: f64| (length * scale).round() as u32;
        let mut dots = Pixmap::new(size(self.width), size(self.height))?;
        dots.fill(Color::WHITE);
        let transform = Transform::from_scale(scale as f32, scale as f32);
        for item in &self.items {
            draw(&mut dots, item, transform);
        }
        encode(&dots, dots_per_inch).ok()
    }
}

/// Nothing shines through: three channels say all, and one says all greys.
fn encode(dots: &Pixmap, dots_per_inch: f64) -> Result<Vec<u8>, png::EncodingError> {
    let colours = || dots.data().as_chunks::<4>().0.iter();
    let is_grey = colours().all(|dot| dot[0] == dot[1] && dot[1] == dot[2]);
    let data: Vec<u8> = if is_grey {
        colours().map(|dot| dot[0]).collect()
    } else {
        colours().flat_map(|dot| [dot[0], dot[1], dot[2]]).collect()
    };
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, dots.width(), dots.height());
    encoder.set_color(if is_grey { png::ColorType::Grayscale } else { png::ColorType::Rgb });
    encoder.set_depth(png::BitDepth::Eight);
    let per_metre = (dots_per_inch / INCH).round() as u32;
    encoder.set_pixel_dims(Some(png::PixelDimensions {
        xppu: per_metre,
        yppu: per_metre,
        unit: png::Unit::Meter,
    }));
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&data)?;
    writer.finish()?;
    Ok(file)
}

fn draw(dots: &mut Pixmap, item: &Item, transform: Transform) {
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
            paint(dots, path.finish(), (*fill, *pen), transform);
        }
        Item::Circle { centre: [x, y], radius, fill, pen } => {
            let circle = PathBuilder::from_circle(*x as f32, *y as f32, *radius as f32);
            paint(dots, circle, (*fill, *pen), transform);
        }
        Item::Text(words) => write(dots, words, transform),
    }
}

fn ink([red, green, blue]: Colour) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(red, green, blue, 255);
    paint.anti_alias = true;
    paint
}

fn paint(
    dots: &mut Pixmap,
    path: Option<Path>,
    (fill, pen): (Option<Colour>, Option<Pen>),
    transform: Transform,
) {
    let Some(path) = path else { return };
    if let Some(colour) = fill {
        dots.fill_path(&path, &ink(colour), FillRule::Winding, transform, None);
    }
    if let Some(pen) = pen {
        let stroke = Stroke {
            width: pen.width as f32,
            line_join: LineJoin::Round,
            dash: StrokeDash::new(pen.dash.lengths().to_vec(), 0.0),
            ..Stroke::default()
        };
        dots.stroke_path(&path, &ink(pen.colour), &stroke, transform, None);
    }
}

fn write(dots: &mut Pixmap, words: &Text, transform: Transform) {
    let mut letters = Letters { path: PathBuilder::new(), origin: [0.0; 2], words };
    for run in words.runs() {
        letters.origin = run.offset;
        font::outline(run.face, &run.letters, run.size, &mut letters);
    }
    if let Some(path) = letters.path.finish() {
        dots.fill_path(&path, &ink(BLACK), FillRule::Winding, transform, None);
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
