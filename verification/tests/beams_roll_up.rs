//! Simo and Vu-Quoc's roll-up: a cantilever under a moment at its end.

use slideline::output::plot::{Axis, Mark, Series};
use slideline_theory::closed::roll_up;
use slideline_verification::{Claim, Group, Record, run, worst};
use std::f64::consts::{PI, TAU};

pub const GROUP: Group = Group {
    file: "beams_roll_up",
    claims: &[
        Claim {
            name: "polygon_at_every_load_and_closed_at_the_last",
            requirement: "Curvature is exact in the two-node one-point element, so that the nodes lie \
                      on a regular polygon at every load and close at 2 pi, within ten increments.",
            source: "Simo and Vu-Quoc (1986); the polygon is derived.",
            tolerance: "1e-10 of the length: no discretisation error is left, only the residual at \
                    which Newton stops.",
            measure: polygon_at_every_load_and_closed_at_the_last,
        },
        Claim {
            name: "turns_without_effort",
            requirement: "A full circle takes at most ten increments of at most five iterations and no \
                      cutback, two circles twice as many, for every beam element, on meshes of 10 to \
                      80, in any units; B21 and B22 reach it in a single increment.",
            source: "Magisano, Leonetti and Garcea (2017): stresses as unknowns of the linearisation, \
                 docs/theory.md section 3.3. With stresses from strains the same run takes 40 \
                 increments and 361 iterations.",
            tolerance: "None: counts. The tip ends on the clamp to 1e-9 of the length, as the polygon \
                    does: rounding is below it.",
            measure: turns_without_effort,
        },
    ],
};

const ELEMENTS: usize = 10;

/// EI = 1, L = 1, end moment 2 pi.
fn deck() -> String {
    format!(
        "*HEADING\nroll-up\n*NODE, NSET=BEAM\n1, 0.0, 0.0\n11, 1.0, 0.0\n*NGEN, NSET=BEAM\n\
         1, 11, 1\n*ELEMENT, TYPE=B21, ELSET=BEAM\n1, 1, 2\n*ELGEN, ELSET=BEAM\n1, {ELEMENTS}, 1, 1\n\
         *BEAM SECTION, ELSET=BEAM, SECTION=RECT, MATERIAL=M\n1.0, 0.1\n\
         *MATERIAL, NAME=M\n*ELASTIC\n12000.0, 0.0\n\
         *STEP, NLGEOM\n*STATIC\n0.1, 1.0, 1.0E-6, 0.1\n*BOUNDARY\n1, ENCASTRE\n\
         *CLOAD\n11, 6, {:?}\n*CONTROLS, PARAMETERS=FIELD\n1.0E-11\n*END STEP\n",
        2.0 * PI
    )
}

fn polygon_at_every_load_and_closed_at_the_last(record: &mut Record) {
    let curve = run(&deck()).unwrap();
    record.equal("increments", curve.rows.len(), 10);
    let (x, y) = (curve.displacement(11, 1), curve.displacement(11, 2));
    let off = curve.rows.iter().enumerate().map(|(k, row)| {
        let [tip_x, tip_y] = roll_up::polygon_tip(2.0 * PI * row.time, ELEMENTS);
        (1.0 + x[k] - tip_x).hypot(y[k] - tip_y)
    });
    record.at_most("tip from the polygon's, largest (of L)", worst(off), 1e-10);
    record.at_most("tip from the clamp at 2 pi (of L)", (1.0 + x[9]).hypot(y[9]), 1e-10);
    let turn = (curve.displacement(11, 6)[9] - 2.0 * PI).abs();
    record.at_most("rotation of the tip less 2 pi", turn, 1e-10);
    record.tell("iterations an increment", curve.mean_iterations());
    let shape = |k: usize| Series {
        name: format!("load {}0 %", k + 1),
        points: (1..=11)
            .map(|label| {
                let [u, v] = [1, 2].map(|dof| curve.displacement(label, dof)[k]);
                [0.1 * (label - 1) as f64 + u, v]
            })
            .collect(),
        mark: Mark::Curve,
        colour: 0,
    };
    let shapes = [0, 2, 4, 6, 9].map(shape).to_vec();
    let (x, y) = (Axis::linear("x / L"), Axis::linear("y / L"));
    record.chart("Rolled up by a moment at the tip", x, y, shapes);
}

