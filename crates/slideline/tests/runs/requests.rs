//! What output requests do to the files: which increments leave states and
//! rows, and what the printed tables hold.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::output::report;
use slideline::{Job, Quiet, ReadOptions, RunOptions, Severity, Status, run};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A slave node of a rigid cam that is pressed on a cantilever and drawn along
/// it with friction, in two steps: ten increments to press and draw down, ten
/// to draw up again. `{first}` and `{second}` stand for requests.
const DECK: &str = "*NODE, NSET=BEAM
1, 0.0, 0.0
5, 0.0, 50.0E-3
*NGEN, NSET=BEAM
1, 5
*NSET, NSET=LOWER
1, 2
*ELEMENT, TYPE=B21, ELSET=BEAM
1, 1, 2
*ELGEN, ELSET=BEAM
1, 4
*ELSET, ELSET=ROOT
1, 2
*BEAM SECTION, SECTION=RECT, ELSET=BEAM, MATERIAL=STEEL
10.0E-3, 1.0E-3
*MATERIAL, NAME=STEEL
*ELASTIC
210.0E9, 0.3
*NODE
100, -9.0E-3, 45.0E-3
*NODE, NSET=CAM
101, -1.0E-3, 41.0E-3
102, -0.1E-3, 44.0E-3
103, -1.0E-3, 47.0E-3
*NSET, NSET=NOSE
102
*MPC
BEAM, CAM, 100
*ELEMENT, TYPE=ISL21, ELSET=TIP
201, 101, 102
202, 102, 103
*SLIDE LINE, ELSET=TIP, SMOOTH=0.25
2, 3, 4, 5
*INTERFACE, ELSET=TIP
10.0E-3
*FRICTION
0.3
*SURFACE CONTACT, SOFTENED
1.0E-5, 4.8E6
*STEP, NLGEOM
*STATIC
0.1, 1.0, 1.0E-6, 0.1
*BOUNDARY
1, 1, 6
100, 1, 1, 0.4E-3
100, 2, 2, -10.0E-3
100, 6
{first}*END STEP
*STEP, NLGEOM
*STATIC
0.1, 1.0, 1.0E-6, 0.1
*BOUNDARY
100, 2, 2, -2.0E-3
{second}*END STEP
";

/// The deck with those requests.
fn deck(first: &str, second: &str) -> String {
    DECK.replace("{first}", first).replace("{second}", second)
}

fn folder_of(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("requests").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    folder
}

/// Runs a deck to its end; the number of increments.
fn solve(folder: &Path, deck: &str) -> usize {
    let read = Job::read_text("cam", deck, &ReadOptions::default());
    let options = RunOptions { folder: Some(folder.to_owned()), ..RunOptions::default() };
    let outcome = run(&read, &options, &mut Quiet);
    assert_eq!(outcome.status, Status::Completed, "{}: {:?}", folder.display(), read.diagnostics);
    outcome.totals.increments
}

/// Runs the deck with those requests; the folder of the files.
fn files(name: &str, first: &str, second: &str) -> PathBuf {
    let folder = folder_of(name);
    assert_eq!(solve(&folder, &deck(first, second)), 20, "{name}: ten increments a step");
    folder
}

fn text(folder: &Path, ending: &str) -> String {
    std::fs::read_to_string(folder.join(format!("cam{ending}"))).unwrap()
}

/// Numbers of the states that stand in the folder.
fn states(folder: &Path) -> Vec<usize> {
    let names = std::fs::read_dir(folder).unwrap();
    let names = names.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut numbers: Vec<usize> = names
        .filter_map(|name| name.strip_prefix("cam_")?.strip_suffix(".vtu")?.parse().ok())
        .collect();
    numbers.sort_unstable();
    numbers
}

/// Step and increment of the results in a .frd file: two groups of ten places
/// behind the number of the block.
fn frd_results(folder: &Path) -> Vec<(usize, usize)> {
    let text = text(folder, ".frd");
    let heads = text.lines().filter_map(|line| line.strip_prefix("    1PSTEP"));
    let words = heads.map(|head| head.split_whitespace().map(|w| w.parse::<usize>().unwrap()));
    let mut found: Vec<(usize, usize)> = words
        .map(|words| words.skip(1).collect::<Vec<usize>>())
        .map(|numbers| (numbers[1], numbers[0]))
        .collect();
    found.dedup();
    found
}

