//! `*TIE`: nodes of the slave surface follow the faces of the master, as means over their own faces or
//! one by one.
//!
//! ```text
//!        s  slave node              u_s = sum N_i(xi) u_i
//!   o----x-------o  master face     at the place x nearest to it
//! ```

mod arms;
mod hanging;
mod master;
mod means;

use std::collections::{HashMap, HashSet, VecDeque};

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::element::solid::smallest_jacobian;
use slideline_mech::pressure::{Face, Nearest};
use slideline_model::{Dialect, Dof, Kinematics, MeanMotion, NodeIndex, NumberedSet};

use super::bodies::Bodies;
use super::equations::add;
use super::faces::{faces, nodes_of_surface};
use super::one_node::is_one;
use super::supports::Supports;
use crate::constraints::Tie;
use crate::draft::Draft;
use crate::rule::Subject;
use crate::surfaces::{Extent, NamedSurface};
use arms::{Arm, Arms, NOTHING, arms, join, judge_arms, open_circles, turns_far};
use hanging::{hanging, turn_far};
use master::{Master, nearest};
use means::{Means, Shares, means, misplaced};

/// Part of a pressure that may reach other nodes than it should unsaid [1]. (choice)
const MISPLACED: f64 = 0.01;

pub(super) fn ties(draft: &mut Draft) {
    let ties = draft.ties.clone(); // requests ask for those of pairs
    if ties.is_empty() {
        return;
    }
    let prescribed = super::steps::prescribed(draft);
    let supports = Supports::new(draft);
    let bodies = Bodies::of(draft);
    let mut done = Done::default();
    let mut left: VecDeque<&Tie> = ties.iter().collect();
    while let Some(tie) = left.pop_front() {
        let (same, others) = left.into_iter().partition(|other| is_one_with(tie, other));
        left = others;
        one((tie, &same), (&prescribed, &supports, &bodies), &mut done, draft);
    }
    let without = open_circles(&done.arms, draft);
    turn_far(std::mem::take(&mut done.hanging), &without, draft);
    moved(&done.tied, draft);
}

/// What the ties so far have done.
#[derive(Default)]
struct Done {
    /// A node that two ties name follows the first; where one moved, the tie that moved it.
    tied: HashMap<NodeIndex, Option<Span>>,
    arms: Vec<Arm>,
    /// Motions of nodes that hang at faces which may turn far.
    hanging: Vec<MeanMotion>,
}

/// Whether faces of one slave surface are tied to two masters in the same way: those that lie upon both
/// take their means over both.
fn is_one_with(tie: &Tie, other: &Tie) -> bool {
    tie.by_faces
        && other.by_faces
        && tie.slave.name == other.slave.name
        && tie.adjust == other.adjust
        && tie.tolerance == other.tolerance
}

/// Complains about elements that the moving of nodes onto their masters has turned inside out.
fn moved(tied: &HashMap<NodeIndex, Option<Span>>, draft: &mut Draft) {
    let mut folded: Vec<(u64, Span)> = Vec::new();
    for block in &draft.model.blocks {
        let Kinematics::Solid { rule, .. } = block.kind.kinematics else { continue };
        for element in &block.elements {
            let moved = |node| tied.get(node).copied().flatten();
            let Some(origin) = element.nodes.iter().find_map(moved) else { continue };
            let at = element.nodes.iter().map(|&node| draft.model.nodes.position(node));
            let at: Vec<[f64; 3]> = at.collect();
            if smallest_jacobian(block.kind.cell, rule, &at) <= 0.0 {
                folded.push((element.label, origin));
            }
        }
    }
    for (label, origin) in folded {
        let message = format!("this tie moves nodes onto its master and folds element {label}");
        let error = Diagnostic::error(Code("SL0346"), message).at(origin);
        let help = "write ADJUST=NO, a smaller POSITION TOLERANCE, or move the nodes in the mesh";
        draft.consequence(Subject::Links, error.help(help));
    }
}

