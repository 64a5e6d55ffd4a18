//! Refactorisation, one solution and many, of typical systems: chains of plane beams (3 dofs a node),
//! a plane grid of quadrilaterals (2 dofs) and a space grid of bricks (3 dofs); with them the rate of
//! a dense product, the measure of the machine, and dense systems. `cargo bench -p slideline-linalg`; a part of a name
//! behind `--` chooses.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};
use slideline_linalg::{BackEnd, DenseLu, Kind, Pattern, analyse_with};

/// Beam chain with `nodes` nodes: diagonally dominant values on the pattern of the elements.
fn chain(nodes: usize) -> Pattern {
    let elements = (0..nodes - 1).map(|e| (3 * e..3 * e + 6).collect::<Vec<usize>>());
    Pattern::from_cliques(3 * nodes, elements)
}

/// Grid of nodes whose cells (quadrilaterals, bricks) couple all their dofs.
fn grid(nodes: [usize; 3], dofs: usize) -> Pattern {
    let [nx, ny, nz] = nodes;
    let node = move |x: usize, y: usize, z: usize| x + nx * (y + ny * z);
    let cells = (0..nx - 1).flat_map(move |x| (0..ny - 1).map(move |y| (x, y)));
    let layers = if nz == 1 { 1 } else { nz - 1 };
    let cells = cells.flat_map(move |(x, y)| (0..layers).map(move |z| (x, y, z)));
    let clique = move |(x, y, z): (usize, usize, usize)| {
        let corners = (0..8).map(move |c| (x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)));
        let inside = corners.filter(move |&(_, _, z)| z < nz);
        inside.flat_map(move |(x, y, z)| (0..dofs).map(move |d| dofs * node(x, y, z) + d)).collect()
    };
    Pattern::from_cliques(dofs * nx * ny * nz, cells.map(clique).collect::<Vec<Vec<_>>>().iter())
}

/// Diagonally dominant values, unsymmetric only where asked for.
fn values(pattern: &Pattern, kind: Kind) -> Vec<f64> {
    let rows = (0..pattern.size()).flat_map(|i| pattern.row(i).iter().map(move |&j| (i, j)));
    let skew = |i: usize, j: usize| if kind == Kind::Unsymmetric && i < j { 0.2 } else { 0.0 };
    let off = |i: usize, j: usize| -1.0 + 0.1 * ((i + j) % 7) as f64 + skew(i, j);
    let value = |(i, j): (usize, usize)| {
        if i == j { 0.8 * pattern.row(i).len() as f64 } else { off(i, j) }
    };
    rows.map(value).collect()
}

fn systems() -> Vec<(&'static str, Pattern, Vec<BackEnd>)> {
    let (banded, sparse) = (BackEnd::Banded, BackEnd::Sparse);
    vec![
        ("chain 75", chain(25), vec![banded]),
        ("chain 300", chain(100), vec![banded]),
        ("chain 3000", chain(1000), vec![banded]),
        ("plane 5 k", grid([50, 50, 1], 2), vec![banded, sparse]),
        ("plane 49 k", grid([157, 157, 1], 2), vec![sparse]),
        ("space 8 k", grid([14, 14, 14], 3), vec![sparse]),
        ("space 49 k", grid([25, 25, 26], 3), vec![sparse]),
    ]
}

fn factor(criterion: &mut Criterion) {
    let wanted = std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    for (name, pattern, back_ends) in systems() {
        for kind in [Kind::Symmetric, Kind::Unsymmetric] {
            let values = values(&pattern, kind);
            for &back_end in &back_ends {
                let name = format!("{name} {kind:?} {back_end:?}");
                if wanted.as_ref().is_none_or(|part| name.contains(part.as_str())) {
                    measure(criterion, &name, (&pattern, &values), (kind, back_end));
                }
            }
        }
    }
}

fn measure(
    criterion: &mut Criterion,
    name: &str,
    (pattern, values): (&Pattern, &[f64]),
    (kind, back_end): (Kind, BackEnd),
) {
    let begin = std::time::Instant::now();
    let mut solver = analyse_with(pattern, kind, back_end);
    println!(
        "{name}: analysed in {:.3} s: {}",
        begin.elapsed().as_secs_f64(),
        solver.description()
    );
    let n = pattern.size();
    let mut block = vec![1.0; 32 * n];
    let mut group = criterion.benchmark_group(name);
    group.sample_size(10);
    group.bench_function("refactor", |b| {
        b.iter(|| black_box(solver.refactor(pattern, black_box(values)).is_ok()));
    });
    group.bench_function("solve", |b| {
        b.iter(|| black_box(solver.solve(&mut block[..n]).is_ok()));
    });
    group.bench_function("solve 32", |b| {
        b.iter(|| black_box(solver.solve_many(&mut block, 32).is_ok()));
    });
    group.finish();
}

/// Rate of a dense product of order 1000: 2e9 operations.
fn product(criterion: &mut Criterion) {
    let a = Mat::from_fn(1000, 1000, |i, j| ((i * 7 + j) % 11) as f64);
    let mut c = Mat::<f64>::zeros(1000, 1000);
    let mut group = criterion.benchmark_group("dense product of order 1000");
    group.sample_size(10);
    group.bench_function("2e9 operations", |b| {
        b.iter(|| matmul(&mut c, Accum::Replace, &a, &a, 1.0, Par::Seq));
    });
    group.finish();
}

/// Elimination of dense systems with row exchanges, as of the condensed contact problem.
fn dense(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("dense system");
    group.sample_size(10);
    let mut lu = DenseLu::default();
    for n in [30_usize, 300, 1300] {
        let entry = |k: usize| ((k * k * 7 + 3 * k) % 101) as f64 - 50.0;
        let matrix: Vec<f64> = (0..n * n).map(entry).collect();
        group.bench_function(format!("of {n} equations"), |b| {
            b.iter(|| {
                lu.matrix_mut(n).copy_from_slice(&matrix);
                black_box(lu.factor())
            });
        });
    }
    group.finish();
}

criterion_group!(benches, product, dense, factor);
criterion_main!(benches);
