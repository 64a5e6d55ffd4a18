//! All writers of a job as one observer.

use crate::facts::{Facts, Status};
use crate::file::WriteError;
use crate::job::JobFiles;
use crate::kept::Kept;
use crate::lock::Lock;
use crate::restart::{self, Saved};
use crate::rows::Csv;
use crate::summary::Summary;
use crate::writer::Writer;
use crate::{ccx, contact, dat, element, energy, frd, history, msg, pair, sensitivity, sta, vtu};
use slideline_measures::NoiseSummary;
use slideline_solve::Checkpoint;
use slideline_solve::observe::{Event, Observer, Stop};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// What was computed in less is sooner computed again than waited for.
const WORTH: Duration = Duration::from_secs(1);

type Make = for<'a> fn(&JobFiles, &Facts<'a>) -> Box<dyn Writer + 'a>;

/// One kind of file and who writes it.
struct Kind {
    name: &'static str,
    make: Make,
}

/// The registry. `JOB.json` stands apart: it is written before everything
/// else and after it.
const REGISTRY: &[Kind] = &[
    Kind { name: "sta", make: |job, facts| Box::new(sta::Sta::new(job, facts.formats)) },
    Kind { name: "cvg", make: |job, facts| Box::new(ccx::Cvg::new(job, facts.formats)) },
    Kind { name: "msg", make: |job, facts| Box::new(msg::Msg::new(job, facts)) },
    Kind { name: "dat", make: |job, facts| Box::new(dat::Dat::new(job, facts)) },
    Kind { name: "history.csv", make: |job, _| Box::new(Csv::<history::History>::new(job)) },
    Kind { name: "contact.csv", make: |job, _| Box::new(Csv::<contact::Contact>::new(job)) },
    Kind { name: "pair.csv", make: |job, _| Box::new(Csv::<pair::Pairs>::new(job)) },
    Kind { name: "energy.csv", make: |job, _| Box::new(Csv::<energy::Energy>::new(job)) },
    Kind { name: "element.csv", make: |job, _| Box::new(Csv::<element::Solids>::new(job)) },
    Kind { name: "beam.csv", make: |job, _| Box::new(Csv::<element::Beams>::new(job)) },
    Kind {
        name: "sensitivity.csv",
        make: |job, facts| Box::new(sensitivity::Sensitivities::new(job, facts)),
    },
    Kind { name: "frd", make: |job, facts| Box::new(frd::Frd::new(job, facts)) },
    Kind { name: "vtu", make: |job, _| Box::new(vtu::States::new(job)) },
];

/// Names of the registered kinds of files.
pub fn kinds() -> impl Iterator<Item = &'static str> {
    REGISTRY.iter().map(|kind| kind.name)
}

/// Writes all files of a run as it goes.
pub struct Writers<'a> {
    job: JobFiles,
    writers: Vec<Box<dyn Writer + 'a>>,
    summary: Summary<'a>,
    failure: Option<WriteError>,
    /// `JOB.rst` stands apart: it is written when everything else is, and
    /// says where.
    restart: restart::Writer<'a>,
    lock: Option<Lock>,
    ended: bool,
    /// How many steps the run has.
    steps: usize,
    /// When the files were forced to the disk; at first when the run began.
    forced: Instant,
}

impl<'a> Writers<'a> {
    /// Removes the files of an earlier run of the job and begins new ones.
    ///
    /// # Errors
    /// When the folder cannot be made, an old file cannot be removed, or the
    /// summary cannot be written.
    pub fn create(job: JobFiles, facts: Facts<'a>) -> Result<Self, WriteError> {
        job.clear()?;
        let lock = Lock::take(&job);
        let writers = REGISTRY.iter().map(|kind| (kind.make)(&job, &facts)).collect();
        let restart = restart::Writer::new(facts.clone(), None);
        let summary = Summary::begin(&job, facts)?;
        Ok(Self::with(job, writers, summary, restart, lock))
    }

