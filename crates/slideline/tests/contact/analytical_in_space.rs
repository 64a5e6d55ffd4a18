//! Analytical rigid surfaces in space against faces of solids: a plane, a ball, a roller.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::space_decks::{solved, turn};
use std::fmt::Write as _;

type Vector = [f64; 3];

/// A block with its top at z = 0, clamped at its bottom, and a tool above it.
struct Press {
    /// Places of the grid lines along x and y, and along z from the bottom.
    lines: [Vec<f64>; 3],
    modulus: f64,
    /// Lines behind `*SURFACE, NAME=TOOL`, by the way in which points are turned.
    tool: fn(&dyn Fn(Vector) -> String) -> String,
    friction: f64,
    /// Way of the reference node, which is at (0, 0, 1).
    way: Vector,
    angle: f64,
}

impl Press {
    fn deck(&self) -> String {
        let text = |x: Vector| {
            let [x, y, z] = turn(x, self.angle);
            format!("{x:?}, {y:?}, {z:?}")
        };
        let [nx, ny, nz] = [0, 1, 2].map(|k| self.lines[k].len());
        let node = |i: usize, j: usize, k: usize| 1 + i + nx * (j + ny * k);
        let mut deck = String::from("*NODE\n");
        for k in 0..nz {
            for j in 0..ny {
                for i in 0..nx {
                    let at = [self.lines[0][i], self.lines[1][j], self.lines[2][k]];
                    let _ = writeln!(deck, "{}, {}", node(i, j, k), text(at));
                }
            }
        }
        let reference = node(nx - 1, ny - 1, nz - 1) + 1;
        let _ = writeln!(deck, "{reference}, {}", text([0.0, 0.0, 1.0]));
        deck.push_str("*ELEMENT, TYPE=C3D8I, ELSET=BLOCK\n");
        let mut number = 0;
        let mut top = String::new();
        for k in 0..nz - 1 {
            for j in 0..ny - 1 {
                for i in 0..nx - 1 {
                    number += 1;
                    let c = |a, b, c| node(i + a, j + b, k + c);
                    let nodes = [c(0, 0, 0), c(1, 0, 0), c(1, 1, 0), c(0, 1, 0)];
                    let upper = [c(0, 0, 1), c(1, 0, 1), c(1, 1, 1), c(0, 1, 1)];
                    let all = nodes.iter().chain(&upper).map(ToString::to_string);
                    let _ = writeln!(deck, "{number}, {}", all.collect::<Vec<_>>().join(", "));
                    if k == nz - 2 {
                        let _ = writeln!(top, "{number}, S2");
                    }
                }
            }
        }
        let _ = write!(
            deck,
            "*NSET, NSET=BOTTOM, GENERATE\n1, {}, 1\n\
             *SOLID SECTION, ELSET=BLOCK, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n{:?}, 0.3\n\
             *SURFACE, NAME=TOP\n{top}\
             *SURFACE, NAME=TOOL, {}\
             *RIGID BODY, REF NODE={reference}, ANALYTICAL SURFACE=TOOL\n\
             *SURFACE INTERACTION, NAME=I\n*FRICTION\n{:?}\n\
             *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nTOP, TOOL\n\
             *STEP, NLGEOM\n*STATIC, DIRECT\n0.25, 1.\n*CONTROLS, PARAMETERS=FIELD\n1e-10\n\
             *BOUNDARY\nBOTTOM, 1, 3\n{reference}, 4, 6\n",
            nx * ny,
            self.modulus,
            (self.tool)(&text),
            self.friction,
        );
        for (k, value) in turn(self.way, self.angle).into_iter().enumerate() {
            let _ = writeln!(deck, "{reference}, {0}, {0}, {value:?}", k + 1);
        }
        deck.push_str("*END STEP\n");
        deck
    }
}

fn even(from: f64, to: f64, count: usize) -> Vec<f64> {
    (0..=count).map(|k| from + (to - from) * k as f64 / count as f64).collect()
}

/// A plane at z = 0, its normal downwards.
fn plane(text: &dyn Fn(Vector) -> String) -> String {
    let (a, b, c) = (text([0.0; 3]), text([1.0, 0.0, 0.0]), text([0.0, -1.0, 0.0]));
    // x to b, drawn along -y: local y is x cross -y, downwards
    format!("TYPE=CYLINDER\n{a}, {b}\n{c}\nSTART, -5., 0.\nLINE, 5., 0.\n")
}

/// A ball of radius 1 about the reference node.
fn ball(text: &dyn Fn(Vector) -> String) -> String {
    let (a, b) = (text([0.0, 0.0, 1.0]), text([0.0, 0.0, 2.0]));
    format!("TYPE=REVOLUTION\n{a}, {b}\nSTART, 1., 0.\nCIRCL, 0., -1., 0., 0.\n")
}

