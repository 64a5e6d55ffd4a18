//! Sections whose axis need not run through their centroid, by integrals over them.
//!
//! ```text
//!      o                  o: corners, the points where stress is told
//!      |  ^ 2             x: the axis of the beam, origin of both axes
//!      |  |               s: shear centre   c: centroid
//!      |c +--> 1
//!      sx--------o
//! ```
//! docs/theory.md section 3.14.

use super::trapezoid;
use super::walls::{Fault, Wall, integrals};
use std::f64::consts::{FRAC_PI_3, PI, TAU};

/// A section by its integrals; places are along axes 1 and 2 from the axis of the beam.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// Name, as `SECTION=` has it.
    pub name: &'static str,
    /// Area [L2].
    pub area: f64,
    /// Centroid [L].
    pub centroid: [f64; 2],
    /// I11, I12, I22 about the centroid [L4].
    pub second_moments: [f64; 3],
    /// Torsion constant J [L4].
    pub torsion: f64,
    /// Where a force leaves the section without twist [L].
    pub shear_center: [f64; 2],
    /// k of K = k G A [1].
    pub shear_factor: f64,
    /// Outermost points, at which stress is told [L].
    pub corners: Vec<[f64; 2]>,
    /// Outer radius of a round one [L].
    pub radius: Option<f64>,
}

/// A full rectangle with sides along the axes [L].
#[derive(Debug, Clone, Copy, PartialEq)]
struct Plate {
    low: [f64; 2],
    high: [f64; 2],
}

impl Plate {
    fn size(&self) -> [f64; 2] {
        [self.high[0] - self.low[0], self.high[1] - self.low[1]]
    }

    fn middle(&self) -> [f64; 2] {
        [0.5 * (self.low[0] + self.high[0]), 0.5 * (self.low[1] + self.high[1])]
    }

    /// The same as a wall along its longer side.
    fn wall(&self) -> Wall {
        let ([width, height], [x, y]) = (self.size(), self.middle());
        match width > height {
            true => Wall { ends: [[self.low[0], y], [self.high[0], y]], thickness: height },
            false => Wall { ends: [[x, self.low[1]], [x, self.high[1]]], thickness: width },
        }
    }
}

/// Area, centroid and I11, I12, I22 about it of plates that do not overlap.
fn full(plates: &[Plate]) -> (f64, [f64; 2], [f64; 3]) {
    let area = |plate: &Plate| plate.size()[0] * plate.size()[1];
    let whole: f64 = plates.iter().map(area).sum();
    let centroid = [0, 1]
        .map(|k| plates.iter().map(|plate| area(plate) * plate.middle()[k]).sum::<f64>() / whole);
    let moment = |i: usize, j: usize| {
        let about = |plate: &Plate| {
            let arm = |k: usize| plate.middle()[k] - centroid[k];
            let own = if i == j { plate.size()[i].powi(2) / 12.0 } else { 0.0 };
            area(plate) * (own + arm(i) * arm(j))
        };
        plates.iter().map(about).sum::<f64>()
    };
    (whole, centroid, [moment(1, 1), moment(0, 1), moment(0, 0)])
}

impl Profile {
    /// Straight thin walls, one after the other: `ARBITRARY`.
    ///
    /// # Errors
    /// What keeps the walls from being a section.
    pub fn of_walls(walls: &[Wall]) -> Result<Self, Fault> {
        let own = integrals(walls)?;
        Ok(Self {
            name: "ARBITRARY",
            area: own.area,
            centroid: own.centroid,
            second_moments: own.second_moments,
            torsion: own.torsion,
            shear_center: own.shear_center,
            shear_factor: 1.0,
            corners: own.corners,
            radius: None,
        })
    }

    /// An angle of outer sizes along axes 1 and 2 and thicknesses of the legs along them [L]; the axis
    /// of the beam is where the middle lines of both meet.
    pub fn angle([width, height]: [f64; 2], [along, up]: [f64; 2]) -> Self {
        let (left, bottom) = (-0.5 * up, -0.5 * along);
        let (right, top) = (width + left, height + bottom);
        let plates = [
            Plate { low: [left, bottom], high: [right, bottom + along] },
            Plate { low: [left, bottom + along], high: [left + up, top] },
        ];
        let (area, centroid, second_moments) = full(&plates);
        Self {
            name: "L",
            area,
            centroid,
            second_moments,
            torsion: (width * along.powi(3) + (height - along) * up.powi(3)) / 3.0,
            shear_center: [0.0; 2],
            shear_factor: 1.0,
            corners: vec![
                [right, bottom],
                [right, bottom + along],
                [left, bottom],
                [left + up, top],
                [left, top],
            ],
            radius: None,
        }
    }

