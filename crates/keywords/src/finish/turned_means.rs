//! What follows what where the mean motion of a cloud turns far.
//!
//! ```text
//!   reference node free         it follows, and the cloud moves as it likes
//!   prescribed in part          nodes of the cloud follow, whole: a direction alone would come to lie
//!                               along the arm of its node, where nothing of a turn is seen
//!     o A  o                    A, B follow; what of them is still free is
//!       R->    -->   R          a dof of its own along an axis that turns with R
//!     o B  o
//! ```
//!
//! docs/theory.md section 4.2.

use slideline_diag::Span;
use slideline_model::{Dof, MeanMotion, NodeIndex};
use std::collections::HashSet;
use std::ops::Range;

use super::equations::solve;
use crate::draft::Draft;

/// The dofs of a coupling.
#[derive(Clone, Copy)]
pub(super) struct Columns<'a> {
    /// Those of the reference node first.
    pub names: &'a [(NodeIndex, Dof)],
    /// Those that cannot follow.
    pub taken: &'a [bool],
    /// How many are of the reference node.
    pub own: usize,
    /// Those that follow in small motion.
    pub pivots: &'a [usize],
}

/// Notes a cloud that may turn far; `rows` are its equations of small motion.
pub(super) fn turn_far(
    (reference, cloud): (NodeIndex, &[(NodeIndex, f64)]),
    (rows, columns): (Vec<Vec<f64>>, Columns<'_>),
    (constraints, origin): (Range<usize>, Span),
    draft: &mut Draft,
) {
    // nodes that other constraints follow would close a circle if they followed too
    let others = &draft.model.linear_constraints[..constraints.start];
    let leading = others.iter().flat_map(|own| &own.terms).map(|&(node, ..)| node).collect();
    let (dependents, turning) = columns.followers(rows, &leading);
    for name in &dependents {
        draft.dependents.entry(*name).or_insert(origin);
    }
    let mut coupled = [false; 6];
    columns.names[..columns.own].iter().for_each(|(_, dof)| coupled[*dof as usize] = true);
    let cloud = cloud.iter().copied().filter(|(_, weight)| *weight != 0.0).collect();
    let own = MeanMotion { reference, coupled, cloud, constraints, dependents, turning, origin };
    draft.model.mean_motions.push(own);
}

/// Names of dofs.
type Names = Vec<(NodeIndex, Dof)>;

impl Columns<'_> {
    /// What follows, and what of it follows a dof of its own.
    fn followers(&self, rows: Vec<Vec<f64>>, leading: &HashSet<NodeIndex>) -> (Names, Names) {
        let pivots = self.pivots_far(rows, leading);
        let whole: HashSet<NodeIndex> =
            pivots.iter().filter(|own| **own >= self.own).map(|&own| self.names[own].0).collect();
        let follows = |column: &usize| {
            let of_cloud = *column >= self.own && whole.contains(&self.names[*column].0);
            pivots.contains(column) || of_cloud && !self.taken[*column]
        };
        let all: Vec<usize> = (0..self.names.len()).filter(follows).collect();
        let names = |columns: &mut dyn Iterator<Item = &usize>| -> Names {
            columns.map(|&column| self.names[column]).collect()
        };
        let turning = names(&mut all.iter().filter(|column| !pivots.contains(column)));
        (names(&mut all.iter()), turning)
    }

    /// The dofs for which the equations are solved: those of the reference node where all of them are free, else
    /// of nodes that are free in all directions and that nothing else follows, else of such that something
    /// follows, else of free directions, else what follows in small motion.
    fn pivots_far(&self, rows: Vec<Vec<f64>>, leading: &HashSet<NodeIndex>) -> Vec<usize> {
        if !self.taken[..self.own].contains(&true) {
            return self.pivots.to_vec();
        }
        let held: HashSet<NodeIndex> =
            self.names.iter().zip(self.taken).filter(|own| *own.1).map(|own| own.0.0).collect();
        let columns = || self.names.iter().zip(self.taken).enumerate();
        let of_whole = columns().map(|(place, own)| place < self.own || held.contains(&own.0.0));
        let of_whole: Vec<bool> = of_whole.collect();
        let is_leading = self.names.iter().map(|own| leading.contains(&own.0));
        let of_own = of_whole.iter().zip(is_leading).map(|(held, leads)| *held || leads).collect();
        let of_free = columns().map(|(place, own)| place < self.own || *own.1);
        let tried: [Vec<bool>; 3] = [of_own, of_whole, of_free.collect()];
        let found = tried.iter().find_map(|taken| solve(rows.clone(), 0, taken));
        let solved = |rows: Vec<(usize, Vec<f64>)>| rows.into_iter().map(|own| own.0).collect();
        found.map_or_else(|| self.pivots.to_vec(), solved)
    }
}
