//! The state in which a model starts, without solving anything.

use slideline_mech::contact::pair::Body;
use slideline_model::{Formulation, Master, Model};
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
    if let (Some(start), None) = (&mut first.0, from) {
        add_gaps_of_nodes(model, start);
    }
    first.0
}

/// Integrated contact is evaluated near the zone of contact alone. Before
/// anything moves the gap of every other slave node is its distance from the
/// rigid surface.
fn add_gaps_of_nodes(model: &Model, start: &mut InitialGaps) {
    for (place, pair) in model.contact_pairs.iter().enumerate() {
        let (Formulation::SurfaceToSurface, Master::RigidSurface(surface)) =
            (pair.formulation, &pair.master)
        else {
            continue;
        };
        let Some(shape) = slideline_solve::rigid_surface(surface) else { continue };
        let profile = pair.profile.as_ref().and_then(slideline_solve::rigid_surface);
        let nearest = profile.and_then(|profile| shape.overclosure_of(&profile));
        let body = Body { reference: model.nodes.position(surface.reference), dofs: [0.0; 3] };
        let rows = start.points.iter_mut().filter(|row| row.pair == place);
        for row in rows.filter(|row| row.opening == f64::INFINITY) {
            let of_node = || shape.overclosure(&body, row.position);
            let overclosure = if pair.profile.is_some() { nearest } else { of_node() };
            if let Some(overclosure) = overclosure {
                row.opening = -overclosure;
            }
        }
    }
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