    /// Cuts the files of a job back to a saved state and goes on with them.
    ///
    /// # Errors
    /// When a file is not there any more, or cannot be cut.
    pub fn resume(job: &JobFiles, facts: Facts<'a>, saved: Saved) -> Result<Self, WriteError> {
        let lock = Lock::take(job);
        restart::cut_back(job, &saved)?;
        let Saved { checkpoint, kept, memory, place, .. } = saved;
        let job = job.going_on(kept);
        let writers = REGISTRY.iter().map(|kind| (kind.make)(&job, &facts)).collect();
        let restart = restart::Writer::new(facts.clone(), Some(place));
        let summary = Summary::resume(&job, facts, memory, &checkpoint)?;
        Ok(Self::with(job, writers, summary, restart, lock))
    }

    fn with(
        job: JobFiles,
        writers: Vec<Box<dyn Writer + 'a>>,
        summary: Summary<'a>,
        restart: restart::Writer<'a>,
        lock: Option<Lock>,
    ) -> Self {
        let (failure, ended, steps, forced) = (None, false, 0, Instant::now());
        Self { job, writers, summary, failure, restart, lock, ended, steps, forced }
    }

    /// Where the files are.
    pub fn job(&self) -> &JobFiles {
        &self.job
    }

    /// Why results are incomplete, if they are.
    pub fn failure(&self) -> Option<&WriteError> {
        self.failure.as_ref()
    }

    /// Takes in the noise of the run, which `JOB.json` says at the end.
    pub fn measured(&mut self, noise: &NoiseSummary) {
        self.summary.measured(noise);
    }

    fn note(&mut self, result: Result<(), WriteError>) {
        if let (None, Err(error)) = (&self.failure, result) {
            self.failure = Some(error);
        }
    }

    /// Waits for the disk at the end of a step, not in every increment: a
    /// machine that loses its power loses one step at most.
    fn step_is_safe(&mut self, checkpoint: &Checkpoint<'_>) -> Result<(), WriteError> {
        let at_the_end = checkpoint.step >= self.steps; // which waits itself
        if checkpoint.last_of_step() && !at_the_end { self.force() } else { Ok(()) }
    }

    fn force(&mut self) -> Result<(), WriteError> {
        if self.forced.elapsed() < WORTH {
            return Ok(());
        }
        self.forced = Instant::now();
        self.job.synchronise()
    }

    /// Takes note of an event. Every writer is asked even when one fails:
    /// what can be kept is kept.
    pub fn write(&mut self, event: &Event<'_>) -> ControlFlow<Stop> {
        let mut writers = std::mem::take(&mut self.writers);
        for writer in &mut writers {
            let result = writer.event(event);
            self.note(result);
        }
        self.writers = writers;
        let result = match event {
            Event::StepBegin(report) => {
                self.restart.begin(report);
                self.steps = report.model.steps.len();
                self.summary.watch(event);
                Ok(())
            }
            Event::Checkpoint(checkpoint)
                if self.failure.is_none() && self.restart.is_due(checkpoint) =>
            {
                let mut kept = Kept::default();
                self.writers.iter().for_each(|writer| writer.keep(&mut kept));
                let saved = self.restart.write(&self.job, checkpoint, kept, &self.summary);
                saved.and_then(|()| self.step_is_safe(checkpoint))
            }
            Event::Checkpoint(checkpoint) if self.failure.is_none() => {
                self.step_is_safe(checkpoint)
            }
            Event::End(ending) => {
                self.ended = true;
                let status = match &self.failure {
                    Some(_) => Status::OutputError,
                    None => Status::of(ending),
                };
                let written = self.summary.end(status, ending);
                self.lock = None;
                written.and_then(|()| self.force())
            }
            _ => {
                self.summary.watch(event);
                Ok(())
            }
        };
        self.note(result);
        match &self.failure {
            Some(error) => ControlFlow::Break(Stop::OutputFailed(error.to_string())),
            None => ControlFlow::Continue(()),
        }
    }
}

impl Observer for Writers<'_> {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        self.write(&event)
    }
}

impl Drop for Writers<'_> {
    /// A panic on its way up must not leave a summary that says `running`.
    fn drop(&mut self) {
        if !self.ended && std::thread::panicking() {
            let _ = self.summary.give_up(); // the panic is the thing to tell
        }
    }
}
