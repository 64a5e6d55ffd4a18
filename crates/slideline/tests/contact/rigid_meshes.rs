//! Contact with meshes of rigid elements: the same as with other descriptions of the same body.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::ops::ControlFlow;

/// The reactions of node 300 in every increment.
#[derive(Default)]
struct Reactions(Vec<[f64; 6]>);

impl Observer for Reactions {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let nodes = &frame.model.nodes;
            let node = (0..nodes.len()).find(|&node| nodes.label(node) == 300).unwrap();
            self.0.push(Dof::ALL.map(|dof| frame.nodal.reaction(node, dof)));
        }
        ControlFlow::Continue(())
    }
}

fn run(deck: &str) -> Vec<[f64; 6]> {
    let read = Job::read_text("rigid", deck, &ReadOptions::default());
    let mut model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    for step in &mut model.steps {
        step.controls.field.r_n = 1e-11;
    }
    let mut found = Reactions::default();
    let ending = solve(&model, &SolveOptions::default(), &mut found);
    assert!(matches!(ending, Ending::Completed(_)), "{deck}\n{ending:?}");
    assert!(found.0.iter().any(|forces| forces[..3].iter().any(|f| f.abs() > 1.0)), "no contact");
    found.0
}

fn compare(expected: &[[f64; 6]], found: &[[f64; 6]], what: &str) {
    assert_eq!(expected.len(), found.len(), "{what}");
    let size = expected.iter().flatten().fold(0.0, |size: f64, x| size.max(x.abs()));
    for (a, b) in expected.iter().flatten().zip(found.iter().flatten()) {
        assert!((a - b).abs() < 1e-8 * size, "{what}: {a} {b} of {size}");
    }
}

fn codes(deck: &str) -> Vec<String> {
    let read = Job::read_text("rigid", deck, &ReadOptions::default());
    read.diagnostics.iter().map(|said| said.code.0.to_owned()).collect()
}

/// A block of two elements that is pressed on a ledge, which is then moved and turned.
fn plane(element: &str, ledge: &str, kind: &str) -> String {
    format!(
        "*NODE\n1, 1., 0.\n2, 2., 0.\n3, 3., 0.\n4, 1., 1.\n5, 2., 1.\n6, 3., 1.\n300, 1., -1.\n\
         *ELEMENT, TYPE={element}, ELSET=E\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n*SOLID SECTION, ELSET=E, \
         MATERIAL=M\n1.\n*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n{ledge}*SURFACE, NAME=B\nE, S1\n\
         *SURFACE INTERACTION, NAME=I\n1.\n*FRICTION\n.3\n*CONTACT PAIR, INTERACTION=I, TYPE={kind}\n\
         B, R\n*NSET, NSET=TOP\n4, 5, 6\n*STEP, NLGEOM\n*STATIC\n.25, 1.\n*BOUNDARY\nTOP, 1\n\
         TOP, 2, 2, -.05\n300, 1, 6\n*END STEP\n*STEP, NLGEOM\n*STATIC\n.25, 1.\n*BOUNDARY\n\
         300, 1, 1, .1\n300, 6, 6, .01\n*END STEP\n"
    )
}

/// Requirement: a ledge of R2D2 or RAX2 acts as the analytical surface along it: at nodes and over
/// faces, in plane strain and as a ring, with friction, moved and turned; from either side of its
/// elements, and with the side left open. 1e-8.
#[test]
fn rigid_lines_are_analytical_surfaces() {
    let analytical = "*SURFACE, NAME=R, TYPE=SEGMENTS\nSTART, .1, -.01\nLINE, 2.3, -.01\n\
                      LINE, 4.1, -.01\n*RIGID BODY, ANALYTICAL SURFACE=R, REF NODE=300\n";
    let lines = |name: &str, nodes: [u32; 3], side: &str| {
        let [a, b, c] = nodes;
        format!(
            "*NODE\n201, .1, -.01\n202, 2.3, -.01\n203, 4.1, -.01\n*ELEMENT, TYPE={name}, ELSET=L\n\
             11, {a}, {b}\n12, {b}, {c}\n*SURFACE, NAME=R\nL, {side}\n*RIGID BODY, ELSET=L, \
             REF NODE=300\n"
        )
    };
    for (element, name) in [("CPE4", "R2D2"), ("CAX4", "RAX2")] {
        for kind in ["NODE TO SURFACE", "SURFACE TO SURFACE"] {
            let expected = run(&plane(element, analytical, kind));
            for (nodes, side) in
                [([201, 202, 203], "SPOS"), ([203, 202, 201], "SNEG"), ([203, 202, 201], "")]
            {
                let found = run(&plane(element, &lines(name, nodes, side), kind));
                compare(&expected, &found, &format!("{element} {kind} {side}"));
            }
        }
    }
    let below = plane("CPE4", &lines("R2D2", [201, 202, 203], "SNEG"), "NODE TO SURFACE");
    assert!(!codes(&below).contains(&"SL0331".to_owned()), "a named side is kept");
}

