//! Rounds that are pressed into one another, with straight faces of different lengths, contact spread over faces.
//!
//! Source: docs/theory.md section 5.22; Lame's thick rings.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::noise::{codes, folder, run_in};
use slideline::{Job, ReadOptions, Status};
use std::fmt::Write;

/// Radii of the pin, of the joint and of the hub, what they overlap [L], and the height of the rings.
const RINGS: [f64; 5] = [6.0, 10.0, 14.0, 0.05, 1.0];
const LAYERS: usize = 3;

/// A quarter of a pin in that of a hub, of so many faces each.
struct Fit {
    /// Faces of the pin and of the hub.
    faces: [usize; 2],
    /// Whether the hub is the slave.
    hub_is_slave: bool,
    in_space: bool,
    formulation: &'static str,
    /// Length of the unit of length.
    unit: f64,
}

const SPREAD: Fit = Fit {
    faces: [9, 9],
    hub_is_slave: false,
    in_space: false,
    formulation: "SURFACE TO SURFACE",
    unit: 1.0,
};

impl Fit {
    /// One ring: its cards, its nodes from `first` on; sets X0 and Y0 get its ends, OUT or IN its faces.
    fn ring(&self, first: usize, count: usize, [from, to]: [f64; 2], name: &str) -> String {
        let (mut text, mut ends) =
            (format!("*NODE, NSET={name}\n"), [String::new(), String::new()]);
        let planes = if self.in_space { 2 } else { 1 };
        let node =
            |ring: usize, k: usize, z: usize| first + ring + (LAYERS + 1) * (k + (count + 1) * z);
        for z in 0..planes {
            for k in 0..=count {
                let (sin, cos) = (std::f64::consts::FRAC_PI_2 * k as f64 / count as f64).sin_cos();
                for ring in 0..=LAYERS {
                    let r = self.unit * (from + (to - from) * ring as f64 / LAYERS as f64);
                    let (own, high) = (node(ring, k, z), self.unit * RINGS[4] * z as f64);
                    writeln!(text, "{own}, {:.15e}, {:.15e}, {high}", r * cos, r * sin).unwrap();
                    if k == 0 || k == count {
                        writeln!(ends[usize::from(k == 0)], "{own},").unwrap();
                    }
                }
            }
        }
        let kind = if self.in_space { "C3D8I" } else { "CPE4I" };
        writeln!(text, "*ELEMENT, TYPE={kind}, ELSET={name}").unwrap();
        for k in 0..count {
            for ring in 0..LAYERS {
                let level = |z| {
                    [
                        node(ring, k, z),
                        node(ring + 1, k, z),
                        node(ring + 1, k + 1, z),
                        node(ring, k + 1, z),
                    ]
                };
                let all: Vec<usize> = (0..planes).flat_map(level).collect();
                let list: Vec<String> = all.iter().map(usize::to_string).collect();
                writeln!(text, "{}, {}", first + k * LAYERS + ring, list.join(", ")).unwrap();
            }
        }
        let [x0, y0] = ends;
        format!("{text}*NSET, NSET=X0\n{x0}*NSET, NSET=Y0\n{y0}")
    }

