//! Hand-written derivatives against their formula in second-order arithmetic and against differences.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // test code throughout

use proptest::prelude::*;
use slideline_mech::contact::gap::Gap;
use slideline_mech::contact::gap::circle::{Circle, Side};
use slideline_mech::contact::gap::curve::{Along, Weights, point_to_curve};
use slideline_mech::differentiate::{Real, Second};
use slideline_mech::element::{AxialSpring, Beam21, SpringLaw};
use slideline_mech::rigid::{Attachment, PointMap, push_forward};
use slideline_mech::section::BeamStiffness;

fn close(a: f64, b: f64, scale: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * scale
}

fn beam() -> Beam21 {
    let stiffness =
        BeamStiffness { axial: 258_750.0, shear: 57_033.0, bending: 0.0485, centroid: 4e-4 };
    Beam21::new([[0.01, 0.02], [0.011, 0.022]], stiffness)
}

fn rotations(range: std::ops::Range<f64>) -> impl Strategy<Value = [f64; 6]> {
    (prop::array::uniform4(-2e-3..2e-3_f64), range.clone(), range)
        .prop_map(|(u, f1, f2)| [u[0], u[1], f1, u[2], u[3], f2])
}

/// Compares a kernel of `N` variables with `formula` evaluated in second-order arithmetic.
fn compare<const N: usize>(gap: &Gap<N>, h: &Second<N>, sigma: &Second<N>, length: f64) {
    let tolerance = 1e-9;
    assert!(close(gap.overclosure, h.value, length, 1e-14));
    assert!(close(gap.along, sigma.value, length, 1e-13), "{} {}", gap.along, sigma.value);
    let size =
        |m: &[[f64; N]; N]| m.as_flattened().iter().fold(1.0 / length, |a, b| a.max(b.abs()));
    let (by_h, by_s) = (size(&h.hessian), size(&sigma.hessian));
    // The direction is d sigma/dq over its length at the slave.
    let (g, s) = (&sigma.gradient, &sigma.hessian);
    let at_slave = g[0].hypot(g[1]);
    for i in 0..N {
        let direction = g[i] / at_slave;
        assert!(close(gap.direction[i], direction, 1.0 + direction.abs(), 1e-11));
        assert!(close(gap.gradient[i], h.gradient[i], 1.0, 1e-11));
        assert!(close(
            gap.slip_gradient[i],
            sigma.gradient[i],
            1.0 + sigma.gradient[i].abs(),
            1e-11
        ));
        for (j, column) in s[0].iter().zip(&s[1]).enumerate() {
            let (a, b) = (gap.second.hessian[i][j], h.hessian[i][j]);
            assert!(close(a, b, by_h, tolerance), "h {i} {j}: {a} {b}");
            let growth = (g[0] * column.0 + g[1] * column.1) / at_slave;
            let (a, b) =
                (gap.second.direction_derivative[i][j], (s[i][j] - direction * growth) / at_slave);
            let by_drag = (1.0 + direction.abs()) * by_s / at_slave;
            assert!(close(a, b, by_drag, tolerance), "s {i} {j}: {a} {b}");
        }
    }
}

/// Compares derivatives with central differences of the kernel itself, of relative step 1e-6.
fn differences<const N: usize>(q: &[f64; N], length: f64, kernel: impl Fn(&[f64; N]) -> Gap<N>) {
    let gap = kernel(q);
    let step = 1e-6 * length;
    for j in 0..N {
        let (mut up, mut down) = (*q, *q);
        up[j] += step;
        down[j] -= step;
        let (up, down) = (kernel(&up), kernel(&down));
        let slope = |a: f64, b: f64| (a - b) / (2.0 * step);
        assert!(close(slope(up.overclosure, down.overclosure), gap.gradient[j], 1.0, 1e-7));
        assert!(close(slope(up.along, down.along), gap.slip_gradient[j], 3.0, 1e-7));
        for i in 0..N {
            let h = slope(up.gradient[i], down.gradient[i]);
            let s = slope(up.direction[i], down.direction[i]);
            assert!(close(h, gap.second.hessian[i][j], 30.0 / length, 1e-7));
            assert!(close(s, gap.second.direction_derivative[i][j], 300.0 / length, 1e-7));
        }
    }
}

