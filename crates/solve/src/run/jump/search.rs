//! Where an increment jumps: its parts halved until what is left over stays, or fades.

use super::part::{FALLS, Part, Rest};
use crate::constraints::Role;
use crate::newton::Scratch;
use crate::problem::Problem;
use crate::state::State;
use crate::target::Target;
use slideline_diag::{Code, Diagnostic};
use slideline_model::NodeIndex;

/// Part of the energy turned over from which on a jump is looked for.
pub(super) const NOTABLE: f64 = 0.01;
/// How often an increment is halved: nothing but a jump keeps more than
/// 2^-8 of what it left over.
const HALVINGS: usize = 8;
/// Halvings that are made at least: by then the rest of a smooth path has
/// fallen to a 32nd.
const FEWEST: usize = 5;

/// Looks for a jump between two states that an increment joins.
pub(super) fn find(
    plan: &Problem<'_>,
    (from, to): (&State, &State),
    target: &Target,
    work: &mut Scratch,
) -> Option<Jump> {
    let (end, dt) = (target.step_time, target.dt);
    let (from, to) = (work.copy(from), work.copy(to));
    let whole = Part { from, to, end, dt, rest: Rest::default() };
    let mut part = None;
    let found = narrow(plan, (&whole, &mut part), target, work);
    part.into_iter().chain([whole]).for_each(|part| part.spare(work));
    found
}

/// Halves the whole, and of its halves the one that leaves more over, again and again: `part` is
/// the last of them. The jump, where what is left over stays.
fn narrow(
    plan: &Problem<'_>,
    (whole, part): (&Part, &mut Option<Part>),
    target: &Target,
    work: &mut Scratch,
) -> Option<Jump> {
    let enough = NOTABLE * whole.to.books.turned_over;
    let mut left = [whole.left(); HALVINGS + 1];
    let (mut count, mut steady) = (1, 0);
    while count <= HALVINGS && (steady < 2 || count <= FEWEST) {
        let longer = part.as_ref().unwrap_or(whole);
        let before = longer.left();
        let Some((half, both)) = longer.sharper_half(plan, target, work) else {
            // Where not even halves are found the structure itself must say
            // that it gave way.
            if work.negative_pivots == 0 {
                return None;
            }
            if let Some(over) = longer.over_the_limit(plan, target, work, enough) {
                return (over.left() > enough).then(|| Jump::of(plan, &over));
            }
            break;
        };
        let now = half.left();
        let last = part.replace(half);
        last.into_iter().for_each(|part| part.spare(work));
        // what the rule misses falls by four with every halving
        if now.abs() <= enough || both.abs() <= FALLS * before.abs() {
            return None;
        }
        steady = if (now - before).abs() <= 0.1 * before.abs() { steady + 1 } else { 0 };
        left[count] = now;
        count += 1;
    }
    // What is no jump falls by half at least with every halving.
    let fades = match left[..count] {
        [.., two_before, _, last] => last <= 0.5 * two_before,
        [.., before, last] => last <= 0.75 * before,
        _ => false,
    };
    let driven = part.as_ref().is_some_and(|part| part.is_driven(plan, whole));
    let part = part.as_ref().unwrap_or(whole);
    // A jump releases energy; what gains some is none.
    (!fades && !driven && part.left() > enough).then(|| Jump::of(plan, part))
}

/// A jump from one equilibrium to another.
pub(super) struct Jump {
    /// Energy that it released [F L].
    released: f64,
    /// Work of supports and loads in the increment, and what friction
    /// dissipated, from the parts in which it was walked [F L].
    work: f64,
    dissipation: f64,
    /// What the parts without the jump left over [F L].
    left: f64,
    /// Total time before it [T].
    time: f64,
    /// The node that it moved most, and how far [L].
    node: Option<(NodeIndex, f64)>,
    /// Places of the pairs that carried pressure before it and none after.
    lost: Vec<usize>,
}

impl Jump {
    fn of(plan: &Problem<'_>, part: &Part) -> Self {
        let (from, to) = (&part.from, &part.to);
        // What is driven does not spring.
        let moved = |node: usize| {
            let own = plan.dofs.named_of_node(node).filter(|&dof| !plan.dofs.is_rotation(dof));
            let way = own.map(|dof| match plan.constraints.roles[dof] {
                Role::Prescribed(_) => 0.0,
                _ => to.displacement[dof] - from.displacement[dof],
            });
            way.fold(0.0, f64::hypot)
        };
        let nodes = (0..plan.model.nodes.len()).map(|node| (node, moved(node)));
        let closed = |state: &State, pair: usize| {
            let mut points = plan.contact.points.iter().zip(&state.points);
            points.any(|(point, now)| plan.contact.parent(point.pair) == pair && now.closed)
        };
        let pairs = 0..plan.contact.own_pairs();
        let whole = part.rest.with(part);
        Self {
            released: part.left(),
            work: whole.work,
            dissipation: whole.dissipation - to.books.opening_dissipation,
            left: part.rest.left,
            time: from.total_time,
            node: nodes.max_by(|a, b| a.1.total_cmp(&b.1)),
            lost: pairs.filter(|&pair| closed(from, pair) && !closed(to, pair)).collect(),
        }
    }

    /// Counts it in the energies of the state that it led to: the work of its
    /// increment is that of the parts, which enclose the jump.
    pub fn enter(&self, before: &State, state: &mut State) {
        let energy = &mut state.energy;
        energy.released_energy += self.released;
        energy.external_work = before.energy.external_work + self.work;
        energy.friction_dissipation = before.energy.friction_dissipation + self.dissipation;
        let unbalanced = energy.supplied() - energy.taken();
        let origin = *state.balance_origin.insert(before.balance_origin.unwrap_or(unbalanced));
        energy.balance = unbalanced - origin;
        state.books.left = self.left;
    }

    pub fn told(&self, plan: &Problem<'_>, target: &Target, state: &State) -> Diagnostic {
        let mut message = format!(
            "the structure jumps to another equilibrium in increment {} of step {}, at total time \
             {:.6}",
            target.increment, target.step, self.time
        );
        if let Some((node, moved)) = self.node {
            let label = plan.model.nodes.name(node);
            message.push_str(&format!(": node {label} springs by {moved:.4e}"));
        }
        for &pair in &self.lost {
            let name = &plan.model.contact_pairs[pair].name;
            message.push_str(&format!(", the contact of {name} opens"));
        }
        message.push_str(&format!(
            ", and {:.4e} of energy is released, {:.1} % of the energy converted",
            self.released,
            100.0 * self.released / state.books.turned_over
        ));
        let node = self.node.map(|(node, _)| plan.model.nodes.get(node).origin);
        Diagnostic::note(Code("SL0603"), message).at(node).help(
            "is a jump meant here, as of a hook that springs off an edge? Then nothing needs to be \
             changed: released_energy in JOB.energy.csv has this energy. Else a node hung on a corner \
             of its master until it tore off: round the corner (FILLET RADIUS, SMOOTH), or refine \
             the slave",
        )
    }
}
