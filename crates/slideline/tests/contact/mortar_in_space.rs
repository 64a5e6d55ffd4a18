//! Contact of surface with surface on faces of solids in space: the patch test, balance, objectivity,
//! tangents.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::space_decks::{Block, Kind, Last, checked, size, solved, turn};

/// Two blocks, one upon the other, compressed by a hundredth of their height.
struct Patch {
    cells: [[usize; 3]; 2],
    kinds: [Kind; 2],
    upper_is_slave: bool,
    angle: f64,
    held: bool,
}

const MODULUS: f64 = 1e6;
const SQUEEZE: f64 = 0.01;

impl Patch {
    fn turn(&self, at: [f64; 3]) -> [f64; 3] {
        let [x, y, z] = turn(at, self.angle);
        [x + 3.0 * self.angle, y - self.angle, z + 0.3 * self.angle]
    }

    fn deck(&self) -> String {
        let mut deck = String::from("*HEADING\npatch\n");
        let lower = Block { name: "LOWER", base: 0, cells: self.cells[0], kind: self.kinds[0] };
        let upper =
            Block { name: "UPPER", base: 10_000, cells: self.cells[1], kind: self.kinds[1] };
        let place = |from: f64| {
            move |[x, y, z]: [f64; 3]| {
                let bump = |t: f64| t * (1.0 - t);
                let all = bump(x) * bump(y) * bump(z);
                [x + all, y - 0.7 * all, from + 0.5 * (z + all)]
            }
        };
        lower.write(&mut deck, |at| self.turn(place(0.0)(at)));
        upper.write(&mut deck, |at| self.turn(place(0.5)(at)));
        deck.push_str(&lower.surface("LOWERFACE", |[_, _, z]| z == 1.0));
        deck.push_str(&upper.surface("UPPERFACE", |[_, _, z]| z == 0.0));
        let (slave, master) = match self.upper_is_slave {
            true => ("UPPERFACE", "LOWERFACE"),
            false => ("LOWERFACE", "UPPERFACE"),
        };
        deck.push_str(&lower.set("BASE", |[_, _, z]| z == 0.0));
        deck.push_str(&upper.set("HEAD", |[_, _, z]| z == 1.0));
        let side = |[x, y, _]: [f64; 3]| x == 0.0 || x == 1.0 || y == 0.0 || y == 1.0;
        deck.push_str(&lower.set("SIDES", side));
        deck.push_str(&upper.set("OTHERSIDES", side));
        let held = if self.held { "SIDES, 1, 2\nOTHERSIDES, 1, 2\n" } else { "" };
        let [x, y, z] = turn([0.0, 0.0, -SQUEEZE], self.angle);
        deck + &format!(
            "*MATERIAL, NAME=M\n*ELASTIC\n{MODULUS:?}, 0.0
*SOLID SECTION, ELSET=LOWER, MATERIAL=M\n*SOLID SECTION, ELSET=UPPER, MATERIAL=M
*SURFACE INTERACTION, NAME=I
*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE
{slave}, {master}
*BOUNDARY\nBASE, 1, 3\n{held}*STEP\n*STATIC\n1.0, 1.0
*BOUNDARY\nHEAD, 1, 1, {x:?}\nHEAD, 2, 2, {y:?}\nHEAD, 3, 3, {z:?}
*CONTROLS, PARAMETERS=FIELD\n1e-11\n*END STEP\n",
        )
    }

    /// Requires that every node moves as in uniform compression, to 1e-10.
    fn check(&self) {
        let last = solved(&self.deck());
        let up = turn([0.0, 0.0, 1.0], self.angle);
        let origin = self.turn([0.0; 3]);
        let mut most = 0.0_f64;
        for &(_, at, moved) in &last.nodes {
            let height: f64 = (0..3).map(|k| up[k] * (at[k] - origin[k])).sum();
            let off: [f64; 3] = std::array::from_fn(|k| moved[k] + SQUEEZE * height * up[k]);
            most = most.max(size(off));
        }
        let what = (self.kinds, self.upper_is_slave, self.angle, self.held);
        assert!(most < 1e-10 * SQUEEZE, "{what:?} {most:e}");
        for row in &last.contact {
            let exact = MODULUS * SQUEEZE;
            assert!((row.pressure - exact).abs() < 1e-9 * exact, "{what:?} {row:?}");
        }
        assert!(size(last.force()) > 0.0 && last.worst < 1e-11, "{what:?} {}", last.worst);
    }
}

/// Requirement: a uniform pressure passes faces that do not match, exactly: with linear and quadratic
/// faces of hexahedra and tetrahedra, in both roles, turned and shifted, with supports at nodes
/// of the interface. Source: Taylor and Papadopoulos' patch test. Tolerance: 1e-10.
#[test]
fn a_uniform_pressure_passes_faces_that_do_not_match() {
    use Kind::{C3d4, C3d8, C3d8i, C3d10, C3d20, C3d20r};
    let kinds = [
        [C3d8, C3d8],
        [C3d8i, C3d8],
        [C3d4, C3d4],
        [C3d10, C3d10],
        [C3d20, C3d20],
        [C3d20r, C3d20r],
        [C3d8, C3d10],
        [C3d20, C3d4],
    ];
    for kinds in kinds {
        for upper_is_slave in [true, false] {
            for (angle, held) in [(0.0, true), (0.7, false)] {
                let cells = [[2, 3, 2], [3, 2, 1]];
                Patch { cells, kinds, upper_is_slave, angle, held }.check();
            }
        }
    }
}

