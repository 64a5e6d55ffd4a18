//! Energy that an increment leaves over: a jump, or a force that changes more
//! between two increments than the trapezoidal rule can follow.
//!
//! ```text
//!   load |      ___ o - - - - - -> o     halves, and the half again that
//!        |    /      \           /       leaves more over: what the rule
//!        |  /          \_______/         misses fades, what a jump
//!        '------------------------- u    releases stays
//! ```
//!
//! docs/theory.md section 10.

mod part;
mod search;

use super::analysis::{Analysis, Left};
use crate::account::rounding;
use crate::books::{Books, Sudden};
use crate::newton::Scratch;
use crate::newton::recall_points;
use crate::observe::Event;
use crate::problem::Problem;
use crate::stabilise;
use crate::target::Target;
use search::{NOTABLE, find};
use slideline_diag::{Code, Diagnostic, Place};

/// Part of the energy of its own increment from which on it is.
const SHARP: f64 = 0.02;
/// Part of the energy turned over that a run may leave unbalanced unsaid.
const MUCH: f64 = 0.2;
/// Part of the energy that the parts store which one increment may miss unsaid.
const MISSED: f64 = 0.5;

impl Analysis<'_> {
    /// Enters what the increment that was just committed left over into the
    /// sums of its step. Where it jumped, what the jump released is counted
    /// apart, and said.
    pub(super) fn balance_books(
        &mut self,
        plan: &Problem<'_>,
        target: &Target,
        work: &mut Scratch,
    ) -> Option<Diagnostic> {
        // The dashpots of stabilisation hold what would fall: no equilibrium
        // path that energies could be held against.
        let stabilised = stabilise::settings(plan, self.committed).is_some();
        let books = self.committed.books;
        if stabilised || books.left.abs() <= rounding(plan, self.committed) {
            self.committed.books.left = 0.0;
        }
        let own = books.turned_over - self.trial.books.turned_over;
        // a jump releases energy: what gains some is none
        let left = self.committed.books.left;
        let looked_for = left > NOTABLE * books.turned_over && left > SHARP * own;
        let jump = looked_for.then(|| find(plan, (self.trial, self.committed), target, work));
        if looked_for {
            recall_points(self.committed, work);
        }
        let said = jump.flatten().map(|jump| {
            jump.enter(self.trial, self.committed);
            jump.told(plan, target, self.committed)
        });
        self.committed.books.enter(target);
        said
    }

    /// Says so where the increments of the run left much energy unbalanced, or one of them most of
    /// what the parts store.
    pub(super) fn judge_balance(
        &mut self,
        plan: &Problem<'_>,
        target: &Target,
    ) -> Result<(), Left> {
        if target.step < plan.model.steps.len() {
            return Ok(());
        }
        let books = self.committed.books;
        // a model that is back where it began has rounded on its way
        let much = MUCH * books.turned_over + books.unsure;
        let said = if books.unbalanced() > much {
            unbalanced(plan, &books)
        } else if books.missed() > MISSED && books.sudden.missed > books.unsure {
            stepped_over(plan, &books)
        } else {
            return Ok(());
        };
        said.map_or(Ok(()), |said| self.tell(Event::Diagnosed(&said)))
    }
}

/// Energy of the whole run that does not balance.
fn unbalanced(plan: &Problem<'_>, books: &Books) -> Option<Diagnostic> {
    let unbalanced = books.unbalanced();
    let [step, increment] = books.worst_at;
    let message = format!(
        "energy does not balance: the error is {unbalanced:.3e}, {:.0} % of the energy converted, \
         most of it ({:.3e}) in increment {increment} of step {step}: forces change more within an \
         increment than its two ends show, and work and peak forces are not reliable",
        100.0 * unbalanced / books.turned_over,
        books.worst,
    );
    with_shorter_increments(plan, message, (step, books.worst_dt))
}

/// An increment that holds what the step is about.
fn stepped_over(plan: &Problem<'_>, books: &Books) -> Option<Diagnostic> {
    let Sudden { missed, at: [step, increment], dt } = books.sudden;
    let message = format!(
        "energy does not balance: increment {increment} of step {step} leaves {missed:.3e} of it open, \
         {:.0} % of what the parts store: it loads or unloads them at once, its two \
         ends do not show the force between them, and work and peak forces are not reliable",
        100.0 * books.missed(),
    );
    with_shorter_increments(plan, message, (step, dt))
}

/// The warning, with increments of a quarter of a length.
fn with_shorter_increments(
    plan: &Problem<'_>,
    message: String,
    (step, length): (usize, f64),
) -> Option<Diagnostic> {
    let of_it = plan.model.steps.get(step.checked_sub(1)?)?;
    let procedure = &of_it.procedure;
    let shorter = 0.25 * length;
    let direct = if procedure.direct { ", DIRECT" } else { "" };
    let card = format!(
        "*STATIC{direct}\n{shorter:.4E}, {:?}, {:.4E}, {shorter:.4E}\n",
        procedure.period,
        procedure.minimum.min(1e-3 * shorter),
    );
    let said = Diagnostic::warning(Code("SL0604"), message)
        .at(procedure.origin.unwrap_or(of_it.origin))
        .help(format!(
            "use increments of at most {shorter:.3e} in step {step}, and compare the forces"
        ));
    Some(match procedure.origin {
        Some(origin) => said.card(Place::Instead(origin), card),
        None => said,
    })
}
