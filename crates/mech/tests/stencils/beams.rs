//! B22 and B23: derivatives, objectivity, patch tests, closed forms, orders of convergence.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // test code throughout

use proptest::prelude::*;
use slideline_mech::differentiate::Second;
use slideline_mech::element::b22::axis_runs_forward;
use slideline_mech::element::{Beam21, Beam22, Beam23};
use slideline_mech::section::BeamStiffness;
use std::f64::consts::{PI, TAU};

/// Any of the three, as a function of the dofs of its nodes.
trait Element<const N: usize, const NN: usize> {
    fn evaluate(&self, q: &[f64; N], force: &mut [f64; N], tangent: &mut [f64; NN]) -> f64;
    fn linear(&self, q: &[f64; N], force: &mut [f64; N], tangent: &mut [f64; NN]) -> f64;
    fn derived(&self, q: &[f64; N]) -> Second<N>;
    fn nodes(&self) -> Vec<[f64; 2]>;
}

macro_rules! element {
    ($name:ident, $n:literal, $nn:literal, $reference:expr) => {
        impl Element<$n, $nn> for $name {
            fn evaluate(&self, q: &[f64; $n], f: &mut [f64; $n], k: &mut [f64; $nn]) -> f64 {
                self.force_and_tangent(q, f, k)
            }
            fn linear(&self, q: &[f64; $n], f: &mut [f64; $n], k: &mut [f64; $nn]) -> f64 {
                self.linear_force_and_tangent(q, f, k)
            }
            fn derived(&self, q: &[f64; $n]) -> Second<$n> {
                self.energy(&Second::variables(q))
            }
            fn nodes(&self) -> Vec<[f64; 2]> {
                $reference(self)
            }
        }
    };
}
element!(Beam21, 6, 36, |b: &Beam21| b.reference.to_vec());
element!(Beam22, 9, 81, |b: &Beam22| b.reference.to_vec());
element!(Beam23, 6, 36, |b: &Beam23| b.reference().to_vec());

const SEED: BeamStiffness =
    BeamStiffness { axial: 258_750.0, shear: 84_591.0, bending: 0.0485, centroid: 0.0 };

/// Curved, with its middle node off the middle of the chord.
fn b22() -> Beam22 {
    Beam22::new([[0.01, 0.02], [0.0107, 0.0211], [0.011, 0.022]], SEED)
}

fn b23() -> Beam23 {
    Beam23::new([[0.01, 0.02], [0.011, 0.022]], SEED)
}

/// Force and tangent are the derivatives of the energy, to round-off.
fn closed_form<const N: usize, const NN: usize>(element: &impl Element<N, NN>, q: &[f64; N]) {
    let (mut force, mut tangent) = ([0.0; N], [0.0; NN]);
    let energy = element.evaluate(q, &mut force, &mut tangent);
    let exact = element.derived(q);
    assert!((energy - exact.value).abs() <= 1e-12 * exact.value.abs());
    let size = largest(&exact.gradient);
    let most = largest(exact.hessian.as_flattened());
    for i in 0..N {
        assert!((force[i] - exact.gradient[i]).abs() <= 1e-11 * size, "{i}");
        for j in 0..N {
            assert!((tangent[N * i + j] - exact.hessian[i][j]).abs() <= 1e-11 * most, "{i} {j}");
            assert!((tangent[N * i + j] - tangent[N * j + i]).abs() <= 1e-14 * most, "{i} {j}");
        }
    }
}

/// Force by central differences of the energy, tangent by those of the force; step 1e-6.
fn differences<const N: usize, const NN: usize>(element: &impl Element<N, NN>, q: &[f64; N]) {
    let run = |q: &[f64; N]| {
        let (mut force, mut tangent) = ([0.0; N], [0.0; NN]);
        let energy = element.evaluate(q, &mut force, &mut tangent);
        (energy, force, tangent)
    };
    let (energy, force, tangent) = run(q);
    for j in 0..N {
        let length = if j % 3 == 2 { 1.0 } else { 1e-3 };
        let step = 1e-6 * length;
        let (mut up, mut down) = (*q, *q);
        up[j] += step;
        down[j] -= step;
        let (up, down) = (run(&up), run(&down));
        let difference = (up.0 - down.0) / (2.0 * step);
        assert!((difference - force[j]).abs() < 1e-8 * (energy / length + force[j].abs()), "{j}");
        let column = (0..N).fold(0.0_f64, |a, i| a.max(tangent[N * i + j].abs()));
        for i in 0..N {
            let difference = (up.1[i] - down.1[i]) / (2.0 * step);
            assert!((difference - tangent[N * i + j]).abs() <= 1e-7 * column, "{i} {j}");
        }
    }
}

