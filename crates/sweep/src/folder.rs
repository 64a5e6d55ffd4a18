//! The folder of a study: `study.json`, shards, `study.csv`.

use crate::case::Row;
use crate::shard::{self, Found};
use crate::study_file::StudyFile;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use slideline::VERSION;
use slideline::diag::{Code, Diagnostic};
use std::fmt::Write as _;
use std::io::{ErrorKind, Write as _};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Why a study could not go on.
#[derive(Clone, Debug)]
pub enum Failure {
    /// The study or its deck is wrong.
    Input(Vec<Diagnostic>),
    /// A file could not be written.
    Output(Box<Diagnostic>),
}

/// A folder whose study is known.
#[derive(Clone, Debug)]
pub(crate) struct Folder {
    pub path: PathBuf,
    pub identity: String,
    pub cases_a_shard: u64,
    pub cases: u64,
}

/// What tells a study from others: everything that its results depend on.
pub(crate) fn identity(study: &StudyFile, deck_hash: &str) -> String {
    let mut digest = Sha256::new();
    for part in
        [VERSION, deck_hash, &format!("{} {:?}", study.study.description(), study.responses)]
    {
        digest.update((part.len() as u64).to_le_bytes());
        digest.update(part.as_bytes());
    }
    shard::hexadecimal(&digest.finalize())
}

pub(crate) fn unwritten(path: &Path, reason: &dyn std::fmt::Display) -> Failure {
    let message = format!("results could not be written: {}: {reason}", path.display());
    let help = "Free disk space or choose another folder with --out. What was written is kept: the \
                same command goes on from there.";
    Failure::Output(Box::new(Diagnostic::error(Code("SL0702"), message).help(help)))
}

impl Folder {
    /// Opens the folder of a study, or makes it with shards of as many cases as `size` says; that
    /// is asked only where the study is new.
    pub fn open(
        path: &Path,
        study: &StudyFile,
        identity: String,
        size: impl FnOnce() -> u64,
    ) -> Result<Self, Failure> {
        std::fs::create_dir_all(path).map_err(|reason| unwritten(path, &reason))?;
        let plan = path.join("study.json");
        if !plan.exists() {
            let made = description(study, &identity, size());
            create(&plan, &made).map_err(|reason| unwritten(&plan, &reason))?;
        }
        let told = std::fs::read_to_string(&plan).map_err(|reason| unwritten(&plan, &reason))?;
        let told: Value = serde_json::from_str(&told).unwrap_or_default();
        let cases_a_shard = told["cases_a_shard"].as_u64().filter(|&count| count > 0);
        match cases_a_shard {
            Some(cases_a_shard) if told["identity"] == identity => Ok(Self {
                path: path.to_owned(),
                identity,
                cases_a_shard,
                cases: study.study.cases(),
            }),
            _ => Err(Failure::Input(vec![another(&plan)])),
        }
    }

    /// Number of shards.
    pub fn shards(&self) -> u64 {
        self.cases.div_ceil(self.cases_a_shard)
    }

    /// Cases of a shard.
    pub fn cases_of(&self, shard: u64) -> Range<u64> {
        let begin = shard * self.cases_a_shard;
        begin..(begin + self.cases_a_shard).min(self.cases)
    }

    /// How many those are.
    pub fn count(&self, shard: u64) -> u64 {
        let cases = self.cases_of(shard);
        cases.end - cases.start
    }

    /// The file of a shard.
    pub fn file(&self, shard: u64) -> PathBuf {
        self.path.join(format!("shard_{shard:05}.parquet"))
    }

    /// What is there of a shard.
    pub fn read(&self, study: &StudyFile, shard: u64) -> Found {
        shard::read(&self.file(shard), study, &self.identity, self.cases_of(shard))
    }

