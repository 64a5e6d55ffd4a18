//! The whole analysis: steps, increments, commits.

pub(crate) mod analysis;
mod committing;
mod initial_stress;
mod jump;
mod model_change;
mod neighbours;
mod opening;
pub(crate) mod options;
mod overpulled_beams;
mod recovery;
mod released_moments;
mod sensitivities;
mod shown;
mod sliding_off;
mod steps;
mod strayed;
mod telling;
mod turned_means;

use crate::checkpoint::Checkpoint;
use crate::observe::reports::Totals;
use crate::observe::{Ending, Observer};
use crate::plan::{Plan, PlanMismatch};
use crate::workspace::Workspace;
pub use options::{Options, TangentCheck};
use slideline_diag::{Code, Diagnostic};
use slideline_model::Model;

/// Runs every step of a model and tells the observer.
pub fn run(model: &Model, options: &Options, observer: &mut dyn Observer) -> Ending {
    let run = Workspace::new(&Plan::of(model), options).run(model, observer);
    run.unwrap_or_else(|mismatch| impossible(&mismatch))
}

/// Goes on from a checkpoint of the same model and tells the observer; the
/// step it stands in begins anew for the observer, as resumed. `None` where
/// the checkpoint is not one of this model: nothing was told.
pub fn resume(
    model: &Model,
    options: &Options,
    from: Checkpoint<'static>,
    observer: &mut dyn Observer,
) -> Option<Ending> {
    go_on(model, options, &from, observer, (from.totals, true))
}

/// Walks what a model has behind a checkpoint, as a run of its own: the rest
/// of its step, where there is one, and the steps after it. Increments and
/// iterations count from zero, time and energies go on. `None` where the
/// checkpoint is not one of this model: nothing was told.
pub fn run_from(
    model: &Model,
    options: &Options,
    from: &Checkpoint<'_>,
    observer: &mut dyn Observer,
) -> Option<Ending> {
    let totals = Totals { dropped_points: from.totals.dropped_points, ..Totals::default() };
    go_on(model, options, from, observer, (totals, false))
}

/// The increments behind a checkpoint; `counts`: the totals so far, and whether the observer
/// has seen what came before.
fn go_on(
    model: &Model,
    options: &Options,
    from: &Checkpoint<'_>,
    observer: &mut dyn Observer,
    counts: (Totals, bool),
) -> Option<Ending> {
    if !from.fits(model) {
        return None;
    }
    let run = Workspace::new(&Plan::of(model), options).go_on(model, from, observer, counts);
    Some(run.unwrap_or_else(|mismatch| impossible(&mismatch)))
}

/// A model that is not of its own plan: a fault of this program.
fn impossible(mismatch: &PlanMismatch) -> Ending {
    let said = Diagnostic::error(Code("SL0901"), mismatch.to_string());
    Ending::NotConverged(Totals::default(), said)
}
