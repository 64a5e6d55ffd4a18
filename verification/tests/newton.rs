//! Newton's order, and how many iterations the paper's decks take.

use slideline::observe::IterationReport;
use slideline::output::plot::{Axis, Mark, Series};
use slideline_verification::{Claim, Curve, Group, Method, Push, Record, paper, run, worst};

pub const GROUP: Group = Group {
    file: "newton",
    claims: &[
        Claim {
            name: "beams_are_quadratic_to_the_floor",
            requirement: "With the active set fixed the residual falls as the square of the one \
                          before, down to the floor of rounding: mean order 1.8, r' q/r2 bounded.",
            source: "Newton's method with an exact tangent.",
            tolerance: "r' q/r2 below 100 for every pair down to the floor; a rate of convergence \
                        would make it 1e6 and more there.",
            measure: beams_are_quadratic_to_the_floor,
        },
        Claim {
            name: "contact_is_quadratic_to_the_floor",
            requirement: "With contact r'/r2 is bounded over the whole stroke, the residual at the \
                          floor included: only two residuals as a rule lie between the first and \
                          the floor.",
            source: "Newton's method with an exact tangent.",
            tolerance: "100 per newton: with a tangent that is wrong by one part in a thousand it \
                        would be 1e-3/r, a thousand times as much when the floor of 1e-9 N is near.",
            measure: contact_is_quadratic_to_the_floor,
        },
        Claim {
            name: "few_iterations_and_no_cutback",
            requirement: "The paper's decks in 20 increments: at most 8 iterations an increment \
                          on average, no cutback.",
            source: "Plain Newton needs 20 to 30 here.",
            tolerance: "None: counts.",
            measure: few_iterations_and_no_cutback,
        },
    ],
};

/// Residuals of every increment from the last change of contact on, down to
/// the first at the floor of rounding.
fn falls(curve: &Curve) -> Vec<Vec<f64>> {
    let by_increment = |a: &IterationReport, b: &IterationReport| a.increment == b.increment;
    let fall = |reports: &[IterationReport]| {
        let clean = reports.iter().rposition(|r| r.severe).map_or(0, |last| last + 1);
        reports[clean..]
            .iter()
            .map(|r| (r.force.residual, r.force.allowed))
            .take_while(|(residual, floor)| *residual > *floor)
            .map(|(residual, _)| residual)
            .collect()
    };
    curve.iterations.chunk_by(by_increment).map(fall).collect()
}

/// (order, constant) of successive residuals r, r' below a twentieth of the
/// load q: ln(r'/q)/ln(r/q), the order in units in which the quadratic term is
/// of the size of one, and r' q/r2.
fn orders(curve: &Curve, load: f64) -> Vec<[f64; 2]> {
    let of = |r: &[f64]| [(r[1] / load).ln() / (r[0] / load).ln(), r[1] * load / (r[0] * r[0])];
    let late = |fall: &Vec<f64>| -> Vec<[f64; 2]> {
        fall.windows(2).filter(|r| r[0] < 0.05 * load).map(of).collect()
    };
    falls(curve).iter().flat_map(late).collect()
}

/// A stubby beam: in slender ones stretch and bending converge by turns, and
/// the largest residual jumps from one to the other down to the floor.
fn dead_load(increments: usize) -> String {
    format!(
        "*HEADING\ndead load\n*NODE, NSET=BEAM\n1, 0.0, 0.0\n11, 1.0, 0.0\n*NGEN, NSET=BEAM\n\
         1, 11, 1\n*ELEMENT, TYPE=B21, ELSET=BEAM\n1, 1, 2\n*ELGEN, ELSET=BEAM\n1, 10, 1, 1\n\
         *BEAM SECTION, ELSET=BEAM, SECTION=RECT, MATERIAL=M\n1.0, 0.5\n*MATERIAL, NAME=M\n\
         *ELASTIC\n96.0, 0.0\n*STEP, NLGEOM\n*STATIC\n{dt:?}, 1.0, 1.0E-6, {dt:?}\n*BOUNDARY\n\
         1, ENCASTRE\n*CLOAD\n11, 2, -5.0\n*CONTROLS, PARAMETERS=FIELD\n1.0E-13\n*END STEP\n",
        dt = 1.0 / increments as f64
    )
}

fn beams_are_quadratic_to_the_floor(record: &mut Record) {
    let mut series = Vec::new();
    for increments in [1, 2, 3] {
        let curve = run(&dead_load(increments)).unwrap();
        let orders = orders(&curve, 5.0);
        let what = |what: &str| format!("{increments} increments: {what}");
        record.at_least(what("pairs of residuals"), orders.len() as f64, 1.0);
        let mean = orders.iter().map(|[order, _]| order).sum::<f64>() / orders.len() as f64;
        record.at_least(what("mean order"), mean, 1.8);
        record.at_most(what("r' q/r2, largest"), worst(orders.iter().map(|o| o[1])), 100.0);
        let fall = falls(&curve).pop().unwrap_or_default();
        let points = (1..).zip(fall).map(|(k, r)| [f64::from(k), r]).collect();
        let name = format!("last of {increments} increments");
        series.push(Series { name, points, mark: Mark::Curve, colour: 0 });
    }
    let (x, y) = (Axis::linear("iteration"), Axis::logarithmic("largest residual"));
    record.chart("Residuals of a cantilever under a dead load", x, y, series);
}

fn contact_is_quadratic_to_the_floor(record: &mut Record) {
    for method in [Method::Irs, Method::Isl] {
        for mu in [0.0, 0.3] {
            let push = Push { mu, tolerance: Some(1e-13), ..Push::paper(method) };
            let deck = push.deck().replace("*STEP, NLGEOM", "*STEP, NLGEOM, EXTRAPOLATION=NO");
            let falls = falls(&run(&deck).unwrap());
            let pairs = falls.iter().flat_map(|fall| fall.windows(2));
            let ratio = worst(pairs.map(|r| r[1] / (r[0] * r[0])));
            let longest = falls.iter().map(Vec::len).max().unwrap();
            let what = |what: &str| format!("{method:?}, mu {mu}: {what}");
            record.at_least(what("residuals above the floor, most"), longest as f64, 2.0);
            record.at_most(what("r'/r2, largest (1/N)"), ratio, 100.0);
        }
    }
}

fn few_iterations_and_no_cutback(record: &mut Record) {
    for (name, deck) in [
        ("IRS, 24 B21", paper::IRS_COARSE),
        ("IRS, 99 B21", paper::IRS_FINE),
        ("ISL, 24 B21", paper::ISL_COARSE),
        ("integrated, 24 B21", paper::SURFACE_COARSE),
    ] {
        for mu in ["0.0", "0.3"] {
            let deck = deck.replace("*FRICTION\n0.0", &format!("*FRICTION\n{mu}"));
            assert!(deck.contains(&format!("*FRICTION\n{mu}")));
            let curve = run(&deck).unwrap();
            let what = |what: &str| format!("{name}, mu {mu}: {what}");
            let mean = curve.mean_iterations();
            record.at_most(what("iterations an increment"), mean, 8.0);
            let most = curve.rows.iter().map(|row| row.equilibrium + row.severe).max().unwrap();
            record.tell(what("iterations in an increment, most"), most as f64);
            record.equal(what("cutbacks"), curve.totals.cutbacks, 0);
            record.equal(what("increments"), curve.rows.len(), 20);
        }
    }
}
