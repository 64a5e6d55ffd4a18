//! Further steps from the saved state of an earlier job.
//!
//! Requirement: one deck with all steps, against a job with the first ones and
//! a second job with `*RESTART, READ` and the rest, gives the same increments,
//! bit for bit. Source: docs/keywords/RESTART.md. Rows and states are compared
//! byte for byte, so there is no tolerance.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::jobs::{
    self, MOTIONS, WRITE, code, corpus, files, folder, irs, isl, model, same, slideline, step,
};
use crate::jobs::{columns, stderr};
use std::path::Path;

const QUIET: [&str; 2] = ["--quiet", "--no-html"];

fn run(folder: &Path, deck: &str, options: &[&str]) {
    let output = slideline(folder, &[&["run", deck], options, &QUIET].concat());
    assert_eq!(code(&output), 0, "{deck}: {}", stderr(&output));
}

fn text(folder: &Path, name: &str) -> String {
    std::fs::read_to_string(folder.join(name)).unwrap_or_else(|why| panic!("{name}: {why}"))
}

/// Rows of a CSV file behind its heading.
fn rows(folder: &Path, name: &str) -> Vec<String> {
    text(folder, name).lines().skip(1).map(str::to_owned).collect()
}

/// The last increments of `whole` are those of `part`, which begins after the
/// increment with that number, counted through all steps.
fn ends_like(folder: &Path, whole: &str, part: &str, after: usize) {
    for ending in ["history.csv", "contact.csv", "energy.csv", "pair.csv", "sta"] {
        let [all, own] = [whole, part].map(|job| rows(folder, &format!("{job}.{ending}")));
        let fewer = own.len() < all.len() || ending == "contact.csv"; // no rows before contact
        assert!(!own.is_empty() && fewer, "{part}.{ending}");
        assert_eq!(all[all.len() - own.len()..], own, "{part}.{ending}");
    }
    let messages = |job: &str| {
        let text = text(folder, &format!("{job}.msg"));
        let end = text.rfind(" IS DONE").unwrap(); // what is said of the whole run follows
        text[..end].split_once("ATTEMPT").map(|(_, rest)| rest.to_owned()).unwrap()
    };
    assert!(messages(whole).ends_with(&messages(part)), "{part}.msg");
    let state = |job: &str, number: usize| text(folder, &format!("{job}_{number:04}.vtu"));
    let increments = rows(folder, &format!("{whole}.energy.csv")).len();
    for number in after..=increments {
        assert!(state(whole, number) == state(part, number - after), "{part}: state {number}");
    }
    assert!(!folder.join(format!("{part}_{:04}.vtu", increments - after + 1)).exists());
}

const READ: &str = "*RESTART, READ\n";

/// Three steps in one job, in two, and in three, one after the other.
fn steps_one_by_one(name: &str, contact: &str) {
    let folder = folder(name);
    let [press, drag, back] = MOTIONS.map(|to| step(20, to));
    let write = |name: &str, deck: String| std::fs::write(folder.join(name), deck).unwrap();
    write("whole.inp", columns(20, WRITE, contact));
    write("press.inp", model(WRITE, contact) + &press);
    write("rest.inp", format!("{READ}{drag}{back}"));
    write("drag.inp", format!("*HEADING\nfurther\n{READ}{drag}"));
    write("back.inp", format!("{READ}{back}"));
    run(&folder, "whole", &[]);
    run(&folder, "press", &[]);
    std::fs::remove_file(folder.join("press.inp")).unwrap(); // the states know the model
    run(&folder, "rest", &["--oldjob", "press"]);
    ends_like(&folder, "whole", "rest", 20);
    run(&folder, "drag", &["--oldjob", "press.inp"]);
    run(&folder, "back", &["--oldjob", "drag.rst"]);
    ends_like(&folder, "whole", "back", 40);
    let summary = text(&folder, "back.json");
    let origin = "\"goes_on_from\":{\"job\":\"drag\",\"step\":2,\"increment\":20}";
    assert!(summary.contains(origin) && summary.contains("\"increments\":20,"), "{summary}");
}

#[test]
fn irs_with_friction() {
    steps_one_by_one("irs", &irs());
}

#[test]
fn isl_with_friction() {
    steps_one_by_one("isl", &isl());
}

