//! What a solver asks of the elements of a block: the border between the physics of one element and
//! everything that numbers, gathers, commits and writes.
//!
//! ```text
//!   displacements q, committed state, surroundings (kinematics, temperatures, time)
//!        |
//!        v         +--> force  dW/dq
//!     respond -----+--> tangent d2W/dq2     (not in the force-only mode)
//!        |         +--> trial state
//!        v
//!   strain energy W, or why there is none: a point turned inside out, say
//! ```
//!
//! A kernel holds the elements of one block, all of one type, and names them by their number in the
//! block. Whoever has a formulation of his own implements [`Kernel`], or [`Element`] for one element
//! of fixed size, and lets [`Instances`](super::Instances) do the rest.

use crate::material::Clock;
use crate::turn::Turn;
use serde::{Deserialize, Serialize};
use std::any::Any;
use std::fmt::Debug;

/// How strains follow displacements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Strains<'a> {
    /// Small displacements (a step without NLGEOM).
    Linear,
    /// Any displacement; the tangent is the derivative of the force.
    Exact,
    /// Any displacement; the geometric stiffness is that of these estimated stresses.
    Mixed(&'a [f64]),
}

/// Temperature at a node [theta].
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct Temperature {
    /// Of a solid, or of a beam's axis.
    pub value: f64,
    /// Growth across a beam [theta/L]: along axis 2 of its section, which is in the plane its tangent turned left by a right
    /// angle, and along axis 1, which counts in space alone.
    pub slopes: [f64; 2],
}

/// What an element responds under.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surroundings<'a> {
    /// How strains follow displacements.
    pub strains: Strains<'a>,
    /// Temperatures of its nodes; empty: all are zero and were.
    pub temperatures: &'a [Temperature],
    /// Those before the first step, at which it is free of stress; as many.
    pub initial: &'a [Temperature],
    /// What the rotations of its nodes in space count from; empty: from rest.
    pub turns: &'a [Turn],
    /// What the clock shows.
    pub clock: Clock,
}

impl Surroundings<'_> {
    /// Whether displacements may be large.
    pub fn is_large(&self) -> bool {
        self.strains != Strains::Linear
    }
}

impl<'a> From<Strains<'a>> for Surroundings<'a> {
    /// No temperatures, all turned from rest, and no time.
    fn from(strains: Strains<'a>) -> Self {
        Self { strains, temperatures: &[], initial: &[], turns: &[], clock: Clock::default() }
    }
}

/// Where a response is written.
#[derive(Debug)]
pub struct Response<'a> {
    /// Force dW/dq, an entry a variable [F or F L].
    pub force: &'a mut [f64],
    /// Tangent d2W/dq2, row-major; `None`: force only.
    pub tangent: Option<&'a mut [f64]>,
    /// State variables, were this state committed.
    pub state: &'a mut [f64],
}

/// Why an element has no answer at a displacement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The integration point of that number is turned inside out or has no volume left.
    InsideOut(usize),
    /// The integration point of that number of a ring has come to the axis.
    OnAxis(usize),
    /// At the integration point of that number no thickness is free of stress.
    NoThickness(usize),
    /// The element's own parameters have no equilibrium.
    NoEquilibrium,
    /// Force, energy or tangent are not finite.
    NotFinite,
}

/// How stiff an element is, for the rounding floor of residuals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// Largest stiffness against a displacement [F/L].
    pub stiffness: f64,
    /// Length that belongs to it [L]; `None`: it has none.
    pub length: Option<f64>,
}

/// The most variables an element may have: 27 nodes in space.
pub const MOST_VARIABLES: usize = 81;

/// The most nodes an element may have.
pub const MOST_NODES: usize = 27;

/// The elements of a block.
pub trait Kernel: Any + Debug + Send + Sync {
    /// Number of elements.
    fn count(&self) -> usize;

    /// Number of variables of an element, at most [`MOST_VARIABLES`].
    fn variables(&self) -> usize;

    /// Number of stresses of an element that an iteration may estimate apart.
    fn estimate_size(&self) -> usize {
        0
    }

    /// Whether it makes use of them.
    fn estimates(&self) -> bool {
        self.estimate_size() > 0
    }

