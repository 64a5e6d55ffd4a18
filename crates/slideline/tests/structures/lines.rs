//! Trusses, springs and rigid meshes through decks: closed forms.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::{Dialect, Dof};
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::collections::BTreeMap;
use std::ops::ControlFlow;

/// Displacements and reactions of all nodes at the end, by label.
#[derive(Default)]
struct End(BTreeMap<u64, [[f64; 6]; 2]>);

impl Observer for End {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            for node in 0..frame.model.nodes.len() {
                let motion = Dof::ALL.map(|dof| frame.nodal.displacement(node, dof));
                let reaction = Dof::ALL.map(|dof| frame.nodal.reaction(node, dof));
                self.0.insert(frame.model.nodes.label(node), [motion, reaction]);
            }
        }
        ControlFlow::Continue(())
    }
}

fn run(deck: &str) -> BTreeMap<u64, [[f64; 6]; 2]> {
    run_read(Job::read_text("lines", deck, &ReadOptions::default()), deck)
}

fn run_read(read: slideline::Read, deck: &str) -> BTreeMap<u64, [[f64; 6]; 2]> {
    let mut model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    for step in &mut model.steps {
        step.controls.field.r_n = 1e-11;
    }
    let mut end = End::default();
    let ending = solve(&model, &SolveOptions::default(), &mut end);
    assert!(matches!(ending, Ending::Completed(_)), "{deck}\n{ending:?}");
    end.0
}

/// Requirement: two bars that meet at a shallow angle are pushed through by the force
/// 2 A E ln(l/L) h/l^2 L of logarithmic strain, in the plane and in space, beyond the flat place
/// too. Source: closed form. 1e-10.
#[test]
fn a_shallow_pair_of_bars() {
    for (kind, dofs) in [("T2D2", "1, 2"), ("T3D2", "1, 3")] {
        let down = -1.5_f64;
        let deck = format!(
            "*NODE\n1, 0., 0.\n2, 10., 1.\n3, 20., 0.\n*ELEMENT, TYPE={kind}, ELSET=BARS\n1, 1, 2\n\
             2, 3, 2\n*SOLID SECTION, ELSET=BARS, MATERIAL=M\n2.\n*MATERIAL, NAME=M\n*ELASTIC\n\
             1000., 0.3\n*STEP, NLGEOM\n*STATIC\n0.1, 1.\n*BOUNDARY\n1, {dofs}\n3, {dofs}\n\
             2, 3, 3\n2, 1, 1\n2, 2, 2, {down}\n*END STEP\n"
        );
        let reaction = run(&deck)[&2][1][1];
        let (before, height) = (101.0_f64.sqrt(), 1.0 + down);
        let after = (100.0 + height * height).sqrt();
        let force = 2.0 * 2.0 * 1000.0 * (after / before).ln() * before / after * height / after;
        assert!((reaction - force).abs() < 1e-10 * force.abs(), "{kind}: {reaction} {force}");
    }
}

/// Requirement: quadratic bars in a row carry a force through their middle nodes: the
/// displacements of the closed form.
#[test]
fn a_row_of_quadratic_bars() {
    let end = run(
        "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 2., 0.\n4, 3., 0.\n5, 4., 0.\n*ELEMENT, TYPE=T2D3, ELSET=B\n\
         1, 1, 2, 3\n2, 3, 4, 5\n*SOLID SECTION, ELSET=B, MATERIAL=M\n2.\n*MATERIAL, NAME=M\n\
         *ELASTIC\n1000., 0.3\n*NSET, NSET=ALL, GENERATE\n1, 5\n*STEP\n*STATIC\n1., 1.\n*BOUNDARY\n\
         1, 1\nALL, 2\n*CLOAD\n5, 1, 10.\n*END STEP\n",
    );
    for node in 1..=5 {
        let expected = 10.0 / 2000.0 * (node - 1) as f64;
        assert!((end[&node][0][0] - expected).abs() < 1e-14);
    }
}

