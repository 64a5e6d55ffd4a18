//! The Newton loop allocates nothing after its first iteration.
//!
//! Counted are all allocations of the process between one iteration's report
//! and the next one of the same increment, so that this is measured before
//! there are other threads; the observer itself only writes into room it has
//! already.

use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop};
use slideline_verification::{Claim, Group, Method, Push, Record, paper};
use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};
use std::alloc::System;
use std::ops::ControlFlow;
use std::sync::OnceLock;

pub const GROUP: Group = Group {
    file: "no_allocation",
    claims: &[Claim {
        name: "nothing_from_the_second_iteration_on",
        requirement: "From the second iteration of an increment on, Newton allocates no memory.",
        source: "The design of the solver: scratch belongs to a workspace that is made once.",
        tolerance: "None: zero.",
        measure: nothing_from_the_second_iteration_on,
    }],
};

#[global_allocator]
static COUNTER: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Solids with a pressure that follows its faces.
const PRESSED: &str = "*NODE
1, 0.0, 0.0
2, 1.0, 0.0
3, 2.0, 0.0
4, 0.0, 1.0
5, 1.0, 1.0
6, 2.0, 1.0
*ELEMENT, TYPE=CPE4, ELSET=BLOCK
1, 1, 2, 5, 4
2, 2, 3, 6, 5
*SOLID SECTION, ELSET=BLOCK, MATERIAL=SOFT
1.0
*MATERIAL, NAME=SOFT
*ELASTIC
100.0, 0.3
*STEP, NLGEOM
*STATIC
0.5, 1.0, 0.1, 0.5
*BOUNDARY
1, 1, 2
4, 1, 2
*DLOAD
BLOCK, P3, 3.0
*END STEP
";

/// Of a deck: later iterations, and allocations in them.
static COUNTS: OnceLock<Vec<(&str, usize, usize)>> = OnceLock::new();

/// Allocations of the process so far.
pub fn allocations() -> usize {
    let stats = COUNTER.stats();
    stats.allocations + stats.reallocations
}

/// (iteration, allocations since the report before).
struct Count {
    between: Vec<(usize, usize)>,
    before: usize,
}

impl Observer for Count {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Iteration(report) = event {
            let now = allocations();
            self.between.push((report.iteration, now - self.before));
            self.before = now;
        }
        ControlFlow::Continue(())
    }
}

/// Counts; to be called while no other thread runs.
pub fn count() {
    let friction = Push { mu: 0.3, ..Push::paper(Method::Isl) }.deck();
    let decks = [
        ("IRS, 24 B21", paper::IRS_COARSE),
        ("IRS, 99 B21", paper::IRS_FINE),
        ("ISL, 24 B21", paper::ISL_COARSE),
        ("ISL, 24 B21, mu 0.3", &friction),
        ("CPE4, pressed", PRESSED),
    ];
    let counted = decks.map(|(name, deck)| {
        let model = Job::read_text("count", deck, &ReadOptions::default()).model.unwrap();
        let mut count = Count { between: Vec::with_capacity(10_000), before: 0 };
        slideline::solve(&model, &SolveOptions::default(), &mut count);
        let later = count.between.iter().filter(|(iteration, _)| *iteration > 1);
        (name, later.clone().count(), later.map(|(_, allocations)| allocations).sum())
    });
    COUNTS.get_or_init(|| counted.to_vec());
}

fn nothing_from_the_second_iteration_on(record: &mut Record) {
    for (name, later, allocations) in COUNTS.get().unwrap() {
        record.at_least(format!("{name}: later iterations"), *later as f64, 1.0);
        record.equal(format!("{name}: allocations in them"), *allocations, 0);
    }
}
