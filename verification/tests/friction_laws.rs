//! The other friction laws, each against its closed form, on a block that is
//! pulled over a plane.
//!
//! ```text
//!        N = 10
//!        v
//!     [block]--> u       area 1/2, so p = N/A = 20
//!   ============
//! ```
//!
//! Source: semantics section 3. Tolerance 1e-9: a rigid block has no
//! discretisation, residuals are held at 1e-12.

use slideline_verification::{Curve, run};

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

/// Requirement: min(mu p, tau_max) A: 4/2 = 2 instead of mu N = 3; a limit
/// above mu p = 6 changes nothing, zero is none.
#[test]
fn shear_limit() {
    for (limit, exact) in [("4.0", 4.0 * AREA), ("7.0", 0.3 * NORMAL), ("0.0", 0.3 * NORMAL)] {
        for stick in [", ELASTIC SLIP=0.001", ", LAGRANGE"] {
            let law = format!("{stick}, TAUMAX={limit}\n0.3");
            let found = force(&pulled(&law, "", 1, (0.5, 1.0, 5)), 1);
            println!("TAUMAX={limit}{stick}: {:.12} of {exact}", found[4]);
            assert!(found.iter().all(|f| (f - exact).abs() < 1e-9 * exact), "{limit}: {found:?}");
        }
    }
}

/// Requirement: mu = mu_k + (mu_s - mu_k) exp(-d_c v): the mean slip rate of the
/// increment is the speed of the block. mu_s = 0.5, mu_k = 0.2, d_c = 2.
#[test]
fn static_to_kinetic_decay() {
    let forces: Vec<f64> = [0.01_f64, 0.1, 1.0, 10.0]
        .into_iter()
        .map(|speed| {
            let exact = NORMAL * (0.2 + 0.3 * (-2.0 * speed).exp());
            let law = ", EXPONENTIAL DECAY, ELASTIC SLIP=1.0E-4\n0.5, 0.2, 2.0";
            let found = force(&pulled(law, "", 1, (0.5, 0.5 / speed, 10)), 1);
            println!("decay at speed {speed}: {:.12} of {exact:.12}", found[9]);
            assert!(found.iter().all(|f| (f - exact).abs() < 1e-9 * exact), "{speed}: {found:?}");
            found[9]
        })
        .collect();
    assert!(forces.windows(2).all(|pair| pair[1] < pair[0]), "faster is easier: {forces:?}");
}

/// Requirement: no slip while closed, at any force: the block stays, the
/// spring of stiffness 100 carries k u, far beyond the weight.
#[test]
fn rough_never_slips() {
    let spring = "*ELEMENT, TYPE=SPRINGA, ELSET=SPRING\n1, 1, 2\n*SPRING, ELSET=SPRING\n\n100.0\n";
    let curve = pulled(", ROUGH", spring, 2, (0.5, 1.0, 5));
    let (found, place) = (force(&curve, 2), curve.displacement(1, 1));
    for (k, found) in found.iter().enumerate() {
        let exact = 100.0 * 0.1 * (k + 1) as f64;
        assert!((found - exact).abs() < 1e-9 * 50.0, "{k}: {found} {exact}");
    }
    let slip = place.iter().fold(0.0_f64, |most, u| u.abs().max(most));
    println!("ROUGH: force {:.9} of 50 under a weight of 10, slip {slip:.1e}", found[4]);
    assert!(slip < 1e-12, "{slip:e}");
}
