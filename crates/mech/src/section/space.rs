//! What a beam in space needs of a section beyond a plane one: bending about both axes, torsion.
//!
//! ```text
//!     2 ^                I11 = integral x2^2 dA     I22 = integral x1^2 dA
//!       | x2  . dA       I12 = integral x1 x2 dA
//!       +--> 1           torque = G J twist
//!         x1
//! ```
//! docs/theory.md eqs (3.79) to (3.81).

use super::plane::TransverseShear;
use super::shape::Shape;
use crate::material::Elastic;
use std::f64::consts::PI;

impl Shape {
    /// Second moments of area I11, I12, I22 about the centroid [L4].
    pub fn second_moments(&self) -> [f64; 3] {
        let own = self.second_moment();
        match *self {
            Self::Rectangle { width, height } => [own, 0.0, height * width.powi(3) / 12.0],
            Self::Circle(_) | Self::Pipe { .. } => [own, 0.0, own],
            Self::General { second_moments, .. } => second_moments,
            Self::Profile(ref profile) => profile.second_moments,
        }
    }

    /// Torsion constant J [L4]: exact for a rectangle (the series of Saint-Venant), a circle and a
    /// pipe; of others that of their profile.
    /// [timoshenko1951, chapter 10]
    pub fn torsion_constant(&self) -> f64 {
        match *self {
            Self::Rectangle { width, height } => {
                rectangle_torsion(width.max(height), width.min(height))
            }
            Self::Circle(_) | Self::Pipe { .. } => 2.0 * self.second_moment(),
            Self::General { torsion, .. } => torsion,
            Self::Profile(ref profile) => profile.torsion,
        }
    }

    /// Axial stress at a point along axes 1 and 2 [L] of the section forces N [F] and moments SM1, SM2
    /// [F L] about the axis of the beam [F/L2]: docs/theory.md eq. (3.108).
    pub fn stress(&self, [force, first, second]: [f64; 3], at: [f64; 2]) -> f64 {
        let centroid = self.centroid();
        let [about_1, mixed, about_2] = self.second_moments();
        let (first, second) = (first + centroid[1] * force, second + centroid[0] * force);
        let resisting = about_1 * about_2 - mixed * mixed;
        let bent_1 = (first * about_2 - second * mixed) / resisting;
        let bent_2 = (second * about_1 - first * mixed) / resisting;
        force / self.area() - bent_1 * (at[1] - centroid[1]) - bent_2 * (at[0] - centroid[0])
    }
}

/// Sum of 1/n^5 over all n: zeta(5).
const ZETA: f64 = 1.036_927_755_143_37;

/// J of a rectangle of sides a >= b [L]: docs/theory.md eq. (3.80).
fn rectangle_torsion(a: f64, b: f64) -> f64 {
    // tanh x = 1 - 2/(exp(2x) + 1): the ones sum up to 31/32 zeta(5), the others vanish soon
    let term = |n: f64| 2.0 / ((n * PI * a / b).exp() + 1.0) / n.powi(5);
    let others: f64 = (0..7).rev().map(|k| term(f64::from(2 * k + 1))).sum();
    let sum = 31.0 / 32.0 * ZETA - others;
    a * b.powi(3) / 3.0 * (1.0 - 192.0 / PI.powi(5) * b / a * sum)
}

/// The stiffnesses of a beam in space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpaceStiffness {
    /// EA [F].
    pub axial: f64,
    /// Transverse shear stiffnesses along axes 1 and 2: K13, K23 [F].
    pub shear: [f64; 2],
    /// GJ [F L2].
    pub torsion: f64,
    /// E I11, E I12, E I22 about the centroid [F L2].
    pub bending: [f64; 3],
    /// Centroid along axes 1 and 2 [L].
    pub centroid: [f64; 2],
    /// Shear centre along axes 1 and 2 [L].
    pub shear_center: [f64; 2],
}

