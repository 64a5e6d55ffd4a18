//! Contact in space on a floor: the condensed problem with two tangential directions, held against
//! its laws and against equilibrium, both written out here once more.
//!
//! ```text
//!        z |   o   o  o      nodes, joined by a random stiffness
//!          |  o   o  o
//!          +--------------   floor z = 0; loads press and drag in all directions
//! ```

use super::*;
use slideline_linalg::{BuiltIn, Kind as MatrixKind, Pattern, Solver};
use slideline_mech::contact::enforcement::Enforcement;
use slideline_mech::contact::friction::{Ellipse, FrictionLaw, Stick};
use slideline_mech::contact::normal::NormalLaw;
use slideline_mech::contact::onset::Onset;
use slideline_mech::contact::pair::Laws;
use slideline_mech::contact::tangential::Tangential;

/// Numbers between -1 and 1 that look random.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Nodes above a floor, on a structure that holds them.
struct Floor {
    nodes: usize,
    /// Stiffness, row-major [F/L].
    stiffness: Vec<f64>,
    load: Vec<f64>,
    gaps: Vec<f64>,
    areas: Vec<f64>,
    slips: Vec<Tangential>,
    laws: Laws,
    /// Whether the least energy is sought as well, once the contact is found.
    minimised: bool,
}

impl Floor {
    /// K = 1 + B'B/n with random B: as stiff in all directions, and everything coupled.
    fn new(nodes: usize, (normal, friction): (NormalLaw, FrictionLaw)) -> Self {
        let (n, mut random) = (3 * nodes, Random(nodes as u64 + 11));
        let b: Vec<f64> = (0..n * n).map(|_| random.next()).collect();
        let mut stiffness = vec![0.0; n * n];
        for i in 0..n {
            for j in 0..n {
                let product: f64 = (0..n).map(|k| b[k * n + i] * b[k * n + j]).sum();
                stiffness[i * n + j] = product / n as f64 + if i == j { 1.0 } else { 0.0 };
            }
        }
        let mut load: Vec<f64> = (0..n).map(|_| 0.4 * random.next()).collect();
        load.iter_mut().skip(2).step_by(3).for_each(|down| *down -= 0.6);
        let gaps = (0..nodes).map(|_| 0.2 + 0.4 * random.next()).collect();
        let areas = (0..nodes).map(|_| 1.5 + random.next()).collect();
        let slips = (0..nodes).map(|_| Tangential([0.05 * random.next(), 0.05 * random.next()]));
        let (slips, user) = (slips.collect(), None);
        let laws = Laws { normal, friction, onset: Onset::Immediate, user };
        Self { nodes, stiffness, load, gaps, areas, slips, laws, minimised: false }
    }

    /// The points, the tangents of point k turned by `turn` k.
    fn points(&self, turn: f64) -> LinearPoints {
        let mut points = LinearPoints::default();
        points.clear(2);
        for k in 0..self.nodes {
            let sliding = Sliding {
                slip: turned(self.slips[k], -turn * k as f64),
                elastic_slip: Tangential::ZERO,
                traction: Tangential::ZERO,
                stiffness: 0.0,
                state_variables: (0, 0),
            };
            let point = LinearPoint {
                place: k,
                pair: 0,
                law: 0,
                area: self.areas[k],
                integrated: false,
                overclosure: -self.gaps[k],
                pressure: 0.0,
                stiffness: 0.0,
                least: 1e-3,
                sliding: Some(sliding),
            };
            let (sin, cos) = (turn * k as f64).sin_cos();
            let tangents = [cos, sin, 0.0, -sin, cos, 0.0];
            let rows = [&[0.0, 0.0, -1.0][..], &tangents, &tangents].concat();
            points.push_rows(point, &[3 * k, 3 * k + 1, 3 * k + 2], &rows);
        }
        points
    }

    /// The same where hardly anything but contact holds the nodes as a whole.
    fn loose(mut self, held: f64) -> Self {
        self.minimised = true;
        let n = 3 * self.nodes;
        let mean = |i: usize, j: usize| if i % 3 == j % 3 { 3.0 / n as f64 } else { 0.0 };
        let kept = |i: usize, j: usize| f64::from(u8::from(i == j)) - mean(i, j);
        let times = |a: &dyn Fn(usize, usize) -> f64, b: &dyn Fn(usize, usize) -> f64| {
            let of = |k: usize| (0..n).map(|l| a(k / n, l) * b(l, k % n)).sum();
            (0..n * n).map(of).collect::<Vec<f64>>()
        };
        let half = times(&kept, &|i, j| self.stiffness[i * n + j]);
        self.stiffness = times(&|i, j| half[i * n + j], &kept);
        (0..n).for_each(|i| self.stiffness[i * n + i] += held);
        self
    }

