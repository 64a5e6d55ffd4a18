//! Two coefficients of friction on a surface of revolution: along its profile and across it, everywhere.
//!
//! ```text
//!        axis | .  foot           a node of a block is pressed on a disc or a ball and pulled, or
//!             |/ ) turns          the surface turns under it
//!     --------o---------> r
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::space_decks::{Block, Kind, Last, checked, size, solved, turn};
use std::fmt::Write as _;

type Vector = [f64; 3];

const RADIUS: f64 = 40.0;

/// Along the profile and across it.
const MU: [f64; 2] = [0.4, 0.1];

#[derive(Clone, Copy, Debug, PartialEq)]
enum Surface {
    Disc,
    Ball,
}

/// A foot that is pulled over a surface about z through the origin.
#[derive(Clone, Copy, Debug)]
struct Pull {
    surface: Surface,
    /// Behind ANISOTROPIC.
    stick: &'static str,
    mu: [f64; 2],
    /// Distance of the foot from the axis, and the way of the pull.
    from: f64,
    way: Vector,
    /// By how much the surface turns about its axis meanwhile.
    turns: f64,
    /// Turn of the whole.
    angle: f64,
}

const PULL: Pull = Pull {
    surface: Surface::Disc,
    stick: "",
    mu: MU,
    from: 12.0,
    way: [0.5, 0.0, 0.0],
    turns: 0.0,
    angle: 0.0,
};

impl Pull {
    /// The height of the surface.
    fn height(&self, across: f64) -> f64 {
        match self.surface {
            Surface::Disc => 0.0,
            Surface::Ball => (RADIUS * RADIUS - across * across).sqrt(),
        }
    }

    fn deck(&self) -> String {
        let of = |x: Vector| turn(x, self.angle);
        let text = |x: Vector| of(x).map(|x| format!("{x:?}")).join(", ");
        let block = Block { name: "B", base: 0, cells: [2, 2, 1], kind: Kind::C3d8 };
        let mut deck = String::new();
        let height = self.height(self.from);
        block.write(&mut deck, |[x, y, z]| of([self.from + x - 0.5, y - 0.5, height + z]));
        deck.push_str(&block.set("FOOT", |at| at == [0.5, 0.5, 0.0]));
        deck.push_str(&block.set("TOP", |at| at[2] == 1.0));
        let profile = match self.surface {
            Surface::Disc => "START, 0., 0.\nLINE, 30., 0.",
            Surface::Ball => "START, 0., 40.\nCIRCL, 40., 0., 0., 0.",
        };
        let [first, second] = self.mu;
        let _ = writeln!(
            deck,
            "*SOLID SECTION, ELSET=B, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n1e3, 0.\n\
             *NODE, NSET=HELD\n9999, {0}\n*SURFACE, NAME=MASTER, TYPE=REVOLUTION\n{0}, {1}\n{profile}\n\
             *RIGID BODY, REF NODE=9999, ANALYTICAL SURFACE=MASTER\n*SURFACE, NAME=SLAVE, TYPE=NODE\nFOOT, 1.\n\
             *SURFACE INTERACTION, NAME=I\n*FRICTION, ANISOTROPIC{2}\n{first:?}, {second:?}\n\
             *CONTACT PAIR, INTERACTION=I\nSLAVE, MASTER",
            text([0.0; 3]),
            text([0.0, 0.0, 1.0]),
            self.stick,
        );
        let about = of([0.0, 0.0, 1.0]);
        for (moved, increments) in [(0.0, 2), (1.0, 5)] {
            let each = 1.0 / f64::from(increments);
            let _ = writeln!(
                deck,
                "*STEP, NLGEOM\n*STATIC\n{each:?}, 1., 1e-5, {each:?}\n\
                 *CONTROLS, PARAMETERS=FIELD\n1e-10\n*BOUNDARY\nHELD, 1, 3"
            );
            let [x, y, z] = self.way;
            let by = of([moved * x, moved * y, moved * z - 0.02]);
            for k in 0..3 {
                let _ = writeln!(deck, "TOP, {0}, {0}, {1:?}", k + 1, by[k]);
                let _ =
                    writeln!(deck, "HELD, {0}, {0}, {1:?}", k + 4, moved * self.turns * about[k]);
            }
            deck.push_str("*END STEP\n");
        }
        deck
    }

