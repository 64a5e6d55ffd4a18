use super::{
    Decay, Ellipse, FrictionLaw, Projection, Status, Stick, Tangential, TangentialMap, Traction,
};

const CRITICAL: f64 = 4e-6;

fn coulomb(limit: Option<f64>, decay: Option<Decay>, stick: Stick) -> FrictionLaw {
    FrictionLaw::Coulomb { coefficient: 0.3, ellipse: Ellipse::CIRCLE, limit, decay, stick }
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
        slope(),
    ]
}

fn slope() -> FrictionLaw {
    coulomb(None, None, Stick::Slope { stiffness: 6e10 })
}

/// Requirement: with a stick slope the traction is slope times elastic slip, whatever the pressure,
/// up to mu p; the elastic slip then is mu p over the slope, the rest is dissipated. By hand.
#[test]
fn a_stick_slope_does_not_follow_the_pressure() {
    for pressure in [1e6, 4e6] {
        let stick = slope().update_by(pressure, 2e-6, 1e-6, 1.0);
        assert_eq!((stick.status, stick.d_tau_d_pressure[0]), (Status::Stick, 0.0));
        assert!((stick.tau[0] - 1.8e5).abs() < 1e-6);
    }
    let slip = slope().update_by(1e6, 9e-6, 1e-6, 1.0);
    assert_eq!(slip.status, Status::Slip);
    assert!((slip.tau[0] - 3e5).abs() < 1e-6 && (slip.elastic_slip[0] - 5e-6).abs() < 1e-18);
    assert!((slip.dissipated_slip - 5e-6).abs() < 1e-18);
    // felt through a structure: two springs in series
    let felt = slope().resolve_by(1e6, (1e5, 3e10), 0.0, (0.0, 1.0));
    assert!((felt.tau[0] - 1e5 * 6e10 / 9e10).abs() < 1e-6);
}

/// The laws in the plane, by numbers.
trait InThePlane {
    fn update_by(&self, pressure: f64, slip: f64, elastic_slip: f64, dt: f64) -> Traction;
    fn project_by(&self, pressure: f64, z: f64, slip: f64, dt: f64) -> Projection;
    fn resolve_by(
        &self,
        pressure: f64,
        z: (f64, f64),
        elastic_slip: f64,
        slip: (f64, f64),
    ) -> Projection;
}

impl InThePlane for FrictionLaw {
    fn update_by(&self, pressure: f64, slip: f64, elastic_slip: f64, dt: f64) -> Traction {
        self.update(pressure, Tangential::along(slip), Tangential::along(elastic_slip), dt)
    }

    fn project_by(&self, pressure: f64, z: f64, slip: f64, dt: f64) -> Projection {
        self.project(pressure, Tangential::along(z), Tangential::along(slip), dt)
    }

    fn resolve_by(
        &self,
        pressure: f64,
        (z, kappa): (f64, f64),
        elastic_slip: f64,
        (slip, dt): (f64, f64),
    ) -> Projection {
        let (z, slip) = (Tangential::along(z), Tangential::along(slip));
        self.resolve(pressure, (z, kappa), Tangential::along(elastic_slip), (slip, dt))
    }
}

/// Requirement: stick, slip and dissipated slip of backward Euler. Source: semantics, section 3.
#[test]
fn stick_then_slip() {
    let stick = elastic().update_by(1e6, 1e-6, 1e-6, 1.0);
    assert_eq!(stick.status, Status::Stick);
    assert!((stick.tau[0] - 0.3e6 * 0.5).abs() < 1e-6 && stick.dissipated_slip == 0.0);
    let slip = elastic().update_by(1e6, -9e-6, 1e-6, 1.0);
    assert_eq!(slip.status, Status::Slip);
    assert!((slip.tau[0] + 0.3e6).abs() < 1e-6);
    assert!((slip.elastic_slip[0] + CRITICAL).abs() < 1e-20);
    assert!((slip.dissipated_slip - 4e-6).abs() < 1e-18);
}

/// Requirement: both derivatives. Tolerance: central differences, relative 1e-7.
#[test]
fn derivatives_by_differences() {
    for law in laws() {
        for slip in [-9e-6, -1.3e-6, 0.7e-6, 2.1e-6, 8e-6] {
            for elastic_slip in [-2e-6, 0.0, 1e-6] {
                let (p, dt) = (1e6, 0.05);
                let at = |p: f64, s: f64| law.update_by(p, s, elastic_slip, dt).tau[0];
                let answer = law.update_by(p, slip, elastic_slip, dt);
                let by_slip = (at(p, slip + 1e-11) - at(p, slip - 1e-11)) / 2e-11;
                let by_p = (at(p + 1.0, slip) - at(p - 1.0, slip)) / 2.0;
                assert!(
                    (by_slip - answer.d_tau_d_slip.at(0, 0)).abs() < 1e-7 * 1e6 / CRITICAL,
                    "{law:?}"
                );
                assert!((by_p - answer.d_tau_d_pressure[0]).abs() < 1e-7, "{law:?}");
                assert!(answer.dissipated_slip >= 0.0);
            }
        }
    }
}

