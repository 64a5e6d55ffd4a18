//! Which of two nodes that meet is the slave.
//!
//! ```text
//!    o sharp edge    o fine    o coarse    o - o - o as they follow one another
//!      first                                 last
//! ```
//!
//! docs/theory.md section 5.12. (derived)

use crate::surface::mesh::FaceMesh;
use crate::vector::Vector;
use std::collections::VecDeque;

/// Sharp edges that stand out come first, then what has smaller faces, in classes of twice the size,
/// then all as they follow one another over the surface.
pub(super) fn ranks(
    (mesh, reference): (&FaceMesh, &[Vector]),
    at: &[Vec<usize>],
    fineness: &[f64],
) -> Vec<usize> {
    let mut is_edge = vec![false; at.len()];
    for (face, own) in mesh.faces().iter().enumerate() {
        let corners = own.cell.faces.len();
        let stands_out = |edge: &usize| {
            let other = mesh.neighbour(face, *edge);
            other.is_some_and(|other| mesh.stands_out(face, other, reference))
        };
        for edge in (0..corners).filter(stands_out) {
            let ends = [edge, (edge + 1) % corners, corners + edge];
            let nodes = ends.iter().filter_map(|&end| own.nodes.get(end));
            nodes.for_each(|&node| is_edge[node] = true);
        }
    }
    let longest = fineness.iter().copied().fold(0.0, f64::max);
    let class = |node: usize| -((longest / fineness[node]).log2() + 0.5).floor() as i64;
    let follows = following(mesh, at);
    let mut order: Vec<usize> = (0..at.len()).collect();
    order.sort_by_key(|&node| (!is_edge[node], class(node), follows[node]));
    let mut ranks = vec![0; at.len()];
    for (rank, node) in order.into_iter().enumerate() {
        ranks[node] = rank;
    }
    ranks
}

/// The number of every node as they follow one another over the surface from an end of it, one
/// connected stretch after the other: neighbours have numbers near to one another.
fn following(mesh: &FaceMesh, at: &[Vec<usize>]) -> Vec<usize> {
    let mut number = vec![usize::MAX; at.len()];
    let mut count = 0;
    let mut seen = vec![usize::MAX; at.len()];
    for first in 0..at.len() {
        if number[first] != usize::MAX {
            continue;
        }
        let stretch = spreading(mesh, at, first, (&mut seen, first));
        let end = stretch.last().copied().unwrap_or(first);
        // a mark of its own: the stretch is gone over once more, from its end
        for node in spreading(mesh, at, end, (&mut seen, at.len() + first)) {
            number[node] = count;
            count += 1;
        }
    }
    number
}

/// The connected stretch of every node, by its first node.
pub(super) fn stretches(mesh: &FaceMesh, at: &[Vec<usize>]) -> Vec<usize> {
    let mut seen = vec![usize::MAX; at.len()];
    for first in 0..at.len() {
        if seen[first] == usize::MAX {
            spreading(mesh, at, first, (&mut seen, first));
        }
    }
    seen
}

/// The nodes of a stretch in the order in which a wave from one of them meets them; what it met is
/// marked.
fn spreading(
    mesh: &FaceMesh,
    at: &[Vec<usize>],
    from: usize,
    (seen, mark): (&mut [usize], usize),
) -> Vec<usize> {
    let mut open = VecDeque::from([from]);
    seen[from] = mark;
    let mut order = Vec::new();
    while let Some(node) = open.pop_front() {
        order.push(node);
        for &face in &at[node] {
            for &next in &mesh.faces()[face].nodes {
                if seen[next] != mark {
                    seen[next] = mark;
                    open.push_back(next);
                }
            }
        }
    }
    order
}
