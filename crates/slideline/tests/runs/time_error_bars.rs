//! Error bars in time: what the increments of a run cost in its reactions.
//!
//! Source: docs/theory.md, section 12.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::{Ending, Event, Observer, Stop};
use slideline::{Job, Quiet, Reactions, ReadOptions, SolveOptions, solve, time_error_bars};
use std::ops::ControlFlow;
use std::path::Path;

/// RF2 of node 9999 by total time.
#[derive(Default)]
struct Force(Vec<[f64; 2]>);

impl Observer for Force {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let node = frame.model.nodes.find(9999).unwrap();
            self.0.push([frame.total_time, frame.nodal.reaction(node, Dof::U2)]);
        }
        ControlFlow::Continue(())
    }
}

/// A deck of the paper in so many increments.
fn deck(name: &str, increments: u32) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/diehl1995");
    let text = std::fs::read_to_string(path.join(format!("{name}.inp"))).unwrap();
    let dt = 1.0 / f64::from(increments);
    let seen = text.contains("0.05, 1.0, 1.0E-6, 0.05");
    assert!(seen, "{name}");
    text.replace("0.05, 1.0, 1.0E-6, 0.05", &format!("{dt}, 1.0, 1.0E-6, {dt}"))
        .replace("INC=100", "INC=1000")
}

fn forces(text: &str) -> Vec<[f64; 2]> {
    let model = Job::read_text("deck", text, &ReadOptions::default()).model.unwrap();
    let mut force = Force::default();
    let ending = solve(&model, &SolveOptions::default(), &mut force);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
    force.0
}

/// (force, bar) of every increment.
fn with_bars(text: &str) -> Vec<[f64; 2]> {
    let model = Job::read_text("deck", text, &ReadOptions::default()).model.unwrap();
    let mut found = Reactions::of(&model);
    let options = SolveOptions::default();
    let ending = solve(&model, &options, &mut found.watch(&mut Quiet));
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
    let bars = time_error_bars(&model, &found, &options, &mut Quiet).unwrap();
    let bars = bars.of(9999, Dof::U2).unwrap();
    forces(text).iter().zip(bars).map(|([_, force], &bar)| [*force, bar]).collect()
}

/// Requirement: the bars of two increments over the stroke hold the distance
/// to 200, with friction, and do not exceed it a hundredfold.
#[test]
fn two_increments_have_bars_that_hold_the_distance_to_two_hundred() {
    for name in ["surface_coarse_mu03", "isl_coarse_mu03"] {
        let fine = forces(&deck(name, 200));
        let peak = fine.iter().fold(0.0, |most: f64, [_, force]| most.max(force.abs()));
        for (k, [force, bar]) in with_bars(&deck(name, 2)).into_iter().enumerate() {
            let error = (force - fine[100 * (k + 1) - 1][1]).abs();
            assert!(error <= bar, "{name} {k}: {error} {bar}");
            assert!(bar <= 100.0 * error.max(1e-3 * peak), "{name} {k}: {error} {bar}");
        }
    }
}

/// Requirement: without friction an increment ends in an equilibrium that
/// does not depend on the way there; bars are what the criterion of
/// convergence leaves, half a percent of the peak at most.
#[test]
fn without_friction_the_way_costs_nothing() {
    for name in ["surface_coarse", "isl_coarse"] {
        let rows = with_bars(&deck(name, 20));
        let peak = rows.iter().fold(0.0, |most: f64, [force, _]| most.max(force.abs()));
        let most = rows.iter().fold(0.0, |most: f64, [_, bar]| most.max(*bar));
        assert!(rows.len() == 20 && most < 5e-3 * peak, "{name}: {most} of {peak}");
    }
}
