//! The solution alone: a model that has been read, to its last increment; and
//! reading alone. `cargo bench -p slideline-verification --bench solve`.
//!
//! `UNSYMM=NO` stands beside the default, because the paper remarks on it.

// a bench that cannot read its deck has nothing to measure
#![allow(clippy::expect_used)]

use criterion::{Criterion, criterion_group, criterion_main};
use slideline::{Job, Model, Quiet, ReadOptions, SolveOptions};
use slideline_verification::{Cam, paper};
use std::hint::black_box;

fn model(name: &str, deck: &str) -> Model {
    Job::read_text(name, deck, &ReadOptions::default()).model.expect("the corpus is read")
}

fn decks() -> Vec<(&'static str, String)> {
    let rubbed = |deck: &str| deck.replace("*FRICTION\n0.0", "*FRICTION\n0.3");
    let isl = rubbed(paper::ISL_COARSE);
    let half = isl.replace("*STEP, NLGEOM", "*STEP, NLGEOM, UNSYMM=NO");
    let cam = Cam { increments: 20, mu: 0.3, onset: "IMMEDIATE", spacing: 3.0 };
    vec![
        ("irs_coarse", paper::IRS_COARSE.to_owned()),
        ("irs_coarse_mu03", rubbed(paper::IRS_COARSE)),
        ("irs_fine", paper::IRS_FINE.to_owned()),
        ("isl_coarse", paper::ISL_COARSE.to_owned()),
        ("isl_coarse_mu03", isl),
        ("isl_coarse_mu03_unsymm_no", half),
        ("cam_mu03", cam.deck()),
    ]
}

fn solving(c: &mut Criterion) {
    let mut group = c.benchmark_group("solve");
    for (name, deck) in decks() {
        let model = model(name, &deck);
        group.bench_function(name, |b| {
            b.iter(|| slideline::solve(black_box(&model), &SolveOptions::default(), &mut Quiet));
        });
    }
    group.finish();
}

fn reading(c: &mut Criterion) {
    let mut group = c.benchmark_group("read");
    for (name, deck) in decks().into_iter().filter(|(name, _)| !name.contains("mu03")) {
        group.bench_function(name, |b| b.iter(|| model(name, black_box(&deck))));
    }
    group.finish();
}

criterion_group!(benches, solving, reading);
criterion_main!(benches);
