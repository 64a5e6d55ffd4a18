//! The surface of solids as triangles: all of plane ones, of those in space what can be seen.
//!
//! ```text
//!   3---2     3-6-2     triangles with a mark for each side that is an edge of an element;
//!   |  /|     7/ \5     a face that two elements share is inside and left out
//!   | / |     |\ /|
//!   0---1     0-4-1
//! ```

use slideline_model::TYPES;
use std::collections::HashMap;

/// Three points, and which of the sides 01, 12, 20 are edges of elements, as bits 1, 2, 4.
pub(super) type Triangle = ([usize; 3], u8);

/// Faces of a cell by its type in VTK files, in the numbers of such files: corners
/// counter-clockwise as seen from outside, then the middles of the sides. Of an area it is the
/// only one.
fn faces(vtk: u8) -> Vec<Vec<usize>> {
    let solid = |kind: &&&slideline_model::ElementType| {
        kind.cell.dimension > 1 && kind.cell.pieces.iter().any(|piece| piece.vtk == vtk)
    };
    let Some(kind) = TYPES.iter().find(solid) else { return Vec::new() };
    let cell = kind.cell;
    let order = cell.pieces.first().map_or(&[][..], |piece| piece.nodes);
    let place = |node: usize| order.iter().position(|own| *own == node).unwrap_or(node);
    match cell.dimension {
        2 => vec![(0..cell.nodes).map(place).collect()],
        _ => cell.faces.iter().map(|face| face.iter().copied().map(place).collect()).collect(),
    }
}

/// Whether a cell fills space. [VTK file formats: cell types]
pub(super) fn is_volume(vtk: u8) -> bool {
    matches!(vtk, 10 | 12 | 13 | 24 | 25 | 26)
}

/// Triangles of a face of so many nodes, by places in it.
fn parts(nodes: usize) -> &'static [([usize; 3], u8)] {
    match nodes {
        3 => &[([0, 1, 2], 7)],
        4 => &[([0, 1, 2], 3), ([0, 2, 3], 6)],
        6 => &[([0, 3, 5], 5), ([3, 1, 4], 3), ([5, 4, 2], 6), ([3, 4, 5], 0)],
        8 => &[
            ([0, 4, 7], 5),
            ([4, 1, 5], 3),
            ([5, 2, 6], 3),
            ([6, 3, 7], 3),
            ([4, 5, 7], 0),
            ([5, 6, 7], 0),
        ],
        _ => &[],
    }
}

/// The surface of cells, each a type and its points. Points with the same label are one: where
/// materials meet they are there twice.
pub(super) fn surface<'a>(
    cells: impl Iterator<Item = (u8, &'a [i64])>,
    labels: &[i64],
) -> Vec<Triangle> {
    let mut known: HashMap<u8, Vec<Vec<usize>>> = HashMap::new();
    let mut found: Vec<Option<Vec<usize>>> = Vec::new();
    let mut place_of: HashMap<Vec<i64>, usize> = HashMap::new();
    for (kind, points) in cells {
        let faces = known.entry(kind).or_insert_with(|| faces(kind));
        for face in faces.iter() {
            let own: Option<Vec<usize>> = face
                .iter()
                .map(|&place| {
                    usize::try_from(*points.get(place)?).ok().filter(|p| *p < labels.len())
                })
                .collect();
            let Some(own) = own else { continue };
            if faces.len() > 1 {
                let mut key: Vec<i64> = own.iter().map(|&point| labels[point]).collect();
                key.sort_unstable();
                if let Some(other) = place_of.insert(key, found.len()) {
                    found[other] = None;
                    found.push(None);
                    continue;
                }
            }
            found.push(Some(own));
        }
    }
    let triangles = found.iter().flatten().flat_map(|face| {
        parts(face.len()).iter().map(|(places, mark)| (places.map(|place| face[place]), *mark))
    });
    triangles.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: triangles of a face cover it once, their marked sides are its rim. Source: area
    /// and rim of the unit square and triangle.
    #[test]
    fn triangles_cover_a_face() {
        let square =
            [[0., 0.], [1., 0.], [1., 1.], [0., 1.], [0.5, 0.], [1., 0.5], [0.5, 1.], [0., 0.5]];
        let triangle = [[0., 0.], [1., 0.], [0., 1.], [0.5, 0.], [0.5, 0.5], [0., 0.5]];
        let cases: [(&[[f64; 2]], f64, f64); 4] = [
            (&triangle[..3], 0.5, 2.0 + 2f64.sqrt()),
            (&square[..4], 1.0, 4.0),
            (&triangle, 0.5, 2.0 + 2f64.sqrt()),
            (&square, 1.0, 4.0),
        ];
        for (nodes, content, rim) in cases {
            let [mut area, mut around] = [0.0; 2];
            for (places, mark) in parts(nodes.len()) {
                let [a, b, c] = places.map(|place| nodes[place]);
                area += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
                for (bit, [p, q]) in [(1, [a, b]), (2, [b, c]), (4, [c, a])] {
                    if mark & bit != 0 {
                        around += (q[0] - p[0]).hypot(q[1] - p[1]);
                    }
                }
            }
            assert!(
                (area - content).abs() < 1e-12 && (around - rim).abs() < 1e-12,
                "{}",
                nodes.len()
            );
        }
    }

    /// Requirement: of two cells that meet, also over copies of their nodes, the face between them
    /// is inside; every cell of space has a closed surface that looks outwards. Source: Euler's
    /// formula by shared sides, each walked once in each direction.
    #[test]
    fn what_two_cells_share_is_inside() {
        let two = [(12, [0, 1, 2, 3, 4, 5, 6, 7]), (12, [8, 9, 10, 11, 12, 13, 14, 15])];
        let labels: Vec<i64> = (1..=8).chain(5..=12).collect();
        let skin = surface(two.iter().map(|(kind, points)| (*kind, &points[..])), &labels);
        assert_eq!(skin.len(), 2 * (12 - 2));
        for kind in TYPES.iter().filter(|kind| kind.cell.dimension > 1) {
            let piece = &kind.cell.pieces[0];
            assert_eq!(is_volume(piece.vtk), kind.cell.dimension == 3, "{}", kind.name());
            if kind.cell.dimension == 2 {
                continue;
            }
            let points: Vec<i64> = (0..piece.nodes.len() as i64).collect();
            let labels: Vec<i64> = (1..=piece.nodes.len() as i64).collect();
            let skin = surface(std::iter::once((piece.vtk, &points[..])), &labels);
            let mut sides: Vec<[usize; 2]> = Vec::new();
            for ([a, b, c], _) in skin {
                sides.extend([[a, b], [b, c], [c, a]]);
            }
            assert!(!sides.is_empty() && sides.iter().all(|[a, b]| sides.contains(&[*b, *a])));
        }
    }
}
