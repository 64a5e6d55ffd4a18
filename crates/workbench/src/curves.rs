//! What is drawn over what: reactions over the motions that drive a model, or, where none does, its
//! load over the way of what is loaded.
//!
//! ```text
//!   driven   reaction of the nodes that a card moves     over their motion
//!   loaded   sum of the loads along one axis             over the motion of a loaded node along it
//!            pressure                                    over the motion of a node under it
//! ```

use serde_json::{Value, json};
use slideline::Model;
use slideline::model::{Amplitude, Dof, Driven, Load, NodeIndex};
use slideline::observe::Frame;
use std::collections::BTreeSet;

/// Most loaded nodes that are followed.
const MOST: usize = 24;

/// The curves of a model.
pub(crate) enum Curves {
    /// Nodes with a prescribed motion.
    Driven(Vec<Driven>),
    /// Nodes with loads, the node and its dof.
    Loaded(Vec<(NodeIndex, Dof)>, Ordinate),
}

/// What loads a model.
pub(crate) enum Ordinate {
    /// Nodes with forces along each axis.
    Forces(Vec<(Dof, Vec<NodeIndex>)>),
    /// The pressure on faces.
    Pressure,
}

impl Curves {
    /// Those of a model; none where nothing is driven and nothing is loaded.
    pub fn of(model: &Model) -> Self {
        let driven = model.driven();
        if !driven.is_empty() {
            return Self::Driven(driven);
        }
        let forces = || {
            let own = |step: &slideline::model::Step| {
                step.loads.iter().chain(&step.distributed.forces).cloned().collect::<Vec<Load>>()
            };
            model.steps.iter().flat_map(own).filter(|own| own.value != 0.0)
        };
        let mut loads: Vec<Load> = forces().collect();
        if loads.is_empty() {
            return Self::Loaded(pressed(model), Ordinate::Pressure);
        }
        let mut along: Vec<(Dof, Vec<NodeIndex>)> = Vec::new();
        for own in &loads {
            match along.iter_mut().find(|(dof, _)| *dof == own.dof) {
                Some((_, nodes)) if nodes.contains(&own.node) => {}
                Some((_, nodes)) => nodes.push(own.node),
                None => along.push((own.dof, vec![own.node])),
            }
        }
        // the largest loads first, in the order of the deck where they are alike
        loads.sort_by(|a, b| b.value.abs().total_cmp(&a.value.abs()));
        let mut points: Vec<(NodeIndex, Dof)> = Vec::new();
        for own in &loads {
            if points.len() < MOST && !points.contains(&(own.node, own.dof)) {
                points.push((own.node, own.dof));
            }
        }
        Self::Loaded(points, Ordinate::Forces(along))
    }

    /// Whether it is a load over the way of what is loaded.
    pub fn is_loaded(&self) -> bool {
        matches!(self, Self::Loaded(points, _) if !points.is_empty())
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        match self {
            Self::Driven(driven) => driven.len(),
            Self::Loaded(points, _) => points.len(),
        }
    }

    /// Whether signs of motion and force belong together: a pressure has a side, and no direction.
    pub fn is_directed(&self) -> bool {
        !matches!(self, Self::Loaded(_, Ordinate::Pressure))
    }

    /// The same as the page is told of driven motions.
    pub fn told(&self, model: &Model) -> Value {
        let Self::Loaded(points, ordinate) = self else { return json!([]) };
        let each = points.iter().map(|&(node, dof)| {
            let label = model.nodes.label(node);
            let load = match ordinate {
                Ordinate::Pressure => "P".to_owned(),
                Ordinate::Forces(_) => dof.reaction_name().replacen('R', "C", 1),
            };
            json!({
                "node": label,
                "who": format!("node {label}"),
                "motion": dof.name(),
                "reaction": load,
            })
        });
        each.collect()
    }

