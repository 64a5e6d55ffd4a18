//! What happens beside a run: recording, progress, Ctrl-C, faults of Python functions.

use crate::friction::Failures;
use crate::recording::Recording;
use pyo3::prelude::*;
use slideline::{Event, Observer, Stop};
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// How often signals are looked for: people do not notice less.
const PAUSE: Duration = Duration::from_millis(20);

/// Watches a run that has let the interpreter go.
pub(crate) struct Watch {
    /// What it has seen.
    pub recording: Recording,
    /// Called after every increment.
    told: Option<Py<PyAny>>,
    failures: Arc<Failures>,
    looked: Instant,
    /// What a signal or a function of progress raised; it ends the run.
    pub raised: Option<PyErr>,
}

impl Watch {
    pub fn new(recording: Recording, told: Option<Py<PyAny>>, failures: Arc<Failures>) -> Self {
        Self { recording, told, failures, looked: Instant::now(), raised: None }
    }

    /// What a law of friction raised that it should not.
    pub fn failure(&self) -> Option<PyErr> {
        self.failures.take()
    }

    /// Looks for signals; a second one ends the run within the increment.
    fn look(&mut self) -> ControlFlow<Stop> {
        if self.looked.elapsed() < PAUSE {
            return ControlFlow::Continue(());
        }
        self.looked = Instant::now();
        match (Python::attach(|py| py.check_signals()), &self.raised) {
            (Ok(()), _) => ControlFlow::Continue(()),
            (Err(raised), None) => {
                self.raised = Some(raised);
                ControlFlow::Continue(())
            }
            (Err(_), Some(_)) => ControlFlow::Break(Stop::Interrupted),
        }
    }

    /// Says that an increment has converged; where something was raised the run ends here.
    fn tell(&mut self, event: &Event<'_>) -> ControlFlow<Stop> {
        let Event::Committed(frame) = event else { return ControlFlow::Continue(()) };
        if let (Some(told), None) = (&self.told, &self.raised) {
            let iterations = frame.severe_iterations + frame.equilibrium_iterations;
            let said = (frame.step, frame.increment, frame.total_time, iterations);
            self.raised = Python::attach(|py| told.call1(py, said)).err();
        }
        match self.raised {
            Some(_) => ControlFlow::Break(Stop::Interrupted),
            None => ControlFlow::Continue(()),
        }
    }
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        self.recording.take(&event);
        self.look()?;
        if self.failures.any() {
            return ControlFlow::Break(Stop::Interrupted);
        }
        self.tell(&event)
    }
}
