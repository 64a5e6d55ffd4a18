//! The parameters of a run with what the states so far owe to them.

use super::neighbour::Level;
use super::parameter::{Parameter, SensitivityFault};
use super::tries::STEPS;
use crate::plan::Plan;
use crate::start::Start;
use crate::users::UserFrictions;
use slideline_model::Model;

/// Increments after which a larger step is tried again.
const AGAIN: usize = 8;

/// A parameter on the way through a run.
#[derive(Debug)]
pub struct Course {
    /// The parameter.
    pub parameter: Parameter,
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

/// All parameters of a run.
#[derive(Debug)]
pub struct Varied {
    /// The parameters.
    pub courses: Vec<Course>,
    plan: Plan,
    users: UserFrictions,
}

impl Varied {
    /// The parameters of a model.
    ///
    /// # Errors
    /// A parameter that the model cannot be differentiated by.
    pub fn new(
        parameters: &[Parameter],
        (plan, model): (&Plan, &Model),
        users: &UserFrictions,
    ) -> Result<Self, SensitivityFault> {
        let mut varied = Self { courses: Vec::new(), plan: plan.clone(), users: users.clone() };
        for parameter in parameters {
            let parameter = parameter.clone();
            varied.courses.push(Course {
                parameter,
                levels: Vec::new(),
                recent: [0; 2],
                state: Vec::new(),
                start: Vec::new(),
                one_sided: false,
                is_lost: false,
            });
            varied.level(varied.courses.len() - 1, 0, model)?;
        }
        Ok(varied)
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
            let at = (&own.parameter, h);
            own.levels.push(Level::new(at, (&self.plan, model, &self.users))?);
        }
        Ok(&own.levels[level])
    }
}

/// Why a model has no derivative by a parameter, if it has none.
pub fn sensitivity_fault(
    parameter: &Parameter,
    (plan, model): (&Plan, &Model),
    users: &UserFrictions,
) -> Option<SensitivityFault> {
    Varied::new(std::slice::from_ref(parameter), (plan, model), users).err()
}

impl Course {
    /// The neighbours with the step of a place that was made, in a step that begins from `start`,
    /// and the derivative of the state.
    pub fn parts(&mut self, place: usize, start: &Start<'_>) -> (&Level, &[f64]) {
        let level = &mut self.levels[place];
        level.take_starts(start, &self.start);
        (level, &self.state)
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
        self.levels.iter_mut().for_each(Level::begin_step);
    }
}
