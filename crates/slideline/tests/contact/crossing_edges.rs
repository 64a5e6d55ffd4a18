//! Sharp edges that cross sharp edges in space: held between all nodes of both, and unknown to all results where
//! faces carry.
//!
//! ```text
//!        \      /        a roof upside down on a roof: no node of one stands over a face of the other
//!      ___\____/___
//!     /____________\     theory, section 5.18
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::space_decks::{Block, Kind, Last, ended, run, size, turn};
use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, TangentCheck, solve};
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// Two roofs that cross, the upper one upside down; their ridges touch as they begin.
#[derive(Clone, Copy, Debug)]
struct Roofs {
    kind: Kind,
    upper_is_slave: bool,
    friction: f64,
    /// The card of a softened law; hard contact where it is empty.
    law: &'static str,
    /// Cells along both ridges.
    along: usize,
    /// Where the upper roof stands, and how far above [L].
    offset: [f64; 3],
    turned: f64,
    unit: f64,
    slope: f64,
}

const ROOFS: Roofs = Roofs {
    kind: Kind::C3d8,
    upper_is_slave: true,
    friction: 0.0,
    law: "",
    along: 3,
    offset: [0.03, 0.05, 0.0],
    turned: 0.0,
    unit: 1.0,
    slope: 1.0,
};

impl Roofs {
    fn at(&self, x: [f64; 3]) -> [f64; 3] {
        turn(x, self.turned.to_radians()).map(|x| self.unit * x)
    }

    fn lower(&self) -> Block {
        Block { name: "LOWER", base: 0, cells: [2, self.along, 2], kind: self.kind }
    }

    fn upper(&self) -> Block {
        Block { name: "UPPER", base: 10_000, cells: [self.along, 2, 2], kind: self.kind }
    }

    fn lower_place(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        [x - 0.5, y - 0.5, z * (1.0 - self.slope * (x - 0.5).abs()) - 1.0]
    }

    fn upper_place(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let up = 1.0 - (1.0 - z) * (1.0 - self.slope * (y - 0.5).abs());
        let [a, b, c] = self.offset;
        [x - 0.5 + a, y - 0.5 + b, up + c]
    }

    /// Nodes, elements, sets and materials.
    fn blocks(&self) -> String {
        let (lower, upper) = (self.lower(), self.upper());
        let mut deck = String::from("*HEADING\ncrossing edges\n");
        lower.write(&mut deck, |x| self.at(self.lower_place(x)));
        upper.write(&mut deck, |x| self.at(self.upper_place(x)));
        deck.push_str(&lower.set("BASE", |[_, _, z]| z == 0.0));
        deck.push_str(&upper.set("HEAD", |[_, _, z]| z == 1.0));
        let modulus = 1000.0 / (self.unit * self.unit);
        write!(
            deck,
            "*MATERIAL, NAME=M\n*ELASTIC\n{modulus:?}, 0.3\n*SOLID SECTION, ELSET=LOWER, MATERIAL=M\n\
             *SOLID SECTION, ELSET=UPPER, MATERIAL=M\n*BOUNDARY\nBASE, 1, 3\n"
        )
        .unwrap();
        deck
    }

    fn pair(&self) -> &'static str {
        if self.upper_is_slave { "TIP, TOP" } else { "TOP, TIP" }
    }

    /// The deck up to its steps.
    fn head(&self) -> String {
        let mut deck = self.blocks();
        deck.push_str(&self.lower().surface("TOP", |[_, _, z]| z == 1.0));
        deck.push_str(&self.upper().surface("TIP", |[_, _, z]| z == 0.0));
        write!(
            deck,
            "*SURFACE INTERACTION, NAME=I\n*FRICTION\n{:?}\n{}*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\n{}\n",
            self.friction,
            self.law,
            self.pair()
        )
        .unwrap();
        deck
    }

    /// A step to a place of the upper roof.
    fn step(&self, to: [f64; 3], increment: f64) -> String {
        let [x, y, z] = self.at(to);
        format!(
            "*STEP, NLGEOM, INC=500\n*STATIC\n{increment:?}, 1.0, , {increment:?}\n*BOUNDARY\nHEAD, 1, 1, {x:?}\n\
             HEAD, 2, 2, {y:?}\nHEAD, 3, 3, {z:?}\n*END STEP\n"
        )
    }

    fn pressed(&self) -> String {
        self.head() + &self.step([0.0, 0.0, -0.06], 0.25)
    }

    /// The force on the upper roof, in the unturned model with lengths of 1.
    fn force(&self, of: [f64; 3]) -> [f64; 3] {
        let sign = if self.upper_is_slave { 1.0 } else { -1.0 };
        turn(of, -self.turned.to_radians()).map(|own| sign * own)
    }
}