/// The dofs after a rigid motion of the deformed element.
fn moved<const N: usize>(nodes: &[[f64; 2]], q: &[f64; N], turn: f64, shift: [f64; 2]) -> [f64; N] {
    let (s, c) = turn.sin_cos();
    let mut moved = *q;
    for (node, x) in nodes.iter().enumerate() {
        let p = [x[0] + q[3 * node], x[1] + q[3 * node + 1]];
        moved[3 * node] = c * p[0] - s * p[1] + shift[0] - x[0];
        moved[3 * node + 1] = s * p[0] + c * p[1] + shift[1] - x[1];
        moved[3 * node + 2] = q[3 * node + 2] + turn;
    }
    moved
}

/// A rigid motion turns the force and keeps energy; forces are in balance, moments too.
fn objective<const N: usize, const NN: usize>(
    element: &impl Element<N, NN>,
    q: &[f64; N],
    turn: f64,
) {
    let nodes = element.nodes();
    let (mut f, mut g, mut tangent) = ([0.0; N], [0.0; N], [0.0; NN]);
    let before = element.evaluate(q, &mut f, &mut tangent);
    let after = element.evaluate(&moved(&nodes, q, turn, [0.3, -0.2]), &mut g, &mut tangent);
    let (s, c) = turn.sin_cos();
    // Moving by a metre rounds positions to 1e-16 m: 1e-16 EA/l.
    let tolerance = 1e-11 * largest(&f) + 1e-14 * SEED.axial / 2e-3;
    assert!((before - after).abs() <= 1e-11 * before + 1e-18 * SEED.axial);
    let mut balance = [0.0; 3];
    for (node, x) in nodes.iter().enumerate() {
        let k = 3 * node;
        assert!((g[k] - (c * f[k] - s * f[k + 1])).abs() < tolerance);
        assert!((g[k + 1] - (s * f[k] + c * f[k + 1])).abs() < tolerance);
        assert!((g[k + 2] - f[k + 2]).abs() < tolerance);
        balance[0] += f[k];
        balance[1] += f[k + 1];
        balance[2] += f[k + 2] + (x[0] + q[k]) * f[k + 1] - (x[1] + q[k + 1]) * f[k];
    }
    assert!(largest(&balance) <= 1e-12 * largest(&f), "{balance:?}");
}

/// Without NLGEOM: the tangent at zero displacement, the force its product with q, the energy half
/// of the work.
fn linear<const N: usize, const NN: usize>(element: &impl Element<N, NN>, q: &[f64; N]) {
    let (mut force, mut tangent) = ([0.0; N], [0.0; NN]);
    let energy = element.linear(q, &mut force, &mut tangent);
    let (mut none, mut start) = ([0.0; N], [0.0; NN]);
    element.evaluate(&[0.0; N], &mut none, &mut start);
    let size = largest(&start);
    assert!(largest(&none) <= 1e-15 * size);
    let mut twice = 0.0;
    for i in 0..N {
        let product: f64 = (0..N).map(|j| tangent[N * i + j] * q[j]).sum();
        assert!((product - force[i]).abs() <= 1e-12 * size * 2e-3);
        assert!((0..N).all(|j| (tangent[N * i + j] - start[N * i + j]).abs() <= 1e-13 * size));
        twice += q[i] * force[i];
    }
    assert!((twice - 2.0 * energy).abs() <= 1e-10 * energy);
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |a: f64, b| a.max(b.abs()))
}

/// Displacements up to a millimetre (the elements are 2.2 mm long) and rotations.
fn motion<const N: usize>(turn: f64) -> impl Strategy<Value = [f64; N]> {
    prop::array::uniform::<_, N>(-1.0..1.0_f64)
        .prop_map(move |v| std::array::from_fn(|i| v[i] * if i % 3 == 2 { turn } else { 5e-4 }))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn b22_follows_from_its_energy(q in motion::<9>(3.0)) { closed_form(&b22(), &q); }
    #[test]
    fn b23_follows_from_its_energy(q in motion::<6>(1.0)) { closed_form(&b23(), &q); }
    #[test]
    fn b22_by_differences(q in motion::<9>(1.0)) { differences(&b22(), &q); }
    #[test]
    fn b23_by_differences(q in motion::<6>(0.7)) { differences(&b23(), &q); }
    #[test]
    fn b22_is_objective(q in motion::<9>(0.5), turn in -3.0..3.0_f64) { objective(&b22(), &q, turn); }
    #[test]
    fn b23_is_objective(q in motion::<6>(0.5), turn in -30.0..30.0_f64) { objective(&b23(), &q, turn); }
    #[test]
    fn b22_linear(q in motion::<9>(0.1)) { linear(&b22(), &q); }
    #[test]
    fn b23_linear(q in motion::<6>(0.1)) { linear(&b23(), &q); }

    /// The element read backwards is the same element.
    #[test]
    fn reversed_elements_are_the_same(q in motion::<9>(0.5)) {
        let element = b22();
        let [a, b, c] = element.reference;
        let back = [q[6], q[7], q[8], q[3], q[4], q[5], q[0], q[1], q[2]];
        let w = element.energy(&q);
        prop_assert!((Beam22::new([c, b, a], SEED).energy(&back) - w).abs() < 1e-12 * w);
        let (ends, back) = ([q[0], q[1], q[2], q[6], q[7], q[8]], [q[6], q[7], q[8], q[0], q[1], q[2]]);
        let w = Beam23::new([a, c], SEED).energy(&ends);
        prop_assert!((Beam23::new([c, a], SEED).energy(&back) - w).abs() < 1e-11 * w);
    }
}

