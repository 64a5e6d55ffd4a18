//! CSV files that grow: a heading, then rows of every converged increment.

use crate::file::{Growing, WriteError};
use crate::job::JobFiles;
use crate::kept::Kept;
use crate::number::push_shortest;
use crate::writer::Writer;
use slideline_solve::observe::{Event, Frame, StepReport};
use std::fmt::{Display, Write as _};

/// What stands in one kind of CSV file.
pub(crate) trait Rows {
    /// Ending of the file, once the columns are known.
    fn ending(&self) -> &'static str;

    /// Columns behind step, increment and time; `None` where the deck does not
    /// ask for the file. Asked once, when the run begins.
    fn columns(&mut self, report: &StepReport<'_>) -> Option<String>;

    /// The rows of an increment.
    fn rows(&self, sheet: &mut Sheet<'_>, frame: &Frame<'_>);
}

/// Takes the rows of an increment, cell by cell.
pub(crate) struct Sheet<'a> {
    text: &'a mut String,
    /// `step,increment,time`, as every row begins.
    start: String,
}

impl<'a> Sheet<'a> {
    /// A sheet for the rows of one increment.
    pub fn new(text: &'a mut String, frame: &Frame<'_>) -> Self {
        let mut start = format!("{},{},", frame.step, frame.increment);
        push_shortest(&mut start, frame.total_time);
        Self { text, start }
    }

    /// Begins a row.
    pub fn row(&mut self) -> &mut Self {
        self.text.push_str(&self.start);
        self
    }

    /// A cell without commas.
    pub fn cell(&mut self, cell: impl Display) -> &mut Self {
        let _ = write!(self.text, ",{cell}"); // a String takes any text
        self
    }

    /// A name, quoted where it would break the row.
    pub fn name(&mut self, name: &str) -> &mut Self {
        match name.contains([',', '"', '\n']) {
            true => self.cell(format_args!("\"{}\"", name.replace('"', "\"\""))),
            false => self.cell(name),
        }
    }

    /// Numbers, a cell each.
    pub fn numbers(&mut self, values: impl IntoIterator<Item = f64>) -> &mut Self {
        for value in values {
            self.text.push(',');
            push_shortest(self.text, value);
        }
        self
    }

    /// Ends the row.
    pub fn end(&mut self) {
        self.text.push('\n');
    }
}

/// Writes a CSV file.
pub(crate) struct Csv<R> {
    job: JobFiles,
    rows: R,
    begun: bool,
    file: Option<Growing>,
}

impl<R: Rows + Default> Csv<R> {
    /// The file of a job.
    pub fn new(job: &JobFiles) -> Self {
        Self { job: job.clone(), rows: R::default(), begun: false, file: None }
    }
}

impl<R: Rows> Writer for Csv<R> {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match (event, &mut self.file) {
            (Event::StepBegin(report), None) if !self.begun => {
                self.begun = true;
                if let Some(columns) = self.rows.columns(report) {
                    let heading = format!("step,increment,time,{columns}\n");
                    self.file = Some(self.job.begin(self.rows.ending(), &heading)?);
                }
                Ok(())
            }
            (Event::Committed(frame), Some(file)) => {
                self.rows.rows(&mut Sheet::new(&mut file.text, frame), frame);
                file.flush()
            }
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.file(self.rows.ending(), self.file.as_ref());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_quoted_where_they_must_be() {
        let mut text = String::new();
        let mut sheet = Sheet { text: &mut text, start: "1,2,0.5".to_owned() };
        sheet.row().name("A").name("a,\"b\"").cell(7).numbers([0.5, 1e-9]).end();
        assert_eq!(text, "1,2,0.5,A,\"a,\"\"b\"\"\",7,0.5,1e-9\n");
    }
}
