//! The adviser on decks good and broken.
//!
//! Requirement: no warning or error on any deck of the good corpus (advice is
//! allowed, and due where slaves stand coarsely on a beam), and on each broken
//! deck of `corpus/advice` the codes that it announces.

#![allow(clippy::unwrap_used)] // a test may fail where it stands

use slideline::observe::Ending;
use slideline::{
    Diagnostic, Event, Job, Observer, Read, ReadOptions, Severity, SolveOptions, Stop, advise,
    mended, solve,
};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

fn decks(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus").join(folder);
    let mut decks: Vec<PathBuf> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    decks.retain(|path| path.extension().is_some_and(|ending| ending == "inp"));
    decks.sort();
    decks
}

fn read(path: &Path) -> (Read, Vec<Diagnostic>) {
    let read = Job::read(path, &ReadOptions::default());
    let said = advise(&read);
    (read, said)
}

/// Folders whose decks are good; those of `sound` have other shapes, ways and
/// units than the paper's.
const GOOD: [&str; 4] = ["diehl1995", "keywords", "sound", "tutorial"];

#[test]
fn good_decks_raise_no_warning() {
    let mut failed = Vec::new();
    let mut count = 0;
    for path in GOOD.iter().flat_map(|folder| decks(folder)) {
        count += 1;
        for said in read(&path).1.iter().filter(|said| said.severity >= Severity::Warning) {
            failed.push(format!("{}: {} {}", path.display(), said.code, said.message));
        }
    }
    assert!(count >= 80 && failed.is_empty(), "{}", failed.join("\n"));
}

/// Totals and diagnosis of a run without files; 400 increments at most.
fn solved(read: &Read) -> Ending {
    struct Until(usize);
    impl Observer for Until {
        fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
            self.0 -= usize::from(matches!(event, Event::Committed(_)));
            if self.0 == 0 {
                ControlFlow::Break(Stop::Interrupted)
            } else {
                ControlFlow::Continue(())
            }
        }
    }
    solve(read.model.as_ref().unwrap(), &SolveOptions::default(), &mut Until(400))
}

/// What the adviser calls sound runs to its end, and reading has nothing
/// against it either.
#[test]
fn sound_decks_run() {
    let mut failed = Vec::new();
    for path in decks("sound") {
        let (read, _) = read(&path);
        let warned = read.diagnostics.iter().filter(|said| said.severity >= Severity::Warning);
        failed.extend(
            warned.map(|said| format!("{}: {} {}", path.display(), said.code, said.message)),
        );
        match solved(&read) {
            Ending::Completed(totals) if totals.increments > 0 => {}
            other => failed.push(format!("{}: {other:?}", path.display())),
        }
    }
    assert!(decks("sound").len() >= 8 && failed.is_empty(), "{}", failed.join("\n"));
}

/// Diehl (1995), figure 4: the coarse IRS model is the noisy one.
#[test]
fn the_papers_coarse_irs_model_gets_its_advice() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/diehl1995");
    let (_, said) = read(&folder.join("irs_coarse.inp"));
    let role = said.iter().find(|said| said.code.0 == "SL0403").unwrap();
    // l/(2r) = 2.0853895 mm / 18 mm [verification: metrics and expectations]
    assert!(role.message.contains("0.116"), "{}", role.message);
}

#[test]
fn broken_decks_are_told_what_is_wrong() {
    let mut failed = Vec::new();
    for path in decks("advice") {
        let text = std::fs::read_to_string(&path).unwrap();
        let (read, said) = read(&path);
        let codes: Vec<&str> = said.iter().map(|said| said.code.0).collect();
        for code in text.lines().filter_map(|line| line.strip_prefix("**! ")) {
            if !codes.contains(&code) {
                let errors: Vec<_> = read.diagnostics.iter().map(|d| &d.message).collect();
                failed.push(format!("{}: {code} not in {codes:?}; {errors:?}", path.display()));
            }
        }
        failed.extend(
            said.iter()
                .filter(|d| d.span.is_none() || d.help.is_none())
                .map(|d| format!("{}: {} without a place or a remedy", path.display(), d.code)),
        );
    }
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}

