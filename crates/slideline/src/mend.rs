//! A mended deck, tried before it is offered.
//!
//! ```text
//!   finding with a card --> deck with it --> check: its complaint is gone, no new one
//!                                        --> run:   comes as far, says nothing new
//!                                        `-> else it stays advice
//! ```

use crate::advice::{advise, mended};
use crate::job::Job;
use crate::read::Read;
use slideline_advice::Noise;
use slideline_diag::{Code, Diagnostic, Severity};
use slideline_solve::Options;
use slideline_solve::observe::{Ending, Event, Observer, Stop};
use std::collections::BTreeMap;
use std::ops::ControlFlow;

/// What came of trying the cards that a deck's findings suggest.
#[derive(Clone, Debug, Default)]
pub struct Mend {
    /// The mended deck; none where no card stood the trial.
    pub deck: Option<Vec<u8>>,
    /// Findings whose card stands in it.
    pub mended: Vec<Code>,
    /// Findings whose card was tried and left out, each with the reason.
    pub left_out: Vec<(Code, String)>,
    /// Whether the mended deck was run to its end, or as far as the old one.
    pub was_run: bool,
}

/// Tries every card that the diagnostics of a deck suggest. A card is kept
/// where a check of the deck with it makes the complaint go away and brings no
/// new one, and where a run then comes as far as before without saying more.
/// `observer` may stop the runs; nothing is kept then.
pub fn try_mends(
    read: &Read,
    diagnostics: &[Diagnostic],
    options: &Options,
    observer: &mut dyn Observer,
) -> Mend {
    let mut mend = Mend::default();
    let mut kept: Vec<Diagnostic> = Vec::new();
    let mut before = counts(diagnostics);
    for said in diagnostics.iter().filter(|said| mended(read, &[(*said).clone()]).is_some()) {
        let mut with = kept.clone();
        with.push(said.clone());
        let Some(after) = mended(read, &with).map(|bytes| checked(read, &bytes)) else { continue };
        match objection(said, &before, &after) {
            Some(reason) => mend.left_out.push((said.code, reason)),
            None => (kept, before) = (with, after),
        }
    }
    run_it(read, &mut kept, &mut mend, (options, observer));
    mend.mended = kept.iter().map(|said| said.code).collect();
    mend.deck = mended(read, &kept);
    mend
}

/// How often each code was said, notes apart.
type Counts = BTreeMap<&'static str, usize>;

fn counts(diagnostics: &[Diagnostic]) -> Counts {
    let mut counts = Counts::new();
    diagnostics.iter().for_each(|said| *counts.entry(said.code.0).or_default() += 1);
    counts
}

fn reread(read: &Read, bytes: &[u8]) -> Read {
    Job::read_bytes(read.job.clone(), bytes, &read.options)
}

fn checked(read: &Read, bytes: &[u8]) -> Counts {
    let mut again = reread(read, bytes);
    again.diagnostics.extend(advise(&again));
    counts(&again.diagnostics)
}

/// Why a card does not help: its complaint stays, or others come.
fn objection(said: &Diagnostic, before: &Counts, after: &Counts) -> Option<String> {
    let count = |counts: &Counts, code: &str| counts.get(code).copied().unwrap_or(0);
    if let Some((code, _)) = after.iter().find(|(code, now)| **now > count(before, code)) {
        return Some(format!("with it check says {code}"));
    }
    let code = said.code.0;
    (count(after, code) >= count(before, code)).then(|| format!("{code} stays with it"))
}

/// Runs the deck with the kept cards against the old one; drops the last cards
/// until the run is no worse.
fn run_it(
    read: &Read,
    kept: &mut Vec<Diagnostic>,
    mend: &mut Mend,
    (options, observer): (&Options, &mut dyn Observer),
) {
    if kept.is_empty() {
        return;
    }
    let Some(old) = Trial::of(read, options, observer) else {
        // the old deck has errors, or none of its states is known: its check is all there is
        let runs = mended(read, kept).and_then(|bytes| {
            let again = reread(read, &bytes);
            Trial::of(&again, options, observer)
        });
        mend.was_run = runs.is_some_and(|trial| trial.completed);
        return;
    };
    while let Some(bytes) = mended(read, kept) {
        let new = Trial::of(&reread(read, &bytes), options, observer);
        let Some(reason) = new.map_or(Some("it cannot be run".to_owned()), |new| new.worse(&old))
        else {
            mend.was_run = true;
            return;
        };
        let Some(said) = kept.pop() else { return };
        mend.left_out.push((said.code, reason));
    }
}

