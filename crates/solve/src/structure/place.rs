//! The model's elements take their places.

use super::element::{Placed, Shape};
use super::{BeamReport, Structure};
use crate::constraints::Constraints;
use crate::dofs::DofMap;
use slideline_mech::element::{AxialSpring, Beam21, Beam22, Beam23, GroundSpring};
use slideline_mech::section::{Rectangle, TransverseShear, rectangle_stiffness};
use slideline_model::{
    BeamBlock, BeamElement, Dof, ElementBlock, Model, NodeIndex, SpringBlock, SpringKind,
};

/// How an element is made of its section and its undeformed positions: the
/// shape, its EA/l [F/L] and l [L] (between neighbouring nodes).
type Make = fn(&BeamBlock, &[[f64; 2]]) -> (Shape, f64, f64);

/// Where elements act: dofs and constraints.
type Numbering<'a> = (&'a DofMap, &'a Constraints);

impl Structure {
    /// Places every element that is not rigid as a whole.
    pub fn new(model: &Model, numbering: Numbering<'_>, nlgeom: bool) -> Self {
        let mut structure = Self {
            elements: Vec::new(),
            own: Vec::new(),
            entries: Vec::new(),
            dependent: Vec::new(),
            beams: Vec::new(),
            nlgeom,
            stresses: 0,
            stiffest: 0.0,
            stiffest_length: 0.0,
        };
        for block in &model.blocks {
            match block {
                ElementBlock::B21(block) => structure.place_beams(model, numbering, block, beam21),
                ElementBlock::B22(block) => structure.place_beams(model, numbering, block, beam22),
                ElementBlock::B23(block) => structure.place_beams(model, numbering, block, beam23),
                ElementBlock::Spring(block) => structure.place_springs(model, numbering, block),
            }
        }
        structure
    }

    fn place_beams(
        &mut self,
        model: &Model,
        numbering: Numbering<'_>,
        block: &BeamBlock,
        make: Make,
    ) {
        for element in &block.elements {
            let nodes: Vec<NodeIndex> = BeamElement::all_nodes(element).collect();
            let carrier = |node: &NodeIndex| numbering.1.carrier(*node);
            if nodes.iter().all(|node| carrier(node) == carrier(&nodes[0])) {
                continue; // all of it belongs to one rigid body: nothing to strain
            }
            let points: Vec<_> = nodes.iter().map(|&node| model.nodes.plane(node)).collect();
            let (shape, axial, length) = make(block, &points);
            if axial > self.stiffest {
                (self.stiffest, self.stiffest_length) = (axial, length);
            }
            self.beams.push(BeamReport {
                element: self.elements.len(),
                label: element.label,
                nodes: element.nodes,
                half_height: 0.5 * block.section.height,
            });
            self.place(numbering, shape, &nodes, &[Dof::U1, Dof::U2, Dof::UR3]);
        }
    }

    fn place_springs(&mut self, model: &Model, numbering: Numbering<'_>, block: &SpringBlock) {
        let stiffness = block.stiffness;
        self.stiffest = self.stiffest.max(stiffness.abs());
        for element in &block.elements {
            match block.kind {
                SpringKind::Ground(dof) => {
                    let dofs: &[Dof] =
                        if dof.is_rotation() { &[Dof::UR3] } else { &[Dof::U1, Dof::U2] };
                    let component = dofs.iter().position(|&own| own == dof).unwrap_or(0);
                    let shape = Shape::Ground(GroundSpring { stiffness }, component);
                    self.place(numbering, shape, &element.nodes[..1], dofs);
                }
                SpringKind::Axial => {
                    let reference = element.nodes.map(|node| model.nodes.plane(node));
                    let shape = Shape::Axial(AxialSpring { reference, stiffness });
                    self.place(numbering, shape, &element.nodes, &[Dof::U1, Dof::U2]);
                }
            }
        }
    }

    /// Appends an element that acts on `kinds` of its nodes' dofs.
    fn place(
        &mut self,
        (dofs, constraints): Numbering<'_>,
        shape: Shape,
        nodes: &[NodeIndex],
        kinds: &[Dof],
    ) {
        let (first_own, first_entry) = (self.own.len(), self.entries.len());
        for &node in nodes {
            self.own.extend(kinds.iter().filter_map(|&kind| dofs.find(node, kind)));
        }
        let variables = self.own.len() - first_own;
        if self.own[first_own..].iter().any(|&dof| constraints.is_dependent(dof)) {
            self.dependent.push(self.elements.len());
        }
        self.entries.resize(first_entry + variables * variables, usize::MAX);
        let first_stress = self.stresses;
        self.stresses += shape.stresses();
        self.elements.push(Placed { shape, variables, first_own, first_entry, first_stress });
    }
}

fn rules(block: &BeamBlock) -> (Rectangle, TransverseShear) {
    let section = &block.section;
    let rectangle =
        Rectangle { width: section.width, height: section.height, poisson: section.poisson };
    let shear = TransverseShear {
        slenderness: section.shear.slenderness_compensation,
        given: section.shear.stiffness,
        ..TransverseShear::default()
    };
    (rectangle, shear)
}

fn beam21(block: &BeamBlock, points: &[[f64; 2]]) -> (Shape, f64, f64) {
    let (rectangle, shear) = rules(block);
    let reference = [points[0], points[1]];
    let length = distance(reference[0], reference[1]);
    let stiffness = rectangle_stiffness(&rectangle, &block.section.material, &shear, length);
    (Shape::Beam21(Beam21::new(reference, stiffness)), stiffness.axial / length, length)
}

fn beam22(block: &BeamBlock, points: &[[f64; 2]]) -> (Shape, f64, f64) {
    let (rectangle, shear) = rules(block);
    let reference = [0, 1, 2].map(|node| points[node.min(points.len() - 1)]);
    let length = distance(reference[0], reference[1]) + distance(reference[1], reference[2]);
    let shear = shear.second_order();
    let stiffness = rectangle_stiffness(&rectangle, &block.section.material, &shear, length);
    let shape = Shape::Beam22(Box::new(Beam22::new(reference, stiffness)));
    let half = 0.5 * length;
    (shape, stiffness.axial / half, half)
}

fn beam23(block: &BeamBlock, points: &[[f64; 2]]) -> (Shape, f64, f64) {
    let (rectangle, shear) = rules(block);
    let reference = [points[0], points[1]];
    let length = distance(reference[0], reference[1]);
    let stiffness = rectangle_stiffness(&rectangle, &block.section.material, &shear, length);
    (Shape::Beam23(Beam23::new(reference, stiffness)), stiffness.axial / length, length)
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}