/// Requirement: a rigid line or plate of no named side turns the one to a block that the block is on, not the one
/// that its nodes are on: also where these lie exactly on it, or beyond it.
#[test]
fn blocks_are_on_the_side_of_their_solids() {
    let line = |element: &str, rigid: &str, y: f64, side: &str| {
        let ledge = format!(
            "*NODE\n201, .1, {y:?}\n202, 2.3, {y:?}\n203, 4.1, {y:?}\n*ELEMENT, TYPE={rigid}, ELSET=L\n\
             11, 201, 202\n12, 202, 203\n*SURFACE, NAME=R\nL{side}\n*RIGID BODY, ELSET=L, REF NODE=300\n"
        );
        run(&plane(element, &ledge, "SURFACE TO SURFACE"))
    };
    let plate = |z: f64, side: &str| {
        let plate = format!(
            "*NODE\n221, -.2, -.3, {z:?}\n222, 1.7, -.2, {z:?}\n223, 1.6, 4.1, {z:?}\n224, -.1, 4., {z:?}\n\
             225, 5., 1.5, {z:?}\n*ELEMENT, TYPE=R3D4, ELSET=L\n11, 221, 222, 223, 224\n\
             *ELEMENT, TYPE=R3D3, ELSET=L\n12, 222, 225, 223\n*SURFACE, NAME=R\nL{side}\n\
             *RIGID BODY, ELSET=L, REF NODE=300\n"
        );
        run(&space(&plate, &pair("SURFACE TO SURFACE")))
    };
    for height in [0.0, 0.01] {
        for (element, rigid) in [("CPE4", "R2D2"), ("CAX4", "RAX2")] {
            let [named, open] = [", SPOS", ""].map(|side| line(element, rigid, height, side));
            compare(&named, &open, &format!("{element} {height}"));
        }
        let [named, open] = [", SPOS", ""].map(|side| plate(height, side));
        compare(&named, &open, &format!("plate {height}"));
    }
}

/// A block that is pressed on a plate, which is then moved and tilted.
fn space(plate: &str, contact: &str) -> String {
    format!(
        "*NODE\n1, 1., 1., 0.\n2, 2., 1., 0.\n3, 2., 2., 0.\n4, 1., 2., 0.\n5, 1., 1., 1.\n\
         6, 2., 1., 1.\n7, 2., 2., 1.\n8, 1., 2., 1.\n300, 1., 1., -1.\n201, -.2, -.3, -.01\n\
         202, 1.7, -.2, -.01\n203, 1.6, 4.1, -.01\n204, -.1, 4., -.01\n205, 5., 1.5, -.01\n\
         *ELEMENT, TYPE=C3D8, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n*SOLID SECTION, ELSET=E, \
         MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n{plate}*SURFACE, NAME=B\nE, S1\n\
         *SURFACE INTERACTION, NAME=I\n*FRICTION\n.3\n{contact}*NSET, NSET=TOP, GENERATE\n5, 8\n\
         *STEP, NLGEOM\n*STATIC\n.25, 1.\n*BOUNDARY\nTOP, 1, 2\nTOP, 3, 3, -.05\n300, 1, 6\n\
         *END STEP\n*STEP, NLGEOM\n*STATIC\n.25, 1.\n*BOUNDARY\n300, 1, 1, .1\n300, 5, 5, .01\n\
         *END STEP\n"
    )
}

fn pair(kind: &str) -> String {
    format!("*CONTACT PAIR, INTERACTION=I, TYPE={kind}\nB, R\n")
}

