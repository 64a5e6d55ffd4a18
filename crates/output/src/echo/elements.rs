//! Blocks of elements with their sections.

use super::materials::{expands, told};
use super::words::{extremes, number, range};
use slideline_mech::element::{BeamHeat, solid};
use slideline_model::{
    BeamSection, Dialect, ElementBlock, ElementType, Kinematics, Model, NodeIndex, Section, Shape,
    SolidSection, SpringLaw, SpringSection, SpringWay,
};
use std::fmt::Write as _;

/// Elements of one section.
pub(super) fn block(text: &mut String, model: &Model, block: &ElementBlock) {
    match &block.section {
        Section::Beam(section) => beams(text, model, block, section),
        Section::Spring(section) => springs(text, block, section),
        Section::Solid(section) => solids(text, block, section, model.dialect),
        Section::Properties(_) => elements(text, block),
    }
}

fn beams(text: &mut String, model: &Model, block: &ElementBlock, section: &BeamSection) {
    let word = block.word();
    line!(text, "\nBEAMS {}  {} elements {word}", block.name, block.elements.len());
    line!(
        text,
        "  section {}; E = {}, nu = {}, G = {}",
        shape(&section.shape),
        number(section.material.modulus),
        number(section.material.poisson),
        number(section.material.shear_modulus())
    );
    if block.kind.is_space_beam() {
        in_space(text, block, section);
        return;
    }
    let stiffness = |length: f64| section.stiffness(length, block.kind.cell.nodes == 3);
    let lengths: Vec<f64> =
        block.elements.iter().map(|element| distance(model, element.ends())).collect();
    let Some((short, long)) = extremes(&lengths) else { return };
    let (of_short, of_long) = (stiffness(short), stiffness(long));
    line!(
        text,
        "  EA = {}, EI = {}, element length {}",
        number(of_short.axial),
        number(of_short.bending),
        range(short, long)
    );
    if of_short.centroid.abs() > ROUNDING * section.shape.height() {
        let place = number(of_short.centroid);
        line!(text, "  centroid {place} away from the axis, along the normal of the beam");
    }
    transverse_shear(text, block.kind, section, [of_short.shear, of_long.shear]);
    if let Some(heat) = &section.heat {
        warmed(text, heat);
    }
    if section.poisson != 0.0 {
        line!(
            text,
            "  POISSON = {} is read; the section stays constant all the same",
            number(section.poisson)
        );
    }
}

/// What temperature does to beams.
fn warmed(text: &mut String, heat: &BeamHeat) {
    if heat.elastic.len() > 1 {
        let moduli: Vec<f64> = heat.elastic.iter().map(|row| row.1.modulus).collect();
        let (low, high) = extremes(&moduli).unwrap_or_default();
        line!(text, "  E over {} temperatures: {}", moduli.len(), range(low, high));
    }
    if let Some(expansion) = &heat.expansion {
        line!(text, "  {}", expands(expansion));
    }
}

/// Stiffnesses of beams in space that do not depend on their lengths.
fn in_space(text: &mut String, block: &ElementBlock, section: &BeamSection) {
    let stiffness = section.space_stiffness(0.0, block.kind.cell.nodes == 3);
    let [first, mixed, second] = stiffness.bending.map(number);
    line!(text, "  EA = {}, E I11 = {first}, E I22 = {second}", number(stiffness.axial));
    if stiffness.bending[1] != 0.0 {
        line!(text, "  E I12 = {mixed}");
    }
    let [k13, k23] = stiffness.shear.map(number);
    line!(text, "  G J = {}, K13 = {k13}, K23 = {k23}", number(stiffness.torsion));
    away_from_axis(text, section);
    let [x, y, z] = section.first_axis.map(number);
    line!(text, "  axis 1 of the section along ({x}, {y}, {z}), as far as across the beam");
}

/// Part of the size of a section that counts as nothing [1].
const ROUNDING: f64 = 1e-12;

/// Where the centroid and the shear centre are that are not the axis of the beam.
fn away_from_axis(text: &mut String, section: &BeamSection) {
    let places =
        [("centroid", section.shape.centroid()), ("shear centre", section.shape.shear_center())];
    let size = section.shape.width() + section.shape.height();
    let beside = |place: &[f64; 2]| place[0].hypot(place[1]) > ROUNDING * size;
    for (name, [first, second]) in places.into_iter().filter(|(_, place)| beside(place)) {
        line!(
            text,
            "  {name} at {} along axis 1 and {} along axis 2 of the section",
            number(first),
            number(second)
        );
    }
}

