//! Stresses over the height of a beam's section.
//!
//! ```text
//!     5 o-------   y = +height/2, on the side of the normal that stands
//!     4 o          90 degrees counter-clockwise of the beam's direction
//!     3 o  -> direction
//!     2 o
//!     1 o-------   y = -height/2
//! ```

use slideline_model::{
    BeamSection, Dof, Element, ElementBlock, Model, NodeIndex, SECTION_POINTS, Section, types,
};
use slideline_solve::observe::{BeamRow, Frame};
use std::collections::BTreeMap;

/// Axial stress at the section points [F/L2]: N/A - y M/I, y from the centroid. A positive moment
/// turns the beam counter-clockwise along its way, which shortens the fibres
/// on the side of the normal. Derived: plane sections. The points are evenly spaced over the
/// height of the section.
pub(crate) fn axial_stresses(
    [force, moment]: [f64; 2],
    section: &BeamSection,
) -> [f64; SECTION_POINTS] {
    let shape = &section.shape;
    let (bottom, height) = (shape.bottom(), shape.height());
    [0.0, 0.25, 0.5, 0.75, 1.0]
        .map(|place| shape.stress_in_plane([force, moment], bottom + place * height))
}

/// Mises stress of the outer fibres [F/L2], where the shear stress of a
/// section is zero: the larger |S11|.
pub(crate) fn outer_mises(stresses: &[f64; SECTION_POINTS]) -> f64 {
    stresses[0].abs().max(stresses[SECTION_POINTS - 1].abs())
}

/// Section results of beams at a node: the mean over the beams that meet
/// there, as viewers expect of nodal results.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct NodalSection {
    beams: f64,
    /// Sum of the chords of the beams, as they lie now [L].
    chord: [f64; 2],
    /// Sums of SF1, SF2 [F] and SM1 [F L].
    forces: [f64; 3],
    /// Sums of S11 at the section points [F/L2].
    stresses: [f64; SECTION_POINTS],
}

impl NodalSection {
    /// SF1, SF2 [F] and SM1 [F L].
    pub fn forces(&self) -> [f64; 3] {
        self.forces.map(|sum| sum / self.beams)
    }

    /// S11 at the section points [F/L2].
    pub fn stresses(&self) -> [f64; SECTION_POINTS] {
        self.stresses.map(|sum| sum / self.beams)
    }

    /// The stress of the outer fibre with the larger magnitude, along the
    /// beam: xx, yy, zz, xy, yz, zx [F/L2].
    pub fn tensor(&self) -> [f64; 6] {
        let [first, .., last] = self.stresses();
        let stress = if last.abs() > first.abs() { last } else { first };
        let [x, y] = self.chord;
        let length = x.hypot(y);
        if length == 0.0 {
            return [0.0; 6];
        }
        let [x, y] = [x / length, y / length];
        [stress * x * x, stress * y * y, 0.0, stress * x * y, 0.0, 0.0]
    }
}

/// Section results at the nodes of the beams, in the order of the nodes.
pub(crate) fn nodal_sections(frame: &Frame<'_>) -> BTreeMap<NodeIndex, NodalSection> {
    let place = |node: NodeIndex| {
        let position = frame.model.nodes.position(node);
        let moved = |dof| frame.nodal.displacement(node, dof);
        [position[0] + moved(Dof::U1), position[1] + moved(Dof::U2)]
    };
    let mut found: BTreeMap<NodeIndex, NodalSection> = BTreeMap::new();
    for (row, element, section) in beams(frame) {
        let [from, to] = row.nodes.map(place);
        let stresses = axial_stresses([row.axial_force, row.bending_moment], section);
        let forces = [row.axial_force, row.shear_force, row.bending_moment];
        for &node in element.nodes {
            let sums = found.entry(node).or_default();
            sums.beams += 1.0;
            (0..2).for_each(|axis| sums.chord[axis] += to[axis] - from[axis]);
            sums.forces.iter_mut().zip(forces).for_each(|(sum, force)| *sum += force);
            sums.stresses.iter_mut().zip(stresses).for_each(|(sum, stress)| *sum += stress);
        }
    }
    found
}

/// The beams of a frame with their elements and sections. Beams that belong
/// to one rigid body have no results.
pub(crate) fn beams<'a>(
    frame: &Frame<'a>,
) -> impl Iterator<Item = (&'a BeamRow, Element<'a>, &'a BeamSection)> + use<'a> {
    let blocks = frame.model.blocks.iter().filter_map(|block| block.beams());
    let mut elements =
        blocks.flat_map(|block| block.elements.iter().map(move |element| (element, block.section)));
    frame.beams.iter().filter_map(move |row| {
        let (element, section) = elements.find(|(element, _)| element.label == row.label)?;
        Some((row, element, section))
    })
}

/// A beam in space with its results.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SpaceBeam<'a> {
    /// The element.
    pub element: Element<'a>,
    section: &'a BeamSection,
    /// Values in the order of the fields of its type.
    pub values: &'a [f64],
}

