//! The study of Diehl (1995), repeated: its models under both friction logics,
//! theory beside them, every figure, a table of errors, one page.
//!
//! ```text
//!   decks --> runs --+--> fig1.svg ... fig8b.svg, PNG twins
//!   theory ----------+--> errors.csv, curves.csv
//!                    '--> diehl1995.html
//! ```
//!
//! Every number on the page and in the figures is computed when the study is
//! made; none is written down.

// dimension tags such as [L] are not links
#![allow(rustdoc::broken_intra_doc_links)]

mod cases;
mod curve;
mod decks;
mod failure;
mod figures;
mod fine;
mod page;
mod progress;
mod study;
mod table;
mod theory;

pub use cases::{Case, FINE, FRICTION, INCREMENTS, ModelKind, Stick, cases};
pub use curve::{Curve, Increment};
pub use decks::Deck;
pub use failure::Failure;
pub use fine::Errors;
pub use progress::{Progress, Tell};
pub use study::Study;
pub use table::{Row, rows};
pub use theory::{References, Theory, Values};

use rayon::prelude::*;
use std::collections::BTreeSet;
use std::path::Path;

/// Dots an inch of the PNG twins.
const DOTS: f64 = 300.0;

/// What was made.
#[derive(Clone, Debug)]
pub struct Report {
    /// Everything that was computed.
    pub study: Study,
    /// The table of errors.
    pub rows: Vec<Row>,
    /// Names of the files in the folder.
    pub files: Vec<String>,
}

/// Makes the study and writes it into `folder`, which is made if missing:
/// figures, tables, page, and the decks. `tell` hears of every piece that is done.
///
/// # Errors
/// When a model does not converge or a file cannot be written; files that
/// were written stay.
pub fn reproduce(folder: &Path, tell: Tell<'_>) -> Result<Report, Failure> {
    std::fs::create_dir_all(folder.join("decks")).map_err(at(folder))?;
    let total = cases().len() + theory::count_of_references() + fine::count() + figures::COUNT;
    let count = progress::Count::new(total, tell);
    let study = study::compute(&count)?;
    let rows = table::rows(&study);
    let figures = figures::all(&study);
    let draw = |figure: &figures::Figure| {
        let svg = figure.scene.svg();
        let png = figure.scene.png(DOTS).ok_or(Failure::Figure(figure.name))?;
        count.tick(figure.name.to_owned());
        Ok((figure.name, svg, png))
    };
    let drawn: Result<Vec<_>, Failure> = figures.par_iter().map(draw).collect();
    let mut files = Files { folder, names: Vec::new() };
    for (name, svg, png) in drawn? {
        files.write(&format!("{name}.svg"), svg.as_bytes())?;
        files.write(&format!("{name}.png"), &png)?;
    }
    files.write("errors.csv", table::csv(&rows).as_bytes())?;
    files.write("curves.csv", table::curves_csv(&study).as_bytes())?;
    files.write("diehl1995.html", page::page(&study, &rows, &figures).as_bytes())?;
    let decks: BTreeSet<(&str, &str)> =
        cases().iter().map(|case| (case.deck.name, case.deck.text)).collect();
    for (name, text) in decks {
        files.write(&format!("decks/{name}.inp"), text.as_bytes())?;
    }
    Ok(Report { study, rows, files: files.names })
}

fn at(path: &Path) -> impl FnOnce(std::io::Error) -> Failure + '_ {
    move |reason| Failure::Write { path: path.to_owned(), reason }
}

/// Writes files whole: beside, then renamed.
struct Files<'a> {
    folder: &'a Path,
    names: Vec<String>,
}

impl Files<'_> {
    fn write(&mut self, name: &str, content: &[u8]) -> Result<(), Failure> {
        let path = self.folder.join(name);
        let part = self.folder.join(format!("{name}.part"));
        let written = std::fs::write(&part, content).and_then(|()| std::fs::rename(&part, &path));
        if written.is_err() {
            let _ = std::fs::remove_file(&part); // the first error is the one to tell
        }
        written.map_err(at(&path))?;
        self.names.push(name.to_owned());
        Ok(())
    }
}
