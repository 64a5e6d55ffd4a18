//! Friction with a coefficient along each axis of a surface in space: a block pulled at an angle.
//!
//! ```text
//!      2 |   . way            the drag leans towards the axis of the larger coefficient:
//!        |  /                 slip is normal to the ellipse of the limit
//!        | /  ..--> drag
//!        o-----------> 1
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::space_decks::{Block, Kind, Last, checked, size, solved, turn};
use std::fmt::Write as _;

type Vector = [f64; 3];

/// The block is pressed by this, over its height 1.
const STRAIN: f64 = 0.002;

/// What the block slides on.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Floor {
    /// Faces, at the nodes of the block.
    Faces,
    /// Faces, over those of the block.
    Spread,
    /// An analytical plane, its profile along x.
    Plane,
}

/// A block pressed on a floor that does not give, and pulled along it.
#[derive(Clone, Copy, Debug)]
struct Pull<'a> {
    floor: Floor,
    /// The card and its data line.
    friction: &'a str,
    /// Direction of the pull to x in the undeformed floor, before the whole is turned.
    towards: f64,
    /// Turn of the whole.
    angle: f64,
    /// Turn of the axes that the pair names, from x in the undeformed floor.
    axes: Option<f64>,
}

const PULL: Pull<'_> =
    Pull { floor: Floor::Faces, friction: "*FRICTION\n0.3", towards: 0.5, angle: 0.0, axes: None };

