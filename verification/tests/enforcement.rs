//! How contact is enforced changes nothing but the cost.
//!
//! Requirement: the condensed contact problem solved with its matrix and without it leads to the
//! same increments, the same number of iterations and, converged to R_n = 1e-10, the same
//! reactions to 1e-9 of the largest: for soft and hard laws, elastic and exact stick, on rigid
//! and deforming masters, at nodes and integrated. Source: theory 8.14.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::{Enforcement, Job, Quiet, ReadOptions, RunOptions, SolveOptions, Status, run};
use slideline_verification::many_points::{HARD, SOFT, beam_on_beam, beam_on_flat};
use std::fmt::Write;
use std::path::Path;

/// Reactions and iterations of a deck.
struct Found {
    reactions: Vec<f64>,
    iterations: usize,
    text: String,
}

fn solve(name: &str, deck: &str, enforcement: Option<Enforcement>) -> Found {
    let way = enforcement.map_or("by_size", Enforcement::word);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("enforcement").join(name).join(way);
    let _ = std::fs::remove_dir_all(&folder);
    let read = Job::read_text(name, deck, &ReadOptions::default());
    assert!(read.model.is_some(), "{:?}", read.diagnostics);
    let solve = SolveOptions { enforcement, ..SolveOptions::default() };
    let options = RunOptions { folder: Some(folder.clone()), solve, ..RunOptions::default() };
    assert_eq!(run(&read, &options, &mut Quiet).status, Status::Completed, "{name} {way}");
    let file = |end: &str| std::fs::read_to_string(folder.join(format!("{name}.{end}"))).unwrap();
    let history = file("history.csv");
    let columns: Vec<&str> = history.lines().next().unwrap().split(',').collect();
    let wanted: Vec<usize> = (0..columns.len()).filter(|&k| columns[k].starts_with("RF")).collect();
    let row = |line: &str| -> Vec<f64> {
        let fields: Vec<&str> = line.split(',').collect();
        wanted.iter().map(|&k| fields[k].parse().unwrap_or(0.0)).collect()
    };
    let text = file("msg");
    Found {
        reactions: history.lines().skip(1).flat_map(row).collect(),
        iterations: text.lines().filter(|line| line.contains("ITERATION ")).count(),
        text,
    }
}

fn agree(name: &str, deck: &str) {
    let dense = solve(name, deck, Some(Enforcement::Dense));
    let free = solve(name, deck, Some(Enforcement::MatrixFree));
    assert!(!dense.text.contains("matrix-free") && free.text.contains("matrix-free"), "{name}");
    assert_eq!(dense.reactions.len(), free.reactions.len(), "{name}");
    let largest = dense.reactions.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
    let pairs = dense.reactions.iter().zip(&free.reactions);
    let off = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest;
    assert!(off <= 1e-9, "{name}: {off:.1e} of the largest reaction");
    let (a, b) = (dense.iterations, free.iterations);
    assert!(b <= a + a / 20 + 1, "{name}: {b} iterations instead of {a}");
}

/// Residual tolerance 1e-10 in every step.
fn tight(deck: &str) -> String {
    let mut text = String::new();
    let mut in_static = false;
    for line in deck.lines() {
        if in_static && line.starts_with('*') {
            text.push_str("*CONTROLS, PARAMETERS=FIELD\n1E-10\n");
        }
        in_static = (in_static && !line.starts_with('*')) || line.starts_with("*STATIC");
        writeln!(text, "{line}").unwrap();
    }
    text
}

macro_rules! paper {
    ($($name:ident),*) => {$(
        #[test]
        fn $name() {
            let name = stringify!($name);
            let path = Path::new(env!("CARGO_MANIFEST_DIR"))
                .join("../corpus/diehl1995").join(name).with_extension("inp");
            agree(name, &tight(&std::fs::read_to_string(path).unwrap()));
        }
    )*};
}

paper!(
    irs_coarse_mu03,
    irs_coarse_mu03_lagrange,
    isl_coarse,
    isl_coarse_mu03_lagrange,
    isl_coarse_push_pull_mu03,
    cam_isl_4deg_mu03,
    surface_coarse_mu03
);

#[test]
fn many_soft_points() {
    agree("soft", &tight(&beam_on_flat(150, SOFT, None)));
    agree("soft_friction", &tight(&beam_on_flat(110, SOFT, Some(0.2))));
}

#[test]
fn many_hard_points() {
    agree("hard", &tight(&beam_on_flat(120, HARD, None)));
    agree("hard_friction", &tight(&beam_on_flat(90, HARD, Some(0.2))));
}

/// Requirement: a master with so many parts that only those near enter the pattern gives what one
/// with all of them does: the same increments as the dense way finds, on both sides of that size.
#[test]
fn beams_on_beams() {
    agree("beams", &beam_on_beam(90));
    agree("beams_selective", &beam_on_beam(108));
}

/// Requirement: without being told, large problems are solved without the matrix and small ones
/// with it.
#[test]
fn the_size_decides() {
    assert!(
        solve("large", &beam_on_flat(150, SOFT, None), None).text.contains("contact matrix-free")
    );
    assert!(
        !solve("small", &beam_on_flat(50, SOFT, None), None).text.contains("contact matrix-free")
    );
}