fn checked(deck: &str) -> Last {
    let last =
        run(deck, &SolveOptions { check_tangent: TangentCheck::Every, ..SolveOptions::default() });
    assert!(last.off < 1e-6, "{}", last.told);
    assert!(last.worst < 1e-10, "{:e}", last.worst);
    last
}

fn solved(deck: &str) -> Last {
    run(deck, &SolveOptions::default())
}

fn apart(one: [f64; 3], other: [f64; 3]) -> f64 {
    size([0, 1, 2].map(|k| one[k] - other[k])) / size(one)
}

/// The sum of the reactions of the upper roof along the height, with crossings or without.
#[derive(Default)]
struct Reaction(f64);

impl Observer for Reaction {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let nodes = &frame.model.nodes;
            let upper = (0..nodes.len()).filter(|&node| nodes.label(node) > 10_000);
            self.0 = upper.map(|node| frame.nodal.reaction(node, Dof::U3)).sum();
        }
        ControlFlow::Continue(())
    }
}

fn reaction(deck: &str, with_crossings: bool) -> f64 {
    let read = Job::read_text("crossing", deck, &ReadOptions::default());
    let mut model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
    if !with_crossings {
        model.crossing_edges.clear();
    }
    let mut seen = Reaction::default();
    let ending = solve(&model, &SolveOptions::default(), &mut seen);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}\n{deck}");
    seen.0
}

/// Requirement: two ridges that cross are held by one force whichever side is named first, linear and quadratic, where
/// nothing held them; turned and in other units it is the same. Tangents are those of differences, the pair balances.
#[test]
fn crossed_ridges_are_held_whichever_side_is_named_first() {
    for kind in [Kind::C3d8, Kind::C3d20r, Kind::C3d4] {
        let along = if kind == Kind::C3d8 { 3 } else { 1 };
        let own = Roofs { kind, along, ..ROOFS };
        let first = own.force(checked(&own.pressed()).force());
        let none = reaction(&own.pressed(), false);
        assert!(first[2] > 1.0 && none.abs() < 1e-6 * first[2], "{kind:?} {first:?} {none}");
        let held = reaction(&own.pressed(), true);
        assert!((held / first[2] + 1.0).abs() < 1e-6, "{kind:?} {first:?} {held}");
        let other = Roofs { upper_is_slave: false, ..own };
        let second = other.force(solved(&other.pressed()).force());
        assert!(apart(first, second) < 1e-9, "{kind:?} {first:?} {second:?}");
    }
    let first = ROOFS.force(solved(&ROOFS.pressed()).force());
    for (turned, unit) in [(90.0, 1.0), (37.0, 1e-3), (37.0, 1e3)] {
        let own = Roofs { turned, unit, ..ROOFS };
        let force = own.force(solved(&own.pressed()).force());
        assert!(apart(first, force) < 1e-8, "{own:?} {first:?} {force:?}");
    }
}

/// Requirement: the force is that of an equation between the heights of the four ends about the crossing, where
/// displacements are small.
#[test]
fn the_force_is_that_of_an_equation_between_the_four_ends() {
    let own = Roofs { along: 3, ..ROOFS };
    let way = -1e-6;
    let force = reaction(&(own.head() + &own.step([0.0, 0.0, way], 1.0)), true);
    // the ridges cross at (0, .05) below and at (0, .05) above: shares within the middle third of each
    let (t, s) = (3.0 * 0.05 + 0.5, 0.5 - 3.0 * 0.03);
    let ridge = |block: &Block, has: &dyn Fn([f64; 3]) -> bool| -> Vec<u64> {
        let text = block.set("X", has);
        text.lines().skip(1).map(|line| line.parse().unwrap()).collect()
    };
    let lower = ridge(&own.lower(), &|[x, y, z]| x == 0.5 && z == 1.0 && (0.3..0.7).contains(&y));
    let upper = ridge(&own.upper(), &|[x, y, z]| y == 0.5 && z == 0.0 && (0.3..0.7).contains(&x));
    let mut deck = own.blocks();
    write!(
        deck,
        "*EQUATION\n4\n{}, 3, {:?}, {}, 3, {:?}, {}, 3, {:?}, {}, 3, {:?}\n",
        upper[0],
        1.0 - s,
        upper[1],
        s,
        lower[0],
        t - 1.0,
        lower[1],
        -t
    )
    .unwrap();
    deck.push_str(&own.step([0.0, 0.0, way], 1.0));
    let expected = reaction(&deck, true);
    assert!(expected < 0.0 && (force / expected - 1.0).abs() < 1e-4, "{force} {expected}");
}

