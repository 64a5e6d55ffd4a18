//! An element of the embedding program with a state of its own: the example's own.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

#[allow(dead_code)] // its main is not called here
#[path = "../../examples/user_element.rs"]
mod example;

use example::{Rows, model};
use slideline::observe::Ending;
use slideline::{Checkpoint, Event, Observer, SolveOptions, Stop, resume, solve};
use std::ops::ControlFlow;

/// Requirement: a bar that has yielded keeps its plastic strain: pulled to 0.02 and back, the
/// stress ends where elastic unloading from the limit leads. Source: closed form, yield strain
/// 0.005; the elastic beam beside it adds E A e = 10 e. Tolerance: 1e-9, the residual's.
#[test]
fn a_yielding_bar_remembers() {
    let model = model().unwrap();
    let mut rows = Rows::default();
    let ending = solve(&model, &SolveOptions::default(), &mut rows);
    let Ending::Completed(totals) = ending else { panic!("{ending:?}") };
    assert_eq!((totals.increments, totals.cutbacks, rows.0.len()), (20, 0, 20));
    let mut plastic = 0.0_f64;
    for (place, [u, force, stress, told]) in rows.0.into_iter().enumerate() {
        let exact = (2000.0 * (u - plastic)).clamp(-10.0, 10.0);
        plastic = u - exact / 2000.0;
        let step = if place < 10 { place + 1 } else { 19 - place };
        assert!((u - 0.002 * step as f64).abs() < 1e-15, "{place} {u}");
        assert!((stress - exact).abs() < 1e-11 && (told - plastic).abs() < 1e-14, "{place}");
        assert!((force - (0.05 * exact + 10.0 * u)).abs() < 1e-9, "{place}: {force}");
    }
    assert!((plastic - 0.005).abs() < 1e-14, "yielded back: {plastic}");
}

/// Requirement: a run that goes on from a checkpoint has the state of the bar, bit for bit; a
/// checkpoint whose states are of another number is refused.
#[test]
fn the_state_of_a_bar_is_restarted() {
    struct Keep(Option<Checkpoint<'static>>, usize);
    impl Observer for Keep {
        fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
            if let Event::Checkpoint(checkpoint) = event
                && (checkpoint.step, checkpoint.increment) == (1, self.1)
            {
                self.0 = Some(checkpoint.owned());
            }
            ControlFlow::Continue(())
        }
    }
    let model = model().unwrap();
    let options = SolveOptions::default();
    let mut whole = Rows::default();
    solve(&model, &options, &mut whole);
    let mut kept = Keep(None, 7);
    solve(&model, &options, &mut kept);
    let mut rest = Rows::default();
    let checkpoint = kept.0.unwrap();
    resume(&model, &options, checkpoint.clone(), &mut rest).unwrap();
    assert_eq!(whole.0[7..], rest.0[..]);
    assert!(rest.0.last().unwrap()[3] != 0.0);
    let mut other = model.clone();
    other.blocks[1].elements.push(101, &[0, 1], model.nodes.get(0).origin);
    assert!(resume(&other, &options, checkpoint, &mut Rows::default()).is_none());
}
