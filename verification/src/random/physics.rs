//! What must hold in every increment of a completed run, from its files.
//!
//! ```text
//!   p >= 0, |tau| <= mu p, p = p(h)
//!   sum RF + loads + springs = 0, sum (x x RF + RM) + ... = 0
//!   work = strain + contact + friction, friction grows
//! ```

use super::classes::{Case, Normal, Spring, Step, Stick};
use super::files::{Energy, Files, Point, State};

/// What rounding leaves of an inequality [1].
const ROUNDING: f64 = 1e-9;
/// What the residuals allowed may leave of balance, a node [1]: R_p.
const ALLOWED: f64 = 4e-6;
/// Largest share of the energy turned over that may be missing unsaid [1].
const MISSING: f64 = 0.2;

/// Everything that is broken, each kind once, with its worst.
pub fn violations(case: &Case, files: &Files) -> Vec<(&'static str, String)> {
    let mut found: Vec<(&'static str, String)> = Vec::new();
    let mut add = |kind: &'static str, why: String| {
        if !found.iter().any(|(known, _)| *known == kind) {
            found.push((kind, why));
        }
    };
    let mut peak = 0.0_f64;
    let most = pressure_peak(files);
    let mut dissipated = 0.0_f64;
    let size = energy(files);
    for (k, state) in files.states.iter().enumerate() {
        let place = |why: String| format!("step {} inc {}: {why}", state.step + 1, state.increment);
        for point in &state.points {
            if let Some((kind, why)) = law(case, point, most) {
                add(kind, place(why));
            }
        }
        let finite = state.motion.iter().chain(&state.reaction).flatten().all(|x| x.is_finite());
        if !finite {
            add("not finite", place(String::new()));
        }
        if let Some(why) = balance(case, files, (k, state), &mut peak) {
            add("balance", place(why));
        }
        if state.pair_imbalance > 1e-9 {
            add("pair", place(format!("imbalance {:.1e}", state.pair_imbalance)));
        }
        let now = state.energy.dissipation;
        if now < dissipated - 1e-10 * size {
            add("dissipation", place(format!("{dissipated:.3e} to {now:.3e} of {size:.3e}")));
        }
        dissipated = now;
    }
    let missing = missing(files);
    if missing > MISSING && !files.warnings.contains("energ") {
        add("energy", format!("{:.1} % of it is missing", 100.0 * missing));
    }
    found
}

/// Largest energy of a run.
fn energy(files: &Files) -> f64 {
    let sizes = files.states.iter().map(|s| s.energy.work.abs().max(s.energy.strain));
    sizes.fold(0.0, f64::max)
}

/// What is missing of the energy, at worst, in all that was turned over [1].
pub fn missing(files: &Files) -> f64 {
    missing_of(files.states.iter().map(|state| state.energy))
}

/// The same of the energies of the increments.
pub fn missing_of(energies: impl Iterator<Item = Energy> + Clone) -> f64 {
    let missing = energies.clone().map(|energy| energy.balance.abs()).fold(0.0, f64::max);
    let (mut turned_over, mut before) = (0.0, [0.0; 2]);
    for Energy { work, balance, .. } in energies {
        let now = [work, work - balance];
        turned_over += (now[0] - before[0]).abs().max((now[1] - before[1]).abs());
        before = now;
    }
    missing / turned_over.max(f64::MIN_POSITIVE)
}

fn pressure_peak(files: &Files) -> f64 {
    let points = files.states.iter().flat_map(|state| &state.points);
    points.map(|point| point.pressure).fold(0.0, f64::max)
}

/// Signs and laws of a point.
fn law(case: &Case, point: &Point, most: f64) -> Option<(&'static str, String)> {
    let Point { node, pressure: p, shear, open, .. } = *point;
    let node = case.placed.numbers[node];
    let draft = &case.draft;
    if p < 0.0 || !p.is_finite() {
        return Some(("pull", format!("node {node}: p = {p:.3e}")));
    }
    if (point.status == "open") != (p == 0.0) {
        return Some(("status", format!("node {node}: {} at p = {p:.3e}", point.status)));
    }
    let mut limit = draft.friction.mu * p;
    if let Stick::Limit(taumax) = draft.friction.stick {
        limit = limit.min(taumax);
    }
    if shear.abs() > limit * (1.0 + ROUNDING) + 1e-15 * most {
        return Some(("friction", format!("node {node}: tau = {shear:.6e}, limit {limit:.6e}")));
    }
    let pair = &draft.pairs[point.pair];
    if pair.integrated {
        return None; // its rows are means, and a law of means is no law
    }
    if draft.normal == Normal::Hard {
        let deep = 1e-6;
        if open < -deep || (p > 1e-6 * most && open > deep) {
            return Some(("law", format!("node {node}: hard, p = {p:.3e}, gap {open:.3e}")));
        }
        return None;
    }
    let (expected, slope) = law_of(&draft.normal, -open);
    // a gap is a difference of coordinates
    let rounding = 1e-13 * slope * 10.0;
    ((p - expected).abs() > 1e-6 * most.max(expected) + rounding)
        .then(|| ("law", format!("node {node}: p = {p:.6e}, law {expected:.6e} at {open:.3e}")))
}

