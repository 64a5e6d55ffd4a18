//! Planes of symmetry at which a model ends: what lies beyond is its mirror image.
//!
//! ```text
//!            |o----o----        the whole model lies on one side of the plane, elements end in it with a
//!   mirror   |o    |            face, and every node of elements there is held across the plane, but those at which
//!    image   |o----o----        the master ends not along it: a clamped end is no such plane
//! ```
//!
//! docs/theory.md section 5.3.

use crate::element::block::{Element, ElementBlock};
use crate::model::Model;
use crate::node::{Dof, NodeIndex, RigidLink};
use crate::numbered::{Numbered, NumberedSet};
use crate::presence::ElementIndex;
use crate::step::{Prescribed, Step};
use crate::surface::Master;
use slideline_mech::axes::Axes;
use slideline_mech::surface::mirror::across;
use slideline_mech::vector::{Vector, dot, scale, size, sub};
use std::collections::HashMap;

/// Distance from a plane up to which a node lies in it, over the size of the model [1]: decks are written with a few
/// digits.
const IN_PLANE: f64 = 1e-5;
/// Sine of the angle up to which two directions are one [1], for the same reason.
const SAME: f64 = 1e-5;
/// Directions whose parts agree in so many steps of one are counted together [1].
const STEPS: f64 = 1e3;

/// A plane of symmetry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SymmetryPlane {
    /// Its unit normal [1].
    pub normal: Vector,
    /// How far from the origin it lies along the normal [L].
    pub level: f64,
    /// Distance from it up to which a node lies in it [L].
    pub room: f64,
}

impl SymmetryPlane {
    /// Whether a place lies in it.
    pub fn holds(&self, at: Vector) -> bool {
        (dot(self.normal, at) - self.level).abs() <= self.room
    }
}

/// The nodes of a model by the directions in which they are held.
struct Held<'a> {
    model: &'a Model,
    /// Unit vectors, each node's across one another [1].
    directions: Numbered<NodeIndex, Vec<Vector>>,
    /// The same of those in which they move in some step as they are told, or not at all.
    told: Numbered<NodeIndex, Vec<Vector>>,
    /// Nodes that do not turn in any step.
    still: NumberedSet<NodeIndex>,
    /// What hangs on rigid links.
    links: Numbered<NodeIndex, &'a RigidLink>,
    /// Nodes of elements, each once.
    nodes: Vec<NodeIndex>,
    /// Length of the box about these [L].
    size: f64,
}

impl Model {
    /// The planes of symmetry beyond which what nodes meet goes on as its image: those in which a line of nodes ends, or
    /// smoothed faces do; `None` for what nodes do not meet. None at all where no element has a side.
    pub fn planes_beyond<'p>(
        &self,
        masters: impl Iterator<Item = Option<&'p Master>>,
    ) -> Vec<Vec<SymmetryPlane>> {
        if !self.blocks.iter().any(|block| block.kind.joins() && !block.kind.cell.faces.is_empty())
        {
            return Vec::new();
        }
        let ends: Vec<Vec<NodeIndex>> =
            masters.map(|own| own.map_or_else(Vec::new, ends_of)).collect();
        if ends.iter().all(Vec::is_empty) {
            return vec![Vec::new(); ends.len()];
        }
        let held = Held::new(self);
        ends.iter().map(|ends| held.planes(ends)).collect()
    }
}

/// The nodes of a master that may lie in a plane beyond which it goes on.
fn ends_of(master: &Master) -> Vec<NodeIndex> {
    match master {
        Master::SlideLine(line) if !line.is_ring() => {
            [line.nodes.first(), line.nodes.last()].into_iter().flatten().copied().collect()
        }
        Master::Faces(faces) if faces.smooth && faces.swept.is_none() => faces.nodes(),
        _ => Vec::new(),
    }
}

impl<'a> Held<'a> {
    fn new(model: &'a Model) -> Self {
        let mut has = vec![false; model.nodes.len()];
        parts(model).flat_map(|(_, own)| own.nodes).for_each(|&node| has[node] = true);
        let nodes: Vec<_> = (0..has.len()).filter(|&node| has[node]).collect();
        let bounds = |axis: usize| {
            let all = nodes.iter().map(|&node| model.nodes.position(node)[axis]);
            let low = all.clone().fold(f64::INFINITY, f64::min);
            all.fold(f64::NEG_INFINITY, f64::max) - low
        };
        let size = if nodes.is_empty() { 0.0 } else { size([0, 1, 2].map(bounds)) };
        let held = directions(model, is_still, |one, other| one & other);
        let told = directions(model, |_| true, |one, other| one | other);
        let links = model.rigid_links.iter().map(|link| (link.dependent, link)).collect();
        Self { model, directions: held, told, still: unturned(model), links, nodes, size }
    }

