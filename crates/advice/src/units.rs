//! Numbers that do not belong to one consistent set of units.

use crate::finding::Finding;
use crate::start::Start;
use slideline_diag::{Code, Diagnostic};
use slideline_model::{Dof, Material, NormalLaw, Pressed, Section};

/// Rotation that nobody means in radians: three times round [1].
const TURNS: f64 = 3.0 * std::f64::consts::TAU;
/// Stroke in sizes of the model that no part makes [1].
const FAR: f64 = 30.0;
/// Moduli of metals in MPa; in Pa they are those of jelly, which keeps its volume [F/L2].
const METALS: std::ops::Range<f64> = 4e4..5e5;
/// Poisson's ratio below which a soft body is no jelly [1].
const NO_JELLY: f64 = 0.4;
/// Size of a model that nobody gives in mm [L].
const TINY: f64 = 0.05;

/// SL0413: modulus against size, pressures and clearances against both. The
/// program assumes no unit; it only compares orders of magnitude.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    for block in start.model.blocks.iter().filter_map(|block| block.beams()) {
        let (modulus, height) = (block.section.material.modulus, block.section.shape.height());
        // solids have moduli of 1e6 to 1e12 Pa: 1 to 1e6 in MPa
        let in_pascal = modulus >= 1e8; // above any solid in psi
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
                said.help("give *NODE, *BEAM SECTION and *ELASTIC in one set of units"),
            ));
        }
    }
    solids(start, findings);
    pressures(start, findings);
    laws(start, findings);
    widths(start, findings);
    strokes(start, findings);
}

/// Metals in MPa in a model that is a few hundredths long.
fn solids(start: &Start<'_>, findings: &mut Vec<Finding>) {
    for block in &start.model.blocks {
        let Section::Solid(section) = &block.section else { continue };
        let Some(elastic) = section.material.elastic() else { continue };
        let stiff = METALS.contains(&elastic.modulus) && elastic.poisson < NO_JELLY;
        if !stiff || start.reach <= 0.0 || start.reach >= TINY {
            continue;
        }
        let message = format!(
            "units look mixed in {}: E = {:.3e} in a model {:.3e} wide: the modulus looks like MPa, \
             lengths like m; with m and N it is in Pa",
            block.name, elastic.modulus, start.reach
        );
        let said = Diagnostic::advice(Code("SL0413"), message).at(block.origin);
        findings.push(Finding::said(said.help("give *NODE and *ELASTIC in one set of units")));
    }
}

/// Pressures on faces that no linear elastic body of the model bears.
fn pressures(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let linear = |material: &Material| match material {
        Material::Elastic(elastic, _) => Some(elastic.modulus),
        _ => material.metal(0.0).map(|elastic| elastic.modulus),
    };
    let solids = start.model.blocks.iter().filter_map(|block| match &block.section {
        Section::Solid(section) => Some(&section.material),
        _ => None,
    });
    let moduli: Option<Vec<f64>> = solids.map(linear).collect();
    let Some(stiffest) = moduli.into_iter().flatten().reduce(f64::max) else { return };
    let all = start.model.steps.iter().flat_map(|step| &step.distributed.pressures);
    let all = all.filter(|own| matches!(own.on, Pressed::Face(_)));
    let Some(worst) = all.max_by(|a, b| a.value.abs().total_cmp(&b.value.abs())) else { return };
    if worst.value.abs() <= stiffest {
        return;
    }
    let message = format!(
        "a pressure of {:.3e} is {:.1e} times the largest Young's modulus of the model: their units \
         differ",
        worst.value.abs(),
        worst.value.abs() / stiffest
    );
    let said = Diagnostic::advice(Code("SL0413"), message).at(worst.origin);
    findings.push(Finding::said(said.help("give loads and *ELASTIC in one set of units")));
}

/// Out-of-plane widths of contact and beams that differ by a unit.
fn widths(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let blocks = || start.model.blocks.iter().filter_map(|block| block.beams());
    let widest = blocks().map(|block| block.section.shape.width()).fold(0.0, f64::max);
    let least = blocks().map(|block| block.section.shape.width()).fold(f64::INFINITY, f64::min);
    for pair in &start.model.contact_pairs {
        let width = pair.interaction.width;
        if widest <= 0.0 || (least / 100.0 < width && width < 100.0 * widest) {
            continue;
        }
        let message = format!(
            "contact of {} is {width:.3e} wide, the beams are {least:.3e} to {widest:.3e} wide: \
             pressures and areas look like different units",
            pair.name
        );
        let said = Diagnostic::warning(Code("SL0413"), message).at(pair.interaction.origin);
        findings.push(Finding::said(said.help(format!(
            "give the out-of-plane width on {} in the unit of *BEAM SECTION",
            pair.vocabulary.interaction()
        ))));
    }
}

/// Motions that are far larger than the model, and rotations in degrees.
fn strokes(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let size = start.size();
    for prescribed in start.model.steps.iter().flat_map(|step| &step.prescribed) {
        let (value, label) = (prescribed.value.abs(), start.model.nodes.name(prescribed.node));
        let (message, help) = if prescribed.dof == Dof::UR3 && value > TURNS {
            (
                format!(
                    "node {label} is turned by {value} rad, {:.1} times round: it looks like degrees",
                    value / std::f64::consts::TAU
                ),
                "give rotations on *BOUNDARY in radians",
            )
        } else if !prescribed.dof.is_rotation() && size > 0.0 && value > FAR * size {
            (
                format!(
                    "node {label} is moved by {value:.3e}, {:.0} times the size of the model, \
                     {size:.3e}: it looks like another unit of length",
                    value / size
                ),
                "give displacements on *BOUNDARY in the unit of *NODE",
            )
        } else {
            continue;
        };
        let said = Diagnostic::warning(Code("SL0413"), message).at(prescribed.origin);
        findings.push(Finding::said(said.help(help)));
    }
}

fn laws(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let blocks = || start.model.blocks.iter().filter_map(|block| block.beams());
    let modulus = blocks().map(|block| block.section.material.modulus).fold(0.0, f64::max);
    let height = blocks().map(|block| block.section.shape.height()).fold(f64::INFINITY, f64::min);
    for pair in &start.model.contact_pairs {
        let NormalLaw::Exponential { clearance, pressure } = pair.interaction.normal else {
            continue;
        };
        let softest = blocks()
            .map(|block| {
                let section = &block.section;
                section.material.modulus * (section.shape.height() / start.reach).powi(3)
            })
            .fold(f64::INFINITY, f64::min);
        let why = if softest.is_finite() && pressure < 1e-3 * softest {
            format!(
                "p0 = {pressure:.3e} is {:.1e} times the pressure E (h/L)^3 that bends a beam",
                pressure / softest
            )
        } else if modulus > 0.0 && pressure > 10.0 * modulus {
            format!("p0 = {pressure:.3e} is {:.1e} times Young's modulus", pressure / modulus)
        } else if height.is_finite() && clearance > height {
            format!(
                "c0 = {clearance:.3e} is {:.1} times the height of the beam",
                clearance / height
            )
        } else {
            continue;
        };
        let message = format!("the units of the pressure law of {} are doubtful: {why}", pair.name);
        let said = Diagnostic::warning(Code("SL0413"), message)
            .at(pair.interaction.normal_origin.unwrap_or(pair.interaction.origin));
        findings.push(Finding::said(said.help(format!(
            "on {} give c0 a hundredth of the height of the beam or less, and p0 of the order of \
             the contact pressure",
            pair.vocabulary.softened()
        ))));
    }
}
