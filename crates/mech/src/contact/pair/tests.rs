use super::*;
use crate::contact::friction::{Decay, Stick};
use crate::contact::gap::circle::{Circle, Side};

const C0: f64 = 1e-5;

fn interaction(normal: NormalLaw, stick: Stick, enforcement: Enforcement) -> Interaction {
    let friction = FrictionLaw::Coulomb { coefficient: 0.3, limit: None, decay: None, stick };
    Interaction { normal, friction, onset: Onset::Immediate, enforcement }
}

fn soft() -> NormalLaw {
    NormalLaw::Exponential { clearance: C0, pressure: 4.8e6 }
}

const MIXED: Enforcement = Enforcement::Mixed { normal: 5e11, tangential: 2e11 };
const ELASTIC: Stick = Stick::Elastic { slip: 4e-6 };

fn interactions() -> Vec<Interaction> {
    let mut all = vec![
        interaction(soft(), ELASTIC, Enforcement::Inserted),
        interaction(soft(), ELASTIC, MIXED),
        interaction(soft(), Stick::Lagrange, MIXED),
        interaction(NormalLaw::Hard, Stick::Lagrange, MIXED),
    ];
    let mut fading = all[2].clone();
    fading.friction = FrictionLaw::Coulomb {
        coefficient: 0.3,
        limit: None,
        decay: Some(Decay { kinetic: 0.1, rate: 2e3 }),
        stick: Stick::Lagrange,
    };
    all.push(fading);
    all
}

fn gap(q: &[f64; 5]) -> Gap<5> {
    let circle = Circle { radius: 9e-3, side: Side::Convex };
    circle.gap([q[0], q[1]], [q[2], q[3]], q[4], 0.0).unwrap()
}

fn trial(along: f64, multipliers: Multipliers) -> PointTrial {
    let committed = PointState { closed: true, along: Some(along), elastic_slip: 1e-6 };
    PointTrial { committed, multipliers, period: None, dt: 0.05 }
}

/// Requirement: the whole stencil (force, columns, rows, block) is consistent: differences of force
/// and constraints by every variable and multiplier. Tolerance: 1e-6 of the largest entry of the same
/// derivative, the noise of central differences on lengths of 1e-5.
#[test]
fn stencil_by_differences() {
    let q = [9e-3 * 0.8 - 1e-6, 9e-3 * 0.6 - 1e-6, 1e-6, 2e-6, 0.01];
    let origin = gap(&q).along;
    for law in interactions() {
        for slip in [1e-6, -3e-5] {
            for (lp, lt) in [(6e6, 0.0), (1e6, 1e4), (8e6, -9e5)] {
                let at = |q: &[f64; 5], lp: f64, lt: f64| {
                    let gap = gap(q);
                    let trial = trial(origin - slip, Multipliers { pressure: lp, traction: lt });
                    let response = respond(&law, gap.overclosure, gap.along, &trial, None);
                    assemble(2e-5, &gap, &response)
                };
                let stencil = at(&q, lp, lt);
                check_variables(&stencil, &q, |q| at(q, lp, lt));
                check_multipliers(&stencil, |dp, dt| at(&q, lp + dp, lt + dt));
            }
        }
    }
}

fn biggest(values: &[f64]) -> f64 {
    values.iter().fold(1e-300_f64, |a, b| a.max(b.abs()))
}

fn check_variables(stencil: &Stencil<5>, q: &[f64; 5], at: impl Fn(&[f64; 5]) -> Stencil<5>) {
    let most = biggest(stencil.tangent[..4].as_flattened());
    for j in 0..5 {
        let step = if j == 4 { 1e-8 } else { 1e-10 };
        let unit = if j == 4 { 1e-2 } else { 1.0 };
        let (mut up, mut down) = (*q, *q);
        up[j] += step;
        down[j] -= step;
        let (up, down) = (at(&up), at(&down));
        for i in 0..5 {
            let difference = (up.force[i] - down.force[i]) / (2.0 * step);
            let lever = if i == 4 { 1e-2 } else { 1.0 };
            let exact = stencil.tangent[i][j];
            assert!(
                (difference - exact).abs() < 1e-6 * most * unit * lever,
                "{i} {j}: {difference} {exact}"
            );
        }
        for c in 0..2 {
            let difference = (up.constraint[c] - down.constraint[c]) / (2.0 * step);
            let exact = stencil.rows[c][j];
            let size = biggest(&stencil.rows[c]).max(2e-5);
            assert!((difference - exact).abs() < 1e-6 * size, "row {c} {j}: {difference} {exact}");
        }
    }
}

fn check_multipliers(stencil: &Stencil<5>, at: impl Fn(f64, f64) -> Stencil<5>) {
    for (which, (dp, dt)) in [(1.0, 0.0), (0.0, 1.0)].into_iter().enumerate() {
        let (up, down) = (at(dp, dt), at(-dp, -dt));
        for i in 0..5 {
            let difference = (up.force[i] - down.force[i]) / 2.0;
            assert!((difference - stencil.columns[which][i]).abs() < 1e-6 * 2e-5);
        }
        for c in 0..2 {
            let difference = (up.constraint[c] - down.constraint[c]) / 2.0;
            let exact = stencil.block[c][which];
            assert!((difference - exact).abs() < 1e-6 * 2e-5 / 2e11, "{c} {which}");
        }
    }
}

