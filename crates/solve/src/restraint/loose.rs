//! Bodies that contact alone keeps where they are.
//!
//! ```text
//!      push         let go
//!    ==>|_|       ==   |_|      what nothing touches any more stays where it is: without mass
//!                               it has no momentum
//! ```
//!
//! docs/theory.md section 8.18. (derived)

use super::rigid_motions::{DEPENDENT, Motion, named_motion, rank};
use super::{Restraint, length};
use crate::contact::Contact;
use crate::dofs::DofMap;
use crate::state::PointState;
use slideline_mech::vector::{size, sub};
use slideline_model::{ContactPair, Master, Model, NodeIndex, Step};
use std::collections::HashMap;

/// Part of the way of a body by which it may leave what pushes it and be said to touch it [1]. (choice)
const HARDLY: f64 = 0.1;
/// Part of its size by which a body goes far in an iteration [1]. (choice)
const FAR: f64 = 0.1;
/// Most motions of a body.
const MOST: usize = 6;

/// The bodies that supports leave free, and what they can meet.
#[derive(Debug, Clone, Default)]
pub struct LooseBodies {
    bodies: Vec<LooseBody>,
    /// Which of them each pair of the model joins.
    pairs: Vec<Meeting>,
    /// Two of them that ties join.
    tied: Vec<[usize; 2]>,
    /// Which of them nodes belong to.
    of_node: HashMap<NodeIndex, usize>,
}

/// How stiff and how large the elements of a body are.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Firmness {
    /// Mean of the least and the largest EA/l, in logarithms [F/L].
    pub stiffness: f64,
    /// Length of the stiffest element [L].
    pub length: f64,
}

/// What meets in a pair.
#[derive(Debug, Clone, Default)]
struct Meeting {
    /// Loose bodies.
    bodies: Vec<usize>,
    /// Whether something is there that supports hold.
    has_held: bool,
}

/// A body that supports leave free.
#[derive(Debug, Clone)]
pub struct LooseBody {
    /// The dofs of its nodes, along the axes of the model.
    dofs: Vec<usize>,
    /// Those that are unknown, along the own axes of nodes that have some.
    unknowns: Vec<usize>,
    /// A base of its free motions.
    free: Vec<Motion>,
    /// The node that they turn about, and the length in which they count turns [L].
    root: NodeIndex,
    size: f64,
    /// Whether it turns about a support, and whether it can do nothing else.
    swings: bool,
    hangs: bool,
    /// How far from that node it reaches, undeformed [L].
    extent: f64,
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
    /// The bodies that supports leave some motion and that contact, or what ties them to others, may hold; none that springs
    /// between two nodes hold. `is_unknown` says of a dof whether it is.
    pub fn loose_bodies(
        &mut self,
        (model, step): (&Model, &Step),
        (dofs, is_unknown): (&DofMap, impl Fn(usize) -> bool),
    ) -> LooseBodies {
        let (mut found, mut roots) = (LooseBodies::default(), Vec::new());
        for root in self.roots() {
            let free = self.motions(root);
            if free.is_empty() || self.is_sprung(model, step, root) {
                continue;
            }
            let members = self.members(model, root);
            found.of_node.extend(members.iter().map(|&node| (node, roots.len())));
            roots.push(root);
            // motions count by the way of what moves most
            let by_most = |motion: &Motion| {
                let (_, moved) = self.farthest(model, (root, &members), motion)?;
                Some(motion.map(|part| part / length(moved)))
            };
            let turns = free.iter().any(|own| own[3..].iter().any(|x| x.abs() > DEPENDENT));
            let turning: Vec<Motion> = free.iter().map(turn_of).collect();
            let is_supported = self.rows.get(&root).is_some_and(|rows| !rows.is_empty());
            let origin = model.nodes.position(root);
            let from_root = |node: NodeIndex| size(sub(model.nodes.position(node), origin));
            let own = |&node: &NodeIndex| dofs.of_node(node);
            // the same for nodes without axes of their own
            let named = |&node: &NodeIndex| dofs.of_node(node).chain(dofs.named_of_node(node));
            let mut unknowns: Vec<usize> = members.iter().flat_map(named).collect();
            unknowns.retain(|&dof| is_unknown(dof));
            unknowns.sort_unstable();
            unknowns.dedup();
            found.bodies.push(LooseBody {
                unknowns,
                dofs: members.iter().flat_map(own).collect(),
                free: free.iter().filter_map(by_most).collect(),
                root,
                size: if self.size > 0.0 { self.size } else { 1.0 },
                swings: is_supported && turns,
                hangs: is_supported && rank(&turning) == free.len(),
                extent: members.iter().map(|&node| from_root(node)).fold(0.0, f64::max),
            });
        }
        let meeting = |pair| Meeting::of(pair, &found.of_node);
        found.pairs = model.contact_pairs.iter().map(meeting).collect();
        for (one, &root) in roots.iter().enumerate() {
            let group = self.ties.group(root);
            let others = roots.iter().enumerate().filter(|(_, own)| group.contains(own));
            found.tied.extend(others.filter(|(other, _)| one < *other).map(|own| [one, own.0]));
        }
        found.forget_lone_ones();
        found
    }
}

