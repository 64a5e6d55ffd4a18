//! Bodies that contact alone keeps where they are.
//!
//! ```text
//!      push         let go
//!    ==>|_|       ==   |_|      what nothing touches any more stays where it is: without mass
//!                               it has no momentum
//! ```
//!
//! docs/theory.md section 8.18. (derived)

use super::rigid_motions::{DEPENDENT, Motion, named_motion};
use super::{Restraint, length};
use crate::contact::Contact;
use crate::dofs::DofMap;
use crate::state::PointState;
use slideline_model::{Master, Model, NodeIndex, Step};
use std::collections::HashSet;

/// Part of the way of a body by which it may leave what pushes it and be said to touch it [1]. (choice)
const HARDLY: f64 = 0.1;
/// Part of the forces on a body that may be left along a free motion by rounding [1].
const BALANCED: f64 = 1e-6;

/// A body that supports leave free.
#[derive(Debug, Clone)]
pub struct LooseBody {
    /// Its unknowns: equations and dofs, in the order of these.
    unknowns: Vec<(usize, usize)>,
    /// A base of its free motions.
    free: Vec<Motion>,
    /// The node that they turn about, and the length in which they count turns [L].
    root: NodeIndex,
    size: f64,
    /// Whether it turns about a support.
    swings: bool,
    /// Pairs of contact of the model that it belongs to.
    pairs: Vec<usize>,
}

/// A model with its dofs where they stand.
#[derive(Clone, Copy)]
pub struct Stand<'a> {
    /// The model.
    pub model: &'a Model,
    /// Its dofs.
    pub dofs: &'a DofMap,
    /// What they are.
    pub u: &'a [f64],
}

impl Stand<'_> {
    fn position(&self, node: NodeIndex) -> [f64; 3] {
        self.dofs.translations(node).displace(self.model.nodes.position(node), self.u)
    }
}

impl Restraint {
    /// The bodies that supports leave some motion and that are in contact: with what is held, and neither held by springs or
    /// ties nor by way of dofs that follow others. `unknown`: the dofs of all equations; `follows` says whether a dof follows others.
    pub fn loose_bodies(
        &mut self,
        (model, step): (&Model, &Step),
        (dofs, unknown): (&DofMap, &[usize]),
        follows: impl Fn(usize) -> bool,
    ) -> Vec<LooseBody> {
        let (mut found, mut taken) = (Vec::new(), vec![0_usize; model.contact_pairs.len()]);
        for root in self.roots() {
            let free = self.motions(root);
            if free.is_empty() {
                continue;
            }
            let members = self.members(model, root);
            let own: HashSet<NodeIndex> = members.iter().copied().collect();
            let (pairs, met) = pairs_of(model, &own);
            pairs.iter().for_each(|&pair| taken[pair] += 1);
            // rows of contact are asked for unknowns alone
            let is_led = met
                .iter()
                .any(|&node| dofs.of_node(node).chain(dofs.named_of_node(node)).any(&follows));
            let is_tied = self.ties.group(root).len() > 1
                || self.is_sprung(model, step, root)
                || model.linear_constraints.iter().any(|equation| {
                    let terms = equation.terms.iter().map(|term| term.0);
                    terms.chain([equation.dependent.0]).any(|node| own.contains(&node))
                });
            if pairs.is_empty() || is_led || is_tied {
                continue;
            }
            // motions count by the way of what moves most
            let by_most = |motion: &Motion| {
                let (_, moved) = self.farthest(model, (root, &members), motion)?;
                Some(motion.map(|part| part / length(moved)))
            };
            let turns = free.iter().any(|own| own[3..].iter().any(|x| x.abs() > DEPENDENT));
            let is_supported = self.rows.get(&root).is_some_and(|rows| !rows.is_empty());
            let unknowns = unknown.iter().copied().enumerate();
            let unknowns = unknowns.filter(|&(_, dof)| own.contains(&dofs.name(dof).0));
            let mut unknowns: Vec<(usize, usize)> = unknowns.collect();
            unknowns.sort_unstable_by_key(|own| own.1);
            let size = if self.size > 0.0 { self.size } else { 1.0 };
            let (free, swings) = (free.iter().filter_map(by_most).collect(), is_supported && turns);
            found.push(LooseBody { unknowns, free, root, size, swings, pairs });
        }
        // of two that touch one another neither tells where the other one is
        found.retain(|own| own.pairs.iter().all(|&pair| taken[pair] == 1));
        found
    }
}

