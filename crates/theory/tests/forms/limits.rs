//! Where a reference does not exist it says why; no wrong number is given.

use slideline_theory::{Cantilever, FirstProblem, Reference, SecondProblem, Stroke, TheoryError};

const ALL: [Reference; 5] = [
    Reference::Linear,
    Reference::Elastica,
    Reference::Reissner,
    Reference::Softened { area: 1.5705e-5 },
    Reference::Continuum,
];

fn at(problem: &FirstProblem, y: f64, mu: f64, reference: Reference) -> Result<bool, TheoryError> {
    problem.equilibrium(y - problem.start_y, mu, reference, Stroke::Push).map(|e| e.is_some())
}

/// Requirement: where the circle is clear of the beam nothing acts; a stroke that never touches has
/// no reference, and that is said. Source: verification section 2, k = 0 and 1 of the cam.
#[test]
fn clear_of_the_beam() {
    let mut problem = FirstProblem::diehl();
    problem.circle_x = -5e-3;
    problem.stroke = -1e-3;
    for reference in ALL {
        assert_eq!(at(&problem, 45e-3, 0.3, reference), Ok(false), "{reference:?}");
        assert_eq!(problem.rows(0.3, 2, reference), Err(TheoryError::NeverTouches));
        let cam = SecondProblem::project().rows(0.3, 20, reference).unwrap();
        for row in &cam[..2] {
            assert!(row.rm3 == 0.0 && row.force == 0.0 && row.contact_length.is_none());
        }
        assert!(cam[3].force > 0.0);
    }
}

#[test]
fn past_the_clamp() {
    let problem = FirstProblem::diehl();
    for reference in ALL {
        assert_eq!(
            at(&problem, -1e-3, 0.0, reference),
            Err(TheoryError::PastClamp),
            "{reference:?}"
        );
    }
}

/// The error names its increment.
#[test]
fn errors_name_the_increment() {
    let mut problem = FirstProblem::diehl();
    problem.stroke = -50e-3;
    for reference in ALL {
        let found = problem.rows(0.0, 10, reference);
        assert!(
            matches!(found, Err(TheoryError::AtIncrement { increment: 8..=9, .. })),
            "{reference:?} {found:?}"
        );
    }
}

#[test]
fn beyond_the_tip() {
    let mut problem = FirstProblem::diehl();
    // short beam on the same line
    problem.beam = Cantilever { tip: [7e-3 + 2.222e-3 * 0.6, 30e-3], ..problem.beam };
    for reference in ALL {
        assert!(
            matches!(at(&problem, 33e-3, 0.0, reference), Err(TheoryError::BeyondTip { .. })),
            "{reference:?}"
        );
    }
}

/// Friction so large that it takes up the whole transverse force: mu tan(slope) > 1.
#[test]
fn jamming() {
    let problem = FirstProblem::diehl();
    let linear = at(&problem, 15e-3, 9.0, Reference::Linear);
    assert!(matches!(linear, Err(TheoryError::Jamming { .. })), "{linear:?}");
    for reference in &ALL[1..] {
        assert!(at(&problem, 15e-3, 9.0, *reference).is_err(), "{reference:?}");
    }
}

#[test]
fn impossible_dimensions() {
    let mut problem = FirstProblem::diehl();
    assert!(matches!(problem.rows(-0.1, 20, ALL[0]), Err(TheoryError::AtIncrement { .. })));
    assert!(matches!(problem.rows(0.1, 0, ALL[0]), Err(TheoryError::InvalidInput(_))));
    problem.beam.thickness = 0.0;
    assert!(problem.rows(0.1, 20, ALL[0]).is_err());
    let mut cam = SecondProblem::project();
    cam.arm = f64::NAN;
    assert!(cam.rows(0.1, 20, ALL[0]).is_err());
    assert!(SecondProblem::project().rows(0.0, 20, Reference::Softened { area: 0.0 }).is_err());
}

/// Other dimensions: for a deflection small beside all lengths every theory of a
/// stiff, slender beam gives the linear answer.
#[test]
fn other_dimensions_in_the_small() {
    for (radius, offset) in [(2e-3, 1e-6), (9e-3, 4e-6), (60e-3, 1e-5)] {
        let beam = Cantilever {
            base: [0.0, 0.0],
            tip: [0.4, 0.0],
            width: 10e-3,
            thickness: 1e-3,
            modulus: 200e9,
            poisson: 0.3,
            shear_factor: 0.85,
        };
        let mut cam =
            SecondProblem { beam, radius, arm: 0.05, sweep: -0.01, ..SecondProblem::project() };
        cam.start_angle = 0.01;
        cam.pivot = [0.2, radius - offset + 0.05];
        cam.law.clearance = 1e-9;
        let linear = cam.rows(0.2, 4, Reference::Linear).unwrap();
        for reference in
            [Reference::Elastica, Reference::Reissner, Reference::Softened { area: 1e-4 }]
        {
            let exact = cam.rows(0.2, 4, reference).unwrap();
            let peak = linear[4].rm3.abs();
            assert!(peak > 0.0);
            for (a, b) in linear.iter().zip(&exact) {
                assert!((a.rm3 - b.rm3).abs() < 2e-3 * peak, "{reference:?} {a:?} {b:?}");
            }
        }
    }
}
