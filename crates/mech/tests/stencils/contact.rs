//! Contact composed: the geometry of the 1995 decks, balance, objectivity, no NaN.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // test code throughout

use proptest::prelude::*;
use slideline_mech::contact::friction::{Ellipse, FrictionLaw, Stick};
use slideline_mech::contact::gap::Quadratic;
use slideline_mech::contact::gap::offset::Offset;
use slideline_mech::contact::normal::NormalLaw;
use slideline_mech::contact::onset::Onset;
use slideline_mech::contact::pair::{
    AnyGap, Body, History, Laws, PointTrial, RigidSurface, UserState, chain_gap, chain_overclosure,
};
use slideline_mech::contact::search::chain::Chain;
use slideline_mech::contact::search::chain::{flat, raised};
use slideline_mech::contact::search::nearest::Nearby;
use slideline_mech::contact::search::rigid::{Part, RigidSegment};
use slideline_mech::contact::tangential::Tangential;
use slideline_mech::rigid::{Attachment, PointMap, push_forward};

const STILL: Body = Body { reference: [0.0, 45e-3, 0.0], dofs: [0.0; 3] };

fn beam_nodes(count: usize) -> Vec<[f64; 3]> {
    (0..count)
        .map(|i| {
            let s = i as f64 / (count - 1) as f64;
            [7e-3 + s * 2.222e-3, s * 50e-3, 0.0]
        })
        .collect()
}

/// The circle of the seed's IRS deck.
fn circle() -> RigidSurface {
    let centre = [0.0, 45e-3];
    RigidSurface::new(vec![
        RigidSegment::arc([0.0, 54e-3], [9e-3, 45e-3], centre).unwrap(),
        RigidSegment::arc([9e-3, 45e-3], [0.0, 36e-3], centre).unwrap(),
    ])
}

fn overclosure_of_node(nodes: &[[f64; 3]], number: usize) -> f64 {
    let point = nodes[number - 1];
    let facing = circle().closest(&STILL, point).unwrap();
    circle().gap::<Quadratic>(&STILL, &facing, (point, Offset::NONE)).unwrap().overclosure()
}

/// Requirement: initial overclosures of the IRS decks. Source: semantics, section 1, point 4.
/// Tolerance: the digits printed there.
#[test]
fn initial_overclosure_of_the_1995_rigid_surface_decks() {
    let (coarse, fine) = (beam_nodes(25), beam_nodes(100));
    assert!((overclosure_of_node(&coarse, 22) + 31.17e-6).abs() < 6e-9);
    assert!((overclosure_of_node(&fine, 89) - 7.71e-6).abs() < 6e-9);
    assert!((overclosure_of_node(&fine, 90) - 2.30e-6).abs() < 6e-9);
}

/// Requirement: initial overclosures of the slide line deck, smoothing 0.25, nodes 2 to 25. Source:
/// semantics, section 1, point 4. Tolerance: the digits printed there.
#[test]
fn initial_overclosure_of_the_1995_slide_line_deck() {
    let nodes = beam_nodes(25)[1..].to_vec();
    let chain = Chain::new(&nodes, Some(0.25), 0.1).unwrap();
    let at = |degrees: f64| {
        let (s, c) = degrees.to_radians().sin_cos();
        let point = [9e-3 * s, 45e-3 - 9e-3 * c, 0.0];
        let piece = chain.closest(&nodes, Nearby::Positions, point).unwrap();
        chain_gap::<Quadratic>(&chain, &piece, &nodes, (point, Offset::NONE)).unwrap()
    };
    assert!((at(88.0).overclosure() - 8.667e-6).abs() < 6e-10);
    assert!((at(84.0).overclosure() + 7.289e-6).abs() < 6e-10);
    assert!(at(80.0).overclosure() < -19e-6 && at(92.0).overclosure() < -19e-6);
    assert!(at(88.0).normal()[0] < 0.0); // towards the circle
}

