//! Orders of convergence of solids, by a manufactured solution without forces inside.
//!
//! ```text
//!   2 G u = (3 - 4 nu) h e_y - y grad h,  h harmonic     prescribed on the border; meshes n and 2n
//! ```

use slideline_verification::{Claim, Elasticity, Errors, Group, Record, Solid, errors, run};
use std::fmt::Write as _;

pub const GROUP: Group = Group {
    file: "solids_orders",
    claims: &[
        Claim {
            name: "orders_in_the_plane",
            requirement: "displacements converge with the power p + 1 of the element size in the mean \
                          square, strains with p in the norm of the energy, in meshes out of shape; \
                          p = 1 linear, 2 quadratic types.",
            source: "Theory of finite elements; exact field by Papkovich and Neuber's potentials, \
                     which satisfies Navier's equations without forces; norms by shape functions and \
                     quadrature of the verification's own.",
            tolerance: "the theory's order less 0.15, from 8 to 16 elements a side.",
            measure: |record| orders(record, &PLANE, 8),
        },
        Claim {
            name: "orders_in_space",
            requirement: "the same in space.",
            source: "as in the plane.",
            tolerance: "the theory's order less 0.25, from 3 to 6 elements a side: not yet the limit.",
            measure: |record| orders(record, &SPACE, 3),
        },
    ],
};

/// Types and their order.
const PLANE: [(&str, f64); 13] = [
    ("CPE3", 1.0),
    ("CPE4", 1.0),
    ("CPE4I", 1.0),
    ("CPE4R", 1.0),
    ("CPE6", 2.0),
    ("CPE8", 2.0),
    ("CPE8R", 2.0),
    ("CPS3", 1.0),
    ("CPS4", 1.0),
    ("CPS4I", 1.0),
    ("CPS6", 2.0),
    ("CPS8", 2.0),
    ("CPS8R", 2.0),
];
const SPACE: [(&str, f64); 10] = [
    ("C3D4", 1.0),
    ("C3D6", 1.0),
    ("C3D8", 1.0),
    ("C3D8I", 1.0),
    ("C3D8R", 1.0),
    ("C3D10", 2.0),
    // one pressure an element is of first order
    ("C3D10H", 1.0),
    ("C3D15", 2.0),
    ("C3D20", 2.0),
    ("C3D20R", 2.0),
];

const SHEAR: f64 = 0.5;
const POISSON: f64 = 0.3;

/// The body: a cube out of shape, smoothly, so that finer elements have less of it.
fn skewed([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x + 0.15 * y * (1.0 - 0.5 * x), y + 0.1 * x * x, z + 0.1 * x * y * z]
}

/// h = exp(k x) cos(a y) cos(b z), k^2 = a^2 + b^2: its slopes and second derivatives.
fn harmonic([a, b]: [f64; 2], [x, y, z]: [f64; 3]) -> (f64, [f64; 3], [[f64; 3]; 3]) {
    let k = a.hypot(b);
    let along = (k * x).exp();
    let factor = [
        [along, k * along, k * k * along],
        [(a * y).cos(), -a * (a * y).sin(), -a * a * (a * y).cos()],
        [(b * z).cos(), -b * (b * z).sin(), -b * b * (b * z).cos()],
    ];
    let of = |orders: [usize; 3]| (0..3).map(|axis| factor[axis][orders[axis]]).product();
    let slopes = std::array::from_fn(|i| of(std::array::from_fn(|axis| usize::from(axis == i))));
    let second = |i: usize, j: usize| {
        of(std::array::from_fn(|axis| usize::from(axis == i) + usize::from(axis == j)))
    };
    (of([0; 3]), slopes, std::array::from_fn(|i| std::array::from_fn(|j| second(i, j))))
}

/// The exact displacements and their gradient.
fn exact(waves: [f64; 2], at: [f64; 3], poisson: f64) -> ([f64; 3], [[f64; 3]; 3]) {
    let (h, slopes, second) = harmonic(waves, at);
    let ratio = 3.0 - 4.0 * poisson;
    let one = |i: usize, j: usize| f64::from(u8::from(i == j));
    let u = |i: usize| 0.5 / SHEAR * (ratio * h * one(i, 1) - at[1] * slopes[i]);
    let gradient = |i: usize, j: usize| {
        let grown = ratio * slopes[j] * one(i, 1);
        0.5 / SHEAR * (grown - one(j, 1) * slopes[i] - at[1] * second[i][j])
    };
    (std::array::from_fn(u), std::array::from_fn(|i| std::array::from_fn(|j| gradient(i, j))))
}

const FLAT: [f64; 2] = [2.0, 0.0];
const WAVES: [f64; 2] = [1.3, 1.1];
/// Plane stress is plane strain of another Poisson's ratio, nu/(1 + nu).
const OF_PLANE_STRESS: f64 = POISSON / (1.0 + POISSON);

fn computed(element: &str, cells: usize) -> Result<Errors, String> {
    let modulus = 2.0 * SHEAR * (1.0 + POISSON);
    let material = format!("*ELASTIC\n{modulus:?}, {POISSON:?}\n");
    let solid = Solid { element, cells: [cells; 3], map: skewed, material: &material };
    let mesh = solid.mesh();
    let axes = if solid.is_spatial() { 3 } else { 2 };
    let (field, poisson): (slideline_verification::Field, f64) = match &element[..3] {
        "C3D" => (|at| exact(WAVES, at, POISSON), POISSON),
        "CPS" => (|at| exact(FLAT, at, OF_PLANE_STRESS), OF_PLANE_STRESS),
        _ => (|at| exact(FLAT, at, POISSON), POISSON),
    };
    let mut deck = format!("*HEADING\norders\n{}*STEP\n*STATIC\n1.0, 1.0\n*BOUNDARY\n", mesh.text);
    let border = |at: [f64; 3]| (0..axes).any(|k| at[k] == 0.0 || at[k] == 1.0);
    for (label, _, place) in mesh.nodes.iter().filter(|(_, at, _)| border(*at)) {
        for (axis, value) in field(*place).0.iter().take(axes).enumerate() {
            let _ = writeln!(deck, "{label}, {0}, {0}, {value:?}", axis + 1);
        }
    }
    deck.push_str("*END STEP\n");
    let curve = run(&deck)?;
    let row = curve.rows.last().ok_or("no increment")?;
    let displacement = |label: u64| {
        let node = curve.model.nodes.find(label).unwrap();
        let [x, y, z, ..] = row.displacement[node];
        [x, y, z]
    };
    let elasticity =
        Elasticity { lame: 2.0 * SHEAR * poisson / (1.0 - 2.0 * poisson), shear: SHEAR };
    Ok(errors(&solid, &mesh, displacement, field, elasticity))
}

fn orders(record: &mut Record, types: &[(&str, f64)], cells: usize) {
    let less = if cells > 4 { 0.15 } else { 0.25 };
    for &(element, order) in types {
        match (computed(element, cells), computed(element, 2 * cells)) {
            (Ok(coarse), Ok(fine)) => {
                let fall = |coarse: f64, fine: f64| (coarse / fine).log2();
                let found = fall(coarse.displacement, fine.displacement);
                record.at_least(format!("{element}, order of u"), found, order + 1.0 - less);
                let found = fall(coarse.energy, fine.energy);
                record.at_least(format!("{element}, order of energy"), found, order - less);
                record.tell(format!("{element}, error of u on the finer mesh"), fine.displacement);
            }
            (Err(why), _) | (_, Err(why)) => record.holds(format!("{element}: {why}"), false),
        }
    }
}