fn masters(tie: &Tie, draft: &mut Draft) -> Vec<Master> {
    let Some(surface) = draft.surface(&tie.master) else { return Vec::new() };
    let dimension = if draft.model.is_in_space() { 3 } else { 2 };
    let found = faces(&surface, tie.master.span, draft);
    let made = found.into_iter().filter_map(|face| {
        let kind = Face::of(dimension, face.nodes.len(), 1.0)?;
        Some(Master::new(kind, face.nodes, draft))
    });
    let masters: Vec<Master> = made.collect();
    if masters.is_empty() {
        let message = format!("the master surface {} has no faces", tie.master.name);
        let error = Diagnostic::error(Code("SL0332"), message).at(tie.master.span);
        draft.consequence(Subject::Elements, error.help("a master is made of element faces"));
    }
    masters
}

/// A tie, with others of the same slave.
fn one(
    (tie, same): (&Tie, &VecDeque<&Tie>),
    (prescribed, supports, bodies): (&NumberedSet<(NodeIndex, Dof)>, &Supports, &Bodies),
    done: &mut Done,
    draft: &mut Draft,
) {
    let all = std::iter::once(tie).chain(same.iter().copied());
    let names: Vec<&str> = all.clone().map(|own| own.master.name.as_str()).collect();
    let masters: Vec<Master> = all.flat_map(|own| masters(own, draft)).collect();
    let Some(slave) = draft.surface(&tie.slave) else { return };
    if masters.is_empty() {
        return;
    }
    let own: HashSet<NodeIndex> = masters.iter().flat_map(|master| master.nodes.clone()).collect();
    let (mut near, mut left) = (Vec::new(), Vec::new());
    for node in nodes_of_surface(&slave, tie.slave.span, draft) {
        if own.contains(&node) || done.tied.contains_key(&node) {
            continue;
        }
        let point = draft.model.nodes.get(node).position;
        let Some((place, found)) = nearest(&masters, point) else { continue };
        match found.distance > masters[place].reach(tie.tolerance) {
            true => left.push(node),
            false => near.push(TiedNode { node, master: place, near: found }),
        }
    }
    let slaves = slave_faces(tie, &slave, draft);
    let means = match tie.by_faces {
        true => of_faces(&slaves, (&masters, tie.tolerance), (&near, prescribed, bodies), draft),
        false => Means::default(),
    };
    if !tie.by_faces && !slaves.is_empty() {
        judge_nodes(tie, &slaves, (&masters, &near), draft);
    }
    if tie.adjust {
        adjust(&near, &means, draft);
    }
    let mut widest = 0.0_f64;
    for own in &near {
        done.tied.insert(own.node, tie.adjust.then_some(tie.origin));
        if !bodies.hold(own.node, &nearest_shares(own, &masters), draft) {
            let sides = (&masters[..], &means);
            let gap = follow(tie, own, sides, (prescribed, supports), done, draft);
            widest = widest.max(gap);
        }
    }
    judge_arms(tie, widest, draft);
    too_far(tie, &left, &names, draft);
}

/// SL0348: nodes that are not tied.
fn too_far(tie: &Tie, left: &[NodeIndex], names: &[&str], draft: &mut Draft) {
    let Some(&first) = left.first() else { return };
    let label = draft.model.nodes.label(first);
    let (slave, master) = (&tie.slave.name, names.join(" and "));
    let message = match left.len() {
        1 => format!("node {label} of {slave} lies too far from {master} and is not tied"),
        count => format!(
            "{count} nodes of {slave}, such as {label}, lie too far from {master} and are not tied"
        ),
    };
    let warning = Diagnostic::warning(Code("SL0348"), message).at(tie.origin);
    let help = "POSITION TOLERANCE= of *TIE, ADJUST= of *CONTACT PAIR, ties from further away";
    draft.consequence(Subject::Links, warning.help(help));
}

/// A slave node that is tied, with the place of the master that is nearest to it.
struct TiedNode {
    node: NodeIndex,
    master: usize,
    near: Nearest,
}

/// The faces of solids that a slave surface is made of, by their nodes; none of other surfaces.
fn slave_faces(tie: &Tie, slave: &NamedSurface, draft: &mut Draft) -> Vec<Vec<NodeIndex>> {
    if !matches!(slave.extent, Extent::Elements(_)) {
        return Vec::new();
    }
    let found = faces(slave, tie.slave.span, draft);
    match found.iter().any(|face| face.face.is_none()) {
        true => Vec::new(), // beams
        false => found.into_iter().map(|face| face.nodes).collect(),
    }
}

