//! Elements in blocks of one type and one section.
//!
//! ```text
//!   block:  type (a row of the table)   section   elements: label, nodes, deck line
//! ```

use super::element_type::{ElementType, Kinematics};
use super::section::{BeamSection, Section, SpringSection, SpringWay};
use crate::node::{Dof, NodeIndex};
use slideline_diag::Span;
use slideline_mech::axes::Axes;
use slideline_mech::element::solid;

/// Elements that share type and section: the solver dispatches once a block.
#[derive(Clone, Debug, PartialEq)]
pub struct ElementBlock {
    /// What kind of element it is.
    pub kind: &'static ElementType,
    /// Name of the element set that the section was given to.
    pub name: String,
    /// Section and material.
    pub section: Section,
    /// Elements in order of definition.
    pub elements: Elements,
    /// The section's card.
    pub origin: Span,
}

impl ElementBlock {
    /// A block without elements.
    pub fn new(kind: &'static ElementType, name: &str, section: Section, origin: Span) -> Self {
        let elements = Elements::new(kind.cell.nodes);
        Self { kind, name: name.to_owned(), section, elements, origin }
    }

    /// The same with elements: label and nodes of each, all from one place of the deck.
    pub fn with<N: AsRef<[NodeIndex]>>(
        mut self,
        elements: impl IntoIterator<Item = (u64, N)>,
    ) -> Self {
        for (label, nodes) in elements {
            self.elements.push(label, nodes.as_ref(), self.origin);
        }
        self
    }

    /// Number of state variables of an element.
    pub fn states(&self) -> usize {
        (self.kind.states)(&self.section)
    }

    /// Whether the way to a state is part of it: what is stored of a state is more than a first
    /// guess at the next one, as the thickness of a sheet is.
    pub fn remembers(&self) -> bool {
        match &self.section {
            Section::Solid(section) => section.material.states() > 0,
            _ => self.states() > 0,
        }
    }

    /// Number of state variables of an integration point; those of the element as a whole stand
    /// behind those of its points.
    pub fn point_states(&self) -> usize {
        let plane_stress = solid::Kinematics::PlaneStress;
        match (&self.section, self.kind.kinematics) {
            (Section::Solid(section), Kinematics::Truss) => section.material.uniaxial_states(),
            (Section::Solid(section), Kinematics::Solid { strains, .. }) => {
                section.material.states() + usize::from(strains == plane_stress)
            }
            _ => 0,
        }
    }

    /// The type in a deck's words.
    pub fn word(&self) -> &'static str {
        self.kind.name()
    }

    /// Dofs of every node that an element moves with.
    pub fn dofs(&self) -> &'static [Dof] {
        match &self.section {
            Section::Spring(SpringSection { way: SpringWay::Dof(dof), .. }) => dof.alone(),
            Section::Spring(section) if section.way.is_in_space() => &[Dof::U1, Dof::U2, Dof::U3],
            _ => self.kind.dofs,
        }
    }

    /// Axes of the material at the integration points of an element, by its place, on the
    /// undeformed positions of its nodes [L]; none where they are those of the model.
    pub fn axes_at_points(&self, element: usize, nodes: &[[f64; 3]]) -> Vec<Axes> {
        let (Section::Solid(section), Kinematics::Solid { rule, .. }) =
            (&self.section, self.kind.kinematics)
        else {
            return Vec::new();
        };
        let all = section.orientation.as_ref();
        let Some(orientation) = all.and_then(|all| all.of(element)) else { return Vec::new() };
        let mut shapes = vec![0.0; nodes.len()];
        let mut at = |place: &[f64; 3]| {
            (self.kind.cell.shapes)(place, &mut shapes);
            let point = std::array::from_fn(|k| {
                nodes.iter().zip(&shapes).map(|(node, shape)| shape * node[k]).sum()
            });
            orientation.at(nodes, point)
        };
        rule.points.iter().map(&mut at).collect()
    }

    /// Whether its dofs are those along the own axes of its nodes: springs on one dof.
    pub fn acts_along_own_axes(&self) -> bool {
        matches!(&self.section, Section::Spring(SpringSection { way: SpringWay::Dof(_), .. }))
    }

    /// The beams in the plane, of whatever type; `None`: other elements.
    pub fn beams(&self) -> Option<Beams<'_>> {
        match &self.section {
            Section::Beam(section) if self.kind.is_beam() => Some(Beams {
                name: &self.name,
                section,
                elements: &self.elements,
                origin: self.origin,
            }),
            _ => None,
        }
    }

    /// The springs, of whatever type; `None`: other elements.
    pub fn springs(&self) -> Option<Springs<'_>> {
        match &self.section {
            Section::Spring(section) => {
                Some(Springs { name: &self.name, section, elements: &self.elements })
            }
            _ => None,
        }
    }
}

