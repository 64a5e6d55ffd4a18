//! Stresses that are estimated apart: what they change of the tangent, and where they arrive.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // test code throughout

use proptest::prelude::*;
use slideline_mech::element::{Beam21, Beam22, Beam23, Mixed};
use slideline_mech::section::BeamStiffness;

const SEED: BeamStiffness =
    BeamStiffness { axial: 258_750.0, shear: 84_591.0, bending: 0.0485, centroid: 0.0 };

fn b21() -> Beam21 {
    Beam21::new([[0.01, 0.02], [0.011, 0.022]], SEED)
}

fn b22() -> Beam22 {
    Beam22::new([[0.01, 0.02], [0.0107, 0.0211], [0.011, 0.022]], SEED)
}

fn b23() -> Beam23 {
    Beam23::new([[0.01, 0.02], [0.011, 0.022]], SEED)
}

/// Displacements of `N / 3` nodes of elements about 2e-3 long.
fn displacements<const N: usize>() -> impl Strategy<Value = [f64; N]> {
    prop::array::uniform::<_, N>(-1.0..1.0_f64).prop_map(scaled)
}

fn scaled<const N: usize>(numbers: [f64; N]) -> [f64; N] {
    std::array::from_fn(|i| numbers[i] * if i % 3 == 2 { 0.7 } else { 4e-4 })
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

fn near(a: &[f64], b: &[f64], tolerance: f64) {
    let scale = largest(b).max(f64::MIN_POSITIVE);
    for (i, (x, y)) in a.iter().zip(b).enumerate() {
        assert!((x - y).abs() <= tolerance * scale, "{i}: {x} {y} of {scale}");
    }
}

/// With the stresses of the strains the mixed tangent is the tangent; whatever the stresses, force
/// and energy are those of the law.
fn own_stresses<const N: usize, const NN: usize, const S: usize>(
    element: &impl Mixed<N, NN, S>,
    exact: impl Fn(&mut [f64; N], &mut [f64; NN]) -> f64,
    q: &[f64; N],
    estimate: &[f64; S],
) {
    let (mut force, mut tangent) = ([0.0; N], [0.0; NN]);
    let energy = exact(&mut force, &mut tangent);
    let own = element.stresses_after(q, &[0.0; N]);
    near(&element.force_of_stresses(q, &own), &force, 1e-11);
    let (mut f, mut k) = ([0.0; N], [0.0; NN]);
    assert_eq!((element.force_and_mixed_tangent(q, &own, &mut f, &mut k), f), (energy, force));
    near(&k, &tangent, 1e-11);
    let mixed = element.force_and_mixed_tangent(q, estimate, &mut f, &mut k);
    assert_eq!((mixed, f), (energy, force));
}

/// The mixed tangent is the derivative of the law's force and of the force of what the estimate is
/// beyond the law, held fixed.
fn tangent_by_differences<const N: usize, const NN: usize, const S: usize>(
    element: &impl Mixed<N, NN, S>,
    q: &[f64; N],
    estimate: &[f64; S],
) {
    let (mut force, mut tangent) = ([0.0; N], [0.0; NN]);
    element.force_and_mixed_tangent(q, estimate, &mut force, &mut tangent);
    let own = element.stresses_after(q, &[0.0; N]);
    let beyond: [f64; S] = std::array::from_fn(|i| estimate[i] - own[i]);
    let both = |q: &[f64; N]| -> [f64; N] {
        let (mut force, mut unused) = ([0.0; N], [0.0; NN]);
        element.force_and_mixed_tangent(q, estimate, &mut force, &mut unused);
        let other = element.force_of_stresses(q, &beyond);
        std::array::from_fn(|i| force[i] + other[i])
    };
    let size = largest(&tangent);
    for j in 0..N {
        let step = if j % 3 == 2 { 1e-6 } else { 1e-9 };
        let (mut up, mut down) = (*q, *q);
        up[j] += step;
        down[j] -= step;
        let (up, down) = (both(&up), both(&down));
        for i in 0..N {
            let difference = (up[i] - down[i]) / (2.0 * step);
            let entry = tangent[N * i + j];
            assert!((difference - entry).abs() <= 1e-6 * size, "{i} {j}: {difference} {entry}");
            assert!((entry - tangent[N * j + i]).abs() <= 1e-12 * size, "symmetric");
        }
    }
}

/// Where the tangent of the stresses arrives.
fn arrives<const N: usize, const NN: usize, const S: usize>(
    element: &impl Mixed<N, NN, S>,
    q: &[f64; N],
    change: &[f64; N],
) {
    let at = |t: f64| {
        let moved = std::array::from_fn(|i| q[i] + t * change[i]);
        element.stresses_after(&moved, &[0.0; N])
    };
    let (here, up, down) = (at(0.0), at(1e-6), at(-1e-6));
    let line: [f64; S] = std::array::from_fn(|i| here[i] + (up[i] - down[i]) / 2e-6);
    near(&element.stresses_after(q, change), &line, 1e-7);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn b21_mixed(q in displacements::<6>(), change in displacements::<6>(),
                 s in prop::array::uniform3(-1e3..1e3_f64)) {
        let beam = b21();
        own_stresses(&beam, |f, k| beam.force_and_tangent(&q, f, k), &q, &s);
        tangent_by_differences(&beam, &q, &s);
        arrives(&beam, &q, &change);
    }

    #[test]
    fn b22_mixed(q in displacements::<9>(), change in displacements::<9>(),
                 s in prop::array::uniform6(-1e3..1e3_f64)) {
        let beam = b22();
        own_stresses(&beam, |f, k| beam.force_and_tangent(&q, f, k), &q, &s);
        tangent_by_differences(&beam, &q, &s);
        arrives(&beam, &q, &change);
    }

    #[test]
    fn b23_mixed(q in displacements::<6>(), change in displacements::<6>(),
                 s in prop::array::uniform3(-1e3..1e3_f64)) {
        let beam = b23();
        own_stresses(&beam, |f, k| beam.force_and_tangent(&q, f, k), &q, &s);
        tangent_by_differences(&beam, &q, &s);
        arrives(&beam, &q, &change);
    }
}
