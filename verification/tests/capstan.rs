//! A limp chain over a drum that turns under it.
//!
//! ```text
//!        .-o-o-.
//!      o/   o   \o    n nodes on half a drum, springs between them
//!   T1 |         | T2
//! ```

use slideline::output::plot::{Axis, Mark, Series};
use slideline_theory::closed::capstan;
use slideline_verification::{Claim, Group, Record, run};
use std::f64::consts::PI;
use std::fmt::Write as _;

pub const GROUP: Group = Group {
    file: "capstan",
    claims: &[Claim {
        name: "chain_over_a_drum",
        requirement: "With every node slipping T2/T1 = [(1 + mu tan(D/2))/(1 - mu tan(D/2))]^n, \
                      D = pi/n, which tends to exp(mu pi): 9, 36, 90 nodes, mu 0.1 and 0.3, \
                      penalty and Lagrange.",
        source: "Euler and Eytelwein; the polygon's ratio is derived.",
        tolerance: "1e-6: links of stiffness 1e8 under unit tension stretch by 1e-8, which moves \
                    the nodes and turns the links by as much.",
        measure: chain_over_a_drum,
    }],
};

/// Unit tension at node 1, node n + 1 held, the drum 999 turned by 0.02.
fn deck(n: u32, mu: f64, stick: &str) -> String {
    let turn = PI / f64::from(n);
    let at = |j: f64| [((j + 0.5) * turn).cos(), ((j + 0.5) * turn).sin()];
    let mut text = String::from("*HEADING\ncapstan\n*NODE\n999, 0.0, 0.0\n");
    for j in 0..=n {
        let [x, y] = at(f64::from(j));
        let _ = writeln!(text, "{}, {x:?}, {y:?}", j + 1); // a String takes any text
    }
    // the pull has the direction of the link that would come before
    let ([x0, y0], [x1, y1]) = (at(-1.0), at(0.0));
    let length = (x0 - x1).hypot(y0 - y1);
    let pull = [(x0 - x1) / length, (y0 - y1) / length];
    let (end, side) = ((-0.3_f64).sin(), (-0.3_f64).cos());
    let _ = write!(
        text,
        "*ELEMENT, TYPE=SPRINGA, ELSET=CHAIN\n1, 1, 2\n*ELGEN, ELSET=CHAIN\n1, {n}, 1, 1\n\
         *SPRING, ELSET=CHAIN\n\n1.0E8\n*RIGID SURFACE, ELSET=CONTACT, TYPE=SEGMENTS\n\
         START, {:?}, {end:?}\nCIRCL, 0.0, 1.0, 0.0, 0.0\nCIRCL, {side:?}, {end:?}, 0.0, 0.0\n\
         *ELEMENT, TYPE=IRS21, ELSET=CONTACT\n1001, 1, 2, 999\n*ELGEN, ELSET=CONTACT\n\
         1001, {}, 1, 1\n*INTERFACE, ELSET=CONTACT\n1.0\n*FRICTION{stick}\n{mu:?}\n\
         *STEP, NLGEOM\n*STATIC\n1.0, 1.0\n*BOUNDARY\n999, 1, 6\n{held}, 1, 6\n*CLOAD\n\
         1, 1, {:?}\n1, 2, {:?}\n*CONTROLS, PARAMETERS=FIELD\n1.0E-12\n*END STEP\n\
         *STEP, NLGEOM\n*STATIC\n0.1, 1.0, 1.0E-6, 0.1\n*BOUNDARY\n999, 6, 6, -0.02\n\
         *CONTROLS, PARAMETERS=FIELD\n1.0E-12\n*END STEP\n",
        -side,
        n - 1,
        pull[0],
        pull[1],
        held = n + 1,
    );
    text
}

/// Tension at the held end over that at the pulled one.
fn ratio(n: u32, mu: f64, stick: &str) -> f64 {
    let curve = run(&deck(n, mu, stick)).unwrap();
    let [x, y] = [1, 2].map(|dof| *curve.reaction(u64::from(n) + 1, dof).last().unwrap());
    x.hypot(y)
}

fn chain_over_a_drum(record: &mut Record) {
    let mut series = Vec::new();
    for mu in [0.1, 0.3] {
        let mut points = Vec::new();
        for n in [9, 36, 90] {
            let exact = capstan::polygon_ratio(mu, PI, n).unwrap();
            for (name, stick) in [("penalty", ""), ("Lagrange", ", LAGRANGE")] {
                let found = ratio(n, mu, stick);
                let what = format!("{n} nodes, mu {mu}, {name}: T2/T1, error (relative)");
                record.at_most(what, (found / exact - 1.0).abs(), 1e-6);
                if stick.is_empty() {
                    points.push([f64::from(n), found / capstan::limit_ratio(mu, PI) - 1.0]);
                }
            }
        }
        let name = format!("mu {mu}, above exp(mu pi)");
        series.push(Series { name, points, mark: Mark::Curve, colour: 0 });
    }
    let (x, y) = (Axis::logarithmic("nodes"), Axis::logarithmic("T2/T1 over the limit, less 1"));
    record.chart("A chain tends to a rope", x, y, series);
}
