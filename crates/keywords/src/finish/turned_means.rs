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
use slideline_model::{Dof, LinearConstraint, LinearMeanTurn, MeanMotion, NodeIndex};
use std::collections::HashSet;
use std::ops::Range;

use super::equations::{has_circle, solve};
use crate::constraints::OpenMean;
use crate::draft::Draft;

/// Chooses what follows what where clouds turn far, once all other constraints are known. A cloud that these
/// leave no choice stays linear.
pub(super) fn turn_far(draft: &mut Draft) {
    if draft.means.is_empty() {
        return;
    }
    let prescribed = super::steps::prescribed(draft);
    let carrying: HashSet<NodeIndex> =
        draft.model.rigid_links.iter().map(|link| link.master).collect();
    let hanging = draft.model.mean_motions.iter();
    let mut chosen: Vec<Large> = hanging.map(|own| in_large_motion(own, draft)).collect();
    for own in std::mem::take(&mut draft.means) {
        let follows = own.pivots.iter().map(|&pivot| own.names[pivot]).collect::<HashSet<_>>();
        let is_taken = |name: &(NodeIndex, Dof)| {
            let by_others = draft.dependents.contains_key(name) && !follows.contains(name);
            by_others || prescribed.contains(name) || carrying.contains(&name.0)
        };
        let taken: Vec<bool> = own.names.iter().map(is_taken).collect();
        let others = draft.model.linear_constraints.iter().enumerate();
        let others = others.filter(|(place, _)| !own.constraints.contains(place));
        // nodes that other constraints follow would close a circle if they followed too
        let terms = others.flat_map(|(_, other)| &other.terms);
        let leading = terms.map(|&(node, ..)| node).collect();
        let found = Columns { of: &own, taken: &taken }.followers(&leading);
        let Some((dependents, turning)) = found else {
            draft.model.linear_mean_turns.push(own.linear);
            continue;
        };
        chosen.push((own.constraints.clone(), own.in_large_motion(&dependents)));
        if has_circle(&replaced(&draft.model.linear_constraints, &chosen)) {
            chosen.pop();
            draft.model.linear_mean_turns.push(own.linear);
            continue;
        }
        let origin = own.linear.origin;
        dependents.iter().for_each(|&name| _ = draft.dependents.entry(name).or_insert(origin));
        draft.model.mean_motions.push(own.motion(dependents, turning));
    }
}

/// Constraints of small motion, and what stands for them in large motion.
pub(super) type Large = (Range<usize>, Vec<LinearConstraint>);

/// What follows what where a node hangs at faces, with coefficients of none.
pub(super) fn in_large_motion(own: &MeanMotion, draft: &Draft) -> Large {
    let axes = draft.model.directions().iter().filter(|dof| !dof.is_rotation());
    let names = own.cloud.iter().flat_map(|&(node, _)| axes.clone().map(move |&dof| (node, dof)));
    (own.constraints.clone(), following(&own.dependents, names, own.origin))
}

/// Dofs that follow others, with coefficients of none.
fn following(
    dependents: &[(NodeIndex, Dof)],
    followed: impl Iterator<Item = (NodeIndex, Dof)>,
    origin: Span,
) -> Vec<LinearConstraint> {
    let terms: Vec<_> = followed.map(|(node, dof)| (node, dof, 1.0)).collect();
    let follows =
        |&dependent| LinearConstraint { dependent, terms: terms.clone(), constant: 0.0, origin };
    dependents.iter().map(follows).collect()
}

/// The constraints with others in place of some.
pub(super) fn replaced(constraints: &[LinearConstraint], by: &[Large]) -> Vec<LinearConstraint> {
    let replaced: HashSet<usize> = by.iter().flat_map(|own| own.0.clone()).collect();
    let stay = constraints.iter().enumerate().filter(|(place, _)| !replaced.contains(place));
    stay.map(|(_, own)| own).chain(by.iter().flat_map(|own| &own.1)).cloned().collect()
}

impl OpenMean {
    /// What follows what, with coefficients of none.
    fn in_large_motion(&self, dependents: &[(NodeIndex, Dof)]) -> Vec<LinearConstraint> {
        let followed = self.names.iter().filter(|name| !dependents.contains(name));
        following(dependents, followed.copied(), self.linear.origin)
    }

    fn motion(self, dependents: Names, turning: Names) -> MeanMotion {
        let mut coupled = [false; 6];
        self.names[..self.own].iter().for_each(|(_, dof)| coupled[*dof as usize] = true);
        let Self { cloud, constraints, linear, .. } = self;
        let LinearMeanTurn { reference, origin, .. } = linear;
        MeanMotion {
            reference,
            coupled,
            cloud,
            hung: Vec::new(),
            constraints,
            dependents,
            turning,
            origin,
        }
    }
}

/// Names of dofs.
type Names = Vec<(NodeIndex, Dof)>;

/// The dofs of a coupling, and those of them that cannot follow.
#[derive(Clone, Copy)]
struct Columns<'a> {
    of: &'a OpenMean,
    taken: &'a [bool],
}

impl Columns<'_> {
    /// What follows, and what of it follows a dof of its own.
    fn followers(&self, leading: &HashSet<NodeIndex>) -> Option<(Names, Names)> {
        let (own, all) = (self.of.own, &self.of.names);
        let pivots = self.pivots_far(leading)?;
        let whole: HashSet<NodeIndex> =
            pivots.iter().filter(|pivot| **pivot >= own).map(|&pivot| all[pivot].0).collect();
        let follows = |column: &usize| {
            let of_cloud = *column >= own && whole.contains(&all[*column].0);
            pivots.contains(column) || of_cloud && !self.taken[*column]
        };
        let found: Vec<usize> = (0..all.len()).filter(follows).collect();
        let names = |columns: &mut dyn Iterator<Item = &usize>| -> Names {
            columns.map(|&column| all[column]).collect()
        };
        let turning = names(&mut found.iter().filter(|column| !pivots.contains(column)));
        Some((names(&mut found.iter()), turning))
    }

    /// The dofs for which the equations are solved: those of the reference node where all of them are free, else
    /// of nodes that are free in all directions and that nothing else follows, else of such that something
    /// follows; `None`: there are none.
    fn pivots_far(&self, leading: &HashSet<NodeIndex>) -> Option<Vec<usize>> {
        let OpenMean { own, rows, names, pivots, .. } = self.of;
        if !self.taken[..*own].contains(&true) {
            return Some(pivots.clone());
        }
        let columns = || names.iter().zip(self.taken).enumerate();
        let held: HashSet<NodeIndex> =
            columns().filter(|(_, own)| *own.1).map(|(_, own)| own.0.0).collect();
        let of_whole = columns().map(|(place, name)| place < *own || held.contains(&name.0.0));
        let of_whole: Vec<bool> = of_whole.collect();
        let is_leading = names.iter().map(|name| leading.contains(&name.0));
        let of_own = of_whole.iter().zip(is_leading).map(|(held, leads)| *held || leads).collect();
        let tried: [Vec<bool>; 2] = [of_own, of_whole];
        let found = tried.iter().find_map(|taken| solve(rows.clone(), 0, taken));
        found.map(|rows| rows.into_iter().map(|own| own.0).collect())
    }
}