    /// Displacements, pressures and tractions (by the first tangents, turned by nothing).
    fn solve(&self, way: Enforcement, turn: f64) -> (Vec<f64>, Vec<f64>, Vec<Tangential>) {
        let mut contact = LinearisedContact::default();
        let found = self.solve_with(&mut contact, way, turn);
        assert!(contact.is_solved(), "{way:?}");
        found
    }

    fn solve_with(
        &self,
        contact: &mut LinearisedContact,
        way: Enforcement,
        turn: f64,
    ) -> (Vec<f64>, Vec<f64>, Vec<Tangential>) {
        let n = 3 * self.nodes;
        let all = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        let pattern = Pattern::from_pairs(n, all);
        let mut values = vec![0.0; pattern.entries()];
        for i in 0..n {
            for j in 0..n {
                values[pattern.position(i, j).unwrap()] = self.stiffness[i * n + j];
            }
        }
        let mut points = self.points(turn);
        let mut augmented = values.clone();
        let mut solver =
            Solver::analyse(&pattern, MatrixKind::Unsymmetric, &BuiltIn { back_end: None });
        let mut stiffness = Stiffness {
            pattern: &pattern,
            values: &values,
            augmented: &mut augmented,
            solver: &mut solver,
            symmetrised: false,
        };
        stiffness.factor(&points).unwrap();
        let context = LawContext {
            laws: std::slice::from_ref(&self.laws),
            time: 1.0,
            dt: 1.0,
            committed: &[],
            symmetrised: false,
            rounding: 1e-14,
            units: &vec![1.0; n],
        };
        let mut du = self.load.clone();
        contact.solve(&mut points, &context, (way, &mut stiffness), &mut du).unwrap();
        if self.minimised {
            contact.minimise(&points, &context);
        }
        let pressures = points.iter().map(|point| point.pressure).collect();
        let back = |(k, point): (usize, &LinearPoint)| turned(point.traction(), turn * k as f64);
        let tractions = points.iter().enumerate().map(back).collect();
        (du, pressures, tractions)
    }
}

fn turned(vector: Tangential, angle: f64) -> Tangential {
    let ([x, y], (sin, cos)) = (vector.0, angle.sin_cos());
    Tangential([cos * x - sin * y, sin * x + cos * y])
}

fn coulomb(stick: Stick) -> FrictionLaw {
    FrictionLaw::Coulomb {
        coefficient: 0.4,
        ellipse: Ellipse::CIRCLE,
        limit: None,
        decay: None,
        stick,
    }
}

/// Requirement: both ways find displacements in equilibrium with pressures and tractions, which obey
/// their laws in space: no overclosure without pressure, stick inside the circle of Coulomb's limit,
/// slip along the traction on it. Enough points stick and slide, open and close, for this to bite.
/// Tolerance: 1e-9 of the loads.
#[test]
fn the_laws_hold_in_two_directions() {
    let elastic = coulomb(Stick::Elastic { slip: 0.02 });
    for (friction, nodes) in [coulomb(Stick::Lagrange), elastic].iter().zip([24, 60]) {
        for way in [Enforcement::Dense, Enforcement::MatrixFree] {
            let floor = Floor::new(nodes, (NormalLaw::Hard, friction.clone()));
            let (du, pressures, tractions) = floor.solve(way, 0.0);
            let counts = check(&floor, &du, &pressures, &tractions);
            assert!(counts.iter().all(|&count| count >= 3), "open, stick, slip: {counts:?}");
        }
    }
}

