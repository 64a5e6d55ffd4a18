//! Slave nodes that come into the part of their master where its surface ends.
//!
//! ```text
//!     +-------+ ->           the end of the leaf goes through the side of the step; its lower side alone is the master
//!     | leaf  |   +------
//!     +-------+   | step
//!                 +------
//! ```
//!
//! Source: docs/theory.md section 5.8.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::noise::{folder, run_in};
use slideline::{Job, ReadOptions, Status};
use std::fmt::Write;

/// A leaf that is pushed over a step.
struct Push {
    in_space: bool,
    /// How high the step reaches above the lower side of the leaf; the leaf is one thick.
    high: f64,
    /// Length of a cell.
    long: f64,
    /// Length of the unit of length, and the turn of the model about z.
    unit: f64,
    turn: f64,
    formulation: &'static str,
    /// Whether end and side are of the surfaces too.
    is_whole: bool,
}

const PUSH: Push = Push {
    in_space: false,
    high: 0.2,
    long: 1.0,
    unit: 1.0,
    turn: 0.0,
    formulation: "NODE TO SURFACE",
    is_whole: false,
};

impl Push {
    /// Nodes and elements of a row of three cells from a place on, its nodes from `first` on.
    fn row(&self, text: &mut String, name: &str, first: usize, [x, y]: [f64; 2]) {
        let (sin, cos) = self.turn.to_radians().sin_cos();
        let planes = if self.in_space { 2 } else { 1 };
        writeln!(text, "*NODE, NSET={name}").unwrap();
        for z in 0..planes {
            for (row, k) in (0..2).flat_map(|row| (0..4).map(move |k| (row, k))) {
                let at = [x + self.long * k as f64, y + row as f64].map(|own| self.unit * own);
                let turned = [cos * at[0] - sin * at[1], sin * at[0] + cos * at[1]];
                let node = first + k + 4 * row + 8 * z;
                let deep = self.unit * z as f64;
                writeln!(text, "{node}, {:.15e}, {:.15e}, {deep:e}", turned[0], turned[1]).unwrap();
            }
        }
        let kind = if self.in_space { "C3D8" } else { "CPE4" };
        writeln!(text, "*ELEMENT, TYPE={kind}, ELSET=ALL").unwrap();
        for k in first..first + 3 {
            let level = |z: usize| [k, k + 1, k + 5, k + 4].map(|node| (node + 8 * z).to_string());
            let all: Vec<String> = (0..planes).flat_map(level).collect();
            writeln!(text, "{k}, {}", all.join(", ")).unwrap();
        }
    }

    fn deck(&self) -> String {
        let mut text = String::from("*HEADING\na leaf is pushed over a step\n");
        self.row(&mut text, "LEAF", 101, [0.0, 0.0]);
        self.row(&mut text, "STEP", 201, [3.2 * self.long, self.high - 1.0]);
        // lower, upper, left and right sides of a cell
        let [low, high, left, right] =
            if self.in_space { ["S3", "S5", "S6", "S4"] } else { ["S1", "S3", "S4", "S2"] };
        let side = |first: usize, side: &str| -> String {
            (first..first + 3).map(|own| format!("{own}, {side}\n")).collect()
        };
        let [end, front] = match self.is_whole {
            true => [format!("103, {right}\n"), format!("201, {left}\n")],
            false => [String::new(), String::new()],
        };
        let (sin, cos) = self.turn.to_radians().sin_cos();
        let way = [1.5 * self.long, 0.0].map(|own| self.unit * own);
        let moved = [cos * way[0], sin * way[0]];
        let of = |first: usize| {
            let nodes = if self.in_space { vec![0, 4, 8, 12] } else { vec![0, 4] };
            nodes.iter().map(|k| format!("{},\n", first + k)).collect::<String>()
        };
        let dofs = if self.in_space { 3 } else { 2 };
        write!(
            text,
            "*NSET, NSET=TAIL\n{}*SURFACE, NAME=UNDER\n{}{end}*SURFACE, NAME=TREAD\n{}{front}\
             *SOLID SECTION, ELSET=ALL, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n{:e}, 0.3\n\
             *SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, TYPE={}\nTREAD, UNDER\n*BOUNDARY\n\
             STEP, 1, {dofs}\n*STEP, NLGEOM\n*STATIC\n0.1, 1.\n*BOUNDARY\nTAIL, 1, 1, {:e}\nTAIL, 2, 2, {:e}\n{}*END STEP\n",
            of(101),
            side(101, low),
            side(201, high),
            1e3 / self.unit.powi(2),
            self.formulation,
            moved[0],
            moved[1],
            if self.in_space { "TAIL, 3, 3\n" } else { "" }
        )
        .unwrap();
        text
    }

    /// How the run ends, and what is said of nodes in the part.
    fn run(&self, name: &str) -> (Status, Vec<String>) {
        let outcome =
            run_in(&folder(name), &Job::read_text("push", &self.deck(), &ReadOptions::default()));
        let said = outcome.diagnostics.iter().filter(|own| own.code.0 == "SL0627");
        let said = said.map(|own| own.message.clone()).collect();
        (outcome.status, said)
    }
}

/// Requirement: a part that goes through another one by its end, which no surface names, is told once, in the plane and in
/// space, turned and in any units, with how deep it stands. What reaches in by less than a tenth of the height of an element is not, nor what passes behind the part.
#[test]
fn what_goes_in_by_its_end_is_told() {
    for in_space in [false, true] {
        for (high, long, unit, turn) in [
            (0.2, 1.0, 1.0, 0.0),
            (0.45, 1.0, 1e-3, 33.0),
            (0.12, 1.0, 39.0, -45.0),
            (0.15, 10.0, 1.0, 0.0),
            (0.15, 10.0, 1.0, 71.0),
        ] {
            let name = format!("strayed_{in_space}_{long}_{turn}");
            let (status, said) = Push { in_space, high, long, unit, turn, ..PUSH }.run(&name);
            assert_eq!((status, said.len()), (Status::Completed, 1), "{name}: {said:?}");
            let deep = format!("{:.3e} behind", high * unit);
            assert!(said[0].contains(&deep), "{name}: {said:?} {deep}");
        }
    }
    for high in [0.08, -0.1, 2.3] {
        let (status, said) = Push { high, ..PUSH }.run("strayed_little");
        assert_eq!((status, said.len()), (Status::Completed, 0), "{high}");
    }
}

/// Requirement: where end and side belong to the surfaces the leaf is held, and nothing is told, at nodes and over faces.
#[test]
fn what_is_held_is_not() {
    for formulation in ["NODE TO SURFACE", "SURFACE TO SURFACE"] {
        let (status, said) =
            Push { formulation, high: 0.5, is_whole: true, ..PUSH }.run("strayed_whole");
        assert_eq!((status, said.len()), (Status::Completed, 0), "{formulation}: {said:?}");
    }
}