/// Requirement: friction at a crossing sticks, slips with its coefficient and turns with the way, whichever side is named
/// first.
#[test]
fn friction_of_a_crossing_follows_its_coefficient() {
    let forces = [true, false].map(|upper_is_slave| {
        let own = Roofs { friction: 0.2, upper_is_slave, ..ROOFS };
        let deck =
            own.head() + &own.step([0.0, 0.0, -0.05], 0.5) + &own.step([0.12, 0.09, -0.05], 0.25);
        let last = checked(&deck);
        let row = last.contact.iter().find(|row| row.pressure > 0.0).unwrap();
        assert!((row.shear.size() / row.pressure - 0.2).abs() < 1e-9, "{row:?}");
        own.force(last.force())
    });
    let [first, second] = forces;
    assert!(apart(first, second) < 1e-3, "{first:?} {second:?}");
    let stuck = [5.0, 50.0].map(|friction| {
        let own = Roofs { friction, ..ROOFS };
        let deck =
            own.head() + &own.step([0.0, 0.0, -0.05], 0.5) + &own.step([0.004, 0.003, -0.05], 0.5);
        own.force(solved(&deck).force())
    });
    // but for elastic slips, which are smaller the larger the coefficient
    assert!(apart(stuck[0], stuck[1]) < 1e-3, "{stuck:?}");
}

/// Requirement: a ridge that is drawn along another one over several edges of both goes on without a cutback, its force
/// hardly changes, and friction goes along.
#[test]
fn a_ridge_is_drawn_over_several_edges() {
    for (upper_is_slave, friction) in [(true, 0.0), (false, 0.0), (true, 0.2), (false, 0.2)] {
        let own = Roofs { along: 9, upper_is_slave, friction, offset: [-0.3, -0.3, 0.0], ..ROOFS };
        let deck =
            own.head() + &own.step([0.0, 0.0, -0.04], 0.5) + &own.step([0.6, 0.6, -0.04], 0.0625);
        let last = solved(&deck);
        assert_eq!(last.forces.len(), 18, "{own:?} {:?}", last.iterations);
        let forces: Vec<_> = last.forces.iter().skip(2).map(|&force| own.force(force)).collect();
        for force in &forces {
            let most = forces.iter().map(|own| own[2]).fold(0.0, f64::max);
            assert!(force[2] > 0.6 * most, "{forces:?}");
        }
    }
}

/// Requirement: softened laws hold a crossing, and it lets go as it is lifted; a pair that is taken away takes its crossings
/// along, and brings them when it comes back.
#[test]
fn crossings_are_soft_are_lifted_leave_and_come_back() {
    let hard = ROOFS.force(solved(&ROOFS.pressed()).force())[2];
    for law in [
        "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n2.E5\n",
        "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n.001, 20.\n",
    ] {
        let own = Roofs { law, ..ROOFS };
        let soft = own.force(checked(&own.pressed()).force())[2];
        assert!(soft < hard && soft > 0.8 * hard || law.contains("EXP"), "{law} {soft} {hard}");
        assert!((soft / hard - 1.0).abs() < 0.2, "{law} {soft} {hard}");
        let lifted = solved(&(own.pressed() + &own.step([0.0, 0.0, 0.02], 0.5))).force();
        assert!(size(lifted) == 0.0, "{lifted:?}");
    }
    let step = |act| {
        format!(
            "*STEP, NLGEOM\n*STATIC\n0.5, 1.0, , 0.5\n*MODEL CHANGE, TYPE=CONTACT PAIR, {act}\n{}\n*END STEP\n",
            ROOFS.pair()
        )
    };
    let deck = ROOFS.pressed() + &step("REMOVE") + &step("ADD");
    let last = solved(&deck);
    let forces: Vec<f64> = last.forces.iter().map(|&force| ROOFS.force(force)[2]).collect();
    let [.., pressed, _, away, _, back] = forces[..] else { panic!("{forces:?}") };
    assert!(pressed > 1.0 && away == 0.0, "{forces:?}");
    assert!((back / pressed - 1.0).abs() < 1e-6, "{forces:?}");
}