    /// The drag over the press at the end: along the profile, and across it.
    fn drag(&self, last: &Last) -> [f64; 2] {
        let force = turn(last.force(), -self.angle);
        let foot = last.contact.last().unwrap().position;
        let [x, y, z] = turn(foot, -self.angle);
        let away = [x / x.hypot(y), y / x.hypot(y), 0.0];
        let normal = match self.surface {
            Surface::Disc => [0.0, 0.0, 1.0],
            Surface::Ball => [x, y, z].map(|own| own / size([x, y, z])),
        };
        let along = [away[0] * normal[2], away[1] * normal[2], -normal[0].hypot(normal[1])];
        let by = |to: Vector| (0..3).map(|k| force[k] * to[k]).sum::<f64>();
        let press = by(normal);
        [by(along) / press, by([-away[1], away[0], 0.0]) / press]
    }
}

fn near(found: [f64; 2], expected: [f64; 2], within: f64) -> bool {
    (found[0] - expected[0]).hypot(found[1] - expected[1]) < within
}

/// Requirement: a foot that is pulled along the profile has the first coefficient, on a disc without a hole and
/// on a ball near its pole, however the whole is turned. On both the axes were those of a chart across the
/// axis. Tolerance: what is left of the transient.
#[test]
fn axis_1_is_the_profile_everywhere() {
    for surface in [Surface::Disc, Surface::Ball] {
        for (mu, stick) in [(MU, ""), ([0.1, 0.4], ""), (MU, ", LAGRANGE")] {
            for angle in [0.0, 0.8] {
                let down = if surface == Surface::Ball { -0.16 } else { 0.0 };
                let way = [0.5, 0.0, down];
                let pull = Pull { surface, mu, stick, angle, way, ..PULL };
                let last = solved(&pull.deck());
                let found = pull.drag(&last);
                assert!(near(found, [-mu[0], 0.0], 1e-6), "{pull:?}: {found:?}");
            }
        }
    }
}

/// Requirement: a surface that turns under a foot drags it along the way of each increment with the second
/// coefficient: the axes go with the place on the surface, not with the material. An increment turns by
/// 0.1, its way is half of that behind. Tolerance: the elastic slip.
#[test]
fn a_surface_that_turns_has_its_axes_where_the_foot_is() {
    for surface in [Surface::Disc, Surface::Ball] {
        for angle in [0.0, 0.8] {
            let pull = Pull { surface, angle, way: [0.0; 3], turns: 0.5, ..PULL };
            let found = pull.drag(&solved(&pull.deck()));
            let expected = match surface {
                Surface::Disc => [-MU[1] * 0.05_f64.sin(), MU[1] * 0.05_f64.cos()],
                Surface::Ball => [found[0], MU[1]],
            };
            assert!(near(found, expected, 1e-3), "{pull:?}: {found:?} {expected:?}");
            assert!(found[0].abs() < 0.06 * MU[1], "{pull:?}: {found:?}");
        }
    }
}

/// Requirement: all ways out of the pole are along the profile: a foot in the pole has the first coefficient in
/// every direction, and beside it as well once it has gone a way that is long to that distance. In at most
/// eight iterations where it stands in the pole.
#[test]
fn every_way_out_of_the_pole_is_along_the_profile() {
    for (mu, stick) in [(MU, ""), ([0.1, 0.4], ""), (MU, ", LAGRANGE"), ([0.0, 0.4], "")] {
        for (towards, angle) in [(0.0_f64, 0.0), (1.1, 0.0), (1.1, 0.8)] {
            // without the first coefficient nothing but sticking across the way is left beside the pole
            for &from in if mu[0] > 0.0 { &[0.0, 1e-6][..] } else { &[0.0] } {
                let way = [0.5 * towards.cos(), 0.5 * towards.sin(), 0.0];
                let pull = Pull { mu, stick, angle, from, way, ..PULL };
                let last = solved(&pull.deck());
                let found = pull.drag(&last);
                assert!(near(found, [-mu[0], 0.0], 1e-4), "{pull:?}: {found:?}");
                assert!(from > 0.0 || last.most() <= 8, "{pull:?}: {:?}", last.iterations);
            }
        }
    }
}

/// Requirement: the tangent is that of the forces but for what turns about the normal, which is small where a
/// way is short to the distance from the axis.
#[test]
fn tangents_are_those_of_the_forces_away_from_the_pole() {
    for surface in [Surface::Disc, Surface::Ball] {
        let last = checked(&Pull { surface, way: [0.5, 0.2, 0.0], ..PULL }.deck());
        assert!(last.off < 2e-3, "{surface:?}: {} {}", last.off, last.told);
    }
}
