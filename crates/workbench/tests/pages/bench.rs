//! The exchange with a bench, as a page has it.

#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)] // a test may fail where it stands

use crate::exchange::{ask, ask_until, last, opened, parameter, rows};
use serde_json::{Value, json};
use slideline::output::report::{Options, write};
use slideline::{Job, Quiet, ReadOptions, RunOptions, code_page, run};
use slideline_workbench::{Bench, KINDS, markdown, range};
use std::path::PathBuf;

const DECK: &str = include_str!("../../../../corpus/new/snap_fit.inp");

/// A folder of this test's own.
fn folder(name: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("slideline_bench_{}_{name}", std::process::id()));
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// Runs a deck with its files; the rows of a node's motion and reaction, and the report.
fn run_deck(name: &str, text: &str, columns: [&str; 2]) -> (Vec<[f64; 2]>, String) {
    let folder = folder(name);
    let path = folder.join(format!("{name}.inp"));
    std::fs::write(&path, text).unwrap();
    let mut read = Job::read(&path, &ReadOptions::default());
    read.diagnostics.extend(slideline::advise(&read));
    let notes = |said: &slideline::Diagnostic| said.severity == slideline::Severity::Note;
    read.diagnostics.sort_by_key(notes);
    let outcome = run(&read, &RunOptions::default(), &mut Quiet);
    let page = |code: &str| code_page(code).map(markdown::fragment);
    let report = write(&outcome.files, &Options { page, ..Options::default() }).unwrap();
    // a bench that reads from memory has no folder
    let beside = format!("{}/", folder.display());
    let page = std::fs::read_to_string(report.path).unwrap().replace(&beside, "");
    let csv = std::fs::read_to_string(outcome.files.path(".history.csv")).unwrap();
    let mut lines = csv.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    let place = columns.map(|name| head.iter().position(|own| *own == name).unwrap());
    let rows = lines.filter(|line| line.split(',').nth(3) == Some("100")).map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        place.map(|place| cells[place].parse::<f64>().unwrap())
    });
    let rows = rows.collect();
    std::fs::remove_dir_all(folder).unwrap();
    (rows, page)
}

/// Requirement: sliders are the parameters with numbers, in the words of the deck; what is computed
/// is none; ranges come from the deck, and from the user above it.
#[test]
fn parameters_are_read_with_their_words() {
    let text = DECK.replace("*PARAMETER\n", "** range thickness 1.0 3.0\n*PARAMETER\n");
    let ranges = vec![range("width=10:40").unwrap()];
    let mut bench = Bench::new().with_deck("snap_fit.inp", &text).with_ranges(ranges);
    let deck = last(&mut bench, &json!({"ask": "open", "id": 1}));
    let own = parameter(&deck, "thickness");
    let expected = json!({
        "name": "thickness", "value": 1.5, "minimum": 1, "maximum": 3, "integer": false,
        "about": "height of the arm", "origin": "parameter", "unit": "mm",
    });
    assert_eq!(own, expected);
    assert_eq!(parameter(&deck, "width")["maximum"], 40.0);
    assert_eq!(parameter(&deck, "length")["minimum"], 25.0);
    assert!(parameter(&deck, "stroke").is_null() && parameter(&deck, "x1").is_null());
    assert_eq!(deck["reaction"], json!({"node": 100, "component": "RF1", "motion": "U1"}));
    for wrong in ["a", "a=1", "a=2:1", "a=1:x", "a=1:1"] {
        assert!(range(wrong).is_none(), "{wrong}");
    }
}

