//! What was understood, in words: the opening of `JOB.dat` and of `check`.

use crate::ledger::onset_word;
use crate::number::general;
use slideline_mech::element::{BeamHeat, solid};
use slideline_mech::material::Expansion;
use slideline_model::{
    BeamSection, ContactPair, Dialect, Dof, ElementBlock, ElementType, Formulation, Friction,
    Kinematics, Load, Master, Material, Model, NodeIndex, NormalLaw, Prescribed, Section, Shape,
    SolidSection, SpringLaw, SpringSection, SpringWay, Step, StickRule,
};
use slideline_solve::observe::{ContactRow, Frame};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// Everything that was understood of a deck, with the state in which it
/// starts.
pub fn model_echo(model: &Model, start: &Frame<'_>) -> String {
    let mut text = String::new();
    heading(&mut text, model);
    nodes(&mut text, model);
    instances(&mut text, model);
    for block in &model.blocks {
        match &block.section {
            Section::Beam(section) => beams(&mut text, model, block, section),
            Section::Spring(section) => springs(&mut text, block, section),
            Section::Solid(section) => solids(&mut text, block, section, model.dialect),
            Section::Properties(_) => elements(&mut text, block),
        }
    }
    constraints(&mut text, model);
    for (place, pair) in model.contact_pairs.iter().enumerate() {
        text.push('\n');
        text.push_str(&pair_echo(model, pair));
        let rows: Vec<&ContactRow> = start.contact.iter().filter(|row| row.pair == place).collect();
        points(&mut text, model, &rows);
    }
    initial_contact_energy(&mut text, model, start);
    for (place, step) in model.steps.iter().enumerate() {
        step_echo(&mut text, model, place + 1, step);
    }
    text
}

fn heading(text: &mut String, model: &Model) {
    for heading in model.heading.lines() {
        line!(text, "{heading}");
    }
    line!(text, "dialect          {}", model.dialect.word());
    line!(text, "friction onset   {}", onset_word(model.friction_onset));
}

