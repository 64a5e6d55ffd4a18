//! Models at neighbouring values of a parameter, and the step that they are in.

use super::numbers::move_start;
use super::parameter::{Parameter, SensitivityFault};
use crate::constraints::Constraints;
use crate::contact::Contact;
use crate::continued::Continued;
use crate::plan::Plan;
use crate::problem::Problem;
use crate::start::Start;
use crate::structure::{Kernels, Structure};
use crate::target::Target;
use crate::users::UserFrictions;
use crate::values::Values;
use slideline_model::Model;
use std::borrow::Cow;

/// The neighbours of a model with one step of a parameter.
#[derive(Debug)]
pub struct Level {
    /// The step of the parameter.
    pub h: f64,
    /// Where they stand, in steps.
    pub offsets: &'static [f64],
    /// Models and their values, in that order.
    pub near: Vec<(Model, Values)>,
    /// What the step at hand begins from in each; none yet: empty.
    starts: Vec<Start<'static>>,
}

impl Level {
    /// Those at some steps `h` of a parameter of `base`.
    ///
    /// # Errors
    /// A parameter that the model cannot be differentiated by.
    pub fn new(
        (parameter, h, offsets): (&Parameter, f64, &'static [f64]),
        (plan, base, users): (&Plan, &Model, &UserFrictions),
    ) -> Result<Self, SensitivityFault> {
        let name = || parameter.name.clone();
        let near = offsets.iter().map(|offset| {
            let model = (parameter.model)(parameter.value + offset * h);
            let model = model.ok_or_else(|| SensitivityFault::NoModel(name()))?;
            let mut values = Values::default();
            let same = plan.mismatch(&model).is_none() && values.take(plan, &model, users).is_ok();
            if !same {
                return Err(SensitivityFault::Outline(name()));
            }
            let times = model.steps.iter().zip(&base.steps);
            if times.into_iter().any(|(own, base)| own.procedure != base.procedure) {
                return Err(SensitivityFault::Times(name()));
            }
            Ok((model, values))
        });
        Ok(Self { h, offsets, near: near.collect::<Result<_, _>>()?, starts: Vec::new() })
    }

    /// Forgets what a step begins from: another one begins.
    pub fn begin_step(&mut self) {
        self.starts.clear();
    }

    /// Finds what the step begins from in every neighbour of one that begins from `start`, which
    /// moves by these derivatives.
    pub fn take_starts(&mut self, start: &Start<'_>, derivatives: &[f64]) {
        if self.starts.is_empty() {
            let steps = self.offsets.iter().map(|offset| offset * self.h);
            self.starts.extend(steps.map(|h| move_start(start, (derivatives, h))));
        }
    }

    /// The step of a neighbour in an increment of `base`.
    pub fn surroundings(
        &self,
        neighbour: usize,
        base: (&Problem<'_>, f64, &Target),
    ) -> Surroundings<'_> {
        let (model, values) = &self.near[neighbour];
        Surroundings::new((model, values), base, &self.starts[neighbour])
    }
}

/// What the step of a neighbour has of its own.
#[derive(Debug)]
pub struct Surroundings<'a> {
    model: &'a Model,
    values: &'a Values,
    contact: Cow<'a, Contact>,
    kernels: Option<Kernels>,
    /// What its step begins from.
    start: &'a Start<'static>,
}

impl<'a> Surroundings<'a> {
    /// Those of a neighbour of `base` in an increment from `time` [T] on that begins from `start`.
    fn new(
        (model, values): (&'a Model, &'a Values),
        (base, time, target): (&Problem<'_>, f64, &Target),
        start: &'a Start<'static>,
    ) -> Self {
        let step = &model.steps[target.step - 1];
        let contact = values.contact.of_step((model, base.dofs.len()), target.step - 1);
        let times = (time, target.step_time);
        let contact = match contact.at(times, step.procedure.period) {
            Some(changed) => Cow::Owned(changed),
            None => contact,
        };
        let references = if step.nlgeom { &*start.references } else { &[] };
        let is_own = !references.is_empty() || !step.sections.is_empty();
        let kernels = is_own.then(|| {
            let mut kernels = Kernels::default();
            // where an element cannot begin, the base said so
            let taken = kernels.take(base.structure.numbering, model, (references, &step.sections));
            taken.ok().map(|()| kernels)
        });
        Self { model, values, contact, kernels: kernels.flatten(), start }
    }

    /// The problem of the neighbour: numbering and pattern are those of the base.
    pub fn problem<'b>(&'b self, base: &Problem<'b>, step: usize) -> Problem<'b> {
        let Self { model, values, .. } = *self;
        let kernels = self.kernels.as_ref().unwrap_or(&values.kernels);
        let own = |numbered: usize| &model.steps[numbered];
        let before = step.checked_sub(2).map(own);
        let continued = Continued { amplitudes: &model.amplitudes, before };
        Problem {
            model,
            step: own(step - 1),
            before,
            largest_load: continued.largest_load(own(step - 1), values.reach),
            constraints: Constraints { motion: &values.motion, ..base.constraints },
            structure: Structure {
                kernels,
                references: &self.start.references,
                initial: &model.initial_temperatures,
                stiffest: values.kernels.stiffest,
                stiffest_length: values.kernels.stiffest_length,
                ..base.structure
            },
            contact: &self.contact,
            reach: values.reach,
            lever: values.lever,
            enforcement: None,
            faces: &values.faces[step - 1],
            start: self.start,
            ..*base
        }
    }
}