/// Requirement: a curved element moved rigidly has no strain. Tolerance: rounding of the motion.
#[test]
fn rigid_motion_of_a_curved_element() {
    let element = b22();
    for turn in [0.0, 0.4, 3.0, -50.0] {
        let q = moved(&element.reference, &[0.0; 9], turn, [0.1, 0.2]);
        for strains in element.station_strains(&q) {
            let size = strains.axial.abs() + strains.shear.abs() + 1e-3 * strains.curvature.abs();
            assert!(size < 1e-12, "{turn}: {strains:?}");
        }
    }
    let bow = element.length() / 1e-3_f64.hypot(2e-3) - 1.0;
    assert!(bow > 0.005 && bow < 0.02 && axis_runs_forward(&element.reference));
    assert!(!axis_runs_forward(&[[0.0; 2], [0.2, 0.0], [1.0, 0.0]]));
}

/// Requirement: without length nothing is carried and nothing is undefined.
#[test]
fn elements_without_length() {
    let (q, mut force, mut tangent) = ([0.1; 9], [1.0; 9], [1.0; 81]);
    Beam22::new([[1.0; 2]; 3], SEED).force_and_tangent(&q, &mut force, &mut tangent);
    assert!(largest(&force) == 0.0 && largest(&tangent) == 0.0);
    let (q, mut force, mut tangent) = ([0.1; 6], [1.0; 6], [1.0; 36]);
    Beam23::new([[1.0; 2]; 2], SEED).force_and_tangent(&q, &mut force, &mut tangent);
    assert!(largest(&force) == 0.0 && largest(&tangent) == 0.0);
}

/// Patch tests: a state of constant strain, given at the nodes and turned rigidly, is found in
/// every element. B22 holds axial and shear strain together exactly; B23 axial strain and an arc of
/// a circle (four Gauss points: 1e-11 for an arc of 36 degrees).
#[test]
fn patch_of_constant_strain() {
    let (axial, shear, turn) = (1e-3, 2e-3, 2.0_f64);
    let reference = [[0.0, 0.0], [0.45, 0.0], [1.0, 0.0]];
    let at = |x: f64, y: f64| {
        let (s, c) = turn.sin_cos();
        [c * x - s * y, s * x + c * y]
    };
    let mut q = [0.0; 9];
    for (node, x) in reference.iter().enumerate() {
        let p = at(x[0] * (1.0 + axial), x[0] * shear);
        q[3 * node..][..3].copy_from_slice(&[p[0] - x[0], p[1], turn]);
    }
    for strains in Beam22::new(reference, SEED).station_strains(&q) {
        assert!((strains.axial - axial).abs() < 1e-14 && (strains.shear - shear).abs() < 1e-14);
        assert!(strains.curvature.abs() < 1e-14);
    }
    let (arc, stretch) = (PI / 5.0, 1.001);
    let (p, q0) =
        (at(stretch * arc.sin() / arc, stretch * (1.0 - arc.cos()) / arc), [0.0, 0.0, turn]);
    let q = [q0[0], q0[1], q0[2], p[0] - 1.0, p[1], turn + arc];
    let element = Beam23::new([[0.0, 0.0], [1.0, 0.0]], SEED);
    let (strains, forces) = (element.strains(&q), element.section_forces(&q));
    assert!((strains.axial - 1e-3).abs() < 2e-11, "{strains:?}");
    assert!((strains.curvature - arc).abs() < 1e-14 && forces.shear.abs() < 1e-12);
    assert!((forces.axial - SEED.axial * strains.axial).abs() < 1e-9);
}