impl Meeting {
    fn of(pair: &ContactPair, owner: &HashMap<NodeIndex, usize>) -> Self {
        let rigid = pair.rigid_surfaces().map(|surface| surface.reference);
        let swept = match &pair.master {
            Master::Faces(faces) => faces.swept.as_ref().map(|surface| surface.reference),
            Master::RigidSurface(_) | Master::SlideLine(_) | Master::Itself(_) => None,
        };
        let nodes = pair.slave_nodes().into_iter().chain(pair.master.deforming_nodes());
        let mut new = Self::default();
        for node in nodes.chain(rigid).chain(swept) {
            match owner.get(&node) {
                Some(&body) => new.bodies.push(body),
                None => new.has_held = true,
            }
        }
        new.bodies.sort_unstable();
        new.bodies.dedup();
        new
    }
}

impl LooseBodies {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }

    /// Places in the list of the bodies of a pair of the model.
    pub fn of_pair(&self, pair: usize) -> &[usize] {
        self.pairs.get(pair).map_or(&[], |own| &own.bodies)
    }

    /// Each of them.
    pub fn iter(&self) -> impl Iterator<Item = &LooseBody> {
        self.bodies.iter()
    }

    /// How firm each is, given that of all elements, with the block and the member of each in the model: those without elements are as
    /// firm as `others`.
    pub fn firmness(
        &self,
        model: &Model,
        elements: impl Iterator<Item = ((usize, usize), Firmness)>,
        (others, into): (Firmness, &mut Vec<Firmness>),
    ) {
        into.clear();
        into.resize(self.bodies.len(), Firmness::default());
        let mut least = vec![f64::INFINITY; self.bodies.len()];
        for ((block, member), own) in elements {
            let block = &model.blocks[block];
            let node = block.elements.get(member).nodes[0];
            let body = self.of_node.get(&node).filter(|_| block.kind.joins());
            let Some(&body) = body.filter(|_| own.stiffness > 0.0) else { continue };
            least[body] = least[body].min(own.stiffness);
            if own.stiffness > into[body].stiffness {
                into[body] = own;
            }
        }
        for (own, least) in into.iter_mut().zip(least) {
            match least.is_finite() {
                true => own.stiffness = own.stiffness.sqrt() * least.sqrt(),
                false => *own = others,
            }
        }
    }

    /// Leaves out those that nothing can touch: contact never holds them.
    fn forget_lone_ones(&mut self) {
        let joined = self.joined(|_| true);
        let mut is_met = vec![false; self.bodies.len()];
        self.pairs.iter().flat_map(|own| &own.bodies).for_each(|&body| is_met[joined[body]] = true);
        for (body, _) in self.bodies.iter_mut().zip(&joined).filter(|own| !is_met[*own.1]) {
            body.dofs.clear();
            body.unknowns.clear();
        }
        if !is_met.contains(&true) {
            *self = Self::default();
        }
    }

    /// A body that stands for all that ties and some pairs join to each.
    fn joined(&self, pairs: impl Fn(usize) -> bool) -> Vec<usize> {
        let mut group: Vec<usize> = (0..self.bodies.len()).collect();
        let mut join = |one: usize, other: usize| {
            let [one, other] = [one, other].map(|body| group[body]);
            group.iter_mut().filter(|own| **own == other).for_each(|own| *own = one);
        };
        self.tied.iter().for_each(|&[one, other]| join(one, other));
        let touching = self.pairs.iter().enumerate().filter(|own| pairs(own.0));
        touching.for_each(|(_, own)| own.bodies.windows(2).for_each(|two| join(two[0], two[1])));
        group
    }

    /// Whether each is in contact with what is held, by way of others too: where contact was closed before and is in a first
    /// guess; not if that takes the sides of it apart by more than a small part of the way of a body from `from` to `to`.
    pub fn are_held(
        &self,
        contact: &Contact,
        (before, now): (&[PointState], &[PointState]),
        (from, to): (&[f64], &[f64]),
    ) -> Vec<bool> {
        let way = |body: &LooseBody| {
            let ways = body.unknowns.iter().map(|&dof| (to[dof] - from[dof]).abs());
            ways.fold(0.0, f64::max)
        };
        let ways: Vec<f64> = self.bodies.iter().map(way).collect();
        let mut closed = vec![false; self.pairs.len()];
        for (point, (before, now)) in contact.points.iter().zip(before.iter().zip(now)) {
            let pair = contact.parent(point.pair);
            let farthest = self.pairs[pair].bodies.iter().map(|&body| ways[body]);
            let room = HARDLY * farthest.fold(0.0, f64::max);
            let stays = !before.closed || now.opening - before.opening <= room;
            closed[pair] |= now.closed && stays;
        }
        let group = self.joined(|pair| closed[pair]);
        let mut is_held = vec![false; group.len()];
        for (pair, meeting) in self.pairs.iter().enumerate() {
            let holds = closed[pair] && meeting.has_held;
            meeting.bodies.iter().for_each(|&body| is_held[group[body]] |= holds);
        }
        group.iter().map(|&own| is_held[own]).collect()
    }
}