/// Requirement: FREQUENCY=N writes every N-th increment of a step and its last
/// one, 0 none; several cards what any of them asks for; without a card every
/// increment. Requests stand until a step makes new ones. Source: Abaqus
/// manual, `*OUTPUT`, `*NODE FILE`. The list of states names those that stand
/// in the folder, and no other.
#[test]
fn frequency_rules_which_increments_leave_states() {
    let every: Vec<usize> = (0..=20).collect();
    let cases: [(&str, &str, &str, &[usize]); 7] = [
        ("none", "", "", &every),
        ("history", "*OUTPUT, HISTORY, FREQUENCY=5\n*NODE OUTPUT\nU\n", "", &every),
        ("field", "*OUTPUT, FIELD, FREQUENCY=4\n*NODE OUTPUT\nU\n", "", &[0, 4, 8, 10, 14, 18, 20]),
        (
            "old",
            "*NODE FILE, FREQUENCY=6\nU\n*EL FILE, FREQUENCY=4\nS\n",
            "",
            &[0, 4, 6, 8, 10, 14, 16, 18, 20],
        ),
        (
            "changed",
            "*CONTACT FILE, FREQUENCY=100\nCSTRESS\n",
            "*OUTPUT, FIELD, FREQUENCY=5\n",
            &[0, 10, 15, 20],
        ),
        ("half", "*OUTPUT, FIELD, FREQUENCY=0\n", "*OUTPUT, FIELD, FREQUENCY=5\n", &[0, 15, 20]),
        ("never", "*OUTPUT, FIELD, FREQUENCY=0\n", "", &[]),
    ];
    for (name, first, second, expected) in cases {
        let folder = files(&format!("frequency-{name}"), first, second);
        assert_eq!(states(&folder), expected, "{name}");
        let listed = match expected {
            [] => Vec::new(),
            _ => text(&folder, ".pvd").lines().map(str::to_owned).collect(),
        };
        let listed: Vec<&str> =
            listed.iter().filter_map(|line| line.split("file=\"").nth(1)).collect();
        let names: Vec<String> = expected.iter().map(|n| format!("cam_{n:04}.vtu\"/>")).collect();
        assert_eq!(listed, names, "{name}");
        let json = text(&folder, ".json");
        assert!(json.contains(&format!("\"states\":{},", expected.len())), "{name}: {json}");
        let asked = first.contains("FILE") || (first.contains("FIELD") && name != "never");
        assert_eq!(folder.join("cam.frd").exists(), asked, "{name}: .frd is for who asks");
        if asked {
            let after = expected.iter().filter(|number| **number > 0);
            let results = after.map(|n| if *n > 10 { (2, n - 10) } else { (1, *n) });
            assert_eq!(frd_results(&folder), results.collect::<Vec<_>>(), "{name}");
        }
    }
}

/// Requirement: what the contract fixes does not depend on requests: motion
/// and reaction, contact and energy of every converged increment. No
/// tolerance: the same text.
#[test]
fn histories_have_every_increment_whatever_is_asked_for() {
    let plain = files("histories-plain", "*NODE PRINT, NSET=LOWER\nU\n", "");
    let thin = "*NODE PRINT, NSET=LOWER, FREQUENCY=0\nU\n*OUTPUT, FIELD, FREQUENCY=0\n\
                *OUTPUT, HISTORY, FREQUENCY=7\n*NODE OUTPUT, NSET=LOWER\nU\n";
    let thin = files("histories-thin", thin, "");
    for ending in [".history.csv", ".contact.csv", ".energy.csv"] {
        assert_eq!(text(&plain, ending), text(&thin, ending), "{ending}");
    }
    assert_eq!(text(&thin, ".energy.csv").lines().count(), 21);
    assert!(!text(&thin, ".dat").contains("TOTAL TIME"), "a table that is never due");
    assert!(text(&thin, ".dat").contains("  states never"), "what was understood");
}

