//! Elements and contact pairs that leave the model and come back, `*MODEL CHANGE`.
//!
//! Source: docs/theory.md section 9.1. Closed forms of bars; elements that begin against the same
//! elements in a deck of their own, on nodes that stand where they begin.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::{Dialect, Dof, Kinematics, Model, TYPES};
use slideline::observe::{Ending, Energies};
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, resume, solve};
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// A committed increment: vectors have six entries a node.
#[derive(Clone, Debug, PartialEq)]
struct Row {
    step: usize,
    time: f64,
    motion: Vec<f64>,
    reaction: Vec<f64>,
    energy: Energies,
    results: Vec<usize>,
}

#[derive(Default)]
struct Rows {
    rows: Vec<Row>,
    said: Vec<&'static str>,
}

impl Observer for Rows {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Committed(frame) => {
                let each = |of: &dyn Fn(usize, Dof) -> f64| -> Vec<f64> {
                    let nodes = 0..frame.model.nodes.len();
                    nodes.flat_map(|node| Dof::ALL.map(|dof| of(node, dof))).collect()
                };
                self.rows.push(Row {
                    step: frame.step,
                    time: frame.step_time,
                    motion: each(&|node, dof| frame.nodal.displacement(node, dof)),
                    reaction: each(&|node, dof| frame.nodal.reaction(node, dof)),
                    energy: frame.energy,
                    results: frame.elements.iter().map(|block| block.members.len()).collect(),
                });
            }
            Event::Diagnosed(said) => self.said.push(said.code.0),
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

fn model(deck: &str, dialect: Dialect) -> Model {
    let options = ReadOptions { dialect: Some(dialect), ..ReadOptions::default() };
    let read = Job::read_text("change", deck, &options);
    let mut model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    for step in &mut model.steps {
        step.controls.field.r_n = 1e-12;
    }
    model
}

fn walked(model: &Model) -> Rows {
    let mut rows = Rows::default();
    match solve(model, &SolveOptions::default(), &mut rows) {
        Ending::Completed(_) => rows,
        other => panic!("{other:?}"),
    }
}

fn run(deck: &str) -> Vec<Row> {
    let rows = walked(&model(deck, Dialect::Abaqus));
    assert!(!rows.said.contains(&"SL0604") && !rows.said.contains(&"SL0603"), "{:?}", rows.said);
    rows.rows
}

/// The last increment of a step.
fn end(rows: &[Row], step: usize) -> &Row {
    rows.iter().rfind(|row| row.step == step).unwrap()
}

fn near(one: f64, other: f64, scale: f64, about: &str) {
    assert!((one - other).abs() <= scale, "{about}: {one:e} and {other:e}");
}

fn all_near(one: &[f64], other: &[f64], part: f64, about: &str) {
    let largest = other.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    for (place, (a, b)) in one.iter().zip(other).enumerate() {
        assert!((a - b).abs() <= part * largest, "{about}, {place}: {a:e} and {b:e}");
    }
}

fn step(nlgeom: bool, count: usize, cards: &str) -> String {
    let nlgeom = if nlgeom { ", NLGEOM" } else { "" };
    format!("*STEP{nlgeom}\n*STATIC, DIRECT\n{:?}, 1.\n{cards}*END STEP\n", 1.0 / count as f64)
}

const LEAVE: &str = "*MODEL CHANGE, TYPE=ELEMENT, REMOVE\n";
const BEGIN: &str = "*MODEL CHANGE, TYPE=ELEMENT, ADD=STRAIN FREE\n";
const RETURN: &str = "*MODEL CHANGE, TYPE=ELEMENT, ADD=WITH STRAIN\n";

/// Two bars of length 1 and stiffness EA = 100 between walls.
const BARS: &str = "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 2., 0.\n*ELEMENT, TYPE=T2D2, ELSET=LEFT\n1, 1, 2\n\
    *ELEMENT, TYPE=T2D2, ELSET=RIGHT\n2, 2, 3\n*ELSET, ELSET=ALL\nLEFT, RIGHT\n\
    *SOLID SECTION, ELSET=ALL, MATERIAL=M\n0.1\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n\
    *BOUNDARY\n1, 1, 2\n3, 1, 2\n2, 2\n";

/// Requirement: the force of a removed bar goes over to the other one, linearly in time; the energy
/// that it held is told, and the account is even. Closed form, 1e-12.
#[test]
fn the_rest_takes_over_what_a_removed_bar_carried() {
    let load = "*CLOAD\n2, 1, 4.\n";
    let deck = BARS.to_owned()
        + &step(false, 1, load)
        + &step(false, 4, &format!("{LEAVE}RIGHT\n"))
        + &step(false, 2, &format!("{RETURN}2\n"))
        + &step(false, 1, "*CLOAD, OP=NEW\n2, 1, 0.\n");
    let rows = run(&deck);
    let (k, load) = (100.0, 4.0);
    let both = load / (2.0 * k);
    near(end(&rows, 1).motion[6], both, 1e-14, "both");
    for row in &rows {
        let u = row.motion[6];
        // what the right bar exerted on the node, and what of it is missing or too much
        let missing = k * both * (1.0 - row.time);
        let (of_bars, right) = match row.step {
            2 => ((load - missing) / k, 0.0),
            3 => {
                // it comes back where the node stands, with the force k load/k
                let u = (load + load * (1.0 - row.time)) / (2.0 * k);
                (u, k * u)
            }
            4 => (0.0, 0.0),
            _ => (both, k * both),
        };
        near(u, of_bars, 1e-13, "motion");
        near(row.reaction[0], -k * u, 1e-11, "the left wall");
        if row.step == 2 {
            near(row.reaction[12], 0.0, 1e-13, "the wall of the removed bar");
            near(row.energy.removed_energy, 0.5 * k * both * both, 1e-13, "what it held");
        } else if row.step != 3 {
            near(row.reaction[12], -right, 1e-11, "the right wall");
        }
        near(row.energy.balance, 0.0, 1e-13, "balance");
    }
    let brought = 0.5 * (load / k).powi(2) * k - 0.5 * k * both * both;
    near(end(&rows, 3).energy.removed_energy, -brought, 1e-13, "what it brought");
    assert_eq!([1, 2, 3].map(|step| end(&rows, step).results.iter().sum::<usize>()), [2, 1, 2]);
}

/// Requirement: at large strain, what is left after a removal is what a model without the bar has,
/// and what comes back with strain gives the solution of before, whatever the increments. 1e-10.
#[test]
fn a_return_with_strain_gives_the_old_solution() {
    let load = "*CLOAD\n2, 1, 12.\n";
    let alone = BARS.replace("ELSET=ALL\nLEFT, RIGHT", "ELSET=ALL\nLEFT");
    let alone = alone.replace("*ELEMENT, TYPE=T2D2, ELSET=RIGHT\n2, 2, 3\n", "");
    let alone = run(&(alone + &step(true, 4, load)));
    for count in [2, 3, 8] {
        let deck = BARS.to_owned()
            + &step(true, 2, load)
            + &step(true, count, &format!("{LEAVE}RIGHT\n"))
            + &step(true, count, &format!("{RETURN}RIGHT\n"));
        let rows = run(&deck);
        all_near(&end(&rows, 2).motion[..12], &end(&alone, 1).motion[..12], 1e-10, "alone");
        all_near(&end(&rows, 3).motion, &end(&rows, 1).motion, 1e-10, "as before");
        all_near(&end(&rows, 3).reaction, &end(&rows, 1).reaction, 1e-10, "as before");
        let (before, after) = (&end(&rows, 1).energy, &end(&rows, 3).energy);
        near(after.strain_energy, before.strain_energy, 1e-9, "energy");
    }
}

/// Requirement: the account of a removal at large strain closes with the square of the increment.
#[test]
fn the_balance_of_a_removal_falls_with_the_square_of_the_increment() {
    let balance = |count| {
        let deck = BARS.to_owned()
            + &step(true, 8, "*CLOAD\n2, 1, 30.\n")
            + &step(true, count, &format!("{LEAVE}RIGHT\n"));
        let rows = run(&deck);
        (end(&rows, 2).energy.balance - end(&rows, 1).energy.balance).abs()
    };
    let [coarse, fine] = [4, 16].map(balance);
    assert!(coarse > 12.0 * fine && coarse > 0.0, "{coarse:e} {fine:e}");
}

/// Requirement: a bar that begins in parallel to a stretched one takes the further load as its
/// stiffness says, k1 u + k2 (u - u0) = P. Closed form, 1e-12.
#[test]
fn a_bar_that_begins_takes_its_share_of_the_further_load() {
    let deck = "*NODE\n1, 0., 0.\n2, 2., 0.\n*ELEMENT, TYPE=T2D2, ELSET=OLD\n1, 1, 2\n\
        *ELEMENT, TYPE=T2D2, ELSET=NEW\n2, 1, 2\n*SOLID SECTION, ELSET=OLD, MATERIAL=M\n0.2\n\
        *SOLID SECTION, ELSET=NEW, MATERIAL=M\n0.6\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n\
        *BOUNDARY\n1, 1, 2\n2, 2\n"
        .to_owned()
        + &step(false, 1, &format!("{LEAVE}NEW\n*CLOAD\n2, 1, 5.\n"))
        + &step(false, 1, &format!("{BEGIN}NEW\n"))
        + &step(false, 3, "*CLOAD\n2, 1, 25.\n");
    let rows = run(&deck);
    let (old, new) = (100.0, 300.0);
    let first = 5.0 / old;
    near(end(&rows, 1).motion[6], first, 1e-14, "the old one alone");
    near(end(&rows, 2).motion[6], first, 1e-14, "nothing moves as it begins");
    near(end(&rows, 3).motion[6], (25.0 + new * first) / (old + new), 1e-13, "both");
    near(end(&rows, 3).energy.balance, 0.0, 1e-12, "balance");
    assert_eq!(end(&rows, 3).energy.removed_energy, 0.0);
}

/// One element of a row of the table: nodes, the cards of its section, and its dofs.
struct Kind {
    name: &'static str,
    nodes: Vec<[f64; 3]>,
    section: String,
    dofs: Vec<usize>,
}

/// All rows: solids, trusses, beams, springs.
fn kinds() -> Vec<Kind> {
    let mut all = Vec::new();
    for row in TYPES {
        let name = row.names[0];
        let count = row.cell.nodes;
        let space = row.is_spatial();
        let line = [[1.0, 0.5, 0.0], [2.0, 1.0, 0.0], [3.0, 1.5, 0.0]];
        let places = row.cell.places;
        let nodes: Vec<[f64; 3]> = match count {
            1 => vec![[1.0, 0.5, 0.0]],
            2 => vec![line[0], line[2]],
            3 if places.is_empty() => line.to_vec(),
            _ => {
                let bend = |[x, y, z]: [f64; 3]| [3.0 + x + 0.1 * y, y + 0.05 * x, z + 0.1 * x];
                places
                    .iter()
                    .map(|&at| bend(at))
                    .map(|[x, y, z]| [x, y, if space { z } else { 0.0 }])
                    .collect()
            }
        };
        let material = "*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.25\n";
        let section = match row.kinematics {
            Kinematics::Solid { .. } | Kinematics::Truss => {
                format!("*SOLID SECTION, ELSET=E, MATERIAL=M\n0.5\n{material}")
            }
            Kinematics::Beam { .. } | Kinematics::SpaceBeam => format!(
                "*BEAM SECTION, SECTION=RECT, ELSET=E, MATERIAL=M\n0.3, 0.2\n{}{material}",
                if space { "0., 0., -1.\n" } else { "" }
            ),
            Kinematics::Spring if name == "SPRINGA" => "*SPRING, ELSET=E\n\n700.\n".to_owned(),
            Kinematics::Spring if count == 1 => "*SPRING, ELSET=E\n2\n700.\n".to_owned(),
            Kinematics::Spring => "*SPRING, ELSET=E\n2, 2\n700.\n".to_owned(),
            // what a gap carries is no linear law of its motion, which these tests go by
            Kinematics::Gap | Kinematics::Other => continue,
        };
        let dofs = match row.kinematics {
            Kinematics::Spring if name == "SPRINGA" => vec![1, 2],
            Kinematics::Spring => vec![2],
            _ => row.dofs.iter().map(|dof| dof.number()).collect(),
        };
        all.push(Kind { name, nodes, section, dofs });
    }
    assert!(all.len() > 30, "the table has all kinds");
    all
}

/// A motion of a node: a stretch and a shear, and turns about one axis.
fn motion(at: [f64; 3], dof: usize, size: f64) -> f64 {
    let [x, y, z] = at;
    size * match dof {
        1 => 0.05 * x - 0.03 * y + 0.01 * z,
        2 => 0.04 * x + 0.02 * y,
        3 => 0.02 * x - 0.01 * y + 0.03 * z,
        turn => (0.02 + 0.03 * x) * [0.3, 0.5, 1.0][turn - 4],
    }
}

impl Kind {
    fn deck(&self, moved: f64) -> String {
        let mut deck = "*NODE\n".to_owned();
        for (node, at) in self.nodes.iter().enumerate() {
            let mut at = *at;
            for dof in self.dofs.iter().filter(|dof| **dof < 4) {
                at[dof - 1] += motion(self.nodes[node], *dof, moved);
            }
            let _ = writeln!(deck, "{}, {:?}, {:?}, {:?}", node + 1, at[0], at[1], at[2]);
        }
        let nodes: Vec<String> = (1..=self.nodes.len()).map(|node| node.to_string()).collect();
        let nodes = nodes.chunks(10).map(|line| line.join(", ")).collect::<Vec<_>>().join(",\n");
        let Self { name, section, .. } = self;
        format!("{deck}*ELEMENT, TYPE={name}, ELSET=E\n1, {nodes}\n{section}")
    }