impl SpaceStiffness {
    /// Section forces by strains: rows and columns axial, shear along axes 1 and 2, twist,
    /// curvature about axes 1 and 2. Fibres at x1, x2 stretch by k1 x2 - k2 x1, hence the sign of
    /// I12; shear acts at the shear centre: docs/theory.md eqs (3.105) and (3.106).
    pub fn matrix(&self) -> [[f64; 6]; 6] {
        let ([x1, x2], [s1, s2]) = (self.centroid, self.shear_center);
        let [first, mixed, second] = self.bending;
        let mut matrix = [[0.0; 6]; 6];
        let mut add = |stiffness: f64, entries: [(usize, f64); 3]| {
            for (i, a) in entries {
                entries.iter().for_each(|(j, b)| matrix[i][*j] += stiffness * a * b);
            }
        };
        add(self.axial, [(0, 1.0), (4, x2), (5, -x1)]);
        add(self.shear[0], [(1, 1.0), (3, -s2), (3, 0.0)]);
        add(self.shear[1], [(2, 1.0), (3, s1), (3, 0.0)]);
        matrix[3][3] += self.torsion;
        matrix[4][4] += first;
        matrix[5][5] += second;
        matrix[4][5] -= mixed;
        matrix[5][4] -= mixed;
        matrix
    }

    /// Bending stiffness about the axis of the section that bends most easily [F L2].
    pub fn least_bending(&self) -> f64 {
        let [first, mixed, second] = self.bending;
        0.5 * (first + second) - (0.5 * (first - second)).hypot(mixed)
    }
}

