//! `*TRANSFORM` through decks: a model that is turned as a whole, with its conditions along axes
//! that turn with it, is the same model.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// Displacements, reactions and loads of all dofs of all nodes along the axes in which they are
/// named, and displacements along those of the model, by label.
#[derive(Default)]
struct End {
    named: BTreeMap<u64, [[f64; 3]; 6]>,
    plain: BTreeMap<u64, [f64; 3]>,
}

impl Observer for End {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            for node in 0..frame.model.nodes.len() {
                let label = frame.model.nodes.label(node);
                self.named.insert(label, Dof::ALL.map(|dof| frame.nodal.named(node, dof)));
                let moved = |axis: usize| frame.nodal.displacement(node, Dof::ALL[axis]);
                self.plain.insert(label, std::array::from_fn(moved));
            }
        }
        ControlFlow::Continue(())
    }
}

/// Runs a deck whose nodes stand turned by `turn`; `transform` cards stand before the step.
fn run(
    nodes: &[(u64, [f64; 3])],
    turn: impl Fn([f64; 3]) -> [f64; 3],
    (before, transform, after): (&str, &str, &str),
) -> End {
    let mut deck = "*NODE, NSET=ALL\n".to_owned();
    for &(label, x) in nodes {
        let [x, y, z] = turn(x);
        let _ = writeln!(deck, "{label}, {x:?}, {y:?}, {z:?}");
    }
    let deck = deck + before + transform + after;
    let read = Job::read_text("transform", &deck, &ReadOptions::default());
    let mut model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    for step in &mut model.steps {
        (step.controls.field.r_n, step.controls.field.c_n) = (1e-12, 1e-9);
    }
    let mut end = End::default();
    let ending = solve(&model, &SolveOptions::default(), &mut end);
    assert!(matches!(ending, Ending::Completed(_)), "{deck}\n{ending:?}");
    end
}

/// Holds two results against each other: differences over the largest value of a kind.
fn assert_same(a: &End, b: &End, within: f64) {
    for kind in 0..3 {
        let size = a.named.values().flatten().fold(0.0_f64, |most, own| most.max(own[kind].abs()));
        assert!(kind == 2 || size > 0.0);
        for (label, own) in &a.named {
            for (dof, own) in own.iter().enumerate() {
                let off = (own[kind] - b.named[label][dof][kind]).abs();
                let (x, y) = (own[kind], b.named[label][dof][kind]);
                assert!(off <= within * size, "node {label} dof {} {kind}: {x} {y}", dof + 1);
            }
        }
    }
}

/// A beam along x, clamped left, and beside it a block of solids with a coupling to a reference
/// node and an equation between the two.
const PLANE: (&str, &str) = (
    "*ELEMENT, TYPE=B21, ELSET=BEAM\n1, 1, 2\n2, 2, 3\n\
     *ELEMENT, TYPE=CPE4, ELSET=BLOCK\n11, 11, 12, 15, 14\n12, 12, 13, 16, 15\n\
     *BEAM SECTION, SECTION=RECT, ELSET=BEAM, MATERIAL=M\n2., 0.5\n\
     *SOLID SECTION, ELSET=BLOCK, MATERIAL=M\n2.\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n\
     *NSET, NSET=LEFT\n11, 14\n*NSET, NSET=RIGHT\n13, 16\n",
    "*SURFACE, NAME=END, TYPE=NODE\n13\n16\n\
     *COUPLING, CONSTRAINT NAME=C, REF NODE=20, SURFACE=END\n*KINEMATIC\n1, 1\n6, 6\n\
     *EQUATION\n2\n3, 2, 1., 12, 2, -0.5\n\
     *STEP, NLGEOM\n*STATIC\n0.5, 1.\n*BOUNDARY\n1, 1, 6\nLEFT, 1, 1\n11, 2, 2\n20, 2, 2\n\
     20, 1, 1, 0.4\n*CLOAD\n3, 1, -0.3\n3, 2, 0.2\n16, 2, -1.5\n20, 6, 4.\n*END STEP\n",
);

