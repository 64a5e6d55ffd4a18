//! What is prescribed and what acts at a time of a step.
//!
//! ```text
//!   load |    step 1     step 2
//!        |      ____...            a load that goes on: from its own value
//!        |     /    \              one that is removed ramps off
//!        |____/      \____
//! ```
//!
//! docs/theory.md eq. (9.5).

use crate::constraints::Role;
use crate::continued::Continued;
use crate::problem::Problem;
use slideline_mech::element::Temperature;
use slideline_model::{Amplitude, Dialect, Load, Step};

impl Problem<'_> {
    /// Puts the prescribed values of a time of the step into `u`.
    pub fn prescribe(&self, step_time: f64, u: &mut [f64]) {
        for (dof, role) in self.constraints.roles.iter().enumerate() {
            if let Role::Prescribed(place) = *role {
                let prescribed = &self.step.prescribed[place];
                let amplitude = self.amplitude(prescribed.amplitude);
                let start = self.start.displacement[dof];
                u[dof] = match prescribed.fixed {
                    true => start,
                    false => self.at(step_time, start, prescribed.value, amplitude),
                };
            }
        }
    }

    /// Puts the loads of a time of the step into `load`, eq. (9.5).
    pub fn load(&self, step_time: f64, load: &mut [f64]) {
        load.fill(0.0);
        let (step, dofs) = (self.step, self.dofs);
        let concentrated = step.loads.iter().map(|own| (dofs.named(own.node, own.dof), own));
        for (dof, own) in concentrated {
            let Some(dof) = dof else { continue };
            load[dof] += self.applied(step_time, own, |before| &before.loads);
        }
        for own in &step.distributed.forces {
            let Some(dof) = dofs.find(own.node, own.dof) else { continue };
            load[dof] += self.applied(step_time, own, |before| &before.distributed.forces);
        }
        // A support that is released lets go over the step (manual), and so does what is removed,
        // eq. (9.6); in CalculiX they are gone when it begins.
        if self.model.dialect == Dialect::Abaqus {
            for (value, &reaction) in load.iter_mut().zip(&*self.start.released) {
                *value += self.at(step_time, reaction, 0.0, None);
            }
        }
    }

    /// The pressures on faces at a time of the step [F/L2], eq. (9.5).
    pub fn pressures(&self, step_time: f64) -> impl Iterator<Item = f64> + '_ {
        self.step.distributed.pressures.iter().map(move |own| {
            let start = self.continued().start_of(own.continues, |before, place| {
                let before = before.distributed.pressures.get(place)?;
                Some((before.value, before.amplitude))
            });
            self.at(step_time, start, own.value, self.amplitude(own.amplitude))
        })
    }

    /// A load of a list at a time of the step.
    fn applied(&self, step_time: f64, own: &Load, list: fn(&Step) -> &[Load]) -> f64 {
        let start = self.continued().start_of_load(own, list);
        self.at(step_time, start, own.value, self.amplitude(own.amplitude))
    }

    /// What loads of the step go on from.
    fn continued(&self) -> Continued<'_> {
        Continued { amplitudes: &self.model.amplitudes, before: self.before }
    }

    fn amplitude(&self, place: Option<usize>) -> Option<&Amplitude> {
        place.map(|place| &self.model.amplitudes[place])
    }

    /// Puts the temperatures of a time of the step into `all`, a node each; none where the model
    /// knows of none.
    pub fn temperatures(&self, step_time: f64, all: &mut Vec<Temperature>) {
        all.clear();
        if !self.model.has_temperatures() {
            return;
        }
        let initial = |node| self.model.initial_temperature(node);
        let start = |node| self.start.temperatures.get(node).copied().unwrap_or(initial(node));
        let between = |node, end: Temperature, amplitude: Option<usize>| {
            let amplitude = self.amplitude(amplitude);
            let start = start(node);
            let at = |start, end| self.at(step_time, start, end, amplitude);
            let slopes = [0, 1].map(|k| at(start.slopes[k], end.slopes[k]));
            Temperature { value: at(start.value, end.value), slopes }
        };
        // What the step before heated and this one does not name goes back to where it began.
        all.extend((0..self.model.nodes.len()).map(|node| between(node, initial(node), None)));
        for entry in &self.step.temperatures {
            all[entry.node] = between(entry.node, entry.temperature, entry.amplitude);
        }
    }

    /// A value between the start of the step and its end.
    fn at(&self, step_time: f64, start: f64, end: f64, amplitude: Option<&Amplitude>) -> f64 {
        let period = self.step.procedure.period;
        match amplitude {
            Some(amplitude) => end * amplitude.at(step_time),
            None if self.step.at_once || step_time >= period => end,
            None => start + (end - start) * (step_time / period),
        }
    }
}
