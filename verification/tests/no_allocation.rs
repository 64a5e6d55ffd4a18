//! The Newton loop allocates nothing after its first iteration.
//!
//! Requirement: architecture, "Model, Plan, Workspace". Counted are all
//! allocations of the process between one iteration's report and the next one
//! of the same increment; the observer itself only writes into room it has
//! already. No tolerance: zero.

use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop};
use slideline_verification::{Method, Push, paper};
use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};
use std::alloc::System;
use std::ops::ControlFlow;

#[global_allocator]
static COUNTER: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// (increment, iteration, allocations since the report before).
struct Count {
    between: Vec<(usize, usize, usize)>,
    before: usize,
}

impl Observer for Count {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Iteration(report) = event {
            let stats = COUNTER.stats();
            let now = stats.allocations + stats.reallocations;
            self.between.push((report.increment, report.iteration, now - self.before));
            self.before = now;
        }
        ControlFlow::Continue(())
    }
}

// One test alone in its process: tests side by side would count one another.
#[test]
fn nothing_from_the_second_iteration_on() {
    let friction = Push { mu: 0.3, ..Push::paper(Method::Isl) }.deck();
    let decks = [
        ("IRS coarse", paper::IRS_COARSE),
        ("IRS fine", paper::IRS_FINE),
        ("ISL coarse", paper::ISL_COARSE),
        ("ISL coarse with friction", &friction),
    ];
    for (name, deck) in decks {
        let model = Job::read_text("count", deck, &ReadOptions::default()).model.unwrap();
        let mut count = Count { between: Vec::with_capacity(10_000), before: 0 };
        slideline::solve(&model, &SolveOptions::default(), &mut count);
        let later: Vec<_> =
            count.between.iter().filter(|(_, iteration, _)| *iteration > 1).collect();
        let guilty: Vec<_> = later.iter().filter(|(_, _, allocations)| *allocations > 0).collect();
        let sum: usize = guilty.iter().map(|(_, _, allocations)| allocations).sum();
        assert!(!later.is_empty());
        assert!(
            guilty.is_empty(),
            "{name}: {sum} allocations in {} of {} iterations, such as (increment, iteration, \
             allocations) {:?}",
            guilty.len(),
            later.len(),
            &guilty[..guilty.len().min(5)]
        );
    }
}
