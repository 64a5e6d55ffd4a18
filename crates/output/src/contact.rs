//! `JOB.contact.csv`: a row per slave point that is or was in contact.

use crate::file::{Growing, WriteError};
use crate::history::push_time;
use crate::job::JobFiles;
use crate::number::push_shortest;
use crate::restart::Kept;
use crate::writers::Writer;
use slideline_solve::observe::{ContactRow, Event, Frame};
use std::fmt::Write as _;

/// Writes `JOB.contact.csv`.
pub(crate) struct Contact {
    job: JobFiles,
    file: Option<Growing>,
}

const HEADER: &str = concat!(
    "step,increment,time,pair,node,status,COPEN,CPRESS,CSHEAR1,CSLIP1,friction,",
    "x,y,normal_x,normal_y,area\n",
);

impl Contact {
    pub fn new(job: &JobFiles) -> Self {
        Self { job: job.clone(), file: None }
    }

    fn begin(&mut self) -> Result<(), WriteError> {
        if self.file.is_none() {
            self.file = Some(Growing::begin(&self.job, ".contact.csv", HEADER)?);
        }
        Ok(())
    }

    fn rows(&mut self, frame: &Frame<'_>) -> Result<(), WriteError> {
        let Some(file) = &mut self.file else { return Ok(()) };
        for row in frame.contact.iter().filter(|row| row.ever_closed) {
            push_row(&mut file.text, frame, row);
        }
        file.flush()
    }
}

fn push_row(text: &mut String, frame: &Frame<'_>, row: &ContactRow) {
    push_time(text, frame);
    push_name(text, &frame.model.contact_pairs[row.pair].name);
    // A String takes any text.
    let _ = write!(text, ",{},{}", frame.model.nodes.label(row.node), row.status.word());
    for value in [row.opening, row.pressure, row.shear, row.slip] {
        text.push(',');
        push_shortest(text, value);
    }
    let _ = write!(text, ",{}", row.friction.word()); // a String takes any text
    let place = [row.position[0], row.position[1], row.normal[0], row.normal[1], row.area];
    for value in place {
        text.push(',');
        push_shortest(text, value);
    }
    text.push('\n');
}

/// A name, quoted where it would break the row.
pub(crate) fn push_name(text: &mut String, name: &str) {
    if name.contains([',', '"', '\n']) {
        let _ = write!(text, "\"{}\"", name.replace('"', "\"\"")); // a String takes any text
    } else {
        text.push_str(name);
    }
}

impl Writer for Contact {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match event {
            Event::StepBegin(_) => self.begin(),
            Event::Committed(frame) => self.rows(frame),
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.file(".contact.csv", self.file.as_ref());
    }
}
