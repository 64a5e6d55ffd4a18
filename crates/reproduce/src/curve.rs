//! A run of the study and its increments.

use crate::cases::Case;
use crate::failure::Failure;
use slideline::model::Dof;
use slideline::observe::{ContactRow, Ending, Frame, Totals};
use slideline::{Event, Job, Model, Observer, ReadOptions, SolveOptions, Stop};
use std::ops::ControlFlow;

/// A converged increment.
#[derive(Clone, Debug)]
pub struct Increment {
    /// Displacement of the circle along Y [L], or rotation of the cam [1].
    pub motion: f64,
    /// Its reaction: RF2 [F], or RM3 about the pivot [F L].
    pub reaction: f64,
    /// Force of the support on the circle or cam [F].
    pub resultant: [f64; 2],
    /// Iterations, severe ones included.
    pub iterations: usize,
    /// Current places of all nodes, in model order [L].
    pub places: Vec<[f64; 2]>,
    /// Contact points.
    pub contact: Vec<ContactRow>,
}

/// A run that came to its end.
#[derive(Clone, Debug)]
pub struct Curve {
    /// What was run.
    pub case: Case,
    /// The model as the deck gave it.
    pub model: Model,
    /// Its increments.
    pub increments: Vec<Increment>,
    /// Counts.
    pub totals: Totals,
    /// Friction work that the onset dropped [F L].
    pub dropped_work: f64,
}

impl Curve {
    /// The reactions, one an increment [F or F L].
    pub fn reactions(&self) -> Vec<f64> {
        self.increments.iter().map(|row| row.reaction).collect()
    }

    /// The motions, one an increment [L or 1].
    pub fn motions(&self) -> Vec<f64> {
        self.increments.iter().map(|row| row.motion).collect()
    }
}

/// Reads and runs a deck of ours, in its own increments or in so many equal ones.
pub(crate) fn run(case: Case, increments: Option<usize>) -> Result<Curve, Failure> {
    let options = ReadOptions { friction_onset: Some(case.onset), ..ReadOptions::default() };
    let read = Job::read_text(case.deck.name, case.deck.text, &options);
    let failed = |reason: String| Failure::Run { what: case.words(), reason };
    let Some(mut model) = read.model else {
        let said: Vec<String> = read.diagnostics.into_iter().map(|said| said.message).collect();
        return Err(failed(said.join("; ")));
    };
    for (step, count) in model.steps.iter_mut().zip(increments) {
        let size = step.procedure.period / count as f64;
        step.procedure.initial = size;
        step.procedure.maximum = size;
        step.max_increments = 2 * count;
    }
    let Some(driven) = model.steps.iter().flat_map(|s| &s.prescribed).find(|p| p.moves()) else {
        return Err(failed("nothing moves".to_owned()));
    };
    let mut watch =
        Watch { node: driven.node, dof: case.model.driven(), rows: Vec::new(), dropped: 0.0 };
    match slideline::solve(&model, &SolveOptions::default(), &mut watch) {
        Ending::Completed(totals) => {
            Ok(Curve { case, increments: watch.rows, dropped_work: watch.dropped, totals, model })
        }
        Ending::NotConverged(_, diagnosis) => Err(failed(diagnosis.message)),
        Ending::Stopped(..) => Err(failed("stopped".to_owned())),
    }
}

/// Keeps what figures and table need.
struct Watch {
    node: usize,
    dof: Dof,
    rows: Vec<Increment>,
    dropped: f64,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            self.dropped = frame.energy.dropped_friction;
            self.rows.push(self.increment(frame));
        }
        ControlFlow::Continue(())
    }
}

impl Watch {
    fn increment(&self, frame: &Frame<'_>) -> Increment {
        let place = |node: usize| {
            let [x, y, _] = frame.model.nodes.position(node);
            let moved = |dof| frame.nodal.displacement(node, dof);
            [x + moved(Dof::U1), y + moved(Dof::U2)]
        };
        Increment {
            motion: frame.nodal.displacement(self.node, self.dof),
            reaction: frame.nodal.reaction(self.node, self.dof),
            resultant: [Dof::U1, Dof::U2].map(|dof| frame.nodal.reaction(self.node, dof)),
            iterations: frame.severe_iterations + frame.equilibrium_iterations,
            places: (0..frame.model.nodes.len()).map(place).collect(),
            contact: frame.contact.to_vec(),
        }
    }
}