/// A slender cantilever of `n` elements under the end moment of so many `turns`. Units: `length` and
/// `force` are those of the deck in the first one's (10 long, 1 by 0.1, E = 1.2e7).
struct Roll {
    kind: &'static str,
    n: usize,
    increment: f64,
    turns: f64,
    length: f64,
    force: f64,
}

impl Roll {
    const FIRST: Self =
        Self { kind: "B21", n: 10, increment: 0.1, turns: 1.0, length: 1.0, force: 1.0 };

    fn deck(&self) -> String {
        let &Self { kind, n, increment, turns, length, force } = self;
        let middle = if kind == "B22" { 2 } else { 1 };
        let nodes = if kind == "B22" { "1, 2, 3" } else { "1, 2" };
        let last = 1 + n * middle;
        format!(
            "*NODE, NSET=BEAM\n1, 0., 0.\n{last}, {long:?}, 0.\n*NGEN, NSET=BEAM\n1, {last}\n\
             *ELEMENT, TYPE={kind}, ELSET=BEAM\n1, {nodes}\n\
             *ELGEN, ELSET=BEAM\n1, {n}, {middle}, 1\n\
             *BEAM SECTION, ELSET=BEAM, SECTION=RECT, MATERIAL=M\n{wide:?}, {high:?}\n\
             *MATERIAL, NAME=M\n*ELASTIC\n{modulus:?}, 0.3\n*STEP, NLGEOM, INC=200\n*STATIC\n\
             {increment:?}, 1., 1e-6, {increment:?}\n*BOUNDARY\n1, 1, 6\n\
             *CLOAD\n{last}, 6, {moment:?}\n*END STEP\n",
            long = 10.0 * length,
            wide = length,
            high = 0.1 * length,
            modulus = 1.2e7 * force / (length * length),
            moment = turns * TAU * 100.0 * force * length,
        )
    }

    /// Increments, cutbacks, most iterations of one increment, and how far the tip ends from the
    /// clamp (of L).
    fn walk(&self) -> [f64; 4] {
        let curve = run(&self.deck()).unwrap();
        let most = curve.rows.iter().map(|row| row.equilibrium + row.severe).max().unwrap_or(0);
        let tip = (1 + self.n * if self.kind == "B22" { 2 } else { 1 }) as u64;
        let [x, y] = [1, 2].map(|dof| curve.displacement(tip, dof).last().copied().unwrap());
        let off = (1.0 + x / (10.0 * self.length)).hypot(y / (10.0 * self.length));
        [curve.rows.len() as f64, curve.totals.cutbacks as f64, most as f64, off]
    }
}

fn turns_without_effort(record: &mut Record) {
    let mut walk = |name: &str, roll: Roll, increments: f64| {
        let [count, cutbacks, most, off] = roll.walk();
        record.at_most(format!("{name}: increments"), count, increments);
        record.at_most(format!("{name}: cutbacks"), cutbacks, 0.0);
        record.at_most(format!("{name}: iterations of an increment, most"), most, 5.0);
        record.at_most(format!("{name}: tip from the clamp (of L)"), off, 1e-9);
    };
    for kind in ["B21", "B22", "B23"] {
        for n in [10, 20, 40, 80] {
            let one = Roll { kind, n, ..Roll::FIRST };
            walk(&format!("{n} {kind}"), one, 10.0);
            let two = Roll { kind, n, turns: 2.0, increment: 0.05, ..Roll::FIRST };
            walk(&format!("{n} {kind}, two circles"), two, 20.0);
        }
        let small = Roll { kind, length: 1e-6, force: 3.7e4, ..Roll::FIRST };
        walk(&format!("10 {kind}, lengths times 1e-6, forces times 3.7e4"), small, 10.0);
        let large = Roll { kind, length: 2.54e3, force: 1e-5, ..Roll::FIRST };
        walk(&format!("10 {kind}, lengths times 2540, forces times 1e-5"), large, 10.0);
    }
    for kind in ["B21", "B22"] {
        let at_once = Roll { kind, increment: 1.0, ..Roll::FIRST };
        walk(&format!("10 {kind}, at once"), at_once, 1.0);
    }
}
