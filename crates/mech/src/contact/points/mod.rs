//! Where contact is sampled, with which weight.
//!
//! ```text
//!      o--------o--------o----o      slave nodes
//!      |<-->|<------>|<---->|<>|     half of every element that meets there, times the width
//!
//!      o----m----o                   a three-node beam: 1/6, 4/6, 1/6 of it
//! ```

pub mod faces;
pub mod integration_points;
pub mod looking;
pub mod slopes;

/// How far contact reaches across the plane of the model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Across {
    /// So far everywhere [L].
    Width(f64),
    /// Once about axis 2, which is the axis of the model.
    Ring,
}

impl Across {
    /// Widths that belong to the shares of an element's two nodes [L]: docs/theory.md eq. (6.8).
    fn of_nodes(self, shares: [f64; 2], ends: [[f64; 3]; 2]) -> [f64; 2] {
        let radii = match self {
            Self::Width(width) => return [width; 2],
            Self::Ring => ends.map(|end| end[0]),
        };
        let toward = |own: f64, other: f64| (2.0 * own + other) / 3.0;
        let linear = [toward(radii[0], radii[1]), toward(radii[1], radii[0])];
        let of = |k: usize| match shares == [0.5; 2] || radii[k] <= 0.0 {
            true => linear[k],
            false => radii[k],
        };
        [of(0), of(1)].map(|radius| std::f64::consts::TAU * radius)
    }
}

/// Tributary areas of slave nodes [L2]: A_i = sum over the elements meeting at node i of its share
/// times their length and width, chords of the undeformed mesh. With shares of one half an end node
/// gets half an element.
///
/// Of each element: its nodes, their shares, their positions [L]; `add` takes a node and its part.
/// [semantics: areas]
pub fn tributary_areas(
    elements: impl Iterator<Item = ([usize; 2], [f64; 2], [[f64; 3]; 2])>,
    across: Across,
    mut add: impl FnMut(usize, f64),
) {
    for (nodes, shares, ends) in elements {
        let length = chord(ends);
        let widths = across.of_nodes(shares, ends);
        for ((node, share), width) in nodes.into_iter().zip(shares).zip(widths) {
            add(node, share * width * length);
        }
    }
}

/// Average length of contact elements by the positions of their nodes [L], for the slip tolerance;
/// zero without elements. [semantics: friction, `SLIP TOLERANCE`]
pub fn average_length(elements: impl Iterator<Item = [[f64; 3]; 2]>) -> f64 {
    let (sum, count) =
        elements.map(chord).fold((0.0, 0.0), |(sum, count), length| (sum + length, count + 1.0));
    if count > 0.0 { sum / count } else { 0.0 }
}