/// Requirement: a state saved as a deck and run from files has the same bits, and the report that the
/// bench makes is that of the run but for the seconds it took.
#[test]
fn a_saved_deck_has_the_same_bits() {
    let values = json!({"thickness": 1.733, "mu": 0.21, "lead": 33.5});
    let (mut bench, _) = opened("snap_fit.inp", DECK);
    let said = ask(&mut bench, &json!({"ask": "solve", "id": 2, "values": values}));
    let end = said.last().unwrap();
    assert_eq!((&end["say"], &end["status"]), (&json!("end"), &json!("completed")));
    let save = |what: &str| json!({"ask": "save", "id": 3, "what": what, "values": values});
    let deck = last(&mut bench, &save("deck"));
    let text = deck["text"].as_str().unwrap();
    assert!(text.contains("thickness = 1.733        # height of the arm [mm]"), "{text}");
    let (ran, page) = run_deck("snap_fit", text, ["U1", "RF1"]);
    let rows = rows(&said);
    assert_eq!(rows.len(), ran.len() + 1);
    assert_eq!(rows[0][3..], [0.0, 0.0]);
    for (own, ran) in rows[1..].iter().zip(&ran) {
        assert_eq!([own[3].to_bits(), own[4].to_bits()], ran.map(f64::to_bits), "{own:?}");
    }
    let report = last(&mut bench, &save("report"));
    let clean = |page: &str| -> Vec<String> {
        let page = page.replace("><", ">\n<");
        page.lines().map(str::to_owned).collect()
    };
    let (own, ran) = (clean(report["text"].as_str().unwrap()), clean(&page));
    assert_eq!(own.len(), ran.len());
    let differ: Vec<_> = own.iter().zip(&ran).filter(|(own, ran)| own != ran).collect();
    assert!(differ.len() <= 1, "{:.4000}", format!("{differ:#?}"));
    assert!(differ.iter().all(|(own, _)| own.ends_with(" s</dd>")), "{differ:#?}");
    let script = last(&mut bench, &save("python"));
    let script = script["text"].as_str().unwrap();
    assert!(
        script.contains("thickness = 1.733") && script.contains("result.history(100, \"RF1\")")
    );
}

/// Requirement: a solve ends as soon as something newer is asked for, and the next one has the bits of
/// one that was never disturbed.
#[test]
fn a_newer_request_ends_an_older_one() {
    let (mut bench, _) = opened("snap_fit.inp", DECK);
    let solve = json!({"ask": "solve", "id": 2, "values": {"thickness": 2.0}});
    let whole = ask(&mut bench, &solve);
    let mut asked = 0;
    let left = ask_until(&mut bench, &json!({"ask": "solve", "id": 3}), |_| {
        asked += 1;
        asked < 20
    });
    assert_eq!(left.last().unwrap(), &json!({"say": "overtaken", "id": 3}));
    assert!(
        rows(&left).len() < 30 && asked < 30,
        "{} rows, asked {asked} times",
        rows(&left).len()
    );
    assert_eq!(rows(&ask(&mut bench, &solve)), rows(&whole));
}

/// Requirement: a deck with an error is answered with its diagnostics, solving it says them, and a
/// sound text makes the bench sound again.
#[test]
fn errors_of_an_edit_are_told() {
    let (mut bench, _) = opened("snap_fit.inp", DECK);
    let wrong = DECK.replace("*FRICTION", "*FRICTON");
    let deck = last(&mut bench, &json!({"ask": "deck", "id": 2, "text": wrong}));
    let said = deck["diagnostics"].as_array().unwrap();
    let error = said.iter().find(|own| own["severity"] == "error").unwrap();
    let line = 1 + wrong.lines().position(|line| line == "*FRICTON").unwrap();
    assert_eq!((&deck["sound"], &error["line"]), (&json!(false), &json!(line)), "{error}");
    assert_eq!(error["file"], "snap_fit.inp");
    let end = last(&mut bench, &json!({"ask": "solve", "id": 3}));
    assert_eq!((&end["status"], &end["verdict"]["colour"]), (&json!("input_error"), &json!("red")));
    let deck = last(&mut bench, &json!({"ask": "deck", "id": 4, "text": DECK}));
    assert_eq!(deck["sound"], true);
    let bad = json!({"ask": "solve", "id": 5, "values": {"length": -1.0}});
    let end = last(&mut bench, &bad);
    assert_ne!(end["verdict"]["colour"], "green", "{end}");
    assert_eq!(last(&mut bench, &json!({"ask": "solve", "id": 6}))["status"], "completed");
}

/// Requirement: every deck to begin with opens, has sliders, and solves to a verdict that is not red.
#[test]
fn every_deck_to_begin_with_solves() {
    let start = last(&mut Bench::new(), &json!({"ask": "open", "id": 1}));
    assert_eq!(start["kinds"].as_array().unwrap().len(), KINDS.len());
    assert!(start["kinds"][0]["picture"].as_str().unwrap().starts_with("<svg"));
    for kind in KINDS {
        let mut bench = Bench::new();
        let deck = last(&mut bench, &json!({"ask": "new", "id": 1, "kind": kind.kind}));
        assert!(deck["parameters"].as_array().unwrap().len() > 5, "{}", kind.kind);
        let said = ask(&mut bench, &json!({"ask": "solve", "id": 2}));
        let end = said.last().unwrap();
        assert_eq!(end["status"], "completed", "{}", kind.kind);
        assert_ne!(end["verdict"]["colour"], "red", "{}", kind.kind);
        assert!(rows(&said).len() > 10 && said[1]["rows"].as_array().unwrap().len() == 1);
        assert_eq!(end["formula"].is_null(), kind.kind != "snap-fit", "{}", kind.kind);
    }
}