const PLANE_NODES: [(u64, [f64; 3]); 10] = [
    (1, [0.0, 5.0, 0.0]),
    (2, [5.0, 5.0, 0.0]),
    (3, [10.0, 5.0, 0.0]),
    (11, [0.0, 0.0, 0.0]),
    (12, [5.0, 0.5, 0.0]),
    (13, [10.0, 0.0, 0.0]),
    (14, [0.0, 3.0, 0.0]),
    (15, [5.5, 3.0, 0.0]),
    (16, [10.0, 3.0, 0.0]),
    (20, [12.0, 1.0, 0.0]),
];

/// Requirement: in the plane a model turned with its conditions gives the same displacements,
/// reactions and loads along the turned axes, with supports, loads, an equation and a coupling at
/// finite rotation: to 1e-12 of the largest.
#[test]
fn a_turned_plane_model_is_the_same() {
    let straight = run(&PLANE_NODES, |x| x, (PLANE.0, "", PLANE.1));
    let (s, c) = 0.7_f64.sin_cos();
    let turn = |[x, y, _]: [f64; 3]| [c * x - s * y, s * x + c * y, 0.0];
    let axes = format!("*TRANSFORM, NSET=ALL\n{c:?}, {s:?}, 0., {:?}, {c:?}, 0.\n", -s);
    let turned = run(&PLANE_NODES, turn, (PLANE.0, &axes, PLANE.1));
    assert_same(&straight, &turned, 1e-12);
    for (label, &moved) in &straight.plain {
        let expected = turn(moved);
        let off = (0..3).map(|k| (expected[k] - turned.plain[label][k]).abs()).fold(0.0, f64::max);
        assert!(off < 1e-11, "{label}: {off}");
    }
}

/// A block in space with a reference node that carries its right face, one of whose nodes gives
/// up its own direction 2 alone to an equation.
const SPACE: (&str, &str) = (
    "*ELEMENT, TYPE=C3D8, ELSET=BLOCK\n1, 1, 2, 5, 4, 11, 12, 15, 14\n2, 2, 3, 6, 5, 12, 13, 16, 15\n\
     *SOLID SECTION, ELSET=BLOCK, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n\
     *NSET, NSET=LEFT\n1, 4, 11, 14\n",
    "*SURFACE, NAME=END, TYPE=NODE\n3\n6\n13\n16\n\
     *COUPLING, CONSTRAINT NAME=C, REF NODE=20, SURFACE=END\n*KINEMATIC\n1, 2\n\
     *EQUATION\n2\n15, 3, 1., 12, 3, -0.5\n\
     *STEP, NLGEOM\n*STATIC\n0.5, 1.\n*BOUNDARY\nLEFT, 1, 1\n1, 2, 3\n4, 3, 3\n20, 1, 1, 0.3\n\
     20, 3, 3\n20, 5, 6\n*CLOAD\n16, 3, -2.5\n5, 2, 1.\n20, 4, 6.\n20, 2, 1.\n*END STEP\n",
);

/// Requirement: the same in space, for axes that are tilted every way.
#[test]
fn a_turned_model_in_space_is_the_same() {
    let at = |label: u64| -> [f64; 3] {
        let (k, z) = ((label - 1) % 10, f64::from(u8::from(label > 10)));
        [3.0 * (k % 3) as f64 + 0.1 * z, 2.0 * (k / 3) as f64, 2.5 * z]
    };
    let labels = [1, 2, 3, 4, 5, 6, 11, 12, 13, 14, 15, 16];
    let mut nodes: Vec<(u64, [f64; 3])> = labels.map(|label| (label, at(label))).to_vec();
    nodes.push((20, [8.0, 1.0, 1.0]));
    let straight = run(&nodes, |x| x, (SPACE.0, "", SPACE.1));
    // a rotation about (1, 2, -0.5) by 0.9
    let n = [1.0, 2.0, -0.5].map(|x: f64| x / 5.25_f64.sqrt());
    let (s, c) = 0.9_f64.sin_cos();
    let turn = |x: [f64; 3]| -> [f64; 3] {
        let along: f64 = (0..3).map(|k| n[k] * x[k]).sum();
        std::array::from_fn(|k| {
            let (next, last) = ((k + 1) % 3, (k + 2) % 3);
            c * x[k] + (1.0 - c) * along * n[k] + s * (n[next] * x[last] - n[last] * x[next])
        })
    };
    let [[a, b, d], [e, f, g]] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(turn);
    let axes = format!("*TRANSFORM, NSET=ALL\n{a:?}, {b:?}, {d:?}, {e:?}, {f:?}, {g:?}\n");
    let turned = run(&nodes, turn, (SPACE.0, &axes, SPACE.1));
    assert_same(&straight, &turned, 1e-12);
}

