//! A round bar of metal in tension: even, then necking.
//!
//! ```text
//!   <--|      )__(      |-->     R = 6.413, L = 53.334, the middle thinner by 1.8 %;
//!   <--|      )  (      |-->     a quarter of the section, ends slide and move by 7
//! ```

use slideline_theory::closed::tension::{Bar, bridgman};
use slideline_verification::{Claim, Curve, Group, Meshed, Record, Solid, run};
use std::f64::consts::PI;
use std::fmt::Write as _;

pub const GROUP: Group = Group {
    file: "solids_necking",
    claims: &[
        Claim {
            name: "even_bar_in_tension",
            requirement: "the force of an even bar over its elongation, past the largest one.",
            source: "closed form: Kirchhoff's stress over the logarithmic strain, contraction by nu \
                     and at constant plastic volume; material of Simo and Hughes (1998).",
            tolerance: "1e-5: every increment is exact, the table has 80 lines.",
            measure: even,
        },
        Claim {
            name: "necking_bar",
            requirement: "a bar that is thinner in the middle carries at most Considere's force, and \
                          then necks: its force over the area of the neck is the flow stress at the \
                          strain of the neck by Bridgman's factor for the neck's own profile.",
            source: "problem of J. C. Simo and T. J. R. Hughes, Computational Inelasticity (1998), \
                     chapter 9, and of Simo (1988), elongation 14; A. Considere (1885) with the area \
                     of the middle as lower and of the bar as upper bound; P. W. Bridgman (1944).",
            tolerance: "Considere's bounds as they are; 5 % of Bridgman's stress, whose assumptions \
                        (arcs, even strain in the neck) are no better; the neck at the end to 5 %. \
                        CAX4R is told: its hourglass control stays elastic where the metal flows.",
            measure: necking,
        },
        Claim {
            name: "necking_sheet",
            requirement: "the same bar in plane strain, 12.826 wide, carries at most Considere's force \
                          of plane strain; C3D8 held across is CPE4.",
            source: "Simo and Hughes (1998); von Mises in plane strain.",
            tolerance: "0.2 % beyond Considere's bounds, for the elastic strain across; 1e-6 between \
                        elements of plane and space, which are one formulation.",
            measure: sheet,
        },
    ],
};

const RADIUS: f64 = 6.413;
const HALF: f64 = 26.667;
const BULK: f64 = 164.206;
const SHEAR: f64 = 80.1938;
const MODULUS: f64 = 9.0 * BULK * SHEAR / (3.0 * BULK + SHEAR);

/// Saturating and linear hardening.
fn yield_stress(plastic: f64) -> f64 {
    0.45 + 0.12924 * plastic + (0.715 - 0.45) * (1.0 - (-16.93 * plastic).exp())
}

/// The same as a table, which is straight between its lines; dense where it bends.
fn lines() -> Vec<[f64; 2]> {
    let at = |k: usize| 2.0 * (k as f64 / 80.0).powi(3);
    (0..=80).map(|k| [yield_stress(at(k)), at(k)]).collect()
}

/// What the program has: straight between the lines of the table.
fn tabulated(plastic: f64) -> f64 {
    let table = lines();
    let next = table.iter().position(|line| line[1] > plastic).unwrap_or(80).max(1);
    let ([low, from], [high, to]) = (table[next - 1], table[next]);
    low + (high - low) * (plastic - from) / (to - from)
}

fn material() -> String {
    let poisson = MODULUS / (2.0 * SHEAR) - 1.0;
    let mut text = format!("*ELASTIC\n{MODULUS:?}, {poisson:?}\n*PLASTIC\n");
    for [stress, strain] in lines() {
        let _ = writeln!(text, "{stress:?}, {strain:?}");
    }
    text
}

/// From the axis, or the plane of symmetry, out and up from the middle; elements grow away from the middle.
fn bar([x, y, z]: [f64; 3]) -> [f64; 3] {
    let height = 0.2 * y + 0.8 * y * y;
    [RADIUS * x * (0.982 + 0.018 * height), HALF * height, z]
}

