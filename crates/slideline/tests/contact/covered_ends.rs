//! Contact over faces that are covered in part: blocks pressed upon the end of another one, and drawn over it.
//!
//! ```text
//!          +------+
//!          |      |  ->          the end of each covers a part of a face of the other
//!          +------+
//!   +---------+
//!   |         |
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::mortar_decks::{Block, Kind, Last};
use crate::space_decks;
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, TangentCheck, solve};
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// A block of that width upon another one that ends at x = 2.
#[derive(Clone, Copy, Debug)]
struct OverEnd {
    kind: Kind,
    lower: [usize; 2],
    upper: [usize; 2],
    /// Where the upper block begins, and how wide it is.
    at: f64,
    width: f64,
    /// Sides of both that are in the surfaces.
    sides: [&'static [&'static str]; 2],
    modulus: f64,
    friction: f64,
    upper_is_slave: bool,
    way: [f64; 2],
    /// By how much both overlap to begin with, which interference takes away.
    overlap: f64,
}

const TOP: &[&str] = &["top"];
const BOTTOM: &[&str] = &["bottom"];
const UPPER_SIDES: &[&str] = &["bottom", "left", "right"];
const LOWER_SIDES: &[&str] = &["top", "left", "right"];

const BLOCKS: OverEnd = OverEnd {
    kind: Kind::Cpe4,
    lower: [7, 3],
    upper: [4, 3],
    at: 0.958,
    width: 0.7,
    sides: [LOWER_SIDES, UPPER_SIDES],
    modulus: 1000.0,
    friction: 0.0,
    upper_is_slave: false,
    way: [-0.2, -0.1],
    overlap: 0.0,
};

impl OverEnd {
    fn deck(&self, increments: u32) -> String {
        let mut deck = String::from("*HEADING\nover the end\n");
        let lower = Block { base: 0, cells: self.lower, kind: self.kind };
        let upper = Block { base: 10_000, cells: self.upper, kind: self.kind };
        lower.write(&mut deck, "LOWER", |[x, y]| [2.0 * x, y]);
        let floor = 1.0 - self.overlap;
        upper.write(&mut deck, "UPPER", |[x, y]| [self.at + self.width * x, floor + y]);
        for (block, name, sides) in [(lower, "TOP", self.sides[0]), (upper, "FOOT", self.sides[1])]
        {
            for (k, side) in sides.iter().enumerate() {
                let own = block.surface(name, side);
                deck.push_str(if k == 0 { &own } else { own.split_once('\n').unwrap().1 });
            }
        }
        deck.push_str(&lower.set("BASE", |_, y| y == 0.0));
        deck.push_str(&upper.set("HEAD", |_, y| y == 1.0));
        let (slave, master) = if self.upper_is_slave { ("FOOT", "TOP") } else { ("TOP", "FOOT") };
        let interference = match self.overlap > 0.0 {
            true => format!("*CONTACT INTERFERENCE, SHRINK\n{slave}, {master}\n"),
            false => String::new(),
        };
        let ([x, y], step) = (self.way, 1.0 / f64::from(increments));
        write!(
            deck,
            "*MATERIAL, NAME=M\n*ELASTIC\n1000.0, 0.3\n*MATERIAL, NAME=N\n*ELASTIC\n{:?}, 0.3\n\
             *SOLID SECTION, ELSET=LOWER, MATERIAL=M\n*SOLID SECTION, ELSET=UPPER, MATERIAL=N\n\
             *SURFACE INTERACTION, NAME=I\n*FRICTION\n{:?}\n*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\n\
             {slave}, {master}\n*BOUNDARY\nBASE, 1, 2\n*STEP, NLGEOM, INC=500\n*STATIC\n{step:?}, 1.0, , {step:?}\n\
             {interference}*BOUNDARY\nHEAD, 1, 1, {x:?}\nHEAD, 2, 2, {y:?}\n*END STEP\n",
            self.modulus, self.friction
        )
        .unwrap();
        deck
    }

    fn run(&self, increments: u32, check_tangent: TangentCheck) -> Last {
        let deck = self.deck(increments);
        let read = Job::read_text("over_end", &deck, &ReadOptions::default());
        let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
        let mut last = Last { watched: 10_000, ..Last::default() };
        let options = SolveOptions { check_tangent, ..SolveOptions::default() };
        let ending = solve(&model, &options, &mut last);
        assert!(matches!(ending, Ending::Completed(_)), "{self:?} {ending:?}\n{deck}");
        last
    }
}

/// Requirement: blocks upon the ends of others, with and without friction, linear and quadratic, either side the slave, find
/// their end, with tangents of differences and pairs in balance; four times the increments move the force by less than 2 %,
/// and what nodes are let go by is in the balance of energies.
#[test]
fn ends_slide_over_faces() {
    let soft = OverEnd { modulus: 5000.0, friction: 0.5, lower: [6, 5], upper: [7, 4], ..BLOCKS };
    let all = [
        BLOCKS,
        OverEnd {
            at: 1.42,
            width: 1.5,
            sides: [TOP, UPPER_SIDES],
            upper_is_slave: true,
            modulus: 1000.0,
            way: [-0.2, -0.05],
            ..soft
        },
        OverEnd {
            kind: Kind::Cpe8,
            lower: [9, 2],
            upper: [3, 3],
            at: 0.45,
            sides: [LOWER_SIDES, BOTTOM],
            modulus: 5000.0,
            friction: 0.2,
            way: [0.1, -0.1],
            ..BLOCKS
        },
        OverEnd {
            kind: Kind::Cpe8,
            lower: [5, 4],
            upper: [8, 3],
            at: 0.186,
            width: 1.5,
            sides: [TOP, UPPER_SIDES],
            friction: 0.5,
            way: [0.1, -0.1],
            ..BLOCKS
        },
    ];
    for own in all {
        let coarse = own.run(10, TangentCheck::Every);
        assert!(
            coarse.off < 1e-6 && coarse.worst < 1e-10,
            "{own:?} {:e} {:e}",
            coarse.off,
            coarse.worst
        );
        let fine = own.run(40, TangentCheck::Never);
        let [one, other] = [&coarse, &fine].map(|own| own.curve.last().unwrap()[1]);
        assert!((one - other).abs() < 0.02 * other.abs(), "{own:?} {one} {other}");
        let off = fine.balance.abs() / fine.work;
        assert!(off < 0.01, "{own:?} {off}");
    }
}

