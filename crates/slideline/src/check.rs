//! The state in which a model starts, without solving anything.

use slideline_model::Model;
use slideline_solve::Checkpoint;
use slideline_solve::observe::{ContactRow, Event, Observer, Stop};
use std::ops::ControlFlow;

/// A model's contact points before anything moves.
#[derive(Clone, Debug, Default)]
pub struct InitialGaps {
    /// One row per contact point of every pair, in order.
    pub points: Vec<ContactRow>,
    /// The echo of what was understood, as in the printed output.
    pub echo: String,
    /// Number of equations.
    pub equations: usize,
}

/// Begins a run, from the state of an earlier job where there is one, takes
/// note of how it starts, and ends it there. `None` where the solver refuses
/// the model.
pub fn initial_gaps(
    model: &Model,
    options: &slideline_solve::Options,
    from: Option<&Checkpoint<'_>>,
) -> Option<InitialGaps> {
    let mut first = First(None);
    // Ended by us, on purpose.
    let _ = match from {
        None => Some(slideline_solve::run(model, options, &mut first)),
        Some(from) => slideline_solve::run_from(model, options, from, &mut first),
    };
    first.0
}

struct First(Option<InitialGaps>);

impl Observer for First {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::StepBegin(report) = event {
            self.0 = Some(InitialGaps {
                points: report.start.contact.to_vec(),
                echo: slideline_output::echo::model_echo(report.model, &report.start),
                equations: report.equations,
            });
        }
        ControlFlow::Break(Stop::Interrupted)
    }
}