/// Requirement: the requests that a preprocessor writes into every deck are
/// read without a word, and FREQUENCY=0 saves no state to go on from. Source:
/// Abaqus manual, `*RESTART`, `*OUTPUT`.
#[test]
fn the_usual_requests_are_read() {
    let usual = "*Restart, write, frequency=0\n*Output, field, variable=PRESELECT\n\
                 *Node Output\nU, RF\n*Element Output, directions=YES\nSF, S\n\
                 *Output, history, variable=PRESELECT\n";
    let folder = files("usual", usual, "");
    assert!(!folder.join("cam.rst").exists(), "0 saves nothing");
    assert!(folder.join("cam.frd").exists() && folder.join("cam.element.csv").exists());
    let read = Job::read_text("cam", &deck(usual, ""), &ReadOptions::default());
    let loud = read.diagnostics.iter().filter(|said| said.severity > Severity::Note);
    assert_eq!(loud.map(|said| said.message.as_str()).collect::<Vec<_>>(), [""; 0]);
}

/// Requirement: rows of element results come as often as their own cards say.
#[test]
fn element_results_come_as_often_as_their_cards_say() {
    let first = "*OUTPUT, HISTORY, FREQUENCY=4\n*ELEMENT OUTPUT, ELSET=ROOT\nSF\n\
                 *EL FILE, FREQUENCY=5, ELSET=BEAM\nS\n";
    let table = text(&files("elements", first, ""), ".element.csv");
    let mut found: BTreeMap<(usize, usize), Vec<usize>> = BTreeMap::new();
    for row in table.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let number = |place: usize| cells[place].parse().unwrap();
        found.entry((number(0), number(1))).or_default().push(number(3));
    }
    for step in [1, 2] {
        for (increment, beams) in
            [(4, &[1, 2][..]), (5, &[1, 2, 3, 4]), (8, &[1, 2]), (10, &[1, 2, 3, 4])]
        {
            assert_eq!(found.remove(&(step, increment)).unwrap(), beams, "{step} {increment}");
        }
    }
    assert!(found.is_empty(), "{found:?}");
}

/// Requirement: a report of thinned states is made, says which increments it
/// can draw, and misses no listed state silently.
#[test]
fn a_report_of_thinned_states_says_so() {
    let page = |folder: &Path| {
        let job = slideline::output::JobFiles::new(folder, "cam");
        report::write(&job, &report::Options::default()).map(|_| text(folder, ".html"))
    };
    let folder = files("report", "*OUTPUT, FIELD, FREQUENCY=4\n", "");
    let html = page(&folder).unwrap();
    assert!(html.contains("written for 6 of 20 converged increments"), "the page says so");
    assert!(html.contains("4, 8, 10, 14, 18, 20"), "and which");
    assert!(html.contains("\"states\":[0,4,8,10,14,18,20]"));
    std::fs::remove_file(folder.join("cam_0008.vtu")).unwrap();
    assert!(page(&folder).unwrap_err().to_string().contains("cam_0008.vtu"));
    let whole = files("report-whole", "", "");
    assert!(!page(&whole).unwrap().contains("States were written"), "nothing to say");
    std::fs::remove_file(whole.join("cam.pvd")).unwrap();
    assert!(page(&whole).unwrap_err().to_string().contains("cam.pvd"));
    let none = files("report-none", "*OUTPUT, FIELD, FREQUENCY=0\n", "");
    let html = page(&none).unwrap();
    assert!(html.contains("asked for no states") && html.contains("\"states\":[]"));
}

