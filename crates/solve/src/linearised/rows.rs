//! Rows of the condensed contact problem of an iteration, and the integration points among them.

use super::points::Kind;
use slideline_mech::contact::enforcement::{Complementarity, TangentialComplementarity};
use slideline_mech::contact::tangential::MOST_DIRECTIONS;

/// What a row of the condensed contact problem stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unknown {
    /// A pressure or a traction of a point.
    Multiplier {
        point: usize,
        kind: Kind,
        /// Row of the same point's pressure (its own, for a pressure).
        pressure_row: usize,
    },
    /// The contact force of all integration_points on an equation.
    Interface { equation: usize },
}

/// One row of the condensed contact problem.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    pub unknown: Unknown,
    /// Overclosure, slip or displacement without any multiplier beyond the
    /// augmentation stiffness [L].
    pub free: f64,
    /// The same at the point of linearisation [L].
    pub start: f64,
    /// Lent stiffness [F/L3].
    pub augmentation: f64,
    /// Stiffness of the structure as the row feels it [F/L3].
    pub kappa: f64,
    /// What is left of it without the augmentation [F/L3].
    pub own: f64,
    /// Stiffness of the structure as the row feels it, with its augmentation [F/L3].
    pub felt: f64,
    /// Natural unit of its unknown: that of one force.
    pub unit: f64,
    /// Weight of its square in the norm, so that squares add up to an energy.
    pub weight: f64,
}

impl Row {
    /// A row of which nothing else is known.
    pub(super) fn new(unknown: Unknown) -> Self {
        Self {
            unknown,
            free: 0.0,
            start: 0.0,
            augmentation: 0.0,
            kappa: 0.0,
            own: 0.0,
            felt: 0.0,
            unit: 1.0,
            weight: 0.0,
        }
    }

    /// Row of the pressure at the point of a pressure or traction.
    pub(super) fn pressure_row(&self) -> Option<usize> {
        match self.unknown {
            Unknown::Multiplier { pressure_row, .. } => Some(pressure_row),
            Unknown::Interface { .. } => None,
        }
    }

    /// The point of a pressure or traction.
    pub(super) fn point(&self) -> Option<(usize, Kind)> {
        match self.unknown {
            Unknown::Multiplier { point, kind, .. } => Some((point, kind)),
            Unknown::Interface { .. } => None,
        }
    }
}

/// What the laws ask of the multiplier of a row, with derivatives: by multipliers and values of
/// all rows of its kind at its point, and by the pressure there.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct RowSlopes {
    /// The value [F/L2].
    pub value: f64,
    /// First row of the kind, and how many they are.
    pub first: usize,
    pub count: usize,
    pub by_multiplier: [f64; MOST_DIRECTIONS],
    pub by_value: [f64; MOST_DIRECTIONS],
    pub by_pressure: f64,
}

impl RowSlopes {
    /// Of the pressure in row `i`.
    pub(super) fn of_pressure(i: usize, answer: &Complementarity) -> Self {
        let mut slopes = Self { value: answer.value, first: i, count: 1, ..Self::default() };
        (slopes.by_multiplier[0], slopes.by_value[0]) = (answer.by_multiplier, answer.by_value);
        slopes
    }

    /// Of the traction along a direction, those of the point beginning with row `first`.
    pub(super) fn of_traction(
        (first, count): (usize, usize),
        direction: usize,
        answer: &TangentialComplementarity,
    ) -> Self {
        Self {
            value: answer.value[direction],
            first,
            count,
            by_multiplier: answer.by_multiplier.0[direction],
            by_value: answer.by_value.0[direction],
            by_pressure: answer.by_pressure[direction],
        }
    }

    /// The rows of its kind with their derivatives by multiplier and value.
    pub(super) fn each(&self) -> impl Iterator<Item = (usize, f64, f64)> {
        let slopes = self.by_multiplier.into_iter().zip(self.by_value).take(self.count);
        (self.first..).zip(slopes).map(|(row, (multiplier, value))| (row, multiplier, value))
    }
}

/// Gives the rows of all directions of a point one stiffness, that of their mean compliance: only
/// then does a traction that slides oppose its slip.
pub(super) fn share_among_directions(rows: &mut [Row]) {
    let mut begin = 0;
    while begin < rows.len() {
        let tangential =
            |row: &&Row| matches!(row.point(), Some((_, Kind::Tangential(k))) if k > 0);
        let count = 1 + rows[begin + 1..].iter().take_while(tangential).count();
        if count > 1 {
            share(&mut rows[begin..begin + count]);
        }
        begin += count;
    }
}

fn share(rows: &mut [Row]) {
    let count = rows.len() as f64;
    let compliance = rows.iter().map(|row| if row.kappa > 0.0 { 1.0 / row.kappa } else { 0.0 });
    let compliance = compliance.sum::<f64>() / count;
    let weight = rows.iter().map(|row| row.weight).sum::<f64>() / count;
    for row in rows {
        row.kappa = if compliance > 0.0 { 1.0 / compliance } else { f64::INFINITY };
        row.own = row.kappa - row.augmentation;
        row.felt = if compliance > 0.0 { 1.0 / compliance } else { 0.0 };
        row.weight = weight;
    }
}

/// An integration point that takes part, with the rows of its equations.
#[derive(Clone, Copy, Debug)]
pub(super) struct IntegrationPoint<'a> {
    pub point: usize,
    pub rows: &'a [usize],
}

/// All integration points that take part.
#[derive(Clone, Debug, Default)]
pub(super) struct IntegrationPoints {
    /// Each with where its rows end.
    points: Vec<(usize, usize)>,
    rows: Vec<usize>,
}

impl IntegrationPoints {
    /// None.
    pub(super) const NONE: &'static Self = &Self { points: Vec::new(), rows: Vec::new() };

    pub(super) fn clear(&mut self) {
        self.points.clear();
        self.rows.clear();
    }

    /// Adds the row of an equation of the point that is finished next.
    pub(super) fn push_row(&mut self, row: usize) {
        self.rows.push(row);
    }

    /// Adds the point whose rows have been added.
    pub(super) fn finish(&mut self, point: usize) {
        self.points.push((point, self.rows.len()));
    }

    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = IntegrationPoint<'_>> {
        let begins = std::iter::once(0).chain(self.points.iter().map(|&(_, end)| end));
        let each = begins.zip(&self.points);
        each.map(|(begin, &(point, end))| IntegrationPoint { point, rows: &self.rows[begin..end] })
    }
}
