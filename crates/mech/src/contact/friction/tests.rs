use super::{Decay, FrictionLaw, Status, Stick};

const CRITICAL: f64 = 4e-6;

fn coulomb(limit: Option<f64>, decay: Option<Decay>, stick: Stick) -> FrictionLaw {
    FrictionLaw::Coulomb { coefficient: 0.3, limit, decay, stick }
}

fn elastic() -> FrictionLaw {
    coulomb(None, None, Stick::Elastic { slip: CRITICAL })
}

fn laws() -> Vec<FrictionLaw> {
    let stick = Stick::Elastic { slip: CRITICAL };
    vec![
        elastic(),
        coulomb(Some(2.5e5), None, stick),
        coulomb(None, Some(Decay { kinetic: 0.1, rate: 2e3 }), stick),
        FrictionLaw::Rough { stick },
    ]
}

/// Requirement: stick, slip and dissipated slip of backward Euler. Source: semantics, section 3.
#[test]
fn stick_then_slip() {
    let stick = elastic().update(1e6, 1e-6, 1e-6, 1.0);
    assert_eq!(stick.status, Status::Stick);
    assert!((stick.tau - 0.3e6 * 0.5).abs() < 1e-6 && stick.dissipated_slip == 0.0);
    let slip = elastic().update(1e6, -9e-6, 1e-6, 1.0);
    assert_eq!(slip.status, Status::Slip);
    assert!((slip.tau + 0.3e6).abs() < 1e-6);
    assert!((slip.elastic_slip + CRITICAL).abs() < 1e-20);
    assert!((slip.dissipated_slip - 4e-6).abs() < 1e-18);
}

/// Requirement: both derivatives. Tolerance: central differences, relative 1e-7.
#[test]
fn derivatives_by_differences() {
    for law in laws() {
        for slip in [-9e-6, -1.3e-6, 0.7e-6, 2.1e-6, 8e-6] {
            for elastic_slip in [-2e-6, 0.0, 1e-6] {
                let (p, dt) = (1e6, 0.05);
                let at = |p: f64, s: f64| law.update(p, s, elastic_slip, dt).tau;
                let answer = law.update(p, slip, elastic_slip, dt);
                let by_slip = (at(p, slip + 1e-11) - at(p, slip - 1e-11)) / 2e-11;
                let by_p = (at(p + 1.0, slip) - at(p - 1.0, slip)) / 2.0;
                assert!((by_slip - answer.d_tau_d_slip).abs() < 1e-7 * 1e6 / CRITICAL, "{law:?}");
                assert!((by_p - answer.d_tau_d_pressure).abs() < 1e-7, "{law:?}");
                assert!(answer.dissipated_slip >= 0.0);
            }
        }
    }
}

/// Requirement: tau_max rules where mu p exceeds it, and then nothing follows the pressure.
#[test]
fn largest_traction() {
    let law = coulomb(Some(2e5), None, Stick::Elastic { slip: CRITICAL });
    let answer = law.update(1e6, 1e-5, 0.0, 1.0);
    assert_eq!((answer.tau, answer.d_tau_d_pressure), (2e5, 0.0));
}

/// Requirement: no pressure, no law, no multiplier: no traction.
#[test]
fn nothing_from_nothing() {
    assert_eq!(elastic().update(0.0, 1.0, 1.0, 1.0).tau, 0.0);
    assert_eq!(elastic().update(-1.0, 1.0, 1.0, 1.0).elastic_slip, 0.0);
    assert_eq!(FrictionLaw::None.update(1.0, 1.0, 0.0, 1.0).tau, 0.0);
    let zero = FrictionLaw::Coulomb {
        coefficient: 0.0,
        limit: None,
        decay: None,
        stick: Stick::Elastic { slip: 0.0 },
    };
    let answer = zero.update(1.0, 0.0, 0.0, 0.0);
    assert!(answer.tau == 0.0 && answer.d_tau_d_slip.is_finite());
    assert!(!elastic().needs_multiplier());
}

