//! Sections that taper along an element: the even one that stands for them.
//!
//! ```text
//!      +-----___
//!      |        ---+       sizes go evenly from end to end;
//!      |        ---+       A, I and J are those of the mean
//!      +-----
//! ```
//! docs/theory.md section 3.18.

use super::profile::Profile;
use super::shape::Shape;

impl Shape {
    /// The even section of an element whose section goes evenly from that of its first end to that of its
    /// second one: docs/theory.md eqs (3.116) and (3.117).
    pub fn tapered(ends: [&Self; 2]) -> Self {
        let half = |of: &dyn Fn(&Self) -> f64| 0.5 * (of(ends[0]) + of(ends[1]));
        let moment = |place: usize| fourth(ends.map(|end| end.second_moments()[place]));
        let area = second(ends.map(Self::area));
        let second_moments = [moment(0), moment(1), moment(2)];
        let torsion = fourth(ends.map(Self::torsion_constant));
        let centroid = [0, 1].map(|axis| half(&|end| end.centroid()[axis]));
        let shear_center = [0, 1].map(|axis| half(&|end| end.shear_center()[axis]));
        if let [Self::General { .. }, _] | [_, Self::General { .. }] = ends {
            return Self::General { area, second_moments, torsion, centroid, shear_center };
        }
        let [first, other] = ends.map(Self::points);
        let between = |(a, b): (&[f64; 2], &[f64; 2])| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
        let corners = first.iter().zip(&other).map(between).collect();
        let radius = match ends.map(Self::radius) {
            [Some(a), Some(b)] => Some(0.5 * (a + b)),
            _ => None,
        };
        Self::Profile(Box::new(Profile {
            name: ends[0].name(),
            area,
            centroid,
            second_moments,
            torsion,
            shear_center,
            shear_factor: half(&Self::shear_factor),
            corners,
            radius,
        }))
    }
}

/// Mean of the square of what goes evenly from one end to the other, of its squares at both.
fn second([a, b]: [f64; 2]) -> f64 {
    (a + (a * b).sqrt() + b) / 3.0
}

/// The same of its fourth power. Where signs differ, as of I12, what is between the ends cancels.
fn fourth([a, b]: [f64; 2]) -> f64 {
    let between = if a * b > 0.0 {
        let [from, to] = [a, b].map(|end| end.abs().sqrt().sqrt());
        a.signum() * from * to * (from * from + from * to + to * to)
    } else {
        0.0
    };
    (a + between + b) / 5.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean along the length of a value of the section at x from 0 to 1, by Simpson's rule on many pieces.
    fn mean(of: impl Fn(f64) -> f64) -> f64 {
        let pieces = 400;
        let at = |k: usize| k as f64 / f64::from(2 * pieces as u32);
        (0..pieces)
            .map(|k| (of(at(2 * k)) + 4.0 * of(at(2 * k + 1)) + of(at(2 * k + 2))) / 6.0)
            .sum::<f64>()
            / f64::from(pieces as u32)
    }

    /// Requirement: of sections that stay similar to themselves A, I and J are the means of those along the
    /// length; of equal ends they are those of the ends.
    #[test]
    fn similar_sections_have_their_means() {
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-12 * b.abs(), "{a} {b}");
        let rectangle = |s: f64| Shape::Rectangle { width: 2.0 * s, height: 3.0 * s };
        let pipe = |s: f64| Shape::Pipe { radius: s, wall: 0.2 * s };
        let angle = |s: f64| {
            Shape::Profile(Box::new(Profile::angle([2.0 * s, 3.0 * s], [0.3 * s, 0.2 * s])))
        };
        for shape in [&rectangle as &dyn Fn(f64) -> Shape, &pipe, &angle] {
            let size = |x: f64| 1.5 - 0.9 * x;
            let own = Shape::tapered([&shape(1.5), &shape(0.6)]);
            near(own.area(), mean(|x| shape(size(x)).area()));
            near(own.torsion_constant(), mean(|x| shape(size(x)).torsion_constant()));
            for place in [0, 2] {
                near(own.second_moments()[place], mean(|x| shape(size(x)).second_moments()[place]));
            }
            near(own.height(), 0.5 * (shape(1.5).height() + shape(0.6).height()));
            let even = Shape::tapered([&shape(1.2), &shape(1.2)]);
            near(even.area(), shape(1.2).area());
            near(even.second_moment(), shape(1.2).second_moment());
            near(even.largest_strain([0.1, 0.2, 0.3]), shape(1.2).largest_strain([0.1, 0.2, 0.3]));
        }
        let mixed = Shape::tapered([&angle(1.5), &angle(0.6)]).second_moments()[1];
        near(mixed, mean(|x| angle(1.5 - 0.9 * x).second_moments()[1]));
    }

    /// Requirement: products of either sign leave a section that no bending softens.
    #[test]
    fn products_of_either_sign() {
        let general = |mixed: f64, scale: f64| Shape::General {
            area: scale * scale,
            second_moments: [2.0, mixed, 1.0].map(|own| own * scale.powi(4)),
            torsion: scale,
            centroid: [0.0; 2],
            shear_center: [0.0; 2],
        };
        for (a, b) in [(1.4, 1.4), (1.4, -1.4), (-1.4, 0.0), (-1.4, -1.0)] {
            let own = Shape::tapered([&general(a, 1.0), &general(b, 0.3)]);
            let [first, mixed, second] = own.second_moments();
            assert!(mixed * mixed < first * second, "{a} {b} {mixed}");
        }
    }
}