/// Requirement: a spring between two nodes takes the difference of their displacements, one with a
/// table the force of its line; in space a spring along its axis does what the plane's does.
#[test]
fn springs_between_nodes() {
    let end =
        run("*NODE\n1, 0., 0.\n2, 1., 0.\n3, 1., 0.\n*ELEMENT, TYPE=SPRING1, ELSET=GROUND\n1, 2\n\
         *SPRING, ELSET=GROUND\n1\n4.\n*ELEMENT, TYPE=SPRING2, ELSET=BETWEEN\n2, 2, 3\n\
         *SPRING, ELSET=BETWEEN, NONLINEAR\n1, 1\n-5., -2.\n-1., -1.\n0., 0.\n3., 1.\n\
         *STEP\n*STATIC\n1., 1.\n*BOUNDARY\n1, 1, 2\n2, 2\n3, 2\n*CLOAD\n3, 1, 3.\n*END STEP\n");
    // -3 in the spring between: -1 - 4 (d - 1) at d = 1.5 of node 3 against node 2
    assert!((end[&2][0][0] - 0.75).abs() < 1e-10, "{end:?}");
    assert!((end[&3][0][0] - 0.75 - 1.5).abs() < 1e-10, "{end:?}");
    let end = run("*NODE\n1, 0., 0., 0.\n2, 0., 3., 4.\n*ELEMENT, TYPE=T3D2, ELSET=B\n1, 1, 2\n\
         *SOLID SECTION, ELSET=B, MATERIAL=M\n1.\n*MATERIAL, NAME=M\n*ELASTIC\n1E-6, 0.\n\
         *ELEMENT, TYPE=SPRINGA, ELSET=A\n2, 1, 2\n*SPRING, ELSET=A\n\n10.\n*STEP, NLGEOM\n\
         *STATIC\n0.25, 1.\n*BOUNDARY\n1, 1, 3\n2, 1, 1\n2, 2, 2, 3.\n2, 3, 3, 4.\n*END STEP\n");
    assert!((end[&2][1][1] - 30.0).abs() < 1e-4 && (end[&2][1][2] - 40.0).abs() < 1e-4, "{end:?}");
}

/// Requirement: a rigid mesh of R3D4 moves as one body with its reference node, and carries what
/// hangs on its nodes: a quarter turn about the reference node. Masses beside it change nothing.
#[test]
fn a_rigid_mesh_turns() {
    let end = run(
        "*NODE\n1, 1., 0., 0.\n2, 2., 0., 0.\n3, 2., 1., 0.\n4, 1., 1., 0.\n5, 2., 0., 1.\n9, 0., 0., 0.\n\
         *ELEMENT, TYPE=R3D4, ELSET=PLATE\n1, 1, 2, 3, 4\n*ELEMENT, TYPE=MASS, ELSET=HEAVY\n7, 9\n\
         *RIGID BODY, REF NODE=9, ELSET=PLATE\n*ELEMENT, TYPE=T3D2, ELSET=BAR\n2, 2, 5\n\
         *SOLID SECTION, ELSET=BAR, MATERIAL=M\n0.5\n*MATERIAL, NAME=M\n*ELASTIC\n100., 0.\n\
         *STEP, NLGEOM\n*STATIC\n0.2, 1.\n*BOUNDARY\n9, 1, 5\n9, 6, 6, 1.5707963267948966\n5, 1, 3\n\
         *END STEP\n",
    );
    let moved = end[&3][0];
    assert!((moved[0] + 3.0).abs() < 1e-12 && (moved[1] - 1.0).abs() < 1e-12, "{moved:?}");
    // the bar to (2, 0, 1) from (0, 2, 0): length 3
    let force = 0.5 * 100.0 * 3.0_f64.ln() / 3.0;
    let reaction = end[&5][1];
    for (k, way) in [2.0, -2.0, 1.0].into_iter().enumerate() {
        assert!((reaction[k] - force * way / 3.0).abs() < 1e-9, "{reaction:?} {force}");
    }
}

/// Requirement: tips of cantilevers of every section bend as P L^3/(3 E I) says, with the second
/// moments of area of the closed forms; a general section has its own moduli.
#[test]
fn cantilevers_of_all_sections() {
    let pi = std::f64::consts::PI;
    let beam = |data: &str| format!("*BEAM SECTION, SECTION={data}, ELSET=B, MATERIAL=M\n");
    let lines = |kind: &str, sizes: &str| beam(kind) + sizes + "\n";
    // flange and web, each of area 4 and 1.25 from the centroid
    let tee = 4.0 / 12.0 + 64.0 / 12.0 + 2.0 * 4.0 * 1.25 * 1.25;
    let sections = [
        (lines("RECT", "3., 2."), 2.0),
        (lines("CIRC", "1.5"), pi * 1.5_f64.powi(4) / 4.0),
        (lines("PIPE", "1.5, 0.5"), pi * (1.5_f64.powi(4) - 1.0) / 4.0),
        (lines("BOX", "4., 6., .5, 1., .5, 1."), (4.0 * 216.0 - 3.0 * 64.0) / 12.0),
        (lines("I", "3.25, 5., 0., 4., 0., 1., 1."), tee),
        ("*BEAM GENERAL SECTION, ELSET=B\n4., 5., 0., 6., 7.\n\n1000., 400.\n".to_owned(), 5.0),
    ];
    for (card, second_moment) in sections {
        let end = run(&format!(
            "*NODE\n1, 0., 0.\n2, 40., 0.\n3, 80., 0.\n*ELEMENT, TYPE=B23, ELSET=B\n1, 1, 2\n\
             2, 2, 3\n{card}*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*STEP\n*STATIC\n1., 1.\n\
             *BOUNDARY\n1, 1, 6\n*CLOAD\n3, 2, 0.01\n*END STEP\n"
        ));
        let expected = 0.01 * 80.0_f64.powi(3) / (3.0 * 1000.0 * second_moment);
        let moved = end[&3][0][1];
        assert!((moved - expected).abs() < 1e-9 * expected, "{card}: {moved} {expected}");
    }
}

