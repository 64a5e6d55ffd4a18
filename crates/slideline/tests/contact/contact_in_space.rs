//! Contact of solids in space: nodes on faces, pressed, slid and turned.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::space_decks::{Last, ended, size, solved, turn};
use slideline::SolveOptions;
use slideline::observe::Ending;
use std::fmt::Write as _;

/// A brick of C3D8: its numbers of cells, its corner and size, and the turn of the whole model.
struct Brick {
    name: &'static str,
    base: usize,
    cells: [usize; 3],
    corner: [f64; 3],
    size: [f64; 3],
}

impl Brick {
    fn node(&self, [i, j, k]: [usize; 3]) -> usize {
        let [nx, ny, _] = self.cells;
        self.base + 1 + i + (nx + 1) * (j + (ny + 1) * k)
    }

    fn element(&self, [i, j, k]: [usize; 3]) -> usize {
        let [nx, ny, _] = self.cells;
        self.base + 1 + i + nx * (j + ny * k)
    }

    fn write(&self, deck: &mut String, angle: f64) {
        let [nx, ny, nz] = self.cells;
        let all = |[nx, ny, nz]: [usize; 3]| {
            let of_layer = move |k| (0..ny).flat_map(move |j| (0..nx).map(move |i| [i, j, k]));
            (0..nz).flat_map(of_layer)
        };
        deck.push_str("*NODE\n");
        for place in all([nx + 1, ny + 1, nz + 1]) {
            let at: [f64; 3] = std::array::from_fn(|c| {
                self.corner[c] + self.size[c] * place[c] as f64 / self.cells[c] as f64
            });
            let [x, y, z] = turn(at, angle);
            let _ = writeln!(deck, "{}, {x:?}, {y:?}, {z:?}", self.node(place));
        }
        let _ = writeln!(deck, "*ELEMENT, TYPE=C3D8, ELSET={}", self.name);
        for [i, j, k] in all(self.cells) {
            let corner = |a, b, c| self.node([i + a, j + b, k + c]);
            let nodes = [
                corner(0, 0, 0),
                corner(1, 0, 0),
                corner(1, 1, 0),
                corner(0, 1, 0),
                corner(0, 0, 1),
                corner(1, 0, 1),
                corner(1, 1, 1),
                corner(0, 1, 1),
            ];
            let nodes = nodes.map(|n| n.to_string()).join(", ");
            let _ = writeln!(deck, "{}, {nodes}", self.element([i, j, k]));
        }
        for (set, k) in [("BOTTOM", 0), ("TOP", nz)] {
            let _ = writeln!(deck, "*NSET, NSET={set}-{}", self.name);
            for [i, j, _] in all([nx + 1, ny + 1, 1]) {
                let _ = writeln!(deck, "{}", self.node([i, j, k]));
            }
        }
        for (name, face, k) in [("LOWER", "S1", 0), ("UPPER", "S2", nz - 1)] {
            let _ = writeln!(deck, "*SURFACE, NAME={name}-{}", self.name);
            for [i, j, _] in all([nx, ny, 1]) {
                let _ = writeln!(deck, "{}, {face}", self.element([i, j, k]));
            }
        }
    }
}

impl Brick {
    /// The side of the brick as plane solids: x and z of its cells at y = 0.
    fn write_side(&self, deck: &mut String) {
        let [nx, _, nz] = self.cells;
        let node = |i: usize, k: usize| self.base + 1 + i + (nx + 1) * k;
        let element = |i: usize, k: usize| self.base + 1 + i + nx * k;
        deck.push_str("*NODE\n");
        for k in 0..=nz {
            for i in 0..=nx {
                let at = |axis: usize, place: usize| {
                    self.corner[axis] + self.size[axis] * place as f64 / self.cells[axis] as f64
                };
                let _ = writeln!(deck, "{}, {:?}, {:?}", node(i, k), at(0, i), at(2, k));
            }
        }
        let _ = writeln!(deck, "*ELEMENT, TYPE=CPE4, ELSET={}", self.name);
        for k in 0..nz {
            for i in 0..nx {
                let nodes = [node(i, k), node(i + 1, k), node(i + 1, k + 1), node(i, k + 1)];
                let nodes = nodes.map(|n| n.to_string()).join(", ");
                let _ = writeln!(deck, "{}, {nodes}", element(i, k));
            }
        }
        let (face, k) = if self.name == "F" { ("S3", nz - 1) } else { ("S1", 0) };
        let _ = writeln!(deck, "*SURFACE, NAME=SIDE-{}", self.name);
        for i in 0..nx {
            let _ = writeln!(deck, "{}, {face}", element(i, k));
        }
        let _ = writeln!(deck, "*NSET, NSET=TOP-{}", self.name);
        for i in 0..=nx {
            let _ = writeln!(deck, "{}", node(i, nz));
        }
    }
}

/// A block on a foundation, pressed by 0.05 and then slid by (0.5, 0.2), the whole turned.
struct Blocks {
    block: [usize; 3],
    foundation: [usize; 3],
    rigid_foundation: bool,
    friction: f64,
    angle: f64,
    slide: bool,
    unit: f64,
}