    /// All dofs lead to the motion of that size, less that of another.
    fn lead(&self, size: f64, less: f64) -> String {
        let mut cards = "*BOUNDARY\n".to_owned();
        for (node, at) in self.nodes.iter().enumerate() {
            for &dof in &self.dofs {
                let value = motion(*at, dof, size) - motion(*at, dof, less);
                let _ = writeln!(cards, "{}, {dof}, {dof}, {value:?}", node + 1);
            }
        }
        cards
    }
}

/// Requirement: an element of every kind that begins free of strain answers as one whose nodes
/// stand there from the beginning (large displacements), or that has moved from there (small ones);
/// it exerts nothing as it begins. Another deck, 1e-9 of the largest reaction: positions are
/// rounded in the deck.
#[test]
fn elements_of_every_kind_begin_where_they_stand() {
    for kind in kinds() {
        for nlgeom in [true, false] {
            let about = format!("{} {nlgeom}", kind.name);
            let deck = kind.deck(0.0)
                + &step(nlgeom, 2, &(format!("{LEAVE}E\n") + &kind.lead(1.0, 0.0)))
                + &step(nlgeom, 1, &format!("{BEGIN}E\n"))
                + &step(nlgeom, 3, &kind.lead(2.5, 0.0));
            let rows = run(&deck);
            let moved = if nlgeom { 1.0 } else { 0.0 };
            let fresh = kind.deck(moved) + &step(nlgeom, 1, &kind.lead(2.5, 1.0));
            let fresh = run(&fresh);
            let force = &end(&fresh, 1).reaction;
            let largest = force.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            assert!(largest > 0.0, "{about}");
            for step in [1, 2] {
                let idle = &end(&rows, step).reaction;
                assert!(idle.iter().all(|own| own.abs() < 1e-11 * largest), "{about}: {idle:?}");
            }
            // moments of large turns in space belong to the vectors that they are counted by
            let is_turn = |place: &usize| place % 6 > 2 && nlgeom && kind.dofs.len() == 6;
            let forces = |row: &Row| -> Vec<f64> {
                (0..row.reaction.len()).filter(|k| !is_turn(k)).map(|k| row.reaction[k]).collect()
            };
            all_near(&forces(end(&rows, 3)), &forces(end(&fresh, 1)), 1e-9, &about);
            let (one, other) = (&end(&rows, 3).energy, &end(&fresh, 1).energy);
            near(one.strain_energy, other.strain_energy, 1e-9 * other.strain_energy, &about);
        }
    }
}

/// Requirement: an element of every kind that was away answers with strain as if it had been there
/// all the time, and nothing while it is away. The same deck without changes, 1e-12.
#[test]
fn elements_of_every_kind_come_back_with_their_strain() {
    for kind in kinds() {
        for nlgeom in [true, false] {
            let about = format!("{} {nlgeom}", kind.name);
            let walk = |changes: [&str; 2]| {
                let [leave, back] = changes;
                let deck = kind.deck(0.0)
                    + &step(nlgeom, 2, &kind.lead(1.0, 0.0))
                    + &step(nlgeom, 2, &(leave.to_owned() + &kind.lead(2.0, 0.0)))
                    + &step(nlgeom, 2, &(back.to_owned() + &kind.lead(2.5, 0.0)));
                run(&deck)
            };
            let there = walk(["", ""]);
            let away = walk([&format!("{LEAVE}E\n"), &format!("{RETURN}E\n")]);
            assert!(end(&away, 2).reaction.iter().all(|own| *own == 0.0), "{about}");
            all_near(&end(&away, 3).reaction, &end(&there, 3).reaction, 1e-12, &about);
            near(
                end(&away, 3).energy.strain_energy,
                end(&there, 3).energy.strain_energy,
                1e-12 * end(&there, 3).energy.strain_energy,
                &about,
            );
        }
    }
}

/// Four plane elements in a square, the upper ones the set UP; plastic where asked for.
fn square(hardens: bool) -> String {
    let mut deck = "*NODE\n".to_owned();
    for j in 0..3 {
        for i in 0..3 {
            let _ = writeln!(deck, "{}, {i}., {j}.", 1 + i + 3 * j);
        }
    }
    let plastic = if hardens { "*PLASTIC\n10., 0.\n30., 0.2\n" } else { "" };
    deck + "*ELEMENT, TYPE=CPE4, ELSET=DOWN\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n*ELEMENT, TYPE=CPE4, \
        ELSET=UP\n3, 4, 5, 8, 7\n4, 5, 6, 9, 8\n*ELSET, ELSET=ALL\nUP, DOWN\n*SOLID SECTION, \
        ELSET=ALL, MATERIAL=M\n1.\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n"
        + plastic
        + "*BOUNDARY\n1, 1, 2\n2, 1, 2\n3, 1, 2\n7, 1, 2\n8, 1, 2\n9, 1, 2\n"
}

const SIDE: &str = "*CLOAD\n4, 1, 8.\n5, 2, 6.\n6, 1, 9.\n";

/// Requirement: a run that is left in the middle of a removal or of an addition goes on to the same
/// bits. Plastic solids at large strain.
#[test]
fn a_saved_state_in_the_middle_of_a_change_goes_on_alike() {
    let deck = square(true)
        + &step(true, 2, SIDE)
        + &step(true, 4, &format!("{LEAVE}UP\n"))
        + &step(true, 2, &format!("{BEGIN}3\n"))
        + &step(true, 2, &format!("{RETURN}4\n*CLOAD, OP=NEW\n5, 2, 9.\n"));
    let model = model(&deck, Dialect::Abaqus);
    let straight = walked(&model).rows;
    assert_eq!(straight.len(), 10);
    struct Saved(Vec<slideline::Checkpoint<'static>>);
    impl Observer for Saved {
        fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
            if let Event::Checkpoint(checkpoint) = event {
                self.0.push(checkpoint.owned());
            }
            ControlFlow::Continue(())
        }
    }
    let mut saved = Saved(Vec::new());
    let _ = solve(&model, &SolveOptions::default(), &mut saved);
    assert_eq!(saved.0.len(), 10);
    for (place, from) in saved.0.into_iter().enumerate().take(9) {
        let mut rows = Rows::default();
        let ending = resume(&model, &SolveOptions::default(), from, &mut rows);
        assert!(matches!(ending, Some(Ending::Completed(_))), "{place}: {ending:?}");
        assert_eq!(rows.rows, straight[place + 1..], "from {place} on");
    }
}

/// Requirement: nodes that nothing moves any more stay, and load on what is absent vanishes: a
/// pressure on removed faces and their weight ramp off, and begin again.
#[test]
fn loads_leave_with_their_elements_and_come_back() {
    let deck = square(false)
        .replace("*BOUNDARY\n1", "*DENSITY\n2.\n*BOUNDARY\n1")
        .replace("7, 1, 2\n8, 1, 2\n9, 1, 2\n", "7, 1\n")
        + &step(false, 1, "*DLOAD\nUP, P3, 4.\nALL, GRAV, 1., 0., -1.\n")
        + &step(false, 2, &format!("{LEAVE}UP\n"))
        + &step(false, 2, &format!("{BEGIN}UP\n"));
    let rows = run(&deck);
    // pressure 4 on a width of 2, weight 2 a unit of area
    let held = |row: &Row| row.reaction.iter().skip(1).step_by(6).sum::<f64>();
    near(held(end(&rows, 1)), 4.0 * 2.0 + 2.0 * 4.0, 1e-10, "all");
    near(held(end(&rows, 2)), 2.0 * 2.0, 1e-10, "the lower half");
    near(held(&rows[1]), 0.5 * (16.0 + 4.0), 1e-10, "half way");
    near(held(end(&rows, 3)), 16.0, 1e-10, "all again");
    let top = |row: &Row| row.motion[6 * 6..].to_vec();
    assert_eq!(top(end(&rows, 2)), top(end(&rows, 1)), "what nothing moves stays");
    assert_ne!(end(&rows, 2).motion[6 * 4 + 1], end(&rows, 1).motion[6 * 4 + 1]);
}

/// Requirement: a body whose elements are all absent takes its rigid body, its equation, its own
/// axes and its tie along without making the matrix singular.
#[test]
fn what_hangs_on_absent_elements_is_held() {
    let cards = "*NODE\n20, 1., 3.\n21, 5., 5.\n*RIGID BODY, REF NODE=20, TIE NSET=TOP\n\
        *NSET, NSET=TOP\n7, 8, 9\n*TRANSFORM, NSET=SIDE\n1., 1., 0., -1., 1., 0.\n*NSET, NSET=SIDE\n6\n\
        *BOUNDARY\n1";
    let deck =
        square(false).replace("7, 1, 2\n8, 1, 2\n9, 1, 2\n", "").replacen("*BOUNDARY\n1", cards, 1)
            + &step(true, 1, "*CLOAD\n20, 2, 6.\n6, 1, 2.\n")
            + &step(true, 2, &format!("{LEAVE}UP\n*CLOAD, OP=NEW\n6, 1, 2.\n"))
            + &step(true, 2, &format!("{RETURN}UP\n*CLOAD, OP=NEW\n20, 2, 6.\n6, 1, 2.\n"));
    let rows = run(&deck);
    all_near(&end(&rows, 3).motion, &end(&rows, 1).motion, 1e-9, "as before");
    let reference = |row: &Row| row.motion[6 * 9..6 * 10].to_vec();
    assert_eq!(reference(end(&rows, 2)), reference(end(&rows, 1)), "the body stays");
}

/// A cantilever under a rigid stop that presses its tip down.
fn held_beam(law: &str) -> String {
    let mut deck = "*NODE\n".to_owned();
    for node in 0..=10 {
        let _ = writeln!(deck, "{}, {node}., 0.", node + 1);
    }
    deck + "20, 10., 3.\n*ELEMENT, TYPE=B21, ELSET=B\n1, 1, 2\n*ELGEN, ELSET=B\n1, 10\n*BEAM SECTION, \
        SECTION=RECT, ELSET=B, MATERIAL=M\n1., 0.5\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n\
        *NSET, NSET=TIP\n10, 11\n*SURFACE, NAME=TIP, TYPE=NODE\nTIP\n*SURFACE, NAME=STOP, \
        TYPE=SEGMENTS\nSTART, 20., 0.\nLINE, -1., 0.\n*RIGID BODY, REF NODE=20, ANALYTICAL \
        SURFACE=STOP\n*SURFACE INTERACTION, NAME=I\n1.\n*FRICTION\n0.3\n"
        + law
        + "*CONTACT PAIR, INTERACTION=I\nTIP, STOP\n*BOUNDARY\n1, 1, 6\n20, 1, 6\n"
}

/// Requirement: what a removed contact pair held springs back, linearly in time where all is linear;
/// when it comes back it holds again as before. Linear kinematics, hard and softened law.
#[test]
fn a_removed_pair_lets_go_and_comes_back() {
    let soft = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1000.\n";
    for law in ["", soft] {
        let press = "*BOUNDARY\n20, 2, 2, -0.2\n";
        let change = |act: &str| format!("*MODEL CHANGE, TYPE=CONTACT PAIR, {act}\nTIP, STOP\n");
        let deck = held_beam(law)
            + &step(false, 4, press)
            + &step(false, 4, &change("REMOVE"))
            + &step(false, 1, &change("ADD"));
        let rows = walked(&model(&deck, Dialect::Abaqus)).rows;
        let tip = |row: &Row| row.motion[6 * 10 + 1];
        let pressed = tip(end(&rows, 1));
        assert!(pressed < -0.19, "{pressed}");
        for row in rows.iter().filter(|row| row.step == 2) {
            near(tip(row), pressed * (1.0 - row.time), 1e-9, "springs back");
            let held = end(&rows, 1).reaction[6 * 11 + 1];
            near(row.reaction[6 * 11 + 1], held * (1.0 - row.time), 1e-9, "the stop is let go");
            near(row.energy.balance, end(&rows, 1).energy.balance, 1e-9, "balance");
        }
        near(tip(end(&rows, 3)), pressed, 1e-6, "held again");
    }
}

/// Requirement: what is absent in the first step was never there: the run is that of a deck without
/// it, and the pair is not searched.
#[test]
fn what_is_absent_from_the_beginning_was_never_there() {
    let with = square(true) + &step(true, 3, &format!("{LEAVE}UP\n{SIDE}"));
    let without = square(true).replace("7, 1, 2\n8, 1, 2\n9, 1, 2\n", "");
    let without =
        without.replace("*ELEMENT, TYPE=CPE4, ELSET=UP\n3, 4, 5, 8, 7\n4, 5, 6, 9, 8\n", "");
    let without = without.replace("UP, DOWN", "DOWN") + &step(true, 3, SIDE);
    let (one, other) = (run(&with), run(&without));
    for (one, other) in one.iter().zip(&other) {
        all_near(&one.motion[..36], &other.motion[..36], 1e-12, "motion");
        near(one.energy.strain_energy, other.energy.strain_energy, 1e-12, "energy");
        assert_eq!(one.energy.removed_energy, 0.0);
    }
}

/// Requirement: the dialects end alike; in that of CalculiX the forces of what is removed are gone at once. Linear
/// elasticity, 1e-12.
#[test]
fn both_dialects_change_the_model_alike() {
    let deck = BARS.to_owned()
        + &step(false, 1, "*CLOAD\n2, 1, 4.\n")
        + &step(false, 2, &format!("{LEAVE}RIGHT\n"));
    let [one, other] =
        [Dialect::Abaqus, Dialect::Calculix].map(|dialect| walked(&model(&deck, dialect)).rows);
    all_near(&end(&one, 2).motion, &end(&other, 2).motion, 1e-12, "end");
    let [ramped, gone] = [&one, &other].map(|rows| rows[1].motion[6]);
    let last = end(&one, 2).motion[6];
    assert!((gone - last).abs() < 1e-12 && (ramped - last).abs() > 1e-3, "{ramped} {gone} {last}");
}

/// Requirement: files say what is absent: the cells of the states, the energy that left; tables have
/// rows of what is there.
#[test]
fn files_leave_out_what_is_absent() {
    let print = "*EL PRINT, ELSET=ALL\nS\n*ELEMENT OUTPUT, ELSET=ALL\nS\n";
    let deck = square(false)
        + &step(false, 1, &(SIDE.to_owned() + print))
        + &step(false, 1, &format!("{LEAVE}UP\n"));
    let folder = std::path::PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("model_change");
    let _ = std::fs::remove_dir_all(&folder);
    let read = Job::read_text("parts", &deck, &ReadOptions::default());
    let options = slideline::RunOptions { folder: Some(folder.clone()), ..Default::default() };
    let done = slideline::run(&read, &options, &mut slideline::Quiet);
    assert_eq!(done.status, slideline::Status::Completed, "{done:?}");
    let text = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    let energy = text("parts.energy.csv");
    assert!(energy.lines().next().unwrap().contains("released_energy,removed_energy"), "{energy}");
    let rows = text("parts.element.csv");
    let of = |increment: &str| {
        let named = rows.lines().filter(|line| line.starts_with(increment));
        named.map(|line| line.split(',').nth(3).unwrap().to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(of("1,1,").iter().filter(|own| *own == "3").count(), 4, "{rows}");
    assert!(
        !of("2,1,").contains(&"3".to_owned()) && of("2,1,").contains(&"1".to_owned()),
        "{rows}"
    );
    let state = std::fs::read(folder.join("parts_0001.vtu")).unwrap();
    assert!(state.windows(13).any(|own| own == b"Name=\"active\""), "no field");
}

/// Requirement: an element that begins warm is free of stress there, and expands from there. Closed
/// form: E A alpha (T - T0) between walls, 1e-11.
#[test]
fn an_element_that_begins_warm_expands_from_there() {
    let deck = BARS.replace("*ELASTIC\n1000., 0.", "*ELASTIC\n1000., 0.\n*EXPANSION\n1.E-3")
        + "*NSET, NSET=N\n1, 2, 3\n"
        + &step(false, 1, &format!("{LEAVE}ALL\n*BOUNDARY\n2, 1\n*TEMPERATURE\nN, 50.\n"))
        + &step(false, 1, &format!("{BEGIN}RIGHT\n"))
        + &step(false, 2, &format!("{RETURN}LEFT\n*TEMPERATURE\nN, 80.\n"));
    let rows = run(&deck);
    assert!(end(&rows, 2).reaction.iter().all(|own| *own == 0.0));
    // the left one has been there from the start
    near(end(&rows, 3).reaction[0], 100.0 * 1e-3 * 80.0, 1e-11, "left");
    near(end(&rows, 3).reaction[12], -100.0 * 1e-3 * 30.0, 1e-11, "right");
}

/// Requirement: what only absent elements have held is named, before the run and by the run, with a
/// step and a node of it.
#[test]
fn what_has_lost_its_hold_is_named() {
    let mut deck = "*NODE\n".to_owned();
    for node in 0..=6 {
        let _ = writeln!(deck, "{}, {node}., 0.", node + 1);
    }
    deck += "*ELEMENT, TYPE=B21, ELSET=B\n1, 1, 2\n*ELGEN, ELSET=B\n1, 6\n*ELSET, ELSET=JOINT\n3\n\
        *BEAM SECTION, SECTION=RECT, ELSET=B, MATERIAL=M\n1., 0.5\n*MATERIAL, NAME=M\n*ELASTIC\n\
        1000., 0.\n*BOUNDARY\n1, 1, 6\n";
    deck += &step(true, 1, "*CLOAD\n7, 2, 0.01\n");
    deck += &step(true, 1, &format!("{LEAVE}JOINT\n"));
    let read = Job::read_text("loose", &deck, &ReadOptions::default());
    let said = slideline::advise(&read);
    let loose = said.iter().find(|own| own.code.0 == "SL0409").unwrap();
    assert!(loose.message.starts_with("from step 2 on the body of node 4"), "{loose:?}");
    let mut rows = Rows::default();
    match solve(&read.model.unwrap(), &SolveOptions::default(), &mut rows) {
        Ending::NotConverged(_, why) => {
            assert_eq!(why.code.0, "SL0503", "{why:?}");
            let named = (4..=7).any(|node| why.message.contains(&format!("node {node} ")));
            assert!(named, "{}", why.message);
        }
        other => panic!("{other:?}"),
    }
}

/// Requirement: sets and elements of instances are named as elsewhere, the cards in any order; and
/// contact elements stand for their pair.
#[test]
fn instances_and_contact_elements_are_named_as_elsewhere() {
    let deck =
        "*PART, NAME=P\n*NODE\n1, 0., 0.\n2, 1., 0.\n3, 2., 0.\n*ELEMENT, TYPE=T2D2, ELSET=E\n\
        1, 1, 2\n2, 2, 3\n*SOLID SECTION, ELSET=E, MATERIAL=M\n1.\n*END PART\n*ASSEMBLY, NAME=A\n\
        *INSTANCE, NAME=I, PART=P\n*END INSTANCE\n*INSTANCE, NAME=J, PART=P\n0., 5., 0.\n\
        *END INSTANCE\n*END ASSEMBLY\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n*BOUNDARY\n\
        I.1, 1, 2\nI.2, 2\nI.3, 1, 2\nJ.1, 1, 2\nJ.2, 2\nJ.3, 1, 2\n"
            .to_owned()
            + &step(true, 1, "*CLOAD\nI.2, 1, 3.\n")
            + &step(true, 1, &format!("{LEAVE}J.E, I.2\n"));
    let presence = model(&deck, Dialect::Abaqus).steps[1].presence.clone();
    assert_eq!(presence.absent.len(), 3, "{presence:?}");
    let rows = run(&deck);
    assert_eq!(end(&rows, 2).results.iter().sum::<usize>(), 1);
    let irs = "*NODE\n1, 0., 0.\n2, 1., 0.\n9, 0., 1.\n*ELEMENT, TYPE=B21, ELSET=B\n1, 1, 2\n\
        *BEAM SECTION, SECTION=RECT, ELSET=B, MATERIAL=M\n1., 0.5\n*MATERIAL, NAME=M\n*ELASTIC\n\
        1000., 0.\n*RIGID SURFACE, TYPE=SEGMENTS, ELSET=C\nSTART, -9., -1.\nLINE, 9., -1.\n\
        *ELEMENT, TYPE=IRS21, ELSET=C\n11, 1, 2, 9\n*INTERFACE, ELSET=C\n1.\n*BOUNDARY\n1, 1, 6\n\
        9, 1, 6\n"
        .to_owned()
        + &step(true, 1, &format!("{LEAVE}C\n"))
        + &step(true, 1, "*MODEL CHANGE, ADD\n11\n");
    let model = model(&irs, Dialect::Abaqus);
    let absent = model.steps.iter().map(|step| step.presence.absent_pairs.clone());
    assert_eq!(absent.collect::<Vec<_>>(), [vec![0], vec![]]);
}
