//! What a step begins from: the end of the one before.
//!
//! ```text
//!   reaction |    step 1     step 2
//!            |      ____               reactions of supports that step 2 releases
//!            |     /    \              ramp off over it
//!            |____/      \____
//! ```
//!
//! What loads begin from follows from the model: `history`.

use crate::constraints::ConstraintNumbering;
use crate::state::State;
use crate::structure::Reference;
use serde::{Deserialize, Serialize};
use slideline_mech::element::Temperature;
use std::borrow::Cow;

/// What a step begins from, a dof each.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct Start<'a> {
    /// Displacements and rotations [L or 1].
    pub displacement: Cow<'a, [f64]>,
    /// Reactions of supports that the step releases, and forces of what it removes; they ramp off
    /// over it [F or F L].
    pub released: Cow<'a, [f64]>,
    /// Temperatures, a node each; empty: those before the first step [theta].
    pub temperatures: Cow<'a, [Temperature]>,
    /// Where elements begin that were added free of strain, in this step or before, by ascending
    /// element.
    pub references: Cow<'a, [Reference]>,
}

impl Start<'_> {
    /// Takes what a step begins from out of the state before it. Of the reactions, those of
    /// dofs that the step leaves free become loads that ramp off. The references stay.
    pub fn take(&mut self, state: &State, constraints: &ConstraintNumbering) {
        let into = |list: &mut Cow<'_, [f64]>, from: &[f64]| {
            let list = list.to_mut();
            list.clear();
            list.extend_from_slice(from);
        };
        into(&mut self.displacement, &state.displacement);
        into(&mut self.released, &state.reaction);
        self.temperatures.to_mut().clone_from(&state.temperatures);
        for (dof, force) in self.released.to_mut().iter_mut().enumerate() {
            if constraints.equation(dof).is_none() {
                *force = 0.0;
            }
        }
    }

    /// The same, to be kept.
    pub fn owned(&self) -> Start<'static> {
        Start {
            displacement: Cow::Owned(self.displacement.clone().into_owned()),
            released: Cow::Owned(self.released.clone().into_owned()),
            temperatures: Cow::Owned(self.temperatures.clone().into_owned()),
            references: Cow::Owned(self.references.clone().into_owned()),
        }
    }

    /// The same, borrowed.
    pub fn borrowed(&self) -> Start<'_> {
        Start {
            displacement: Cow::Borrowed(&self.displacement),
            released: Cow::Borrowed(&self.released),
            temperatures: Cow::Borrowed(&self.temperatures),
            references: Cow::Borrowed(&self.references),
        }
    }
}
