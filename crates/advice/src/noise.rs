//! Noise, measured while a run goes on.
//!
//! ```text
//!   RF |  /\/\/\    roughness and reversals of driven reactions
//!      | /          contact changes per increment, penetration/c0
//!      +--------> t
//! ```

use slideline_diag::{Code, Diagnostic, Span};
use slideline_measures::{DEFAULT_NOISE_FLOOR, maximum, reversals, roughness};
use slideline_model::{ContactPair, Dof, Model, NodeIndex, NormalLaw};
use slideline_solve::observe::{Event, Frame, Observer, Status, Stop};
use std::ops::ControlFlow;

/// Roughness above which a driven reaction is called noisy [1].
const ROUGH: f64 = 0.01;
/// Wiggles below this fraction of the peak are not counted [1].
const FLOOR: f64 = 0.002;
/// Penetration above which a softened law has been pressed too far, in c0 [1].
const DEEP: f64 = 3.0;

/// Watches a run and measures its noise: one pass over the contact points of
/// every increment, a few numbers kept for each.
#[derive(Clone, Debug, Default)]
pub struct Noise {
    curves: Vec<Curve>,
    pairs: Vec<Pair>,
    increments: usize,
}

#[derive(Clone, Debug)]
struct Curve {
    node: NodeIndex,
    label: u64,
    dof: Dof,
    origin: Span,
    values: Vec<f64>,
}

#[derive(Clone, Debug, Default)]
struct Pair {
    name: String,
    origin: Option<Span>,
    clearance: Option<f64>,
    closed: Vec<bool>,
    changes: usize,
    penetration: (f64, u64),
}

/// Noise of one driven reaction.
#[derive(Clone, Debug, PartialEq)]
pub struct ReactionNoise {
    /// Node label and component, such as `9999.RF2`.
    pub name: String,
    /// Roughness [1]; none for fewer than three increments or a zero curve.
    pub roughness: Option<f64>,
    /// Sign changes of the slope beyond a small fraction of the peak.
    pub reversals: usize,
}

/// Noise of one contact pair.
#[derive(Clone, Debug, PartialEq)]
pub struct PairNoise {
    /// The pair's name.
    pub name: String,
    /// Points that opened or closed, per increment [1].
    pub changes_per_increment: f64,
    /// Deepest penetration [L].
    pub penetration: f64,
    /// The same in units of c0 [1], for a softened law.
    pub penetration_over_c0: Option<f64>,
}

/// What was measured.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct NoiseSummary {
    /// Increments seen.
    pub increments: usize,
    /// Driven reactions.
    pub reactions: Vec<ReactionNoise>,
    /// Contact pairs.
    pub pairs: Vec<PairNoise>,
}

impl Noise {
    /// The measures so far.
    pub fn summary(&self) -> NoiseSummary {
        let reactions = self.curves.iter().map(|curve| ReactionNoise {
            name: format!("{}.{}", curve.label, curve.dof.reaction_name()),
            roughness: roughness(&curve.values),
            reversals: reversals(&curve.values, FLOOR.max(DEFAULT_NOISE_FLOOR)),
        });
        let pairs = self.pairs.iter().map(|pair| PairNoise {
            name: pair.name.clone(),
            changes_per_increment: pair.changes as f64 / self.increments.max(1) as f64,
            penetration: pair.penetration.0,
            penetration_over_c0: pair.clearance.map(|c0| pair.penetration.0 / c0),
        });
        NoiseSummary {
            increments: self.increments,
            reactions: reactions.collect(),
            pairs: pairs.collect(),
        }
    }

    /// What the measures ask to be said.
    pub fn findings(&self) -> Vec<Diagnostic> {
        let mut said: Vec<Diagnostic> = self.curves.iter().filter_map(noisy).collect();
        for pair in &self.pairs {
            said.extend(self.changing(pair));
            said.extend(pressed(pair));
        }
        said
    }

    /// Takes note of an event that others watch as well.
    pub fn watch(&mut self, event: &Event<'_>) {
        match event {
            Event::StepBegin(report) if report.step == 1 => self.begin(report.model),
            Event::Committed(frame) => self.follow(frame),
            _ => {}
        }
    }

