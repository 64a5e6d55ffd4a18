//! Sharp edges: held as nodes where contact over faces, or at the nodes of the slave, does not see them,
//! and unknown to all results where it does.
//!
//! ```text
//!        /\                      ____
//!       /  \                    |    |        stands, slides, lies down
//!       \  /  ->                |    |
//!     ---\/-----             ---+----+---
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::mortar_decks::{Block, Kind, Last};
use crate::space_decks::turn as space_turn;
use slideline::observe::Ending;
use slideline::{Job, ReadOptions, SolveOptions, TangentCheck, solve};
use std::fmt::Write as _;

/// Where the corner of the upper block stands on the face below, which is 0.4 long.
const PLACE: f64 = 0.13;

/// A block that stands on its corner, turned by `tilt` degrees, on a wider one.
#[derive(Clone, Copy, Debug)]
struct Standing {
    kind: Kind,
    tilt: f64,
    faces: bool,
    upper_is_slave: bool,
    friction: f64,
    /// The card of a softened law; hard contact where it is empty.
    law: &'static str,
    /// How far from the axis the middle of a model of rings is.
    radius: f64,
    /// Turn and unit of the whole model.
    turned: f64,
    unit: f64,
}

const STANDING: Standing = Standing {
    kind: Kind::Cpe4,
    tilt: 45.0,
    faces: true,
    upper_is_slave: true,
    friction: 0.0,
    law: "",
    radius: 0.0,
    turned: 0.0,
    unit: 1.0,
};

fn turn([x, y]: [f64; 2], degrees: f64) -> [f64; 2] {
    let (s, c) = degrees.to_radians().sin_cos();
    [c * x - s * y, s * x + c * y]
}

impl Standing {
    fn at(&self, x: [f64; 2]) -> [f64; 2] {
        turn([x[0] + self.radius, x[1]], self.turned).map(|x| self.unit * x)
    }

    /// The deck, in which the upper nodes are carried along by `carry` of their undeformed places.
    fn deck(&self, increment: f64, carry: impl Fn([f64; 2]) -> [f64; 2]) -> String {
        let mut deck = String::from("*HEADING\nsharp edges\n");
        let lower = Block { base: 0, cells: [5, 2], kind: self.kind };
        let upper = Block { base: 10_000, cells: [3, 3], kind: self.kind };
        lower.write(&mut deck, "LOWER", |[x, y]| self.at([2.0 * x - 1.0, y - 1.0]));
        let place = |[x, y]: [f64; 2]| {
            let [x, y] = turn([0.5 * x, 0.5 * y], self.tilt);
            [x + PLACE, y]
        };
        upper.write(&mut deck, "UPPER", |x| self.at(place(x)));
        deck.push_str(&lower.surface("TOP", "top"));
        let sides = ["bottom", "left"].map(|side| upper.surface("TIP", side));
        deck.push_str(&sides[0]);
        deck.push_str(sides[1].split_once('\n').unwrap().1);
        deck.push_str(&lower.set("BASE", |_, y| y == 0.0));
        let kind = if self.faces { "SURFACE TO SURFACE" } else { "NODE TO SURFACE" };
        let (slave, master) = if self.upper_is_slave { ("TIP", "TOP") } else { ("TOP", "TIP") };
        let modulus = 1000.0 / (self.unit * self.unit);
        write!(
            deck,
            "*MATERIAL, NAME=M\n*ELASTIC\n{modulus:?}, 0.3\n*SOLID SECTION, ELSET=LOWER, MATERIAL=M\n{0:?}\n\
             *SOLID SECTION, ELSET=UPPER, MATERIAL=M\n{0:?}\n*SURFACE INTERACTION, NAME=I\n*FRICTION\n{1:?}\n{2}\
             *CONTACT PAIR, INTERACTION=I, TYPE={kind}\n{slave}, {master}\n*BOUNDARY\nBASE, 1, 2\n\
             *STEP, NLGEOM, INC=500\n*STATIC\n{increment:?}, 1.0, , {increment:?}\n*BOUNDARY\n",
            self.unit, self.friction, self.law
        )
        .unwrap();
        let most = if matches!(self.kind, Kind::Cpe8) { 6 } else { 3 };
        for (j, i) in (0..=most).flat_map(|j: usize| (0..=most).map(move |i: usize| (j, i))) {
            let exists = most == 3 || i % 2 == 0 || j % 2 == 0;
            if (i != most && j != most) || !exists {
                continue;
            }
            let from = place([i, j].map(|k| k as f64 / most as f64));
            let [a, b] = [self.at(from), self.at(carry(from))];
            let node = upper.node(i, j);
            writeln!(deck, "{node}, 1, 1, {:?}\n{node}, 2, 2, {:?}", b[0] - a[0], b[1] - a[1])
                .unwrap();
        }
        deck.push_str("*END STEP\n");
        deck
    }

