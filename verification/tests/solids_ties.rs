//! Meshes that do not match, tied: a uniform stress passes, and a turn makes none.

use slideline_verification::{Claim, Group, Meshed, Record, Solid, run, worst};
use std::fmt::Write as _;

pub const GROUP: Group = Group {
    file: "solids_ties",
    claims: &[
        Claim {
            name: "uniform_stress_passes_a_tie",
            requirement: "two blocks of any element types, tied face to face where their meshes do \
                          not match, either one coarser, pulled: every \
                          node moves as in one block of uniform stress.",
            source: "u = e y along the pull, -nu e x across it, -nu/(1-nu) e x in plane strain.",
            tolerance: "1e-9 of the displacements: rounding of the solution.",
            measure: uniform,
        },
        Claim {
            name: "uniform_stress_passes_a_tie_of_skewed_faces",
            requirement: "the same where faces are no parallelograms.",
            source: "As above; cuts of such faces are curves upon them, and are taken for straight.",
            tolerance: "1e-4 of the displacements; what follows the nearest place is .03 to .4 off.",
            measure: skewed,
        },
        Claim {
            name: "a_turn_leaves_a_curved_tie_without_strain",
            requirement: "two bodies tied along a curved face that their meshes cut in different \
                          ways, turned as one: no strain.",
            source: "Means of positions turn as positions do: the slave stands where they are.",
            tolerance: "1e-9 of the turn: rounding.",
            measure: turned,
        },
    ],
};

const PLANE: [&str; 6] = ["CPS3", "CPS4", "CPE4I", "CPE6", "CPS8", "CPE8R"];
const RINGS: [&str; 3] = ["CAX4", "CAX6", "CAX8R"];
const SPACE: [&str; 7] = ["C3D4", "C3D6", "C3D8I", "C3D10", "C3D15", "C3D20", "C3D20R"];

/// A body of the two, with the numbers that its labels begin behind.
struct Body<'a> {
    solid: Solid<'a>,
    mesh: Meshed,
    behind: u64,
}

impl<'a> Body<'a> {
    fn new(
        element: &'a str,
        cells: [usize; 3],
        map: fn([f64; 3]) -> [f64; 3],
        behind: u64,
    ) -> Self {
        let solid = Solid { element, cells, map, material: "*ELASTIC\n7.0, 0.3\n" };
        let mesh = solid.mesh();
        Self { solid, mesh, behind }
    }

    /// Nodes and elements, and the surface of faces all of whose corners answer yes.
    fn write(&self, name: &str, of: impl Fn([f64; 3]) -> bool, deck: &mut String) {
        deck.push_str("*NODE\n");
        for (label, _, [x, y, z]) in &self.mesh.nodes {
            let _ = writeln!(deck, "{}, {x:?}, {y:?}, {z:?}", label + self.behind);
        }
        let element = self.solid.element;
        let _ = writeln!(deck, "*ELEMENT, TYPE={element}, ELSET={name}");
        for (number, nodes) in self.mesh.elements.iter().enumerate() {
            let _ = write!(deck, "{}", number as u64 + 1 + self.behind);
            for (place, label) in nodes.iter().enumerate() {
                let end = if place == 10 { ",\n" } else { ", " };
                let _ = write!(deck, "{end}{}", label + self.behind);
            }
            deck.push('\n');
        }
        let thick = if self.solid.is_spatial() { "" } else { "1.0\n" };
        let _ = writeln!(
            deck,
            "*SOLID SECTION, ELSET={name}, MATERIAL=M\n{thick}*SURFACE, NAME={name}"
        );
        let inside = self.mesh.labels(of);
        for (number, nodes) in self.mesh.elements.iter().enumerate() {
            for (face, corners) in self.mesh.faces.iter().enumerate() {
                if corners.iter().all(|&corner| inside.binary_search(&nodes[corner]).is_ok()) {
                    let _ = writeln!(deck, "{}, S{}", number as u64 + 1 + self.behind, face + 1);
                }
            }
        }
    }

    fn hold(&self, of: impl Fn([f64; 3]) -> bool, axis: usize, value: f64) -> String {
        let labels = self.mesh.nodes.iter().filter(|(_, _, at)| of(*at));
        labels
            .map(|(label, ..)| format!("{}, {axis}, {axis}, {value:?}\n", label + self.behind))
            .collect()
    }
}

