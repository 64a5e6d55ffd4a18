//! How the curve of a run and its key figures follow parameters: exact derivatives.
//!
//! A key figure is the force at one row of the curve, or a sum over rows; its derivative is that of
//! what it is taken from, as long as it is taken from there. [docs/sensitivities.md]

use crate::curves::Curves;
use crate::deck::Opened;
use crate::quiet::Quiet;
use crate::slider::Slider;
use crate::solve::{OVERTAKEN, Room, Silent, because, first_error, model};
use crate::values::Values;
use slideline::observe::{Ending, Frame, Sensitivity};
use slideline::output::report::Told;
use slideline::{Event, Judge, Observer, Parameter, Stop};
use std::ops::ControlFlow;
use std::sync::Arc;

/// How a curve follows a parameter.
pub(crate) struct Rates {
    /// Derivatives of motion and force, row by row from the start on.
    pub curve: Vec<[f64; 2]>,
    /// Derivative of the largest strain of beams.
    strain: Option<f64>,
    /// The first row where the derivative is that of one side; behind the last one: none.
    pub one_sided: usize,
}

/// Why there is no exact derivative.
pub(crate) const LOST: &str = "the run has no derivative by it";
/// As above.
pub(crate) const ONE_SIDED: &str = "the derivative is that of one side";

/// Solves with derivatives by the parameters in these places, each `None` where there are none.
/// `Err`: why there is no result.
pub(crate) fn differentiated(
    opened: &Opened,
    values: &Values,
    room: &mut Room,
    places: &[usize],
    say: &mut dyn FnMut(&str) -> bool,
) -> Result<(Quiet, Vec<Option<Rates>>), String> {
    let (model, said) = model(opened, values).map_err(|errors| first_error(&errors))?;
    let job = (opened.job(), &*opened.read.deck_hash, false);
    let judge = Judge::showing(&model, (&said, &opened.read.sources), job);
    let all: Vec<Parameter> =
        places.iter().map(|&place| parameter(opened, values, place)).collect();
    let varied = room.varied(&model, &all).ok_or(OVERTAKEN)?;
    let has = |own: &Parameter| varied.names().any(|name| name == own.name);
    let numbers: Vec<usize> = (0..all.len()).filter(|&number| has(&all[number])).collect();
    let courses = numbers.iter().map(|_| Course::default()).collect();
    let mut watch = Watch {
        silent: Silent::of(judge, &model, say),
        curves: Curves::of(&model),
        courses,
        rows: 0,
        strained: None,
    };
    let ending = room.run_varied(&model, varied, &mut watch);
    let Watch { silent, courses, rows, .. } = watch;
    match ending {
        Some(Ending::Completed(_)) => {}
        Some(Ending::NotConverged(_, said)) => return Err(because(&said)),
        Some(Ending::Stopped(..)) | None => return Err(OVERTAKEN.to_owned()),
    }
    let quiet = silent.ended()?;
    let curve = quiet.place;
    let mut rates: Vec<Option<Rates>> = places.iter().map(|_| None).collect();
    for (number, own) in numbers.into_iter().zip(courses) {
        rates[number] = own.rates(curve, rows);
    }
    Ok((quiet, rates))
}

/// A slider as what a run is differentiated by.
fn parameter(opened: &Opened, values: &Values, place: usize) -> Parameter {
    let slider = &opened.sliders[place];
    let value = values.0[place];
    let deck = opened.parametric.clone();
    let (values, sliders, places) = (values.clone(), opened.sliders.clone(), opened.places.clone());
    let model = move |value: f64| {
        let settings = places.settings(&sliders, &values.with(place, value)).ok()?;
        deck.as_ref()?.model(&settings).ok()
    };
    Parameter {
        name: slider.name.clone(),
        value,
        scale: scale(slider, value),
        model: Arc::new(model),
    }
}