    /// Writes a shard; it is there whole or not at all.
    pub fn write(&self, study: &StudyFile, shard: u64, rows: &[Row]) -> Result<(), Failure> {
        let path = self.file(shard);
        let bytes = shard::bytes(study, &self.identity, rows);
        let bytes = bytes.map_err(|reason| unwritten(&path, &reason))?;
        let part = own_name(&path);
        let written = std::fs::write(&part, bytes).and_then(|()| std::fs::rename(&part, &path));
        written.map_err(|reason| {
            let _ = std::fs::remove_file(&part); // the first error is the one to tell
            unwritten(&path, &reason)
        })
    }
}

/// A name of this process alone: two may write the same shard.
pub(crate) fn own_name(path: &Path) -> PathBuf {
    path.with_extension(format!("{}.new", std::process::id()))
}

/// Writes a file that must not be there yet, whole or not at all; one that another process has
/// written meanwhile stays.
fn create(path: &Path, text: &str) -> std::io::Result<()> {
    let part = own_name(path);
    let mut file = std::fs::File::create(&part)?;
    let written = file.write_all(text.as_bytes()).and_then(|()| std::fs::hard_link(&part, path));
    let _ = std::fs::remove_file(&part); // the first error is the one to tell
    match written {
        Err(reason) if reason.kind() == ErrorKind::AlreadyExists => Ok(()),
        written => written,
    }
}

fn description(study: &StudyFile, identity: &str, cases_a_shard: u64) -> String {
    let parameters: Vec<&String> = study.parameters.iter().map(|(name, _)| name).collect();
    let told = json!({
        "identity": identity,
        "program_version": VERSION,
        "deck": study.deck.display().to_string(),
        "cases": study.study.cases(),
        "cases_a_shard": cases_a_shard,
        "shards": study.study.cases().div_ceil(cases_a_shard),
        "parameters": parameters,
        "responses": &study.responses,
    });
    format!("{told:#}\n")
}

fn another(plan: &Path) -> Diagnostic {
    let message = format!(
        "{} is of another study: parameters, responses, deck or program have changed since",
        plan.display()
    );
    let help = "Choose another folder with --out, or remove the old one.";
    Diagnostic::error(Code("SL0807"), message).help(help)
}

/// Joins all shards of a folder as `study.csv`, in the order of the cases. `Ok(None)`: shards are
/// missing, and nothing was written.
pub(crate) fn join_all(folder: &Folder, study: &StudyFile) -> Result<Option<PathBuf>, Failure> {
    let path = folder.path.join("study.csv");
    let part = own_name(&path);
    let failed = |reason: std::io::Error| unwritten(&path, &reason);
    let mut out = std::io::BufWriter::new(std::fs::File::create(&part).map_err(failed)?);
    out.write_all(header(study).as_bytes()).map_err(failed)?;
    for shard in 0..folder.shards() {
        let Found::Rows(rows) = folder.read(study, shard) else {
            let _ = std::fs::remove_file(&part); // nothing of it is needed
            return Ok(None);
        };
        let text: String = rows.iter().map(line).collect();
        out.write_all(text.as_bytes()).map_err(failed)?;
    }
    out.into_inner().map_err(|failure| failed(failure.into_error()))?;
    std::fs::rename(&part, &path).map_err(failed)?;
    Ok(Some(path))
}

fn header(study: &StudyFile) -> String {
    let names = study.parameters.iter().map(|(name, _)| name).chain(&study.responses);
    let names: Vec<&str> = names.map(String::as_str).collect();
    format!("case,{},code\n", names.join(","))
}

/// A row; numbers are the shortest texts that read back to the same doubles.
fn line(row: &Row) -> String {
    let mut text = row.case.to_string();
    for value in &row.values {
        let _ = write!(text, ",{value:?}"); // a String takes any text
    }
    for value in &row.responses {
        let _ = match value {
            Some(value) => write!(text, ",{value:?}"),
            None => write!(text, ","),
        };
    }
    let _ = writeln!(text, ",{}", row.code.as_deref().unwrap_or_default());
    text
}