/// Requirement: along the axes of a cylinder, a ring sector whose cut faces are held around and
/// whose inside is moved outwards stays one: every node moves along its radius, and nodes of a
/// radius alike.
#[test]
fn a_sector_about_an_axis() {
    let (mut nodes, mut elements) = (Vec::new(), String::new());
    for k in 0..5_u64 {
        for i in 0..3_u64 {
            let (s, c) = (0.2 + 0.3 * k as f64).sin_cos();
            let r = 2.0 + 0.5 * i as f64;
            nodes.push((10 * k + i + 1, [1.0 + r * c, -2.0 + r * s, 0.0]));
            if k > 0 && i > 0 {
                let (n, m) = (10 * k + i, 10 * (k - 1) + i);
                let _ = writeln!(elements, "{n}, {m}, {}, {}, {n}", m + 1, n + 1);
            }
        }
    }
    let before = format!(
        "*ELEMENT, TYPE=CPE4, ELSET=RING\n{elements}*SOLID SECTION, ELSET=RING, MATERIAL=M\n\
         *MATERIAL, NAME=M\n*ELASTIC\n100., 0.3\n*NSET, NSET=CUT\n1, 2, 3, 41, 42, 43\n\
         *NSET, NSET=INSIDE\n1, 11, 21, 31, 41\n"
    );
    let axes = "*TRANSFORM, NSET=ALL, TYPE=C\n1., -2., 0., 1., -2., 1.\n";
    let after =
        "*STEP, NLGEOM\n*STATIC\n1., 1.\n*BOUNDARY\nCUT, 2, 2\nINSIDE, 1, 1, 0.2\n*END STEP\n";
    let end = run(&nodes, |x| x, (&before, axes, after));
    for (label, own) in &end.named {
        let first = end.named[&(label % 10)];
        assert!((own[0][0] - first[0][0]).abs() < 1e-11, "{label}: {own:?} {first:?}");
        assert!(own[1][0].abs() < 1e-11, "{label}: {own:?}");
    }
}

/// Requirement: two bricks that are tied are the same where they are turned, with supports along turned axes on both
/// sides of the tie: to 1e-12. What rounding of the axes left of a row made it follow dofs that were free, and
/// the supports of the slave were refused (SL0315).
#[test]
fn a_turned_tie_is_the_same() {
    let brick = |first: u64, x: f64| {
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let both = corners.into_iter().chain(corners.map(|[x, y, _]| [x, y, 1.0]));
        both.enumerate().map(move |(k, c)| (first + k as u64, [c[0] + x, c[1], c[2]]))
    };
    let nodes: Vec<_> = brick(1, 0.0).chain(brick(11, 1.0)).collect();
    let before = "*ELEMENT, TYPE=C3D8, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n\
                  2, 11, 12, 13, 14, 15, 16, 17, 18\n*SOLID SECTION, ELSET=E, MATERIAL=M\n\
                  *MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SURFACE, NAME=A\n1, S4\n*SURFACE, NAME=B\n\
                  2, S6\n*TIE, NAME=T\nB, A\n";
    let after = "*STEP, NLGEOM\n*STATIC\n0.5, 1.\n*BOUNDARY\nALL, 3, 3\n1, 1, 2\n4, 1, 2\n5, 1, 2\n\
                 8, 1, 2\n*CLOAD\n13, 2, -2.\n17, 2, -2.\n12, 1, 3.\n16, 1, 3.\n*END STEP\n";
    let straight = run(&nodes, |x| x, (before, "", after));
    // an oblique frame: its products round
    let a = [0.36, 0.48, -0.8];
    let b = [-0.8, 0.6, 0.0];
    let c = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let place = |x: [f64; 3]| [0, 1, 2].map(|k| a[k] * x[0] + b[k] * x[1] + c[k] * x[2]);
    let axes = format!(
        "*TRANSFORM, NSET=ALL\n{:?}, {:?}, {:?}, {:?}, {:?}, {:?}\n",
        a[0], a[1], a[2], b[0], b[1], b[2]
    );
    let turned = run(&nodes, place, (before, &axes, after));
    assert_same(&straight, &turned, 1e-12);
}
