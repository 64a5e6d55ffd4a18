//! An analysis under way: what it runs on, and how a step may be left early.

use super::neighbours;
use super::options::{Options, TangentCheck};
use super::shown::Rows;
use crate::contact::Reached;
use crate::observe::reports::Totals;
use crate::observe::{Ending, Event, Observer, Stop};
use crate::overpulled::OverpulledBeams;
use crate::plan::Numbering;
use crate::problem::Means;
use crate::sensitivity::Varied;
use crate::start::Start;
use crate::state::State;
use crate::values::Values;
use slideline_diag::Diagnostic;
use slideline_mech::contact::enforcement::Enforcement;
use slideline_model::Model;
use std::ops::ControlFlow;

/// Where the states and rows of a run stand, to be used again.
#[derive(Default)]
pub struct Room {
    pub(super) committed: State,
    pub(super) trial: State,
    pub(super) rows: Rows,
    pub(super) start: Start<'static>,
    /// States of an increment that the pattern follows.
    pub(super) reached: Vec<Reached>,
    pub(super) neighbours: neighbours::Room,
}

impl Room {
    /// The undeformed model of a plan.
    pub fn begin(&mut self, plan: &Numbering) {
        let [points, state_variables, elements] = plan.sizes;
        let states = (state_variables, elements);
        self.committed.begin(plan.dofs.len(), points, states);
        self.trial.begin(plan.dofs.len(), points, states);
        self.start.references.to_mut().clear();
    }
}

/// A run under way.
pub struct Analysis<'a> {
    pub(super) model: &'a Model,
    pub(super) plan: &'a Numbering,
    pub(super) values: &'a Values,
    pub(super) means: Means<'a>,
    pub(super) observer: &'a mut dyn Observer,
    pub(super) committed: &'a mut State,
    pub(super) trial: &'a mut State,
    pub(super) start: &'a mut Start<'static>,
    pub(super) reached: &'a mut Vec<Reached>,
    /// Counts of the run so far.
    pub totals: Totals,
    /// Whether the observer has seen what came before.
    pub resumes: bool,
    pub(super) check_tangent: TangentCheck,
    pub(super) enforcement: Option<Enforcement>,
    /// One fault of the tangent is enough to be told.
    pub(super) tangent_is_wrong: bool,
    /// Whether it was said that masters leave no room.
    pub(super) room_is_judged: bool,
    /// Whether it was said that an edge of a master stands in a face of the slave.
    pub(super) edges_are_judged: bool,
    /// Whether a slave node in the part of its master was told of.
    pub(super) strayed_are_told: bool,
    /// Clouds of nodes of which it was said that they have turned far.
    pub(super) turned_means: Vec<usize>,
    /// Beams that are pulled beyond their shear stiffness.
    pub(super) overpulled: OverpulledBeams,
    /// Nodes that slid off the ends of their masters, pair by pair.
    pub(super) slid_off: Vec<SlidOff>,
    pub(super) rows: &'a mut Rows,
    /// What the run is differentiated by, and the state and start before the step.
    pub varied: Option<&'a mut Varied>,
    pub(super) before: Option<Box<(State, Start<'static>)>>,
    pub(super) neighbours: &'a mut neighbours::Room,
}

/// Nodes of a pair that slid off an end of its master.
pub(super) struct SlidOff {
    /// Number of the pair.
    pub pair: usize,
    /// How many did.
    pub times: usize,
    /// What is to be said of the last one.
    pub last: Diagnostic,
}

/// Why a step was left before its end.
pub(super) enum Left {
    Stopped(Stop),
    Failed(Box<Diagnostic>),
}

impl<'a> Analysis<'a> {
    /// A run from the undeformed model on.
    pub fn new(
        model: &'a Model,
        (plan, values): (&'a Numbering, &'a Values),
        (options, means): (&Options, Means<'a>),
        (room, observer): (&'a mut Room, &'a mut dyn Observer),
    ) -> Self {
        let Room { committed, trial, rows, start, reached, neighbours } = room;
        rows.heaviest.begin(&[]);
        Self {
            model,
            plan,
            values,
            means,
            observer,
            committed,
            trial,
            start,
            reached,
            totals: Totals::default(),
            resumes: false,
            check_tangent: options.check_tangent,
            enforcement: options.enforcement,
            tangent_is_wrong: false,
            room_is_judged: false,
            edges_are_judged: false,
            strayed_are_told: false,
            turned_means: Vec::new(),
            overpulled: OverpulledBeams::default(),
            slid_off: Vec::new(),
            rows,
            varied: None,
            before: None,
            neighbours,
        }
    }

    /// How the run ends that was left.
    pub(super) fn left(&self, left: Left) -> Ending {
        match left {
            Left::Stopped(stop) => Ending::Stopped(self.totals, stop),
            Left::Failed(diagnosis) => Ending::NotConverged(self.totals, *diagnosis),
        }
    }

    /// Tells the observer, who may stop the run.
    pub(super) fn tell(&mut self, event: Event<'_>) -> Result<(), Left> {
        match self.observer.event(event) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(stop) => Err(Left::Stopped(stop)),
        }
    }
}
