//! The models of the study and their runs.
//!
//! ```text
//!   decks x onsets --> runs, side by side --> curves
//!                                               |--> figures, table, page
//!   closed forms and exact references ----------'
//! ```

use crate::decks::{self, Deck, Family};
use crate::failure::Failure;
use crate::fine;
use crate::theory::{References, Theory, references};
use rayon::prelude::*;
use slideline::model::Dof;
use slideline::observe::{ContactRow, Ending, Frame, Totals};
use slideline::{Event, Job, Model, Observer, Onset, ReadOptions, SolveOptions, Stop};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Coefficient of friction of the models that have friction [1].
pub const FRICTION: f64 = 0.3;
/// Equal increments of every model.
pub const INCREMENTS: usize = 20;

/// A finite element model of the paper, or ours beside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModelKind {
    /// First problem, contact elements on 24 beams.
    IrsCoarse,
    /// First problem, contact elements on 99 beams.
    IrsFine,
    /// First problem, contact elements on the circle.
    Isl,
    /// First problem, contact integrated along 24 beams; not in the paper.
    Integrated,
    /// Second problem, slave nodes every 3 degrees.
    Cam,
    /// Second problem, slave nodes every 4 degrees.
    CamWide,
    /// Second problem, contact integrated along 24 beams; not in the paper.
    CamIntegrated,
}

impl ModelKind {
    /// In the order of the study.
    pub const ALL: [Self; 7] = [
        Self::IrsCoarse,
        Self::IrsFine,
        Self::Isl,
        Self::Integrated,
        Self::Cam,
        Self::CamWide,
        Self::CamIntegrated,
    ];

    /// In a few words.
    pub fn name(self) -> &'static str {
        match self {
            Self::IrsCoarse => "IRS coarse",
            Self::IrsFine => "IRS fine",
            Self::Isl => "ISL coarse",
            Self::Integrated => "integrated",
            Self::Cam => "ISL cam 3 deg",
            Self::CamWide => "ISL cam 4 deg",
            Self::CamIntegrated => "integrated cam",
        }
    }

    /// Number of the paper's problem.
    pub fn problem(self) -> u8 {
        if matches!(self, Self::Cam | Self::CamWide | Self::CamIntegrated) { 2 } else { 1 }
    }

    /// The model whose references are its own too: where contact is integrated
    /// there is no slave node, and the share of one that softened contact at
    /// one point asks for is that of the ISL model of the same problem.
    pub fn shares_references_of(self) -> Self {
        match self {
            Self::Integrated => Self::Isl,
            Self::CamIntegrated => Self::Cam,
            own => own,
        }
    }

    /// The reference that a model of its kind goes to when everything is made
    /// fine but the share of a slave node.
    pub fn exact(self) -> Theory {
        match self {
            Self::Integrated | Self::CamIntegrated => Theory::Continuum,
            _ => Theory::Softened,
        }
    }

    /// Dof that drives the model.
    pub fn driven(self) -> Dof {
        if self.problem() == 1 { Dof::U2 } else { Dof::UR3 }
    }

    fn decks(self) -> Family {
        match self {
            Self::IrsCoarse => decks::IRS_COARSE,
            Self::IrsFine => decks::IRS_FINE,
            Self::Isl => decks::ISL,
            Self::Integrated => decks::INTEGRATED,
            Self::Cam => decks::CAM,
            Self::CamWide => decks::CAM_WIDE,
            Self::CamIntegrated => decks::CAM_INTEGRATED,
        }
    }
}

/// How sticking is imposed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stick {
    /// There is no friction.
    Frictionless,
    /// Elastic slip.
    Penalty,
    /// Multipliers.
    Lagrange,
}

impl Stick {
    /// The word of files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Frictionless => "none",
            Self::Penalty => "penalty",
            Self::Lagrange => "lagrange",
        }
    }
}

/// One run of the study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Case {
    /// The model.
    pub model: ModelKind,
    /// How sticking is imposed.
    pub stick: Stick,
    /// When friction is called.
    pub onset: Onset,
    /// Its deck.
    pub deck: Deck,
}

impl Case {
    /// Coefficient of friction [1].
    pub fn friction(&self) -> f64 {
        if self.stick == Stick::Frictionless { 0.0 } else { FRICTION }
    }

    /// In a line.
    pub fn words(&self) -> String {
        let onset = slideline::output::onset_word(self.onset);
        match self.stick {
            Stick::Frictionless => format!("{}, no friction", self.deck.name),
            Stick::Penalty | Stick::Lagrange => format!("{}, {onset}", self.deck.name),
        }
    }
}

/// Every run of the study: each model without friction, and with friction
/// under both logics, with both algorithms.
pub fn cases() -> Vec<Case> {
    let of = |model: ModelKind| {
        let [none, penalty, lagrange] = model.decks();
        let case = move |stick, onset, deck| Case { model, stick, onset, deck };
        [
            case(Stick::Frictionless, Onset::Immediate, none),
            case(Stick::Penalty, Onset::Immediate, penalty),
            case(Stick::Lagrange, Onset::Immediate, lagrange),
            case(Stick::Penalty, Onset::Matfru, penalty),
            case(Stick::Lagrange, Onset::Matfru, lagrange),
        ]
    };
    ModelKind::ALL.into_iter().flat_map(of).collect()
}

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

/// Everything that was computed.
#[derive(Clone, Debug)]
pub struct Study {
    /// One curve a case, in the order of [`cases`].
    pub curves: Vec<Curve>,
    /// What the curves are held against.
    pub references: References,
    /// The three formulations of 24 beams in small increments.
    pub fine: Vec<fine::Errors>,
}

impl Study {
    /// The curve of a case.
    pub fn curve(&self, model: ModelKind, stick: Stick, onset: Onset) -> Option<&Curve> {
        self.curves.iter().find(|curve| {
            let case = &curve.case;
            case.model == model && case.stick == stick && case.onset == onset
        })
    }
}

/// A piece of work that is done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Pieces done so far, this one included.
    pub done: usize,
    /// All pieces.
    pub total: usize,
    /// What was done.
    pub what: String,
}

/// Told of every piece of work that is done, from any thread.
pub type Tell<'a> = &'a (dyn Fn(&Progress) + Sync);

/// Counts pieces of work.
pub(crate) struct Count<'a> {
    done: AtomicUsize,
    total: usize,
    tell: Tell<'a>,
}

impl<'a> Count<'a> {
    pub fn new(total: usize, tell: Tell<'a>) -> Self {
        Self { done: AtomicUsize::new(0), total, tell }
    }

    pub fn tick(&self, what: String) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        (self.tell)(&Progress { done, total: self.total, what });
    }
}

/// Runs every case and finds every reference, side by side.
pub(crate) fn compute(count: &Count<'_>) -> Result<Study, Failure> {
    let curves = || {
        let each = |case: Case| {
            let curve = run(case, None)?;
            count.tick(case.words());
            Ok(curve)
        };
        cases().into_par_iter().map(each).collect::<Result<Vec<Curve>, Failure>>()
    };
    let all = || rayon::join(curves, || fine::curves(count));
    let (references, (curves, small)) = rayon::join(|| references(count), all);
    let references = references?;
    Ok(Study { curves: curves?, fine: fine::errors(&small?, &references), references })
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
            let [x, y] = frame.model.nodes.plane(node);
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
