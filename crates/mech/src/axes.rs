//! Systems of axes: which way the axes 1, 2, 3 point at a place.
//!
//! ```text
//!   rectangular      cylindrical         spherical
//!     2 ^            2 ^   ^ 1             2 ^  ^ 1 away from the centre
//!       |               \ / radial            \/
//!       o--> 1           o                    o
//!   the same           about an axis        about a centre and its polar axis
//! ```
//! docs/theory.md section 4.3.

use crate::vector::{cross, dot, sub};
/// Unit vectors along the axes 1, 2 and 3, a row each: `axes[i][j]` is the cosine between axis
/// i and axis j of the model.
pub type Axes = [[f64; 3]; 3];

/// The axes of the model.
pub const PLAIN: Axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Part of the distance from the origin of a system below which a point is on its axis [1].
const ON_AXIS: f64 = 1e-10;

/// A system of axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum System {
    /// The same axes everywhere.
    Rectangular(Axes),
    /// 1 away from the axis, 2 around it, 3 along it.
    Cylindrical {
        /// A point of the axis [L].
        origin: [f64; 3],
        /// Its direction, a unit vector.
        axis: [f64; 3],
    },
    /// 1 away from the centre, 2 around the polar axis, 3 along the meridian.
    Spherical {
        /// The centre [L].
        origin: [f64; 3],
        /// Direction of the polar axis, a unit vector.
        axis: [f64; 3],
    },
}

impl System {
    /// Axis 1 along `first`, axis 2 in the plane of `first` and `second`, on the side of
    /// `second`. `None` where these have no direction or the same one.
    pub fn rectangular(first: [f64; 3], second: [f64; 3]) -> Option<Self> {
        let first = unit(first)?;
        let second = unit(second)?;
        let third = direction(cross(first, second))?;
        Some(Self::Rectangular([first, cross(third, first), third]))
    }

    /// Axis 3 along `third`, axis 1 in the plane of `third` and `first`.
    pub fn z_rectangular(third: [f64; 3], first: [f64; 3]) -> Option<Self> {
        let third = unit(third)?;
        let second = direction(cross(third, unit(first)?))?;
        Some(Self::Rectangular([cross(second, third), second, third]))
    }

    /// About the axis from `a` to `b` [L]; `None` where they coincide.
    pub fn cylindrical(a: [f64; 3], b: [f64; 3]) -> Option<Self> {
        Some(Self::Cylindrical { origin: a, axis: unit(sub(b, a))? })
    }

    /// About the centre `a` with the polar axis through `b` [L]; `None` where they coincide.
    pub fn spherical(a: [f64; 3], b: [f64; 3]) -> Option<Self> {
        Some(Self::Spherical { origin: a, axis: unit(sub(b, a))? })
    }

    /// The axes at a point [L]. On the axis of a system, where none is radial, axis 1 is as near
    /// to x as can be, or to y.
    pub fn at(&self, point: [f64; 3]) -> Axes {
        match *self {
            Self::Rectangular(axes) => axes,
            Self::Cylindrical { origin, axis } => {
                let radial = radial(sub(point, origin), axis);
                [radial, cross(axis, radial), axis]
            }
            Self::Spherical { origin, axis } => {
                let arm = sub(point, origin);
                let around = cross(axis, radial(arm, axis));
                // without a radius all directions are alike
                let first = unit(arm).unwrap_or_else(|| radial(arm, axis));
                [first, around, cross(first, around)]
            }
        }
    }

    /// Whether a point is on the axis, where no direction is radial.
    pub fn is_on_axis(&self, point: [f64; 3]) -> bool {
        match *self {
            Self::Rectangular(_) => false,
            Self::Cylindrical { origin, axis } | Self::Spherical { origin, axis } => {
                let arm = sub(point, origin);
                length(across(arm, axis)) <= ON_AXIS * length(arm)
            }
        }
    }

    /// The system as a rigid motion takes it along: `point` moves places, `turn` directions.
    #[must_use]
    pub fn moved(
        self,
        point: impl Fn([f64; 3]) -> [f64; 3],
        turn: impl Fn([f64; 3]) -> [f64; 3],
    ) -> Self {
        match self {
            Self::Rectangular(axes) => Self::Rectangular(axes.map(turn)),
            Self::Cylindrical { origin, axis } => {
                Self::Cylindrical { origin: point(origin), axis: turn(axis) }
            }
            Self::Spherical { origin, axis } => {
                Self::Spherical { origin: point(origin), axis: turn(axis) }
            }
        }
    }
}

/// Axes turned about one of them (0, 1 or 2) by an angle [1], right-handed.
#[must_use]
pub fn turned(axes: Axes, about: usize, angle: f64) -> Axes {
    let (sin, cos) = angle.sin_cos();
    let (next, last) = ((about + 1) % 3, (about + 2) % 3);
    let mut new = axes;
    for k in 0..3 {
        new[next][k] = cos * axes[next][k] + sin * axes[last][k];
        new[last][k] = cos * axes[last][k] - sin * axes[next][k];
    }
    new
}

