//! Random models of solids in contact, in the plane, as rings and in space.
//!
//! ```text
//!   class, number -> Draft -> Placement -> text -> slideline -> files
//!                      \----------\--------------------------------> judge
//! ```

mod case;
mod cells;
mod choices;
mod classes;
mod depth;
mod draft;
mod forces;
mod judge;
mod mesh;
mod touching;
mod write;

pub use case::Case;
pub use classes::{CLASSES, Class};
pub use draft::Draft;
pub use write::Placement;

use super::trial::{Ending, Verdict, run_text};
use std::path::Path;
use std::time::Duration;

/// Share of the energy whose absence must shrink with the increments.
const NOTABLE: f64 = 0.05;

/// Runs a model in a folder and judges its files; every fifth one in natural units as well.
pub fn attempt(case: &Case, folder: &Path, limit: Duration) -> Verdict {
    let (mut verdict, files) = once(case, folder, limit);
    let completed = verdict.ending == Ending::Completed;
    if case.number.is_multiple_of(5) {
        let other = once(&case.natural(), folder, limit).0;
        if (other.ending == Ending::Completed) != completed || other.work != verdict.work {
            let [a, b] = [&verdict, &other].map(|v| format!("{:?} {:?}", v.ending, v.work));
            verdict.violations.push(("units", format!("{a}, in natural units {b}")));
        }
    }
    let Some(files) = files.filter(|files| completed && judge::missing(files) > NOTABLE) else {
        return verdict;
    };
    let finer = Case { draft: case.draft.finer(), ..case.clone() };
    let (fine, left) = once(&finer, folder, 4 * limit);
    match left.filter(|_| fine.ending == Ending::Completed) {
        None => verdict.violations.push(("finer", format!("{:?}", fine.ending))),
        Some(left) => {
            let missing = [&files, &left].map(judge::missing);
            let said = left.said("energ");
            if !said && missing[1] > NOTABLE && missing[1] > 0.6 * missing[0] {
                let [a, b] = missing.map(|part| 100.0 * part);
                let why = format!("{a:.1} % missing, finer {b:.1} %");
                verdict.violations.push(("energy stays", why));
            }
        }
    }
    verdict
}

/// Runs once; files as well, where there are.
fn once(case: &Case, folder: &Path, limit: Duration) -> (Verdict, Option<judge::Files>) {
    let ran = run_text(&case.text(), folder, limit);
    let files = judge::read(case, folder, "model");
    let told = files.as_ref().map(|files| (files.status.as_str(), files.diagnosis.clone()));
    let mut verdict = ran.verdict(told);
    if let (Ending::Completed, Some(files)) = (&verdict.ending, &files) {
        verdict.violations = judge::violations(case, files);
    }
    (verdict, files)
}

/// Draws and runs models of a class.
pub fn sweep(
    class: &Class,
    numbers: impl Iterator<Item = u64>,
    (folder, limit): (&Path, Duration),
    mut each: impl FnMut(&Case, &Verdict),
) {
    for number in numbers {
        let case = Case::drawn(class, number);
        let verdict = attempt(&case, folder, limit);
        each(&case, &verdict);
    }
}