/// A node on bars along the axes, EA/L = 50 each, that a force along (0.6, 0.8) draws against a gap.
fn gap_on_bars(in_space: bool, gap: &str, force: f64) -> String {
    let (bar, third) = match in_space {
        true => ("T3D2", "13, 2\n"),
        false => ("T2D2", ""),
    };
    let third = if third.is_empty() { String::new() } else { format!("6, {third}") };
    format!(
        "*NODE\n2, 6., 8., 0.\n3, 9., 12., 0.\n11, -4., 8., 0.\n12, 6., -2., 0.\n13, 6., 8., -10.\n\
         *NSET, NSET=HELD\n3, 11, 12, 13\n*ELEMENT, TYPE={bar}, ELSET=BARS\n4, 11, 2\n5, 12, 2\n\
         {third}*SOLID SECTION, ELSET=BARS, MATERIAL=M\n0.5\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n\
         *ELEMENT, TYPE=GAPUNI, ELSET=GAP\n7, 2, 3\n*GAP, ELSET=GAP\n{gap}\n*STEP\n*STATIC\n\
         0.25, 1.\n*BOUNDARY\nHELD, 1, {}\n*CLOAD\n2, 1, {}\n2, 2, {}\n*END STEP\n",
        if in_space { 3 } else { 2 },
        0.6 * force,
        0.8 * force
    )
}

/// Requirement: a gap between two nodes leaves them alone until it closes, then it carries its
/// stiffness times what is beyond; direction given with any length, or taken from the nodes;
/// overclosed at the start; with the stiffness of its card and with a thousand times that of the
/// bars. Closed form (F + K d)/(k + K).
#[test]
fn a_gap_closes() {
    for in_space in [false, true] {
        let cases = [
            ("0.3, 3., 4., 0., , 200.", 10.0, 10.0 / 50.0),
            ("0.3, 3., 4., 0., , 200.", 20.0, (20.0 + 200.0 * 0.3) / 250.0),
            ("0.3, , , , , 200.", 20.0, (20.0 + 200.0 * 0.3) / 250.0),
            ("-0.1, 0.6, 0.8, , , 200.", 0.0, -200.0 * 0.1 / 250.0),
            ("0.3, 0.6, 0.8", 20.0, (20.0 + 50e3 * 0.3) / 50.05e3),
        ];
        for (gap, force, along) in cases {
            let end = run(&gap_on_bars(in_space, gap, force));
            let [x, y, ..] = end[&2][0];
            let off = (x - 0.6 * along).hypot(y - 0.8 * along);
            assert!(off < 1e-11, "{gap} {force}: {x} {y} {along}");
        }
    }
}

