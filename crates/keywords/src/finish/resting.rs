//! Distributed loads from step to step.
//!
//! ```text
//!   element 7, weight --- forces of a unit load x value: 4 --> 6, or --> 0
//!   element 7, face 2 --- pressure
//! ```

use std::collections::HashSet;
use std::rc::Rc;

use slideline_diag::Span;
use slideline_model::{self as model, Dialect, Dof, Load, NodeIndex, Pressure};

use super::distributed::resolve;
use super::load_forces::What;
use super::standing::{Curved, Standing};
use crate::distributed::{Distributed, Key};
use crate::draft::Draft;

/// What rests on elements: pressures and forces.
#[derive(Clone, Default)]
pub(super) struct InForce {
    standing: Standing<(usize, Key), Entry>,
    /// The first pressure or force of each in the lists of the step before.
    first: Vec<usize>,
    /// Those on elements that are absent: they act again when these come back.
    waiting: Vec<((usize, Key), Entry)>,
}

#[derive(Clone)]
struct Entry {
    what: Rc<What>,
    value: f64,
    amplitude: Option<usize>,
    origin: Span,
}

impl Curved for Entry {
    fn amplitude(&self) -> Option<usize> {
        self.amplitude
    }
}

impl InForce {
    /// What a further step copies.
    pub fn size(&self) -> usize {
        self.standing.len() + self.waiting.len()
    }

    /// Values that stand, with their amplitudes.
    pub fn values(&mut self) -> impl Iterator<Item = (&mut f64, &mut Option<usize>)> {
        let waiting = self.waiting.iter_mut().map(|(_, entry)| entry);
        let all = self.standing.iter_mut().chain(waiting);
        all.map(|entry| (&mut entry.value, &mut entry.amplitude))
    }

    /// `OP=NEW` of `*DLOAD` and of `*DSLOAD`: each removes its own, in CalculiX both.
    pub fn renew(&mut self, [elements, surfaces]: [bool; 2], dialect: Dialect) {
        let both = dialect == Dialect::Calculix && (elements || surfaces);
        let gone = |key: &Key| both || if key.of_surface { surfaces } else { elements };
        self.standing.remove(|(_, key)| gone(key));
        self.waiting.retain(|((_, key), _)| !gone(key));
    }

    /// Lets the loads on absent elements wait, and those act again whose elements are back.
    pub fn wait(&mut self, absent: impl Fn(usize) -> bool) {
        let back = self.waiting.extract_if(.., |((element, _), _)| !absent(*element));
        self.standing.take(back.collect());
        let gone = |&(element, _): &(usize, Key)| absent(element);
        let standing = self.standing.keyed().filter(|(key, _)| gone(key));
        self.waiting.extend(standing.map(|(key, entry)| (key, entry.clone())));
        self.standing.remove(gone);
    }

    /// The loads of a step, with those that ramp off where they do not vanish `at_once`.
    pub fn loads(&mut self, at_once: bool, draft: &Draft) -> model::Distributed {
        let leaving = self.standing.succeed(|old, new| draft.same_curve(old, new));
        let mut loads = model::Distributed::default();
        let mut first = Vec::with_capacity(self.standing.len());
        for (entry, before) in self.standing.iter() {
            first.push(entry.place(&loads));
            let before = before.map(|before| (&before.load, self.first[before.place]));
            entry.add(before.filter(|(old, _)| entry.goes_on_from(old)), at_once, &mut loads);
            // a traction of another direction leaves along its own
            let leaves = entry.amplitude.is_none() && !at_once;
            if let Some(other) = before.filter(|(old, _)| leaves && !entry.goes_on_from(old)) {
                other.0.ramped_off().add(Some(other), at_once, &mut loads);
            }
        }
        for before in leaving.iter().filter(|_| !at_once) {
            let old = (&before.load, self.first[before.place]);
            before.load.ramped_off().add(Some(old), at_once, &mut loads);
        }
        self.first = first;
        loads
    }

    /// What stands is that of the step before from now on.
    pub fn pass(&mut self) {
        self.standing.pass();
    }

    /// Puts the lines of a step into force, each with its amplitude.
    pub fn take(&mut self, lines: &[(&Distributed, Option<usize>)], draft: &mut Draft) {
        let mut new = Vec::new();
        for &(line, amplitude) in lines {
            for (place, what) in resolve(line, draft) {
                let (what, value) = (Rc::new(what), line.value);
                new.push((place, Entry { what, value, amplitude, origin: line.origin }));
            }
        }
        let named: HashSet<(usize, Key)> = new.iter().map(|(place, _)| *place).collect();
        self.waiting.retain(|(place, _)| !named.contains(place));
        self.standing.take(new);
    }
}

impl Entry {
    /// Where its first pressure or force will stand.
    fn place(&self, loads: &model::Distributed) -> usize {
        match *self.what {
            What::Pressure(..) => loads.pressures.len(),
            What::Forces(_) => loads.forces.len(),
        }
    }

    /// Whether it differs from another load in its size alone, or in the forces on its nodes.
    fn goes_on_from(&self, old: &Self) -> bool {
        match (&*self.what, &*old.what) {
            (What::Pressure(own, _), What::Pressure(old, _)) => own == old,
            (What::Forces(_), What::Forces(_)) => true,
            _ => false,
        }
    }

    /// The same, on its way to nothing.
    fn ramped_off(&self) -> Self {
        Self { value: 0.0, amplitude: None, ..self.clone() }
    }

    /// Adds it to the loads of a step; `before`: what it goes on from, and where that began in the
    /// list of the step before.
    fn add(&self, before: Option<(&Self, usize)>, at_once: bool, loads: &mut model::Distributed) {
        let (value, amplitude, origin) = (self.value, self.amplitude, self.origin);
        match &*self.what {
            What::Pressure(on, nodes) => {
                let continues = before.map(|(_, place)| place);
                let (on, nodes) = (on.clone(), nodes.clone());
                let pressure = Pressure { on, nodes, value, amplitude, continues, origin };
                loads.pressures.push(pressure);
            }
            What::Forces(forces) => {
                let (old, first) =
                    before.map_or((&[][..], 0), |(old, first)| (old.forces(), first));
                let mut left: Vec<bool> = vec![amplitude.is_none() && !at_once; old.len()];
                for (k, &(node, dof, share)) in forces.iter().enumerate() {
                    let at = place_of((node, dof), old, k);
                    at.into_iter().for_each(|at| left[at] = false);
                    let (value, continues) = (share * value, at.map(|at| first + at));
                    loads.forces.push(Load { node, dof, value, amplitude, continues, origin });
                }
                // a weight that turns leaves its old direction
                for (k, &(node, dof, _)) in old.iter().enumerate().filter(|&(k, _)| left[k]) {
                    let (value, continues) = (0.0, Some(first + k));
                    loads.forces.push(Load { node, dof, value, amplitude, continues, origin });
                }
            }
        }
    }

    /// Forces of a unit load; none of a pressure.
    fn forces(&self) -> &[(NodeIndex, Dof, f64)] {
        match &*self.what {
            What::Pressure(..) => &[],
            What::Forces(forces) => forces,
        }
    }
}

/// Where a list has a force on this dof: at `near`, as a rule.
fn place_of(
    (node, dof): (NodeIndex, Dof),
    list: &[(NodeIndex, Dof, f64)],
    near: usize,
) -> Option<usize> {
    let is = |own: &(NodeIndex, Dof, f64)| (own.0, own.1) == (node, dof);
    match list.get(near) {
        Some(own) if is(own) => Some(near),
        _ => list.iter().position(is),
    }
}
