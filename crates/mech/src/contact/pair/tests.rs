use super::*;
use crate::contact::friction::{Decay, Ellipse, Stick};

fn soft() -> NormalLaw {
    NormalLaw::Exponential { clearance: 1e-5, pressure: 4.8e6 }
}

fn coulomb(stick: Stick, decay: Option<Decay>) -> FrictionLaw {
    FrictionLaw::Coulomb { coefficient: 0.3, ellipse: Ellipse::CIRCLE, limit: None, decay, stick }
}

fn laws(friction: FrictionLaw) -> Laws {
    Laws { normal: soft(), friction, onset: Onset::Immediate, user: None }
}

fn trial(overclosure: f64, slip: f64) -> PointTrial {
    let (slip, traction) = (Tangential::along(slip), Tangential::ZERO);
    PointTrial { overclosure, slip, pressure: 0.0, traction, stiffness: 1e12, dt: 0.05 }
}

/// No law of a user, no state_variables.
fn state_variables(fault: &mut Option<UserFrictionError>) -> UserState<'_> {
    UserState { time: 0.0, committed: &[], state: &mut [], fault }
}

/// Requirement: the derivatives that a complementarity states are those of the complementarity. Central differences
/// with relative steps of 1e-6; tolerance 1e-6 of the largest derivative (truncation 1e-12, rounding
/// 1e-10 of the value).
#[test]
fn demands_by_differences() {
    let elastic = coulomb(Stick::Elastic { slip: 4e-6 }, None);
    let decaying = coulomb(Stick::Lagrange, Some(Decay { kinetic: 0.2, rate: 1e3 }));
    let kappa = 3e11;
    for friction in [elastic, decaying] {
        let laws = laws(friction);
        for (tau, slip, p) in [(1e5, 1e-6, 2e6), (9e5, 5e-6, 2e6), (-9e5, -5e-6, 1e6)] {
            let at = |[tau, slip, p]: [f64; 3]| {
                laws.complementarity_of_traction(
                    (Tangential::along(tau), Tangential::along(slip), p),
                    Tangential::along(5e-7),
                    (kappa, 0.05),
                    &mut state_variables(&mut None),
                )
            };
            let asked = at([tau, slip, p]);
            let stated =
                [asked.by_multiplier.at(0, 0), asked.by_value.at(0, 0), asked.by_pressure[0]];
            for (k, size) in [1e5, 1e-6, 1e6].into_iter().enumerate() {
                let step = 1e-6 * size;
                let (mut up, mut down) = ([tau, slip, p], [tau, slip, p]);
                up[k] += step;
                down[k] -= step;
                let difference = (at(up).value - at(down).value)[0] / (2.0 * step);
                let scale = stated[k].abs().max(1e5 / size * 1e-2);
                assert!(
                    (difference - stated[k]).abs() < 1e-5 * scale,
                    "{k} {difference} {stated:?}"
                );
            }
        }
        for (p, h) in [(1e5, -8e-6), (3e6, -1e-6), (0.0, -2e-5)] {
            let at = |p: f64, h: f64| laws.complementarity_of_pressure(p, h, kappa).value;
            let complementarity = laws.complementarity_of_pressure(p, h, kappa);
            let by_p = (at(p + 1.0, h) - at(p - 1.0, h)) / 2.0;
            let by_h = (at(p, h + 1e-12) - at(p, h - 1e-12)) / 2e-12;
            assert!(
                (by_p - complementarity.by_multiplier).abs() < 1e-5,
                "{by_p} {complementarity:?}"
            );
            assert!(
                (by_h - complementarity.by_value).abs() < 1e-5 * kappa,
                "{by_h} {complementarity:?}"
            );
        }
    }
}

/// Requirement: a solution of the complementarity equation obeys the law: lambda = complementarity(lambda, h) exactly
/// where lambda = p(h). Tolerance: round-off of the resolvent.
#[test]
fn the_law_is_the_solution_of_its_demand() {
    let laws = laws(FrictionLaw::None);
    for h in [-9e-6, -5e-6, 0.0, 8e-6] {
        let p = laws.pressure(h, 0.0);
        for kappa in [1e9, 1e12, 1e14] {
            let complementarity = laws.complementarity_of_pressure(p, h, kappa);
            assert!((complementarity.value - p).abs() < 1e-11 * p, "{h} {kappa}");
        }
    }
}

