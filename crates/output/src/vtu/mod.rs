//! `JOB_0000.vtu` ... and `JOB.pvd`: deformed states for viewers. The number
//! of a state is that of the converged increments before it, of all steps; 0
//! is the start. Without a request there is one for every increment.
//! `JOB.failed.vtu` is where a run gave up, with the forces nothing balances.
//!
//! ```text
//!   o---o---o---o    beams, springs, slave surfaces
//!      .---.
//!     (     )        rigid surfaces in chords, moved with their body
//! ```
//!
//! Points stand where they are in that state; `displacement` leads there
//! from the undeformed position.

mod array;
mod grid;
mod held;

use crate::file::{WriteError, at, read_text, replace};
use crate::job::{FAILED, JobFiles};
use crate::kept::Kept;
use crate::number::push_shortest;
use crate::state_numbers::StateNumbers;
use crate::writer::Writer;
use array::Text;
pub(crate) use grid::Grid;

use slideline_solve::observe::{Event, Frame, StepReport, Unconverged};
use std::fmt::Write as _;
use std::time::{Duration, Instant};

/// The list of states is renewed at most this often while a run goes on, so
/// that long runs do not spend their time on it.
const RENEWAL: Duration = Duration::from_secs(1);

/// Writes the states and their list.
pub(crate) struct States {
    job: JobFiles,
    grid: Option<Grid>,
    /// The text of a state, written anew for each.
    text: Text,
    list: String,
    numbers: StateNumbers,
    /// Converged increments of all steps.
    increments: usize,
    first_time: String,
    listed: Option<Instant>,
}

impl States {
    pub fn new(job: &JobFiles) -> Self {
        let (list, first_time, text) = Default::default();
        let (numbers, listed) = (StateNumbers::default(), None);
        Self {
            job: job.clone(),
            grid: None,
            text,
            list,
            numbers,
            increments: 0,
            first_time,
            listed,
        }
    }

    /// The list of the states that a run which goes on finds; their times
    /// stand in `JOB.energy.csv`, a row for each increment.
    fn recall(&mut self, kept: &Kept) -> Result<(), WriteError> {
        let path = self.job.path(".energy.csv");
        let text = read_text(&path).map_err(at(&path))?;
        let times = text.lines().skip(1).filter_map(|row| row.split(',').nth(2));
        let mut states = kept.states.iter().peekable();
        for (number, time) in std::iter::once(kept.first_time.as_str()).chain(times).enumerate() {
            if states.next_if_eq(&number).is_some() {
                self.list(number, time);
            }
        }
        self.increments = kept.increments;
        Ok(())
    }

    fn list(&mut self, number: usize, time: &str) {
        if number == 0 {
            time.clone_into(&mut self.first_time);
        }
        let name = escaped(&self.job.state_name(number));
        // A String takes any text.
        let _ =
            writeln!(self.list, "    <DataSet timestep=\"{time}\" part=\"0\" file=\"{name}\"/>");
        self.numbers.push(number);
    }

    /// The start, unless no step leaves states.
    fn begin(&mut self, report: &StepReport<'_>) -> Result<(), WriteError> {
        let first = self.increments == 0 && self.numbers.is_empty();
        if first && report.model.steps.iter().any(|step| step.output.has_states()) {
            return self.state(&report.start);
        }
        Ok(())
    }

    fn increment(&mut self, frame: &Frame<'_>) -> Result<(), WriteError> {
        self.increments += 1;
        if state_is_due(frame) { self.state(frame) } else { Ok(()) }
    }

    fn state(&mut self, frame: &Frame<'_>) -> Result<(), WriteError> {
        let grid = self.grid.get_or_insert_with(|| Grid::new(frame.model));
        let name = self.job.state_name(self.increments);
        grid.file(&mut self.text, frame, None);
        replace(&self.job.folder().join(&name), &self.text.letters)?;
        let mut time = String::new();
        push_shortest(&mut time, frame.total_time);
        self.list(self.increments, &time);
        if self.listed.is_none_or(|written| written.elapsed() >= RENEWAL) {
            self.write_list()?;
        }
        Ok(())
    }

    /// Beside the states, for it is none: `JOB.failed.vtu`.
    fn unconverged(&mut self, state: &Unconverged<'_>) -> Result<(), WriteError> {
        let grid = self.grid.get_or_insert_with(|| Grid::new(state.frame.model));
        grid.file(&mut self.text, &state.frame, Some(state));
        replace(&self.job.path(FAILED), &self.text.letters)
    }

    fn write_list(&mut self) -> Result<(), WriteError> {
        let text = format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" \
             byte_order=\"LittleEndian\">\n  <Collection>\n{}  </Collection>\n</VTKFile>\n",
            self.list
        );
        replace(&self.job.path(".pvd"), text.as_bytes())?;
        self.listed = Some(Instant::now());
        Ok(())
    }
}

/// Whether a committed increment leaves a state.
pub(crate) fn state_is_due(frame: &Frame<'_>) -> bool {
    let step = frame.model.steps.get(frame.step.wrapping_sub(1));
    step.is_none_or(|step| step.output.state_is_due(frame.increment, frame.last_of_step))
}

/// A text as an XML attribute.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

impl Writer for States {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match event {
            Event::StepBegin(report) if report.resumed => match self.job.clone().kept() {
                Some(kept) => self.recall(kept),
                None => Ok(()),
            },
            Event::StepBegin(report) => self.begin(report),
            Event::Committed(frame) => self.increment(frame),
            Event::Unconverged(state) => self.unconverged(state),
            Event::End(_) if !self.numbers.is_empty() => self.write_list(),
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.states = self.numbers.clone();
        kept.increments = self.increments;
        kept.first_time.clone_from(&self.first_time);
    }
}