/// Requirement: an unknown variable is told, with those that are known, and left out: no result
/// of the others depends on it.
#[test]
fn unknown_variables_are_told() {
    for card in [
        "*NODE PRINT\nU, SDGE\n",
        "*CONTACT PRINT\nCSTRESS, SDGE\n",
        "*EL PRINT\nS, SDGE\n",
        "*NODE FILE\nU, SDGE\n",
        "*EL FILE\nS, SDGE\n",
        "*CONTACT FILE\nCSTRESS, SDGE\n",
        "*OUTPUT, FIELD\n*NODE OUTPUT\nU, SDGE\n",
        "*OUTPUT, FIELD\n*ELEMENT OUTPUT\nS, SDGE\n",
        "*OUTPUT, HISTORY\n*CONTACT OUTPUT\nCSTRESS, SDGE\n",
    ] {
        let read = Job::read_text("cam", &deck(card, ""), &ReadOptions::default());
        let said: Vec<_> = read.diagnostics.iter().filter(|said| said.code.0 == "SL0252").collect();
        let [only] = said.as_slice() else { panic!("{card}: {said:?}") };
        assert_eq!(only.severity, Severity::Warning, "{card}");
        assert!(only.message.contains("`SDGE`"), "{card}: {}", only.message);
        assert!(only.help.iter().any(|help| help.contains("known: ")), "{card}");
        assert!(read.model.is_some(), "{card}");
    }
}

/// Requirement: what other programs write and this one does not is a note: nothing is doubtful.
#[test]
fn variables_of_other_programs_are_notes() {
    for (card, name) in [
        ("*NODE FILE\nU, PU\n", "PU"),
        ("*EL FILE\nS, err\n", "err"),
        ("*OUTPUT, FIELD\n*ELEMENT OUTPUT\nS, THE\n", "THE"),
        ("*OUTPUT, FIELD\n*CONTACT OUTPUT\nCSTRESS, CSTATUS\n", "CSTATUS"),
    ] {
        let read = Job::read_text("cam", &deck(card, ""), &ReadOptions::default());
        let quoted = format!("`{name}`");
        let said = read.diagnostics.iter().find(|said| said.message.contains(&quoted)).unwrap();
        assert_eq!((said.code.0, said.severity), ("SL0257", Severity::Note), "{card}");
    }
}

/// A printed table: its title, names of the columns and rows of words.
struct Printed {
    title: String,
    names: Vec<String>,
    rows: Vec<Vec<String>>,
}

/// The tables of a .dat file, read as a person would: a title, a line of
/// names, rows until an empty line.
fn tables(folder: &Path) -> Vec<Printed> {
    let text = text(folder, ".dat");
    let words = |line: &str| line.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let is_title = |line: &str| line.starts_with("STEP ") && line.contains("TOTAL TIME");
    let lines: Vec<&str> = text.lines().collect();
    let titles = (0..lines.len()).filter(|&at| is_title(lines[at]));
    titles
        .map(|at| {
            let rows = lines[at + 2..].iter().take_while(|line| !line.is_empty());
            Printed {
                title: lines[at].to_owned(),
                names: words(lines[at + 1]),
                rows: rows.map(|line| words(line)).collect(),
            }
        })
        .collect()
}

impl Printed {
    /// Step and increment of the title.
    fn when(&self) -> [String; 2] {
        let words: Vec<&str> = self.title.split_whitespace().collect();
        [words[1].to_owned(), words[3].to_owned()]
    }

    /// The row of a node or element (or the one named so), by column.
    fn row(&self, key: &str, label: &str) -> BTreeMap<&str, &str> {
        let place = self.names.iter().position(|name| name == key).unwrap();
        let row = self.rows.iter().find(|row| row[place] == label).unwrap();
        self.names.iter().map(String::as_str).zip(row.iter().map(String::as_str)).collect()
    }

    fn labels(&self, key: &str) -> Vec<&str> {
        let place = self.names.iter().position(|name| name == key).unwrap();
        self.rows.iter().map(|row| row[place].as_str()).collect()
    }
}

/// Rows of a CSV file by column name.
fn csv(folder: &Path, ending: &str) -> Vec<BTreeMap<String, String>> {
    let text = text(folder, ending);
    let names: Vec<String> = text.lines().next().unwrap().split(',').map(str::to_owned).collect();
    let rows = text.lines().skip(1);
    rows.map(|row| names.iter().cloned().zip(row.split(',').map(str::to_owned)).collect()).collect()
}

/// A printed number against one of a CSV file: eight digits stand in a table.
fn near(printed: &str, written: &str, what: &str) {
    let (shown, value): (f64, f64) = (printed.parse().unwrap(), written.parse().unwrap());
    let same = shown == value || (shown - value).abs() <= 0.6e-7 * value.abs();
    assert!(same, "{what}: the table shows {printed}, the file {written}");
}

