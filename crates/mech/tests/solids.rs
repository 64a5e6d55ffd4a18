//! Plane strain with the mean dilation: derivatives, symmetries, patch test, bending, locking.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // test code throughout

use proptest::prelude::*;
use slideline_mech::differentiate::Second;
use slideline_mech::element::mean_dilation::{Quad4, runs_around};
use slideline_mech::element::{Element, Instances, Kernel, Response, Strains};
use slideline_mech::material::{Elastic, Hencky, PlaneStrainLaw, SaintVenant};
use std::fmt::Debug;

const SKEW: [[f64; 2]; 4] = [[10.0, 20.0], [11.1, 20.2], [11.4, 21.3], [9.9, 20.9]];
const STEEL: Elastic = Elastic { modulus: 7.0, poisson: 0.3 };

fn hencky(corners: &[[f64; 2]; 4], elastic: Elastic) -> Quad4<Hencky> {
    Quad4::quad4(corners, 0.5, (Hencky(elastic), elastic, true))
}

fn green(corners: &[[f64; 2]; 4], elastic: Elastic) -> Quad4<SaintVenant> {
    Quad4::quad4(corners, 0.5, (SaintVenant(elastic), elastic, false))
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

fn near(a: &[f64], b: &[f64], tolerance: f64) {
    for (i, (x, y)) in a.iter().zip(b).enumerate() {
        assert!((x - y).abs() <= tolerance, "{i}: {x} {y}");
    }
}

/// Force, tangent and energy.
fn response(element: &impl Element<8, 64>, q: &[f64; 8]) -> ([f64; 8], [f64; 64], f64) {
    let (mut force, mut tangent) = ([0.0; 8], [0.0; 64]);
    let energy = element.exact(q, &mut force, &mut tangent);
    (force, tangent, energy)
}

fn displacements(size: f64) -> impl Strategy<Value = [f64; 8]> {
    prop::array::uniform::<_, 8>(-1.0..1.0_f64).prop_map(move |q| q.map(|u| size * u))
}

/// Against forward differentiation of the energy; and the force alone has the same bits.
fn derivatives<L>(element: &Quad4<L>, q: &[f64; 8])
where
    L: PlaneStrainLaw + Debug + Send + Sync,
{
    let exact: Second<8> = element.energy(&Second::variables(q));
    let (force, tangent, energy) = response(element, q);
    let scale = 7.0;
    assert!((energy - exact.value).abs() < 1e-13 * scale);
    near(&force, &exact.gradient, 1e-13 * scale);
    near(&tangent, exact.hessian.as_flattened(), 1e-12 * scale);
    let mut alone = [0.0; 8];
    assert_eq!(Element::<8, 64>::exact_force(element, q, &mut alone), energy);
    assert_eq!(alone, force);
}

proptest! {
    /// Requirement: force and tangent are the derivatives of the energy, at strains up to about
    /// 0.4. Source: forward differentiation. Tolerance: rounding.
    #[test]
    fn derivatives_of_the_energy(q in displacements(0.15)) {
        derivatives(&hencky(&SKEW, STEEL), &q);
        derivatives(&green(&SKEW, STEEL), &q);
    }

    /// Requirement: small displacements leave no difference between the laws and strains: the
    /// linear force is the limit of both, and its tangent times q. Tolerance: the square of the
    /// strain.
    #[test]
    fn small_displacements(q in displacements(1e-7)) {
        let element = hencky(&SKEW, STEEL);
        let (mut force, mut tangent) = ([0.0; 8], [0.0; 64]);
        let energy = element.linear(&q, &mut force, &mut tangent);
        for large in [response(&element, &q).0, response(&green(&SKEW, STEEL), &q).0] {
            near(&large, &force, 1e-12);
        }
        let product: Vec<f64> =
            tangent.chunks(8).map(|row| row.iter().zip(&q).map(|(k, u)| k * u).sum()).collect();
        near(&product, &force, 1e-20);
        let work: f64 = force.iter().zip(&q).map(|(f, u)| f * u).sum();
        prop_assert!((2.0 * energy - work).abs() < 1e-13 * work);
    }

    /// Requirement: a turn and a shift after any displacement turn the force and leave the
    /// energy. Source: objectivity. Tolerance: rounding.
    #[test]
    fn objectivity(q in displacements(0.15), turn in -7.0..7.0_f64) {
        let (s, c) = turn.sin_cos();
        let moved: [f64; 8] = std::array::from_fn(|i| {
            let place = [0, 1].map(|k| SKEW[i / 2][k] + q[2 * (i / 2) + k]);
            let turned = [c * place[0] - s * place[1] + 3.0, s * place[0] + c * place[1] - 2.0];
            turned[i % 2] - SKEW[i / 2][i % 2]
        });
        let turns = |f: &[f64; 8]| -> Vec<f64> {
            f.chunks(2).flat_map(|f| [c * f[0] - s * f[1], s * f[0] + c * f[1]]).collect()
        };
        for (before, after) in [
            (response(&hencky(&SKEW, STEEL), &q), response(&hencky(&SKEW, STEEL), &moved)),
            (response(&green(&SKEW, STEEL), &q), response(&green(&SKEW, STEEL), &moved)),
        ] {
            prop_assert!((after.2 - before.2).abs() < 1e-12);
            near(&after.0, &turns(&before.0), 1e-12);
        }
    }
}

/// Displacements of the corners under u = A X + b.
fn homogeneous(corners: &[[f64; 2]; 4], a: [[f64; 2]; 2]) -> [f64; 8] {
    std::array::from_fn(|i| {
        let x = corners[i / 2];
        a[i % 2][0] * x[0] + a[i % 2][1] * x[1] + 0.25
    })
}

/// Requirement: rigid motion makes no force. Source: statics. Tolerance: rounding of positions of
/// 20 against elements of 1 and a stiffness of 10.
#[test]
fn rigid_motion_makes_no_force() {
    for turn in [0.0, 1e-3, 1.0, 3.1] {
        let (s, c) = f64::sin_cos(turn);
        let q = homogeneous(&SKEW, [[c - 1.0, -s], [s, c - 1.0]]);
        for (force, _, energy) in
            [response(&hencky(&SKEW, STEEL), &q), response(&green(&SKEW, STEEL), &q)]
        {
            assert!(largest(&force) < 2e-13 && energy.abs() < 1e-25, "{force:?} {energy}");
        }
    }
}

/// Five skewed elements in a square; the four inner nodes are in no order.
const PATCH: [[f64; 2]; 8] = [
    [0.0, 0.0],
    [0.24, 0.0],
    [0.24, 0.12],
    [0.0, 0.12],
    [0.04, 0.02],
    [0.18, 0.03],
    [0.16, 0.08],
    [0.08, 0.08],
];
const ELEMENTS: [[usize; 4]; 5] =
    [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [4, 5, 6, 7]];

/// Requirement: the patch test. Under a homogeneous deformation every point of a skewed mesh has
/// the same stress, that of the law, and inner nodes no force. Source: mesh of R. H. MacNeal and
/// R. L. Harder (1985). Tolerance: 1e-12 of the stress.
#[test]
fn patch_test() {
    let small = [[1e-3, 5e-4], [5e-4, 1e-3]];
    let large = [[0.3, 0.2], [-0.1, -0.2]];
    for (a, linear) in [(small, true), (large, false)] {
        let corners = |nodes: &[usize; 4]| nodes.map(|node| PATCH[node]);
        let elements = ELEMENTS.iter().map(|nodes| hencky(&corners(nodes), STEEL));
        let kernel: Instances<_, 8, 64> = elements.collect();
        let strains = if linear { Strains::Linear } else { Strains::Exact };
        let mut inner = [[0.0; 2]; 8];
        let mut first: Option<[f64; 32]> = None;
        for (element, nodes) in ELEMENTS.iter().enumerate() {
            let q = homogeneous(&corners(nodes), a);
            let mut force = [0.0; 8];
            let into = Response { force: &mut force, tangent: None, state: &mut [] };
            kernel.respond(element, &q, &[], strains, into);
            for (corner, &node) in nodes.iter().enumerate() {
                (0..2).for_each(|k| inner[node][k] += force[2 * corner + k]);
            }
            let mut results = [0.0; 32];
            kernel.results(element, &q, &[], strains, &mut results);
            near(&results, first.get_or_insert(results), 1e-12);
        }
        near(inner[4..].as_flattened(), &[0.0; 8], 1e-13);
        assert!(largest(inner[..4].as_flattened()) > 1e-4);
        let stress = first.unwrap();
        near(&stress[4..8], &stress[..4], 1e-12);
        if linear {
            // 2 G eps + (K - 2 G/3) tr eps
            let (shear, bulk) = (STEEL.shear_modulus(), STEEL.bulk_modulus());
            let even = (bulk - 2.0 / 3.0 * shear) * 2e-3;
            let exact = [2e-3 * shear + even, 2e-3 * shear + even, even, 1e-3 * shear];
            near(&stress[..4], &exact, 1e-14);
            near(&stress[16..20], &[1e-3, 1e-3, 0.0, 1e-3], 1e-14);
        }
    }
}

/// Cauchy stress of a homogeneous deformation of the unit square, by the work of the faces: the
/// force of the kernel on its right face is the stress times the turned face.
#[test]
fn stresses_are_those_of_the_nodal_forces() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let a = [[0.3, 0.2], [-0.1, -0.2]];
    let q = homogeneous(&square, a);
    // N dA of the right face is the first column of the cofactor of F
    let face = [1.0 + a[1][1], -a[0][1]];
    let check = |element: &dyn Fn(&mut [f64; 8], &mut [f64; 32])| {
        let (mut force, mut results) = ([0.0; 8], [0.0; 32]);
        element(&mut force, &mut results);
        let pull = [force[2] + force[4], force[3] + force[5]].map(|f| f / 0.5);
        let [xx, yy, _, xy] = [results[0], results[1], results[2], results[3]];
        near(&pull, &[xx * face[0] + xy * face[1], xy * face[0] + yy * face[1]], 1e-14);
        results
    };
    let log = hencky(&square, STEEL);
    let told = check(&|force, results| {
        Element::<8, 64>::exact_force(&log, &q, force);
        Element::<8, 64>::results(&log, &q, false, results);
    });
    let green = green(&square, STEEL);
    check(&|force, results| {
        Element::<8, 64>::exact_force(&green, &q, force);
        Element::<8, 64>::results(&green, &q, false, results);
    });
    // Hencky: J sigma = 2 G ln V + (K - 2 G/3) ln J
    let jacobian = 1.3 * 0.8 + 0.2 * 0.1;
    let even = (STEEL.bulk_modulus() - 2.0 / 3.0 * STEEL.shear_modulus()) * f64::ln(jacobian);
    let shear = 2.0 * STEEL.shear_modulus();
    let [xx, yy, zz, angle] = [told[16], told[17], told[18], told[19]];
    let exact = [shear * xx + even, shear * yy + even, shear * zz + even, 0.5 * shear * angle];
    near(&told[..4], &exact.map(|stress| stress / jacobian), 1e-14);
    assert!((xx + yy - f64::ln(jacobian)).abs() < 1e-15);
}

