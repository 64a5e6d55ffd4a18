//! `JOB.html`: one page that shows what came of a job, made from its result
//! files alone.
//!
//! ```text
//!   JOB.json  JOB.dat  JOB.msg ----+
//!   JOB.history.csv  .contact.csv -+-> Results -> verdict, data -> page
//!   JOB.energy.csv  JOB_nnnn.vtu --+
//! ```
//!
//! The page needs no network and no library: style, script and numbers stand
//! in it. Curves keep every increment; shapes are thinned where there are
//! many. What each part means is said in `docs/report.md`.

mod contact;
mod data;
mod frames;
mod iterations;
mod live;
mod options;
mod overlay;
mod page;
mod presence;
mod results;
mod skin;
mod verdict;

pub(crate) use live::Live;
pub use live::Told;
pub use options::Options;
pub use page::{DRAWING, STYLE, filled};
pub use slideline_figures::escaped;

pub use crate::reading::problem::Problem;

use crate::file::replace;
use crate::job::JobFiles;
use crate::json::Members as _;
use crate::lock::is_running;
use crate::reading::summary;
use results::Results;
use std::path::PathBuf;

/// A report that was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// The file.
    pub path: PathBuf,
    /// Its size in bytes.
    pub size: usize,
    /// The verdict, a sentence each.
    pub verdict: Vec<String>,
    /// Whether the deck is another one than the job ran.
    pub deck_changed: bool,
}

/// Writes `JOB.html` from the result files.
///
/// # Errors
/// Result files that are missing, truncated or foreign; a job that still runs
/// (unless [`Options::unfinished`]); a page that cannot be written. A page
/// that was there stays then.
pub fn write(job: &JobFiles, options: &Options<'_>) -> Result<Report, Problem> {
    let results = Results::read(job, options.unfinished)?;
    let overlay = options.overlay.map(overlay::read).transpose()?;
    let ran = results.summary.text("deck_hash");
    let deck_changed = options.deck_hash.is_some_and(|now| ran.is_some_and(|ran| ran != now));
    let mut remarks = Vec::new();
    if deck_changed {
        remarks.push(CHANGED.to_owned());
    }
    if results.summary.text("status") == Some("running") {
        let said = match is_running(job) {
            true => "The job was running when this page was made.",
            false => "The job had been killed when this page was made.",
        };
        remarks.push(said.to_owned());
    }
    let page = page::page(&job.name(), &results, overlay.as_ref(), options, &remarks);
    let path = job.path(".html");
    replace(&path, page.as_bytes())?;
    let verdict = verdict::sentences(&results, &verdict::judged(&results));
    Ok(Report { path, size: page.len(), verdict, deck_changed })
}

/// Hash of the deck that a job ran, where its summary says so.
pub fn deck_hash(job: &JobFiles) -> Option<String> {
    summary::read(job, true).ok()?.text("deck_hash").map(str::to_owned)
}

/// What a report says whose deck was edited after the run.
pub const CHANGED: &str = "The deck was changed after this run: these results belong to its \
                           earlier text. Run it again to see what the deck says now.";
