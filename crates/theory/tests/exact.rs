//! Elastica and Reissner references against verification section 1.2.

use slideline_theory::{FirstProblem, Reference};

const ELASTICA: [f64; 21] = [
    -0.0006635158,
    -0.006455674,
    -0.01422769,
    -0.02461088,
    -0.03845617,
    -0.05692056,
    -0.08159263,
    -0.1146772,
    -0.1592710,
    -0.2197820,
    -0.3025786,
    -0.4170148,
    -0.5770910,
    -0.8042102,
    -1.131894,
    -1.614128,
    -2.340715,
    -3.466856,
    -5.273306,
    -8.297048,
    -13.63925,
];

/// Requirement: column K of the table, to all digits shown.
#[test]
fn elastica_column() {
    let rows = FirstProblem::diehl().rows(0.0, 20, Reference::Elastica).unwrap();
    for (row, table) in rows.iter().zip(ELASTICA) {
        let unit = 10f64.powf(table.abs().log10().floor() - 6.0);
        assert!((row.rf2 - table).abs() <= 0.51 * unit, "{}: {} {table}", row.increment, row.rf2);
    }
}

use slideline_theory::{Equilibrium, ExponentialLaw, SecondProblem, Stroke};

/// Five-point Gauss rule on (-1, 1).
const GAUSS: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

fn integral(a: f64, b: f64, panels: usize, f: impl Fn(f64) -> f64) -> f64 {
    let half = 0.5 * (b - a) / panels as f64;
    let panel = |i: usize| {
        let middle = a + half * (2 * i + 1) as f64;
        GAUSS.iter().map(|(x, w)| w * half * f(middle + half * x)).sum::<f64>()
    };
    (0..panels).map(panel).sum()
}

const EXACT: [Reference; 4] = [
    Reference::Elastica,
    Reference::Reissner,
    Reference::Softened { area: 1.5705e-5 },
    Reference::Continuum,
];

fn energy(e: &Equilibrium) -> f64 {
    e.strain_energy + e.contact_energy
}

/// Requirement: without friction the work of RF2 over the push is the energy
/// gained by beam and contact. The tolerance is that of the quadrature.
#[test]
fn first_problem_keeps_its_energy() {
    let problem = FirstProblem::diehl();
    for reference in EXACT {
        let at = |u2: f64| problem.equilibrium(u2, 0.0, reference, Stroke::Push).unwrap().unwrap();
        for (from, to) in [(-1.5e-3, -15e-3), (-15e-3, -30e-3)] {
            let work = integral(from, to, 6, |u2| at(u2).reaction[1]);
            let gained = energy(&at(to)) - energy(&at(from));
            assert!((work / gained - 1.0).abs() < 2e-8, "{reference:?}: {work} {gained}");
        }
    }
}

/// Requirement: the same for the cam, from clear of the beam to the end.
#[test]
fn second_problem_keeps_its_energy() {
    let problem = SecondProblem::project();
    for reference in EXACT {
        let at =
            |ur3: f64| problem.equilibrium(ur3, 0.0, reference, Stroke::Push).unwrap().unwrap();
        let (from, to) = (-6f64.to_radians(), -60f64.to_radians());
        let work = integral(from, to, 8, |ur3| problem.moment(&at(ur3)));
        let gained = energy(&at(to)) - energy(&at(from));
        assert!((work / gained - 1.0).abs() < 2e-8, "{reference:?}: {work} {gained}");
    }
}

/// Reading of verification section 1.3: what separates the references.
#[test]
fn references_stand_where_the_reading_says() {
    let problem = FirstProblem::diehl();
    for (mu, mild, end) in [(0.0, 0.005, 0.02), (0.3, 0.002, 0.01)] {
        let lin = problem.rows(mu, 20, Reference::Linear).unwrap();
        let hard = problem.rows(mu, 20, Reference::Reissner).unwrap();
        let off = |k: usize| lin[k].rf2 / hard[k].rf2 - 1.0;
        assert!((1..=12).all(|k| off(k) > 0.0 && off(k) < mild), "{mu}");
        assert!(off(20) > end, "{mu}: {}", off(20));
    }
    let hard = problem.rows(0.0, 20, Reference::Reissner).unwrap();
    let soft = problem.rows(0.0, 20, EXACT[2]).unwrap();
    for (k, percent) in [(1, 13.0), (5, 3.0), (10, 1.6), (15, 0.8), (20, 0.0)] {
        let shift = 100.0 * (soft[k].rf2 / hard[k].rf2 - 1.0);
        assert!((shift - percent).abs() < 0.7, "{k}: {shift}");
    }
}

