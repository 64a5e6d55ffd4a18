//! The verification report, from the outcomes of the claims.
//!
//! ```text
//!   Outcome --> FILE-NAME.json   one record a claim
//!       |-----> report.html      one page: light, dark, on paper, no network
//!       '-----> report.md        the same numbers as a table
//! ```
//!
//! Nothing in these files depends on the time or the machine: two runs of one
//! program leave the same bytes.

mod html;
mod json;
mod markdown;
mod wording;

use crate::claim::Outcome;
use std::io;
use std::path::Path;

/// Writes the record of one claim into `folder`.
///
/// # Errors
/// A file that cannot be written.
pub fn write_record(folder: &Path, outcome: &Outcome) -> io::Result<()> {
    std::fs::create_dir_all(folder)?;
    let name = format!("{}-{}.json", outcome.file, outcome.claim.name);
    std::fs::write(folder.join(name), json::record(outcome))
}

/// Writes the report of all claims into `folder`, and removes records of
/// claims that are no more.
///
/// # Errors
/// A file that cannot be written or removed.
pub fn write_report(folder: &Path, outcomes: &[Outcome]) -> io::Result<()> {
    let kept: Vec<String> = outcomes
        .iter()
        .map(|outcome| format!("{}-{}.json", outcome.file, outcome.claim.name))
        .collect();
    std::fs::create_dir_all(folder)?;
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if name.ends_with(".json") && !kept.contains(&name) {
            std::fs::remove_file(path)?;
        }
    }
    std::fs::write(folder.join("report.md"), markdown::page(outcomes))?;
    std::fs::write(folder.join("report.html"), html::page(outcomes))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Claim, Record, Study};

    fn outcomes() -> Vec<Outcome> {
        let claim = |name, measure| Claim {
            name,
            requirement: "x < 1 & more",
            source: "a <book>",
            tolerance: "rounding",
            measure,
        };
        let good = |record: &mut Record| {
            record.at_most("error", 0.25, 1.0);
            let points = vec![[12.0, 1e-2], [24.0, 2.5e-3]];
            record.convergence("Convergence", "error", &[Study { name: "B21".into(), points }]);
            let axes = ["travel", "force"];
            record.comparison(
                "Force",
                axes,
                &[0.0, 1.0],
                &[("run", &[0.0, 2.0])],
                ("exact", &[0.0, 2.1]),
            );
        };
        let bad = |record: &mut Record| record.at_least("order", 1.0, 2.0);
        vec![
            Outcome::of("One", "first", claim("all_is_well", good)),
            Outcome::of("Two", "second", claim("not_so_well", bad)),
        ]
    }

    /// Requirement: the page says of each claim what it requires, where from,
    /// why the tolerance, what was measured; it needs nothing from elsewhere.
    #[test]
    fn page_and_table_say_it_all() {
        let found = outcomes();
        let page = html::page(&found);
        for part in [
            "1 of 2 claims do not hold.",
            "All is well",
            "x &lt; 1 &amp; more",
            "a &lt;book&gt;",
            "rounding",
            "at most 1",
            "B21: order 2.00",
            "at least 2",
            "prefers-color-scheme: dark",
            "@media print",
        ] {
            assert!(page.contains(part), "{part} is missing");
        }
        assert!(!page.contains("http://") && !page.contains("https://") && !page.contains("NaN"));
        assert_eq!(page.matches("<svg").count(), 2);
        let table = markdown::page(&found);
        assert!(
            table.contains("| first::all_is_well | error | 0.25 | at most 1 | yes |"),
            "{table}"
        );
        assert!(
            table.contains("| second::not_so_well | order | 1 | at least 2 | **no** |"),
            "{table}"
        );
        assert_eq!(page, html::page(&outcomes()), "the same bytes again");
    }

    /// Requirement: a record of each claim, none of claims that are no more.
    #[test]
    fn files_of_a_run() {
        let folder = std::env::temp_dir().join(format!("claims-{}", std::process::id()));
        let found = outcomes();
        for outcome in &found {
            write_record(&folder, outcome).unwrap();
        }
        let record = std::fs::read_to_string(folder.join("first-all_is_well.json")).unwrap();
        assert!(record.contains("\"holds\":true") && record.contains("[24,0.0025]"), "{record}");
        write_report(&folder, &found[..1]).unwrap();
        let mut names: Vec<String> = std::fs::read_dir(&folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        assert_eq!(names, ["first-all_is_well.json", "report.html", "report.md"]);
        std::fs::remove_dir_all(folder).unwrap();
    }
}
