//! Williams' toggle, its apex brought down by displacement.
//!
//! Requirement: the load through both limit points. Source: Williams (1964);
//! the exact extensible beam of verification section 5. Tolerance 0.1 %: a
//! clamped and guided one-point beam lacks 1/n2 of its bending flexibility,
//! 0.016 % with 80 elements a side (0.06 % with 40, which the fall between the
//! limit points doubles).

use slideline_theory::closed::toggle::Toggle;
use slideline_verification::{Curve, run};

const STEPS: usize = 140;

/// One half, apex guided; so stiff in shear that there is none.
fn deck(toggle: &Toggle) -> String {
    let height = (12.0 * toggle.bending_stiffness / toggle.axial_stiffness).sqrt();
    let modulus = toggle.axial_stiffness / height;
    format!(
        "*HEADING\ntoggle\n*NODE, NSET=BEAM\n1, 0.0, 0.0\n81, {:?}, {:?}\n*NGEN, NSET=BEAM\n\
         1, 81, 1\n*ELEMENT, TYPE=B21, ELSET=BEAM\n1, 1, 2\n*ELGEN, ELSET=BEAM\n1, 80, 1, 1\n\
         *BEAM SECTION, ELSET=BEAM, SECTION=RECT, MATERIAL=M\n1.0, {height:?}\n\
         *TRANSVERSE SHEAR STIFFNESS\n1.0E10, , 0.0\n*MATERIAL, NAME=M\n*ELASTIC\n{modulus:?}, 0.0\n\
         *STEP, NLGEOM, INC=1000\n*STATIC\n{dt:?}, 1.0, 1.0E-6, {dt:?}\n*BOUNDARY\n1, ENCASTRE\n\
         81, 1\n81, 6\n81, 2, 2, -0.7\n*END STEP\n",
        toggle.half_span,
        toggle.rise,
        dt = 1.0 / STEPS as f64,
    )
}

/// Largest value (`sign` 1) or smallest (-1) between rows, by a parabola through three.
fn extreme(v: &[f64], load: &[f64], range: std::ops::Range<usize>, sign: f64) -> (f64, f64) {
    let k = range.max_by(|&a, &b| (sign * load[a]).total_cmp(&(sign * load[b]))).unwrap();
    let (a, b, c) = (load[k - 1], load[k], load[k + 1]);
    let s = 0.5 * (a - c) / (a - 2.0 * b + c);
    (v[k] + s * (v[k + 1] - v[k]), b - 0.25 * (a - c) * s)
}

fn path() -> (Curve, Vec<f64>, Vec<f64>) {
    let curve = run(&deck(&Toggle::williams())).unwrap();
    let v = curve.displacement(81, 2).iter().map(|u| -u).collect();
    let load = curve.reaction(81, 2).iter().map(|rf| -2.0 * rf).collect();
    (curve, v, load)
}

#[test]
fn load_and_limit_points() {
    let toggle = Toggle::williams();
    let (curve, v, load) = path();
    assert_eq!(curve.rows.len(), STEPS, "no cutback");
    for at in [0.1, 0.5, 0.7] {
        let k = v.iter().position(|u| (u - at).abs() < 1e-9).unwrap();
        let exact = toggle.load(at).unwrap();
        assert!((load[k] / exact - 1.0).abs() < 1e-3, "v {at}: {} {exact}", load[k]);
    }
    for (range, sign, from, to) in [(20..70, 1.0, 0.15, 0.3), (60..100, -1.0, 0.3, 0.5)] {
        let (at, found) = extreme(&v, &load, range, sign);
        let (exact_at, exact) = toggle.limit(from, to).unwrap();
        println!("toggle: limit {found:.6} at {at:.6}, exact {exact:.6} at {exact_at:.6}");
        assert!((found / exact - 1.0).abs() < 1e-3, "{found} {exact}");
        assert!((at - exact_at).abs() < 1e-3, "{at} {exact_at}");
    }
}