/// Requirement: the push-in force of the design guides is that of the theory for the arm and its ramp
/// (mm, N, MPa), where the crest is as high as the hook is bent; the solved force is near it.
#[test]
fn the_rule_is_that_of_the_guides() {
    let deck = DECK.replace("fillet = 0.2", "fillet = 0.0001");
    let (mut bench, _) = opened("snap_fit.inp", &deck);
    let end = last(&mut bench, &json!({"ask": "solve", "id": 2}));
    let arm = slideline_theory::closed::snap_fit::SnapFit {
        width: 25.0,
        thickness: 1.5,
        length: 50.0,
        modulus: 2400.0,
    };
    let rule = arm.mating_force(2.0, 30f64.to_radians(), 0.3).unwrap();
    let told = end["formula"]["value"].as_f64().unwrap();
    assert!((told / rule - 1.0).abs() < 0.02, "{told} {rule}");
    let solved = end["figures"]["push_in"].as_f64().unwrap();
    assert!((solved / rule - 1.0).abs() < 0.15, "{solved} {rule}");
    // the dashed curve pushes where the solved one pushes
    let curve = end["formula"]["curve"].as_array().unwrap();
    let least = curve.iter().filter_map(|own| own[1].as_f64()).fold(0.0, f64::min);
    assert!((least / told + 1.0).abs() < 0.02, "{least}");
}

/// Requirement: solving for a force finds the parameter that gives it, to 1e-6; what is out of reach
/// is missed with the nearest there is.
#[test]
fn a_parameter_follows_a_wanted_force() {
    let (mut bench, _) = opened("snap_fit.inp", DECK);
    let aim = |wanted: f64| json!({"ask": "aim", "id": 2, "parameter": "thickness", "response": "push_in", "wanted": wanted});
    let aimed = last(&mut bench, &aim(1.5));
    assert_eq!(aimed["say"], "aimed", "{aimed}");
    assert!(aimed["steps"].as_u64().unwrap() <= 6 && aimed["slopes"] == "exact", "{aimed}");
    let values = json!({"thickness": aimed["value"]});
    let end = last(&mut bench, &json!({"ask": "solve", "id": 3, "values": values}));
    let force = end["figures"]["push_in"].as_f64().unwrap();
    assert!((force / 1.5 - 1.0).abs() <= 1e-6, "{force}");
    let mut other = aim(1.5);
    other["slopes"] = json!("differences");
    let again = last(&mut bench, &other);
    assert_eq!((&again["say"], &again["slopes"]), (&json!("aimed"), &json!("differences")));
    let [a, b] = [&aimed, &again].map(|own| own["value"].as_f64().unwrap());
    assert!((a / b - 1.0).abs() < 1e-5, "{a} {b}");
    // a verdict of the strain has no derivative: the answer says that it was done without
    let asked = json!({"ask": "aim", "id": 2, "parameter": "thickness", "response": "utilisation", "wanted": 0.06});
    let aimed = last(&mut bench, &asked);
    assert!(aimed["slopes"] == "differences" && aimed["because"].is_string(), "{aimed}");
    let missed = last(&mut bench, &aim(1000.0));
    assert_eq!(missed["say"], "missed", "{missed}");
    let nearest = missed["nearest"].as_f64().unwrap();
    assert!(nearest > 5.0 && nearest < 1000.0, "{missed}");
    assert!((missed["value"].as_f64().unwrap() - 3.0).abs() < 1e-9);
}

