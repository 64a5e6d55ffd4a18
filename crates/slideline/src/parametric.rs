//! One deck, many values of its parameters: it is parsed once.

use crate::read::Read;
use slideline_deck::Parsed;
use slideline_diag::{Code, Diagnostic, Severity, has_errors};
use slideline_keywords::{Prepared, Setting};
use slideline_model::{Model, Onset};
use slideline_solve::Parameter;
use std::sync::Arc;

/// A deck whose cards were read, waiting for values.
#[derive(Clone, Debug)]
pub struct Parametric {
    deck: Prepared,
    onset: Option<Onset>,
}

impl Parametric {
    /// That of a deck that was read. `Err`: it goes on from the states of another job, whose
    /// values are fixed.
    pub fn of(read: &Read) -> Result<Self, Box<Diagnostic>> {
        if read.from.is_some() {
            let message = "a deck with *RESTART, READ cannot be run with other values: the state \
                           that it goes on from has its own";
            let help = "Put all steps into one deck.";
            return Err(Box::new(Diagnostic::error(Code("SL0802"), message).help(help)));
        }
        let parsed = Parsed { deck: read.deck.clone(), diagnostics: of_the_text(read) };
        Ok(Self {
            deck: Prepared::new(parsed, read.options.dialect.unwrap_or_default()),
            onset: read.options.friction_onset,
        })
    }

    /// The model with these values, that of [`Job::read`](crate::Job::read) with them as
    /// [`ReadOptions::parameters`](crate::ReadOptions::parameters). `Err`: the errors.
    pub fn model(&self, settings: &[Setting]) -> Result<Model, Vec<Diagnostic>> {
        self.read(settings).map(|(model, _)| model)
    }

    /// Names and values of the parameters that are numbers of their own, in the order of the deck.
    pub fn numbers(&self, settings: &[Setting]) -> Vec<(String, f64)> {
        self.deck.interpret_with(settings).numbers
    }

    /// Parameters as a run is differentiated by them, each from the values of `settings`. One that is
    /// zero counts as large at 1, in its own unit.
    pub fn varied(
        self: &Arc<Self>,
        settings: &[Setting],
        numbers: &[(String, f64)],
    ) -> Vec<Parameter> {
        let vary = |(name, value): &(String, f64)| {
            let (deck, name_of) = (Arc::clone(self), name.clone());
            let others: Vec<Setting> =
                settings.iter().filter(|own| own.name != *name).cloned().collect();
            let model = move |value: f64| {
                let mut all = others.clone();
                let value = format!("{value:?}");
                all.push(Setting { name: name_of.clone(), value, span: None });
                deck.model(&all).ok()
            };
            let scale = if *value == 0.0 { 1.0 } else { value.abs() };
            Parameter { name: name.clone(), value: *value, scale, model: Arc::new(model) }
        };
        numbers.iter().map(vary).collect()
    }

    /// The same with everything that reading has to say.
    pub fn read(&self, settings: &[Setting]) -> Result<(Model, Vec<Diagnostic>), Vec<Diagnostic>> {
        let interpreted = self.deck.interpret_with(settings);
        let mut said = interpreted.diagnostics;
        let mut model = interpreted.model;
        model.friction_onset = self.onset.unwrap_or(model.friction_onset);
        if !has_errors(&said) {
            said.extend(slideline_solve::adjust(&mut model));
            said.extend(slideline_solve::memory_objection(&model));
        }
        if has_errors(&said) {
            said.retain(|said| said.severity == Severity::Error);
            return Err(said);
        }
        Ok((model, said))
    }
}

/// What was said about the syntax of a deck.
fn of_the_text(read: &Read) -> Vec<Diagnostic> {
    let of_the_text = |said: &&Diagnostic| said.code.0.starts_with("SL01");
    read.diagnostics.iter().filter(of_the_text).cloned().collect()
}