/// Requirement: projection of Lagrange stick on the Coulomb limit, with derivatives.
#[test]
fn projection() {
    let law = coulomb(None, None, Stick::Lagrange);
    assert!(law.needs_multiplier());
    let stick = law.project(1e6, 1e5, 0.0, 1.0);
    assert_eq!((stick.tau, stick.by_z, stick.by_pressure), (1e5, 1.0, 0.0));
    assert_eq!(stick.status, Status::Stick);
    let slip = law.project(1e6, -1e7, 0.0, 1.0);
    assert_eq!((slip.by_z, slip.by_pressure, slip.status), (0.0, -0.3, Status::Slip));
    assert!((slip.tau + 3e5).abs() < 1e-9);
    let rough = FrictionLaw::Rough { stick: Stick::Lagrange };
    assert_eq!(rough.project(1.0, 1e9, 0.0, 1.0).tau, 1e9);
    assert_eq!(law.project(0.0, 5.0, 0.0, 1.0).tau, 0.0);
}

/// Requirement: the loop of a stick-slip block dissipates 4 mu N (A - mu N/k), here with the elastic
/// slip as the spring. Source: verification, section 6. Tolerance: exact for a law linear in pieces.
#[test]
fn loop_area() {
    let (p, amplitude, steps) = (1e6, 10e-6, 40);
    let (mut elastic_slip, mut dissipated, mut position) = (CRITICAL, 0.0, amplitude);
    for direction in [-1.0, 1.0] {
        for _ in 0..steps {
            let slip = direction * 2.0 * amplitude / f64::from(steps);
            let answer = elastic().update(p, slip, elastic_slip, 1.0);
            dissipated += answer.tau.abs() * answer.dissipated_slip;
            elastic_slip = answer.elastic_slip;
            position += slip;
        }
    }
    assert!((position - amplitude).abs() < 1e-18);
    let expected = 4.0 * 0.3 * p * (amplitude - CRITICAL);
    assert!((dissipated - expected).abs() < 1e-12 * expected);
}

/// Requirement: elastic stick through the structure's stiffness is the law at the slip that is left,
/// tau = law(slip + (z - tau - kappa slip)/kappa), and its derivatives are those of differences: in
/// stick, in slip, with a limit and with decay. Tolerance: round-off; 1e-6 for central differences.
#[test]
fn stick_through_a_stiffness_is_the_law_where_both_balance() {
    let decay = Some(Decay { kinetic: 0.1, rate: 3.0 });
    let elastic = Stick::Elastic { slip: 0.02 };
    let coulomb =
        |limit, decay| FrictionLaw::Coulomb { coefficient: 0.4, limit, decay, stick: elastic };
    let laws =
        [coulomb(None, None), coulomb(Some(0.5), None), FrictionLaw::Rough { stick: elastic }];
    let (pressure, committed, dt) = (2.0, 0.004, 0.3);
    for (law, kappa) in laws.iter().flat_map(|law| [1.0, 30.0, 2e3].map(|kappa| (law, kappa))) {
        for z in [-4.0, -0.3, 0.05, 0.4, 3.0] {
            let found = law.resolve(pressure, (z, kappa), committed, (0.0, dt));
            let slip = (z - found.tau) / kappa;
            let expected = law.update(pressure, slip, committed, dt).tau;
            assert!((found.tau - expected).abs() < 1e-12 * (1.0 + z.abs()), "{law:?} {kappa} {z}");
        }
    }
    for law in laws.iter().chain([&coulomb(None, decay)]) {
        for z in [-4.0, -0.3, 0.05, 3.0] {
            let at =
                |p: f64, z: f64, slip: f64| law.resolve(p, (z, 30.0), committed, (slip, dt)).tau;
            let found = law.resolve(pressure, (z, 30.0), committed, (0.01, dt));
            let h = 1e-6;
            let differences = [
                (at(pressure, z + h, 0.01) - at(pressure, z - h, 0.01)) / (2.0 * h),
                (at(pressure + h, z, 0.01) - at(pressure - h, z, 0.01)) / (2.0 * h),
                (at(pressure, z, 0.01 + h) - at(pressure, z, 0.01 - h)) / (2.0 * h),
            ];
            for (own, difference) in
                [found.by_z, found.by_pressure, found.by_slip].iter().zip(differences)
            {
                assert!(
                    (own - difference).abs() < 1e-6 * (1.0 + own.abs()),
                    "{law:?} {z}: {own} {difference}"
                );
            }
        }
    }
}