/// Whether every body that beams and links join has a node of which all is held, turns as well: nothing is loose. A quick answer
/// without the lists of a [`Restraint`], which may be no where supports hold all.
pub fn all_are_clamped(
    (model, step): (&Model, &Step),
    (dofs, is_held): (&DofMap, impl Fn(usize) -> bool),
) -> bool {
    let mut parent: Vec<NodeIndex> = (0..model.nodes.len()).collect();
    // halves the way to the root on each walk
    let root = |parent: &mut [NodeIndex], mut node: NodeIndex| {
        while parent[node] != node {
            parent[node] = parent[parent[node]];
            node = parent[node];
        }
        node
    };
    let mut join = |a: NodeIndex, b: NodeIndex| {
        let [a, b] = [a, b].map(|node| root(&mut parent, node));
        parent[a.max(b)] = a.min(b);
    };
    for (_, element) in
        step.presence.elements(&model.blocks).filter(|(block, _)| block.kind.joins())
    {
        element.nodes.windows(2).for_each(|ends| join(ends[0], ends[1]));
    }
    for link in &model.rigid_links {
        // with all that it has, turns as well
        if dofs.of_node(link.dependent).all(|dof| link.follows[dofs.name(dof).1 as usize]) {
            join(link.master, link.dependent);
        }
    }
    let own = |node: NodeIndex| dofs.of_node(node);
    let mut clamped = vec![false; parent.len()];
    for node in 0..parent.len() {
        let turns = own(node).any(|dof| dofs.is_rotation(dof));
        clamped[root(&mut parent, node)] |= turns && own(node).all(&is_held);
    }
    (0..clamped.len()).all(|node| own(node).all(&is_held) || clamped[root(&mut parent, node)])
}

impl LooseBody {
    /// Whether contact touches it in a state, and where it did before in a first guess too: not if that takes it away by more
    /// than a small part of its way from `from` to `to`.
    pub fn is_touched(
        &self,
        contact: &Contact,
        (before, now): (&[PointState], &[PointState]),
        (from, to): (&[f64], &[f64]),
    ) -> bool {
        let ways = self.unknowns.iter().map(|&(_, dof)| (to[dof] - from[dof]).abs());
        let room = HARDLY * ways.fold(0.0, f64::max);
        contact.points.iter().zip(before.iter().zip(now)).any(|(point, (before, now))| {
            let stays = !before.closed || now.opening - before.opening <= room;
            now.closed && stays && self.belongs_to(contact.parent(point.pair))
        })
    }

    /// Whether it is of a pair of the model.
    pub fn belongs_to(&self, pair: usize) -> bool {
        self.pairs.contains(&pair)
    }

    /// Takes what moves it freely out of the way from one configuration to another one, and whether that is done: what turns
    /// about a support may be taken along by that.
    pub fn stay(&self, stand: Stand<'_>, to: &mut [f64]) -> bool {
        if self.swings {
            return false;
        }
        let motions = self.place(stand);
        let way = |k: usize| to[self.unknowns[k].1] - stand.u[self.unknowns[k].1];
        let moves = motions.part_of(way);
        for (k, &(_, dof)) in self.unknowns.iter().enumerate() {
            to[dof] -= motions.moved(&moves, k);
        }
        true
    }

    /// Where it stands.
    pub fn place<'a>(&'a self, stand: Stand<'a>) -> FreeMotions<'a> {
        let count = self.free.len().min(MOST);
        let mut base = [[0.0; MOST]; MOST];
        (0..count).for_each(|k| base[k][k] = 1.0);
        FreeMotions { body: self, stand, centre: stand.position(self.root), base, count }
    }
}