/// A clamped chain of elements with loads at its tip.
struct Chain<E> {
    elements: Vec<E>,
}

impl<E> Chain<E> {
    /// Newton under a tip load, in steps; returns the displacements.
    fn solve<const N: usize, const NN: usize>(&self, load: [f64; 3], steps: usize) -> Vec<f64>
    where
        E: Element<N, NN>,
    {
        let stride = N - 3;
        let mut u = vec![0.0; stride * self.elements.len() + 3];
        for step in 1..=steps {
            #[allow(clippy::cast_precision_loss)] // a handful of steps
            let factor = step as f64 / steps as f64;
            self.iterate(&mut u, load.map(|value| value * factor), true);
        }
        u
    }

    fn linear<const N: usize, const NN: usize>(&self, load: [f64; 3]) -> Vec<f64>
    where
        E: Element<N, NN>,
    {
        let mut u = vec![0.0; (N - 3) * self.elements.len() + 3];
        self.iterate(&mut u, load, false);
        u
    }

    fn iterate<const N: usize, const NN: usize>(&self, u: &mut [f64], load: [f64; 3], exact: bool)
    where
        E: Element<N, NN>,
    {
        let (stride, size) = (N - 3, u.len());
        for iteration in 0..60 {
            let (mut residual, mut matrix) = (vec![0.0; size], vec![vec![0.0; size]; size]);
            for (e, element) in self.elements.iter().enumerate() {
                let (mut f, mut k) = ([0.0; N], [0.0; NN]);
                let q: [f64; N] = u[stride * e..][..N].try_into().unwrap();
                if exact {
                    element.evaluate(&q, &mut f, &mut k);
                } else {
                    element.linear(&q, &mut f, &mut k);
                }
                for i in 0..N {
                    residual[stride * e + i] -= f[i];
                    for j in 0..N {
                        matrix[stride * e + i][stride * e + j] += k[N * i + j];
                    }
                }
            }
            for (k, value) in load.iter().enumerate() {
                residual[size - 3 + k] += value;
            }
            let change = gauss(&matrix, &residual);
            for (u, change) in u[3..].iter_mut().zip(&change) {
                *u += change;
            }
            let small = largest(&change) < 1e-11 * (1.0 + largest(u));
            if small || !exact {
                return;
            }
            assert!(iteration < 59, "no convergence: {}", largest(&change));
        }
    }
}

/// Solves without the first three dofs; symmetric banded matrices need no pivots beyond the
/// diagonal here, partial pivoting all the same.
fn gauss(matrix: &[Vec<f64>], right: &[f64]) -> Vec<f64> {
    let n = right.len() - 3;
    let mut a: Vec<Vec<f64>> = (0..n)
        .map(|i| matrix[i + 3][3..].iter().copied().chain([right[i + 3]]).collect())
        .collect();
    for i in 0..n {
        let pivot = (i..n).max_by(|&p, &q| a[p][i].abs().total_cmp(&a[q][i].abs())).unwrap();
        a.swap(i, pivot);
        for r in i + 1..n {
            let factor = a[r][i] / a[i][i];
            if factor != 0.0 {
                let (top, bottom) = a.split_at_mut(r);
                for (x, y) in bottom[0][i..].iter_mut().zip(&top[i][i..]) {
                    *x -= factor * y;
                }
            }
        }
    }
    let mut x = vec![0.0; n];
    for i in (0..n).rev() {
        let sum: f64 = (i + 1..n).map(|j| a[i][j] * x[j]).sum();
        x[i] = (a[i][n] - sum) / a[i][i];
    }
    x
}

#[allow(clippy::cast_precision_loss)] // a handful of nodes
fn along(count: usize, node: usize) -> [f64; 2] {
    [node as f64 / count as f64, 0.0]
}

fn chain21(n: usize, stiffness: BeamStiffness) -> Chain<Beam21> {
    let element = |e| Beam21::new([along(n, e), along(n, e + 1)], stiffness);
    Chain { elements: (0..n).map(element).collect() }
}

fn chain22(n: usize, stiffness: BeamStiffness) -> Chain<Beam22> {
    let node = |i| along(2 * n, i);
    let element = |e| Beam22::new([node(2 * e), node(2 * e + 1), node(2 * e + 2)], stiffness);
    Chain { elements: (0..n).map(element).collect() }
}

fn chain23(n: usize, stiffness: BeamStiffness) -> Chain<Beam23> {
    let element = |e| Beam23::new([along(n, e), along(n, e + 1)], stiffness);
    Chain { elements: (0..n).map(element).collect() }
}