/// Components along the axes of a vector of the model.
pub fn along(axes: &Axes, vector: [f64; 3]) -> [f64; 3] {
    axes.map(|axis| dot(axis, vector))
}

/// The vector of the model with these components along the axes.
pub fn vector(axes: &Axes, components: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|j| (0..3).map(|i| components[i] * axes[i][j]).sum())
}

/// The unit vector away from an axis, towards `arm`.
fn radial(arm: [f64; 3], axis: [f64; 3]) -> [f64; 3] {
    let away = across(arm, axis);
    let far = length(away) > ON_AXIS * length(arm);
    let any = || direction(across(PLAIN[0], axis)).or_else(|| direction(across(PLAIN[1], axis)));
    unit(away).filter(|_| far).or_else(any).unwrap_or(PLAIN[0])
}

/// The part of a vector across a unit vector.
fn across(arm: [f64; 3], axis: [f64; 3]) -> [f64; 3] {
    let along = dot(arm, axis);
    std::array::from_fn(|k| arm[k] - along * axis[k])
}

/// The direction of a vector made of unit vectors; `None` where rounding alone is left of it.
fn direction(a: [f64; 3]) -> Option<[f64; 3]> {
    unit(a).filter(|_| length(a) > ON_AXIS)
}

fn unit(a: [f64; 3]) -> Option<[f64; 3]> {
    let scale = a.iter().fold(0.0_f64, |most, part| most.max(part.abs()));
    if scale == 0.0 || !scale.is_finite() {
        return None;
    }
    let a = a.map(|part| part / scale);
    let length = length(a);
    Some(a.map(|part| part / length))
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_right_handed(axes: &Axes) -> bool {
        let [a, b, c] = *axes;
        let third = cross(a, b);
        let unit = axes.iter().all(|axis| (length(*axis) - 1.0).abs() < 1e-14);
        unit && dot(a, b).abs() < 1e-14 && (0..3).all(|k| (third[k] - c[k]).abs() < 1e-14)
    }

    /// Requirement: axes point as the manual of `*TRANSFORM` and `*ORIENTATION` says, are
    /// perpendicular, right-handed and of length one, on the axis too.
    #[test]
    fn axes_point_as_defined() {
        let plane = System::rectangular([0.0, 2.0, 0.0], [-3.0, 1.0, 0.0]).unwrap();
        assert_eq!(plane.at([9.0; 3]), [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
        let z = System::z_rectangular([0.0, 0.0, 2.0], [0.0, 5.0, 1.0]).unwrap();
        assert_eq!(z.at([0.0; 3]), [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
        let round = System::cylindrical([1.0, 1.0, 0.0], [1.0, 1.0, 4.0]).unwrap();
        assert_eq!(round.at([1.0, 3.0, 7.0]), [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
        let ball = System::spherical([0.0; 3], [0.0, 0.0, 1.0]).unwrap();
        assert_eq!(ball.at([2.0, 0.0, 0.0]), PLAIN);
        let (a, b) = ([0.3, -0.4, 0.8], [-0.2, 0.9, 0.1]);
        let systems = [
            System::rectangular(a, b),
            System::z_rectangular(a, b),
            System::cylindrical(a, b),
            System::spherical(a, b),
        ];
        for system in systems.map(Option::unwrap) {
            for point in [[0.7, 0.1, -0.3], a, b, [0.05, 0.25, 0.45]] {
                let axes = system.at(point);
                assert!(is_right_handed(&axes), "{system:?} at {point:?}: {axes:?}");
                assert!(is_right_handed(&turned(axes, 1, 0.4)));
                let back = vector(&axes, along(&axes, point));
                assert!((0..3).all(|k| (back[k] - point[k]).abs() < 1e-15));
            }
        }
    }

    /// Requirement: what has no direction makes no system, whatever the unit of length.
    #[test]
    fn directions_must_differ() {
        for scale in [1e-9, 1.0, 1e9] {
            let a = [scale, 2.0 * scale, 0.0];
            let b = a.map(|x| -3.0 * x);
            assert_eq!(System::rectangular(a, b), None);
            assert_eq!(System::z_rectangular(a, b), None);
            assert_eq!(System::cylindrical(a, a), None);
            assert!(System::cylindrical([0.0; 3], a).unwrap().is_on_axis(b));
            assert!(System::rectangular(a, [0.0, scale, 0.0]).is_some());
        }
        assert_eq!(System::rectangular([0.0; 3], [1.0, 0.0, 0.0]), None);
        assert_eq!(System::rectangular([f64::NAN; 3], [1.0, 0.0, 0.0]), None);
    }

    /// Requirement: a turn about axis 3 takes axis 1 towards axis 2.
    #[test]
    fn turns_are_right_handed() {
        let axes = turned(PLAIN, 2, std::f64::consts::FRAC_PI_6);
        assert!((axes[0][0] - 0.75_f64.sqrt()).abs() < 1e-15 && (axes[0][1] - 0.5).abs() < 1e-15);
        assert!(is_right_handed(&turned(turned(PLAIN, 0, 0.3), 1, -0.8)));
    }
}
