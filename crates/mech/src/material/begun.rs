//! How points of a material begin: under stress, with plastic strain behind them, with fibres laid.

use super::answer::Conditions;
use super::law::Material;
use super::prestressed::{self, parted};
use super::tensor::Symmetric;

impl Material {
    /// State variables that begin a point under a Cauchy stress [F/L2], of a point that has this
    /// `state`; `None`: it keeps none, or bears no such stress.
    pub fn strain_before(
        &self,
        stress: &Symmetric,
        under: &Conditions,
        state: &[f64],
    ) -> Option<Symmetric> {
        match self {
            Self::Prestressed(own) => own.law.strain_to(stress, under, parted(state)[1]),
            _ => None,
        }
    }

    /// Begins a point with an equivalent plastic strain [1] and a first back stress [F/L2]. False,
    /// with nothing changed: it does not yield, or its yield surface does not move.
    pub fn harden(&self, strain: f64, back_stress: &Symmetric, state: &mut [f64]) -> bool {
        match self {
            Self::Plastic(own) => own.harden(strain, back_stress, state),
            Self::Graded(own) => {
                own.rows().next().is_some_and(|law| law.harden(strain, back_stress, state))
            }
            Self::Expanding(own) => own.law.harden(strain, back_stress, state),
            Self::Creeping(own) => own.metal.harden(strain, back_stress, state),
            Self::Prestressed(own) => match state.get_mut(prestressed::STATES..) {
                Some(rest) => own.law.harden(strain, back_stress, rest),
                None => false,
            },
            _ => false,
        }
    }

    /// The symmetric displacement gradient that a Cauchy stress [F/L2] belongs to, from a `state` of
    /// the law; `None`: it bears no such stress.
    pub fn strain_to(
        &self,
        stress: &Symmetric,
        under: &Conditions,
        state: &[f64],
    ) -> Option<Symmetric> {
        if let Self::Prestressed(own) = self {
            return own.law.strain_to(stress, under, state);
        }
        let rest = state.get(..self.states())?;
        prestressed::before(stress, under.large, |gradient| {
            self.respond(gradient, under, rest, &mut rest.to_vec())
        })
    }

    /// Largest strain with which a point of this `state` begins, [1]: zero where it begins free of stress.
    pub fn strained_before(&self, state: &[f64]) -> f64 {
        match self {
            Self::Prestressed(_) => {
                parted(state)[0].iter().fold(0.0, |most, own| most.max(own.abs()))
            }
            _ => 0.0,
        }
    }

    /// How many families of fibres it has.
    pub fn families(&self) -> usize {
        match self {
            Self::Fibrous(tissue) => tissue.directions.len(),
            Self::Expanding(own) => own.law.families(),
            Self::Prestressed(own) => own.law.families(),
            _ => 0,
        }
    }

    /// Lays its fibres along these directions, unit vectors along its axes.
    pub fn lay(&mut self, directions: &[[f64; 3]]) {
        match self {
            Self::Fibrous(tissue) => tissue.directions = directions.to_vec(),
            Self::Expanding(own) => own.law.lay(directions),
            Self::Prestressed(own) => own.law.lay(directions),
            _ => {}
        }
    }
}
