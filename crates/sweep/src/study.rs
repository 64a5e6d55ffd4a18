//! A study: which values, which responses.

use crate::checks::{checked_design, checked_names, checked_spread};
use crate::curve::Curve;
use crate::design::{Design, Kind};
use crate::expression::{Known, Watched, is_name, read};
use crate::layout::{Layout, Parameter};
use crate::response::Response;
use crate::spread::{Number, Spread};
use slideline::Diagnostic;
use slideline::diag::{Code, Sources, Span};

/// A study.
#[derive(Clone, Debug)]
pub struct Study {
    pub(crate) parameters: Vec<Parameter>,
    design: Design,
    pub(crate) responses: Vec<Response>,
    pub(crate) curves: Vec<Curve>,
    /// Where each curve is named first.
    pub(crate) places: Vec<Span>,
    pub(crate) watched: Watched,
    /// Whether derivatives of the responses by the parameters stand behind them.
    pub(crate) gradients: bool,
}

impl Study {
    /// Lays a study out. Responses are names and expressions; these are added to `sources`, so that
    /// errors point at them.
    ///
    /// # Errors
    /// A diagnostic: values or a layout that cannot be (SL0803), a response that cannot be
    /// evaluated (SL0804).
    pub fn new(
        parameters: Vec<Parameter>,
        layout: &Layout,
        responses: &[(String, String)],
        sources: &mut Sources,
    ) -> Result<Self, Box<Diagnostic>> {
        checked_names(&parameters)?;
        parameters.iter().try_for_each(checked_spread)?;
        let design = checked_design(&parameters, layout)?;
        let names: Vec<String> = parameters.iter().map(|own| own.name.clone()).collect();
        let (responses, named) = read_responses(responses, &names, sources)?;
        let (curves, places) = named.into_iter().unzip();
        let watched = responses.iter().map(|own| own.term.watched()).max().unwrap_or_default();
        Ok(Self { parameters, design, responses, curves, places, watched, gradients: false })
    }

    /// Everything that the rows depend on, as a text.
    pub(crate) fn description(&self) -> String {
        let Self { parameters, design, responses, curves, .. } = self;
        format!("{parameters:?} {design:?} {responses:?} {curves:?}")
    }

    /// The same with the derivatives of the responses by the parameters.
    pub fn with_gradients(mut self) -> Self {
        self.gradients = true;
        self
    }

    /// Numbers of a row behind the parameters: responses, and derivatives where they are asked for.
    pub(crate) fn columns(&self) -> usize {
        let each = if self.gradients { 1 + self.parameters.len() } else { 1 };
        each * self.responses.len()
    }

    /// How many cases there are.
    pub fn cases(&self) -> u64 {
        self.design.cases
    }

    /// Whether its cases come in points of Saltelli's design.
    pub(crate) fn has_shares(&self) -> bool {
        self.design.kind == Kind::Saltelli
    }

    /// Values of the parameters in a case, from 0.
    pub fn values(&self, case: u64) -> Vec<Number> {
        let spreads: Vec<&Spread> = self.parameters.iter().map(|own| &own.spread).collect();
        self.design.values(case, &spreads)
    }
}

/// Responses, and the curves that they name with their places.
type Responses = (Vec<Response>, Vec<(Curve, Span)>);

fn read_responses(
    given: &[(String, String)],
    parameters: &[String],
    sources: &mut Sources,
) -> Result<Responses, Box<Diagnostic>> {
    let (mut names, mut curves): (Vec<String>, Vec<_>) = (Vec::new(), Vec::new());
    let (mut all, mut places) = (Vec::with_capacity(given.len()), Vec::new());
    for (name, text) in given {
        let file = sources.add(format!("response {name}"), text.clone());
        let refused = |message: String, span: Span| {
            let help = "a response is made of measures such as peak(RF2@100), max(U1@TIP, 1), \
                        at(RF1@100, 0.5) or work(RF2@100, U2@100), of parameters, responses before \
                        it, + - * / and brackets";
            Box::new(Diagnostic::error(Code("SL0804"), message).at(span).help(help))
        };
        let whole = Span::new(file, 0, text.len());
        if !is_name(name) || names.contains(name) || parameters.contains(name) {
            let message = format!("`{name}` cannot name a response: letters, digits and _, once");
            return Err(refused(message, whole));
        }
        let known = Known { parameters, responses: &names, curves: &mut curves };
        let term = read(text, known).map_err(|said| {
            refused(said.message, Span::new(file, said.place.start, said.place.end))
        })?;
        let new = curves[places.len()..].iter();
        places.extend(new.map(|(_, place)| Span::new(file, place.start, place.end)));
        names.push(name.clone());
        all.push(Response { term, place: whole });
    }
    Ok((all, curves.into_iter().map(|(curve, _)| curve).zip(places).collect()))
}
