//! The model's elements take their places.

use super::element::{Placed, Shape};
use super::{BeamReport, Structure};
use crate::layout::{Carried, Layout};
use slideline_mech::element::{AxialSpring, Beam21, Beam22, Beam23, GroundSpring};
use slideline_mech::rigid::{Attachment, PointMap};
use slideline_mech::section::{Rectangle, TransverseShear, rectangle_stiffness};
use slideline_model::{
    BeamBlock, BeamElement, Dof, ElementBlock, Model, NodeIndex, SpringBlock, SpringKind,
};

/// How an element is made of its section and its undeformed positions: the
/// shape, its EA/l [F/L] and l [L] (between neighbouring nodes).
type Make = fn(&BeamBlock, &[Carried]) -> (Shape, f64, f64);

impl Structure {
    /// Places every element that is not rigid as a whole.
    pub fn new(model: &Model, layout: &Layout, nlgeom: bool) -> Self {
        let mut structure = Self {
            elements: Vec::new(),
            own: Vec::new(),
            targets: Vec::new(),
            entries: Vec::new(),
            beams: Vec::new(),
            nlgeom,
            stresses: 0,
            stiffest: 0.0,
            stiffest_length: 0.0,
        };
        for block in &model.blocks {
            match block {
                ElementBlock::B21(block) => structure.place_beams(model, layout, block, beam21),
                ElementBlock::B22(block) => structure.place_beams(model, layout, block, beam22),
                ElementBlock::B23(block) => structure.place_beams(model, layout, block, beam23),
                ElementBlock::Spring(block) => structure.place_springs(model, layout, block),
            }
        }
        structure
    }

    fn place_beams(&mut self, model: &Model, layout: &Layout, block: &BeamBlock, make: Make) {
        for element in &block.elements {
            let nodes: Vec<NodeIndex> = BeamElement::all_nodes(element).collect();
            let points: Vec<Carried> =
                nodes.iter().map(|&node| layout.carried_node(model, node)).collect();
            if points.iter().all(|point| point.node == points[0].node) {
                continue; // all of it belongs to one rigid body: nothing to strain
            }
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
            self.place(layout, shape, (&nodes, &points), &Dof::PLANE);
        }
    }

    fn place_springs(&mut self, model: &Model, layout: &Layout, block: &SpringBlock) {
        let stiffness = block.stiffness;
        self.stiffest = self.stiffest.max(stiffness.abs());
        for element in &block.elements {
            let ends = element.nodes.map(|node| layout.carried_node(model, node));
            match block.kind {
                SpringKind::Ground(dof) => {
                    let dofs: &[Dof] =
                        if dof.is_rotation() { &[Dof::UR3] } else { &[Dof::U1, Dof::U2] };
                    let component = dofs.iter().position(|&own| own == dof).unwrap_or(0);
                    let shape = Shape::Ground(GroundSpring { stiffness }, component);
                    self.place(layout, shape, (&element.nodes[..1], &ends[..1]), dofs);
                }
                SpringKind::Axial => {
                    let reference = ends.map(|end| end.reference);
                    let shape = Shape::Axial(AxialSpring { reference, stiffness });
                    self.place(layout, shape, (&element.nodes, &ends), &[Dof::U1, Dof::U2]);
                }
            }
        }
    }

    /// Appends an element that acts on `dofs` of its nodes.
    fn place(
        &mut self,
        layout: &Layout,
        shape: Shape,
        (nodes, points): (&[NodeIndex], &[Carried]),
        dofs: &[Dof],
    ) {
        let (first_own, first_target) = (self.own.len(), self.targets.len());
        let mut attachments = Vec::new();
        let dependent = points.iter().any(|point| matches!(point.map, PointMap::Arm { .. }));
        let carrier_dofs = if dependent { layout.dofs } else { dofs };
        for (&node, point) in nodes.iter().zip(points) {
            if dependent {
                attachments.extend(attach(dofs, point.map, self.targets.len() - first_target));
            }
            self.own.extend(dofs.iter().filter_map(|&dof| layout.slot(node, dof)));
            let carrier = carrier_dofs.iter().filter_map(|&dof| layout.slot(point.node, dof));
            self.targets.extend(carrier);
        }
        let (variables, width) = (self.own.len() - first_own, self.targets.len() - first_target);
        let first_entry = self.entries.len();
        self.entries.resize(first_entry + width * width, usize::MAX);
        let first_stress = self.stresses;
        self.stresses += shape.stresses();
        self.elements.push(Placed {
            shape,
            variables,
            first_own,
            width,
            first_target,
            first_entry,
            first_stress,
            attachments,
        });
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

fn beam21(block: &BeamBlock, points: &[Carried]) -> (Shape, f64, f64) {
    let (rectangle, shear) = rules(block);
    let reference = [points[0].reference, points[1].reference];
    let length = distance(reference[0], reference[1]);
    let stiffness = rectangle_stiffness(&rectangle, &block.section.material, &shear, length);
    (Shape::Beam21(Beam21::new(reference, stiffness)), stiffness.axial / length, length)
}

fn beam22(block: &BeamBlock, points: &[Carried]) -> (Shape, f64, f64) {
    let (rectangle, shear) = rules(block);
    let reference = [0, 1, 2].map(|node| points[node.min(points.len() - 1)].reference);
    let length = distance(reference[0], reference[1]) + distance(reference[1], reference[2]);
    let shear = shear.second_order();
    let stiffness = rectangle_stiffness(&rectangle, &block.section.material, &shear, length);
    let shape = Shape::Beam22(Box::new(Beam22::new(reference, stiffness)));
    let half = 0.5 * length;
    (shape, stiffness.axial / half, half)
}

fn beam23(block: &BeamBlock, points: &[Carried]) -> (Shape, f64, f64) {
    let (rectangle, shear) = rules(block);
    let reference = [points[0].reference, points[1].reference];
    let length = distance(reference[0], reference[1]);
    let stiffness = rectangle_stiffness(&rectangle, &block.section.material, &shear, length);
    (Shape::Beam23(Beam23::new(reference, stiffness)), stiffness.axial / length, length)
}

/// How the variables `dofs` of a node follow the dofs of its carrier, the
/// first of which stands at `first`.
fn attach(dofs: &[Dof], map: PointMap, first: usize) -> Vec<Attachment> {
    let point = dofs.contains(&Dof::U1).then_some(Attachment::Point { map, first });
    let rotation = dofs.contains(&Dof::UR3).then_some(Attachment::Rotation { dof: first + 2 });
    point.into_iter().chain(rotation).collect()
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}