/// Requirement: overclosure, coordinate and normal are continuous from straight part to corner and
/// back for a point moving along a smoothed chain. Tolerance: the step.
#[test]
fn smoothed_chain_is_continuous() {
    let nodes = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.4], [3.5, 0.1]].map(raised);
    let chain = Chain::new(&nodes, Some(0.3), 0.1).unwrap();
    let mut last: Option<AnyGap> = None;
    for i in 0..20_000 {
        let x = 0.2 + f64::from(i) * 1.5e-4;
        let point = [x, 0.3, 0.0];
        let piece = chain.closest(&nodes, Nearby::Positions, point).unwrap();
        let gap = chain_gap::<Quadratic>(&chain, &piece, &nodes, (point, Offset::NONE)).unwrap();
        let values = chain_overclosure(&chain, &piece, &nodes, point).unwrap();
        assert_eq!(values, [gap.overclosure(), gap.along()[0]]);
        if let Some(before) = last {
            assert!((gap.overclosure() - before.overclosure()).abs() < 2e-4, "{x}");
            let step = (gap.along() - before.along()).size();
            assert!(step < 1e-3, "{x}: {step}");
            assert!((gap.normal()[0] - before.normal()[0]).abs() < 3e-3, "{x}");
        }
        last = Some(gap);
    }
}

/// Requirement: the coordinate along a rigid surface runs on from one arc to the next.
#[test]
fn coordinate_runs_on_at_a_joint() {
    let along = |degrees: f64| {
        let (s, c) = degrees.to_radians().sin_cos();
        let point = [9.01e-3 * s, 45e-3 + 9.01e-3 * c, 0.0];
        let facing = circle().closest(&STILL, point).unwrap();
        circle().gap::<Quadratic>(&STILL, &facing, (point, Offset::NONE)).unwrap().along()[0]
    };
    for degrees in [0.5, 30.0, 89.999_999, 90.000_001, 120.0, 179.5] {
        assert!((along(degrees) - 9e-3 * f64::to_radians(degrees)).abs() < 1e-15, "{degrees}");
    }
}

fn rubbing() -> Laws {
    Laws {
        normal: NormalLaw::Linear { stiffness: 50.0 },
        friction: FrictionLaw::Coulomb {
            coefficient: 0.3,
            ellipse: Ellipse::CIRCLE,
            limit: None,
            decay: None,
            stick: Stick::Elastic { slip: 0.01 },
        },
        onset: Onset::Immediate,
        user: None,
    }
}

/// Force p dh + tau d sigma over the variables of a gap and its derivative, for a given slip.
fn force_and_tangent(gap: &AnyGap, slip: f64) -> (Vec<f64>, Vec<f64>) {
    let laws = rubbing();
    let slip = Tangential::along(slip);
    let (along, elastic_slip) = (Some(gap.along() - slip), Tangential::ZERO);
    let history = History { closed: true, along, elastic_slip };
    let overclosure = gap.overclosure();
    let (pressure, traction, stiffness, dt) = (0.0, Tangential::ZERO, 0.0, 1.0);
    let trial = PointTrial { overclosure, slip, pressure, traction, stiffness, dt };
    let mut state_variables =
        UserState { time: 0.0, committed: &[], state: &mut [], fault: &mut None };
    let response = laws.respond(&history, &trial, &mut state_variables);
    let (p, tau) = (response.pressure, response.traction);
    let slope = laws.normal.pressure(overclosure).unwrap().1;
    let d = gap.derivatives();
    let [hessian, of_direction] = gap.second_derivatives();
    let n = gap.width();
    let force = (0..n).map(|i| p * d.gradient[i] + tau.tau[0] * d.direction[i]).collect();
    let tangent = (0..n * n).map(|k| {
        let (i, j) = (k / n, k % n);
        let by_slip = tau.d_tau_d_slip.at(0, 0) * d.slip_gradient[j];
        let by_pressure = tau.d_tau_d_pressure[0] * slope * d.gradient[j];
        p * hessian[k]
            + tau.tau[0] * of_direction[k]
            + slope * d.gradient[i] * d.gradient[j]
            + d.direction[i] * (by_slip + by_pressure)
    });
    (force, tangent.collect())
}