    /// Two flanges and a web whose axis has the distance `origin` from the bottom: widths of bottom
    /// and top flange, thicknesses of bottom flange, top flange and web [L].
    pub fn flanged(
        (origin, height): (f64, f64),
        [bottom, top]: [f64; 2],
        [low, high, web]: [f64; 3],
    ) -> Self {
        let plate = |width: f64, from: f64, to: f64| Plate {
            low: [-0.5 * width, from - origin],
            high: [0.5 * width, to - origin],
        };
        let plates = [
            plate(bottom, 0.0, low),
            plate(web, low, height - high),
            plate(top, height - high, height),
        ];
        let (area, centroid, second_moments) = full(&plates);
        let of = |plate: &Plate| {
            let wall = plate.wall();
            let [[a, b], [c, d]] = wall.ends;
            (c - a).hypot(d - b) * wall.thickness.powi(3) / 3.0
        };
        Self {
            name: "I",
            area,
            centroid,
            second_moments,
            torsion: plates.iter().map(of).sum(),
            shear_center: [0.0, flanges_shear_center([bottom, top], [low, high], height) - origin],
            shear_factor: 0.44,
            corners: corners(&plates[0]).into_iter().chain(corners(&plates[2])).collect(),
            radius: None,
        }
    }

    /// A rectangular tube of outer width and height with thicknesses right, top, left, bottom [L];
    /// the axis of the beam is the middle of the outer rectangle.
    ///
    /// # Errors
    /// What keeps the walls from being a tube.
    pub fn tube([width, height]: [f64; 2], walls: [f64; 4]) -> Result<Self, Fault> {
        let [right, top, left, bottom] = walls;
        let (x, y) = (0.5 * width, 0.5 * height);
        let plates = [
            Plate { low: [-x, -y], high: [x, bottom - y] },
            Plate { low: [x - right, bottom - y], high: [x, y - top] },
            Plate { low: [-x, y - top], high: [x, y] },
            Plate { low: [-x, bottom - y], high: [left - x, y - top] },
        ];
        let (area, centroid, second_moments) = full(&plates);
        let middle = [
            [0.5 * left - x, 0.5 * bottom - y],
            [x - 0.5 * right, 0.5 * bottom - y],
            [x - 0.5 * right, y - 0.5 * top],
            [0.5 * left - x, y - 0.5 * top],
        ];
        let around: [Wall; 4] = std::array::from_fn(|k| Wall {
            ends: [middle[k], middle[(k + 1) % 4]],
            thickness: [bottom, right, top, left][k],
        });
        let thin = integrals(&around)?;
        Ok(Self {
            name: "BOX",
            area,
            centroid,
            second_moments,
            torsion: thin.torsion,
            shear_center: thin.shear_center,
            shear_factor: 0.44,
            corners: vec![[-x, -y], [x, -y], [x, y], [-x, y]],
            radius: None,
        })
    }

    /// A full trapezoid of widths at bottom and top and a height [L], symmetric about axis 2, whose
    /// axis has the distance `origin` from the bottom. Its shear centre is taken for its centroid.
    pub fn trapezoid([bottom, top]: [f64; 2], height: f64, origin: f64) -> Self {
        let sum = bottom + top;
        let centroid = [0.0, height * (bottom + 2.0 * top) / (3.0 * sum) - origin];
        let squares = bottom * bottom + top * top;
        let first = height.powi(3) * (squares + 4.0 * bottom * top) / (36.0 * sum);
        Self {
            name: "TRAPEZOID",
            area: 0.5 * height * sum,
            centroid,
            second_moments: [first, 0.0, height * sum * squares / 48.0],
            torsion: trapezoid::torsion([bottom, top], height),
            shear_center: centroid,
            shear_factor: 0.822,
            corners: vec![
                [-0.5 * bottom, -origin],
                [0.5 * bottom, -origin],
                [-0.5 * top, height - origin],
                [0.5 * top, height - origin],
            ],
            radius: None,
        }
    }