/// Requirement: faces that match pass it likewise: edges lie on edges.
#[test]
fn faces_that_match_pass_it_too() {
    for kind in [Kind::C3d8, Kind::C3d10] {
        let cells = [[2, 2, 1], [2, 2, 1]];
        Patch { cells, kinds: [kind; 2], upper_is_slave: true, angle: 0.0, held: false }.check();
    }
}

/// A block on a foundation, pressed and then slid and turned about its axis, the whole turned.
struct Slid {
    kinds: [Kind; 2],
    friction: f64,
    law: &'static str,
    angle: f64,
    unit: f64,
    way: f64,
}

const SLID: Slid =
    Slid { kinds: [Kind::C3d8; 2], friction: 0.25, law: "", angle: 0.0, unit: 1.0, way: 0.4 };

impl Slid {
    fn deck(&self) -> String {
        let mut deck = String::from("*HEADING\nslid\n");
        let lower = Block { name: "F", base: 0, cells: [4, 4, 1], kind: self.kinds[0] };
        let upper = Block { name: "B", base: 10_000, cells: [2, 2, 1], kind: self.kinds[1] };
        let placed = |at: [f64; 3]| turn(at.map(|x| self.unit * x), self.angle);
        lower.write(&mut deck, |[x, y, z]| placed([3.0 * x, 3.0 * y, z]));
        // a foot that is somewhat round, and reaches beyond the edge as it slides
        let round = |x: f64, y: f64| 0.06 * ((x - 0.5).powi(2) + (y - 0.4).powi(2));
        upper.write(&mut deck, |[x, y, z]| {
            placed([2.1 + 0.7 * x, 0.9 + 0.8 * y, 1.0 + round(x, y) * (1.0 - z) + 0.6 * z])
        });
        deck.push_str(&lower.surface("TOP", |[_, _, z]| z == 1.0));
        deck.push_str(&upper.surface("FOOT", |[_, _, z]| z == 0.0));
        deck.push_str(&lower.set("BASE", |[_, _, z]| z == 0.0));
        deck.push_str(&upper.set("HEAD", |[_, _, z]| z == 1.0));
        let modulus = 1000.0 / (self.unit * self.unit);
        let friction = match self.friction {
            0.0 => String::new(),
            mu => format!("*FRICTION\n{mu}\n"),
        };
        deck += &format!(
            "*MATERIAL, NAME=M\n*ELASTIC\n{modulus:?}, 0.3
*SOLID SECTION, ELSET=F, MATERIAL=M\n*SOLID SECTION, ELSET=B, MATERIAL=M
*SURFACE INTERACTION, NAME=I\n{}{friction}
*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nFOOT, TOP\n",
            self.law
        );
        for (end, increments) in [([0.0, 0.0, -0.06], 3), ([self.way, 0.15, -0.06], 6)] {
            let each = 1.0 / f64::from(increments);
            deck += &format!(
                "*STEP, NLGEOM\n*STATIC\n{each:?}, 1., 1e-5, {each:?}\n*BOUNDARY\nBASE, 1, 3\n"
            );
            let end = turn(end.map(|u| self.unit * u), self.angle);
            for (dof, u) in end.iter().enumerate() {
                deck += &format!("HEAD, {0}, {0}, {u:?}\n", dof + 1);
            }
            deck.push_str("*END STEP\n");
        }
        deck
    }
}

fn report(last: &Last) -> String {
    format!("{:?} {:e} {:e}\n{}", last.iterations, last.worst, last.off, last.told)
}

/// Requirement: the assembled tangent is that of the forces, in every iteration: pressed, slid with
/// friction beyond an edge, under hard and softened laws, with linear and quadratic faces.
#[test]
fn tangents_are_those_of_the_forces() {
    let soft = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n5000.\n";
    for (kinds, friction, law) in [
        ([Kind::C3d8; 2], 0.0, ""),
        ([Kind::C3d8; 2], 0.25, ""),
        ([Kind::C3d8, Kind::C3d10], 0.25, ""),
        ([Kind::C3d4, Kind::C3d8], 0.25, soft),
    ] {
        let last = checked(&Slid { kinds, friction, law, way: 0.2, ..SLID }.deck());
        assert!(last.off < 2e-6, "{kinds:?} {friction} {law} {}", report(&last));
        assert!(last.worst < 1e-11, "{}", report(&last));
    }
}

/// Requirement: a model turned in space, and one in other units, gives the same forces turned: pressed,
/// slid over the edge of its foundation, with friction. Forces and moments balance; no increment
/// takes more than six iterations.
#[test]
fn a_turned_model_gives_turned_forces() {
    let still = solved(&SLID.deck());
    let turned = solved(&Slid { angle: 0.8, ..SLID }.deck());
    let other_units = solved(&Slid { unit: 1024.0, ..SLID }.deck());
    for ((a, b), c) in still.forces.iter().zip(&turned.forces).zip(&other_units.forces) {
        let expected = turn(*a, 0.8);
        let off: [f64; 3] = std::array::from_fn(|k| b[k] - expected[k]);
        assert!(size(off) < 1e-6 * size(*a), "{b:?} {expected:?}");
        let off: [f64; 3] = std::array::from_fn(|k| c[k] - a[k]);
        assert!(size(off) < 1e-6 * size(*a), "{c:?} {a:?}");
    }
    assert!(still.worst < 1e-11 && turned.worst < 1e-11, "{}", report(&still));
    assert!(still.iterations.iter().all(|&own| own <= 6), "{}", report(&still));
}