/// Requirement: round gaps stop a node that leaves the tube or the ball about another, or that comes
/// too near to one outside, wherever on them, and carry their stiffness times what is beyond; along
/// its axis a tube is open. Closed form (F + K d)/(k + K) along the force.
/// Source: Abaqus, gap contact elements GAPCYL and GAPSPHER.
#[test]
fn round_gaps_close() {
    let free = 10.0 / 50.0;
    let stopped = |way: f64| (20.0 + 200.0 * way) / 250.0;
    let (same, apart) = ("3, 6., 8., 0.", "3, 9., 12., 0.");
    let cases = [
        ("GAPSPHER", true, same, "0.3, , , , , 200.", 10.0, free),
        ("GAPSPHER", true, same, "0.3, , , , , 200.", 20.0, stopped(0.3)),
        ("GAPSPHER", false, same, "0.3, , , , , 200.", 20.0, stopped(0.3)),
        ("GAPSPHER", true, apart, "-4.8, , , , , 200.", 10.0, 10.0 / 50.0),
        ("GAPSPHER", true, apart, "-4.8, , , , , 200.", 20.0, stopped(0.2)),
        ("GAPCYL", true, same, "0.3, 0., 0., 2., , 200.", 20.0, stopped(0.3)),
        ("GAPCYL", false, same, "0.3, 0., 0., 1., , 200.", 20.0, stopped(0.3)),
        ("GAPCYL", true, apart, "-4.8, 0., 0., 1., , 200.", 20.0, stopped(0.2)),
        ("GAPCYL", true, same, "0.3, 3., 4., 0., , 200.", 20.0, 20.0 / 50.0),
        ("GAPCYL", true, same, "0.3, 0., 0., 1.", 20.0, (20.0 + 50e3 * 0.3) / 50.05e3),
    ];
    for (kind, in_space, centre, gap, force, along) in cases {
        for nlgeom in ["*STEP\n", "*STEP, NLGEOM\n"] {
            let deck = gap_on_bars(in_space, gap, force)
                .replace("TYPE=GAPUNI", &format!("TYPE={kind}"))
                .replace("3, 9., 12., 0.", centre)
                .replace("*STEP\n", nlgeom);
            let [x, y, ..] = run(&deck)[&2][0];
            let off = (x - 0.6 * along).hypot(y - 0.8 * along);
            // bars that turn and stretch are a little stiffer and softer than k
            let close = if nlgeom.contains("NLGEOM") { 0.05 * along } else { 1e-9 };
            assert!(off < close, "{kind} {gap} {force}: {x} {y}, not {along}");
        }
    }
}

/// Requirement: in the dialect of CalculiX a gap follows its law k h (1/2 + atan(h/e)/pi), with
/// e = pi s/k, open and closed. Closed form: bisection of the balance of the node.
#[test]
fn a_gap_in_the_dialect_of_calculix() {
    for force in [10.0_f64, 20.0] {
        let deck = gap_on_bars(true, "0.3, 0.6, 0.8, 0., , 200., 0.5", force);
        let options = ReadOptions { dialect: Some(Dialect::Calculix), ..ReadOptions::default() };
        let end = run_read(Job::read_text("gap", &deck, &options), &deck);
        let residual = |u: f64| {
            let (h, e) = (u - 0.3, std::f64::consts::PI * 0.5 / 200.0);
            50.0 * u + 200.0 * h * (0.5 + (h / e).atan() / std::f64::consts::PI) - force
        };
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            *(if residual(middle) > 0.0 { &mut high } else { &mut low }) = middle;
        }
        let [x, y, ..] = end[&2][0];
        assert!((0.6 * x + 0.8 * y - low).abs() < 1e-10, "{force}: {x} {y} {low}");
    }
}

/// Requirement: a gap that cannot be read is told of with its reason: no direction, no stiffness to
/// go by, a direction that leaves the plane, a stiffness below zero, elements of another type.
#[test]
fn gaps_that_cannot_be() {
    let deck = gap_on_bars(false, "0.3, 3., 4., 0., , 200.", 1.0);
    let cases = [
        ("0.3, 3., 4., 0., , 200.", "0.3, 0., 0., 1.", "leaves the plane"),
        ("0.3, 3., 4., 0., , 200.", "0.3, 3., 4., 0., , -2.", "must be positive"),
        ("*GAP, ELSET=GAP", "*GAP, ELSET=BARS", "which is not a gap"),
        ("9., 12., 0.\n", "6., 8., 0.\n", "has no direction"),
    ];
    for (old, new, words) in cases {
        let deck = deck.replace(
            "3., 4., 0., , 200.",
            if words == "has no direction" { "" } else { "3., 4., 0., , 200." },
        );
        let read = Job::read_text("gap", &deck.replace(old, new), &ReadOptions::default());
        let said = format!("{:?}", read.diagnostics);
        assert!(said.contains(words), "{words}: {said}");
    }
    let round = gap_on_bars(true, "0.3, , , , , 200.", 1.0).replace("GAPUNI", "GAPCYL");
    for (old, new, words) in [
        ("GAPCYL", "GAPCYL", "the axis of the gap is missing"),
        ("0.3, , , ,", "0., 0., 0., 1.,", "is a distance"),
        ("9., 12., 0.\n", "6., 8., 0.\n", "has no direction"),
    ] {
        let axis = if words.contains("axis") { ", , ," } else { ", 0., 0., 1.," };
        let outside = if words.contains("direction") { "-0.3" } else { "0.3" };
        let deck = round.replace(old, new).replace("0.3, , , ,", &format!("{outside}{axis}"));
        let read = Job::read_text("gap", &deck, &ReadOptions::default());
        let said = format!("{:?}", read.diagnostics);
        assert!(said.contains(words), "{words}: {said}");
    }
    let bare = "*NODE\n1, 0., 0.\n2, 1., 0.\n*ELEMENT, TYPE=GAPUNI, ELSET=GAP\n1, 1, 2\n*GAP, ELSET=GAP\n\
                0.1\n*STEP\n*STATIC\n1., 1.\n*BOUNDARY\n1, 1, 2\n2, 1, 2\n*END STEP\n";
    let read = Job::read_text("gap", bare, &ReadOptions::default());
    assert!(format!("{:?}", read.diagnostics).contains("stiffness of the gap is missing"));
}

