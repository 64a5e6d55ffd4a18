//! Whether a body went through a beam, or a beam through a body.
//!
//! ```text
//!     side of the centre, as seen from the nearest beam:
//!            (  )                  -----------
//!        -----------     start         (  )       passed
//! ```
//!
//! Beams are looked at as chords between nodes; what chords miss of a curve is
//! allowed for. A disc that goes round the end of a beam has passed nothing.

use super::classes::{Case, Pair, Side, Solid};
use super::files::{Files, State, side_nodes};

/// What is crossed or overlapped, each kind once.
pub fn violations(case: &Case, files: &Files) -> Vec<(&'static str, String)> {
    let mut found: Vec<(&'static str, String)> = Vec::new();
    for (k, pair) in case.draft.pairs.iter().enumerate() {
        let Side::Body(body) = pair.master else { continue };
        for state in &files.states {
            if let Some(why) = overlap(case, state, (k, pair), body) {
                let why = format!("step {} inc {}: {why}", state.step + 1, state.increment);
                found.push(("overlap", why));
                break;
            }
        }
        if let Some(why) = passed(case, files, pair, body) {
            found.push(("passed", why));
        }
    }
    found.dedup_by_key(|(kind, _)| *kind);
    found
}

/// Where a node stands.
fn place(case: &Case, state: Option<&State>, node: usize) -> [f64; 2] {
    let motion = state.map_or([0.0; 3], |state| state.motion[node]);
    [0, 1].map(|c| case.draft.nodes[node][c] + motion[c])
}

/// A point in the body's own first place.
fn in_body(case: &Case, state: &State, body: usize, at: [f64; 2]) -> [f64; 2] {
    let node = case.draft.bodies[body].node;
    let now = place(case, Some(state), node);
    let (sin, cos) = state.motion[node][2].sin_cos();
    let [x, y] = [at[0] - now[0], at[1] - now[1]];
    let first = case.draft.nodes[node];
    [first[0] + cos * x + sin * y, first[1] - sin * x + cos * y]
}

/// Depth below the surface; negative outside.
fn depth(solid: &Solid, at: [f64; 2]) -> f64 {
    match solid {
        Solid::Disc(centre, radius) => radius - (at[0] - centre[0]).hypot(at[1] - centre[1]),
        Solid::Convex(corners) => {
            let next = corners.iter().cycle().skip(1);
            let inside = corners.iter().zip(next).map(|(a, b)| {
                let [x, y] = [b[0] - a[0], b[1] - a[1]];
                (x * (at[1] - a[1]) - y * (at[0] - a[0])) / x.hypot(y).max(1e-300)
            });
            inside.fold(f64::INFINITY, f64::min)
        }
    }
}

/// A slave node deeper than any point owns up to.
fn overlap(case: &Case, state: &State, (k, pair): (usize, &Pair), body: usize) -> Option<String> {
    let own = state.points.iter().filter(|point| point.pair == k);
    let known = own.map(|point| -point.open).fold(0.0, f64::max);
    // Rows of integrated contact are means over elements, and middle nodes
    // stand off the line through the ends by a part of the sagitta.
    let mesh = longest(side_nodes(case, &pair.slave).iter().map(|&node| case.draft.nodes[node]));
    let integrated = 3.0 * known + (0.04 * mesh * mesh).max(2e-3);
    let allowed = if pair.integrated { integrated } else { 1.01 * known + 1e-5 };
    let solid = &case.draft.bodies[body].solid;
    side_nodes(case, &pair.slave).iter().find_map(|&node| {
        let at = in_body(case, state, body, place(case, Some(state), node));
        let deep = depth(solid, at);
        let number = case.placed.numbers[node];
        (deep > allowed).then(|| format!("node {number} {deep:.2e} deep, said {known:.2e}"))
    })
}

/// Longest chord between neighbours.
fn longest(points: impl Iterator<Item = [f64; 2]> + Clone) -> f64 {
    let chords = points.clone().zip(points.skip(1));
    chords.map(|(a, b)| (b[0] - a[0]).hypot(b[1] - a[1])).fold(0.0, f64::max)
}

/// Nearest point of a row of chords: distance and side; no side at an end.
fn nearest(points: &[[f64; 2]], centre: [f64; 2]) -> (f64, Option<f64>) {
    let mut best = (f64::INFINITY, None);
    for (k, ends) in points.windows(2).enumerate() {
        let [x, y] = [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]];
        let [a, b] = [centre[0] - ends[0][0], centre[1] - ends[0][1]];
        let part = ((a * x + b * y) / (x * x + y * y).max(1e-300)).clamp(0.0, 1.0);
        let far = (a - part * x).hypot(b - part * y);
        if far < best.0 {
            let end = (k == 0 && part == 0.0) || (k + 2 == points.len() && part == 1.0);
            best = (far, (!end).then_some((x * b - y * a).signum()));
        }
    }
    best
}

/// A disc on the other side of its beam, or a chord deep in it.
fn passed(case: &Case, files: &Files, pair: &Pair, body: usize) -> Option<String> {
    let (Side::Chain(chain), Solid::Disc(_, radius)) =
        (&pair.slave, &case.draft.bodies[body].solid)
    else {
        return None;
    };
    let chain = &case.draft.chains[*chain];
    let row = |state: Option<&State>| {
        chain.nodes.iter().map(|&node| place(case, state, node)).collect::<Vec<_>>()
    };
    let node = case.draft.bodies[body].node;
    let start = row(None);
    let side = nearest(&start, place(case, None, node)).1?;
    let mesh = longest(start.iter().copied());
    for state in &files.states {
        let (far, now) = nearest(&row(Some(state)), place(case, Some(state), node));
        let now = now?; // gone round the end
        let at = format!("step {} inc {}", state.step + 1, state.increment);
        if now != side {
            return Some(format!("{at}: the body is on the other side"));
        }
        let open = state.points.iter().map(|point| -point.open).fold(0.0, f64::max);
        let chords = mesh * mesh / (2.0 * radius);
        if radius - far > 2.0 * open + chords.min(0.5 * radius) + 2e-3 {
            return Some(format!("{at}: a beam lies {:.2e} deep in the body", radius - far));
        }
    }
    None
}
