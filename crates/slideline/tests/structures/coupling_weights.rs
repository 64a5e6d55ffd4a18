//! How couplings spread a force over the nodes of a surface: by areas, distance, and axes.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::{Dialect, Dof};
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::collections::BTreeMap;
use std::ops::ControlFlow;

/// Displacements of all nodes at the end, by label.
#[derive(Default)]
struct End(BTreeMap<u64, [f64; 6]>);

impl Observer for End {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let nodes = &frame.model.nodes;
            let of = |node| Dof::ALL.map(|dof| frame.nodal.displacement(node, dof));
            self.0.extend((0..nodes.len()).map(|node| (nodes.label(node), of(node))));
        }
        ControlFlow::Continue(())
    }
}

fn run(deck: &str, dialect: Dialect) -> BTreeMap<u64, [f64; 6]> {
    let options = ReadOptions { dialect: Some(dialect), ..ReadOptions::default() };
    let read = Job::read_text("weights", deck, &options);
    let model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    let mut end = End::default();
    let ending = solve(&model, &SolveOptions::default(), &mut end);
    assert!(matches!(ending, Ending::Completed(_)), "{deck}\n{ending:?}");
    end.0
}

/// Nodes of a face that stand on equal springs along z and are coupled to node 100 above
/// `centre`, with the solids' own stiffness next to nothing; the shares of a force of 60 on it.
fn shares(
    solid: &str,
    top: &[u64],
    coupling: &str,
    centre: [f64; 2],
    dialect: Dialect,
) -> Vec<f64> {
    let [x, y] = centre;
    let list = |nodes: &[u64]| nodes.iter().map(|n| format!("{n},\n")).collect::<String>();
    let springs: String = top.iter().map(|n| format!("{}, {n}\n", 50 + n)).collect();
    let deck = format!(
        "*NODE\n100, {x:?}, {y:?}, 5.\n{solid}*NSET, NSET=TOP\n{}*SOLID SECTION, ELSET=E, MATERIAL=M\n\
         *MATERIAL, NAME=M\n*ELASTIC\n1e-6, 0.\n*ELEMENT, TYPE=SPRING1, ELSET=SP\n{springs}\
         *SPRING, ELSET=SP\n3\n1000.\n{coupling}*STEP\n*STATIC\n1., 1.\n*BOUNDARY\nBOT, 1, 3\n\
         TOP, 1, 2\n*CLOAD\n100, 3, 60.\n*END STEP\n",
        list(top)
    );
    let end = run(&deck, dialect);
    top.iter().map(|node| 1000.0 * end[node][2]).collect()
}

fn compare(found: &[f64], expected: &[f64], what: &str) {
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() < 1e-6 * 60.0, "{what}: {found:?} {expected:?}");
    }
}

/// Two bricks, 1 and 3 long and 2 wide.
const BRICKS: &str = "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 4., 0., 0.\n4, 0., 2., 0.\n\
     5, 1., 2., 0.\n6, 4., 2., 0.\n7, 0., 0., 1.\n8, 1., 0., 1.\n9, 4., 0., 1.\n10, 0., 2., 1.\n\
     11, 1., 2., 1.\n12, 4., 2., 1.\n*ELEMENT, TYPE=C3D8, ELSET=E\n1, 1, 2, 5, 4, 7, 8, 11, 10\n\
     2, 2, 3, 6, 5, 8, 9, 12, 11\n*NSET, NSET=BOT, GENERATE\n1, 6\n*SURFACE, NAME=S\nE, S2\n";
const ON_BRICKS: [u64; 6] = [7, 8, 9, 10, 11, 12];

fn coupling(more: &str, how: &str) -> String {
    format!("*COUPLING, REF NODE=100, SURFACE=S{more}\n*DISTRIBUTING{how}\n")
}

