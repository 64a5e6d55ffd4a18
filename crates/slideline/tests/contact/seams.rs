//! Parts that ties, equations, `*MPC` or a pre-tension section join node by node are one part, also where contact meets the seam:
//! forces are those of the mesh whose nodes are merged there.
//!
//! ```text
//!        +-----+-----+
//!        |  U  |  U  |          one of both blocks is cut, and its halves are joined
//!   +----+-----s-----+----+
//!   |    L     m     L    |     s, m: two nodes at one place on the surface of contact
//!   +----------+----------+
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::space_decks::turn;
use crate::two_blocks::{mesh, solved as pressed};
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop};
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// How halves are joined.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Joint {
    Merged,
    Tie,
    TieOfNodes,
    Equation,
    Mpc,
    /// A cut by a pre-tension section whose reference node is held.
    Cut,
}

const JOINTS: [Joint; 5] = [Joint::Tie, Joint::TieOfNodes, Joint::Equation, Joint::Mpc, Joint::Cut];

impl Joint {
    /// Whether the deck has two nodes at one place.
    fn is_of_two(self) -> bool {
        !matches!(self, Self::Merged | Self::Cut)
    }
}

/// What is pressed on what.
#[derive(Clone, Copy, Debug)]
struct Case {
    in_space: bool,
    over_faces: bool,
    /// The lower block, the master, is cut, not the upper one.
    cut_low: bool,
    law: &'static str,
}

/// Forces on the slaves of all increments, and the number of contact rows of the last one.
#[derive(Default)]
struct Forces {
    all: Vec<[f64; 3]>,
    rows: usize,
}

impl Observer for Forces {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            self.all.extend(frame.pairs.iter().take(1).map(|pair| pair.force));
            self.rows = frame.contact.len();
        }
        ControlFlow::Continue(())
    }
}

/// Columns and rows of elements of each block, and the column of nodes at which it is cut.
const CELLS: [(usize, usize, usize); 2] = [(4, 2, 2), (3, 2, 1)];

/// Nodes of a block whose elements are columns: label of the node of a column, row and layer; `right`:
/// as the elements right of the cut have it.
fn label(block: usize, (i, j, k): (usize, usize, usize), right: bool, joint: Joint) -> usize {
    let second = right && joint.is_of_two() && i == CELLS[block].2;
    1000 * (block + 1) + 500 * usize::from(second) + 100 * k + 10 * i + j + 1
}

fn place(block: usize, (i, j, k): (usize, usize, usize), case: Case) -> [f64; 3] {
    let (columns, rows, _) = CELLS[block];
    let [u, v] = [i as f64 / columns as f64, j as f64 / rows as f64];
    let z = 0.7 * k as f64;
    let x = match block {
        0 => [4.0 * u - 2.0, v - 1.0, z],
        // a foot that is a little round, beside the middle
        _ => [1.8 * u - 0.85, 0.02 * (1.0 - v) * (2.0 * u - 1.0).powi(2) + 0.8 * v, z],
    };
    if case.in_space { turn(x, 0.8) } else { x }
}

/// Nodes of a block, those that are held in a set of their own.
fn write_nodes(deck: &mut String, block: usize, joint: Joint, case: Case) {
    let (columns, rows, cut) = CELLS[block];
    let layers = if case.in_space { 2 } else { 1 };
    let mut held = String::new();
    deck.push_str("*NODE, NSET=ALL\n");
    for i in 0..=columns {
        let sides: &[bool] =
            if i == cut && joint.is_of_two() { &[false, true] } else { &[i > cut] };
        for (j, k) in (0..=rows).flat_map(|j| (0..layers).map(move |k| (j, k))) {
            for &right in sides {
                let [x, y, z] = place(block, (i, j, k), case);
                let node = label(block, (i, j, k), right, joint);
                let _ = writeln!(deck, "{node}, {x:?}, {y:?}, {z:?}");
                if is_held(block, j) {
                    let _ = writeln!(held, "{node}");
                }
            }
        }
    }
    let _ = write!(deck, "*NSET, NSET=HELD{block}\n{held}");
}

/// Whether the nodes of a row of a block are held.
fn is_held(block: usize, row: usize) -> bool {
    row == if block == 0 { 0 } else { CELLS[block].1 }
}