/// How many points are open, stick and slip, their laws checked.
fn check(floor: &Floor, du: &[f64], pressures: &[f64], tractions: &[Tangential]) -> [usize; 3] {
    let (n, mut counts) = (du.len(), [0; 3]);
    for k in 0..floor.nodes {
        let (p, tau, area) = (pressures[k], tractions[k], floor.areas[k]);
        let pushes = [-area * tau[0], -area * tau[1], area * p];
        for (axis, push) in pushes.into_iter().enumerate() {
            let i = 3 * k + axis;
            let inner: f64 = (0..n).map(|j| floor.stiffness[i * n + j] * du[j]).sum();
            assert!((inner - floor.load[i] - push).abs() < 1e-9, "equation {i}");
        }
        let gap = floor.gaps[k] + du[3 * k + 2];
        let slip = floor.slips[k] + Tangential([du[3 * k], du[3 * k + 1]]);
        assert!(p >= 0.0 && gap > -1e-9 && p * gap < 1e-9, "{k}: {p} {gap}");
        let limit = 0.4 * p;
        match &floor.laws.friction {
            FrictionLaw::Coulomb { stick: Stick::Lagrange, .. } => {
                assert!(tau.size() <= limit * (1.0 + 1e-9) + 1e-12);
                let sticks = tau.size() < limit * (1.0 - 1e-7);
                assert!(!sticks || slip.size() < 1e-9, "{k} sticks, and slips by {slip:?}");
            }
            law => {
                let expected = law.update(p, slip, Tangential::ZERO, 1.0).tau;
                assert!((tau - expected).size() < 1e-9, "{k}: {tau:?} {expected:?}");
            }
        }
        let slides = p > 0.0 && tau.size() >= limit * (1.0 - 1e-7);
        if slides {
            let along = limit * slip.direction();
            assert!((tau - along).size() < 1e-7 * limit, "{k}: {tau:?} against {slip:?}");
        }
        counts[if p == 0.0 { 0 } else { 1 + usize::from(slides) }] += 1;
    }
    counts
}

/// Requirement: the tangents of a point are a choice: turned, differently at every point, they change
/// nothing; and both ways find the same. Tolerance: 1e-9.
#[test]
fn tangents_may_be_turned() {
    let floor = Floor::new(24, (NormalLaw::Hard, coulomb(Stick::Lagrange)));
    let (one, _, tractions) = floor.solve(Enforcement::Dense, 0.0);
    for (way, turn) in
        [(Enforcement::Dense, 0.7), (Enforcement::MatrixFree, 0.0), (Enforcement::MatrixFree, 0.7)]
    {
        let (other, _, own) = floor.solve(way, turn);
        let off = one.iter().zip(&other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-9, "{way:?} {turn}: {off}");
        assert!(tractions.iter().zip(&own).all(|(a, b)| (*a - *b).size() < 1e-8));
    }
}

/// Requirement: softened contact in space, too. Tolerance as above, of the law of the pressure.
#[test]
fn softened_pressures_in_space() {
    let normal = NormalLaw::Exponential { clearance: 0.05, pressure: 0.5 };
    for way in [Enforcement::Dense, Enforcement::MatrixFree] {
        let floor = Floor::new(24, (normal.clone(), coulomb(Stick::Elastic { slip: 0.02 })));
        let (du, pressures, tractions) = floor.solve(way, 0.3);
        for k in 0..floor.nodes {
            let overclosure = -(floor.gaps[k] + du[3 * k + 2]);
            let (p, _) = floor.laws.normal.pressure(overclosure).unwrap();
            assert!((p - pressures[k]).abs() < 1e-9 * (1.0 + p), "{way:?} {k}: {p}");
            let slip = floor.slips[k] + Tangential([du[3 * k], du[3 * k + 1]]);
            let tau = floor.laws.friction.update(p, slip, Tangential::ZERO, 1.0).tau;
            assert!((tau - tractions[k]).size() < 1e-9, "{way:?} {k}");
        }
    }
}

/// Requirement: the way to the least energy ends where rounding is all that is left of the residual,
/// here of nodes that as a whole hardly anything but contact holds; it does not take all steps of
/// all rounds, each with a factorisation.
#[test]
fn the_descent_ends_at_rounding() {
    let elastic = coulomb(Stick::Elastic { slip: 0.02 });
    for (nodes, held) in [(40, 1e-5), (70, 1e-5), (40, 1e-6), (70, 1e-6)] {
        let floor = Floor::new(nodes, (NormalLaw::Hard, elastic.clone())).loose(held);
        let mut contact = LinearisedContact::default();
        let _ = floor.solve_with(&mut contact, Enforcement::Dense, 0.0);
        let steps = contact.descent.steps;
        assert!(steps < 60, "{nodes} nodes, held by {held:e}: {steps} steps");
    }
}
