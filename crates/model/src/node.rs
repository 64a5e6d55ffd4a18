//! Nodes, their degrees of freedom, and links that make them rigid.

use crate::numbered::Numbered;
use crate::numbering::{Name, Numbering};
use slideline_diag::Span;

/// Place of a node in [`Nodes`].
pub type NodeIndex = usize;

/// A degree of freedom of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Dof {
    /// Displacement along x [L].
    U1,
    /// Displacement along y [L].
    U2,
    /// Displacement along z [L].
    U3,
    /// Rotation about x [1].
    UR1,
    /// Rotation about y [1].
    UR2,
    /// Rotation about z [1].
    UR3,
}

impl Dof {
    /// All six, in the order of their deck numbers 1 to 6.
    pub const ALL: [Self; 6] = [Self::U1, Self::U2, Self::U3, Self::UR1, Self::UR2, Self::UR3];
    /// Those that a plane model uses.
    pub const PLANE: [Self; 3] = [Self::U1, Self::U2, Self::UR3];

    /// The motions of a rigid body, in space or in the plane.
    pub fn of_rigid_body(in_space: bool) -> &'static [Self] {
        if in_space { &Self::ALL } else { &Self::PLANE }
    }

    /// From the deck's number 1 to 6.
    pub fn from_number(number: i64) -> Option<Self> {
        usize::try_from(number - 1).ok().and_then(|index| Self::ALL.get(index).copied())
    }

    /// The list of this one alone.
    pub fn alone(self) -> &'static [Self] {
        &Self::ALL[self as usize..=self as usize]
    }

    /// Deck number 1 to 6.
    pub fn number(self) -> usize {
        self as usize + 1
    }

    /// Name of the motion, such as `U2`.
    pub fn name(self) -> &'static str {
        ["U1", "U2", "U3", "UR1", "UR2", "UR3"][self as usize]
    }

    /// Name of the reaction, such as `RF2` or `RM3`.
    pub fn reaction_name(self) -> &'static str {
        ["RF1", "RF2", "RF3", "RM1", "RM2", "RM3"][self as usize]
    }

    /// Whether it is a rotation (its force is a moment).
    pub fn is_rotation(self) -> bool {
        self as usize >= 3
    }

    /// Whether a plane model has it.
    pub fn is_plane(self) -> bool {
        Self::PLANE.contains(&self)
    }
}

/// A point of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// Its number in the deck.
    pub label: u64,
    /// Undeformed position [L].
    pub position: [f64; 3],
    /// Where it was defined.
    pub origin: Span,
}

/// All nodes, with their labels.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Nodes {
    list: Vec<Node>,
    by_label: Numbered<u64, NodeIndex>,
    numbering: Numbering,
}

impl Nodes {
    /// Takes a node in; a node of the same label is replaced in its place.
    pub fn insert(&mut self, node: Node) -> NodeIndex {
        if let Some(&index) = self.by_label.get(&node.label) {
            self.list[index] = node;
            return index;
        }
        self.by_label.insert(node.label, self.list.len());
        self.list.push(node);
        self.list.len() - 1
    }

    /// The place of a label.
    pub fn find(&self, label: u64) -> Option<NodeIndex> {
        self.by_label.get(&label).copied()
    }

    /// The node at that place.
    ///
    /// Panics only for an index that this model never gave out.
    pub fn get(&self, index: NodeIndex) -> &Node {
        &self.list[index]
    }

    /// Moves a node's undeformed position [L].
    pub fn place(&mut self, index: NodeIndex, position: [f64; 3]) {
        self.list[index].position = position;
    }

    /// Label of the node at that place.
    pub fn label(&self, index: NodeIndex) -> u64 {
        self.list[index].label
    }

    /// The node at that place in the deck's words, `ARM-1.12` in a deck of parts.
    pub fn name(&self, index: NodeIndex) -> Name<'_> {
        self.numbering.name(self.label(index))
    }

    /// How numbers are made of instances and numbers of their parts.
    pub fn numbering(&self) -> &Numbering {
        &self.numbering
    }

    /// Says how the numbers are made; they stay as they are.
    pub fn set_numbering(&mut self, numbering: Numbering) {
        self.numbering = numbering;
    }

    /// Gives the numbers of instances another stride.
    pub fn restride(&mut self, stride: u64) {
        for node in &mut self.list {
            node.label = self.numbering.restride(node.label, stride);
        }
        self.by_label = self.list.iter().enumerate().map(|(at, node)| (node.label, at)).collect();
        self.numbering = Numbering::new(stride, self.numbering.instances().to_vec());
    }

    /// Undeformed position [L].
    pub fn position(&self, index: NodeIndex) -> [f64; 3] {
        self.list[index].position
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// All nodes in the order of their places.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &Node> {
        self.list.iter()
    }
}

/// A dof that follows others linearly, u = sum a u_k + c: what an `*EQUATION` or a tie comes to.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearConstraint {
    /// The dof that gives up its own motion.
    pub dependent: (NodeIndex, Dof),
    /// What it follows, with coefficients [1, L or 1/L].
    pub terms: Vec<(NodeIndex, Dof, f64)>,
    /// What is added [L or 1].
    pub constant: f64,
    /// Where it was said.
    pub origin: Span,
}

/// Dofs of a node that move as if welded to another one by a rigid bar: `*RIGID BODY`, `*MPC` of
/// type BEAM, `*KINEMATIC`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidLink {
    /// The node that gives up dofs.
    pub dependent: NodeIndex,
    /// The node it follows.
    pub master: NodeIndex,
    /// Which of its six dofs follow.
    pub follows: [bool; 6],
    /// `ROT NODE`: the node whose displacements are the rotation of the master.
    pub turn: Option<NodeIndex>,
    /// Where it was said.
    pub origin: Span,
}

impl RigidLink {
    /// All dofs of a node follow.
    pub const WELDED: [bool; 6] = [true; 6];
    /// Its displacements follow, it turns by itself.
    pub const PINNED: [bool; 6] = [true, true, true, false, false, false];

    /// A node that follows another with all its dofs.
    pub fn welded(dependent: NodeIndex, master: NodeIndex, origin: Span) -> Self {
        Self { dependent, master, follows: Self::WELDED, turn: None, origin }
    }
}

/// A named set of nodes.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct NodeSet {
    /// Name, upper case.
    pub name: String,
    /// Members in the order in which they joined, each once.
    pub members: Vec<NodeIndex>,
    /// Where it was first defined.
    pub origin: Span,
}
