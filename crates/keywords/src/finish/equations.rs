//! Linear constraints: equations, ties of nodes, and groups of them solved for chosen dofs.
//!
//! ```text
//!   a1 u1 + a2 u2 + ... = 0   ->   u1 = -(a2 u2 + ...)/a1
//! ```

use std::collections::{HashMap, HashSet};

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{Dof, LinearConstraint, NodeIndex};

use crate::constraints::{Equation, Term};
use crate::draft::Draft;
use crate::rule::Subject;

/// All equations of the deck.
pub(super) fn equations(draft: &mut Draft) {
    for equation in std::mem::take(&mut draft.equations) {
        let nodes: Vec<Vec<NodeIndex>> =
            equation.terms.iter().map(|term| draft.nodes_of(&term.node, term.span)).collect();
        if nodes.iter().any(Vec::is_empty) {
            continue; // which has been said
        }
        let count = nodes.iter().map(Vec::len).max().unwrap_or(1);
        if let Some(place) = nodes.iter().position(|own| own.len() != 1 && own.len() != count) {
            unequal(&equation.terms[place], nodes[place].len(), count, draft);
            continue;
        }
        for k in 0..count {
            let at = |own: &Vec<NodeIndex>| if own.len() == 1 { own[0] } else { own[k] };
            one(&equation, &nodes.iter().map(at).collect::<Vec<_>>(), draft);
        }
    }
}

fn unequal(term: &Term, own: usize, count: usize, draft: &mut Draft) {
    let message = format!("this set has {own} nodes, another one of the equation {count}");
    let error = Diagnostic::error(Code("SL0347"), message).at(term.span);
    let help = "sets of an equation have the same number of nodes, or one node";
    draft.consequence(Subject::Links, error.help(help));
}

fn one(equation: &Equation, nodes: &[NodeIndex], draft: &mut Draft) {
    let directions = draft.model.directions();
    let mut terms: Vec<(NodeIndex, Dof, f64)> = Vec::new();
    for (term, &node) in equation.terms.iter().zip(nodes) {
        if !directions.contains(&term.dof) || term.factor == 0.0 {
            continue; // a dof that stays zero
        }
        match terms.iter_mut().find(|(own, dof, _)| (*own, *dof) == (node, term.dof)) {
            Some((_, _, factor)) => *factor += term.factor,
            None => terms.push((node, term.dof, term.factor)),
        }
    }
    let Some(first) = equation.terms.first() else { return };
    if !directions.contains(&first.dof) && terms.is_empty() {
        return;
    }
    let eliminated = terms.first().filter(|own| (own.0, own.1) == (nodes[0], first.dof));
    let Some(&(node, dof, factor)) = eliminated.filter(|(.., factor)| *factor != 0.0) else {
        let message = "the first term of an equation must not vanish: its dof is eliminated";
        let error = Diagnostic::error(Code("SL0347"), message).at(first.span);
        draft.consequence(Subject::Links, error.help("begin with another term"));
        return;
    };
    let rest = terms[1..].iter().map(|&(node, dof, a)| (node, dof, -a / factor)).collect();
    add(draft, (node, dof), rest, equation.origin);
}

/// Makes a dof follow others, unless it follows already.
pub(super) fn add(
    draft: &mut Draft,
    dependent: (NodeIndex, Dof),
    terms: Vec<(NodeIndex, Dof, f64)>,
    origin: Span,
) {
    if let Some(&first) = draft.dependents.get(&dependent) {
        twice(draft, dependent, first, origin);
        return;
    }
    draft.dependents.insert(dependent, origin);
    let constraint = LinearConstraint { dependent, terms, constant: 0.0, origin };
    draft.model.linear_constraints.push(constraint);
}

pub(super) fn twice(draft: &mut Draft, (node, dof): (NodeIndex, Dof), first: Span, origin: Span) {
    let name = draft.model.nodes.name(node);
    let message = format!("dof {} of node {name} is dependent twice", dof.number());
    let error = Diagnostic::error(Code("SL0316"), message).at(origin);
    let error = beside_cut(error.label(first, "dependent here first"), node, draft);
    draft.consequence(Subject::Links, error);
}

/// Says of which node of the deck that one is which a pre-tension section has added.
pub(super) fn beside_cut(error: Diagnostic, node: NodeIndex, draft: &Draft) -> Diagnostic {
    let label = draft.model.nodes.label(node);
    let original = draft.uncut(label);
    if !draft.behind_cuts.get(&original).is_some_and(|own| own.contains(&label)) {
        return error;
    }
    error.help(format!(
        "node {label} is the other side of node {original}, which lies on a cut by a pre-tension section and follows \
         its reference node there: leave the nodes of the cut out of couplings, ties and equations"
    ))
}

/// Complains about dofs that follow themselves by way of others, and about rigid bodies whose own
/// dofs follow others linearly.
pub(super) fn circles(draft: &mut Draft) {
    let open = places(&draft.model.linear_constraints);
    let left = unordered(&draft.model.linear_constraints, &open);
    if let Some(&place) = left.first() {
        let LinearConstraint { dependent: (node, dof), origin, .. } =
            draft.model.linear_constraints[place];
        let name = draft.model.nodes.name(node);
        let message =
            format!("dof {} of node {name} follows itself by way of others", dof.number());
        let error = Diagnostic::error(Code("SL0347"), message).at(origin);
        let help = "begin the equation with a dof that no other equation needs";
        draft.consequence(Subject::Links, error.help(help));
    }
    for link in draft.model.rigid_links.clone() {
        let follows = |dof: &&Dof| open.contains_key(&(link.master, **dof));
        let Some(&dof) = Dof::ALL.iter().find(follows) else { continue };
        let origin = draft.dependents.get(&(link.master, dof)).copied().unwrap_or(link.origin);
        let name = draft.model.nodes.name(link.master);
        let message = format!("node {name} carries a rigid body and cannot follow other dofs");
        let error = Diagnostic::error(Code("SL0317"), message).at(origin);
        let error = error.label(link.origin, "it carries a body here");
        let help = "begin the equation with another dof: the first one is eliminated";
        draft.consequence(Subject::Links, error.help(help));
    }
}

