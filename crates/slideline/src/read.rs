//! From a path or a text to a model.

use crate::further::{self, From};
use crate::job::{Job, ReadOptions};
use sha2::{Digest, Sha256};
use slideline_deck::{Deck, FromDisk, Loader, NoFiles, PathKind};
use slideline_diag::{Code, Diagnostic, Sources, Span, has_errors};
use slideline_keywords::Setting;
use slideline_model::Model;
use std::fmt::Write as _;
use std::io::Read as _;
use std::path::{Path, PathBuf};

/// A deck that was read.
#[derive(Clone, Debug)]
pub struct Read {
    /// The job.
    pub job: Job,
    /// All texts that were read.
    pub sources: Sources,
    /// The cards.
    pub deck: Deck,
    /// The model; `None` where the deck has errors.
    pub model: Option<Model>,
    /// Everything there is to say, errors among it.
    pub diagnostics: Vec<Diagnostic>,
    /// SHA-256 over all texts, in hexadecimal digits.
    pub deck_hash: String,
    /// Whether there was any text; if not, a run leaves the folder alone.
    pub has_text: bool,
    /// The state of an earlier job that this one goes on from.
    pub from: Option<From>,
    /// What overrode the deck.
    pub options: ReadOptions,
}

impl Job {
    /// Reads the deck at `path` (`.inp` may be left out) and everything it
    /// includes. A file that cannot be read is an error among the diagnostics.
    pub fn read(path: &Path, options: &ReadOptions) -> Read {
        let job = Self::named(path);
        match load(&job.deck) {
            Ok(bytes) => {
                let name = job.deck.display().to_string();
                interpret(job, &name, &bytes, &FromDisk, options)
            }
            Err(reason) => unreadable(job, path, &reason, options),
        }
    }

    /// Reads other text in place of the deck of a job; it includes what the
    /// deck does.
    pub fn read_bytes(job: Self, bytes: &[u8], options: &ReadOptions) -> Read {
        let name = job.deck.display().to_string();
        interpret(job, &name, bytes, &FromDisk, options)
    }

    /// Reads a deck from memory; it can include nothing.
    pub fn read_text(name: &str, text: &str, options: &ReadOptions) -> Read {
        let job = Self { deck: PathBuf::from(format!("{name}.inp")), stem: name.into() };
        let shown = job.deck.display().to_string();
        interpret(job, &shown, text.as_bytes(), &NoFiles, options)
    }
}

fn load(path: &Path) -> Result<Vec<u8>, String> {
    // A pipe may never begin, a device never end.
    if let Ok(kind @ (PathKind::Folder | PathKind::Device | PathKind::Pipe)) = PathKind::of(path) {
        return Err(format!("it is {}", kind.words()));
    }
    let file = std::fs::File::open(path).map_err(|reason| reason.to_string())?;
    let mut bytes = Vec::new();
    let limit = slideline_deck::MAX_BYTES as u64 + 1; // one more: the parser says that it is too large
    file.take(limit).read_to_end(&mut bytes).map_err(|reason| reason.to_string())?;
    Ok(bytes)
}

fn unreadable(job: Job, path: &Path, reason: &str, options: &ReadOptions) -> Read {
    let message = format!("the deck {} cannot be read: {reason}", job.deck.display());
    let help = if job.deck == path {
        "Name an existing deck; the ending .inp may be left out.".to_owned()
    } else {
        format!("Neither {} nor {} is a deck.", path.display(), job.deck.display())
    };
    Read {
        job,
        sources: Sources::default(),
        deck: Deck::default(),
        model: None,
        diagnostics: vec![Diagnostic::error(Code("SL0701"), message).help(help)],
        deck_hash: String::new(),
        has_text: false,
        from: None,
        options: options.clone(),
    }
}

fn interpret(
    job: Job,
    name: &str,
    bytes: &[u8],
    loader: &dyn Loader,
    options: &ReadOptions,
) -> Read {
    let mut sources = Sources::default();
    let parsed = slideline_deck::parse(&mut sources, name, bytes, loader);
    let settings = settings(&options.parameters, &mut sources);
    let found = further::find(&job, &parsed, options);
    let (interpreted, from) = match found {
        Ok(Some(from)) => (from.interpret(&settings, &parsed, &mut sources), Some(from)),
        Ok(None) => {
            let dialect = options.dialect.unwrap_or_default();
            (slideline_keywords::interpret_with(&settings, &parsed, dialect), None)
        }
        Err(said) => (further::without_meaning(&parsed, *said), None),
    };
    let mut model = interpreted.model;
    if let Some(onset) = options.friction_onset.or(from.as_ref().map(|from| from.onset)) {
        model.friction_onset = onset;
    }
    let mut diagnostics = interpreted.diagnostics;
    if !has_errors(&diagnostics) {
        diagnostics.extend(slideline_solve::adjust(&mut model));
        diagnostics.extend(slideline_solve::memory_objection(&model));
    }
    let model = (!has_errors(&diagnostics)).then_some(model);
    Read {
        job,
        deck_hash: hash(&parsed.deck),
        has_text: !bytes.trim_ascii().is_empty(),
        sources,
        deck: parsed.deck,
        model,
        diagnostics,
        from,
        options: options.clone(),
    }
}

/// Settings of parameters, with a text each that complaints can point at.
fn settings(given: &[(String, String)], sources: &mut Sources) -> Vec<Setting> {
    let set = |(name, value): &(String, String)| {
        let text = format!("{name}={value}");
        let end = text.len();
        let span = Span::new(sources.add("--set", text), 0, end);
        Setting { name: name.clone(), value: value.clone(), span: Some(span) }
    };
    given.iter().map(set).collect()
}

/// SHA-256 over the length and the bytes of every file in reading order.
fn hash(deck: &Deck) -> String {
    let mut digest = Sha256::new();
    for file in &deck.files {
        digest.update((file.bytes.len() as u64).to_le_bytes());
        digest.update(&file.bytes);
    }
    digest.finalize().iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}"); // a String takes any text
        text
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_deck_is_told_and_leaves_no_trace() {
        let read = Job::read(Path::new("no/such/deck"), &ReadOptions::default());
        assert!(read.model.is_none() && !read.has_text);
        assert_eq!(read.diagnostics[0].code, Code("SL0701"));
        assert!(read.diagnostics[0].message.contains("no/such/deck.inp"));
    }

    #[test]
    fn a_job_is_named_with_or_without_its_ending() {
        for (path, stem) in [("a/beam", "beam"), ("a/beam.inp", "beam"), ("a/v1.2", "v1.2")] {
            assert_eq!(Job::named(Path::new(path)).stem, stem);
        }
        let job = Job::named(Path::new("beam"));
        assert_eq!(job.files(None).folder(), Path::new("."));
        assert_eq!(job.files(Some(Path::new("out"))).path(".sta"), Path::new("out/beam.sta"));
    }

    #[test]
    fn the_hash_tells_texts_apart() {
        let hash = |text| Job::read_text("a", text, &ReadOptions::default()).deck_hash;
        assert_eq!(hash("*HEADING\n"), hash("*HEADING\n"));
        assert_ne!(hash("*HEADING\n"), hash("*HEADING\nx\n"));
        assert_eq!(hash("").len(), 64);
    }
}
