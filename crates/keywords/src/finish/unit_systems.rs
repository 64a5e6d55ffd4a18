//! Densities, moduli and accelerations that are of no one set of units.
//!
//! ```text
//!            length  force  modulus of steel  density of steel   gravity
//!    SI      m       N      2.1e11            7850               9.81
//!            mm      N      2.1e5             7.85e-9            9810
//! ```
//!
//! Only what no set of units in use has is spoken of, and only where a load asks for the density:
//! elsewhere it has no effect.

use std::ops::Range;

use slideline_diag::{Code, Diagnostic, Span};

use crate::draft::{Draft, Elasticity, Material};

/// Densities of solids in kg/m3; soft matter, whose modulus may be small, is lighter [M/L3].
const HEAVY: Range<f64> = 2500.0..25e3;
/// Densities of solids in t/mm3 [M/L3].
const IN_TONNES: Range<f64> = 5e-10..3e-8;
/// Moduli in Pa of what is as hard as a plastic [F/L2].
const IN_PASCAL: Range<f64> = 1e9..1e13;
/// The same in MPa [F/L2].
const IN_MEGAPASCAL: Range<f64> = 1e3..1e6;
/// Gravity in m/s2 and in mm/s2 [L/T2].
const GRAVITY: [Range<f64>; 2] = [9.7..9.9, 9700.0..9900.0];

/// SL0413: advises about a density that a load asks for, and about the acceleration, if it is one.
pub(super) fn judge(
    material: &Material,
    density: f64,
    (acceleration, load): (Option<[f64; 3]>, Span),
    draft: &mut Draft,
) {
    let modulus = modulus(material);
    let stiffness = modulus.and_then(|modulus| against_modulus(density, modulus));
    let pull = acceleration.map(|along| along.iter().map(|a| a * a).sum::<f64>().sqrt());
    let weight = pull.and_then(|pull| against_gravity(density, pull));
    let name = &material.name;
    let said = match (stiffness, modulus, weight, pull) {
        (Some(unit), Some(modulus), ..) => Some((
            format!(
                "units look mixed in {name}: E = {modulus:.3e} with a density {density:.3e}: {unit}"
            ),
            material.density.as_ref().map_or(load, |own| own.1.1),
            "give *ELASTIC and *DENSITY in one set of units",
        )),
        (.., Some(unit), Some(pull)) => Some((
            format!(
                "units look mixed in {name}: a density {density:.3e} under gravity of {pull:.4}: {unit}"
            ),
            load,
            "give *DENSITY and gravity in one set of units",
        )),
        _ => None,
    };
    if let Some((message, span, help)) = said {
        draft.log.push(Diagnostic::advice(Code("SL0413"), message).at(span).help(help));
    }
}

/// Young's modulus of an isotropic material [F/L2].
fn modulus(material: &Material) -> Option<f64> {
    match &material.elasticity {
        Some((Elasticity::Isotropic(table), _)) => table.first().map(|row| row.1.modulus),
        _ => None,
    }
}

/// What is wrong with a density beside a modulus.
fn against_modulus(density: f64, modulus: f64) -> Option<&'static str> {
    if IN_TONNES.contains(&density) && IN_PASCAL.contains(&modulus) {
        Some("the density looks like t/mm3, the modulus like Pa; with mm, N and t it is in MPa")
    } else if HEAVY.contains(&density) && IN_MEGAPASCAL.contains(&modulus) {
        Some("the density looks like kg/m3, the modulus like MPa; with m, N and kg it is in Pa")
    } else {
        None
    }
}

/// What is wrong with a density beside gravity.
fn against_gravity(density: f64, pull: f64) -> Option<&'static str> {
    let [metres, millimetres] = &GRAVITY;
    if IN_TONNES.contains(&density) && metres.contains(&pull) {
        Some("the density looks like t/mm3, gravity like m/s2; with mm, N and t it is 9810")
    } else if HEAVY.contains(&density) && millimetres.contains(&pull) {
        Some("the density looks like kg/m3, gravity like mm/s2; with m, N and kg it is 9.81")
    } else {
        None
    }
}