/// Most motions of a body.
const MOST: usize = 6;
/// Part of a motion that contact meets below which it does not oppose it [1]: faces tilt by the strains of what they
/// belong to. (choice)
const OPPOSED: f64 = 1e-2;

/// Part of its size by which a correction must move a body that contact presses on along what is left to it for that to be
/// rounding [1]: which of its motions are left and which are what contact makes it do is not told apart. (choice)
const WILD: f64 = 0.1;

/// The free motions of a body that are left to it where it stands.
pub struct FreeMotions<'a> {
    body: &'a LooseBody,
    stand: Stand<'a>,
    /// Where the node is that it turns about [L].
    centre: [f64; 3],
    /// So many orthogonal combinations of its free motions.
    base: [[f64; MOST]; MOST],
    count: usize,
}

impl FreeMotions<'_> {
    /// Takes away what a row of contact opposes, over dofs.
    pub fn oppose(&mut self, dofs: &[usize], row: &[f64]) {
        let (mut met, mut weight) = ([0.0; MOST], 0.0);
        for (&dof, &factor) in dofs.iter().zip(row) {
            let own = self.body.unknowns.binary_search_by_key(&dof, |own| own.1);
            if let Ok(k) = own {
                met.iter_mut().zip(self.seen(k)).for_each(|(sum, part)| *sum += factor * part);
                weight += factor.abs();
            }
        }
        let most = (0..self.count).map(|k| met[k].abs()).fold(0.0, f64::max);
        if most <= OPPOSED * weight {
            return;
        }
        // the others without what the one that is met most has of it
        let Some(pivot) = (0..self.count).max_by(|a, b| met[*a].abs().total_cmp(&met[*b].abs()))
        else {
            return;
        };
        let own = self.base[pivot];
        for k in (0..self.count).filter(|k| *k != pivot) {
            let by = met[k] / met[pivot];
            self.base[k].iter_mut().zip(own).for_each(|(x, part)| *x -= by * part);
        }
        self.count -= 1;
        self.base.swap(pivot, self.count);
    }

    /// How much of what is left of them is in a correction of the equations, given what is unbalanced, a dof each, and what
    /// rounding leaves there; `None` where something acts along them.
    pub fn part_in(
        &self,
        correction: &[f64],
        (unbalanced, floor): (impl Fn(usize) -> f64, f64),
    ) -> Option<[f64; MOST]> {
        let (mut sums, mut allowed) = ([0.0; MOST], [0.0; MOST]);
        for (k, &(_, dof)) in self.body.unknowns.iter().enumerate() {
            for (m, part) in self.seen(k).into_iter().enumerate() {
                let force = part * unbalanced(dof);
                sums[m] += force;
                allowed[m] += BALANCED * force.abs() + floor * part.abs();
            }
        }
        let is_balanced = (0..self.count).all(|m| sums[m].abs() <= allowed[m]);
        is_balanced.then(|| self.part_of(|k| correction[self.body.unknowns[k].0]))
    }

    /// Whether contact opposes some of them.
    pub fn are_opposed(&self) -> bool {
        self.count < self.body.free.len()
    }

    /// Whether they move the body by more than a part of its size.
    pub fn move_far(&self, moves: &[f64; MOST]) -> bool {
        let (mut size, mut most) = (0.0_f64, 0.0_f64);
        for (k, &(_, dof)) in self.body.unknowns.iter().enumerate() {
            let (node, name) = self.stand.dofs.name(dof);
            let from = self.stand.position(node).into_iter().zip(self.centre);
            size = from.map(|(x, c)| (x - c).abs()).fold(size, f64::max);
            if !name.is_rotation() {
                most = most.max(self.moved(moves, k).abs());
            }
        }
        most > WILD * size
    }

    /// What a row of contact, over dofs, sees of them.
    pub fn seen_by(&self, moves: &[f64; MOST], (dofs, row): (&[usize], &[f64])) -> f64 {
        let of = |(&dof, &factor): (&usize, &f64)| {
            let own = self.body.unknowns.binary_search_by_key(&dof, |own| own.1);
            own.map_or(0.0, |k| factor * self.moved(moves, k))
        };
        dofs.iter().zip(row).map(of).sum()
    }

    /// Takes a part of them out of a correction of the equations.
    pub fn take(&self, moves: &[f64; MOST], part: f64, correction: &mut [f64]) {
        for (k, &(equation, _)) in self.body.unknowns.iter().enumerate() {
            correction[equation] -= part * self.moved(moves, k);
        }
    }

    /// What an unknown sees of every motion that is left.
    fn seen(&self, k: usize) -> [f64; MOST] {
        let (node, name) = self.stand.dofs.name(self.body.unknowns[k].1);
        let at = self.stand.position(node);
        let arm = std::array::from_fn(|x| (at[x] - self.centre[x]) / self.body.size);
        let mut own = named_motion(self.stand.model, node, name, arm);
        if name.is_rotation() {
            own = own.map(|x| x / self.body.size);
        }
        let mut free = [0.0; MOST];
        for (into, motion) in free.iter_mut().zip(&self.body.free) {
            *into = own.iter().zip(motion).map(|(a, b)| a * b).sum();
        }
        let mut seen = [0.0; MOST];
        for (into, base) in seen.iter_mut().zip(&self.base[..self.count]) {
            *into = base.iter().zip(free).map(|(a, b)| a * b).sum();
        }
        seen
    }

    fn moved(&self, moves: &[f64; MOST], k: usize) -> f64 {
        moves.iter().zip(self.seen(k)).map(|(a, b)| a * b).sum()
    }

    /// How much of every motion is in what unknowns do: least squares.
    fn part_of(&self, value: impl Fn(usize) -> f64) -> [f64; MOST] {
        let mut rows = [[0.0; MOST + 1]; MOST];
        for k in 0..self.body.unknowns.len() {
            let seen = self.seen(k);
            for i in 0..self.count {
                for j in 0..self.count {
                    rows[i][j] += seen[i] * seen[j];
                }
                rows[i][MOST] += seen[i] * value(k);
            }
        }
        solved(rows, self.count)
    }
}