impl Pull<'_> {
    fn way(&self) -> Vector {
        let (sine, cosine) = self.towards.sin_cos();
        turn([cosine, sine, 0.0], self.angle)
    }

    fn deck(&self) -> String {
        let of = |x: Vector| turn(x, self.angle);
        let floor = Block { name: "F", base: 0, cells: [3, 3, 1], kind: Kind::C3d8 };
        let block = Block { name: "B", base: 5000, cells: [2, 2, 2], kind: Kind::C3d8 };
        let mut deck = String::from("*HEADING\na block pulled at an angle\n");
        block.write(&mut deck, of);
        deck.push_str(&block.surface("SLAVE", |at| at[2] == 0.0));
        deck.push_str(&block.set("TOP", |at| at[2] == 1.0));
        deck.push_str(
            "*SOLID SECTION, ELSET=B, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n1e3, 0.3\n",
        );
        if self.floor == Floor::Plane {
            let text = |x: Vector| of(x).map(|x| format!("{x:?}")).join(", ");
            let _ = writeln!(
                deck,
                "*NODE, NSET=ALL-F\n9999, {0}\n*SURFACE, NAME=MASTER, TYPE=CYLINDER\n{0}, {1}\n{2}\n\
                 START, 5., 0.\nLINE, -5., 0.\n*RIGID BODY, REF NODE=9999, ANALYTICAL SURFACE=MASTER",
                text([0.0; 3]),
                text([1.0, 0.0, 0.0]),
                text([0.0, -1.0, 0.0]),
            );
        } else {
            floor.write(&mut deck, |[x, y, z]| of([4.0 * x - 1.5, 4.0 * y - 1.5, z - 1.0]));
            deck.push_str(&floor.surface("MASTER", |at| at[2] == 1.0));
            deck.push_str(&floor.set("ALL-F", |_| true));
            deck.push_str("*SOLID SECTION, ELSET=F, MATERIAL=M\n");
        }
        let formulation = match self.floor {
            Floor::Spread => "SURFACE TO SURFACE",
            Floor::Faces | Floor::Plane => "NODE TO SURFACE",
        };
        let _ = writeln!(
            deck,
            "*SURFACE INTERACTION, NAME=I\n{}\n\
             *CONTACT PAIR, INTERACTION=I, TYPE={formulation}\nSLAVE, MASTER{}",
            self.friction,
            if self.axes.is_some() { ", AXES, AXES" } else { "" }
        );
        if let Some(axes) = self.axes {
            let along =
                |by: f64| of([by.cos(), by.sin(), 0.0]).map(|x| format!("{x:?}")).join(", ");
            let (first, second) = (along(axes), along(axes + 1.5));
            let _ = writeln!(deck, "*ORIENTATION, NAME=AXES\n{first}, {second}");
        }
        let last = if self.floor == Floor::Plane { 6 } else { 3 };
        let way = self.way();
        let down = of([0.0, 0.0, -STRAIN]);
        for (length, increments) in [(0.0, 2), (0.6, 6)] {
            let each = 1.0 / f64::from(increments);
            let _ = writeln!(
                deck,
                "*STEP, NLGEOM\n*STATIC\n{each:?}, 1., 1e-5, {each:?}\n\
                 *CONTROLS, PARAMETERS=FIELD\n1e-10\n*BOUNDARY\nALL-F, 1, {last}"
            );
            for k in 0..3 {
                let _ = writeln!(deck, "TOP, {0}, {0}, {1:?}", k + 1, down[k] + length * way[k]);
            }
            deck.push_str("*END STEP\n");
        }
        deck
    }

    /// The drag over the press, and its direction, that is expected of coefficients along the axes.
    fn drag(&self, coefficients: [f64; 2]) -> Vector {
        let normal = turn([0.0, 0.0, 1.0], self.angle);
        let first = match self.floor {
            _ if self.axes.is_some() => {
                let (sine, cosine) = self.axes.unwrap_or(0.0).sin_cos();
                turn([cosine, sine, 0.0], self.angle)
            }
            Floor::Plane => turn([1.0, 0.0, 0.0], self.angle),
            Floor::Faces | Floor::Spread => {
                let across: Vector =
                    std::array::from_fn(|k| f64::from(u8::from(k == 0)) - normal[0] * normal[k]);
                across.map(|x| x / size(across))
            }
        };
        let second = [
            normal[1] * first[2] - normal[2] * first[1],
            normal[2] * first[0] - normal[0] * first[2],
            normal[0] * first[1] - normal[1] * first[0],
        ];
        let way = self.way();
        let dot = |a: Vector| (0..3).map(|k| a[k] * way[k]).sum::<f64>();
        let along = [dot(first), dot(second)];
        let whole = (coefficients[0] * along[0]).hypot(coefficients[1] * along[1]);
        let [a, b] = [0, 1].map(|k| coefficients[k] * coefficients[k] * along[k] / whole);
        std::array::from_fn(|k| -a * first[k] - b * second[k])
    }

    /// Holds the force on the block against what is expected of a limit of the traction that all of the
    /// foot has reached, over its area of 1.
    fn holds_at(&self, last: &Last, coefficients: [f64; 2], limit: f64) {
        let largest = coefficients[0].max(coefficients[1]);
        let drag = self.drag(coefficients.map(|own| own / largest));
        let (force, normal) = (last.force(), turn([0.0, 0.0, 1.0], self.angle));
        let press: f64 = (0..3).map(|k| force[k] * normal[k]).sum();
        let off: Vector = std::array::from_fn(|k| force[k] - press * normal[k] - limit * drag[k]);
        let carried = if self.floor == Floor::Spread { STRAIN } else { 0.0 };
        assert!(press > 1.0, "{self:?}: {press}");
        assert!(size(off) < (1e-6 + carried) * limit, "{self:?}: {force:?}, off by {off:?}");
        assert!(last.worst < 1e-9, "{self:?}: balance {}", last.worst);
    }

    /// Holds the force on the block against what is expected.
    fn holds(&self, last: &Last, coefficients: [f64; 2]) {
        let (force, drag) = (last.force(), self.drag(coefficients));
        let normal = turn([0.0, 0.0, 1.0], self.angle);
        let press: f64 = (0..3).map(|k| force[k] * normal[k]).sum();
        let off: Vector = std::array::from_fn(|k| force[k] - press * (normal[k] + drag[k]));
        assert!(press > 1.0, "{self:?}: {press}");
        let carried = if self.floor == Floor::Spread { STRAIN } else { 0.0 };
        let tolerance = (1e-6 + carried * size(drag)) * press;
        assert!(size(off) < tolerance, "{self:?}: {force:?}, off by {off:?}");
        assert!(last.worst < 1e-9, "{self:?}: balance {}", last.worst);
    }
}