    fn pressed(&self) -> String {
        self.deck(0.25, |[x, y]| [x + 0.06, y - 0.05])
    }
}

/// What a run leaves, with its edges or without; reactions are those of the upper nodes.
fn run(deck: &str, with_edges: bool, check_tangent: TangentCheck) -> Last {
    let read = Job::read_text("edges", deck, &ReadOptions::default());
    let mut model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
    if !with_edges {
        model.edge_pairs.clear();
        model.crossing_edges.clear();
    }
    let mut last = Last { watched: 10_000, ..Last::default() };
    let options = SolveOptions { check_tangent, ..SolveOptions::default() };
    let ending = solve(&model, &options, &mut last);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}\n{deck}");
    last
}

fn near(one: &[[f64; 2]], other: &[[f64; 2]], part: f64) -> bool {
    let size = one.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    let off = one.iter().zip(other).map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]));
    one.len() == other.len() && off.fold(0.0, f64::max) <= part * size
}

/// Requirement: a corner that is pressed into a face and slid along it is held by the same force whichever side is named
/// first, over faces and at nodes, with and without friction, linear and quadratic, turned and in other units;
/// without its edges over faces it goes in without a force. Tangents are those of differences, pairs balance, and the force of
/// the pair is that of the supports.
#[test]
fn a_corner_is_held_whichever_side_is_named_first() {
    for kind in [Kind::Cpe4, Kind::Cpe8] {
        for friction in [0.0, 0.3] {
            let own = Standing { kind, friction, ..STANDING };
            let first = run(&own.pressed(), true, TangentCheck::Every);
            let force = first.curve.last().unwrap();
            assert!(force[1] < -1.0, "{force:?}");
            assert!(first.off < 1e-6 && first.worst < 1e-10, "{:e} {:e}", first.off, first.worst);
            assert!((first.force[1] + force[1]).abs() < 1e-6 * force[1].abs(), "{:?}", first.force);
            assert!((force[0].abs() > 0.1 * force[1].abs()) == (friction > 0.0), "{force:?}");
            let rows: f64 = first.contact.iter().map(|row| row.pressure * row.area).sum();
            assert!(rows > 0.9 * force[1].abs() && rows < 1.1 * force[1].abs(), "{rows}");
            let none = run(&own.pressed(), false, TangentCheck::Never);
            assert!(none.curve[1][1].abs() < 1e-9 * force[1].abs(), "{:?}", none.curve);
            for (faces, upper_is_slave) in [(true, false), (false, false)] {
                let other = Standing { faces, upper_is_slave, ..own };
                let other_run = run(&other.pressed(), true, TangentCheck::Every);
                assert!(
                    near(&first.curve, &other_run.curve, if friction > 0.0 { 1e-3 } else { 1e-6 }),
                    "{other:?} {:?} {:?}",
                    first.curve,
                    other_run.curve
                );
                assert!(
                    other_run.off < 1e-6 && other_run.worst < 1e-10,
                    "{:e} {:e}",
                    other_run.off,
                    other_run.worst
                );
            }
            let moved = Standing { turned: 37.0, unit: 1e-3, ..own };
            let curve: Vec<_> = run(&moved.pressed(), true, TangentCheck::Never)
                .curve
                .iter()
                .map(|&own| turn(own, -37.0))
                .collect();
            assert!(near(&first.curve, &curve, 1e-5), "{:?} {curve:?}", first.curve);
        }
    }
}

/// Requirement: blocks that lie flat on one another know nothing of their edges, whichever is the slave.
#[test]
fn flat_on_flat_knows_of_no_edges() {
    for upper_is_slave in [true, false] {
        let own = Standing { tilt: 0.0, upper_is_slave, friction: 0.2, ..STANDING };
        let deck = own.deck(0.25, |[x, y]| [x + 0.06, y - 0.005]);
        let [with, without] = [true, false].map(|edges| run(&deck, edges, TangentCheck::Never));
        assert!(near(&with.curve, &without.curve, 1e-10), "{:?} {:?}", with.curve, without.curve);
    }
}

