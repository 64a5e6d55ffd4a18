//! What holds a state back on its way downhill.

use slideline_mech::contact::tangential::Tangential;

/// Below this stiffness it holds nothing [1].
const LEAST: f64 = 1e-14;
/// Factor by which a step is held more than by what was too weak for one before [1].
const FIRMER: f64 = 2.0;
/// What is remembered of that behind every step [1].
const FADES: f64 = 0.8;

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
    /// What the accepted steps of the round have walked, and how far the round before got away.
    pub walked: f64,
    pub away: f64,
    /// Stiffness that was too weak for a step of late, less by [`FADES`] for every step since [1].
    pub too_weak: f64,
    /// What was estimated there.
    pub(super) estimates: Estimates,
}

impl Relaxation {
    /// Begins a way downhill.
    pub fn set_out(&mut self, stiffness: f64) {
        (self.stiffness, self.too_weak) = (stiffness, 0.0);
        (self.walked, self.away) = (0.0, 0.0);
    }

    /// Accepts a step; the next one is held by a multiple of what held it, and by more than what was
    /// too weak of late.
    pub fn walk(&mut self, way: f64, by: f64) {
        self.walked += way;
        self.stiffness = (self.stiffness * by).max(LEAST).max(FIRMER * self.too_weak);
        self.too_weak *= FADES;
    }

    /// Takes a step back, which may have been held too weakly; what it is repeated with is greater by
    /// a factor.
    pub fn take_back(&mut self, by: f64, was_weak: bool) {
        if was_weak {
            self.too_weak = self.stiffness;
        }
        self.stiffness *= by;
    }
}
