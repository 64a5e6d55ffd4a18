//! What there is to say about a deck or a run, as objects.

use pyo3::prelude::*;
use slideline::Diagnostic;
use slideline::diag::Sources;
use slideline::output::{card, columns};

/// What there is to say about a deck or a run.
#[pyclass(frozen, get_all, module = "slideline")]
pub(crate) struct Diagnosis {
    /// Code, such as `SL0304`.
    code: &'static str,
    /// `error`, `warning`, `advice` or `note`.
    severity: &'static str,
    /// What is the matter.
    message: String,
    /// What to do; None where there is nothing.
    help: Option<String>,
    /// The file it stands in; None where it has no place.
    file: Option<String>,
    /// The line, from 1.
    line: Option<usize>,
    /// First column and one past the last, from 1.
    columns: Option<(usize, usize)>,
    /// The keyword with its star whose card it stands in.
    card: Option<String>,
    /// A card that would mend it.
    suggestion: Option<String>,
}

impl Diagnosis {
    /// That of a diagnostic.
    pub fn of(said: &Diagnostic, sources: &Sources) -> Self {
        let at = said.span.and_then(|span| sources.locate(span));
        let columns = at.as_ref().map(|at| columns(at, sources, said.span).into());
        Self {
            code: said.code.0,
            severity: said.severity.word(),
            message: said.message.clone(),
            help: said.help.clone(),
            line: at.as_ref().map(|at| at.line),
            file: at.map(|at| at.file),
            columns,
            card: card(said.span, sources),
            suggestion: said.suggestion().map(str::to_owned),
        }
    }

    /// Those of diagnostics, in their order.
    pub fn all(said: &[Diagnostic], sources: &Sources) -> Vec<Self> {
        said.iter().map(|said| Self::of(said, sources)).collect()
    }
}

#[pymethods]
impl Diagnosis {
    /// The page of the code, as `slideline explain` prints it (Markdown).
    fn explain(&self) -> &'static str {
        slideline::code_page(self.code).unwrap_or_default()
    }

    fn __str__(&self) -> String {
        let mut text = format!("{}[{}]: {}", self.severity, self.code, self.message);
        if let (Some(file), Some(line), Some((column, _))) = (&self.file, self.line, self.columns) {
            text.push_str(&format!("\n  --> {file}:{line}:{column}"));
        }
        if let Some(help) = &self.help {
            text.push_str(&format!("\n  = help: {help}"));
        }
        text
    }

    fn __repr__(&self) -> String {
        format!("<Diagnosis {} {}: {}>", self.severity, self.code, self.message)
    }
}

/// The page of a code or of a keyword (Markdown); None where there is none.
#[pyfunction]
pub(crate) fn explain(name: &str) -> Option<&'static str> {
    slideline::page(name)
}