    fn deck(&self) -> String {
        let [inner, joint, outer, over, _] = RINGS;
        let pin = self.ring(1, self.faces[0], [inner, joint + 0.5 * over], "PIN");
        let hub = self.ring(1001, self.faces[1], [joint - 0.5 * over, outer], "HUB");
        // faces of the last ring outwards, and of the first one inwards
        let [out, within] = if self.in_space { ["S4", "S6"] } else { ["S2", "S4"] };
        let of = |first: usize, count: usize, ring: usize, face: &str| -> String {
            (0..count).map(|k| format!("{}, {face}\n", first + k * LAYERS + ring)).collect()
        };
        let surfaces = format!(
            "*SURFACE, NAME=SP\n{}*SURFACE, NAME=SH\n{}",
            of(1, self.faces[0], LAYERS - 1, out),
            of(1001, self.faces[1], 0, within)
        );
        let roles = if self.hub_is_slave { "SH, SP" } else { "SP, SH" };
        let held = if self.in_space { "PIN, 3, 3\nHUB, 3, 3\n" } else { "" };
        let stress = self.unit.powi(-2);
        format!(
            "*HEADING\na pin in a hub\n{pin}{hub}{surfaces}*SOLID SECTION, ELSET=PIN, MATERIAL=M\n\
             *SOLID SECTION, ELSET=HUB, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n{}, 0.3\n*SURFACE INTERACTION, NAME=I\n\
             *CONTACT PAIR, INTERACTION=I, TYPE={}\n{roles}\n*BOUNDARY\nX0, 1, 1\nY0, 2, 2\n{held}*STEP\n*STATIC\n\
             *CONTACT PRINT\nCSTRESS\n*END STEP\n",
            2e5 * stress,
            self.formulation
        )
    }

    /// The force of the contact over that of round rings (Lame), and what is told of it in per cent.
    fn run(&self, name: &str) -> (f64, Option<f64>) {
        let place = folder(name);
        let outcome = run_in(&place, &Job::read_text("fit", &self.deck(), &ReadOptions::default()));
        assert_eq!(outcome.status, Status::Completed, "{name}: {:?}", codes(&outcome));
        let table = std::fs::read_to_string(place.join("fit.contact.csv")).unwrap();
        let mut lines = table.lines();
        let heads: Vec<&str> = lines.next().unwrap().split(',').collect();
        let column = |name: &str| heads.iter().position(|own| *own == name).unwrap();
        let (pressure, area) = (column("CPRESS"), column("area"));
        let force: f64 = lines
            .map(|line| {
                let cells: Vec<&str> = line.split(',').collect();
                cells[pressure].parse::<f64>().unwrap() * cells[area].parse::<f64>().unwrap()
            })
            .sum();
        let [a, r, b, over, _] = RINGS;
        let ring = |a: f64, b: f64| (b * b + a * a) / (b * b - a * a);
        let p = 2e5 / (1.0 - 0.3 * 0.3) * over / r / (ring(a, r) + ring(r, b));
        let said = outcome.diagnostics.iter().find(|own| own.code.0 == "SL0626");
        let told = said.map(|own| {
            let (before, rest) = own.message.split_once(" % too ").unwrap();
            let part: f64 = before.rsplit(' ').next().unwrap().parse().unwrap();
            if rest.starts_with("large") { part } else { -part }
        });
        // a part of the plane is as thick as the unit of length, however long that is
        let unit = if self.in_space { 1.0 } else { self.unit };
        (unit * force / (p * r * std::f64::consts::FRAC_PI_2), told)
    }
}

/// Requirement: where both rounds have faces of one length, contact over faces has the force of the rings, and nothing is
/// told; else how far it is off is told to two hundredths of the force and a tenth of itself, whichever side is the slave,
/// in the plane and in space, in any units.
#[test]
fn what_straight_faces_make_of_a_fit_is_told() {
    for in_space in [false, true] {
        for hub_is_slave in [false, true] {
            for (faces, unit) in
                [([9, 9], 1.0), ([8, 12], 1.0), ([12, 8], 1.0), ([12, 9], 1e-3), ([16, 15], 1.0)]
            {
                let name =
                    format!("straight_{}_{in_space}_{hub_is_slave}", faces[0] * 100 + faces[1]);
                let (force, told) =
                    Fit { faces, in_space, hub_is_slave, unit, ..SPREAD }.run(&name);
                let error = 100.0 * (force - 1.0);
                match told {
                    None => assert!(error.abs() < 6.0, "{name}: {error}"),
                    Some(told) => {
                        assert!(
                            (error - told).abs() < 2.0 + 0.1 * told.abs(),
                            "{name}: {error} {told}"
                        );
                    }
                }
                assert!(faces[0] != faces[1] || told.is_none(), "{name}: {told:?}");
            }
        }
    }
}