/// Nodes, elements, surfaces and the joint of a block; nodes held in sets named by `block`.
fn write(deck: &mut String, block: usize, joint: Joint, case: Case) {
    let (columns, rows, cut) = CELLS[block];
    let layers = if case.in_space { 2 } else { 1 };
    let own = |at, right| label(block, at, right, joint);
    write_nodes(deck, block, joint, case);
    let kind = if case.in_space { "C3D8" } else { "CPE4" };
    let _ = writeln!(deck, "*ELEMENT, TYPE={kind}, ELSET=E{block}");
    let (mut surface, mut sides) = (String::new(), [String::new(), String::new()]);
    let (side, along) = if case.in_space { (2, [4, 6]) } else { (0, [2, 4]) };
    for (i, j) in (0..columns).flat_map(|i| (0..rows).map(move |j| (i, j))) {
        let number = 1000 * (block + 1) + 10 * i + j + 1;
        let corners = [(0, 0), (1, 0), (1, 1), (0, 1)];
        let _ = write!(deck, "{number}");
        for (k, (a, b)) in (0..layers).flat_map(|k| corners.map(move |own| (k, own))) {
            let _ = write!(deck, ", {}", own((i + a, j + b, k), i >= cut));
        }
        deck.push('\n');
        let contact = if block == 0 { rows - 1 } else { 0 };
        if j == contact {
            let _ = writeln!(surface, "{number}, S{}", side + if block == 0 { 3 } else { 1 });
        }
        if i + 1 == cut || i == cut {
            let right = usize::from(i == cut);
            let _ = writeln!(sides[right], "{number}, S{}", along[right]);
        }
    }
    let _ = write!(
        deck,
        "*SOLID SECTION, ELSET=E{block}, MATERIAL=M\n*SURFACE, NAME=S{block}\n{surface}"
    );
    join(deck, sides, block, joint, case);
}

/// The joint of a block, whose faces on both sides of the cut are listed.
fn join(deck: &mut String, sides: [String; 2], block: usize, joint: Joint, case: Case) {
    let (_, rows, cut) = CELLS[block];
    let layers = if case.in_space { 2 } else { 1 };
    // what is held cannot follow as well, but in *TIE
    let free = (0..=rows).filter(|&j| !is_held(block, j));
    let nodes = free.flat_map(|j| (0..layers).map(move |k| (cut, j, k)));
    let free = nodes.map(|at| [true, false].map(|right| label(block, at, right, joint)));
    match joint {
        Joint::Merged => {}
        Joint::Cut => {
            let [left, _] = sides;
            let _ = write!(
                deck,
                "*SURFACE, NAME=LEFT\n{left}*NODE\n9000, 0., 0.\n*BOUNDARY\n9000, 1\n\
                 *PRE-TENSION SECTION, SURFACE=LEFT, NODE=9000\n"
            );
        }
        Joint::Tie | Joint::TieOfNodes => {
            let by = if joint == Joint::Tie { "" } else { ", TYPE=NODE TO SURFACE" };
            let [left, right] = sides;
            let _ = write!(
                deck,
                "*SURFACE, NAME=LEFT\n{left}*SURFACE, NAME=RIGHT\n{right}*TIE, NAME=T{by}\nRIGHT, LEFT\n"
            );
        }
        Joint::Equation => {
            for ([one, other], dof) in free.flat_map(|own| [1, 2, 3].map(|dof| (own, dof))) {
                if dof < 3 || case.in_space {
                    let _ = writeln!(deck, "*EQUATION\n2\n{other}, {dof}, -2.5, {one}, {dof}, 2.5");
                }
            }
        }
        Joint::Mpc => free.for_each(|[one, other]| {
            let _ = writeln!(deck, "*MPC\nTIE, {one}, {other}");
        }),
    }
}

/// The upper block is pressed on the lower one, drawn along it and back.
fn solved(case: Case, joint: Joint) -> Forces {
    run(&deck(case, joint))
}

fn deck(case: Case, joint: Joint) -> String {
    let mut deck = String::from("*HEADING\nseams\n");
    for block in 0..2 {
        let is_cut = (block == 0) == case.cut_low;
        write(&mut deck, block, if is_cut { joint } else { Joint::Merged }, case);
    }
    let (axes, last) = match case.in_space {
        true => {
            let [a, b] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|e| turn(e, 0.8));
            let of = |v: [f64; 3]| format!("{:?}, {:?}, {:?}", v[0], v[1], v[2]);
            (format!("*TRANSFORM, NSET=ALL\n{}, {}\n", of(a), of(b)), 3)
        }
        false => (String::new(), 2),
    };
    let kind = if case.over_faces { "SURFACE" } else { "NODE" };
    let _ = write!(
        deck,
        "{axes}*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SURFACE INTERACTION, NAME=I\n{}*FRICTION, \
         ELASTIC SLIP=0.003\n0.4\n*CONTACT PAIR, INTERACTION=I, TYPE={kind} TO SURFACE\nS1, S0\n",
        case.law
    );
    for [x, y] in [[0.0, -0.05], [0.15, -0.05], [-0.1, -0.03]] {
        let _ = write!(
            deck,
            "*STEP, NLGEOM, INC=50\n*STATIC\n0.2, 1., 0.001, 0.2\n*CONTROLS, PARAMETERS=FIELD\n1e-10\n\
             *BOUNDARY\nHELD0, 1, {last}\nHELD1, 1, {last}\nHELD1, 1, 1, {x:?}\nHELD1, 2, 2, {y:?}\n\
             *END STEP\n"
        );
    }
    deck
}

