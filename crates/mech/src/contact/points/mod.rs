//! Where contact is sampled, with which weight.
//!
//! ```text
//!      o--------o--------o----o      slave nodes
//!      |<-->|<------>|<---->|<>|     half of every element that meets there, times the width
//! ```

pub mod slopes;
pub mod stations;

/// Tributary area of each slave node [L2]: A_i = width (sum of lengths of the elements meeting at
/// node i)/2, chords of the undeformed mesh. End nodes get half an element.
///
/// `elements` number the nodes 0 .. `node_count`, `coordinates` are those of the nodes; an element
/// that names a node outside is left out. [semantics: areas]
pub fn tributary_areas(
    node_count: usize,
    elements: &[[usize; 2]],
    coordinates: &[[f64; 2]],
    width: f64,
) -> Vec<f64> {
    let mut areas = vec![0.0; node_count];
    for &[first, second] in elements {
        if let Some(length) = chord(coordinates, first, second) {
            for node in [first, second] {
                if let Some(area) = areas.get_mut(node) {
                    *area += 0.5 * width * length;
                }
            }
        }
    }
    areas
}

/// Average length of the contact elements [L], for the slip tolerance; zero without elements.
/// [semantics: friction, `SLIP TOLERANCE`]
pub fn average_length(elements: &[[usize; 2]], coordinates: &[[f64; 2]]) -> f64 {
    let lengths = elements.iter().filter_map(|&[a, b]| chord(coordinates, a, b));
    let (sum, count) = lengths.fold((0.0, 0.0), |(sum, count), length| (sum + length, count + 1.0));
    if count > 0.0 { sum / count } else { 0.0 }
}

fn chord(coordinates: &[[f64; 2]], first: usize, second: usize) -> Option<f64> {
    let (a, b) = (coordinates.get(first)?, coordinates.get(second)?);
    Some((b[0] - a[0]).hypot(b[1] - a[1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn circle_of_the_1995_deck() -> (Vec<[usize; 2]>, Vec<[f64; 2]>) {
        let r = 9e-3;
        let coordinates = (0..=20)
            .map(|i: i32| {
                let degrees = if i <= 10 { 6 * i } else { 60 + 4 * (i - 10) };
                let (s, c) = f64::from(degrees).to_radians().sin_cos();
                [r * s, -r * c]
            })
            .collect();
        ((0..20).map(|i| [i, i + 1]).collect(), coordinates)
    }

    /// Requirement: areas of the seed's ISL deck. Source: semantics, section 3, table. Tolerance: the
    /// digits printed there.
    #[test]
    fn areas_of_the_1995_slide_line_deck() {
        let (elements, coordinates) = circle_of_the_1995_deck();
        let areas = tributary_areas(21, &elements, &coordinates, 25e-3);
        for (node, area) in [
            (0, 1.177559e-5),
            (5, 2.355118e-5),
            (10, 1.962798e-5),
            (15, 1.570477e-5),
            (20, 7.852387e-6),
        ] {
            assert!((areas[node] - area).abs() < 1e-6 * area, "{node}: {}", areas[node]);
        }
        assert!((0.005 * average_length(&elements, &coordinates) - 3.9256e-6).abs() < 1e-10);
    }

    #[test]
    fn nothing_gives_nothing() {
        assert_eq!(average_length(&[], &[]), 0.0);
        assert_eq!(tributary_areas(1, &[[0, 7]], &[[0.0, 0.0]], 1.0), vec![0.0]);
    }
}