    /// The planes of symmetry in which some of these nodes lie, the axis of rings among them.
    fn planes(&self, nodes: &[NodeIndex]) -> Vec<SymmetryPlane> {
        let mut known: Vec<(Vector, (f64, f64))> = Vec::new();
        let mut tested: Vec<SymmetryPlane> = Vec::new();
        for (node, normal) in self.shared_candidates(nodes) {
            let place = known.iter().position(|(own, _)| is_same(*own, normal));
            let place = place.unwrap_or_else(|| {
                known.push((normal, self.reach(normal)));
                known.len() - 1
            });
            let (normal, (low, high)) = known[place];
            for level in [low, high] {
                let plane = SymmetryPlane { normal, level, room: self.room() };
                if plane.holds(self.model.nodes.position(node)) && !tested.contains(&plane) {
                    tested.push(plane);
                }
            }
        }
        tested.retain(|plane| self.ends_in(plane));
        tested
    }

    fn dimension(&self) -> usize {
        if self.model.is_in_space() { 3 } else { 2 }
    }

    fn room(&self) -> f64 {
        IN_PLANE * self.size
    }

    /// Between which levels along a normal the elements lie [L].
    fn reach(&self, normal: Vector) -> (f64, f64) {
        let levels = self.nodes.iter().map(|&node| dot(normal, self.model.nodes.position(node)));
        let low = levels.clone().fold(f64::INFINITY, f64::min);
        (low, levels.fold(f64::NEG_INFINITY, f64::max))
    }

    /// Normals that a plane of symmetry through one of these nodes may have, with the node. In space a surface that ends
    /// in a plane has two nodes there at least: what one node alone is held along, as of a cylinder, is none.
    fn shared_candidates(&self, nodes: &[NodeIndex]) -> Vec<(NodeIndex, Vector)> {
        let all =
            || nodes.iter().flat_map(|&node| self.candidates(node).map(move |own| (node, own)));
        let key = |normal: Vector| {
            let first = normal.iter().find(|part| part.abs() > SAME).copied().unwrap_or(1.0);
            normal.map(|part| (STEPS * part * first.signum()).round() as i64)
        };
        let mut count: HashMap<[i64; 3], usize> = HashMap::new();
        all().for_each(|(_, normal)| *count.entry(key(normal)).or_default() += 1);
        let least = self.dimension() - 1;
        all().filter(|(_, normal)| count[&key(*normal)] >= least).collect()
    }

    /// Normals that a plane of symmetry through a node may have, which is free along it.
    fn candidates(&self, node: NodeIndex) -> impl Iterator<Item = Vector> + '_ {
        let is_free = self.is_free(node) && !self.links.contains_key(&node);
        let own = self.directions.get(&node).filter(|_| is_free).into_iter().flatten().copied();
        let is_axis = self.is_on_axis(node);
        own.filter(move |own| !(is_axis && is_same(*own, AXIS))).chain(is_axis.then_some(AXIS))
    }

    /// Whether a node moves on its own in some direction, in all steps.
    fn is_free(&self, node: NodeIndex) -> bool {
        self.told.get(&node).is_none_or(|own| own.len() < self.dimension())
    }

    /// Whether a node of rings lies on their axis.
    fn is_on_axis(&self, node: NodeIndex) -> bool {
        self.model.is_of_rings() && self.model.nodes.position(node)[0].abs() <= self.room()
    }

    /// Whether the model ends in a plane as a half of something symmetric does.
    fn ends_in(&self, plane: &SymmetryPlane) -> bool {
        let place = |node: &NodeIndex| self.model.nodes.position(*node);
        let inside: NumberedSet<_> =
            self.nodes.iter().copied().filter(|node| plane.holds(place(node))).collect();
        let is_axis = inside.iter().all(|&node| self.is_on_axis(node));
        if self.model.is_of_rings() && !is_axis && dot(plane.normal, AXIS).abs() > SAME {
            return false; // a cylinder or a cone
        }
        let is_held = |node: &NodeIndex| is_axis || self.holds(*node, plane.normal);
        let ends = || {
            parts(self.model).any(|(block, own)| {
                let cell = block.kind.cell;
                let is_in = |&k: &usize| inside.contains(&own.nodes[k]);
                cell.faces.iter().any(|face| corners_of(cell.dimension, face).all(is_in))
            })
        };
        inside.iter().all(is_held) && ends()
    }

    /// Whether a node is held along a direction, by itself or by the rigid body that it belongs to, which does not turn.
    fn holds(&self, node: NodeIndex, normal: Vector) -> bool {
        let is_held = |node: NodeIndex| {
            self.directions.get(&node).is_some_and(|of| size(across(normal, of)) <= SAME)
        };
        let by_link = |link: &&&RigidLink| {
            let moves = &link.follows[..self.dimension()];
            moves.iter().all(|&follows| follows)
                && link.turn.is_none()
                && self.still.contains(&link.master)
        };
        let link = self.links.get(&node).filter(by_link);
        is_held(node) || link.is_some_and(|link| is_held(link.master))
    }
}

/// The corners of a face: in the plane both ends, in space those that stand first.
fn corners_of(dimension: usize, face: &[usize]) -> impl Iterator<Item = &usize> {
    let [count, every] = match (dimension, face.len()) {
        (3, 6) => [3, 1],
        (3, 8) => [4, 1],
        (3, other) => [other, 1],
        (_, other) => [other, other.max(2) - 1],
    };
    face.iter().take(count).step_by(every)
}

