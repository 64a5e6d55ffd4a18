//! Orders of elimination with little fill, and the choice among them.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;
use feral_amf::amf_order;
use feral_scotch::{CscPattern, scotch_order};

use crate::fronts::Tree;
use crate::pattern::Pattern;

/// Operations of a factorisation from which on a second order is tried: below, ordering costs as
/// much as it could save.
const WORTH_FILL: f64 = 3e7;
/// And from which on nested dissection is tried, which takes longer.
const WORTH_DISSECTION: f64 = 1e9;

/// The elimination tree with the fewest predicted operations; `None` when the pattern is beyond the
/// libraries.
pub(crate) fn best_tree(pattern: &Pattern) -> Option<Tree> {
    let mut best = Tree::new(pattern, &minimum_degree(pattern)?);
    let operations = best.predicted().1;
    if operations < WORTH_FILL {
        return Some(best);
    }
    let mut consider = |order: Option<Vec<usize>>| {
        if let Some(order) = order {
            let tree = Tree::new(pattern, &order);
            if tree.predicted().1 < best.predicted().1 {
                best = tree;
            }
        }
    };
    let graph = Graph::new(pattern)?;
    consider(graph.order(|pattern| amf_order(pattern).ok()));
    if operations >= WORTH_DISSECTION {
        consider(graph.order(|pattern| scotch_order(pattern).ok()));
    }
    Some(best)
}

/// Work of the solutions on an interface that follow a factorisation, for each entry of the factor
/// that they read, in operations of the factorisation [1]: sixty of them, each reading it twice, ten
/// times slower than dense products (judged by blocks slid on foundations).
const SOLUTIONS: f64 = 1200.0;

/// As [`best_tree`], where most solutions are wanted on an interface alone: its equations come last
/// where that is predicted to take less time for both. They are then one dense front.
pub(crate) fn best_tree_for(pattern: &Pattern, interface: &[usize]) -> Option<Tree> {
    let free = best_tree(pattern)?;
    if interface.is_empty() {
        return Some(free);
    }
    let mut is_kept = vec![true; pattern.size()];
    interface.iter().for_each(|&equation| is_kept[equation] = false);
    let kept: Vec<usize> = (0..pattern.size()).filter(|&i| is_kept[i]).collect();
    let time = |tree: &Tree| tree.predicted().1 + SOLUTIONS * tree.entries_above(interface);
    // the front alone may be too large: its order need not be sought then
    let width = (pattern.size() - kept.len()) as f64;
    if width.powi(3) / 3.0 > time(&free) {
        return Some(free);
    }
    let mut order: Vec<usize> =
        best_tree(&pattern.among(&kept))?.order.into_iter().map(|i| kept[i]).collect();
    order.extend((0..pattern.size()).filter(|&i| !is_kept[i]));
    let last = Tree::new(pattern, &order);
    Some(if time(&last) < time(&free) { last } else { free })
}

/// Approximate minimum degree [amestoy1996].
fn minimum_degree(pattern: &Pattern) -> Option<Vec<usize>> {
    let n = pattern.size();
    let structure =
        SymbolicSparseColMatRef::new_checked(n, n, pattern.row_start(), None, pattern.columns());
    let (mut order, mut position) = (vec![0; n], vec![0; n]);
    let need = amd::order_scratch::<usize>(n, pattern.entries());
    let mut memory = MemBuffer::try_new(need).ok()?;
    let stack = MemStack::new(&mut memory);
    amd::order(&mut order, &mut position, structure, amd::Control::default(), stack).ok()?;
    Some(order)
}

/// The graph of the nodes: equations with the same neighbours are one vertex.
pub(crate) struct Graph {
    /// Where the neighbours of each vertex begin.
    pub start: Vec<i32>,
    /// Neighbours, those of one vertex after those of another.
    pub neighbour: Vec<i32>,
    /// Equations of each vertex, one vertex after another.
    equation: Vec<usize>,
    equation_start: Vec<usize>,
}

impl Graph {
    /// `None` where it is beyond 32-bit numbers.
    pub fn new(pattern: &Pattern) -> Option<Self> {
        let n = pattern.size();
        let mut vertex = vec![usize::MAX; n];
        let (mut equation, mut equation_start) = (Vec::with_capacity(n), vec![0]);
        for i in 0..n {
            if vertex[i] != usize::MAX {
                continue;
            }
            let own = equation_start.len() - 1;
            let row = pattern.row(i);
            let alike = |&&j: &&usize| j >= i && vertex[j] == usize::MAX && pattern.row(j) == row;
            let members: Vec<usize> = row.iter().filter(alike).copied().collect();
            members.iter().for_each(|&j| vertex[j] = own);
            equation.extend(members);
            equation_start.push(equation.len());
        }
        let (mut start, mut neighbour) = (vec![0], Vec::new());
        for own in 0..equation_start.len() - 1 {
            let row = pattern.row(equation[equation_start[own]]);
            let begin = neighbour.len();
            let others = row.iter().map(|&j| vertex[j]).filter(|&other| other != own);
            neighbour.extend(others.map(|other| other as i32));
            neighbour[begin..].sort_unstable();
            let mut kept = begin;
            for at in begin..neighbour.len() {
                if at == begin || neighbour[at] != neighbour[kept - 1] {
                    neighbour[kept] = neighbour[at];
                    kept += 1;
                }
            }
            neighbour.truncate(kept);
            start.push(i32::try_from(kept).ok()?);
        }
        Some(Self { start, neighbour, equation, equation_start })
    }