impl SpaceBeam<'_> {
    /// The value of a component of a field.
    pub fn value(&self, field: &str, component: usize) -> f64 {
        let first = types::B31.field(field).map_or(0, |(_, first)| first);
        self.values.get(first + component).copied().unwrap_or_default()
    }

    /// Axial stress at the points of the section [F/L2]: docs/theory.md eq. (3.108).
    pub fn stresses(&self) -> Vec<f64> {
        let forces = [self.value("SF", 0), self.value("SM", 0), self.value("SM", 1)];
        let shape = &self.section.shape;
        shape.points().into_iter().map(|at| shape.stress(forces, at)).collect()
    }

    /// Largest strain of a fibre [1].
    pub fn fibre_strain(&self) -> f64 {
        let strains = [self.value("SE", 0), self.value("SK", 0), self.value("SK", 1)];
        self.section.shape.largest_strain(strains)
    }
}

/// All beams in space of a frame with their results.
pub(crate) fn space_beams<'a>(frame: &'a Frame<'a>) -> impl Iterator<Item = SpaceBeam<'a>> {
    let blocks = frame.elements.iter().filter_map(|results| {
        let block = frame.model.blocks.get(results.block)?;
        Some((results, of_space(block)?))
    });
    blocks.flat_map(|(results, section)| {
        let elements = results.elements(frame.model);
        elements.map(move |(element, values)| SpaceBeam { element, section, values })
    })
}

/// The section of beams in space; `None`: other elements.
fn of_space(block: &ElementBlock) -> Option<&BeamSection> {
    match &block.section {
        Section::Beam(section) if block.kind.is_space_beam() => Some(section),
        _ => None,
    }
}

/// The most points at which stress is told of a beam in space of a model.
pub(crate) fn most_points(model: &Model) -> usize {
    let sections = model.blocks.iter().filter_map(of_space);
    sections.map(|section| section.shape.points().len()).max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideline_model::ShearRule;

    /// Requirement: the stresses have the resultants they come from, N as sum
    /// and M as moment. Source: definition of the resultants; the stress is
    /// linear, so that Simpson's rule over points 1, 3, 5 is exact. Tolerance:
    /// rounding.
    #[test]
    fn stresses_have_the_resultants_of_the_section() {
        let section = BeamSection {
            shape: slideline_model::Shape::Rectangle { width: 2.0, height: 3.0 },
            heat: None,
            poisson: 0.0,
            material: slideline_mech::material::Elastic { modulus: 1.0, poisson: 0.0 },
            shear: ShearRule::default(),
            first_axis: BeamSection::FIRST_AXIS,
        };
        let s = axial_stresses([5.0, -7.0], &section);
        let normal = 2.0 * 3.0 / 6.0 * (s[0] + 4.0 * s[2] + s[4]);
        let moment = -2.0 * 3.0 / 6.0 * (-1.5 * s[0] + 1.5 * s[4]);
        assert!((normal - 5.0).abs() < 1e-13 && (moment + 7.0).abs() < 1e-13);
        assert!((s[1] - 0.5 * (s[0] + s[2])).abs() < 1e-13);
        assert_eq!(outer_mises(&s), s[4]);
    }

    /// Requirement: the tensor is a pull along the beam: its trace is the
    /// outer stress, it has no part across, and its Mises stress is that of
    /// the outer fibres. Tolerance: rounding.
    #[test]
    fn the_tensor_is_a_pull_along_the_beam() {
        let stresses = [6.0, 0.0, 0.0, 0.0, -20.0];
        let node = NodalSection { beams: 2.0, chord: [3.0, 4.0], stresses, ..Default::default() };
        let [xx, yy, zz, xy, yz, zx] = node.tensor();
        assert!((xx + yy + 10.0).abs() < 1e-14 && zz == 0.0 && yz == 0.0 && zx == 0.0);
        let across = 0.64 * xx + 0.36 * yy - 2.0 * 0.48 * xy;
        assert!(across.abs() < 1e-14, "{across}");
        let mises = (0.5 * ((xx - yy).powi(2) + xx * xx + yy * yy) + 3.0 * xy * xy).sqrt();
        assert!((mises - outer_mises(&node.stresses())).abs() < 1e-13);
    }
}
