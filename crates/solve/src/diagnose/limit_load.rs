//! Metal that flows without hardening until nothing carries more.

use super::case::Case;
use crate::increments::Verdict;
use crate::structure::Ambient;
use slideline_diag::{Code, Diagnostic};
use slideline_linalg::SolveError;
use slideline_mech::material::{Clock, HardeningEnd};
use slideline_model::{ElementBlock, Section};

/// The element whose plastic strain grew most behind the end of its hardening.
struct Flowing {
    block: usize,
    member: usize,
    /// Plastic strain of its point.
    strain: Growth,
    /// Elastic strain at its yield stress [1].
    elastic: f64,
    /// Elements that flow so, with this one.
    count: usize,
}

/// A plastic strain that grew.
#[derive(Clone, Copy)]
struct Growth {
    /// At the last commit [1].
    before: f64,
    /// In the last attempt [1].
    now: f64,
}

impl Growth {
    fn size(self) -> f64 {
        self.now - self.before
    }
}

impl Case<'_> {
    /// A load that grew until elements flow at a yield stress that grows no more.
    pub(super) fn limit_load(&self) -> Option<Diagnostic> {
        if !self.is_loaded() {
            return None;
        }
        let flowing = self.flowing()?;
        let singular = matches!(self.outcome.fault, Some(SolveError::Singular { .. }));
        let softens = self.work.negative_pivots > 0;
        let unbounded = self.outcome.verdict == Verdict::FlowsAway || singular || softens;
        if !unbounded && flowing.strain.size() < flowing.elastic {
            return None;
        }
        let block = &self.plan.model.blocks[flowing.block];
        let element = block.elements.get(flowing.member);
        let (others, flow) = match flowing.count {
            1 => (String::new(), "flows"),
            count => (format!(" and {} more", count - 1), "flow"),
        };
        let message = format!(
            "the limit load is reached {}: element {} ({}){others} of {} {flow} without hardening, and \
             nothing beside carries more; the plastic strain of element {} grew from {:.3e} to {:.3e} \
             in the last attempt",
            self.beyond(),
            element.label,
            block.word(),
            block.name,
            element.label,
            flowing.strain.before,
            flowing.strain.now,
        );
        let said = Diagnostic::error(Code("SL0525"), message).at(element.origin).help(
            "the results up to that time are kept, and the load at their end is the limit load; \
             prescribe a motion with *BOUNDARY in place of the load, or give *PLASTIC a further line: \
             behind the last one the yield stress stays",
        );
        Some(match self.motion_for_load() {
            Some(own) => said.card(own.place, own.text),
            None => said,
        })
    }

    /// Whether a force or a pressure acts in the step.
    fn is_loaded(&self) -> bool {
        let step = self.plan.step;
        let forces = step.loads.iter().chain(&step.distributed.forces).any(|own| own.value != 0.0);
        forces || step.distributed.pressures.iter().any(|own| own.value != 0.0)
    }

    /// What flows in the last attempt, or would if the last motion went on: where the tangent turns
    /// negative at once, iterations may end anywhere. `None`: nothing.
    fn flowing(&self) -> Option<Flowing> {
        let mut now = self.committed.elements.clone();
        self.plan.structure.gather_state(&self.work.evaluation.contributions, &mut now);
        self.flowed(&now).or_else(|| self.flowed(&self.further()?))
    }

    /// States of the elements at the end of the last attempt, were the last increment to go on.
    fn further(&self) -> Option<Vec<f64>> {
        let before = self.committed;
        let last = before.increment_time.0;
        if last <= 0.0 {
            return None;
        }
        let on = before.displacement.iter().zip(&before.increment);
        let u: Vec<f64> = on.map(|(u, du)| u + self.dt / last * du).collect();
        let ambient = Ambient {
            temperatures: &before.temperatures,
            turns: &before.turns,
            clock: Clock::default(),
        };
        Some(self.plan.structure.states_at(&u, &before.elements, &ambient))
    }

    /// What has flowed from the last commit to these states.
    fn flowed(&self, now: &[f64]) -> Option<Flowing> {
        let before = &self.committed.elements;
        let mut most: Option<Flowing> = None;
        let (mut first, mut count) = (0, 0);
        for (block, own) in self.plan.model.blocks.iter().enumerate() {
            for member in 0..own.elements.len() {
                let range = first..first + own.states();
                first = range.end;
                let Some((strain, end)) = flow(own, [&before[range.clone()], &now[range]]) else {
                    continue;
                };
                count += 1;
                let flowing = Flowing { block, member, strain, elastic: end.elastic_strain, count };
                if most.as_ref().is_none_or(|most| flowing.strain.size() > most.strain.size()) {
                    most = Some(flowing);
                }
            }
        }
        most.map(|most| Flowing { count, ..most })
    }
}

/// Plastic strains of the point of an element that grew most behind the end of its hardening, before
/// and now; `None`: none did.
fn flow(block: &ElementBlock, states: [&[f64]; 2]) -> Option<(Growth, HardeningEnd)> {
    let Section::Solid(section) = &block.section else { return None };
    let end = section.material.hardening_end()?;
    let size = block.point_states();
    if size == 0 {
        return None;
    }
    let [before, now] = states.map(|state| state.chunks_exact(size).take(block.kind.points));
    let strain = |state: &[f64]| section.material.plastic_strain(state);
    let points = before
        .zip(now)
        .filter_map(|(before, now)| Some(Growth { before: strain(before)?, now: strain(now)? }));
    let grown = points.filter(|own| own.size() > 0.0 && own.now >= end.plastic_strain);
    let most = grown.max_by(|a, b| a.size().total_cmp(&b.size()))?;
    Some((most, end))
}
