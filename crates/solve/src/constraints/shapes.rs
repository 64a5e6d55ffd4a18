//! Dofs that follow others so that nodes keep a shape: g(u) = 0, whatever the motion.
//!
//! ```text
//!   u_d(others): g(u_d, others) = 0     du_d = - sum (g_k / g_d) du_k
//! ```
//!
//! docs/theory.md eqs (4.16) to (4.18).

use crate::dofs::DofMap;
use slideline_mech::kept_shape::{KeptShape, Nodes};
use slideline_model::{Dof, Model, NodeIndex};

/// A dof that keeps a shape.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ShapeRow {
    /// What is kept.
    shape: KeptShape,
    /// Displacements of its nodes along the axes of the model, where these may change it.
    dofs: Vec<[Option<usize>; 3]>,
    /// The dof that is the angle of a mean turn.
    angle: Option<usize>,
    /// Where the undeformed positions of its nodes begin.
    first: usize,
}

/// Nodes of a shape in a configuration.
struct Configuration<'a> {
    row: &'a ShapeRow,
    places: &'a [[f64; 3]],
    u: &'a [f64],
}

impl Nodes for Configuration<'_> {
    fn count(&self) -> usize {
        self.row.dofs.len()
    }

    fn before(&self, node: usize) -> [f64; 3] {
        self.places[self.row.first + node]
    }

    fn now(&self, node: usize) -> [f64; 3] {
        let (before, dofs) = (self.before(node), self.row.dofs[node]);
        std::array::from_fn(|k| before[k] + dofs[k].map_or(0.0, |dof| self.u[dof]))
    }
}

/// Corrections of the dependent dof at most.
const MOST: usize = 30;
/// Part of the size of a shape within which it is kept [1].
const KEPT: f64 = 1e-9;

impl ShapeRow {
    /// That of a shape of the model; `first`: where the positions of its nodes begin.
    pub fn new(model: &Model, dofs: &DofMap, (place, first): (usize, usize)) -> Self {
        let own = &model.shapes[place];
        let seen = |dof: &Dof| own.shape.sees(*dof as usize);
        let along = |&node: &NodeIndex| {
            [Dof::U1, Dof::U2, Dof::U3]
                .map(|dof| Some(dof).filter(seen).and_then(|dof| dofs.find(node, dof)))
        };
        Self {
            shape: own.shape,
            dofs: own.nodes.iter().map(along).collect(),
            angle: own.angle.and_then(|node| dofs.named(node, Dof::U1)),
            first,
        }
    }

    /// Dofs that the dependent one follows.
    pub fn followed(&self, dependent: usize) -> impl Iterator<Item = usize> + '_ {
        let all = self.dofs.iter().flatten().flatten().copied().chain(self.angle);
        all.filter(move |&dof| dof != dependent)
    }

    fn value(&self, (places, u): (&[[f64; 3]], &[f64])) -> f64 {
        let angle = self.angle.map_or(0.0, |dof| u[dof]);
        self.shape.value(&Configuration { row: self, places, u }) - angle
    }

    /// Derivative by the dof of a node and direction.
    fn slope(&self, (places, u): (&[[f64; 3]], &[f64]), dof: usize) -> f64 {
        if self.angle == Some(dof) {
            return -1.0;
        }
        let at = Configuration { row: self, places, u };
        let node = self.dofs.iter().position(|own| own.contains(&Some(dof)));
        let Some(node) = node else { return 0.0 };
        let along = self.dofs[node].iter().position(|own| *own == Some(dof)).unwrap_or(0);
        self.shape.slope(&at, node)[along]
    }

    /// The largest distance of its nodes from the first one [L]; of an angle alone, one.
    fn size(&self, places: &[[f64; 3]], dependent: usize) -> f64 {
        if self.angle == Some(dependent) {
            return 1.0;
        }
        let own = &places[self.first..self.first + self.dofs.len()];
        let far = |at: &[f64; 3]| (0..3).fold(0.0_f64, |sum, k| sum.hypot(at[k] - own[0][k]));
        own.iter().map(far).fold(0.0, f64::max)
    }

    /// Moves the dependent dof until the shape is kept; where no place of it does that, it is no
    /// number, and the attempt ends.
    pub fn enforce(&self, dependent: usize, places: &[[f64; 3]], u: &mut [f64]) {
        let allowed = KEPT * self.size(places, dependent);
        let mut value = self.value((places, u));
        for _ in 0..MOST {
            let step = value / self.slope((places, u), dependent);
            if value == 0.0 || !step.is_finite() {
                break;
            }
            let before = u[dependent];
            u[dependent] = before - step;
            let mut now = self.value((places, u));
            let mut part = 1.0;
            while now.abs() > value.abs() && part > 1e-3 {
                part *= 0.5;
                u[dependent] = before - part * step;
                now = self.value((places, u));
            }
            if now.abs() >= value.abs() {
                u[dependent] = before;
                break;
            }
            value = now;
        }
        let left = value / self.slope((places, u), dependent);
        if left.is_nan() || left.abs() > allowed {
            u[dependent] = f64::NAN;
        }
    }

    /// Adds the coefficients of the dofs that the dependent one follows.
    pub fn push_coefficients(
        &self,
        dependent: usize,
        at: (&[[f64; 3]], &[f64]),
        into: &mut Vec<f64>,
    ) {
        let own = self.slope(at, dependent);
        into.extend(self.followed(dependent).map(|dof| -self.slope(at, dof) / own));
    }

    /// Pairs of followed dofs with f d2u_d/du2 of the force `f` on the dependent one; `row` are those
    /// dofs with their coefficients.
    pub fn turning<R: Iterator<Item = (usize, f64)>>(
        &self,
        (dependent, force): (usize, f64),
        (places, u): (&[[f64; 3]], &[f64]),
        row: impl Fn() -> R,
        call: &mut impl FnMut(usize, usize, f64),
    ) {
        if force == 0.0 {
            return;
        }
        let multiplier = -force / self.slope((places, u), dependent);
        let at = Configuration { row: self, places, u };
        self.shape.bends(&at, |(a, i), (b, j), value| {
            let (Some(first), Some(second)) = (self.dofs[a][i], self.dofs[b][j]) else { return };
            let value = multiplier * value;
            match (first == dependent, second == dependent) {
                (false, false) => call(first, second, value),
                (true, false) => row().for_each(|(dof, c)| call(dof, second, c * value)),
                (false, true) => row().for_each(|(dof, c)| call(first, dof, c * value)),
                (true, true) => row().for_each(|(one, c)| {
                    row().for_each(|(other, d)| call(one, other, c * d * value));
                }),
            }
        });
    }
}
