//! Steps: increments, motions and loads.

use super::contact::normal_law;
use super::words::{extremes, named, number, range};
use slideline_mech::traction::Follows;
use slideline_model::{Load, Model, NodeIndex, Prescribed, Pressed, Step};
use std::collections::BTreeSet;
use std::fmt::Write as _;

pub(super) fn step_echo(text: &mut String, model: &Model, step_number: usize, step: &Step) {
    line!(text, "\nSTEP {step_number}  {}", step.title.replace('\n', " / "));
    let time = &step.procedure;
    line!(
        text,
        "  {}static, period {}, increments {} (first), {} to {}{}, at most {}",
        if step.nlgeom { "geometrically nonlinear, " } else { "linear kinematics, " },
        number(time.period),
        number(time.initial),
        number(time.minimum),
        number(time.maximum),
        if time.direct { ", fixed" } else { "" },
        step.max_increments
    );
    states_echo(text, &step.output.states_every);
    changes(text, model, step);
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
            number(row[0].value),
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
            number(row[0].value),
            amplitude(model, row[0].amplitude),
            if nodes.len() > 1 { ", each" } else { "" }
        );
    }
    distributed(text, model, step);
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

/// Pressures and forces that are spread over faces and volumes, card by card.
fn distributed(text: &mut String, model: &Model, step: &Step) {
    for row in step.distributed.pressures.chunk_by(|a, b| a.origin == b.origin) {
        let values: Vec<f64> = row.iter().map(|pressure| pressure.value).collect();
        let Some((least, most)) = extremes(&values) else { continue };
        line!(
            text,
            "  {} {} {} to {}{}",
            match &row[0].on {
                Pressed::Face(_) => "pressure on",
                Pressed::Traction(own) => traction(own.follows()),
                Pressed::Sections(_) => "force per length, which turns with its sections, on",
                Pressed::Turning(_) => "turning, at the places of the nodes, of",
            },
            row.len(),
            match row[0].on {
                Pressed::Face(_) | Pressed::Traction(_) => "faces goes",
                Pressed::Sections(_) => "beam elements goes",
                Pressed::Turning(_) => "elements goes",
            },
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
            sum.map(|sum| number(sum).to_string()).join(", "),
            amplitude(model, row[0].amplitude)
        );
    }
}

/// What a traction does when its face moves.
fn traction(follows: Follows) -> &'static str {
    match (follows.turns, follows.grows) {
        (true, true) => "traction, which turns with its faces, on",
        (true, false) => "traction, which turns with its faces, per undeformed area on",
        (false, true) => "traction, which keeps its direction, on",
        (false, false) => "traction, which keeps its direction, per undeformed area on",
    }
}

fn amplitude(model: &Model, place: Option<usize>) -> String {
    let amplitude = place.and_then(|place| model.amplitudes.get(place));
    amplitude.map_or_else(String::new, |amplitude| format!(" times amplitude {}", amplitude.name))
}

/// What is absent, what begins, and other friction.
fn changes(text: &mut String, model: &Model, step: &Step) {
    let count =
        |count: usize, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
    let presence = &step.presence;
    for (list, how) in [(&presence.absent, "absent"), (&presence.begun, "added free of strain")] {
        if !list.is_empty() {
            line!(text, "  {} {how}", count(list.len(), "element"));
        }
    }
    for &pair in &presence.absent_pairs {
        line!(text, "  the contact of {} is absent", model.contact_pairs[pair].name);
    }
    for own in &step.sections {
        line!(text, "  another section of {}", model.blocks[own.block].name);
    }
    for own in &step.pressures {
        let (name, law) = (&model.contact_pairs[own.pair].name, normal_law(&own.normal));
        line!(text, "  pressure of {name}: {law}");
    }
    for own in &step.frictions {
        let name = &model.contact_pairs[own.pair].name;
        match own.to.coefficients() {
            [mu, _] if mu > 0.0 => line!(text, "  friction of {name}: {}", number(mu)),
            _ if own.to.acts() => line!(text, "  friction of {name}: another law"),
            _ => line!(text, "  no friction of {name}"),
        }
    }
}
