//! Which numbers describe the motion.
//!
//! ```text
//!   node 1          node 2      node 3         dofs, one after the other:
//!   [U1 U2 UR3]     [U1 U2]     [U1 U2 UR3]    0 1 2   3 4   5 6 7
//!   beam            solid       no element
//! ```
//!
//! A node has the dofs of its elements and of the rigid body or contact that it
//! belongs to; one without elements has all, to move as it is told. The numbering
//! knows no step: it holds for a whole run and for those that go on from it.
//!
//! A node with axes of its own has its dofs a second time, along these, behind those of all
//! nodes: what is prescribed, loaded or linked there names them, and the others follow. Behind all these stand
//! the dofs of clouds that turn far, along axes that turn with them ([`DofMap::turning_dofs`]).

use crate::leading::{Leading, leading_dofs};
use slideline_model::{Dof, Master, Model, NodeIndex};
use std::collections::HashMap;
use std::ops::Range;

/// The dofs of a model's nodes, numbered node by node.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct DofMap {
    /// First dof of every node, and behind the last one their number.
    first: Vec<usize>,
    /// Nodes with axes of their own, ascending, each with its transform.
    turned: Vec<(NodeIndex, usize)>,
    /// First dof along the own axes of each of those, and behind the last one the number of all.
    first_turned: Vec<usize>,
    /// Place in `turned` of those.
    place: HashMap<NodeIndex, usize>,
    /// Node and direction of every dof.
    names: Vec<(NodeIndex, Dof)>,
    /// Whether an element, a rigid body or contact uses it.
    active: Vec<bool>,
    /// Those that are rotations.
    rotations: Vec<usize>,
    /// Nodes that turn in space, each with its three rotations along the axes of the model.
    turning: Vec<(NodeIndex, [usize; 3])>,
    /// Directions that some node has.
    kinds: Vec<Dof>,
    /// First dof along axes that turn with a cloud.
    first_turning: usize,
}

impl DofMap {
    /// Numbers the dofs of a model.
    pub fn new(model: &Model) -> Self {
        let mut has = vec![[None; Dof::ALL.len()]; model.nodes.len()];
        // a spring acts on a node, but is no part that the node belongs to
        let mut alone = vec![true; model.nodes.len()];
        let parts = model.blocks.iter().filter(|block| block.kind.joins());
        let members = parts.flat_map(|block| block.elements.iter()).flat_map(|e| e.nodes);
        members.for_each(|&node| alone[node] = false);
        let free =
            (0..alone.len()).filter(|&node| alone[node]).flat_map(|node| rigid_body(model, node));
        free.for_each(|(node, dof)| has[node][dof as usize] = Some(false));
        let turned = turned(model);
        let place = turned.iter().enumerate().map(|(place, &(node, _))| (node, place)).collect();
        let mut along = vec![[false; Dof::ALL.len()]; turned.len()];
        let mut note = |plain: bool, (node, dof): (NodeIndex, Dof)| {
            has[node][dof as usize] = Some(true);
            note_turned(&place, &mut along, plain, (node, dof));
        };
        of_elements(model, &mut note);
        let leading = leading_dofs(model);
        of_bodies((model, &leading), &mut note);
        for ((node, dof), _) in leading {
            has[node][dof as usize].get_or_insert(false);
        }
        complete(&turned, &along, &mut has);
        let count = has.iter().flatten().flatten().count();
        let mut map = Self {
            first: Vec::with_capacity(model.nodes.len() + 1),
            names: Vec::with_capacity(count),
            active: Vec::with_capacity(count),
            ..Self::default()
        };
        map.first.push(0);
        for (node, has) in has.iter().enumerate() {
            for dof in Dof::ALL {
                if let Some(active) = has[dof as usize] {
                    map.names.push((node, dof));
                    map.active.push(active);
                }
            }
            map.first.push(map.names.len());
        }
        map.add_turned(turned, place, &along);
        map.first_turning = map.names.len();
        map.names.extend(model.mean_motions.iter().flat_map(|own| &own.turning));
        map.active.resize(map.names.len(), true);
        let count = map.names.len();
        let turning = |dof: &usize| map.is_rotation(*dof);
        let mut rotations = Vec::with_capacity((0..count).filter(turning).count());
        rotations.extend((0..count).filter(turning));
        map.rotations = rotations;
        map.turning = map.find_turning();
        let used = |dof: &Dof| dof.is_plane() || map.names.iter().any(|(_, own)| own == dof);
        map.kinds = Dof::ALL.into_iter().filter(used).collect();
        map
    }

    /// Adds the dofs along own axes behind all others.
    fn add_turned(
        &mut self,
        turned: Vec<(NodeIndex, usize)>,
        place: HashMap<NodeIndex, usize>,
        along: &[[bool; 6]],
    ) {
        self.first_turned.push(self.names.len());
        for (&(node, _), along) in turned.iter().zip(along) {
            for dof in self.of_node(node) {
                let name = self.names[dof];
                self.names.push(name);
                self.active.push(along[name.1 as usize]);
            }
            self.first_turned.push(self.names.len());
        }
        (self.turned, self.place) = (turned, place);
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.names.len()
    }