/// Pressure of a softened law and its slope.
pub fn law_of(normal: &Normal, h: f64) -> (f64, f64) {
    match normal {
        Normal::Hard => (0.0, 0.0),
        Normal::Linear(k) => (k * h.max(0.0), *k),
        Normal::Exponential(c, p0) => {
            let scale = p0 / (std::f64::consts::E - 1.0);
            let at = |xi: f64| scale * xi * xi.exp_m1();
            let slope = |xi: f64| scale / c * ((1.0 + xi) * xi.exp() - 1.0);
            let xi = 1.0 + h / c;
            match xi {
                _ if xi <= 0.0 => (0.0, 0.0),
                _ if xi <= 7.0 => (at(xi), slope(xi)),
                _ => (at(7.0) + slope(7.0) * c * (xi - 7.0), slope(7.0)),
            }
        }
        Normal::Tabular(rows) => {
            let first = rows.windows(2).find(|pair| h <= pair[1][1]);
            let pair = first.unwrap_or(&rows[rows.len() - 2..]);
            let slope = (pair[1][0] - pair[0][0]) / (pair[1][1] - pair[0][1]);
            (if h < rows[0][1] { 0.0 } else { pair[0][0] + slope * (h - pair[0][1]) }, slope)
        }
    }
}

/// Loads of an increment: they grow linearly over a step and stay.
fn loads(steps: &[Step], state: &State) -> Vec<(usize, [f64; 2])> {
    let mut now: Vec<(usize, [f64; 2])> = Vec::new();
    for (k, step) in steps.iter().enumerate().take(state.step + 1) {
        let part = if k < state.step { 1.0 } else { (state.time - k as f64).clamp(0.0, 1.0) };
        for (node, goal) in &step.loads {
            match now.iter_mut().find(|(known, _)| known == node) {
                Some((_, load)) => (0..2).for_each(|c| load[c] += part * (goal[c] - load[c])),
                None => now.push((*node, goal.map(|g| part * g))),
            }
        }
    }
    now
}

/// Sum of forces and moments of what acts from outside.
fn balance(
    case: &Case,
    files: &Files,
    (k, state): (usize, &State),
    peak: &mut f64,
) -> Option<String> {
    let draft = &case.draft;
    let at = |node: usize| [0, 1].map(|c| draft.nodes[node][c] + state.motion[node][c]);
    let (mut sum, mut size, mut reach) = ([0.0; 3], 0.0, 1.0_f64);
    let mut act = |node: usize, [x, y, moment]: [f64; 3]| {
        let arm = at(node);
        sum[0] += x;
        sum[1] += y;
        sum[2] += arm[0] * y - arm[1] * x + moment;
        size += x.abs() + y.abs() + moment.abs();
        reach = reach.max(arm[0].hypot(arm[1]));
    };
    for (node, reaction) in state.reaction.iter().enumerate() {
        act(node, *reaction);
    }
    for (node, [x, y]) in loads(&draft.steps, state) {
        act(node, [x, y, 0.0]);
    }
    for spring in &draft.springs {
        if let Spring::Ground(node, axis, stiffness) = *spring {
            let mut force = [0.0; 3];
            force[axis] = -stiffness * state.motion[node][axis];
            act(node, force);
        }
    }
    *peak = peak.max(size);
    // A support that is let go may be ramped off, and is not among the rows.
    let last = files.states.get(k + 1).is_none_or(|next| next.step != state.step);
    if draft.steps[state.step].anew && !last {
        return None;
    }
    let nodes = draft.nodes.len() as f64;
    let stretched = state.motion.iter().map(|m| m[0].hypot(m[1])).fold(0.0, f64::max);
    let axial = draft.chains.iter().map(|chain| chain.modulus * chain.height * draft.width);
    let rounding = 1e-13 * axial.fold(0.0, f64::max) * stretched * nodes;
    let allowed = nodes * (ALLOWED * *peak + rounding);
    let force = sum[0].hypot(sum[1]);
    let moment = sum[2].abs() / reach;
    (force.max(moment) > allowed).then(|| {
        format!("force {force:.2e}, moment {moment:.2e} of {size:.2e}, peak {:.2e}", *peak)
    })
}
