//! Whether a run converged and balances.
//!
//! What must balance, in every committed increment:
//!
//! ```text
//!   supports   sum RF = 0,  sum (x x RF + RM) = 0       to the sum of the residuals allowed
//!   each pair  RF of the body + sum A (p n - tau t) = 0,  moments about its reference too
//! ```
//!
//! The second is exact but for rounding: nothing but contact acts on the body.

use super::deck::{Kind, Model};
use slideline::model::Dof;
use slideline::observe::{Ending, Event, Frame, IterationReport, Observer, Stop};
use slideline::{Job, ReadOptions, SolveOptions, solve};
use std::collections::BTreeMap;
use std::ops::ControlFlow;

/// Iterations after which a run counts as hanging.
const HANGS: usize = 50_000;
/// What rounding may leave of the balance of a pair, in the largest force that
/// has acted on the body [1].
const ROUNDING: f64 = 1e-9;

/// What came of a model.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// Every step was walked, every increment balances.
    Balanced,
    /// Every step was walked, but an increment does not balance: what is off.
    Unbalanced(String),
    /// A diagnosis ended it: its code and message.
    Diagnosed(&'static str, String),
    /// What must never be: NaN, no end, a deck that cannot be read.
    Broken(String),
}

/// What came of a model, with its numbers.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// In a word.
    pub outcome: Outcome,
    /// Newton iterations.
    pub iterations: usize,
    /// Committed increments.
    pub increments: usize,
    /// Largest sum of the supports' forces, in forces then acting [1];
    /// increments with less than 1e-6 of the peak are held against that.
    pub imbalance: f64,
    /// The same in sums of allowed residuals [1]: at most 1.
    pub of_allowed: f64,
    /// Largest imbalance of a pair, in the peak force of its body [1].
    pub pair: f64,
}

/// Runs a model and judges it.
pub fn judge(model: &Model) -> Verdict {
    let read = Job::read_text("random", &model.text, &ReadOptions::default());
    let mut watch = Watch::default();
    let outcome = match &read.model {
        None => Outcome::Broken(format!("does not read: {:?}", read.diagnostics)),
        Some(read) => {
            watch.body = read.nodes.find(model.body).filter(|_| model.nodal);
            let ending = solve(read, &SolveOptions::default(), &mut watch);
            watch.outcome(&ending)
        }
    };
    Verdict {
        outcome,
        iterations: watch.iterations,
        increments: watch.states.len(),
        imbalance: watch.imbalance(),
        of_allowed: watch.states.iter().map(|state| state.of_allowed).fold(0.0, f64::max),
        pair: watch.pair(),
    }
}

/// An increment.
struct State {
    /// Sum of the reactions, and of their magnitudes [F].
    force: [f64; 2],
    /// Larger one of the sums of forces and moments, in what is allowed [1].
    of_allowed: f64,
    /// What the body lacks [F], and the force on it [F].
    body: [f64; 2],
}

#[derive(Default)]
struct Watch {
    body: Option<usize>,
    iterations: usize,
    allowed: [f64; 2],
    states: Vec<State>,
    /// Largest sum of the magnitudes of reactions so far [F].
    peak: f64,
    nan: bool,
    hangs: bool,
}

impl Watch {
    fn imbalance(&self) -> f64 {
        let peak = self.states.iter().map(|state| state.force[1]).fold(0.0, f64::max);
        let ratio = |s: &State| s.force[0] / s.force[1].max(1e-6 * peak).max(f64::MIN_POSITIVE);
        self.states.iter().map(ratio).fold(0.0, f64::max)
    }

    fn pair(&self) -> f64 {
        let largest = |k: usize| self.states.iter().map(|s| s.body[k]).fold(0.0, f64::max);
        largest(0) / largest(1).max(f64::MIN_POSITIVE)
    }

