//! Shapes of sections: area, second moment of area, extents.

use super::profile::{Profile, around};
use std::f64::consts::PI;

/// Shape of a section, whose axis runs through its centroid where nothing else is said.
#[derive(Debug, Clone, PartialEq)]
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
    /// Area [L2] and second moments of area [L4] as given.
    General {
        /// A.
        area: f64,
        /// I11 about axis 1, the product I12, I22 about axis 2, all about the centroid; a plane
        /// beam has the first one.
        second_moments: [f64; 3],
        /// Torsion constant J; of no meaning in the plane.
        torsion: f64,
        /// Centroid along both axes [L].
        centroid: [f64; 2],
        /// Shear centre along both axes [L]; of no meaning in the plane.
        shear_center: [f64; 2],
    },
    /// Another one, by integrals over it.
    Profile(Box<Profile>),
}

impl Shape {
    /// Area A [L2].
    pub fn area(&self) -> f64 {
        match *self {
            Self::Rectangle { width, height } => width * height,
            Self::Circle(radius) => PI * radius * radius,
            Self::Pipe { radius, wall } => PI * wall * (2.0 * radius - wall),
            Self::General { area, .. } => area,
            Self::Profile(ref own) => own.area,
        }
    }

    /// Second moment of area I about the centroid and axis 1, out of the plane of bending [L4].
    pub fn second_moment(&self) -> f64 {
        match *self {
            Self::Rectangle { width, height } => width * height.powi(3) / 12.0,
            Self::Circle(radius) => 0.25 * PI * radius.powi(4),
            Self::Pipe { radius, wall } => {
                let inner = radius - wall;
                0.25 * self.area() * (radius * radius + inner * inner)
            }
            Self::General { second_moments: [own, ..], .. } => own,
            Self::Profile(ref own) => own.second_moments[0],
        }
    }

    /// The centroid along axes 1 and 2, counted from the axis of the beam [L].
    pub fn centroid(&self) -> [f64; 2] {
        match self {
            Self::General { centroid, .. } => *centroid,
            Self::Profile(own) => own.centroid,
            _ => [0.0; 2],
        }
    }

    /// Where a force leaves the section without twist, along axes 1 and 2, counted from the axis of
    /// the beam [L].
    pub fn shear_center(&self) -> [f64; 2] {
        match self {
            Self::General { shear_center, .. } => *shear_center,
            Self::Profile(own) => own.shear_center,
            _ => [0.0; 2],
        }
    }

    /// Where it begins along axis 2, counted from the axis of the beam [L].
    pub fn bottom(&self) -> f64 {
        match self {
            Self::Profile(own) => own.extent(1)[0],
            Self::General { centroid: [_, own], .. } => own - 0.5 * self.height(),
            _ => -0.5 * self.height(),
        }
    }

    /// Extent along axis 2 [L]; of a section without a shape that of a rectangle with its area and
    /// second moment.
    pub fn height(&self) -> f64 {
        match *self {
            Self::Rectangle { height, .. } => height,
            Self::Circle(radius) | Self::Pipe { radius, .. } => 2.0 * radius,
            Self::General { area, second_moments: [own, ..], .. } => (12.0 * own / area).sqrt(),
            Self::Profile(ref own) => own.extent(1)[1] - own.extent(1)[0],
        }
    }

    /// Extent along axis 1 [L].
    pub fn width(&self) -> f64 {
        match *self {
            Self::Rectangle { width, .. } => width,
            Self::Circle(radius) | Self::Pipe { radius, .. } => 2.0 * radius,
            Self::General { .. } => self.area() / self.height(),
            Self::Profile(ref own) => own.extent(0)[1] - own.extent(0)[0],
        }
    }

    /// Shear factor k: of K = k G A. [Abaqus manual, choosing a beam cross-section]
    pub fn shear_factor(&self) -> f64 {
        match self {
            Self::Rectangle { .. } => 0.85,
            Self::Circle(_) => 0.89,
            Self::Pipe { .. } => 0.53,
            Self::General { .. } => 1.0,
            Self::Profile(own) => own.shear_factor,
        }
    }

    /// Name, as `SECTION=` has it.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Rectangle { .. } => "RECT",
            Self::Circle(_) => "CIRC",
            Self::Pipe { .. } => "PIPE",
            Self::General { .. } => "GENERAL",
            Self::Profile(own) => own.name,
        }
    }

    /// Axial stress of a beam in the plane, which bends about axis 1 alone, at a height over its axis
    /// [F/L2]: of the section forces N [F] and SM1 [F L] about the axis.
    pub fn stress_in_plane(&self, [force, moment]: [f64; 2], height: f64) -> f64 {
        let centroid = self.centroid()[1];
        let moment = moment + centroid * force;
        force / self.area() - (height - centroid) * moment / self.second_moment()
    }

    /// Largest strain of a fibre, pulled or pressed [1], of the strain of the axis and the curvatures
    /// SK1, SK2 [1/L] of a beam in space.
    pub fn largest_strain(&self, [axial, first, second]: [f64; 3]) -> f64 {
        if let Some(radius) = self.radius() {
            return axial.abs() + first.hypot(second) * radius;
        }
        let at = |[x1, x2]: [f64; 2]| (axial - first * x2 - second * x1).abs();
        self.points().into_iter().map(at).fold(0.0, f64::max)
    }

    /// That of a round section about the axis [L]; `None`: it has corners.
    pub(super) fn radius(&self) -> Option<f64> {
        match *self {
            Self::Circle(radius) | Self::Pipe { radius, .. } => Some(radius),
            Self::Profile(ref own) => own.radius,
            _ => None,
        }
    }

    /// Points at which stress is told of a beam in space, along axes 1 and 2 [L]: outermost ones; of
    /// a section without a shape the corners of a rectangle with its area and its second moments.
    pub fn points(&self) -> Vec<[f64; 2]> {
        match *self {
            Self::Rectangle { width, height } => {
                let (x, y) = (0.5 * width, 0.5 * height);
                vec![[-x, -y], [x, -y], [-x, y], [x, y]]
            }
            Self::Circle(radius) | Self::Pipe { radius, .. } => around(radius, 8),
            Self::General {
                area, second_moments: [first, _, second], centroid: [x, y], ..
            } => {
                let [half, up] = [second, first].map(|moment| (3.0 * moment / area).sqrt());
                vec![[x - half, y - up], [x + half, y - up], [x - half, y + up], [x + half, y + up]]
            }
            Self::Profile(ref own) => own.corners.clone(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: areas and second moments are those by hand: a pipe is a circle less a circle.
    /// Tolerance: rounding.
    #[test]
    fn areas_and_second_moments() {
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-14 * b.abs(), "{a} {b}");
        let (pipe, outer, inner) =
            (Shape::Pipe { radius: 2.0, wall: 0.5 }, Shape::Circle(2.0), Shape::Circle(1.5));
        near(pipe.area(), outer.area() - inner.area());
        near(pipe.second_moment(), outer.second_moment() - inner.second_moment());
        let general = Shape::General {
            area: 6.0,
            second_moments: [4.5, 0.0, 4.5],
            torsion: 9.0,
            centroid: [0.0; 2],
            shear_center: [0.0; 2],
        };
        near(general.height(), 3.0);
        near(general.width(), 2.0);
    }
}
