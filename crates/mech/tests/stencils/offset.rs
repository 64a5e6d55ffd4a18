//! Surfaces that stand off their lines: derivatives of slip and drag, action and reaction.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // test code throughout

use proptest::prelude::*;
use slideline_mech::contact::gap::Quadratic;
use slideline_mech::contact::gap::offset::Offset;
use slideline_mech::contact::pair::{AnyGap, Body, RigidSurface, chain_gap};
use slideline_mech::contact::search::chain::Chain;
use slideline_mech::contact::search::nearest::Nearby;
use slideline_mech::contact::search::rigid::RigidSegment;
use slideline_mech::rigid::{Attachment, PointMap, push_forward, push_gradients};

const OFFSET: Offset = Offset { slave: 0.15, master: 0.05 };
/// Dofs of the slave in front of those of its master: (x, y, rotation of its section).
const SLAVE: Attachment = Attachment::Point { map: PointMap::Free, first: 0 };

/// What a point of a beam sees: overclosure, slip coordinate, rows of both and of the drag, and the
/// derivative of the drag, all by dofs.
struct Seen {
    over: f64,
    slip: f64,
    rows: [Vec<f64>; 3],
    drag_by: Vec<f64>,
}

fn seen(gap: &AnyGap<Quadratic>, attachments: &[Attachment], dofs: &[f64]) -> Seen {
    let (from, n, m) = (gap.derivatives(), gap.width(), dofs.len());
    let gradients = [from.gradient, from.slip_gradient, from.direction];
    let mut rows = vec![0.0; 3 * m];
    push_gradients(attachments, dofs, (&gradients, n), (&mut rows, m));
    let mut drag_by = vec![0.0; m * m];
    let [_, second] = gap.second_derivatives();
    push_forward(attachments, dofs, from.direction, second, &mut vec![0.0; m], &mut drag_by);
    let mut rows: [Vec<f64>; 3] = [0, 1, 2].map(|k| rows[k * m..][..m].to_vec());
    rows[1][2] += OFFSET.slave;
    rows[2][2] += OFFSET.slave;
    let t = gap.tangent();
    let slip = gap.along()[0] + OFFSET.slave * (dofs[2] - t[1].atan2(t[0]));
    Seen { over: gap.overclosure(), slip, rows, drag_by }
}

const NODES: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.1, 0.0], [2.1, 0.5, 0.0], [2.9, 1.2, 0.0]];

/// Dofs: the slave's three, then two a node of the chain.
fn on_chain(dofs: &[f64; 11]) -> Option<Seen> {
    let chain = Chain::new(&NODES, Some(0.3), 0.0)?;
    let at = |k: usize| [NODES[k][0] + dofs[3 + 2 * k], NODES[k][1] + dofs[4 + 2 * k], 0.0];
    let positions = [0, 1, 2, 3].map(at);
    let point = [dofs[0], dofs[1], 0.0];
    let piece = chain.closest(&positions, Nearby::Positions, point)?;
    let gap = chain_gap::<Quadratic>(&chain, &piece, &positions, (point, OFFSET))?;
    let free = |k: usize| Attachment::Point { map: PointMap::Free, first: 3 + 2 * k };
    let nodes: Vec<Attachment> = piece.nodes().map(free).collect();
    let all: Vec<Attachment> = std::iter::once(SLAVE).chain(nodes).collect();
    Some(seen(&gap, &all, dofs))
}

fn profile() -> RigidSurface {
    RigidSurface::new(vec![
        RigidSegment::Line { a: [-2.0, 0.3], b: [0.0, 0.0] },
        RigidSegment::Line { a: [0.0, 0.0], b: [1.0, 0.0] },
        RigidSegment::arc([1.0, 0.0], [2.0, -1.0], [1.0, -1.0]).unwrap(),
        RigidSegment::Parabola { start: [2.0, -1.0], mid: [2.3, -2.0], end: [2.1, -3.0] },
    ])
}

/// Dofs: the slave's three, then those of the body.
fn on_profile(dofs: &[f64; 6]) -> Option<Seen> {
    let surface = profile();
    let body = Body { reference: [0.5, -0.7, 0.0], dofs: [dofs[3], dofs[4], dofs[5]] };
    let point = [dofs[0], dofs[1], 0.0];
    let facing = surface.closest(&body, point)?;
    let gap = surface.gap::<Quadratic>(&body, &facing, (point, OFFSET))?;
    let attachments = surface.attachments(&body, &facing, SLAVE, 3)?;
    Some(seen(&gap, attachments.as_slice(), dofs))
}

/// Holds rows and the derivative of the drag against differences; gives back false where the point
/// stands so near a border of two parts that there are none.
fn compare<const N: usize>(dofs: &[f64; N], see: impl Fn(&[f64; N]) -> Option<Seen>) -> bool {
    let Some(own) = see(dofs) else { return false };
    let step = 1e-6;
    for j in 0..N {
        let moved = |by: f64| {
            let mut moved = *dofs;
            moved[j] += by;
            see(&moved)
        };
        let (Some(up), Some(down)) = (moved(step), moved(-step)) else { return false };
        let slope = |a: f64, b: f64| (a - b) / (2.0 * step);
        let apart = slope(up.over, down.over) - own.rows[0][j];
        assert!(apart.abs() < 1e-7, "h {j}: {apart}");
        let apart = slope(up.slip, down.slip) - own.rows[1][j];
        assert!(apart.abs() < 1e-6, "s {j}: {apart}");
        for i in 0..N {
            let apart = slope(up.rows[2][i], down.rows[2][i]) - own.drag_by[i * N + j];
            assert!(apart.abs() < 1e-5, "d {i} {j}: {apart}");
        }
    }
    true
}