/// The rows of nodes that follow means, where faces are tied to faces. What has a support, or its own
/// axes and a support, follows the nearest place, and so does what others of the faces follow already.
fn of_faces(
    slaves: &[Vec<NodeIndex>],
    masters: (&[Master], Option<f64>),
    (near, prescribed, bodies): (&[TiedNode], &NumberedSet<(NodeIndex, Dof)>, &Bodies),
    draft: &Draft,
) -> Means {
    let held: HashSet<NodeIndex> = prescribed.iter().map(|(node, _)| *node).collect();
    let mut tied: HashSet<NodeIndex> = near.iter().map(|own| own.node).collect();
    tied.retain(|&node| !bodies.have(node));
    followed_within(slaves, draft).iter().for_each(|node| _ = tied.remove(node));
    let follows = |node: NodeIndex, axis: usize| {
        let dof = draft.model.directions().get(axis);
        let held_here = match draft.axes_of(node) {
            Some(_) => held.contains(&node),
            None => dof.is_some_and(|&dof| prescribed.contains(&(node, dof))),
        };
        tied.contains(&node) && !held_here
    };
    means(slaves, masters, follows, draft)
}

/// Nodes of slave faces that others of the same faces follow, where an earlier tie ends within a face: means
/// have parts of those, and would follow themselves.
fn followed_within(slaves: &[Vec<NodeIndex>], draft: &Draft) -> HashSet<NodeIndex> {
    let own: HashSet<NodeIndex> = slaves.iter().flatten().copied().collect();
    let constraints = draft.model.linear_constraints.iter();
    let within = constraints.filter(|constraint| own.contains(&constraint.dependent.0));
    let terms = within.flat_map(|constraint| &constraint.terms).map(|&(node, ..)| node);
    terms.filter(|node| own.contains(node)).collect()
}

/// Advises where nodes that are tied one by one hand a pressure on to the wrong nodes.
fn judge_nodes(
    tie: &Tie,
    slaves: &[Vec<NodeIndex>],
    (masters, near): (&[Master], &[TiedNode]),
    draft: &mut Draft,
) {
    let shares = near.iter().map(|own| (own.node, nearest_shares(own, masters)));
    let off = misplaced(slaves, (masters, tie.tolerance), &shares.collect(), draft);
    if off <= MISPLACED {
        return;
    }
    let (slave, master) = (&tie.slave.name, &tie.master.name);
    let message = format!(
        "the nodes of {slave} are tied one by one to the places of {master} nearest to them: of an \
         even pressure {:.0} % reaches other nodes of {master} than it should, and stresses at the \
         tie are off",
        100.0 * off
    );
    let help = match draft.dialect {
        Dialect::Calculix => {
            "TYPE=SURFACE TO SURFACE of *TIE ties faces, which does not mind; CalculiX, whose results \
             these are, does not know it. Or let the meshes match there"
        }
        Dialect::Abaqus => "leave out TYPE=NODE TO SURFACE, or let the meshes match there",
    };
    draft.log.push(Diagnostic::advice(Code("SL0429"), message).at(tie.origin).help(help));
}

/// Shares of the master's nodes in the place nearest to a slave node.
fn nearest_shares(own: &TiedNode, masters: &[Master]) -> Shares {
    masters[own.master].nodes.iter().copied().zip(own.near.shapes).collect()
}

/// Moves slave nodes onto the master: to where what they follow is. Means have parts of nodes that
/// follow the nearest place, which move first.
fn adjust(near: &[TiedNode], means: &Means, draft: &mut Draft) {
    for own in near {
        let at = draft.model.nodes.position(own.node);
        let nearest = |axis: usize| match means[axis].contains_key(&own.node) {
            true => at[axis],
            false => own.near.place[axis],
        };
        draft.model.nodes.place(own.node, std::array::from_fn(nearest));
    }
    let place = |own: &TiedNode, axis: usize| match means[axis].get(&own.node) {
        Some(row) => row
            .iter()
            .map(|&(node, share)| share * draft.model.nodes.position(node)[axis])
            .sum::<f64>(),
        None => own.near.place[axis],
    };
    let places = near.iter().map(|own| (own.node, std::array::from_fn(|axis| place(own, axis))));
    let places: Vec<(NodeIndex, [f64; 3])> = places.collect();
    places.into_iter().for_each(|(node, place)| draft.model.nodes.place(node, place));
}

