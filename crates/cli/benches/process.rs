//! The whole process: start, deck, solution, result files written, report off;
//! and its peak memory. `cargo bench -p slideline-cli`.
//!
//! Memory is what the system's `time` says of the child; without `/usr/bin/time`
//! only times are measured.

// a bench that cannot run the program has nothing to measure
#![allow(clippy::expect_used, clippy::panic)]

use criterion::{Criterion, criterion_group, criterion_main};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const PROGRAM: &str = env!("CARGO_BIN_EXE_slideline");
const TIME: &str = "/usr/bin/time";
const DECKS: [&str; 4] = ["irs_coarse", "irs_fine", "isl_coarse", "isl_coarse_mu03"];

fn deck(name: &str) -> PathBuf {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/diehl1995");
    corpus.join(name).with_extension("inp")
}

/// `run DECK --out FOLDER --quiet --no-html` behind `program`.
fn command(program: &str, before: &[&str], name: &str, folder: &Path) -> Command {
    let mut command = Command::new(program);
    command.args(before).arg("run").arg(deck(name)).arg("--out").arg(folder);
    command.args(["--quiet", "--no-html"]).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

/// Largest resident memory of five runs [kB].
fn memory(name: &str, folder: &Path) -> Option<u64> {
    let once = || {
        let output = command(TIME, &["-f", "%M", PROGRAM], name, folder)
            .stderr(Stdio::piped())
            .output()
            .ok()?;
        let said = String::from_utf8(output.stderr).ok()?;
        said.lines().last()?.trim().parse().ok()
    };
    (0..5).map(|_| once()).max().flatten()
}

fn process(c: &mut Criterion) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("bench_process");
    std::fs::create_dir_all(&folder).expect("the folder of results");
    let mut group = c.benchmark_group("process");
    for name in DECKS {
        match memory(name, &folder) {
            Some(peak) => println!("process/{name}: peak memory {:.1} MB", peak as f64 / 1024.0),
            None => println!("process/{name}: peak memory not measured, {TIME} is missing"),
        }
        group.bench_function(name, |b| {
            b.iter(|| {
                let status = command(PROGRAM, &[], name, &folder).status();
                assert!(status.is_ok_and(|status| status.success()), "{name}");
            });
        });
    }
    group.finish();
}

criterion_group!(benches, process);
criterion_main!(benches);
