//! What must hold in every increment of a completed run of solids, from its files alone.
//!
//! ```text
//!   p >= 0, |tau| <= mu p, p = p(h)        sum RF + loads = 0, sum (x x RF) + ... = 0
//!   no node deep in another part           work = strain + contact + friction
//! ```

use super::draft::{Draft, World};
use super::forces::{PairForce, pair_force, unbalanced};
use super::mesh::Part;
use super::{case::Case, depth};
use crate::random::classes::{Normal, Stick};
use crate::random::files::{Energy, Rows, member};
use crate::random::physics::law_of;
use std::collections::{BTreeMap, HashMap};
use std::path::Path;

/// What rounding leaves of an inequality.
const ROUNDING: f64 = 1e-9;
/// What the residuals allowed may leave of balance, a node.
const ALLOWED: f64 = 4e-6;
/// Largest share of the energy turned over that may be missing unsaid.
const MISSING: f64 = 0.2;
/// How deep a node may lie in another part, in widths of the largest facet of contact: between the
/// nodes of the slave surfaces overlap by what their curvature leaves.
const DEEP: f64 = 0.35;

/// A contact point.
#[derive(Clone, Debug)]
struct Point {
    node: usize,
    open: bool,
    gap: f64,
    pressure: f64,
    shear: f64,
}

/// A converged increment in the units and axes of the draft.
#[derive(Clone, Debug, Default)]
pub struct State {
    step: usize,
    increment: usize,
    time: f64,
    motion: Vec<[f64; 3]>,
    reaction: Vec<[f64; 3]>,
    /// Moments at nodes that have rotations.
    moment: Vec<f64>,
    points: Vec<Point>,
    energy: Energy,
    pair_imbalance: f64,
    pairs: Vec<PairForce>,
}

/// All of a run.
#[derive(Clone, Debug, Default)]
pub struct Files {
    /// `completed` or not.
    pub status: String,
    states: Vec<State>,
    /// Warnings and the reasons of the verdict, in one text.
    warnings: String,
    /// Code and message of the diagnosis.
    pub diagnosis: Option<(String, String)>,
}

impl Files {
    /// Whether a warning or the verdict has that word.
    pub fn said(&self, word: &str) -> bool {
        self.warnings.contains(word)
    }
}

/// Reads the files of a job; `None` where one is missing.
pub fn read(case: &Case, folder: &Path, job: &str) -> Option<Files> {
    let path = |ending: &str| folder.join(format!("{job}{ending}"));
    let units = case.placed.units;
    let numbers: HashMap<u64, usize> =
        case.placed.numbers.iter().enumerate().map(|(node, &number)| (number, node)).collect();
    let mut states = BTreeMap::new();
    history(case, &numbers, &Rows::read(&path(".history.csv"))?, &mut states);
    let contact = Rows::read(&path(".contact.csv"))?;
    for row in 0..contact.cells.len() {
        let Some(state) = states.get_mut(&contact.key(row)) else { continue };
        let Some(&node) = numbers.get(&(contact.whole(row, "node") as u64)) else { continue };
        let pressure = |column| contact.number(row, column) / units.pressure(1.0);
        let second = pressure("CSHEAR2");
        let second = if case.draft.world == World::Space { second } else { 0.0 };
        state.points.push(Point {
            node,
            open: contact.text(row, "status") == "open",
            gap: contact.number(row, "COPEN") / units.length,
            pressure: pressure("CPRESS"),
            shear: pressure("CSHEAR1").hypot(second),
        });
    }
    let energy = Rows::read(&path(".energy.csv"))?;
    for row in 0..energy.cells.len() {
        let of = |column| energy.number(row, column) / (units.force * units.length);
        if let Some(state) = states.get_mut(&energy.key(row)) {
            state.energy = Energy {
                work: of("external_work"),
                strain: of("strain_energy"),
                dissipation: of("friction_dissipation"),
                balance: of("balance"),
            };
        }
    }
    let pairs = Rows::read(&path(".pair.csv"))?;
    for row in 0..pairs.cells.len() {
        if let Some(state) = states.get_mut(&pairs.key(row)) {
            let [force, moment] =
                ["force_imbalance", "moment_imbalance"].map(|column| pairs.number(row, column));
            let worst = force.max(1e-3 * moment);
            state.pair_imbalance = state.pair_imbalance.max(worst);
            state.pairs.extend(pair_force(case, &pairs, row));
        }
    }
    let json = std::fs::read_to_string(path(".json")).ok()?;
    let warnings = json.split("\"warnings\":[").nth(1)?.split("\"peaks\":").next()?;
    let said = json.split("\"diagnosis\":{").nth(1);
    Some(Files {
        status: member(&json, "status").to_owned(),
        states: states.into_values().collect(),
        warnings: warnings.to_owned() + json.split("\"verdict\":").nth(1).unwrap_or(""),
        diagnosis: said
            .map(|text| (member(text, "code").to_owned(), member(text, "message").to_owned())),
    })
}

