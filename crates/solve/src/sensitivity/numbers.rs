//! The real numbers of a state, one after the other: what is moved to a neighbour and differentiated.

use crate::start::Start;
use crate::state::{PointState, State};
use Numbers::{Moving, Still};
use slideline_mech::contact::pair::Footing;
use slideline_mech::element::Temperature;
use slideline_mech::turn::Turn;
use slideline_model::Model;
use std::ops::Range;
use std::slice::from_mut;

/// A state moved by `h` times its derivative; of another length, not at all.
pub fn move_state(from: &State, (by, h): (&[f64], f64), into: &mut State) {
    into.copy_from(from);
    let mut by = by;
    each_of_state(into, &mut |numbers| move_numbers(numbers, (&mut by, h)));
}

/// What a step begins from, moved likewise.
pub fn move_start(from: &Start<'_>, (by, h): (&[f64], f64)) -> Start<'static> {
    let mut moved = from.owned();
    let mut by = by;
    each_of_start(&mut moved, &mut |numbers| move_numbers(numbers, (&mut by, h)));
    moved
}

/// Numbers of a state, or how many that are still: those of points that were never touched.
enum Numbers<'a> {
    Moving(&'a mut [f64]),
    Still(usize),
}

impl Numbers<'_> {
    fn count(&self) -> usize {
        match self {
            Moving(numbers) => numbers.len(),
            Still(count) => *count,
        }
    }
}

/// Moves numbers by the first of the rates, which are then used.
#[inline]
fn move_numbers(numbers: Numbers<'_>, (rates, h): (&mut &[f64], f64)) {
    let (own, rest) = rates.split_at(numbers.count().min(rates.len()));
    if let Moving(numbers) = numbers {
        numbers.iter_mut().zip(own).for_each(|(value, rate)| *value += h * rate);
    }
    *rates = rest;
}

/// Adds weighted states; what is infinite in all of them counts as still.
pub fn combine_states<'a>(states: impl Iterator<Item = (f64, &'a mut State)>, into: &mut Vec<f64>) {
    into.fill(0.0);
    let mut end = 0;
    for (weight, state) in states {
        let mut place = 0;
        each_of_state(state, &mut |numbers| add(into, &mut place, (weight, numbers)));
        end = place.max(end);
    }
    finish(into, 0..end);
}

/// The rates of a state between two neighbours, those of its lists of dofs being known.
pub fn rates_between(
    [one, other]: [(f64, &mut State); 2],
    lists: [&[f64]; LISTS],
    into: &mut Vec<f64>,
) {
    let mut begin = 0;
    let count = lists.iter().map(|list| list.len()).sum();
    into.resize(into.len().max(count), 0.0);
    for list in lists {
        into[begin..][..list.len()].copy_from_slice(list);
        begin += list.len();
    }
    let mut place = begin;
    each_beyond_dofs(one.1, &mut |numbers| put(into, &mut place, (one.0, numbers)));
    into.truncate(place);
    place = begin;
    each_beyond_dofs(other.1, &mut |numbers| complete(into, &mut place, (other.0, numbers)));
    into.truncate(place);
}

