//! Fields on nodes.

use slideline_model::{Dof, NodeIndex, NodeVariable};
use slideline_solve::observe::Frame;

/// A field on nodes, as decks ask for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NodeField {
    /// U: displacements [L] and rotations [1].
    Motion,
    /// RF: forces [F] and moments [F L] of supports on the model.
    Reaction,
    /// CF: applied forces [F] and moments [F L].
    Load,
    /// COORD: current coordinates [L].
    Coordinate,
    /// NT: temperature [theta], no vector.
    Temperature,
}

impl From<NodeVariable> for NodeField {
    fn from(variable: NodeVariable) -> Self {
        match variable {
            NodeVariable::U => Self::Motion,
            NodeVariable::RF => Self::Reaction,
            NodeVariable::CF => Self::Load,
            NodeVariable::COORD => Self::Coordinate,
            NodeVariable::NT => Self::Temperature,
        }
    }
}

impl NodeField {
    /// All fields.
    pub const ALL: [Self; 5] =
        [Self::Motion, Self::Reaction, Self::Load, Self::Coordinate, Self::Temperature];

    /// Name, as decks ask for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Motion => "U",
            Self::Reaction => "RF",
            Self::Load => "CF",
            Self::Coordinate => "COORD",
            Self::Temperature => "NT",
        }
    }

    /// Its values along some dofs at all nodes, node by node.
    pub fn table(self, frame: &Frame<'_>, dofs: &[Dof]) -> Vec<f64> {
        let nodes = &frame.model.nodes;
        let mut table = vec![0.0; dofs.len() * nodes.len()];
        for (node, dof, [displacement, reaction, load]) in frame.nodal.all() {
            if let Some(column) = dofs.iter().position(|own| *own == dof) {
                table[dofs.len() * node + column] = match self {
                    Self::Motion | Self::Coordinate => displacement,
                    Self::Reaction => reaction,
                    Self::Load => load,
                    Self::Temperature => frame.nodal.temperature(node),
                };
            }
        }
        if self == Self::Coordinate {
            for (row, node) in table.chunks_exact_mut(dofs.len()).zip(nodes.iter()) {
                let still = dofs.iter().map(|dof| node.position[dof.number() - 1]);
                row.iter_mut().zip(still).for_each(|(moved, still)| *moved += still);
            }
        }
        table
    }

    /// Its components along some dofs; a coordinate has none along a rotation, a temperature one in
    /// all.
    pub fn components(self, dofs: &[Dof]) -> impl Iterator<Item = NodeComponent> {
        let first = dofs.first().copied();
        let has = move |dof: &Dof| match self {
            Self::Coordinate => !dof.is_rotation(),
            Self::Temperature => Some(*dof) == first,
            _ => true,
        };
        dofs.iter().copied().filter(has).map(move |dof| NodeComponent { field: self, dof })
    }
}

/// A component of a field on nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NodeComponent {
    /// The field.
    pub field: NodeField,
    /// The dof it belongs to.
    pub dof: Dof,
}

impl NodeComponent {
    /// Name, such as `U2`, `RM3`, `COOR1`.
    pub fn name(self) -> &'static str {
        let own = |names: [&'static str; 6]| names[self.dof.number() - 1];
        match self.field {
            NodeField::Motion => self.dof.name(),
            NodeField::Reaction => self.dof.reaction_name(),
            NodeField::Load => own(["CF1", "CF2", "CF3", "CM1", "CM2", "CM3"]),
            NodeField::Coordinate => own(["COOR1", "COOR2", "COOR3", "", "", ""]),
            NodeField::Temperature => "NT11",
        }
    }

    /// Unit tag.
    pub fn unit(self) -> &'static str {
        match (self.field, self.dof.is_rotation()) {
            (NodeField::Temperature, _) => "[theta]",
            (NodeField::Motion, true) => "[1]",
            (NodeField::Motion | NodeField::Coordinate, _) => "[L]",
            (NodeField::Reaction | NodeField::Load, true) => "[F L]",
            (NodeField::Reaction | NodeField::Load, false) => "[F]",
        }
    }

    /// Its value at a node along the axis in which the deck names the dof, that of the node where
    /// it has axes of its own; coordinates and temperatures are those of the model.
    pub fn named_value(self, frame: &Frame<'_>, node: NodeIndex) -> f64 {
        let [displacement, reaction, load] = frame.nodal.named(node, self.dof);
        match self.field {
            NodeField::Motion => displacement,
            NodeField::Reaction => reaction,
            NodeField::Load => load,
            NodeField::Coordinate | NodeField::Temperature => self.value(frame, node),
        }
    }

    /// Its value at a node along an axis of the model.
    pub fn value(self, frame: &Frame<'_>, node: NodeIndex) -> f64 {
        let (nodal, dof) = (&frame.nodal, self.dof);
        match self.field {
            NodeField::Motion => nodal.displacement(node, dof),
            NodeField::Reaction => nodal.reaction(node, dof),
            NodeField::Load => nodal.load(node, dof),
            NodeField::Temperature => nodal.temperature(node),
            NodeField::Coordinate => {
                let still = frame.model.nodes.get(node).position;
                still[dof.number() - 1] + nodal.displacement(node, dof)
            }
        }
    }
}

/// Where a node is now, in all three directions [L].
pub fn place(frame: &Frame<'_>, node: NodeIndex) -> [f64; 3] {
    let still = frame.model.nodes.position(node);
    let moved = |axis| frame.nodal.displacement(node, [Dof::U1, Dof::U2, Dof::U3][axis]);
    std::array::from_fn(|axis| still[axis] + moved(axis))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: names and units are those of docs/files.md.
    #[test]
    fn components_are_named_as_decks_name_them() {
        let of = |field: NodeField| -> Vec<(&str, &str)> {
            field.components(&Dof::PLANE).map(|own| (own.name(), own.unit())).collect()
        };
        assert_eq!(of(NodeField::Motion), [("U1", "[L]"), ("U2", "[L]"), ("UR3", "[1]")]);
        assert_eq!(of(NodeField::Reaction), [("RF1", "[F]"), ("RF2", "[F]"), ("RM3", "[F L]")]);
        assert_eq!(of(NodeField::Load), [("CF1", "[F]"), ("CF2", "[F]"), ("CM3", "[F L]")]);
        assert_eq!(of(NodeField::Coordinate), [("COOR1", "[L]"), ("COOR2", "[L]")]);
        assert_eq!(of(NodeField::Temperature), [("NT11", "[theta]")]);
        for field in NodeField::ALL {
            let names: Vec<&str> = field.components(&Dof::ALL).map(NodeComponent::name).collect();
            assert!(names.iter().all(|name| !name.is_empty()), "{}", field.name());
        }
    }
}
