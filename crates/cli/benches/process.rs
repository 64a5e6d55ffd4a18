//! The whole process: start, deck, solution, result files written, report off;
//! and its peak memory. `cargo bench -p slideline-cli --bench process`.
//!
//! Memory is what the system's `time` says of the child; without `/usr/bin/time`
//! only times are measured.

// a bench that cannot run the program has nothing to measure
#![allow(clippy::expect_used, clippy::panic)]

mod common;

use criterion::{Criterion, criterion_group, criterion_main};
use std::ffi::OsString;
use std::path::Path;

const DECKS: [&str; 4] = ["irs_coarse", "irs_fine", "isl_coarse", "isl_coarse_mu03"];

/// `run DECK --out FOLDER --quiet --no-html`.
fn arguments(name: &str, folder: &Path) -> Vec<OsString> {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/diehl1995");
    let deck = corpus.join(name).with_extension("inp");
    let words = [deck.as_os_str(), "--out".as_ref(), folder.as_os_str()].map(OsString::from);
    let ends = ["--quiet", "--no-html"].map(OsString::from);
    [OsString::from("run")].into_iter().chain(words).chain(ends).collect()
}

fn process(c: &mut Criterion) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("bench_process");
    std::fs::create_dir_all(&folder).expect("the folder of results");
    let mut group = c.benchmark_group("process");
    for name in DECKS {
        let arguments = arguments(name, &folder);
        common::tell_memory(&format!("process/{name}"), &arguments);
        group.bench_function(name, |b| b.iter(|| common::run(&arguments)));
    }
    group.finish();
}

criterion_group!(benches, process);
criterion_main!(benches);