/// Requirement: `*NODE PRINT` shows the nodes of its set, once in each
/// increment that is due, with the values of JOB.history.csv.
#[test]
fn node_tables_hold_what_the_history_holds() {
    let asked = "*NODE PRINT, NSET=LOWER, FREQUENCY=3\nU, RF2\n";
    let folder = files("dat-nodes", asked, "");
    let tables = tables(&folder);
    let when: Vec<[String; 2]> = tables.iter().map(Printed::when).collect();
    let due = [1, 2].iter().flat_map(|step| [3, 6, 9, 10].map(|inc| (*step, inc)));
    assert_eq!(when, due.map(|(s, i)| [s, i].map(|n: i32| n.to_string())).collect::<Vec<_>>());
    let history = csv(&folder, ".history.csv");
    for table in &tables {
        assert!(table.title.ends_with("NODES LOWER"), "{}", table.title);
        assert_eq!(table.names, ["NODE", "U1", "U2", "UR3", "RF1", "RF2", "RM3"]);
        assert_eq!(table.labels("NODE"), ["1", "2"]);
        let [step, increment] = table.when();
        for label in ["1", "2"] {
            let same = |row: &&BTreeMap<String, String>| {
                row["step"] == step && row["increment"] == increment && row["node"] == label
            };
            let row = history.iter().find(same).unwrap();
            for (name, shown) in
                table.row("NODE", label).iter().filter(|(name, _)| **name != "NODE")
            {
                near(shown, &row[*name], &format!("{} node {label} {name}", table.title));
            }
        }
    }
    let reaction: f64 = tables[7].row("NODE", "1")["RF1"].parse().unwrap();
    assert!(reaction.abs() > 0.1, "the root carries what the cam pushes: {reaction}");
}

/// Requirement: `*CONTACT PRINT` shows the slave nodes of its set, open ones
/// too, with status and values of JOB.contact.csv; forces are pressure and
/// shear times the area; the deck closes and opens nothing else than node 102.
#[test]
fn contact_tables_hold_what_the_contact_history_holds() {
    let asked = "*CONTACT PRINT\nCSTRESS, CDISP, CFORCE\n*CONTACT PRINT, NSET=NOSE\nCSTR\n";
    let folder = files("dat-contact", asked, "");
    let tables = tables(&folder);
    assert_eq!(tables.len(), 40);
    let written = csv(&folder, ".contact.csv");
    let mut compared = [0, 0];
    for table in &tables {
        let nose = table.title.ends_with("CONTACT NOSE");
        let labels: &[&str] = if nose { &["102"] } else { &["101", "102", "103"] };
        assert!(nose || table.title.ends_with("CONTACT all slave nodes"), "{}", table.title);
        assert_eq!(table.labels("NODE"), labels);
        let [step, increment] = table.when();
        for label in labels {
            let shown = table.row("NODE", label);
            let same = |row: &&BTreeMap<String, String>| {
                row["step"] == step && row["increment"] == increment && row["node"] == *label
            };
            let Some(row) = written.iter().find(same) else {
                assert_eq!((shown["STATUS"], shown["CPRESS"]), ("open", "0.0000000e0"));
                continue;
            };
            compared[usize::from(nose)] += 1;
            assert_eq!((shown["PAIR"], shown["STATUS"]), ("TIP", row["status"].as_str()));
            for name in ["CPRESS", "CSHEAR1"] {
                near(shown[name], &row[name], &format!("{} {label} {name}", table.title));
            }
            if nose {
                continue;
            }
            near(shown["COPEN"], &row["COPEN"], "COPEN");
            near(shown["CSLIP1"], &row["CSLIP1"], "CSLIP1");
            let area: f64 = row["area"].parse().unwrap();
            for (force, traction) in [("CNORMF", "CPRESS"), ("CSHEARF", "CSHEAR1")] {
                let value = area * row[traction].parse::<f64>().unwrap();
                near(shown[force], &value.to_string(), force);
            }
        }
    }
    assert_eq!(compared, [18, 18], "node 102 touches from the third increment on");
    let slips: Vec<f64> = tables
        .iter()
        .filter(|table| table.title.ends_with("NOSE"))
        .map(|table| table.row("NODE", "102")["CSHEAR1"].parse().unwrap())
        .collect();
    assert!(slips[9] < 0.0 && slips[19] > 0.0, "friction turns with the motion: {slips:?}");
}