/// Requirement: a force above the centre of a surface is spread as the areas of its nodes are,
/// docs/theory.md section 4.2: 1 : 4 : 3 along two unequal bricks, -1/12 and 1/3 of a face with
/// eight nodes, 0 and 1/3 with six, in both dialects. ccx 2.20 gives the same digits. A surface of
/// nodes has equal weights, whatever areas are behind them. 1e-6.
#[test]
fn forces_are_spread_by_areas() {
    let twenty = "*NODE\n1, 0., 0., 0.\n2, 2., 0., 0.\n3, 2., 2., 0.\n4, 0., 2., 0.\n5, 0., 0., 1.\n\
         6, 2., 0., 1.\n7, 2., 2., 1.\n8, 0., 2., 1.\n9, 1., 0., 0.\n10, 2., 1., 0.\n11, 1., 2., 0.\n\
         12, 0., 1., 0.\n13, 1., 0., 1.\n14, 2., 1., 1.\n15, 1., 2., 1.\n16, 0., 1., 1.\n\
         17, 0., 0., .5\n18, 2., 0., .5\n19, 2., 2., .5\n20, 0., 2., .5\n*ELEMENT, TYPE=C3D20, \
         ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15,\n16, 17, 18, 19, 20\n\
         *NSET, NSET=BOT\n1, 2, 3, 4, 9, 10, 11, 12, 17, 18, 19, 20\n*SURFACE, NAME=S\nE, S2\n";
    let ten = "*NODE\n1, 0., 0., 1.\n2, 2., 0., 1.\n3, 0., 2., 1.\n4, 0., 0., 3.\n5, 1., 0., 1.\n\
         6, 1., 1., 1.\n7, 0., 1., 1.\n8, 0., 0., 2.\n9, 1., 0., 2.\n10, 0., 1., 2.\n*ELEMENT, \
         TYPE=C3D10, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10\n*NSET, NSET=BOT\n4, 8, 9, 10\n\
         *SURFACE, NAME=S\nE, S1\n";
    for dialect in [Dialect::Abaqus, Dialect::Calculix] {
        let plain = coupling("", "");
        let found = shares(BRICKS, &ON_BRICKS, &plain, [2.0, 1.0], dialect);
        compare(&found, &[3.75, 15.0, 11.25, 3.75, 15.0, 11.25], "bricks");
        let nodes: Vec<u64> = (5..=8).chain(13..=16).collect();
        let found = shares(twenty, &nodes, &plain, [1.0, 1.0], dialect);
        compare(&found, &[-5.0, -5.0, -5.0, -5.0, 20.0, 20.0, 20.0, 20.0], "twenty");
        let third = 2.0 / 3.0;
        let found = shares(ten, &[1, 2, 3, 5, 6, 7], &plain, [third; 2], dialect);
        compare(&found, &[0.0, 0.0, 0.0, 20.0, 20.0, 20.0], "ten");
    }
    let nodal =
        "*SURFACE, NAME=N, TYPE=NODE\nTOP, 1.\n*COUPLING, REF NODE=100, SURFACE=N\n*DISTRIBUTING\n";
    let found = shares(BRICKS, &ON_BRICKS, nodal, [5.0 / 3.0, 1.0], Dialect::Abaqus);
    compare(&found, &[10.0; 6], "nodes");
}

/// Requirement: displacements are coupled whatever the data lines say, and a force on the reference
/// node is along the axes of the coupling in the dialect of CalculiX, along those of the model in that
/// of Abaqus. Source: ccx 2.20, Abaqus manual. Axis 3 points down. 1e-6.
#[test]
fn axes_of_a_coupling_turn_forces_on_its_reference_node() {
    let axes = "*ORIENTATION, NAME=DOWN\n1., 0., 0., 0., -1., 0.\n";
    let up = [3.75, 15.0, 11.25, 3.75, 15.0, 11.25];
    for (dialect, sign) in [(Dialect::Abaqus, 1.0), (Dialect::Calculix, -1.0)] {
        for dofs in ["", "\n1, 2", "\n3, 3"] {
            let plain = coupling("", dofs);
            compare(&shares(BRICKS, &ON_BRICKS, &plain, [2.0, 1.0], dialect), &up, dofs);
            let along = format!("{axes}{}", coupling(", ORIENTATION=DOWN", dofs));
            let found = shares(BRICKS, &ON_BRICKS, &along, [2.0, 1.0], dialect);
            compare(&found, &up.map(|share| sign * share), dofs);
        }
    }
}

/// Requirement: weights that fall with the distance from the reference node fall as the factors
/// 1 - r, 1 - r^2 and 1 - 3 r^2 + 2 r^3 of the largest distance say, and INFLUENCE RADIUS leaves out
/// what is beyond. A square of nodes about a nearer pair: by symmetry no moment.
#[test]
fn weights_fall_with_the_distance() {
    // the distance of the outer nodes is the largest: their weight is nothing
    let (near, far) = ((1.0_f64 + 1.0 + 16.0).sqrt(), (9.0_f64 + 1.0 + 16.0).sqrt());
    let inner = near / far;
    for (method, factor) in [
        ("LINEAR", 1.0 - inner),
        ("QUADRATIC", 1.0 - inner * inner),
        ("CUBIC", 1.0 - 3.0 * inner.powi(2) + 2.0 * inner.powi(3)),
    ] {
        let how = format!(", WEIGHTING METHOD={method}");
        // reference node above x = 1: distances of the columns x = 0, 1 and 4
        let at = |x: f64| {
            let part = ((x - 1.0).powi(2) + 1.0 + 16.0).sqrt() / far;
            match method {
                "LINEAR" => 1.0 - part,
                "QUADRATIC" => 1.0 - part * part,
                _ => 1.0 - 3.0 * part.powi(2) + 2.0 * part.powi(3),
            }
        };
        assert!((at(0.0) - factor).abs() < 1e-12);
        let weights = [0.5 * at(0.0), 2.0 * at(1.0), 1.5 * at(4.0)];
        let total: f64 = weights.iter().sum();
        let mean: f64 = (weights[1] + 4.0 * weights[2]) / total;
        let square: f64 = [0.0, 1.0, 4.0]
            .into_iter()
            .zip(weights)
            .map(|(x, w): (f64, f64)| w * (x - mean).powi(2))
            .sum();
        let column = |x: f64, w: f64| 60.0 * w * (1.0 / total + (1.0 - mean) * (x - mean) / square);
        let one = [column(0.0, weights[0]), column(1.0, weights[1]), column(4.0, weights[2])];
        let expected: Vec<f64> = one.iter().chain(&one).map(|share| 0.5 * share).collect();
        let found = shares(BRICKS, &ON_BRICKS, &coupling("", &how), [1.0, 1.0], Dialect::Abaqus);
        compare(&found, &expected, method);
    }
    let near = coupling(", INFLUENCE RADIUS=4.5", "");
    let found = shares(BRICKS, &ON_BRICKS, &near, [0.8, 1.0], Dialect::Abaqus);
    // the columns at 0 and 1 with the areas 0.5 and 2: their centre is 0.8
    compare(&found, &[6.0, 24.0, 0.0, 6.0, 24.0, 0.0], "radius");
}

