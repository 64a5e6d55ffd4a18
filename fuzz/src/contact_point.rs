//! A contact point never gives NaN for finite input of any size that a model
//! can hold.

use slideline::mech::contact::friction::{Ellipse, FrictionLaw, Stick};
use slideline::mech::contact::gap::offset::Offset;
use slideline::mech::contact::normal::NormalLaw;
use slideline::mech::contact::pair::{AnyGap, Body, RigidSurface, chain_gap};
use slideline::mech::contact::search::chain::{Chain, raised};
use slideline::mech::contact::search::nearest::Nearby;
use slideline::mech::contact::search::rigid::RigidSegment;
use slideline::mech::contact::tangential::Tangential;

/// Laws, a chain and a rigid surface of these numbers.
pub fn check(bytes: &[u8]) {
    let v = numbers(bytes);
    if v.len() < 12 {
        return;
    }
    laws(&v);
    let points: Vec<[f64; 2]> = v[8..].chunks_exact(2).map(|xy| [xy[0], xy[1]]).collect();
    let smoothing = (v[2] / 2e9).abs().min(0.499);
    chain(&points, smoothing, [v[4], v[5]]);
    rigid(&points, [v[4], v[5]], [v[6], v[7], v[3]]);
}

/// Numbers of magnitude 1e-9 to 1e9, both signs, and 0.
fn numbers(bytes: &[u8]) -> Vec<f64> {
    let read = |chunk: &[u8]| i32::from_le_bytes([chunk[0], chunk[1], chunk[2], chunk[3]]);
    let scaled = |n: i32| f64::from(n) * 10f64.powi(n.rem_euclid(10) - 9);
    bytes.chunks_exact(4).map(read).map(scaled).collect()
}

fn laws(v: &[f64]) {
    let (length, pressure) = (v[0].abs() + 1e-9, v[1].abs() + 1e-9);
    let laws = [
        NormalLaw::Exponential { clearance: length, pressure },
        NormalLaw::CalculixExponential { clearance: length, pressure },
        NormalLaw::CalculixLinear { stiffness: pressure, tension: length, pulls: true },
        NormalLaw::CalculixLinear { stiffness: pressure, tension: length, pulls: false },
        NormalLaw::Linear { stiffness: pressure },
        NormalLaw::Tabular(vec![(0.0, -length), (pressure, length), (2.0 * pressure, 1e9)]),
    ];
    for law in &laws {
        let (p, slope) = law.pressure(v[2]).unwrap_or_default();
        let energy = law.energy(v[2]);
        assert!(p.is_finite() && slope.is_finite() && energy.is_finite(), "{law:?} at {}", v[2]);
        for stick in [Stick::Lagrange, Stick::Elastic { slip: length }] {
            let coefficient = v[3].abs().min(10.0);
            let friction = FrictionLaw::Coulomb {
                coefficient,
                ellipse: Ellipse::CIRCLE,
                limit: None,
                decay: None,
                stick,
            };
            let slip = Tangential([v[4], v[6]]);
            let before = Tangential([v[5].clamp(-length, length), 0.0]);
            let tau = friction.update(p, slip, before, 1.0).tau;
            let limit = friction.limit_traction(p, slip, 1.0);
            assert!(!tau[0].is_nan() && !tau[1].is_nan() && !limit.is_nan());
        }
    }
}

/// Surfaces that stand off.
const OFFSET: Offset = Offset { slave: 0.1, master: 0.05 };

fn chain(nodes: &[[f64; 2]], smoothing: f64, point: [f64; 2]) {
    let nodes: Vec<_> = nodes.iter().copied().map(raised).collect();
    let (nodes, point) = (&nodes[..], raised(point));
    let Some(chain) = Chain::new(nodes, Some(smoothing).filter(|own| *own < 0.4), 0.1) else {
        return;
    };
    let Some(piece) = chain.closest(nodes, Nearby::Positions, point) else { return };
    assert!(piece.nodes().end <= nodes.len() && !piece.parameter.is_nan(), "{piece:?}");
    if let Some(gap) = chain_gap(&chain, &piece, nodes, (point, OFFSET)) {
        finite(&gap);
    }
}

/// Lines, arcs about every third point, parabolas.
fn rigid(points: &[[f64; 2]], point: [f64; 2], dofs: [f64; 3]) {
    let mut segments = Vec::new();
    for (k, three) in points.windows(3).step_by(2).enumerate() {
        let [a, b, c] = [three[0], three[1], three[2]];
        segments.extend(match k % 3 {
            0 if a != c => Some(RigidSegment::Line { a, b: c }),
            1 => RigidSegment::arc(a, c, b),
            2 if a != c => Some(RigidSegment::Parabola { start: a, mid: b, end: c }),
            _ => None,
        });
    }
    let surface = RigidSurface::new(segments);
    let point = raised(point);
    let body = Body { reference: [0.0; 3], dofs: [dofs[0], dofs[1], dofs[2] * 1e-9] };
    if let Some(overclosure) = surface.overclosure(&body, point) {
        assert!(!overclosure.is_nan(), "{surface:?} {point:?}");
    }
    let Some(facing) = surface.closest(&body, point) else { return };
    if let Some(gap) = surface.gap(&body, &facing, (point, OFFSET)) {
        finite(&gap);
    }
}

fn finite(gap: &AnyGap) {
    let [x, y, _] = gap.normal();
    let numbers = [gap.overclosure(), gap.along()[0], x, y, gap.position()[0], gap.position()[1]];
    assert!(numbers.iter().all(|number| !number.is_nan()), "{numbers:?}");
}