/// The paper's slide line and cam, pushed and pulled, with friction; and
/// contact integrated along a beam, whose history lives at stations.
#[test]
fn the_papers_decks_and_integrated_contact() {
    let folder = folder("paper");
    let surface = corpus("surface_coarse_mu03.inp");
    let pull = "*STEP, NLGEOM\nBACK\n*STATIC\n0.05, 1.0, 1.0E-6, 0.05\n*BOUNDARY\n\
                9999, 2, 2, -10.0E-3\n*END STEP\n";
    let decks = [
        ("isl", corpus("isl_coarse_push_pull_mu03.inp")),
        ("cam", corpus("cam_isl_push_pull_mu03.inp")),
        ("surface", surface.trim_end().to_owned() + "\n" + pull),
    ];
    for (name, deck) in decks {
        let deck = if deck.contains("*RESTART") { deck } else { WRITE.to_owned() + &deck };
        let second = deck.match_indices("*STEP").nth(1).unwrap().0;
        let [first_name, further_name] = ["first", "further"].map(|part| format!("{name}_{part}"));
        let write = |name: &str, deck: &str| {
            std::fs::write(folder.join(format!("{name}.inp")), deck).unwrap();
        };
        write(name, &deck);
        write(&first_name, &deck[..second]);
        write(&further_name, &format!("{READ}{}", &deck[second..]));
        run(&folder, name, &[]);
        run(&folder, &first_name, &[]);
        run(&folder, &further_name, &["--oldjob", &first_name]);
        let after = rows(&folder, &format!("{first_name}.energy.csv")).len();
        ends_like(&folder, name, &further_name, after);
    }
}

/// From an increment in the middle of a step: the rest of it, then the new
/// steps; from a step that others followed: those are left out.
#[test]
fn a_step_and_an_increment_may_be_chosen() {
    let folder = folder("chosen");
    let [_, drag, back] = MOTIONS.map(|to| step(20, to));
    let write = |name: &str, deck: String| std::fs::write(folder.join(name), deck).unwrap();
    write("whole.inp", columns(20, WRITE, &irs()));
    write("middle.inp", format!("*RESTART, READ, STEP=1, INC=7\n{drag}{back}"));
    write("other.inp", format!("*RESTART, READ, STEP=1\n{back}"));
    write("press_back.inp", model(WRITE, &irs()) + &step(20, MOTIONS[0]) + &back);
    write("again.inp", format!("*RESTART, READ, STEP=1, INC=12\n{drag}{back}"));
    run(&folder, "whole", &[]);
    run(&folder, "middle", &["--oldjob", "whole"]);
    ends_like(&folder, "whole", "middle", 7);
    run(&folder, "again", &["--oldjob", "middle"]);
    ends_like(&folder, "whole", "again", 12);
    run(&folder, "press_back", &[]);
    run(&folder, "other", &["--oldjob", "whole"]);
    ends_like(&folder, "press_back", "other", 20);
}

/// `OVERLAY` keeps the last state of every step, `FREQUENCY` those asked for.
#[test]
fn overlay_keeps_one_state_a_step() {
    let folder = folder("overlay");
    let [_, drag, back] = MOTIONS.map(|to| step(20, to));
    let write = |name: &str, deck: String| std::fs::write(folder.join(name), deck).unwrap();
    let overlay = "*RESTART, WRITE, OVERLAY\n";
    write("whole.inp", columns(20, overlay, &irs()));
    write("rest.inp", format!("*RESTART, READ, STEP=1\n{drag}{back}"));
    write("middle.inp", format!("*RESTART, READ, STEP=1, INC=7\n{drag}{back}"));
    run(&folder, "whole", &[]);
    run(&folder, "rest", &["--oldjob", "whole"]);
    ends_like(&folder, "whole", "rest", 20);
    let output = slideline(&folder, &["run", "middle", "--oldjob", "whole"]);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).contains("step 1: increment 20"), "{}", stderr(&output));
}

/// A job that goes on from another one can be left and gone on with as well,
/// without the earlier job.
#[test]
fn a_further_job_can_be_left() {
    let folder = folder("left");
    let [press, drag, _] = MOTIONS.map(|to| step(20, to));
    let write = |name: &str, deck: String| std::fs::write(folder.join(name), deck).unwrap();
    write("press.inp", model(WRITE, &irs()) + &press);
    write("drag.inp", format!("{READ}{drag}"));
    run(&folder, "press", &[]);
    run(&folder, "drag", &["--oldjob", "press"]);
    let whole = files(&folder, "drag");
    // the files as a kill after the ninth increment leaves them
    let state = std::fs::read(folder.join("drag.rst")).unwrap();
    std::fs::write(folder.join("drag.rst"), jobs::up_to_state(&state, 9)).unwrap();
    std::fs::remove_file(folder.join("drag_0015.vtu")).unwrap();
    std::fs::remove_file(folder.join("press.rst")).unwrap();
    run(&folder, "drag", &["--restart"]);
    same(&whole, &files(&folder, "drag"), "left after 9 increments");
}

