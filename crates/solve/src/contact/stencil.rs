//! The dofs that a slave point and what it faces depend on.

use super::shear::Shear;
use slideline_mech::contact::gap::Linear;
use slideline_mech::contact::gap::offset::Offset;
use slideline_mech::contact::pair::{AnyGap, StencilAttachments};
use slideline_mech::contact::points::slopes::MOST_SLOPE_DOFS;
use slideline_mech::contact::tangential::Tangential;
use slideline_mech::rigid::Attachment;

/// The most dofs that a gap in the plane follows directly, those of shear left out.
pub const MOST_DIRECT: usize = 16;

/// The dofs that a point and what it faces depend on.
pub struct Stencil<'a> {
    /// Position of the point [L].
    pub position: [f64; 3],
    width: usize,
    dofs: [usize; MOST_DIRECT],
    /// In place of a segment's rotations the turns of its line.
    values: [f64; MOST_DIRECT],
    /// How the variables of the gap follow them.
    pub attachments: Option<StencilAttachments>,
    /// The shear that turns the line of a segment beyond its rotations.
    pub shear: Option<&'a Shear>,
    /// How far the surfaces stand off the point and its master.
    pub offset: Offset,
    /// Rotations of the slave's sections with their weights at the point; of none, weights zero.
    pub section: SectionTurn,
}

/// The rotation of a section: dofs with their weights.
pub type SectionTurn = [(usize, f64); 3];
/// No rotation.
pub const NO_TURN: SectionTurn = [(0, 0.0); 3];

impl<'a> Stencil<'a> {
    /// The stencil of a slave point at `position`.
    #[inline]
    pub fn new(position: [f64; 3]) -> Self {
        Self {
            position,
            width: 0,
            dofs: [0; MOST_DIRECT],
            values: [0.0; MOST_DIRECT],
            attachments: None,
            shear: None,
            offset: Offset::NONE,
            section: NO_TURN,
        }
    }

    /// Number of dofs.
    pub fn width(&self) -> usize {
        self.width
    }

    /// The dofs.
    pub fn dofs(&self) -> &[usize] {
        &self.dofs[..self.width]
    }

    /// Their values.
    pub fn values(&self) -> &[f64] {
        &self.values[..self.width]
    }

    /// The dofs, and behind them those that shear alone follows.
    pub(super) fn with_further(&self) -> [usize; MOST_SLOPE_DOFS] {
        let mut all = [0; MOST_SLOPE_DOFS];
        all[..self.width].copy_from_slice(self.dofs());
        if let Some(shear) = self.shear {
            all[self.width..][..shear.further.len()].copy_from_slice(&shear.further);
        }
        all
    }

    /// Takes in how far surfaces stand off, and the rotation of a node's section. Friction of a node
    /// that has none, as of a truss, acts on its line.
    pub fn carry(&mut self, offset: Offset, section: SectionTurn, u: &[f64]) {
        let [(dof, weight), ..] = section;
        if weight == 0.0 {
            self.offset = Offset { slave: 0.0, master: offset.both() };
            return;
        }
        (self.offset, self.section) = (offset, section);
        self.add_from(&[dof], u);
    }

    /// Coordinates of the point along its master, and how far its surface has rolled on that [L].
    pub fn along(&self, gap: &AnyGap<Linear>, u: &[f64]) -> Tangential {
        let rolled = self.offset.rolled(self.section_turn(u), gap.tangent());
        Tangential([gap.along()[0], rolled])
    }

    /// The rotation of the section that carries the point [rad].
    pub fn section_turn(&self, u: &[f64]) -> f64 {
        self.section.iter().map(|&(dof, weight)| weight * u[dof]).sum()
    }

    /// Adds dofs with their values.
    pub fn add(&mut self, dofs: &[usize], values: impl IntoIterator<Item = f64>) {
        self.dofs[self.width..][..dofs.len()].copy_from_slice(dofs);
        let room = &mut self.values[self.width..][..dofs.len()];
        room.iter_mut().zip(values).for_each(|(room, value)| *room = value);
        self.width += dofs.len();
    }

    /// Where the dofs of a node of the master stand, behind a place; those that do not are added.
    pub fn follow(&mut self, from: usize, dofs: &[usize], u: &[f64]) -> usize {
        let known =
            dofs.first().and_then(|own| self.dofs().iter().skip(from).position(|d| d == own));
        known.map_or_else(
            || {
                let first = self.width;
                self.add_from(dofs, u);
                first
            },
            |place| from + place,
        )
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
