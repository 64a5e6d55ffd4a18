//! Beams and trusses in space as slaves: at their nodes against analytical surfaces, meshed rigid faces and
//! faces of solids.
//!
//! ```text
//!        .---.  |         .-o-o-.
//!       |     | |       o/       \o     a belt on a drum: T2/T1 = exp(mu phi); wound as a helix,
//!        '---'  |   T1 |           | T2  exp(mu phi cos alpha)
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::space_decks::turn;
use slideline::model::Dof;
use slideline::observe::{Ending, Event, Observer, Stop};
use slideline::{Job, ReadOptions, SolveOptions, TangentCheck, solve};
use std::f64::consts::PI;
use std::fmt::Write as _;
use std::ops::ControlFlow;

type Vector = [f64; 3];

/// Reactions at a node over the increments.
struct Watch {
    node: u64,
    forces: Vec<Vector>,
    imbalance: f64,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let node = frame.model.nodes.find(self.node).unwrap();
            let axes = [Dof::U1, Dof::U2, Dof::U3];
            self.forces.push(axes.map(|dof| frame.nodal.reaction(node, dof)));
            for pair in frame.pairs {
                let own = pair.force_imbalance.max(pair.moment_imbalance);
                self.imbalance = self.imbalance.max(own);
            }
        }
        ControlFlow::Continue(())
    }
}

fn run(deck: &str, node: u64, options: &SolveOptions) -> Watch {
    let read = Job::read_text("deck", deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
    let mut watch = Watch { node, forces: Vec::new(), imbalance: 0.0 };
    let ending = solve(&model, options, &mut watch);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
    watch
}

/// What the beam of the paper's first problem meets.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Circle {
    /// In the plane, an analytical surface.
    Plane,
    /// In space, drawn along its axis.
    Cylinder,
    /// In space, turned about the y-axis.
    Ball,
    /// In space, rigid quadrilaterals.
    Mesh,
}

/// The paper's first problem, N and mm, turned in space; the circle of radius 9 meets the line of nodes.
fn push(circle: Circle, mu: f64, angle: f64, (elements, increments): (usize, usize)) -> String {
    let place = |x: Vector| turn(x, angle);
    let text = |x: Vector| {
        let [x, y, z] = place(x);
        format!("{x:?}, {y:?}, {z:?}")
    };
    let plane = circle == Circle::Plane;
    let mut deck = String::from("*HEADING\nA circle on a beam\n*NODE\n");
    for k in 0..=elements {
        let t = k as f64 / elements as f64;
        let _ = writeln!(deck, "{}, {}", k + 1, text([7.0 + 2.222 * t, 50.0 * t, 0.0]));
    }
    let _ = writeln!(deck, "99999, {}", text([0.0, 45.0, 0.0]));
    let kind = if plane { "B21" } else { "B31" };
    let _ = writeln!(deck, "*ELEMENT, TYPE={kind}, ELSET=BEAM");
    (1..=elements).for_each(|k| writeln!(deck, "{k}, {k}, {}", k + 1).unwrap());
    let [nx, ny, nz] = place([0.0, 0.0, -1.0]);
    let shear = 0.85 * 3450.0 * 37.5;
    let _ = writeln!(
        deck,
        "*BEAM SECTION, SECTION=RECT, ELSET=BEAM, MATERIAL=M\n25.0, 1.5\n{nx:?}, {ny:?}, {nz:?}\n\
         *TRANSVERSE SHEAR STIFFNESS\n{shear:?}, {shear:?}, 0.0\n*MATERIAL, NAME=M\n*ELASTIC\n6900.0, 0.0"
    );
    surface(circle, &mut deck, &text);
    let still = if plane { "99999, 6, 6" } else { "99999, 4, 6" };
    let [dx, dy, dz] = place([0.0, -30.0, 0.0]);
    let across = if plane { String::new() } else { format!("99999, 3, 3, {dz:?}\n") };
    let step = 1.0 / increments as f64;
    let _ = write!(
        deck,
        "*SURFACE, NAME=LINE\nBEAM,{}\n*SURFACE INTERACTION, NAME=I\n25.0\n*FRICTION\n{mu:?}\n\
         *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n1.0E-2, 5.0\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nLINE, CIRCLE\n*BOUNDARY\n1, 1, 6\n\
         *STEP, NLGEOM, INC=1000\n*STATIC\n{step:?}, 1.0, 1.0E-6, {step:?}\n*BOUNDARY\n{still}\n\
         99999, 1, 1, {dx:?}\n99999, 2, 2, {dy:?}\n{across}*CONTROLS, PARAMETERS=FIELD\n1.0E-9\n\
         *END STEP\n",
        if plane { " SPOS" } else { "" },
    );
    deck
}