/// Requirement: a plate of R3D4 and R3D3 acts as the faces of rigid solids in its place: at nodes
/// and over faces, from either side of its elements, with the side left open, and in general
/// contact, which finds it. 1e-8.
#[test]
fn rigid_plates_are_faces_of_rigid_solids() {
    let solids = "*NODE\n211, -.2, -.3, -.5\n212, 1.7, -.2, -.5\n213, 1.6, 4.1, -.5\n\
                  214, -.1, 4., -.5\n215, 5., 1.5, -.5\n*ELEMENT, TYPE=C3D8, ELSET=L\n\
                  11, 211, 212, 213, 214, 201, 202, 203, 204\n*ELEMENT, TYPE=C3D6, ELSET=W\n\
                  12, 212, 215, 213, 202, 205, 203\n*ELSET, ELSET=ALL\nL, W\n*SURFACE, NAME=R\n\
                  ALL, S2\n*RIGID BODY, ELSET=ALL, REF NODE=300\n*SOLID SECTION, ELSET=ALL, \
                  MATERIAL=M\n";
    let plates = |up: bool, side: &str| {
        let (four, three) = if up {
            ("201, 202, 203, 204", "202, 205, 203")
        } else {
            ("204, 203, 202, 201", "203, 205, 202")
        };
        format!(
            "*ELEMENT, TYPE=R3D4, ELSET=L\n11, {four}\n*ELEMENT, TYPE=R3D3, ELSET=L\n12, {three}\n\
             *SURFACE, NAME=R\nL, {side}\n*RIGID BODY, ELSET=L, REF NODE=300\n"
        )
    };
    for kind in ["NODE TO SURFACE", "SURFACE TO SURFACE"] {
        let expected = run(&space(solids, &pair(kind)));
        for (up, side) in [(true, "SPOS"), (false, "SNEG"), (true, ""), (false, "")] {
            let found = run(&space(&plates(up, side), &pair(kind)));
            compare(&expected, &found, &format!("{kind} {up} {side}"));
        }
    }
    let expected = run(&space(&plates(true, "SPOS"), &pair("NODE TO SURFACE")));
    let general =
        "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , I\n";
    let found = run(&space(&plates(false, "SNEG"), general));
    compare(&expected, &found, "general contact");
}

/// Requirement: a plate that names both sides of its elements turns the one to its slaves, and a
/// surface of all nodes of a block, of which some are within it, carries the forces of its outside.
#[test]
fn both_sides_and_all_nodes() {
    let plate = "*ELEMENT, TYPE=R3D4, ELSET=L\n911, 204, 203, 202, 201\n*SURFACE, NAME=R\nL, SPOS\n\
                 L, SNEG\n*RIGID BODY, ELSET=L, REF NODE=300\n";
    let one = plate.replacen("L, SPOS\n", "", 1);
    let sides = [plate, &one].map(|plate| run(&space(plate, &pair("NODE TO SURFACE"))));
    compare(&sides[1], &sides[0], "both sides");
    // eight bricks about a node within
    let mut block = String::from("*NODE, NSET=BLOCK\n");
    let number = |i: usize, j: usize, k: usize| 1 + i + 3 * j + 9 * k;
    let mut bricks = String::from("*ELEMENT, TYPE=C3D8, ELSET=E\n");
    for (i, j, k) in (0..27).map(|n| (n % 3, n / 3 % 3, n / 9)) {
        block += &format!("{}, {}., {}., {}.\n", number(i, j, k), i, j, k);
        if i < 2 && j < 2 && k < 2 {
            let at = |a: usize, b: usize, c: usize| number(i + a, j + b, k + c);
            let ring = |c| [at(0, 0, c), at(1, 0, c), at(1, 1, c), at(0, 1, c)];
            let nodes: Vec<String> =
                ring(0).into_iter().chain(ring(1)).map(|node| node.to_string()).collect();
            bricks += &format!("{}, {}\n", number(i, j, k), nodes.join(", "));
        }
    }
    let deck = |surface: &str| {
        format!(
            "{block}*NODE\n300, 1., 1., -1.\n201, -9., -9., -.01\n202, 9., -9., -.01\n203, 9., 9., -.01\n\
             204, -9., 9., -.01\n{bricks}{plate}*SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, \
             NAME=M\n*ELASTIC\n1000., .3\n{surface}*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, \
             INTERACTION=I, TYPE=NODE TO SURFACE\nB, R\n*NSET, NSET=TOP, GENERATE\n19, 27\n*STEP, \
             NLGEOM\n*STATIC\n.5, 1.\n*BOUNDARY\n300, 1, 6\nTOP, 1, 2\nTOP, 3, 3, -.1\n*END STEP\n"
        )
    };
    let nodes = run(&deck("*SURFACE, TYPE=NODE, NAME=B\nBLOCK, 1.\n"));
    let faces = run(&deck("*ELSET, ELSET=LOW\n1, 2, 4, 5\n*SURFACE, NAME=B\nLOW, S1\n"));
    compare(&faces, &nodes, "all nodes");
}

