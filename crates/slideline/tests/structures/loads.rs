//! Pressures and forces per volume through decks: closed forms.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use super::exactly;
use slideline::model::Dof;
use slideline::observe::{Ending, Totals};
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::collections::HashMap;
use std::ops::ControlFlow;

#[derive(Default)]
struct End {
    motion: HashMap<u64, [f64; 2]>,
    reaction: HashMap<u64, [f64; 2]>,
    totals: Option<Totals>,
}

impl Observer for End {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            for node in 0..frame.model.nodes.len() {
                let label = frame.model.nodes.label(node);
                let of = |dof| frame.nodal.displacement(node, dof);
                self.motion.insert(label, [Dof::U1, Dof::U2].map(of));
                let of = |dof| frame.nodal.reaction(node, dof);
                self.reaction.insert(label, [Dof::U1, Dof::U2].map(of));
            }
        }
        ControlFlow::Continue(())
    }
}

/// A ring of radii 1 and 2 and height 1/2, eight elements CAX8 over the wall, E = 1000, nu = 0.25,
/// density 0.002, held along the axis; nodes 1 to 17 below, 21 to 29 in the middle, 31 to 47 above.
fn ring(history: &str) -> End {
    let mut deck = String::from("*NODE, NSET=ALL\n");
    for i in 0..17 {
        let r = 1.0 + f64::from(i) / 16.0;
        deck += &format!("{}, {r:?}, 0.0\n{}, {r:?}, 0.5\n", 1 + i, 31 + i);
        if i % 2 == 0 {
            deck += &format!("{}, {r:?}, 0.25\n", 21 + i / 2);
        }
    }
    deck += "*ELEMENT, TYPE=CAX8, ELSET=B\n";
    for e in 0..8 {
        let (first, middle) = (1 + 2 * e, 21 + e);
        let corners = [first, first + 2, first + 32, first + 30];
        let sides = [first + 1, middle + 1, first + 31, middle];
        let row: Vec<_> = corners.iter().chain(&sides).map(|node: &i32| node.to_string()).collect();
        deck += &format!("{}, {}\n", 1 + e, row.join(", "));
    }
    deck += &format!(
        "*ELSET, ELSET=INNER\n1,\n*SOLID SECTION, ELSET=B, MATERIAL=M\n*MATERIAL, NAME=M\n\
         *ELASTIC\n1000., 0.25\n*DENSITY\n0.002\n*STEP\n*STATIC\n1., 1.\n*BOUNDARY\n\
         ALL, 2\n{history}*END STEP\n"
    );
    solved(&deck)
}

/// A block of 2 by 1 in four elements, thickness 3, E = 1000, nu = 0.25, density 0.002, held along
/// its left and lower sides.
fn run(step: &str, history: &str) -> End {
    run_with("", step, history)
}

/// The same with further cards of the model.
fn run_with(cards: &str, step: &str, history: &str) -> End {
    let mut nodes = String::new();
    for j in 0..3 {
        for i in 0..3 {
            nodes += &format!("{}, {:?}, {:?}\n", 1 + i + 3 * j, f64::from(i), 0.5 * f64::from(j));
        }
    }
    let deck = format!(
        "*NODE\n{nodes}*ELEMENT, TYPE=CPE4, ELSET=B\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n3, 4, 5, 8, 7\n\
         4, 5, 6, 9, 8\n*ELSET, ELSET=R\n2, 4\n*ELSET, ELSET=T\n3, 4\n*SOLID SECTION, ELSET=B, \
         MATERIAL=M\n3.\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.25\n*DENSITY\n0.002\n\
         *SURFACE, NAME=RIGHT\nR, S2\n*SURFACE, NAME=OUTSIDE\nB,\n{cards}*STEP{step}\n*STATIC\n1., 1.\n\
         *BOUNDARY\n1, 1, 2\n4, 1\n7, 1\n2, 2\n3, 2\n{history}*END STEP\n"
    );
    solved(&deck)
}

fn solved(deck: &str) -> End {
    let (end, totals) = exactly::solved::<End>(deck);
    End { totals: Some(totals), ..end }
}

