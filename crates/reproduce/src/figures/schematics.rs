//! Figure 1: schematics of both problems.
//!
//! Lengths are those of the drawing, in millimetres of a beam of 50 or so;
//! deflections are larger than they would be.

use super::beams::clamp;
use super::figure::{Figure, scene};
use slideline_figures::{Anchor, BLACK, DARK, Dash, GREY, Pen, Rectangle, Scene, Text, View};

const THIN: Pen = Pen::solid(0.6);
const HEAVY: Pen = Pen::solid(2.0);

/// A cantilever bent by a point load, and the circle that bends it.
struct Bent {
    base: [f64; 2],
    /// Unit vectors along xi and eta.
    along: [f64; 2],
    across: [f64; 2],
    length: f64,
    contact: f64,
    deflection: f64,
}

impl Bent {
    fn point(&self, xi: f64, eta: f64) -> [f64; 2] {
        [0, 1].map(|i| self.base[i] + xi * self.along[i] + eta * self.across[i])
    }

    /// Diehl (1995) eq. (1), and straight beyond the load.
    fn deflected(&self, xi: f64) -> f64 {
        let (l, u) = (self.contact, self.deflection);
        if xi <= l {
            0.5 * u * xi * xi * (3.0 * l - xi) / (l * l * l)
        } else {
            u + self.slope() * (xi - l)
        }
    }

    fn slope(&self) -> f64 {
        1.5 * self.deflection / self.contact
    }

    fn line(&self) -> Vec<[f64; 2]> {
        let at = |i: u32| {
            let xi = self.length * f64::from(i) / 60.0;
            self.point(xi, self.deflected(xi))
        };
        (0..=60).map(at).collect()
    }

    fn touch(&self) -> [f64; 2] {
        self.point(self.contact, self.deflection)
    }

    /// Unit normal of the bent beam at the contact, towards the circle.
    fn normal(&self) -> [f64; 2] {
        let (s, c) = self.slope().atan().sin_cos();
        [0, 1].map(|i| c * self.across[i] - s * self.along[i])
    }

    fn centre(&self, radius: f64) -> [f64; 2] {
        let (p, n) = (self.touch(), self.normal());
        [0, 1].map(|i| p[i] + radius * n[i])
    }
}

/// Both problems side by side.
pub(super) fn figure_1() -> Figure {
    let mut scene = scene(292.0, "Schematics of both problems");
    scene.text(Text::new([6.0, 14.0], "a) First example problem").bold());
    scene.text(Text::new([214.0, 14.0], "b) Second example problem").bold());
    first(&mut scene);
    second(&mut scene);
    Figure::new(
        "fig1",
        scene,
        "Schematics of the problems: a rigid circle is pushed along a cantilever (a), \
                  a rigid cam is turned into one (b). Deflections are exaggerated.",
    )
}

fn first(scene: &mut Scene) {
    let window = Rectangle { left: 4.0, top: 22.0, width: 196.0, height: 266.0 };
    let view = View { window, middle: [7.0, 27.5], scale: 3.75 };
    let (s, c) = 8f64.to_radians().sin_cos();
    let bent = Bent {
        base: [4.75, 0.0],
        along: [s, c],
        across: [-c, s],
        length: 56.0,
        contact: 38.0,
        deflection: -2.6,
    };
    let radius = 13.0;
    let centre = bent.centre(radius);
    let path = centre[0]; // the Y axis is the path of the centre
    axes(scene, &view, [path, 0.0], [[1.0, 0.0], [0.0, 1.0]], [25.0, 58.0], ["X", "Y"]);
    local_axes(scene, &view, &bent, [57.5, 10.0]);
    view.line(scene, &bent.line(), HEAVY);
    clamp(scene, &view, bent.base, bent.along, 3.6);
    view.circle(scene, centre, radius, Pen::solid(1.2));
    view.dot(scene, centre, 2.0, Some(BLACK), None);
    // inclination
    view.line(scene, &[bent.base, [bent.base[0], 25.0]], THIN.colour(GREY));
    view.arc(scene, bent.base, 19.0, [82f64.to_radians(), 90f64.to_radians()], THIN);
    view.label(scene, [bent.base[0] + 1.5, 20.3], [0.0, 0.0], "*\u{3b1}*");
    // radius
    let (sin, cos) = 140f64.to_radians().sin_cos();
    view.arrow(scene, centre, [centre[0] + radius * cos, centre[1] + radius * sin], THIN);
    view.label(scene, centre, [-13.0, -19.0], "*r*");
    // the motion
    let from = [centre[0], centre[1] - 2.5];
    view.arrow(scene, from, [centre[0], centre[1] - 9.5], Pen::solid(1.6));
    view.label(scene, from, [-22.0, 16.0], "*\u{3b4}y*, *F*_{y}");
    force(scene, &view, &bent, [6.0, 13.0]);
    // dimensions
    let low = -4.5;
    dimension(scene, &view, [[path, low], [bent.base[0], low]]);
    view.line(scene, &[[path, 0.0], [path, low - 1.0]], THIN.colour(GREY));
    view.line(scene, &[bent.base, [bent.base[0], low - 1.0]], THIN.colour(GREY));
    view.label(scene, [0.5 * (path + bent.base[0]), low], [0.0, 12.0], "*X*_{o}");
    let side = path - 15.5;
    view.line(scene, &[[side - 1.5, centre[1]], centre], THIN.colour(GREY));
    view.line(scene, &[[side - 1.5, 0.0], [path, 0.0]], THIN.colour(GREY));
    dimension(scene, &view, [[side, 0.0], [side, centre[1]]]);
    view.label(scene, [side, 0.45 * centre[1]], [9.0, 3.0], "*Y*_{c}");
}