/// A point of the Bezier curve (1 to 3 degrees) by repeated interpolation, and of its derivatives.
fn casteljau<R: Real>(control: &[[R; 2]], s: R) -> [R; 2] {
    let mut points: Vec<[R; 2]> = control.to_vec();
    let rest = R::from_f64(1.0) - s;
    while points.len() > 1 {
        points = points
            .windows(2)
            .map(|p| [rest * p[0][0] + s * p[1][0], rest * p[0][1] + s * p[1][1]])
            .collect();
    }
    points[0]
}

fn hodograph<R: Real>(control: &[[R; 2]]) -> Vec<[R; 2]> {
    let degree = R::from_f64((control.len() - 1) as f64);
    control
        .windows(2)
        .map(|p| [degree * (p[1][0] - p[0][0]), degree * (p[1][1] - p[0][1])])
        .collect()
}

/// Parameter and overclosure by Newton in the arithmetic of `R`.
fn formula<R: Real>(point: [R; 2], control: &[[R; 2]], start: f64) -> (R, R) {
    let first = hodograph(control);
    let second = if first.len() > 1 { hodograph(&first) } else { vec![[R::from_f64(0.0); 2]] };
    let mut s = R::from_f64(start);
    for _ in 0..60 {
        let (b, d, dd) = (casteljau(control, s), casteljau(&first, s), casteljau(&second, s));
        let apart = [point[0] - b[0], point[1] - b[1]];
        let f = apart[0] * d[0] + apart[1] * d[1];
        let slope = apart[0] * dd[0] + apart[1] * dd[1] - d[0] * d[0] - d[1] * d[1];
        s = s - f / slope;
    }
    let (b, d) = (casteljau(control, s), casteljau(&first, s));
    let size = (d[0] * d[0] + d[1] * d[1]).sqrt();
    let open = (d[0] * (point[1] - b[1]) - d[1] * (point[0] - b[0])) / size;
    (s, -open)
}

/// Control points of the Bezier form of a smoothed corner.
fn corner_control<R: Real>(x: &[[R; 2]], fraction: f64) -> Vec<[R; 2]> {
    let f = R::from_f64(fraction);
    let toward = |p: [R; 2]| [x[1][0] + f * (p[0] - x[1][0]), x[1][1] + f * (p[1] - x[1][1])];
    vec![toward(x[0]), x[1], toward(x[2])]
}

fn points<R: Copy, const N: usize>(q: &[R; N]) -> Vec<[R; 2]> {
    q.chunks(2).map(|p| [p[0], p[1]]).collect()
}

/// Requirement: the formula is the code: twin force and tangent are the derivatives of the energy.
/// Tolerance: round-off of EA eps times the lever.
#[test]
fn beam_stands_still_without_force() {
    let (mut force, mut tangent) = ([1.0; 6], [1.0; 36]);
    let energy = beam().force_and_tangent(&[0.0; 6], &mut force, &mut tangent);
    assert_eq!(energy, 0.0);
    assert!(force.iter().all(|f| *f == 0.0));
}

/// Requirement: elements without length give finite numbers.
#[test]
fn degenerate_elements() {
    let element = Beam21::new([[1.0, 1.0]; 2], beam().stiffness);
    let (mut force, mut tangent) = ([0.0; 6], [0.0; 36]);
    let q = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6];
    assert!(element.force_and_tangent(&q, &mut force, &mut tangent).is_finite());
    assert!(force.iter().chain(&tangent).all(|value| value.is_finite()));
    let spring = AxialSpring { reference: [[1.0, 1.0]; 2], law: SpringLaw::Linear(3.0) };
    let (mut force, mut tangent) = ([0.0; 4], [0.0; 16]);
    assert!(spring.force_and_tangent(&[0.0; 4], &mut force, &mut tangent).is_finite());
    assert!(force.iter().chain(&tangent).all(|value| value.is_finite()));
}