/// Requirement: a block that stands on its corner and lies down ends as one that knew of no edges; on the way its
/// corner is held. Energy balances with the square of the increment.
#[test]
fn a_block_that_lies_down_lets_its_edge_go() {
    let own = Standing { tilt: 30.0, ..STANDING };
    let down = |[x, y]: [f64; 2]| {
        let [x, y] = turn([x - PLACE, y], -30.0);
        [x + PLACE, y - 0.01]
    };
    let balances = [0.05, 0.0125].map(|increment| {
        let deck = own.deck(increment, down);
        let [with, without] = [true, false].map(|edges| run(&deck, edges, TangentCheck::Never));
        let [end, other] = [&with, &without].map(|own| *own.curve.last().unwrap());
        assert!(near(&[end], &[other], 1e-6), "{end:?} {other:?}");
        let early = with.curve.len() / 4;
        assert!(with.curve[early][1] < 10.0 * without.curve[early][1] - 1.0, "{:?}", with.curve);
        with.balance.abs() / with.work
    });
    assert!(balances[1] < 0.02 && balances[1] < balances[0] / 10.0, "{balances:?}");
}

/// The ways to name the two sides.
const WAYS: [(bool, bool); 4] = [(true, true), (true, false), (false, true), (false, false)];

/// Requirement: an edge that is a ring is held by one force whichever side is named first; far from the axis that
/// is the force of the plane, by the length of the ring.
#[test]
fn a_ring_on_its_edge_is_held_whichever_side_is_named_first() {
    let forces = WAYS.map(|(faces, upper_is_slave)| {
        let own = Standing { kind: Kind::Cax4, radius: 2000.0, faces, upper_is_slave, ..STANDING };
        let ring = run(&own.pressed(), true, TangentCheck::Every);
        assert!(ring.off < 1e-6 && ring.worst < 1e-10, "{own:?} {:e} {:e}", ring.off, ring.worst);
        ring.curve.last().unwrap()[1]
    });
    let plane = run(&STANDING.pressed(), true, TangentCheck::Never).curve.last().unwrap()[1];
    let around = 2.0 * std::f64::consts::PI * 2000.0;
    for force in forces {
        assert!((force - forces[0]).abs() < 1e-4 * forces[0].abs(), "{forces:?}");
        assert!((force / around - plane).abs() < 2e-3 * plane.abs(), "{forces:?} {plane}");
    }
}

/// Requirement: softened contact holds an edge too, softer than hard contact does, and by one force of either side where the
/// area of the edge is the same.
#[test]
fn a_softened_law_holds_an_edge() {
    let hard = run(&STANDING.pressed(), true, TangentCheck::Never).curve.last().unwrap()[1];
    for law in [
        "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n2.E4\n",
        "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n.002, 20.\n",
    ] {
        for (faces, upper_is_slave) in [(true, true), (true, false), (false, false)] {
            let own = Standing { law, faces, upper_is_slave, ..STANDING };
            let soft = run(&own.pressed(), true, TangentCheck::Every);
            assert!(soft.off < 1e-6 && soft.worst < 1e-10, "{own:?} {:e}", soft.off);
            let force = soft.curve.last().unwrap()[1];
            assert!((force - hard).abs() < 0.1 * hard.abs(), "{own:?} {force} {hard}");
        }
    }
}

/// Requirement: a pair that is taken away takes its edges along, and brings them when it comes back.
#[test]
fn edges_leave_and_come_back_with_their_pair() {
    for (faces, upper_is_slave) in [(true, true), (true, false), (false, false)] {
        let own = Standing { faces, upper_is_slave, ..STANDING };
        let pair = if upper_is_slave { "TIP, TOP" } else { "TOP, TIP" };
        let step = |act| {
            format!(
                "*STEP, NLGEOM\n*STATIC\n0.5, 1.0, , 0.5\n*MODEL CHANGE, TYPE=CONTACT PAIR, {act}\n{pair}\n\
                 *END STEP\n"
            )
        };
        let deck = own.pressed() + &step("REMOVE") + &step("ADD");
        let last = run(&deck, true, TangentCheck::Never);
        let forces: Vec<f64> = last.curve.iter().map(|force| force[1]).collect();
        let [.., pressed, _, away, _, back] = forces[..] else { panic!("{forces:?}") };
        assert!(pressed < -1.0 && away.abs() < 1e-8 * pressed.abs(), "{own:?} {forces:?}");
        assert!((back - pressed).abs() < 1e-4 * pressed.abs(), "{own:?} {forces:?}");
    }
}

/// A block in space that stands on an edge, or on a corner, on a wider one.
#[derive(Clone, Copy, Debug)]
struct InSpace {
    kind: crate::space_decks::Kind,
    on_corner: bool,
    faces: bool,
    upper_is_slave: bool,
    friction: f64,
    turned: f64,
}

