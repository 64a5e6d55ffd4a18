//! Equations, couplings and pinned bodies through decks: closed forms and balance.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use super::exactly;
use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::collections::HashMap;
use std::ops::ControlFlow;

/// Positions, displacements and reactions of all nodes at the end, by label.
#[derive(Default)]
struct End(HashMap<u64, [[f64; 3]; 3]>);

impl Observer for End {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let of_node = |node| {
                let motion = Dof::PLANE.map(|dof| frame.nodal.displacement(node, dof));
                let reaction = Dof::PLANE.map(|dof| frame.nodal.reaction(node, dof));
                let nodes = &frame.model.nodes;
                (nodes.label(node), [nodes.get(node).position, motion, reaction])
            };
            self.0 = (0..frame.model.nodes.len()).map(of_node).collect();
        }
        ControlFlow::Continue(())
    }
}

impl End {
    fn motion(&self, label: u64) -> [f64; 3] {
        self.0[&label][1]
    }

    fn reaction(&self, label: u64) -> [f64; 3] {
        self.0[&label][2]
    }

    /// Sum of reactions and of their moments about the origin, at displaced nodes.
    fn sum(&self) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for [at, motion, reaction] in self.0.values() {
            let (x, y) = (at[0] + motion[0], at[1] + motion[1]);
            sum[0] += reaction[0];
            sum[1] += reaction[1];
            sum[2] += reaction[2] + x * reaction[1] - y * reaction[0];
        }
        sum
    }
}

/// Two cantilevers of length 50 and bending stiffness 1000, side by side, tips 3 and 13.
fn run(constraint: &str, step: &str, history: &str) -> End {
    let deck = format!(
        "*NODE\n1, 0., 0.\n2, 25., 0.\n3, 50., 0.\n11, 0., 10.\n12, 25., 10.\n13, 50., 10.\n\
         *ELEMENT, TYPE=B23, ELSET=ARMS\n1, 1, 2\n2, 2, 3\n11, 11, 12\n12, 12, 13\n\
         *BEAM SECTION, SECTION=RECT, ELSET=ARMS, MATERIAL=M\n12., 1.\n*MATERIAL, NAME=M\n\
         *ELASTIC\n1000., 0.\n*SURFACE, NAME=TIPS, TYPE=NODE\n3\n13\n{constraint}*STEP{step}\n\
         *STATIC\n1., 1.\n*BOUNDARY\n1, 1, 6\n11, 1, 6\n{history}*END STEP\n"
    );
    exactly::solved::<End>(&deck).0
}

/// Requirement: tips with equal deflections share a force, P L^3/(3 EI)/2; with u_3 = -2 u_13 the
/// force goes over with the factor: u_13 = P/(k (1 + 4)). Small displacements, exact beams; 1e-9.
#[test]
fn equations_share_forces() {
    let (force, stiffness) = (0.01, 3.0 * 1000.0 / 125_000.0);
    let load = format!("*CLOAD\n13, 2, {force}\n");
    let equal = run("*EQUATION\n2\n3, 2, 1., 13, 2, -1.\n", "", &load);
    for node in [3, 13] {
        let expected = force / (2.0 * stiffness);
        assert!((equal.motion(node)[1] / expected - 1.0).abs() < 1e-9);
    }
    let opposed = run("*EQUATION\n2\n3, 2, 1., 13, 2, 2.\n", "", &load);
    let expected = force / (5.0 * stiffness);
    assert!((opposed.motion(13)[1] / expected - 1.0).abs() < 1e-9);
    assert!((opposed.motion(3)[1] / expected + 2.0).abs() < 1e-9);
    let tied = run("*MPC\nPIN, 3, 13\n", "", &load);
    assert!((tied.motion(3)[1] / equal.motion(3)[1] - 1.0).abs() < 1e-9);
}

const DISTRIBUTED: &str =
    "*NODE\n100, 60., 7.\n*COUPLING, REF NODE=100, SURFACE=TIPS\n*DISTRIBUTING\n1, 6\n";

