//! Text to cards. `cargo bench -p slideline-deck`.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use slideline_deck::{NoFiles, parse};
use slideline_diag::Sources;
use std::fmt::Write as _;
use std::hint::black_box;

/// A deck of `nodes` nodes written out, a beam between each two.
fn long(nodes: usize) -> String {
    let mut text = String::from("*NODE, NSET=BEAM\n");
    for k in 0..nodes {
        let _ = writeln!(text, "{}, {:.6E}, 0.0, 0.0", k + 1, 1e-3 * k as f64); // a String takes any text
    }
    text.push_str("*ELEMENT, TYPE=B21, ELSET=BEAM\n");
    for k in 1..nodes {
        let _ = writeln!(text, "{k}, {k}, {}", k + 1);
    }
    text
}

fn parsing(c: &mut Criterion) {
    let decks = [
        ("irs_coarse", include_str!("../../../corpus/diehl1995/irs_coarse.inp").to_owned()),
        ("isl_coarse", include_str!("../../../corpus/diehl1995/isl_coarse.inp").to_owned()),
        ("10000_nodes", long(10_000)),
    ];
    let mut group = c.benchmark_group("parse");
    for (name, deck) in decks {
        group.throughput(Throughput::Bytes(deck.len() as u64));
        group.bench_function(name, |b| {
            b.iter(|| parse(&mut Sources::default(), name, black_box(deck.as_bytes()), &NoFiles));
        });
    }
    group.finish();
}

criterion_group!(benches, parsing);
criterion_main!(benches);
