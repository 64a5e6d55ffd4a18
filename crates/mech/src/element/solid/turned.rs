//! Energy of hourglass modes along axes that turn with the element.
//!
//! ```text
//!   F = R U        w = R' q         W = w.k w / 2
//!   dR = R [o],    (tr U - U) o = axial(R' dF)      o: turn seen from the axes
//! ```
//!
//! docs/theory.md eqs. (3.119), (3.120).

use super::bending::{Amounts, Bending, MODES};
use crate::material::Axes;
use crate::material::tensor::{Matrix, deformation, full, inverse, product, right};
use crate::vector::{Vector, add, cross, dot, sub};

/// Columns that a displacement has: of the gradient and of the modes.
pub(super) const SIZE: usize = 3 + MODES;

/// Derivatives by gradient and amounts, axis by axis of displacement.
pub(super) type Slopes = [[f64; SIZE]; 3];

const ONE: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The modes of an element in a configuration.
pub(super) struct Held {
    bending: Bending,
    /// Amounts along the turned axes, and the forces on them [L, F].
    amounts: Amounts,
    forces: Amounts,
    turn: Turn,
}

/// How the axes have turned; they do not where strains are linear.
struct Turn {
    /// R.
    axes: Matrix,
    /// U, and (tr U - U)^-1; `None`: axes stand still.
    stretch: Option<(Matrix, Matrix)>,
    /// (tr U - U)^-1 times the moment of the forces about the axes [F L].
    moment: Vector,
}

impl Held {
    /// Along axes that stand still.
    pub fn still(bending: Bending, amounts: Amounts) -> Self {
        let forces = bending.forces(&amounts);
        let turn = Turn { axes: ONE, stretch: None, moment: [0.0; 3] };
        Self { bending, amounts, forces, turn }
    }

    /// Along the axes that the gradient H of displacements has turned.
    pub fn turned(bending: Bending, gradient: &Matrix, amounts: Amounts) -> Self {
        if let Bending::Even(_) = bending {
            return Self::still(bending, amounts);
        }
        let principal = Axes::of(&right(gradient));
        let [stretch, shrink] = [1.0, -1.0]
            .map(|way| full(&principal.tensor(&principal.logs.map(|l| (way * l).exp()))));
        let axes = product(&deformation(gradient), &shrink);
        let amounts = amounts.map(|amount| seen(&axes, amount));
        let forces = bending.forces(&amounts);
        let (lever, _) = inverse(&levers(&stretch));
        let moment = forces.iter().zip(&amounts).map(|(s, w)| cross(*s, *w)).fold([0.0; 3], add);
        let moment = times(&lever, moment);
        let turn = Turn { axes, stretch: Some((stretch, lever)), moment };
        Self { bending, amounts, forces, turn }
    }

    /// Energy [F L].
    pub fn energy(&self) -> f64 {
        0.5 * self.forces.iter().zip(&self.amounts).map(|(s, w)| dot(*s, *w)).sum::<f64>()
    }

    /// Derivatives of the energy.
    pub fn slopes(&self) -> Slopes {
        self.carried(&product(&self.turn.axes, &spin(self.turn.moment)), &self.forces)
    }

    /// Their change with one column of the gradient, or one amount, along an axis.
    pub fn change_of_slopes(&self, axis: usize, column: usize) -> Slopes {
        let Turn { axes, stretch, moment } = &self.turn;
        let mut amounts = [[0.0; 3]; MODES];
        if let Some(amount) = column.checked_sub(3) {
            amounts[amount] = axes[axis]; // R' times a unit vector
        }
        let Some((stretch, lever)) = stretch else {
            return self.carried(&[[0.0; 3]; 3], &self.bending.forces(&amounts));
        };
        let mut gradient = [[0.0; 3]; 3];
        if column < 3 {
            (0..3).for_each(|i| gradient[i][column] = axes[axis][i]);
        }
        let turn = times(lever, axial(&gradient));
        let turned = product(&spin(turn), stretch);
        let stretched = std::array::from_fn(|i| sub(gradient[i], turned[i]));
        for (change, amount) in amounts.iter_mut().zip(&self.amounts) {
            *change = add(*change, cross(*amount, turn));
        }
        let forces = self.bending.forces(&amounts);
        let mut about = [0.0; 3];
        for k in 0..MODES {
            about = add(about, cross(forces[k], self.amounts[k]));
            about = add(about, cross(self.forces[k], amounts[k]));
        }
        let about = times(lever, sub(about, times(&levers(&stretched), *moment)));
        let (first, second) = (product(&spin(turn), &spin(*moment)), spin(about));
        let own: Matrix = std::array::from_fn(|i| add(first[i], second[i]));
        let forces = std::array::from_fn(|k| add(cross(turn, self.forces[k]), forces[k]));
        self.carried(&product(axes, &own), &forces)
    }

    /// Derivatives by the gradient, and those by amounts seen along the turned axes, which are turned back.
    fn carried(&self, by_gradient: &Matrix, forces: &Amounts) -> Slopes {
        std::array::from_fn(|i| {
            let of_modes = |k: usize| dot(self.turn.axes[i], forces[k]);
            std::array::from_fn(|n| if n < 3 { by_gradient[i][n] } else { of_modes(n - 3) })
        })
    }
}

/// R' a.
fn seen(axes: &Matrix, a: Vector) -> Vector {
    std::array::from_fn(|j| axes[0][j] * a[0] + axes[1][j] * a[1] + axes[2][j] * a[2])
}

fn times(m: &Matrix, a: Vector) -> Vector {
    m.map(|row| dot(row, a))
}

/// tr U - U.
fn levers(stretch: &Matrix) -> Matrix {
    let trace = stretch[0][0] + stretch[1][1] + stretch[2][2];
    std::array::from_fn(|i| {
        std::array::from_fn(|j| if i == j { trace } else { 0.0 } - stretch[i][j])
    })
}

/// The matrix whose product with a vector is a x that vector.
fn spin(a: Vector) -> Matrix {
    [[0.0, -a[2], a[1]], [a[2], 0.0, -a[0]], [-a[1], a[0], 0.0]]
}

/// The vector of G - G'.
fn axial(g: &Matrix) -> Vector {
    [g[2][1] - g[1][2], g[0][2] - g[2][0], g[1][0] - g[0][1]]
}