/// Requirement: a distributing coupling makes the reference node follow the mean motion of the
/// nodes and spreads force and moment in balance, eq. (4.7); the same motion prescribed at the
/// reference node gives the same forces there. Small displacements; 1e-9.
#[test]
fn a_distributing_coupling_balances() {
    let loaded = run(DISTRIBUTED, "", "*CLOAD\n100, 1, 0.02\n100, 2, 0.01\n100, 6, 0.3\n");
    let [a, b, reference] = [3, 13, 100].map(|node| loaded.motion(node));
    // arms (0, -5) and (0, 5) from the centre (50, 5): theta = sum r x u / sum r.r
    let theta = (5.0 * a[0] - 5.0 * b[0]) / 50.0;
    let mean = [0, 1].map(|k| 0.5 * (a[k] + b[k]));
    let expected = [mean[0] - theta * 2.0, mean[1] + theta * 10.0, theta];
    for k in 0..3 {
        assert!((reference[k] - expected[k]).abs() < 1e-12, "{reference:?} {expected:?}");
    }
    // without NLGEOM forces balance at the undeformed shape
    let reaction = [1, 11].map(|node| loaded.reaction(node));
    let sum: [f64; 2] = std::array::from_fn(|k| reaction[0][k] + reaction[1][k]);
    assert!((sum[0] + 0.02).abs() < 1e-11 && (sum[1] + 0.01).abs() < 1e-11, "{sum:?}");
    let moment = reaction[0][2] + reaction[1][2] - 10.0 * reaction[1][0];
    let outside = 0.3 + 60.0 * 0.01 - 7.0 * 0.02;
    assert!((moment + outside).abs() < 1e-9, "{moment}");
    let [x, y, turn] = reference;
    let moved = format!("100, 1, 1, {x:?}\n100, 2, 2, {y:?}\n100, 6, 6, {turn:?}\n");
    let driven = run(DISTRIBUTED, "", &moved);
    for (own, expected) in driven.reaction(100).into_iter().zip([0.02, 0.01, 0.3]) {
        assert!((own - expected).abs() < 1e-9, "{own} {expected}");
    }
}

/// Requirement: bodies that turn far stay in balance, welded, pinned, of some dofs, and with a
/// rotation node; a pinned tip takes no moment: it turns otherwise than the body.
#[test]
fn bodies_balance() {
    let node = "*NODE\n100, 60., 7.\n200, 0., 0.\n";
    for (card, turn) in [
        ("*RIGID BODY, REF NODE=100, TIE NSET=TIPS\n", 100),
        ("*RIGID BODY, REF NODE=100, PIN NSET=TIPS\n", 100),
        ("*RIGID BODY, NSET=TIPS, REF NODE=100, ROT NODE=200\n", 200),
        ("*COUPLING, REF NODE=100, SURFACE=TIPS\n*KINEMATIC\n1, 2\n", 100),
    ] {
        let set = format!("{node}*NSET, NSET=TIPS\n3, 13\n{card}");
        let rotation = if turn == 200 { "200, 3, 3, 0.4\n200, 1, 2\n" } else { "100, 6, 6, 0.4\n" };
        let end = run(&set, ", NLGEOM, INC=1000", &format!("100, 2, 2, 8.\n{rotation}"));
        let scale = end.reaction(1)[0].abs();
        let pinned = !card.contains("TIE") && turn == 100;
        assert_eq!((end.motion(3)[2] - 0.4).abs() > 1e-3, pinned, "{card}");
        let mut sum = end.sum();
        if turn == 200 {
            sum[2] = 0.0; // the moment of the body is a force on the rotation node
        }
        for (k, left) in sum.into_iter().enumerate() {
            let size = if k == 2 { 60.0 * scale } else { scale };
            assert!(left.abs() < 1e-8 * size, "{card} {sum:?}");
        }
    }
}

/// A bolt of two halves along x, of length 20 and stiffness EA = 6000, held at both ends; its
/// section is cut in the middle, with the reference node 100.
fn bolt(parts: &str, held: &str, cut: &str, steps: &str) -> End {
    let deck = format!(
        "*NODE\n1, 0., 0.\n2, 10., 0.\n3, 20., 0.\n11, 0., 2.\n12, 10., 2.\n13, 20., 2.\n\
         100, 5., 5.\n{parts}*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n*PRE-TENSION SECTION, \
         NODE=100, {cut}\n*BOUNDARY\n{held}{steps}"
    );
    let read = Job::read_text("bolt", &deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    let mut end = End::default();
    let ending = solve(&model, &SolveOptions::default(), &mut end);
    assert!(matches!(ending, Ending::Completed(_)), "{deck}\n{ending:?}");
    end
}

/// Requirement: a load on the reference node is the tension of the bolt and shortens it by
/// F l/(EA); a length that is taken out pulls with EA/l times it; a length that is held adds what
/// the ends are moved by. By a surface of solids and at the end of a beam; closed form, 1e-9.
/// Source: docs/theory.md eq. (4.12).
#[test]
fn a_bolt_is_drawn_together() {
    let solids = "*ELEMENT, TYPE=CPS4, ELSET=E\n1, 1, 2, 12, 11\n2, 2, 3, 13, 12\n\
        *SOLID SECTION, ELSET=E, MATERIAL=M\n3.\n*SURFACE, NAME=CUT\n1, S2\n";
    let beams = "*ELEMENT, TYPE=B21, ELSET=E\n1, 1, 2\n2, 2, 3\n\
        *BEAM SECTION, SECTION=RECT, ELSET=E, MATERIAL=M\n3., 2.\n";
    let of_solids = (solids, "1, 1, 2\n11, 1\n3, 1\n13, 1\n", "SURFACE=CUT");
    let of_beams = (beams, "1, 1, 6\n3, 1\n", "ELEMENT=1");
    let step = |cards: &str| format!("*STEP\n*STATIC\n1., 1.\n{cards}*END STEP\n");
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-9 * b.abs(), "{a} {b}");
    for (parts, held, cut) in [of_solids, of_beams] {
        let pull = |end: &End| end.reaction(3)[0] + end.0.get(&13).map_or(0.0, |own| own[2][0]);
        let loaded = bolt(parts, held, cut, &step("*CLOAD\n100, 1, 12.\n"));
        near(pull(&loaded), 12.0);
        near(loaded.motion(100)[0], 12.0 * 20.0 / 6000.0);
        let shortened = bolt(parts, held, cut, &step("*BOUNDARY\n100, 1, 1, 0.01\n"));
        near(pull(&shortened), 3.0);
        near(shortened.reaction(100)[0], 3.0);
        let moved =
            "*BOUNDARY, FIXED\n100, 1\n*CLOAD, OP=NEW\n*BOUNDARY\n3, 1, 1, 0.02\n13, 1, 1, 0.02\n";
        let both = step("*CLOAD\n100, 1, 12.\n") + &step(moved);
        let kept = bolt(parts, held, cut, &both);
        near(pull(&kept), 12.0 + 6.0);
        near(kept.motion(100)[0], 12.0 * 20.0 / 6000.0);
    }
}