    /// The dofs along axes that turn with clouds, cloud by cloud, named as the dofs that follow them.
    pub fn turning_dofs(&self) -> Range<usize> {
        self.first_turning..self.len()
    }

    /// How many there are along the axes of the model.
    pub fn plain(&self) -> usize {
        self.first.last().copied().unwrap_or_default()
    }

    /// The dofs of a node.
    #[inline]
    pub fn of_node(&self, node: NodeIndex) -> Range<usize> {
        self.first[node]..self.first[node + 1]
    }

    /// The dofs of a node along the axes in which they are named: its own, or those of the model.
    #[inline]
    pub fn named_of_node(&self, node: NodeIndex) -> Range<usize> {
        if self.turned.is_empty() {
            return self.of_node(node);
        }
        match self.place.get(&node) {
            Some(&place) => self.first_turned[place]..self.first_turned[place + 1],
            None => self.of_node(node),
        }
    }

    /// Nodes with axes of their own, each with its transform in the model.
    pub fn turned(&self) -> &[(NodeIndex, usize)] {
        &self.turned
    }

    /// The place of a node among those with axes of their own.
    pub fn place_of_turned(&self, node: NodeIndex) -> Option<usize> {
        self.place.get(&node).copied()
    }

    /// The dof that a deck names: along the own axes of the node where it has some.
    pub fn named(&self, node: NodeIndex, dof: Dof) -> Option<usize> {
        let plain = self.find(node, dof)?;
        Some(plain - self.first[node] + self.named_of_node(node).start)
    }

    /// The dof of a node along an axis of the model, where it has it.
    pub fn find(&self, node: NodeIndex, dof: Dof) -> Option<usize> {
        let own = self.of_node(node);
        let place = self.names[own.clone()].iter().position(|&(_, kind)| kind == dof)?;
        Some(own.start + place)
    }

    /// Node and direction of every dof, those along own axes behind all others.
    pub fn names(&self) -> &[(NodeIndex, Dof)] {
        &self.names
    }

    /// Node and direction of a dof.
    #[inline]
    pub fn name(&self, dof: usize) -> (NodeIndex, Dof) {
        self.names[dof]
    }

    /// Whether a dof is a rotation.
    #[inline]
    pub fn is_rotation(&self, dof: usize) -> bool {
        self.names[dof].1.is_rotation()
    }

    /// Whether an element, a rigid body or contact uses a dof: what only a
    /// support or a load names does not move by itself.
    pub fn is_active(&self, dof: usize) -> bool {
        self.active[dof]
    }

    /// The dofs that are rotations, ascending.
    pub fn rotations(&self) -> &[usize] {
        &self.rotations
    }

    /// Nodes that turn in space, each with its three rotations along the axes of the model.
    pub fn rotations_in_space(&self) -> impl Iterator<Item = (NodeIndex, [usize; 3])> + '_ {
        self.turning.iter().copied()
    }

    fn find_turning(&self) -> Vec<(NodeIndex, [usize; 3])> {
        let plain = self.rotations.iter().take_while(|&&dof| dof < self.plain());
        let found = plain.filter_map(|&dof| match self.names[dof..].first_chunk::<3>()? {
            &[(node, Dof::UR1), (second, Dof::UR2), (third, Dof::UR3)]
                if node == second && node == third =>
            {
                Some((node, [dof, dof + 1, dof + 2]))
            }
            _ => None,
        });
        found.collect()
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.first.len() - 1
    }

    /// Directions that some node of the model has, those of the plane always.
    pub fn kinds(&self) -> &[Dof] {
        &self.kinds
    }

    /// A value of a nodal vector; zero where the node lacks the dof.
    pub fn read(&self, vector: &[f64], node: NodeIndex, dof: Dof) -> f64 {
        self.find(node, dof).map_or(0.0, |dof| vector[dof])
    }

    /// The displacement of a node [L]; zero along an axis whose dof it lacks.
    pub fn translation(&self, u: &[f64], node: NodeIndex) -> [f64; 3] {
        std::array::from_fn(|axis| self.read(u, node, Dof::ALL[axis]))
    }

    /// The dofs of a node's displacement, those of the plane at least.
    pub fn translations(&self, node: NodeIndex) -> Translations {
        let of = |axis: usize| self.find(node, Dof::ALL[axis]);
        let axes = if of(2).is_some() { 3 } else { 2 };
        Translations { dofs: [0, 1, 2].map(|axis| of(axis).unwrap_or(0)), axes }
    }
}

/// The dofs that carry a point in space: one an axis of the model's dimension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Translations {
    dofs: [usize; 3],
    axes: usize,
}

impl Translations {
    /// The dofs, axis by axis.
    pub fn as_slice(&self) -> &[usize] {
        &self.dofs[..self.axes]
    }