/// What cannot be gone on from is an input error with its own code, and
/// nothing is touched.
#[test]
fn what_cannot_be_gone_on_from() {
    let folder = folder("refused");
    let [press, drag, _] = MOTIONS.map(|to| step(5, to));
    let write = |name: &str, deck: String| std::fs::write(folder.join(name), deck).unwrap();
    write("press.inp", model(WRITE, &irs()) + &press);
    write("drag.inp", format!("{READ}{drag}"));
    run(&folder, "press", &[]);
    run(&folder, "drag", &["--oldjob", "press"]);
    let before = files(&folder, "drag");
    let refused = |options: &[&str], expected: &str, words: &str| {
        let output = slideline(&folder, &[&["run", "drag", "--quiet"], options].concat());
        let said = stderr(&output);
        assert_eq!(code(&output), 1, "{said}");
        assert!(said.contains(expected) && said.contains(words), "{expected}: {said}");
        assert_eq!(said.matches("error[").count(), 1, "{said}");
        let check = slideline(&folder, &[&["check", "drag"], options].concat());
        if !said.contains("replace by its own states") {
            assert_eq!(code(&check), 1, "{}", stderr(&check));
            assert!(stderr(&check).contains(expected), "{}", stderr(&check));
        }
    };
    let press = ["--oldjob", "press"];
    refused(&[], "SL0711", "--oldjob OLD");
    refused(&["--oldjob", "drag"], "SL0711", "another name");
    refused(&["--oldjob", "nothing"], "SL0707", "*RESTART, WRITE");
    refused(&[&press[..], &["--friction-onset", "matfru"]].concat(), "SL0709", "friction onset");
    refused(&[&press[..], &["--dialect", "calculix"]].concat(), "SL0709", "dialect");

    write("drag.inp", format!("*RESTART, READ, STEP=2\n{drag}"));
    refused(&press, "SL0712", "step 1: increments from 1 to 5");
    write("drag.inp", format!("*RESTART, READ, STEP=1, INC=6\n{drag}"));
    refused(&press, "SL0712", "step 1: increments from 1 to 5");
    write("drag.inp", drag.clone());
    refused(&press, "SL0711", "*RESTART, READ");
    write("drag.inp", format!("{READ}{drag}"));

    let states = std::fs::read(folder.join("press.rst")).unwrap();
    let mut old = states.clone();
    old[14] = 1;
    let mut damaged = states.clone();
    *damaged.last_mut().unwrap() ^= 1;
    let cases: [(&[u8], &str); 5] = [
        (b"", "not written by this program"),
        (b"*HEADING\n", "not written by this program"),
        (&old, "another version"),
        (&states[..states.len() - 1], "should have"),
        (&damaged, "STEP=1, INC=4"),
    ];
    for (bytes, words) in cases {
        std::fs::write(folder.join("press.rst"), bytes).unwrap();
        refused(&press, "SL0708", words);
    }
    same(&before, &files(&folder, "drag"), "refused");
}

/// A deck that goes on has no model of its own.
#[test]
fn cards_of_the_model_are_refused() {
    let folder = folder("model_cards");
    let [press, drag, _] = MOTIONS.map(|to| step(5, to));
    let write = |name: &str, deck: String| std::fs::write(folder.join(name), deck).unwrap();
    write("press.inp", model(WRITE, &irs()) + &press);
    run(&folder, "press", &[]);
    let own = "*NODE\n50, 0.0, 0.0\n*BOUNDARY\n1, 1\n*MATERIAL, NAME=N\n*ELASTIC\n1.0, 0.3\n";
    write("drag.inp", format!("{READ}{own}*NSET, NSET=MORE\n1, 3\n{drag}"));
    let output = slideline(&folder, &["run", "drag", "--oldjob", "press"]);
    let said = stderr(&output);
    assert_eq!((code(&output), said.matches("error[SL0214]").count()), (1, 4), "{said}");
    assert_eq!(said.matches("error[").count(), 4, "{said}");
    write("drag.inp", format!("{READ}*NSET, NSET=MORE\n1, 3\n"));
    let output = slideline(&folder, &["run", "drag", "--oldjob", "press"]);
    let said = stderr(&output);
    assert_eq!((code(&output), said.matches("error[SL0301]").count()), (1, 1), "{said}");
}
