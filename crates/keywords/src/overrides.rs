//! Values that names of `*PARAMETER` get from outside the deck.

use slideline_diag::{Code, Diagnostic, Span};

use crate::expression::{Value, Values, evaluate, is_name};
use crate::log::Log;

/// A value for a name that the deck defines by `*PARAMETER`. It stands in place of the first value
/// that the deck gives to the name.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Setting {
    /// The name; capitals and small letters differ.
    pub name: String,
    /// The value, an expression as on a line of `*PARAMETER`, which knows no other names.
    pub value: String,
    /// Where it was said, for what stands against it.
    pub span: Option<Span>,
}

/// Settings while a deck is read.
#[derive(Default)]
pub(crate) struct Overrides(Vec<Override>);

struct Override {
    name: String,
    span: Option<Span>,
    /// `None` where it is used already, or has none and that was said.
    value: Option<Value>,
    is_met: bool,
}

impl Overrides {
    /// The values of the settings; complains about those that have none, and about names set twice.
    pub fn of(settings: &[Setting], log: &mut Log) -> Self {
        let mut all: Vec<Override> = Vec::with_capacity(settings.len());
        for Setting { name, value, span } in settings {
            if all.iter().any(|earlier| earlier.name == *name) {
                refuse(format!("the parameter {name} is set twice"), *span, log);
                continue;
            }
            let value = match evaluate(value, &Values::new()) {
                Ok(value) => Some(value),
                Err((why, _)) => {
                    let message = format!("the parameter {name} cannot be set to `{value}`: {why}");
                    refuse(message, *span, log);
                    None
                }
            };
            all.push(Override { name: name.clone(), span: *span, value, is_met: false });
        }
        Self(all)
    }

    /// The value that stands in place of what a line of the deck gives to a name: of the first
    /// such line only.
    pub fn take(&mut self, name: &str) -> Option<Value> {
        let found = self.0.iter_mut().find(|own| own.name == name)?;
        found.is_met = true;
        found.value.take()
    }

    /// Complains about names that the deck gives no value to. `defined`: those that it does.
    pub fn complain_of_unmet(&self, defined: &Values, log: &mut Log) {
        let mut names: Vec<&str> = defined.keys().map(String::as_str).collect();
        names.sort_unstable();
        for Override { name, span, .. } in self.0.iter().filter(|own| !own.is_met) {
            let message = format!("the deck has no parameter {name}");
            let error = Diagnostic::error(Code("SL0801"), message).at(*span);
            let help = if defined.contains_key(name) {
                "the deck of the previous job has it: its value comes with the saved state"
                    .to_owned()
            } else {
                known(name, &names)
            };
            log.push(error.help(help));
        }
    }
}

/// Names that may be meant by one that the deck does not have.
fn known(name: &str, names: &[&str]) -> String {
    const MOST: usize = 20;
    if names.is_empty() {
        let value = if is_name(name) { name } else { "name" };
        return format!("it has no *PARAMETER at all: write one, with a line `{value} = ...`");
    }
    let more = if names.len() > MOST { ", ..." } else { "" };
    let listed = names.iter().take(MOST).copied().collect::<Vec<_>>().join(", ");
    let near = slideline_deck::nearest(name, names.iter().copied());
    let near = near.map_or_else(String::new, |near| format!("did you mean {near}? "));
    format!(
        "{near}The parameters of the deck are: {listed}{more}; capitals and small letters differ"
    )
}

fn refuse(message: String, span: Option<Span>, log: &mut Log) {
    let help = "a value is a number, an expression of numbers, or a name in quotation marks; it knows \
                no names of the deck";
    log.push(Diagnostic::error(Code("SL0802"), message).at(span).help(help));
}