/// Requirement: a block that slides is dragged as the ellipse has it, S S g p/|S g|, with axis 1 that
/// of x seen along the normal, or the profile of an analytical surface: at the nodes, over faces, on a
/// plane; with elastic stick and with a multiplier; turned in space; with one coefficient zero. Force
/// and moment balance, in at most five iterations. Tolerance: what is left of the transient, 1e-6; over
/// faces the axes are those of the block, and turn with its faces by no more than its strain.
#[test]
fn the_drag_leans_towards_the_larger_coefficient() {
    let cards = [
        ("*FRICTION, ANISOTROPIC\n0.2, 0.5", [0.2, 0.5]),
        ("*FRICTION, ANISOTROPIC, LAGRANGE\n0.5, 0.2", [0.5, 0.2]),
        ("*FRICTION, ANISOTROPIC\n0.4, 0.0", [0.4, 0.0]),
    ];
    for floor in [Floor::Faces, Floor::Spread, Floor::Plane] {
        for (friction, coefficients) in cards {
            for (towards, angle) in [(0.5, 0.0), (2.2, 0.8)] {
                let pull = Pull { floor, friction, towards, angle, axes: None };
                let last = solved(&pull.deck());
                pull.holds(&last, coefficients);
                assert!(last.most() <= 5, "{pull:?}: {:?}", last.iterations);
            }
        }
    }
}

/// Requirement: the same along axes that the pair names, at the nodes those of the master, over faces those of
/// the slave.
#[test]
fn the_pair_names_the_axes() {
    let friction = "*FRICTION, ANISOTROPIC\n0.2, 0.5";
    for floor in [Floor::Faces, Floor::Spread] {
        for (axes, angle) in [(0.4, 0.0), (-1.1, 0.8)] {
            let pull = Pull { floor, friction, towards: 0.5, angle, axes: Some(axes) };
            pull.holds(&solved(&pull.deck()), [0.2, 0.5]);
        }
    }
}

/// Requirement: where the traction has reached TAUMAX everywhere, the drag is that limit along the axis of
/// the larger coefficient, and smaller by the ratio of both along the other: an ellipse of the same shape.
/// Tolerance: as above.
#[test]
fn a_limit_of_the_traction_keeps_the_shape_of_the_ellipse() {
    let coefficients = [0.2, 0.5];
    for stick in ["", ", LAGRANGE"] {
        let friction = format!("*FRICTION, ANISOTROPIC, TAUMAX=0.05{stick}\n0.2, 0.5");
        for floor in [Floor::Faces, Floor::Spread, Floor::Plane] {
            for (towards, angle) in [(0.5, 0.0), (2.2, 0.8)] {
                let pull = Pull { floor, friction: &friction, towards, angle, axes: None };
                pull.holds_at(&solved(&pull.deck()), coefficients, 0.05);
            }
        }
    }
}

/// Requirement: two equal coefficients are one. Tolerance: that of the iteration.
#[test]
fn equal_coefficients_are_one() {
    for floor in [Floor::Faces, Floor::Spread, Floor::Plane] {
        let one = solved(&Pull { floor, ..PULL }.deck());
        let friction = "*FRICTION, ANISOTROPIC\n0.3, 0.3";
        let two = solved(&Pull { floor, friction, ..PULL }.deck());
        for (a, b) in one.forces.iter().zip(&two.forces) {
            let off: Vector = std::array::from_fn(|k| a[k] - b[k]);
            assert!(size(off) < 1e-9 * size(*a), "{floor:?}: {a:?} {b:?}");
        }
    }
}

/// Requirement: the tangent is that of the forces, as they stick and as they slide.
#[test]
fn tangents_are_those_of_the_forces() {
    for floor in [Floor::Faces, Floor::Spread, Floor::Plane] {
        let friction = "*FRICTION, ANISOTROPIC\n0.2, 0.5";
        let last = checked(&Pull { floor, friction, ..PULL }.deck());
        assert!(last.off < 1e-5, "{floor:?}: {} {}", last.off, last.told);
    }
}
