//! `JOB.sensitivity.csv`: how the columns of `JOB.history.csv` follow the parameters of the deck, a row
//! per converged increment, parameter and column.

use crate::facts::Facts;
use crate::file::{Growing, WriteError};
use crate::history::columns;
use crate::job::JobFiles;
use crate::kept::Kept;
use crate::number::push_shortest;
use crate::writer::Writer;
use slideline_model::NodeIndex;
use slideline_results::NodeComponent;
use slideline_solve::observe::{Event, Sensitivity, StepReport};
use std::fmt::Write as _;

const ENDING: &str = ".sensitivity.csv";
const HEADING: &str = "step,increment,time,response,parameter,derivative,one_sided\n";

/// `JOB.sensitivity.csv`.
pub(crate) struct Sensitivities<'a> {
    job: JobFiles,
    parameters: &'a [String],
    /// Columns of nodes, with their names.
    responses: Vec<(String, NodeIndex, NodeComponent)>,
    file: Option<Growing>,
}

impl<'a> Sensitivities<'a> {
    /// The file of a job; without parameters there is none.
    pub fn new(job: &JobFiles, facts: &Facts<'a>) -> Self {
        let parameters = facts.sensitivities;
        Self { job: job.clone(), parameters, responses: Vec::new(), file: None }
    }

    fn begin(&mut self, report: &StepReport<'_>) -> Result<(), WriteError> {
        if self.parameters.is_empty() || self.file.is_some() {
            return Ok(());
        }
        let columns = columns(report.start.nodal.dofs());
        for node in report.model.history_nodes() {
            let name = report.model.nodes.label(node);
            let own = columns.iter().copied();
            self.responses.extend(own.map(|own| (format!("{name}.{}", own.name()), node, own)));
        }
        self.file = Some(self.job.begin(ENDING, HEADING)?);
        Ok(())
    }

    fn take(&mut self, told: &Sensitivity<'_>) -> Result<(), WriteError> {
        let (Some(file), Some(parameter)) = (&mut self.file, self.parameters.get(told.parameter))
        else {
            return Ok(());
        };
        let (step, increment, time) = told.at();
        let mut start = format!("{step},{increment},");
        push_shortest(&mut start, time);
        for (name, node, column) in &self.responses {
            let text = &mut file.text;
            let _ = write!(text, "{start},{name},{parameter},"); // a String takes any text
            push_shortest(text, told.of(|frame| column.value(frame, *node)));
            text.push_str(if told.one_sided { ",1\n" } else { ",0\n" });
        }
        file.flush()
    }
}

impl Writer for Sensitivities<'_> {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match event {
            Event::StepBegin(report) => self.begin(report),
            Event::Sensitivity(told) => self.take(told),
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.file(ENDING, self.file.as_ref());
    }
}
