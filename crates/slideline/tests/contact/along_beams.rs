//! Contact integrated along beams that does not separate, whose overclosures are allowed, whose slaves begin on
//! their master.
//!
//! ```text
//!     ----------------    plate, or circle, K per area: F = K w times the integral of the overclosure
//!     o--o--o--o--o--o    beam along x, held but for its axial motion
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::{Ending, Event, Observer, Stop};
use slideline::{Job, ReadOptions, SolveOptions, TangentCheck, solve};
use std::fmt::Write as _;
use std::ops::ControlFlow;

const STIFFNESS: f64 = 100.0;
const WIDTH: f64 = 2.0;
const LENGTH: f64 = 10.0;
const RADIUS: f64 = 40.0;

/// What lies on the beam: its outward normal points down.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Tool {
    Plate,
    /// A circle of radius 40 that touches at the middle.
    Circle,
}

/// The tool begins at the gap `gap`; a step of four increments for each place to which it goes.
struct Case<'a> {
    tool: Tool,
    beam: &'a str,
    gap: f64,
    law: &'a str,
    pair: &'a str,
    of_first_step: &'a str,
    ways: &'a [f64],
}

impl Case<'_> {
    fn deck(&self) -> String {
        let per = if self.beam == "B22" { 2 } else { 1 };
        let mut deck = String::from("*HEADING\nalong a beam\n*NODE, NSET=LINE\n");
        let last = 10 * per;
        for k in 0..=last {
            let _ = writeln!(deck, "{}, {:?}, 0.0", k + 1, LENGTH * k as f64 / last as f64);
        }
        let _ = writeln!(deck, "*ELEMENT, TYPE={}, ELSET=BEAM", self.beam);
        for k in 0..10 {
            let first = per * k + 1;
            let nodes: Vec<String> = (first..=first + per).map(|node| node.to_string()).collect();
            let _ = writeln!(deck, "{}, {}", k + 1, nodes.join(", "));
        }
        let g = self.gap;
        let profile = match self.tool {
            Tool::Plate => format!("START, 12.0, {g:?}\nLINE, -2.0, {g:?}\n"),
            Tool::Circle => {
                let centre = RADIUS + g;
                format!(
                    "START, {:?}, {centre:?}\nCIRCL, 5.0, {g:?}, 5.0, {centre:?}\n\
                     CIRCL, {:?}, {centre:?}, 5.0, {centre:?}\n",
                    5.0 + RADIUS,
                    5.0 - RADIUS
                )
            }
        };
        let _ = write!(
            deck,
            "*BEAM SECTION, SECTION=RECT, ELSET=BEAM, MATERIAL=M\n{WIDTH:?}, 0.5\n*MATERIAL, NAME=M\n\
             *ELASTIC\n1.0E4, 0.3\n*NODE\n99, 5.0, 2.0\n*SURFACE, NAME=TOOL, TYPE=SEGMENTS\n{profile}\
             *RIGID BODY, REF NODE=99, ANALYTICAL SURFACE=TOOL\n*SURFACE, NAME=FACE\nBEAM, SPOS\n\
             *SURFACE INTERACTION, NAME=I\n{WIDTH:?}\n*SURFACE BEHAVIOR, {}\n{STIFFNESS:?}\n\
             *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE, NO THICKNESS{}\nFACE, TOOL\n\
             *BOUNDARY\n1, 1\nLINE, 2\nLINE, 6\n99, 1\n99, 6\n",
            self.law, self.pair
        );
        for (k, way) in self.ways.iter().enumerate() {
            let own = if k == 0 { self.of_first_step } else { "" };
            let _ = write!(
                deck,
                "*STEP, NLGEOM\n*STATIC, DIRECT\n0.25, 1.0\n*BOUNDARY\n99, 2, 2, {way:?}\n{own}*END STEP\n"
            );
        }
        deck
    }

    fn run(&self, options: &SolveOptions) -> Watch {
        let read = Job::read_text("along", &self.deck(), &ReadOptions::default());
        let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
        let mut watch = Watch::default();
        let ending = solve(&model, options, &mut watch);
        assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
        watch
    }

    /// The forces with which the tool is pressed down at the ends of all increments.
    fn forces(&self) -> Vec<f64> {
        self.run(&SolveOptions::default()).forces
    }
}

const LINEAR: &str = "PRESSURE-OVERCLOSURE=LINEAR";
const BONDED: &str = "PRESSURE-OVERCLOSURE=LINEAR, NO SEPARATION";

const PLAIN: Case<'_> = Case {
    tool: Tool::Plate,
    beam: "B21",
    gap: 0.0,
    law: LINEAR,
    pair: "",
    of_first_step: "",
    ways: &[-0.01],
};

#[derive(Default)]
struct Watch {
    forces: Vec<f64>,
    /// What energies leave over, in the largest work.
    balance: f64,
    openings: Vec<f64>,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let tool = frame.model.nodes.find(99).unwrap();
            self.forces.push(-frame.nodal.reaction(tool, Dof::U2));
            let energy = frame.energy;
            let left = energy.external_work - energy.strain_energy - energy.contact_energy;
            self.balance = self.balance.max(left.abs() / energy.external_work.abs().max(1e-12));
            self.openings = frame.contact.iter().map(|row| row.opening).collect();
        }
        ControlFlow::Continue(())
    }
}

/// The integral of the overclosure of the circle over |x| < reach, its lowest point at the height `y`.
fn integral(y: f64, reach: f64) -> f64 {
    let count = 20_000;
    let each = 2.0 * reach / count as f64;
    let at = |k: usize| {
        let x = -reach + (k as f64 + 0.5) * each;
        RADIUS - x.hypot(RADIUS + y)
    };
    (0..count).map(|k| each * at(k)).sum()
}

