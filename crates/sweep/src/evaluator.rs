//! Responses of one deck at points that others choose, such as an optimiser.

use crate::case::{Room, Row, Runner};
use crate::design::Kind;
use crate::layout::{Layout, Parameter};
use crate::run::share;
use crate::spread::{Number, Spread};
use crate::study::Study;
use crate::sweep::{strange_curves, strange_names};
use slideline::diag::Sources;
use slideline::keywords::Setting;
use slideline::{Diagnostic, Parametric, Read};
use std::sync::{Mutex, PoisonError};

/// A deck, the parameters that are set in it, and the responses that are asked for. Plans and
/// workspaces are kept from one call to the next.
pub struct Evaluator {
    study: Study,
    deck: Parametric,
    rooms: Mutex<Vec<Room>>,
}

impl Evaluator {
    /// That of a deck that was read. Responses are names and expressions; these are added to
    /// `sources`, so that errors point at them.
    ///
    /// # Errors
    /// Those of the deck; a parameter that it does not define (SL0801), a response that cannot be
    /// evaluated (SL0804) or names a node that the deck does not have (SL0805).
    pub fn new(
        read: &Read,
        parameters: &[String],
        responses: &[(String, String)],
        sources: &mut Sources,
    ) -> Result<Self, Vec<Diagnostic>> {
        let Some(model) = &read.model else { return Err(read.diagnostics.clone()) };
        let deck = Parametric::of(read).map_err(|said| vec![*said])?;
        let study = named(parameters, responses, sources).map_err(|said| vec![*said])?;
        let any = |name: &String| Setting { name: name.clone(), value: "0.0".into(), span: None };
        let settings: Vec<Setting> = parameters.iter().map(any).collect();
        let mut said = strange_names(&deck, &settings);
        said.extend(strange_curves(&study, model));
        if said.is_empty() { Ok(Self::of(study, deck)) } else { Err(said) }
    }

    /// That of a study and its deck; the values of the study are of no account.
    pub fn of(study: Study, deck: Parametric) -> Self {
        Self { study, deck, rooms: Mutex::default() }
    }

    /// The row of every point, in their order; a point is the values of the parameters in the order
    /// of their names. Rows have the same bits on any number of threads and after any calls before.
    /// Where `stops` says so, the rows so far that follow one another are returned.
    pub fn evaluate(
        &self,
        points: &[Vec<Number>],
        threads: usize,
        stops: &(dyn Fn() -> bool + Sync),
    ) -> Vec<Row> {
        self.run(&self.study, points, (threads, stops))
    }

    /// The same with the derivatives of the responses by the parameters: behind the responses of a row
    /// those of the first one by all parameters, those of the second one, and so on.
    pub fn differentiate(
        &self,
        points: &[Vec<Number>],
        threads: usize,
        stops: &(dyn Fn() -> bool + Sync),
    ) -> Vec<Row> {
        self.run(&self.study.clone().with_gradients(), points, (threads, stops))
    }

    fn run(
        &self,
        study: &Study,
        points: &[Vec<Number>],
        (threads, stops): (usize, &(dyn Fn() -> bool + Sync)),
    ) -> Vec<Row> {
        let begin = || {
            let room = self.rooms().pop().unwrap_or_default();
            Runner::new(study, &self.deck, stops).in_room_of(room)
        };
        let run = |runner: &mut Runner<'_>, case: u64| {
            let point = points.get(usize::try_from(case).ok()?)?;
            runner.row_of(case, point)
        };
        let leave = |runner: Runner<'_>| self.rooms().push(runner.leave());
        share(0..points.len() as u64, threads, (&|_| (), stops), (&begin, &run, &leave))
    }

    /// A fault of one thread leaves the others their rooms.
    fn rooms(&self) -> std::sync::MutexGuard<'_, Vec<Room>> {
        self.rooms.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A study that gives its parameters no values of their own: it has a list of one number each.
fn named(
    parameters: &[String],
    responses: &[(String, String)],
    sources: &mut Sources,
) -> Result<Study, Box<Diagnostic>> {
    let spread = Spread::List(vec![Number::Real(0.0)]);
    let named = |name: &String| Parameter { name: name.clone(), spread: spread.clone() };
    let layout = Layout { kind: Kind::Together, cases: 0, seed: 0, correlations: Vec::new() };
    Study::new(parameters.iter().map(named).collect(), &layout, responses, sources)
}
