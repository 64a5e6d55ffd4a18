//! Stress before the first step, `*INITIAL CONDITIONS, TYPE=STRESS`.
//!
//! Source: docs/theory.md sections 3.15 and 9.2. Closed forms of bars; elements of every kind against
//! the same elements in a deck of their own, strained from where they are free of stress.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::{Dialect, Dof, ElementType, Kinematics, Model, TYPES};
use slideline::observe::{Ending, Energies};
use slideline::{Checkpoint, Event, Job, Observer, ReadOptions, SolveOptions, Stop, resume, solve};
use slideline_mech::element::solid;
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// A committed increment: vectors have three entries a node.
#[derive(Clone, Debug, PartialEq)]
struct Row {
    step: usize,
    time: f64,
    motion: Vec<f64>,
    reaction: Vec<f64>,
    energy: Energies,
    stress: Vec<f64>,
}

#[derive(Default)]
struct Rows {
    rows: Vec<Row>,
    saved: Vec<Checkpoint<'static>>,
}

impl Observer for Rows {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Committed(frame) => {
                let each = |of: &dyn Fn(usize, Dof) -> f64| -> Vec<f64> {
                    let nodes = 0..frame.model.nodes.len();
                    nodes
                        .flat_map(|node| [Dof::U1, Dof::U2, Dof::U3].map(|dof| of(node, dof)))
                        .collect()
                };
                self.rows.push(Row {
                    step: frame.step,
                    time: frame.step_time,
                    motion: each(&|node, dof| frame.nodal.displacement(node, dof)),
                    reaction: each(&|node, dof| frame.nodal.reaction(node, dof)),
                    energy: frame.energy,
                    stress: frame.elements.iter().flat_map(|own| own.values.clone()).collect(),
                });
            }
            Event::Checkpoint(checkpoint) => self.saved.push(checkpoint.owned()),
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

fn model(deck: &str, dialect: Dialect) -> Model {
    let options = ReadOptions { dialect: Some(dialect), ..ReadOptions::default() };
    let read = Job::read_text("stress", deck, &options);
    let mut model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    for step in &mut model.steps {
        step.controls.field.r_n = 1e-12;
    }
    model
}

fn run(deck: &str, dialect: Dialect) -> Rows {
    let mut rows = Rows::default();
    match solve(&model(deck, dialect), &SolveOptions::default(), &mut rows) {
        Ending::Completed(_) => rows,
        other => panic!("{deck}\n{other:?}"),
    }
}

fn step(nlgeom: bool, count: usize, cards: &str) -> String {
    let nlgeom = if nlgeom { ", NLGEOM" } else { "" };
    format!("*STEP{nlgeom}\n*STATIC, DIRECT\n{:?}, 1.\n{cards}*END STEP\n", 1.0 / count as f64)
}

/// A bar of two trusses of area 0.5 along x, E = 1000, under this stress.
fn bar(stress: f64, more: &str) -> String {
    format!(
        "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 3., 0.\n*ELEMENT, TYPE=T2D2, ELSET=E\n1, 1, 2\n2, 2, 3\n\
         *SOLID SECTION, ELSET=E, MATERIAL=M\n0.5\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n{more}\
         *INITIAL CONDITIONS, TYPE=STRESS\nE, {stress:?}\n*BOUNDARY\n1, 1, 2\n2, 2\n3, 2\n"
    )
}

/// Requirement: a bar under stress between walls stays, and the walls hold the stress from the first
/// increment on. Equilibrium, 1e-12.
#[test]
fn a_bar_between_walls_stays() {
    for nlgeom in [false, true] {
        let rows = run(&(bar(80.0, "") + &step(nlgeom, 2, "*BOUNDARY\n3, 1\n")), Dialect::Abaqus);
        for row in &rows.rows {
            assert!(row.motion.iter().all(|u| u.abs() < 1e-14), "{row:?}");
            assert!((row.reaction[0] + 40.0).abs() < 1e-11, "{row:?}");
            assert!((row.reaction[6] - 40.0).abs() < 1e-11, "{row:?}");
            assert!(row.energy.balance.abs() < 1e-12, "{row:?}");
        }
    }
}

/// Requirement: what nothing holds comes to rest free of stress: at small strain it has shrunk by
/// s/E, at large strain by the stretch l at which E ln l = s l; over the step the stress falls in a
/// straight line where strains are small. Closed form, 1e-12 and 1e-9; the energy that it held is the work of
/// the load that lets it go.
#[test]
fn a_free_bar_relaxes_to_the_exact_strain() {
    let (stress, modulus) = (80.0, 1000.0);
    let mut stretch = 1.0_f64;
    for _ in 0..200 {
        stretch = (stress / modulus * stretch).exp();
    }
    for (nlgeom, length) in [(false, 1.0 - stress / modulus), (true, 1.0 / stretch)] {
        let rows = run(&(bar(stress, "") + &step(nlgeom, 4, "")), Dialect::Abaqus).rows;
        let last = rows.last().unwrap();
        // where all forces vanish, so does what residuals are held against
        assert!((last.motion[6] - 3.0 * (length - 1.0)).abs() < 1e-9, "{nlgeom}: {last:?}");
        assert!(last.energy.strain_energy.abs() < 1e-12, "{last:?}");
        if !nlgeom {
            for row in &rows {
                let left = stress * (1.0 - row.time);
                let expected = -3.0 * (stress - left) / modulus;
                assert!((row.motion[6] - expected).abs() < 1e-12, "{row:?}");
                assert!(row.energy.balance.abs() < 1e-12, "{row:?}");
            }
        }
    }
}

/// Requirement: a bar that has 8 of its yield stress of 10 yields after a strain of 2/E, and hardens
/// from there. Closed form, 1e-10.
#[test]
fn a_stressed_bar_yields_earlier() {
    let plastic = "*PLASTIC\n10., 0.\n30., 0.2\n";
    let pull = "*BOUNDARY\n3, 1, 1, 0.03\n";
    let rows = run(&(bar(8.0, plastic) + &step(false, 10, pull)), Dialect::Abaqus).rows;
    for row in rows {
        let strain = 0.01 * row.time;
        let elastic = 8.0 + 1000.0 * strain;
        // hardening by 100 of plastic strain
        let stress = if elastic <= 10.0 { elastic } else { 10.0 + (elastic - 10.0) / 11.0 };
        assert!((row.reaction[6] - 0.5 * stress).abs() < 1e-10, "{row:?}");
    }
}

/// Stretches of the undeformed body against the one that is free of stress, by kind.
fn stretches(strains: solid::Kinematics, nu: f64) -> [f64; 3] {
    let [a, b, c] = [1.02_f64, 0.985, 1.01];
    match strains {
        solid::Kinematics::PlaneStrain => [a, b, 1.0],
        solid::Kinematics::PlaneStress => [a, b, (-nu / (1.0 - nu) * (a.ln() + b.ln())).exp()],
        solid::Kinematics::Axisymmetric => [a, b, a],
        solid::Kinematics::Space => [a, b, c],
    }
}

const MODULUS: f64 = 1000.0;
const NU: f64 = 0.3;

/// The Cauchy stress of these strains: Hooke's, or Hencky's law.
fn stress(stretches: [f64; 3], large: bool) -> [f64; 3] {
    let strain = stretches.map(|own| if large { own.ln() } else { own - 1.0 });
    let (sum, volume) = (strain.iter().sum::<f64>(), stretches.iter().product::<f64>());
    let lame = MODULUS * NU / ((1.0 + NU) * (1.0 - 2.0 * NU));
    let shear = MODULUS / (2.0 * (1.0 + NU));
    strain.map(|own| (lame * sum + 2.0 * shear * own) / if large { volume } else { 1.0 })
}

/// Where a point of the undeformed body goes: stretched, sheared, turned far where that may be; of a
/// ring without a turn.
fn goes(at: [f64; 3], large: bool, ring: bool, space: bool) -> [f64; 3] {
    let [x, y, z] = at;
    let size = if large { 1.0 } else { 1e-3 };
    let shear = if ring { 0.0 } else { 0.05 };
    let (u, v) = (x * (1.0 + 0.03 * size) + shear * size * y, y * (1.0 - 0.04 * size));
    let w = if space { z * (1.0 + 0.02 * size) + 0.03 * size * x } else { z };
    let (s, c) = if large && !ring { 0.7_f64.sin_cos() } else { (0.0, 1.0) };
    [c * u - s * v, s * u + c * v, w]
}

fn element(row: &ElementType, nodes: &[[f64; 3]], thickness: f64) -> String {
    let mut deck = "*NODE\n".to_owned();
    for (node, [x, y, z]) in nodes.iter().enumerate() {
        let _ = writeln!(deck, "{}, {x:?}, {y:?}, {z:?}", node + 1);
    }
    let list: Vec<String> = (1..=nodes.len()).map(|node| node.to_string()).collect();
    let list = list.chunks(10).map(|line| line.join(", ")).collect::<Vec<_>>().join(",\n");
    let name = row.names[0];
    format!(
        "{deck}*ELEMENT, TYPE={name}, ELSET=E\n1, {list}\n*SOLID SECTION, ELSET=E, MATERIAL=M\n\
         {thickness:?}\n*MATERIAL, NAME=M\n*ELASTIC\n{MODULUS:?}, {NU:?}\n"
    )
}

fn lead(from: &[[f64; 3]], to: &[[f64; 3]], space: bool) -> String {
    let mut cards = "*BOUNDARY\n".to_owned();
    for (node, (from, to)) in from.iter().zip(to).enumerate() {
        for axis in 0..if space { 3 } else { 2 } {
            let value = to[axis] - from[axis];
            let _ = writeln!(cards, "{}, {1}, {1}, {value:?}", node + 1, axis + 1);
        }
    }
    cards
}

/// Requirement: a solid of every kind under stress answers a motion as one that is strained to that
/// stress from where it is free of it, energy included; far turned too. Another deck, 1e-9.
#[test]
fn solids_of_every_kind_answer_as_if_strained_before() {
    let mut count = 0;
    for row in TYPES {
        let Kinematics::Solid { strains, .. } = row.kinematics else { continue };
        count += 1;
        let (space, ring) = (row.is_spatial(), row.is_ring());
        let bend = |[x, y, z]: [f64; 3]| [3.0 + x + 0.1 * y, y + 0.05 * x, z + 0.1 * x];
        let places = row.cell.places.iter().map(|&at| bend(at));
        let nodes: Vec<[f64; 3]> =
            places.map(|[x, y, z]| [x, y, if space { z } else { 0.0 }]).collect();
        for large in [false, true] {
            let l = stretches(strains, NU);
            let l = match (large, strains) {
                // small strains add: the strain across is linear too
                (false, solid::Kinematics::PlaneStress) => {
                    [l[0], l[1], 1.0 - NU / (1.0 - NU) * (l[0] + l[1] - 2.0)]
                }
                _ => l,
            };
            let sigma = stress(l, large);
            let free = |at: [f64; 3]| -> [f64; 3] {
                std::array::from_fn(|k| if large { at[k] / l[k] } else { at[k] })
            };
            let strained = |at: [f64; 3]| -> [f64; 3] {
                let x = goes(at, large, ring, space);
                std::array::from_fn(|k| if large { x[k] } else { x[k] + (l[k] - 1.0) * at[k] })
            };
            let data = match strains {
                solid::Kinematics::PlaneStress => format!("{:?}, {:?}", sigma[0], sigma[1]),
                _ => format!("{:?}, {:?}, {:?}", sigma[0], sigma[1], sigma[2]),
            };
            let to: Vec<_> = nodes.iter().map(|&at| goes(at, large, ring, space)).collect();
            let one = element(row, &nodes, 0.5)
                + &format!("*INITIAL CONDITIONS, TYPE=STRESS\nE, {data}\n")
                + &step(large, 3, &lead(&nodes, &to, space));
            let before: Vec<_> = nodes.iter().map(|&at| free(at)).collect();
            let to: Vec<_> = nodes.iter().map(|&at| strained(at)).collect();
            let thickness = if large && !space && !ring { 0.5 / l[2] } else { 0.5 };
            let other =
                element(row, &before, thickness) + &step(large, 10, &lead(&before, &to, space));
            let about = format!("{} {large}", row.names[0]);
            let [one, other] =
                [one, other].map(|deck| run(&deck, Dialect::Abaqus).rows.pop().unwrap());
            let largest = other.reaction.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
            for (a, b) in one.reaction.iter().zip(&other.reaction) {
                assert!((a - b).abs() < 1e-9 * largest, "{about}: {a} {b} of {largest}");
            }
            let (a, b) = (one.energy.strain_energy, other.energy.strain_energy);
            assert!((a - b).abs() < 1e-9 * b, "{about}: {a} {b}");
        }
    }
    assert!(count > 20, "{count}");
}

/// Requirement: CalculiX gives stresses point by point along its lines; a point that no line names
/// begins free of stress. The told stress of a held cube, 1e-12.
#[test]
fn calculix_gives_stresses_point_by_point() {
    let row = TYPES.iter().find(|row| row.names[0] == "C3D8").unwrap();
    let deck = element(row, row.cell.places, 1.0)
        + "*INITIAL CONDITIONS, TYPE=STRESS\nE, 2, 1., 2., 3., 4., 5., 6.\n1, 8, 7.\n"
        + &step(true, 1, &lead(row.cell.places, row.cell.places, true));
    let last = run(&deck, Dialect::Calculix).rows.pop().unwrap();
    for point in 0..8 {
        let expected = match point {
            1 => [1.0, 2.0, 3.0, 4.0, 5.0, 6.0],
            7 => [7.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            _ => [0.0; 6],
        };
        for (a, b) in last.stress[6 * point..6 * point + 6].iter().zip(expected) {
            assert!((a - b).abs() < 1e-12, "{point}: {:?}", &last.stress[..48]);
        }
    }
}

/// Requirement: a run that is left in the first step goes on to the same bits, and elements that
/// begin anew have forgotten their stress.
#[test]
fn stresses_are_saved_and_forgotten_with_the_state() {
    let leave = "*MODEL CHANGE, REMOVE\n2\n";
    let deck = bar(80.0, "")
        + &step(true, 4, "*BOUNDARY\n3, 1, 1, 0.01\n")
        + &step(true, 2, leave)
        + &step(true, 2, "*MODEL CHANGE, ADD\n2\n");
    let model = model(&deck, Dialect::Abaqus);
    let mut straight = Rows::default();
    let _ = solve(&model, &SolveOptions::default(), &mut straight);
    assert_eq!(straight.rows.len(), 8);
    for (place, from) in straight.saved.into_iter().enumerate().take(7) {
        let mut rows = Rows::default();
        let ending = resume(&model, &SolveOptions::default(), from, &mut rows);
        assert!(matches!(ending, Some(Ending::Completed(_))), "{place}: {ending:?}");
        assert_eq!(rows.rows, straight.rows[place + 1..], "from {place} on");
    }
    let last = straight.rows.last().unwrap();
    assert!(last.reaction.iter().all(|own| own.abs() < 1e-5), "nothing pulls: {last:?}");
}

/// Requirement: a strain that the law does not see lets a free body grow by it without stress, with shear too,
/// and leaves -E times it where the body is held along one axis; a metal must not yield. Source: CalculiX subtracts it from the strain of the law. Small
/// strain, rounding; with NLGEOM the square of the strain.
#[test]
fn a_strain_that_the_law_does_not_see() {
    let strain = [1e-3, -4e-4, 2e-4, 3e-4, -1e-4, 2e-4];
    let deck = |strain: [f64; 6], held: &str, more: &str, step: &str| {
        let values: Vec<String> = strain.iter().map(|own| format!("{own:?}")).collect();
        let lines: String =
            (1..9).map(|point| format!("E, {point}, {}\n", values.join(", "))).collect();
        format!(
            "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n5, 0., 0., 1.\n6, 1., 0., 1.\n\
             7, 1., 1., 1.\n8, 0., 1., 1.\n*ELEMENT, TYPE=C3D8, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n\
             *SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n{more}\
             *INITIAL CONDITIONS, TYPE=PLASTIC STRAIN\n{lines}*STEP{step}\n*STATIC\n.5, 1.\n*BOUNDARY\n{held}\
             *END STEP\n"
        )
    };
    // three nodes hold the rigid motions: 1 all, 2 two, 4 one
    let free = "1, 1, 3\n2, 2, 3\n4, 3\n";
    for (step, tolerance) in [("", 1e-12), (", NLGEOM", 2e-6)] {
        let rows = run(&deck(strain, free, "*PLASTIC\n20., 0.\n", step), Dialect::Calculix).rows;
        let last = rows.last().unwrap();
        let [xx, yy, zz, xy, xz, yz] = strain;
        // of the simple shears that nodes 1, 2, 4 leave: u = xx x + 2 xy y + 2 xz z, v = yy y + 2 yz z
        let corner = &last.motion[3 * 6..3 * 6 + 3];
        let exact = [xx + 2.0 * xy + 2.0 * xz, yy + 2.0 * yz, zz];
        for (found, exact) in corner.iter().zip(exact) {
            assert!((found - exact).abs() < tolerance, "{step} {corner:?} {exact:?}");
        }
        let largest = last.reaction.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
        assert!(largest < 1e-6, "{step} {largest}");
    }
    let sides = "1, 1, 3\n2, 1, 3\n3, 1\n4, 1\n3, 3\n4, 3\n5, 1, 2\n6, 1, 2\n7, 1\n8, 1\n";
    let rows = run(&deck([1e-3, 0.0, 0.0, 0.0, 0.0, 0.0], sides, "", ""), Dialect::Calculix).rows;
    let pull: f64 = [1, 2, 5, 6].iter().map(|&node| rows.last().unwrap().reaction[3 * node]).sum();
    assert!((pull + 1.0).abs() < 1e-9, "{pull}");
    let yielding = deck([0.1, 0.0, 0.0, 0.0, 0.0, 0.0], free, "*PLASTIC\n20., 0.\n", "");
    let options = ReadOptions { dialect: Some(Dialect::Calculix), ..ReadOptions::default() };
    let said = Job::read_text("stress", &yielding, &options).diagnostics;
    assert!(said.iter().any(|own| own.code.0 == "SL0385"), "{said:#?}");
}