/// Requirement: a uniform pressure q on the right side, nu' = nu/(1 - nu), E' = E/(1 - nu^2): u1 =
/// -q L/E', u2 = nu' q H/E' everywhere (patch test), by faces, by surface and as a traction; the
/// reactions take q A. Small displacements; 1e-10.
#[test]
fn pressure_on_a_side() {
    let (modulus, poisson) = (1000.0 / (1.0 - 0.0625), 0.25 / 0.75);
    for load in [
        "*DLOAD\nR, P2, 5.\n",
        "*DSLOAD\nRIGHT, P, 5.\n",
        "*DSLOAD\nRIGHT, TRVEC, 5., -1., 0., 0.\n",
    ] {
        let end = run("", load);
        for (label, x, y) in [(9, 2.0, 1.0), (5, 1.0, 0.5)] {
            let [u, v] = end.motion[&label];
            assert!((u + 5.0 * x / modulus).abs() < 1e-10 * 5.0 / modulus * 100.0, "{u}");
            assert!((v - 5.0 * poisson * y / modulus).abs() < 1e-10, "{v}");
        }
        let sum: f64 = [1, 4, 7].map(|node| end.reaction[&node][0]).iter().sum();
        assert!((sum - 5.0 * 3.0).abs() < 1e-9, "{sum}");
    }
}

/// Requirement: a traction along a surface pulls where its direction points when laid onto it, with
/// its whole size. Source: Abaqus manual, `*DSLOAD` (TRSHR). Tolerance: rounding.
#[test]
fn traction_along_a_side() {
    let end = run("", "*DSLOAD\nRIGHT, TRSHR, 5., 7., 0.5, 0.\n");
    let across: f64 = [1, 2, 3].map(|node| end.reaction[&node][1]).iter().sum();
    let along: f64 = [1, 4, 7].map(|node| end.reaction[&node][0]).iter().sum();
    assert!((across + 5.0 * 3.0).abs() < 1e-9 && along.abs() < 1e-9, "{across} {along}");
}

/// Requirement: the direction of a traction may be given in axes of its own: along x of axes turned by a
/// right angle it pulls along y; along the radius of a cylinder about z its sums over the side x = 2, y = 0
/// to 1, thickness 3, are 6 asinh(1/2) and 3 (sqrt 5 - 2) times its size. Source: the integrals of
/// (x, y)/r. Tolerance: rounding; two points an edge, 1e-4.
#[test]
fn traction_in_axes_of_its_own() {
    let turned = "*ORIENTATION, NAME=O\n0., 1., 0., -1., 0., 0.\n";
    let load = "*DSLOAD, ORIENTATION=O\nRIGHT, TRVEC, 5., 1., 0., 0.\n";
    let sums = |end: &End| {
        let sum = |nodes: [u64; 3], k: usize| {
            nodes.map(|node| end.reaction[&node][k]).iter().sum::<f64>()
        };
        [sum([1, 4, 7], 0), sum([1, 2, 3], 1)]
    };
    let [x, y] = sums(&run_with(turned, "", load));
    assert!(x.abs() < 1e-9 && (y + 15.0).abs() < 1e-9, "{x} {y}");
    let round = "*ORIENTATION, NAME=O, SYSTEM=CYLINDRICAL\n0., 0., 0., 0., 0., 1.\n";
    let [x, y] = sums(&run_with(round, "", load));
    let expected = [-30.0 * 0.5_f64.asinh(), -15.0 * (5.0_f64.sqrt() - 2.0)];
    assert!((x / expected[0] - 1.0).abs() < 1e-4, "{x} {expected:?}");
    assert!((y / expected[1] - 1.0).abs() < 1e-4, "{y} {expected:?}");
}

