//! What the measures of a run and the adviser cost beside the run itself:
//! `cargo bench -p slideline-verification --bench measures`.
//!
//! ```text
//!   solve/quiet   the solution, nobody watches (contact pairs are summed up)
//!   solve/noise   the same, its noise measured
//!   run           the same with all result files
//!   advise        what `slideline check` has to say before
//! ```

// a bench that cannot read its deck has nothing to measure
#![allow(clippy::expect_used)]

use criterion::{Criterion, criterion_group, criterion_main};
use slideline::{Job, Noise, Quiet, Read, ReadOptions, RunOptions, SolveOptions};
use std::hint::black_box;

const DECKS: [(&str, &str); 3] = [
    ("irs_coarse", include_str!("../../corpus/diehl1995/irs_coarse.inp")),
    ("isl_coarse", include_str!("../../corpus/diehl1995/isl_coarse.inp")),
    ("surface_coarse", include_str!("../../corpus/diehl1995/surface_coarse.inp")),
];

/// Every deck with 20 and with 200 increments.
fn decks() -> Vec<(String, Read)> {
    let mut all = Vec::new();
    for (name, text) in DECKS {
        let finer = text
            .replace("0.05, 1.0, 1.0E-6, 0.05", "0.005, 1.0, 1.0E-6, 0.005")
            .replace("INC=100", "INC=1000");
        for (count, text) in [(20, text), (200, finer.as_str())] {
            let read = Job::read_text(name, text, &ReadOptions::default());
            all.push((format!("{name}_{count}"), read));
        }
    }
    all
}

fn measures(c: &mut Criterion) {
    let options = SolveOptions::default();
    let folder = std::env::temp_dir().join("slideline_bench_measures");
    let files = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
    for (name, read) in decks() {
        let model = read.model.as_ref().expect("the corpus is read");
        let mut group = c.benchmark_group(&name);
        group.bench_function("solve/quiet", |b| {
            b.iter(|| slideline::solve(black_box(model), &options, &mut Quiet));
        });
        group.bench_function("solve/noise", |b| {
            b.iter(|| {
                let mut noise = Noise::of(model);
                slideline::solve(black_box(model), &options, &mut noise);
                noise.findings(&noise.summary())
            });
        });
        group.bench_function("run", |b| b.iter(|| slideline::run(&read, &files, &mut Quiet)));
        group.bench_function("advise", |b| b.iter(|| slideline::advise(black_box(&read))));
        group.finish();
    }
    let _ = std::fs::remove_dir_all(folder); // a folder left behind harms nothing
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = measures
}
criterion_main!(benches);