/// The surface CIRCLE on the body of node 99999.
fn surface(circle: Circle, deck: &mut String, text: &dyn Fn(Vector) -> String) {
    let at = |degrees: f64, z: f64| {
        let (s, c) = degrees.to_radians().sin_cos();
        text([9.0 * c, 45.0 + 9.0 * s, z])
    };
    let profile = "START, 0.0, 9.0\nCIRCL, 9.0, 0.0, 0.0, 0.0\nCIRCL, 0.0, -9.0, 0.0, 0.0\n";
    let _ = match circle {
        Circle::Plane => write!(
            deck,
            "*SURFACE, NAME=CIRCLE, TYPE=SEGMENTS\nSTART, 0.0, 54.0\nCIRCL, 9.0, 45.0, 0.0, 45.0\n\
             CIRCL, 0.0, 36.0, 0.0, 45.0\n"
        ),
        Circle::Cylinder => write!(
            deck,
            "*SURFACE, NAME=CIRCLE, TYPE=CYLINDER\n{}, {}\n{}\n{profile}",
            text([0.0, 45.0, 0.0]),
            text([1.0, 45.0, 0.0]),
            text([0.0, 45.0, -1.0])
        ),
        Circle::Ball => write!(
            deck,
            "*SURFACE, NAME=CIRCLE, TYPE=REVOLUTION\n{}, {}\n{profile}",
            text([0.0, 45.0, 0.0]),
            text([0.0, 46.0, 0.0])
        ),
        Circle::Mesh => {
            deck.push_str("*NODE\n");
            let count = 180;
            for k in 0..=count {
                let degrees = 45.0 - 100.0 * k as f64 / count as f64;
                let _ = writeln!(deck, "{}, {}", 10001 + k, at(degrees, -2.0));
                let _ = writeln!(deck, "{}, {}", 20001 + k, at(degrees, 2.0));
            }
            deck.push_str("*ELEMENT, TYPE=R3D4, ELSET=DISC\n");
            for k in 0..count {
                let [a, b] = [10001 + k, 10002 + k];
                let _ = writeln!(deck, "{a}, {a}, {b}, {}, {}", b + 10000, a + 10000);
            }
            write!(deck, "*RIGID BODY, REF NODE=99999, ELSET=DISC\n*SURFACE, NAME=CIRCLE\nDISC,\n")
        }
    };
    if circle != Circle::Mesh {
        deck.push_str("*RIGID BODY, REF NODE=99999, ANALYTICAL SURFACE=CIRCLE\n");
    }
}

/// Root of the mean square of what forces are off, over the peak.
fn off(forces: &[Vector], exact: &[Vector], angle: f64) -> f64 {
    assert_eq!(forces.len(), exact.len());
    let size = |v: Vector| v.iter().map(|x| x * x).sum::<f64>();
    let peak = exact.iter().map(|&f| size(f)).fold(0.0, f64::max);
    let apart = forces.iter().zip(exact).map(|(&own, &exact)| {
        let exact = turn(exact, angle);
        size(std::array::from_fn(|k| own[k] - exact[k]))
    });
    (apart.sum::<f64>() / exact.len() as f64 / peak).sqrt()
}

/// Requirement: a beam in space that moves in a plane, however that is turned, has the forces of B21:
/// on a cylinder, on a ball that it meets at its middle, and on a fine mesh. Tolerance: that
/// of the equilibrium; the smoothed faces of the mesh differ a little from the circle.
#[test]
fn a_beam_in_space_is_the_beam_of_the_plane() {
    for mu in [0.0, 0.3] {
        let options = SolveOptions::default();
        let plane = run(&push(Circle::Plane, mu, 0.0, (24, 20)), 99999, &options).forces;
        for (circle, limit) in
            [(Circle::Cylinder, 1e-9), (Circle::Ball, 1e-9), (Circle::Mesh, 1e-6)]
        {
            for angle in [0.0, 0.9] {
                let own = run(&push(circle, mu, angle, (24, 20)), 99999, &options);
                let apart = off(&own.forces, &plane, angle);
                assert!(apart < limit, "{circle:?} {mu} {angle}: {apart}");
                assert!(own.imbalance < 1e-9, "{circle:?} {mu}: {}", own.imbalance);
            }
        }
    }
}

/// Requirement: tangents are the derivatives of the forces. Source: differences in every iteration.
#[test]
fn tangents_are_those_of_the_forces() {
    let options = SolveOptions { check_tangent: TangentCheck::Every, ..SolveOptions::default() };
    for circle in [Circle::Cylinder, Circle::Ball] {
        run(&push(circle, 0.3, 0.9, (8, 20)), 99999, &options);
    }
}