/// Requirement: an overlap that interference takes away from faces that are covered in part: what is allowed counts as
/// areas move, so that tangents are those of differences.
#[test]
fn interference_on_faces_that_are_covered_in_part() {
    for upper_is_slave in [true, false] {
        let own = OverEnd { overlap: 0.03, at: 1.6, way: [0.05, 0.0], upper_is_slave, ..BLOCKS };
        let last = own.run(4, TangentCheck::Every);
        assert!(last.off < 1e-6 && last.worst < 1e-10, "{own:?} {:e} {:e}", last.off, last.worst);
        assert!(last.curve.last().unwrap()[1] < -1.0, "{:?}", last.curve);
    }
}

/// A block pressed upon the corner of another one in space and drawn inward.
fn over_corner(friction: f64, upper_is_slave: bool) -> String {
    let mut deck = String::from("*HEADING\nover the corner\n");
    let kind = space_decks::Kind::C3d8;
    let lower = space_decks::Block { name: "LOWER", base: 0, cells: [3, 3, 1], kind };
    let upper = space_decks::Block { name: "UPPER", base: 10_000, cells: [2, 3, 1], kind };
    lower.write(&mut deck, |[x, y, z]| [2.0 * x, 2.0 * y, z]);
    upper.write(&mut deck, |[x, y, z]| [1.37 + 0.9 * x, 1.21 + y, 1.0 + z]);
    deck.push_str(&lower.surface("TOP", |[_, _, z]| z == 1.0));
    deck.push_str(&upper.surface("FOOT", |[_, _, z]| z == 0.0));
    deck.push_str(&lower.set("BASE", |[_, _, z]| z == 0.0));
    deck.push_str(&upper.set("HEAD", |[_, _, z]| z == 1.0));
    let (slave, master) = if upper_is_slave { ("FOOT", "TOP") } else { ("TOP", "FOOT") };
    write!(
        deck,
        "*MATERIAL, NAME=M\n*ELASTIC\n1000.0, 0.3\n*SOLID SECTION, ELSET=LOWER, MATERIAL=M\n\
         *SOLID SECTION, ELSET=UPPER, MATERIAL=M\n*SURFACE INTERACTION, NAME=I\n*FRICTION\n{friction:?}\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\n{slave}, {master}\n*BOUNDARY\nBASE, 1, 3\n\
         *STEP, NLGEOM, INC=500\n*STATIC\n0.1, 1.0, , 0.1\n*BOUNDARY\nHEAD, 1, 1, -0.3\nHEAD, 2, 2, -0.2\n\
         HEAD, 3, 3, -0.05\n*END STEP\n"
    )
    .unwrap();
    deck
}

/// Requirement: the same in space, where corners of faces are let go: tangents are those of differences, the pair
/// balances.
#[test]
fn corners_slide_over_faces_in_space() {
    for (friction, upper_is_slave) in [(0.0, false), (0.3, false), (0.0, true), (0.3, true)] {
        let last = space_decks::checked(&over_corner(friction, upper_is_slave));
        assert!(last.off < 2e-6, "{friction} {upper_is_slave} {:e} {}", last.off, last.told);
        assert!(last.worst < 1e-10, "{friction} {upper_is_slave} {:e}", last.worst);
    }
}

/// The force of the pressures of a pair by its rows, and that of the pair.
#[derive(Default)]
struct Forces {
    by_rows: f64,
    of_pair: f64,
}

impl Observer for Forces {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            self.by_rows = frame.contact.iter().map(|row| row.pressure * row.area).sum();
            let of_pressure = frame.pairs[0].of_pressure.force;
            self.of_pair = of_pressure.iter().map(|x| x * x).sum::<f64>().sqrt();
        }
        ControlFlow::Continue(())
    }
}

/// Requirement: what is told of slave nodes is pressure and the area that it acts on: their products are the force of
/// the pair, also where slave faces are covered in part, in the plane and in space. Flat faces, 1e-3.
#[test]
fn pressures_by_their_areas_are_the_force() {
    let upright = OverEnd { way: [0.0, -0.05], sides: [TOP, BOTTOM], ..BLOCKS };
    for deck in [upright.deck(4), over_corner(0.0, false).replace("1, 1, -0.3", "1, 1, 0.0")] {
        let read = Job::read_text("areas", &deck, &ReadOptions::default());
        let mut forces = Forces::default();
        let ending = solve(&read.model.unwrap(), &SolveOptions::default(), &mut forces);
        assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
        let Forces { by_rows, of_pair } = forces;
        assert!(of_pair > 1.0 && (by_rows / of_pair - 1.0).abs() < 5e-3, "{by_rows} {of_pair}");
    }
}