impl LooseBody {
    /// The dofs of its nodes, along the axes of the model.
    pub fn dofs(&self) -> impl Iterator<Item = usize> {
        self.dofs.iter().copied()
    }

    /// Whether it hangs on a support, about which it can turn and no more.
    pub fn hangs(&self) -> bool {
        self.hangs
    }

    /// Whether a change of dofs moves it by more than a part of its size.
    pub fn goes_far(&self, change: impl Fn(usize) -> f64, dofs: &DofMap) -> bool {
        let mut ways = self.unknowns.iter().filter(|&&dof| !dofs.is_rotation(dof));
        ways.any(|&dof| change(dof).abs() > FAR * self.extent)
    }

    /// Its unknowns, a dof each.
    pub fn unknowns(&self) -> impl Iterator<Item = usize> {
        self.unknowns.iter().copied()
    }

    /// Takes what moves it freely out of the way from one configuration to another one, and says whether that is done: what
    /// turns about a support may be taken along by that.
    pub fn stay(&self, stand: Stand<'_>, to: &mut [f64]) -> bool {
        if self.swings {
            return false;
        }
        let centre = stand.position(self.root);
        let moves = self.part_of(stand, |dof| to[dof] - stand.u[dof]);
        for &dof in &self.unknowns {
            let seen = self.seen((stand, centre), dof);
            to[dof] -= moves.iter().zip(seen).map(|(a, b)| a * b).sum::<f64>();
        }
        true
    }

    /// What an unknown sees of every free motion.
    fn seen(&self, (stand, centre): (Stand<'_>, [f64; 3]), dof: usize) -> [f64; MOST] {
        let (node, name) = stand.dofs.name(dof);
        let at = stand.position(node);
        let arm = std::array::from_fn(|x| (at[x] - centre[x]) / self.size);
        let mut own = named_motion(stand.model, node, name, arm);
        if name.is_rotation() {
            own = own.map(|x| x / self.size);
        }
        let mut seen = [0.0; MOST];
        for (into, motion) in seen.iter_mut().zip(&self.free) {
            *into = own.iter().zip(motion).map(|(a, b)| a * b).sum();
        }
        seen
    }

    /// How much of every free motion is in what unknowns do: least squares.
    fn part_of(&self, stand: Stand<'_>, value: impl Fn(usize) -> f64) -> [f64; MOST] {
        let centre = stand.position(self.root);
        let count = self.free.len().min(MOST);
        let mut rows = [[0.0; MOST + 1]; MOST];
        for &dof in &self.unknowns {
            let seen = self.seen((stand, centre), dof);
            for i in 0..count {
                for j in 0..count {
                    rows[i][j] += seen[i] * seen[j];
                }
                rows[i][MOST] += seen[i] * value(dof);
            }
        }
        solved(rows, count)
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

/// A motion without its translation.
fn turn_of(motion: &Motion) -> Motion {
    let [.., x, y, z] = *motion;
    [0.0, 0.0, 0.0, x, y, z]
}