/// A roller of radius 1 along y.
fn roller(text: &dyn Fn(Vector) -> String) -> String {
    let at = [0.0, 0.0, 1.0];
    let (a, b, c) = (text(at), text([1.0, 0.0, 1.0]), text([0.0, 1.0, 1.0]));
    format!(
        "TYPE=CYLINDER\n{a}, {b}\n{c}\nSTART, 1., 0.\nCIRCL, 0., -1., 0., 0.\nCIRCL, -1., 0., 0., 0.\n"
    )
}

/// Requirement: a plane lies flat on the block: every node of the top follows it, and force and
/// moment balance.
#[test]
fn a_plane_presses_flat() {
    let press = Press {
        lines: [even(-0.5, 0.5, 3), even(-0.5, 0.5, 3), even(-1.0, 0.0, 3)],
        modulus: 1000.0,
        tool: plane,
        friction: 0.0,
        way: [0.0, 0.0, -0.05],
        angle: 0.0,
    };
    let last = solved(&press.deck());
    assert_eq!(last.contact.len(), 16);
    for row in &last.contact {
        assert!(row.pressure > 0.0 && row.opening.abs() < 1e-12, "{row:?}");
        assert!((row.normal[2] + 1.0).abs() < 1e-12);
        assert!((row.position[2] + 0.05).abs() < 1e-12, "it follows the plane: {row:?}");
    }
    assert!(last.worst < 1e-9, "{}", last.worst);
}

/// Requirement: turned in space everything is the same, with friction, for all three tools.
/// Tolerance: that of the increments' convergence. When the turn of a direction in the plane was taken at
/// another place than that of the tangent which it is compared with, the ball was off by 7e-6.
#[test]
fn tools_are_the_same_in_any_direction() {
    for tool in [plane, ball, roller] {
        let press = |angle: f64| Press {
            lines: [even(-0.6, 0.6, 4), even(-0.5, 0.5, 4), even(-1.0, 0.0, 3)],
            modulus: 1000.0,
            tool,
            friction: 0.2,
            way: [0.08, 0.03, -0.06],
            angle,
        };
        let straight = solved(&press(0.0).deck());
        let oblique = solved(&press(0.7).deck());
        let expected = turn(straight.force(), 0.7);
        let size = expected.iter().map(|f| f * f).sum::<f64>().sqrt();
        assert!(size > 1.0);
        for k in 0..3 {
            let off = (oblique.force()[k] - expected[k]).abs();
            assert!(off < 1e-6 * size, "{:?} {expected:?}", oblique.force());
        }
        assert!(straight.worst.max(oblique.worst) < 1e-9);
        assert!(straight.most() <= 8, "{} iterations", straight.most());
    }
}

/// Grid lines that are fine about zero and end at `reach`.
fn graded(fine: f64, count: usize, reach: f64) -> Vec<f64> {
    let mut half = even(0.0, fine, count);
    let mut step = fine / count as f64;
    while half.last().unwrap() + 2.4 * step < reach {
        step *= 2.4;
        half.push(half.last().unwrap() + step);
    }
    half.push(reach);
    half.iter().rev().map(|x| -x).chain(half.iter().skip(1).copied()).collect()
}

/// Requirement: Hertz: a rigid ball of radius 1 pressed by d into a half-space gives
/// P = 4/3 E/(1 - nu^2) sqrt(R) d^(3/2); the block is large against the contact, and stiffer by its
/// clamped bottom. The node on the axis stands at the pole.
#[test]
fn a_ball_obeys_hertz() {
    let depth: f64 = 0.01;
    let lines = graded(0.12, 4, 1.5);
    let below: Vec<f64> = lines.iter().copied().filter(|x| *x <= 0.0).collect();
    let press = Press {
        lines: [lines.clone(), lines, below],
        modulus: 1000.0,
        tool: ball,
        friction: 0.0,
        way: [0.0, 0.0, -depth],
        angle: 0.0,
    };
    let last = solved(&press.deck());
    let hertz = 4.0 / 3.0 * 1000.0 / (1.0 - 0.09) * depth.powf(1.5);
    let force = last.force()[2].abs();
    assert!((force / hertz - 1.0).abs() < 0.12, "{force} beside {hertz}");
    let pole =
        last.contact.iter().find(|row| row.position[0].hypot(row.position[1]) < 1e-9).unwrap();
    assert!(pole.pressure > 0.0 && (pole.position[2] + depth).abs() < 1e-9, "{pole:?}");
    let closed: Vec<_> = last.contact.iter().filter(|row| row.pressure > 0.0).collect();
    let reach = closed.iter().map(|row| row.position[0].hypot(row.position[1])).fold(0.0, f64::max);
    assert!((0.08..0.13).contains(&reach), "radius of contact {reach} beside 0.1");
}