/// Requirement: the band holds the curve, grows with the tolerance, and is to first order that of the
/// modulus: forces are proportional to it where contact is hard against bending.
#[test]
fn a_band_is_as_wide_as_its_tolerances() {
    let (mut bench, _) = opened("snap_fit.inp", DECK);
    let mut width = |tolerance: f64| {
        let asked = json!({"ask": "band", "id": 2, "tolerances": {"modulus": tolerance}});
        let band = last(&mut bench, &asked);
        let column = |name: &str| -> Vec<f64> {
            band[name].as_array().unwrap().iter().map(|own| own.as_f64().unwrap()).collect()
        };
        let (low, high) = (column("low"), column("high"));
        assert!(low.len() == 201 && low.iter().zip(&high).all(|(low, high)| low <= high));
        let place = (0..201).min_by(|a, b| low[*a].total_cmp(&low[*b])).unwrap();
        (high[place] - low[place]) / (high[place] + low[place])
    };
    let expected = 1.644_853_6 * 0.05 / 3f64.sqrt();
    let found = width(0.05).abs();
    assert!((found / expected - 1.0).abs() < 0.05, "{found} {expected}");
    assert!((width(0.025).abs() / found - 0.5).abs() < 0.02);
    // exact slopes are those of differences with a small tolerance, by what moves force and travel too
    for name in ["thickness", "mu", "lead"] {
        let mut side = |slopes: &str| {
            let asked =
                json!({"ask": "band", "id": 2, "tolerances": {name: 1e-4}, "slopes": slopes});
            let band = last(&mut bench, &asked);
            let expected = if slopes == "exact" { json!([]) } else { json!([name]) };
            assert_eq!(band["differences"], expected, "{band:.300}");
            let column = |name: &str| -> Vec<f64> {
                band[name].as_array().unwrap().iter().map(|own| own.as_f64().unwrap()).collect()
            };
            let (low, high) = (column("low"), column("high"));
            low.iter().zip(&high).map(|(low, high)| high - low).collect::<Vec<f64>>()
        };
        let (exact, differences) = (side("exact"), side("differences"));
        let most = exact.iter().copied().fold(0.0, f64::max);
        let near = |(a, b): (&f64, &f64)| (a - b).abs() < 0.02 * most;
        let count = exact.iter().zip(&differences).filter(|own| near(*own)).count();
        assert!(most > 0.0 && count >= 185, "{name}: {count}");
    }
}

/// Requirement: keywords and their parameters complete a line, and pages explain.
#[test]
fn words_are_completed_and_explained() {
    let mut bench = Bench::new();
    let complete =
        |line: &str| json!({"ask": "complete", "id": 1, "line": line, "column": line.len()});
    let words = |told: &Value| -> Vec<String> {
        let all = told["words"].as_array().unwrap().iter();
        all.map(|own| own["word"].as_str().unwrap().to_owned()).collect()
    };
    let told = last(&mut bench, &complete("*CONTACT P"));
    assert!(words(&told).contains(&"*CONTACT PAIR".to_owned()), "{told}");
    assert!(words(&told).iter().all(|own| own.starts_with("*CONTACT P")));
    let told = last(&mut bench, &complete("*BEAM SECTION, EL"));
    assert_eq!(words(&told), ["ELSET="]);
    for line in ["1, 2, 3", "** a comment", "*NOTHING, A"] {
        assert!(words(&last(&mut bench, &complete(line))).is_empty(), "{line}");
    }
    for word in ["CONTACT PAIR", "SL0301"] {
        let page = last(&mut bench, &json!({"ask": "explain", "id": 2, "word": word}));
        assert!(page["html"].as_str().unwrap().contains(word), "{page}");
    }
}

/// Requirement: what is not understood is refused with a reason, and nothing else happens.
#[test]
fn nonsense_is_refused() {
    let (mut bench, _) = opened("snap_fit.inp", DECK);
    for message in [
        json!({}),
        json!([1]),
        json!({"ask": "dance", "id": 3}),
        json!({"ask": "solve", "id": 3, "values": {"nothing": 1.0}}),
        json!({"ask": "solve", "id": 3, "values": {"length": "long"}}),
        json!({"ask": "aim", "id": 3, "parameter": "nothing", "response": "push_in", "wanted": 1}),
        json!({"ask": "aim", "id": 3, "parameter": "length"}),
        json!({"ask": "band", "id": 3, "tolerances": {"length": -1.0}}),
        json!({"ask": "save", "id": 3, "what": "world"}),
        json!({"ask": "new", "id": 3, "kind": "spoon"}),
        json!({"ask": "deck", "id": 3}),
        json!({"ask": "explain", "id": 3, "word": "SL9999"}),
    ] {
        let said = ask(&mut bench, &message);
        assert_eq!(said.len(), 1, "{message}");
        assert_eq!(said[0]["say"], "refused", "{message}: {}", said[0]);
        assert!(!said[0]["why"].as_str().unwrap().is_empty());
    }
    let mut said = String::new();
    bench.answer("{", &mut |text: &str| {
        said.push_str(text);
        true
    });
    assert!(said.contains("refused"));
}
