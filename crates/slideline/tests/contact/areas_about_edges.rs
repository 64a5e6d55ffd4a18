//! Areas of nodes about edges, and normals, against the forces that belong to them.
//!
//! ```text
//!       o-----o        its whole outside is the slave: sides carry nothing
//!       |     |
//!       o-----o
//!   o------------o
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::space_decks::EDGES;
use slideline::{Job, Quiet, ReadOptions, RunOptions, Status, run};
use std::fmt::Write;
use std::path::Path;

/// Corners of a square and of a cube, in the order of an element.
const CORNERS: [[f64; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [1.0, 1.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [1.0, 0.0, 1.0],
    [1.0, 1.0, 1.0],
    [0.0, 1.0, 1.0],
];

/// A block of one element of some type, its nodes from `first` on, from a corner on and so large; with the numbers of its lower and
/// upper nodes.
fn block(
    deck: &mut String,
    (kind, name, first): (&str, &str, usize),
    at: impl Fn([f64; 3]) -> [f64; 3],
) {
    let in_space = kind.starts_with("C3D");
    let (corners, edges) = if in_space { (8, 12) } else { (4, 4) };
    let up = if in_space { 2 } else { 1 };
    let mut places: Vec<[f64; 3]> = CORNERS[..corners].to_vec();
    if ["CPE8", "CAX8", "C3D20"].contains(&kind) {
        let middle = |edge: &[usize; 2]| {
            let [a, b] = edge.map(|end| CORNERS[end]);
            std::array::from_fn(|axis| 0.5 * (a[axis] + b[axis]))
        };
        places.extend(EDGES[..edges].iter().map(middle));
    }
    *deck += "*NODE\n";
    for (k, &place) in places.iter().enumerate() {
        let [x, y, z] = at(place);
        writeln!(deck, "{}, {x:?}, {y:?}, {z:?}", first + k).unwrap();
    }
    let numbers: Vec<String> = (0..places.len()).map(|k| (first + k).to_string()).collect();
    let (own, more) = numbers.split_at(numbers.len().min(10));
    let more = if more.is_empty() { String::new() } else { format!(",\n{}", more.join(", ")) };
    writeln!(deck, "*ELEMENT, TYPE={kind}, ELSET={name}\n{first}, {}{more}", own.join(", "))
        .unwrap();
    for (set, level) in [("LOW", 0.0), ("HIGH", 1.0)] {
        let own = (0..places.len()).filter(|&k| places[k][up] == level);
        let own: Vec<String> = own.map(|k| (first + k).to_string()).collect();
        writeln!(deck, "*NSET, NSET={name}{set}\n{}", own.join(", ")).unwrap();
    }
}

/// A block of sides 2 on a wider one is pressed down by 0.1, one element each; in the plane between x = 2 and 4, radii of rings. The face
/// below rises by `rise` over its length. `pair` is the type of contact and the slave.
fn deck(kind: &str, (kind_of_contact, slave): (&str, &str), rise: f64) -> String {
    let in_space = kind.starts_with("C3D");
    let (last, below, top) = match kind {
        _ if in_space => (3, "C3D8", "S2"),
        "CAX4" | "CAX8" => (2, "CAX4", "S3"),
        _ => (2, "CPE4", "S3"),
    };
    let wide = |own: [f64; 3]| {
        let mut at = [1.0 + 4.0 * own[0], 4.0 * own[1] - 1.0, 4.0 * own[2] - 1.0];
        at[last - 1] = (own[last - 1] - 1.0) + own[last - 1] * rise * (own[0] - 0.5);
        at
    };
    let mut deck = String::new();
    block(&mut deck, (below, "LOWER", 1), wide);
    block(&mut deck, (kind, "UPPER", 101), |own| [2.0 + 2.0 * own[0], 2.0 * own[1], 2.0 * own[2]]);
    deck + &format!(
        "*SURFACE, NAME=MASTER\nLOWER, {top}\n*SURFACE, NAME=SLAVE\n{slave}\n*MATERIAL, NAME=M\n*ELASTIC\n\
         1.0E6, 0.0\n*SOLID SECTION, ELSET=LOWER, MATERIAL=M\n*SOLID SECTION, ELSET=UPPER, MATERIAL=M\n\
         *SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n100.0\n\
         *CONTACT PAIR, INTERACTION=I, TYPE={kind_of_contact}\nSLAVE, MASTER\n*BOUNDARY\nLOWERLOW, 1, {last}\n\
         UPPERHIGH, 1, {}\n*STEP, NLGEOM\n*STATIC\n0.5, 1.0\n*BOUNDARY\nUPPERHIGH, {last}, {last}, -0.1\n\
         *END STEP\n",
        last - 1
    )
}

/// A table by rows of its last increment.
struct Table(Vec<Vec<(String, String)>>);

impl Table {
    fn read(file: &Path) -> Self {
        let text = std::fs::read_to_string(file).unwrap();
        let mut lines = text.lines();
        let head: Vec<&str> = lines.next().unwrap().split(',').collect();
        let named = |line: &str| {
            let cells = head.iter().zip(line.split(','));
            cells.map(|(name, cell)| ((*name).to_owned(), cell.to_owned())).collect()
        };
        let rows: Vec<Vec<(String, String)>> = lines.map(named).collect();
        let of = |row: &Vec<(String, String)>| Self::cell(row, "increment").to_owned();
        let last = rows.last().map(of).unwrap();
        Self(rows.into_iter().filter(|row| of(row) == last).collect())
    }

    fn cell<'a>(row: &'a [(String, String)], name: &str) -> &'a str {
        &row.iter().find(|(own, _)| own == name).unwrap_or_else(|| panic!("no {name}")).1
    }

    fn sum(&self, of: impl Fn(&dyn Fn(&str) -> f64) -> f64) -> f64 {
        let number =
            |row: &[(String, String)], name: &str| Self::cell(row, name).parse().unwrap_or(0.0);
        self.0.iter().map(|row| of(&|name: &str| number(row, name))).sum()
    }
}

