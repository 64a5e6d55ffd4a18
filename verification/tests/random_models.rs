//! Random small models: beams and rigid bodies, all laws, motions and onsets;
//! and the same as mangled text.
//!
//! Requirement (architecture, Errors): of models that are well-posed by
//! construction at least 98 % converge and balance, the rest end in a named
//! diagnosis; without a known cause at most 0.5 % of all; none hangs, panics
//! or gives NaN. Ten thousand are run by the example `random_models`; here are
//! the first of them. Of so few the share without a known cause is gated at
//! three times that.

use slideline::{Job, ReadOptions, advise};
use slideline_verification::random::classes::CLASSES;
use slideline_verification::random::trial::{Table, sweep};
use slideline_verification::random::{Sequence, Tally, judge, model, solids};
use std::time::Duration;

/// Models that are run here.
const MODELS: u64 = 600;

#[test]
fn random_models_converge_and_balance_or_say_why() {
    let mut tally = Tally::default();
    for number in 0..MODELS {
        let model = model(number);
        tally.add(&model, &judge(&model));
    }
    println!("{tally}");
    let [models, _, balanced] = tally.well_posed();
    assert!(balanced * 100 >= models * 98, "{tally}\n{:#?}", tally.remarkable);
    assert!(tally.unknown() * 1000 <= tally.models() * 15, "{tally}\n{:#?}", tally.remarkable);
    assert_eq!(tally.broken, 0, "{:#?}", tally.remarkable);
}

/// Cards cut, joined and shuffled: reading and advising end, and never in a
/// panic.
#[test]
fn mangled_decks_are_read_to_their_end() {
    let mut s = Sequence::new(3);
    for number in 0..1000 {
        let mut bytes = model(number).text.into_bytes();
        for _ in 0..=s.below(6) {
            let (a, b) = (s.below(bytes.len()), s.below(bytes.len()));
            let (first, second) = (a.min(b), a.max(b));
            match s.below(4) {
                0 => bytes[a] = s.below(256) as u8,
                1 => bytes.swap(a, b),
                2 => drop(bytes.drain(first..(first + s.below(40)).min(second.max(first)))),
                _ => {
                    let piece = bytes[first..(first + 30).min(bytes.len())].to_vec();
                    bytes.splice(a..a, piece);
                }
            }
        }
        let text = String::from_utf8_lossy(&bytes);
        let deck = Job::read_text("mangled", &text, &ReadOptions::default());
        assert!(deck.model.is_some() || !deck.diagnostics.is_empty());
        let _ = advise(&deck); // must not panic either
    }
}

/// Models of each class that are run here.
const EACH: u64 = 12;

/// Every class in short. Ten thousand are run by the example `random_models`,
/// and counted in docs/robustness.md. Requirement: 99 % of the well-posed
/// complete; of so few one more may fail. No completed run breaks a law, and
/// none hides a crossing but the one that docs/robustness.md names as open
/// (`coarse` 11).
#[test]
fn classes_complete_and_keep_the_laws() {
    let folder = std::env::temp_dir().join(format!("slideline-classes-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let mut table = Table::default();
    for class in &CLASSES {
        let limit = Duration::from_secs(300); // a busy machine is no fault
        sweep(class, 0..EACH, (&folder, limit), |case, verdict| table.add(case.label(), verdict));
    }
    std::fs::remove_dir_all(&folder).unwrap();
    println!("{table}");
    let [well_posed, completed] = table.well_posed();
    assert!(completed * 100 >= well_posed * 98, "{table}");
    let broken = table.violations();
    let laws = ["pull", "friction", "status", "law", "dissipation"];
    for never in laws.iter().chain(&["not finite", "balance", "pair"]) {
        assert!(!broken.contains_key(never), "{table}");
    }
    assert!(broken.get("passed").is_none_or(|&count| count <= 1), "{table}");
}

/// Models of solids of each class that are run here.
const SOLIDS: u64 = 4;

/// Solids in contact in the plane, as rings and in space, every class in short; hundreds are run by
/// the example `random_models` and counted in docs/robustness.md. Requirement: of the well-posed at
/// most one fails, and no completed run breaks a law.
#[test]
fn solids_complete_and_keep_the_laws() {
    let folder = std::env::temp_dir().join(format!("slideline-solids-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let mut table = Table::default();
    for class in &solids::CLASSES {
        let limit = Duration::from_secs(300); // a busy machine is no fault
        solids::sweep(class, 1..1 + SOLIDS, (&folder, limit), |case, verdict| {
            table.add(case.label(), verdict);
        });
    }
    std::fs::remove_dir_all(&folder).unwrap();
    println!("{table}");
    let [well_posed, completed] = table.well_posed();
    assert!(completed + 1 >= well_posed, "{table}");
    assert!(table.violations().is_empty(), "{table}");
}

/// Parts that grew cell by cell beside one another, once wrong: a node saw the far side of a curved face (0), or the wall of a
/// hole through the part (113); the outline of a part with a hole was refused (38); a sliver as small as rounding closed (211).
#[test]
fn parts_that_stand_apart_do_not_touch() {
    let folder = std::env::temp_dir().join(format!("slideline-apart-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let mut table = Table::default();
    let class = solids::CLASSES.iter().find(|class| class.name == "apart").unwrap();
    let limit = Duration::from_secs(300); // a busy machine is no fault
    solids::sweep(class, [0, 38, 113, 211].into_iter(), (&folder, limit), |case, verdict| {
        table.add(case.label(), verdict);
    });
    std::fs::remove_dir_all(&folder).unwrap();
    println!("{table}");
    assert_eq!(table.well_posed(), [4, 4], "{table}");
    assert!(table.violations().is_empty(), "{table}");
}