impl InSpace {
    fn deck(&self) -> String {
        use crate::space_decks::Block;
        let mut deck = String::from("*HEADING\nsharp edges in space\n");
        let lower = Block { name: "LOWER", base: 0, cells: [4, 4, 1], kind: self.kind };
        let upper = Block { name: "UPPER", base: 10_000, cells: [2, 2, 2], kind: self.kind };
        let turned = |x: [f64; 3]| space_turn(x, self.turned);
        lower.write(&mut deck, |[x, y, z]| turned([2.0 * x - 1.0, 2.0 * y - 1.0, z - 1.0]));
        // its edge along y, or its corner, is lowest
        let second = if self.on_corner { 2.0_f64.sqrt().atan() } else { 45_f64.to_radians() };
        let place = |[x, y, z]: [f64; 3]| {
            let [x, y, z] = [0.6 * x, 0.6 * y, 0.6 * z];
            let first = if self.on_corner { 45_f64.to_radians() } else { 0.0 };
            let (s, c) = first.sin_cos();
            let [y, z] = [c * y - s * z, s * y + c * z];
            let (s, c) =
                (if self.on_corner { second - std::f64::consts::FRAC_PI_2 } else { -second })
                    .sin_cos();
            let [x, z] = [c * x + s * z, -s * x + c * z];
            [x + 0.11, y - if self.on_corner { -0.07 } else { 0.27 }, z]
        };
        upper.write(&mut deck, |x| turned(place(x)));
        deck.push_str(&lower.surface("TOP", |[_, _, z]| z == 1.0));
        deck.push_str(
            &upper.surface("TIP", |[x, y, z]| x == 0.0 || z == 0.0 || (self.on_corner && y == 0.0)),
        );
        deck.push_str(&lower.set("BASE", |[_, _, z]| z == 0.0));
        deck.push_str(
            &upper.set("HEAD", |[x, y, z]| x == 1.0 || z == 1.0 || (self.on_corner && y == 1.0)),
        );
        let kind = if self.faces { "SURFACE TO SURFACE" } else { "NODE TO SURFACE" };
        let (slave, master) = if self.upper_is_slave { ("TIP", "TOP") } else { ("TOP", "TIP") };
        let way = turned([0.05, 0.02, -0.06]);
        write!(
            deck,
            "*MATERIAL, NAME=M\n*ELASTIC\n1000.0, 0.3\n*SOLID SECTION, ELSET=LOWER, MATERIAL=M\n\
             *SOLID SECTION, ELSET=UPPER, MATERIAL=M\n*SURFACE INTERACTION, NAME=I\n*FRICTION\n{:?}\n\
             *CONTACT PAIR, INTERACTION=I, TYPE={kind}\n{slave}, {master}\n*BOUNDARY\nBASE, 1, 3\n\
             *STEP, NLGEOM, INC=500\n*STATIC\n0.25, 1.0, , 0.25\n*BOUNDARY\nHEAD, 1, 1, {:?}\nHEAD, 2, 2, {:?}\n\
             HEAD, 3, 3, {:?}\n*END STEP\n",
            self.friction, way[0], way[1], way[2]
        )
        .unwrap();
        deck
    }
}

/// Requirement: the same of an edge and of a corner in space, of hexahedra and tetrahedra: one force whichever side is
/// named first; turned, the turned force; tangents of differences, pairs in balance.
#[test]
fn an_edge_in_space_is_held_whichever_side_is_named_first() {
    use crate::space_decks::{Kind, checked, solved};
    for (kind, on_corner) in [(Kind::C3d8, false), (Kind::C3d8, true), (Kind::C3d4, true)] {
        for friction in [0.0, 0.3] {
            let (faces, upper_is_slave, turned) = (true, true, 0.0);
            let own = InSpace { kind, on_corner, faces, upper_is_slave, friction, turned };
            let first = checked(&own.deck());
            let force = first.force();
            assert!(force[2] > 1.0, "{own:?} {force:?}");
            assert!(
                first.off < 1e-6 && first.worst < 1e-10,
                "{own:?} {:e} {:e}",
                first.off,
                first.worst
            );
            let off = |other: [f64; 3]| {
                let apart = [0, 1, 2].map(|k| other[k] - force[k]);
                crate::space_decks::size(apart) / crate::space_decks::size(force)
            };
            for faces in [true, false] {
                let other = InSpace { faces, upper_is_slave: false, ..own };
                let reaction = solved(&other.deck()).force().map(|own| -own);
                assert!(
                    off(reaction) < if friction > 0.0 { 1e-3 } else { 1e-6 },
                    "{other:?} {force:?} {reaction:?}"
                );
            }
            let turned = solved(&InSpace { turned: 0.7, ..own }.deck()).force();
            assert!(off(space_turn(turned, -0.7)) < 1e-5, "{own:?} {force:?} {turned:?}");
        }
    }
}
