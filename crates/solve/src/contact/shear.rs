//! The shear angles of the beams about a segment, by dofs.

use crate::dofs::{DofMap, rigid_dofs};
use slideline_mech::contact::points::slopes::{MOST_SLOPE_DOFS, ShearSlopes, ShearedBeam};
use slideline_model::{Element, Kinematics, Model, NodeIndex};
use std::collections::HashMap;

/// Places of the ends' turns among the dofs of a segment.
pub const TURNS: [usize; 2] = [2, 5];
/// Dofs of a segment and of the rigid body that it faces, before those that
/// shear alone follows.
const DIRECT: usize = 9;

/// What turns the tangents of a segment beyond its nodes.
#[derive(Clone, Debug)]
pub struct Shear {
    /// The turning, by local numbers: 0 to 5 the segment's dofs, from 9 on the
    /// further ones.
    slopes: ShearSlopes,
    /// Ends of its beams.
    ends: [Option<[NodeIndex; 2]>; 3],
    /// Dofs beyond those of the segment and of the body that it faces.
    pub further: Vec<usize>,
}

/// Shear-flexible beams by their nodes.
pub type ShearedBeams<'a> = HashMap<NodeIndex, Vec<Element<'a>>>;

/// The beams of a model whose chords turn beyond their sections. A shear-rigid
/// beam's do so by bending.
pub fn sheared_beams(model: &Model) -> ShearedBeams<'_> {
    let mut beams = ShearedBeams::new();
    for block in &model.blocks {
        let sheared = block.kind.kinematics == Kinematics::Beam { sheared: true };
        if sheared && block.kind.cell.nodes == 3 {
            for beam in &block.elements {
                beam.ends().iter().for_each(|node| beams.entry(*node).or_default().push(beam));
            }
        }
    }
    beams
}

impl Shear {
    /// Shear about the element between two nodes; `None` where no beam of
    /// its own is shear-flexible.
    pub fn new(
        model: &Model,
        dofs: &DofMap,
        nodes: [NodeIndex; 2],
        beams: &ShearedBeams<'_>,
    ) -> Option<Self> {
        let is_own = |beam: &&Element<'_>| nodes.iter().all(|node| beam.ends().contains(node));
        let own = *beams.get(&nodes[0])?.iter().find(is_own)?;
        // Where more than two beams meet, none is the next one.
        let next = |node: NodeIndex| match beams[&node][..] {
            [a, b] => Some(if a == own { b } else { a }),
            _ => None,
        };
        let mut places = Places { dofs, nodes, further: Vec::new() };
        let [left, right] = nodes.map(next);
        let about = [left, Some(own), right];
        let ends = about.map(|beam| Some(beam?.ends()));
        let beams = about.map(|beam| Some(places.sheared(model, beam?)));
        Some(Self { slopes: ShearSlopes { beams }, ends, further: places.further })
    }

    /// Takes the positions of a model with the same beams.
    pub fn take(&mut self, model: &Model) {
        for (beam, ends) in self.slopes.beams.iter_mut().zip(self.ends) {
            if let (Some(beam), Some(ends)) = (beam, ends) {
                let [a, b] = ends.map(|node| model.nodes.get(node).position);
                beam.chord = [b[0] - a[0], b[1] - a[1]];
            }
        }
    }

    /// The rotation of the middle node of its own beam, where that has one.
    pub fn middle(&self) -> Option<usize> {
        let [.., (middle, _), _] = self.slopes.beams[1]?.rotations;
        Some(self.further[middle.checked_sub(DIRECT)?])
    }

    fn values(&self, dofs: &[usize], u: &[f64]) -> [f64; MOST_SLOPE_DOFS] {
        let mut values = [0.0; MOST_SLOPE_DOFS];
        for (value, &dof) in values.iter_mut().zip(&dofs[..6]) {
            *value = u[dof];
        }
        for (value, &dof) in values[DIRECT..].iter_mut().zip(&self.further) {
            *value = u[dof];
        }
        values
    }

    /// Turns of both ends beyond their rotations [rad]; `dofs` begin with the
    /// segment's.
    pub fn turns(&self, dofs: &[usize], u: &[f64]) -> [f64; 2] {
        let values = self.values(dofs, u);
        [0, 1].map(|end| self.slopes.turn(end, &values))
    }

    /// Their derivatives by all dofs.
    pub fn gradients(&self, dofs: &[usize], u: &[f64]) -> [[f64; MOST_SLOPE_DOFS]; 2] {
        let values = self.values(dofs, u);
        [0, 1].map(|end| self.slopes.gradient(end, &values))
    }

    /// Tangent by all dofs from force and tangent by the direct ones, the
    /// ends' turns among them.
    pub fn push_tangent(
        &self,
        (dofs, u): (&[usize], &[f64]),
        force: &[f64],
        (direct, n): (&[f64], usize),
        tangent: &mut [f64],
    ) {
        let (m, values) = (dofs.len(), self.values(dofs, u));
        for (row, from) in tangent.chunks_exact_mut(m).zip(direct.chunks_exact(n).take(n)) {
            row[..n].copy_from_slice(from);
        }
        let gradients = self.gradients(dofs, u);
        for (&turn, gradient) in TURNS.iter().zip(&gradients) {
            // By one turn and one dof, and back.
            for j in 0..n {
                let (across, along) = (direct[j * n + turn], direct[turn * n + j]);
                for (k, g) in gradient[..m].iter().enumerate() {
                    tangent[j * m + k] += across * g;
                    tangent[k * m + j] += along * g;
                }
            }
            for (&other, other_gradient) in TURNS.iter().zip(&gradients) {
                let both = direct[turn * n + other];
                for (i, g) in gradient[..m].iter().enumerate() {
                    for (k, h) in other_gradient[..m].iter().enumerate() {
                        tangent[i * m + k] += both * g * h;
                    }
                }
            }
        }
        for (end, turn) in TURNS.into_iter().enumerate() {
            self.slopes.add_hessian(end, &values, force[turn], (&mut *tangent, m));
        }
    }
}

/// Local numbers of the dofs about a segment.
struct Places<'a> {
    dofs: &'a DofMap,
    nodes: [NodeIndex; 2],
    further: Vec<usize>,
}

impl Places<'_> {
    fn sheared(&mut self, model: &Model, beam: Element<'_>) -> ShearedBeam {
        let [a, b] = beam.ends().map(|node| model.nodes.get(node).position);
        let ends = beam.ends().map(|node| self.node(node));
        let rotations = match *beam.nodes {
            // Simpson's rule, as exact as the element's own two points.
            [_, middle, _] => {
                let middle = self.further(rigid_dofs(self.dofs, middle)[2]);
                [(ends[0] + 2, 1.0 / 6.0), (middle, 4.0 / 6.0), (ends[1] + 2, 1.0 / 6.0)]
            }
            _ => [(ends[0] + 2, 0.5), (ends[1] + 2, 0.5), (ends[1] + 2, 0.0)],
        };
        ShearedBeam { chord: [b[0] - a[0], b[1] - a[1]], ends, rotations }
    }

    /// First local number of a node's three dofs.
    fn node(&mut self, node: NodeIndex) -> usize {
        match self.nodes.iter().position(|&own| own == node) {
            Some(own) => 3 * own,
            None => {
                let [x, y, turn] = rigid_dofs(self.dofs, node);
                let first = self.further(x);
                self.further(y);
                self.further(turn);
                first
            }
        }
    }

    fn further(&mut self, dof: usize) -> usize {
        self.further.push(dof);
        DIRECT + self.further.len() - 1
    }
}
