//! Thin walls that meet at their ends: what a section made of them resists, and where it is sheared
//! without a twist.
//!
//! ```text
//!     o----------o       w: wall of length l and thickness t, along the middle of which the
//!     |     w    ^          coordinates run
//!     |          | 2     one cell at most: walls that come back to where they began
//!     o----o     +--> 1
//! ```
//! docs/theory.md section 3.14. [vlasov1961]

/// A straight wall between two points of the section [L].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    /// Both ends on the middle of its thickness, along axes 1 and 2 [L].
    pub ends: [[f64; 2]; 2],
    /// Its thickness [L].
    pub thickness: f64,
}

/// Why walls make no section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// Some do not touch the others.
    Apart,
    /// They enclose more than one cell.
    Cells,
    /// All lie on one line, about which nothing resists bending.
    Straight,
}

/// Integrals over the walls of a section.
#[derive(Clone, Debug, PartialEq)]
pub struct Integrals {
    /// Area [L2].
    pub area: f64,
    /// Centroid along axes 1 and 2 [L].
    pub centroid: [f64; 2],
    /// I11, I12, I22 about the centroid [L4].
    pub second_moments: [f64; 3],
    /// Torsion constant J [L4].
    pub torsion: f64,
    /// Where a force leaves the section without twist [L].
    pub shear_center: [f64; 2],
    /// Ends of the walls, each once, in the order of the walls [L].
    pub corners: Vec<[f64; 2]>,
}

impl Wall {
    fn length(&self) -> f64 {
        let [[a, b], [c, d]] = self.ends;
        (c - a).hypot(d - b)
    }

    fn area(&self) -> f64 {
        self.length() * self.thickness
    }
}

/// Part of the size of a section within which two ends are one [1].
const MEETS: f64 = 1e-6;

/// The walls as a graph: corners, and the two corners of each wall.
struct Walk<'a> {
    walls: Vec<&'a Wall>,
    corners: Vec<[f64; 2]>,
    ends: Vec<[usize; 2]>,
}

