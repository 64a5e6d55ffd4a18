//! Values of parameters: as the page has them, as a deck takes them.

use crate::slider::Slider;
use serde_json::Value;

/// Values of all sliders, in their order.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Values(pub Vec<f64>);

impl Values {
    /// Those of the deck with what an object of names and numbers says in their place. `Err`: why
    /// it cannot.
    pub fn of(sliders: &[Slider], said: Option<&Value>) -> Result<Self, String> {
        let mut values: Vec<f64> = sliders.iter().map(|own| own.value).collect();
        let members = said.and_then(Value::as_object).into_iter().flatten();
        for (name, value) in members {
            let place = sliders.iter().position(|own| own.name == *name);
            let place = place.ok_or_else(|| format!("the deck has no parameter {name}"))?;
            let number = value.as_f64().filter(|own| own.is_finite());
            values[place] = number.ok_or_else(|| format!("the value of {name} is no number"))?;
        }
        Ok(Self(values))
    }

    /// The same with another value in one place.
    pub fn with(&self, place: usize, value: f64) -> Self {
        let mut own = self.clone();
        own.0[place] = value;
        own
    }
}