/// A block of beams.
#[derive(Clone, Copy, Debug)]
pub struct Beams<'a> {
    /// Name of the element set that the section was given to.
    pub name: &'a str,
    /// Section and material.
    pub section: &'a BeamSection,
    /// Elements in order of definition.
    pub elements: &'a Elements,
    /// The section's card.
    pub origin: Span,
}

/// A block of springs.
#[derive(Clone, Copy, Debug)]
pub struct Springs<'a> {
    /// Name of the element set.
    pub name: &'a str,
    /// Stiffness and dof.
    pub section: &'a SpringSection,
    /// Elements in order of definition.
    pub elements: &'a Elements,
}

/// Elements of one number of nodes, in order of definition.
#[derive(Clone, Debug, PartialEq)]
pub struct Elements {
    /// Nodes of an element, at least one.
    width: usize,
    /// Label of each, and where it was defined.
    named: Vec<(u64, Span)>,
    /// Nodes of all of them, one element after the other.
    nodes: Vec<NodeIndex>,
}

impl Elements {
    /// None yet, of so many nodes each.
    pub fn new(nodes: usize) -> Self {
        Self { width: nodes.max(1), named: Vec::new(), nodes: Vec::new() }
    }

    /// Takes an element in. Nodes that are missing are its last one again; more
    /// than it has are left out.
    pub fn push(&mut self, label: u64, nodes: &[NodeIndex], origin: Span) {
        let Some(&last) = nodes.last() else { return };
        self.named.push((label, origin));
        let end = self.nodes.len() + self.width;
        self.nodes.extend_from_slice(&nodes[..nodes.len().min(self.width)]);
        self.nodes.resize(end, last);
    }

    /// The label of each, to be changed.
    pub fn labels_mut(&mut self) -> impl Iterator<Item = &mut u64> {
        self.named.iter_mut().map(|(label, _)| label)
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.named.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.named.is_empty()
    }

    /// The element at that index of the block.
    ///
    /// Panics only for an index that this block never gave out.
    pub fn get(&self, index: usize) -> Element<'_> {
        let (label, origin) = self.named[index];
        let nodes = &self.nodes[self.width * index..self.width * (index + 1)];
        Element { label, nodes, origin }
    }

    /// All of them.
    pub fn iter(&self) -> ElementIter<'_> {
        self.into_iter()
    }
}

impl<'a> IntoIterator for &'a Elements {
    type Item = Element<'a>;
    type IntoIter = ElementIter<'a>;

    fn into_iter(self) -> Self::IntoIter {
        ElementIter { named: self.named.iter(), nodes: self.nodes.chunks_exact(self.width) }
    }
}

/// The elements of a block, one after the other.
#[derive(Clone, Debug)]
pub struct ElementIter<'a> {
    named: std::slice::Iter<'a, (u64, Span)>,
    nodes: std::slice::ChunksExact<'a, NodeIndex>,
}

impl<'a> Iterator for ElementIter<'a> {
    type Item = Element<'a>;

    fn next(&mut self) -> Option<Element<'a>> {
        let (&(label, origin), nodes) = self.named.next().zip(self.nodes.next())?;
        Some(Element { label, nodes, origin })
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.named.size_hint()
    }
}

impl ExactSizeIterator for ElementIter<'_> {}

/// An element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Element<'a> {
    /// Its number in the deck.
    pub label: u64,
    /// Its nodes, in the order of the deck.
    pub nodes: &'a [NodeIndex],
    /// Where it was defined.
    pub origin: Span,
}

impl Element<'_> {
    /// First and last node: the ends of a line; of a spring to the ground twice
    /// its node.
    pub fn ends(&self) -> [NodeIndex; 2] {
        [self.nodes[0], self.nodes[self.nodes.len() - 1]]
    }
}

/// What the material of a beam section may be strained to. It changes no
/// result: margin and verdict are held against it.
#[derive(Clone, Debug, PartialEq)]
pub struct Allowable {
    /// Index of the block.
    pub block: usize,
    /// What it allows.
    pub limit: Limit,
    /// Where it was defined.
    pub origin: Span,
}

/// What a material allows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    /// A strain [1]: of a fibre of a beam, principal in a solid.
    Strain(f64),
    /// A stress [F/L2]: Young's modulus times the strain of a fibre of a beam, that of Mises in a
    /// solid.
    Stress(f64),
}