/// Requirement: friction dissipates: traction and dissipated slip never have opposite signs, and the
/// traction opposes motion (has the sign of the slip).
#[test]
fn friction_dissipates() {
    for stick in [Stick::Elastic { slip: 4e-6 }, Stick::Lagrange] {
        let laws = laws(coulomb(stick, None));
        for slip in [-1e-3, -5e-6, 5e-6, 1e-3] {
            let history = History {
                closed: true,
                along: Some(Tangential::ZERO),
                elastic_slip: Tangential::ZERO,
            };
            let response =
                laws.respond(&history, &trial(-2e-6, slip), &mut state_variables(&mut None));
            assert!(response.traction.tau[0] * slip > 0.0);
            assert!(response.traction.dissipated_slip >= 0.0);
        }
    }
}

/// Requirement: a point that faces nothing carries nothing, also under a law that pulls.
#[test]
fn nothing_faces_nothing() {
    let pulling = NormalLaw::CalculixLinear { stiffness: 1e10, tension: 1e3, pulls: true };
    for normal in [soft(), pulling, NormalLaw::Hard] {
        let laws =
            Laws { normal, friction: FrictionLaw::None, onset: Onset::Immediate, user: None };
        let response = laws.respond(
            &History::default(),
            &trial(f64::NEG_INFINITY, 0.0),
            &mut state_variables(&mut None),
        );
        assert!(!response.closed && response.pressure == 0.0);
    }
}

/// Requirement: on a closed surface the slip is the short way round.
#[test]
fn slip_wraps_at_the_period() {
    let (from, to) = (Tangential([9.5, 0.3]), Tangential([0.5, 0.7]));
    let history = History { closed: true, along: Some(from), elastic_slip: Tangential::ZERO };
    assert!((slip(&history, to, Some(10.0)) - Tangential([1.0, 0.4])).size() < 1e-14);
    assert_eq!(slip(&history, to, None), to - from);
    assert_eq!(slip(&History::default(), to, None), Tangential::ZERO);
}

/// Requirement: the gap to the nose beyond a sharp edge is the distance from its parabola, and its
/// coordinate goes on from that of the straight part, on either side.
#[test]
fn gaps_to_noses_are_distances_from_their_parabolas() {
    use super::super::search::chain::{Chain, PieceKind};
    use super::super::search::nearest::Nearby;
    use super::super::search::outlook::Outlook;
    use super::super::search::sharp;
    let block = [[0.0, -1.5, 0.0], [0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, -1.0, 0.0]];
    let mut chain = Chain::new(&block, Some(0.2), 0.1).unwrap();
    chain.slave = 0.5;
    let mut outlook = Outlook::EVERYWHERE;
    outlook.add([0.0, -1.0, 0.0], 0.5);
    // a way of 0.05 prolongs the top; the nose goes on by 0.05 and down by 0.05
    for (edge, out, ahead) in [(2.0, 1.0, true), (0.0, -1.0, false)] {
        let point = [edge + out * 0.08, 0.03, 0.0];
        let at = (point, None, &outlook);
        let piece = sharp::closest(&chain, &block, Nearby::Positions, at).unwrap();
        assert_eq!(piece.kind, PieceKind::Nose { ahead });
        let [over, along] = super::chain::chain_overclosure(&chain, &piece, &block, point).unwrap();
        let least = (0..=20_000).map(|k| {
            let s = f64::from(k) / 20_000.0;
            let (x, y) = (0.05 + 0.1 * s - 0.05 * s * s, -0.05 * s * s);
            (point[0] - edge - out * x).hypot(point[1] - y)
        });
        let least = least.fold(f64::INFINITY, f64::min);
        assert!((over + least).abs() < 1e-8, "{over} {least}");
        let from = if ahead { 3.5 } else { 1.5 };
        let on = out * (along - from);
        assert!((0.05..0.15).contains(&on), "{along}");
    }
}
