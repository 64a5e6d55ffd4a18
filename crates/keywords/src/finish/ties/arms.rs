//! Arms of tied nodes that stay away from what they follow.
//!
//! ```text
//!        s  slave node, not moved onto the master     u_s = sum N_i u_i + w x d
//!      d |
//!   o----x-------o  master face, turned by w
//! ```
//!
//! docs/theory.md section 4.11

use std::collections::{BTreeSet, HashSet};

use slideline_diag::{Code, Diagnostic};
use slideline_mech::face_turn::{swing, turn};
use slideline_model::{Dof, NodeIndex};

use super::super::equations::in_circles;
use super::master::{Master, TOLERANCE, TOUCHING, nearest};
use super::means::Shares;
use crate::constraints::Tie;
use crate::draft::Draft;

/// Part of an arm below which a factor is rounding [1].
pub(super) const NOTHING: f64 = 1e-12;

/// A term of a row: a dof that is followed, and how much.
type Term = (NodeIndex, Dof, f64);

/// What the displacements of a node make of a turn: a matrix [1/L].
pub(super) type NodeTurn = (NodeIndex, [[f64; 3]; 3]);

/// What arms add to what the displacements of a slave node follow.
#[derive(Default)]
pub(super) struct Arms {
    /// Along the axes of the model, for small turns.
    pub terms: [Vec<Term>; 3],
    /// The turn that they follow, by nodes of the faces.
    pub turns: Vec<NodeTurn>,
    /// Distance from the face in sizes of it [1].
    pub part: f64,
}

/// A row that has an arm.
pub(super) struct Arm {
    /// Its place among the linear constraints.
    pub constraint: usize,
    pub dependent: (NodeIndex, Dof),
    /// Its terms without the arm.
    pub without: Vec<Term>,
}

/// The arms of a node that follows a row along each axis, `distance` away from the face `nearest`; nothing
/// where the node is at the place itself.
pub(super) fn arms(
    (node, distance): (NodeIndex, f64),
    rows: [&Shares; 3],
    (masters, nearest): (&[Master], usize),
    draft: &Draft,
) -> Arms {
    let nodes = &draft.model.nodes;
    let at = nodes.position(node);
    let way = |row: &Shares| -> [f64; 3] {
        let place = |k: usize| row.iter().map(|(own, w)| w * nodes.position(*own)[k]).sum::<f64>();
        std::array::from_fn(|k| at[k] - place(k))
    };
    let ways = rows.map(way);
    let long = ways.map(|way| way.iter().map(|d| d * d).sum::<f64>().sqrt());
    if long.iter().all(|long| *long <= TOUCHING * masters[nearest].size) {
        return Arms::default();
    }
    let (turns, size) = turns(masters, at);
    let directions = draft.model.directions();
    let terms = |axis: usize| -> Vec<Term> {
        if long[axis] <= TOUCHING * size {
            return Vec::new();
        }
        let all = turns.iter().flat_map(|(node, turn)| {
            let row = swing(turn, ways[axis])[axis];
            let along = directions.iter().filter(|dof| !dof.is_rotation());
            along.map(move |&dof| (*node, dof, row[dof as usize]))
        });
        all.filter(|(.., factor)| factor.abs() > NOTHING * long[axis] / size).collect()
    };
    let part = if size > 0.0 { distance / size } else { 0.0 };
    Arms { terms: std::array::from_fn(terms), turns, part }
}

impl Arms {
    /// Whether there are none.
    pub fn are_none(&self) -> bool {
        self.terms.iter().all(Vec::is_empty)
    }
}