/// The name and the size of a section.
fn shape(shape: &Shape) -> String {
    let (width, height) = (number(shape.width()), number(shape.height()));
    let size = match shape {
        Shape::Rectangle { .. } => return format!("RECT: width {width}, height {height}"),
        Shape::General { .. } => String::new(),
        _ => format!("width {width}, height {height}, "),
    };
    let (area, second_moment) = (number(shape.area()), number(shape.second_moment()));
    format!("{}: {size}A = {area}, I = {second_moment}", shape.name())
}

fn transverse_shear(
    text: &mut String,
    kind: &ElementType,
    section: &BeamSection,
    range_of: [f64; 2],
) {
    if kind.kinematics == (Kinematics::Beam { sheared: false }) {
        line!(text, "  rigid in transverse shear");
        return;
    }
    let shear = match section.shear.stiffness {
        Some(given) => format!("K23 = {} as given", number(given)),
        None => format!("k G A with k = {}", section.shape.shear_factor()),
    };
    line!(
        text,
        "  transverse shear stiffness K = {}: f_p times {shear}, SCF = {}{}",
        range(range_of[0], range_of[1]),
        number(section.shear.slenderness_compensation),
        if kind.cell.nodes == 3 { " times 1e-4 (second order)" } else { "" }
    );
}

fn distance(model: &Model, [first, second]: [NodeIndex; 2]) -> f64 {
    let (a, b) = (model.nodes.position(first), model.nodes.position(second));
    (b[0] - a[0]).hypot(b[1] - a[1])
}

/// Solids of one section.
fn solids(text: &mut String, block: &ElementBlock, section: &SolidSection, dialect: Dialect) {
    let (word, count) = (block.word(), block.elements.len());
    line!(text, "\nSOLIDS {}  {count} elements {word}", block.name);
    let material = told(&section.material);
    if block.kind.is_truss() {
        line!(text, "  area {}; {material}", number(section.thickness));
    } else if block.kind.is_spatial() {
        line!(text, "  {material}");
    } else {
        line!(text, "  thickness {}; {material}", number(section.thickness));
    }
    let Kinematics::Solid { formulation, .. } = block.kind.kinematics else { return };
    match formulation[usize::from(dialect == Dialect::Calculix)] {
        solid::Formulation::Hourglass => {
            line!(text, "  hourglass control: stiffness of elastic bending");
        }
        solid::Formulation::SoftHourglass => {
            line!(text, "  hourglass control: .032 E V sum (dN/dX)^2, as CalculiX");
        }
        _ => {}
    }
}

/// Elements of a type that somebody else has defined.
fn elements(text: &mut String, block: &ElementBlock) {
    let (word, count) = (block.word(), block.elements.len());
    line!(text, "\nELEMENTS {}  {count} elements {word}", block.name);
}

fn springs(text: &mut String, block: &ElementBlock, section: &SpringSection) {
    let kind = match section.way {
        SpringWay::Dof(dof) if block.kind.cell.nodes == 1 => {
            format!("to the ground, dof {}", dof.number())
        }
        SpringWay::Dof(dof) => format!("between two nodes, dof {}", dof.number()),
        SpringWay::Line { .. } | SpringWay::Direction { direction: None, .. } => {
            "along the line between two nodes".to_owned()
        }
        SpringWay::Around { axis, inside, radius, .. } => {
            let side = if inside { "within" } else { "beyond" };
            let across = axis.map(|way| {
                let [x, y, z] = way.map(number);
                format!(", across ({x}, {y}, {z})")
            });
            let (far, across) = (number(radius), across.unwrap_or_default());
            format!("{side} {far} of one another{across}")
        }
        SpringWay::Direction { direction: Some(way), .. } => {
            let [x, y, z] = way.map(number);
            format!("between two nodes along ({x}, {y}, {z})")
        }
    };
    let law = match &section.law {
        SpringLaw::Linear(stiffness) => format!("stiffness {}", number(*stiffness)),
        SpringLaw::Table(table) => format!("a table of {} forces", table.len()),
        SpringLaw::Gap { clearance, .. } => format!(
            "a gap of {} that closes with the stiffness {}",
            number(*clearance),
            number(section.law.stiffest())
        ),
    };
    line!(text, "\nSPRINGS {}  {} elements {kind}, {law}", block.name, block.elements.len());
}