/// Requirement: displacements along the axes of ORIENTATION follow the reference node: a ring of
/// nodes held tangentially and along the axis turns as the node does and breathes freely, as
/// ccx 2.20 has it; all displacements along any axes are those along the axes of the model.
#[test]
fn couplings_along_axes() {
    let block = "*NODE, NSET=ALL\n1, 0., 0., 0.\n2, 10., 0., 0.\n3, 10., 10., 0.\n4, 0., 10., 0.\n\
         5, 0., 0., 20.\n6, 10., 0., 20.\n7, 10., 10., 20.\n8, 0., 10., 20.\n100, 5., 5., 30.\n\
         *ELEMENT, TYPE=C3D8, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n*SURFACE, NAME=S\nE, S2\n\
         *SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n\
         *ORIENTATION, NAME=OR, SYSTEM=CYLINDRICAL\n5., 5., 0., 5., 5., 1.\n";
    let step = |large: &str| {
        format!(
            "*STEP{large}\n*STATIC\n1., 1.\n*BOUNDARY\n1, 1, 3\n2, 1, 3\n3, 1, 3\n4, 1, 3\n\
             100, 1, 5\n100, 3, 3, -0.1\n100, 6, 6, 0.001\n*END STEP\n"
        )
    };
    let card = |dofs: &str, more: &str| {
        format!("*COUPLING, REF NODE=100, SURFACE=S{more}\n*KINEMATIC\n{dofs}\n")
    };
    let deck = format!("{block}{}{}", card("2, 3", ", ORIENTATION=OR"), step(""));
    let end = run(&deck, Dialect::Abaqus);
    for (node, [x, y]) in
        [(5, [-5.0, -5.0]), (6, [5.0, -5.0]), (7, [5.0, 5.0]), (8, [-5.0, 5.0_f64])]
    {
        let [ux, uy, uz, ..] = end[&node];
        let (radial, around) = ((x * ux + y * uy) / 50.0, (x * uy - y * ux) / 50.0);
        assert!(
            (around - 0.001).abs() < 1e-12 && (uz + 0.1).abs() < 1e-12,
            "{node}: {around} {uz}"
        );
        assert!(radial > 1e-4, "{node} does not breathe: {radial}");
    }
    let large = format!("{block}{}{}", card("2, 3", ", ORIENTATION=OR"), step(", NLGEOM"));
    let said = Job::read_text("weights", &large, &ReadOptions::default()).diagnostics;
    assert!(said.iter().any(|said| said.code.0 == "SL0221"), "{said:?}");
    let ends = ["", ", ORIENTATION=OR"].map(|more| {
        run(&format!("{block}{}{}", card("1, 3", more), step(", NLGEOM")), Dialect::Abaqus)
    });
    assert_eq!(ends[0], ends[1]);
}

/// Requirement: rotations that the data lines of *DISTRIBUTING leave out are no part of the
/// coupling in the dialect of Abaqus: the reference node has no rotation then.
#[test]
fn rotations_that_are_released() {
    for (dofs, turns) in [("1, 6", true), ("1, 3", false)] {
        let deck = format!(
            "*NODE\n100, 2., 1., 5.\n{BRICKS}*SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n\
             *ELASTIC\n1000., 0.3\n*COUPLING, REF NODE=100, SURFACE=S\n*DISTRIBUTING\n{dofs}\n*STEP\n\
             *STATIC\n1., 1.\n*BOUNDARY\nBOT, 1, 3\n*CLOAD\n100, 1, 1.\n*END STEP\n"
        );
        let end = run(&deck, Dialect::Abaqus);
        assert_eq!(end[&100][4].abs() > 1e-9, turns, "{dofs}: {:?}", end[&100]);
        assert!(end[&100][0].abs() > 1e-6);
    }
}
