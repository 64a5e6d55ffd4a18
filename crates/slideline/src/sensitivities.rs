//! What a run is differentiated by: the parameters of its deck.

use crate::lost_sensitivities::Lost;
use crate::parametric::Parametric;
use crate::read::Read;
use slideline_diag::{Code, Diagnostic};
use slideline_keywords::Setting;
use slideline_model::Model;
use slideline_solve::observe::{Ending, Observer};
use slideline_solve::{Options, Plan, Varied, Workspace};
use std::sync::Arc;

/// Parameters that a run can be differentiated by, and what is to be said of the others.
pub(crate) struct Chosen {
    /// The run that they differentiate, where there are some.
    pub run: Option<Differentiated>,
    pub names: Vec<String>,
    pub said: Vec<Diagnostic>,
}

/// A run with its sensitivities: where it is made, and what it is differentiated by.
pub(crate) struct Differentiated(Workspace, Varied);

impl Differentiated {
    /// Runs the model that the parameters of these names were chosen for; `None`: they are none of it.
    pub fn run(
        self,
        (model, names): (&Model, &[String]),
        observer: &mut dyn Observer,
    ) -> Option<Ending> {
        let Self(mut workspace, varied) = self;
        workspace.run_varied(model, varied, &mut Lost::new(names, observer)).ok()
    }
}

impl Chosen {
    /// None: the run is not differentiated.
    fn none() -> Self {
        Self { run: None, names: Vec::new(), said: Vec::new() }
    }

    /// Those of a deck that was read, where they are wanted; `Err`: as [`Chosen::of`].
    pub fn wanted(
        read: &Read,
        wanted: bool,
        by: (&Options, bool),
    ) -> Result<Self, Box<Diagnostic>> {
        match &read.model {
            Some(model) if wanted => Self::of(read, model, by),
            _ => Ok(Self::none()),
        }
    }

    /// The numbers of a deck that was read. `Err`: there are none, or the run goes on from a saved
    /// state, which does not know its derivatives.
    fn of(
        read: &Read,
        model: &Model,
        (options, restarts): (&Options, bool),
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
        let (plan, parameters) = (Plan::of(model), deck.varied(&settings, &numbers));
        let (varied, faults) = Varied::of(&parameters, (&plan, model), &options.user_frictions);
        let names: Vec<String> = varied.names().map(str::to_owned).collect();
        let said = faults.iter().map(|fault| {
            let message = format!("no sensitivities by {}: {fault}", fault.parameter());
            Diagnostic::warning(Code("SL0811"), message).help(
                "only numbers that may change a little have sensitivities: sizes, places, \
                 materials, friction, motions and loads, but no counts and no times",
            )
        });
        let said = said.collect();
        if names.is_empty() {
            let message = "no sensitivities: no parameter of the deck may change a little";
            let names: Vec<&str> = numbers.iter().map(|(name, _)| name.as_str()).collect();
            let help = format!(
                "Its parameters are counts, or times of steps: {}. Name a size, a material or a \
                 motion by *PARAMETER.",
                names.join(", ")
            );
            return Err(refused(message, &help));
        }
        let run = Differentiated(Workspace::new(&plan, options), varied);
        Ok(Self { run: Some(run), names, said })
    }
}

fn refused(message: &str, help: &str) -> Box<Diagnostic> {
    Box::new(Diagnostic::error(Code("SL0810"), message).help(help))
}