/// The solution of a few symmetric equations, their right sides last; zero along what they do not tell.
fn solved(mut rows: [[f64; MOST + 1]; MOST], count: usize) -> [f64; MOST] {
    let whole: [f64; MOST] = std::array::from_fn(|i| rows[i][i]);
    for pivot in 0..count {
        if rows[pivot][pivot] <= DEPENDENT * whole[pivot] {
            rows[pivot] = [0.0; MOST + 1];
            continue;
        }
        let own = rows[pivot].map(|x| x / rows[pivot][pivot]);
        for (_, row) in rows.iter_mut().enumerate().take(count).filter(|(i, _)| *i != pivot) {
            let by = row[pivot];
            row.iter_mut().zip(own).for_each(|(x, part)| *x -= by * part);
        }
        rows[pivot] = own;
    }
    std::array::from_fn(|i| if i < count { rows[i][MOST] } else { 0.0 })
}

/// Pairs with a node of a body on either side, and these nodes.
fn pairs_of(model: &Model, members: &HashSet<NodeIndex>) -> (Vec<usize>, Vec<NodeIndex>) {
    let (mut pairs, mut met) = (Vec::new(), Vec::new());
    for (place, pair) in model.contact_pairs.iter().enumerate() {
        let rigid = pair.rigid_surfaces().map(|surface| surface.reference);
        let swept = match &pair.master {
            Master::Faces(faces) => faces.swept.as_ref().map(|surface| surface.reference),
            Master::RigidSurface(_) | Master::SlideLine(_) | Master::Itself(_) => None,
        };
        let nodes = pair.slave_nodes().into_iter().chain(pair.master.deforming_nodes());
        let before = met.len();
        met.extend(nodes.chain(rigid).chain(swept).filter(|node| members.contains(node)));
        if met.len() > before {
            pairs.push(place);
        }
    }
    (pairs, met)
}