/// The mended deck reads without error, runs, and has lost the finding; each
/// card has a comment that names the finding.
#[test]
fn a_suggested_card_mends_what_it_names() {
    let mut failed = Vec::new();
    let mut mended_decks = 0;
    for path in decks("advice") {
        let (read, said) = read(&path);
        let Some(bytes) = mended(&read, &said) else { continue };
        mended_decks += 1;
        let text = String::from_utf8(bytes).unwrap();
        let old = std::fs::read_to_string(&path).unwrap();
        for was in said.iter().filter(|was| was.edit.is_some()) {
            let comment = format!("** {}: ", was.code);
            if !text.contains(&comment) || old.contains(&comment) {
                failed.push(format!("{}: {} has no comment", path.display(), was.code));
            }
        }
        let again = Job::read_text("mended", &text, &ReadOptions::default());
        if again.model.is_none() {
            let errors: Vec<_> = again.diagnostics.iter().map(|d| &d.message).collect();
            failed.push(format!("{}: mended deck has errors: {errors:?}", path.display()));
            continue;
        }
        match solved(&again) {
            Ending::Completed(_) | Ending::Stopped(..) => {}
            Ending::NotConverged(_, why) => {
                failed.push(format!(
                    "{}: mended deck does not run: {}",
                    path.display(),
                    why.message
                ));
            }
        }
        let left = advise(&again);
        for was in said.iter().filter(|was| was.edit.is_some()) {
            let still = |d: &&Diagnostic| d.code == was.code && d.message == was.message;
            if left.iter().any(|d| still(&d)) {
                failed.push(format!("{}: {} is still there", path.display(), was.code));
            }
        }
    }
    assert!(mended_decks >= 8 && failed.is_empty(), "{mended_decks}: {}", failed.join("\n"));
}

/// Requirement: faces on one another that a tie, equations, contact or springs join were meant to have
/// nodes of their own, and so were those of what a step takes away; without any of these they are named.
#[test]
fn faces_that_were_meant_to_be_two_are_not_reported() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/advice");
    let deck = std::fs::read_to_string(folder.join("SL0410-unmerged-bricks-mm.inp")).unwrap();
    let surfaces = "*SURFACE, NAME=UPPER\nHEAD, S1\n*SURFACE, NAME=LOWER\nFOOT, S2\n";
    let pairs = [[101, 5], [102, 6], [103, 7], [104, 8]];
    let equations: String = pairs
        .iter()
        .flat_map(|[a, b]| (1..=3).map(move |dof| format!("2\n{a}, {dof}, 1., {b}, {dof}, -1.\n")))
        .collect();
    let springs: String = pairs.iter().map(|[a, b]| format!("{a}1, {a}, {b}\n")).collect();
    let joined = [
        format!("{surfaces}*TIE, NAME=GLUE\nUPPER, LOWER\n"),
        format!(
            "{surfaces}*SURFACE INTERACTION, NAME=TOUCH\n*CONTACT PAIR, INTERACTION=TOUCH, \
             TYPE=NODE TO SURFACE\nUPPER, LOWER\n"
        ),
        format!("*EQUATION\n{equations}"),
        format!("*ELEMENT, TYPE=SPRING2, ELSET=SOFT\n{springs}*SPRING, ELSET=SOFT\n3, 3\n1.\n"),
    ];
    let found = |deck: &str| {
        let read = Job::read_text("bricks", deck, &ReadOptions::default());
        assert!(read.model.is_some(), "{:?}\n{deck}", read.diagnostics);
        advise(&read).iter().any(|said| said.code.0 == "SL0410")
    };
    assert!(found(&deck));
    for card in joined {
        assert!(!found(&deck.replace("*STEP,", &format!("{card}*STEP,"))), "{card}");
    }
    let removed =
        "*MODEL CHANGE, TYPE=ELEMENT, REMOVE\nHEAD\n*DLOAD, OP=NEW\nFOOT, P2, 1.0\n*END STEP";
    let two_steps = format!("{deck}*STEP, NLGEOM\n*STATIC\n1.0, 1.0\n{removed}\n");
    assert!(!found(&two_steps));
}