/// The tables of pairs, of contact points and of energies.
fn tables(name: &str, deck: &str) -> [Table; 3] {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("areas-about-edges").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    let read = Job::read_text("job", deck, &ReadOptions::default());
    let options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
    let outcome = run(&read, &options, &mut Quiet);
    assert_eq!(outcome.status, Status::Completed, "{name}: {:?}", read.diagnostics);
    ["pair", "contact", "energy"].map(|kind| Table::read(&folder.join(format!("job.{kind}.csv"))))
}

/// Requirement: a block pressed on a plane by a law K h has the force K h A of its face, whether its surface is that
/// face or its whole outside, in the plane, of rings, in space, with middle nodes and without; and the areas of its closed points sum up to the
/// face. Source: docs/theory.md eq. (5.59). Tolerance: the strain of the blocks, 1e-3 of h.
#[test]
fn sides_of_a_block_carry_nothing() {
    let ring = 12.0 * std::f64::consts::PI;
    let meshes = [
        ("CPE4", 2.0),
        ("CPE8", 2.0),
        ("CAX4", ring),
        ("CAX8", ring),
        ("C3D8", 4.0),
        ("C3D20", 4.0),
    ];
    for (kind, area) in meshes {
        for (name, slave) in [("face", "UPPER, S1"), ("outside", "UPPER,")] {
            let name = format!("{kind}-{name}");
            let [pair, ..] = tables(&name, &deck(kind, ("NODE TO SURFACE", slave), 0.0));
            let force = pair.sum(|cell| cell(if area == 4.0 { "force_z" } else { "force_y" }));
            let exact = 100.0 * 0.1 * area;
            assert!((force - exact).abs() < 2e-3 * exact, "{name}: {force} for {exact}");
            let found = pair.sum(|cell| cell("area"));
            assert!((found - area).abs() < 1e-9 * area, "{name}: {found} for {area}");
        }
    }
}

