//! The real numbers of a state, one after the other: what is moved to a neighbour and differentiated.

use crate::start::Start;
use crate::state::{PointState, State};
use slideline_mech::contact::pair::Footing;
use slideline_mech::element::Temperature;
use slideline_mech::turn::Turn;

/// A state moved by `h` times its derivative; of another length, not at all.
pub fn move_state(from: &State, (by, h): (&[f64], f64), into: &mut State) {
    into.copy_from(from);
    let mut by = by.iter();
    each_of_state(into, &mut |value| *value += by.next().map_or(0.0, |rate| h * rate));
}

/// What a step begins from, moved likewise.
pub fn move_start(from: &Start<'_>, (by, h): (&[f64], f64)) -> Start<'static> {
    let mut moved = from.owned();
    let mut by = by.iter();
    each_of_start(&mut moved, &mut |value| *value += by.next().map_or(0.0, |rate| h * rate));
    moved
}

/// Adds weighted states; what is infinite in all of them counts as still.
pub fn combine_states<'a>(states: impl Iterator<Item = (f64, &'a mut State)>, into: &mut Vec<f64>) {
    into.clear();
    for (weight, state) in states {
        let mut place = 0;
        each_of_state(state, &mut |value| add(into, &mut place, weight * *value));
    }
    finish(into);
}

/// Adds weighted beginnings of a step.
pub fn combine_starts<'a>(
    starts: impl Iterator<Item = (f64, &'a mut Start<'static>)>,
    into: &mut Vec<f64>,
) {
    into.clear();
    for (weight, start) in starts {
        let mut place = 0;
        each_of_start(start, &mut |value| add(into, &mut place, weight * *value));
    }
    finish(into);
}

fn add(into: &mut Vec<f64>, place: &mut usize, value: f64) {
    match into.get_mut(*place) {
        Some(sum) => *sum += value,
        None => into.push(value),
    }
    *place += 1;
}

fn finish(list: &mut [f64]) {
    list.iter_mut().filter(|value| !value.is_finite()).for_each(|value| *value = 0.0);
}

/// Whether two states of a contact point stand on the same branch of its laws, and on the same
/// face.
pub fn is_same_branch(one: &PointState, other: &PointState) -> bool {
    let face = |point: &PointState| point.footing.map(|footing| footing.place.face);
    let word = |point: &PointState| (point.closed, point.status, point.friction);
    word(one) == word(other)
        && one.along.is_some() == other.along.is_some()
        && face(one) == face(other)
}

/// Part by which both sides may differ [1].
const SIDES: f64 = 0.1;
/// Rates that count as none, in the largest number over the scale of the parameter [1].
const NOTHING: f64 = 1e-6;
/// What rounding may do to numbers, in parts of the largest [1].
const ROUNDING: f64 = 1e-11;

/// Part of the rates by which differences with one and two steps `h` of a parameter of that scale
/// disagree over four neighbours [1]; infinite where those of both sides of the base do: there is a
/// kink between them. Reactions below `least_force` are rounding.
pub fn bend(states: &[State; 4], base: &State, (h, scale): (f64, f64), least_force: f64) -> f64 {
    let lists: [fn(&State) -> &[f64]; 2] = [|own| &own.elements, |own| &own.reaction];
    let of = [(lists[0], 0.0), (lists[1], least_force)].map(|(list, least)| {
        let [a, b, c, d] = states.each_ref().map(list);
        let [mut bent, mut apart, mut rate, mut size] = [0.0_f64; 4];
        for (i, own) in list(base).iter().enumerate() {
            let (near, wide) = ((c[i] - b[i]) / (2.0 * h), (d[i] - a[i]) / (4.0 * h));
            rate = rate.max(near.abs());
            bent = bent.max((near - wide).abs());
            apart = apart.max((c[i] - 2.0 * own + b[i]).abs() / h.abs());
            size = size.max(own.abs());
        }
        let nothing = of_rounding(size, (h, scale), least);
        if apart > SIDES * (rate + size / scale) + nothing {
            return f64::INFINITY;
        }
        beyond_rounding(bent, (rate, size), (h, scale), least)
    });
    of[0].max(of[1])
}

/// What rounding may make of the rates of numbers of that size, which are known to `least`.
fn of_rounding(size: f64, (h, scale): (f64, f64), least: f64) -> f64 {
    (ROUNDING * size + least) / h.abs() + NOTHING * size / scale
}

/// The part of the rates that is more than rounding [1].
pub fn beyond_rounding(bent: f64, (rate, size): (f64, f64), steps: (f64, f64), least: f64) -> f64 {
    let beyond = (bent - of_rounding(size, steps, least)).max(0.0);
    if beyond == 0.0 { 0.0 } else { beyond / rate }
}

fn each_of_state(state: &mut State, call: &mut dyn FnMut(&mut f64)) {
    // displacements first: `Course::rates` counts on it
    let lists = [
        &mut state.displacement,
        &mut state.increment,
        &mut state.increment_before,
        &mut state.reaction,
        &mut state.load,
        &mut state.state_variables,
        &mut state.elements,
        &mut state.damping,
    ];
    lists.into_iter().flatten().for_each(&mut *call);
    state.points.iter_mut().for_each(|point| each_of_point(point, call));
    each_temperature(&mut state.temperatures, call);
    state.turns.iter_mut().for_each(|turn| each_of_turn(turn, call));
    let energy = &mut state.energy;
    let energies = [
        &mut energy.external_work,
        &mut energy.thermal_work,
        &mut energy.strain_energy,
        &mut energy.material_dissipation,
        &mut energy.contact_energy,
        &mut energy.friction_dissipation,
        &mut energy.friction_elastic,
        &mut energy.dropped_friction,
        &mut energy.stabilisation,
        &mut energy.released_energy,
        &mut energy.removed_energy,
        &mut energy.balance,
    ];
    energies.into_iter().for_each(&mut *call);
    state.balance_origin.iter_mut().for_each(call);
}

fn each_of_point(point: &mut PointState, call: &mut dyn FnMut(&mut f64)) {
    let PointState { pressure, traction, opening, along, elastic_slip, slip, .. } = point;
    call(pressure);
    call(opening);
    for direction in [traction, elastic_slip, slip].into_iter().chain(along) {
        direction.0.iter_mut().for_each(&mut *call);
    }
    let PointState { dissipated, dropped_work, position, normal, area, xi, footing, .. } = point;
    [dissipated, dropped_work, area, xi].into_iter().for_each(&mut *call);
    position.iter_mut().chain(normal).for_each(&mut *call);
    let Some(Footing { place, normal, direction, bearing }) = footing else { return };
    let parts = place.at.iter_mut().chain(normal).chain(direction).chain(bearing);
    parts.for_each(call);
}

fn each_temperature(list: &mut [Temperature], call: &mut dyn FnMut(&mut f64)) {
    for own in list {
        call(&mut own.value);
        call(&mut own.slope);
    }
}

fn each_of_turn(turn: &mut Turn, call: &mut dyn FnMut(&mut f64)) {
    turn.start.iter_mut().chain(&mut turn.before).for_each(call);
}

fn each_of_start(start: &mut Start<'static>, call: &mut dyn FnMut(&mut f64)) {
    start.displacement.to_mut().iter_mut().for_each(&mut *call);
    start.released.to_mut().iter_mut().for_each(&mut *call);
    each_temperature(start.temperatures.to_mut(), call);
    for own in start.references.to_mut() {
        own.displacement.iter_mut().for_each(&mut *call);
        own.turned.iter_mut().flatten().for_each(&mut *call);
        each_temperature(&mut own.temperatures, call);
    }
}