/// Requirement: points weigh m g, and m omega^2 r about an axis, on their nodes, twice where two are at a node;
/// a part gives its points to its instances. Source: Newton. Tolerance: rounding.
#[test]
fn points_weigh() {
    let cards = "*ELEMENT, TYPE=MASS, ELSET=P\n11, 6\n12, 6\n*ELEMENT, TYPE=MASS, ELSET=Q\n13, 9\n\
        *MASS, ELSET=P\n0.25\n*MASS, ELSET=Q\n1.5\n";
    let down = |end: &End| [1, 2, 3].map(|node| end.reaction[&node][1]).iter().sum::<f64>();
    let own = 0.002 * 2.0 * 3.0;
    let whole = down(&run_with(cards, "", "*DLOAD\n, GRAV, 10., 0., -1., 0.\n"));
    assert!((whole - 10.0 * (own + 2.0)).abs() < 1e-9, "{whole}");
    let some = down(&run_with(cards, "", "*DLOAD\nQ, GRAV, 10., 0., -1., 0.\n"));
    assert!((some - 15.0).abs() < 1e-9, "{some}");
    // about an axis along z through (-1, 0): node 9 is at (2, 1)
    let turned = run_with(cards, "", "*DLOAD\nQ, CENTRIF, 4., -1., 0., 0., 0., 0., 1.\n");
    let across: f64 = [1, 4, 7].map(|node| turned.reaction[&node][0]).iter().sum();
    assert!((across + 1.5 * 4.0 * 3.0).abs() < 1e-9, "{across}");
    assert!((down(&turned) + 1.5 * 4.0).abs() < 1e-9, "{}", down(&turned));
}

/// Requirement: pressure that follows its faces converges quadratically at large strain, and on all
/// free sides of a body it leaves no resultant: reactions along a side are q times its current
/// length.
#[test]
fn pressure_follows_its_faces() {
    let end = run(", NLGEOM", "*DSLOAD\nOUTSIDE, P, 200.\n");
    let [_, v] = end.motion[&9];
    let sum: f64 = [1, 4, 7].map(|node| end.reaction[&node][0]).iter().sum();
    // the supports along x = 0 carry what the other sides press beyond their own face
    let own = end.motion[&7][1];
    assert!(v.abs() > 0.05, "far from small: {v}");
    assert!(sum.abs() < 1e-7 * 200.0, "faces on both sides balance: {sum} {own}");
    let iterations = end.totals.unwrap().iterations;
    assert!(iterations <= 7, "{iterations}");
}

/// Requirement: gravity and centrifugal forces have the resultants rho V g and rho V omega^2 times
/// the distance of the centre from the axis; a force per volume f V.
#[test]
fn forces_per_volume() {
    let volume = 2.0 * 1.0 * 3.0;
    let across = |end: &End| [1, 2, 3].map(|node| end.reaction[&node][1]).iter().sum::<f64>();
    let along = |end: &End| [1, 4, 7].map(|node| end.reaction[&node][0]).iter().sum::<f64>();
    let gravity = run("", "*DLOAD\n, GRAV, 9.81, 0., -2., 0.\n");
    assert!((across(&gravity) - 0.002 * volume * 9.81).abs() < 1e-12);
    let body = run("", "*DLOAD\nB, BX, 0.3\n");
    assert!((along(&body) + 0.3 * volume).abs() < 1e-12);
    let turning = run("", "*DLOAD\nB, CENTRIF, 7., -1., 0., 0., 0., 1., 0.\n");
    assert!((along(&turning) + 0.002 * volume * 7.0 * 2.0).abs() < 1e-12);
}

