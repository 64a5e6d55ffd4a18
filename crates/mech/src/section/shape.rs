//! Shapes of sections: area, second moment of area, extents.

use std::f64::consts::PI;

/// Shape of a section whose axis runs through its centroid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// Width out of the plane, height in the plane [L].
    Rectangle {
        /// Along axis 1.
        width: f64,
        /// Along axis 2.
        height: f64,
    },
    /// A full circle of that radius [L].
    Circle(f64),
    /// A tube.
    Pipe {
        /// Outer radius [L].
        radius: f64,
        /// Thickness of the wall [L].
        wall: f64,
    },
    /// A rectangular tube, symmetric about its axes.
    Box {
        /// Outer width along axis 1, outer height along axis 2 [L].
        size: [f64; 2],
        /// Thickness of the walls along axis 2, and of those along axis 1 [L].
        walls: [f64; 2],
    },
    /// Two flanges and a web.
    Flanged {
        /// Height [L].
        height: f64,
        /// Widths of the bottom and the top flange [L].
        widths: [f64; 2],
        /// Thicknesses of the bottom flange, the top flange and the web [L].
        walls: [f64; 3],
    },
    /// Area [L2] and second moments of area [L4] as given.
    General {
        /// A.
        area: f64,
        /// I11 about axis 1, the product I12, I22 about axis 2; a plane beam has the first one.
        second_moments: [f64; 3],
        /// Torsion constant J; of no meaning in the plane.
        torsion: f64,
    },
}

impl Shape {
    /// Area A [L2].
    pub fn area(&self) -> f64 {
        match *self {
            Self::Rectangle { width, height } => width * height,
            Self::Circle(radius) => PI * radius * radius,
            Self::Pipe { radius, wall } => PI * wall * (2.0 * radius - wall),
            Self::Box { size: [a, b], walls: [s, t] } => a * b - (a - 2.0 * s) * (b - 2.0 * t),
            Self::Flanged { .. } => self.plates().iter().map(|plate| plate.area()).sum(),
            Self::General { area, .. } => area,
        }
    }

    /// Second moment of area I about axis 1, out of the plane of bending [L4].
    pub fn second_moment(&self) -> f64 {
        match *self {
            Self::Rectangle { width, height } => width * height.powi(3) / 12.0,
            Self::Circle(radius) => 0.25 * PI * radius.powi(4),
            Self::Pipe { radius, wall } => {
                let inner = radius - wall;
                0.25 * self.area() * (radius * radius + inner * inner)
            }
            Self::Box { size: [a, b], walls: [s, t] } => {
                (a * b.powi(3) - (a - 2.0 * s) * (b - 2.0 * t).powi(3)) / 12.0
            }
            Self::Flanged { .. } => {
                let centroid = self.centroid();
                let about = |plate: &Plate| {
                    let arm = plate.middle - centroid;
                    plate.area() * (plate.height * plate.height / 12.0 + arm * arm)
                };
                self.plates().iter().map(about).sum()
            }
            Self::General { second_moments: [own, ..], .. } => own,
        }
    }

    /// Distance of the centroid from the bottom [L].
    pub fn centroid(&self) -> f64 {
        match self {
            Self::Flanged { .. } => {
                let first: f64 = self.plates().iter().map(|p| p.area() * p.middle).sum();
                first / self.area()
            }
            _ => 0.5 * self.height(),
        }
    }

    /// Extent along axis 2 [L]; of a section without a shape that of a rectangle with its area and
    /// second moment.
    pub fn height(&self) -> f64 {
        match *self {
            Self::Rectangle { height, .. } | Self::Flanged { height, .. } => height,
            Self::Circle(radius) | Self::Pipe { radius, .. } => 2.0 * radius,
            Self::Box { size: [_, height], .. } => height,
            Self::General { area, second_moments: [own, ..], .. } => (12.0 * own / area).sqrt(),
        }
    }

