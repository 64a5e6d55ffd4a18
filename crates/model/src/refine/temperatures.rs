//! Temperatures of the nodes of a halved mesh: the mean of the two between which each stands.

use super::edge::{Edge, refusal};
use crate::model::Model;
use crate::node::NodeIndex;
use crate::step::NodalTemperature;
use slideline_diag::Diagnostic;
use slideline_mech::element::Temperature;
use std::collections::HashMap;

fn mean(a: Temperature, b: Temperature) -> Temperature {
    Temperature {
        value: 0.5 * (a.value + b.value),
        slopes: [0, 1].map(|k| 0.5 * (a.slopes[k] + b.slopes[k])),
    }
}

/// Gives every new node its temperatures; `added`: each with the two between which it stands.
///
/// # Errors
/// Where those two follow different amplitudes.
pub(super) fn fill(model: &mut Model, added: &[(NodeIndex, Edge)]) -> Result<(), Box<Diagnostic>> {
    if !model.initial_temperatures.is_empty() {
        for &(node, [a, b]) in added {
            let own = mean(model.initial_temperature(a), model.initial_temperature(b));
            model.initial_temperatures.resize(node + 1, own);
            model.initial_temperatures[node] = own;
        }
    }
    let initial = model.initial_temperatures.clone();
    let before = |node: NodeIndex| initial.get(node).copied().unwrap_or_default();
    for step in &mut model.steps {
        let list = &mut step.temperatures;
        let mut place: HashMap<NodeIndex, usize> =
            list.iter().enumerate().map(|(at, own)| (own.node, at)).collect();
        for &(node, ends) in added {
            let known = ends.map(|end| place.get(&end).map(|&at| list[at].clone()));
            let Some(first) = known.iter().flatten().next().cloned() else { continue };
            let [a, b] = [0, 1].map(|k| match &known[k] {
                Some(own) => (own.temperature, own.amplitude),
                None => (before(ends[k]), None),
            });
            if a.1 != b.1 {
                let labels = ends.map(|end| model.nodes.label(end));
                let reason = "their temperatures follow different amplitudes";
                return Err(refusal(labels, reason, first.origin));
            }
            let temperature = mean(a.0, b.0);
            place.insert(node, list.len());
            list.push(NodalTemperature { node, temperature, ..first });
        }
    }
    Ok(())
}
