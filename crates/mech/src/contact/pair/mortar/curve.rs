//! Faces of the plane as curves over control points.
//!
//! ```text
//!   o---------o      a straight face          1 - t, t
//!        x
//!   o   / \   o      a face with a middle     (1 - t)^2, 2 t (1 - t), t^2: none is negative,
//!    `-o---o-'       node, an arc: rational   and every part of the face has positive integrals
//! ```
//!
//! docs/theory.md eq. (5.20)

use crate::differentiate::Real;

/// A place or a direction in the plane.
pub type Place<R> = [R; 2];

/// Most control points of a face.
pub const MOST_CONTROLS: usize = 3;

/// A curve over two or three control points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curve<R> {
    /// Its control points [L]; of a straight face the first two.
    pub controls: [Place<R>; MOST_CONTROLS],
    /// How many they are.
    pub count: usize,
    /// Weight of the middle one: the cosine of half its angle makes an arc [1].
    pub weight: f64,
}

/// Shape functions of the control points and their derivatives by the parameter [1].
#[derive(Debug, Clone, Copy)]
pub struct Shapes<R> {
    /// The functions.
    pub value: [R; MOST_CONTROLS],
    /// Their derivatives.
    pub slope: [R; MOST_CONTROLS],
}

/// a - b.
pub fn sub<R: Real>(a: Place<R>, b: Place<R>) -> Place<R> {
    [a[0] - b[0], a[1] - b[1]]
}

/// a + factor b.
pub fn add_scaled<R: Real>(a: Place<R>, factor: R, b: Place<R>) -> Place<R> {
    [a[0] + factor * b[0], a[1] + factor * b[1]]
}

/// factor a.
pub fn scale<R: Real>(factor: R, a: Place<R>) -> Place<R> {
    [factor * a[0], factor * a[1]]
}

/// a . b.
pub fn dot<R: Real>(a: Place<R>, b: Place<R>) -> R {
    a[0] * b[0] + a[1] * b[1]
}

/// e3 . (a x b).
pub fn cross<R: Real>(a: Place<R>, b: Place<R>) -> R {
    a[0] * b[1] - a[1] * b[0]
}

/// The zero vector.
pub fn zero<R: Real>() -> Place<R> {
    [R::from_f64(0.0); 2]
}

/// Shape functions of so many control points; a middle one of another weight than 1 makes them
/// rational.
pub fn shapes<R: Real>(count: usize, weight: f64, t: R) -> Shapes<R> {
    let (nothing, one, two) = (R::from_f64(0.0), R::from_f64(1.0), R::from_f64(2.0));
    let rest = one - t;
    if count == 2 {
        return Shapes { value: [rest, t, nothing], slope: [-one, one, nothing] };
    }
    let w = R::from_f64(weight);
    let value = [rest * rest, w * two * t * rest, t * t];
    let slope = [-(two * rest), w * two * (rest - t), two * t];
    if weight == 1.0 {
        return Shapes { value, slope };
    }
    let sum = value[0] + value[1] + value[2];
    let by_t = (slope[0] + slope[1] + slope[2]) / sum;
    let value = value.map(|own| own / sum);
    let slope = std::array::from_fn(|k| slope[k] / sum - value[k] * by_t);
    Shapes { value, slope }
}

impl<R: Real> Curve<R> {
    /// Its shape functions at a parameter.
    pub fn shapes(&self, t: R) -> Shapes<R> {
        shapes(self.count, self.weight, t)
    }

    /// The control points blended [L].
    pub fn blend(&self, by: &[R; MOST_CONTROLS]) -> Place<R> {
        let own = self.controls[..self.count].iter().zip(by);
        own.fold(zero(), |sum, (&control, &by)| add_scaled(sum, by, control))
    }

    /// Its first (0) or last (1) point [L].
    pub fn end(&self, end: usize) -> Place<R> {
        self.controls[self.last_control(end)]
    }

    /// The control point that is its first (0) or last (1) point.
    pub fn last_control(&self, end: usize) -> usize {
        end * (self.count - 1)
    }

    /// The same curve without derivatives.
    pub fn values(&self) -> Curve<f64> {
        let controls = self.controls.map(|place| place.map(|x| x.value()));
        Curve { controls, count: self.count, weight: self.weight }
    }

