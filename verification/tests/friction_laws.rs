//! The other friction laws, each against its closed form, on a block that is
//! pulled over a plane.
//!
//! ```text
//!        N = 10
//!        v
//!     [block]--> u       area 1/2, so p = N/A = 20
//!   ============
//! ```

use slideline::output::plot::{Axis, Mark, Series};
use slideline_verification::{Claim, Curve, Group, Record, peak, run, worst};

const LAWS: &str = "The manual's laws of *FRICTION (docs/theory.md, friction).";
const EXACT: &str = "1e-9: a rigid block has no discretisation, residuals are held at 1e-12.";

pub const GROUP: Group = Group {
    file: "friction_laws",
    claims: &[
        Claim {
            name: "shear_limit",
            requirement: "With TAUMAX the block is pulled by min(mu p, tau_max) A: 4/2 = 2 instead \
                          of mu N = 3; a limit above mu p = 6 changes nothing, zero is none.",
            source: LAWS,
            tolerance: EXACT,
            measure: shear_limit,
        },
        Claim {
            name: "static_to_kinetic_decay",
            requirement: "mu = mu_k + (mu_s - mu_k) exp(-d_c v) at speeds 0.01 to 10, \
                          mu_s = 0.5, mu_k = 0.2, d_c = 2: faster is easier.",
            source: LAWS,
            tolerance: EXACT,
            measure: static_to_kinetic_decay,
        },
        Claim {
            name: "rough_never_slips",
            requirement: "ROUGH: no slip while closed, at any force. The block stays, the spring of \
                          stiffness 100 carries k u, far beyond the weight.",
            source: LAWS,
            tolerance: "1e-9 of the force, 1e-12 of slip: rounding.",
            measure: rough_never_slips,
        },
    ],
};

const NORMAL: f64 = 10.0;
const AREA: f64 = 0.5; // half of a contact element of length 1 and width 1

/// Presses the block in step 1, then moves node `moved` along x by `travel`
/// in `increments` over `period`.
fn pulled(
    friction: &str,
    spring: &str,
    moved: u64,
    (travel, period, increments): (f64, f64, usize),
) -> Curve {
    let first = if moved == 1 { "1, 1\n1, 6" } else { "1, 6\n2, 1, 6" };
    let deck = format!(
        "*HEADING\nblock\n*NODE\n1, 0.0, 0.0\n2, 1.0, 0.0\n3, 0.0, 1.0\n99, 0.0, -1.0\n{spring}\
         *RIGID SURFACE, ELSET=CONTACT, TYPE=SEGMENTS\nSTART, -5.0, 0.0\nLINE, 5.0, 0.0\n\
         *ELEMENT, TYPE=IRS21, ELSET=CONTACT\n11, 1, 3, 99\n\
         *INTERFACE, ELSET=CONTACT\n1.0\n*FRICTION{friction}\n\
         *STEP, NLGEOM\n*STATIC\n1.0, 1.0\n*BOUNDARY\n{first}\n3, 1, 6\n99, 1, 6\n\
         *CLOAD\n1, 2, {:?}\n*CONTROLS, PARAMETERS=FIELD\n1.0E-12\n*END STEP\n\
         *STEP, NLGEOM, INC=1000\n*STATIC\n{dt:?}, {period:?}, 1.0E-6, {dt:?}\n\
         *BOUNDARY\n{moved}, 1, 1, {travel:?}\n*CONTROLS, PARAMETERS=FIELD\n1.0E-12\n*END STEP\n",
        -NORMAL,
        dt = period / increments as f64,
    );
    let curve = run(&deck).unwrap();
    assert_eq!(curve.rows.len(), 1 + increments, "no cutback");
    curve
}

/// Force that pulls node `moved` in step 2.
fn force(curve: &Curve, moved: u64) -> Vec<f64> {
    curve.reaction(moved, 1).split_off(1)
}

fn off(found: &[f64], exact: f64) -> f64 {
    worst(found.iter().map(|force| (force / exact - 1.0).abs()))
}

fn shear_limit(record: &mut Record) {
    for (limit, exact) in [("4.0", 4.0 * AREA), ("7.0", 0.3 * NORMAL), ("0.0", 0.3 * NORMAL)] {
        for stick in ["ELASTIC SLIP=0.001", "LAGRANGE"] {
            let law = format!(", {stick}, TAUMAX={limit}\n0.3");
            let found = force(&pulled(&law, "", 1, (0.5, 1.0, 5)), 1);
            let what = format!("TAUMAX={limit}, {stick}: force less {exact}, largest (relative)");
            record.at_most(what, off(&found, exact), 1e-9);
        }
    }
}

fn static_to_kinetic_decay(record: &mut Record) {
    let speeds = [0.01_f64, 0.1, 1.0, 10.0];
    let mut forces = Vec::new();
    for speed in speeds {
        let exact = NORMAL * (0.2 + 0.3 * (-2.0 * speed).exp());
        let law = ", EXPONENTIAL DECAY, ELASTIC SLIP=1.0E-4\n0.5, 0.2, 2.0";
        let found = force(&pulled(law, "", 1, (0.5, 0.5 / speed, 10)), 1);
        let what = format!("speed {speed}: force less {exact:.6}, largest (relative)");
        record.at_most(what, off(&found, exact), 1e-9);
        forces.push([speed, found[9]]);
    }
    let easier = forces.windows(2).all(|pair| pair[1][1] < pair[0][1]);
    record.holds("faster is easier", easier);
    let law: Vec<[f64; 2]> = (0..=60)
        .map(|k| 10f64.powf(-2.0 + 0.05 * f64::from(k)))
        .map(|speed| [speed, NORMAL * (0.2 + 0.3 * (-2.0 * speed).exp())])
        .collect();
    let (x, y) = (Axis::logarithmic("speed"), Axis::linear("force"));
    let curves = vec![
        Series { name: "slideline".into(), points: forces, mark: Mark::Discs, colour: 0 },
        Series { name: "law".into(), points: law, mark: Mark::Guide, colour: 0 },
    ];
    record.chart("Force over speed", x, y, curves);
}

fn rough_never_slips(record: &mut Record) {
    let spring = "*ELEMENT, TYPE=SPRINGA, ELSET=SPRING\n1, 1, 2\n*SPRING, ELSET=SPRING\n\n100.0\n";
    let curve = pulled(", ROUGH", spring, 2, (0.5, 1.0, 5));
    let (found, place) = (force(&curve, 2), curve.displacement(1, 1));
    let exact = (1..).map(|k| 10.0 * f64::from(k));
    let off = worst(found.iter().zip(exact).map(|(found, exact)| (found - exact).abs()));
    record.at_most("force less 100 u, largest (of 50)", off / 50.0, 1e-9);
    record.at_most("slip, largest", peak(&place), 1e-12);
}
