//! What a run is differentiated by: the parameters of its deck.

use crate::lost_sensitivities::Lost;
use crate::parametric::Parametric;
use crate::read::Read;
use slideline_diag::{Code, Diagnostic};
use slideline_keywords::Setting;
use slideline_model::Model;
use slideline_solve::observe::{Ending, Observer};
use slideline_solve::{Options, Parameter, Plan, UserFrictions, Workspace, sensitivity_fault};
use std::sync::Arc;

/// Parameters that a run can be differentiated by, and what is to be said of the others.
pub(crate) struct Chosen {
    parameters: Vec<Parameter>,
    pub names: Vec<String>,
    pub said: Vec<Diagnostic>,
}

impl Chosen {
    /// None: the run is not differentiated.
    fn none() -> Self {
        Self { parameters: Vec::new(), names: Vec::new(), said: Vec::new() }
    }

    /// Those of a deck that was read, where they are wanted; `Err`: as [`Chosen::of`].
    pub fn wanted(
        read: &Read,
        wanted: bool,
        by: (&UserFrictions, bool),
    ) -> Result<Self, Box<Diagnostic>> {
        match &read.model {
            Some(model) if wanted => Self::of(read, model, by),
            _ => Ok(Self::none()),
        }
    }

    /// Runs a model with its sensitivities; `None`: the parameters are none of the model.
    pub fn run(
        &self,
        model: &Model,
        options: &Options,
        observer: &mut dyn Observer,
    ) -> Option<Ending> {
        let mut workspace = Workspace::new(&Plan::of(model), options);
        let mut watch = Lost::new(&self.names, observer);
        workspace.run_differentiated(model, &self.parameters, &mut watch).ok()?.ok()
    }

    /// The numbers of a deck that was read. `Err`: there are none, or the run goes on from a saved
    /// state, which does not know its derivatives.
    fn of(
        read: &Read,
        model: &Model,
        (users, restarts): (&UserFrictions, bool),
    ) -> Result<Self, Box<Diagnostic>> {
        if restarts || read.from.is_some() {
            let message = "no sensitivities: the run continues from a saved state, which does not \
                           hold how it follows the parameters";
            return Err(refused(
                message,
                "Put all steps into one deck, and run it from the beginning.",
            ));
        }
        let deck = Arc::new(Parametric::of(read)?);
        let given = read.options.parameters.iter();
        let settings: Vec<Setting> = given
            .map(|(name, value)| Setting { name: name.clone(), value: value.clone(), span: None })
            .collect();
        let numbers = deck.numbers(&settings);
        if numbers.is_empty() {
            let message = "no sensitivities: the deck has no parameter that is a number";
            let help = "Give names to numbers by *PARAMETER, with lines such as `mu = 0.3`, and write \
                        <mu> where they stand.";
            return Err(refused(message, help));
        }
        let plan = Plan::of(model);
        let mut chosen = Self::none();
        for parameter in deck.varied(&settings, &numbers) {
            match sensitivity_fault(&parameter, (&plan, model), users) {
                None => {
                    chosen.names.push(parameter.name.clone());
                    chosen.parameters.push(parameter);
                }
                Some(fault) => {
                    let message = format!("no sensitivities by {}: {fault}", parameter.name);
                    let said = Diagnostic::warning(Code("SL0811"), message);
                    chosen.said.push(said.help(
                        "only numbers that may change a little have sensitivities: sizes, places, \
                         materials, friction, motions and loads, but no counts and no times",
                    ));
                }
            }
        }
        if chosen.parameters.is_empty() {
            let message = "no sensitivities: no parameter of the deck may change a little";
            let names: Vec<&str> = numbers.iter().map(|(name, _)| name.as_str()).collect();
            let help = format!(
                "Its parameters are counts, or times of steps: {}. Name a size, a material or a \
                 motion by *PARAMETER.",
                names.join(", ")
            );
            return Err(refused(message, &help));
        }
        Ok(chosen)
    }
}

fn refused(message: &str, help: &str) -> Box<Diagnostic> {
    Box::new(Diagnostic::error(Code("SL0810"), message).help(help))
}