/// What counts as a large change of a parameter: its size; of what may be zero, such as an angle or a
/// shift, half of its range.
fn scale(slider: &Slider, value: f64) -> f64 {
    let half = 0.5 * (slider.range[1] - slider.range[0]);
    let may_be_zero = slider.range[0] <= 0.0 && slider.range[1] >= 0.0;
    if may_be_zero { value.abs().max(half) } else { value.abs() }
}

/// What was told of a parameter.
#[derive(Default)]
struct Course {
    /// Derivatives of motion and force of all that is driven, row by row from the first increment on.
    rows: Vec<Vec<[f64; 2]>>,
    strain: Option<f64>,
    one_sided: Option<usize>,
}

impl Course {
    /// `None`: it was lost on the way.
    fn rates(self, curve: usize, rows: usize) -> Option<Rates> {
        let own = self.rows.iter().map(|row| row.get(curve).copied());
        let curve: Option<Vec<[f64; 2]>> = std::iter::once(Some([0.0; 2])).chain(own).collect();
        let curve = curve.filter(|own| own.len() == rows + 1)?;
        let is_sound = curve.iter().flatten().all(|own| own.is_finite());
        let one_sided = self.one_sided.unwrap_or(usize::MAX);
        is_sound.then_some(Rates { curve, strain: self.strain, one_sided })
    }
}

/// Watches a run and what its states follow.
struct Watch<'a, 's> {
    silent: Silent<'a, 's>,
    curves: Curves,
    courses: Vec<Course>,
    /// Increments so far.
    rows: usize,
    /// The largest strain of beams with the place of its beam, and whether the last row has it.
    strained: Option<(f64, usize, bool)>,
}

impl Watch<'_, '_> {
    fn commit(&mut self, frame: &Frame<'_>) {
        self.rows += 1;
        if let Some((_, _, is_last)) = &mut self.strained {
            *is_last = false;
        }
        for (place, beam) in frame.beams.iter().enumerate() {
            if self.strained.is_none_or(|(most, ..)| beam.fibre_strain > most) {
                self.strained = Some((beam.fibre_strain, place, true));
            }
        }
        if self.strained.is_some_and(|(.., is_last)| is_last) {
            self.courses.iter_mut().for_each(|own| own.strain = None);
        }
    }

    fn follow(&mut self, told: &Sensitivity<'_>) {
        let Some(course) = self.courses.get_mut(told.parameter) else { return };
        // one that misses a row has lost its way
        if course.rows.len() + 1 != self.rows {
            return;
        }
        // a row of neighbours, weighed as the derivative of a number is
        let count = self.curves.count();
        let rate = |place: usize, part: usize| {
            told.of(|frame| self.curves.row(frame).get(place).map_or(0.0, |own| own[part]))
        };
        course.rows.push((0..count).map(|place| [rate(place, 0), rate(place, 1)]).collect());
        if let Some((_, place, true)) = self.strained {
            course.strain = Some(told.of(|frame| frame.beams[place].fibre_strain));
        }
        if told.one_sided {
            course.one_sided.get_or_insert(self.rows);
        }
    }
}

impl Observer for Watch<'_, '_> {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match &event {
            Event::Committed(frame) => self.commit(frame),
            Event::Sensitivity(told) => self.follow(told),
            _ => {}
        }
        self.silent.event(event)
    }
}

