//! What observers are shown of a state: rows, counts, the frame about them.

use crate::account::rounding;
use crate::balance::Sum;
use crate::contact::ContactKinematics;
use crate::heaviest::Measured;
use crate::newton::Outcome;
use crate::observe::results::{BeamRow, BlockResults, ContactRow, PairRow, SectionRow};
use crate::observe::{Frame, Nodal};
use crate::problem::Problem;
use crate::rows::{Gathered, contact_rows};
use crate::state::State;
use crate::structure::Ambient;
use crate::target::Target;
use slideline_mech::material::Clock;

/// What observers are shown of the committed state.
#[derive(Default)]
pub(super) struct Rows {
    /// A row a slave node.
    pub contact: Vec<ContactRow>,
    /// Scratch of the rows of integrated contact.
    gathered: Vec<Gathered>,
    /// Which contact rows were closed before the increment.
    pub closed: Vec<bool>,
    /// A row a pair.
    pub pairs: Vec<PairRow>,
    /// Pairs where they have carried most so far in the run.
    pub heaviest: Measured,
    /// A row a request for a surface.
    pub sections: Vec<SectionRow>,
    /// What the dofs of joined nodes carry, a dof each; empty where nobody asks.
    pub joined: Vec<f64>,
    /// Scratch of the rows of pairs.
    pub sums: Vec<Sum>,
    /// A row a beam.
    pub beams: Vec<BeamRow>,
    /// Results of the elements of every block.
    pub elements: Vec<BlockResults>,
}

impl Rows {
    /// Those of a state, whose contact may just have been evaluated; pairs are left as they are.
    pub fn fill(
        &mut self,
        plan: &Problem<'_>,
        (state, pushing): (&State, Option<&ContactKinematics>),
    ) {
        let rows = (&mut self.contact, &mut self.gathered);
        contact_rows((plan.model, plan.dofs), plan.contact, (state, pushing), rows);
        let ambient = Ambient {
            temperatures: &state.temperatures,
            turns: &state.turns,
            clock: Clock::default(),
        };
        let inside = (&state.elements[..], ambient);
        plan.structure.results(&state.displacement, inside, &mut self.elements);
        self.beams.clear();
        for results in &self.elements {
            let Some(beams) = plan.model.blocks[results.block].beams() else { continue };
            let rows = results.elements(plan.model);
            self.beams.extend(rows.map(|(beam, values)| BeamRow::of(beam, beams.section, values)));
        }
    }
}

/// Counts of a frame.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Numbers {
    pub step: usize,
    pub increment: usize,
    pub attempt: usize,
    pub severe: usize,
    pub equilibrium: usize,
    pub dt: f64,
    pub last: bool,
}

impl Numbers {
    /// Those of an attempt.
    pub fn of(target: &Target, outcome: &Outcome) -> Self {
        Self {
            step: target.step,
            increment: target.increment,
            attempt: target.attempt,
            severe: outcome.severe,
            equilibrium: outcome.equilibrium,
            dt: target.dt,
            last: false,
        }
    }
}

/// A state with its rows and counts.
pub(super) fn frame<'a>(
    plan: &'a Problem<'_>,
    state: &'a State,
    numbers: &Numbers,
    rows: &'a Rows,
) -> Frame<'a> {
    Frame {
        model: plan.model,
        step: numbers.step,
        increment: numbers.increment,
        attempt: numbers.attempt,
        severe_iterations: numbers.severe,
        equilibrium_iterations: numbers.equilibrium,
        total_time: state.total_time,
        step_time: state.step_time,
        time_increment: numbers.dt,
        last_of_step: numbers.last,
        nodal: Nodal {
            dofs: plan.dofs,
            axes: plan.constraints.motion.axes(),
            displacement: &state.displacement,
            reaction: &state.reaction,
            load: &state.load,
            joined: &rows.joined,
            turns: plan.step.nlgeom.then_some(&state.turns[..]),
            temperatures: match state.temperatures.is_empty() {
                true => &plan.model.initial_temperatures,
                false => &state.temperatures,
            },
        },
        contact: &rows.contact,
        pairs: &rows.pairs,
        sections: &rows.sections,
        beams: &rows.beams,
        elements: &rows.elements,
        energy: state.energy,
        energy_rounding: rounding(plan, state),
        energy_unsure: state.books.unsure,
    }
}
