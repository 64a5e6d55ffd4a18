//! How dofs follow others in a configuration.

use super::linear::{Kept, LinearConstraint};
use super::motion::Motion;
use super::numbering::ConstraintNumbering;
use super::rigid::RigidLink;
use slideline_mech::rigid::PlaneTurn;
use slideline_mech::turn::Turn;
use slideline_model::Axes;
use std::ops::Deref;

/// The constraints of a step at work: what follows what, and how far.
#[derive(Clone, Copy, Debug)]
pub struct Constraints<'a> {
    /// Roles and equations, of the plan.
    pub numbering: &'a ConstraintNumbering,
    /// Arms and coefficients, of the values.
    pub motion: &'a Motion,
}

impl Deref for Constraints<'_> {
    type Target = ConstraintNumbering;

    fn deref(&self) -> &ConstraintNumbering {
        self.numbering
    }
}

impl Constraints<'_> {
    /// Moves dependent dofs to where the others take them.
    /// `turns`: what the rotations of nodes in space count from; empty: from rest.
    pub fn enforce(&self, turns: &[Turn], u: &mut [f64]) {
        let mut linear = self.linear.iter().enumerate();
        let follow = |(row, constraint): (usize, &LinearConstraint), u: &mut [f64]| {
            match &constraint.kept {
                Kept::Nothing => {
                    let (coefficients, constant) = self.motion.linear(row);
                    constraint.enforce(coefficients, constant, u);
                }
                Kept::Shape(shape) => shape.enforce(constraint.dependent, &self.motion.places, u),
                Kept::Mean(Some(mean)) => mean.enforce(self.motion.cloud(mean.place), turns, u),
                Kept::Mean(None) => {} // the first of its rows has moved it
            }
        };
        linear.by_ref().take(self.leading).for_each(|own| follow(own, u));
        let links = self.rigid.iter().zip(&self.motion.arms);
        let mut turned = PlaneTurn::NONE;
        links.for_each(|(link, &arm)| {
            link.enforce((arm, self.axes_of(link)), (turns, &mut turned), u);
        });
        linear.for_each(|own| follow(own, u));
    }

    /// The own axes of the dependent node of a link, where it has some.
    pub(super) fn axes_of(&self, link: &RigidLink) -> Option<&Axes> {
        self.motion.axes.get(link.place_of_turned()?)
    }
}