/// A bar on one that it crosses, with their sides: their edges cross where they stand out.
fn flat_on_flat(askew: f64, cells: [usize; 2], upper_is_slave: bool) -> String {
    let lower = Block { name: "LOWER", base: 0, cells: [cells[0], cells[0], 1], kind: Kind::C3d8 };
    let upper =
        Block { name: "UPPER", base: 10_000, cells: [cells[1], cells[1], 1], kind: Kind::C3d8 };
    let mut deck = String::from("*HEADING\nflat on flat\n");
    lower.write(&mut deck, |[x, y, z]| [x - 0.5, 1.6 * (y - 0.5), 0.6 * (z - 1.0)]);
    upper.write(&mut deck, |[x, y, z]| {
        let (s, c) = askew.sin_cos();
        let [x, y] = [1.6 * (x - 0.5), y - 0.5];
        [c * x - s * y, s * x + c * y, 0.6 * z]
    });
    deck.push_str(&lower.set("BASE", |[_, _, z]| z == 0.0));
    deck.push_str(&upper.set("HEAD", |[_, _, z]| z == 1.0));
    let side = |[x, y, _]: [f64; 3]| x == 0.0 || x == 1.0 || y == 0.0 || y == 1.0;
    for (block, name, foot) in [(lower, "TOP", 1.0), (upper, "TIP", 0.0)] {
        let outside = |face: [f64; 3]| face[2] == foot;
        deck.push_str(&block.surface(name, outside));
        let text = [0, 1].map(|axis| {
            [0.0, 1.0].map(|end| block.surface(name, move |x: [f64; 3]| x[axis] == end && side(x)))
        });
        for own in text.as_flattened() {
            deck.push_str(own.split_once('\n').unwrap().1);
        }
    }
    let pair = if upper_is_slave { "TIP, TOP" } else { "TOP, TIP" };
    write!(
        deck,
        "*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SOLID SECTION, ELSET=LOWER, MATERIAL=M\n\
         *SOLID SECTION, ELSET=UPPER, MATERIAL=M\n*SURFACE INTERACTION, NAME=I\n*FRICTION\n0.2\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\n{pair}\n*BOUNDARY\nBASE, 1, 3\n\
         *STEP, NLGEOM, INC=100\n*STATIC\n0.25, 1.0, , 0.25\n*BOUNDARY\nHEAD, 1, 1, 0.02\nHEAD, 2, 2, 0.01\n\
         HEAD, 3, 3, -0.004\n*END STEP\n"
    )
    .unwrap();
    deck
}

/// Requirement: blocks that lie flat on one another, equal meshes and others, along one another and askew, know nothing
/// of their crossings.
#[test]
fn flat_on_flat_knows_of_no_crossings() {
    for (askew, cells) in [(0.0, [3, 3]), (0.0, [4, 3]), (0.4, [3, 3]), (0.4, [4, 3])] {
        for upper_is_slave in [true, false] {
            let deck = flat_on_flat(askew, cells, upper_is_slave);
            let [with, without] = [true, false].map(|own| reaction(&deck, own));
            assert!((with / without - 1.0).abs() < 1e-9, "{askew} {cells:?} {with} {without}");
        }
    }
}

/// Requirement: what overlaps as a step begins is pressed apart where that is not allowed.
#[test]
fn crossings_that_overlap_are_pressed_apart() {
    let own = Roofs { offset: [0.03, 0.05, -0.02], ..ROOFS };
    let (ending, last) = ended(&(own.head() + &own.step([0.0; 3], 0.5)), &SolveOptions::default());
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
    let whole = ROOFS.force(solved(&(ROOFS.head() + &ROOFS.step([0.0, 0.0, -0.02], 0.5))).force());
    assert!(apart(whole, own.force(last.force())) < 0.1, "{:?} {whole:?}", last.force());
}