    /// Where a point that follows them stands [L].
    pub fn displace(&self, mut position: [f64; 3], u: &[f64]) -> [f64; 3] {
        for (at, &dof) in position.iter_mut().zip(self.as_slice()) {
            *at += u[dof];
        }
        position
    }
}

/// Nodes with axes of their own, ascending, each with its transform.
fn turned(model: &Model) -> Vec<(NodeIndex, usize)> {
    let transforms = model.transforms.iter().enumerate();
    let named = transforms.flat_map(|(own, list)| list.nodes.iter().map(move |&node| (node, own)));
    let mut turned: Vec<(NodeIndex, usize)> = named.collect();
    turned.sort_unstable();
    turned.dedup_by_key(|(node, _)| *node);
    turned
}

/// Displacements, and rotations.
const VECTORS: [Range<usize>; 2] = [0..3, 3..6];

/// Notes that a dof of a node with own axes is used: one along the axes of the model uses all of
/// its vector.
fn note_turned(
    place: &HashMap<NodeIndex, usize>,
    along: &mut [[bool; 6]],
    plain: bool,
    (node, dof): (NodeIndex, Dof),
) {
    let Some(&place) = place.get(&node) else { return };
    if !plain {
        along[place][dof as usize] = true;
        return;
    }
    let [shift, turn] = VECTORS;
    along[place][if dof.is_rotation() { turn } else { shift }].fill(true);
}

/// Where a node with own axes has one component of a vector, it has those that its axes mix.
fn complete(turned: &[(NodeIndex, usize)], along: &[[bool; 6]], has: &mut [[Option<bool>; 6]]) {
    let kinds: [bool; 6] = std::array::from_fn(|dof| has.iter().any(|own| own[dof].is_some()));
    for (&(node, _), along) in turned.iter().zip(along) {
        for vector in VECTORS {
            let used = vector.clone().any(|dof| has[node][dof].is_some());
            for dof in vector.filter(|&dof| used && kinds[dof]) {
                let active = has[node][dof].unwrap_or(false) || along[dof];
                has[node][dof] = Some(active);
            }
        }
    }
}

/// Calls back with the dofs that elements give stiffness to, and whether these are along the
/// axes of the model.
fn of_elements(model: &Model, note: &mut impl FnMut(bool, (NodeIndex, Dof))) {
    for block in &model.blocks {
        let (dofs, plain) = (block.dofs(), !block.acts_along_own_axes());
        for &node in block.elements.iter().flat_map(|element| element.nodes) {
            dofs.iter().for_each(|&dof| note(plain, (node, dof)));
        }
    }
}

/// Calls back with the dofs that rigid bodies and contact use, and whether these are along the
/// axes of the model.
fn of_bodies((model, leading): (&Model, &[Leading]), mut call: impl FnMut(bool, (NodeIndex, Dof))) {
    for link in &model.rigid_links {
        for (node, dof) in rigid_body(model, link.dependent) {
            if link.follows[dof as usize] {
                call(false, (node, dof));
            }
        }
    }
    for constraint in &model.linear_constraints {
        call(false, constraint.dependent);
        constraint.terms.iter().for_each(|&(node, dof, _)| call(false, (node, dof)));
    }
    let mut note = |own| call(true, own);
    leading.iter().filter(|(_, used)| *used).for_each(|&(name, _)| note(name));
    for pair in &model.contact_pairs {
        // A contact node needs no element: its translations matter all the same.
        pair.slave_places().flat_map(|node| point(model, node)).for_each(&mut note);
        let profile = pair.profile.iter();
        profile.flat_map(|own| rigid_body(model, own.reference)).for_each(&mut note);
        match &pair.master {
            Master::RigidSurface(surface) => {
                rigid_body(model, surface.reference).for_each(&mut note)
            }
            Master::SlideLine(line) => {
                line.nodes.iter().flat_map(|&node| point(model, node)).for_each(&mut note);
            }
            Master::Itself(surface) => {
                surface.nodes().flat_map(|node| point(model, node)).for_each(&mut note);
            }
            Master::Faces(faces) => {
                let nodes = faces.faces.iter().flat_map(|face| face.nodes.iter().copied());
                nodes.flat_map(|node| point(model, node)).for_each(&mut note);
            }
        }
    }
}

/// The dofs of a node that turns.
fn rigid_body(model: &Model, node: NodeIndex) -> impl Iterator<Item = (NodeIndex, Dof)> + use<> {
    model.directions().iter().map(move |&dof| (node, dof))
}

/// The dofs of a node that does not turn.
fn point(model: &Model, node: NodeIndex) -> impl Iterator<Item = (NodeIndex, Dof)> + use<> {
    rigid_body(model, node).filter(|(_, dof)| !dof.is_rotation())
}

/// The dofs of a node that turns in the plane: displacements and rotation.
pub fn rigid_dofs(dofs: &DofMap, node: NodeIndex) -> [usize; 3] {
    [Dof::U1, Dof::U2, Dof::UR3].map(|dof| dofs.find(node, dof).unwrap_or(0))
}
