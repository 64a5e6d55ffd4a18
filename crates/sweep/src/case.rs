//! One case: values, model, run, responses.

use crate::expression::Watched;
use crate::history::{History, Watch};
use crate::layout::Parameter;
use crate::response::{evaluate, gradients};
use crate::spread::Number;
use crate::study::Study;
use slideline::diag::{Diagnostic, Sources};
use slideline::keywords::Setting;
use slideline::observe::Ending;
use slideline::{
    Judge, Model, Parameter as Varied, Parametric, Plan, SolveOptions, Workspace, objections,
};
use std::sync::Arc;

/// What came of a case.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its number, from 0.
    pub case: u64,
    /// Values of the parameters.
    pub values: Vec<f64>,
    /// Values of the responses; behind them, where a study asks for gradients, the derivatives of the
    /// first one by all parameters, those of the second one, and so on.
    pub responses: Vec<Option<f64>>,
    /// Why there are none.
    pub code: Option<String>,
}

/// Code of a case whose responses name a node, a pair, a step or a time that its model does not have.
const NO_NODE: &str = "SL0805";

/// What a runner keeps from one case to the next.
#[derive(Default)]
pub(crate) struct Room {
    workspace: Option<Workspace>,
    history: History,
}

/// Runs cases of a study, one after the other, in the room of those before.
pub(crate) struct Runner<'a> {
    study: &'a Study,
    deck: &'a Parametric,
    stops: &'a (dyn Fn() -> bool + Sync),
    options: SolveOptions,
    room: Room,
    /// The deck for the neighbours of a case, where gradients are asked for.
    differentiated: Option<Arc<Parametric>>,
}

impl<'a> Runner<'a> {
    pub fn new(
        study: &'a Study,
        deck: &'a Parametric,
        stops: &'a (dyn Fn() -> bool + Sync),
    ) -> Self {
        let differentiated = study.gradients.then(|| Arc::new(deck.clone()));
        let (options, room) = (SolveOptions::default(), Room::default());
        Self { study, deck, stops, options, room, differentiated }
    }

    /// The same in a room that another one has left.
    pub fn in_room_of(mut self, room: Room) -> Self {
        self.room = room;
        self
    }

    /// Leaves its room to another one.
    pub fn leave(self) -> Room {
        self.room
    }

    /// The row of a case; `None`: the user asked for an end.
    pub fn row(&mut self, case: u64) -> Option<Row> {
        self.row_of(case, &self.study.values(case))
    }

    /// The row of a case with these values of the parameters.
    pub fn row_of(&mut self, case: u64, numbers: &[Number]) -> Option<Row> {
        let values: Vec<f64> = numbers.iter().map(|number| number.real()).collect();
        let settings = settings(self.study, numbers);
        let found = match self.deck.read(&settings) {
            Ok((model, said)) => {
                let varied = self.varied(numbers, &settings);
                self.run(&model, said, &varied)?
            }
            Err(said) => Err(said.first().map_or("SL0901", |said| said.code.0)),
        };
        let (responses, code) = match found {
            Ok(()) => (self.responses(&values), None),
            Err(code) => (vec![None; self.study.columns()], Some(code.to_owned())),
        };
        Some(Row { case, values, responses, code })
    }

    /// Values of the responses, and their derivatives where these are asked for.
    fn responses(&self, values: &[f64]) -> Vec<Option<f64>> {
        let (responses, history) = (&self.study.responses, &self.room.history);
        let mut found = evaluate(responses, values, history);
        if self.differentiated.is_some() {
            let more = gradients(responses, values, (&found, history));
            found.extend(more);
        }
        found
    }

    /// The parameters of a case that may change a little, with their places.
    fn varied(&self, numbers: &[Number], settings: &[Setting]) -> (Vec<usize>, Vec<Varied>) {
        let Some(deck) = &self.differentiated else { return (Vec::new(), Vec::new()) };
        let real = numbers.iter().enumerate().filter_map(|(place, number)| match number {
            Number::Real(value) => {
                Some((place, (self.study.parameters[place].name.clone(), *value)))
            }
            Number::Whole(_) => None,
        });
        let (places, named): (Vec<usize>, Vec<(String, f64)>) = real.unzip();
        (places, deck.varied(settings, &named))
    }

    /// Runs a model of which reading said something; the code of what stands against it. `None`: the
    /// user asked for an end.
    fn run(
        &mut self,
        model: &Model,
        mut said: Vec<Diagnostic>,
        varied: &(Vec<usize>, Vec<Varied>),
    ) -> Option<Result<(), &'static str>> {
        if !self.room.history.begin(&self.study.curves, model) {
            return Some(Err(NO_NODE));
        }
        if self.study.watched == Watched::Verdict {
            said.extend(objections(model));
        }
        if self.differentiated.is_some() {
            self.room.history.differentiate(self.study.parameters.len());
        }
        let ending = match self.in_room(model, &said, varied) {
            Some(ending) => ending,
            None => {
                // another outline, such as another number of elements
                self.room.workspace = Some(Workspace::new(&Plan::of(model), &self.options));
                self.in_room(model, &said, varied)?
            }
        };
        match ending {
            Ending::Completed(_) => Some(Ok(())),
            Ending::NotConverged(_, said) => Some(Err(said.code.0)),
            Ending::Stopped(..) => None,
        }
    }

    /// Runs a model where the last one was; `None`: there is no room for its outline.
    fn in_room(
        &mut self,
        model: &Model,
        said: &[Diagnostic],
        (places, varied): &(Vec<usize>, Vec<Varied>),
    ) -> Option<Ending> {
        let sources = Sources::default(); // no message is read
        let judges = self.study.watched > Watched::Curves;
        let judge = judges.then(|| Judge::new(model, (said, &sources)));
        let (history, stops) = (&mut self.room.history, self.stops);
        let workspace = self.room.workspace.as_mut()?;
        if varied.is_empty() {
            return workspace.run(model, &mut Watch { history, by: &[], judge, stops }).ok();
        }
        // what the model cannot be differentiated by has no derivatives
        let (mut by, (own, faults)) = (places.clone(), workspace.varied(model, varied).ok()?);
        let is_fault = |name: &str| faults.iter().any(|fault| fault.parameter() == name);
        let mut names = varied.iter().map(|own| &*own.name);
        by.retain(|_| names.next().is_some_and(|name| !is_fault(name)));
        let watch = &mut Watch { history, by: &by, judge, stops };
        workspace.run_varied(model, own, watch).ok()
    }
}

/// Values of a case as the deck takes them.
fn settings(study: &Study, values: &[Number]) -> Vec<Setting> {
    let set = |(parameter, value): (&Parameter, &Number)| Setting {
        name: parameter.name.clone(),
        value: value.text(),
        span: None,
    };
    study.parameters.iter().zip(values).map(set).collect()
}