/// Requirement: loads on a ring act all round. Pressure inside: Lame's tube in plane strain, u = p
/// a^2 (1 + nu) ((1 - 2 nu) r + b^2/r) / (E (b^2 - a^2)), 1e-5 with eight quadratic elements over the
/// wall; the resultants of rotation, of weight and of a force per volume are rho omega^2 2 pi h
/// (b^3 - a^3)/3, rho g V and f V.
#[test]
fn loads_act_all_round_a_ring() {
    let pi = std::f64::consts::PI;
    let pressed = ring("*DLOAD\nINNER, P4, 6.\n");
    for (label, r) in [(1, 1.0), (9, 1.5), (17, 2.0)] {
        let exact = 6.0 * 1.25 * (0.5 * r + 4.0 / r) / (1000.0 * 3.0);
        let [u, _] = pressed.motion[&label];
        assert!((u - exact).abs() < 1e-5 * exact, "{label} {u} {exact}");
    }
    let volume = 3.0 * pi * 0.5;
    let sum = |end: &End, axis: usize| end.reaction.values().map(|r| r[axis]).sum::<f64>();
    let turning = ring("ALL, 1\n*DLOAD\nB, CENTRIF, 9., 0., 0., 0., 0., 1., 0.\n");
    let exact = 0.002 * 9.0 * 2.0 * pi * 0.5 * 7.0 / 3.0;
    assert!((sum(&turning, 0) + exact).abs() < 1e-10, "{} {exact}", sum(&turning, 0));
    let weight = ring("*DLOAD\nB, GRAV, 9.81, 0., -1., 0.\n");
    assert!((sum(&weight, 1) - 0.002 * 9.81 * volume).abs() < 1e-10);
    let body = ring("ALL, 1\n*DLOAD\nB, BX, 0.3\n");
    assert!((sum(&body, 0) + 0.3 * volume).abs() < 1e-10);
}