/// Requirement: springs and gaps alone move in space where they leave the plane: by their nodes, by
/// the dof that they resist, by their direction. Source: closed forms. 1e-9.
#[test]
fn springs_and_gaps_alone_in_space() {
    // three springs along the edges of a corner, pressed inwards along its diagonal
    let corner = "*NODE\n1, 1., 0., 0.\n2, 0., 1., 0.\n3, 0., 0., 1.\n4, 0., 0., 0.\n*ELEMENT, \
                  TYPE=SPRINGA, ELSET=S\n1, 1, 4\n2, 2, 4\n3, 3, 4\n*SPRING, ELSET=S\n\n100.\n\
                  *STEP\n*STATIC\n1., 1.\n*BOUNDARY\n1, 1, 3\n2, 1, 3\n3, 1, 3\n*CLOAD\n4, 1, 1.\n\
                  4, 2, 2.\n4, 3, 3.\n*END STEP\n";
    let moved = run(corner)[&4][0];
    for (axis, u) in moved.iter().take(3).enumerate() {
        assert!((u - 0.01 * (axis + 1) as f64).abs() < 1e-9, "{moved:?}");
    }
    // along axis 3 and about axis 1, all nodes in the plane
    let kinds = |dof: u32| {
        format!(
            "*NODE\n1, 0., 0.\n2, 1., 0.\n*ELEMENT, TYPE=SPRING1, ELSET=G\n1, 1\n*ELEMENT, \
             TYPE=SPRING2, ELSET=S\n2, 1, 2\n*SPRING, ELSET=G\n{dof}\n50.\n*SPRING, ELSET=S\n{dof}, \
             {dof}\n100.\n*STEP\n*STATIC\n1., 1.\n*CLOAD\n2, {dof}, 2.\n*END STEP\n"
        )
    };
    for dof in [3, 4] {
        let end = run(&kinds(dof));
        let [u1, u2] = [1, 2].map(|node| end[&node][0][dof as usize - 1]);
        assert!((u1 - 0.04).abs() < 1e-9 && (u2 - 0.06).abs() < 1e-9, "{dof}: {u1} {u2}");
    }
    // a gap along axis 3, its nodes in one place, and a mass and a damper beside it
    let gap = "*NODE\n1, 0., 0., 2.\n2, 0., 0., 2.\n*ELEMENT, TYPE=GAPUNI, ELSET=G\n1, 1, 2\n\
               *ELEMENT, TYPE=DASHPOTA, ELSET=D\n2, 1, 2\n*GAP, ELSET=G\n.1, 0., 0., 1., , 1000.\n\
               *STEP\n*STATIC\n1., 1.\n*BOUNDARY\n1, 1, 6\n2, 1, 2\n2, 3, 3, -.2\n*END STEP\n";
    let force = run(gap)[&2][1][2];
    assert!((force + 100.0).abs() < 1e-9, "{force}");
}

/// Requirement: springs whose nodes lie in a plane z = constant stay a plane model, and so do
/// tables of springs whatever their forces.
#[test]
fn springs_in_a_plane_stay_there() {
    let deck = "*NODE\n1, 0., 0., 1.\n2, 1., 0., 1.\n*ELEMENT, TYPE=SPRINGA, ELSET=S\n1, 1, 2\n\
                *SPRING, ELSET=S, NONLINEAR\n\n3., 0.\n4., 1.\n*STEP\n*STATIC\n1., 1.\n*BOUNDARY\n\
                1, 1, 2\n2, 1, 2\n*END STEP\n";
    let read = Job::read_text("plane", deck, &ReadOptions::default());
    assert!(!read.model.unwrap_or_else(|| panic!("{:?}", read.diagnostics)).is_in_space());
}
