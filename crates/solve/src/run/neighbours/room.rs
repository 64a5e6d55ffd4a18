//! What the neighbours of an increment stand in, and how far their forces tell of rates.

use super::told::Shelf;
use crate::contact::MovingPoints;
use crate::newton::{Rates, Scratch, WholeTangent};
use crate::problem::Problem;
use crate::sensitivity::Bend;
use crate::state::State;
use crate::tangent::Kept;

/// What the neighbours stand in, one behind the other, to be used again.
#[derive(Default)]
pub struct Room {
    /// The step that there is room for, and its contact points; none: 0.
    pub(super) step: (usize, usize),
    /// The converged trial, evaluated once more.
    pub(super) base: Scratch,
    /// Points that the first round does not look at.
    pub(super) alone: Vec<bool>,
    pub(super) sides: [Scratch; 4],
    pub(super) before: [State; 4],
    pub(super) after: [State; 4],
    /// Where frames stand that observers ask for.
    pub(super) shelf: Shelf,
    /// What is kept of the tangent of the base.
    pub(super) kept: Kept,
    /// The linear system of that tangent, where it is not that of the run.
    pub(super) whole: WholeTangent,
    pub(super) tangent: Moves,
    /// Integration points that follow the closed part of their cells.
    pub(super) moving: MovingPoints,
    /// Room for the rates of a state.
    pub(super) rates_of_state: Vec<f64>,
    pub(super) rates: Rates,
    pub(super) residual: Vec<f64>,
    pub(super) defects: Vec<f64>,
    /// How forces follow, a dof each: those that nothing balances, and those of contact.
    pub(super) forces: [Vec<f64>; 2],
    /// What rounding makes of forces [F].
    pub(super) least_force: f64,
}

/// How the parts of an increment follow a parameter, and room to find it.
#[derive(Default)]
pub struct Moves {
    /// Displacements and rotations, a dof each.
    pub(super) moved: Vec<f64>,
    /// Forces of what the parameter touches of the elements, displacements held.
    pub(super) touched: Vec<f64>,
    /// All forces, loads among them.
    pub(super) force: Vec<f64>,
    /// Ends of the closed parts of cells, along their elements.
    pub(super) ends: Vec<f64>,
    /// Slips of closed integration points, a point each [L].
    pub(super) slips: Vec<f64>,
    /// Room for both neighbours.
    pub(super) pair: [Vec<f64>; 2],
}

impl Room {
    /// Makes room for a step.
    pub(super) fn fit(&mut self, plan: &Problem<'_>, step: usize) {
        let own = (step, plan.contact.points.len());
        if self.step != own {
            self.step = own;
            let shown = self.shelf.works.iter_mut();
            let all = self.sides.iter_mut().chain([&mut self.base]).chain(shown);
            all.for_each(|side| side.fit_near(plan));
            let elements = plan.structure.numbering.at_the_border(plan.constraints.numbering);
            self.kept.elements = elements;
        }
    }

    /// The bend of forces, those that nothing balances among them [1]: an error there is one of the
    /// rates.
    pub(super) fn bend_of_forces(
        &self,
        plan: &Problem<'_>,
        base: &Scratch,
        steps: (f64, f64),
    ) -> f64 {
        let [a, b, c, d] = self.sides.each_ref();
        let all = [a, b, base, c, d].map(|side| &side.evaluation);
        let mut bend = Bend::default();
        for dof in 0..plan.dofs.len() {
            let per = if plan.dofs.name(dof).1.is_rotation() { plan.lever } else { 1.0 };
            bend.note(all.map(|own| own.unbalanced(dof) / per));
            bend.note(all.map(|own| own.contact[dof] / per));
        }
        bend.of_rates(steps, self.least_force)
    }

    /// Largest rate of a force that should be balanced and is not, in the largest rate of a
    /// reaction or contact force, between neighbours with steps `h`.
    pub(super) fn unbalanced(&self, plan: &Problem<'_>, h: f64) -> f64 {
        let [left, touching] = &self.forces;
        let size = |list: &[f64], dof: usize| as_force(plan, list[dof], dof);
        let constraints = &plan.constraints;
        let largest = |most: f64, own: f64| most.max(own);
        let open = constraints.dof_of_equation.iter().map(|&dof| size(left, dof));
        let all = (0..left.len()).map(|dof| size(left, dof).max(size(touching, dof)));
        let (open, all) = (open.fold(0.0, largest), all.fold(0.0, largest));
        if all <= self.least_force / h.abs() { 0.0 } else { open / all }
    }
}

/// What rounding makes of forces where parts moved as they did: of those that hold single equations
/// where they are; where all rest, of what rounding of their places would be held by [F].
pub(super) fn least_force(plan: &Problem<'_>, tangent: &[f64], state: &State) -> f64 {
    let moved = |dof: usize| match plan.dofs.name(dof).1.is_rotation() {
        true => state.displacement[dof].abs() * plan.lever,
        false => state.displacement[dof].abs(),
    };
    let each = plan.constraints.dof_of_equation.iter().enumerate();
    let held = each.map(|(equation, &dof)| {
        let place = plan.pattern.position(equation, equation);
        let stiffness = place.map_or(0.0, |place| tangent[place]);
        let stiffness = match plan.dofs.name(dof).1.is_rotation() {
            true => stiffness.abs() / (plan.lever * plan.lever),
            false => stiffness.abs(),
        };
        stiffness * (moved(dof) + f64::EPSILON * plan.reach)
    });
    f64::EPSILON * held.fold(0.0, f64::max)
}

/// A force or moment as a force [F].
fn as_force(plan: &Problem<'_>, value: f64, dof: usize) -> f64 {
    let is_moment = plan.dofs.name(dof).1.is_rotation();
    (if is_moment { value / plan.lever } else { value }).abs()
}
