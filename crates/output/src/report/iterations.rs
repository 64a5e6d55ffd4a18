//! `JOB.msg` read back: how each increment converged.

use crate::number::general;
use slideline_solve::observe::{FieldReport, IterationReport};

/// Residual of a field and what it is held against.
pub(crate) type Residual = [f64; 2];

/// One Newton iteration.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Iteration {
    /// Whether contact changed in it.
    pub severe: bool,
    /// Points whose contact changed.
    pub changes: usize,
    /// Points that were closed.
    pub closed: usize,
    /// Largest force residual and tolerance [F].
    pub force: Residual,
    /// Largest moment residual and tolerance [F L].
    pub moment: Residual,
    /// Whether everything had converged.
    pub converged: bool,
}

/// One attempt at an increment.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Attempt {
    /// Step number.
    pub step: usize,
    /// Increment number.
    pub increment: usize,
    /// Attempt number.
    pub attempt: usize,
    /// Its iterations.
    pub iterations: Vec<Iteration>,
    /// Why it was given up.
    pub reason: Option<String>,
}

/// Takes in an iteration of a run that goes on.
pub(crate) fn iterated(list: &mut Vec<Attempt>, report: &IterationReport) {
    let [step, increment, attempt] = [report.step, report.increment, report.attempt];
    let known = list
        .last()
        .is_some_and(|own| (own.step, own.increment, own.attempt) == (step, increment, attempt));
    if !known {
        list.push(Attempt { step, increment, attempt, ..Attempt::default() });
    }
    let Some(last) = list.last_mut() else { return };
    last.iterations.push(Iteration {
        severe: report.severe,
        changes: report.contact_changes.len(),
        closed: report.closed,
        force: shown(&report.force),
        moment: shown(&report.moment),
        converged: report.converged,
    });
}

/// Residual and tolerance with the digits that `JOB.msg` has.
fn shown(field: &FieldReport) -> Residual {
    let rounded = |value: f64| general(value, 4).parse().unwrap_or(f64::NAN);
    [rounded(field.residual), rounded(field.allowed)]
}

/// Reads the attempts; lines that say something else are passed over.
pub(crate) fn attempts(text: &str) -> Vec<Attempt> {
    let mut list: Vec<Attempt> = Vec::new();
    for line in text.lines() {
        if let Some(rest) = line.strip_prefix("STEP ") {
            list.extend(heading(rest));
            continue;
        }
        let Some(attempt) = list.last_mut() else { continue };
        if let Some(rest) = line.strip_prefix("  ITERATION ") {
            attempt.iterations.push(iteration(rest));
        } else if let Some(rest) = line.strip_prefix("    force ") {
            if let Some(last) = attempt.iterations.last_mut() {
                last.force = residual(rest);
            }
        } else if let Some(rest) = line.strip_prefix("    moment ") {
            if let Some(last) = attempt.iterations.last_mut() {
                last.moment = residual(rest);
            }
        } else if line.starts_with("  ATTEMPT ")
            && let Some((_, reason)) = line.split_once(" IS GIVEN UP ")
        {
            let reason = reason.split_once("): ").map_or(reason, |(_, reason)| reason);
            attempt.reason = Some(reason.to_owned());
        }
    }
    list
}

/// `1  INCREMENT 2  ATTEMPT 1`; the title of a step is something else.
fn heading(rest: &str) -> Option<Attempt> {
    let mut words = rest.split_whitespace();
    let step = words.next()?.parse().ok()?;
    let mut named = |name: &str| -> Option<usize> {
        (words.next()? == name).then(|| words.next()?.parse().ok())?
    };
    let (increment, attempt) = (named("INCREMENT")?, named("ATTEMPT")?);
    let whole = words.next().is_none();
    whole.then(|| Attempt { step, increment, attempt, ..Attempt::default() })
}

fn iteration(rest: &str) -> Iteration {
    let mut found = Iteration::default();
    for part in rest.split([';', ',']).map(str::trim) {
        let first = part.split_whitespace().next().and_then(|word| word.parse().ok());
        if part.contains("severe discontinuity") {
            found.severe = true;
        } else if part.contains("contact change") {
            found.changes = first.unwrap_or_default();
        } else if part.ends_with(" closed") {
            found.closed = first.unwrap_or_default();
        } else if part == "CONVERGED" {
            found.converged = true;
        }
    }
    found
}

fn residual(rest: &str) -> Residual {
    let after = |name: &str| -> f64 {
        let value = rest.split_once(name).and_then(|(_, rest)| rest.split_whitespace().next());
        value.and_then(|value| value.parse().ok()).unwrap_or(f64::NAN)
    };
    [after("largest residual"), after("  allowed")]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn attempts_and_iterations_are_found() {
        let text = "\nSTEP 1  INCREMENT 1  ATTEMPT 2 of my title\n\nSTEP 1  INCREMENT 7  ATTEMPT 1\n  \
            ITERATION 1  severe discontinuity iteration; 2 contact changes, 3 closed, contact defect 0\n    \
            force   largest residual       1.116 at node 25 dof 2  time-averaged force      0.6889  allowed    6.889e-7  largest correction   0.0001047 at node 25 dof 1  largest increment      0.0015\n    \
            moment  largest residual    1.006e-6 at node 22 dof 6  time-averaged moment    0.002847  allowed    2.847e-9  largest correction 0\n    \
            ISL node 9017 closes\n  \
            ITERATION 2  equilibrium iteration 1; 0 contact changes, 1 closed, contact defect 0; CONVERGED\n  \
            ATTEMPT 1 OF INCREMENT 7 IS GIVEN UP (time increment 0.05): too slow; no further attempt\n";
        let found = attempts(text);
        let last = found.last().unwrap();
        assert_eq!((last.step, last.increment, last.attempt), (1, 7, 1));
        assert_eq!(last.iterations.len(), 2);
        let first = &last.iterations[0];
        assert!(first.severe && first.changes == 2 && first.closed == 3 && !first.converged);
        assert_eq!((first.force, first.moment), ([1.116, 6.889e-7], [1.006e-6, 2.847e-9]));
        assert!(last.iterations[1].converged && !last.iterations[1].severe);
        assert_eq!(last.reason.as_deref(), Some("too slow; no further attempt"));
    }
}