fn nodes(text: &mut String, model: &Model) {
    let linked = model.rigid_links.len();
    line!(text, "\nNODES  {}, {linked} of them on rigid links", model.nodes.len());
    for axis in 0..3 {
        let values = model.nodes.iter().map(|node| node.position[axis]);
        let (low, high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        if high > low {
            let name = ["x", "y", "z"][axis];
            line!(text, "  {name} from {} to {}", general(low, 9), general(high, 9));
        }
    }
}

/// Who has which numbers: in files a node of an instance has one number.
fn instances(text: &mut String, model: &Model) {
    let numbering = model.nodes.numbering();
    if numbering.instances().is_empty() {
        return;
    }
    if numbering.stride() == 0 {
        line!(text, "\nINSTANCES  all numbers are those of the deck");
        return;
    }
    line!(text, "\nINSTANCES  numbers in files of nodes and elements");
    for (name, k) in numbering.instances().iter().zip(1_u64..) {
        let offset = k * numbering.stride();
        line!(text, "  {name}.n is {offset} + n");
    }
}

fn beams(text: &mut String, model: &Model, block: &ElementBlock, section: &BeamSection) {
    let word = block.word();
    line!(text, "\nBEAMS {}  {} elements {word}", block.name, block.elements.len());
    line!(
        text,
        "  section {}; E = {}, nu = {}, G = {}",
        shape(&section.shape),
        general(section.material.modulus, 9),
        general(section.material.poisson, 9),
        general(section.material.shear_modulus(), 9)
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
        general(of_short.axial, 9),
        general(of_short.bending, 9),
        range(short, long)
    );
    transverse_shear(text, block.kind, section, [of_short.shear, of_long.shear]);
    if let Some(heat) = &section.heat {
        warmed(text, heat);
    }
    if section.poisson != 0.0 {
        line!(
            text,
            "  POISSON = {} is read; the section stays constant all the same",
            general(section.poisson, 9)
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
    let [first, mixed, second] = stiffness.bending.map(|value| general(value, 9));
    line!(text, "  EA = {}, E I11 = {first}, E I22 = {second}", general(stiffness.axial, 9));
    if stiffness.bending[1] != 0.0 {
        line!(text, "  E I12 = {mixed}");
    }
    let [k13, k23] = stiffness.shear.map(|value| general(value, 9));
    line!(text, "  G J = {}, K13 = {k13}, K23 = {k23}", general(stiffness.torsion, 9));
    let [x, y, z] = section.first_axis.map(|part| general(part, 9));
    line!(text, "  axis 1 of the section along ({x}, {y}, {z}), as far as across the beam");
}

/// The name and the size of a section.
fn shape(shape: &Shape) -> String {
    let (width, height) = (general(shape.width(), 9), general(shape.height(), 9));
    let size = match shape {
        Shape::Rectangle { .. } => return format!("RECT: width {width}, height {height}"),
        Shape::General { .. } => String::new(),
        _ => format!("width {width}, height {height}, "),
    };
    let (area, second_moment) = (general(shape.area(), 9), general(shape.second_moment(), 9));
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
        Some(given) => format!("K23 = {} as given", general(given, 9)),
        None => format!("k G A with k = {}", section.shape.shear_factor()),
    };
    line!(
        text,
        "  transverse shear stiffness K = {}: f_p times {shear}, SCF = {}{}",
        range(range_of[0], range_of[1]),
        general(section.shear.slenderness_compensation, 9),
        if kind.cell.nodes == 3 { " times 1e-4 (second order)" } else { "" }
    );
}

fn distance(model: &Model, [first, second]: [NodeIndex; 2]) -> f64 {
    let (a, b) = (model.nodes.position(first), model.nodes.position(second));
    (b[0] - a[0]).hypot(b[1] - a[1])
}

fn extremes(values: &[f64]) -> Option<(f64, f64)> {
    let first = *values.first()?;
    Some(values.iter().fold((first, first), |(l, h), &v| (l.min(v), h.max(v))))
}

/// `a`, or `a to b` where they differ by more than rounding.
fn range(low: f64, high: f64) -> String {
    let (low, high) = (general(low, 9), general(high, 9));
    if low == high { low.to_string() } else { format!("{low} to {high}") }
}

/// Solids of one section.
fn solids(text: &mut String, block: &ElementBlock, section: &SolidSection, dialect: Dialect) {
    let (word, count) = (block.word(), block.elements.len());
    line!(text, "\nSOLIDS {}  {count} elements {word}", block.name);
    let material = told(&section.material);
    if block.kind.is_truss() {
        line!(text, "  area {}; {material}", general(section.thickness, 9));
    } else if block.kind.is_spatial() {
        line!(text, "  {material}");
    } else {
        line!(text, "  thickness {}; {material}", general(section.thickness, 9));
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

/// A material in words.
fn told(material: &Material) -> String {
    match (material, material.elastic()) {
        (Material::Elastic(elastic, _), _) => {
            format!("E = {}, nu = {}", general(elastic.modulus, 9), general(elastic.poisson, 9))
        }
        (Material::Anisotropic(_), _) => "anisotropic elasticity".to_owned(),
        (Material::Foam(_), Some(elastic)) => format!(
            "foam; at small strain E = {}, nu = {}",
            general(elastic.modulus, 9),
            general(elastic.poisson, 9)
        ),
        (Material::RambergOsgood(metal), _) => format!(
            "E = {}, nu = {}, deformation plasticity from {} with exponent {}",
            general(metal.elastic.modulus, 9),
            general(metal.elastic.poisson, 9),
            general(metal.stress, 9),
            general(metal.exponent, 9)
        ),
        (Material::Rubber(_), Some(elastic)) => format!(
            "rubber of shear modulus {} and bulk modulus {} at small strain",
            general(elastic.shear_modulus(), 9),
            general(elastic.bulk_modulus(), 9),
        ),
        (Material::Plastic(plastic), _) => format!(
            "E = {}, nu = {}, yields at {}{}",
            general(plastic.elastic.modulus, 9),
            general(plastic.elastic.poisson, 9),
            general(plastic.table.first().map_or(0.0, |line| line[0]), 9),
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
        (Material::Expanding(own), _) => {
            format!("{}; {}", told(&own.law), expands(&own.expansion))
        }
        _ => "a material of the embedding program".to_owned(),
    }
}

/// How something expands, in words.
fn expands(expansion: &Expansion) -> String {
    let coefficients: Vec<f64> = expansion.table.iter().flat_map(|row| row.1).collect();
    let (low, high) = extremes(&coefficients).unwrap_or_default();
    format!("expands by {} from {} on", range(low, high), general(expansion.zero, 9))
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
        SpringWay::Line { .. } => "along the line between two nodes".to_owned(),
    };
    let law = match &section.law {
        SpringLaw::Linear(stiffness) => format!("stiffness {}", general(*stiffness, 9)),
        SpringLaw::Table(table) => format!("a table of {} forces", table.len()),
    };
    line!(text, "\nSPRINGS {}  {} elements {kind}, {law}", block.name, block.elements.len());
}

/// Dofs that follow others: `*EQUATION`, `*TIE`, `*COUPLING` and the like.
fn constraints(text: &mut String, model: &Model) {
    let all = &model.linear_constraints;
    if all.is_empty() {
        return;
    }
    line!(text, "\nDEPENDENT DOFS  {}, by equations, ties and couplings", all.len());
    for own in all.iter().take(MOST_EQUATIONS) {
        let name = |node: NodeIndex, dof: Dof| format!("{}.{}", model.nodes.name(node), dof.name());
        let terms = own.terms.iter().map(|&(node, dof, factor)| {
            format!("{} {} {}", sign(factor), general(factor.abs(), 9), name(node, dof))
        });
        let mut terms: Vec<String> = terms.collect();
        if own.constant != 0.0 || terms.is_empty() {
            terms.push(format!("{} {}", sign(own.constant), general(own.constant.abs(), 9)));
        }
        line!(text, "  {} = {}", name(own.dependent.0, own.dependent.1), terms.join(" "));
    }
    if all.len() > MOST_EQUATIONS {
        line!(text, "  and {} more", all.len() - MOST_EQUATIONS);
    }
}

/// Most equations that are told one by one.
const MOST_EQUATIONS: usize = 20;

fn sign(value: f64) -> char {
    if value < 0.0 { '-' } else { '+' }
}

/// Pressures and forces that are spread over faces and volumes, card by card.
fn distributed(text: &mut String, model: &Model, step: &Step) {
    for row in step.distributed.pressures.chunk_by(|a, b| a.origin == b.origin) {
        let values: Vec<f64> = row.iter().map(|pressure| pressure.value).collect();
        let Some((least, most)) = extremes(&values) else { continue };
        line!(
            text,
            "  pressure on {} faces goes to {}{}",
            row.len(),
            range(least, most),
            amplitude(model, row[0].amplitude)
        );
    }
    for row in step.distributed.forces.chunk_by(|a, b| a.origin == b.origin) {
        let mut sum = [0.0; 3];
        for load in row {
            if let Some(sum) = sum.get_mut(load.dof.number() - 1) {
                *sum += load.value;
            }
        }
        line!(
            text,
            "  distributed force on {} nodes goes to {} in all{}",
            row.iter().map(|load| load.node).collect::<BTreeSet<NodeIndex>>().len(),
            sum.map(|sum| general(sum, 9).to_string()).join(", "),
            amplitude(model, row[0].amplitude)
        );
    }
}

/// Who is slave, who is master, and the laws between them.
pub fn pair_echo(model: &Model, pair: &ContactPair) -> String {
    let mut text = String::new();
    let slaves = pair.slave_nodes();
    line!(text, "CONTACT PAIR {}", pair.name);
    let sampled = match pair.formulation {
        Formulation::NodeToSurface => "sampled at the nodes",
        Formulation::SurfaceToSurface => "integrated along their elements",
        Formulation::Mortar => "spread over their faces",
    };
    let nodes = labels(model, &slaves);
    line!(text, "  slave    {} nodes ({nodes}), {sampled}", slaves.len());
    line!(text, "  master   {}", master(model, &pair.master));
    let interaction = &pair.interaction;
    line!(text, "  width    {}", general(interaction.width, 9));
    line!(text, "  normal   {}", normal_law(&interaction.normal));
    line!(text, "  friction {}", friction_law(&interaction.friction));
    text
}

/// Node numbers; a row of consecutive ones as `first to last`.
pub fn labels(model: &Model, nodes: &[NodeIndex]) -> String {
    let labels: Vec<u64> = nodes.iter().map(|&node| model.nodes.label(node)).collect();
    let mut parts: Vec<String> = Vec::new();
    for row in labels.chunk_by(|a, b| a + 1 == *b) {
        match row {
            [first, .., last] if row.len() > 2 => parts.push(format!("{first} to {last}")),
            _ => parts.extend(row.iter().map(u64::to_string)),
        }
    }
    if parts.len() > 12 {
        let more = parts.len() - 11;
        parts.truncate(11);
        parts.push(format!("and {more} more"));
    }
    parts.join(", ")
}

fn master(model: &Model, master: &Master) -> String {
    match master {
        Master::RigidSurface(surface) => format!(
            "analytic rigid surface of {} segment{}, moving with node {}",
            surface.segments.len(),
            if surface.segments.len() == 1 { "" } else { "s" },
            model.nodes.label(surface.reference)
        ),
        Master::Faces(faces) => format!(
            "{} faces of {} nodes ({}), {}, EXTENSION ZONE = {}",
            faces.faces.len(),
            faces.nodes().len(),
            labels(model, &faces.nodes()),
            if faces.smooth { "smoothed" } else { "not smoothed" },
            general(faces.extension, 9)
        ),
        Master::SlideLine(chain) => format!(
            "slide line of {} nodes ({}), SMOOTH = {}, EXTENSION ZONE = {}",
            chain.nodes.len(),
            labels(model, &chain.nodes),
            general(chain.smooth, 9),
            general(chain.extension, 9)
        ),
    }
}

/// The normal law in words, the dialect's formula named.
pub fn normal_law(law: &NormalLaw) -> String {
    let number = |value: f64| general(value, 9);
    match law {
        NormalLaw::Hard => "hard: no penetration, no tension".to_owned(),
        NormalLaw::Linear { stiffness } => format!("linear: p = K h, K = {}", number(*stiffness)),
        NormalLaw::Exponential { clearance, pressure } => format!(
            "exponential as Abaqus has it: p = p0/(e-1) xi (exp(xi) - 1), xi = 1 + h/c0; c0 = {}, \
             p0 = {} (h = c0: 7.44 p0)",
            number(*clearance),
            number(*pressure)
        ),
        NormalLaw::CalculixExponential { clearance, pressure } => format!(
            "exponential as CalculiX has it: p = p0 exp(b h), b = ln(100)/c0; c0 = {}, p0 = {} \
             (h = c0: 100 p0)",
            number(*clearance),
            number(*pressure)
        ),
        NormalLaw::CalculixLinear { stiffness, tension } => format!(
            "linear as CalculiX has it: p = K h (1/2 + atan(h/eps)/pi), K = {}, pulls up to {}",
            number(*stiffness),
            number(*tension)
        ),
        NormalLaw::Tabular(pairs) => format!("table of {} points", pairs.len()),
    }
}

/// The friction law in words.
pub fn friction_law(friction: &Friction) -> String {
    let number = |value: f64| general(value, 9);
    match friction {
        Friction::Frictionless => "none".to_owned(),
        Friction::Coulomb { coefficient, limit, decay, stick } => {
            let mut text = format!("Coulomb, mu = {}", number(*coefficient));
            if let Some(decay) = decay {
                let _ = write!(
                    text,
                    " decaying to {} with slip rate (d_c = {})",
                    number(decay.kinetic),
                    number(decay.rate)
                ); // a String takes any text
            }
            if let Some(limit) = limit {
                let _ = write!(text, ", TAUMAX = {}", number(*limit)); // as above
            }
            text.push_str(&match stick {
                StickRule::SlipTolerance(fraction) => format!(
                    ", sticks within an elastic slip of {} of the mean contact element length",
                    number(*fraction)
                ),
                StickRule::ElasticSlip(slip) => {
                    format!(", sticks within an elastic slip of {}", number(*slip))
                }
                StickRule::Lagrange => ", sticks exactly (LAGRANGE)".to_owned(),
            });
            text
        }
        Friction::Rough => "rough: no slip while closed".to_owned(),
        Friction::User { name, properties, .. } => {
            format!("user law {name} with {} properties", properties.len())
        }
    }
}

fn points(text: &mut String, model: &Model, rows: &[&ContactRow]) {
    line!(text, "  {:>10} {:>16} {:>20}", "slave node", "area", "initial gap");
    for row in rows {
        line!(
            text,
            "  {:>10} {:>16} {:>20}",
            model.nodes.label(row.node),
            general(row.area, 7),
            gap(row.opening)
        );
    }
}

/// A gap in words where the point faces no master.
pub fn gap(opening: f64) -> String {
    if opening.is_finite() { general(opening, 7).to_string() } else { "faces no master".to_owned() }
}

/// An initial overclosure holds energy before anything moves.
/// [contract: JOB.energy.csv]
fn initial_contact_energy(text: &mut String, model: &Model, start: &Frame<'_>) {
    let energy: f64 = start
        .contact
        .iter()
        .filter(|row| row.opening.is_finite())
        .map(|row| row.area * model.contact_pairs[row.pair].interaction.normal.energy(-row.opening))
        .sum();
    if !model.contact_pairs.is_empty() {
        line!(
            text,
            "\nThe contact laws hold an energy of {} in the undeformed positions; the energy \
                 balance counts from the first converged state.",
            general(energy, 7)
        );
    }
}

/// How often states are written, where the deck says so.
fn states_echo(text: &mut String, every: &[usize]) {
    let words = |every: &usize| match every {
        0 => "never".to_owned(),
        1 => "every increment".to_owned(),
        many => format!("every {many} increments and at the end"),
    };
    if !every.is_empty() {
        let words: Vec<String> = every.iter().map(words).collect();
        line!(text, "  states {}", words.join(", "));
    }
}

fn step_echo(text: &mut String, model: &Model, number: usize, step: &Step) {
    line!(text, "\nSTEP {number}  {}", step.title.replace('\n', " / "));
    let time = &step.procedure;
    line!(
        text,
        "  {}static, period {}, increments {} (first), {} to {}{}, at most {}",
        if step.nlgeom { "geometrically nonlinear, " } else { "linear kinematics, " },
        general(time.period, 9),
        general(time.initial, 9),
        general(time.minimum, 9),
        general(time.maximum, 9),
        if time.direct { ", fixed" } else { "" },
        step.max_increments
    );
    states_echo(text, &step.output.states_every);
    let fixed = step.prescribed.iter().filter(|motion| !motion.moves()).count();
    line!(text, "  {fixed} dofs held");
    let moving: Vec<&Prescribed> = step.prescribed.iter().filter(|own| own.moves()).collect();
    let alike = |a: &&Prescribed, b: &&Prescribed| {
        (a.dof, a.value, a.amplitude, a.origin) == (b.dof, b.value, b.amplitude, b.origin)
    };
    for row in moving.chunk_by(alike) {
        let nodes: Vec<NodeIndex> = row.iter().map(|motion| motion.node).collect();
        line!(
            text,
            "  {} {} goes to {}{}",
            named(model, &nodes),
            row[0].dof.name(),
            general(row[0].value, 9),
            amplitude(model, row[0].amplitude)
        );
    }
    let alike = |a: &Load, b: &Load| {
        (a.dof, a.value, a.amplitude, a.origin) == (b.dof, b.value, b.amplitude, b.origin)
    };
    for row in step.loads.chunk_by(alike) {
        let nodes: Vec<NodeIndex> = row.iter().map(|load| load.node).collect();
        line!(
            text,
            "  {} load along {} goes to {}{}{}",
            named(model, &nodes),
            row[0].dof.name(),
            general(row[0].value, 9),
            amplitude(model, row[0].amplitude),
            if nodes.len() > 1 { ", each" } else { "" }
        );
    }
    distributed(text, model, step);
}

/// `node 7`, or `nodes 7 to 9`.
fn named(model: &Model, nodes: &[NodeIndex]) -> String {
    let noun = if nodes.len() == 1 { "node" } else { "nodes" };
    format!("{noun} {}", labels(model, nodes))
}

fn amplitude(model: &Model, place: Option<usize>) -> String {
    let amplitude = place.and_then(|place| model.amplitudes.get(place));
    amplitude.map_or_else(String::new, |amplitude| format!(" times amplitude {}", amplitude.name))
}
