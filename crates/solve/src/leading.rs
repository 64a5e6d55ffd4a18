//! Dofs of the nodes that others follow as parts of rigid bodies.
//!
//! ```text
//!   master  o===o  u1 alone follows: u1 = U1 + (phi x arm)1, with U1, phi2 and phi3;
//!               |  nothing gives U2, U3 and phi1 a stiffness
//! ```
//!
//! What nothing follows does not move by itself. One that is loaded stays an unknown, which nothing holds. Where no
//! step has large motion this depends on arms, so that the outline of a model has it.

use slideline_model::{Dof, Model, NodeIndex, RigidLink};
use std::collections::{HashMap, HashSet};

/// Whether some link leaves dofs of its node alone: then arms and loads decide which dofs masters have.
pub fn is_partial(model: &Model) -> bool {
    model.rigid_links.iter().any(|link| link.follows != RigidLink::WELDED)
}

/// The masters of a model, ascending, and which of their six dofs something follows or loads.
pub fn masters(model: &Model) -> Vec<(NodeIndex, [bool; 6])> {
    let next: HashMap<NodeIndex, NodeIndex> =
        model.rigid_links.iter().map(|link| (link.dependent, link.master)).collect();
    let turned: HashSet<NodeIndex> =
        model.transforms.iter().flat_map(|own| own.nodes.iter().copied()).collect();
    let loads = model.steps.iter().flat_map(|step| &step.loads);
    let loaded: HashSet<(NodeIndex, Dof)> = loads.map(|load| (load.node, load.dof)).collect();
    let small = model.steps.iter().all(|step| !step.nlgeom);
    let mut used: HashMap<NodeIndex, [bool; 6]> = HashMap::new();
    for link in &model.rigid_links {
        let master = last(link.master, &next);
        let levers = match small && !turned.contains(&link.dependent) {
            true => levers(model, master, link.dependent),
            false => [true; 3],
        };
        let is_turned = turned.contains(&link.dependent);
        let own = used.entry(master).or_default();
        followed((model.is_in_space(), is_turned), link, levers, own);
        for dof in Dof::ALL {
            own[dof as usize] |= loaded.contains(&name(link.turn, (master, dof)));
        }
        if master != link.master {
            used.entry(link.master).or_insert([true; 6]);
        }
    }
    let mut all: Vec<_> = used.into_iter().collect();
    all.sort_unstable_by_key(|own| own.0);
    all
}

/// A dof of a master, and whether something follows or loads it.
pub type Leading = ((NodeIndex, Dof), bool);

/// The dofs of all masters of a model, and whether something follows or loads them.
pub fn leading_dofs(model: &Model) -> Vec<Leading> {
    let turns: HashMap<NodeIndex, NodeIndex> =
        model.rigid_links.iter().filter_map(|link| Some((link.master, link.turn?))).collect();
    let of_master = |(master, used): (NodeIndex, [bool; 6])| {
        let turn = turns.get(&master).copied();
        let dofs = model.directions().iter();
        dofs.map(move |&dof| (name(turn, (master, dof)), used[dof as usize]))
    };
    masters(model).into_iter().flat_map(of_master).collect()
}

/// The dof that is one of a master: a rotation may be a displacement of its rotation node.
fn name(turn: Option<NodeIndex>, (master, dof): (NodeIndex, Dof)) -> (NodeIndex, Dof) {
    match turn.filter(|_| dof.is_rotation()) {
        Some(node) => (node, Dof::ALL[dof as usize - 3]),
        None => (master, dof),
    }
}

/// The node at the end of a chain of links.
fn last(mut node: NodeIndex, next: &HashMap<NodeIndex, NodeIndex>) -> NodeIndex {
    for _ in 0..next.len() {
        match next.get(&node) {
            Some(&master) if master != node => node = master,
            _ => break,
        }
    }
    node
}

/// Along which axes an arm reaches but for rounding.
fn levers(model: &Model, master: NodeIndex, dependent: NodeIndex) -> [bool; 3] {
    let [from, to] = [master, dependent].map(|node| model.nodes.position(node));
    let arm: [f64; 3] = std::array::from_fn(|k| (to[k] - from[k]).abs());
    let longest = arm.iter().copied().fold(0.0, f64::max);
    arm.map(|part| part > ROUNDING * longest)
}

/// Part of an arm that is rounding, of meshes that were written with seven digits [1].
const ROUNDING: f64 = 1e-6;

/// Notes which dofs of its master a link follows: u = U + phi x arm, component by component; along
/// axes of its own all of both vectors. Small turns act by levers alone, large ones by all of an arm.
fn followed(
    (in_space, is_turned): (bool, bool),
    link: &RigidLink,
    levers: [bool; 3],
    used: &mut [bool; 6],
) {
    for component in (0..6).filter(|&component| link.follows[component]) {
        let moves = component < 3;
        for k in 0..3 {
            used[k] |= moves && (is_turned || k == component);
            let is_about = in_space || k == 2;
            let turns = match moves {
                true => k != component && is_about && levers[3 - k - component],
                false => k == component - 3,
            };
            used[3 + k] |= is_turned || turns;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(follows: [bool; 6], is_turned: bool, in_space: bool) -> [bool; 6] {
        by_levers(follows, (in_space, is_turned), [true; 3])
    }

    fn by_levers(follows: [bool; 6], of: (bool, bool), levers: [bool; 3]) -> [bool; 6] {
        let link =
            RigidLink { follows, ..RigidLink::welded(1, 0, slideline_diag::Span::default()) };
        let mut used = [false; 6];
        followed(of, &link, levers, &mut used);
        used
    }

    /// Requirement: small turns about axes to which no arm is across move nothing.
    #[test]
    fn turns_act_by_levers() {
        let two = [true, true, false, false, false, false];
        let flat = by_levers(two, (true, false), [true, true, false]);
        assert_eq!(flat, [true, true, false, false, false, true]);
        let on_axis = by_levers(two, (true, false), [false, false, true]);
        assert_eq!(on_axis, [true, true, false, true, true, false]);
        let one = [true, false, false, false, false, false];
        assert!(!by_levers(one, (false, false), [true, false, false])[5]);
    }

    /// Requirement: a master has the dofs that something follows: of one displacement the two turns about the
    /// axes across it.
    #[test]
    fn a_displacement_follows_itself_and_two_turns() {
        let one = [true, false, false, false, false, false];
        assert_eq!(of(one, false, true), [true, false, false, false, true, true]);
        assert!(of(one, true, true).iter().all(|own| *own));
        let two = [true, true, false, false, false, false];
        assert_eq!(of(two, false, true), [true, true, false, true, true, true]);
        let turn = [false, false, false, false, true, false];
        assert_eq!(of(turn, false, true), turn);
        assert_eq!(of(one, false, false)[..2], [true, false]);
        assert!(of(one, false, false)[5]);
    }
}