/// What a run in memory came to.
struct Trial {
    completed: bool,
    stopped: bool,
    diagnosis: Option<Code>,
    said: Vec<Code>,
}

impl Trial {
    fn of(read: &Read, options: &Options, observer: &mut dyn Observer) -> Option<Self> {
        let model = read.model.as_ref().filter(|_| read.from.is_none())?;
        let mut watch = Watch { observer, noise: Noise::of(model), said: Vec::new() };
        let ending = slideline_solve::run(model, options, &mut watch);
        let Watch { noise, mut said, .. } = watch;
        let found = noise.findings(&noise.summary());
        said.extend(found.iter().filter(|said| said.severity >= Severity::Advice).map(|s| s.code));
        Some(Self {
            completed: matches!(ending, Ending::Completed(_)),
            stopped: matches!(ending, Ending::Stopped(..)),
            diagnosis: match ending {
                Ending::NotConverged(_, why) => Some(why.code),
                _ => None,
            },
            said,
        })
    }

    /// Why this run is worse than the old one.
    fn worse(&self, old: &Self) -> Option<String> {
        if self.stopped {
            return Some("its run was stopped".to_owned());
        }
        if let Some(code) = self.diagnosis.filter(|_| old.completed) {
            return Some(format!("with it the run does not converge ({code})"));
        }
        if !old.completed {
            return None; // it came less far, and could say less
        }
        let new = self.said.iter().find(|code| !old.said.contains(code));
        new.map(|code| format!("with it the run says {code}"))
    }
}

/// Passes events on and takes note of what is said.
struct Watch<'a> {
    observer: &'a mut dyn Observer,
    noise: Noise,
    said: Vec<Code>,
}

impl Observer for Watch<'_> {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        self.noise.watch(&event);
        if let Event::Diagnosed(said) = event
            && said.severity >= Severity::Advice
            && said.severity < Severity::Error
        {
            self.said.push(said.code);
        }
        self.observer.event(event)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(code: &'static str) -> Diagnostic {
        Diagnostic::advice(Code(code), "x")
    }

    /// Requirement: a card that leaves its complaint, or brings another one,
    /// is no mend.
    #[test]
    fn a_card_that_does_not_help_is_left_out() {
        let before = counts(&[said("SL0404"), said("SL0404"), said("SL0402")]);
        let once = counts(&[said("SL0404"), said("SL0402")]);
        assert_eq!(objection(&said("SL0404"), &before, &once), None);
        assert!(objection(&said("SL0404"), &before, &before).is_some_and(|r| r.contains("stays")));
        let other = counts(&[said("SL0404"), said("SL0405")]);
        let found = objection(&said("SL0404"), &before, &other);
        assert!(found.is_some_and(|reason| reason.contains("SL0405")));
    }

    /// Requirement: a run that converged must go on converging, and must not
    /// say what it did not say before.
    #[test]
    fn a_run_that_gets_worse_is_told() {
        let trial = |completed, diagnosis, said: &[&'static str]| Trial {
            completed,
            stopped: false,
            diagnosis,
            said: said.iter().copied().map(Code).collect(),
        };
        let old = trial(true, None, &["SL0611"]);
        assert_eq!(trial(true, None, &["SL0611"]).worse(&old), None);
        assert_eq!(trial(true, None, &[]).worse(&old), None);
        let fails = trial(false, Some(Code("SL0501")), &[]);
        assert!(fails.worse(&old).is_some_and(|reason| reason.contains("SL0501")));
        assert_eq!(fails.worse(&trial(false, Some(Code("SL0501")), &[])), None);
        assert!(trial(true, None, &["SL0610"]).worse(&old).is_some());
    }
}