impl<'a> Walk<'a> {
    fn new(walls: &'a [Wall]) -> Self {
        let all = || walls.iter().flat_map(|wall| wall.ends);
        let extent = |k: usize| {
            let (low, high) = all().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), end| {
                (low.min(end[k]), high.max(end[k]))
            });
            high - low
        };
        let near = MEETS * extent(0).hypot(extent(1));
        let walls: Vec<&Wall> = walls.iter().filter(|wall| wall.area() > 0.0).collect();
        let mut corners: Vec<[f64; 2]> = Vec::new();
        let mut corner = |at: [f64; 2]| {
            let known = corners.iter().position(|c| (c[0] - at[0]).hypot(c[1] - at[1]) <= near);
            known.unwrap_or_else(|| {
                corners.push(at);
                corners.len() - 1
            })
        };
        let ends = walls.iter().map(|wall| wall.ends.map(&mut corner)).collect();
        Self { walls, corners, ends }
    }

    /// Whether each wall is part of the cell: what is left where loose ends are taken away.
    fn in_cell(&self) -> Vec<bool> {
        let mut kept = vec![true; self.walls.len()];
        loop {
            let meeting = |corner: usize| {
                let own = self.ends.iter().zip(&kept).filter(|(_, kept)| **kept);
                own.filter(|(ends, _)| ends.contains(&corner)).count()
            };
            let loose = |(ends, kept): (&[usize; 2], &bool)| {
                *kept && ends.iter().any(|&corner| meeting(corner) < 2)
            };
            let Some(loose) = self.ends.iter().zip(&kept).position(loose) else { return kept };
            kept[loose] = false;
        }
    }

    /// Twice the area that the cell encloses, and each wall's part of the way round it: 1 along
    /// it, -1 against it, 0 for others.
    fn round(&self) -> (f64, Vec<f64>) {
        let cell = self.in_cell();
        let mut way = vec![0.0; self.walls.len()];
        let Some(first) = cell.iter().position(|own| *own) else { return (0.0, way) };
        let (mut wall, mut twice) = (first, 0.0);
        let [start, mut here] = self.ends[first];
        way[first] = 1.0;
        loop {
            let [from, to] = self.ends[wall];
            let [a, b] = if way[wall] > 0.0 { [from, to] } else { [to, from] };
            twice += cross(self.corners[a], self.corners[b]);
            if here == start {
                return (twice, way);
            }
            let next = (0..self.walls.len()).find(|&other| {
                cell[other] && way[other] == 0.0 && self.ends[other].contains(&here)
            });
            let Some(next) = next else { return (twice, way) };
            let [from, to] = self.ends[next];
            (way[next], here) = if from == here { (1.0, to) } else { (-1.0, from) };
            wall = next;
        }
    }

    /// Warping at the corners for a twist about the origin [L2]; `None`: a corner is not reached.
    /// Along a wall it grows by twice the area that is swept, less what the flow of shear in a cell
    /// takes back, `flow` times the length over the thickness.
    fn warping(&self, way: &[f64], flow: f64) -> Option<Vec<f64>> {
        let mut warping: Vec<Option<f64>> = vec![None; self.corners.len()];
        *warping.first_mut()? = Some(0.0);
        for _ in 0..self.corners.len() {
            for ((wall, &[from, to]), way) in self.walls.iter().zip(&self.ends).zip(way) {
                let grown = cross(self.corners[from], self.corners[to])
                    - flow * way * wall.length() / wall.thickness;
                match (warping[from], warping[to]) {
                    (Some(own), None) => warping[to] = Some(own + grown),
                    (None, Some(own)) => warping[from] = Some(own - grown),
                    _ => {}
                }
            }
        }
        warping.into_iter().collect()
    }

    /// Integral of the product of two quantities that run straight along the walls, given at the
    /// corners.
    fn product(&self, f: impl Fn(usize) -> f64, g: impl Fn(usize) -> f64) -> f64 {
        let of = |(wall, &[a, b]): (&&Wall, &[usize; 2])| {
            let both = 2.0 * (f(a) * g(a) + f(b) * g(b)) + f(a) * g(b) + f(b) * g(a);
            wall.area() * both / 6.0
        };
        self.walls.iter().zip(&self.ends).map(of).sum()
    }
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// The integrals over walls, counted on the middle of their thickness.
///
/// # Errors
/// What keeps the walls from being a section.
pub fn integrals(walls: &[Wall]) -> Result<Integrals, Fault> {
    let walk = Walk::new(walls);
    let (twice, way) = walk.round();
    let around: f64 =
        walk.walls.iter().zip(&way).map(|(w, way)| way.abs() * w.length() / w.thickness).sum();
    let flow = if around > 0.0 { twice / around } else { 0.0 };
    let warping = walk.warping(&way, flow).ok_or(Fault::Apart)?;
    if walk.walls.len() > walk.corners.len() {
        return Err(Fault::Cells);
    }
    let area = walk.walls.iter().map(|wall| wall.area()).sum::<f64>();
    let at = |k: usize| walk.product(|c| walk.corners[c][k], |_| 1.0) / area;
    let centroid = [at(0), at(1)];
    let own = |c: usize, k: usize| walk.corners[c][k] - centroid[k];
    let moment = |i: usize, j: usize| walk.product(|c| own(c, i), |c| own(c, j));
    let second_moments @ [first, mixed, second] = [moment(1, 1), moment(0, 1), moment(0, 0)];
    let resisting = first * second - mixed * mixed;
    let bends = resisting > MEETS * MEETS * (first + second).powi(2);
    if !bends {
        return Err(Fault::Straight);
    }
    let warped = |k: usize| walk.product(|c| warping[c], |c| own(c, k));
    let (by_1, by_2) = (warped(0), warped(1));
    let shear_center =
        [(second * by_2 - mixed * by_1) / resisting, (mixed * by_2 - first * by_1) / resisting];
    let open = |(wall, way): (&&Wall, &f64)| match *way {
        0.0 => wall.length() * wall.thickness.powi(3) / 3.0,
        _ => 0.0,
    };
    let torsion = twice * flow + walk.walls.iter().zip(&way).map(open).sum::<f64>();
    Ok(Integrals { area, centroid, second_moments, torsion, shear_center, corners: walk.corners })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn walls(points: &[[f64; 2]], thickness: &[f64]) -> Vec<Wall> {
        let ends = points.array_windows::<2>();
        ends.zip(thickness).map(|(ends, &thickness)| Wall { ends: *ends, thickness }).collect()
    }

    fn near(a: f64, b: f64, by: f64) {
        assert!((a - b).abs() < by, "{a} {b}");
    }

    /// Requirement: the shear centre of a channel lies 3 b^2 s / (h t + 6 b s) behind its web, its
    /// torsion constant is the sum of its walls; wherever the origin is. Source: Timoshenko,
    /// Strength of Materials I, article 54.
    #[test]
    fn channel() {
        let (b, h, s, t) = (5.0, 8.0, 0.3, 0.2);
        for [x, y] in [[0.0, 0.0], [3.0, -7.0]] {
            let points = [[x + b, y], [x, y], [x, y + h], [x + b, y + h]];
            let own = integrals(&walls(&points, &[s, t, s])).unwrap();
            near(own.shear_center[0], x - 3.0 * b * b * s / (h * t + 6.0 * b * s), 1e-12);
            near(own.shear_center[1], y + 0.5 * h, 1e-12);
            near(own.torsion, (2.0 * b * s.powi(3) + h * t.powi(3)) / 3.0, 1e-14);
            near(own.area, 2.0 * b * s + h * t, 1e-13);
            near(own.second_moments[0], t * h.powi(3) / 12.0 + b * s * h * h / 2.0, 1e-11);
            near(own.second_moments[1], 0.0, 1e-12);
        }
    }

    /// Requirement: a slit ring is sheared without twist on the side away from the slit, at twice
    /// its radius from its middle; without the slit in its middle, with J of a thin pipe. Tolerance:
    /// a polygon of 400 sides.
    #[test]
    fn ring_with_and_without_a_slit() {
        let (radius, t, sides) = (3.0, 0.1, 400);
        let at = |k: usize| {
            let (s, c) = (TAU * k as f64 / sides as f64).sin_cos();
            [radius * c, radius * s]
        };
        let closed: Vec<[f64; 2]> = (0..=sides).map(|k| at(k % sides)).collect();
        let slit: Vec<[f64; 2]> = (0..sides).map(at).collect();
        let own = integrals(&walls(&closed, &[t; 400])).unwrap();
        near(own.torsion, TAU * radius.powi(3) * t, 1e-3 * own.torsion);
        near(own.shear_center[0].hypot(own.shear_center[1]), 0.0, 1e-9);
        let own = integrals(&walls(&slit, &[t; 400])).unwrap();
        near(own.shear_center[0], -2.0 * radius, 0.03 * radius);
        near(own.torsion, TAU * radius * t.powi(3) / 3.0, 4e-3 * own.torsion);
    }

    /// Requirement: shear flows of a force through the shear centre of a box with walls of four
    /// thicknesses do not twist it: the integral of q ds / t round the cell vanishes, and their
    /// moment is that of the force. Source: Bredt and Jourawski, integrated here by steps.
    #[test]
    fn box_with_unequal_walls() {
        let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 6.0], [0.0, 6.0], [0.0, 0.0]];
        let thickness = [0.1, 0.4, 0.2, 0.15];
        let own = integrals(&walls(&points, &thickness)).unwrap();
        near(own.torsion, 4.0 * 24.0_f64.powi(2) / (40.0 + 15.0 + 20.0 + 40.0), 1e-10);
        // a force of 1 along axis 2: q = q0 - integral of t (a x1 + b x2) ds
        let [first, mixed, second] = own.second_moments;
        let det = first * second - mixed * mixed;
        let (a, b) = (-mixed / det, second / det);
        let (mut moment, mut round, mut around, mut swept) = (0.0, 0.0, 0.0, 0.0);
        let mut q = 0.0;
        for (ends, t) in points.array_windows::<2>().zip(thickness) {
            let steps = 2000;
            let length = (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]);
            let h = length / f64::from(steps);
            for step in 0..steps {
                let part = (f64::from(step) + 0.5) / f64::from(steps);
                let x: [f64; 2] =
                    std::array::from_fn(|k| ends[0][k] + part * (ends[1][k] - ends[0][k]));
                let force = t * (a * (x[0] - own.centroid[0]) + b * (x[1] - own.centroid[1]));
                q -= 0.5 * h * force;
                let arm = cross(
                    x,
                    [(ends[1][0] - ends[0][0]) / length, (ends[1][1] - ends[0][1]) / length],
                );
                moment += q * arm * h;
                round += q * h / t;
                around += h / t;
                swept += arm * h;
                q -= 0.5 * h * force;
            }
        }
        let untwisted = moment - round / around * swept;
        near(own.shear_center[0], untwisted, 1e-5);
    }

    /// Requirement: what is no section is refused, and says why.
    #[test]
    fn faults() {
        let apart =
            [walls(&[[0.0; 2], [1.0, 0.0]], &[0.1]), walls(&[[0.0, 1.0], [1.0, 2.0]], &[0.1])];
        assert_eq!(integrals(&apart.concat()), Err(Fault::Apart));
        let line = walls(&[[0.0; 2], [1.0, 1.0], [2.0, 2.0]], &[0.1, 0.1]);
        assert_eq!(integrals(&line), Err(Fault::Straight));
        let mut two = walls(&[[0.0; 2], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0], [0.0; 2]], &[0.1; 4]);
        two.extend(walls(&[[0.0; 2], [2.0, 1.0]], &[0.1]));
        assert_eq!(integrals(&two), Err(Fault::Cells));
    }
}
