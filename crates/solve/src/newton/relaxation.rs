//! What holds a state back on its way downhill.

use slideline_mech::contact::tangential::Tangential;

/// What an iteration estimates beside the displacements.
#[derive(Clone, Debug, Default)]
pub(super) struct Estimates {
    pub(super) pressures: Vec<f64>,
    pub(super) tractions: Vec<Tangential>,
    pub(super) stresses: Vec<f64>,
    pub(super) standing: Vec<Option<usize>>,
}

/// What holds a state back on its way.
#[derive(Clone, Debug, Default)]
pub(super) struct Relaxation {
    /// mu, in stiffnesses of the stiffest element; zero: none.
    pub stiffness: f64,
    /// State at the beginning of the step, a dof each.
    pub anchor: Vec<f64>,
    /// State at the beginning of the round of steps, a dof each.
    pub round: Vec<f64>,
    /// What was estimated there.
    pub(super) estimates: Estimates,
}