/// Requirement: tau_max rules where mu p exceeds it, and then nothing follows the pressure.
#[test]
fn largest_traction() {
    let law = coulomb(Some(2e5), None, Stick::Elastic { slip: CRITICAL });
    let answer = law.update_by(1e6, 1e-5, 0.0, 1.0);
    assert_eq!((answer.tau[0], answer.d_tau_d_pressure[0]), (2e5, 0.0));
}

/// Requirement: no pressure, no law, no multiplier: no traction.
#[test]
fn nothing_from_nothing() {
    assert_eq!(elastic().update_by(0.0, 1.0, 1.0, 1.0).tau[0], 0.0);
    assert_eq!(elastic().update_by(-1.0, 1.0, 1.0, 1.0).elastic_slip[0], 0.0);
    assert_eq!(FrictionLaw::None.update_by(1.0, 1.0, 0.0, 1.0).tau[0], 0.0);
    let zero = FrictionLaw::Coulomb {
        coefficient: 0.0,
        ellipse: Ellipse::CIRCLE,
        limit: None,
        decay: None,
        stick: Stick::Elastic { slip: 0.0 },
    };
    let answer = zero.update_by(1.0, 0.0, 0.0, 0.0);
    assert!(answer.tau[0] == 0.0 && answer.d_tau_d_slip.is_finite());
    assert!(!elastic().needs_multiplier());
}

/// Requirement: projection of Lagrange stick on the Coulomb limit, with derivatives.
#[test]
fn projection() {
    let law = coulomb(None, None, Stick::Lagrange);
    assert!(law.needs_multiplier());
    let stick = law.project_by(1e6, 1e5, 0.0, 1.0);
    assert_eq!((stick.tau[0], stick.by_z.at(0, 0), stick.by_pressure[0]), (1e5, 1.0, 0.0));
    assert_eq!(stick.status, Status::Stick);
    let slip = law.project_by(1e6, -1e7, 0.0, 1.0);
    assert_eq!((slip.by_z.at(0, 0), slip.by_pressure[0], slip.status), (0.0, -0.3, Status::Slip));
    assert!((slip.tau[0] + 3e5).abs() < 1e-9);
    let rough = FrictionLaw::Rough { stick: Stick::Lagrange };
    assert_eq!(rough.project_by(1.0, 1e9, 0.0, 1.0).tau[0], 1e9);
    assert_eq!(law.project_by(0.0, 5.0, 0.0, 1.0).tau[0], 0.0);
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
            let answer = elastic().update_by(p, slip, elastic_slip, 1.0);
            dissipated += answer.tau[0].abs() * answer.dissipated_slip;
            elastic_slip = answer.elastic_slip[0];
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
    let coulomb = |limit, decay| FrictionLaw::Coulomb {
        coefficient: 0.4,
        ellipse: Ellipse::CIRCLE,
        limit,
        decay,
        stick: elastic,
    };
    let laws =
        [coulomb(None, None), coulomb(Some(0.5), None), FrictionLaw::Rough { stick: elastic }];
    let (pressure, committed, dt) = (2.0, 0.004, 0.3);
    for (law, kappa) in laws.iter().flat_map(|law| [1.0, 30.0, 2e3].map(|kappa| (law, kappa))) {
        for z in [-4.0, -0.3, 0.05, 0.4, 3.0] {
            let found = law.resolve_by(pressure, (z, kappa), committed, (0.0, dt));
            let slip = (z - found.tau[0]) / kappa;
            let expected = law.update_by(pressure, slip, committed, dt).tau[0];
            assert!(
                (found.tau[0] - expected).abs() < 1e-12 * (1.0 + z.abs()),
                "{law:?} {kappa} {z}"
            );
        }
    }
    for law in laws.iter().chain([&coulomb(None, decay)]) {
        for z in [-4.0, -0.3, 0.05, 3.0] {
            let at = |p: f64, z: f64, slip: f64| {
                law.resolve_by(p, (z, 30.0), committed, (slip, dt)).tau[0]
            };
            let found = law.resolve_by(pressure, (z, 30.0), committed, (0.01, dt));
            let h = 1e-6;
            let differences = [
                (at(pressure, z + h, 0.01) - at(pressure, z - h, 0.01)) / (2.0 * h),
                (at(pressure + h, z, 0.01) - at(pressure - h, z, 0.01)) / (2.0 * h),
                (at(pressure, z, 0.01 + h) - at(pressure, z, 0.01 - h)) / (2.0 * h),
            ];
            for (own, difference) in
                [found.by_z.at(0, 0), found.by_pressure[0], found.by_slip.at(0, 0)]
                    .iter()
                    .zip(differences)
            {
                assert!(
                    (own - difference).abs() < 1e-6 * (1.0 + own.abs()),
                    "{law:?} {z}: {own} {difference}"
                );
            }
        }
    }
}