    /// A tube of an outer radius and a thickness of the wall [L]; its shear factor is Cowper's for a
    /// Poisson ratio of 0.3, from 0.53 of a thin one to 0.89 of a full one.
    pub fn thick_pipe(radius: f64, wall: f64) -> Self {
        let inner = radius - wall;
        let moment = 0.25 * PI * (radius.powi(4) - inner.powi(4));
        let ratio = (inner / radius).powi(2);
        let both = (1.0 + ratio).powi(2);
        Self {
            name: "THICK PIPE",
            area: PI * (radius * radius - inner * inner),
            centroid: [0.0; 2],
            second_moments: [moment, 0.0, moment],
            torsion: 2.0 * moment,
            shear_center: [0.0; 2],
            shear_factor: 7.8 * both / (8.8 * both + 23.6 * ratio),
            corners: around(radius, 8),
            radius: Some(radius),
        }
    }

    /// A tube with six equal sides: radius of the circle round it, thickness of its walls [L].
    pub fn hexagon(radius: f64, wall: f64) -> Self {
        let inner = radius - wall / FRAC_PI_3.sin();
        let middle = 0.5 * (radius + inner);
        let root = 3.0_f64.sqrt();
        let moment = 5.0 * root / 16.0 * (radius.powi(4) - inner.powi(4));
        Self {
            name: "HEX",
            area: 1.5 * root * (radius * radius - inner * inner),
            centroid: [0.0; 2],
            second_moments: [moment, 0.0, moment],
            torsion: 4.5 * wall * middle.powi(3),
            shear_center: [0.0; 2],
            shear_factor: 0.53,
            corners: around(radius, 6),
            radius: None,
        }
    }

    /// Where it begins and ends along axis 1 or axis 2, counted from 0 [L].
    pub(super) fn extent(&self, axis: usize) -> [f64; 2] {
        let start = [f64::INFINITY, f64::NEG_INFINITY];
        self.corners
            .iter()
            .fold(start, |[low, high], corner| [low.min(corner[axis]), high.max(corner[axis])])
    }
}

/// So many points on a circle [L], the first one on axis 1.
pub(super) fn around(radius: f64, count: u32) -> Vec<[f64; 2]> {
    let at = |k: u32| {
        let (s, c) = (TAU * f64::from(k) / f64::from(count)).sin_cos();
        [radius * c, radius * s]
    };
    (0..count).map(at).collect()
}

/// The lower left, lower right, upper left and upper right corner.
fn corners(plate: &Plate) -> [[f64; 2]; 4] {
    let ([a, b], [c, d]) = (plate.low, plate.high);
    [[a, b], [c, b], [a, d], [c, d]]
}