/// Requirement: `*EL PRINT` shows the beams of its set, for stresses a row a
/// section point, with the values of JOB.element.csv.
#[test]
fn element_tables_hold_what_the_element_results_hold() {
    let asked = "*EL PRINT, ELSET=ROOT\nSF, SM, SE, SK\n*EL PRINT, FREQUENCY=10\n5, 2\nS, MISES\n\
                 *EL FILE\nS\n";
    let folder = files("dat-elements", asked, "");
    let tables = tables(&folder);
    assert_eq!(tables.len(), 20 + 2);
    let written = csv(&folder, ".element.csv");
    for table in &tables {
        let [step, increment] = table.when();
        let of = |label: &str| {
            let same = |row: &&BTreeMap<String, String>| {
                row["step"] == step && row["increment"] == increment && row["element"] == label
            };
            written.iter().find(same).unwrap()
        };
        if table.title.ends_with("ELEMENTS ROOT") {
            assert_eq!(table.labels("ELEMENT"), ["1", "2"]);
            for label in ["1", "2"] {
                let shown = table.row("ELEMENT", label);
                for name in ["SF1", "SF2", "SM1", "SE1", "SE2", "SK1"] {
                    near(shown[name], &of(label)[name], name);
                }
            }
            continue;
        }
        assert!(table.title.ends_with("ELEMENTS all beams"), "{}", table.title);
        assert_eq!(table.labels("ELEMENT"), ["1", "1", "2", "2", "3", "3", "4", "4"]);
        assert_eq!(table.labels("POINT"), ["5", "2"].repeat(4));
        for row in &table.rows {
            let expected = of(&row[0]);
            near(&row[2], &expected[&format!("S11_{}", row[1])], "S11");
            near(&row[3], &expected["MISES"], "MISES");
        }
    }
}

/// Requirement: stresses are those of the beam's own section, also where beams
/// that belong to a rigid body, and have no results, come before it with
/// another one. Source: S11 = N/A - y M/I. Tolerance: rounding.
#[test]
fn stresses_are_those_of_the_beams_own_section() {
    let folder = folder_of("sections");
    let drawn = "*ELEMENT, TYPE=B21, ELSET=DRAWN\n301, 101, 102\n302, 102, 103\n\
                 *BEAM SECTION, SECTION=RECT, ELSET=DRAWN, MATERIAL=STEEL\n0.5, 0.25\n\
                 *ELEMENT, TYPE=B21, ELSET=BEAM\n1, 1, 2\n";
    let text = deck("*EL FILE\nS\n", "");
    let nodes = &text[text.find("*NODE\n100").unwrap()..text.find("*NSET, NSET=NOSE").unwrap()];
    let text = text.replace(nodes, "").replace("*ELEMENT, TYPE=B21, ELSET=BEAM\n1, 1, 2\n", drawn);
    let text = text.replacen("*ELEMENT", &format!("{nodes}*ELEMENT"), 1);
    assert_eq!(solve(&folder, &text), 20);
    let [area, second_moment] = [1.0e-5, 10.0e-3 * 1.0e-9 / 12.0];
    let rows = csv(&folder, ".element.csv");
    assert_eq!(rows.len(), 4 * 20);
    for row in rows {
        let value = |name: &str| row[name].parse::<f64>().unwrap();
        let expected = value("SF1") / area - 0.5e-3 * value("SM1") / second_moment;
        assert!((value("S11_5") - expected).abs() <= 1e-12 * value("MISES"), "{row:?}");
    }
}

