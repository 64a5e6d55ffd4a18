//! What the loads of a step go on from: those of the step before.

use slideline_model::{Amplitude, Load, Step};

/// The step before, with the amplitudes of the model.
#[derive(Clone, Copy, Debug)]
pub struct Continued<'a> {
    /// Amplitudes of the model.
    pub amplitudes: &'a [Amplitude],
    /// The step before; `None`: there is none.
    pub before: Option<&'a Step>,
}

impl Continued<'_> {
    /// The largest concentrated load at the beginning or the end of a step, moments over a lever [F].
    pub fn largest_load(&self, step: &Step, lever: f64) -> f64 {
        let ends = |own: &Load| {
            let by = if own.dof.is_rotation() && lever > 0.0 { 1.0 / lever } else { 1.0 };
            [self.start_of_load(own, |before| &before.loads), own.value].map(|value| by * value)
        };
        step.loads.iter().flat_map(ends).fold(0.0, |most, value| value.abs().max(most))
    }

    /// What a load begins from, of a list of loads [F or F L].
    pub fn start_of_load(&self, own: &Load, list: fn(&Step) -> &[Load]) -> f64 {
        self.start_of(own.continues, |before, place| {
            let before = list(before).get(place)?;
            Some((before.value, before.amplitude))
        })
    }

    /// What a load begins from: the value of the one that it continues, at the end of the step
    /// before. `of` reads value and amplitude of a load there.
    pub fn start_of(
        &self,
        continues: Option<usize>,
        of: impl Fn(&Step, usize) -> Option<(f64, Option<usize>)>,
    ) -> f64 {
        let Some((before, place)) = self.before.zip(continues) else { return 0.0 };
        let Some((value, amplitude)) = of(before, place) else { return 0.0 };
        let end = before.procedure.period;
        let amplitude = amplitude.map(|place| &self.amplitudes[place]);
        amplitude.map_or(value, |amplitude| value * amplitude.at(end))
    }
}
