//! From a value of a slider to the first point of the curve, and to its end, without a page:
//! `cargo bench -p slideline-workbench --bench answer`.

use criterion::{Criterion, criterion_group, criterion_main};
use slideline_workbench::Bench;

const DECK: &str = include_str!("../../../corpus/new/snap_fit.inp");

/// Asks for a solve; it ends behind so many messages of points.
fn solve(bench: &mut Bench, thickness: f64, most: usize) -> usize {
    let ask = format!("{{\"ask\":\"solve\",\"id\":1,\"values\":{{\"thickness\":{thickness}}}}}");
    let (mut points, mut bytes) = (0, 0);
    bench.answer(&ask, &mut |text: &str| {
        bytes += text.len();
        points += usize::from(text.contains("\"say\":\"points\""));
        points < most
    });
    bytes
}

fn answers(c: &mut Criterion) {
    let mut bench = Bench::new().with_deck("snap_fit.inp", DECK);
    bench.answer("{\"ask\":\"open\",\"id\":0}", &mut |_| true);
    let mut thickness = 1.5;
    let mut next = move || {
        thickness = if thickness > 1.6 { 1.5 } else { thickness + 1e-3 };
        thickness
    };
    // the start, then the first increment
    c.bench_function("first point", |b| b.iter(|| solve(&mut bench, next(), 2)));
    c.bench_function("200 increments", |b| b.iter(|| solve(&mut bench, next(), usize::MAX)));
}

criterion_group!(benches, answers);
criterion_main!(benches);