fn pulled(solid: &Solid<'_>, step: &str, moved: f64) -> Result<(Curve, Meshed), String> {
    let mesh = solid.mesh();
    let mut deck =
        format!("*HEADING\nbar\n{}*STEP, NLGEOM, INC=1000\n*STATIC\n{step}\n", mesh.text);
    deck.push_str("*BOUNDARY\n");
    if solid.is_spatial() {
        deck.push_str(&mesh.hold(|_| true, 3, 0.0));
    }
    deck.push_str(&mesh.hold(|at| at[0] == 0.0, 1, 0.0));
    deck.push_str(&mesh.hold(|at| at[1] == 0.0, 2, 0.0));
    deck.push_str(&mesh.hold(|at| at[1] == 1.0, 2, moved));
    deck.push_str("*END STEP\n");
    Ok((run(&deck)?, mesh))
}

/// Force at the moved end, increment by increment.
fn forces(curve: &Curve, mesh: &Meshed) -> Vec<f64> {
    let end = mesh.labels(|at| at[1] == 1.0);
    let columns: Vec<Vec<f64>> = end.iter().map(|&label| curve.reaction(label, 2)).collect();
    (0..curve.rows.len()).map(|k| columns.iter().map(|column| column[k]).sum()).collect()
}

fn even(record: &mut Record) {
    let bar = Bar { modulus: MODULUS, yield_stress: tabulated };
    let material = material();
    for element in ["CAX4", "CAX4R", "CAX8R", "CAX6"] {
        let solid = Solid {
            element,
            cells: [1, 2, 1],
            map: |[x, y, _]| [RADIUS * x, HALF * y, 0.0],
            material: &material,
        };
        match pulled(&solid, "0.05, 1.0, 1.0E-6, 0.05", 6.0) {
            Ok((curve, mesh)) => {
                let moved = curve.displacement(mesh.nearest([0.0, 1.0, 0.0]), 2);
                let exact = moved.iter().map(|u| nominal(&bar, 1.0 + u / HALF));
                let area = PI * RADIUS * RADIUS;
                let off = forces(&curve, &mesh).into_iter().zip(exact);
                let off = off.map(|(force, exact)| (force / (area * exact) - 1.0).abs());
                record.at_most(
                    format!("{element}, force"),
                    slideline_verification::worst(off),
                    1e-5,
                );
            }
            Err(why) => record.holds(format!("{element}: {why}"), false),
        }
    }
}

/// Force for each undeformed area at a stretch, by halving the plastic strain.
fn nominal(bar: &Bar, stretch: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if bar.even(middle)[1] < stretch { low = middle } else { high = middle }
    }
    bar.even(low)[0]
}

/// An increment at which the bar has necked.
struct Neck {
    /// Radius [L].
    radius: f64,
    /// Radius of its profile [L].
    profile: f64,
    /// Force [F].
    force: f64,
}

/// The free side, deformed: height and radius from the middle up.
fn side(curve: &Curve, mesh: &Meshed, row: usize) -> Vec<[f64; 2]> {
    let nodes = mesh.nodes.iter().filter(|(_, at, _)| at[0] == 1.0);
    let mut side: Vec<[f64; 2]> = nodes
        .map(|&(label, _, [r, z, _])| {
            let moved = |dof| curve.displacement(label, dof)[row];
            [z + moved(2), r + moved(1)]
        })
        .collect();
    side.sort_by(|a, b| a[0].total_cmp(&b[0]));
    side
}

/// The neck when it has come to a part of the bar's radius.
fn neck(curve: &Curve, mesh: &Meshed, part: f64) -> Option<Neck> {
    let middle = curve.displacement(mesh.nearest([1.0, 0.0, 0.0]), 1);
    let row = middle.iter().position(|u| 0.982 * RADIUS + u <= part * RADIUS)?;
    let side = side(curve, mesh, row);
    let radius = side[0][1];
    // r = a + z^2/(2 profile) + c z^4 by least squares over most of a radius
    let mut sums = [0.0; 5];
    for [z, r] in side.iter().filter(|at| at[0] < 0.8 * radius) {
        let (p, q, y) = (z * z, z.powi(4), r - radius);
        let own = [p * p, p * q, q * q, p * y, q * y];
        sums.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
    }
    let [a, b, c, d, e] = sums;
    let square = (d * c - e * b) / (a * c - b * b);
    Some(Neck { radius, profile: 0.5 / square, force: forces(curve, mesh)[row] })
}

