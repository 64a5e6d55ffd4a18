//! Contact of surface with surface on faces of plane solids: the patch test, balance, roles.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::mortar_decks::{Block, Kind, Last, solved};

/// Two blocks, one upon the other, compressed by a hundredth of their height: the number of faces
/// of both at the interface, kinds of their elements, which is slave, and how the whole is turned.
struct Patch {
    faces: [usize; 2],
    kinds: [Kind; 2],
    upper_is_slave: bool,
    angle: f64,
    held: bool,
    nlgeom: bool,
}

const MODULUS: f64 = 1e6;
const SQUEEZE: f64 = 0.01;

impl Patch {
    fn turn(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (s, c) = self.angle.sin_cos();
        [c * x - s * y + 3.0 * self.angle, s * x + c * y - self.angle]
    }

    fn deck(&self) -> String {
        let mut deck = String::from("*HEADING\npatch\n");
        let lower = Block { base: 0, cells: [self.faces[0], 3], kind: self.kinds[0] };
        let upper = Block { base: 10_000, cells: [self.faces[1], 2], kind: self.kinds[1] };
        let place = |from: f64| {
            move |[x, y]: [f64; 2]| {
                let bump = |t: f64| t * (1.0 - t);
                [x + 0.25 * bump(x) * bump(y), from + 0.5 * (y + 0.6 * bump(x) * bump(y))]
            }
        };
        lower.write(&mut deck, "LOWER", |at| self.turn(place(0.0)(at)));
        upper.write(&mut deck, "UPPER", |at| self.turn(place(0.5)(at)));
        deck.push_str(&lower.surface("LOWERFACE", "top"));
        deck.push_str(&upper.surface("UPPERFACE", "bottom"));
        let (slave, master) = match self.upper_is_slave {
            true => ("UPPERFACE", "LOWERFACE"),
            false => ("LOWERFACE", "UPPERFACE"),
        };
        deck.push_str(&lower.set("BASE", |_, y| y == 0.0));
        deck.push_str(&upper.set("HEAD", |_, y| y == 1.0));
        let side = |x: f64, _: f64| x == 0.0 || x == 1.0;
        deck.push_str(&lower.set("SIDES", side));
        deck.push_str(&upper.set("OTHERSIDES", side));
        let (s, c) = self.angle.sin_cos();
        let held = if self.held { "SIDES, 1, 1\nOTHERSIDES, 1, 1\n" } else { "" };
        let nlgeom = if self.nlgeom { ", NLGEOM" } else { "" };
        deck + &format!(
            "*MATERIAL, NAME=M\n*ELASTIC\n{MODULUS:?}, 0.0
*SOLID SECTION, ELSET=LOWER, MATERIAL=M\n1.0
*SOLID SECTION, ELSET=UPPER, MATERIAL=M\n1.0
*SURFACE INTERACTION, NAME=I
*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE
{slave}, {master}
*BOUNDARY\nBASE, 1, 2\n{held}*STEP{nlgeom}\n*STATIC\n1.0, 1.0
*BOUNDARY\nHEAD, 1, 1, {:?}\nHEAD, 2, 2, {:?}\n*CONTROLS, PARAMETERS=FIELD\n1e-11\n*END STEP\n",
            SQUEEZE * s,
            -SQUEEZE * c
        )
    }

    /// Requires that every node moves as in uniform compression, to 1e-10.
    fn check(&self) {
        let last = solved(&self.deck());
        let (s, c) = self.angle.sin_cos();
        let [ox, oy] = self.turn([0.0, 0.0]);
        for &(node, [x, y], [u, v]) in &last.nodes {
            let height = -s * (x - ox) + c * (y - oy);
            let exact = [SQUEEZE * height * s, -SQUEEZE * height * c];
            let off = (u - exact[0]).hypot(v - exact[1]);
            assert!(off < 1e-10 * SQUEEZE, "node {node}: {u} {v} {exact:?} {off}");
        }
        for row in &last.contact {
            let exact = MODULUS * SQUEEZE;
            assert!((row.pressure - exact).abs() < 1e-9 * exact, "{row:?}");
        }
        balanced(&last);
    }
}

fn balanced(last: &Last) {
    let size = last.force[0].hypot(last.force[1]);
    assert!(size > 0.0);
    assert!(last.imbalance.iter().all(|off| *off < 1e-11 * size), "{:?} {size}", last.imbalance);
}

/// Requirement: a uniform pressure passes faces that do not match, exactly: with linear and quadratic
/// faces of triangles and quadrilaterals, distorted, in both roles, turned and shifted, with supports
/// at nodes of the interface. Source: Taylor and Papadopoulos' patch test. Tolerance: 1e-10.
#[test]
fn a_uniform_pressure_passes_faces_that_do_not_match() {
    use Kind::{Cpe3, Cpe4, Cpe6, Cpe8, Cps4};
    let kinds =
        [[Cpe4, Cpe4], [Cps4, Cps4], [Cpe8, Cpe8], [Cpe3, Cpe3], [Cpe6, Cpe6], [Cpe4, Cpe8]];
    for kinds in kinds {
        for upper_is_slave in [true, false] {
            for (angle, held) in [(0.0, false), (0.0, true), (0.7, false), (-2.0, false)] {
                let faces = [3, 4];
                Patch { faces, kinds, upper_is_slave, angle, held, nlgeom: false }.check();
            }
        }
    }
}
