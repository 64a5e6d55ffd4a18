//! How many analyses a second one core makes, without files:
//! `cargo run --release -p slideline-verification --example analyses_a_second`.

use slideline::{Job, Model, Plan, Quiet, ReadOptions, SolveOptions, Workspace, solve};
use slideline_verification::{Method, Push};
use std::hint::black_box;
use std::time::Instant;

/// Least time of five rounds of `count` analyses, for one [s].
fn least(count: usize, mut analysis: impl FnMut(usize)) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..5 {
        let begin = Instant::now();
        (0..count).for_each(&mut analysis);
        best = best.min(begin.elapsed().as_secs_f64() / count as f64);
    }
    best
}

/// Other friction, thickness and stroke for every case.
fn vary(model: &mut Model, case: usize) {
    let part = (case % 17) as f64 / 17.0;
    for block in &mut model.blocks {
        if let slideline::model::Section::Beam(section) = &mut block.section
            && let slideline::model::Shape::Rectangle { height, .. } = &mut section.shape
        {
            *height = 1.5e-3 * (1.0 + 0.02 * part);
        }
    }
    for pair in &mut model.contact_pairs {
        if let slideline::model::Friction::Coulomb { coefficient, .. } =
            &mut pair.interaction.friction
        {
            *coefficient = 0.3 - 0.05 * part;
        }
    }
}

fn main() {
    let rounds = std::env::args().nth(1).and_then(|n| n.parse().ok()).unwrap_or(200_usize);
    let deck = Push { mu: 0.3, ..Push::paper(Method::Isl) }.deck();
    let read = Job::read_text("isl", &deck, &ReadOptions::default());
    let Some(mut model) = read.model else { return };
    let options = SolveOptions::default();
    let fresh = least(rounds, |_| {
        black_box(solve(black_box(&model), &options, &mut Quiet));
    });
    let mut workspace = Workspace::new(&Plan::of(&model), &options);
    let again = least(rounds, |_| {
        let _ = black_box(workspace.run(black_box(&model), &mut Quiet));
    });
    let varied = least(rounds, |case| {
        vary(&mut model, case);
        let _ = black_box(workspace.run(black_box(&model), &mut Quiet));
    });
    for (name, time) in [("fresh", fresh), ("again", again), ("again, model changed", varied)] {
        println!("{name:22} {:.3} ms, {:.0} a second", 1e3 * time, 1.0 / time);
    }
}