/// The resultant of a row: forces and their moment about the origin, rotations included.
fn resultant(row: &[f64], positions: &[[f64; 2]], turns: &[usize]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    let translations = (0..row.len()).filter(|k| !turns.contains(k)).collect::<Vec<_>>();
    for (at, pair) in positions.iter().zip(translations.chunks_exact(2)) {
        let force = [row[pair[0]], row[pair[1]]];
        sum[0] += force[0];
        sum[1] += force[1];
        sum[2] += at[0] * force[1] - at[1] * force[0];
    }
    turns.iter().for_each(|&turn| sum[2] += row[turn]);
    sum
}

proptest! {
    /// Requirement: rows of overclosure, slip and drag are derivatives, also in corners and on curved
    /// profiles. Source: central differences, of the slip coordinate sigma + r (theta - beta), eq.
    /// (5.46). Tolerance: their truncation.
    #[test]
    fn derivatives_on_a_chain(
        x in 0.2..2.6_f64, y in 0.1..1.3_f64, turn in -2.0..2.0_f64,
        u in prop::array::uniform8(-0.05..0.05_f64),
    ) {
        let mut dofs = [0.0; 11];
        dofs[..3].copy_from_slice(&[x, y, turn]);
        dofs[3..].copy_from_slice(&u);
        let own = on_chain(&dofs).filter(|own| own.over.abs() < 0.5);
        if own.is_some() && away(&dofs, on_chain) {
            compare(&dofs, on_chain);
        }
    }

    /// Requirement and tolerance as above.
    #[test]
    fn derivatives_on_a_profile(
        x in -1.5..3.0_f64, y in -2.8..0.8_f64, turn in -2.0..2.0_f64,
        u in prop::array::uniform3(-0.3..0.3_f64),
    ) {
        let dofs = [x, y, turn, u[0], u[1], u[2]];
        let own = on_profile(&dofs).filter(|own| own.over.abs() < 0.5);
        if own.is_some() && away(&dofs, on_profile) {
            compare(&dofs, on_profile);
        }
    }

    /// Requirement: forces and moments of pressure and friction balance, that of the offset on the
    /// slave's section included, at any gap. Tolerance: rounding.
    #[test]
    fn action_is_reaction(x in 0.2..2.6_f64, y in 0.1..1.3_f64, turn in -2.0..2.0_f64) {
        let mut dofs = [0.0; 11];
        dofs[..3].copy_from_slice(&[x, y, turn]);
        if let Some(own) = on_chain(&dofs) {
            let mut positions = vec![[x, y]];
            positions.extend(NODES.map(|[x, y, _]| [x, y]));
            for row in &own.rows {
                let sum = resultant(row, &positions, &[2]);
                prop_assert!(sum.iter().all(|part| part.abs() < 1e-11), "{sum:?}");
            }
        }
        let dofs = [x, y, turn, 0.0, 0.0, 0.0];
        if let Some(own) = on_profile(&dofs) {
            for row in &own.rows {
                let sum = resultant(row, &[[x, y], [0.5, -0.7]], &[2, 5]);
                prop_assert!(sum.iter().all(|part| part.abs() < 1e-11), "{sum:?}");
            }
        }
    }
}

/// Whether the parts that face a point do not change about it: slips do not jump.
fn away<const N: usize>(dofs: &[f64; N], see: impl Fn(&[f64; N]) -> Option<Seen>) -> bool {
    let Some(own) = see(dofs) else { return false };
    (0..2).all(|axis| {
        [-1e-4, 1e-4].into_iter().all(|by| {
            let mut moved = *dofs;
            moved[axis] += by;
            see(&moved).is_some_and(|other| {
                let apart = |row: usize| {
                    let rows = other.rows[row].iter().zip(&own.rows[row]);
                    rows.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
                };
                apart(0) < 5e-3 && apart(1) < 5e-3
            })
        })
    })
}

/// Requirement: a disc that rolls on a line or about a circle does not slip; one that slides without
/// turning slips by its way along the surface. Source: kinematics of rigid bodies. Tolerance: rounding.
#[test]
fn a_rolling_disc_does_not_slip() {
    let r = OFFSET.slave;
    let surface = profile();
    let body = Body { reference: [0.0; 3], dofs: [0.0; 3] };
    let slip = |point: [f64; 2], turn: f64| {
        let point = [point[0], point[1], 0.0];
        let facing = surface.closest(&body, point).unwrap();
        let gap = surface.gap::<Quadratic>(&body, &facing, (point, OFFSET)).unwrap();
        gap.along()[0] + OFFSET.rolled(turn, gap.tangent())
    };
    // on the line along +x a disc above it turns clockwise
    let rolled = slip([0.7, r], -0.4 / r) - slip([0.3, r], 0.0);
    assert!(rolled.abs() < 1e-14, "{rolled}");
    assert!((slip([0.7, r], 0.0) - slip([0.3, r], 0.0) - 0.4).abs() < 1e-14);
    // about the quarter of a circle of radius 1 its centre goes (1 + r) psi
    let about = |psi: f64| [1.0 + (1.0 + r) * psi.sin(), -1.0 + (1.0 + r) * psi.cos()];
    let turn = -0.8 * (1.0 + r) / r;
    assert!((slip(about(1.0), turn) - slip(about(0.2), 0.0)).abs() < 1e-13);
    let slid = slip(about(1.0), 0.0) - slip(about(0.2), 0.0);
    assert!((slid - 0.8 * (1.0 + r)).abs() < 1e-13, "{slid}");
}
