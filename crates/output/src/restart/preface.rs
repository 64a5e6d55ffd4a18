//! What stands before the states in `JOB.rst`: whose states they are.

use crate::ledger::onset_word;
use crate::summary::Facts;
use slideline_diag::{Code, Diagnostic, Source};
use slideline_model::Dialect;
use slideline_solve::bytes::{Packed, Unpacking};

/// The texts of a deck.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Part {
    /// Name and text of the deck, then of what it includes.
    pub texts: Vec<(String, String)>,
    /// How many steps there are after it, those of parts before it included;
    /// what it says behind them does not count.
    pub steps: usize,
}

/// Where the history of a job begins.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Origin {
    /// Name of the earlier job.
    pub job: String,
    /// Step of the state that was read.
    pub step: usize,
    /// Increment of the state that was read.
    pub increment: usize,
}

/// The jobs that a job goes on from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Earlier {
    /// Their decks, the first one first.
    pub parts: Vec<Part>,
    /// The state that was read.
    pub origin: Origin,
}

/// What must be the same in the run that goes on.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Circumstances {
    version: String,
    deck_hash: String,
    pub dialect: String,
    pub friction_onset: String,
}

impl Circumstances {
    fn of(facts: &Facts<'_>) -> Self {
        Self {
            version: facts.version.to_owned(),
            deck_hash: facts.deck_hash.to_owned(),
            dialect: facts.dialect.map(Dialect::word).unwrap_or_default().to_owned(),
            friction_onset: facts.friction_onset.map(onset_word).unwrap_or_default().to_owned(),
        }
    }

    fn fields(&self) -> [(&'static str, &str); 4] {
        [
            ("the program", &self.version),
            ("the deck", &self.deck_hash),
            ("the dialect", &self.dialect),
            ("the friction onset", &self.friction_onset),
        ]
    }
}

/// What all states of a file have in common.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Preface {
    pub circumstances: Circumstances,
    /// The jobs that the job goes on from.
    pub earlier: Option<Earlier>,
    /// Texts of the job's own deck.
    pub texts: Vec<(String, String)>,
}

impl Preface {
    pub fn of(facts: &Facts<'_>) -> Self {
        let own = facts.sources.files().iter().take(facts.own_texts);
        let text = |source: &Source| (source.name.clone(), source.text.clone());
        Self {
            circumstances: Circumstances::of(facts),
            earlier: facts.earlier.cloned(),
            texts: own.map(text).collect(),
        }
    }

    /// Why a run described by `facts` is not one of the job that the states
    /// belong to.
    pub fn objection(&self, facts: &Facts<'_>) -> Option<Diagnostic> {
        let now = Circumstances::of(facts);
        let fields = self.circumstances.fields().into_iter().zip(now.fields());
        let mut fields = fields.into_iter();
        if let Some(((what, was), (_, now))) = fields.find(|((_, was), (_, now))| was != now) {
            return Some(changed(what, was, now));
        }
        let origin = |earlier: Option<&Earlier>| {
            earlier.map_or_else(
                || "none".to_owned(),
                |Earlier { origin: Origin { job, step, increment }, .. }| {
                    format!("{job}, step {step}, increment {increment}")
                },
            )
        };
        let was = self.earlier.as_ref();
        (was != facts.earlier)
            .then(|| changed("the earlier job", &origin(was), &origin(facts.earlier)))
    }

    /// Why a new job cannot go on from the states: another program, or
    /// options that contradict the model they belong to.
    pub fn objection_of_new(
        &self,
        version: &str,
        dialect: Option<&str>,
        onset: Option<&str>,
    ) -> Option<Diagnostic> {
        let now = [Some(version), None, dialect, onset];
        let fields = self.circumstances.fields().into_iter().zip(now);
        fields.into_iter().find_map(|((what, was), now)| {
            now.filter(|now| *now != was).map(|now| changed(what, was, now))
        })
    }

    pub fn pack(&self, bytes: &mut Packed) {
        self.circumstances.fields().into_iter().for_each(|(_, field)| bytes.text(field));
        bytes.flag(self.earlier.is_some());
        if let Some(Earlier { parts, origin }) = &self.earlier {
            bytes.text(&origin.job);
            bytes.count(origin.step);
            bytes.count(origin.increment);
            bytes.count(parts.len());
            for part in parts {
                bytes.count(part.steps);
                pack_texts(&part.texts, bytes);
            }
        }
        pack_texts(&self.texts, bytes);
    }

    pub fn unpack(bytes: &mut Unpacking<'_>) -> Option<Self> {
        let circumstances = Circumstances {
            version: bytes.text()?,
            deck_hash: bytes.text()?,
            dialect: bytes.text()?,
            friction_onset: bytes.text()?,
        };
        let earlier = if bytes.flag()? { Some(unpack_earlier(bytes)?) } else { None };
        Some(Self { circumstances, earlier, texts: unpack_texts(bytes)? })
    }
}

fn changed(what: &str, was: &str, now: &str) -> Diagnostic {
    let message =
        format!("{what} was changed since the state was saved: it was {was} and is {now} now");
    Diagnostic::error(Code("SL0709"), message).help(
        "Continue with the deck and options of the saved state, or run the job from the \
               beginning.",
    )
}

fn unpack_earlier(bytes: &mut Unpacking<'_>) -> Option<Earlier> {
    let origin = Origin { job: bytes.text()?, step: bytes.count()?, increment: bytes.count()? };
    let parts = (0..bytes.length(16)?)
        .map(|_| Some(Part { steps: bytes.count()?, texts: unpack_texts(bytes)? }))
        .collect::<Option<_>>()?;
    Some(Earlier { parts, origin })
}

fn pack_texts(texts: &[(String, String)], bytes: &mut Packed) {
    bytes.count(texts.len());
    for (name, text) in texts {
        bytes.text(name);
        bytes.text(text);
    }
}

fn unpack_texts(bytes: &mut Unpacking<'_>) -> Option<Vec<(String, String)>> {
    (0..bytes.length(16)?).map(|_| Some((bytes.text()?, bytes.text()?))).collect()
}