/// Half the length on which the circle overlaps the line at the height `y`.
fn reach(y: f64) -> f64 {
    (RADIUS * RADIUS - (RADIUS + y).powi(2)).max(0.0).sqrt()
}

/// Requirement: under a plate what has closed pulls as it presses; what never closed pulls nothing.
/// Tolerance: rounding.
#[test]
fn a_plate_that_does_not_separate_pulls() {
    for beam in ["B21", "B22", "B23"] {
        let ways = &[-0.01, 0.02][..];
        let forces = Case { beam, law: BONDED, ways, ..PLAIN }.forces();
        let whole = STIFFNESS * WIDTH * LENGTH;
        for (force, way) in
            forces.iter().zip([-0.0025, -0.005, -0.0075, -0.01, -0.0025, 0.005, 0.0125, 0.02])
        {
            assert!((force + whole * way).abs() < 1e-9 * whole, "{beam}: {force} at {way}");
        }
        let plain = Case { beam, ways, ..PLAIN }.forces();
        assert_eq!(plain.last(), Some(&0.0), "{beam}");
        let apart = Case { beam, law: BONDED, gap: 0.05, ways: &[-0.01, 0.02], ..PLAIN }.forces();
        assert!(apart.iter().all(|force| *force == 0.0), "{beam}: {apart:?}");
    }
}

/// Requirement: under a circle the stretch that has closed stays closed, and no more: pressed by 0.02 and
/// pulled by 0.01, F = K w times the integral of the overclosure over that stretch. Source: quadrature.
/// Tolerance: the ends of the closed stretch within a cell, 1e-3.
#[test]
fn what_has_closed_stays_closed_and_no_more() {
    let forces = Case { tool: Tool::Circle, law: BONDED, ways: &[-0.02, 0.01], ..PLAIN }.forces();
    let closed = reach(-0.02);
    for (force, way) in forces.iter().zip([-0.005, -0.01, -0.015, -0.02]) {
        let pressing = STIFFNESS * WIDTH * integral(way, reach(way));
        assert!((force / pressing - 1.0).abs() < 1e-3, "{force} for {pressing} at {way}");
    }
    let last = STIFFNESS * WIDTH * integral(0.01, closed);
    assert!((forces[7] / last - 1.0).abs() < 1e-3, "{} for {last}", forces[7]);
    let pressed = STIFFNESS * WIDTH * integral(-0.02, closed);
    assert!((forces[3] / pressed - 1.0).abs() < 1e-3, "{} for {pressed}", forces[3]);
}

/// Requirement: an overclosure that the step takes away presses with its part: straight with time under a
/// plate and under a circle, whether it is what overlaps or, of the plate, a value; the work that it does is in
/// the balance of energies. Tolerance: rounding; of the circle the quadrature.
#[test]
fn overclosures_are_taken_away_over_the_step() {
    let whole = STIFFNESS * WIDTH * LENGTH * 0.01;
    for of_first_step in
        ["*CONTACT INTERFERENCE, SHRINK\nFACE, TOOL\n", "*CONTACT INTERFERENCE\nFACE, TOOL, 0.01\n"]
    {
        let case = Case { gap: -0.01, of_first_step, ways: &[0.0], ..PLAIN };
        let watch = case.run(&SolveOptions::default());
        for (force, part) in watch.forces.iter().zip([0.25, 0.5, 0.75, 1.0]) {
            assert!(
                (force - part * whole).abs() < 1e-9 * whole,
                "{of_first_step}: {force} at {part}"
            );
        }
        assert!(watch.balance < 1e-9, "{of_first_step}: {}", watch.balance);
    }
    let of_first_step = "*CONTACT INTERFERENCE, SHRINK\nFACE, TOOL\n";
    let case = Case { tool: Tool::Circle, gap: -0.02, of_first_step, ways: &[0.0], ..PLAIN };
    let watch = case.run(&SolveOptions::default());
    let whole = STIFFNESS * WIDTH * integral(-0.02, reach(-0.02));
    for (force, part) in watch.forces.iter().zip([0.25, 0.5, 0.75, 1.0]) {
        assert!(
            (force / (part * whole) - 1.0).abs() < 1e-3,
            "circle: {force} at {part} of {whole}"
        );
    }
    assert!(watch.balance < 2e-2, "circle: {}", watch.balance);
}

/// Requirement: ADJUST moves the nodes of the beam, those in the middle too, onto the master, without
/// strain; beyond its distance it leaves them.
#[test]
fn slaves_begin_on_their_master() {
    for beam in ["B21", "B22", "B23"] {
        let pair = ", ADJUST=0.02";
        let case = Case { beam, gap: 0.01, pair, ways: &[-0.001], ..PLAIN };
        let forces = case.forces();
        let whole = STIFFNESS * WIDTH * LENGTH * 0.001;
        assert!((forces[3] - whole).abs() < 1e-9 * whole, "{beam}: {} for {whole}", forces[3]);
        let far = Case { beam, gap: 0.03, pair, ways: &[-0.001], ..PLAIN }.forces();
        assert_eq!(far[3], 0.0, "{beam}");
    }
}

/// Requirement: tangents are the derivatives of the forces. Source: differences in every iteration.
#[test]
fn tangents_are_those_of_the_forces() {
    let options = SolveOptions { check_tangent: TangentCheck::Every, ..SolveOptions::default() };
    Case { tool: Tool::Circle, law: BONDED, ways: &[-0.02, 0.01], ..PLAIN }.run(&options);
    let of_first_step = "*CONTACT INTERFERENCE, SHRINK\nFACE, TOOL\n";
    Case { tool: Tool::Circle, gap: -0.02, of_first_step, ways: &[0.0], ..PLAIN }.run(&options);
}