    /// Motion and force of each after an increment.
    pub fn row(&self, frame: &Frame<'_>) -> Vec<[f64; 2]> {
        match self {
            Self::Driven(driven) => driven.iter().map(|own| reaction(own, frame)).collect(),
            Self::Loaded(points, Ordinate::Pressure) => {
                let pressure = pressure(frame);
                let way = |(node, dof): &(NodeIndex, Dof)| frame.nodal.displacement(*node, *dof);
                points.iter().map(|own| [way(own), pressure]).collect()
            }
            Self::Loaded(points, Ordinate::Forces(along)) => {
                let total = |dof: Dof, node: NodeIndex| -> f64 {
                    let known = along.iter().find(|own| own.0 == dof && !dof.is_rotation());
                    let alone = [node];
                    let nodes = known.map_or(&alone[..], |own| &own.1);
                    nodes.iter().map(|&node| frame.nodal.named(node, dof)[2]).sum()
                };
                let own = |&(node, dof): &(NodeIndex, Dof)| {
                    [frame.nodal.named(node, dof)[0], total(dof, node)]
                };
                points.iter().map(own).collect()
            }
        }
    }
}

/// The motion of the first node and the sum of the reactions of all, along the axes in which the
/// deck names the motion.
fn reaction(own: &Driven, frame: &Frame<'_>) -> [f64; 2] {
    let mut named = own.nodes.iter().map(|&node| frame.nodal.named(node, own.dof));
    let [motion, first, _] = named.next().unwrap_or_default();
    [motion, first + named.map(|[_, reaction, _]| reaction).sum::<f64>()]
}

/// Nodes under pressure, evenly chosen where there are many, along every axis.
fn pressed(model: &Model) -> Vec<(NodeIndex, Dof)> {
    let all = model.steps.iter().flat_map(|step| &step.distributed.pressures);
    let faces = all.filter(|own| !own.on.is_turning());
    let nodes: BTreeSet<NodeIndex> = faces.flat_map(|own| own.nodes.iter().copied()).collect();
    let axes = if model.is_in_space() { &Dof::ALL[..] } else { &Dof::PLANE[..] };
    let axes: Vec<Dof> = axes.iter().copied().filter(|own| !own.is_rotation()).collect();
    let stride = (nodes.len() * axes.len()).div_ceil(MOST).max(1);
    let chosen = nodes.into_iter().step_by(stride);
    chosen.flat_map(|node| axes.iter().map(move |&dof| (node, dof)).collect::<Vec<_>>()).collect()
}

/// The largest pressure that acts, with its sign; as the solver ramps it. [theory (9.5)]
fn pressure(frame: &Frame<'_>) -> f64 {
    let (model, step) = (frame.model, &frame.model.steps[frame.step - 1]);
    let before = frame.step.checked_sub(2).map(|place| &model.steps[place]);
    let amplitude = |place: Option<usize>| place.map(|place| &model.amplitudes[place]);
    let at = |time: f64, period: f64, ends: [f64; 2], amplitude: Option<&Amplitude>| match amplitude
    {
        Some(amplitude) => ends[1] * amplitude.at(time),
        None if step.at_once || time >= period => ends[1],
        None => ends[0] + (ends[1] - ends[0]) * (time / period),
    };
    let all = step.distributed.pressures.iter().filter(|own| !own.on.is_turning());
    let pressures = all.map(|own| {
        let begun = own.continues.zip(before).and_then(|(place, before)| {
            let old = before.distributed.pressures.get(place)?;
            let end = before.procedure.period;
            Some(amplitude(old.amplitude).map_or(old.value, |own| old.value * own.at(end)))
        });
        let ends = [begun.unwrap_or(0.0), own.value];
        at(frame.step_time, step.procedure.period, ends, amplitude(own.amplitude))
    });
    pressures.reduce(|most, own| if own.abs() > most.abs() { own } else { most }).unwrap_or(0.0)
}

/// The curve of a run whose point moves most, from the start on.
pub(crate) fn farthest(rows: &[Vec<[f64; 2]>]) -> usize {
    let count = rows.first().map_or(0, Vec::len);
    let reach = |place: usize| {
        rows.iter()
            .filter_map(|row| row.get(place))
            .fold(0.0, |most: f64, own| most.max(own[0].abs()))
    };
    let mut best = 0;
    for place in 1..count {
        if reach(place) > reach(best) {
            best = place;
        }
    }
    best
}
