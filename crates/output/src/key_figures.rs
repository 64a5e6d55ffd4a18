//! What a run came to, in a few numbers of its `JOB.json`.

use crate::job::JobFiles;
use crate::json::{Members as _, Value};
use crate::reading::summary::{driven, raw};

/// Names of the numbers: forces and work of the driven motion that does most work, the largest strain
/// and what of the allowable one that is.
pub const KEY_FIGURES: [&str; 7] =
    ["push_in", "pull_out", "ratio", "work_in", "work_out", "strain", "utilisation"];

/// What a run came to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct KeyFigures {
    /// In one word.
    pub status: String,
    /// Colour of the verdict.
    pub verdict: String,
    /// In the order of [`KEY_FIGURES`].
    pub values: [Option<f64>; KEY_FIGURES.len()],
    /// First node, motion and reaction of the driven motion that does most work; or else of the
    /// first one.
    pub driven: Option<(u64, String, String)>,
}

/// Those of a job; none where it has no summary.
pub fn key_figures(job: &JobFiles) -> Option<KeyFigures> {
    Some(figures_of(&raw(job).ok()?))
}

/// Those that a summary, the object of `JOB.json`, says.
pub fn figures_of(summary: &Value) -> KeyFigures {
    let forces = summary.list("forces").first();
    let taken = |key| forces?.get(key)?.number("force");
    let number = |key| forces?.number(key);
    let strain = summary.get("fibre_strain").or(summary.get("principal_strain"));
    let values = [
        taken("push_in"),
        taken("pull_out"),
        number("ratio"),
        number("work_in"),
        number("work_out"),
        strain.and_then(|own| own.number("max")),
        summary.get("allowable").and_then(|used| used.number("utilisation")),
    ];
    let name = |key| forces?.text(key).map(str::to_owned);
    let of_forces = || Some((forces?.count("node")? as u64, name("motion")?, name("reaction")?));
    let first = || {
        let own = driven(summary).into_iter().next()?;
        Some((*own.nodes.first()?, own.motion, own.reaction))
    };
    KeyFigures {
        status: summary.text("status").unwrap_or_default().to_owned(),
        verdict: summary
            .get("verdict")
            .and_then(|own| own.text("colour"))
            .unwrap_or_default()
            .into(),
        values,
        driven: of_forces().or_else(first),
    }
}