fn tip(u: &[f64]) -> [f64; 3] {
    u[u.len() - 3..].try_into().unwrap()
}

/// Requirement: linear cantilever under tip loads exact at any number of elements: B22
/// PL3/3EI + PL/K, B23 PL3/3EI. Source: verification 5 (Timoshenko). Tolerance 1e-9 as there.
#[test]
fn timoshenko_cantilever() {
    let stiffness = BeamStiffness { axial: 1e4, shear: 50.0, bending: 2.0, centroid: 0.0 };
    let [force, length] = [0.7, 1.0_f64];
    let bending = force * length.powi(3) / (3.0 * stiffness.bending);
    let turn = force * length * length / (2.0 * stiffness.bending);
    for n in [1, 2, 5] {
        let u = tip(&chain22(n, stiffness).linear([0.3, force, 0.0]));
        let expected = bending + force * length / stiffness.shear;
        assert!((u[1] / expected - 1.0).abs() < 1e-9 && (u[2] / turn - 1.0).abs() < 1e-9, "{n}");
        assert!((u[0] / (0.3 / stiffness.axial) - 1.0).abs() < 1e-9);
        let u = tip(&chain23(n, stiffness).linear([0.3, force, 0.0]));
        assert!((u[1] / bending - 1.0).abs() < 1e-9 && (u[2] / turn - 1.0).abs() < 1e-9, "{n}");
    }
    // The exact element at a small load is the linear one.
    let u = tip(&chain23(3, stiffness).solve([0.0, 1e-6 * force, 0.0], 1));
    assert!((u[1] / (1e-6 * bending) - 1.0).abs() < 1e-9);
}

/// Requirement: roll-up (Simo and Vu-Quoc): M = q EI/L gives the tip x = sin q/q, y = (1-cos q)/q
/// (verification 5). B23 lies on the circle (its four Gauss points: 1e-10 at ten elements), B22
/// has its rotations exact and its ends within (q/n)^4/4320 of the length; both close at q = 2 pi.
#[test]
fn roll_up() {
    let stiffness = BeamStiffness { axial: 1e4, shear: 4e3, bending: 1.0, centroid: 0.0 };
    for q in [PI / 4.0, PI / 2.0, PI, 1.5 * PI, TAU] {
        let expected = [q.sin() / q - 1.0, (1.0 - q.cos()) / q];
        let check = |u: [f64; 3], tolerance: f64| {
            let error = (u[0] - expected[0]).hypot(u[1] - expected[1]);
            assert!(error < tolerance, "{q}: {error}");
            assert!((u[2] - q).abs() < 1e-10);
        };
        check(tip(&chain23(10, stiffness).solve([0.0, 0.0, q], 10)), 1e-10);
        let tolerance = if q > 6.0 { 1e-10 } else { (q / 10.0_f64).powi(4) / 4320.0 + 1e-10 };
        check(tip(&chain22(10, stiffness).solve([0.0, 0.0, q], 10)), tolerance);
    }
}

/// Requirement: Bisshopp and Drucker's cantilever, P L2/EI = 2 (tip angle .7817498316, deflection
/// .4934574804, shortening .1606417208: verification 5), reached with order 2 (B21), at least 3.8
/// (B22, B23). Tolerance on the order: 0.2, the asymptotic range starts about 4 elements.
#[test]
fn order_of_convergence_against_the_elastica() {
    let stiffness = BeamStiffness { axial: 1e9, shear: 1e9, bending: 1.0, centroid: 0.0 };
    let load = [0.0, 2.0, 0.0];
    let error = |u: Vec<f64>| {
        let u = tip(&u);
        (u[0] + 0.160_641_720_8).abs().max((u[1] - 0.493_457_480_4).abs())
    };
    let order = |name: &str, errors: &[f64]| {
        for pair in errors.windows(2) {
            println!(
                "{name}: {:.3e} {:.3e} order {:.3}",
                pair[0],
                pair[1],
                (pair[0] / pair[1]).log2()
            );
        }
        (errors[errors.len() - 2] / errors[errors.len() - 1]).log2()
    };
    let counts = [2, 4, 8, 16];
    let b21 = counts.map(|n| error(chain21(n, stiffness).solve(load, 4)));
    let b22 = counts.map(|n| error(chain22(n, stiffness).solve(load, 4)));
    let b23 = counts.map(|n| error(chain23(n, stiffness).solve(load, 4)));
    assert!(order("B21", &b21) > 1.9);
    assert!(order("B22", &b22) > 3.8);
    assert!(order("B23", &b23) > 3.8);
    assert!(b22[3] < 1e-6 && b23[3] < 1e-6);
}
