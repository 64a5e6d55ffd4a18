//! Williams' toggle, its apex brought down by displacement.

use slideline_theory::closed::toggle::Toggle;
use slideline_verification::{Claim, Curve, Group, Record, run};

pub const GROUP: Group = Group {
    file: "beams_williams_toggle",
    claims: &[Claim {
        name: "load_and_limit_points",
        requirement: "The load of the toggle through both of its limit points.",
        source: "Williams (1964); the exact extensible beam (derived).",
        tolerance: "0.1 %: a clamped and guided one-point beam lacks 1/n2 of its bending \
                    flexibility, 0.016 % with 80 elements a side, which the fall between the limit \
                    points doubles.",
        measure: load_and_limit_points,
    }],
};

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

fn load_and_limit_points(record: &mut Record) {
    let toggle = Toggle::williams();
    let (curve, v, load) = path();
    record.equal("increments, without a cutback", curve.rows.len(), STEPS);
    for at in [0.1, 0.5, 0.7] {
        let k = v.iter().position(|u| (u - at).abs() < 1e-9).unwrap();
        let off = (load[k] / toggle.load(at).unwrap() - 1.0).abs();
        record.at_most(format!("load at v = {at}, error (%)"), 100.0 * off, 0.1);
    }
    for (name, range, sign, from, to) in
        [("upper", 20..70, 1.0, 0.15, 0.3), ("lower", 60..100, -1.0, 0.3, 0.5)]
    {
        let (at, found) = extreme(&v, &load, range, sign);
        let (exact_at, exact) = toggle.limit(from, to).unwrap();
        let off = 100.0 * (found / exact - 1.0).abs();
        record.at_most(format!("{name} limit load, error (%)"), off, 0.1);
        record.at_most(format!("{name} limit point, error of v"), (at - exact_at).abs(), 1e-3);
    }
    let exact: Vec<f64> = v.iter().map(|&v| toggle.load(v).unwrap_or(f64::NAN)).collect();
    let axes = ["deflection of the apex", "load"];
    record.comparison("Williams' toggle", axes, &v, &[("80 B21 a side", &load)], ("exact", &exact));
}
