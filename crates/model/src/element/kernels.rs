//! Kernels of the rows of the table: sections in a deck's words become those of the mechanics.

use super::element_type::{Kinematics, Undeformed};
use super::section::{BeamSection, Section, SpringSection, SpringWay};
use crate::dialect::Dialect;
use slideline_mech::element::heated::Heated;
use slideline_mech::element::solid::{Formulation, Interpolation, Recipe, Told};
use slideline_mech::element::{
    AxialSpring, Bar, Beam21, Beam22, Beam23, DirectedSpring, GroundSpring, HeatedBeams, Instances,
    Kernel, RadialSpring, RelativeSpring, SpaceBeam, SpaceBeams, SpringLaw,
};
use slideline_mech::section::{
    BeamStiffness, SpaceStiffness, TransverseShear, space_stiffness, stiffness,
};

/// The kernel that was made; the one before it, whose room may be used again.
type Kept = Option<Box<dyn Kernel>>;

pub(super) fn b21(block: &Undeformed<'_>, room: Kept) -> Kept {
    let Section::Beam(section) = block.section else { return None };
    let elements = block.plane::<2>().map(|ends| {
        let stiffness = section.stiffness(distance(ends[0], ends[1]), false);
        Beam21::new(ends, stiffness)
    });
    Some(beams::<_, 6, 36>(section, elements, room))
}

pub(super) fn b22(block: &Undeformed<'_>, room: Kept) -> Kept {
    let Section::Beam(section) = block.section else { return None };
    let elements = block.plane::<3>().map(|nodes| {
        let length = distance(nodes[0], nodes[1]) + distance(nodes[1], nodes[2]);
        Beam22::new(nodes, section.stiffness(length, true))
    });
    Some(beams::<_, 9, 81>(section, elements, room))
}

pub(super) fn b23(block: &Undeformed<'_>, room: Kept) -> Kept {
    let Section::Beam(section) = block.section else { return None };
    let elements = block.plane::<2>().map(|ends| {
        let stiffness = section.stiffness(distance(ends[0], ends[1]), false);
        Beam23::new(ends, stiffness)
    });
    Some(beams::<_, 6, 36>(section, elements, room))
}

/// The kernel of beams: with temperatures only where they change something.
fn beams<E: Heated<N, NN> + 'static, const N: usize, const NN: usize>(
    section: &BeamSection,
    elements: impl Iterator<Item = E>,
    room: Kept,
) -> Box<dyn Kernel> {
    match &section.heat {
        Some(heat) => Box::new(HeatedBeams::<E, N, NN>::new(elements, (**heat).clone())),
        None => Instances::<E, N, NN>::in_room(room, elements),
    }
}

/// Beams in space of a row. One whose axis 1 runs along it has been refused before: it makes none.
pub(super) fn space_beam<const N: usize, const P: usize>(
    block: &Undeformed<'_>,
    _room: Kept,
) -> Kept {
    let Section::Beam(section) = block.section else { return None };
    let elements = block.positions::<3, N>().map(|nodes| {
        let length = nodes.windows(2).map(|ends| distance(ends[0], ends[1])).sum();
        SpaceBeam::new(nodes, section.first_axis, &section.space_stiffness(length, N == 3))
    });
    let heat = section.heat.as_deref().cloned();
    Some(Box::new(elements.collect::<Option<SpaceBeams<N, P>>>()?.heated(heat)))
}

pub(super) fn spring1(block: &Undeformed<'_>, room: Kept) -> Kept {
    let law = along_a_dof(block)?;
    let springs = block.nodes.iter().map(|_| GroundSpring(law.clone()));
    Some(Instances::<_, 1, 1>::in_room(room, springs))
}

pub(super) fn spring2(block: &Undeformed<'_>, room: Kept) -> Kept {
    let law = along_a_dof(block)?;
    let springs = block.plane::<2>().map(|_| RelativeSpring(law.clone()));
    Some(Instances::<_, 2, 4>::in_room(room, springs))
}

/// The law of springs on a dof.
fn along_a_dof(block: &Undeformed<'_>) -> Option<SpringLaw> {
    match block.section {
        Section::Spring(SpringSection { law, way: SpringWay::Dof(_) }) => Some(law.clone()),
        _ => None,
    }
}

pub(super) fn springa(block: &Undeformed<'_>, room: Kept) -> Kept {
    let Section::Spring(SpringSection { law, way: SpringWay::Line { in_space } }) = block.section
    else {
        return None;
    };
    let law = || law.clone();
    Some(if *in_space {
        let nodes = block.positions::<3, 2>();
        let springs = nodes.map(|reference| AxialSpring { reference, law: law() });
        Instances::<_, 6, 36>::in_room(room, springs)
    } else {
        let springs = block.plane::<2>().map(|reference| AxialSpring { reference, law: law() });
        Instances::<_, 4, 16>::in_room(room, springs)
    })
}

