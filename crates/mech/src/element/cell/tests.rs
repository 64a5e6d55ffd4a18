use super::*;

const SOLIDS: [&Cell; 10] =
    [&TRI3, &TRI6, &QUAD4, &QUAD8, &TET4, &TET10, &WEDGE6, &WEDGE15, &HEX8, &HEX20];
/// Inside every reference cell.
const INSIDE: [f64; 3] = [0.3, 0.15, -0.4];

fn shapes(cell: &Cell, at: [f64; 3]) -> Vec<f64> {
    let mut shapes = vec![0.0; cell.nodes];
    (cell.shapes)(&at, &mut shapes);
    shapes
}

fn slopes(cell: &Cell, at: [f64; 3]) -> Vec<[f64; 3]> {
    let mut slopes = vec![[0.0; 3]; cell.nodes];
    (cell.slopes)(&at, &mut slopes);
    slopes
}

/// Requirement: a cell agrees with itself: nodes of faces and pieces exist, both orders of a piece
/// are orders of the same nodes.
#[test]
fn cells_agree_with_themselves() {
    for cell in [&POINT, &LINE2, &LINE3].into_iter().chain(SOLIDS) {
        let named = cell.faces.iter().copied().chain(cell.pieces.iter().map(|p| p.nodes));
        assert!(named.flatten().all(|&node| node < cell.nodes), "{}", cell.name);
        for piece in cell.pieces {
            let sorted = |nodes: &[usize]| {
                let mut nodes = nodes.to_vec();
                nodes.sort_unstable();
                nodes
            };
            assert_eq!(sorted(piece.nodes), sorted(piece.frd_nodes), "{}", cell.name);
        }
    }
}

/// Requirement: shape functions are one at their own node and zero at the others, sum to one, and
/// slopes are their derivatives. Tolerance: rounding, of a central difference of quadratic
/// functions with products (its error is the third derivative).
#[test]
fn shapes_and_slopes() {
    for cell in SOLIDS {
        assert_eq!(cell.places.len(), cell.nodes);
        for (node, place) in cell.places.iter().enumerate() {
            for (other, shape) in shapes(cell, *place).into_iter().enumerate() {
                let exact = if node == other { 1.0 } else { 0.0 };
                assert!((shape - exact).abs() < 1e-15, "{} {node} {other}", cell.name);
            }
        }
        assert!((shapes(cell, INSIDE).iter().sum::<f64>() - 1.0).abs() < 1e-15);
        let slopes = slopes(cell, INSIDE);
        for axis in 0..cell.dimension {
            assert!(slopes.iter().map(|slope| slope[axis]).sum::<f64>().abs() < 1e-15);
            let moved = |by: f64| {
                let mut at = INSIDE;
                at[axis] += by;
                shapes(cell, at)
            };
            let (up, down) = (moved(1e-4), moved(-1e-4));
            for node in 0..cell.nodes {
                let difference = (up[node] - down[node]) / 2e-4;
                assert!((slopes[node][axis] - difference).abs() < 1e-8, "{} {node}", cell.name);
            }
        }
    }
}

/// Area vector of a face of a volume and the integral of its position along it, by corners and
/// middle nodes in straight lines: each edge with the centre of the face.
fn face(cell: &Cell, nodes: &[usize]) -> ([f64; 3], f64) {
    let corners = if nodes.len() > 4 { nodes.len() / 2 } else { nodes.len() };
    let at = |k: usize| cell.places[nodes[k % corners]];
    let middle: [f64; 3] =
        std::array::from_fn(|axis| (0..corners).map(|k| at(k)[axis]).sum::<f64>() / corners as f64);
    let mut area = [0.0; 3];
    for k in 0..corners {
        let a: [f64; 3] = std::array::from_fn(|axis| at(k)[axis] - middle[axis]);
        let b: [f64; 3] = std::array::from_fn(|axis| at(k + 1)[axis] - middle[axis]);
        for (axis, area) in area.iter_mut().enumerate() {
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            *area += 0.5 * (a[i] * b[j] - a[j] * b[i]);
        }
    }
    (area, (0..3).map(|axis| middle[axis] * area[axis]).sum())
}

/// Requirement: faces close the cell and look outwards: area vectors sum to zero, the divergence
/// theorem gives the volume; middle nodes stand in the middle of their edge. Source: geometry.
#[test]
fn faces_close_the_cell() {
    for (cell, volume) in [(&TET4, 1.0 / 6.0), (&WEDGE6, 1.0), (&HEX8, 8.0)].into_iter().chain([
        (&TET10, 1.0 / 6.0),
        (&WEDGE15, 1.0),
        (&HEX20, 8.0),
    ]) {
        let (mut sum, mut content) = ([0.0; 3], 0.0);
        for nodes in cell.faces {
            let (area, flow) = face(cell, nodes);
            (0..3).for_each(|axis| sum[axis] += area[axis]);
            content += flow / 3.0;
            assert!(flow >= 0.0);
        }
        assert!(sum.iter().all(|s| s.abs() < 1e-15), "{} {sum:?}", cell.name);
        assert!((content - volume).abs() < 1e-15, "{} {content}", cell.name);
    }
    for cell in [&TRI3, &TRI6, &QUAD4, &QUAD8] {
        for (place, nodes) in cell.faces.iter().enumerate() {
            let next = cell.faces[(place + 1) % cell.faces.len()];
            assert_eq!(nodes[nodes.len() - 1], next[0], "{}", cell.name);
        }
    }
}

/// Requirement: the middle nodes of a face stand between its corners.
#[test]
fn middles_of_faces() {
    for cell in [&TRI6, &QUAD8, &TET10, &WEDGE15, &HEX20] {
        for nodes in cell.faces {
            let edges: Vec<[usize; 3]> = match **nodes {
                [a, middle, b] => vec![[a, middle, b]],
                _ => {
                    let corners = nodes.len() / 2;
                    let edge = |k| [nodes[k], nodes[corners + k], nodes[(k + 1) % corners]];
                    (0..corners).map(edge).collect()
                }
            };
            for [a, middle, b] in edges {
                for axis in 0..3 {
                    let between = 0.5 * (cell.places[a][axis] + cell.places[b][axis]);
                    assert_eq!(between, cell.places[middle][axis], "{} {nodes:?}", cell.name);
                }
            }
        }
    }
}
