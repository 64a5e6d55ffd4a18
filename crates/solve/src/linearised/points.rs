//! The contact points of an iteration, linearised, with their rows over the equations.

use crate::constraints::{Constraints, Rows};
use crate::contact::{ContactOperator, OperatorRows};
use slideline_mech::contact::pair::Laws;
use slideline_mech::contact::tangential::Tangential;
use std::ops::{Deref, Index, IndexMut};

/// How far an unknown must move a point along its tangents, by its own motion, for it to slide [1]. A node
/// whose share of a face is counted has 5 % of it; by turning, faces move points by their gaps.
const LEAST_SLIDE: f64 = 1e-2;

/// Part by which forces and slips of a point may differ for its augmentation to count as symmetric [1].
const TURNED: f64 = 0.01;

/// Friction at a point whose friction is called.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sliding {
    /// Change of the slip coordinates since the last commit [L].
    pub slip: Tangential,
    /// Committed elastic slip [L].
    pub elastic_slip: Tangential,
    /// Shear traction: estimate in, solution out [F/L2].
    pub traction: Tangential,
    /// Stiffness augmentation to K, the same in all directions [F/L3].
    pub stiffness: f64,
    /// Where the point's state values of a user law begin, and how many.
    pub state_variables: (usize, usize),
}

/// A contact point, linearised.
#[derive(Clone, Copy, Debug)]
pub struct LinearPoint {
    /// Place of the point in the plan.
    pub place: usize,
    /// Place of its pair in the model.
    pub pair: usize,
    /// Place of its law among the laws.
    pub law: usize,
    /// Area [L2].
    pub area: f64,
    /// Whether it is one of the many integration points of integrated contact.
    pub integrated: bool,
    /// Overclosure [L].
    pub overclosure: f64,
    /// Pressure: estimate in, solution out [F/L2].
    pub pressure: f64,
    /// Stiffness augmentation to K [F/L3].
    pub stiffness: f64,
    /// Stiffness of the structure below which the point's own counts as none
    /// [F/L3].
    pub least: f64,
    /// Friction, where it would be called for a closed point.
    pub sliding: Option<Sliding>,
}

impl LinearPoint {
    /// Traction estimated or found; zero without friction [F/L2].
    pub fn traction(&self) -> Tangential {
        self.sliding.map_or(Tangential::ZERO, |sliding| sliding.traction)
    }

    /// Sets the traction, where there is friction [F/L2].
    pub(super) fn set_traction(&mut self, traction: Tangential) {
        if let Some(sliding) = &mut self.sliding {
            sliding.traction = traction;
        }
    }

    /// Sets a solution [F/L2].
    pub fn take(&mut self, pressure: f64, traction: Tangential) {
        self.pressure = pressure;
        self.set_traction(traction);
    }

    /// Moves a solution that presses by changes of its pressure and traction [F/L2]; it goes on pressing.
    pub fn move_by(&mut self, pressure: f64, traction: Tangential) {
        if (self.pressure + pressure) * self.pressure > 0.0 {
            self.pressure += pressure;
            let moved = self.traction() + traction;
            self.set_traction(moved);
        }
    }

    /// Sets the augmentation along the normal and along the tangents [F/L3].
    pub fn set_augmentation(&mut self, augmentation: Augmentation) {
        self.stiffness = augmentation.normal;
        if let Some(sliding) = &mut self.sliding {
            sliding.stiffness = augmentation.tangential;
        }
    }

    /// The augmentation it has.
    pub(super) fn augmentation(&self) -> Augmentation {
        let tangential = self.sliding.map_or(0.0, |sliding| sliding.stiffness);
        Augmentation { normal: self.stiffness, tangential }
    }
}

/// Stiffness per area of a point [F/L3].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Augmentation {
    /// Along its normal.
    pub normal: f64,
    /// Along its tangents.
    pub tangential: f64,
}

/// Which multiplier of a point: its pressure, or its traction along a direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Normal,
    Tangential(usize),
}

/// The points of an iteration.
#[derive(Clone, Debug, Default)]
pub struct LinearPoints {
    points: Vec<LinearPoint>,
    operator: ContactOperator,
    /// Unknowns of the point that is being added, and its rows, unknown by unknown.
    unknowns: Vec<usize>,
    columns: Vec<f64>,
}

/// A point with its rows over the equations.
#[derive(Clone, Copy, Debug)]
pub struct LinearRows<'a> {
    point: &'a LinearPoint,
    /// Its rows.
    pub rows: OperatorRows<'a>,
}

impl Deref for LinearRows<'_> {
    type Target = LinearPoint;

    fn deref(&self) -> &LinearPoint {
        self.point
    }
}

impl LinearPoints {
    /// Forgets all points.
    pub fn clear(&mut self, directions: usize) {
        self.points.clear();
        self.operator.clear(directions);
    }

    /// Room for so many points of so many equations each.
    pub fn reserve(&mut self, points: usize, equations: usize) {
        self.points.reserve(points);
        self.operator.reserve(points, equations);
    }

    /// Adds a point whose rows over dofs are `rows`, and hands those to the equations that the
    /// dofs follow.
    pub fn push(
        &mut self,
        point: LinearPoint,
        rows: OperatorRows<'_>,
        (constraints, following): (&Constraints, &Rows),
    ) {
        let count = 1 + 2 * self.operator.directions();
        self.unknowns.clear();
        self.columns.clear();
        let Self { unknowns, columns, .. } = self;
        for (k, &dof) in rows.unknowns.iter().enumerate() {
            constraints.for_each_equation(following, dof, &mut |equation, factor: f64| {
                let own = rows.column(k).map(|value| factor * value);
                match unknowns.iter().position(|&own| own == equation) {
                    Some(known) => {
                        let column = &mut columns[known * count..][..count];
                        column.iter_mut().zip(own).for_each(|(sum, value)| *sum += value);
                    }
                    None => {
                        unknowns.push(equation);
                        columns.extend(own);
                    }
                }
            });
        }
        self.points.push(point);
        self.operator.push_columns(&self.unknowns, &self.columns);
    }

