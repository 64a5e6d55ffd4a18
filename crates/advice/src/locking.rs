//! Solids that are too stiff for what they are made of.
//!
//! ```text
//!   constant strain   bends only by shear, however fine it looks:  TRI3 TET4 WEDGE6
//!   constant volume   at nu -> 1/2, in plastic flow and in rubber every point that is integrated
//!                     binds the volume; with about as many bonds as dofs nothing moves freely
//! ```
//!
//! Counting dofs against bonds per element of an endless mesh is the constraint count of Nagtegaal,
//! Parks and Rice (Computer Methods in Applied Mechanics and Engineering 4, 1974) and of Hughes.

use crate::finding::Finding;
use crate::start::Start;
use slideline_diag::{Code, Diagnostic};
use slideline_mech::element::solid::{Formulation, Kinematics as Strains};
use slideline_model::{
    Dialect, ElementBlock, ElementType, Kinematics, Material, Section, SolidSection,
};

/// Dofs for each bond below which a mesh locks [1]: two in the plane and three in space are those
/// of the body itself.
const FEW: f64 = 1.1;
/// Poisson's ratio from which on a body is next to incompressible [1].
const INCOMPRESSIBLE: f64 = 0.45;

/// SL0416: elements that lock.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    for block in &start.model.blocks {
        let Section::Solid(section) = &block.section else { continue };
        let bends = |element: slideline_model::Element<'_>| {
            element.nodes.iter().any(|&node| start.bodies.dependent[node].is_none())
        };
        let count = block.elements.iter().filter(|element| bends(*element)).count();
        let reason = reason(block, section, start.model.dialect).filter(|_| count > 0);
        findings.extend(reason.map(|reason| say(block, count, &reason)));
    }
}

/// Why elements of a block lock; `None`: they do not.
fn reason(block: &ElementBlock, section: &SolidSection, dialect: Dialect) -> Option<String> {
    let tight = tightness(&section.material).filter(|_| locks(block.kind, dialect));
    match (tight, is_constant(block.kind)) {
        (Some(tight), _) => Some(format!(
            "{tight}, and these elements hold the volume at so many points that little is left to move: they are far too stiff"
        )),
        (None, true) => {
            Some("their strain is constant, so that they bend far too stiffly".to_owned())
        }
        (None, false) => None,
    }
}

/// What keeps the volume of a material, in words.
fn tightness(material: &Material) -> Option<String> {
    let poisson = material.elastic().map(|elastic| elastic.poisson);
    let is_rubber = material.rubber(0.0, |_| ()).is_some();
    match (material.metal(0.0), is_rubber) {
        (Some(_), _) => Some("plastic flow leaves the volume alone".to_owned()),
        (None, true) if poisson.is_some_and(|poisson| poisson > INCOMPRESSIBLE) => {
            Some("rubber keeps its volume".to_owned())
        }
        _ => poisson
            .filter(|poisson| *poisson > INCOMPRESSIBLE)
            .map(|poisson| format!("nu = {poisson} is next to incompressible")),
    }
}

/// Whether strain is constant in an element that has nothing for bending.
fn is_constant(kind: &ElementType) -> bool {
    ["tri3", "tet4", "wedge6"].contains(&kind.cell.name)
}

/// Whether elements of a type have too few dofs for the bonds of their volume.
fn locks(kind: &ElementType, dialect: Dialect) -> bool {
    let Kinematics::Solid { strains, formulation, .. } = kind.kinematics else { return false };
    if strains == Strains::PlaneStress {
        return false; // its thickness is free
    }
    // nodes for each element of an endless mesh; five or six tetrahedra fill a cube
    let nodes = match kind.cell.name {
        "tri3" | "wedge6" => 0.5,
        "tri6" => 2.0,
        "quad8" => 3.0,
        "tet4" => 2.0 / 11.0,
        "tet10" => 1.4,
        "wedge15" => 2.5,
        "hex20" => 4.0,
        _ => 1.0,
    };
    let dimension = kind.cell.dimension as f64;
    let points = kind.points as f64;
    let (bonds, modes) = match formulation[usize::from(dialect == Dialect::Calculix)] {
        Formulation::MeanDilation | Formulation::Hourglass | Formulation::SoftHourglass => {
            (1.0, 0.0)
        }
        Formulation::LinearDilation => (1.0 + dimension, 0.0),
        Formulation::Incompatible => (points, dimension * dimension),
        Formulation::Plain => (points, 0.0),
    };
    dimension * nodes + modes < FEW * bonds
}

fn say(block: &ElementBlock, count: usize, reason: &str) -> Finding {
    let word = block.word();
    let noun = if count == 1 { "element" } else { "elements" };
    let message = format!("{count} {noun} {word} of {}: {reason}", block.name);
    let better = match (block.kind.is_spatial(), block.kind.is_ring()) {
        (true, _) => {
            "C3D8 or C3D20R; where only tetrahedra can be meshed, C3D10 for bending and \
                      C3D10H where the volume is kept"
        }
        (false, true) => "CAX4 or CAX8R",
        (false, false) if word.starts_with("CPS") => "CPS4I or CPS8R",
        (false, false) => "CPE4 or CPE8R",
    };
    let said = Diagnostic::advice(Code("SL0416"), message).at(block.origin);
    Finding::said(said.help(format!("mesh the part with {better}")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideline_model::TYPES;

    /// Requirement: which types lock where the volume is kept. Source: the constraint count; for
    /// the quadrilaterals and hexahedra the measured hourglass table of the elements (E4, Q1P0 do
    /// not, Q1 does), for quadratic ones the reduced rules.
    #[test]
    fn the_types_that_lock() {
        let locking = |dialect| -> Vec<&str> {
            let all = TYPES.into_iter().filter(|kind| locks(kind, dialect));
            all.map(ElementType::name).collect()
        };
        let both =
            ["CPE3", "CPE8", "CAX3", "CAX8", "C3D4", "C3D4H", "C3D6", "C3D10", "C3D15", "C3D20"];
        assert_eq!(locking(Dialect::Abaqus), both);
        let calculix = locking(Dialect::Calculix);
        assert!(both.iter().all(|name| calculix.contains(name)));
        assert!(calculix.contains(&"C3D8") && calculix.contains(&"CAX4"), "{calculix:?}");
        assert!(!calculix.contains(&"C3D8I") && !calculix.contains(&"C3D20R"), "{calculix:?}");
    }
}