    /// Writes force, tangent and trial state of an element at the displacements `q`, which it
    /// reaches from its committed state, and returns its strain energy [F L]. The force-only mode
    /// writes the same bits.
    ///
    /// # Errors
    /// What keeps the element from an answer there; what was written is of no meaning then.
    fn respond(
        &self,
        element: usize,
        q: &[f64],
        committed: &[f64],
        under: &Surroundings<'_>,
        into: Response<'_>,
    ) -> Result<f64, Failure>;

    /// Writes the force of estimated stresses at the displacements, the rotations of nodes in
    /// space counting from the turns; false where there are none to be estimated.
    fn force_of_stresses(
        &self,
        _element: usize,
        _at: (&[f64], &[Turn]),
        _stresses: &[f64],
        _force: &mut [f64],
    ) -> bool {
        false
    }

    /// Writes the stresses that a linear solution with the change `change` of `q` arrives at.
    fn stresses_after(
        &self,
        _element: usize,
        _q: &[f64],
        _change: &[f64],
        _under: &Surroundings<'_>,
        _into: &mut [f64],
    ) {
    }

    /// Raises estimated stresses that are next to none, in a model of size `reach` [L], to a slight
    /// tension: docs/theory.md eq. (3.30).
    fn tighten(&self, _element: usize, _reach: f64, _stresses: &mut [f64]) {}

    /// How stiff an element is.
    fn scale(&self, element: usize) -> Scale;

    /// Part of the energy of an element that it does not give back [F L], of a state and the
    /// displacements that it belongs to.
    fn dissipated(
        &self,
        _element: usize,
        _q: &[f64],
        _state: &[f64],
        _under: &Surroundings<'_>,
    ) -> f64 {
        0.0
    }

    /// By how much the creep strains of the increment that led to a state differ at most, taken by
    /// the conditions at its two ends [1].
    fn creep_difference(&self, _element: usize, _state: &[f64]) -> f64 {
        0.0
    }

    /// Writes what the element offers as results at `q` and its state, in the order of the fields
    /// that its type declares.
    fn results(
        &self,
        element: usize,
        q: &[f64],
        state: &[f64],
        under: &Surroundings<'_>,
        into: &mut [f64],
    );
}

/// One element of `N` variables without state; `NN` is `N` squared.
pub trait Element<const N: usize, const NN: usize>: Debug + Send + Sync {
    /// Writes force and tangent of small displacements, returns the strain energy [F L].
    fn linear(&self, q: &[f64; N], force: &mut [f64; N], tangent: &mut [f64; NN]) -> f64;

    /// Writes force and tangent, returns the strain energy [F L].
    fn exact(&self, q: &[f64; N], force: &mut [f64; N], tangent: &mut [f64; NN]) -> f64;

    /// Writes the force alone, with the bits of [`Element::exact`], returns the strain energy [F L].
    fn exact_force(&self, q: &[f64; N], force: &mut [f64; N]) -> f64 {
        self.exact(q, force, &mut [0.0; NN])
    }

    /// How stiff it is.
    fn scale(&self) -> Scale;

    /// Writes its results.
    fn results(&self, q: &[f64; N], linear: bool, into: &mut [f64]);

    /// Number of stresses that may be estimated apart.
    fn estimate_size(&self) -> usize {
        0
    }

    /// Writes force of the law and tangent with the geometric stiffness of `stresses`, returns the
    /// strain energy [F L]. See [`Mixed`](super::Mixed).
    fn mixed(
        &self,
        q: &[f64; N],
        _stresses: &[f64],
        force: &mut [f64; N],
        tangent: &mut [f64; NN],
    ) -> f64 {
        self.exact(q, force, tangent)
    }

    /// Writes the force of estimated stresses; false where there are none.
    fn force_of_stresses(&self, _q: &[f64; N], _stresses: &[f64], _force: &mut [f64; N]) -> bool {
        false
    }

    /// Writes the stresses that a linear solution with the change `change` arrives at.
    fn stresses_after(&self, _q: &[f64; N], _change: &[f64; N], _into: &mut [f64]) {}

    /// See [`Kernel::tighten`].
    fn tighten(&self, _reach: f64, _stresses: &mut [f64]) {}
}
