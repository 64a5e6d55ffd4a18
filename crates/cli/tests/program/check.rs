//! `slideline check`: words for modern pairs, and decks that it mends.

#![allow(clippy::unwrap_used)] // a test may fail where it stands

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn slideline(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_slideline"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap()
}

fn corpus(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus").join(name);
    std::fs::read_to_string(path).unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Requirement: the mended deck stands beside the old one, with a comment on
/// each card; it runs; nothing is overwritten, however often that is done.
#[test]
fn a_mended_deck_stands_beside_the_old_one_and_overwrites_nothing() {
    let folder = folder("check_fix");
    let deck = corpus("advice/SL0407-circle-inside-out-mm.inp");
    std::fs::write(folder.join("roller.inp"), &deck).unwrap();
    std::fs::write(folder.join("roller.fixed.inp"), "mine\n").unwrap();
    for _ in 0..2 {
        let output = slideline(&folder, &["check", "roller", "--fix"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
    }
    assert_eq!(
        names(&folder),
        ["roller.fixed-2.inp", "roller.fixed-3.inp", "roller.fixed.inp", "roller.inp"]
    );
    let text = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    assert_eq!(text("roller.inp"), deck);
    assert_eq!(text("roller.fixed.inp"), "mine\n");
    assert_eq!(text("roller.fixed-2.inp"), text("roller.fixed-3.inp"));
    assert!(text("roller.fixed-2.inp").contains("** SL0407: "));
    let output = slideline(&folder, &["run", "roller.fixed-2", "--no-html", "--quiet"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}

/// Requirement: a card that was tried and does not help is told with the
/// reason, and no deck is written for it.
#[test]
fn a_card_that_does_not_help_is_not_offered() {
    let folder = folder("check_fix_left_out");
    let deck = corpus("advice/SL0409-free-beam.inp");
    std::fs::write(folder.join("beam.inp"), deck).unwrap();
    let output = slideline(&folder, &["check", "beam", "--fix"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(said.contains("SL0409: its card was tried and left out, because"), "{said}");
    assert_eq!(names(&folder), ["beam.inp"]);
}

/// Requirement: a run says what check says, on the terminal, in its summary
/// and in its report, and its verdict is not green then.
#[test]
fn a_run_says_what_check_says() {
    let folder = folder("check_run");
    let deck = corpus("diehl1995/irs_fine.inp");
    std::fs::write(folder.join("job.inp"), deck).unwrap();
    let output = slideline(&folder, &["run", "job"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    let seen = String::from_utf8_lossy(&output.stdout).into_owned();
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    let (summary, page) = (read("job.json"), read("job.html"));
    for code in ["SL0403", "SL0405"] {
        assert!(said.contains(&format!("advice[{code}]")), "{said}");
        assert!(summary.contains(&format!("\"code\":\"{code}\"")), "{summary}");
        assert!(page.contains(&format!("<strong>advice {code}</strong>")), "{code}");
    }
    let (note, advice) = (said.find("note[SL0204]").unwrap(), said.find("advice[SL0403]").unwrap());
    assert!(advice < note, "notes go below: {said}");
    assert!(summary.contains("\"verdict\":{\"colour\":\"amber\",\"reasons\":["), "{summary}");
    assert!(seen.contains("verdict: amber ("), "{seen}");
}

/// Requirement: the allowable decides margin, pass and fail, and a part that
/// fails makes the verdict red; no result depends on it.
#[test]
fn an_allowable_gives_margin_pass_and_fail() {
    let deck = corpus("keywords/ALLOWABLE.inp");
    let run = |stress: &str| {
        let folder = folder(&format!("allowable_{stress}"));
        let deck = deck.replace("STRESS=350.0E6", &format!("STRESS={stress}"));
        std::fs::write(folder.join("job.inp"), deck).unwrap();
        let output = slideline(&folder, &["run", "job", "--quiet", "--no-html"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let read = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
        (read("job.json"), read("job.history.csv"))
    };
    let (passes, history) = run("350.0E6");
    assert!(
        passes.contains("\"pass\":true") && passes.contains("\"colour\":\"green\""),
        "{passes}"
    );
    let (fails, same) = run("1.0E6");
    assert!(fails.contains("\"pass\":false") && fails.contains("\"colour\":\"red\""), "{fails}");
    assert_eq!(history, same);
}

/// Requirement: the undeformed model is drawn with an arrow for normals, the
/// smallest gap in words, and as a page that stands alone.
#[test]
fn the_model_is_drawn_before_it_runs() {
    let folder = folder("check_picture");
    std::fs::write(folder.join("snap.inp"), corpus("tutorial/snap_fit.inp")).unwrap();
    for name in ["snap.svg", "snap.html", "snap.png"] {
        let output = slideline(&folder, &["check", "snap", "--picture", name]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let bytes = std::fs::read(folder.join(name)).unwrap();
        let text = String::from_utf8_lossy(&bytes);
        match name {
            "snap.png" => assert_eq!(&bytes[1..4], b"PNG"),
            _ => {
                assert!(text.contains("gap 1.6") && text.contains("outward normal"), "{name}");
                assert!(!text.contains("NaN") && !text.contains("href="), "{name}");
            }
        }
    }
    let output = slideline(&folder, &["check", "snap", "--picture", "snap.pdf"]);
    assert_eq!(output.status.code(), Some(64), "{output:?}");
}

/// Requirement: rubber and its test data are drawn below the model, and what was fitted is said.
#[test]
fn rubber_is_drawn_with_its_test_data() {
    let folder = folder("check_rubber");
    std::fs::write(folder.join("block.inp"), corpus("keywords/PLANAR-TEST-DATA.inp")).unwrap();
    for name in ["block.svg", "block.html", "block.png"] {
        let output = slideline(&folder, &["check", "block", "--picture", name]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(said.contains("SL0285") && said.contains("alpha2 = "), "{said}");
        let text = std::fs::read(folder.join(name)).unwrap();
        let text = String::from_utf8_lossy(&text);
        assert!(name == "block.png" || text.contains("equibiaxial: law"), "{name}");
        assert!(!text.contains("NaN"), "{name}");
    }
}

/// Requirement: who is slave and who is master is told in the words of the
/// cards that the deck has.
#[test]
fn roles_are_told_in_the_words_of_the_deck() {
    let folder = folder("check_roles");
    let cases = [
        ("diehl1995/surface_coarse.inp", "contact is integrated along the first surface"),
        ("diehl1995/irs_modern.inp", "nodes of the first surface of *CONTACT PAIR are slaves"),
        ("diehl1995/isl_modern.inp", "the beams of the second one are the master"),
        ("diehl1995/irs_coarse.inp", "nodes of IRS elements are slaves"),
        ("diehl1995/isl_coarse.inp", "nodes of ISL elements are slaves"),
    ];
    for (name, words) in cases {
        std::fs::write(folder.join("job.inp"), corpus(name)).unwrap();
        for arguments in [&["check", "job"][..], &["check", "job", "--json"]] {
            let output = slideline(&folder, arguments);
            let text = String::from_utf8(output.stdout).unwrap();
            assert!(text.contains(words), "{name}: {text}");
            let old = name.contains("modern") || name.contains("surface");
            assert!(!old || !text.contains("IRS elements") && !text.contains("ISL elements"));
        }
    }
}

/// Requirement: the table of initial gaps has every slave node of integrated contact that faces
/// the master, near the zone of contact or not: here a circle of radius 9 mm whose lower half ends
/// at its equator. Source: distance from the circle.
#[test]
fn gaps_of_integrated_contact_are_those_of_its_nodes() {
    let folder = folder("check_gaps");
    std::fs::write(folder.join("job.inp"), corpus("diehl1995/surface_coarse.inp")).unwrap();
    let output = slideline(&folder, &["check", "job", "--json"]);
    let text = String::from_utf8(output.stdout).unwrap();
    let pair: serde_json::Value = text
        .lines()
        .map(|line| serde_json::from_str::<serde_json::Value>(line).unwrap())
        .find_map(|said| said.get("pair").cloned())
        .unwrap();
    let gaps = pair["initial_gaps"].as_array().unwrap();
    let known = gaps.iter().filter(|row| row["gap"].is_number()).count();
    assert!(known > 4, "{known} of {}: {gaps:?}", gaps.len());
}

/// Requirement: remedies speak the words of the deck they answer.
#[test]
fn remedies_speak_the_words_of_their_deck() {
    let folder = folder("check_words");
    for (name, own, other) in [
        ("irs_coarse", "*SLIDE LINE", "*SURFACE, TYPE=NODE"),
        ("irs_modern", "*SURFACE, TYPE=NODE", "*SLIDE LINE"),
    ] {
        std::fs::write(folder.join("job.inp"), corpus(&format!("diehl1995/{name}.inp"))).unwrap();
        let output = slideline(&folder, &["check", "job"]);
        let text = String::from_utf8(output.stderr).unwrap().replace('\n', " ");
        assert!(text.contains("SL0403") && text.contains(own), "{name}: {text}");
        let help = &text[text.find("SL0403").unwrap()..];
        assert!(!help.contains(other), "{name}: {help}");
    }
}

/// A strip whose middle block of ten is drawn along the world's x, or along its y by axes of its own: `turned` by 90
/// degrees, the first one.
fn drawn(turned: bool) -> String {
    let mut deck = String::from("*NODE\n");
    for (base, wide, low) in [(0, 10.0, -1.0), (100, 2.0, 0.0)] {
        for i in 0..=10 {
            for j in 0..2 {
                let (x, y) = (wide * 0.1 * f64::from(i), low + f64::from(j));
                writeln!(deck, "{}, {x:?}, {y:?}", base + 1 + 2 * i + j).unwrap();
            }
        }
    }
    for (base, set) in [(0, "LOWER"), (100, "UPPER")] {
        writeln!(deck, "*ELEMENT, TYPE=CPE4, ELSET={set}").unwrap();
        for i in 0..10 {
            let at = base + 1 + 2 * i;
            writeln!(deck, "{}, {at}, {}, {}, {}", base + 1 + i, at + 2, at + 3, at + 1).unwrap();
        }
        writeln!(deck, "*SOLID SECTION, ELSET={set}, MATERIAL=M").unwrap();
    }
    deck.push_str("*MATERIAL, NAME=M\n*ELASTIC\n1000.0, 0.3\n*SURFACE, NAME=FOOT\nUPPER, S1\n*SURFACE, NAME=TOP\n");
    deck.push_str(
        "LOWER, S3\n*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I\nFOOT, TOP\n",
    );
    let odd: Vec<String> = (0..=10).map(|i| (1 + 2 * i).to_string()).collect();
    let even: Vec<String> = (0..=10).map(|i| (102 + 2 * i).to_string()).collect();
    writeln!(deck, "*NSET, NSET=BASE\n{}", odd.join(", ")).unwrap();
    writeln!(deck, "*NSET, NSET=HEAD\n{}", even.join(", ")).unwrap();
    // of axes turned by 90 degrees the first one is y, the second one -x
    let (axes, along, down, way) = match turned {
        true => ("*TRANSFORM, NSET=HEAD\n0.0, 1.0, 0.0, -1.0, 0.0, 0.0\n", 2, 1, -7.0),
        false => ("", 1, 2, 7.0),
    };
    write!(
        deck,
        "{axes}*BOUNDARY\nBASE, 1, 2\n*STEP, NLGEOM\n*STATIC, DIRECT\n0.5, 1.0\n*BOUNDARY\n\
         HEAD, {along}, {along}, {way:?}\nHEAD, {down}, {down}, -0.01\n*END STEP\n"
    )
    .unwrap();
    deck
}

/// Requirement: motions along axes of their own are advised on as the same ones along those of the model.
#[test]
fn advice_on_motions_along_own_axes() {
    let folder = folder("check_own_axes");
    let advice = |turned: bool| -> Vec<String> {
        std::fs::write(folder.join("job.inp"), drawn(turned)).unwrap();
        let output = slideline(&folder, &["check", "job"]);
        let said = String::from_utf8(output.stderr).unwrap();
        said.lines().filter(|line| line.starts_with("advice[")).map(str::to_owned).collect()
    };
    let (own, models) = (advice(true), advice(false));
    assert!(models.iter().any(|line| line.contains("SL0405")), "{models:?}");
    assert_eq!(own, models);
}

/// A half turn of a band of beams round a drum that turns, with ends along its tangents.
fn band(unit: f64) -> String {
    let (count, radius) = (40, 10.0);
    let angle = |k: i32| std::f64::consts::PI * f64::from(k) / f64::from(count);
    let round = (0..=count).map(|k| [radius * angle(k).cos(), radius * angle(k).sin()]);
    let ends = [2.0, 1.0].map(|y| [radius, -y]).into_iter().chain(round);
    let mut deck = String::from("*NODE\n");
    for (k, [x, y]) in ends.chain([1.0, 2.0].map(|y| [-radius, -y])).enumerate() {
        writeln!(deck, "{}, {:?}, {:?}", k + 1, unit * x, unit * y).unwrap();
    }
    let (last, r) = (count + 5, unit * radius);
    write!(
        deck,
        "9000, 0., 0.\n*ELEMENT, TYPE=B21, ELSET=B\n1, 1, 2\n*ELGEN, ELSET=B\n1, {}, 1, 1\n*BEAM SECTION, SECTION=RECT, \
         ELSET=B, MATERIAL=M\n{:?}, {:?}\n*MATERIAL, NAME=M\n*ELASTIC\n{:?}, 0.3\n*SURFACE, NAME=DR, TYPE=SEGMENTS\n\
         START, 0., {:?}\nCIRCL, {:?}, 0., 0., 0.\nCIRCL, 0., {r:?}, 0., 0.\nCIRCL, {r:?}, 0., 0., 0.\nCIRCL, 0., {:?}, \
         0., 0.\n*RIGID BODY, REF NODE=9000, ANALYTICAL SURFACE=DR\n*SURFACE, NAME=SB\nB,\n*SURFACE INTERACTION, \
         NAME=I\n*FRICTION\n0.3\n*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nSB, DR\n*BOUNDARY\n9000, 1, 2\n\
         {last}, 1, 6\n*STEP, NLGEOM\n*STATIC\n0.05, 1.\n*BOUNDARY\n9000, 6, 6, -0.5\n*CLOAD\n1, 2, -1.\n*END STEP\n",
        last - 1,
        unit,
        0.1 * unit,
        200_000.0 / (unit * unit),
        -r,
        -r,
        -r
    )
    .unwrap();
    deck
}

/// Requirement: a slave that fits its master touches it everywhere, and rounding names no place where it does: nothing
/// is said of the way of that place, whatever the unit is. It went to and fro by a third of the band.
#[test]
fn a_slave_that_fits_its_master_goes_nowhere_by_rounding() {
    let folder = folder("check_band");
    for unit in [1.0, 1e-3, 25.4, 1e3] {
        std::fs::write(folder.join("job.inp"), band(unit)).unwrap();
        let output = slideline(&folder, &["check", "job"]);
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.success() && !said.contains("SL0405"), "{unit}: {said}");
    }
}