impl Rates {
    /// The derivative of a key figure. `Err`: why there is none.
    pub fn of(&self, name: &str, quiet: &Quiet) -> Result<f64, &'static str> {
        let Quiet { told, curve, .. } = quiet;
        let last = curve.len().saturating_sub(1);
        let found = match name {
            "push_in" => self.taken(told.places[0], curve),
            "pull_out" => self.taken(told.places[1], curve),
            "ratio" => self.ratio(told, curve),
            "work_in" => self.work(curve, told.inward).map(|own| (own, last)),
            "work_out" => self.work(curve, -told.inward).map(|own| (own, last)),
            "strain" => self.strain.map(|own| (own, last)),
            "deflection" => {
                let at = quiet.deflection().map(|own| own.0);
                at.map(|row| (curve[row][0].signum() * self.curve[row][0], row))
            }
            _ => None,
        };
        let (rate, row) = found.filter(|own| own.0.is_finite()).ok_or(LOST)?;
        if row >= self.one_sided { Err(ONE_SIDED) } else { Ok(rate) }
    }

    /// That of the size of the force at a row, and the row.
    fn taken(&self, row: Option<usize>, curve: &[[f64; 2]]) -> Option<(f64, usize)> {
        let row = row?;
        Some((curve.get(row)?[1].signum() * self.curve.get(row)?[1], row))
    }

    fn ratio(&self, told: &Told, curve: &[[f64; 2]]) -> Option<(f64, usize)> {
        let [(push, into), (pull, out)] =
            [self.taken(told.places[0], curve)?, self.taken(told.places[1], curve)?];
        let (force, ratio) = (curve[into][1].abs(), (curve[out][1] / curve[into][1]).abs());
        Some(((pull - ratio * push) / force, into.max(out)))
    }

    /// That of the work on the increments that go one way, which is linear in force and motion.
    fn work(&self, curve: &[[f64; 2]], way: f64) -> Option<f64> {
        let pairs = curve.windows(2).zip(self.curve.windows(2));
        let each = pairs.filter(|(own, _)| (own[1][0] - own[0][0]) * way > 0.0).map(|(own, by)| {
            let step = |ends: &[[f64; 2]]| ends[1][0] - ends[0][0];
            let force = |ends: &[[f64; 2]]| 0.5 * (ends[0][1] + ends[1][1]);
            force(by) * step(own) + force(own) * step(by)
        });
        Some(each.sum()).filter(|_| curve.len() == self.curve.len())
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

    use super::*;
    use crate::outcome::figure;
    use crate::solve::quietly;
    use slideline::{Job, ReadOptions};

    const DECK: &str = include_str!("../../../corpus/new/snap_fit.inp");
    const PLAIN: &str = include_str!("../../../corpus/tutorial/snap_fit.inp");

    fn opened(text: &str) -> Opened {
        let read = |name: &str, text: &str| Job::read_text(name, text, &ReadOptions::default());
        // equilibrium sharp enough for differences of whole runs
        let text = text.replace("*BOUNDARY", "*CONTROLS, PARAMETERS=FIELD\n1.0E-10\n*BOUNDARY");
        Opened::new("snap_fit.inp", &text, &[], &read)
    }

    /// Requirement: derivatives of key figures and of the curve are those of differences of whole runs, by
    /// parameters of the deck and by what was found in one without.
    #[test]
    fn figures_follow_as_whole_runs_do() {
        for (text, names) in
            [(DECK, ["thickness", "mu", "lead"]), (PLAIN, ["modulus", "angle", "stroke"])]
        {
            let opened = opened(text);
            let (values, mut room) = (Values::of(&opened.sliders, None).unwrap(), Room::default());
            let places =
                names.map(|name| opened.sliders.iter().position(|own| own.name == name).unwrap());
            let (quiet, rates) =
                differentiated(&opened, &values, &mut room, &places, &mut |_| true).unwrap();
            for (name, (place, rates)) in names.iter().zip(places.iter().zip(rates)) {
                let rates = rates.unwrap();
                let step = 1e-6 * values.0[*place];
                let mut side = |sign: f64| {
                    let own = values.with(*place, values.0[*place] + sign * step);
                    quietly(&opened, &own, &mut room, &mut |_| true).unwrap()
                };
                let sides = [side(-1.0), side(1.0)];
                for response in ["push_in", "pull_out", "ratio", "work_in", "work_out", "strain"] {
                    let [low, high] =
                        [&sides[0], &sides[1]].map(|own| figure(own, response).unwrap());
                    let difference = (high - low) / (2.0 * step);
                    let exact = rates.of(response, &quiet).unwrap();
                    let size = figure(&quiet, response).unwrap() / values.0[*place];
                    let off = (exact - difference).abs() / (difference.abs() + 1e-2 * size.abs());
                    assert!(off < 1e-3, "{response} by {name}: {exact} {difference}");
                }
            }
        }
    }
}
