//! Contact on faces of plane solids: against an analytical surface and against one another.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::observe::{ContactRow, Ending, Frame};
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop};
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// What the last increment left: reactions of a node, contact points, balance of the pair.
#[derive(Default)]
struct Last {
    node: u64,
    reaction: [f64; 2],
    contact: Vec<ContactRow>,
    force: [f64; 3],
    imbalance: [f64; 2],
    iterations: usize,
}

impl Observer for Last {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            self.take(frame);
        }
        ControlFlow::Continue(())
    }
}

impl Last {
    fn take(&mut self, frame: &Frame<'_>) {
        use slideline::model::Dof;
        let node = frame.model.nodes.find(self.node).unwrap();
        self.reaction = [Dof::U1, Dof::U2].map(|dof| frame.nodal.reaction(node, dof));
        self.contact = frame.contact.to_vec();
        self.force = frame.pairs[0].force;
        let (force, moment) = (frame.pairs[0].force_imbalance, frame.pairs[0].moment_imbalance);
        self.imbalance = [force, moment];
        self.iterations += frame.severe_iterations + frame.equilibrium_iterations;
    }
}

fn solved(deck: &str, node: u64) -> Last {
    let read = Job::read_text("solids", deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
    let mut last = Last { node, ..Last::default() };
    let ending = slideline::solve(&model, &SolveOptions::default(), &mut last);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
    last
}

/// Nodes and elements of a grid, numbered from `base` on, row by row from below.
fn grid(deck: &mut String, base: usize, [x, y]: [&[f64]; 2], set: &str) {
    let columns = x.len();
    let number = |i: usize, j: usize| base + i + columns * j;
    deck.push_str("*NODE\n");
    for (j, y) in y.iter().enumerate() {
        for (i, x) in x.iter().enumerate() {
            let _ = writeln!(deck, "{}, {x:?}, {y:?}", number(i, j));
        }
    }
    let _ = writeln!(deck, "*ELEMENT, TYPE=CPE4, ELSET={set}");
    for j in 0..y.len() - 1 {
        for i in 0..columns - 1 {
            let corners = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
            let [a, b, c, d] = corners;
            let _ = writeln!(deck, "{a}, {a}, {b}, {c}, {d}");
        }
    }
}

fn row(deck: &mut String, card: &str, numbers: impl Iterator<Item = usize>) {
    let _ = writeln!(deck, "{card}");
    numbers.for_each(|number| {
        let _ = writeln!(deck, "{number}");
    });
}

/// So many equal steps of a length, then as many that grow by 22 % each.
fn graded(first: f64, even: usize, growing: usize) -> Vec<f64> {
    let (mut places, mut step) = (vec![0.0], first);
    for k in 0..even + growing {
        step *= if k < even { 1.0 } else { 1.22 };
        places.push(places[k] + step);
    }
    places
}

/// Requirement: a rigid circle pressed into a block in plane strain carries Hertz' pressure,
/// p0 = sqrt(P E'/(pi R)) over the half-width a = 2 P/(pi p0) with E' = E/(1 - nu^2): p(x) is within 2 %
/// of p0 everywhere but at the two points next to the edge. Source: Johnson, Contact Mechanics, 4.2.
/// The block is 25 half-widths wide and 14 elements stand on one.
#[test]
fn a_circle_on_a_block_carries_hertz_pressure() {
    let (e, nu, radius, thickness) = (1000.0, 0.3, 5.0, 2.0);
    let right = graded(0.012, 20, 19);
    let x: Vec<f64> = right[1..].iter().rev().map(|x| -x).chain(right.iter().copied()).collect();
    let down = graded(0.012, 12, 19);
    let y: Vec<f64> = down.iter().rev().map(|y| -y).collect();
    let mut deck = String::from("*HEADING\nHertz\n");
    grid(&mut deck, 1, [&x, &y], "BLOCK");
    let (columns, top) = (x.len(), x.len() * (y.len() - 2) + 1);
    row(&mut deck, "*NSET, NSET=BOTTOM", 1..=columns);
    row(&mut deck, "*ELSET, ELSET=TOP", top..top + columns - 1);
    let _ = write!(
        deck,
        "*NODE\n99999, 0.0, {radius:?}
*MATERIAL, NAME=M
*ELASTIC
{e:?}, {nu:?}
*SOLID SECTION, ELSET=BLOCK, MATERIAL=M
{thickness:?}
*SURFACE, NAME=FACE
TOP, S3
*SURFACE, NAME=CIRCLE, TYPE=SEGMENTS
START, {radius:?}, {radius:?}
CIRCL, 0.0, 0.0, 0.0, {radius:?}
CIRCL, -{radius:?}, {radius:?}, 0.0, {radius:?}
*RIGID BODY, ANALYTICAL SURFACE=CIRCLE, REF NODE=99999
*SURFACE INTERACTION, NAME=I
*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE
FACE, CIRCLE
*BOUNDARY
BOTTOM, 1, 2
99999, 1, 1
99999, 6, 6
*STEP, NLGEOM
*STATIC
0.25, 1.0
*BOUNDARY
99999, 2, 2, -0.008
*END STEP
"
    );
    let last = solved(&deck, 99999);
    let force = -last.reaction[1] / thickness;
    let stiff = e / (1.0 - nu * nu);
    let most = (force * stiff / (std::f64::consts::PI * radius)).sqrt();
    let half = 2.0 * force / (std::f64::consts::PI * most);
    assert!(half > 10.0 * 0.012 && half < 20.0 * 0.012, "{half}");
    let mut inside = 0;
    for point in last.contact.iter().filter(|point| point.position[0].abs() < half - 0.024) {
        let exact = most * (1.0 - (point.position[0] / half).powi(2)).sqrt();
        assert!((point.pressure - exact).abs() < 0.02 * most, "{point:?} {exact}");
        inside += 1;
    }
    assert!(inside > 16, "{inside}");
    assert!(last.imbalance.iter().all(|off| *off < 1e-12), "{:?}", last.imbalance);
    // the thickness of the contact is that of the solids
    assert!((last.force[1] + last.reaction[1].abs()).abs() < 1e-9 * last.reaction[1].abs());
}

/// Two blocks of equal width on one another, faces with 6 and 4 elements; the upper one is pressed
/// down and, where `drag` is given, aside.
fn blocks(drag: f64, friction: f64) -> String {
    let even = |n: usize, from: f64, to: f64| -> Vec<f64> {
        (0..=n).map(|k| from + (to - from) * k as f64 / n as f64).collect()
    };
    let mut deck = String::from("*HEADING\nblocks\n");
    grid(&mut deck, 1, [&even(7, -1.0, 1.0), &even(4, -1.0, 0.0)], "LOWER");
    grid(&mut deck, 101, [&even(4, -0.6, 0.5), &even(3, 0.0, 0.8)], "UPPER");
    row(&mut deck, "*NSET, NSET=BOTTOM", 1..9);
    row(&mut deck, "*NSET, NSET=TOP", 116..121);
    row(&mut deck, "*ELSET, ELSET=UNDER", 25..32);
    row(&mut deck, "*ELSET, ELSET=OVER", 101..105);
    let _ = write!(
        deck,
        "*MATERIAL, NAME=M
*ELASTIC
1000.0, 0.3
*SOLID SECTION, ELSET=LOWER, MATERIAL=M
*SOLID SECTION, ELSET=UPPER, MATERIAL=M
*SURFACE, NAME=UPWARD
UNDER, S3
*SURFACE, NAME=DOWNWARD
OVER, S1
*SURFACE INTERACTION, NAME=I
*FRICTION
{friction:?}
*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE
DOWNWARD, UPWARD
*BOUNDARY
BOTTOM, 1, 2
*STEP, NLGEOM
*STATIC
0.5, 1.0
*BOUNDARY
TOP, 1, 1
TOP, 2, 2, -0.02
*END STEP
*STEP, NLGEOM
*STATIC
0.25, 1.0
*BOUNDARY
TOP, 1, 1, {drag:?}
TOP, 2, 2, -0.02
*END STEP
"
    );
    deck
}

/// Requirement: a block that is dragged over another slides at mu times its normal force, forces and
/// moments of both sides balance, and iterations stay about three an increment.
#[test]
fn a_block_slides_over_a_block() {
    let last = solved(&blocks(0.25, 0.3), 118);
    let [along, across, _] = last.force;
    let friction: f64 = last.contact.iter().map(|point| point.shear[0] * point.area).sum();
    let pressed: f64 = last.contact.iter().map(|point| point.pressure * point.area).sum();
    assert!((friction.abs() - 0.3 * pressed).abs() < 1e-9 * pressed, "{friction} {pressed}");
    assert!(along < 0.0 && across > 0.9 * pressed && -along > 0.25 * pressed, "{along} {across}");
    assert!(last.imbalance.iter().all(|off| *off < 1e-12), "{:?}", last.imbalance);
    assert!(last.iterations <= 24, "{}", last.iterations);
}

/// Requirement: where the end of a master has passed over a slave node, which then stands behind it
/// without having met it, a further step that moves next to nothing changes next to nothing. Source:
/// a step is a division of time, not of mechanics. Tolerance: what the motion does.
#[test]
fn a_further_step_catches_no_node_that_stands_behind() {
    let swapped = blocks(0.3, 0.0).replace("DOWNWARD, UPWARD", "UPWARD, DOWNWARD");
    let further = "*STEP, NLGEOM
*STATIC
1.0, 1.0
*BOUNDARY
TOP, 1, 1, 0.3001
TOP, 2, 2, -0.02
*END STEP
";
    let before = solved(&swapped, 118);
    let after = solved(&format!("{swapped}{further}"), 118);
    let [a, b] = [&before, &after].map(|last| last.force[1].abs());
    assert!(a > 0.0 && (a - b).abs() < 2e-3 * a, "{a} {b}");
    let closed = |last: &Last| last.contact.iter().filter(|row| row.pressure > 0.0).count();
    assert_eq!(closed(&before), closed(&after));
}

/// Requirement: the same blocks are read with contact spread over their faces, and slide at mu times
/// the force that presses them.
#[test]
fn a_block_slides_over_a_block_by_faces() {
    let deck = blocks(0.25, 0.3).replace("NODE TO SURFACE", "SURFACE TO SURFACE");
    let last = solved(&deck, 118);
    let friction: f64 = last.force[0].hypot(last.force[1]);
    assert!(friction > 0.0 && last.imbalance.iter().all(|off| *off < 1e-12));
}