/// Cells of different sizes, every one a brick.
fn lower([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x + 0.3 * x * (1.0 - x), y, z + 0.2 * z * (1.0 - z)]
}

fn upper([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x - 0.25 * x * (1.0 - x), 1.0 + y, z - 0.3 * z * (1.0 - z)]
}

/// Nodes inside moved within planes of their height.
fn skewed_lower([x, y, z]: [f64; 3]) -> [f64; 3] {
    let inside = x * (1.0 - x) * (0.5 + y);
    [x + 0.3 * inside * (1.0 - z), y, z + 0.2 * inside * z * (1.0 - z)]
}

fn skewed_upper([x, y, z]: [f64; 3]) -> [f64; 3] {
    let inside = x * (1.0 - x) * (1.5 - y);
    [x - 0.25 * inside * z, 1.0 + y, z - 0.3 * inside * z * (1.0 - z)]
}

fn flat_lower([x, y, _]: [f64; 3]) -> [f64; 3] {
    [x + 0.2 * x * (1.0 - x), y, 0.0]
}

fn flat_upper([x, y, _]: [f64; 3]) -> [f64; 3] {
    [x - 0.2 * x * (1.0 - x), 1.0 + y, 0.0]
}

fn uniform(record: &mut Record) {
    let plane = (&PLANE[..], flat_lower as fn([f64; 3]) -> [f64; 3], flat_upper as fn(_) -> _);
    let space = (&SPACE[..], lower as fn([f64; 3]) -> [f64; 3], upper as fn(_) -> _);
    for (types, below, above) in [plane, (&RINGS[..], plane.1, plane.2), space] {
        for master in types {
            for slave in types {
                for cells in [[3, 3], [2, 5], [5, 2]] {
                    if master.starts_with("C3D") && cells[0] == 3 && master != slave {
                        continue; // both others are enough
                    }
                    let [m, s] = cells.map(|n| [n, 2, n]);
                    let bodies =
                        [Body::new(master, m, below, 0), Body::new(slave, s, above, 10_000)];
                    let lateral = match () {
                        () if master.starts_with("CPE") != slave.starts_with("CPE") => continue,
                        () if master.starts_with("CPE") => 0.3 / 0.7,
                        () => 0.3,
                    };
                    pulled(record, &bodies, lateral, 1e-9, &format!("{master} {slave} {cells:?}"));
                }
            }
        }
    }
}

fn skewed(record: &mut Record) {
    for (master, slave) in [("C3D8I", "C3D20"), ("C3D20R", "C3D8I"), ("C3D10", "C3D10")] {
        for [m, s] in [[[4, 2, 3], [3, 2, 2]], [[5, 2, 5], [2, 2, 2]]] {
            let bodies =
                [Body::new(master, m, skewed_lower, 0), Body::new(slave, s, skewed_upper, 10_000)];
            pulled(record, &bodies, 0.3, 1e-4, &format!("{master} {slave}, {m:?} on {s:?}"));
        }
    }
}