/// Sum of forces and moment about the origin for forces at positions.
fn balance(force: &[f64], positions: &[[f64; 2]]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (f, x) in force.chunks(2).zip(positions) {
        sum[0] += f[0];
        sum[1] += f[1];
        sum[2] += x[0] * f[1] - x[1] * f[0];
    }
    sum
}

fn wavy(jitter: &[f64; 8]) -> Vec<[f64; 3]> {
    (0..4).map(|i| [i as f64 + jitter[2 * i], jitter[2 * i + 1], 0.0]).collect()
}

/// Mixed rigid surface: line, convex corner, line, arc, parabola.
fn surface() -> RigidSurface {
    RigidSurface::new(vec![
        RigidSegment::Line { a: [-2.0, -1.0], b: [-1.0, 0.0] },
        RigidSegment::Line { a: [-1.0, 0.0], b: [0.0, 0.0] },
        RigidSegment::arc([0.0, 0.0], [1.0, -1.0], [0.0, -1.0]).unwrap(),
        RigidSegment::Parabola { start: [1.0, -1.0], mid: [1.5, -1.8], end: [2.5, -2.0] },
    ])
}

/// Force and tangent on the dofs, the coordinate along the surface, and the segment with its part.
type OnDofs = ([f64; 5], [f64; 25], f64, (usize, Part));

/// Local dofs: slave (x, y), body (x, y, phi); force and tangent pushed to them.
fn on_dofs(dofs: &[f64; 5], slip_origin: Option<f64>) -> Option<OnDofs> {
    let body = Body { reference: [0.3, -1.7, 0.0], dofs: [dofs[2], dofs[3], dofs[4]] };
    let point = [dofs[0], dofs[1], 0.0];
    let facing = surface().closest(&body, point)?;
    let gap = surface().gap::<Quadratic>(&body, &facing, (point, Offset::NONE))?;
    let slave = Attachment::Point { map: PointMap::Free, first: 0 };
    let attachments = surface().attachments(&body, &facing, slave, 2)?;
    let slip = slip_origin.map_or(0.2, |origin| gap.along()[0] - origin);
    let (force, tangent) = force_and_tangent(&gap, slip);
    let (mut f, mut t) = ([0.0; 5], [0.0; 25]);
    push_forward(attachments.as_slice(), dofs, &force, &tangent, &mut f, &mut t);
    Some((f, t, gap.along()[0], (facing.segment, facing.part)))
}

