//! Where an instance stands.
//!
//! ```text
//!   X  --translated-->  X + t  --turned about the axis a b-->  a + R (X + t - a)
//! ```
//! docs/theory.md eq. (4.6).

/// A translation, then a rotation about an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Motion {
    /// Translation [L].
    pub translation: [f64; 3],
    /// A point of the axis [L] and the rotation about it.
    pub rotation: Option<([f64; 3], [[f64; 3]; 3])>,
}

impl Motion {
    /// The rotation by an angle [1] about the axis from `a` to `b`; `None` where both
    /// coincide.
    pub fn rotation(a: [f64; 3], b: [f64; 3], degrees: f64) -> Option<([f64; 3], [[f64; 3]; 3])> {
        let along = std::array::from_fn::<f64, 3, _>(|k| b[k] - a[k]);
        let scale = along.iter().fold(0.0_f64, |most, part| most.max(part.abs()));
        if scale == 0.0 || !scale.is_finite() {
            return None;
        }
        let scaled = along.map(|part| part / scale);
        let length = scaled.iter().map(|part| part * part).sum::<f64>().sqrt();
        Some((a, turn(scaled.map(|part| part / length), degrees)))
    }

    /// Where a point of the part stands in the assembly [L].
    pub fn point(&self, part: [f64; 3]) -> [f64; 3] {
        let moved: [f64; 3] = std::array::from_fn(|k| part[k] + self.translation[k]);
        let Some((a, rotation)) = self.rotation else { return moved };
        let arm: [f64; 3] = std::array::from_fn(|k| moved[k] - a[k]);
        let turned = times(&rotation, arm);
        std::array::from_fn(|k| a[k] + turned[k])
    }

    /// Where a direction of the part points in the assembly.
    pub fn direction(&self, part: [f64; 3]) -> [f64; 3] {
        self.rotation.map_or(part, |(_, rotation)| times(&rotation, part))
    }

    /// Whether the plane of x and y stays one of constant z.
    pub fn keeps_the_plane(&self) -> bool {
        self.rotation.is_none_or(|(_, r)| r[2][2] == 1.0)
    }
}

/// Frame through a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Frame {
    origin: [f64; 3],
    /// Unit vectors of the axes.
    along: [[f64; 3]; 3],
}

impl Frame {
    /// With their origin, a point on the first axis and one in the plane of the first two; `None`
    /// where the three lie on a line.
    pub fn through(origin: [f64; 3], first: [f64; 3], second: [f64; 3]) -> Option<Self> {
        let less = |a: [f64; 3]| -> [f64; 3] { std::array::from_fn(|k| a[k] - origin[k]) };
        let (a, b) = (less(first), less(second));
        let normal =
            [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        let unit = |v: [f64; 3], of: f64| -> Option<[f64; 3]> {
            let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
            (length > 1e-12 * of).then(|| v.map(|x| x / length))
        };
        let size = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let [x, z] = [unit(a, 0.0)?, unit(normal, size(a) * size(b))?];
        let y = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]];
        Some(Self { origin, along: [x, y, z] })
    }

    /// Where a point with these coordinates stands [L].
    pub fn point(&self, own: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|k| {
            self.origin[k] + (0..3).map(|axis| own[axis] * self.along[axis][k]).sum::<f64>()
        })
    }
}

/// Rotation about a unit axis: R = c 1 + (1 - c) n n' + s [n]x. Quarter turns are exact.
fn turn(axis: [f64; 3], degrees: f64) -> [[f64; 3]; 3] {
    let (sin, cos) = match degrees.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => degrees.to_radians().sin_cos(),
    };
    let [x, y, z] = axis;
    let cross = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let one = if i == j { 1.0 } else { 0.0 };
            let along = axis[i] * axis[j];
            // in this form the axis itself stays exactly where it is
            cos * (one - along) + along + sin * cross[i][j]
        })
    })
}

fn times(matrix: &[[f64; 3]; 3], vector: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| (0..3).map(|j| matrix[i][j] * vector[j]).sum())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: rotations are right-handed, keep lengths and their axis, and are applied
    /// after the translation. Source: Abaqus manual, `*INSTANCE`.
    #[test]
    fn translated_first_then_turned() {
        let rotation = Motion::rotation([1.0, 0.0, 0.0], [1.0, 0.0, 5.0], 90.0);
        let motion = Motion { translation: [1.0, 0.0, 2.0], rotation };
        assert_eq!(motion.point([1.0, 0.0, 0.0]), [1.0, 1.0, 2.0]);
        assert!(motion.keeps_the_plane());
        let rotation = Motion::rotation([0.0; 3], [1.0, 2.0, -0.5], 37.0);
        let motion = Motion { translation: [0.0; 3], rotation };
        let [x, y, z] = motion.point([0.3, -0.7, 2.0]);
        let length = (x * x + y * y + z * z).sqrt();
        assert!((length - (0.09_f64 + 0.49 + 4.0).sqrt()).abs() < 1e-15);
        let axis = motion.point([2.0, 4.0, -1.0]);
        assert!(axis.iter().zip([2.0, 4.0, -1.0]).all(|(a, b)| (a - b).abs() < 1e-15));
        assert!(!motion.keeps_the_plane());
        assert_eq!(Motion::rotation([1.0; 3], [1.0; 3], 30.0), None);
    }
}