/// Requirement: a pure curvature keeps axial and shear strain at zero (regular polygon).
/// Source: verification, section 5, roll-up.
#[test]
fn a_chord_of_the_polygon_has_no_axial_or_shear_strain() {
    let stiffness = BeamStiffness { axial: 1.0, shear: 1.0, bending: 1.0, centroid: 0.0 };
    let element = Beam21::new([[0.0, 0.0], [1.0, 0.0]], stiffness);
    let angle = 0.7_f64;
    let (s, c) = (0.5 * angle).sin_cos();
    let strains = element.strains(&[0.0, 0.0, 0.0, c - 1.0, s, angle]);
    assert!(strains.axial.abs() < 1e-16 && strains.shear.abs() < 1e-16);
    assert!((strains.curvature - angle).abs() < 1e-16);
    let forces = element.section_forces(&[0.0, 0.0, 0.0, c - 1.0, s, angle]);
    assert!((forces.moment - angle).abs() < 1e-15);
}

/// Requirement: rounding of the force is about 1e-10 N at any distance from the origin.
/// Source: semantics, section 9, force floor.
#[test]
fn rounding_does_not_grow_with_the_coordinates() {
    let near = beam();
    let shift = 1000.0;
    let far = Beam21::new(near.reference.map(|p| [p[0] + shift, p[1] + shift]), near.stiffness);
    let q = [1e-7, 2e-7, 1e-5, 3e-7, 1e-7, 2e-5];
    let (mut f, mut g) = ([0.0; 6], [0.0; 6]);
    near.force(&q, &mut f);
    far.force(&q, &mut g);
    // The element's own length and angle are known to 1e-10 relative at 1000 m; nothing else is lost.
    let size = f.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    for i in 0..6 {
        assert!((f[i] - g[i]).abs() < 1e-9 * size, "{i}: {} {}", f[i], g[i]);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn beam_twin_is_its_energy(q in rotations(-3.0..3.0)) {
        let element = beam();
        let (mut force, mut tangent) = ([0.0; 6], [0.0; 36]);
        let energy = element.force_and_tangent(&q, &mut force, &mut tangent);
        let exact = element.energy(&Second::variables(&q));
        prop_assert!(close(energy, exact.value, exact.value.abs(), 1e-12));
        let size = exact.gradient.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
        let most = exact.hessian.as_flattened().iter().fold(0.0_f64, |a, b| a.max(b.abs()));
        for i in 0..6 {
            prop_assert!(close(force[i], exact.gradient[i], size, 1e-11));
            for j in 0..6 {
                prop_assert!(close(tangent[6 * i + j], exact.hessian[i][j], most, 1e-11));
            }
        }
        let mut alone = [0.0; 6];
        element.force(&q, &mut alone);
        prop_assert_eq!(alone, force);
    }

    #[test]
    fn beam_tangent_by_differences(q in rotations(-1.0..1.0)) {
        let element = beam();
        let (mut force, mut tangent) = ([0.0; 6], [0.0; 36]);
        element.force_and_tangent(&q, &mut force, &mut tangent);
        for j in 0..6 {
            let step = if j % 3 == 2 { 1e-6 } else { 1e-6 * element.length() };
            let (mut up, mut down) = (q, q);
            up[j] += step;
            down[j] -= step;
            let (mut f, mut g) = ([0.0; 6], [0.0; 6]);
            element.force(&up, &mut f);
            element.force(&down, &mut g);
            let column = (0..6).fold(0.0_f64, |a, i| a.max(tangent[6 * i + j].abs()));
            for i in 0..6 {
                let difference = (f[i] - g[i]) / (2.0 * step);
                prop_assert!(close(difference, tangent[6 * i + j], column, 1e-7));
            }
        }
    }

    /// Objectivity: a rigid motion of the deformed element turns its force and keeps its energy.
    #[test]
    fn beam_is_objective(q in rotations(-0.5..0.5), turn in -3.0..3.0_f64, shift in prop::array::uniform2(-1.0..1.0_f64)) {
        let element = beam();
        let (s, c) = turn.sin_cos();
        let mut moved = q;
        for node in 0..2 {
            let x = element.reference[node];
            let p = [x[0] + q[3 * node], x[1] + q[3 * node + 1]];
            moved[3 * node] = c * p[0] - s * p[1] + shift[0] - x[0];
            moved[3 * node + 1] = s * p[0] + c * p[1] + shift[1] - x[1];
            moved[3 * node + 2] = q[3 * node + 2] + turn;
        }
        let (mut f, mut g) = ([0.0; 6], [0.0; 6]);
        element.force(&q, &mut f);
        element.force(&moved, &mut g);
        // Moving by a metre rounds positions to 1e-16 m: 1e-16 EA/l.
        let floor = 1e-14 * element.stiffness.axial / element.length();
        let size = f.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
        for node in 0..2 {
            let k = 3 * node;
            prop_assert!((g[k] - (c * f[k] - s * f[k + 1])).abs() < floor + 1e-11 * size);
            prop_assert!((g[k + 1] - (s * f[k] + c * f[k + 1])).abs() < floor + 1e-11 * size);
            prop_assert!((g[k + 2] - f[k + 2]).abs() < floor + 1e-11 * size);
        }
    }

    /// Force and moment of the end forces are in balance about the deformed positions.
    #[test]
    fn beam_is_in_balance(q in rotations(-2.0..2.0)) {
        let element = beam();
        let mut f = [0.0; 6];
        element.force(&q, &mut f);
        let size = f.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
        prop_assert!((f[0] + f[3]).abs() <= 1e-13 * size && (f[1] + f[4]).abs() <= 1e-13 * size);
        let x = element.reference;
        let d = [x[1][0] + q[3] - x[0][0] - q[0], x[1][1] + q[4] - x[0][1] - q[1]];
        let moment = f[2] + f[5] + d[0] * f[4] - d[1] * f[3];
        prop_assert!(moment.abs() < 1e-12 * size);
    }

    /// Linear kinematics: the tangent is that at zero displacement and the force its product with q.
    #[test]
    fn linear_beam(q in rotations(-0.1..0.1)) {
        let element = beam();
        let (mut force, mut tangent) = ([0.0; 6], [0.0; 36]);
        let energy = element.linear_force_and_tangent(&q, &mut force, &mut tangent);
        let (mut none, mut start) = ([0.0; 6], [0.0; 36]);
        element.force_and_tangent(&[0.0; 6], &mut none, &mut start);
        let size = start.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
        let mut twice = 0.0;
        for i in 0..6 {
            let product: f64 = (0..6).map(|j| tangent[6 * i + j] * q[j]).sum();
            prop_assert!(close(product, force[i], size * 2e-3, 1e-12));
            prop_assert!((0..6).all(|j| close(tangent[6 * i + j], start[6 * i + j], size, 1e-14)));
            twice += q[i] * force[i];
        }
        prop_assert!(close(twice, 2.0 * energy, energy, 1e-10));
    }

    #[test]
    fn axial_spring_is_its_energy(q in prop::array::uniform4(-0.4..0.4_f64)) {
        let reference = [[0.0, 1.0], [2.0, 2.0]];
        let spring = AxialSpring { reference, law: SpringLaw::Linear(7.0) };
        let (mut force, mut tangent) = ([0.0; 4], [0.0; 16]);
        let energy = spring.force_and_tangent(&q, &mut force, &mut tangent);
        let elongation = spring.elongation(&Second::variables(&q));
        let exact = Second::from_f64(3.5) * elongation * elongation;
        prop_assert!(close(energy, exact.value, 1.0, 1e-13));
        for i in 0..4 {
            prop_assert!(close(force[i], exact.gradient[i], 1.0, 1e-12));
            for j in 0..4 {
                prop_assert!(close(tangent[4 * i + j], exact.hessian[i][j], 7.0, 1e-12));
            }
        }
    }

    /// A rigid arm: pushed force and tangent are the derivatives of a potential of the point.
    #[test]
    fn arm_pushes_forward(dofs in prop::array::uniform3(-2.0..2.0_f64), arm in prop::array::uniform2(-1.0..1.0_f64)) {
        let potential = |p: [Second<3>; 2]| p[0] * p[0] * p[1] + p[1].sin() * p[0];
        let q = Second::variables(&dofs);
        let number = Second::<3>::from_f64;
        let (s, c) = (q[2].sin(), q[2].cos());
        let point = [
            q[0] + c * number(arm[0]) - s * number(arm[1]),
            q[1] + s * number(arm[0]) + c * number(arm[1]),
        ];
        let exact = potential(point);
        let map = PointMap::Arm { arm };
        let u = map.displacement(&dofs);
        prop_assert!((u[0] + arm[0] - point[0].value).abs() < 1e-15 * 8.0);
        let x = Second::<2>::variables(&[u[0] + arm[0], u[1] + arm[1]]);
        let at_point = x[0] * x[0] * x[1] + x[1].sin() * x[0];
        let (mut force, mut tangent) = ([0.0; 3], [0.0; 9]);
        map.push_forward(&dofs, &at_point.gradient, &at_point.hessian, &mut force, &mut tangent);
        for i in 0..3 {
            prop_assert!(close(force[i], exact.gradient[i], 10.0, 1e-13));
            for j in 0..3 {
                prop_assert!(close(tangent[3 * i + j], exact.hessian[i][j], 30.0, 1e-13));
            }
        }
    }

    /// Three points on two bodies and a rotation, dofs shared: against second-order arithmetic.
    #[test]
    fn shared_dofs_push_forward(dofs in prop::array::uniform5(-1.0..1.0_f64), a in prop::array::uniform2(-1.0..1.0_f64), b in prop::array::uniform2(-1.0..1.0_f64)) {
        let q = Second::<5>::variables(&dofs);
        let ride = |arm: [f64; 2]| {
            let (s, c, n) = (q[4].sin(), q[4].cos(), Second::<5>::from_f64);
            [q[2] + c * n(arm[0]) - s * n(arm[1]), q[3] + s * n(arm[0]) + c * n(arm[1])]
        };
        let (pa, pb) = (ride(a), ride(b));
        let variables = [q[0], q[1], pa[0], pa[1], pb[0], pb[1], q[4]];
        let exact = potential(&variables);
        let values: [f64; 7] = variables.map(|v| v.value);
        let stencil = potential(&Second::<7>::variables(&values));
        let attachments = [
            Attachment::Point { map: PointMap::Free, first: 0 },
            Attachment::Point { map: PointMap::Arm { arm: a }, first: 2 },
            Attachment::Point { map: PointMap::Arm { arm: b }, first: 2 },
            Attachment::Rotation { dof: 4 },
        ];
        let (mut force, mut tangent) = ([0.0; 5], [0.0; 25]);
        push_forward(&attachments, &dofs, &stencil.gradient, stencil.hessian.as_flattened(), &mut force, &mut tangent);
        for i in 0..5 {
            prop_assert!(close(force[i], exact.gradient[i], 30.0, 1e-13));
            for j in 0..5 {
                prop_assert!(close(tangent[5 * i + j], exact.hessian[i][j], 100.0, 1e-13));
            }
        }
    }

    #[test]
    fn straight_segment(p in prop::array::uniform2(0.1..0.9_f64), j in prop::array::uniform6(-0.2..0.2_f64)) {
        let q = [p[0] + j[0], p[1] - 0.5 + j[1], j[2], j[3], 1.0 + j[4], j[5]];
        let kernel = |q: &[f64; 6]| {
            let x = points(q);
            let (xi, _) = formula(x[0], &x[1..], 0.5);
            let along = Along::straight(3.0, 1.3, xi);
            point_to_curve(x[0], &[x[1], x[2]], &Weights::straight(xi), &along, xi).unwrap()
        };
        let x = points(&Second::variables(&q));
        let (xi, h) = formula(x[0], &x[1..], 0.5);
        compare(&kernel(&q), &h, &(Second::from_f64(3.0) + Second::from_f64(1.3) * xi), 1.0);
        differences(&q, 1.0, kernel);
    }

    #[test]
    fn smoothed_corner(p in prop::array::uniform2(-0.1..0.1_f64), j in prop::array::uniform6(-0.1..0.1_f64), f in 0.05..0.45_f64) {
        let q = [1.0 + f * p[0], f * p[1], j[0], j[1], 1.0 + j[2], 0.1 + j[3], 2.2 + j[4], j[5]];
        let (a1, a2) = (f, 1.2 * f);
        let kernel = |q: &[f64; 8]| {
            let x = points(q);
            let (s, _) = formula(x[0], &corner_control(&x[1..], f), 0.5);
            let along = Along::corner(5.0, a1, a2, s);
            point_to_curve(x[0], &[x[1], x[2], x[3]], &Weights::corner(s, f), &along, s).unwrap()
        };
        let x = points(&Second::variables(&q));
        let (s, h) = formula(x[0], &corner_control(&x[1..], f), 0.5);
        let n = Second::<8>::from_f64;
        let sigma = n(5.0 - a1) + n(2.0 * a1) * s + n(a2 - a1) * s * s;
        compare(&kernel(&q), &h, &sigma, 1.0);
        differences(&q, f, kernel);
    }

    #[test]
    fn parabola_and_cubic(p in prop::array::uniform2(-0.1..0.1_f64), j in prop::array::uniform8(-0.1..0.1_f64)) {
        let q = [1.0 + p[0], 0.5 + p[1], j[0], j[1], 1.0 + j[2], 0.6 + j[3], 2.0 + j[4], j[5]];
        let x = points(&Second::variables(&q));
        let (s, h) = formula(x[0], &x[1..], 0.5);
        let v = points(&q);
        let xi = s.value;
        let along = Along { value: xi, first: 1.0, second: 0.0 };
        let gap: Gap<8> =
            point_to_curve(v[0], &[v[1], v[2], v[3]], &Weights::quadratic(xi), &along, xi).unwrap();
        compare(&gap, &h, &s, 1.0);
        let q = [1.5 + p[0], 0.5 + p[1], j[0], j[1], 1.0 + j[2], 0.6 + j[3], 2.0 + j[4], 0.5 + j[5], 3.0 + j[6], j[7]];
        let x = points(&Second::variables(&q));
        let (s, h) = formula(x[0], &x[1..], 0.5);
        let v = points(&q);
        let xi = s.value;
        let along = Along { value: xi, first: 1.0, second: 0.0 };
        let control = [v[1], v[2], v[3], v[4]];
        let gap: Gap<10> = point_to_curve(v[0], &control, &Weights::cubic(xi), &along, xi).unwrap();
        compare(&gap, &h, &s, 1.0);
    }

    /// A curve through nodes as Bezier's cubic, whose inner points lie a third of the tangents from its ends.
    #[test]
    fn curve_through_nodes(p in prop::array::uniform2(-0.1..0.1_f64), j in prop::array::uniform8(-0.1..0.1_f64), own in 0..3_usize) {
        let mut q = [0.0; 10];
        q[..2].copy_from_slice(&[0.5 + own as f64 + p[0], 0.4 + p[1]]);
        for (k, at) in j.into_iter().enumerate() {
            q[2 + k] = at + if k % 2 == 0 { (k / 2) as f64 } else { 0.2 * (k / 2) as f64 };
        }
        let (middle, end) = ([-0.5, -0.2, 0.7, 0.0], [0.3, -1.1, 0.8, 0.0]);
        let tangents = [middle, end];
        let x = points(&Second::variables(&q));
        let n = Second::<10>::from_f64;
        let control: Vec<_> = (0..4).map(|k| [0, 1].map(|c| {
            let third = |weights: [f64; 4]| (0..4).fold(n(0.0), |sum, i| sum + n(weights[i] / 3.0) * x[1 + i][c]);
            match k {
                0 => x[1 + own][c],
                1 => x[1 + own][c] + third(middle),
                2 => x[2 + own][c] - third(end),
                _ => x[2 + own][c],
            }
        })).collect();
        let (s, h) = formula(x[0], &control, 0.5);
        let v = points(&q);
        let xi = s.value;
        let along = Along { value: 3.0 + 1.3 * xi, first: 1.3, second: 0.0 };
        let nodes = [v[1], v[2], v[3], v[4]];
        let gap: Gap<10> = point_to_curve(v[0], &nodes, &Weights::through(xi, own, &tangents), &along, xi).unwrap();
        compare(&gap, &h, &(n(3.0) + n(1.3) * s), 1.0);
    }

    #[test]
    fn circle(d in prop::array::uniform2(-2.0..2.0_f64), c in prop::array::uniform2(-1.0..1.0_f64), phi in -9.0..9.0_f64, convex: bool) {
        prop_assume!(d[0].hypot(d[1]) > 0.3);
        let side = if convex { Side::Convex } else { Side::Concave };
        let circle = Circle { radius: 0.9, side };
        let q = [c[0] + d[0], c[1] + d[1], c[0], c[1], phi];
        let kernel = |reference: f64| {
            move |q: &[f64; 5]| circle.gap([q[0], q[1]], [q[2], q[3]], q[4], reference).unwrap()
        };
        let x = Second::variables(&q);
        let (dx, dy) = (x[0] - x[2], x[1] - x[3]);
        let distance = (dx * dx + dy * dy).sqrt();
        let n = Second::<5>::from_f64;
        let sign = n(if convex { 1.0 } else { -1.0 });
        let h = sign * (n(0.9) - distance);
        let sigma = -(sign * n(0.9) * (dy.atan2(dx) - x[4]));
        let gap = kernel(sigma.value)(&q);
        compare(&gap, &h, &sigma, 1.0);
        // Wrapped to within pi r of any reference.
        let far = kernel(100.0)(&q);
        prop_assert!((far.along - 100.0).abs() <= std::f64::consts::PI * 0.9 + 1e-9);
        let turns = (far.along - gap.along) / (std::f64::consts::TAU * 0.9);
        prop_assert!((turns - turns.round()).abs() < 1e-9);
        differences(&q, 0.3, kernel(sigma.value));
        // The tangent is the direction in which sigma grows, the normal that in which g grows.
        let along = gap.slip_gradient[0] * gap.tangent[0] + gap.slip_gradient[1] * gap.tangent[1];
        let away = gap.gradient[0] * gap.normal[0] + gap.gradient[1] * gap.normal[1];
        prop_assert!(along > 0.0 && (away + 1.0).abs() < 1e-14);
    }
}

fn potential<const N: usize>(v: &[Second<N>; 7]) -> Second<N> {
    v[0] * v[2] * v[5] + v[1].sin() * v[3] * v[6] + v[4] * v[4] * v[6] + v[0] * v[1] * v[3]
}

/// Requirement: every function of the second-order arithmetic, against central differences of its
/// gradient. Tolerance 1e-7 for a step of 1e-6.
#[test]
fn second_order_arithmetic() {
    fn all<R: Real>(q: &[R; 2]) -> R {
        let [x, y] = *q;
        x.sqrt() * y.exp() + x.sin() / y.cos() + (x * y).ln() + y.exp_m1().powi(3)
            - x.atan2(y) * (-x).abs()
            + y.atan2(-x)
    }
    let q = [0.7, 0.4];
    let value = all(&Second::variables(&q));
    assert!((value.value - all(&q)).abs() < 1e-15);
    for j in 0..2 {
        let (mut up, mut down) = (q, q);
        up[j] += 1e-6;
        down[j] -= 1e-6;
        assert!(((all(&up) - all(&down)) / 2e-6 - value.gradient[j]).abs() < 1e-7);
        let (up, down) = (all(&Second::variables(&up)), all(&Second::variables(&down)));
        for i in 0..2 {
            let difference = (up.gradient[i] - down.gradient[i]) / 2e-6;
            assert!((difference - value.hessian[i][j]).abs() < 1e-7);
        }
    }
}