/// Requirement: the stiffness of a square against bending is 7/9 G, .299 E at nu = .3, whatever
/// the bulk modulus: no locking. Source: hourglass mode u = x y in closed form, integrated exactly.
/// Tolerance: rounding.
#[test]
fn bending_of_a_square_does_not_lock() {
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let mode = [1.0, 0.0, -1.0, 0.0, 1.0, 0.0, -1.0, 0.0];
    for poisson in [0.0, 0.3, 0.49, 0.4999] {
        let elastic = Elastic { modulus: 1.0, poisson };
        let element = Quad4::quad4(&square, 1.0, (Hencky(elastic), elastic, true));
        let (mut force, mut tangent) = ([0.0; 8], [0.0; 64]);
        element.linear(&mode, &mut force, &mut tangent);
        let stiffness = force.iter().zip(mode).map(|(f, u)| f * u).sum::<f64>() / 4.0;
        let exact = 7.0 / 9.0 * elastic.shear_modulus();
        assert!((stiffness - exact).abs() < 1e-12, "{poisson}: {stiffness} {exact}");
        if poisson == 0.3 {
            assert!((stiffness - 0.299).abs() < 5e-4);
        }
    }
}

/// Requirement: a square has three motions without stiffness and no more. Tolerance: rounding.
#[test]
fn rank_of_the_stiffness() {
    let element = hencky(&SKEW, STEEL);
    let (mut force, mut tangent) = ([0.0; 8], [0.0; 64]);
    Element::<8, 64>::linear(&element, &[0.0; 8], &mut force, &mut tangent);
    // elimination with full pivoting
    let (mut k, mut rank) = (tangent, 0);
    let scale = largest(&tangent);
    let mut left: Vec<usize> = (0..8).collect();
    while let Some(place) = (0..left.len()).max_by(|&a, &b| {
        let size = |p: usize| k[9 * left[p]].abs();
        size(a).total_cmp(&size(b))
    }) {
        let pivot = left.swap_remove(place);
        if k[9 * pivot] < 1e-12 * scale {
            break;
        }
        rank += 1;
        for &i in &left {
            let factor = k[8 * i + pivot] / k[9 * pivot];
            (0..8).for_each(|j| k[8 * i + j] -= factor * k[8 * pivot + j]);
        }
    }
    assert_eq!(rank, 5);
}

/// Requirement: corners given clockwise, or far re-entrant, are told from sound ones.
#[test]
fn corners_that_make_no_element() {
    assert!(runs_around(&SKEW));
    let [a, b, c, d] = SKEW;
    assert!(!runs_around(&[a, d, c, b]) && !runs_around(&[a, b, d, c]));
    assert!(!runs_around(&[a, b, [10.1, 20.1], d]));
}

/// Requirement: a deformation that turns a square inside out has no energy at all (no number), so
/// that the iteration sees it: a logarithm has no value there.
#[test]
fn inside_out_is_no_number() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let q = homogeneous(&square, [[-1.5, 0.0], [0.0, 0.0]]);
    assert!(response(&hencky(&square, STEEL), &q).2.is_nan());
    assert!(response(&green(&square, STEEL), &q).2.is_nan());
}