/// Requirement: contact at nodes, whose master is drawn round, is not told of.
#[test]
fn nodes_on_a_round_master_are_right() {
    for (faces, hub_is_slave) in [([8, 12], false), ([12, 8], true)] {
        let fit = Fit { faces, hub_is_slave, formulation: "NODE TO SURFACE", ..SPREAD };
        let (force, told) = fit.run(&format!("round_nodes_{}", faces[0]));
        assert_eq!(told, None);
        assert!((force - 1.0).abs() < 0.01, "{faces:?} {force}");
    }
}

/// A part between two heights over a width, of so many elements across, its nodes from `first` on: `low` and `high` give
/// its lower and its upper side.
fn strip(
    (name, first, across): (&str, usize, usize),
    low: impl Fn(f64) -> f64,
    high: impl Fn(f64) -> f64,
) -> String {
    let mut text = format!("*NODE, NSET={name}\n");
    for row in 0..=LAYERS {
        for k in 0..=across {
            let (x, part) = (9.0 * k as f64 / across as f64 - 4.5, row as f64 / LAYERS as f64);
            let y = low(x) * (1.0 - part) + high(x) * part;
            writeln!(text, "{}, {x:?}, {y:?}", first + k + (across + 1) * row).unwrap();
        }
    }
    writeln!(text, "*ELEMENT, TYPE=CPE4I, ELSET={name}").unwrap();
    for row in 0..LAYERS {
        for k in 0..across {
            let n = first + k + (across + 1) * row;
            let (own, above) = (first + k + across * row, n + across + 1);
            writeln!(text, "{own}, {n}, {}, {}, {above}", n + 1, above + 1).unwrap();
        }
    }
    let (foot, top) = (first, first + (across + 1) * LAYERS);
    let row =
        |from: usize| -> String { (from..=from + across).map(|own| format!("{own},\n")).collect() };
    let faces = |from: usize, side: &str| -> String {
        (from..from + across).map(|own| format!("{own}, {side}\n")).collect()
    };
    format!(
        "{text}*SOLID SECTION, ELSET={name}, MATERIAL=M\n*NSET, NSET={name}FOOT\n{}*NSET, NSET={name}TOP\n{}\
         *SURFACE, NAME={name}LOW\n{}*SURFACE, NAME={name}HIGH\n{}",
        row(foot),
        row(top),
        faces(first, "S1"),
        faces(first + across * (LAYERS - 1), "S3")
    )
}

/// Requirement: a wedge in its groove has edges, which stand where they are drawn: nothing is told of it, although its
/// faces are a fourth as long as those of the groove; whatever its angle, up to where two faces begin to be a round.
#[test]
fn edges_are_no_rounds() {
    for degrees in [23.0_f64, 30.0, 44.0, 60.0] {
        let slope = degrees.to_radians().tan();
        let edge = |x: f64| slope * x.abs();
        let wedge = strip(("WEDGE", 1, 8), edge, |_| 4.5 * slope + 4.0);
        let groove = strip(("GROOVE", 1001, 2), |_| -3.0, edge);
        let deck = format!(
            "{wedge}{groove}*MATERIAL, NAME=M\n*ELASTIC\n1e4, 0.3\n*SURFACE INTERACTION, NAME=I\n\
             *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nWEDGELOW, GROOVEHIGH\n*BOUNDARY\nGROOVEFOOT, 1, 2\n\
             WEDGETOP, 1, 1\n*STEP\n*STATIC\n*BOUNDARY\nWEDGETOP, 2, 2, -0.01\n*END STEP\n"
        );
        let name = format!("edges_are_no_rounds_{degrees}");
        let read = Job::read_text("wedge", &deck, &ReadOptions::default());
        let outcome = run_in(&folder(&name), &read);
        assert_eq!(outcome.status, Status::Completed, "{name}: {:?}", codes(&outcome));
        assert!(!codes(&outcome).contains(&"SL0626"), "{name}: {:?}", outcome.diagnostics);
    }
}