/// Requirement: turning and mirroring a problem turns and mirrors its answer.
#[test]
fn answers_do_not_depend_on_the_axes() {
    let problem = FirstProblem::diehl();
    let mut mirror = problem;
    for end in [&mut mirror.beam.base, &mut mirror.beam.tip] {
        end[0] = -end[0];
    }
    let mut upside_down = problem;
    for end in [&mut upside_down.beam.base, &mut upside_down.beam.tip] {
        end[1] = -end[1];
    }
    (upside_down.start_y, upside_down.stroke) = (-problem.start_y, -problem.stroke);
    for reference in [Reference::Linear, Reference::Reissner, Reference::Continuum] {
        let base = problem.rows(0.3, 4, reference).unwrap();
        let left = mirror.rows(0.3, 4, reference).unwrap();
        let down = upside_down.rows(0.3, 4, reference).unwrap();
        for k in 0..=4 {
            assert!(
                (left[k].rf1 / base[k].rf1 + 1.0).abs() < 1e-8
                    && (left[k].rf2 / base[k].rf2 - 1.0).abs() < 1e-8
            );
            assert!(
                (down[k].rf1 / base[k].rf1 - 1.0).abs() < 1e-8
                    && (down[k].rf2 / base[k].rf2 + 1.0).abs() < 1e-8
            );
        }
    }
}

/// Requirement: scaling of units (here millimetres) scales the answers.
#[test]
fn answers_scale_with_the_units() {
    let si = FirstProblem::diehl();
    let mut mm = si;
    for end in [&mut mm.beam.base, &mut mm.beam.tip] {
        *end = end.map(|v| v * 1e3);
    }
    (mm.beam.width, mm.beam.thickness, mm.beam.modulus) = (25.0, 1.5, 6900.0);
    (mm.radius, mm.start_y, mm.stroke) = (9.0, 45.0, -30.0);
    mm.law = ExponentialLaw { clearance: 1e-2, pressure: 4.8 };
    for (a, b) in
        EXACT.iter().zip([EXACT[0], EXACT[1], Reference::Softened { area: 15.705 }, EXACT[3]])
    {
        let (a, b) = (si.rows(0.3, 3, *a).unwrap(), mm.rows(0.3, 3, b).unwrap());
        for (a, b) in a.iter().zip(&b) {
            assert!((a.rf2 / b.rf2 - 1.0).abs() < 1e-9 && (a.rf1 / b.rf1 - 1.0).abs() < 1e-9);
        }
    }
}

/// Requirement: friction adds to the push and takes from the return, and
/// without friction both are one.
#[test]
fn return_stroke() {
    let problem = FirstProblem::diehl();
    let cam = SecondProblem::project();
    for reference in [Reference::Linear, EXACT[0], EXACT[1], EXACT[2], EXACT[3]] {
        let free = problem.rows(0.0, 4, reference).unwrap();
        let push = problem.rows(0.3, 4, reference).unwrap();
        let back = problem.stroke_rows(0.3, 4, reference, Stroke::Return).unwrap();
        let same = problem.stroke_rows(0.0, 4, reference, Stroke::Return).unwrap();
        for k in 0..=4 {
            assert!(push[k].rf2 < free[k].rf2 && back[k].rf2 > free[k].rf2);
            assert_eq!(same[k].rf2, free[k].rf2);
        }
        let free = cam.rows(0.0, 4, reference).unwrap();
        let push = cam.rows(0.3, 4, reference).unwrap();
        let back = cam.stroke_rows(0.3, 4, reference, Stroke::Return).unwrap();
        assert!(
            (1..=4).all(|k| push[k].rm3 < free[k].rm3 && back[k].rm3 > free[k].rm3),
            "{reference:?}"
        );
    }
}

/// Requirement: tributary areas, the ISL deck's of semantics section 3 to its digits; the
/// cam's from sin(1.5 degrees) = 0.0261769483.
#[test]
fn slave_areas() {
    let isl = FirstProblem::diehl().slave_area(4f64.to_radians());
    let cam = SecondProblem::project().slave_area(3f64.to_radians());
    assert!(
        (isl - 1.570477e-5).abs() < 6e-12 && (cam / (4.5e-4 * 0.026_176_948_3) - 1.0).abs() < 1e-8
    );
}

/// Requirement: energy is kept with other dimensions too: thicker beam, smaller circle,
/// stiffer contact.
#[test]
fn other_dimensions_keep_their_energy() {
    let mut problem = FirstProblem::diehl();
    problem.beam.thickness = 2.5e-3;
    (problem.radius, problem.circle_x, problem.start_y, problem.stroke) =
        (6e-3, 2e-3, 20e-3, -8e-3);
    problem.law = ExponentialLaw { clearance: 3e-6, pressure: 2e7 };
    for reference in EXACT {
        let at = |u2: f64| problem.equilibrium(u2, 0.0, reference, Stroke::Push).unwrap().unwrap();
        let work = integral(0.0, -8e-3, 8, |u2| at(u2).reaction[1]);
        let gained = energy(&at(-8e-3)) - energy(&at(0.0));
        assert!((work / gained - 1.0).abs() < 2e-8, "{reference:?}: {work} {gained}");
    }
}