/// A belt of n trusses on a drum of radius 1 over the angle phi, rising by `pitch` a radian, under unit
/// tension at its first node, held at its last one; the drum slides under it along the belt.
fn belt(n: usize, phi: f64, pitch: f64, mu: f64) -> String {
    let each = phi / n as f64;
    let at = |j: f64| {
        let angle = (j + 0.5) * each;
        [angle.cos(), angle.sin(), pitch * (j + 0.5) * each]
    };
    let mut deck = String::from("*HEADING\nbelt\n*NODE\n999, 0.0, 0.0, 0.0\n");
    for j in 0..=n {
        let [x, y, z] = at(j as f64);
        let _ = writeln!(deck, "{}, {x:?}, {y:?}, {z:?}", j + 1);
    }
    let (before, first) = (at(-1.0), at(0.0));
    let way: Vector = std::array::from_fn(|k| before[k] - first[k]);
    let length = way.iter().map(|x| x * x).sum::<f64>().sqrt();
    let pull = way.map(|x| x / length);
    let slide = -0.05;
    let _ = write!(
        deck,
        "*ELEMENT, TYPE=T3D2, ELSET=BELT\n1, 1, 2\n*ELGEN, ELSET=BELT\n1, {n}, 1, 1\n\
         *SOLID SECTION, ELSET=BELT, MATERIAL=M\n1.0E-2\n*MATERIAL, NAME=M\n*ELASTIC\n1.0E8, 0.0\n\
         *INITIAL CONDITIONS, TYPE=STRESS\nBELT, 1.0E2\n\
         *SURFACE, NAME=LINE\nBELT,\n*SURFACE, NAME=DRUM, TYPE=CYLINDER\n0., 0., 0., 1., 0., 0.\n\
         0., 0., -1.\nSTART, -1.0, 0.0\nCIRCL, 0.0, 1.0, 0.0, 0.0\nCIRCL, 1.0, 0.0, 0.0, 0.0\n\
         CIRCL, 0.0, -1.0, 0.0, 0.0\nCIRCL, -1.0, 0.0, 0.0, 0.0\n\
         *RIGID BODY, REF NODE=999, ANALYTICAL SURFACE=DRUM\n\
         *SURFACE INTERACTION, NAME=I\n1.0\n*FRICTION\n{mu:?}\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nLINE, DRUM\n\
         *STEP, NLGEOM\n*STATIC\n1.0, 1.0\n*BOUNDARY\n999, 1, 6\n{held}, 1, 3\n*CLOAD\n\
         1, 1, {:?}\n1, 2, {:?}\n1, 3, {:?}\n*CONTROLS, PARAMETERS=FIELD\n1.0E-10\n*END STEP\n\
         *STEP, NLGEOM\n*STATIC\n0.1, 1.0, 1.0E-6, 0.1\n*BOUNDARY\n999, 6, 6, {slide:?}\n\
         999, 3, 3, {:?}\n*CONTROLS, PARAMETERS=FIELD\n1.0E-10\n*END STEP\n",
        pull[0],
        pull[1],
        pull[2],
        slide * pitch,
        held = n + 1,
    );
    deck
}

/// Tension at the held end over that at the pulled one.
fn ratio(deck: &str, held: usize) -> f64 {
    let watch = run(deck, held as u64, &SolveOptions::default());
    watch.forces.last().unwrap().iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Requirement: where every node of a belt slips about a drum, T2/T1 is that of the polygon,
/// [(1 + mu tan(D/2))/(1 - mu tan(D/2))]^n, D = phi/n, which tends to exp(mu phi). Source: Euler and Eytelwein;
/// the polygon's ratio is derived (verification/tests/capstan.rs). Tolerance: the stretch of the belt.
#[test]
fn a_belt_on_a_drum() {
    for (mu, n) in [(0.1, 18), (0.3, 36)] {
        let half = (0.5 * PI / n as f64).tan();
        let exact = ((1.0 + mu * half) / (1.0 - mu * half)).powi(n as i32);
        let found = ratio(&belt(n, PI, 0.0, mu), n + 1);
        assert!((found / exact - 1.0).abs() < 1e-4, "{mu} {n}: {found} for {exact}");
        assert!((found / (mu * PI).exp() - 1.0).abs() < 2e-3);
    }
}

/// Requirement: wound as a helix of the angle alpha it is exp(mu phi cos alpha), phi = 3 pi, because the curvature
/// of a helix is cos^2 alpha over the radius and its length phi/cos alpha. Tolerance: the polygon, of
/// second order in the angle of a truss.
#[test]
fn a_helical_wrap() {
    let (mu, phi, pitch) = (0.2, 3.0 * PI, 0.3_f64);
    let cosine = 1.0 / pitch.hypot(1.0);
    let exact = (mu * phi * cosine).exp();
    let found = ratio(&belt(108, phi, pitch, mu), 109);
    assert!((found / exact - 1.0).abs() < 2e-3, "{found} for {exact}");
}
