//! `slideline report`: from the result files to `JOB.html`, and the peak memory
//! of it. `cargo bench -p slideline-cli --bench report`.
//!
//! ```text
//!   o--o--o--o--o--o--o     every node of a beam stays closed on a plane
//!   ===================     that slides along it: as many rows of contact
//!           --->            as nodes times increments
//! ```
//!
//! The largest deck has 1000 elements and 1000 increments (170 MB of contact
//! history); the smallest is the paper's, 24 elements and 20 increments.

// a bench that cannot run the program has nothing to measure
#![allow(clippy::expect_used, clippy::panic)]

mod common;

use criterion::{Criterion, criterion_group, criterion_main};
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// The deck of the drawing.
fn flat(elements: usize, increments: usize) -> String {
    format!(
        "*NODE, NSET=BEAM\n1, 0.0, 0.0\n{last}, 1.0, 0.0\n*NGEN, NSET=BEAM\n1, {last}, 1\n\
         *ELEMENT, TYPE=B21, ELSET=BEAM\n1, 1, 2\n*ELGEN, ELSET=BEAM\n1, {elements}, 1, 1\n\
         *BEAM SECTION, ELSET=BEAM, SECTION=RECT, MATERIAL=M\n25.0E-3, 1.5E-3\n\
         *MATERIAL, NAME=M\n*ELASTIC\n6.9E9, 0.3\n*NODE\n9999, 0.5, -0.1\n\
         *SURFACE, NAME=PLANE, TYPE=SEGMENTS\nSTART, -1.0, 0.0\nLINE, 2.0, 0.0\n\
         *RIGID BODY, REF NODE=9999, ANALYTICAL SURFACE=PLANE\n\
         *SURFACE, NAME=BEAM, TYPE=ELEMENT\nBEAM, SNEG\n\
         *SURFACE INTERACTION, NAME=S\n25.0E-3\n*FRICTION\n0.3\n\
         *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1.0E9\n\
         *CONTACT PAIR, INTERACTION=S, TYPE=NODE TO SURFACE, NO THICKNESS\nBEAM, PLANE\n\
         *STEP, NLGEOM, INC=2000\nSLIDE\n*STATIC, DIRECT\n{size}, 1.0\n*BOUNDARY\n\
         1, 1, 6\nBEAM, 1, 2\n9999, 6\n9999, 1, 1, 0.3\n9999, 2, 2, 1.0E-5\n*END STEP\n",
        last = elements + 1,
        size = 1.0 / increments as f64,
    )
}

/// Runs a deck in a folder of its own; returns the job.
fn results(name: &str, deck: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("bench_report");
    std::fs::create_dir_all(&folder).expect("the folder of results");
    let job = folder.join(name);
    let path = job.with_extension("inp");
    std::fs::write(&path, deck).expect("the deck");
    let words = ["run", "--quiet", "--no-html"].map(OsString::from);
    common::run(&words.into_iter().chain([path.into_os_string()]).collect::<Vec<_>>());
    job
}

fn report(c: &mut Criterion) {
    let paper = include_str!("../../../corpus/diehl1995/isl_coarse_mu03.inp").to_owned();
    let decks = [
        ("paper_20", paper),
        ("flat_100_100", flat(100, 100)),
        ("flat_1000_1000", flat(1000, 1000)),
    ];
    let mut group = c.benchmark_group("report");
    group.sample_size(10);
    for (name, deck) in decks {
        let job = results(name, &deck);
        let arguments = [OsString::from("report"), job.clone().into_os_string()];
        common::run(&arguments);
        let size = std::fs::metadata(job.with_extension("html")).map_or(0, |file| file.len());
        println!("report/{name}: {:.2} MB", size as f64 / 1e6);
        common::tell_memory(&format!("report/{name}"), &arguments);
        group.bench_function(name, |b| b.iter(|| common::run(&arguments)));
    }
    group.finish();
}

criterion_group!(benches, report);
criterion_main!(benches);
