//! What follows from dimension and number of nodes of a cell.

/// Whether elements here have such cells.
pub(crate) fn is_known(dimension: usize, nodes: usize) -> bool {
    matches!(
        (dimension, nodes),
        (0, 1) | (1, 2 | 3) | (2, 3 | 4 | 6 | 8) | (3, 4 | 6 | 8 | 10 | 15 | 20)
    )
}

/// How many nodes of a cell an element here has, the first ones: quadratic cells may have nodes in
/// the middle of faces and volumes, and the edges of what is left are the same curves.
pub(crate) fn kept(dimension: usize, nodes: usize) -> usize {
    match (dimension, nodes) {
        (2, 9) => 8,
        (3, 18) => 15,
        (3, 27) => 20,
        _ => nodes,
    }
}

/// The corners of a line or an area, by their numbers, ascending: what a face of an element and a
/// cell on it have in common.
pub(crate) fn corners(dimension: usize, nodes: &[u64]) -> Vec<u64> {
    let mut corners = match (dimension, nodes.len()) {
        // a line ends with its ends, its middle is between them
        (1, 3) => vec![nodes[0], nodes[2]],
        (2, 6) => nodes[..3].to_vec(),
        (2, 8) => nodes[..4].to_vec(),
        _ => nodes.to_vec(),
    };
    corners.sort_unstable();
    corners
}

/// The nodes of an area walked the other way round.
pub(crate) fn reversed(nodes: &[u64]) -> Vec<u64> {
    let order: &[usize] = match nodes.len() {
        3 => &[0, 2, 1],
        4 => &[0, 3, 2, 1],
        6 => &[0, 2, 1, 5, 4, 3],
        8 => &[0, 3, 2, 1, 7, 6, 5, 4],
        _ => return nodes.to_vec(),
    };
    order.iter().map(|&place| nodes[place]).collect()
}

/// Corners of an area: half of the nodes of a quadratic one.
pub(crate) fn corner_count(nodes: usize) -> usize {
    if nodes > 4 { nodes / 2 } else { nodes }
}
