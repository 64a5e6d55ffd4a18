//! What stands before the states in `JOB.rst`: whose states they are.

use crate::facts::{Earlier, Facts, Origin};
use crate::ledger::onset_word;
use serde::{Deserialize, Serialize};
use slideline_diag::{Code, Diagnostic, Source};
use slideline_model::Dialect;

/// What must be the same in the run that goes on.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Circumstances {
    version: String,
    deck_hash: String,
    pub dialect: String,
    pub friction_onset: String,
    /// Values that parameters of the deck were given from outside.
    pub parameters: Vec<(String, String)>,
}

impl Circumstances {
    fn of(facts: &Facts<'_>) -> Self {
        Self {
            version: facts.version.to_owned(),
            deck_hash: facts.deck_hash.to_owned(),
            dialect: facts.dialect.map(Dialect::word).unwrap_or_default().to_owned(),
            friction_onset: facts.friction_onset.map(onset_word).unwrap_or_default().to_owned(),
            parameters: facts.parameters.to_vec(),
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

    /// Values from outside, as on the command line.
    fn settings(&self) -> String {
        let set: Vec<String> =
            self.parameters.iter().map(|(name, value)| format!("{name}={value}")).collect();
        if set.is_empty() { "none".to_owned() } else { set.join(" ") }
    }
}

/// What all states of a file have in common.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
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
        let mut fields = self.circumstances.fields().into_iter().zip(now.fields());
        if let Some(((what, was), (_, now))) = fields.find(|((_, was), (_, now))| was != now) {
            return Some(changed(what, was, now));
        }
        if self.circumstances.parameters != now.parameters {
            let what = "the set of values given by --set";
            return Some(changed(what, &self.circumstances.settings(), &now.settings()));
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
}

fn changed(what: &str, was: &str, now: &str) -> Diagnostic {
    let message =
        format!("{what} was changed since the state was saved: it was {was} and is {now} now");
    Diagnostic::error(Code("SL0709"), message).help(
        "Continue with the deck and options of the saved state, or run the job from the \
               beginning.",
    )
}