const BLOCKS: Blocks = Blocks {
    block: [2, 2, 2],
    foundation: [5, 5, 2],
    rigid_foundation: false,
    friction: 0.0,
    angle: 0.0,
    slide: false,
    unit: 1.0,
};

impl Blocks {
    fn deck(&self) -> String {
        let mut deck = String::new();
        let own = |name, base, cells, corner: [f64; 3], size: [f64; 3]| Brick {
            name,
            base,
            cells,
            corner: corner.map(|x| self.unit * x),
            size: size.map(|x| self.unit * x),
        };
        let first = own("F", 0, self.foundation, [0.0; 3], [3.0, 3.0, 1.0]);
        let second = own("B", 5000, self.block, [0.53, 0.97, 1.0], [1.0, 1.0, 1.0]);
        first.write(&mut deck, self.angle);
        second.write(&mut deck, self.angle);
        let modulus = 1000.0 / (self.unit * self.unit);
        let _ = writeln!(
            deck,
            "*MATERIAL, NAME=M\n*ELASTIC\n{modulus:?}, 0.3\n\
             *SOLID SECTION, ELSET=F, MATERIAL=M\n*SOLID SECTION, ELSET=B, MATERIAL=M\n\
             *SURFACE INTERACTION, NAME=I\n*FRICTION\n{}\n\
             *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nLOWER-B, UPPER-F",
            self.friction
        );
        let still = if self.rigid_foundation { "F" } else { "BOTTOM-F" };
        if self.rigid_foundation {
            deck.push_str("*NSET, NSET=F, ELSET=F\n");
        }
        let mut step = |end: [f64; 3], increments: usize| {
            let each = 1.0 / increments as f64;
            let _ = writeln!(
                deck,
                "*STEP, NLGEOM\n*STATIC\n{each:?}, 1., 1e-5, {each:?}\n*BOUNDARY\n{still}, 1, 3"
            );
            let end = turn(end.map(|u| self.unit * u), self.angle);
            for (dof, u) in end.iter().enumerate() {
                let _ = writeln!(deck, "TOP-B, {0}, {0}, {u:?}", dof + 1);
            }
            deck.push_str("*END STEP\n");
        };
        step([0.0, 0.0, -0.05], 4);
        if self.slide {
            step([0.5, 0.2, -0.05], 10);
        }
        deck
    }
}

/// Requirement: on a foundation that does not give, a block carries what it carries on supports: its
/// nodes stand on a plane, whatever the faces below them, and pressures act along its normal. The
/// whole balances to rounding.
#[test]
fn a_rigid_foundation_is_a_plane() {
    let blocks = Blocks { rigid_foundation: true, ..BLOCKS };
    let on_foundation = solved(&blocks.deck());
    assert!(on_foundation.worst < 1e-12, "{}", on_foundation.worst);
    let other = Blocks { foundation: [7, 4, 1], ..blocks };
    let other = solved(&other.deck());
    for (a, b) in on_foundation.contact.iter().zip(&other.contact) {
        assert!(a.opening.abs() < 1e-12 && (a.normal[2] - 1.0).abs() < 1e-12);
        assert!((a.pressure - b.pressure).abs() < 1e-9 * a.pressure.abs());
    }
    assert!((on_foundation.force()[2] - other.force()[2]).abs() < 1e-9 * other.force()[2]);
}

/// Requirement: a block that slides obliquely is held back by mu N against its way, and every point
/// by mu p, with no more than four iterations in an increment; forces and moments of slaves and
/// faces balance to rounding.
#[test]
fn a_sliding_block_is_held_back_by_mu_times_its_pressure() {
    let blocks = Blocks { rigid_foundation: true, friction: 0.25, slide: true, ..BLOCKS };
    let last = solved(&blocks.deck());
    let way = [0.5, 0.2].map(|u| u / 0.5_f64.hypot(0.2));
    let tangential = [last.force()[0], last.force()[1]];
    let along = -(tangential[0] * way[0] + tangential[1] * way[1]);
    assert!((along - 0.25 * last.force()[2]).abs() < 1e-2 * along, "{:?}", last.force());
    for row in last.contact.iter().filter(|row| row.pressure > 0.0) {
        assert!((row.shear.size() - 0.25 * row.pressure).abs() < 1e-9 * row.pressure);
    }
    assert!(last.most() <= 4, "{} iterations", last.most());
    assert!(last.worst < 1e-12, "{}", last.worst);
}