    /// Takes the slip of the last point as prescribed, where its equations, in their natural `units`, move
    /// it next to nothing: supports hold all that slides, and faces turn by what the rest moves.
    pub fn hold_slip_of_last(&mut self, units: &[f64]) {
        let last = self.points.len() - 1;
        let rows = self.operator.rows(last);
        let moved = |direction: usize| {
            let by_unit = rows.unknowns.iter().zip(rows.slip(direction));
            by_unit.fold(0.0_f64, |most, (&e, g)| most.max((g * units[e]).abs()))
        };
        if (0..rows.directions()).all(|direction| moved(direction) <= LEAST_SLIDE) {
            self.operator.hold_slip(last);
        }
    }

    /// Adds a point with its rows over equations, row by row.
    #[cfg(test)]
    pub fn push_rows(&mut self, point: LinearPoint, equations: &[usize], rows: &[f64]) {
        self.points.push(point);
        self.operator.push_rows(equations, rows);
    }

    /// A point with its rows.
    pub fn at(&self, index: usize) -> LinearRows<'_> {
        LinearRows { point: &self.points[index], rows: self.operator.rows(index) }
    }

    /// Tangential directions of a point.
    pub fn directions(&self) -> usize {
        self.operator.directions()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// The points, without their rows.
    pub fn iter(&self) -> std::slice::Iter<'_, LinearPoint> {
        self.points.iter()
    }

    /// All points with their rows.
    pub fn with_rows(&self) -> impl Iterator<Item = LinearRows<'_>> {
        (0..self.points.len()).map(|index| self.at(index))
    }

    /// Takes over other points, room kept.
    pub(super) fn copy_from(&mut self, other: &Self) {
        self.points.clone_from(&other.points);
        self.operator.copy_from(&other.operator);
    }
}

impl Index<usize> for LinearPoints {
    type Output = LinearPoint;

    fn index(&self, index: usize) -> &LinearPoint {
        &self.points[index]
    }
}

impl IndexMut<usize> for LinearPoints {
    fn index_mut(&mut self, index: usize) -> &mut LinearPoint {
        &mut self.points[index]
    }
}

impl LinearRows<'_> {
    /// How a value of the point follows a vector of all equations.
    pub(super) fn dot(&self, of: Kind, vector: &[f64]) -> f64 {
        self.rows.unknowns.iter().zip(self.gradient(of)).map(|(&e, g)| g * vector[e]).sum()
    }

    /// Derivatives of overclosure or slip.
    pub(super) fn gradient(&self, of: Kind) -> &[f64] {
        match of {
            Kind::Normal => self.rows.normal(),
            Kind::Tangential(direction) => self.rows.slip(direction),
        }
    }

    /// Direction of the force of a multiplier.
    pub(super) fn force(&self, of: Kind) -> &[f64] {
        match of {
            Kind::Normal => self.rows.normal(),
            Kind::Tangential(direction) => self.rows.force(direction),
        }
    }

    /// Whether its forces point elsewhere than its slips are measured.
    pub(super) fn turns(&self) -> bool {
        let differs = |d: usize| {
            let (force, slip) = (self.rows.force(d), self.rows.slip(d));
            let (mut off, mut size) = (0.0, 0.0);
            for (f, s) in force.iter().zip(slip) {
                off += (f - s) * (f - s);
                size += f * f;
            }
            off > TURNED * TURNED * size
        };
        (0..self.rows.directions()).any(differs)
    }

    /// Adds the forces of a multiplier to a vector of all equations [F].
    pub(super) fn push(&self, of: Kind, multiplier: f64, into: &mut [f64]) {
        for (&equation, f) in self.rows.unknowns.iter().zip(self.force(of)) {
            into[equation] += self.area * multiplier * f;
        }
    }

    /// Whether contact has a say in its equations. Where supports hold it along its normal, they take
    /// what a hard law cannot tell from their reaction; a softened law presses there by itself, and
    /// friction acts where the point slides.
    pub fn takes_part(&self, laws: &Laws) -> bool {
        let rubs = || self.sliding.is_some() && self.slides();
        self.moves(Kind::Normal) || (laws.pressure(self.overclosure, 0.0) > 0.0 && rubs())
    }

    pub(super) fn moves(&self, of: Kind) -> bool {
        self.gradient(of).iter().any(|&g| g != 0.0)
    }

    /// Whether anything moves it along its master.
    pub(super) fn slides(&self) -> bool {
        (0..self.rows.directions()).any(|direction| self.moves(Kind::Tangential(direction)))
    }

    /// Normal and tangential forces per area at its equation `k`, put together [F/L2].
    pub(super) fn force_at(&self, k: usize, normal: f64, tangential: Tangential) -> f64 {
        let along = |direction: usize| tangential[direction] * self.rows.force(direction)[k];
        (0..self.rows.directions()).map(along).fold(normal * self.rows.normal()[k], |a, b| a + b)
    }

    /// Overclosure and slip by the values of its equations.
    pub(super) fn values(&self, of_equation: impl Fn(usize) -> f64) -> (f64, Tangential) {
        let (mut normal, mut tangential) = (0.0, Tangential::ZERO);
        for k in 0..self.rows.width() {
            let d = of_equation(k);
            normal += self.rows.normal()[k] * d;
            for direction in 0..self.rows.directions() {
                tangential.0[direction] += self.rows.slip(direction)[k] * d;
            }
        }
        (normal, tangential)
    }
}
