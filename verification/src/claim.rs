//! Claims as data, and what comes of measuring one.
//!
//! ```text
//!   Chapter -> Group (a file of tests/) -> Claim --measure--> Record --> Outcome
//! ```

use crate::record::Record;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Something that the program is held to.
#[derive(Clone, Copy, Debug)]
pub struct Claim {
    /// What is claimed, as the name of a test.
    pub name: &'static str,
    /// What must be seen.
    pub requirement: &'static str,
    /// Where the requirement, or the reference, comes from.
    pub source: &'static str,
    /// Why the limits are what they are.
    pub tolerance: &'static str,
    /// Runs what is to be run and records what is seen.
    pub measure: fn(&mut Record),
}

/// The claims of one file.
#[derive(Clone, Copy, Debug)]
pub struct Group {
    /// The file, `tests/FILE.rs`.
    pub file: &'static str,
    /// Its claims.
    pub claims: &'static [Claim],
}

/// A chapter of the report.
#[derive(Clone, Copy, Debug)]
pub struct Chapter {
    /// Its title.
    pub title: &'static str,
    /// Files in the order in which they are reported.
    pub groups: &'static [Group],
}

/// A claim that was measured.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Title of its chapter.
    pub chapter: &'static str,
    /// File it stands in.
    pub file: &'static str,
    /// The claim.
    pub claim: Claim,
    /// What was recorded.
    pub record: Record,
    /// Why it could not be measured to the end.
    pub broken: Option<String>,
}

impl Outcome {
    /// Measures a claim; a claim that cannot be measured is broken, not fatal.
    pub fn of(chapter: &'static str, file: &'static str, claim: Claim) -> Self {
        let mut record = Record::default();
        let ended = catch_unwind(AssertUnwindSafe(|| (claim.measure)(&mut record)));
        let broken = ended.err().map(|reason| {
            let words = reason.downcast_ref::<String>().map(String::as_str);
            let words = words.or_else(|| reason.downcast_ref::<&str>().copied());
            words.unwrap_or("it could not be measured").to_owned()
        });
        Self { chapter, file, claim, record, broken }
    }

    /// File and name, such as `comb::flat_drag`.
    pub fn id(&self) -> String {
        format!("{}::{}", self.file, self.claim.name)
    }

    /// Whether something was measured and everything measured is as required.
    pub fn holds(&self) -> bool {
        let measured = self.record.measured();
        self.broken.is_none() && !measured.is_empty() && measured.iter().all(|one| one.holds())
    }

    /// What does not hold, a line each.
    pub fn objections(&self) -> String {
        let failed = self.record.measured().iter().filter(|one| !one.holds());
        let failed = failed
            .map(|one| format!("{}: {}, required {}", one.quantity, one.found(), one.required()));
        let mut lines: Vec<String> = failed.chain(self.broken.clone()).collect();
        if self.record.measured().is_empty() && lines.is_empty() {
            lines.push("nothing was measured".to_owned());
        }
        lines.join("\n")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(measure: fn(&mut Record)) -> Outcome {
        let claim = Claim { name: "name", requirement: "", source: "", tolerance: "", measure };
        Outcome::of("chapter", "file", claim)
    }

    /// Requirement: a claim holds where all that was measured is as required,
    /// and not where nothing was, or where it could not be.
    #[test]
    fn what_holds() {
        assert!(of(|record| record.at_most("a", 1.0, 1.0)).holds());
        assert!(!of(|_| ()).holds());
        let failed = of(|record| {
            record.at_most("a", 1.0, 2.0);
            record.at_most("b", f64::NAN, 2.0);
        });
        assert!(!failed.holds());
        assert_eq!(failed.objections(), "b: nan, required at most 2");
        let broken = of(|record| {
            record.at_most("a", 1.0, 2.0);
            panic!("the deck has errors");
        });
        assert!(!broken.holds());
        assert_eq!(broken.objections(), "the deck has errors");
        assert_eq!(broken.id(), "file::name");
    }
}
