//! Whole decks of the 1995 paper, text to last increment, without files.

// a bench that cannot read its deck has nothing to measure
#![allow(clippy::expect_used)]

use criterion::{Criterion, criterion_group, criterion_main};
use slideline::{Job, Quiet, ReadOptions, SolveOptions};
use slideline_verification::paper;
use std::hint::black_box;

fn whole_decks(c: &mut Criterion) {
    let decks = [
        ("irs_coarse", paper::IRS_COARSE),
        ("irs_fine", paper::IRS_FINE),
        ("isl_coarse", paper::ISL_COARSE),
        ("surface_coarse", paper::SURFACE_COARSE),
    ];
    let mut group = c.benchmark_group("whole_decks");
    for (name, deck) in decks {
        group.bench_function(name, |b| {
            b.iter(|| {
                let read = Job::read_text(name, black_box(deck), &ReadOptions::default());
                let model = read.model.expect("the corpus is read");
                slideline::solve(&model, &SolveOptions::default(), &mut Quiet)
            });
        });
    }
    group.finish();
}

criterion_group!(benches, whole_decks);
criterion_main!(benches);
