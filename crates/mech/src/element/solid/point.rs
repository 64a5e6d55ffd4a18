//! A point of a deformed element: gradient, slopes by deformed position, stress.

use crate::element::kernel::Surroundings;
use crate::material::Answer;
use crate::material::tensor::{Matrix, Moduli, Symmetric, dilation};

/// What an element responds under, its committed state and its trial state.
pub(super) type States<'a, 'b> = (&'a Surroundings<'a>, &'a [f64], &'b mut [f64]);

/// A point of a deformed element, as forces and tangents are made of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point<const D: usize, const N: usize> {
    /// Undeformed volume it stands for [L3].
    pub weight: f64,
    /// Derivatives of the shape functions by deformed position, axis by axis [1/L].
    pub slopes: [[f64; N]; D],
    /// Shape functions over the deformed radius; zeros but for rings [1/L].
    pub hoop: [f64; N],
    /// H of the displacements, enhanced ones included.
    pub gradient: Matrix,
    /// J - 1, or the sum of small strains.
    pub dilation: f64,
    /// Kirchhoff stress that does work on the gradients of displacements.
    pub stress: Symmetric,
    /// The part of it that turns with them: all, or none where displacements are small.
    pub turning: Symmetric,
    /// Its moduli.
    pub moduli: Moduli,
    /// Energy per undeformed volume.
    pub energy: f64,
    /// The part of it that is not given back.
    pub dissipation: f64,
}

impl<const D: usize, const N: usize> Point<D, N> {
    /// Nothing yet.
    pub const EMPTY: Self = Self {
        weight: 0.0,
        slopes: [[0.0; N]; D],
        hoop: [0.0; N],
        gradient: [[0.0; 3]; 3],
        dilation: 0.0,
        stress: [0.0; 6],
        turning: [0.0; 6],
        moduli: [[0.0; 6]; 6],
        energy: 0.0,
        dissipation: 0.0,
    };

    /// Finds the change of volume of its gradient.
    #[inline(always)]
    pub fn note_dilation(&mut self, large: bool) {
        let h = &self.gradient;
        self.dilation = if large { dilation(h) } else { h[0][0] + h[1][1] + h[2][2] };
    }

    /// Takes the answer of the material in.
    #[inline(always)]
    pub fn take(&mut self, answer: &Answer, large: bool) {
        self.stress = answer.stress;
        self.turning = if large { answer.stress } else { [0.0; 6] };
        self.moduli = answer.moduli;
        self.energy = answer.energy;
        self.dissipation = answer.dissipation;
    }
}

/// Energy of all points.
pub(super) fn energy<const D: usize, const N: usize>(points: &[Point<D, N>]) -> f64 {
    points.iter().map(|point| point.weight * point.energy).sum()
}
