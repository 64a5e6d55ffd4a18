//! A study with its folder: the shards that are missing are run.

use crate::case::{Row, Runner};
use crate::folder::{Failure, Folder, identity, join_all};
use crate::indices::write_indices;
use crate::run::run;
use crate::shard::Found;
use crate::study::Study;
use crate::study_file::StudyFile;
use slideline::diag::{Code, Diagnostic, Severity, Sources, Span};
use slideline::keywords::Setting;
use slideline::{Job, Parametric, ReadOptions};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Seconds that a shard should take on one thread [T].
const SHARD_SECONDS: f64 = 4.0;
/// Cases whose time says how many make a shard.
const TRIALS: u64 = 8;

/// How a study is run.
#[derive(Clone, Debug)]
pub struct SweepOptions {
    /// Folder of the results.
    pub folder: PathBuf,
    /// Threads.
    pub threads: usize,
    /// The shards k with k mod the second = the first.
    pub part: (u64, u64),
    /// Whether to join the shards as `study.csv`.
    pub csv: bool,
}

/// What came of it.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// Cases run now.
    pub done: u64,
    /// Of those, how many failed.
    pub failed: u64,
    /// Cases that were there already.
    pub kept: u64,
    /// Whether the user ended it.
    pub interrupted: bool,
    /// What there is to say, such as damaged shards.
    pub said: Vec<Diagnostic>,
    /// The joined table.
    pub csv: Option<PathBuf>,
    /// Shares of the variance, of Saltelli's design.
    pub indices: Option<PathBuf>,
}

/// Runs the cases of a study that are not there yet, shard by shard. `stops` is asked often whether
/// to end; `told` hears after every case how many are done, and how many there are to be run now.
///
/// # Errors
/// A deck or a study that is wrong, a folder of another study, a file that cannot be written; what
/// was written is kept.
pub fn sweep(
    study: &StudyFile,
    sources: &mut Sources,
    options: &SweepOptions,
    told: &(dyn Fn(u64, u64) + Sync),
    stops: &(dyn Fn() -> bool + Sync),
) -> Result<Outcome, Failure> {
    let (deck, hash) = prepared(study, sources)?;
    let size = || cases_a_shard(study, &deck);
    let folder = Folder::open(&options.folder, study, identity(study, &hash), size)?;
    let mut outcome = Outcome::default();
    let missing = missing(&folder, study, options.part, &mut outcome);
    let all: u64 = missing.iter().map(|&shard| folder.count(shard)).sum();
    for shard in missing {
        let before = outcome.done;
        let told = |done| told(before + done, all);
        let cases = folder.cases_of(shard);
        let rows = run(&study.study, &deck, cases, options.threads, (&told, stops));
        if (rows.len() as u64) < folder.count(shard) {
            outcome.interrupted = true;
            return Ok(outcome);
        }
        outcome.done += rows.len() as u64;
        outcome.failed += rows.iter().filter(|row: &&Row| row.code.is_some()).count() as u64;
        folder.write(study, shard, &rows)?;
    }
    if study.study.has_shares() {
        outcome.indices = write_indices(&folder, study)?;
    }
    if options.csv {
        outcome.csv = join_all(&folder, study)?;
        let others = outcome.csv.is_none().then(other_parts_missing);
        outcome.said.extend(others);
    }
    Ok(outcome)
}

/// The deck of a study, held against it, and its hash.
///
/// # Errors
/// A deck that is wrong, a parameter that it does not define, a response of a node that it does not
/// have.
pub fn prepared(study: &StudyFile, sources: &mut Sources) -> Result<(Parametric, String), Failure> {
    let read = Job::read(&study.deck, &ReadOptions::default());
    let Some(model) = &read.model else {
        *sources = read.sources.clone();
        let errors = read.diagnostics.into_iter().filter(|said| said.severity == Severity::Error);
        return Err(Failure::Input(errors.collect()));
    };
    let deck = Parametric::of(&read).map_err(|said| Failure::Input(vec![*said]))?;
    let said = strange_names(&deck, &first_case(study)).into_iter();
    let said = said.chain(strange_curves(&study.study, model));
    let said: Vec<Diagnostic> = said.collect();
    if said.is_empty() { Ok((deck, read.deck_hash)) } else { Err(Failure::Input(said)) }
}