fn necking(record: &mut Record) {
    let exact = Bar { modulus: MODULUS, yield_stress };
    let largest = PI * RADIUS * RADIUS * exact.largest().unwrap();
    let material = material();
    let mut last = Vec::new();
    for (element, cells) in [("CAX4", [8, 24, 1]), ("CAX8R", [4, 12, 1]), ("CAX4R", [8, 24, 1])] {
        let solid = Solid { element, cells, map: bar, material: &material };
        let (curve, mesh) = match pulled(&solid, "0.01, 1.0, 1.0E-6, 0.02", 7.0) {
            Ok(found) => found,
            Err(why) => {
                record.holds(format!("{element}: {why}"), false);
                continue;
            }
        };
        let force = forces(&curve, &mesh);
        let most = force.iter().copied().fold(0.0, f64::max);
        record.within(format!("{element}, largest force"), most / largest, [0.982 * 0.982, 1.0]);
        let end = force.last().copied().unwrap_or(f64::NAN);
        let radius = side(&curve, &mesh, force.len() - 1)[0][1];
        record.tell(format!("{element}, last force over the largest"), end / most);
        record.tell(format!("{element}, last radius of the neck over the bar's"), radius / RADIUS);
        for part in [0.8, 0.7] {
            let what = format!("{element}, stress at {part} R over Bridgman's");
            let Some(neck) = neck(&curve, &mesh, part) else {
                record.holds(format!("{what}: no such neck"), false);
                continue;
            };
            let flow = yield_stress(2.0 * (0.982 * RADIUS / neck.radius).ln());
            let stress = neck.force / (PI * neck.radius * neck.radius);
            let ratio = stress / (flow * bridgman(neck.radius, neck.profile));
            if element == "CAX4R" {
                record.tell(what, ratio);
            } else {
                record.within(what, ratio, [0.95, 1.05]);
            }
        }
        last.push(radius);
    }
    record.at_most("CAX4 and CAX8R, last radii apart", (last[0] / last[1] - 1.0).abs(), 0.05);
}

fn sheet(record: &mut Record) {
    let material = material();
    let poisson = MODULUS / (2.0 * SHEAR) - 1.0;
    // von Mises in plane strain: 2/sqrt 3 of the stress, sqrt 3/2 of the strain
    let nominal = |plastic: f64| {
        let stress = 2.0 / 3f64.sqrt() * yield_stress(plastic);
        let strain = 0.5 * 3f64.sqrt() * plastic + stress * (1.0 - poisson * poisson) / MODULUS;
        stress * (-strain).exp()
    };
    let largest = RADIUS * (1..2000).map(|k| nominal(1e-4 * f64::from(k))).fold(0.0, f64::max);
    let mut last = Vec::new();
    for (element, cells) in [("CPE4", [6, 16, 1]), ("CPE8R", [4, 12, 1]), ("C3D8", [6, 16, 1])] {
        let solid = Solid { element, cells, map: bar, material: &material };
        match pulled(&solid, "0.02, 1.0, 1.0E-6, 0.04", 5.0) {
            Ok((curve, mesh)) => {
                let force = forces(&curve, &mesh);
                let most = force.iter().copied().fold(0.0, f64::max);
                let what = format!("{element}, largest force");
                record.within(what, most / largest, [0.98, 1.002]);
                let end = force.last().copied().unwrap_or(f64::NAN);
                record.at_most(format!("{element}, last force over the largest"), end / most, 0.9);
                last.push(end);
            }
            Err(why) => record.holds(format!("{element}: {why}"), false),
        }
    }
    if let [plane, _, spatial] = last[..] {
        record.at_most("CPE4 and C3D8, last forces apart", (spatial / plane - 1.0).abs(), 1e-6);
    }
}