/// Requirement: pressure times area along the normal of the contact table sums up to the force of pressure of its pair, at
/// nodes and over faces, in the plane and in space, on a master that is not parallel to the slave, held softly and hard. Source:
/// docs/files.md. Tolerance: rounding of the table.
#[test]
fn normals_of_the_table_carry_the_force_of_the_pair() {
    let law = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n100.0\n";
    for (kind, axes) in [("CPE4", &["x", "y"][..]), ("C3D8", &["x", "y", "z"])] {
        for contact in ["NODE TO SURFACE", "SURFACE TO SURFACE"] {
            for held in [law, ""] {
                let deck = deck(kind, (contact, "UPPER, S1"), 0.08).replace(law, held);
                let name = format!("{kind}-{}-{}", contact.replace(' ', "-"), held.len());
                let [pair, points, _] = tables(&name, &deck);
                let along = |axis: &str| pair.sum(|cell| cell(&format!("normal_{axis}")));
                let size = axes.iter().fold(0.0, |size: f64, axis| size.hypot(along(axis)));
                assert!(along("x").abs() > 1e-3 * size, "{name}: nothing leans");
                for axis in axes {
                    let column = format!("normal_{axis}");
                    let sum = points.sum(|cell| cell("CPRESS") * cell("area") * cell(&column));
                    let whole = along(axis);
                    assert!((whole - sum).abs() < 1e-9 * size, "{name} {axis}: {sum} for {whole}");
                }
            }
        }
    }
}

/// A block that stands softly on its corner is tipped over it from 10 degrees to 40 in so many increments.
fn tipped(increments: usize) -> String {
    let at = |degrees: f64, [along, up, _]: [f64; 3]| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        [along * cosine - up * sine, along * sine + up * cosine - 0.01, 0.0]
    };
    let mut deck = String::new();
    block(&mut deck, ("CPE4", "LOWER", 1), |own| [4.0 * own[0] - 1.7, own[1] - 1.0, 0.0]);
    block(&mut deck, ("CPE4", "UPPER", 101), |own| at(10.0, own));
    deck += "*SURFACE, NAME=MASTER\nLOWER, S3\n*SURFACE, NAME=SLAVE\nUPPER,\n*MATERIAL, NAME=M\n*ELASTIC\n1000.0, 0.3\n\
             *SOLID SECTION, ELSET=LOWER, MATERIAL=M\n*SOLID SECTION, ELSET=UPPER, MATERIAL=M\n\
             *SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n500.0\n\
             *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nSLAVE, MASTER\n*BOUNDARY\nLOWERLOW, 1, 2\n";
    writeln!(deck, "*STEP, NLGEOM\n*STATIC, DIRECT\n{:?}, 1.0\n*BOUNDARY", 1.0 / increments as f64)
        .unwrap();
    for (k, &corner) in CORNERS[..4].iter().enumerate().skip(1) {
        let [from, to] = [10.0, 40.0].map(|degrees| at(degrees, corner));
        for axis in 0..2 {
            let by = to[axis] - from[axis];
            writeln!(deck, "{}, {1}, {1}, {by:?}", 101 + k, axis + 1).unwrap();
        }
    }
    deck + "*END STEP\n"
}

/// Requirement: a block that tips over has the area of the face that looks at the master, then of both, and energies balance, the
/// closer the shorter the increments. Source: docs/theory.md 5.21, section 10. Tolerance: second order.
#[test]
fn a_block_that_tips_over_keeps_its_account() {
    let left = [16, 32].map(|increments| {
        let [pair, _, energy] = tables(&format!("tipped-{increments}"), &tipped(increments));
        let area = pair.sum(|cell| cell("area"));
        assert!((area - 1.0).abs() < 1e-12, "both sides of one: {area}");
        energy.sum(|cell| cell("balance")).abs()
    });
    // the law held up to 0.4 on the way
    assert!(left[0] < 1e-2 && left[1] < 0.4 * left[0], "{left:?}");
}
