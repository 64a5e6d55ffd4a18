//! How the yield surface moves: kinematic hardening.
//!
//! ```text
//!           ____
//!        /  .   \    centre: the sum of the back stresses
//!       |   ^ a  |
//!        \__|__ /    a grows along the flow, and is recalled towards zero
//!           +
//! ```
//!
//! Armstrong and Frederick's law as a sum of several [chaboche1986], backward Euler; without recall
//! it is linear hardening. CalculiX tabulates the growth instead. docs/theory.md eq. (3.68).

use super::hardening::{Hardening, yield_stress};

/// A part of what moves the yield surface.
#[derive(Debug, Clone, PartialEq)]
pub enum BackStress {
    /// Grows with a modulus and is recalled.
    Evolving {
        /// Stress to plastic strain in tension at the beginning [F/L2].
        modulus: f64,
        /// Part of it that a unit of equivalent plastic strain recalls [1].
        recall: f64,
    },
    /// Grows with a table: stress [F/L2] over plastic strain [1], constant behind the last line.
    Table(Hardening),
}

impl BackStress {
    /// What an increment of the equivalent plastic strain from `before` keeps of the back stress
    /// [1], and what it adds, as a stress in tension [F/L2].
    pub(super) fn rise(&self, before: f64, strain: f64) -> [f64; 2] {
        match self {
            Self::Evolving { modulus, recall } => {
                let kept = 1.0 / (1.0 + recall * strain);
                [kept, kept * modulus * strain]
            }
            Self::Table(table) => {
                let at = |strain| yield_stress(table, strain)[0];
                [1.0, at(before + strain) - at(before)]
            }
        }
    }

    /// Derivatives of both by the increment.
    pub(super) fn slopes(&self, before: f64, strain: f64) -> [f64; 2] {
        match self {
            Self::Evolving { modulus, recall } => {
                let kept = 1.0 / (1.0 + recall * strain);
                [-recall * kept * kept, modulus * kept * kept]
            }
            Self::Table(table) => [0.0, yield_stress(table, before + strain)[1]],
        }
    }
}
