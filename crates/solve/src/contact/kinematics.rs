//! A slave point against its master in one configuration, in dofs.
//!
//! ```text
//!   kernel variables (point, control points, rotation)
//!        |  attachments: how each follows dofs
//!   dofs of the state vector: h, sigma, direction and their gradients
//! ```

use super::positions::MasterPositions;
use super::shear::{Shear, TURNS};
use crate::linearised::MOST_DOFS;
use slideline_mech::contact::pair::{AnyGap, StencilAttachments};
use slideline_mech::rigid::{Attachment, push_gradients};

/// A slave point against its master in one configuration.
#[derive(Clone, Copy, Debug)]
pub struct ContactKinematics {
    /// Whether it faces its master at all.
    pub faces: bool,
    /// Overclosure [L]; minus infinity where it faces nothing.
    pub overclosure: f64,
    /// Coordinate along the master [L].
    pub along: f64,
    /// Outward normal of the master [1].
    pub normal: [f64; 2],
    /// Position of the point [L].
    pub position: [f64; 2],
    /// Area it stands for [L2].
    pub area: f64,
    /// Where a integration_point stands on its element, 0 to 1.
    pub xi: f64,
    /// Number of dofs it couples.
    pub width: usize,
    /// Those dofs.
    pub dofs: [usize; MOST_DOFS],
    /// dh/du of each dof [1].
    pub gradient: [f64; MOST_DOFS],
    /// d sigma/du of each dof [1].
    pub slip_gradient: [f64; MOST_DOFS],
    /// Direction of the tangential force on each dof [1].
    pub direction: [f64; MOST_DOFS],
}

/// The dofs that a point and what it faces depend on.
pub struct Stencil<'a> {
    /// Position of the point [L].
    pub position: [f64; 2],
    /// Number of dofs.
    pub width: usize,
    /// The dofs.
    pub dofs: [usize; MOST_DOFS],
    /// Their values; in place of a segment's rotations the turns of its line.
    pub values: [f64; MOST_DOFS],
    /// How the variables of the gap follow them.
    pub attachments: Option<StencilAttachments>,
    /// The shear that turns the line of a segment beyond its rotations.
    pub shear: Option<&'a Shear>,
}

/// The most dofs that a gap follows directly, those of shear left out.
pub const MOST_DIRECT: usize = 16;

impl ContactKinematics {
    /// A point that faces nothing.
    pub const NOWHERE: Self = Self {
        faces: false,
        overclosure: f64::NEG_INFINITY,
        along: 0.0,
        normal: [0.0; 2],
        position: [0.0; 2],
        area: 0.0,
        xi: 0.0,
        width: 0,
        dofs: [0; MOST_DOFS],
        gradient: [0.0; MOST_DOFS],
        slip_gradient: [0.0; MOST_DOFS],
        direction: [0.0; MOST_DOFS],
    };
}

impl ContactKinematics {
    /// The point faces nothing and stands for nothing.
    pub fn turn_away(&mut self) {
        self.faces = false;
        self.overclosure = f64::NEG_INFINITY;
        self.width = 0;
        self.area = 0.0;
    }

    /// The point faces nothing, and stands for what it stood for.
    pub fn turn_away_in_place(&mut self) {
        let area = self.area;
        self.turn_away();
        self.area = area;
    }

    /// Takes a gap in and pushes its gradients from kernel variables to dofs.
    pub fn take(&mut self, gap: &AnyGap, stencil: &Stencil<'_>, u: &[f64]) {
        self.faces = true;
        self.overclosure = gap.overclosure();
        self.along = gap.along();
        self.normal = gap.normal();
        let m = stencil.width;
        self.width = m;
        self.dofs[..m].copy_from_slice(&stencil.dofs[..m]);
        self.gradient[..m].fill(0.0);
        self.slip_gradient[..m].fill(0.0);
        self.direction[..m].fill(0.0);
        let from = gap.derivatives();
        push_gradients(
            stencil.attachments(),
            &stencil.values[..m],
            [from.gradient, from.slip_gradient, from.direction],
            [&mut self.gradient[..m], &mut self.slip_gradient[..m], &mut self.direction[..m]],
        );
        if let Some(shear) = stencil.shear {
            self.follow_shear(shear, u);
        }
    }

    /// Derivatives by the turns of a segment's ends become derivatives by all
    /// dofs that shear follows.
    fn follow_shear(&mut self, shear: &Shear, u: &[f64]) {
        let direct = self.width;
        self.width += shear.further.len();
        self.dofs[direct..self.width].copy_from_slice(&shear.further);
        let by_end = shear.gradients(&self.dofs[..self.width], u);
        for derivative in [&mut self.gradient, &mut self.slip_gradient, &mut self.direction] {
            derivative[direct..self.width].fill(0.0);
            let by_turn = TURNS.map(|turn| derivative[turn]);
            for (factor, gradient) in by_turn.into_iter().zip(&by_end) {
                derivative.iter_mut().zip(gradient).for_each(|(sum, g)| *sum += factor * g);
            }
        }
    }
}

impl<'a> Stencil<'a> {
    /// The stencil of a slave point at `position`.
    pub fn new(position: [f64; 2]) -> Self {
        Self {
            position,
            width: 0,
            dofs: [0; MOST_DOFS],
            values: [0.0; MOST_DOFS],
            attachments: None,
            shear: None,
        }
    }

    /// Adds dofs with their values.
    pub fn add(&mut self, dofs: &[usize], values: impl IntoIterator<Item = f64>) {
        self.dofs[self.width..][..dofs.len()].copy_from_slice(dofs);
        let room = &mut self.values[self.width..][..dofs.len()];
        room.iter_mut().zip(values).for_each(|(room, value)| *room = value);
        self.width += dofs.len();
    }

    /// Adds dofs with their values in the state vector.
    pub fn add_from(&mut self, dofs: &[usize], u: &[f64]) {
        self.add(dofs, dofs.iter().map(|&dof| u[dof]));
    }

    /// How the variables of the gap follow the dofs.
    pub fn attachments(&self) -> &[Attachment] {
        self.attachments.as_ref().map_or(&[], StencilAttachments::as_slice)
    }
}

/// Scratch of [`Contact::geometric_tangent`].
#[derive(Clone, Debug)]
pub struct GeometryScratch {
    /// The tangent, row-major.
    pub tangent: [f64; MOST_DOFS * MOST_DOFS],
    pub(super) positions: MasterPositions,
}

impl Default for GeometryScratch {
    fn default() -> Self {
        Self::new()
    }
}

impl GeometryScratch {
    /// Room for a tangent.
    pub fn new() -> Self {
        let positions = MasterPositions::default();
        Self { tangent: [0.0; MOST_DOFS * MOST_DOFS], positions }
    }
}
