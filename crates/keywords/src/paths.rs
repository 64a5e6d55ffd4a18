//! Lines on which nodes are generated.

use slideline_mech::vector::{cross, dot};

/// A line between two places [L].
pub(crate) enum Path {
    Straight([f64; 3], [f64; 3]),
    /// Through a third place, half way in its parameter.
    Parabola([f64; 3], [f64; 3], [f64; 3]),
    Arc(Arc),
}

/// An arc of a circle: radius and height run straight from one end to the other.
pub(crate) struct Arc {
    centre: [f64; 3],
    /// Along the radius of the first end, along the way there, and along the axis [1].
    axes: [[f64; 3]; 3],
    /// Angle from the first end to the last.
    angle: f64,
    /// At the first end [L].
    radius: f64,
    /// By how much the last end is further from the axis [L].
    growth: f64,
    height: f64,
}

impl Path {
    /// The place at a part 0 to 1 of the way [L].
    pub fn at(&self, part: f64) -> [f64; 3] {
        match self {
            Self::Straight(a, b) => std::array::from_fn(|k| a[k] + (b[k] - a[k]) * part),
            Self::Parabola(a, m, b) => {
                let (from, middle, to) = (
                    (1.0 - part) * (1.0 - 2.0 * part),
                    4.0 * part * (1.0 - part),
                    part * (2.0 * part - 1.0),
                );
                std::array::from_fn(|k| from * a[k] + middle * m[k] + to * b[k])
            }
            Self::Arc(arc) => arc.at(part),
        }
    }
}

impl Arc {
    /// The arc about a centre: round an axis by the right hand, or the shorter way where none is
    /// given. `None` where the places make none.
    pub fn through(
        from: [f64; 3],
        to: [f64; 3],
        centre: [f64; 3],
        axis: Option<[f64; 3]>,
    ) -> Option<Self> {
        let away = |x: [f64; 3]| -> [f64; 3] { std::array::from_fn(|k| x[k] - centre[k]) };
        let (a, b) = (away(from), away(to));
        let least = 1e-9 * dot(a, a).max(dot(b, b)).sqrt();
        let unit = |x: [f64; 3], least: f64| {
            let length = dot(x, x).sqrt();
            (length > least).then(|| (x.map(|own| own / length), length))
        };
        let (first, radius) = unit(a, least)?;
        let (axis, _) = match axis {
            Some(axis) => unit(axis, 0.0)?,
            None => unit(cross(a, b), least * radius)?,
        };
        // the axis stands across the first radius
        let along = dot(axis, first);
        let (axis, _) = unit(std::array::from_fn(|k| axis[k] - along * first[k]), 1e-9)?;
        let second = cross(axis, first);
        let (x, y) = (dot(b, first), dot(b, second));
        let last = x.hypot(y);
        if last <= least {
            return None;
        }
        let angle = y.atan2(x);
        let angle = if angle <= 0.0 { angle + std::f64::consts::TAU } else { angle };
        let (axes, growth) = ([first, second, axis], last - radius);
        Some(Self { centre, axes, angle, radius, growth, height: dot(b, axis) })
    }

    fn at(&self, part: f64) -> [f64; 3] {
        let radius = self.radius + self.growth * part;
        let (sin, cos) = (self.angle * part).sin_cos();
        let parts = [radius * cos, radius * sin, self.height * part];
        std::array::from_fn(|k| {
            self.centre[k] + (0..3).map(|i| parts[i] * self.axes[i][k]).sum::<f64>()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: [f64; 3], b: [f64; 3]) -> bool {
        (0..3).all(|k| (a[k] - b[k]).abs() < 1e-12)
    }

    /// Requirement: the shorter way without an axis, round the axis by the right hand with one;
    /// half a circle and more need it.
    #[test]
    fn arcs_go_round_their_axis() {
        let (x, y, c) = ([3.0, 1.0, 1.0], [1.0, 3.0, 1.0], [1.0, 1.0, 1.0]);
        let half = 2.0_f64.sqrt();
        let at = |axis, part| Arc::through(x, y, c, axis).expect("an arc").at(part);
        assert!(near(at(None, 0.5), [1.0 + half, 1.0 + half, 1.0]));
        assert!(near(at(Some([0.0, 0.0, 1.0]), 0.5), [1.0 + half, 1.0 + half, 1.0]));
        assert!(near(at(Some([0.0, 0.0, -2.0]), 0.5), [1.0 - half, 1.0 - half, 1.0]));
        assert!(near(at(None, 1.0), y));
        assert!(Arc::through(x, [-1.0, 1.0, 1.0], c, None).is_none());
        let over = Arc::through(x, [-1.0, 1.0, 1.0], c, Some([0.0, 0.0, 1.0])).expect("an arc");
        assert!(near(over.at(0.5), [1.0, 3.0, 1.0]));
        assert!(Arc::through(x, y, x, None).is_none());
    }

    #[test]
    fn a_parabola_passes_its_middle() {
        let path = Path::Parabola([0.0; 3], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0]);
        assert!(near(path.at(0.5), [1.0, 1.0, 0.0]) && near(path.at(0.25), [0.5, 0.75, 0.0]));
    }
}
