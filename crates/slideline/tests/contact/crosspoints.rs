//! Slave nodes of contact that is spread over faces where something else acts too: another pair, a tie, a
//! support. A uniform pressure must pass them as it passes all others.
//!
//! ```text
//!    +-------+-------+       the upper block is one: its nodes over the joint are slaves of both pairs
//!    +---+---x---+---+
//!    | lower | other |       or the lower blocks are tied at the joint, and their top is the slave
//!    +-------+-------+
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use std::fmt::Write as _;

const MODULUS: f64 = 1e6;
const SQUEEZE: f64 = 0.01;

/// What acts on slave nodes besides.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Also {
    /// Another pair, each with the faces of its own.
    Pair,
    /// Another pair, and both name all faces.
    PairOfAll,
    /// A tie.
    Tie,
    /// Supports in all directions.
    Support,
}

const ALL: [Also; 4] = [Also::Pair, Also::PairOfAll, Also::Tie, Also::Support];

/// A deck with its nodes written: cards that close it, by the names FOOT (and its parts FOOT1, FOOT2), TOP1,
/// TOP2, SIDE1, SIDE2 of surfaces and HELD of slave nodes of the interface; `last` is the direction of the squeeze.
fn closed(also: Also, last: usize, friction: &str) -> String {
    let held = format!("*BOUNDARY\nHELD, {last}, {last}, {:?}\n", -0.5 * SQUEEZE);
    let (pairs, tie, support) = match also {
        Also::Pair => ("FOOT1, TOP1\nFOOT2, TOP2", "", ""),
        Also::PairOfAll => ("FOOT, TOP1\nFOOT, TOP2", "", ""),
        Also::Tie => ("TOP, FOOT", "*TIE, NAME=T\nSIDE2, SIDE1\n", ""),
        Also::Support => ("FOOT1, TOP1\nFOOT2, TOP2", "", held.as_str()),
    };
    let along: String = (1..last).map(|dof| format!("HELD, {dof}, {dof}\n")).collect();
    let support = if support.is_empty() { String::new() } else { support.to_string() + &along };
    format!(
        "{tie}*MATERIAL, NAME=M\n*ELASTIC\n{MODULUS:?}, 0.0
*SURFACE INTERACTION, NAME=I\n{friction}*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE
{pairs}\n*BOUNDARY\nBASE1, 1, {last}\nBASE2, 1, {last}\n*STEP\n*STATIC\n1.0, 1.0\n*BOUNDARY
HEAD, 1, {}\nHEAD, {last}, {last}, {:?}\n{support}*CONTROLS, PARAMETERS=FIELD\n1e-11\n*END STEP\n",
        last - 1,
        -SQUEEZE
    )
}

/// Requires uniform compression of nodes by height and how far they moved, and a uniform pressure.
fn uniform(what: &str, nodes: impl Iterator<Item = (f64, f64)>, pressures: &[f64], worst: f64) {
    for (height, off) in nodes {
        assert!(off < 1e-10 * SQUEEZE, "{what} {height} {off:e}");
    }
    let exact = MODULUS * SQUEEZE;
    assert!(!pressures.is_empty());
    for pressure in pressures {
        assert!((pressure - exact).abs() < 1e-8 * exact, "{what} {pressure} {exact}");
    }
    assert!(worst < 1e-9, "{what} {worst:e}");
}

