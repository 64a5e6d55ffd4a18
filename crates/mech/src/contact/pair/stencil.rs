//! Gaps of any kind, and where their variables are attached.

use super::super::gap::curve::{Along, Weights, point_to_curve};
use super::super::gap::offset::{Offset, Turn};
use super::super::gap::{Gap, Order, Quadratic};
use super::super::search::chain::raised;
use super::super::search::through::CONTROLS;
use super::super::tangential::Tangential;
use crate::rigid::Attachment;

/// A gap of any of the kernels.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(clippy::large_enum_variant)] // a box would allocate in the Newton loop
pub enum AnyGap<O: Order = Quadratic> {
    /// Circle or vertex: (slave x, y, centre x, y, body rotation).
    Circle(Gap<5, O>),
    /// Straight: (slave, two control points).
    Straight(Gap<6, O>),
    /// Corner or parabola: (slave, three control points).
    Curved(Gap<8, O>),
    /// Curve through nodes: (slave, four nodes).
    Cubic(Gap<10, O>),
}

/// Gap against a curve of a point, or of the surface that stands off it; see [`point_to_curve`].
pub(super) fn curve_gap<const K: usize, const N: usize, O: Order>(
    (point, offset): ([f64; 2], Offset),
    control: &[[f64; 2]; K],
    weights: &Weights<K>,
    along: &Along,
    xi: f64,
) -> Option<Gap<N, O>> {
    let mut gap = point_to_curve(point, control, weights, along, xi)?;
    gap.stand_off(offset, |gap| Turn::of_curve(gap, control, weights, along));
    Some(gap)
}

/// Evaluates an expression for the gap inside an [`AnyGap`].
macro_rules! each {
    ($any:expr, $gap:ident => $body:expr) => {
        match $any {
            AnyGap::Circle($gap) => $body,
            AnyGap::Straight($gap) => $body,
            AnyGap::Curved($gap) => $body,
            AnyGap::Cubic($gap) => $body,
        }
    };
}

impl<O: Order> AnyGap<O> {
    /// Overclosure h [L].
    pub fn overclosure(&self) -> f64 {
        each!(self, gap => gap.overclosure)
    }

    /// Master coordinates sigma [L].
    pub fn along(&self) -> Tangential {
        Tangential::along(each!(self, gap => gap.along))
    }

    /// Outward normal of the master.
    pub fn normal(&self) -> [f64; 3] {
        raised(each!(self, gap => gap.normal))
    }

    /// First tangent of the master, in the direction of travel.
    pub fn tangent(&self) -> [f64; 3] {
        raised(each!(self, gap => gap.tangent))
    }

    /// Facing position on the master [L].
    pub fn position(&self) -> [f64; 3] {
        raised(each!(self, gap => gap.position))
    }

    /// Number of variables.
    pub fn width(&self) -> usize {
        each!(self, gap => gap.gradient.len())
    }

    /// Derivatives by the variables, as slices.
    pub fn derivatives(&self) -> Derivatives<'_> {
        each!(self, gap => Derivatives {
            gradient: &gap.gradient,
            slip_gradient: &gap.slip_gradient,
            direction: &gap.direction,
        })
    }
}

impl AnyGap {
    /// Second derivatives by the variables, row-major: d2h/dq2, and those of the directions of the
    /// tangential force, which are not symmetric [1/L].
    pub fn second_derivatives(&self) -> [&[f64]; 2] {
        each!(self, gap => [
            gap.second.hessian.as_flattened(),
            gap.second.direction_derivative.as_flattened(),
        ])
    }
}

/// Derivatives of a gap of n variables; those of sigma direction after direction.
#[derive(Debug, Clone, Copy)]
pub struct Derivatives<'a> {
    /// dh/dq, n [1].
    pub gradient: &'a [f64],
    /// d sigma/dq, n each [1].
    pub slip_gradient: &'a [f64],
    /// Directions of the tangential force, n each [1].
    pub direction: &'a [f64],
}

/// Where the attachments of a stencil go, slave first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StencilAttachments {
    all: [Attachment; 1 + CONTROLS],
    count: usize,
}

impl StencilAttachments {
    /// That of the slave alone.
    pub(super) fn new(slave: Attachment) -> Self {
        Self { all: [slave; 1 + CONTROLS], count: 1 }
    }

    /// Takes one more in.
    pub(super) fn push(&mut self, attachment: Attachment) {
        if let Some(entry) = self.all.get_mut(self.count) {
            *entry = attachment;
            self.count += 1;
        }
    }

    /// The attachments in the order of the gap's variables.
    pub fn as_slice(&self) -> &[Attachment] {
        &self.all[..self.count]
    }
}