    /// Equations of every vertex.
    pub fn vertices(&self) -> impl Iterator<Item = &[usize]> {
        self.equation_start.windows(2).map(|pair| &self.equation[pair[0]..pair[1]])
    }

    /// The equations in the order that a library finds for the vertices.
    fn order(&self, find: impl Fn(&CscPattern<'_>) -> Option<Vec<i32>>) -> Option<Vec<usize>> {
        let vertices = self.start.len() - 1;
        let pattern = CscPattern::new(vertices, &self.start, &self.neighbour)?;
        let order = find(&pattern)?;
        let mut equations = Vec::with_capacity(self.equation.len());
        let mut met = vec![false; vertices];
        for vertex in order {
            let vertex = usize::try_from(vertex).ok()?;
            if std::mem::replace(met.get_mut(vertex)?, true) {
                return None; // no order
            }
            let own = self.equation_start[vertex]..self.equation_start[vertex + 1];
            equations.extend_from_slice(&self.equation[own]);
        }
        (equations.len() == self.equation.len()).then_some(equations)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Grid of bricks with three dofs a node.
    fn bricks(side: usize) -> Pattern {
        let node = |[x, y, z]: [usize; 3]| x + side * (y + side * z);
        let cells = (0..(side - 1).pow(3))
            .map(|c| [c % (side - 1), c / (side - 1) % (side - 1), c / (side - 1).pow(2)]);
        let clique = |[x, y, z]: [usize; 3]| -> Vec<usize> {
            let corners = (0..8).map(|c| node([x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)]));
            corners.flat_map(|corner| 3 * corner..3 * corner + 3).collect()
        };
        let cliques: Vec<Vec<usize>> = cells.map(clique).collect();
        Pattern::from_cliques(3 * side.pow(3), cliques.iter())
    }

    /// Requirement: the dofs of a node are one vertex, and orders of vertices become orders of
    /// equations; what is no order is refused.
    #[test]
    fn nodes_are_vertices() {
        let pattern = bricks(4);
        let graph = Graph::new(&pattern).unwrap();
        assert_eq!(graph.start.len() - 1, 64);
        assert_eq!(graph.neighbour.len(), bricks(4).entries() / 9 - 64);
        let order = graph.order(|vertices| Some((0..vertices.n as i32).rev().collect())).unwrap();
        assert_eq!(order[..4], [189, 190, 191, 186]);
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert!(sorted.into_iter().eq(0..192));
        for wrong in [vec![0; 64], vec![-1; 64], vec![64; 64], vec![]] {
            assert_eq!(graph.order(|_| Some(wrong.clone())), None);
        }
    }

    /// Requirement: a face of a grid comes last, so that solutions on it read less; every tenth
    /// equation of it does not, which would fill a front as large as the grid.
    #[test]
    fn a_small_interface_comes_last() {
        let pattern = bricks(9);
        let face: Vec<usize> = (0..3 * 81).collect();
        let (free, last) = (best_tree(&pattern).unwrap(), best_tree_for(&pattern, &face).unwrap());
        assert!(last.entries_above(&face) < 0.5 * free.entries_above(&face));
        assert!(last.predicted().1 < 3.0 * free.predicted().1);
        let n = pattern.size();
        let mut order = last.order[n - face.len()..].to_vec();
        order.sort_unstable();
        assert_eq!(order, face);
        let all: Vec<usize> = (0..n).collect();
        assert_eq!(best_tree_for(&pattern, &all).unwrap().order, free.order);
    }

    /// Requirement: the order chosen is no worse than minimum degree, and in space, where nested
    /// dissection halves the work (measured: 2.1 at 49 k dofs, 1.7 here), much better.
    #[test]
    fn the_cheapest_order_is_chosen() {
        let pattern = bricks(13);
        let degree = Tree::new(&pattern, &minimum_degree(&pattern).unwrap()).predicted().1;
        let best = best_tree(&pattern).unwrap().predicted().1;
        assert!(degree > WORTH_DISSECTION && best < 0.75 * degree, "{best:e} {degree:e}");
        let chain = Pattern::from_pairs(50, (0..49).map(|i| (i, i + 1)));
        assert_eq!(best_tree(&chain).unwrap().predicted().0, 99.0);
        assert_eq!(best_tree(&Pattern::from_pairs(0, [].into_iter())).unwrap().order.len(), 0);
    }
}
