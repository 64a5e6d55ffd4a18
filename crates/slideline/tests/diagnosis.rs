//! Decks that truly do not converge: the diagnosis names the cause, and the
//! card that it suggests makes them run.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::observe::Ending;
use slideline::{Diagnostic, Job, Quiet, ReadOptions, SolveOptions, solve};
use std::path::Path;

fn deck(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/failing");
    std::fs::read_to_string(folder.join(name)).unwrap()
}

fn ending(text: &str) -> Ending {
    let read = Job::read_text("failing", text, &ReadOptions::default());
    let Some(model) = &read.model else { panic!("{:?}", read.diagnostics) };
    solve(model, &SolveOptions::default(), &mut Quiet)
}

fn diagnosis(text: &str) -> Diagnostic {
    match ending(text) {
        Ending::NotConverged(_, why) => why,
        other => panic!("{other:?}"),
    }
}

/// Williams's toggle has a limit load: verification, beams.
#[test]
fn a_toggle_under_a_load_snaps_through_and_is_driven_instead() {
    let text = deck("SL0511-toggle.inp");
    let why = diagnosis(&text);
    assert_eq!(why.code.0, "SL0511", "{}", why.message);
    assert!(why.help.unwrap().contains("*BOUNDARY with node 11, degree of freedom 2"));
    let (before, load) = text.split_once("*CLOAD").unwrap();
    let end = load.find("*END STEP").unwrap();
    let driven = format!("{before}*BOUNDARY\n11, 2, 2, -0.6\n{}", &load[end..]);
    assert!(matches!(ending(&driven), Ending::Completed(_)));
}

#[test]
fn one_increment_that_is_too_large_is_shortened() {
    let text = deck("SL0512-roll-up.inp");
    let why = diagnosis(&text);
    assert_eq!(why.code.0, "SL0512", "{}", why.message);
    let help = why.help.unwrap();
    assert!(help.contains("leave out DIRECT"), "{help}");
    let shorter = text.replace("*STATIC, DIRECT\n1.0", "*STATIC\n0.1");
    assert!(matches!(ending(&shorter), Ending::Completed(_)));
}
