//! Materials in words.

use super::words::{extremes, number, range};
use slideline_mech::material::{Elastic, Expansion, Fibrous};
use slideline_model::Material;

/// A tissue with fibres in words.
fn fibrous(tissue: &Fibrous, matrix: &Elastic) -> String {
    format!(
        "tissue with {} families of fibres; matrix of E = {}, nu = {} at small strain",
        tissue.directions.len(),
        number(matrix.modulus),
        number(matrix.poisson)
    )
}

/// A material in words.
pub(super) fn told(material: &Material) -> String {
    match (material, material.elastic()) {
        (Material::Elastic(elastic, _), _) => {
            format!("E = {}, nu = {}", number(elastic.modulus), number(elastic.poisson))
        }
        (Material::Anisotropic(..), _) => "anisotropic elasticity".to_owned(),
        (Material::Foam(_), Some(elastic)) => format!(
            "foam; at small strain E = {}, nu = {}",
            number(elastic.modulus),
            number(elastic.poisson)
        ),
        (Material::Fibrous(tissue), Some(matrix)) => fibrous(tissue, &matrix),
        (Material::RambergOsgood(metal), _) => format!(
            "E = {}, nu = {}, deformation plasticity from {} with exponent {}",
            number(metal.elastic.modulus),
            number(metal.elastic.poisson),
            number(metal.stress),
            number(metal.exponent)
        ),
        (Material::Rubber(_), Some(elastic)) => format!(
            "rubber of shear modulus {} and bulk modulus {} at small strain",
            number(elastic.shear_modulus()),
            number(elastic.bulk_modulus()),
        ),
        (Material::Plastic(plastic), _) => format!(
            "E = {}, nu = {}, yields at {}{}",
            number(plastic.elastic.modulus),
            number(plastic.elastic.poisson),
            number(plastic.table.first().map_or(0.0, |line| line[0])),
            if plastic.back_stresses.is_empty() { "" } else { ", the yield surface moves" },
        ),
        (Material::Graded(graded), _) => {
            let rows: Vec<String> = graded.rows().map(told).collect();
            let last = rows.last().map_or("", String::as_str);
            format!(
                "over {} temperatures, from {} to {last}",
                rows.len(),
                rows.first().map_or("", String::as_str)
            )
        }
        (Material::Prestressed(own), _) => {
            format!("{}, under stress at the start", told(&own.law))
        }
        (Material::Expanding(own), _) => {
            format!("{}; {}", told(&own.law), expands(&own.expansion))
        }
        (Material::Creeping(own), _) => {
            let both = if own.beyond_yield { ", driven by the stress beyond yield" } else { "" };
            format!("{}; creeps{both}", told(&own.metal))
        }
        (Material::Viscoelastic(own), _) => {
            format!("{}; relaxes in {} terms", told(&own.law), own.series.len())
        }
        (Material::Rubber(_) | Material::Foam(_) | Material::Fibrous(_), None) => {
            "rubber".to_owned()
        }
        (Material::User(_), _) => "a material of the embedding program".to_owned(),
    }
}

/// How something expands, in words.
pub(super) fn expands(expansion: &Expansion) -> String {
    let coefficients: Vec<f64> = expansion.table.iter().flat_map(|row| row.1).collect();
    let (low, high) = extremes(&coefficients).unwrap_or_default();
    format!("expands by {} from {} on", range(low, high), number(expansion.zero))
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideline_mech::material::{CreepHardening, Creeping, Elastic, Plastic};

    /// Requirement: a metal that yields and creeps is told as what it is, not as somebody else's.
    #[test]
    fn a_metal_that_creeps_is_told() {
        let elastic = Elastic { modulus: 1000.0, poisson: 0.3 };
        let table = vec![[10.0, 0.0], [20.0, 0.1]];
        let metal = Material::Plastic(Plastic { elastic, table, back_stresses: Vec::new() });
        let hardening = CreepHardening::Strain;
        let own = Creeping { metal, hardening, law: Vec::new(), beyond_yield: false };
        let told = told(&Material::Creeping(Box::new(own)));
        assert_eq!(told, "E = 1000, nu = 0.3, yields at 10; creeps");
    }
}