/// Requirement: how far slaves stand along their master is asked of the places of both, whatever the formulation, and a
/// master is too short only where all slaves that are about as near go beyond its end: a block in the middle of a base
/// is drawn to either side, upon it and off its end. Source: closed form.
#[test]
fn strokes_along_masters_of_solids() {
    let deck = |form: &str, way: f64| {
        let mut base = String::from("*NODE\n");
        (0..=20).for_each(|k| base += &format!("{}, {k}., 0.\n{}, {k}., 2.\n", 1 + k, 101 + k));
        base += "*ELEMENT, TYPE=CPE4, ELSET=BASE\n";
        (0..20).for_each(|k| {
            base += &format!("{}, {}, {}, {}, {}\n", 1 + k, 1 + k, 2 + k, 102 + k, 101 + k)
        });
        format!(
            "{base}*NODE\n201, 9., 2.\n202, 11., 2.\n203, 11., 3.\n204, 9., 3.\n300, 10., 4.\n*ELEMENT, TYPE=CPE4, ELSET=UP\n\
             51, 201, 202, 203, 204\n*NSET, NSET=TOP\n203, 204\n*RIGID BODY, REF NODE=300, TIE NSET=TOP\n\
             *NSET, NSET=FIX, GENERATE\n1, 21\n*SOLID SECTION, ELSET=BASE, MATERIAL=M\n*SOLID SECTION, ELSET=UP, MATERIAL=M\n\
             *MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SURFACE, NAME=B\nBASE, S3\n*SURFACE, NAME=U\nUP, S1\n\
             *SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, TYPE={form}\nU, B\n*BOUNDARY\nFIX, 1, 2\n300, 6\n\
             *STEP, NLGEOM, INC=500\n*STATIC\n0.05, 1.\n*CLOAD\n300, 2, -5.\n*BOUNDARY\n300, 1, 1, {way:?}\n*END STEP\n"
        )
    };
    for form in ["SURFACE TO SURFACE", "NODE TO SURFACE"] {
        for (way, short) in
            [(-4.0, false), (4.0, false), (9.5, false), (-9.5, false), (13.0, true), (-13.0, true)]
        {
            let read = Job::read_text("stroke", &deck(form, way), &ReadOptions::default());
            assert!(read.model.is_some(), "{:#?}", read.diagnostics);
            let said = advise(&read);
            let found = said.iter().any(|own| own.code.0 == "SL0408");
            assert_eq!(found, short, "{form} {way} {said:#?}");
        }
    }
}

/// Requirement: where no support holds a body, how far it goes along with what it touches is not known before: that its
/// master is too short is advice (SL0408), and a warning where a support holds it. A block between a base and a plate that is
/// drawn away above it.
#[test]
fn what_goes_along_is_advised() {
    let deck = |held: &str| {
        format!(
            "*NODE\n1, 0., 0.\n2, 4., 0.\n3, 4., 1.\n4, 0., 1.\n11, 1., 1.\n12, 2., 1.\n13, 2., 2.\n\
             14, 1., 2.\n21, 0., 2.\n22, 4., 2.\n23, 4., 3.\n24, 0., 3.\n*ELEMENT, TYPE=CPE4, ELSET=E\n\
             1, 1, 2, 3, 4\n2, 11, 12, 13, 14\n3, 21, 22, 23, 24\n*SOLID SECTION, ELSET=E, MATERIAL=M\n1.\n\
             *MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SURFACE, NAME=BASE\n1, S3\n*SURFACE, NAME=FOOT\n\
             2, S1\n*SURFACE, NAME=HEAD\n2, S3\n*SURFACE, NAME=TOP\n3, S1\n*SURFACE INTERACTION, NAME=I\n\
             1.\n*FRICTION\n0.3\n*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nFOOT, BASE\n\
             HEAD, TOP\n*STEP, NLGEOM\n*STATIC\n0.1, 1.\n*BOUNDARY\n1, 1, 2\n2, 1, 2\n{held}\
             23, 1, 1, -5.\n24, 1, 1, -5.\n23, 2, 2, -0.01\n24, 2, 2, -0.01\n*END STEP\n"
        )
    };
    for (held, severity) in [("", Severity::Advice), ("11, 1, 1\n", Severity::Warning)] {
        let read = Job::read_text("block", &deck(held), &ReadOptions::default());
        let all = advise(&read);
        let said = all.iter().find(|said| said.code.0 == "SL0408").unwrap();
        assert_eq!(said.severity, severity, "{}", said.message);
    }
}