    fn outcome(&self, ending: &Ending) -> Outcome {
        if self.nan {
            return Outcome::Broken("NaN".to_owned());
        }
        let worst = self.states.iter().map(|state| state.of_allowed).fold(0.0, f64::max);
        match ending {
            _ if self.hangs => Outcome::Broken("no end".to_owned()),
            Ending::NotConverged(_, why) if why.message.is_empty() || why.code.0 >= "SL09" => {
                Outcome::Broken(format!("{why:?}"))
            }
            Ending::NotConverged(_, why) => Outcome::Diagnosed(why.code.0, why.message.clone()),
            Ending::Stopped(..) => Outcome::Broken("stopped".to_owned()),
            Ending::Completed(_) if worst > 1.0 => {
                Outcome::Unbalanced(format!("supports: {worst:.2} of what is allowed"))
            }
            Ending::Completed(_) if self.pair() > ROUNDING => {
                Outcome::Unbalanced(format!("pair: {:.1e} of its peak", self.pair()))
            }
            Ending::Completed(_) => Outcome::Balanced,
        }
    }

    fn iteration(&mut self, report: &IterationReport) -> ControlFlow<Stop> {
        self.iterations += 1;
        self.allowed = [report.force.allowed, report.moment.allowed];
        self.hangs = self.iterations > HANGS;
        if self.hangs { ControlFlow::Break(Stop::Interrupted) } else { ControlFlow::Continue(()) }
    }

    fn committed(&mut self, frame: &Frame<'_>) {
        let (mut sum, mut size, mut reach) = ([0.0; 3], 0.0, 0.0_f64);
        let nodes = frame.model.nodes.len();
        for node in 0..nodes {
            let [x, y] = position(frame, node);
            let [fx, fy, m] =
                [Dof::U1, Dof::U2, Dof::UR3].map(|dof| frame.nodal.reaction(node, dof));
            sum[0] += fx;
            sum[1] += fy;
            sum[2] += m + x * fy - y * fx;
            size += fx.abs() + fy.abs();
            reach = reach.max(x.hypot(y));
        }
        let force = sum[0].hypot(sum[1]);
        let most = nodes as f64 * self.allowed[0];
        let most_moment = nodes as f64 * self.allowed[1] + reach * most;
        // What rounding leaves, once forces of the present peak have acted.
        self.peak = self.peak.max(size);
        let rounding = 1e-12 * self.peak;
        let of_allowed =
            (force / (most + rounding)).max(sum[2].abs() / (most_moment + reach * rounding));
        let body = self.body.map_or([0.0, 0.0], |body| body_balance(frame, body));
        self.nan |= !(size.is_finite() && body[0].is_finite() && frame.energy.balance.is_finite());
        self.nan |= frame.contact.iter().any(|row| !(row.pressure + row.shear.size()).is_finite());
        self.states.push(State { force: [force, size], of_allowed, body });
    }
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Iteration(report) => return self.iteration(report),
            Event::Committed(frame) => self.committed(frame),
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

fn position(frame: &Frame<'_>, node: usize) -> [f64; 2] {
    let start = frame.model.nodes.position(node);
    let u = [Dof::U1, Dof::U2].map(|dof| frame.nodal.displacement(node, dof));
    [start[0] + u[0], start[1] + u[1]]
}

/// What is missing in the balance of the body [F], moments over the largest
/// arm; and the size of the forces on it [F].
fn body_balance(frame: &Frame<'_>, body: usize) -> [f64; 2] {
    let centre = position(frame, body);
    let [fx, fy, m] = [Dof::U1, Dof::U2, Dof::UR3].map(|dof| frame.nodal.reaction(body, dof));
    let (mut sum, mut size, mut arm) = ([fx, fy, m], fx.abs() + fy.abs(), 0.0_f64);
    let slave = frame
        .model
        .contact_pairs
        .iter()
        .any(|pair| matches!(pair.master, slideline::model::Master::SlideLine(_)));
    for row in frame.contact.iter().filter(|row| row.pressure != 0.0) {
        let [nx, ny, _] = row.normal;
        let [p, tau] = [row.pressure * row.area, row.shear[0] * row.area];
        // the travel is 90 degrees clockwise of the normal
        let force = [p * nx - tau * ny, p * ny + tau * nx];
        let sign = if slave { 1.0 } else { -1.0 };
        let from = [row.position[0] - centre[0], row.position[1] - centre[1]];
        sum[0] += sign * force[0];
        sum[1] += sign * force[1];
        sum[2] += sign * (from[0] * force[1] - from[1] * force[0]);
        size += p.abs();
        arm = arm.max(from[0].hypot(from[1]));
    }
    let moment = if arm > 0.0 { sum[2].abs() / arm } else { 0.0 };
    [sum[0].hypot(sum[1]).max(moment), size]
}

/// Counts over many models.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Models by kind: run, converged, converged and balanced.
    pub kinds: BTreeMap<Kind, [usize; 3]>,
    /// Diagnoses by kind and code.
    pub codes: BTreeMap<(Kind, &'static str), usize>,
    /// Numbers of the well-posed models that failed, of all without a known
    /// cause, and of those that broke, with the reason.
    pub remarkable: Vec<(u64, Kind, String)>,
    /// Models whose supports balance to 1e-4 of the forces then acting, or of
    /// 1e-6 of the peak.
    pub strict: usize,
    /// Largest imbalance of a pair [1].
    pub pair: f64,
    /// Largest imbalance of supports in what is allowed [1].
    pub of_allowed: f64,
    /// Increments and iterations.
    pub work: [usize; 2],
    /// Broken ones.
    pub broken: usize,
}

impl Tally {
    /// Takes a verdict in.
    pub fn add(&mut self, model: &Model, verdict: &Verdict) {
        let count = self.kinds.entry(model.kind).or_default();
        count[0] += 1;
        self.work[0] += verdict.increments;
        self.work[1] += verdict.iterations;
        let mut remark = |why: String| self.remarkable.push((model.number, model.kind, why));
        match &verdict.outcome {
            Outcome::Balanced => {
                count[1] += 1;
                count[2] += 1;
            }
            Outcome::Unbalanced(why) => {
                count[1] += 1;
                remark(why.clone());
            }
            Outcome::Diagnosed(code, why) => {
                *self.codes.entry((model.kind, code)).or_default() += 1;
                if model.kind == Kind::WellPosed || *code == UNKNOWN {
                    remark(format!("{code} {why}"));
                }
            }
            Outcome::Broken(why) => {
                self.broken += 1;
                remark(format!("BROKEN {why}"));
            }
        }
        if matches!(verdict.outcome, Outcome::Balanced | Outcome::Unbalanced(_)) {
            self.strict += usize::from(verdict.imbalance < 1e-4);
            self.pair = self.pair.max(verdict.pair);
            self.of_allowed = self.of_allowed.max(verdict.of_allowed);
        }
    }