/// Writes weighted numbers from a place on, which moves behind them.
#[inline]
fn put(into: &mut Vec<f64>, place: &mut usize, (weight, numbers): (f64, Numbers<'_>)) {
    let end = *place + numbers.count();
    if into.len() < end {
        into.resize(end, 0.0);
    }
    let sums = &mut into[*place..end];
    match numbers {
        Moving(numbers) => {
            sums.iter_mut().zip(numbers).for_each(|(sum, value)| *sum = weight * *value);
        }
        Still(_) => sums.fill(0.0),
    }
    *place = end;
}

/// Adds the last ones; what is infinite in all counts as still.
#[inline]
fn complete(into: &mut Vec<f64>, place: &mut usize, (weight, numbers): (f64, Numbers<'_>)) {
    let end = *place + numbers.count();
    if into.len() < end {
        into.resize(end, 0.0);
    }
    if let Moving(numbers) = numbers {
        for (sum, value) in into[*place..end].iter_mut().zip(numbers) {
            let all = *sum + weight * *value;
            *sum = if all.is_finite() { all } else { 0.0 };
        }
    }
    *place = end;
}

/// Adds weighted beginnings of a step.
pub fn combine_starts<'a>(
    starts: impl Iterator<Item = (f64, &'a mut Start<'static>)>,
    into: &mut Vec<f64>,
) {
    into.fill(0.0);
    let mut end = 0;
    for (weight, start) in starts {
        let mut place = 0;
        each_of_start(start, &mut |numbers| add(into, &mut place, (weight, numbers)));
        end = place.max(end);
    }
    finish(into, 0..end);
}

/// Adds weighted numbers from a place on, which moves behind them.
#[inline]
fn add(into: &mut Vec<f64>, place: &mut usize, (weight, numbers): (f64, Numbers<'_>)) {
    let end = *place + numbers.count();
    if into.len() < end {
        into.resize(end, 0.0);
    }
    if let Moving(numbers) = numbers {
        let sums = into[*place..end].iter_mut().zip(numbers);
        sums.for_each(|(sum, value)| *sum += weight * *value);
    }
    *place = end;
}

fn finish(list: &mut Vec<f64>, own: Range<usize>) {
    list.truncate(own.end);
    list[own].iter_mut().for_each(|value| *value = if value.is_finite() { *value } else { 0.0 });
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

/// Rates that count as none, in the largest number over the scale of the parameter [1].
const NOTHING: f64 = 3e-8;
/// What rounding may do to numbers, in parts of the largest [1].
const ROUNDING: f64 = 1e-11;

/// How far numbers at four neighbours and the base are from those of a smooth function: by their fourth
/// difference, which is of the fourth power of the step where they are smooth, and of the first at
/// a kink (docs/theory.md eq (13.6)).
#[derive(Clone, Copy, Debug, Default)]
pub struct Bend {
    /// Largest fourth difference.
    apart: f64,
    /// Largest difference of the neighbours next to the base.
    across: f64,
    /// Largest number.
    size: f64,
}

impl Bend {
    /// Looks at a number, from the lowest neighbour to the highest.
    pub fn note(&mut self, [a, b, base, c, d]: [f64; 5]) {
        self.apart = self.apart.max((a - 4.0 * b + 6.0 * base - 4.0 * c + d).abs());
        self.across = self.across.max((c - b).abs());
        self.size = self.size.max(base.abs());
    }

    /// Looks at a number of a pair of neighbours.
    pub fn note_pair(&mut self, [below, base, above]: [f64; 3]) {
        self.apart = self.apart.max((below - 2.0 * base + above).abs());
        self.across = self.across.max((above - below).abs());
        self.size = self.size.max(base.abs());
    }

    /// The second difference over the step in the largest rate of pairs [1], rounding taken off.
    pub fn of_pair(self) -> f64 {
        let beyond = (self.apart - ROUNDING * self.size).max(0.0);
        if beyond == 0.0 { 0.0 } else { beyond / (0.5 * self.across) }
    }

    /// The fourth difference over the step, in the largest rate [1], for steps `h` of a parameter of
    /// that scale and numbers that are known to `least`; what rounding may make of it is taken off.
    pub fn of_rates(self, (h, scale): (f64, f64), least: f64) -> f64 {
        let of_rounding = ROUNDING * self.size + least + NOTHING * self.size * h.abs() / scale;
        let beyond = (self.apart - of_rounding).max(0.0);
        if beyond == 0.0 { 0.0 } else { beyond / (0.5 * self.across) }
    }
}

/// The bend of histories of the elements that remember, of reactions, of which those below `least_force` are
/// rounding, and of energies [1]. What other elements store follows from displacements, and is rounding in a part that only moves.
pub fn bend(
    states: &[State; 4],
    (base, model): (&State, &Model),
    steps: (f64, f64),
    least_force: f64,
) -> f64 {
    let least_energy = least_force * base.displacement.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
    let [a, b, c, d] = states;
    let all = [a, b, base, c, d];
    let energies = all.map(|own| {
        let energy = &own.energy;
        let stored = [energy.strain_energy, energy.contact_energy, energy.friction_elastic];
        [stored, [energy.friction_dissipation, energy.material_dissipation, 0.0]]
    });
    let lists = [
        (all.map(|own| &own.reaction[..]), least_force),
        (energies.each_ref().map(|own| own.as_flattened()), least_energy),
    ];
    let mut histories = Bend::default();
    let mut first = 0;
    for block in &model.blocks {
        let own = first..first + block.states() * block.elements.len();
        first = own.end;
        if block.remembers() {
            own.for_each(|i| histories.note(all.map(|state| state.elements[i])));
        }
    }
    let of = lists.map(|(of, least)| {
        let mut bend = Bend::default();
        for i in 0..of[2].len() {
            bend.note(of.map(|list| list[i]));
        }
        bend.of_rates(steps, least)
    });
    of.into_iter().fold(histories.of_rates(steps, 0.0), f64::max)
}

/// How many numbers of a state are lists of all dofs.
const LISTS: usize = 5;
/// How many numbers a contact point has, where it faces nothing.
const OF_POINT: usize = 19;

/// Calls with the numbers of a state, list by list, displacements first.
fn each_of_state(state: &mut State, call: &mut impl FnMut(Numbers<'_>)) {
    let State { displacement, increment, increment_before, reaction, load, .. } = state;
    let of_dofs: [_; LISTS] = [displacement, increment, increment_before, reaction, load];
    of_dofs.into_iter().for_each(|list| call(Moving(list)));
    each_beyond_dofs(state, call);
}

/// The same without the lists of dofs.
fn each_beyond_dofs(state: &mut State, call: &mut impl FnMut(Numbers<'_>)) {
    let State { state_variables, elements, damping, .. } = state;
    [state_variables, elements, damping].into_iter().for_each(|list| call(Moving(list)));
    let mut untouched = 0;
    for point in &mut state.points {
        if point.is_untouched() && point.along.is_none() && point.footing.is_none() {
            untouched += 1;
            continue;
        }
        if untouched > 0 {
            call(Still(untouched * OF_POINT));
            untouched = 0;
        }
        each_of_point(point, call);
    }
    call(Still(untouched * OF_POINT));
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
    energies
        .into_iter()
        .chain(&mut state.balance_origin)
        .for_each(|own| call(Moving(from_mut(own))));
}

#[inline]
fn each_of_point(point: &mut PointState, call: &mut impl FnMut(Numbers<'_>)) {
    let PointState { traction: t, elastic_slip: e, slip: s, position: x, normal: n, .. } = *point;
    let PointState { pressure, opening, allowed, dissipated, dropped_work, area, xi, .. } = *point;
    // all at once: most states are lists of points
    let mut numbers: [f64; OF_POINT] = [
        pressure,
        opening,
        allowed,
        dissipated,
        dropped_work,
        area,
        xi,
        t.0[0],
        t.0[1],
        e.0[0],
        e.0[1],
        s.0[0],
        s.0[1],
        x[0],
        x[1],
        x[2],
        n[0],
        n[1],
        n[2],
    ];
    call(Moving(&mut numbers));
    let [of_laws @ .., x0, x1, x2, n0, n1, n2] = numbers;
    let [pressure, opening, allowed, lost, dropped_work, area, xi, t0, t1, e0, e1, s0, s1] =
        of_laws;
    (point.pressure, point.opening, point.allowed) = (pressure, opening, allowed);
    (point.dissipated, point.dropped_work) = (lost, dropped_work);
    (point.area, point.xi) = (area, xi);
    (point.traction.0, point.elastic_slip.0, point.slip.0) = ([t0, t1], [e0, e1], [s0, s1]);
    (point.position, point.normal) = ([x0, x1, x2], [n0, n1, n2]);
    let PointState { along, footing, .. } = point;
    along.iter_mut().for_each(|own| call(Moving(&mut own.0)));
    let Some(Footing { place, normal, direction, bearing }) = footing else { return };
    call(Moving(&mut place.at));
    call(Moving(normal));
    call(Moving(direction));
    call(Moving(bearing));
}

fn each_temperature(list: &mut [Temperature], call: &mut impl FnMut(Numbers<'_>)) {
    for own in list {
        call(Moving(from_mut(&mut own.value)));
        call(Moving(&mut own.slopes));
    }
}

fn each_of_turn(turn: &mut Turn, call: &mut impl FnMut(Numbers<'_>)) {
    call(Moving(&mut turn.start));
    call(Moving(&mut turn.before));
}

fn each_of_start(start: &mut Start<'static>, call: &mut impl FnMut(Numbers<'_>)) {
    call(Moving(start.displacement.to_mut()));
    call(Moving(start.released.to_mut()));
    each_temperature(start.temperatures.to_mut(), call);
    for own in start.references.to_mut() {
        call(Moving(&mut own.displacement));
        own.turned.iter_mut().for_each(|turned| call(Moving(turned)));
        each_temperature(&mut own.temperatures, call);
    }
}