    fn begin(&mut self, model: &Model) {
        for step in &model.steps {
            for driven in step.prescribed.iter().filter(|p| p.moves()) {
                let known = |curve: &Curve| curve.node == driven.node && curve.dof == driven.dof;
                if !self.curves.iter().any(known) {
                    self.curves.push(Curve {
                        node: driven.node,
                        label: model.nodes.label(driven.node),
                        dof: driven.dof,
                        origin: driven.origin,
                        values: Vec::new(),
                    });
                }
            }
        }
        self.pairs = model.contact_pairs.iter().map(Pair::new).collect();
    }

    fn follow(&mut self, frame: &Frame<'_>) {
        self.increments += 1;
        for curve in &mut self.curves {
            curve.values.push(frame.nodal.reaction(curve.node, curve.dof));
        }
        let mut place = vec![0usize; self.pairs.len()];
        for row in frame.contact {
            let (Some(pair), Some(at)) = (self.pairs.get_mut(row.pair), place.get_mut(row.pair))
            else {
                continue;
            };
            let closed = row.status != Status::Open;
            match pair.closed.get_mut(*at) {
                Some(was) => pair.changes += usize::from(std::mem::replace(was, closed) != closed),
                None => {
                    pair.closed.push(closed);
                    pair.changes += usize::from(closed);
                }
            }
            *at += 1;
            if closed && -row.opening > pair.penetration.0 {
                pair.penetration = (-row.opening, frame.model.nodes.label(row.node));
            }
        }
    }

    /// SL0611: contact moves to other points in nearly every increment.
    fn changing(&self, pair: &Pair) -> Option<Diagnostic> {
        let rate = pair.changes as f64 / self.increments.max(1) as f64;
        if rate <= 1.0 || self.increments < 5 {
            return None;
        }
        let message = format!(
            "contact of {} changed at {rate:.1} points per increment: the force is handed from \
             node to node, and a friction onset other than IMMEDIATE would drop it",
            pair.name
        );
        Some(Diagnostic::advice(Code("SL0611"), message).at(pair.origin).help(
            "keep FRICTION ONSET=IMMEDIATE; for a smoother force give the slaves to the body on \
             which the contact point rests, or use *CONTACT PAIR, TYPE=SURFACE TO SURFACE",
        ))
    }
}

impl Pair {
    fn new(pair: &ContactPair) -> Self {
        let clearance = match pair.interaction.normal {
            NormalLaw::Exponential { clearance, .. }
            | NormalLaw::CalculixExponential { clearance, .. } => Some(clearance),
            _ => None,
        };
        Self { name: pair.name.clone(), origin: Some(pair.origin), clearance, ..Self::default() }
    }
}

/// SL0610: a driven reaction with more turns than a smooth slide has.
fn noisy(curve: &Curve) -> Option<Diagnostic> {
    let rough = roughness(&curve.values)?;
    let turns = reversals(&curve.values, FLOOR);
    if rough <= ROUGH || turns < 3 {
        return None;
    }
    let message = format!(
        "the reaction {} at node {} is noisy: roughness {:.1} % of its peak of {:.3e}, {turns} \
         reversals in {} increments",
        curve.dof.reaction_name(),
        curve.label,
        100.0 * rough,
        maximum(&curve.values).unwrap_or(0.0),
        curve.values.len()
    );
    Some(Diagnostic::advice(Code("SL0610"), message).at(curve.origin).help(
        "swap the roles so that the curved body carries the slaves, use *CONTACT PAIR, \
         TYPE=SURFACE TO SURFACE, or refine the side with the slaves",
    ))
}

/// SL0612: a softened law pressed beyond what it was made for.
fn pressed(pair: &Pair) -> Option<Diagnostic> {
    let ratio = pair.penetration.0 / pair.clearance?;
    if ratio <= DEEP {
        return None;
    }
    let message = format!(
        "node {} of {} penetrates by {:.3e}, {ratio:.1} times c0: the contact is softer than the \
         law promises",
        pair.penetration.1, pair.name, pair.penetration.0
    );
    Some(
        Diagnostic::advice(Code("SL0612"), message)
            .at(pair.origin)
            .help("raise p0 on *SURFACE CONTACT, SOFTENED to the order of the contact pressure"),
    )
}

impl Observer for Noise {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        self.watch(&event);
        ControlFlow::Continue(())
    }
}
