//! Sums over contact pairs, against forces and moments by hand.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::{Dialect, Job, Quiet, ReadOptions, RunOptions, Status, run};
use std::path::Path;

/// Two unit cubes on one another, E = 1000, nu = 0, pressed by 0.01 and slid along x by 4e-4.
const CUBES: &str = "*NODE, NSET=ALL
1, 0.0, 0.0, 0.0
2, 1.0, 0.0, 0.0
3, 1.0, 1.0, 0.0
4, 0.0, 1.0, 0.0
5, 0.0, 0.0, 1.0
6, 1.0, 0.0, 1.0
7, 1.0, 1.0, 1.0
8, 0.0, 1.0, 1.0
11, 0.0, 0.0, 1.0
12, 1.0, 0.0, 1.0
13, 1.0, 1.0, 1.0
14, 0.0, 1.0, 1.0
15, 0.0, 0.0, 2.0
16, 1.0, 0.0, 2.0
17, 1.0, 1.0, 2.0
18, 0.0, 1.0, 2.0
*NSET, NSET=HIGH
15, 16, 17, 18
*NSET, NSET=LOW
1, 2, 3, 4
*ELEMENT, TYPE=C3D8, ELSET=CUBES
1, 1, 2, 3, 4, 5, 6, 7, 8
2, 11, 12, 13, 14, 15, 16, 17, 18
*SOLID SECTION, ELSET=CUBES, MATERIAL=M
*SURFACE, NAME=SLAVE
2, S1
*SURFACE, NAME=MASTER
1, S2
";

/// The same as squares, y up.
const SQUARES: &str = "*NODE, NSET=ALL
1, 0.0, 0.0
2, 1.0, 0.0
3, 1.0, 1.0
4, 0.0, 1.0
11, 0.0, 1.0
12, 1.0, 1.0
13, 1.0, 2.0
14, 0.0, 2.0
*NSET, NSET=HIGH
13, 14
*NSET, NSET=LOW
1, 2
*ELEMENT, TYPE=CPS4, ELSET=SQUARES
1, 1, 2, 3, 4
2, 11, 12, 13, 14
*SOLID SECTION, ELSET=SQUARES, MATERIAL=M
1.0
*SURFACE, NAME=SLAVE
2, S1
*SURFACE, NAME=MASTER
1, S3
";

fn deck(mesh: &str, up: usize, friction: &str, requests: &str) -> String {
    let across = if up == 3 { "HIGH, 2, 2\n" } else { "" };
    format!(
        "{mesh}*MATERIAL, NAME=M
*ELASTIC
1000.0, 0.0
*SURFACE INTERACTION, NAME=I
*FRICTION{friction}
*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE
SLAVE, MASTER
*STEP
*STATIC
1.0, 1.0
*BOUNDARY
LOW, 1, {up}
HIGH, 1, 1, 4.0E-4
{across}HIGH, {up}, {up}, -0.01
{requests}*END STEP
"
    )
}

/// Runs a deck; what a file of its last increment has.
fn files(name: &str, deck: &str, dialect: Dialect) -> (String, Vec<(String, f64)>) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("contact-totals").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    let read = Job::read_text(
        "job",
        deck,
        &ReadOptions { dialect: Some(dialect), ..ReadOptions::default() },
    );
    let options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
    let outcome = run(&read, &options, &mut Quiet);
    assert_eq!(outcome.status, Status::Completed, "{name}: {:?}", read.diagnostics);
    let table = std::fs::read_to_string(folder.join("job.pair.csv")).unwrap();
    let head = table.lines().next().unwrap().split(',').map(str::to_owned);
    let last = table.lines().last().unwrap().split(',').map(|cell| cell.parse().unwrap_or(0.0));
    (std::fs::read_to_string(folder.join("job.dat")).unwrap(), head.zip(last).collect())
}

fn column(row: &[(String, f64)], name: &str) -> f64 {
    row.iter().find(|(own, _)| own == name).unwrap_or_else(|| panic!("no column {name}")).1
}

/// Numbers of the line behind the one that begins so.
fn below(text: &str, head: &str) -> Vec<(String, f64)> {
    let mut lines = text.lines().skip_while(|line| !line.starts_with(head));
    let names: Vec<String> = lines.next().unwrap().split_whitespace().map(str::to_owned).collect();
    let values = lines.next().unwrap().split_whitespace().map(|cell| cell.parse().unwrap_or(0.0));
    names.into_iter().zip(values).collect()
}

