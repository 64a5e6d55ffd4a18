//! T' K T of an element whose dofs follow many others, as those of tied faces do.
//!
//! ```text
//!   K   n x n       T   n x m, m equations in all       T' (K T): each entry of the matrix once
//! ```
//!
//! Term by term, every entry would be looked up once for each pair of terms: 600 terms of a brick on a
//! tied face make 360,000 look-ups for 14,000 entries.

use super::numbering::ConstraintNumbering;
use super::rows::Rows;
use slideline_linalg::Pattern;

/// Room for an element, used again.
#[derive(Clone, Debug, Default)]
pub struct Carried {
    /// What every dof follows: places among the equations, and coefficients.
    terms: Vec<(usize, f64)>,
    /// Where those of each dof begin.
    start: Vec<usize>,
    /// The same by equations: place, dof and coefficient.
    turned: Vec<(usize, usize, f64)>,
    /// The equations, ascending.
    equations: Vec<usize>,
    /// K T, row by row.
    half: Vec<f64>,
    /// A row of T' K T.
    row: Vec<f64>,
}

impl Carried {
    /// Takes in what dofs follow.
    fn take(&mut self, numbering: &ConstraintNumbering, rows: &Rows, dofs: &[usize]) {
        let Self { terms, start, .. } = self;
        terms.clear();
        start.clear();
        for &dof in dofs {
            start.push(terms.len());
            numbering.for_each_equation(rows, dof, &mut |equation, a| terms.push((equation, a)));
        }
        start.push(terms.len());
    }

    /// Numbers the equations.
    fn number(&mut self) {
        let Self { terms, equations, .. } = self;
        equations.clear();
        equations.extend(terms.iter().map(|(equation, _)| *equation));
        equations.sort_unstable();
        equations.dedup();
        for (equation, _) in terms {
            *equation = equations.partition_point(|own| *own < *equation);
        }
    }

    fn terms(&self, dof: usize) -> &[(usize, f64)] {
        &self.terms[self.start[dof]..self.start[dof + 1]]
    }

    /// Sorts the terms by what is followed.
    fn by_equation(&mut self) {
        let Self { terms, start, turned, .. } = self;
        turned.clear();
        for (dof, range) in start.windows(2).enumerate() {
            turned.extend(terms[range[0]..range[1]].iter().map(|&(at, a)| (at, dof, a)));
        }
        turned.sort_unstable_by_key(|&(at, dof, _)| (at, dof));
    }

    /// K T.
    fn multiply(&mut self, count: usize, tangent: &[f64]) {
        let width = self.equations.len();
        let mut half = std::mem::take(&mut self.half);
        half.clear();
        half.resize(count * width, 0.0);
        for (into, of) in half.chunks_exact_mut(width).zip(tangent.chunks_exact(count)) {
            for (j, k) in of.iter().enumerate().filter(|(_, k)| **k != 0.0) {
                self.terms(j).iter().for_each(|&(at, a)| into[at] += k * a);
            }
        }
        self.half = half;
    }
}

/// Terms a dof from which on an element is summed before it is looked up.
const MANY: usize = 3;

impl ConstraintNumbering {
    /// Adds T' K T of an element to matrix values: `dofs` are its own, `tangent` row by row.
    pub fn scatter_element(
        &self,
        (rows, pattern): (&Rows, &Pattern),
        (dofs, tangent): (&[usize], &[f64]),
        values: &mut [f64],
        room: &mut Carried,
    ) {
        room.take(self, rows, dofs);
        if room.terms.len() > MANY * dofs.len() {
            return room.sum((pattern, dofs.len()), tangent, values);
        }
        let at = |i: usize, j: usize| tangent[i * dofs.len() + j];
        self.scatter((rows, pattern), dofs, at, values);
    }
}

impl Carried {
    /// Adds T' K T of what was taken in.
    fn sum(&mut self, (pattern, count): (&Pattern, usize), tangent: &[f64], values: &mut [f64]) {
        let room = self;
        room.number();
        room.multiply(count, tangent);
        room.by_equation();
        let width = room.equations.len();
        let mut next = 0; // the first term of the equation at hand
        for (place, &equation) in room.equations.iter().enumerate() {
            room.row.clear();
            room.row.resize(width, 0.0);
            while let Some(&(_, dof, a)) = room.turned.get(next).filter(|own| own.0 == place) {
                let half = &room.half[dof * width..][..width];
                room.row.iter_mut().zip(half).for_each(|(sum, own)| *sum += a * own);
                next += 1;
            }
            add_row((pattern, equation), (&room.equations, &room.row), values);
        }
    }
}

/// Adds a row of values of ascending columns to that of the pattern, which holds them or does not.
fn add_row(
    (pattern, row): (&Pattern, usize),
    (columns, own): (&[usize], &[f64]),
    values: &mut [f64],
) {
    let (start, held) = (pattern.row_start()[row], pattern.row(row));
    let mut left = columns.iter().zip(own).peekable();
    for (held, value) in held.iter().zip(&mut values[start..]) {
        while left.next_if(|(column, _)| **column < *held).is_some() {}
        if let Some((_, own)) = left.next_if(|(column, _)| *column == held) {
            *value += own;
        }
    }
}

#[cfg(test)]
pub(super) fn sum_of(
    numbering: &ConstraintNumbering,
    (rows, pattern): (&Rows, &Pattern),
    (dofs, tangent): (&[usize], &[f64]),
    values: &mut [f64],
) {
    let mut room = Carried::default();
    room.take(numbering, rows, dofs);
    room.sum((pattern, dofs.len()), tangent, values);
}
