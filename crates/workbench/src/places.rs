//! Where the numbers of a deck stand that follow sliders.
//!
//! Every place has a name of its own in the deck that takes values, and is given the number that a
//! saved deck has there: both have the same bits.

use crate::profile::Profile;
use crate::slider::Slider;
use crate::values::Values;
use slideline::diag::{Code, Diagnostic, Span};
use slideline::keywords::Setting;

/// A place.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Place {
    /// Where it stands in the deck that the user has.
    pub span: Span,
    /// The name that stands for it in the deck that takes values.
    pub name: String,
    /// The deck's own number.
    pub value: f64,
    /// What it follows.
    pub follows: Follows,
}

/// What a number follows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Follows {
    /// It is the value of a slider.
    Same(usize),
    /// It is that with the other sign.
    Negative(usize),
    /// A slider is added to it.
    Moved(usize),
    /// It is a coordinate of a profile: profile, and place among what is written of it.
    Drawn(usize, usize),
}

/// A profile that follows sliders.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Drawn {
    /// What its surface is called.
    pub name: String,
    /// The profile.
    pub profile: Profile,
    /// The sliders of its handles.
    pub sliders: Vec<usize>,
}

/// All of a deck.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Places {
    /// Numbers.
    pub list: Vec<Place>,
    /// Profiles that some of them draw.
    pub profiles: Vec<Drawn>,
}

impl Places {
    /// The places that have another number than that of the deck, with what is written there. `Err`:
    /// there is no such profile.
    pub fn changed<'a>(
        &'a self,
        sliders: &[Slider],
        values: &Values,
    ) -> Result<Vec<(&'a Place, String)>, Vec<Diagnostic>> {
        let drawn: Result<Vec<Vec<f64>>, Vec<Diagnostic>> =
            self.profiles.iter().map(|own| own.moved(values)).collect();
        let drawn = drawn?;
        let value = |own: &Place| match own.follows {
            Follows::Same(slider) => values.0[slider],
            Follows::Negative(slider) => -values.0[slider],
            Follows::Moved(slider) => own.value + values.0[slider],
            Follows::Drawn(profile, place) => drawn[profile][place],
        };
        let now = self.list.iter().map(|own| (own, value(own)));
        let changed = now.filter(|(own, value)| own.value != *value);
        let written = |(own, value): (&'a Place, f64)| {
            let whole = matches!(own.follows, Follows::Same(slider) if sliders[slider].whole);
            (own, if whole { as_whole(value) } else { format!("{value:?}") })
        };
        Ok(changed.map(written).collect())
    }

    /// What a deck is told: only numbers that are not its own. `Err`: as [`Places::changed`].
    pub fn settings(
        &self,
        sliders: &[Slider],
        values: &Values,
    ) -> Result<Vec<Setting>, Vec<Diagnostic>> {
        let set =
            |(own, value): (&Place, String)| Setting { name: own.name.clone(), value, span: None };
        Ok(self.changed(sliders, values)?.into_iter().map(set).collect())
    }
}

impl Drawn {
    fn moved(&self, values: &Values) -> Result<Vec<f64>, Vec<Diagnostic>> {
        let own: Vec<f64> = self.sliders.iter().map(|own| values.0[*own]).collect();
        self.profile.moved(&own).map_err(|why| {
            let message = format!("surface {} cannot be drawn with these values: {why}", self.name);
            let help = "Make its radii smaller, or its angles more like those of the deck.";
            vec![Diagnostic::error(Code("SL0237"), message).help(help)]
        })
    }
}

/// A value of a slider whose number is whole in the deck.
fn as_whole(value: f64) -> String {
    if value == value.trunc() && value.abs() < 1e15 {
        format!("{value:.0}")
    } else {
        format!("{value:?}")
    }
}
