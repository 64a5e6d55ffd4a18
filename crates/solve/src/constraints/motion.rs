//! The numbers of constraints: arms of rigid bodies, coefficients of equations.
//!
//! ```text
//!   master o====arm====o      u_d = c + a_1 u_1 + a_2 u_2
//! ```
//!
//! Which dofs follow which is the numbering's; these are values that the same plan
//! takes anew.

use super::cloud::{Cloud, CloudNumbers};
use super::numbering::ConstraintNumbering;
use slideline_model::{Axes, Model};

/// Arms and coefficients of the constraints of a model.
#[derive(Clone, Debug, Default)]
pub struct Motion {
    /// Undeformed vectors from the masters of rigid links to their dependent nodes [L].
    pub(super) arms: Vec<[f64; 3]>,
    /// Own axes of the nodes that have some.
    pub(super) axes: Vec<Axes>,
    /// Undeformed positions of the nodes of shapes, shape by shape [L].
    pub(super) places: Vec<[f64; 3]>,
    /// Clouds whose mean motion others follow.
    pub(super) clouds: Vec<Cloud>,
    /// Coefficients of linear constraints, one constraint after the other [1, L or 1/L].
    coefficients: Vec<f64>,
    /// Where the coefficients of each end.
    ends: Vec<usize>,
    /// What each adds [L or 1].
    constants: Vec<f64>,
}

impl Motion {
    /// Takes the numbers of a model that the numbering is of.
    pub fn take(&mut self, numbering: &ConstraintNumbering, model: &Model) {
        self.arms.clear();
        self.arms.extend(numbering.rigid.iter().map(|link| link.arm(model)));
        self.axes.clear();
        self.axes.extend(numbering.turned.iter().map(|&(node, transform)| {
            model.transforms[transform].system.at(model.nodes.position(node))
        }));
        self.places.clear();
        self.places.extend(numbering.shape_nodes.iter().map(|&node| model.nodes.position(node)));
        self.clouds.clear();
        self.clouds.extend(model.mean_motions.iter().map(|mean| Cloud::of(model, mean)));
        self.coefficients.clear();
        self.ends.clear();
        self.constants.clear();
        for constraint in &numbering.linear {
            let source = constraint.source;
            let terms = constraint.terms.iter();
            // those of what is kept are taken from the configuration
            let fixed = constraint.kept.is_nothing();
            self.constants.push(if fixed { source.constant(model) } else { 0.0 });
            let of = |&(_, term): &(usize, usize)| match fixed {
                true => source.coefficient(model, &self.axes, term),
                false => 0.0,
            };
            self.coefficients.extend(terms.map(of));
            self.ends.push(self.coefficients.len());
        }
    }

    /// Own axes of the nodes that have some, in the order of the dofs.
    pub fn axes(&self) -> &[Axes] {
        &self.axes
    }

    /// A cloud, by the place of its mean motion.
    pub(super) fn cloud(&self, place: usize) -> CloudNumbers<'_> {
        CloudNumbers { cloud: &self.clouds[place], axes: &self.axes }
    }

    /// Coefficients and constant of a linear constraint that keeps nothing.
    pub(super) fn linear(&self, row: usize) -> (&[f64], f64) {
        let begin = row.checked_sub(1).map_or(0, |before| self.ends[before]);
        (&self.coefficients[begin..self.ends[row]], self.constants[row])
    }
}