    /// Models that ended without a known cause.
    pub fn unknown(&self) -> usize {
        let unknown = self.codes.iter().filter(|((_, code), _)| *code == UNKNOWN);
        unknown.map(|(_, count)| count).sum()
    }

    /// Models.
    pub fn models(&self) -> usize {
        self.kinds.values().map(|count| count[0]).sum()
    }

    /// Run, converged, converged and balanced, of the well-posed ones.
    pub fn well_posed(&self) -> [usize; 3] {
        self.kinds.get(&Kind::WellPosed).copied().unwrap_or_default()
    }
}

/// The code that names no cause.
pub const UNKNOWN: &str = "SL0501";

impl std::fmt::Display for Tally {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        writeln!(f, "kind: models, converged, converged and balanced; diagnoses")?;
        for (kind, [run, converged, balanced]) in &self.kinds {
            write!(f, "{kind:?}: {run}, {converged}, {balanced};")?;
            for ((_, code), count) in self.codes.iter().filter(|((own, _), _)| own == kind) {
                write!(f, " {code} {count}")?;
            }
            writeln!(f)?;
        }
        let converged: usize = self.kinds.values().map(|count| count[1]).sum();
        writeln!(
            f,
            "{} models, {} increments, {} iterations; without a known cause {}, broken {}",
            self.models(),
            self.work[0],
            self.work[1],
            self.unknown(),
            self.broken
        )?;
        writeln!(
            f,
            "of {converged} converged: supports to 1e-4 of the forces then acting {}; at worst {:.2} \
             of the residuals allowed; pairs to {:.1e} of their peak",
            self.strict, self.of_allowed, self.pair
        )
    }
}
