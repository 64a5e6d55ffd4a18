//! The compiled part of the Python package: decks, runs, tables, studies.
//!
//! ```text
//!   slideline (Python)  -->  slideline._core  -->  slideline, slideline-sweep (Rust)
//!   exceptions, plots,       Deck, Run, Table,     reads, solves, writes
//!   builder                  Evaluator
//! ```
//!
//! Nothing here decides: it carries values over. Names that a user sees, and what is raised when,
//! are those of the Python files beside it.

mod arrays;
mod deck;
mod diagnosis;
mod fields;
mod friction;
mod options;
mod recording;
mod run;
mod study;
mod table;
mod watch;

use pyo3::prelude::*;

/// The compiled part of slideline.
#[pymodule(gil_used = false)]
fn _core(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", slideline::VERSION)?;
    module.add_class::<deck::Deck>()?;
    module.add_class::<diagnosis::Diagnosis>()?;
    module.add_class::<run::Run>()?;
    module.add_class::<fields::ElementField>()?;
    module.add_class::<table::Table>()?;
    module.add_class::<study::Evaluator>()?;
    module.add_class::<study::Study>()?;
    module.add_function(wrap_pyfunction!(deck::read, module)?)?;
    module.add_function(wrap_pyfunction!(deck::read_text, module)?)?;
    module.add_function(wrap_pyfunction!(diagnosis::explain, module)?)?;
    module.add_function(wrap_pyfunction!(study::evaluator, module)?)?;
    module.add_function(wrap_pyfunction!(study::read_study, module)?)
}
