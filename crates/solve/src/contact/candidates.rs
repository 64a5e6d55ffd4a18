//! Which parts of a deforming master a point may touch before long.
//!
//! ```text
//!            x  slave point
//!      . . . | . . .
//!   o---o---o---o---o---o---o     what it faces, and a few parts on either side
//!       |<--------->|
//! ```
//!
//! The pattern of the tangent holds the couplings of candidates. A point that
//! touches beyond them makes it anew, with what it couples as it was met: what
//! touches decides, so that candidates change no result.

use super::facing::Standing;
use super::master::MasterSurface;
use super::mortar::place::MortarRoom;
use super::mortar_faces::place::FaceRoom;
use super::pairs::{Carrier, Contact, SlavePoint};
use super::positions::{MasterPositions, distance};
use crate::state::PointState;
use serde::{Deserialize, Serialize};
use slideline_mech::contact::search::outlook::Outlook;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;

/// Couplings of a pair from which on only those near are taken in.
const MANY: usize = 10_000;
/// Parts on either side of what a point faces. They are twice as many with every state of the
/// increment at which the pattern was left: it is then left as often as a master has powers of two
/// of parts, at most.
const BESIDE: usize = 3;
/// Gap up to which a point has candidates, in distances of neighbouring slave
/// points.
const NEAR: f64 = 4.0;

/// Nodes of a deforming master that each of `points` couples with at a time.
pub fn coupled_parts(points: f64, nodes: f64) -> f64 {
    match points * nodes > MANY as f64 {
        true => nodes.min((2 * BESIDE + 3) as f64),
        false => nodes,
    }
}

/// What of its master a point may touch.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Candidates {
    /// Any part.
    All,
    /// Nodes of a chain.
    Nodes(Range<usize>),
    /// Faces.
    Faces(Vec<usize>),
    /// Beyond those of all points: the dofs that one coupled where it left the pattern.
    Met(Vec<usize>),
}

/// Where contact left the pattern of an increment.
#[derive(Clone, Debug, Default)]
pub struct Reached {
    /// The displacements.
    pub displacement: Vec<f64>,
    /// Of every point that left it the dofs that it coupled.
    pub met: Vec<Vec<usize>>,
}

/// The contact that a pattern holds. In what order unknowns are eliminated hangs on the pattern,
/// and the last digits on that order: a run that goes on takes up the pattern that it had.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct NearContact<'a> {
    /// Candidates of the points; empty where every point has all.
    pub candidates: Cow<'a, [Candidates]>,
    /// Whether couplings of contact may be missing from the pattern.
    pub is_lenient: bool,
}

impl NearContact<'_> {
    /// The same, its list borrowed.
    pub fn borrowed(&self) -> NearContact<'_> {
        NearContact { candidates: Cow::Borrowed(&self.candidates), ..*self }
    }

    /// The same, to be kept.
    pub fn owned(&self) -> NearContact<'static> {
        let candidates = Cow::Owned(self.candidates.clone().into_owned());
        NearContact { candidates, ..*self }
    }
}

impl Candidates {
    /// Whether there are any.
    pub fn is_any(&self) -> bool {
        match self {
            Self::All => true,
            Self::Nodes(range) => !range.is_empty(),
            Self::Faces(faces) => !faces.is_empty(),
            Self::Met(dofs) => !dofs.is_empty(),
        }
    }
}

impl Contact {
    /// Whether a pair has so many couplings that only those near are taken in.
    pub fn is_selective(&self, pair: usize) -> bool {
        let points = self.slave_nodes[pair].len();
        let is_spread = self.mortars.iter().any(|mortar| mortar.pair == pair);
        match &self.masters[pair] {
            MasterSurface::Line { .. } if is_spread => true,
            MasterSurface::Line { itself: Some(_), .. } => true,
            MasterSurface::Line { nodes, .. } => points * nodes.len() > MANY,
            MasterSurface::Faces { .. } => true,
            _ => false,
        }
    }

    /// Whether some pair has so many couplings: then where contact is decides on the pattern.
    pub fn roams(&self) -> bool {
        (0..self.masters.len()).any(|pair| self.is_selective(pair))
    }

    /// Whether candidates may be those of its points: everything that they name is there, among so
    /// many dofs. A saved list need not be.
    pub fn may_have(&self, candidates: &[Candidates], dofs: usize) -> bool {
        if !self.roams() {
            return candidates.is_empty();
        }
        let points = self.points.len().min(candidates.len());
        let (of_points, met) = candidates.split_at(points);
        let is_of =
            |(point, own): (&SlavePoint, &Candidates)| match (own, &self.masters[point.pair]) {
                (Candidates::All, master) => !matches!(master, MasterSurface::Faces { .. }),
                (Candidates::Faces(faces), MasterSurface::Faces { mesh, .. }) => {
                    faces.iter().all(|&face| face < mesh.faces().len())
                }
                (Candidates::Nodes(range), MasterSurface::Line { nodes, .. }) => {
                    range.start <= range.end && range.end <= nodes.len()
                }
                (Candidates::Nodes(range), _) => range.is_empty(),
                _ => false,
            };
        let is_met = |own: &Candidates| match own {
            Candidates::Met(own) => own.iter().all(|&dof| dof < dofs),
            _ => false,
        };
        points == self.points.len()
            && self.points.iter().zip(of_points).all(is_of)
            && met.iter().all(is_met)
    }