fn spans() -> impl Strategy<Value = [f64; 5]> {
    (-1.8..2.4_f64, -2.6..0.4_f64, -0.2..0.2_f64, -0.2..0.2_f64, -1.0..1.0_f64)
        .prop_map(|(a, b, c, d, e)| [a, b, c, d, e])
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Action = reaction in force and moment on a chain, at any overclosure, friction included.
    #[test]
    fn chain_is_in_balance(j in prop::array::uniform8(-0.2..0.2_f64), p in (0.1..2.9_f64, -0.3..0.3_f64), f in 0.0..0.45_f64, slip in -0.1..0.1_f64) {
        let nodes = wavy(&j);
        let reference = wavy(&[0.0; 8]);
        let chain = Chain::new(&reference, Some(f), 0.1).unwrap();
        let point = [p.0, p.1, 0.0];
        if let Some(piece) = chain.closest(&nodes, Nearby::Positions, point) {
            let gap = chain_gap::<Quadratic>(&chain, &piece, &nodes, (point, Offset::NONE)).unwrap();
            let mut positions = vec![flat(point)];
            positions.extend(nodes[piece.nodes()].iter().copied().map(flat));
            let sum = balance(&force_and_tangent(&gap, slip).0, &positions);
            prop_assert!(sum.iter().all(|s| s.abs() < 1e-12 * 50.0), "{:?}", sum);
        }
    }

    /// Objectivity of a chain: turning and moving everything changes neither h nor sigma.
    #[test]
    fn chain_is_objective(j in prop::array::uniform8(-0.2..0.2_f64), p in (0.1..2.9_f64, -0.3..0.3_f64), f in 0.0..0.45_f64, turn in -3.0..3.0_f64) {
        let nodes = wavy(&j);
        let chain = Chain::new(&wavy(&[0.0; 8]), Some(f), 0.1).unwrap();
        let (s, c) = turn.sin_cos();
        let moved = |x: [f64; 3]| [c * x[0] - s * x[1] + 0.3, s * x[0] + c * x[1] - 0.7, 0.0];
        let there: Vec<_> = nodes.iter().map(|x| moved(*x)).collect();
        let point = [p.0, p.1, 0.0];
        if let Some(piece) = chain.closest(&nodes, Nearby::Positions, point) {
            let other = chain.closest(&there, Nearby::Positions, moved(point)).unwrap();
            let a = chain_gap::<Quadratic>(&chain, &piece, &nodes, (point, Offset::NONE)).unwrap();
            let b = chain_gap::<Quadratic>(&chain, &other, &there, (moved(point), Offset::NONE)).unwrap();
            prop_assert!((a.overclosure() - b.overclosure()).abs() < 1e-13, "{piece:?} {other:?}");
            prop_assert!((a.along() - b.along()).size() < 1e-12);
        }
    }

    /// A rigid surface on its body: forces and the moment about the origin balance, the tangent on
    /// the dofs (body rotation included) is that of differences.
    #[test]
    fn rigid_surface_on_dofs(dofs in spans()) {
        // too many points without a facing part would fail the test
        let Some((f, t, along, part)) = on_dofs(&dofs, None) else { return Err(TestCaseError::reject("faces nothing")) };
        let node = [0.3 + dofs[2], -1.7 + dofs[3]];
        let sum = balance(&f[..4], &[[dofs[0], dofs[1]], node]);
        prop_assert!(sum[0].abs() < 1e-12 * 50.0 && sum[1].abs() < 1e-12 * 50.0);
        prop_assert!((sum[2] + f[4]).abs() < 1e-11 * 50.0, "{}", sum[2] + f[4]);
        let origin = Some(along - 0.2);
        let most = t.iter().fold(1.0_f64, |a, b| a.max(b.abs()));
        for j in 0..5 {
            let (mut up, mut down) = (dofs, dofs);
            up[j] += 1e-6;
            down[j] -= 1e-6;
            let (Some(up), Some(down)) = (on_dofs(&up, origin), on_dofs(&down, origin)) else {
                continue;
            };
            // A step across a joint of two segments is no difference quotient.
            if up.3 != part || down.3 != part {
                continue;
            }
            for i in 0..5 {
                let difference = (up.0[i] - down.0[i]) / 2e-6;
                prop_assert!((difference - t[5 * i + j]).abs() < 1e-6 * most, "{} {} {:?}", i, j, part);
            }
        }
    }

    /// Finite input never gives NaN: a gap has finite numbers or is `None`.
    #[test]
    fn no_nan(nodes in prop::collection::vec(prop::array::uniform3(prop::num::f64::NORMAL | prop::num::f64::ZERO), 4), point in prop::array::uniform3(-1e3..1e3_f64)) {
        let chain = Chain::new(&wavy(&[0.0; 8]), Some(0.2), 0.1).unwrap();
        if let Some(piece) = chain.closest(&nodes, Nearby::Positions, point)
            && let Some(gap) = chain_gap::<Quadratic>(&chain, &piece, &nodes, (point, Offset::NONE))
        {
            prop_assert!(gap.overclosure().is_finite() && gap.along().is_finite());
        }
        let same = vec![point; 4];
        prop_assert!(chain.closest(&same, Nearby::Positions, point).is_none());
    }

    /// The same for rigid surfaces, far and near.
    #[test]
    fn no_nan_on_rigid_surfaces(point in prop::array::uniform3(prop::num::f64::NORMAL | prop::num::f64::ZERO), dofs in prop::array::uniform3(-10.0..10.0_f64)) {
        let body = Body { reference: [0.0; 3], dofs };
        if let Some(facing) = surface().closest(&body, point)
            && let Some(gap) = surface().gap::<Quadratic>(&body, &facing, (point, Offset::NONE))
        {
            prop_assert!(gap.overclosure().is_finite() && gap.along().is_finite());
        }
    }
}