/// Requirement: in the plane a uniform pressure passes slave nodes that two pairs share, that a tie moves, that
/// supports hold, exactly, with and without friction. Tolerance: 1e-10.
#[test]
fn a_uniform_pressure_passes_shared_slave_nodes_in_the_plane() {
    use crate::mortar_decks::{Block, Kind, solved};
    for (also, kind) in ALL.into_iter().flat_map(|a| [Kind::Cpe4, Kind::Cpe8].map(|k| (a, k))) {
        for friction in ["", "*FRICTION\n0.3\n"] {
            let mut deck = String::from("*HEADING\ncrosspoints\n");
            let upper = Block { base: 10_000, cells: [4, 2], kind };
            let lower =
                [Block { base: 0, cells: [3, 2], kind }, Block { base: 1000, cells: [2, 3], kind }];
            upper.write(&mut deck, "U", |[x, y]| [x, 0.5 + 0.5 * y]);
            let mut tops = String::new();
            for (k, own) in lower.iter().enumerate() {
                let name = format!("L{}", k + 1);
                own.write(&mut deck, &name, |[x, y]| [0.5 * (x + k as f64), 0.5 * y]);
                let top = own.surface(&format!("TOP{}", k + 1), "top");
                tops += top.split_once('\n').unwrap().1;
                deck += &top;
                deck += &own.surface(&format!("SIDE{}", k + 1), ["right", "left"][k]);
                deck += &own.set(&format!("BASE{}", k + 1), |_, y| y == 0.0);
            }
            let foot = upper.surface("FOOT", "bottom");
            let lines: Vec<&str> = foot.lines().skip(1).collect();
            let _ = write!(
                deck,
                "{foot}*SURFACE, NAME=FOOT1\n{}\n*SURFACE, NAME=FOOT2\n{}\n*SURFACE, NAME=TOP\n{tops}",
                lines[..2].join("\n"),
                lines[2..].join("\n")
            );
            deck += &upper.set("HEAD", |_, y| y == 1.0);
            deck += &upper.set("HELD", |x, y| y == 0.0 && (0.25..0.6).contains(&x));
            for name in ["U", "L1", "L2"] {
                let _ = writeln!(deck, "*SOLID SECTION, ELSET={name}, MATERIAL=M\n1.0");
            }
            let last = solved(&(deck + &closed(also, 2, friction)));
            let off = last.nodes.iter().map(|&(_, [_, y], [u, v])| (y, u.hypot(v + SQUEEZE * y)));
            let pressures: Vec<f64> = pressures(&last.contact);
            uniform(&format!("{also:?} {kind:?} {friction}"), off, &pressures, last.worst);
        }
    }
}

/// Requirement: the same in space, with linear and quadratic faces, of slave nodes that pairs share and that a
/// tie moves. Those that supports hold in all directions are left out: there displacements are exact, and
/// pressures, which supports make up for, were right to 8e-5.
#[test]
fn a_uniform_pressure_passes_shared_slave_nodes_in_space() {
    use crate::space_decks::{Block, Kind, size, solved};
    for (also, kind) in
        ALL[..3].iter().copied().flat_map(|a| [Kind::C3d8, Kind::C3d10].map(|k| (a, k)))
    {
        for friction in ["", "*FRICTION\n0.3\n"] {
            let mut deck = String::from("*HEADING\ncrosspoints\n");
            let upper = Block { name: "U", base: 10_000, cells: [4, 3, 1], kind };
            let lower = [
                Block { name: "L1", base: 0, cells: [3, 2, 1], kind },
                Block { name: "L2", base: 2000, cells: [2, 3, 1], kind },
            ];
            upper.write(&mut deck, |[x, y, z]| [x, y, 0.5 + 0.5 * z]);
            let mut tops = String::new();
            for (k, own) in lower.iter().enumerate() {
                own.write(&mut deck, |[x, y, z]| [0.5 * (x + k as f64), y, 0.5 * z]);
                let top = own.surface(&format!("TOP{}", k + 1), |[_, _, z]| z == 1.0);
                tops += top.split_once('\n').unwrap().1;
                deck += &top;
                let joint = [1.0, 0.0][k];
                deck += &own.surface(&format!("SIDE{}", k + 1), |[x, _, _]| x == joint);
                deck += &own.set(&format!("BASE{}", k + 1), |[_, _, z]| z == 0.0);
            }
            deck += &upper.surface("FOOT", |[_, _, z]| z == 0.0);
            deck += &upper.surface("FOOT1", |[x, _, z]| z == 0.0 && x <= 0.5);
            deck += &upper.surface("FOOT2", |[x, _, z]| z == 0.0 && x >= 0.5);
            let _ = write!(deck, "*SURFACE, NAME=TOP\n{tops}");
            deck += &upper.set("HEAD", |[_, _, z]| z == 1.0);
            deck += &upper.set("HELD", |[x, _, z]| z == 0.0 && (0.25..0.6).contains(&x));
            for name in ["U", "L1", "L2"] {
                let _ = writeln!(deck, "*SOLID SECTION, ELSET={name}, MATERIAL=M");
            }
            let last = solved(&(deck + &closed(also, 3, friction)));
            let off = last
                .nodes
                .iter()
                .map(|&(_, at, [u, v, w])| (at[2], size([u, v, w + SQUEEZE * at[2]])));
            let pressures: Vec<f64> = pressures(&last.contact);
            uniform(&format!("{also:?} {kind:?} {friction}"), off, &pressures, last.worst);
        }
    }
}

/// Pressures of the points that touch: of a pair that names all faces half cover nothing.
fn pressures(rows: &[slideline::observe::ContactRow]) -> Vec<f64> {
    rows.iter().filter(|row| row.pressure != 0.0).map(|row| row.pressure).collect()
}