/// Direction away from the axis of rings.
const AXIS: Vector = [1.0, 0.0, 0.0];

/// The elements that bodies are made of, but those that are there in no step.
fn parts(model: &Model) -> impl Iterator<Item = (&ElementBlock, Element<'_>)> {
    let is_there = |index: ElementIndex| {
        model.steps.is_empty() || model.steps.iter().any(|step| step.presence.has(index))
    };
    let blocks = model.blocks.iter().enumerate().filter(|(_, block)| block.kind.joins());
    blocks.flat_map(move |(place, block)| {
        let all = block.elements.iter().enumerate();
        let there = all.filter(move |(member, _)| is_there((place, *member)));
        there.map(move |(_, own)| (block, own))
    })
}

/// Displacements and rotations of nodes.
type Known = NumberedSet<(NodeIndex, Dof)>;

/// How what is known of two steps comes together.
type Together = fn(&Known, &Known) -> Known;

/// What supports like these hold, in steps that come together so.
fn known(model: &Model, counts: impl Fn(&Prescribed) -> bool, together: Together) -> Known {
    let of_step = |step: &Step| -> Known {
        let own = step.prescribed.iter().filter(|own| counts(own));
        own.map(|own| (own.node, own.dof)).collect()
    };
    let all = model.steps.iter().map(of_step);
    all.reduce(|known, own| together(&known, &own)).unwrap_or_default()
}

/// Whether a support holds at zero.
fn is_still(own: &Prescribed) -> bool {
    own.value == 0.0 || own.fixed
}

/// References of rigid bodies whose rotations are held at zero in every step.
fn unturned(model: &Model) -> NumberedSet<NodeIndex> {
    let all = if model.is_in_space() { &[Dof::UR1, Dof::UR2, Dof::UR3][..] } else { &[Dof::UR3] };
    let known = known(model, is_still, |one, other| one & other);
    let masters = model.rigid_links.iter().map(|link| link.master);
    masters.filter(|node| all.iter().all(|&dof| known.contains(&(*node, dof)))).collect()
}

/// The directions in which nodes are held by supports like these, in steps that come together so.
fn directions(
    model: &Model,
    counts: impl Fn(&Prescribed) -> bool,
    together: Together,
) -> Numbered<NodeIndex, Vec<Vector>> {
    let mut axes: Numbered<NodeIndex, Axes> = Numbered::default();
    for own in &model.transforms {
        let at = |node: NodeIndex| own.system.at(model.nodes.position(node));
        axes.extend(own.nodes.iter().map(|&node| (node, at(node))));
    }
    let along = |node: NodeIndex, dof: Dof| match axes.get(&node) {
        Some(own) => own[dof as usize],
        None => std::array::from_fn(|axis| f64::from(axis == dof as usize)),
    };
    let mut found: Numbered<NodeIndex, Vec<Vector>> = Numbered::default();
    let held = held(model, counts, together);
    for &(node, dof) in &held {
        add(found.entry(node).or_default(), along(node, dof));
    }
    // an equation of one node alone holds it across the vector of its factors
    for own in &model.linear_constraints {
        let (node, dof) = own.dependent;
        let is_alone = own.terms.iter().all(|&(other, dof, _)| other == node && !dof.is_rotation());
        if own.constant != 0.0 || dof.is_rotation() || !is_alone {
            continue;
        }
        let mut factors = along(node, dof);
        for &(_, dof, factor) in &own.terms {
            factors = sub(factors, scale(along(node, dof), factor));
        }
        add(found.entry(node).or_default(), factors);
    }
    found
}

/// Whether two normals are one, or opposite.
fn is_same(a: Vector, b: Vector) -> bool {
    size(sub(b, scale(a, dot(a, b)))) <= SAME
}

/// Takes a direction in, as far as it is a new one.
fn add(directions: &mut Vec<Vector>, new: Vector) {
    let whole = size(new);
    let left = across(new, directions);
    let rest = size(left);
    if rest > SAME * whole {
        directions.push(scale(left, 1.0 / rest));
    }
}

/// Displacements that are held, in the order of the deck, and those that follow such ones.
fn held(
    model: &Model,
    counts: impl Fn(&Prescribed) -> bool,
    together: Together,
) -> Vec<(NodeIndex, Dof)> {
    let mut known = known(model, counts, together);
    let mut listed = NumberedSet::default();
    let steps = model.steps.iter().flat_map(|step| &step.prescribed);
    let steps = steps.map(|own| (own.node, own.dof));
    let mut all: Vec<_> = steps.filter(|own| known.contains(own) && listed.insert(*own)).collect();
    all.retain(|(_, dof)| !dof.is_rotation());
    loop {
        let follows = model.linear_constraints.iter().filter(|own| {
            let mut terms = own.terms.iter();
            own.constant == 0.0
                && !own.dependent.1.is_rotation()
                && terms.all(|&(node, dof, _)| known.contains(&(node, dof)))
        });
        let new: Vec<_> =
            follows.map(|own| own.dependent).filter(|own| !known.contains(own)).collect();
        if new.is_empty() {
            return all;
        }
        known.extend(new.iter().copied());
        all.extend(new);
    }
}