/// What a dof of a slave node follows.
struct Row {
    dof: Dof,
    terms: Vec<(NodeIndex, Dof, f64)>,
    /// The same without its arm, where it has one.
    without: Option<Vec<(NodeIndex, Dof, f64)>>,
    /// Whether it has one in large motion, be it of no effect in small turns.
    hangs: bool,
}

/// Makes the displacements of a node follow a mean or the nearest face. How long its arm is in sizes of the
/// face [1].
fn follow(
    tie: &Tie,
    own: &TiedNode,
    (masters, means): (&[Master], &Means),
    (prescribed, supports): (&NumberedSet<(NodeIndex, Dof)>, &Supports),
    done: &mut Done,
    draft: &mut Draft,
) -> f64 {
    let node = own.node;
    let nearest = nearest_shares(own, masters);
    let shares = means.each_ref().map(|means| means.get(&node).unwrap_or(&nearest));
    let arms = arms((node, own.near.distance), shares, (masters, own.master), draft);
    let is_far = !arms.are_none() && turns_far(draft);
    let mut rows = rows((node, shares), (&arms, is_far), (prescribed, supports), draft);
    if is_far {
        // one after the other
        rows.sort_by_key(|row| row.hangs);
    }
    let mut hung: Vec<Dof> = Vec::new();
    for Row { dof, terms, without, hangs } in rows {
        if hangs {
            hung.push(dof);
        }
        if let Some(without) = without {
            let constraint = draft.model.linear_constraints.len();
            done.arms.push(Arm { constraint, dependent: (node, dof), without });
        }
        add(draft, (node, dof), terms, tie.origin);
    }
    let part = if hung.is_empty() { 0.0 } else { arms.part };
    if is_far && !hung.is_empty() {
        done.hanging.push(hanging((node, &hung), shares, arms, (tie.origin, draft)));
    }
    part
}

/// What the displacements of a node follow. A dof that is prescribed on both sides of the tie is left to its
/// support; but where both sides are held alike in some of the steps only, it follows in all of them. `is_far`:
/// all that is not held has an arm, be it of no effect in small turns.
fn rows(
    (node, shares): (NodeIndex, [&Shares; 3]),
    (arms, is_far): (&Arms, bool),
    (prescribed, supports): (&NumberedSet<(NodeIndex, Dof)>, &Supports),
    draft: &mut Draft,
) -> Vec<Row> {
    let directions = draft.model.directions();
    let axis = |dof: Dof| directions.iter().position(|own| *own == dof).unwrap_or_default();
    let terms = |dof: Dof| -> Vec<_> {
        let shares = shares[axis(dof)].iter().filter(|(_, share)| share.abs() > NOTHING);
        shares.map(|&(own, share)| (own, dof, share)).collect()
    };
    let mut rows = Vec::new();
    for &dof in directions.iter().filter(|dof| !dof.is_rotation()) {
        let mut terms = draft.followed((node, dof), terms);
        let (mut without, mut hangs) = (None, false);
        let held = |&(own, dof, _): &(NodeIndex, Dof, f64)| prescribed.contains(&(own, dof));
        if prescribed.contains(&(node, dof)) && terms.iter().all(held) {
            let is_implied = supports.is_implied((node, dof), &terms);
            if !is_implied || supports.is_always((node, dof)) {
                if let [(one, own, factor)] = terms[..]
                    && is_implied
                    && own == dof
                    && is_one(factor)
                {
                    draft.held_alike.insert((node, dof), one);
                }
                continue;
            }
            draft.implied.insert((node, dof));
        } else {
            let arm = draft.followed((node, dof), |dof| arms.terms[axis(dof)].clone());
            hangs = is_far || !arm.is_empty();
            if !arm.is_empty() {
                without = Some(terms.clone());
                join(&mut terms, arm);
            }
        }
        rows.push(Row { dof, terms, without, hangs });
    }
    rows
}