pub(super) fn gapuni(block: &Undeformed<'_>, room: Kept) -> Kept {
    let Section::Spring(section) = block.section else { return None };
    let SpringWay::Direction { direction, in_space } = section.way else { return None };
    Some(if in_space {
        let nodes = block.positions::<3, 2>();
        let springs = nodes.map(|ends| {
            let direction = direction.unwrap_or_else(|| unit(ends));
            DirectedSpring { direction, law: section.law.clone() }
        });
        Instances::<_, 6, 36>::in_room(room, springs)
    } else {
        let springs = block.plane::<2>().map(|ends| {
            let direction = direction.map_or_else(|| unit(ends), |[x, y, _]| [x, y]);
            DirectedSpring { direction, law: section.law.clone() }
        });
        Instances::<_, 4, 16>::in_room(room, springs)
    })
}

/// Gaps by the distance of their nodes.
pub(super) fn round_gap(block: &Undeformed<'_>, room: Kept) -> Kept {
    let Section::Spring(section) = block.section else { return None };
    let SpringWay::Around { axis, inside, radius, in_space } = section.way else { return None };
    let law = &section.law;
    Some(if in_space {
        let springs = block.positions::<3, 2>().map(|[from, to]| {
            let apart = std::array::from_fn(|k| to[k] - from[k]);
            RadialSpring { apart, axis, inside, radius, law: law.clone() }
        });
        Instances::<_, 6, 36>::in_room(room, springs)
    } else {
        // an axis of the plane stands across it
        let springs = block.plane::<2>().map(|[from, to]| {
            let apart = std::array::from_fn(|k| to[k] - from[k]);
            RadialSpring { apart, axis: None, inside, radius, law: law.clone() }
        });
        Instances::<_, 4, 16>::in_room(room, springs)
    })
}

/// The direction from one place to another.
fn unit<const D: usize>([from, to]: [[f64; D]; 2]) -> [f64; D] {
    let long = distance(from, to);
    std::array::from_fn(|k| if long > 0.0 { (to[k] - from[k]) / long } else { 0.0 })
}

/// Trusses of a row: the thickness of their section is its area.
pub(super) fn truss(block: &Undeformed<'_>, _room: Kept) -> Kept {
    let Section::Solid(section) = block.section else { return None };
    let told = match block.dialect {
        Dialect::Abaqus => Told::Logarithmic,
        Dialect::Calculix => Told::Green,
    };
    let bar = Bar { material: section.material.clone(), area: section.thickness, told };
    let numbers = [block.kind.dofs.len(), block.kind.cell.nodes];
    slideline_kernels::trusses(bar, numbers, block.nodes)
}

/// Solids of a row; what they do about locking is a matter of the dialect.
pub(super) fn solid(block: &Undeformed<'_>, _room: Kept) -> Kept {
    let Section::Solid(section) = block.section else { return None };
    let Kinematics::Solid { strains, formulation, rule } = block.kind.kinematics else {
        return None;
    };
    let (formulation, told) = match block.dialect {
        Dialect::Abaqus => (formulation[0], Told::Logarithmic),
        Dialect::Calculix => (formulation[1], Told::Green),
    };
    let recipe = Recipe {
        cell: block.kind.cell,
        rule,
        kinematics: strains,
        formulation,
        material: section.material.clone(),
        thickness: section.thickness,
        told,
        orientation: section.orientation.as_ref().map(|all| all.chosen(block.members)),
        temperatures: interpolation(block, formulation),
    };
    slideline_kernels::solids(recipe, block.nodes)
}

/// How temperatures reach the points: docs/theory.md section 3.7. CalculiX has a mean in linear
/// hexahedra and what they stand for, and shape functions in wedges.
fn interpolation(block: &Undeformed<'_>, formulation: Formulation) -> Interpolation {
    let cell = block.kind.cell;
    match block.dialect {
        _ if cell.is_quadratic() => Interpolation::Linear,
        Dialect::Abaqus if formulation == Formulation::Incompatible => Interpolation::Shapes,
        Dialect::Calculix if cell.name == "wedge6" => Interpolation::Shapes,
        _ => Interpolation::Mean,
    }
}

impl BeamSection {
    /// EA, K and EI of an element of that length [L]; `second_order`: of three nodes.
    pub fn stiffness(&self, length: f64, second_order: bool) -> BeamStiffness {
        stiffness(&self.shape, &self.material, &self.transverse_shear(second_order), length)
    }

    /// The stiffnesses of an element in space of that length [L]; `second_order`: of three nodes.
    pub fn space_stiffness(&self, length: f64, second_order: bool) -> SpaceStiffness {
        space_stiffness(&self.shape, &self.material, &self.transverse_shear(second_order), length)
    }

    fn transverse_shear(&self, second_order: bool) -> TransverseShear {
        let shear = TransverseShear {
            slenderness: self.shear.slenderness_compensation,
            given: self.shear.stiffness,
            across: self.shear.across,
            ..TransverseShear::default()
        };
        if second_order { shear.second_order() } else { shear }
    }
}

fn distance<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    (0..D).map(|k| b[k] - a[k]).fold(0.0, f64::hypot)
}