    /// The same curve as seen from a place: what is far from the origin keeps its digits.
    fn seen_from(&self, from: Place<R>) -> Self {
        Self { controls: self.controls.map(|control| sub(control, from)), ..*self }
    }

    /// The parameter of the place on the line through `from` along `direction`, near the curve;
    /// `None` where the curve runs along the line or stays aside.
    pub fn crossed(&self, from: Place<R>, direction: Place<R>) -> Option<R> {
        let near = self.seen_from(from);
        let start = near.values().crossed_by_value(direction.map(|x| x.value()))?;
        let mut t = R::from_f64(start);
        // from the value to its derivatives: twice, to second order
        for _ in 0..2 {
            let own = near.shapes(t);
            let off = cross(near.blend(&own.value), direction);
            t = t - off / cross(near.blend(&own.slope), direction);
        }
        Some(t)
    }
}

/// Parameters about a curve within which a line is said to cross it [1].
const ABOUT: std::ops::RangeInclusive<f64> = -1.0..=2.0;

impl Curve<f64> {
    /// The parameter of the place on the line through the origin: of both where a bent curve comes back
    /// over the line, the one at which it passes to the side of its last point.
    ///
    /// ```text
    ///          |  .--o first      |a|, |b|, |c|: how far the control points are off the line
    ///        x( `                 (1 - t)^2 a + 2 t (1 - t) w b + t^2 c = 0
    ///       `  |
    ///   o---`  x this one         where a and c lie on both sides it is the one between them
    ///   last   |
    /// ```
    ///
    /// docs/theory.md eq. (5.20). (derived)
    fn crossed_by_value(&self, direction: Place<f64>) -> Option<f64> {
        let off = |control: usize| cross(self.controls[control], direction);
        let (first, last) = (off(0), off(self.count - 1));
        let found = if self.count == 2 {
            first / (first - last)
        } else {
            let middle = self.weight * off(1);
            let begins = middle - first;
            let root = (middle * middle - first * last).sqrt().copysign(last - first);
            // of two forms of the same root the one that does not lose digits
            match begins * root < 0.0 {
                true => (root - begins) / (last - middle - begins),
                false => -first / (begins + root),
            }
        };
        ABOUT.contains(&found).then_some(found)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test may fail where it stands
mod tests {
    use super::*;

    /// Requirement: where a line crosses a face does not depend on how far from the origin both are; places are
    /// multiples of a power of two, and shifts exact. A million faces away an arc was found by none.
    #[test]
    fn faces_far_away_are_crossed_as_near_ones() {
        let crossed = |shift: f64, count: usize, weight: f64| {
            let far = |[x, y]: [f64; 2]| [x + shift, y - 3.0 * shift];
            let controls = [[0.0, 0.0], [0.5, 0.25], [1.0, 0.125]].map(far);
            let curve = Curve { controls, count, weight };
            [0.0, 0.25, 0.625, 0.875].map(|x| curve.crossed(far([x, 0.5]), [0.125, -1.0]).unwrap())
        };
        for (count, weight) in [(2, 1.0), (3, 1.0), (3, 0.9375)] {
            let near = crossed(0.0, count, weight);
            assert_eq!(crossed(1_048_576.0, count, weight), near, "{count} {weight}");
        }
    }

    /// Requirement: a line between the ends of a bent face crosses it between them, however the face bends
    /// and however steeply the line meets it. One that comes back over the line near an end was not crossed, or beyond
    /// its end.
    #[test]
    fn a_line_between_the_ends_crosses_between_them() {
        for (weight, bend) in [(1.0, 0.3), (1.0, -0.3), (0.75, 0.6), (0.9, -0.6)] {
            let controls = [[0.0, 0.0], [0.5, bend], [1.0, 0.0]];
            let curve = Curve { controls, count: 3, weight };
            for lean in -8..=8 {
                let direction = [f64::from(lean), -1.0];
                for part in 1..16 {
                    let from = [f64::from(part) / 16.0 - 3.0 * direction[0], 3.0];
                    let t = curve.crossed(from, direction).unwrap();
                    let off = cross(sub(curve.blend(&curve.shapes(t).value), from), direction);
                    assert!((0.0..=1.0).contains(&t), "{weight} {bend} {lean} {part}: {t}");
                    assert!(off.abs() < 1e-13, "{weight} {bend} {lean} {part}: off by {off}");
                }
            }
        }
    }
}