fn history(
    case: &Case,
    numbers: &HashMap<u64, usize>,
    rows: &Rows,
    states: &mut BTreeMap<(usize, usize), State>,
) {
    let (placed, count) = (&case.placed, numbers.len());
    let space = case.draft.world == World::Space;
    for row in 0..rows.cells.len() {
        let state = states.entry(rows.key(row)).or_insert_with(|| State {
            step: rows.whole(row, "step").saturating_sub(1),
            increment: rows.whole(row, "increment"),
            time: rows.number(row, "time") / placed.units.time,
            motion: vec![[0.0; 3]; count],
            reaction: vec![[0.0; 3]; count],
            moment: vec![0.0; count],
            ..State::default()
        });
        let Some(&node) = numbers.get(&(rows.whole(row, "node") as u64)) else { continue };
        let vector = |names: [&str; 3], unit: f64| {
            let third = if space { rows.number(row, names[2]) } else { 0.0 };
            placed
                .back([rows.number(row, names[0]), rows.number(row, names[1]), third])
                .map(|x| x / unit)
        };
        state.motion[node] = vector(["U1", "U2", "U3"], placed.units.length);
        state.reaction[node] = vector(["RF1", "RF2", "RF3"], placed.units.force);
        let moment = rows.number(row, "RM3") / (placed.units.force * placed.units.length);
        state.moment[node] = if space || moment.is_nan() { 0.0 } else { moment };
    }
}

/// Everything that is broken, each kind once.
pub fn violations(case: &Case, files: &Files) -> Vec<(&'static str, String)> {
    let mut found: Vec<(&'static str, String)> = Vec::new();
    let mut add = |kind: &'static str, why: String| {
        if !found.iter().any(|(known, _)| *known == kind) {
            found.push((kind, why));
        }
    };
    let peak = files.states.iter().map(turned_over).fold(0.0, f64::max);
    let points = files.states.iter().flat_map(|state| &state.points);
    let most = points.map(|point| point.pressure).fold(0.0, f64::max);
    let sizes = files.states.iter().map(|s| s.energy.work.abs().max(s.energy.strain));
    let size = sizes.fold(0.0, f64::max);
    let mut dissipated = 0.0_f64;
    for state in &files.states {
        let place = |why: String| format!("step {} inc {}: {why}", state.step + 1, state.increment);
        for point in &state.points {
            if let Some((kind, why)) = law(case, point, most) {
                add(kind, place(why));
            }
        }
        if !state.motion.iter().chain(&state.reaction).flatten().all(|x| x.is_finite()) {
            add("not finite", place(String::new()));
        }
        if let Some(why) = balance(&case.draft, state, peak) {
            add("balance", place(why));
        }
        if let Some(why) = part_balance(&case.draft, state, peak) {
            add("part", place(why));
        }
        if let Some(why) = touches(&case.draft, state) {
            add("touches", place(why));
        }
        if state.pair_imbalance > 1e-9 {
            add("pair", place(format!("imbalance {:.1e}", state.pair_imbalance)));
        }
        let now = state.energy.dissipation;
        if now < dissipated - 1e-10 * size {
            add("dissipation", place(format!("{dissipated:.3e} to {now:.3e} of {size:.3e}")));
        }
        dissipated = now;
        if let Some(why) = overlap(&case.draft, state) {
            add("overlap", place(why));
        }
    }
    let at_end = files.states.last().map_or(0.0, turned_over);
    if at_end < case.draft.least_force {
        let least = case.draft.least_force;
        add("no force", format!("{at_end:.2e} at the end, at least {least:.2e} was expected"));
    }
    let missing = missing(files);
    if missing > MISSING && !files.said("energ") {
        add("energy", format!("{:.1} % of it is missing", 100.0 * missing));
    }
    found
}

/// A point that carries something though the parts never meet.
fn touches(draft: &Draft, state: &State) -> Option<String> {
    let point = state.points.iter().find(|point| draft.apart && point.pressure != 0.0)?;
    Some(format!("node {} has p = {:.1e}", point.node, point.pressure))
}

/// What is missing of the energy, at worst, in all that was turned over.
pub fn missing(files: &Files) -> f64 {
    crate::random::physics::missing_of(files.states.iter().map(|state| state.energy))
}