/// What stands against the names of parameters; other errors are those of one case.
pub(crate) fn strange_names(deck: &Parametric, settings: &[Setting]) -> Vec<Diagnostic> {
    let mut said = deck.model(settings).err().unwrap_or_default();
    said.retain(|said| ["SL0801", "SL0802"].contains(&said.code.0));
    said
}

/// Values of the first case, with their places in the study.
fn first_case(study: &StudyFile) -> Vec<Setting> {
    let values = study.parameters.iter().zip(study.study.values(0));
    let set = |((name, span), value): (&(String, _), crate::spread::Number)| Setting {
        name: name.clone(),
        value: value.text(),
        span: Some(*span),
    };
    values.map(set).collect()
}

/// Nodes, pairs, steps and times of responses that the model does not have.
pub(crate) fn strange_curves(study: &Study, model: &slideline::Model) -> Vec<Diagnostic> {
    let curves = study.curves.iter().zip(&study.places);
    let strange = curves.filter(|(curve, _)| curve.source(model).is_none());
    let refuse = |(curve, place): (&crate::curve::Curve, &Span)| {
        let [message, help] = curve.objection(model);
        Diagnostic::error(Code("SL0805"), message).at(*place).help(help)
    };
    let moments = study.responses.iter().filter_map(|own| {
        let [message, help] = own.objection(model)?;
        Some(Diagnostic::error(Code("SL0805"), message).at(own.place).help(help))
    });
    strange.map(refuse).chain(moments).collect()
}

/// How many cases a shard has so that it takes some seconds: by the time of the first cases.
#[allow(clippy::cast_precision_loss, clippy::cast_sign_loss, clippy::cast_possible_truncation)]
fn cases_a_shard(study: &StudyFile, deck: &Parametric) -> u64 {
    let mut runner = Runner::new(&study.study, deck, &|| false);
    runner.row(0); // makes the room
    let trials = TRIALS.min(study.study.cases());
    let (began, mut made) = (Instant::now(), 0);
    while made < trials && began.elapsed().as_secs_f64() < SHARD_SECONDS {
        runner.row(made);
        made += 1;
    }
    let each = began.elapsed().as_secs_f64() / made as f64;
    ((SHARD_SECONDS / each) as u64).clamp(1, study.study.cases())
}

/// Shards of a part that are not there; counts the cases of the others.
fn missing(
    folder: &Folder,
    study: &StudyFile,
    (own, parts): (u64, u64),
    outcome: &mut Outcome,
) -> Vec<u64> {
    let mut missing = Vec::new();
    for shard in (0..folder.shards()).filter(|shard| shard % parts == own) {
        match folder.read(study, shard) {
            Found::Rows(rows) => outcome.kept += rows.len() as u64,
            Found::Missing => missing.push(shard),
            Found::Damaged(why) => {
                let message = format!("{} is damaged: {why}", folder.file(shard).display());
                let said = Diagnostic::warning(Code("SL0808"), message);
                outcome.said.push(said.help("Its cases are computed again."));
                missing.push(shard);
            }
        }
    }
    missing
}

fn other_parts_missing() -> Diagnostic {
    let message = "study.csv was not written: other parts of the study are missing";
    let help = "Run the study once more with --csv when all parts are done.";
    Diagnostic::warning(Code("SL0808"), message).help(help)
}

/// The rows of all shards that are in a folder of a study, in the order of the cases.
///
/// # Errors
/// A deck or a study that is wrong, a folder of another study.
pub fn rows(study: &StudyFile, sources: &mut Sources, folder: &Path) -> Result<Vec<Row>, Failure> {
    let (_, hash) = prepared(study, sources)?;
    let folder = Folder::open(folder, study, identity(study, &hash), || study.study.cases())?;
    let found = (0..folder.shards()).filter_map(|shard| match folder.read(study, shard) {
        Found::Rows(rows) => Some(rows),
        Found::Missing | Found::Damaged(_) => None,
    });
    Ok(found.flatten().collect())
}