fn pulled(record: &mut Record, bodies: &[Body<'_>; 2], lateral: f64, limit: f64, name: &str) {
    let mut deck = String::from("*HEADING\ntied\n*MATERIAL, NAME=M\n*ELASTIC\n7.0, 0.3\n");
    bodies[0].write("MASTER", |at| at[1] == 1.0, &mut deck);
    bodies[1].write("SLAVE", |at| at[1] == 0.0, &mut deck);
    deck.push_str("*TIE, NAME=T\nSLAVE, MASTER\n*STEP\n*STATIC\n1.0, 1.0\n*BOUNDARY\n");
    let spatial = bodies[0].solid.is_spatial();
    for body in bodies {
        deck.push_str(&body.hold(|at| at[0] == 0.0, 1, 0.0));
        deck.push_str(&body.hold(|at| at[1] == 0.0, 2, 0.0));
        deck.push_str(&body.hold(|at| at[1] == 2.0, 2, 2e-3));
        if spatial {
            deck.push_str(&body.hold(|at| at[2] == 0.0, 3, 0.0));
        }
    }
    deck.push_str("*CONTROLS, PARAMETERS=FIELD\n1.0E-11\n*END STEP\n");
    let curve = match run(&deck) {
        Ok(curve) => curve,
        Err(why) => return record.holds(format!("{name}: {why}"), false),
    };
    let off = bodies.iter().flat_map(|body| {
        let curve = &curve;
        body.mesh.nodes.iter().flat_map(move |(label, _, [x, y, z])| {
            let exact = [-lateral * x, *y, -0.3 * z].map(|u| 1e-3 * u);
            (0..if spatial { 3 } else { 2 }).map(move |axis| {
                let found = curve.displacement(label + body.behind, axis + 1);
                (found.last().copied().unwrap_or(f64::NAN) - exact[axis]).abs()
            })
        })
    });
    record.at_most(format!("{name}, largest error"), worst(off.collect::<Vec<_>>()) / 2e-3, limit);
}

/// From the unit cube to a bent block, the face at y = 1 of the one upon that at y = 0 of the other.
fn bent(radius: f64, [x, z]: [f64; 2]) -> [f64; 3] {
    let (sine, cosine) = (0.9 - 0.9 * x).sin_cos();
    [radius * cosine, radius * sine, z]
}

fn inner([x, y, z]: [f64; 3]) -> [f64; 3] {
    bent(1.0 + y, [x, z])
}

fn outer([x, y, z]: [f64; 3]) -> [f64; 3] {
    bent(2.0 + y, [x, z])
}

fn turned(record: &mut Record) {
    let pairs = [
        ("CPE4I", "CPE4I"),
        ("CPE8", "CPE4"),
        ("CPE4", "CPE6"),
        ("C3D8I", "C3D8I"),
        ("C3D20R", "C3D8"),
        ("C3D8", "C3D10"),
    ];
    for (master, slave) in pairs {
        for [m, s] in [[3, 4], [5, 2]] {
            let bodies = [
                Body::new(master, [m, 1, 2], inner, 0),
                Body::new(slave, [s, 1, 1], outer, 10_000),
            ];
            turn(record, &bodies, &format!("{master} {slave} {m} on {s}"));
        }
    }
}

fn turn(record: &mut Record, bodies: &[Body<'_>; 2], name: &str) {
    let mut deck = String::from("*HEADING\nturned\n*MATERIAL, NAME=M\n*ELASTIC\n7.0, 0.3\n");
    bodies[0].write("MASTER", |at| at[1] == 1.0, &mut deck);
    bodies[1].write("SLAVE", |at| at[1] == 0.0, &mut deck);
    let held = bodies[0].mesh.labels(|at| at[1] == 0.0);
    let held: Vec<String> = held.iter().map(u64::to_string).collect();
    let spatial = bodies[0].solid.is_spatial();
    let (axes, first) = if spatial { ("9999, 1, 5", "") } else { ("9999, 1, 2", "") };
    let _ = write!(
        deck,
        "*TIE, NAME=T, POSITION TOLERANCE=0.3\nSLAVE, MASTER\n*NODE\n9999, 0.0, 0.0, 0.0\n\
         *NSET, NSET=HELD\n{}\n*SURFACE, NAME=HELD, TYPE=NODE\nHELD\n\
         *COUPLING, CONSTRAINT NAME=C, REF NODE=9999, SURFACE=HELD\n*KINEMATIC{first}\n\
         *STEP, NLGEOM\n*STATIC, DIRECT\n0.25, 1.0\n*BOUNDARY\n{axes}\n9999, 6, 6, 1.0\n*END STEP\n",
        held.join("\n"),
    );
    let curve = match run(&deck) {
        Ok(curve) => curve,
        Err(why) => return record.holds(format!("{name}: {why}"), false),
    };
    // how far every node of the slave is from where the turn takes the place at which it stood
    let (sine, cosine) = 1.0_f64.sin_cos();
    let off = bodies[1].mesh.nodes.iter().map(|(label, ..)| {
        let label = label + bodies[1].behind;
        let index = curve.model.nodes.find(label);
        let at = index.map_or([f64::NAN; 3], |index| curve.model.nodes.position(index));
        let moved = [1, 2].map(|dof| curve.displacement(label, dof).last().copied());
        let exact = [cosine * at[0] - sine * at[1] - at[0], sine * at[0] + cosine * at[1] - at[1]];
        let far = |axis: usize| moved[axis].unwrap_or(f64::NAN) - exact[axis];
        far(0).hypot(far(1))
    });
    record.at_most(format!("{name}, off the turn"), worst(off.collect::<Vec<_>>()), 1e-9);
}