/// Requirement: a model turned in space, and one in other units, gives the same forces turned and the
/// same iterations: on bending faces, with friction, pressed and slid.
#[test]
fn a_turned_model_gives_turned_forces() {
    let blocks = Blocks { friction: 0.25, slide: true, ..BLOCKS };
    let still = solved(&blocks.deck());
    let all = |last: &Last| last.iterations.iter().sum::<usize>();
    let turned = solved(&Blocks { angle: 0.8, ..blocks }.deck());
    let other_units = solved(&Blocks { unit: 1e3, ..blocks }.deck());
    for ((a, b), c) in still.forces.iter().zip(&turned.forces).zip(&other_units.forces) {
        let expected = turn(*a, 0.8);
        let off: [f64; 3] = std::array::from_fn(|k| b[k] - expected[k]);
        assert!(size(off) < 1e-6 * size(*a), "{b:?} {expected:?}");
        let off: [f64; 3] = std::array::from_fn(|k| c[k] - a[k]);
        assert!(size(off) < 1e-6 * size(*a), "{c:?} {a:?}");
    }
    assert!(all(&turned).abs_diff(all(&still)) <= 2);
    assert!(still.worst < 1e-11, "{}", still.worst);
    assert!(all(&still) <= 3 * still.forces.len(), "{} iterations", all(&still));
}

/// Depth of the strip in space: that of its cells along the way, whose length the slip of sticking
/// points is measured by. In the plane it is 1.
const DEEP: f64 = 1.0 / 3.0;

/// The strip of [`a_strip_in_space_is_one_in_plane_strain`], in the plane or one cell deep.
fn strip(in_space: bool) -> String {
    let mut deck = String::new();
    let foundation =
        Brick { name: "F", base: 0, cells: [5, 1, 1], corner: [0.0; 3], size: [3.0, DEEP, 1.0] };
    let block = Brick {
        name: "B",
        base: 5000,
        cells: [3, 1, 3],
        corner: [0.53, 0.0, 1.0],
        size: [1.0, DEEP, 1.0],
    };
    for own in [&foundation, &block] {
        match in_space {
            true => own.write(&mut deck, 0.0),
            false => own.write_side(&mut deck),
        }
    }
    let pair = if in_space { "LOWER-B, UPPER-F" } else { "SIDE-B, SIDE-F" };
    let (across, up) = if in_space { ("ALL, 2, 2\n", 3) } else { ("", 2) };
    let _ = writeln!(
        deck,
        "*NSET, NSET=ALL, ELSET=F\n*NSET, NSET=ALL, ELSET=B\n*NSET, NSET=STILL, ELSET=F\n\
         *MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n\
         *SOLID SECTION, ELSET=F, MATERIAL=M\n*SOLID SECTION, ELSET=B, MATERIAL=M\n\
         *SURFACE INTERACTION, NAME=I\n*FRICTION\n0.2\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\n{pair}"
    );
    for (x, z) in [(0.0, -0.05), (0.5, -0.05)] {
        let _ = writeln!(
            deck,
            "*STEP, NLGEOM\n*STATIC\n.1, 1., 1e-5, .1\n*BOUNDARY\n{across}STILL, 1, {up}\n\
             TOP-B, 1, 1, {x}\nTOP-B, {up}, {up}, {z}\n*END STEP"
        );
    }
    deck
}

/// Requirement: a strip one cell deep that cannot move across itself is one in plane strain: normal
/// force and friction of every increment are those of CPE4 against a slide line, pressed and slid.
#[test]
fn a_strip_in_space_is_one_in_plane_strain() {
    let (space, plane) = (solved(&strip(true)), solved(&strip(false)));
    assert_eq!(space.forces.len(), plane.forces.len());
    for (space, plane) in space.forces.iter().zip(&plane.forces) {
        let off = (space[0] / DEEP - plane[0]).hypot(space[2] / DEEP - plane[1]);
        assert!(off < 1e-7 * plane[1].abs(), "{space:?} {plane:?}");
    }
}

/// Requirement: a block led through a thin plate in one increment is not let through unsaid: the run
/// goes back and finds the contact, or ends with a diagnosis.
#[test]
fn nothing_passes_through_a_plate_unseen() {
    let mut deck = String::new();
    let plate =
        Brick { name: "F", base: 0, cells: [3, 3, 1], corner: [0.0; 3], size: [3.0, 3.0, 0.1] };
    let block = Brick {
        name: "B",
        base: 5000,
        cells: [1, 1, 1],
        corner: [1.2, 1.3, 0.3],
        size: [0.5, 0.5, 0.2],
    };
    plate.write(&mut deck, 0.0);
    block.write(&mut deck, 0.0);
    deck.push_str(
        "*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n\
         *SOLID SECTION, ELSET=F, MATERIAL=M\n*SOLID SECTION, ELSET=B, MATERIAL=M\n\
         *SURFACE, NAME=PLATE\nF\n*SURFACE INTERACTION, NAME=I\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nLOWER-B, PLATE\n\
         *NSET, NSET=ALL-B, ELSET=B\n*NSET, NSET=ALL-F, ELSET=F\n\
         *STEP, NLGEOM\n*STATIC\n1., 1., 1e-3, 1.\n*BOUNDARY\nALL-F, 1, 3\nALL-B, 1, 2\nALL-B, 3, 3, -1.5\n\
         *END STEP\n",
    );
    let (ending, last) = ended(&deck, &SolveOptions::default());
    let Ending::NotConverged(_, said) = &ending else {
        panic!("passed: {ending:?} {:?}", last.force())
    };
    assert!(said.code.0.starts_with("SL05"), "{said:?}");
}