/// Requirement: of two columns pressed by d, N = E A d / (2 L) whatever friction bends, and all
/// points sliding, friction mu N against the way; their moments about the origin are those of their
/// lever arms. (derived) Tolerance: friction bends the columns, so that the normal turns by some 1e-3
/// and lets its force go by half the square of that; what the arms lose to the press, 5e-3 of them,
/// is counted.
#[test]
fn sums_of_pairs_are_those_of_the_columns() {
    let request = "*CONTACT PRINT\nCFN, CFS, CFT, CMN, CMS, CAREA, CNUM\n";
    let friction = ", ELASTIC SLIP=1.0E-7\n0.003";
    let close = |value: f64, wanted: f64| {
        assert!((value - wanted).abs() < 5e-5, "{value} for {wanted}");
    };
    let (text, row) = files("space", &deck(CUBES, 3, friction, request), Dialect::Abaqus);
    close(column(&row, "normal_z"), 5.0);
    close(column(&row, "friction_x"), -0.015);
    let sum = column(&row, "normal_x") + column(&row, "friction_x");
    close(column(&row, "force_x"), sum);
    close(column(&row, "area"), 1.0);
    let printed = below(&text, "PAIR ");
    let shown = |name: &str, wanted: f64| {
        let value = column(&printed, name);
        assert!((value - wanted).abs() < 5e-5, "{name}: {value} for {wanted}");
    };
    for (name, wanted) in [("CFNM", 5.0), ("CFN3", 5.0), ("CFSM", 0.015), ("CFS1", -0.015)] {
        shown(name, wanted);
    }
    // pressure at y = 1/2 in the mean; friction at z = 1 - 0.005 and y = 1/2
    for (name, wanted) in
        [("CMN1", 2.5), ("CMS2", -0.015 * 0.995), ("CMS3", 0.0075), ("CAREA", 1.0)]
    {
        shown(name, wanted);
    }
    shown("CNUM", 4.0);
    let (text, row) = files("plane", &deck(SQUARES, 2, friction, request), Dialect::Abaqus);
    close(column(&row, "normal_y"), 5.0);
    close(column(&row, "friction_x"), -0.015);
    let printed = below(&text, "PAIR ");
    assert!((column(&printed, "CMS3") - 0.015 * 0.995).abs() < 5e-5);
    assert!(printed.iter().all(|(name, _)| name != "CFN3"), "{printed:?}");
}

/// Requirement: in the dialect of CalculiX the blocks are those of ccx 2.20, to the blank; N and
/// friction are those above, the slave's outside looks down. Only the pair that is named is printed.
#[test]
fn calculix_prints_its_statistics() {
    let request = "*CONTACT PRINT, SLAVE=SLAVE, MASTER=MASTER\nCF\n\
                   *CONTACT PRINT, TOTALS=ONLY\nCELS, CNUM\n";
    let (text, _) = files("ccx", &deck(CUBES, 3, "\n0.003, 1.0E8", request), Dialect::Calculix);
    let at = text.find(" statistics for").unwrap_or_else(|| panic!("{text}"));
    let mut lines = text[at..].lines();
    let mut expect = |wanted: &str| assert_eq!(lines.next().unwrap(), wanted, "{text}");
    expect(" statistics for slave set SLAVE, master set MASTER and time  0.1000000E+01");
    expect("");
    expect("   total surface force (fx,fy,fz) and moment about the origin (mx,my,mz)");
    expect("");
    let numbers = lines.next().unwrap();
    assert_eq!(numbers.len(), 2 + 6 * 14, "{numbers}");
    let values: Vec<f64> = numbers.split_whitespace().map(|n| n.parse().unwrap()).collect();
    assert!((values[2] - 5.0).abs() < 1e-5 && (values[3] - 2.5).abs() < 1e-5, "{numbers}");
    let rest: Vec<&str> = lines.collect();
    assert_eq!(rest[1], "   center of gravity and mean normal");
    assert!(rest[3].starts_with("    5.00"), "{rest:?}");
    assert_eq!(rest[5], "   moment about the center of gravity(mx,my,mz)");
    assert_eq!(rest[9], "   area,  normal force (+ = tension) and shear force (size)");
    let last: Vec<f64> = rest[11].split_whitespace().map(|n| n.parse().unwrap()).collect();
    let wanted = [1.0, -5.0, 0.015];
    assert!(last.iter().zip(wanted).all(|(own, to)| (own - to).abs() < 2e-5), "{}", rest[11]);
    assert_eq!(rest[11].len(), 2 + 3 * 14);
    assert!(text.contains("\n total contact spring energy for time  0.1000000E+01\n\n        "));
    let count =
        "\n total number of contact elements for time  0.1000000E+01\n\n                4\n";
    assert!(text.contains(count), "{text}");
    let other = request.replace("SLAVE=SLAVE", "SLAVE=OTHER");
    let (text, _) = files("other", &deck(CUBES, 3, "\n0.003, 1.0E8", &other), Dialect::Calculix);
    assert!(!text.contains("statistics for"), "{text}");
}