fn law(case: &Case, point: &Point, most: f64) -> Option<(&'static str, String)> {
    let Point { gap, pressure: p, shear, .. } = *point;
    let (node, draft) = (case.placed.numbers[point.node], &case.draft);
    if p < 0.0 || !p.is_finite() {
        return Some(("pull", format!("node {node}: p = {p:.3e}")));
    }
    if point.open != (p == 0.0) {
        return Some(("status", format!("node {node}: open {} at p = {p:.3e}", point.open)));
    }
    let mut limit = draft.friction.mu * p;
    if let Stick::Limit(taumax) = draft.friction.stick {
        limit = limit.min(taumax);
    }
    if shear.abs() > limit * (1.0 + ROUNDING) + 1e-15 * most {
        return Some(("friction", format!("node {node}: tau = {shear:.6e}, limit {limit:.6e}")));
    }
    if draft.normal == Normal::Hard {
        let deep = 1e-6;
        let wrong = gap < -deep || (p > 1e-6 * most && gap > deep);
        return wrong.then(|| ("law", format!("node {node}: hard, p = {p:.3e}, gap {gap:.3e}")));
    }
    let (expected, slope) = law_of(&draft.normal, -gap);
    let rounding = 1e-12 * slope;
    ((p - expected).abs() > 1e-6 * most.max(expected) + rounding)
        .then(|| ("law", format!("node {node}: p = {p:.6e}, law {expected:.6e} at {gap:.3e}")))
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Sum of the sizes of all reactions.
fn turned_over(state: &State) -> f64 {
    state.reaction.iter().flatten().map(|part| part.abs()).sum()
}

/// Sum of forces and moments of what acts from outside; of rings the force along the axis.
fn balance(draft: &Draft, state: &State, peak: f64) -> Option<String> {
    let (mut force, mut moment, mut size, mut reach) = ([0.0; 3], [0.0; 3], 0.0, 1.0_f64);
    let mut act = |node: usize, f: [f64; 3], couple: f64| {
        let at = [0, 1, 2].map(|k| draft.nodes[node][k] + state.motion[node][k]);
        let turns = cross(at, f);
        for k in 0..3 {
            force[k] += f[k];
            moment[k] += turns[k];
        }
        moment[2] += couple;
        size += f.iter().map(|part| part.abs()).sum::<f64>();
        reach = reach.max(at.iter().map(|part| part * part).sum::<f64>().sqrt());
    };
    for (node, (&reaction, &couple)) in state.reaction.iter().zip(&state.moment).enumerate() {
        act(node, reaction, couple);
    }
    for (node, load) in loads(draft, state) {
        act(node, load, 0.0);
    }
    if draft.world == World::Rings {
        (force[0], moment) = (0.0, [0.0; 3]);
    }
    let allowed = draft.nodes.len() as f64 * ALLOWED * peak;
    let length = |v: [f64; 3]| v.iter().map(|part| part * part).sum::<f64>().sqrt();
    let (force, moment) = (length(force), length(moment) / reach);
    (force.max(moment) > allowed)
        .then(|| format!("force {force:.2e}, moment {moment:.2e} of {size:.2e}, peak {peak:.2e}"))
}

/// What is left of the forces on a part.
fn part_balance(draft: &Draft, state: &State, peak: f64) -> Option<String> {
    let loads = loads(draft, state);
    let (part, off, size) = unbalanced(draft, (&state.reaction, &loads), &state.pairs)?;
    let allowed = draft.nodes.len() as f64 * ALLOWED * peak;
    (off > allowed).then(|| format!("part {part}: {off:.2e} of {size:.2e} is left"))
}

/// Loads of an increment: they grow linearly over a step and stay.
fn loads(draft: &Draft, state: &State) -> Vec<(usize, [f64; 3])> {
    let mut now: Vec<(usize, [f64; 3])> = Vec::new();
    for (k, step) in draft.steps.iter().enumerate().take(state.step + 1) {
        let part = if k < state.step { 1.0 } else { (state.time - k as f64).clamp(0.0, 1.0) };
        for (node, goal) in &step.loads {
            match now.iter_mut().find(|(known, _)| known == node) {
                Some((_, load)) => (0..3).for_each(|c| load[c] += part * (goal[c] - load[c])),
                None => now.push((*node, goal.map(|g| part * g))),
            }
        }
    }
    now
}

/// A node of one part deep in another one, or in a disc.
fn overlap(draft: &Draft, state: &State) -> Option<String> {
    let at = |node: usize| [0, 1, 2].map(|k| draft.nodes[node][k] + state.motion[node][k]);
    let facet = |part: &Part| {
        let sizes = part.boundary();
        let size = |face: &Vec<usize>| {
            let ends = [at(face[0]), at(face[1])];
            depth::distance(ends[0], ends[1])
        };
        sizes.iter().map(size).fold(0.0, f64::max)
    };
    let widest = draft.parts.iter().map(|part| facet(&part.0)).fold(0.0, f64::max);
    let soft = if draft.normal == Normal::Hard { 0.0 } else { 0.02 };
    let most = DEEP * widest + soft;
    for (k, (part, _)) in draft.parts.iter().enumerate() {
        let mut own: Vec<_> = part.cells.iter().flatten().copied().collect();
        own.sort_unstable();
        own.dedup();
        for disc in &draft.discs {
            for &node in &own {
                let deep = disc.radius - depth::distance(at(node), at(disc.node));
                if deep > most {
                    return Some(format!("node {node} of part {k} {deep:.2e} in a disc"));
                }
            }
        }
        for (other, (body, _)) in draft.parts.iter().enumerate().filter(|(other, _)| *other != k) {
            let depths = depth::Body::new(body, &at);
            for &node in &own {
                let deep = depths.of(at(node));
                if deep > most {
                    return Some(format!("node {node} of part {k} {deep:.2e} in part {other}"));
                }
            }
        }
    }
    None
}