/// What the nodes of the faces nearest to a point make of the turn there, and the size of the largest of these
/// faces [L]. Above an edge or a corner several are equally near: the turn is the mean of theirs, whichever
/// comes first.
fn turns(masters: &[Master], point: [f64; 3]) -> (Vec<NodeTurn>, f64) {
    let Some((_, near)) = nearest(masters, point) else { return (Vec::new(), 0.0) };
    let is_near = |own: &&Master| {
        let reach = near.distance + TOUCHING * own.size;
        own.at_least(point) <= reach + own.bulge()
            && own.face.nearest(&own.x, point).distance <= reach
    };
    let near = masters.iter().filter(is_near);
    let turned = near.filter_map(|own| Some((own, turn(&own.face, &own.x, point)?)));
    let turned: Vec<_> = turned.collect();
    let mut mean: Vec<NodeTurn> = Vec::new();
    for (master, turn) in &turned {
        for (&node, turn) in master.nodes.iter().zip(turn) {
            let part = turn.map(|row| row.map(|own| own / turned.len() as f64));
            match mean.iter_mut().find(|(own, _)| *own == node) {
                Some((_, sum)) => {
                    let all = sum.as_flattened_mut().iter_mut().zip(part.as_flattened());
                    all.for_each(|(sum, part)| *sum += part);
                }
                None => mean.push((node, part)),
            }
        }
    }
    (mean, turned.iter().map(|(own, _)| own.size).fold(0.0, f64::max))
}

/// Leaves out the arms of nodes that follow themselves by way of them: each of a circle, whichever tie comes
/// first. These nodes.
pub(super) fn open_circles(arms: &[Arm], draft: &mut Draft) -> BTreeSet<NodeIndex> {
    let constraints = &mut draft.model.linear_constraints;
    let is_there = |own: &&Arm| {
        constraints.get(own.constraint).is_some_and(|row| row.dependent == own.dependent)
    };
    let arms: Vec<&Arm> = arms.iter().filter(is_there).collect();
    let circular = if arms.is_empty() { HashSet::new() } else { in_circles(constraints) };
    let closing = arms.iter().filter(|own| circular.contains(&own.constraint));
    let nodes: BTreeSet<NodeIndex> = closing.map(|own| own.dependent.0).collect();
    let Some(&first) = nodes.first() else { return nodes };
    let mut origin = None;
    for own in arms.into_iter().filter(|own| nodes.contains(&own.dependent.0)) {
        let row = &mut constraints[own.constraint];
        row.terms.clone_from(&own.without);
        origin = origin.or(Some(row.origin));
    }
    let name = draft.model.nodes.name(first);
    let message = format!(
        "the faces that {} tied nodes hang at, such as node {name}, follow these nodes: they are tied without \
         arms, and the moments of the gap are left out",
        nodes.len()
    );
    let said = Diagnostic::advice(Code("SL0430"), message).at(origin);
    let help = "make one side the slave of the other in all ties, or leave out ADJUST=NO";
    draft.log.push(said.help(help));
    nodes
}

/// Adds terms to others of the same dofs.
pub(super) fn join(terms: &mut Vec<Term>, more: Vec<Term>) {
    for (node, dof, factor) in more {
        match terms.iter_mut().find(|own| (own.0, own.1) == (node, dof)) {
            Some((.., sum)) => *sum += factor,
            None => terms.push((node, dof, factor)),
        }
    }
}

/// Whether all steps have large motion: one of small motion beside wants arms that are linear.
pub(super) fn turns_far(draft: &Draft) -> bool {
    !draft.steps.is_empty() && draft.steps.iter().all(|step| step.nlgeom)
}

/// Advises where nodes hang at faces by long arms in steps of both kinds: arms follow small turns then. `widest`
/// is the longest arm in sizes of its face [1].
pub(super) fn judge_arms(tie: &Tie, widest: f64, draft: &mut Draft) {
    let has_large = draft.steps.iter().any(|step| step.nlgeom);
    if tie.adjust || !has_large || turns_far(draft) || widest <= TOLERANCE {
        return;
    }
    let (slave, master) = (&tie.slave.name, &tie.master.name);
    let message = format!(
        "{slave} is tied to {master} across a gap of up to {:.0} % of a face: some steps have NLGEOM and \
         others not, so that what bridges it follows small turns only",
        100.0 * widest
    );
    let help = "give all steps NLGEOM, or leave out ADJUST=NO, so that the nodes are moved onto the master; with \
                turns of less than some degrees the answer holds";
    draft.log.push(Diagnostic::advice(Code("SL0430"), message).at(tie.origin).help(help));
}