/// Requirement: nodes of a tie follow the master face that they lie on, and forces go through it in
/// balance of force and moment.
#[test]
fn a_tie_carries_forces() {
    let deck = include_str!("../../../../corpus/keywords/TIE.inp");
    let read = Job::read_text("tie", deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
    let mut end = End::default();
    let ending = solve(&model, &SolveOptions::default(), &mut end);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
    for (node, share) in [(2, 0.25), (3, 0.75)] {
        for k in 0..2 {
            let (lower, upper) = (end.motion[&11][k], end.motion[&14][k]);
            let expected = (1.0 - share) * lower + share * upper;
            assert!((end.motion[&node][k] - expected).abs() < 1e-14);
        }
    }
    let sum = [0, 1].map(|k| [12, 13].map(|node| end.reaction[&node][k]).iter().sum::<f64>());
    assert!((sum[0] - 0.2).abs() < 1e-6 && sum[1].abs() < 1e-6, "{sum:?}");
    let moment = |node: u64, at: [f64; 2], force: [f64; 2]| {
        let [u, v] = end.motion[&node];
        (at[0] + u) * force[1] - (at[1] + v) * force[0]
    };
    let supports =
        moment(12, [2.0, -0.5], end.reaction[&12]) + moment(13, [2.0, 1.5], end.reaction[&13]);
    let loads = moment(1, [0.0, 0.0], [-0.1, 0.0]) + moment(4, [0.0, 1.0], [-0.1, 0.0]);
    assert!((supports + loads).abs() < 1e-6, "{supports} {loads}");
}

/// Requirement: with NLGEOM what turns is pulled outwards where it is. A point m on a spring k at the
/// radius R moves by m omega^2 R/(k - m omega^2); of four elements the reactions along the radius
/// are omega^2 int rho r dV at the present places, by the shares of their nodes. Source: Newton,
/// docs/theory.md eq. (4.28). Tolerance: what iterations leave.
#[test]
fn what_turns_is_pulled_where_it_is() {
    let spring = "*NODE, NSET=ALL\n1, 1., 0.\n2, 2., 0.\n3, 2., 1.\n*ELEMENT, TYPE=SPRINGA, ELSET=S\n1, 1, 2\n\
        2, 1, 3\n*SPRING, ELSET=S\n\n100.\n*ELEMENT, TYPE=MASS, ELSET=P\n3, 2\n*MASS, ELSET=P\n3.\n\
        *BOUNDARY\n1, 1, 2\n3, 1, 2\n2, 2\n*STEP, NLGEOM\n*STATIC\n*DLOAD\n\
        P, CENTRIF, 4., 0., 0., 0., 0., 0., 1.\n*END STEP\n";
    let end = solved(spring);
    let [u, _] = end.motion[&2];
    assert!((u - 24.0 / 88.0).abs() < 1e-9, "{u}");
    let end = run(", NLGEOM", "*DLOAD\nB, CENTRIF, 9000., -1., 0., 0., 0., 1., 0.\n");
    // shares of corners, sides and the middle of four equal elements; the radius counts from x = -1
    let force: f64 = (0..9)
        .map(|k| {
            let share = [0.25, 0.5, 0.25][k % 3] * [0.25, 0.5, 0.25][k / 3];
            let [u, _] = end.motion[&(1 + k as u64)];
            share * (1.0 + (k % 3) as f64 + u)
        })
        .sum();
    let force = 9000.0 * 0.002 * 6.0 * force;
    let carried: f64 = [1, 4, 7].map(|node| end.reaction[&node][0]).iter().sum();
    assert!((carried + force).abs() < 1e-6 * force, "{carried} {force}");
    let at_rest = 9000.0 * 0.002 * 6.0 * 2.0;
    assert!(force > 1.01 * at_rest, "far from at rest: {force} {at_rest}");
    let iterations = end.totals.unwrap().iterations;
    assert!(iterations <= 7, "{iterations}");
}

/// Requirement: a tie holds where supports on both of its sides are let go together, or come later together: two
/// blocks that are tied node by node are one block. The dof that both had prescribed was left free. Tolerance: what
/// iterations leave.
#[test]
fn a_tie_holds_after_supports_on_both_sides() {
    let block = "*NODE\n1, 0., 0.\n2, 0.5, 0.\n3, 1., 0.\n11, 0., 1.\n12, 0.5, 1.\n13, 1., 1.\n\
                 111, 0., 2.\n112, 0.5, 2.\n113, 1., 2.\n";
    let upper = "*NODE\n101, 0., 1.\n102, 0.5, 1.\n103, 1., 1.\n";
    let rest = "*SOLID SECTION, ELSET=E, MATERIAL=M\n1.\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n\
                *NSET, NSET=BOT\n1, 2, 3\n*NSET, NSET=TOP\n111, 112, 113\n";
    let low = "*ELEMENT, TYPE=CPE4, ELSET=E\n1, 1, 2, 12, 11\n2, 2, 3, 13, 12\n";
    let whole = format!(
        "{block}{low}3, 11, 12, 112, 111\n4, 12, 13, 113, 112\n{rest}*NSET, NSET=LEFT\n11\n"
    );
    let tied = |kind: &str| {
        format!(
            "{block}{upper}{low}3, 101, 102, 112, 111\n4, 102, 103, 113, 112\n{rest}*NSET, NSET=LEFT\n\
             11, 101\n*SURFACE, NAME=S\n3, S1\n4, S1\n*SURFACE, NAME=M\n1, S3\n2, S3\n*TIE, NAME=T{kind}\nS, M\n"
        )
    };
    let held = "*STEP, NLGEOM\n*STATIC\n.5, 1.\n*BOUNDARY, OP=NEW\nBOT, 1, 2\nLEFT, 1, 1\nTOP, 2, 2, -0.05\n*END STEP\n";
    let free = "*STEP, NLGEOM\n*STATIC\n.25, 1.\n*BOUNDARY, OP=NEW\nBOT, 1, 2\nTOP, 1, 1, 0.1\nTOP, 2, 2, -0.05\n*END STEP\n";
    for steps in
        [format!("{held}{free}"), format!("{free}{held}"), format!("{held}{free}{held}{free}")]
    {
        let end = |model: &str| {
            let deck = format!("{model}{steps}");
            let read = Job::read_text("tie", &deck, &ReadOptions::default());
            let mut model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
            model.steps.iter_mut().for_each(|step| step.controls.field.r_n = 1e-12);
            let mut end = End::default();
            let ending = solve(&model, &SolveOptions::default(), &mut end);
            assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
            end
        };
        let exact = end(&whole);
        for kind in ["", ", TYPE=NODE TO SURFACE"] {
            let own = end(&tied(kind));
            for node in [1, 2, 3, 11, 12, 13, 111, 112, 113] {
                for k in 0..2 {
                    let (a, b) = (own.motion[&node][k], exact.motion[&node][k]);
                    assert!((a - b).abs() < 1e-10, "{kind} {node} {k} {a} {b}");
                    let (a, b) = (own.reaction[&node][k], exact.reaction[&node][k]);
                    assert!(node == 11 || (a - b).abs() < 1e-7, "{kind} {node} {k} {a} {b}");
                }
            }
        }
    }
}
