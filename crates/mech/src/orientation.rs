//! Axes of a material: `*ORIENTATION`.
//!
//! ```text
//!        2 ^   ^ 1      the law answers in the axes 1, 2, 3 of the undeformed place:
//!           \ /         H' = Q H Q',  tau = Q' tau' Q,  rows of Q along the axes
//!            o
//! ```
//! Q turns body and space alike, so that the axes go with the material when it turns:
//! docs/theory.md eq. (3.55).

use std::sync::Arc;

use crate::axes::{self, Axes, System};
use crate::material::tensor::{Matrix, Symmetric, carried, product, pushed};
use crate::material::{Answer, Conditions, Material};

/// Axes of a material, place by place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orientation {
    /// Which way they point.
    pub basis: Basis,
    /// A further turn about one of them, 0 to 2, by an angle [1].
    pub turn: Option<(usize, f64)>,
}

/// Axes of the material of many elements.
#[derive(Debug, Clone, PartialEq)]
pub enum Orientations {
    /// The same for all.
    All(Orientation),
    /// One for each, in the order of the elements.
    Each(Arc<[Orientation]>),
}

impl Orientations {
    /// That of an element, by its place.
    pub fn of(&self, element: usize) -> Option<&Orientation> {
        match self {
            Self::All(orientation) => Some(orientation),
            Self::Each(all) => all.get(element),
        }
    }

    /// Those of some of the elements, by their places.
    pub fn chosen(&self, elements: &[usize]) -> Self {
        match self {
            Self::All(orientation) => Self::All(*orientation),
            Self::Each(all) => {
                Self::Each(elements.iter().filter_map(|&place| all.get(place).copied()).collect())
            }
        }
    }

    /// Those of the parts of the elements: `begin` has where the parts of each begin, and their end.
    pub fn parted(&self, begin: &[usize]) -> Self {
        let places = begin.windows(2).enumerate();
        let wholes = places.flat_map(|(place, ends)| (ends[0]..ends[1]).map(move |_| place));
        self.chosen(&wholes.collect::<Vec<_>>())
    }
}

/// What axes are given by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Basis {
    /// A system of the model.
    System(System),
    /// Nodes a, b, c of the element, from 0: axis 1 from c to a, b in the plane of 1 and 2.
    Nodes([usize; 3]),
}

impl Orientation {
    /// The axes at a point [L] of an element on the undeformed positions of its nodes [L]; those
    /// of the model where nodes of the element give no direction.
    pub fn at<const D: usize>(&self, nodes: &[[f64; D]], point: [f64; D]) -> Axes {
        let axes = match self.basis {
            Basis::System(system) => system.at(in_space(&point)),
            Basis::Nodes(own) => of_nodes(nodes, own).map_or(axes::PLAIN, |own| own.at([0.0; 3])),
        };
        self.turn.map_or(axes, |(about, angle)| axes::turned(axes, about, angle))
    }
}

/// The system that nodes of an element give; `None` where they are on a line or missing.
pub fn of_nodes<const D: usize>(nodes: &[[f64; D]], own: [usize; 3]) -> Option<System> {
    let at = |k: usize| nodes.get(own[k]).map(in_space);
    let (a, b, c) = (at(0)?, at(1)?, at(2)?);
    let from = |x: [f64; 3]| std::array::from_fn(|k| x[k] - c[k]);
    System::rectangular(from(a), from(b))
}

fn in_space<const D: usize>(point: &[f64; D]) -> [f64; 3] {
    let mut place = [0.0; 3];
    place.iter_mut().zip(point).for_each(|(own, x)| *own = *x);
    place
}

/// A material with its axes at a point.
#[derive(Debug, Clone, Copy)]
pub struct Oriented<'a> {
    /// The law.
    pub material: &'a Material,
    /// Its axes; `None`: those of the model.
    pub axes: Option<Axes>,
}

impl Oriented<'_> {
    /// Answers the displacement gradient H, all along the axes of the model.
    #[inline(always)]
    pub fn respond(
        &self,
        gradient: &Matrix,
        under: &Conditions,
        committed: &[f64],
        state: &mut [f64],
    ) -> Answer {
        match self.axes {
            None => self.material.respond(gradient, under, committed, state),
            Some(q) => self.respond_along(&q, gradient, under, (committed, state)),
        }
    }

    fn respond_along(
        &self,
        q: &Axes,
        gradient: &Matrix,
        under: &Conditions,
        (committed, state): (&[f64], &mut [f64]),
    ) -> Answer {
        let back = transposed(q);
        let own = product(&product(q, gradient), &back);
        let answer = self.material.respond(&own, under, committed, state);
        let (stress, moduli) = (carried(&back, &answer.stress), pushed(&back, &answer.moduli));
        Answer { stress, moduli, ..answer }
    }
}

/// Components along axes of a symmetric tensor of the model.
pub fn along(axes: &Axes, tensor: &Symmetric) -> Symmetric {
    carried(axes, tensor)
}

fn transposed(q: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| q[j][i]))
}