    /// Candidates of all points that have not all nodes of their master, near at displacements
    /// `here` or where contact `reached`, or where they stood `before`, and what was met; none where
    /// every point has all. `positions` is scratch.
    pub fn candidates(
        &self,
        (here, reached, before): (&[f64], &[Reached], &[PointState]),
        positions: &mut MasterPositions,
        all: &mut Vec<Candidates>,
    ) {
        all.clear();
        if !self.roams() {
            return;
        }
        let points = self.points.iter();
        all.extend(points.map(|point| match &self.masters[point.pair] {
            MasterSurface::Faces { .. } => Candidates::Faces(Vec::new()),
            _ if self.is_selective(point.pair) => Candidates::Nodes(0..0),
            _ => Candidates::All,
        }));
        let mut rooms: Vec<MortarRoom> = Vec::new();
        let mut face_rooms: Vec<FaceRoom> = Vec::new();
        let mut crossings = BTreeMap::new();
        let beside = BESIDE << reached.len().saturating_sub(1).min(usize::BITS as usize / 2);
        for u in std::iter::once(here).chain(reached.iter().map(|state| &state.displacement[..])) {
            self.place_masters(u, positions);
            self.near_crossings(u, &mut crossings);
            rooms.resize_with(self.mortars.len(), MortarRoom::default);
            for (mortar, room) in self.mortars.iter().zip(&mut rooms) {
                self.place_mortar(mortar, u, room);
            }
            face_rooms.resize_with(self.face_mortars.len(), FaceRoom::default);
            for (mortar, room) in self.face_mortars.iter().zip(&mut face_rooms) {
                self.place_face_mortar(mortar, u, room);
            }
            for (place, own) in all.iter_mut().enumerate() {
                let point = &self.points[place];
                match own {
                    Candidates::All | Candidates::Met(_) => {}
                    Candidates::Faces(faces) if point.mortar.is_some() => {
                        let own = point.mortar.unwrap_or_default();
                        let (mortar, reach) =
                            (&self.face_mortars[own], NEAR * self.spacing[point.pair]);
                        let at = (&face_rooms[own], reach);
                        self.near_face_mortar(mortar, place - mortar.first, at, faces);
                    }
                    Candidates::Faces(faces) => {
                        let before = before.get(place).and_then(|point| point.footing.as_ref());
                        self.near_faces(place, (u, NEAR, before), positions, faces);
                    }
                    Candidates::Nodes(range) => {
                        let Some(near) = self.near((place, beside), u, (positions, &rooms)) else {
                            continue;
                        };
                        *range = match Range::is_empty(range) {
                            true => near,
                            false => range.start.min(near.start)..range.end.max(near.end),
                        };
                    }
                }
            }
        }
        all.extend(crossings.into_values().map(Candidates::Met));
        let met = reached.iter().flat_map(|state| &state.met);
        all.extend(met.map(|dofs| Candidates::Met(dofs.clone())));
    }

    /// Nodes about the part that a point faces, so many on either side, where it is near.
    fn near(
        &self,
        (place, beside): (usize, usize),
        u: &[f64],
        (positions, rooms): (&MasterPositions, &[MortarRoom]),
    ) -> Option<Range<usize>> {
        let point = &self.points[place];
        if let Some(own) = point.mortar {
            let (mortar, reach) = (&self.mortars[own], NEAR * self.spacing[point.pair]);
            let part = self.near_mortar(mortar, place - mortar.first, (&rooms[own], reach))?;
            let nodes = self.masters[point.pair].nodes().len();
            return Some(part.start.saturating_sub(beside)..(part.end + beside).min(nodes));
        }
        let master = &self.masters[point.pair];
        let MasterSurface::Line { nodes, offset, .. } = master else { return None };
        let Carrier::Node { position, dofs, .. } = &point.carrier else { return None };
        let at = dofs.displace(*position, u);
        let own = positions.nodes.get(*offset..offset + nodes.len())?;
        let known = self.outlook(point, u);
        let outlook = Outlook::of(&known);
        let piece =
            master.piece((positions, point.pair), (Standing::anew(at), point.seat, outlook))?;
        let part = piece.nodes();
        let distance =
            own[part.clone()].iter().map(|&node| distance(at, node)).fold(f64::MAX, f64::min);
        let far = distance > NEAR * self.spacing[point.pair].max(apart_nodes(&own[part.clone()]));
        (!far).then(|| part.start.saturating_sub(beside)..(part.end + beside).min(nodes.len()))
    }
}

/// Largest distance of neighbouring nodes [L].
fn apart_nodes(nodes: &[[f64; 3]]) -> f64 {
    nodes.windows(2).map(|w| distance(w[0], w[1])).fold(0.0, f64::max)
}
