//! What supports a dof over the steps, and whether two dofs are supported alike.

use std::collections::HashMap;

use slideline_model::{Dof, NodeIndex};

use crate::draft::{Boundary, Draft};

/// How often products of factors that add up to one may be off [1].
const ROUNDINGS: f64 = 64.0;

/// A step in which a line, by its place, begins to hold a dof, or none does any longer.
type Change = (usize, Option<usize>);

/// Every dof that some step, or the deck before the first one, prescribes, with what happens to it.
#[derive(Default)]
pub(super) struct Supports {
    lines: Vec<Boundary>,
    changes: HashMap<(NodeIndex, Dof), Vec<Change>>,
}

impl Supports {
    pub(super) fn new(draft: &mut Draft) -> Self {
        let mut supports = Self::default();
        supports.take(0, draft.initial.clone(), draft);
        for step in 0..draft.steps.len() {
            if draft.steps[step].new_boundary {
                supports.release(step);
            }
            supports.take(step, draft.steps[step].boundary.clone(), draft);
        }
        supports
    }

    fn release(&mut self, step: usize) {
        for own in self.changes.values_mut().filter(|own| own.last().is_some_and(|l| l.1.is_some()))
        {
            own.push((step, None));
        }
    }

    fn take(&mut self, step: usize, lines: Vec<Boundary>, draft: &mut Draft) {
        for line in lines {
            let place = self.lines.len();
            for node in draft.nodes_of(&line.target, line.target_span) {
                for &dof in &line.dofs {
                    let own = self.changes.entry((node, dof)).or_default();
                    while own.last().is_some_and(|&(at, _)| at == step) {
                        own.pop();
                    }
                    own.push((step, Some(place)));
                }
            }
            self.lines.push(line);
        }
    }

    /// Whether two dofs are held at the same values, and let go, at the same times.
    pub(super) fn are_alike(&self, one: (NodeIndex, Dof), other: (NodeIndex, Dof)) -> bool {
        let (Some(one), Some(other)) = (self.changes.get(&one), self.changes.get(&other)) else {
            return false;
        };
        let what = |line: usize| {
            let own = &self.lines[line];
            (own.value, own.amplitude.as_ref().map(|(name, _)| name), own.fixed)
        };
        let mut both = one.iter().zip(other);
        one.len() == other.len() && both.all(|(a, b)| a.0 == b.0 && a.1.map(what) == b.1.map(what))
    }

    /// Whether a dof is held from the first step to the last.
    pub(super) fn is_always(&self, dof: (NodeIndex, Dof)) -> bool {
        let own = self.changes.get(&dof);
        own.is_some_and(|own| own[0].0 == 0 && own.iter().all(|(_, line)| line.is_some()))
    }

    /// Whether what holds `dof` follows from what holds those that it follows with these factors.
    pub(super) fn is_implied(
        &self,
        dof: (NodeIndex, Dof),
        terms: &[(NodeIndex, Dof, f64)],
    ) -> bool {
        let sum: f64 = terms.iter().map(|term| term.2).sum();
        let lines = self.changes.get(&dof).into_iter().flatten().filter_map(|(_, line)| *line);
        let stays = lines.map(|line| &self.lines[line]).all(|own| own.value == 0.0 && !own.fixed);
        let even = (sum - 1.0).abs() <= ROUNDINGS * f64::EPSILON;
        (even || stays) && terms.iter().all(|&(node, own, _)| self.are_alike(dof, (node, own)))
    }
}
