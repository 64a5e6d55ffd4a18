//! What contact costs as its points grow, without files:
//! `cargo run --release -p slideline-verification --example many_points`.
//!
//! Prints processor time by case and number of points, the exponent of the growth
//! from one size to the next, and the largest memory so far. Targets: 1,000 closed
//! points without friction in 0.3 s for 14 iterations, 5,000 with friction in 3 s,
//! no steeper than n^1.3, two beams of 1,000 points in 60 MB.

use slideline::observe::{Event, Observer, Stop};
use slideline::{Job, ReadOptions, SolveOptions, solve};
use slideline_verification::many_points::{HARD, SOFT, beam_on_beam, beam_on_flat};
use std::ops::ControlFlow;
use std::time::Instant;

/// Counts iterations and points.
#[derive(Default)]
struct Count {
    iterations: usize,
    closed: usize,
}

impl Observer for Count {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Iteration(report) = event {
            self.iterations += 1;
            self.closed = report.closed;
        }
        ControlFlow::Continue(())
    }
}

/// Largest memory of the process [MB], where the system tells.
fn memory() -> f64 {
    let text = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kib = line.and_then(|line| line.trim().trim_end_matches("kB").trim().parse::<f64>().ok());
    kib.unwrap_or(f64::NAN) / 1024.0
}

fn main() {
    type Make = fn(usize) -> String;
    let cases: [(&str, Make); 4] = [
        ("two beams, friction", beam_on_beam),
        ("flat, soft", |n| beam_on_flat(n, SOFT, None)),
        ("flat, soft, friction", |n| beam_on_flat(n, SOFT, Some(0.2))),
        ("flat, hard", |n| beam_on_flat(n, HARD, None)),
    ];
    let sizes: Vec<usize> = match std::env::args().nth(1).and_then(|most| most.parse().ok()) {
        Some(most) => vec![most],
        None => vec![50, 200, 1000, 5000],
    };
    println!(
        "case                    nodes  closed  iterations   seconds  per iteration  growth  MB"
    );
    for (name, make) in cases {
        let mut last: Option<(usize, f64)> = None;
        for &nodes in &sizes {
            let read = Job::read_text("many", &make(nodes), &ReadOptions::default());
            let Some(model) = &read.model else { continue };
            let mut count = Count::default();
            let begin = Instant::now();
            let ending = solve(model, &SolveOptions::default(), &mut count);
            let seconds = begin.elapsed().as_secs_f64();
            let each = seconds / count.iterations.max(1) as f64;
            let growth =
                last.map_or(f64::NAN, |(n, t)| (each / t).ln() / (nodes as f64 / n as f64).ln());
            last = Some((nodes, each));
            let done = matches!(ending, slideline::observe::Ending::Completed(_));
            println!(
                "{name:22} {nodes:6} {:7} {:11} {seconds:9.4} {each:14.6} {growth:7.2} {:3.0}{}",
                count.closed,
                count.iterations,
                memory(),
                if done { "" } else { "  NOT COMPLETED" },
            );
        }
    }
}
