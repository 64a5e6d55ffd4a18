//! A slave point against its master in one configuration, in slots.
//!
//! ```text
//!   kernel variables (point, control points, rotation)
//!        |  attachments: how each follows dofs
//!   slots of the state vector: h, sigma, drag and their gradients
//! ```

use super::Contact;
use crate::linearised::MOST_DOFS;
use slideline_mech::contact::pair::{AnyGap, StencilAttachments};
use slideline_mech::rigid::{Attachment, push_gradients};

/// A slave point against its master in one configuration.
#[derive(Clone, Copy, Debug)]
pub struct Meeting {
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
    /// Where a station stands on its element, 0 to 1.
    pub xi: f64,
    /// Number of slots it couples.
    pub width: usize,
    /// Those slots.
    pub slots: [usize; MOST_DOFS],
    /// dh/du of each slot [1].
    pub gradient: [f64; MOST_DOFS],
    /// d sigma/du of each slot [1].
    pub slip_gradient: [f64; MOST_DOFS],
    /// Direction of the tangential force on each slot [1].
    pub drag: [f64; MOST_DOFS],
}

/// The dofs that a point and what it faces depend on.
pub struct Stencil {
    /// Position of the point [L].
    pub position: [f64; 2],
    /// Number of slots.
    pub width: usize,
    /// The slots.
    pub slots: [usize; MOST_DOFS],
    /// How the variables of the gap follow them.
    pub attachments: Option<StencilAttachments>,
}

impl Meeting {
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
        slots: [0; MOST_DOFS],
        gradient: [0.0; MOST_DOFS],
        slip_gradient: [0.0; MOST_DOFS],
        drag: [0.0; MOST_DOFS],
    };
}

impl Meeting {
    /// The point faces nothing and stands for nothing.
    pub fn turn_away(&mut self) {
        self.faces = false;
        self.overclosure = f64::NEG_INFINITY;
        self.width = 0;
        self.area = 0.0;
    }

    /// Takes a gap in and pushes its gradients from kernel variables to slots.
    pub fn take(&mut self, gap: &AnyGap, stencil: &Stencil, u: &[f64]) {
        self.faces = true;
        self.overclosure = gap.overclosure();
        self.along = gap.along();
        self.normal = gap.normal();
        let m = stencil.width;
        self.width = m;
        self.slots[..m].copy_from_slice(&stencil.slots[..m]);
        self.gradient[..m].fill(0.0);
        self.slip_gradient[..m].fill(0.0);
        self.drag[..m].fill(0.0);
        let (from, dofs) = (gap.derivatives(), stencil.dofs(u));
        let attachments = stencil.attachments();
        push_gradients(
            attachments,
            &dofs[..m],
            [from.gradient, from.slip_gradient, from.drag],
            [&mut self.gradient[..m], &mut self.slip_gradient[..m], &mut self.drag[..m]],
        );
    }
}

impl Stencil {
    /// Adds slots.
    pub fn add(&mut self, slots: &[usize]) {
        self.slots[self.width..][..slots.len()].copy_from_slice(slots);
        self.width += slots.len();
    }

    /// How the variables of the gap follow the slots.
    pub fn attachments(&self) -> &[Attachment] {
        self.attachments.as_ref().map_or(&[], StencilAttachments::as_slice)
    }

    /// Values of the slots.
    pub fn dofs(&self, u: &[f64]) -> [f64; MOST_DOFS] {
        let mut dofs = [0.0; MOST_DOFS];
        for (dof, &slot) in dofs.iter_mut().zip(&self.slots[..self.width]) {
            *dof = u[slot];
        }
        dofs
    }
}

/// Scratch of [`Contact::geometric_tangent`].
#[derive(Clone, Debug)]
pub struct GeometryScratch {
    /// The tangent, row-major.
    pub tangent: [f64; MOST_DOFS * MOST_DOFS],
    pub(super) positions: Vec<[f64; 2]>,
}

impl GeometryScratch {
    /// Room for the chains of a plan.
    pub fn new(contact: &Contact) -> Self {
        let positions = Vec::with_capacity(contact.chain_nodes());
        Self { tangent: [0.0; MOST_DOFS * MOST_DOFS], positions }
    }
}