    /// Extent along axis 1 [L].
    pub fn width(&self) -> f64 {
        match *self {
            Self::Rectangle { width, .. } => width,
            Self::Circle(radius) | Self::Pipe { radius, .. } => 2.0 * radius,
            Self::Box { size: [width, _], .. } => width,
            Self::Flanged { widths: [a, b], .. } => a.max(b),
            Self::General { .. } => self.area() / self.height(),
        }
    }

    /// Shear factor k: of K = k G A. [Abaqus manual, choosing a beam cross-section]
    pub fn shear_factor(&self) -> f64 {
        match self {
            Self::Rectangle { .. } => 0.85,
            Self::Circle(_) => 0.89,
            Self::Pipe { .. } => 0.53,
            Self::Box { .. } | Self::Flanged { .. } => 0.44,
            Self::General { .. } => 1.0,
        }
    }

    /// Name, as `SECTION=` has it.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Rectangle { .. } => "RECT",
            Self::Circle(_) => "CIRC",
            Self::Pipe { .. } => "PIPE",
            Self::Box { .. } => "BOX",
            Self::Flanged { .. } => "I",
            Self::General { .. } => "GENERAL",
        }
    }

    /// Bottom flange, web and top flange; of another shape none.
    pub(super) fn plates(&self) -> [Plate; 3] {
        let Self::Flanged { height, widths: [bottom, top], walls: [low, high, web] } = *self else {
            return [Plate { width: 0.0, height: 0.0, middle: 0.0 }; 3];
        };
        let between = height - low - high;
        [
            Plate { width: bottom, height: low, middle: 0.5 * low },
            Plate { width: web, height: between, middle: low + 0.5 * between },
            Plate { width: top, height: high, middle: height - 0.5 * high },
        ]
    }
}

/// A rectangular part of a section.
#[derive(Clone, Copy)]
pub(super) struct Plate {
    /// Along axis 1 [L].
    pub width: f64,
    /// Along axis 2 [L].
    pub height: f64,
    /// Distance of its middle from the bottom [L].
    middle: f64,
}

impl Plate {
    fn area(&self) -> f64 {
        self.width * self.height
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: areas and second moments are those by hand: a pipe is a circle less a circle, a
    /// box and an I are sums of rectangles, about the centroid; an I without web holes is a
    /// rectangle. Tolerance: rounding.
    #[test]
    fn areas_and_second_moments() {
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-14 * b.abs(), "{a} {b}");
        let (pipe, outer, inner) =
            (Shape::Pipe { radius: 2.0, wall: 0.5 }, Shape::Circle(2.0), Shape::Circle(1.5));
        near(pipe.area(), outer.area() - inner.area());
        near(pipe.second_moment(), outer.second_moment() - inner.second_moment());
        let tube = Shape::Box { size: [4.0, 6.0], walls: [0.5, 1.0] };
        near(tube.area(), 24.0 - 12.0);
        near(tube.second_moment(), (4.0 * 216.0 - 3.0 * 64.0) / 12.0);
        let walls = [1.0, 2.0, 3.0];
        let full = Shape::Flanged { height: 6.0, widths: [3.0; 2], walls };
        near(full.second_moment(), 3.0 * 216.0 / 12.0);
        near(full.centroid(), 3.0);
        let tee = Shape::Flanged { height: 5.0, widths: [0.0, 4.0], walls: [0.0, 1.0, 1.0] };
        near(tee.area(), 8.0);
        near(tee.centroid(), (4.0 * 4.5 + 4.0 * 2.0) / 8.0);
        near(
            tee.second_moment(),
            4.0 / 12.0 + 4.0 * 1.25_f64.powi(2) + 64.0 / 12.0 + 4.0 * 1.25_f64.powi(2),
        );
        let general = Shape::General { area: 6.0, second_moments: [4.5, 0.0, 4.5], torsion: 9.0 };
        near(general.height(), 3.0);
        near(general.width(), 2.0);
    }
}
