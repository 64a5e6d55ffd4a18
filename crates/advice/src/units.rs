//! Numbers that do not belong to one consistent set of units.

use crate::finding::Finding;
use crate::start::Start;
use slideline_diag::{Code, Diagnostic};
use slideline_model::NormalLaw;

/// SL0413: modulus against size, pressures and clearances against both. The
/// program assumes no unit; it only compares orders of magnitude.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    for block in start.model.blocks.iter().filter_map(|block| block.beams()) {
        let (modulus, height) = (block.section.material.modulus, block.section.height);
        // solids have moduli of 1e6 to 1e12 Pa: 1 to 1e6 in MPa
        let in_pascal = modulus >= 2e7;
        let (said, unit) = if in_pascal && height > 0.5 && start.reach > 10.0 {
            (true, "lengths look like mm, the modulus like Pa; with mm and N it is in MPa")
        } else if (1e2..1e6).contains(&modulus) && height < 0.02 && start.reach < 0.5 {
            (true, "lengths look like m, the modulus like MPa; with m and N it is in Pa")
        } else {
            (false, "")
        };
        if said {
            let message = format!(
                "units look mixed in {}: E = {modulus:.3e} with a section {height:.3e} high and a \
                 model {:.3e} wide: {unit}",
                block.name, start.reach
            );
            let said = Diagnostic::warning(Code("SL0413"), message).at(block.origin);
            findings.push(Finding::said(
                said.help("put *NODE, *BEAM SECTION and *ELASTIC into one set of units"),
            ));
        }
    }
    laws(start, findings);
}

fn laws(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let blocks = || start.model.blocks.iter().filter_map(|block| block.beams());
    let modulus = blocks().map(|block| block.section.material.modulus).fold(0.0, f64::max);
    let height = blocks().map(|block| block.section.height).fold(f64::INFINITY, f64::min);
    for pair in &start.model.contact_pairs {
        let NormalLaw::Exponential { clearance, pressure } = pair.interaction.normal else {
            continue;
        };
        let why = if modulus > 0.0 && pressure > 10.0 * modulus {
            format!("p0 = {pressure:.3e} is {:.1e} times Young's modulus", pressure / modulus)
        } else if height.is_finite() && clearance > height {
            format!(
                "c0 = {clearance:.3e} is {:.1} times the height of the beam",
                clearance / height
            )
        } else {
            continue;
        };
        let message = format!("the pressure law of {} is in doubtful units: {why}", pair.name);
        let said = Diagnostic::warning(Code("SL0413"), message)
            .at(pair.interaction.normal_origin.unwrap_or(pair.interaction.origin));
        findings.push(Finding::said(said.help(
            "on *SURFACE CONTACT, SOFTENED give c0 a hundredth of the height of the beam or less, \
             and p0 of the order of the contact pressure",
        )));
    }
}