/// The stiffnesses of a section in an element of the given length [L]: transverse shear by the rule
/// of the plane beam, each direction with the second moment that it bends by.
pub fn space_stiffness(
    section: &Shape,
    material: &Elastic,
    shear: &TransverseShear,
    length: f64,
) -> SpaceStiffness {
    let area = section.area();
    let moments = section.second_moments();
    let full = section.shear_factor() * material.shear_modulus() * area;
    let reduced = |given: Option<f64>, moment: f64| {
        let whole = given.unwrap_or(full);
        whole / (1.0 + shear.slenderness * length * length * area / (12.0 * moment))
    };
    SpaceStiffness {
        axial: material.modulus * area,
        shear: [reduced(shear.across, moments[2]), reduced(shear.given, moments[0])],
        torsion: material.shear_modulus() * section.torsion_constant(),
        bending: moments.map(|moment| material.modulus * moment),
        centroid: section.centroid(),
        shear_center: section.shear_center(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: second moments about axis 2 are those about axis 1 of the section turned by a
    /// right angle; torsion constants by hand and by tables. Source of the table: Timoshenko and
    /// Goodier, article 109, four digits.
    #[test]
    fn moments_of_turned_sections_and_torsion() {
        let near = |a: f64, b: f64, by: f64| assert!((a - b).abs() < by * b.abs(), "{a} {b}");
        let moments = |width, height| Shape::Rectangle { width, height }.second_moments();
        assert_eq!(moments(2.0, 3.0)[2], moments(3.0, 2.0)[0]);
        for (ratio, factor) in [(1.0, 0.1406), (1.5, 0.196), (2.0, 0.229), (10.0, 0.312)] {
            let shape = Shape::Rectangle { width: ratio * 0.2, height: 0.2 };
            near(shape.torsion_constant(), factor * ratio * 0.2_f64.powi(4), 2.5e-3);
        }
        near(
            Shape::Rectangle { width: 1.0, height: 1.0 }.torsion_constant(),
            0.140_577_014_955_155_5,
            1e-13,
        );
        near(Shape::Circle(2.0).torsion_constant(), 8.0 * PI, 1e-14);
        let thin = Shape::Pipe { radius: 1.0, wall: 1e-3 };
        near(thin.torsion_constant(), 2.0 * PI * 0.9995_f64.powi(3) * 1e-3, 1e-6);
    }

    /// Requirement: the energy of the matrix is E/2 times the integral of the squared fibre strain,
    /// for a section of three points.
    #[test]
    fn coupled_bending_is_that_of_fibres() {
        let fibres = [(1.0, [2.0, 1.0]), (2.0, [-1.0, 0.5]), (0.5, [0.0, -4.0])];
        let sum = |of: &dyn Fn([f64; 2]) -> f64| fibres.map(|(a, x)| a * of(x)).iter().sum::<f64>();
        let bending = [sum(&|x| x[1] * x[1]), sum(&|x| x[0] * x[1]), sum(&|x| x[0] * x[0])];
        let stiffness = SpaceStiffness {
            axial: 1.0,
            shear: [1.0; 2],
            torsion: 1.0,
            bending,
            centroid: [0.0; 2],
            shear_center: [0.0; 2],
        };
        let (matrix, k) = (stiffness.matrix(), [0.0, 0.0, 0.0, 0.0, 0.3, -0.7]);
        let energy: f64 = (0..6)
            .flat_map(|i| (0..6).map(move |j| (i, j)))
            .map(|(i, j)| k[i] * matrix[i][j] * k[j])
            .sum();
        let exact = sum(&|x| (k[4] * x[1] - k[5] * x[0]).powi(2));
        assert!((energy - exact).abs() < 1e-14 * exact);
        // about the axis that bends most easily
        let turn: f64 = 0.5 * (2.0 * bending[1]).atan2(bending[0] - bending[2]);
        let (s, c) = turn.sin_cos();
        let about =
            |s: f64, c: f64| c * c * bending[0] + 2.0 * s * c * bending[1] + s * s * bending[2];
        let least = about(s, c).min(about(c, -s));
        assert!((stiffness.least_bending() - least).abs() < 1e-12 * least.abs().max(1.0));
    }

    /// Requirement: with the axis away from the centroid and the shear centre the energy of the
    /// matrix is that of fibres, stretched by axis, curvatures and place, of a shear at the shear
    /// centre and of the twist; stresses told of its forces are those of the fibres.
    #[test]
    fn an_axis_away_from_the_centroid() {
        let fibres = [(1.0, [2.0, 1.0]), (2.0, [-1.0, 0.5]), (0.5, [0.0, -4.0]), (1.5, [5.0, 3.0])];
        let sum = |of: &dyn Fn([f64; 2]) -> f64| fibres.map(|(a, x)| a * of(x)).iter().sum::<f64>();
        let area = sum(&|_| 1.0);
        let centroid = [sum(&|x| x[0]) / area, sum(&|x| x[1]) / area];
        let central = |i: usize, j: usize| sum(&|x| (x[i] - centroid[i]) * (x[j] - centroid[j]));
        let second_moments = [central(1, 1), central(0, 1), central(0, 0)];
        let shear_center = [0.7, -0.4];
        let shape = Shape::General { area, second_moments, torsion: 0.2, centroid, shear_center };
        let material = Elastic { modulus: 2.0, poisson: 0.25 };
        let shear = TransverseShear {
            slenderness: 0.0,
            given: Some(3.0),
            across: Some(5.0),
            ..Default::default()
        };
        let matrix = space_stiffness(&shape, &material, &shear, 1.0).matrix();
        let e = [0.2, -0.5, 0.3, 0.6, 0.4, -0.7];
        let forces: [f64; 6] = matrix.map(|row| row.iter().zip(e).map(|(d, e)| d * e).sum());
        let energy: f64 = forces.iter().zip(e).map(|(force, strain)| force * strain).sum();
        let fibre = |x: [f64; 2]| e[0] + e[4] * x[1] - e[5] * x[0];
        let leant = [e[1] - e[3] * shear_center[1], e[2] + e[3] * shear_center[0]];
        let exact = 2.0 * sum(&|x| fibre(x).powi(2))
            + 5.0 * leant[0].powi(2)
            + 3.0 * leant[1].powi(2)
            + 0.8 * 0.2 * e[3] * e[3];
        assert!((energy - exact).abs() < 1e-13 * exact, "{energy} {exact}");
        for (_, x) in fibres {
            let told = shape.stress([forces[0], -forces[4], forces[5]], x);
            assert!((told - 2.0 * fibre(x)).abs() < 1e-13, "{told}");
        }
    }
}
