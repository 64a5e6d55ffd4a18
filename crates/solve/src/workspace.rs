//! A plan at work: values of a model, linear systems, scratch.
//!
//! ```text
//!   Plan --new--> Workspace --run(model)--> ending
//!                     ^  |
//!                     '--'  run(another model of the same outline): nothing is parsed,
//!                           numbered, ordered or allocated again
//! ```

use crate::checkpoint::Checkpoint;
use crate::linear_systems::LinearSystems;
use crate::newton::Scratch;
use crate::observe::reports::Totals;
use crate::observe::{Ending, Event, Observer};
use crate::plan::{Plan, PlanMismatch};
use crate::problem::Means;
use crate::run::analysis::{Analysis, Room};
use crate::run::options::Options;
use crate::sensitivity::{Parameter, SensitivityFault, Varied};
use crate::values::Values;
use rayon::ThreadPool;
use slideline_model::Model;
use std::sync::Arc;

/// Everything that the runs of a plan use again: one for each thread that runs.
pub struct Workspace {
    plan: Plan,
    options: Options,
    pool: Option<Arc<ThreadPool>>,
    linear_systems: LinearSystems,
    values: Values,
    scratch: Scratch,
    room: Room,
}

impl Workspace {
    /// One for a plan, empty.
    pub fn new(plan: &Plan, options: &Options) -> Self {
        let pool = thread_pool(options.threads);
        Self {
            plan: plan.clone(),
            options: options.clone(),
            linear_systems: options.linear_systems.on_threads(pool.as_ref()),
            pool,
            values: Values::default(),
            scratch: Scratch::default(),
            room: Room::default(),
        }
    }

    /// Runs every step of a model and tells the observer. The results are those of
    /// [`run`](crate::run()), bit for bit, whatever was run before; with the room of a run
    /// before, nothing is allocated.
    ///
    /// Errors: a model that is not of the outline of the plan; nothing was told.
    pub fn run(
        &mut self,
        model: &Model,
        observer: &mut dyn Observer,
    ) -> Result<Ending, PlanMismatch> {
        self.analyse((model, None), observer, |mut analysis, scratch| analysis.steps(scratch))
    }

    /// The same, differentiated: behind every committed increment the observer is told how it follows
    /// each parameter, as [`Event::Sensitivity`](crate::observe::Event::Sensitivity). Times of
    /// increments are held. docs/theory.md section 13.
    ///
    /// # Errors
    /// A model that is not of the outline of the plan; a parameter that the model cannot be
    /// differentiated by. Nothing was told.
    pub fn run_differentiated(
        &mut self,
        model: &Model,
        parameters: &[Parameter],
        observer: &mut dyn Observer,
    ) -> Result<Result<Ending, PlanMismatch>, SensitivityFault> {
        match self.varied(model, parameters) {
            Ok((varied, faults)) => match faults.into_iter().next() {
                Some(fault) => Err(fault),
                None => Ok(self.run_varied(model, varied, observer)),
            },
            Err(mismatch) => Ok(Err(mismatch)),
        }
    }

    /// What a run of the model is to be differentiated by: those of these parameters that it has
    /// derivatives by, and why it has none by the others. The models beside it are read here, so that
    /// [`run_varied`](Self::run_varied) reads none of them again.
    ///
    /// # Errors
    /// A model that is not of the outline of the plan.
    pub fn varied(
        &self,
        model: &Model,
        parameters: &[Parameter],
    ) -> Result<(Varied, Vec<SensitivityFault>), PlanMismatch> {
        match self.plan.mismatch(model) {
            Some(mismatch) => Err(mismatch),
            None => Ok(Varied::of(parameters, (&self.plan, model), &self.options.user_frictions)),
        }
    }

    /// A differentiated run by what [`varied`](Self::varied) gave for the same model.
    ///
    /// # Errors
    /// A model that is not of the outline of the plan. Nothing was told.
    pub fn run_varied(
        &mut self,
        model: &Model,
        mut varied: Varied,
        observer: &mut dyn Observer,
    ) -> Result<Ending, PlanMismatch> {
        let is_varied = varied.names().len() > 0;
        let of = (model, is_varied.then_some(&mut varied));
        self.analyse(of, observer, |mut analysis, scratch| analysis.steps(scratch))
    }

    /// Goes on from a checkpoint of the model; see [`resume`](crate::resume) and
    /// [`run_from`](crate::run_from).
    pub(crate) fn go_on(
        &mut self,
        model: &Model,
        from: &Checkpoint<'_>,
        observer: &mut dyn Observer,
        (totals, resumes): (Totals, bool),
    ) -> Result<Ending, PlanMismatch> {
        self.analyse((model, None), observer, |mut analysis, scratch| {
            (analysis.totals, analysis.resumes) = (totals, resumes);
            analysis.go_on(from, scratch)
        })
    }

    fn analyse(
        &mut self,
        (model, varied): (&Model, Option<&mut Varied>),
        observer: &mut dyn Observer,
        steps: impl FnOnce(Analysis<'_>, &mut Scratch) -> Ending,
    ) -> Result<Ending, PlanMismatch> {
        if let Some(mismatch) = self.plan.mismatch(model) {
            return Err(mismatch);
        }
        let Self { plan, options, pool, linear_systems, values, scratch, room } = self;
        values.take(plan, model, &options.user_frictions)?;
        let means = Means { pool: pool.as_deref(), linear_systems };
        room.begin(plan);
        let mut analysis =
            Analysis::new(model, (&**plan, &*values), (&*options, means), (room, &mut *observer));
        analysis.varied = varied;
        let ending = steps(analysis, scratch);
        let _ = observer.event(Event::End(&ending)); // the run is over: there is nothing to stop
        Ok(ending)
    }
}

fn thread_pool(threads: usize) -> Option<Arc<ThreadPool>> {
    if threads <= 1 {
        return None;
    }
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().ok().map(Arc::new)
}
