//! The parameters of a run with what the states so far owe to them.

use super::neighbour::Level;
use super::parameter::{Parameter, SensitivityFault};
use super::stencil::{OFFSETS, PAIR, Side, Weights};
use super::touched::Touched;
use super::tries::STEPS;
use crate::plan::Plan;
use crate::start::Start;
use crate::users::UserFrictions;
use slideline_model::Model;
use std::ops::Range;

/// Steps of the pairs of neighbours that stand beside the base with its displacements, in scales of the
/// parameter. Their square is truncation of how forces follow a section or a law; rounding grows with their
/// inverse, but displacements have no part in it. The second one is asked where a law bends over the first and slips
/// are told by rates: between the positions of nodes that stick rounding would decide.
const BESIDE: &[f64] = &[1e-5, 1e-6];
/// Increments after which a larger step is tried again.
const AGAIN: usize = 8;

/// A parameter on the way through a run.
#[derive(Debug)]
pub struct Course {
    /// The parameter.
    pub parameter: Parameter,
    /// Pairs of neighbours beside the base, with what differs in them; `None`: more than the tangent can
    /// tell.
    pairs: Vec<(Level, Option<Touched>)>,
    /// Place of the pair that told last.
    told: usize,
    /// Whether there are no others.
    all_made: bool,
    /// Neighbours with the steps that were needed so far.
    levels: Vec<Level>,
    /// Places of the steps that did in the last increment and the one before.
    recent: [usize; 2],
    /// Derivative of the committed state, as `numbers` lists it.
    pub state: Vec<f64>,
    /// Derivative of what the step begins from.
    pub start: Vec<f64>,
    /// Whether the state depends on a derivative that was taken on one side.
    pub one_sided: bool,
    /// Whether an increment had no derivative by it: then the later ones have none either.
    pub is_lost: bool,
}

/// All parameters of a run, each with the pair of models beside that of the run.
#[derive(Debug)]
pub struct Varied {
    /// The parameters.
    pub courses: Vec<Course>,
    plan: Plan,
    users: UserFrictions,
}

impl Varied {
    /// Those of these parameters that a model can be differentiated by, and why it cannot by the
    /// others.
    pub fn of(
        parameters: &[Parameter],
        (plan, model): (&Plan, &Model),
        users: &UserFrictions,
    ) -> (Self, Vec<SensitivityFault>) {
        let mut varied = Self { courses: Vec::new(), plan: plan.clone(), users: users.clone() };
        let mut faults = Vec::new();
        for parameter in parameters {
            let parameter = parameter.clone();
            let pairs = match pair(&parameter, BESIDE[0], (plan, model, users)) {
                Ok(own) => vec![own],
                Err(fault) => {
                    faults.push(fault);
                    continue;
                }
            };
            varied.courses.push(Course {
                parameter,
                pairs,
                told: 0,
                all_made: false,
                levels: Vec::new(),
                recent: [0; 2],
                state: Vec::new(),
                start: Vec::new(),
                one_sided: false,
                is_lost: false,
            });
        }
        (varied, faults)
    }

    /// Names of the parameters.
    pub fn names(&self) -> impl ExactSizeIterator<Item = &str> {
        self.courses.iter().map(|own| &*own.parameter.name)
    }

    /// Makes the pair beside the base of that place; whether there is one.
    pub fn has_pair(&mut self, course: usize, place: usize, model: &Model) -> bool {
        let own = &mut self.courses[course];
        while own.pairs.len() <= place && !own.all_made {
            let step = BESIDE.get(own.pairs.len());
            let at = (&self.plan, model, &self.users);
            match step.and_then(|&step| pair(&own.parameter, step, at).ok()) {
                Some(new) => own.pairs.push(new),
                None => own.all_made = true,
            }
        }
        own.pairs.len() > place
    }

    /// The neighbours of a parameter with the step of that place.
    ///
    /// # Errors
    /// There are none.
    pub fn level(
        &mut self,
        course: usize,
        level: usize,
        model: &Model,
    ) -> Result<&Level, SensitivityFault> {
        let own = &mut self.courses[course];
        while own.levels.len() <= level {
            let h = STEPS[own.levels.len()] * own.parameter.scale;
            let at = (&own.parameter, h, &OFFSETS[..]);
            own.levels.push(Level::new(at, (&self.plan, model, &self.users))?);
        }
        Ok(&own.levels[level])
    }
}

/// The pair beside a model with a step, in scales of the parameter, and what differs in it.
fn pair(
    parameter: &Parameter,
    step: f64,
    (plan, model, users): (&Plan, &Model, &UserFrictions),
) -> Result<(Level, Option<Touched>), SensitivityFault> {
    let level = (parameter, step * parameter.scale, &PAIR[..]);
    let level = Level::new(level, (plan, model, users))?;
    let touched = match &level.near[..] {
        [(below, _), (above, _)] => Touched::of(model, [below, above]),
        _ => None,
    };
    Ok((level, touched))
}

impl Course {
    /// The neighbours with the step of a place that was made, in a step that begins from `start`,
    /// and the derivative of the state.
    pub fn parts(&mut self, place: usize, start: &Start<'_>) -> (&Level, &[f64]) {
        let level = &mut self.levels[place];
        level.take_starts(start, &self.start);
        (level, &self.state)
    }

    /// The pair of a place that was made, in a step that begins from `start`, what differs in it, and the
    /// derivative of the state; `None`: more differs than the tangent can tell.
    pub fn beside(
        &mut self,
        place: usize,
        start: &Start<'_>,
    ) -> Option<(&Level, &Touched, &[f64])> {
        let (level, touched) = self.pairs.get_mut(place)?;
        let touched = touched.as_ref()?;
        level.take_starts(start, &self.start);
        Some((level, touched, &self.state))
    }

    /// Places of the pairs to ask in an increment, one behind the other: now and then a wider one is tried
    /// again.
    pub fn pairs(&self, increment: usize) -> Range<usize> {
        let first = if increment.is_multiple_of(AGAIN) { 0 } else { self.told };
        match self.pairs[0].1.is_some() {
            true => first..BESIDE.len(),
            false => 0..0,
        }
    }

    /// Notes the place of a pair that told.
    pub fn note_pair(&mut self, place: usize) {
        self.told = place;
    }

    /// Whether the pair tells how a step begins: nothing comes or leaves.
    pub fn begins_simply(&self) -> bool {
        self.pairs[0].1.as_ref().is_some_and(|own| own.begins_simply)
    }

    /// The neighbours that tell how a step begins, with what each counts: the pair, or those with the
    /// step of a place that was made.
    pub fn of_beginning(&self, place: usize) -> (&Level, Vec<f64>) {
        if self.begins_simply() {
            let pair = &self.pairs[0].0;
            return (pair, PAIR.map(|side| 0.5 * side / pair.h).to_vec());
        }
        let level = &self.levels[place];
        (level, Weights::of(Side::Both, level.h).near.to_vec())
    }

    /// Place of the step to begin with: one increment that stands near a kink does not count. Now and
    /// then a larger one is tried again.
    pub fn first(&self, increment: usize) -> usize {
        let own = self.recent[0].min(self.recent[1]);
        if increment.is_multiple_of(AGAIN) { own.saturating_sub(1) } else { own }
    }

    /// Notes the place of a step that did.
    pub fn note(&mut self, place: usize) {
        self.recent = [place, self.recent[0]];
    }

    /// Notes how what a step begins from follows the parameter.
    pub fn begin_step(&mut self) {
        let pairs = self.pairs.iter_mut().map(|own| &mut own.0);
        self.levels.iter_mut().chain(pairs).for_each(Level::begin_step);
    }
}