/// Requirement: without friction the stencil is symmetric, with it it is not.
#[test]
fn symmetry() {
    let q = [9e-3 * 0.8, 9e-3 * 0.6, 0.0, 0.0, 0.01];
    let gap = gap(&q);
    let mut law = interactions().swap_remove(1);
    #[allow(clippy::needless_range_loop)] // entry (i, j) against entry (j, i)
    let unsymmetric = |law: &Interaction| {
        let trial = trial(gap.along - 1e-4, Multipliers { pressure: 5e6, traction: 0.0 });
        let response = respond(law, gap.overclosure, gap.along, &trial, None);
        let stencil = assemble(1.0, &gap, &response);
        let t = &stencil.tangent;
        let mut worst = 0.0_f64;
        for i in 0..5 {
            worst = worst.max((stencil.rows[0][i] - stencil.columns[0][i]).abs() * 5e11);
            for j in 0..5 {
                worst = worst.max((t[i][j] - t[j][i]).abs());
            }
        }
        worst / biggest(t.as_flattened())
    };
    assert!(unsymmetric(&law) > 0.1);
    law.friction = FrictionLaw::None;
    assert!(unsymmetric(&law) < 1e-12);
}

/// Requirement: eliminating the pressure at the solution leaves the tangent of the inserted law, and
/// the recovered multiplier solves the constraint. Tolerance: round-off.
#[test]
fn condensed_is_inserted_at_the_solution() {
    let q = [9e-3 * 0.8, 9e-3 * 0.6, 1e-6, 0.0, 0.01];
    let gap = gap(&q);
    let p = soft().pressure(gap.overclosure).unwrap().0;
    let run = |law: &Interaction, pressure: f64| {
        let trial = trial(gap.along - 1e-4, Multipliers { pressure, traction: 0.0 });
        assemble(2e-5, &gap, &respond(law, gap.overclosure, gap.along, &trial, None))
    };
    let inserted = run(&interactions()[0], 0.0);
    let (condensed, recovery) = run(&interactions()[1], p).condense(0).unwrap();
    assert!(recovery.change.abs() < 1e-9 * p);
    let most = biggest(inserted.tangent.as_flattened());
    for i in 0..5 {
        assert!((condensed.force[i] - inserted.force[i]).abs() < 1e-12 * p * 2e-5);
        for j in 0..5 {
            assert!((condensed.tangent[i][j] - inserted.tangent[i][j]).abs() < 1e-12 * most);
        }
    }
    // Newton on the multiplier alone, from zero, at fixed q.
    let mut pressure = 0.0;
    for _ in 0..20 {
        pressure += run(&interactions()[1], pressure).condense(0).unwrap().1.change;
    }
    assert!((pressure - p).abs() < 1e-9 * p, "{pressure} {p}");
}

/// Requirement: eliminating both multipliers one after the other equals solving the coupled linear
/// system by them at once. Tolerance: round-off.
#[test]
fn both_multipliers_eliminated() {
    let q = [9e-3 * 0.8, 9e-3 * 0.6, 1e-6, 0.0, 0.01];
    let gap = gap(&q);
    let law = &interactions()[2];
    let trial = trial(gap.along - 1e-4, Multipliers { pressure: 3e6, traction: 9e6 });
    let stencil = assemble(2e-5, &gap, &respond(law, gap.overclosure, gap.along, &trial, None));
    let (once, first) = stencil.condense(0).unwrap();
    let (twice, second) = once.condense(1).unwrap();
    assert_eq!(twice.in_use, [false, false]);
    let l1 = second.change;
    let l0 = first.change + first.by_other * l1;
    for c in 0..2 {
        let rest = stencil.constraint[c] + stencil.block[c][0] * l0 + stencil.block[c][1] * l1;
        assert!(rest.abs() < 1e-12 * biggest(&stencil.constraint), "{c}");
    }
    for i in 0..5 {
        let force = stencil.force[i] + stencil.columns[0][i] * l0 + stencil.columns[1][i] * l1;
        assert!((force - twice.force[i]).abs() < 1e-12 * biggest(&stencil.force));
    }
    assert!(twice.condense(0).is_none());
}

/// Requirement: friction does work against the slip in every increment, and none where it is not
/// called. Source: semantics, sections 3 and 4.
#[test]
fn friction_dissipates() {
    for law in interactions() {
        for slip in [-1e-4, 1e-4_f64] {
            let pressure = Multipliers { pressure: 5e6, traction: slip.signum() * 5e6 };
            let response = respond(&law, 0.0, 0.2 + slip, &trial(0.2, pressure), None);
            assert!(response.traction.value * slip > 0.0);
            assert!(response.dissipation > 0.0);
            assert_eq!(response.status, Some(Status::Slip));
        }
        let mut late = law.clone();
        late.onset = Onset::Matfru;
        let mut point = trial(0.2, Multipliers { pressure: 5e6, traction: 0.0 });
        point.committed.closed = false;
        let response = respond(&late, 0.0, 0.3, &point, None);
        assert!(response.traction.value == 0.0 && response.status.is_none());
        assert!(response.state.closed && response.state.elastic_slip == 0.0);
    }
}

/// Requirement: slip on a closed surface goes the short way round.
#[test]
fn slip_wraps_at_the_period() {
    let mut point = trial(0.1, Multipliers::default());
    point.period = Some(10.0);
    assert!((point.slip(9.9) + 0.2).abs() < 1e-14);
    point.committed.along = None;
    assert_eq!(point.slip(3.0), 0.0);
}
