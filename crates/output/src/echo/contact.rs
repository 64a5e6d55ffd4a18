//! Contact pairs: who is slave, who is master, the laws between them, and how they start.

use super::words::{labels, number};
use crate::number::general;
use slideline_model::{
    ContactPair, Formulation, Friction, Master, MasterFaces, Model, NormalLaw, RigidSurface,
    StickRule, Sweep,
};
use slideline_solve::observe::{ContactRow, Frame};
use std::fmt::Write as _;

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
    match &pair.profile {
        Some(profile) => {
            line!(text, "  slave    {}, integrated along it", analytic(model, profile))
        }
        None => {
            let nodes = labels(model, &slaves);
            line!(text, "  slave    {} nodes ({nodes}), {sampled}", slaves.len());
        }
    }
    line!(text, "  master   {}", master(model, &pair.master));
    for plane in model.planes_beyond(std::iter::once(pair.met_at_nodes())).into_iter().flatten() {
        let [x, y, z] = plane.normal.map(number);
        line!(
            text,
            "           it ends in a plane of symmetry across ({x}, {y}, {z}), and goes on as its image"
        );
    }
    let interaction = &pair.interaction;
    line!(text, "  width    {}", number(interaction.width));
    if !pair.offset.is_none() {
        let [slave, master] = [pair.offset.slave, pair.offset.master].map(number);
        line!(text, "  offset   surfaces stand off: slave by {slave}, master by {master}");
    }
    line!(text, "  normal   {}", normal_law(&interaction.normal));
    if interaction.no_separation {
        line!(text, "           what has closed stays closed and carries tension");
    }
    line!(text, "  friction {}", friction_law(&interaction.friction));
    text
}

fn analytic(model: &Model, surface: &RigidSurface) -> String {
    format!(
        "analytic rigid surface of {} segment{}, moving with node {}",
        surface.segments.len(),
        if surface.segments.len() == 1 { "" } else { "s" },
        model.nodes.label(surface.reference)
    )
}

fn master(model: &Model, master: &Master) -> String {
    match master {
        Master::RigidSurface(surface) => analytic(model, surface),
        Master::Faces(MasterFaces { swept: Some(swept), .. }) => format!(
            "analytical surface of {} segment{} {}, moving with node {}",
            swept.segments.len(),
            if swept.segments.len() == 1 { "" } else { "s" },
            match swept.sweep {
                Sweep::Along => "drawn along a line",
                Sweep::Around => "turned about an axis",
            },
            model.nodes.label(swept.reference)
        ),
        Master::Faces(faces) => format!(
            "{}{} faces of {} nodes ({}), {}, EXTENSION ZONE = {}",
            if faces.meets_itself { "the slave surface itself, " } else { "" },
            faces.faces.len(),
            faces.nodes().len(),
            labels(model, &faces.nodes()),
            if faces.smooth { "smoothed" } else { "not smoothed" },
            number(faces.extension)
        ),
        Master::Itself(surface) => format!(
            "the slave surface itself, in {} stretch{}, SMOOTH = {}, EXTENSION ZONE = {}",
            surface.runs.len(),
            if surface.runs.len() == 1 { "" } else { "es" },
            number(surface.smooth),
            number(surface.extension)
        ),
        Master::SlideLine(chain) => format!(
            "slide line of {} nodes ({}), {}, EXTENSION ZONE = {}",
            chain.nodes.len(),
            labels(model, &chain.nodes),
            match chain.smooth {
                Some(smooth) => format!("SMOOTH = {}", number(smooth)),
                None => "drawn through its nodes where it is round".to_owned(),
            },
            number(chain.extension)
        ),
    }
}

/// The normal law in words, the dialect's formula named.
pub fn normal_law(law: &NormalLaw) -> String {
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
        NormalLaw::CalculixLinear { stiffness, tension, pulls } => format!(
            "linear as CalculiX has it: p = K h (1/2 + atan(h/eps)/pi), K = {}, {} {}",
            number(*stiffness),
            if *pulls { "pulls up to" } else { "nothing where open; less than K h by up to" },
            number(*tension)
        ),
        NormalLaw::Bonded { stiffness } => {
            format!("bonded: p = K h both ways, K = {}", number(*stiffness))
        }
        NormalLaw::Tabular(pairs) => format!("table of {} points", pairs.len()),
    }
}

/// The friction law in words.
pub fn friction_law(friction: &Friction) -> String {
    match friction {
        Friction::Frictionless => "none".to_owned(),
        Friction::Coulomb { coefficient, second, limit, decay, stick } => {
            let mut text = format!("Coulomb, mu = {}", number(*coefficient));
            if let Some(second) = second {
                // a String takes any text
                let _ = write!(text, " along axis 1, {} along axis 2", number(*second));
            }
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
                StickRule::Slope(slope) => {
                    format!(", sticks with a slope of {}", number(*slope))
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

pub(super) fn points(text: &mut String, model: &Model, rows: &[&ContactRow]) {
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
pub(super) fn initial_contact_energy(text: &mut String, model: &Model, start: &Frame<'_>) {
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
