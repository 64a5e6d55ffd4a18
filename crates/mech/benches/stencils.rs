//! Cost of one stencil: beams by hand and from their energy, a gap against a corner and a circle.
#![allow(missing_docs, clippy::unwrap_used)] // generated entry points; fixed sound data

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use slideline_mech::contact::gap::Gap;
use slideline_mech::contact::gap::circle::{Circle, Side};
use slideline_mech::contact::gap::curve::{Along, Weights, point_to_curve};
use slideline_mech::differentiate::Second;
use slideline_mech::element::{Beam21, Beam22, Beam23};
use slideline_mech::section::BeamStiffness;

fn beam(criterion: &mut Criterion) {
    let stiffness = BeamStiffness { axial: 258_750.0, shear: 57_033.0, bending: 0.0485 };
    let element = Beam21::new([[0.0, 0.0], [1e-4, 2e-3]], stiffness);
    let q = [1e-4, 2e-4, 0.1, 3e-4, -1e-4, 0.2];
    criterion.bench_function("b21 twin", |bench| {
        let (mut force, mut tangent) = ([0.0; 6], [0.0; 36]);
        bench.iter(|| element.force_and_tangent(black_box(&q), &mut force, &mut tangent));
    });
    criterion.bench_function("b21 differentiated", |bench| {
        bench.iter(|| element.energy(&Second::variables(black_box(&q))));
    });
}

fn finer_beams(criterion: &mut Criterion) {
    let stiffness = BeamStiffness { axial: 258_750.0, shear: 57_033.0, bending: 0.0485 };
    let quadratic = Beam22::new([[0.0, 0.0], [5e-5, 1e-3], [1e-4, 2e-3]], stiffness);
    let q = [1e-4, 2e-4, 0.1, 2e-4, 0.0, 0.15, 3e-4, -1e-4, 0.2];
    criterion.bench_function("b22 twin", |bench| {
        let (mut force, mut tangent) = ([0.0; 9], [0.0; 81]);
        bench.iter(|| quadratic.force_and_tangent(black_box(&q), &mut force, &mut tangent));
    });
    let cubic = Beam23::new([[0.0, 0.0], [1e-4, 2e-3]], stiffness);
    let q = [1e-4, 2e-4, 0.1, 3e-4, -1e-4, 0.2];
    criterion.bench_function("b23 twin", |bench| {
        let (mut force, mut tangent) = ([0.0; 6], [0.0; 36]);
        bench.iter(|| cubic.force_and_tangent(black_box(&q), &mut force, &mut tangent));
    });
    criterion.bench_function("b23 differentiated", |bench| {
        bench.iter(|| cubic.energy(&Second::variables(black_box(&q))));
    });
}

fn gaps(criterion: &mut Criterion) {
    let control = [[0.0, 0.0], [1.0, 0.1], [2.0, 0.0]];
    criterion.bench_function("gap corner", |bench| {
        bench.iter(|| -> Option<Gap<8>> {
            let s = black_box(0.4);
            let along = Along::corner(0.0, 0.2, 0.2, s);
            point_to_curve(black_box([0.95, 0.2]), &control, &Weights::corner(s, 0.2), &along, s)
        });
    });
    let circle = Circle { radius: 9e-3, side: Side::Convex };
    criterion.bench_function("gap circle", |bench| {
        bench.iter(|| circle.gap(black_box([8.9e-3, 1e-3]), [0.0, 0.0], 0.1, 0.0));
    });
}

criterion_group!(benches, beam, finer_beams, gaps);
criterion_main!(benches);
