//! The element table: everything that others need to know of an element type, in one row.
//!
//! A row outside this crate is as good as one of these: a block that names it is read, solved and
//! written like any other.

use super::element_type::ElementType;
use super::solids::SOLIDS;

/// The rows of the table.
pub mod types {
    pub use crate::element::beams::types::*;
    pub use crate::element::solids::types::*;
    pub use crate::element::space_beams::types::*;
    pub use crate::element::springs::types::*;
    pub use crate::element::trusses::types::*;
}

/// The row of that name in decks.
pub fn element_type(name: &str) -> Option<&'static ElementType> {
    TYPES.into_iter().find(|row| row.names.contains(&name))
}

/// Rows of lines and points.
const LINES: [&ElementType; 15] = [
    &types::B21,
    &types::B22,
    &types::B23,
    &types::B31,
    &types::B32,
    &types::T2D2,
    &types::T2D3,
    &types::T3D2,
    &types::T3D3,
    &types::SPRING1,
    &types::SPRING2,
    &types::SPRINGA,
    &types::GAPUNI,
    &types::GAPCYL,
    &types::GAPSPHER,
];

/// All rows.
pub static TYPES: [&ElementType; LINES.len() + SOLIDS.len()] = {
    let mut all: [&ElementType; LINES.len() + SOLIDS.len()] =
        [&types::B21; LINES.len() + SOLIDS.len()];
    let mut row = 0;
    while row < all.len() {
        all[row] = if row < LINES.len() { LINES[row] } else { SOLIDS[row - LINES.len()] };
        row += 1;
    }
    all
};

/// The most nodes that a row has.
pub const MOST_NODES: usize = {
    let (mut most, mut row) = (0, 0);
    while row < TYPES.len() {
        if TYPES[row].cell.nodes > most {
            most = TYPES[row].cell.nodes;
        }
        row += 1;
    }
    most
};

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: every row agrees with its kernel: variables are its dofs, results its fields;
    /// and no two rows have the same name.
    #[test]
    fn rows_agree_with_their_kernels() {
        use crate::{
            BeamSection, Dialect, Dof, ElementBlock, Section, ShearRule, SolidSection,
            SpringSection, SpringWay, Undeformed,
        };
        use slideline_mech::element::Kernel;
        use slideline_mech::element::SpringLaw;
        use slideline_mech::element::Strains;
        use slideline_mech::material::{LargeStrain, Material};
        let elastic = slideline_mech::material::Elastic { modulus: 1.0, poisson: 0.3 };
        let shear = ShearRule::default();
        let shape = slideline_mech::section::Shape::Circle(1.0);
        let first_axis = BeamSection::FIRST_AXIS;
        let (poisson, heat) = (0.0, None);
        let beam = BeamSection { shape, poisson, material: elastic, heat, shear, first_axis };
        let material = Material::Elastic(elastic, LargeStrain::Logarithmic);
        let spring = |way| Section::Spring(SpringSection { law: SpringLaw::Linear(1.0), way });
        let sections = [
            Section::Beam(beam),
            spring(SpringWay::Dof(Dof::U2)),
            spring(SpringWay::Line { in_space: false }),
            spring(SpringWay::Direction { direction: Some([0.0, 1.0, 0.0]), in_space: false }),
            spring(SpringWay::Around { axis: None, inside: false, radius: 0.5, in_space: false }),
            Section::Solid(SolidSection { thickness: 1.0, material, orientation: None }),
        ];
        for row in TYPES {
            let mut nodes = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.5, 1.0, 0.0]];
            if !row.cell.places.is_empty() {
                nodes = row.cell.places.iter().map(|[x, y, z]| [x + 3.0, *y, *z]).collect();
            }
            let nodes = &nodes[..row.cell.nodes];
            let made: Vec<(&Section, Box<dyn Kernel>)> = sections
                .iter()
                .filter_map(|section| {
                    let dialect = Dialect::Abaqus;
                    let kernel = (row.kernel)(
                        &Undeformed { kind: row, section, dialect, nodes, members: &[0] },
                        None,
                    );
                    Some((section, kernel?))
                })
                .collect();
            assert_eq!(made.len(), 1, "{} takes one of these sections", row.name());
            let (section, kernel) = &made[0];
            let block = ElementBlock::new(row, "", (*section).clone(), Default::default());
            let variables = block.dofs().len() * row.cell.nodes;
            assert_eq!((kernel.count(), kernel.variables()), (1, variables));
            let state = vec![0.0; (row.states)(section)];
            let mut results = vec![f64::NAN; row.all_values()];
            let q = vec![0.01; kernel.variables()];
            kernel.results(0, &q, &state, &Strains::Linear.into(), &mut results);
            assert!(results.iter().all(|value| value.is_finite()), "{}", row.name());
            assert!(TYPES.into_iter().filter(|other| *other == row).count() == 1);
            assert_eq!(element_type(row.name()), Some(row));
        }
    }
}