/// Requirement: nodes that a cut adds are as warm as those that they stand for: a bolt that is free to grow, its
/// section held at zero, grows by alpha T l without a force, with *TEMPERATURE and from *INITIAL CONDITIONS on.
/// Closed form, 1e-12.
#[test]
fn a_heated_bolt_grows_as_a_whole() {
    let law = "*MATERIAL, NAME=X\n*ELASTIC\n1000., 0.\n*EXPANSION\n1e-3\n*NSET, NSET=ALL\n1, 2, 3, 11, 12, 13\n";
    let solids = "*ELEMENT, TYPE=CPS4, ELSET=E\n1, 1, 2, 12, 11\n2, 2, 3, 13, 12\n\
        *SOLID SECTION, ELSET=E, MATERIAL=X\n3.\n*SURFACE, NAME=CUT\n1, S2\n";
    let beams = "*ELEMENT, TYPE=B21, ELSET=E\n1, 1, 2\n2, 2, 3\n\
        *BEAM SECTION, SECTION=RECT, ELSET=E, MATERIAL=X\n3., 2.\n";
    let of_solids = (solids, "1, 1, 2\n11, 1\n", "SURFACE=CUT");
    let of_beams = (beams, "1, 1, 6\n", "ELEMENT=1");
    for ((parts, held, cut), initial) in [(of_solids, false), (of_beams, false), (of_solids, true)]
    {
        let start = if initial { "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nALL, 7.\n" } else { "" };
        let parts = format!("{law}{parts}{start}");
        let step =
            "*STEP\n*STATIC\n1., 1.\n*BOUNDARY\n100, 1, 1\n*TEMPERATURE\nALL, 10.\n*END STEP\n";
        let end = bolt(&parts, held, cut, step);
        let grown = if initial { 20.0 * 1e-3 * 3.0 } else { 20.0 * 1e-3 * 10.0 };
        assert!((end.motion(3)[0] - grown).abs() < 1e-12, "{cut} {:?}", end.motion(3));
        assert!(end.reaction(100)[0].abs() < 1e-9, "{cut} {:?}", end.reaction(100));
    }
}

/// Requirement: the sides of a cut are one part and the cut is within it: neither general contact
/// nor a surface that stands for the outside makes contact of the one side with the other, which
/// move into one another as the bolt is drawn together.
#[test]
fn sides_of_a_cut_do_not_touch() {
    let parts = "*NODE\n21, 0., 9.\n22, 10., 9.\n31, 0., 11.\n32, 10., 11.\n*ELEMENT, TYPE=CPS4, \
        ELSET=E\n1, 1, 2, 12, 11\n2, 2, 3, 13, 12\n*ELEMENT, TYPE=CPS4, ELSET=OTHER\n\
        3, 21, 22, 32, 31\n*SOLID SECTION, ELSET=E, MATERIAL=M\n3.\n*SOLID SECTION, ELSET=OTHER, \
        MATERIAL=M\n3.\n*SURFACE, NAME=CUT\n1, S2\n*SURFACE, NAME=OUTSIDE\nE,\n";
    let held = "1, 1, 2\n11, 1\n3, 1\n13, 1\n21, 1, 2\n22, 1, 2\n";
    let general = "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n";
    let itself = "*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I\nOUTSIDE\n";
    for contact in [general, itself] {
        let parts = format!("{parts}{contact}");
        let step = "*STEP\n*STATIC\n1., 1.\n*CLOAD\n100, 1, 12.\n*END STEP\n";
        let end = bolt(&parts, held, "SURFACE=CUT", step);
        let pull = end.reaction(3)[0] + end.0[&13][2][0];
        assert!((pull - 12.0).abs() < 1e-9 * 12.0, "{contact}: {pull}");
        assert!((end.motion(100)[0] - 12.0 * 20.0 / 6000.0).abs() < 1e-12, "{contact}");
    }
}