fn run(deck: &str) -> Forces {
    let read = Job::read_text("seams", deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{:#?}\n{deck}", read.diagnostics));
    let mut forces = Forces::default();
    let ending = slideline::solve(&model, &SolveOptions::default(), &mut forces);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}\n{deck}");
    forces
}

/// Requirement: halves that *TIE, equations, *MPC or the cut of a pre-tension section join node by node press and rub as the whole, as slave and as master,
/// in the plane and in space, with hard and soft contact, at nodes and over faces. Two points of hard
/// contact at one place shared the force at will, and friction began anew at whichever took it; a master
/// in the plane was refused (SL0329), and in space its seam was an edge. Tolerance: what iterations leave.
#[test]
fn a_seam_is_no_edge() {
    let soft = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1e4\n";
    for law in ["", soft] {
        for k in 0..8 {
            let [in_space, over_faces, cut_low] = [k & 1, k & 2, k & 4].map(|bit| bit != 0);
            let case = Case { in_space, over_faces, cut_low, law };
            let whole = solved(case, Joint::Merged);
            let most = whole.all.iter().flatten().fold(0.0_f64, |most, f| most.max(f.abs()));
            for joint in JOINTS {
                let own = solved(case, joint);
                assert_eq!(own.rows, whole.rows, "{case:?} {joint:?}");
                assert_eq!(own.all.len(), whole.all.len(), "{case:?} {joint:?}");
                for (a, b) in own.all.iter().flatten().zip(whole.all.iter().flatten()) {
                    assert!((a - b).abs() < 1e-7 * most, "{case:?} {joint:?} {a} {b}");
                }
            }
        }
    }
}

/// Requirement: where the slaves are moved onto the master (`ADJUST`), the two nodes of a seam stay at one place,
/// and forces are those of the merged mesh. Tolerance: what iterations leave.
#[test]
fn a_seam_is_moved_as_one() {
    let law = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1e4\n";
    for [in_space, over_faces] in [[false, false], [false, true], [true, false], [true, true]] {
        let case = Case { in_space, over_faces, cut_low: false, law };
        let adjusted = |joint| {
            let text = deck(case, joint);
            run(&text.replacen(" TO SURFACE\nS1", " TO SURFACE, ADJUST=0.1\nS1", 1)).all
        };
        let whole = adjusted(Joint::Merged);
        let most = whole.iter().flatten().fold(0.0_f64, |most, f| most.max(f.abs()));
        for joint in [Joint::Tie, Joint::Equation, Joint::Cut] {
            let own = adjusted(joint);
            assert_eq!(own.len(), whole.len(), "{case:?} {joint:?}");
            for (a, b) in own.iter().flatten().zip(whole.iter().flatten()) {
                assert!((a - b).abs() < 1e-7 * most, "{case:?} {joint:?} {a} {b}");
            }
        }
    }
}

/// Requirement: halves that are tied and held by one rigid body across their seam move with it as the whole
/// does; such decks were refused (SL0316). Tolerance: what iterations leave.
#[test]
fn a_rigid_body_may_hold_both_sides_of_a_tie() {
    for (joint, over_faces) in [Joint::Tie, Joint::TieOfNodes].into_iter().zip([false, true]) {
        let case = Case { in_space: false, over_faces, cut_low: false, law: "" };
        let whole = solved(case, Joint::Merged).all;
        let body = "*NODE, NSET=REF\n9999, 0.3, 2.0\n*RIGID BODY, REF NODE=9999, TIE NSET=HELD1\n*MATERIAL";
        let held = deck(case, joint).replacen("*MATERIAL", body, 1);
        let held = held.replace("HELD1, 1, 2\n", "REF, 6, 6\n").replace("HELD1, ", "REF, ");
        let own = run(&held).all;
        let most = whole.iter().flatten().fold(0.0_f64, |most, f| most.max(f.abs()));
        assert_eq!(own.len(), whole.len(), "{joint:?}");
        for (a, b) in own.iter().flatten().zip(whole.iter().flatten()) {
            assert!((a - b).abs() < 1e-7 * most, "{joint:?} {a} {b}");
        }
    }
}

/// Requirement: where a rigid body holds all of both halves, a tie each way says nothing new, and a seam is none.
/// Neither node led the other, and the seam was an edge. Tolerance: what iterations leave.
#[test]
fn ties_of_two_ways_on_a_body_leave_one_node() {
    let solved = |cut_low: bool, joint: Joint| {
        let block = if cut_low { 0 } else { 1 };
        let body = format!(
            "*NODE, NSET=REF\n9999, 0.3, 2.0\n*RIGID BODY, REF NODE=9999, ELSET=E{block}\n*MATERIAL"
        );
        let case = Case { in_space: false, over_faces: false, cut_low, law: "" };
        let held = deck(case, joint).replacen("*MATERIAL", &body, 1);
        let held = held.replace("\nRIGHT, LEFT\n", "\nRIGHT, LEFT\nLEFT, RIGHT\n");
        let turn = "REF, 6, 6\n";
        run(&held
            .replace(&format!("HELD{block}, 1, 2\n"), &format!("REF, 1, 2\n{turn}"))
            .replace("HELD1, ", if cut_low { "HELD1, " } else { "REF, " }))
    };
    for cut_low in [false, true] {
        let whole = solved(cut_low, Joint::Merged);
        let own = solved(cut_low, Joint::Tie);
        let most = whole.all.iter().flatten().fold(0.0_f64, |most, f| most.max(f.abs()));
        assert_eq!(own.rows, whole.rows);
        for (a, b) in own.all.iter().flatten().zip(whole.all.iter().flatten()) {
            assert!((a - b).abs() < 1e-7 * most, "{cut_low} {a} {b}");
        }
    }
}

/// Requirement: the two ends of a face that follow one another stay two nodes of it, as slave and as master:
/// blocks with E = 1000 and nu = 0, pressed by d, carry N = E A d/2 all the same. The face was taken for one node,
/// and carried nothing or fell away. Tolerance: rounding.
#[test]
fn ends_of_a_face_that_move_alike_are_two_nodes() {
    let kinds = ["NODE", "SURFACE"];
    for (tied, kind) in ["12, 11", "4, 3"].into_iter().flat_map(|own| kinds.map(|kind| (own, kind)))
    {
        let deck = format!(
            "{}*MPC\nTIE, {tied}\n*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, TYPE={kind} TO \
             SURFACE\nUPPER, LOWER\n*STEP\n*STATIC\n1., 1.\n*BOUNDARY\nLOW, 1, 2\nHIGH, 1, 2\nHIGH, 2, 2, \
             -0.01\n*END STEP\n",
            mesh(false, 0.0)
        );
        let curve = pressed(&deck);
        assert_eq!(curve.contact.len(), 2, "{tied} {kind}");
        assert!((curve.force[0][1] - 5.0).abs() < 1e-9, "{tied} {kind} {:?}", curve.force);
    }
}

/// Requirement: faces that end at one place and are not joined there are no master: SL0329.
#[test]
fn pieces_that_only_touch_are_no_chain() {
    let deck = "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 1., 1.\n4, 0., 1.\n5, 1., 0.\n6, 2., 0.\n7, 2., 1.\n8, 1., 1.\n\
         11, 0.5, 1.\n12, 1.5, 1.\n13, 1.5, 2.\n14, 0.5, 2.\n*ELEMENT, TYPE=CPE4, ELSET=E\n1, 1, 2, 3, 4\n\
         2, 5, 6, 7, 8\n3, 11, 12, 13, 14\n*SOLID SECTION, ELSET=E, MATERIAL=M\n1.\n*MATERIAL, NAME=M\n\
         *ELASTIC\n1000., 0.3\n*SURFACE, NAME=TOP\n1, S3\n2, S3\n*SURFACE, NAME=FOOT\n3, S1\n\
         *SURFACE INTERACTION, NAME=I\n1.\n*CONTACT PAIR, INTERACTION=I\nFOOT, TOP\n*STEP\n*STATIC\n1., 1.\n\
         *BOUNDARY\n1, 1, 2\n2, 1, 2\n5, 1, 2\n6, 1, 2\n13, 1, 2\n14, 1, 2\n*END STEP\n";
    let read = Job::read_text("pieces", deck, &ReadOptions::default());
    assert!(read.model.is_none());
    assert!(read.diagnostics.iter().any(|own| own.code.0 == "SL0329"), "{:#?}", read.diagnostics);
}