/// Length of an element [L].
pub fn chord([a, b]: [[f64; 3]; 2]) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1]).hypot(b[2] - a[2])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn areas_of(
        elements: &[[usize; 2]],
        shares: &[[f64; 2]],
        coordinates: &[[f64; 3]],
        width: f64,
    ) -> Vec<f64> {
        let mut areas = vec![0.0; coordinates.len()];
        let there = |nodes: &[usize; 2]| nodes.iter().all(|&node| node < coordinates.len());
        let elements = elements.iter().zip(shares).filter(|(nodes, _)| there(nodes));
        let ends = |node: usize| coordinates[node];
        let elements = elements.map(|(&nodes, &shares)| (nodes, shares, nodes.map(ends)));
        tributary_areas(elements, Across::Width(width), |node, area| areas[node] += area);
        areas
    }

    fn average(elements: &[[usize; 2]], coordinates: &[[f64; 3]]) -> f64 {
        average_length(elements.iter().map(|nodes| nodes.map(|node| coordinates[node])))
    }

    fn circle_of_the_1995_deck() -> (Vec<[usize; 2]>, Vec<[f64; 3]>) {
        let r = 9e-3;
        let coordinates = (0..=20)
            .map(|i: i32| {
                let degrees = if i <= 10 { 6 * i } else { 60 + 4 * (i - 10) };
                let (s, c) = f64::from(degrees).to_radians().sin_cos();
                [r * s, -r * c, 0.0]
            })
            .collect();
        ((0..20).map(|i| [i, i + 1]).collect(), coordinates)
    }

    /// Requirement: areas of the seed's ISL deck. Source: semantics, section 3, table. Tolerance: the
    /// digits printed there.
    #[test]
    fn areas_of_the_1995_slide_line_deck() {
        let (elements, coordinates) = circle_of_the_1995_deck();
        let areas = areas_of(&elements, &[[0.5; 2]; 20], &coordinates, 25e-3);
        for (node, area) in [
            (0, 1.177559e-5),
            (5, 2.355118e-5),
            (10, 1.962798e-5),
            (15, 1.570477e-5),
            (20, 7.852387e-6),
        ] {
            assert!((areas[node] - area).abs() < 1e-6 * area, "{node}: {}", areas[node]);
        }
        assert!((0.005 * average(&elements, &coordinates) - 3.9256e-6).abs() < 1e-10);
    }

    /// Requirement: a uniform pressure on a straight line that turns about axis 2 loads its nodes
    /// with 2 pi times the integral of N r: with linear and with quadratic shapes, by Gauss's rule
    /// of three points here. Where a quadratic corner is on the axis its area is small, not zero.
    #[test]
    fn areas_of_rings_are_those_of_their_shape_functions() {
        let (a, b) = ([0.7, 0.2, 0.0], [2.1, 1.4, 0.0]);
        let middle: [f64; 3] = std::array::from_fn(|k| 0.5 * (a[k] + b[k]));
        let gauss = [(-0.6_f64.sqrt(), 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.6_f64.sqrt(), 5.0 / 9.0)];
        let integral = |shape: &dyn Fn(f64) -> f64| {
            let at = |(xi, w): (f64, f64)| w * shape(xi) * (middle[0] + 0.5 * xi * (b[0] - a[0]));
            0.5 * std::f64::consts::TAU * chord([a, b]) * gauss.map(at).iter().sum::<f64>()
        };
        type Part = ([usize; 2], [f64; 2], [[f64; 3]; 2]);
        let ring = |parts: &[Part]| {
            let mut areas = vec![0.0; 3];
            let parts = parts.iter().copied();
            tributary_areas(parts, Across::Ring, |node, area| areas[node] += area);
            areas
        };
        let linear = ring(&[([0, 1], [0.5; 2], [a, b])]);
        assert!((linear[0] - integral(&|xi| 0.5 - 0.5 * xi)).abs() < 1e-14);
        assert!((linear[1] - integral(&|xi| 0.5 + 0.5 * xi)).abs() < 1e-14);
        let thirds = [1.0 / 3.0, 2.0 / 3.0];
        let halves = [([0, 1], thirds, [a, middle]), ([1, 2], [thirds[1], thirds[0]], [middle, b])];
        let quadratic = ring(&halves);
        assert!((quadratic[0] - integral(&|xi| 0.5 * xi * (xi - 1.0))).abs() < 1e-14);
        assert!((quadratic[1] - integral(&|xi| 1.0 - xi * xi)).abs() < 1e-14);
        assert!((quadratic[2] - integral(&|xi| 0.5 * xi * (xi + 1.0))).abs() < 1e-14);
        let centre = [0.0, 1.0, 0.0];
        assert!(ring(&[([0, 1], thirds, [centre, middle])])[0] > 0.0);
    }

    #[test]
    fn nothing_gives_nothing() {
        assert_eq!(average(&[], &[]), 0.0);
        assert_eq!(areas_of(&[[0, 7]], &[[0.5; 2]], &[[0.0; 3]], 1.0), vec![0.0]);
    }

    /// Requirement: a uniform pressure on a line of quadratic shape loads its three nodes with
    /// 1/6, 4/6 and 1/6 of its resultant: force and work are exact for every parabola, here
    /// w(x) = x (l - x). Source: Simpson's rule. Tolerance: rounding.
    #[test]
    fn a_uniform_pressure_on_a_parabola_does_its_work() {
        let (length, width, pressure) = (3.0, 0.5, 7.0);
        let coordinates = [0.0, 0.5, 1.0].map(|x| [x * length, 0.0, 0.0]);
        let shares = [[1.0 / 3.0, 2.0 / 3.0], [2.0 / 3.0, 1.0 / 3.0]];
        let areas = areas_of(&[[0, 1], [1, 2]], &shares, &coordinates, width);
        let work: f64 =
            areas.iter().zip(coordinates).map(|(a, [x, ..])| pressure * a * x * (length - x)).sum();
        let exact = pressure * width * length.powi(3) / 6.0;
        assert!((work - exact).abs() < 1e-14 * exact, "{work} {exact}");
        assert!((areas.iter().sum::<f64>() - width * length).abs() < 1e-15);
    }
}
