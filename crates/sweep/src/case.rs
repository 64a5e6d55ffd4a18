//! One case: values, model, run, responses.

use crate::expression::Watched;
use crate::history::{History, Watch};
use crate::layout::Parameter;
use crate::response::evaluate;
use crate::spread::Number;
use crate::study::Study;
use slideline::diag::{Diagnostic, Sources};
use slideline::keywords::Setting;
use slideline::observe::Ending;
use slideline::{Judge, Model, Parametric, Plan, SolveOptions, Workspace, objections};

/// What came of a case.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its number, from 0.
    pub case: u64,
    /// Values of the parameters.
    pub values: Vec<f64>,
    /// Values of the responses.
    pub responses: Vec<Option<f64>>,
    /// Why there are none.
    pub code: Option<String>,
}

/// Code of a case whose responses name a node or a pair that its model does not have.
const NO_NODE: &str = "SL0805";

/// Runs cases of a study, one after the other, in the room of those before.
pub(crate) struct Runner<'a> {
    study: &'a Study,
    deck: &'a Parametric,
    stops: &'a (dyn Fn() -> bool + Sync),
    options: SolveOptions,
    workspace: Option<Workspace>,
    history: History,
}

impl<'a> Runner<'a> {
    pub fn new(
        study: &'a Study,
        deck: &'a Parametric,
        stops: &'a (dyn Fn() -> bool + Sync),
    ) -> Self {
        Self {
            study,
            deck,
            stops,
            options: SolveOptions::default(),
            workspace: None,
            history: History::default(),
        }
    }

    /// The row of a case; `None`: the user asked for an end.
    pub fn row(&mut self, case: u64) -> Option<Row> {
        let numbers = self.study.values(case);
        let values: Vec<f64> = numbers.iter().map(|number| number.real()).collect();
        let settings = settings(self.study, &numbers);
        let found = match self.deck.read(&settings) {
            Ok((model, said)) => self.run(&model, said)?,
            Err(said) => Err(said.first().map_or("SL0901", |said| said.code.0)),
        };
        let (responses, code) = match found {
            Ok(()) => (evaluate(&self.study.responses, &values, &self.history), None),
            Err(code) => (vec![None; self.study.responses.len()], Some(code.to_owned())),
        };
        Some(Row { case, values, responses, code })
    }

    /// Runs a model of which reading said something; the code of what stands against it. `None`: the
    /// user asked for an end.
    fn run(
        &mut self,
        model: &Model,
        mut said: Vec<Diagnostic>,
    ) -> Option<Result<(), &'static str>> {
        if !self.history.begin(&self.study.curves, model) {
            return Some(Err(NO_NODE));
        }
        if self.study.watched == Watched::Verdict {
            said.extend(objections(model));
        }
        let ending = match self.in_room(model, &said) {
            Some(ending) => ending,
            None => {
                // another outline, such as another number of elements
                self.workspace = Some(Workspace::new(&Plan::of(model), &self.options));
                self.in_room(model, &said)?
            }
        };
        match ending {
            Ending::Completed(_) => Some(Ok(())),
            Ending::NotConverged(_, said) => Some(Err(said.code.0)),
            Ending::Stopped(..) => None,
        }
    }

    /// Runs a model where the last one was; `None`: there is no room for its outline.
    fn in_room(&mut self, model: &Model, said: &[Diagnostic]) -> Option<Ending> {
        let sources = Sources::default(); // no message is read
        let judges = self.study.watched > Watched::Curves;
        let judge = judges.then(|| Judge::new(model, (said, &sources)));
        let (history, stops) = (&mut self.history, self.stops);
        self.workspace.as_mut()?.run(model, &mut Watch { history, judge, stops }).ok()
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