/// Whether dofs follow themselves by way of others.
pub(super) fn has_circle(constraints: &[LinearConstraint]) -> bool {
    !unordered(constraints, &places(constraints)).is_empty()
}

/// Where the constraint of each dof stands.
fn places(constraints: &[LinearConstraint]) -> HashMap<(NodeIndex, Dof), usize> {
    constraints.iter().enumerate().map(|(place, own)| (own.dependent, place)).collect()
}

/// The constraints whose dofs follow themselves by way of others.
pub(super) fn in_circles(constraints: &[LinearConstraint]) -> HashSet<usize> {
    let of_dof = places(constraints);
    let left: HashSet<usize> = unordered(constraints, &of_dof).into_iter().collect();
    // what follows a circle has no order either, and is in none
    let follows_itself = |own: &usize| {
        let (mut seen, mut open) = (HashSet::new(), vec![*own]);
        while let Some(place) = open.pop() {
            let terms = constraints[place].terms.iter().map(|&(node, dof, _)| (node, dof));
            let leaders = terms.filter_map(|term| of_dof.get(&term).copied());
            open.extend(leaders.filter(|leader| left.contains(leader) && seen.insert(*leader)));
        }
        seen.contains(own)
    };
    left.iter().copied().filter(follows_itself).collect()
}

/// The constraints that cannot be put behind all those that their terms follow: in the order of their
/// dependence each is taken once.
fn unordered(
    constraints: &[LinearConstraint],
    of_dof: &HashMap<(NodeIndex, Dof), usize>,
) -> Vec<usize> {
    let mut followers: Vec<Vec<usize>> = vec![Vec::new(); constraints.len()];
    let mut waits_for = vec![0_usize; constraints.len()];
    for (place, constraint) in constraints.iter().enumerate() {
        let terms = constraint.terms.iter().map(|&(node, dof, _)| (node, dof));
        for leader in terms.filter_map(|term| of_dof.get(&term).copied()) {
            followers[leader].push(place);
            waits_for[place] += 1;
        }
    }
    let mut ready: Vec<usize> = (0..constraints.len()).filter(|&k| waits_for[k] == 0).collect();
    while let Some(taken) = ready.pop() {
        for &follower in &followers[taken] {
            waits_for[follower] -= 1;
            if waits_for[follower] == 0 {
                ready.push(follower);
            }
        }
    }
    (0..waits_for.len()).filter(|&place| waits_for[place] > 0).collect()
}

/// Solves equations `sum a u = 0` together for as many dofs as there are equations: first for
/// those that are preferred, never for one that is taken. `None` where they are too few.
pub(super) fn solve(
    mut rows: Vec<Vec<f64>>,
    preferred: usize,
    taken: &[bool],
) -> Option<Vec<(usize, Vec<f64>)>> {
    let mut pivots: Vec<usize> = Vec::new();
    for k in 0..rows.len() {
        let scale = rows[k].iter().fold(0.0_f64, |most, a| most.max(a.abs()));
        let largest = |range: std::ops::Range<usize>| {
            let free = range.filter(|&c| !taken[c] && !pivots.contains(&c));
            free.max_by(|&a, &b| rows[k][a].abs().total_cmp(&rows[k][b].abs()))
        };
        let sound = |&column: &usize| rows[k][column].abs() > 1e-9 * scale;
        let first = largest(0..preferred).filter(sound);
        let column = first.or_else(|| largest(preferred..taken.len()).filter(sound))?;
        pivots.push(column);
        let pivot = rows[k].clone();
        for (other, row) in rows.iter_mut().enumerate() {
            let factor =
                if other == k { 1.0 - 1.0 / pivot[column] } else { row[column] / pivot[column] };
            row.iter_mut().zip(&pivot).for_each(|(a, b)| *a -= factor * b);
            row[column] = if other == k { 1.0 } else { 0.0 };
        }
    }
    Some(pivots.into_iter().zip(rows).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: solutions fulfil the equations, whichever dofs are taken.
    #[test]
    fn solved_equations_are_fulfilled() {
        let rows = vec![vec![-1.0, 0.0, 0.5, 0.5, 0.2], vec![0.0, -1.0, 0.1, -0.3, 0.7]];
        for taken in
            [[false; 5], [true, true, false, false, false], [true, false, true, false, false]]
        {
            let solved = solve(rows.clone(), 2, &taken).expect("a solution");
            let mut u = [0.3, -0.2, 0.9, 0.4, -0.6];
            for (pivot, row) in &solved {
                assert!(!taken[*pivot]);
                u[*pivot] = 0.0;
                let _ = row;
            }
            for (pivot, row) in &solved {
                let sum: f64 = row
                    .iter()
                    .zip(u)
                    .enumerate()
                    .map(
                        |(c, (a, u))| {
                            if solved.iter().any(|(other, _)| *other == c) { 0.0 } else { a * u }
                        },
                    )
                    .sum();
                u[*pivot] = -sum;
            }
            for row in &rows {
                let left: f64 = row.iter().zip(u).map(|(a, u)| a * u).sum();
                assert!(left.abs() < 1e-14, "{taken:?}");
            }
        }
        assert!(solve(rows, 2, &[true; 5]).is_none());
    }
}
