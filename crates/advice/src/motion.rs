//! How bodies move, as far as the deck prescribes it.
//!
//! ```text
//!   prescribed U1, U2, UR3 of a node at a time --> rigid motion of its body
//! ```
//!
//! Deflections are left out: a flexible body goes with its supports.

use crate::bodies::Bodies;
use slideline_mech::axes::PLAIN;
use slideline_mech::contact::pair::Body;
use slideline_mech::vector::{dot, sub};
use slideline_model::{Dof, Model, NodeIndex, Prescribed, Step};

/// The rigid motion of the body of `node` when `fraction` of a step has
/// passed. `None`: supports do not determine it, or pull it apart.
pub fn motion(
    model: &Model,
    bodies: &Bodies,
    (place, fraction): (usize, f64),
    node: NodeIndex,
) -> Option<Body> {
    let body = bodies.of_node(node);
    let step = model.steps.get(place)?;
    let before = place.checked_sub(1).and_then(|before| model.steps.get(before));
    let own = || step.prescribed.iter().filter(|p| bodies.of_node(p.node) == body);
    let released = before.is_some_and(|before| {
        let left = |p: &&Prescribed| p.moves() && bodies.of_node(p.node) == body;
        before.prescribed.iter().filter(left).any(|p| find(step, p.node, p.dof).is_none())
    });
    if released {
        return None; // it springs back to wherever contact and springs let it
    }
    let now = |p: &Prescribed| value(model, step, before, p, fraction);
    let driver = own()
        .map(|p| p.node)
        .find(|&node| [Dof::U1, Dof::U2].iter().all(|&dof| find(step, node, dof).is_some()));
    let Some(driver) = driver else {
        let held = own().count() > 0 && own().all(|p| now(p) == 0.0);
        return (held && bodies.is_flexible(body)).then(|| still(model, body));
    };
    let of = |dof| find(step, driver, dof).map_or(0.0, now);
    let [x, y, _] = in_plane(model, driver, (of(Dof::U1), of(Dof::U2)));
    let moved = Body { reference: model.nodes.position(driver), dofs: [x, y, of(Dof::UR3)] };
    let agrees = own().all(|p| {
        let at = model.nodes.position(p.node);
        let to = moved.to_space(at);
        let axes = model.axes_of(p.node).unwrap_or(PLAIN);
        let along = |axis: usize| dot(axes[axis], sub(to, at));
        let (expected, size) = match p.dof {
            Dof::U1 => (along(0), x.abs().max(y.abs())),
            Dof::U2 => (along(1), x.abs().max(y.abs())),
            _ => (moved.dofs[2], moved.dofs[2].abs()),
        };
        (now(p) - expected).abs() <= 1e-6 * size || p.dof.is_rotation() && p.node != driver
    });
    agrees.then_some(moved)
}

/// Displacements along the axes of a node in the plane as those along the axes of the model [L].
pub fn in_plane(model: &Model, node: NodeIndex, (first, second): (f64, f64)) -> [f64; 3] {
    let axes = model.axes_of(node).unwrap_or(PLAIN);
    [0, 1, 2].map(|k| first * axes[0][k] + second * axes[1][k])
}

fn still(model: &Model, node: NodeIndex) -> Body {
    Body { reference: model.nodes.position(node), dofs: [0.0; 3] }
}

fn find(step: &Step, node: NodeIndex, dof: Dof) -> Option<&Prescribed> {
    step.prescribed.iter().find(|p| p.node == node && p.dof == dof)
}

/// The value that a prescribed dof takes when `fraction` of a step has passed.
fn value(
    model: &Model,
    step: &Step,
    before: Option<&Step>,
    prescribed: &Prescribed,
    fraction: f64,
) -> f64 {
    let amplitude = |p: &Prescribed| p.amplitude.and_then(|place| model.amplitudes.get(place));
    if let Some(amplitude) = amplitude(prescribed) {
        return prescribed.value * amplitude.at(fraction * step.procedure.period);
    }
    if step.at_once {
        return prescribed.value;
    }
    let earlier = before.and_then(|step| {
        let p = find(step, prescribed.node, prescribed.dof)?;
        let factor = amplitude(p).map_or(1.0, |amplitude| amplitude.at(step.procedure.period));
        Some(p.value * factor)
    });
    let start = earlier.unwrap_or(0.0);
    start + fraction * (prescribed.value - start)
}
