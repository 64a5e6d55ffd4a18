//! Bisshopp and Drucker's cantilever under a dead load at its tip.
//!
//! Requirement: tip angle, deflection and shortening of the inextensible
//! cantilever, PL2/EI = 0.25 to 15. Source: verification section 5 (elliptic
//! integrals). Tolerance 0.1 % at 20 elements: one-point elements lack a
//! fraction 1/(4 n2) = 0.06 % of the bending flexibility, of which the
//! slenderness compensation gives back about three quarters; L/t = 1000 keeps
//! stretch and shear below 1e-5.

use slideline_theory::closed::bisshopp_drucker;
use slideline_verification::run;

const LOADS: [usize; 12] = [1, 2, 4, 8, 12, 16, 20, 24, 28, 32, 40, 60]; // quarters

/// L = 1, EI = 1, P = 15 in 60 increments.
const DECK: &str = "*HEADING\ndead load\n*NODE, NSET=BEAM\n1, 0.0, 0.0\n21, 1.0, 0.0\n\
    *NGEN, NSET=BEAM\n1, 21, 1\n*ELEMENT, TYPE=B21, ELSET=BEAM\n1, 1, 2\n\
    *ELGEN, ELSET=BEAM\n1, 20, 1, 1\n*BEAM SECTION, ELSET=BEAM, SECTION=RECT, MATERIAL=M\n\
    12.0, 1.0E-3\n*MATERIAL, NAME=M\n*ELASTIC\n1.0E9, 0.0\n*STEP, NLGEOM, INC=1000\n*STATIC\n\
    0.25, 15.0, 1.0E-6, 0.25\n*BOUNDARY\n1, ENCASTRE\n*CLOAD\n21, 2, -15.0\n*END STEP\n";

#[test]
fn table_of_tip_angle_deflection_shortening() {
    let curve = run(DECK).unwrap();
    let [u, v, turn] = [1, 2, 6].map(|dof| curve.displacement(21, dof));
    let mut worst: f64 = 0.0;
    for quarters in LOADS {
        let load = 0.25 * quarters as f64;
        let k = curve.rows.iter().position(|row| (row.time - load).abs() < 1e-9).unwrap();
        let tip = bisshopp_drucker::tip(load).unwrap();
        for (found, exact) in
            [(-turn[k], tip.angle), (-v[k], tip.deflection), (-u[k], tip.shortening)]
        {
            worst = worst.max((found / exact - 1.0).abs());
            assert!((found / exact - 1.0).abs() < 1e-3, "PL2/EI {load}: {found} {exact}");
        }
    }
    println!(
        "Bisshopp-Drucker: worst {:.4} %, {:.1} iterations",
        100.0 * worst,
        curve.mean_iterations()
    );
}