/// Distance of the shear centre of an I from its bottom [L]: both flanges bend alike about it.
fn flanges_shear_center(widths: [f64; 2], [low, high]: [f64; 2], height: f64) -> f64 {
    let [bottom, top] = [low * widths[0].powi(3), high * widths[1].powi(3)];
    (bottom * 0.5 * low + top * (height - 0.5 * high)) / (bottom + top)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: f64, b: f64) {
        assert!((a - b).abs() < 1e-12 * a.abs().max(b.abs()).max(1.0), "{a} {b}");
    }

    /// Integrals of a region over a fine grid of its bounding box: area, first and second moments.
    fn counted(inside: impl Fn(f64, f64) -> bool, [low, high]: [[f64; 2]; 2]) -> [f64; 6] {
        let n = 1200;
        let [dx, dy] = [0, 1].map(|k| (high[k] - low[k]) / f64::from(n));
        let mut sums = [0.0; 6];
        for i in 0..n {
            for j in 0..n {
                let (x, y) =
                    (low[0] + (f64::from(i) + 0.5) * dx, low[1] + (f64::from(j) + 0.5) * dy);
                if inside(x, y) {
                    let own = [1.0, x, y, y * y, x * y, x * x];
                    sums.iter_mut().zip(own).for_each(|(sum, own)| *sum += own * dx * dy);
                }
            }
        }
        sums
    }

    fn agrees(profile: &Profile, counted: [f64; 6]) {
        let [area, x, y, first, mixed, second] = counted;
        let [c, d] = [x / area, y / area];
        let size = profile.second_moments[0] + profile.second_moments[2];
        let close = |a: f64, b: f64, size: f64| {
            assert!((a - b).abs() < 4e-3 * size, "{}: {a} {b}", profile.name)
        };
        close(profile.area, area, area);
        close(profile.centroid[0], c, area.sqrt());
        close(profile.centroid[1], d, area.sqrt());
        let moments = [first - area * d * d, mixed - area * c * d, second - area * c * c];
        profile.second_moments.iter().zip(moments).for_each(|(own, by)| close(*own, by, size));
    }

    /// Requirement: area, centroid and second moments of every profile are those counted over a
    /// grid of its region. Tolerance: the grid.
    #[test]
    fn integrals_are_those_of_the_region() {
        let angle = Profile::angle([4.0, 6.0], [0.5, 0.8]);
        let l = |x: f64, y: f64| x < 4.0 - 0.4 && y < 6.0 - 0.25 && (y < 0.25 || x < 0.4);
        agrees(&angle, counted(l, [[-0.4, -0.25], [3.6, 5.75]]));
        let i = Profile::flanged((1.0, 6.0), [3.0, 5.0], [0.4, 0.6, 0.3]);
        let flange = |x: f64, y: f64| {
            (y < -0.6 && x.abs() < 1.5) || (y > 4.4 && x.abs() < 2.5) || x.abs() < 0.15
        };
        agrees(&i, counted(flange, [[-2.5, -1.0], [2.5, 5.0]]));
        let tube = Profile::tube([4.0, 6.0], [0.2, 0.4, 0.6, 0.8]).unwrap();
        let hollow =
            |x: f64, y: f64| !(x > -2.0 + 0.6 && x < 2.0 - 0.2 && y > -3.0 + 0.8 && y < 3.0 - 0.4);
        agrees(&tube, counted(hollow, [[-2.0, -3.0], [2.0, 3.0]]));
        let trapezoid = Profile::trapezoid([4.0, 1.0], 3.0, 0.5);
        let slanted = |x: f64, y: f64| 2.0 * x.abs() < 4.0 - (y + 0.5);
        agrees(&trapezoid, counted(slanted, [[-2.0, -0.5], [2.0, 2.5]]));
        let hexagon = Profile::hexagon(2.0, 0.3);
        let apothem = |x: f64, y: f64| {
            let along = |k: f64| {
                let (s, c) = (FRAC_PI_3 * (k + 0.5)).sin_cos();
                (c * x + s * y).abs()
            };
            along(0.0).max(along(1.0)).max(along(2.0))
        };
        let rim = 3.0_f64.sqrt();
        let six = |x: f64, y: f64| (rim - 0.3..rim).contains(&apothem(x, y));
        agrees(&hexagon, counted(six, [[-2.0, -2.0], [2.0, 2.0]]));
    }

    /// Requirement: an angle, an I and a tube of thin walls are sheared without twist where the
    /// same walls without thickness are, and resist torsion as those. Tolerance: the part of a
    /// thickness in a length.
    #[test]
    fn thin_profiles_are_their_walls() {
        let wall = |a: [f64; 2], b: [f64; 2], thickness| Wall { ends: [a, b], thickness };
        let t = 1e-4;
        let angle = Profile::angle([4.0, 6.0], [t, 2.0 * t]);
        let walls = [wall([4.0, 0.0], [0.0; 2], t), wall([0.0; 2], [0.0, 6.0], 2.0 * t)];
        let i = Profile::flanged((1.0, 6.0), [3.0, 5.0], [t, 2.0 * t, 3.0 * t]);
        let flanges = [
            wall([-1.5, -1.0], [0.0, -1.0], t),
            wall([0.0, -1.0], [1.5, -1.0], t),
            wall([0.0, -1.0], [0.0, 5.0], 3.0 * t),
            wall([-2.5, 5.0], [0.0, 5.0], 2.0 * t),
            wall([0.0, 5.0], [2.5, 5.0], 2.0 * t),
        ];
        for (profile, walls) in [(angle, &walls[..]), (i, &flanges[..])] {
            let thin = Profile::of_walls(walls).unwrap();
            let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-3 * b.abs().max(1e-3));
            close(profile.torsion / (t * t * t), thin.torsion / (t * t * t));
            close(profile.shear_center[0], thin.shear_center[0]);
            close(profile.shear_center[1], thin.shear_center[1]);
            (0..3).for_each(|k| {
                close(profile.second_moments[k] / t, thin.second_moments[k] / t);
            });
        }
        near(Profile::tube([4.0, 4.0], [t; 4]).unwrap().shear_center[0], 0.0);
        near(Profile::thick_pipe(1.0, 1.0).shear_factor, 7.8 / 8.8);
    }
}