/// Requirement: TOTALS=YES sums each column, SUMMARY=YES shows its extremes
/// and where they are. Source: Abaqus manual, `*NODE PRINT`. The sums are over
/// all nodes, of forces in equilibrium: zero, to the digits printed and the
/// residual of 1e-6 of the average force.
#[test]
fn totals_and_extremes_stand_below_a_table() {
    let asked = "*NODE PRINT, FREQUENCY=10, TOTALS=YES, SUMMARY=YES\nRF, U\n\
                 *EL PRINT, FREQUENCY=10, TOTALS, SUMMARY=NO\nSF\n\
                 *CONTACT PRINT, FREQUENCY=10, SUMMARY=YES\nCFORCE\n";
    let folder = files("dat-totals", asked, "");
    let all = tables(&folder);
    assert_eq!(all.len(), 6);
    for table in &all {
        let key = table.rows.iter().position(|row| ["TOTAL", "MAXIMUM"].contains(&row[0].as_str()));
        let (members, below) = table.rows.split_at(key.unwrap());
        let skip = if table.title.contains("CONTACT") { 3 } else { 1 };
        let numbers =
            |row: &[String]| -> Vec<f64> { row.iter().map(|word| word.parse().unwrap()).collect() };
        let columns: Vec<Vec<f64>> = members.iter().map(|row| numbers(&row[skip..])).collect();
        for row in below {
            let values = numbers(&row[1..]);
            for (column, value) in values.iter().enumerate() {
                let of = columns.iter().map(|row| row[column]);
                let large = of.clone().fold(0.0, |m: f64, v| m.max(v.abs()));
                match row[0].as_str() {
                    "TOTAL" => {
                        let sum: f64 = of.sum();
                        assert!((value - sum).abs() <= 1e-6 * large, "{}: {row:?}", table.title);
                    }
                    "MAXIMUM" => assert_eq!(*value, of.fold(f64::NEG_INFINITY, f64::max)),
                    "MINIMUM" => assert_eq!(*value, of.fold(f64::INFINITY, f64::min)),
                    _ => {}
                }
            }
        }
        let words: Vec<&str> = below.iter().map(|row| row[0].as_str()).collect();
        let expected: &[&str] = match &table.title {
            title if title.contains("NODES") => &["TOTAL", "MAXIMUM", "AT", "MINIMUM", "AT"],
            title if title.contains("ELEMENTS") => &["TOTAL"],
            _ => &["MAXIMUM", "AT", "MINIMUM", "AT"],
        };
        assert_eq!(words, expected, "{}", table.title);
        if table.title.contains("CONTACT") {
            assert_eq!(below[1][1], "102", "pressed where it touches: {:?}", below[1]);
        }
        if table.title.contains("NODES") {
            let (sum, most) = (numbers(&below[0][1..]), numbers(&below[1][1..]));
            assert!(sum[1].abs() <= 2e-6 * most[1].abs(), "vertical forces balance: {sum:?}");
        }
    }
}

/// Rows of a CSV file by step, increment and the column that names them.
fn by_name(text: &str, name: &str) -> BTreeMap<[String; 3], BTreeMap<String, String>> {
    let mut lines = text.lines();
    let heading: Vec<&str> = lines.next().unwrap().split(',').collect();
    let rows = lines.map(|line| {
        let cells = heading.iter().zip(line.split(','));
        let row: BTreeMap<String, String> =
            cells.map(|(name, cell)| ((*name).to_owned(), cell.to_owned())).collect();
        (["step", "increment", name].map(|key| row[key].clone()), row)
    });
    rows.collect()
}

