//! All cases of a study, on several threads.

use crate::case::{Row, Runner};
use crate::study::Study;
use slideline::Parametric;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

/// Runs cases of a study, in the order of their numbers whatever thread made them; their rows have
/// the same bits on any number of threads. Each thread keeps one plan and one workspace as long as
/// the outline of the models stays the same. Where `stops` says so, the cases so far that follow one
/// another are returned. `told` is called after every case with the number of those that are done.
pub fn run(
    study: &Study,
    deck: &Parametric,
    cases: Range<u64>,
    threads: usize,
    (told, stops): (&(dyn Fn(u64) + Sync), &(dyn Fn() -> bool + Sync)),
) -> Vec<Row> {
    let all = cases.start..cases.end.min(study.cases());
    let begin = || Runner::new(study, deck, stops);
    share(all, threads, (told, stops), (&begin, &|runner, case| runner.row(case), &drop))
}

/// How cases are run: who runs them, one of them, and what is done with who is through.
pub(crate) type Crew<'a, 'r> = (
    &'a (dyn Fn() -> Runner<'r> + Sync),
    &'a (dyn Fn(&mut Runner<'r>, u64) -> Option<Row> + Sync),
    &'a (dyn Fn(Runner<'r>) + Sync),
);

/// Shares cases among threads; the rows of those that follow one another.
pub(crate) fn share(
    cases: Range<u64>,
    threads: usize,
    (told, stops): (&(dyn Fn(u64) + Sync), &(dyn Fn() -> bool + Sync)),
    (begin, run, leave): Crew<'_, '_>,
) -> Vec<Row> {
    let (next, done) = (AtomicU64::new(cases.start), AtomicU64::new(0));
    let work = || {
        let mut runner = begin();
        let mut rows = Vec::new();
        while !stops() {
            let case = next.fetch_add(1, Ordering::Relaxed);
            let Some(row) = (case < cases.end).then(|| run(&mut runner, case)).flatten() else {
                break;
            };
            rows.push(row);
            told(done.fetch_add(1, Ordering::Relaxed) + 1);
        }
        leave(runner);
        rows
    };
    let mut rows = std::thread::scope(|scope| {
        let others: Vec<_> = (1..threads.max(1)).map(|_| scope.spawn(work)).collect();
        let mut rows = work();
        for other in others {
            match other.join() {
                Ok(own) => rows.extend(own),
                Err(fault) => std::panic::resume_unwind(fault),
            }
        }
        rows
    });
    rows.sort_by_key(|row| row.case);
    let together = rows.iter().zip(cases).take_while(|(row, case)| row.case == *case).count();
    rows.truncate(together);
    rows
}
