//! What a slave point faces, and the dofs that both depend on.

use super::facing::{Facing, Standing};
use super::master::MasterSurface;
use super::pairs::{Carrier, Contact, SlavePoint};
use super::positions::MasterPositions;
use super::segment::SlaveSegment;
use super::stencil::Stencil;
use slideline_mech::contact::gap::Linear;
use slideline_mech::contact::pair::{self, AnyGap, History};
use slideline_mech::contact::search::outlook::Outlook;
use slideline_mech::contact::tangential::Tangential;
use slideline_mech::rigid::{Attachment, PointMap};

impl Contact {
    /// The slave's part of a stencil.
    #[inline]
    pub(super) fn slave(&self, point: &SlavePoint, xi: f64, u: &[f64]) -> Stencil<'_> {
        match &point.carrier {
            Carrier::Node { position, dofs, section } => {
                let mut stencil = Stencil::new(dofs.displace(*position, u));
                stencil.add_from(dofs.as_slice(), u);
                stencil.carry(self.offsets[point.pair], *section, u);
                stencil
            }
            Carrier::IntegrationPoint { segment } => {
                let segment = &self.segments[*segment];
                segment.stencil(&segment.ends(u), xi)
            }
        }
    }

    /// Where a slave point stands [L].
    pub(super) fn place(&self, point: &SlavePoint, xi: f64, u: &[f64]) -> [f64; 3] {
        match &point.carrier {
            Carrier::Node { position, dofs, .. } => dofs.displace(*position, u),
            Carrier::IntegrationPoint { segment } => {
                let segment = &self.segments[*segment];
                segment.line.placed(&segment.ends(u)).position(xi)
            }
        }
    }

    /// How a slave point follows its own dofs.
    pub(super) fn attachment(&self, point: &SlavePoint, xi: f64) -> Attachment {
        match &point.carrier {
            Carrier::Node { .. } => Attachment::Point { map: PointMap::Free, first: 0 },
            Carrier::IntegrationPoint { segment } => self.segments[*segment].line.attachment(xi),
        }
    }

    /// What a point faces from where it stands.
    #[inline]
    pub(super) fn faced(
        &self,
        point: &SlavePoint,
        standing: Standing,
        (u, positions): (&[f64], &MasterPositions),
    ) -> Option<Facing> {
        let known = self.outlook(point, u);
        let at = (standing, point.seat, Outlook::of(&known));
        let facing = self.masters[point.pair].search(u, (positions, point.pair), at)?;
        (!self.leaves_out_faced(point, &facing)).then_some(facing)
    }

    /// What the point of a stencil faces; the master's part is added to it.
    pub(super) fn face(
        &self,
        point: &SlavePoint,
        xi: f64,
        u: &[f64],
        positions: &MasterPositions,
        stencil: &mut Stencil<'_>,
    ) -> Option<(AnyGap<Linear>, Facing)> {
        let slave = self.attachment(point, xi);
        let facing = self.faced(point, Standing::anew(stencil.position), (u, positions))?;
        let at = (u, &positions.nodes[..]);
        let gap = self.masters[point.pair].gap(&facing, slave, at, stencil)?;
        Some((gap, facing))
    }

    /// Change of the slip coordinates of a point from those of its history [L].
    pub(super) fn change(
        &self,
        point: &SlavePoint,
        history: &History,
        along: Tangential,
    ) -> Tangential {
        let slip = self.way_along(point, history, along);
        let offset = self.offsets[point.pair];
        match history.along {
            Some(from) if offset.slave != 0.0 => {
                Tangential::along(slip[0] + offset.way(from[1], along[1]))
            }
            _ => slip,
        }
    }

    /// The same of the coordinates along the master alone.
    fn way_along(&self, point: &SlavePoint, history: &History, along: Tangential) -> Tangential {
        match (&self.masters[point.pair], history.along) {
            (MasterSurface::Line { chain, itself: Some(own), .. }, Some(from)) => {
                Tangential([own.slip(chain, from[0], along[0]), 0.0])
            }
            (MasterSurface::Body { surface, .. }, _) => {
                pair::slip(history, along, surface.period())
            }
            (MasterSurface::Line { chain, .. }, _) => pair::slip(history, along, chain.period()),
            _ => pair::slip(history, along, None),
        }
    }

    /// Where an integration point stands on its element while its cell is closed.
    pub(super) fn resting_place(&self, place: usize) -> f64 {
        match self.points[place].carrier {
            Carrier::Node { .. } => 0.0,
            Carrier::IntegrationPoint { segment } => {
                SlaveSegment::resting_place(place - self.segments[segment].first)
            }
        }
    }
}