/// Requirement: every number of every printed table is that of the CSV files
/// in the digits of the table, and every table has all its rows.
#[test]
fn printed_tables_and_csv_files_say_the_same() {
    let requests = "*NODE PRINT, NSET=BEAM\nU, RF\n*EL PRINT, ELSET=BEAM\nSF, SM, SE, SK, S, MISES\n\
                    *EL FILE, ELSET=BEAM\nSF\n*CONTACT PRINT\nCSTRESS, CDISP, CFORCE\n";
    let folder = folder_of("same");
    let read = Job::read_text("cam", &deck(requests, requests), &ReadOptions::default());
    let options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
    assert_eq!(run(&read, &options, &mut Quiet).status, Status::Completed);
    let file = |ending: &str| std::fs::read_to_string(folder.join(format!("cam{ending}"))).unwrap();
    let nodes = by_name(&file(".history.csv"), "node");
    let elements = by_name(&file(".element.csv"), "element");
    let contact = by_name(&file(".contact.csv"), "node");
    let dat = file(".dat");
    let mut compared = [0; 3];
    for table in dat.split("\n\n").filter(|table| table.contains("  TOTAL TIME ")) {
        let mut lines = table.trim().lines();
        let title: Vec<&str> = lines.next().unwrap().split_whitespace().collect();
        let heading: Vec<&str> = lines.next().unwrap().split_whitespace().collect();
        for line in lines {
            let row: BTreeMap<&str, &str> =
                heading.iter().copied().zip(line.split_whitespace()).collect();
            assert_eq!(row.len(), heading.len(), "{line}");
            let key = |name: &str| [title[1], title[3], row[name]].map(str::to_owned);
            let (kind, own, names) = match heading[0] {
                "NODE" => (0, nodes.get(&key("NODE")), 1),
                "ELEMENT" => (1, elements.get(&key("ELEMENT")), 2),
                _ => (2, contact.get(&key("NODE")), 3),
            };
            for &column in &heading[names..] {
                let of = |name: &str| own.map(|own| own[name].parse::<f64>().unwrap());
                let expected = match column {
                    "S11" => of(&format!("S11_{}", row["POINT"])),
                    "CNORMF" => of("CPRESS").map(|pressure| pressure * of("area").unwrap()),
                    "CSHEARF" => of("CSHEAR1").map(|shear| shear * of("area").unwrap()),
                    name => of(name),
                };
                // a point that never closed is in no CSV file
                let never = kind == 2 && own.is_none() && row["STATUS"] == "open";
                let expected = expected.map(|value| format!("{value:.7e}"));
                match never {
                    false => assert_eq!(Some(row[column]), expected.as_deref(), "{column}: {line}"),
                    true if column.starts_with("COPEN") || column.starts_with("CSLIP") => {}
                    true => assert!(row[column].parse::<f64>().unwrap() == 0.0, "{column}: {line}"),
                }
                compared[kind] += 1;
            }
            if let (2, Some(own)) = (kind, own) {
                assert_eq!(row["STATUS"], own["status"], "{line}");
            }
        }
    }
    // 20 increments of 5 nodes, 4 beams (at two points of the section), 3 slaves
    let beams = compared[1] / (20 * 4 * 8);
    assert_eq!(compared, [20 * 5 * 6, 20 * 4 * 8 * beams, 20 * 3 * 6], "{dat}");
    assert!(beams >= 1);
}

/// Requirement: names of results behind a comma at the end of the card are these, and the comma is told; in the dialect of
/// CalculiX PE is how much has yielded, as that program writes it.
#[test]
fn names_follow_a_comma_at_the_end() {
    let deck = "*NODE, NSET=ALL\n1, 0.\n2, 1.\n3, 1., 1.\n4, 0., 1.\n*ELEMENT, TYPE=CPS4, ELSET=E\n1, 1, 2, 3, 4\n\
                *SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n200., 0.3\n*PLASTIC\n1., 0.\n2., 1.\n\
                *BOUNDARY\n1, 1, 2\n4, 1\n2, 2\n*STEP\n*STATIC\n*BOUNDARY\n2, 1, 1, 0.1\n3, 1, 1, 0.1\n*NODE FILE,\nU\n\
                *EL FILE, \nS, PE\n*EL PRINT, ELSET=E,\nTOTALS=NO\nS\n*END STEP\n";
    let options = ReadOptions {
        dialect: Some(slideline::model::Dialect::Calculix),
        ..ReadOptions::default()
    };
    let read = Job::read_text("comma", deck, &options);
    let folder = folder_of("comma");
    let options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
    let outcome = run(&read, &options, &mut Quiet);
    assert_eq!(outcome.status, Status::Completed, "{:?}", outcome.diagnostics);
    let commas = read.diagnostics.iter().filter(|own| own.code.0 == "SL0108");
    assert_eq!(commas.count(), 2, "{:?}", read.diagnostics);
    let frd = std::fs::read_to_string(folder.join("comma.frd")).unwrap();
    for block in [" -4  DISP", " -4  STRESS", " -4  PE "] {
        assert!(frd.contains(block), "{block}");
    }
}
