//! What the exact references do not depend on. That they are right is a claim
//! of `verification/`: tables, and work against energy.

use slideline_theory::{ExponentialLaw, FirstProblem, Reference, SecondProblem, Stroke};

const EXACT: [Reference; 4] = [
    Reference::Elastica,
    Reference::Reissner,
    Reference::Softened { area: 1.5705e-5 },
    Reference::Continuum,
];

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