/// Requirement: a rigid mesh cannot be the slave, and no pressure acts on it: both are said.
#[test]
fn what_a_rigid_mesh_cannot() {
    let plate = "*ELEMENT, TYPE=R3D4, ELSET=L\n11, 201, 202, 203, 204\n*SURFACE, NAME=R\nL, SPOS\n\
                 *RIGID BODY, ELSET=L, REF NODE=300\n";
    let turned = "*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nR, B\n";
    assert!(codes(&space(plate, turned)).contains(&"SL0332".to_owned()));
    let pressed = space(plate, &pair("NODE TO SURFACE"));
    let pressed = pressed.replacen("300, 1, 6\n", "300, 1, 6\n*DSLOAD\nR, P, 1.\n", 1);
    assert!(codes(&pressed).contains(&"SL0221".to_owned()));
}

/// Facets of a wheel, and increments while one of them passes.
const FACETS: usize = 24;
const EACH: usize = 4;

/// A block that is pressed on a wheel of rigid elements or beams, which then turns all the way round. The elements are
/// listed from the one of that number on.
fn wheel(rigid: &str, side: &str, begin: usize, kind: &str) -> String {
    let angle = |k: usize| std::f64::consts::TAU * (k as f64 + 0.5) / FACETS as f64;
    let at =
        |k: usize| format!("{}, {:?}, {:?}\n", 201 + k, 5.0 * angle(k).cos(), 5.0 * angle(k).sin());
    let nodes: String = (0..FACETS).map(at).collect();
    let element = |k: usize| {
        let [own, next] = [(begin + k) % FACETS, (begin + k + 1) % FACETS];
        format!("{}, {}, {}\n", 11 + k, 201 + own, 201 + next)
    };
    let elements: String = (0..FACETS).map(element).collect();
    let section = match rigid {
        "B21" => "*BEAM SECTION, ELSET=L, MATERIAL=M, SECTION=RECT\n1., .1\n",
        _ => "",
    };
    format!(
        "*NODE\n1, -1., 5.\n2, 0., 5.\n3, 1., 5.\n4, -1., 6.\n5, 0., 6.\n6, 1., 6.\n300, 0., 0.\n{nodes}\
         *ELEMENT, TYPE=CPE4, ELSET=E\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n*SOLID SECTION, ELSET=E, MATERIAL=M\n1.\n\
         *MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n*ELEMENT, TYPE={rigid}, ELSET=L\n{elements}{section}\
         *SURFACE, NAME=R\nL{side}\n*RIGID BODY, ELSET=L, REF NODE=300\n*SURFACE, NAME=B\nE, S1\n\
         *SURFACE INTERACTION, NAME=I\n1.\n*CONTACT PAIR, INTERACTION=I, TYPE={kind}\nB, R\n*NSET, NSET=TOP\n4, 5, 6\n\
         *STEP, NLGEOM\n*STATIC\n.5, 1.\n*BOUNDARY\nTOP, 1\nTOP, 2, 2, -.2\n300, 1, 6\n*END STEP\n\
         *STEP, NLGEOM\n*STATIC\n{0:?}, 1., 1e-6, {0:?}\n*BOUNDARY\n300, 6, 6, {1:?}\n*END STEP\n",
        1.0 / (FACETS * EACH) as f64,
        std::f64::consts::TAU
    )
}

/// Requirement: a closed chain of rigid elements or of beams is a master all the way round: every facet that passes
/// has the forces of the one before, that of the seam too, and where the chain begins and which way its
/// elements run makes no difference. Such a cam was refused (SL0329). 1e-8.
#[test]
fn a_closed_cam_turns_all_the_way_round() {
    for kind in ["NODE TO SURFACE", "SURFACE TO SURFACE"] {
        for rigid in ["R2D2", "B21"] {
            let found = run(&wheel(rigid, ", SNEG", 0, kind));
            let turning = &found[2..];
            assert_eq!(turning.len(), FACETS * EACH, "{rigid} {kind}: an increment was cut");
            compare(&turning[..turning.len() - EACH], &turning[EACH..], &format!("{rigid} {kind}"));
            for begin in [7, 18] {
                compare(
                    &found,
                    &run(&wheel(rigid, ", SNEG", begin, kind)),
                    &format!("{rigid} {kind} {begin}"),
                );
            }
            compare(&found, &run(&wheel(rigid, "", 3, kind)), &format!("{rigid} {kind} open"));
        }
    }
}