/// Requirement: in space all derivatives are those of the answers, in stick and in slip, with a limit
/// and with decay. Central differences with relative steps of 1e-6; tolerance 1e-6 of the largest.
#[test]
fn derivatives_in_space_by_differences() {
    let stick = Stick::Elastic { slip: CRITICAL };
    let decay = Some(Decay { kinetic: 0.1, rate: 2e3 });
    let (p, dt, kappa) = (1e6, 0.05, 2e10);
    let before = Tangential([1e-6, -0.7e-6]);
    for law in laws().into_iter().chain([coulomb(None, decay, stick)]) {
        for slip in [[0.9e-6, 1.1e-6], [5e-6, -6e-6], [-2e-6, 8e-6]].map(Tangential) {
            let answer = law.update(p, slip, before, dt);
            let by = |d: Tangential| {
                let at = |s| law.update(p, s, before, dt).tau;
                (at(slip + d) - at(slip - d)) / (2.0 * d.size())
            };
            agree(answer.d_tau_d_slip, by, 1e-12, 0.3 * p / CRITICAL);
            let z = 1e11 * slip;
            let resolved = law.resolve(p, (z, kappa), before, (slip, dt));
            let by = |d: Tangential| {
                let at = |z| law.resolve(p, (z, kappa), before, (slip, dt)).tau;
                (at(z + d) - at(z - d)) / (2.0 * d.size())
            };
            agree(resolved.by_z, by, 1e-1, 1.0);
        }
    }
    let exact = coulomb(None, decay, Stick::Lagrange);
    for z in [[1e5, 2e5], [3e5, -4e5]].map(Tangential) {
        let slip = Tangential([2e-6, 1e-6]);
        let projected = exact.project(p, z, slip, dt);
        let by = |d: Tangential| {
            let at = |z| exact.project(p, z, slip, dt).tau;
            (at(z + d) - at(z - d)) / (2.0 * d.size())
        };
        agree(projected.by_z, by, 1e-1, 1.0);
        let by = |d: Tangential| {
            let at = |slip| exact.project(p, z, slip, dt).tau;
            (at(slip + d) - at(slip - d)) / (2.0 * d.size())
        };
        agree(projected.by_slip, by, 1e-12, 1e9);
    }
}

/// Holds a map against differences along both directions.
fn agree(map: TangentialMap, by: impl Fn(Tangential) -> Tangential, step: f64, scale: f64) {
    for unit in [[1.0, 0.0], [0.0, 1.0]].map(Tangential) {
        let off = map.apply(unit) - by(step * unit);
        assert!(off.size() < 1e-6 * scale, "{map:?} {unit:?}: {off:?}");
    }
}

/// Requirement: no direction of the tangent plane is special: turned by any angle, slip, traction and
/// elastic slip turn, limit and dissipated slip stay; along one direction it is the law of the plane.
/// Tolerance: rounding.
#[test]
fn friction_in_space_is_isotropic() {
    for law in laws() {
        for (slip, before) in [(2e-6, 1e-6), (7e-6, -1e-6), (-9e-6, 3e-6)] {
            let plane = law.update_by(1e6, slip, before, 0.05);
            for angle in [0.3_f64, 1.2, 2.9] {
                let way = Tangential([angle.cos(), angle.sin()]);
                let space = law.update(1e6, slip * way, before * way, 0.05);
                assert!((space.tau - plane.tau[0] * way).size() < 1e-9 * 1e6);
                assert!((space.elastic_slip - plane.elastic_slip[0] * way).size() < 1e-20);
                assert!((space.dissipated_slip - plane.dissipated_slip).abs() < 1e-20);
                assert_eq!(space.status, plane.status);
            }
        }
    }
}