fn second(scene: &mut Scene) {
    let window = Rectangle { left: 206.0, top: 22.0, width: 244.0, height: 266.0 };
    let view = View { window, middle: [25.5, 6.0], scale: 4.3 };
    let bent = Bent {
        base: [0.0, 0.0],
        along: [1.0, 0.0],
        across: [0.0, 1.0],
        length: 50.0,
        contact: 31.0,
        deflection: -4.0,
    };
    let radius = 9.0;
    let centre = bent.centre(radius);
    let (arm, phi) = (13.0, 32f64.to_radians());
    let pivot = [centre[0] - arm * phi.sin(), centre[1] + arm * phi.cos()];
    local_axes(scene, &view, &bent, [49.0, 12.0]);
    view.line(scene, &bent.line(), HEAVY);
    clamp(scene, &view, bent.base, bent.along, 3.6);
    view.circle(scene, centre, radius, Pen::solid(1.2));
    view.dot(scene, centre, 2.0, Some(BLACK), None);
    view.line(scene, &[pivot, centre], Pen::solid(1.4));
    let half = [0.5 * (pivot[0] + centre[0]), 0.5 * (pivot[1] + centre[1])];
    view.label(scene, half, [11.0, -1.0], "*R*");
    view.dot(scene, pivot, 3.0, Some(BLACK), None);
    // angle from -eta
    view.line(scene, &[pivot, [pivot[0], pivot[1] - 15.0]], THIN.colour(GREY));
    let down = -90f64.to_radians();
    view.arc(scene, pivot, 8.0, [down, down + phi], THIN);
    view.label(
        scene,
        [pivot[0] + 8.0 * (0.5 * phi).sin(), pivot[1] - 8.0],
        [1.0, 11.0],
        "*\u{3c6}*",
    );
    // drive, clockwise
    view.arc(scene, pivot, 5.0, [0.35, 2.9], Pen::solid(1.6));
    let at = |angle: f64| [pivot[0] + 5.0 * angle.cos(), pivot[1] + 5.0 * angle.sin()];
    view.arrow(scene, at(0.5), at(-0.1), Pen::solid(1.6));
    view.label(scene, at(1.57), [0.0, -6.0], "*M*_{z}");
    // radius
    let (sin, cos) = 20f64.to_radians().sin_cos();
    let rim = [centre[0] + radius * cos, centre[1] + radius * sin];
    view.arrow(scene, centre, rim, THIN);
    view.label(scene, centre, [22.0, -12.0], "*r*");
    force(scene, &view, &bent, [-10.0, 16.0]);
    // dimensions of the pivot
    view.line(scene, &[pivot, [13.0, pivot[1]]], THIN.colour(GREY));
    dimension(scene, &view, [[14.5, 0.0], [14.5, pivot[1]]]);
    view.label(scene, [14.5, 0.62 * pivot[1]], [-10.0, 3.0], "*\u{3b7}*_{R}");
    view.line(scene, &[[pivot[0], pivot[1] - 15.0], [pivot[0], -12.0]], THIN.colour(GREY));
    dimension(scene, &view, [[0.0, -11.0], [pivot[0], -11.0]]);
    view.label(scene, [0.5 * pivot[0], -11.0], [0.0, 12.0], "*\u{3be}*_{R}");
    dimension(scene, &view, [[0.0, -17.0], [bent.contact, -17.0]]);
    view.line(scene, &[bent.touch(), [bent.contact, -18.0]], THIN.colour(GREY));
    view.label(scene, [0.5 * bent.contact, -17.0], [0.0, 13.0], "*\u{3be}*_{L}");
}

/// The contact force on the beam, on its line through the circle.
fn force(scene: &mut Scene, view: &View, bent: &Bent, shift: [f64; 2]) {
    let (p, n) = (bent.touch(), bent.normal());
    let tip = [0, 1].map(|i| p[i] - 8.0 * n[i]);
    view.arrow(scene, p, tip, Pen::solid(1.6).colour(DARK));
    view.dot(scene, p, 1.8, Some(BLACK), None);
    let [x, y] = view.at(tip);
    scene.text(Text::new([x + 0.35 * shift[0], y + shift[1]], "*F*").anchor(Anchor::Middle));
}

/// The axes xi, over the undeformed beam, and eta.
fn local_axes(scene: &mut Scene, view: &View, bent: &Bent, [xi, eta]: [f64; 2]) {
    view.line(scene, &[bent.base, bent.point(xi, 0.0)], THIN.dash(Dash::Long));
    view.arrow(scene, bent.point(xi - 1.0, 0.0), bent.point(xi + 2.0, 0.0), THIN);
    view.label(scene, bent.point(xi + 2.0, 0.0), [5.0, -4.0], "*\u{3be}*");
    view.arrow(scene, bent.base, bent.point(0.0, eta), Pen::solid(0.9));
    view.label(scene, bent.point(0.0, eta), [-3.0, -5.0], "*\u{3b7}*");
}

/// Two arrows from a point, with their names at the tips.
fn axes(
    scene: &mut Scene,
    view: &View,
    origin: [f64; 2],
    directions: [[f64; 2]; 2],
    lengths: [f64; 2],
    names: [&str; 2],
) {
    for ((way, length), name) in directions.into_iter().zip(lengths).zip(names) {
        let end = |l: f64| [0, 1].map(|i| origin[i] + l * way[i]);
        view.arrow(scene, origin, end(length), Pen::solid(0.9));
        view.label(scene, end(length + 2.2), [0.0, 3.3], &format!("*{name}*"));
    }
}

/// A line with arrows at both ends.
fn dimension(scene: &mut Scene, view: &View, [from, to]: [[f64; 2]; 2]) {
    let middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
    view.arrow(scene, middle, from, THIN);
    view.arrow(scene, middle, to, THIN);
}
