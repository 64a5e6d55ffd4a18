//! Friction whose limit is an ellipse: derivatives, the rule of slip, dissipation, exact projections.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // test code throughout

use slideline_mech::contact::friction::{
    Ellipse, FrictionLaw, Status, Stick, Tangential, TangentialMap,
};

const COEFFICIENTS: [f64; 2] = [0.2, 0.5];
const PRESSURE: f64 = 3.0;
const ELASTIC: Stick = Stick::Elastic { slip: 0.02 };
const BEFORE: Tangential = Tangential([0.004, -0.007]);
const KAPPA: f64 = 30.0;

fn law(stick: Stick) -> FrictionLaw {
    let (coefficient, ellipse) = Ellipse::of(COEFFICIENTS);
    FrictionLaw::Coulomb { coefficient, ellipse, limit: None, decay: None, stick }
}

/// Slips that stick, that slide a little and far.
fn slips() -> [Tangential; 4] {
    [[0.002, 0.003], [0.09, 0.01], [-0.03, 0.06], [4.0, -1.0]].map(Tangential)
}

/// tau over mu p: one on the limit.
fn share(tau: Tangential) -> f64 {
    let [a, b] = [0, 1].map(|k| tau[k] / (COEFFICIENTS[k] * PRESSURE));
    a.hypot(b)
}

/// Whether a slip is normal to the ellipse where a traction is.
fn is_normal(slip: Tangential, tau: Tangential) -> bool {
    let normal = Tangential([0, 1].map(|k| tau[k] / (COEFFICIENTS[k] * COEFFICIENTS[k])));
    (slip.direction() - normal.direction()).size() < 1e-12
}

/// Requirement: with elastic stick the traction is inside the ellipse or on it; the slip that is not
/// elastic is normal to it, and dissipates what is said, never less than nothing. Tolerance: rounding.
#[test]
fn slip_is_normal_to_the_ellipse() {
    for slip in slips() {
        let answer = law(ELASTIC).update(PRESSURE, slip, BEFORE, 1.0);
        let lasting = BEFORE + slip - answer.elastic_slip;
        let work = answer.tau.dot(lasting);
        assert!((work - answer.tau.size() * answer.dissipated_slip).abs() < 1e-14 * (1.0 + work));
        match answer.status {
            Status::Stick => assert!(share(answer.tau) <= 1.0 && lasting.size() < 1e-15),
            Status::Slip => {
                assert!((share(answer.tau) - 1.0).abs() < 1e-14 && work > 0.0);
                assert!(is_normal(lasting, answer.tau), "{lasting:?} {:?}", answer.tau);
            }
        }
    }
}

/// Requirement: exact stick and elastic stick through a stiffness find the traction where law and
/// structure balance, whatever kappa is: the way that is left, (z - tau) over what kappa makes of a
/// way, is the law's. Tolerance: rounding.
#[test]
fn a_projection_is_where_law_and_structure_balance() {
    let (_, ellipse) = Ellipse::of(COEFFICIENTS);
    for kappa in [1.0, KAPPA, 2e3] {
        let per = [[1.0, 0.0], [0.0, 1.0]].map(|unit| ellipse.carried(kappa, Tangential(unit)));
        let left = |z: Tangential, tau: Tangential| {
            Tangential([(z[0] - tau[0]) / per[0][0], (z[1] - tau[1]) / per[1][1]])
        };
        for z in [[0.1, 0.2], [0.5, 1.0], [-3.0, 0.4], [0.1, -40.0]].map(Tangential) {
            let exact = law(Stick::Lagrange).project(PRESSURE, z, Tangential::ZERO, 1.0);
            let way = left(z, exact.tau);
            match exact.status {
                Status::Stick => assert!((exact.tau - z).size() < 1e-15 && share(z) < 1.0),
                Status::Slip => {
                    assert!((share(exact.tau) - 1.0).abs() < 1e-14);
                    assert!(is_normal(way, exact.tau), "{kappa} {z:?}: {way:?} {:?}", exact.tau);
                }
            }
            let none = (Tangential::ZERO, 1.0);
            let elastic = law(ELASTIC).resolve(PRESSURE, (z, kappa), BEFORE, none);
            let way = left(z, elastic.tau);
            let expected = law(ELASTIC).update(PRESSURE, way, BEFORE, 1.0).tau;
            let off = (elastic.tau - expected).size();
            assert!(
                off < 1e-12 * (1.0 + z.size()),
                "{kappa} {z:?}: {:?} {expected:?}",
                elastic.tau
            );
        }
    }
}

/// Requirement: all derivatives are those of the answers. Central differences, 1e-6 of the largest.
#[test]
fn derivatives_by_differences() {
    let none = (Tangential::ZERO, 1.0);
    for slip in slips() {
        let at = |slip| law(ELASTIC).update(PRESSURE, slip, BEFORE, 1.0);
        agree(at(slip).d_tau_d_slip, |d| (at(slip + d).tau, at(slip - d).tau), 75.0);
        let by = |p: f64| law(ELASTIC).update(p, slip, BEFORE, 1.0).tau;
        let difference = (by(PRESSURE + 1e-6) - by(PRESSURE - 1e-6)) / 2e-6;
        assert!((at(slip).d_tau_d_pressure - difference).size() < 1e-6);
        let z = KAPPA * slip;
        let at = |z| law(ELASTIC).resolve(PRESSURE, (z, KAPPA), BEFORE, none);
        agree(at(z).by_z, |d| (at(z + d).tau, at(z - d).tau), 1.0);
        let at = |z| law(Stick::Lagrange).project(PRESSURE, z, Tangential::ZERO, 1.0);
        agree(at(z).by_z, |d| (at(z + d).tau, at(z - d).tau), 1.0);
        let by = |p: f64| law(Stick::Lagrange).project(p, z, Tangential::ZERO, 1.0).tau;
        let difference = (by(PRESSURE + 1e-6) - by(PRESSURE - 1e-6)) / 2e-6;
        assert!((at(z).by_pressure - difference).size() < 1e-6);
    }
}

/// Holds a map against differences along both directions.
fn agree(map: TangentialMap, both: impl Fn(Tangential) -> (Tangential, Tangential), scale: f64) {
    for unit in [[1.0, 0.0], [0.0, 1.0]].map(Tangential) {
        let (more, less) = both(1e-6 * unit);
        let off = map.apply(unit) - (more - less) / 2e-6;
        assert!(off.size() < 1e-6 * scale, "{map:?} {unit:?}: {off:?}");
    }
}

/// Requirement: a direction whose coefficient is zero has no traction and no multiplier; the other one
/// has all of it.
#[test]
fn one_coefficient_may_be_zero() {
    let (coefficient, ellipse) = Ellipse::of([0.4, 0.0]);
    for stick in [ELASTIC, Stick::Lagrange] {
        let law = FrictionLaw::Coulomb { coefficient, ellipse, limit: None, decay: None, stick };
        let slip = Tangential([0.5, -2.0]);
        let tau = match law.needs_multiplier() {
            true => law.project(PRESSURE, KAPPA * slip, slip, 1.0).tau,
            false => law.update(PRESSURE, slip, Tangential::ZERO, 1.0).tau,
        };
        assert!((tau - Tangential([0.4 * PRESSURE, 0.0])).size() < 1e-14, "{tau:?}");
    }
}
