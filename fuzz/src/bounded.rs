//! A run that ends: small models, so many iterations.

use slideline::model::Model;
use slideline::observe::{Event, Observer, Stop};
use std::ops::ControlFlow;

/// Models with more of anything are not run.
const NODES: usize = 60;
/// Iterations after which the run is stopped.
const ITERATIONS: usize = 120;

/// Whether a model is small enough to be run.
pub fn is_small(model: &Model) -> bool {
    let beams = model.blocks.iter().filter_map(|block| block.beams());
    model.nodes.len() <= NODES
        && beams.map(|beams| beams.elements.len()).sum::<usize>() <= NODES
        && model.contact_pairs.len() <= 4
        && model.steps.len() <= 4
}

/// Stops after so many iterations and objects to numbers that are none.
#[derive(Default)]
pub struct Bounded {
    iterations: usize,
}

impl Observer for Bounded {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Iteration(_) => self.iterations += 1,
            Event::Committed(frame) => {
                let contact = frame.contact.iter().map(|row| row.pressure + row.opening);
                for number in contact {
                    assert!(!number.is_nan(), "a committed contact point holds NaN");
                }
            }
            _ => {}
        }
        let go_on = self.iterations < ITERATIONS;
        if go_on { ControlFlow::Continue(()) } else { ControlFlow::Break(Stop::Interrupted) }
    }
}
