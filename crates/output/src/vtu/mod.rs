//! `JOB_0000.vtu` ... and `JOB.pvd`: deformed states for viewers; and
//! `JOB.failed.vtu`, where a run gave up, with the forces nothing balances.
//!
//! ```text
//!   o---o---o---o    beams, springs, slave surfaces
//!      .---.
//!     (     )        rigid surfaces in chords, moved with their body
//! ```
//!
//! Points stand where they are in that state; `displacement` leads there
//! from the undeformed position.

pub(crate) mod base64;
mod grid;

use crate::file::{WriteError, at, replace};
use crate::job::{FAILED, JobFiles};
use crate::number::push_shortest;
use crate::restart::Kept;
use crate::writers::Writer;
use grid::Grid;
use slideline_solve::observe::{Event, Frame, Unconverged};
use std::fmt::Write as _;
use std::time::{Duration, Instant};

/// The list of states is renewed at most this often while a run goes on, so
/// that long runs do not spend their time on it.
const RENEWAL: Duration = Duration::from_secs(1);

/// Writes the states and their list.
pub(crate) struct States {
    job: JobFiles,
    grid: Option<Grid>,
    list: String,
    count: usize,
    first_time: String,
    listed: Option<Instant>,
}

impl States {
    pub fn new(job: &JobFiles) -> Self {
        let (list, first_time) = (String::new(), String::new());
        Self { job: job.clone(), grid: None, list, count: 0, first_time, listed: None }
    }

    /// The list of the states that a run which goes on finds: the start and
    /// one for each row of `JOB.energy.csv`.
    fn recall(&mut self, kept: &Kept) -> Result<(), WriteError> {
        let path = self.job.path(".energy.csv");
        let text = std::fs::read_to_string(&path).map_err(at(&path))?;
        let times = text.lines().skip(1).filter_map(|row| row.split(',').nth(2));
        for time in std::iter::once(kept.first_time.as_str()).chain(times).take(kept.states) {
            self.list(time);
        }
        Ok(())
    }

    fn list(&mut self, time: &str) {
        if self.count == 0 {
            time.clone_into(&mut self.first_time);
        }
        let name = escaped(&self.job.state_name(self.count));
        // A String takes any text.
        let _ =
            writeln!(self.list, "    <DataSet timestep=\"{time}\" part=\"0\" file=\"{name}\"/>");
        self.count += 1;
    }

    fn state(&mut self, frame: &Frame<'_>) -> Result<(), WriteError> {
        let grid = self.grid.get_or_insert_with(|| Grid::new(frame.model));
        let name = self.job.state_name(self.count);
        replace(&self.job.folder().join(&name), grid.state(frame).as_bytes())?;
        let mut time = String::new();
        push_shortest(&mut time, frame.total_time);
        self.list(&time);
        if self.listed.is_none_or(|written| written.elapsed() >= RENEWAL) {
            self.write_list()?;
        }
        Ok(())
    }

    /// Beside the states, for it is none: `JOB.failed.vtu`.
    fn unconverged(&mut self, state: &Unconverged<'_>) -> Result<(), WriteError> {
        let grid = self.grid.get_or_insert_with(|| Grid::new(state.frame.model));
        replace(&self.job.path(FAILED), grid.unconverged(state).as_bytes())
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
            Event::StepBegin(report) if self.count == 0 => self.state(&report.start),
            Event::Committed(frame) => self.state(frame),
            Event::Unconverged(state) => self.unconverged(state),
            Event::End(_) if self.count > 0 => self.write_list(),
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.states = self.count;
        kept.first_time.clone_from(&self.first_time);
    }
}
