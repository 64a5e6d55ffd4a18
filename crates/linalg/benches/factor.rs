//! Refactorisation and one solution of typical systems: chains of plane beams (3 dofs a node) and a
//! plane grid. `cargo bench -p slideline-linalg`.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use slideline_linalg::{BackEnd, Kind, Pattern, analyse, analyse_with};

/// Beam chain with `nodes` nodes: diagonally dominant values on the pattern of the elements.
fn chain(nodes: usize) -> (Pattern, Vec<f64>) {
    let elements = (0..nodes - 1).map(|e| (3 * e..3 * e + 6).collect::<Vec<usize>>());
    let pattern = Pattern::from_cliques(3 * nodes, elements);
    let values = values(&pattern, 12.0);
    (pattern, values)
}

/// Grid of `side` x `side` nodes, five-point stencil.
fn grid(side: usize) -> (Pattern, Vec<f64>) {
    let n = side * side;
    let right = (0..n).filter(move |i| i % side + 1 < side).map(|i| (i, i + 1));
    let pattern = Pattern::from_pairs(n, right.chain((0..n - side).map(|i| (i, i + side))));
    let values = values(&pattern, 4.5);
    (pattern, values)
}

fn values(pattern: &Pattern, diagonal: f64) -> Vec<f64> {
    let rows = (0..pattern.size()).flat_map(|i| pattern.row(i).iter().map(move |&j| (i, j)));
    let off = |i: usize, j: usize| -1.0 + 0.1 * ((i + j) % 7) as f64;
    rows.map(|(i, j)| if i == j { diagonal } else { off(i, j) }).collect()
}

fn factor(criterion: &mut Criterion) {
    let systems = [
        ("chain 75", chain(25)),
        ("chain 300", chain(100)),
        ("chain 3000", chain(1000)),
        ("grid 5041", grid(71)),
    ];
    for (name, (pattern, values)) in &systems {
        for kind in [Kind::Symmetric, Kind::Unsymmetric] {
            let mut solvers = vec![("chosen", analyse(pattern, kind))];
            if name.starts_with("grid") {
                solvers.push(("banded", analyse_with(pattern, kind, BackEnd::Banded)));
                solvers.push(("sparse", analyse_with(pattern, kind, BackEnd::Sparse)));
            }
            for (which, mut solver) in solvers {
                println!("{which}: {}", solver.description());
                let mut x = vec![1.0; pattern.size()];
                criterion.bench_function(&format!("{name} {kind:?} {which}"), |b| {
                    b.iter(|| {
                        x.fill(1.0);
                        let report = solver.refactor(pattern, black_box(values));
                        let solved = solver.solve(&mut x);
                        black_box((report.is_ok(), solved.is_ok()))
                    });
                });
            }
        }
    }
}

criterion_group!(benches, factor);
criterion_main!(benches);
