//! How far a master falls away from where it is met, within a face of the slave: what contact at nodes can
//! miss of it.
//!
//! ```text
//!      o----------x----------o     a slave face with its middle where the master stands nearest:
//!      : d    .--' '--.    d :     its nodes are d away from the master
//!      :   .-'         '-.   :
//! ```
//!
//! docs/theory.md section 5.20

use super::facing::Standing;
use super::master::MasterSurface;
use super::near_line::NearLine;
use super::pairs::{Carrier, Contact, SlavePoint};
use super::positions::MasterPositions;
use super::slave_face::Corners;
use slideline_mech::contact::pair::{FaceRoom, chain_overclosure};
use slideline_mech::contact::search::chain::PieceKind;
use slideline_mech::contact::search::outlook::Outlook;
use slideline_mech::vector::{dot, size, sub};

/// Parts of a line, and of a face in each direction, whose ends are looked at.
const PARTS: [usize; 2] = [8, 4];

/// Sine of the slope of a slave face to the mean of those about a node from which on the node is a corner [1]: half of
/// 45 degrees.
const CORNER: f64 = 0.382_683_432_365_089_8;

/// Sizes of a face within which a node is met as near as any place of its faces [1].
const AT_NODE: f64 = 1e-6;

/// Room in which masters are held against faces of the slave, used again.
#[derive(Debug, Default)]
pub struct FallsRoom {
    /// Where the master of the pair stands nearest to a slave face, where it was asked.
    nearest: Vec<Option<Option<GapAt>>>,
    /// Which nodes are held by closed points.
    pub(super) held: Vec<bool>,
    /// How far each slave face lies off what is round and it is a chord of [L].
    rises: Vec<f64>,
    /// No displacements.
    still: Vec<f64>,
    pub(super) faces: FaceRoom,
}

/// What a slave node misses of its master.
#[derive(Clone, Copy, Debug, Default)]
pub struct MissedAt {
    /// How far the master falls away within a face about the node [L].
    pub falls_away: f64,
    /// How far the smoothed corner that it faces lies off the corner of the line that it smooths [L]; zero elsewhere.
    pub smoothed_away: f64,
}

/// A gap and where it is [L].
type GapAt = (f64, [f64; 3]);

/// A face where it stands.
#[derive(Clone, Copy, Debug)]
struct Face {
    /// Its place among the slave faces; none of an element of a beam.
    number: Option<usize>,
    corners: Corners,
    /// Part of it that reaches from node to node [1].
    part: f64,
    /// Its unit normal [1].
    normal: [f64; 3],
}

impl Face {
    fn new(number: Option<usize>, (corners, normal): (Corners, [f64; 3]), part: f64) -> Self {
        let long = size(normal);
        Self { number, corners, part, normal: normal.map(|own| own / long) }
    }

    /// Ways from its middle halfway to the next nodes, turned across a normal if there is one [L].
    fn ways(&self, level: Option<[f64; 3]>) -> impl Iterator<Item = [f64; 3]> + '_ {
        let middle = mean(self.corners.iter().copied());
        self.corners.iter().map(move |&corner| {
            let way = sub(corner, middle).map(|own| self.part * own);
            let Some(normal) = level.filter(|own| dot(*own, *own) > 0.0) else { return way };
            let share = dot(way, normal) / dot(normal, normal);
            let across: [f64; 3] = std::array::from_fn(|axis| way[axis] - share * normal[axis]);
            let longer = size(way) / size(across);
            if longer.is_finite() { across.map(|own| longer * own) } else { way }
        })
    }

    /// The same way from its middle towards a node of it and back, where it is a triangle: from the node into the face.
    /// The sides of others that are opposite one another have both.
    fn inward(&self, node: [f64; 3]) -> Option<[f64; 3]> {
        let middle = mean(self.corners.iter().copied());
        (self.corners.len() == 3).then(|| sub(middle, node).map(|own| self.part * own))
    }

    /// How far a face that is a chord of something round lies off that in its middle, where `normal` is the one
    /// at a node of it [L].
    fn rise(&self, normal: [f64; 3]) -> f64 {
        let slope = |way: [f64; 3]| (dot(way, normal) / (size(way) * size(normal))).abs();
        let slope = self.ways(None).map(slope).fold(0.0, f64::max);
        if slope < CORNER { 0.25 * self.long() * slope } else { 0.0 }
    }

    /// Twice the longest of them [L].
    fn long(&self) -> f64 {
        2.0 * self.ways(None).map(size).fold(0.0, f64::max)
    }

    /// The place of it where a gap is least.
    fn nearest(&self, gap: &mut impl FnMut([f64; 3]) -> Option<f64>) -> Option<GapAt> {
        let gaps = places(&self.corners).filter_map(|at| Some((gap(at)?, at)));
        gaps.min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// How far a master falls away from a place where its gap is known, within half of the face towards every corner,
    /// and where it has no face there, from a node (with a `level`) into the face [L].
    fn falls(
        &self,
        (least, met): GapAt,
        level: Option<[f64; 3]>,
        gap: &mut impl FnMut([f64; 3]) -> Option<f64>,
    ) -> f64 {
        let long = self.long();
        let mut falls = |way: [f64; 3]| {
            let there = gap(std::array::from_fn(|axis| met[axis] + way[axis]));
            there.map(|gap| (gap - least).clamp(0.0, long))
        };
        let least = self.ways(level).filter_map(&mut falls).reduce(f64::min);
        // about the corner of a part no way of a triangle need lead along it
        least.or_else(|| level.and_then(|_| self.inward(met)).and_then(falls)).unwrap_or(long)
    }
}

impl Contact {
    /// Makes room for the faces of all pairs, and forgets what is known of another state.
    pub fn make_room(&self, dofs: usize, room: &mut FallsRoom) {
        let FallsRoom { nearest, rises, still, .. } = room;
        nearest.clear();
        nearest.resize(self.slave_faces.len(), None);
        rises.clear();
        rises.resize(self.slave_faces.len(), 0.0);
        if rises.is_empty() {
            return;
        }
        still.resize(dofs, 0.0);
        for place in (0..self.points.len()).filter(|&place| !self.points[place].faces.is_empty()) {
            let normal = mean(self.faces_about(place, still).map(|own| own.normal));
            for face in self.faces_about(place, still) {
                let Some(rise) = face.number.and_then(|own| rises.get_mut(own)) else { continue };
                *rise = rise.max(face.rise(normal));
            }
        }
    }

    /// What a slave node misses of its master; `None` where nothing is known of faces.
    pub fn missed_at(
        &self,
        place: usize,
        (u, positions): (&[f64], &MasterPositions),
        room: &mut FallsRoom,
    ) -> Option<MissedAt> {
        let point = &self.points[place];
        let (master, own) = (&self.masters[point.pair], self.place(point, 0.0, u));
        let FallsRoom { nearest: known, faces: rest, rises, .. } = room;
        let round = point.faces.iter().map(|&face| rises[face]).fold(0.0, f64::max);
        let MasterSurface::Line { chain, nodes, offset, itself: None, .. } = master else {
            let mut gap =
                |at| self.depth_at(point, at, (u, positions), rest).map(|depth: f64| -depth);
            let falls_away = self.falls_away((place, own), u, known, &mut gap)?;
            return Some(MissedAt { falls_away: beyond(falls_away, round), smoothed_away: 0.0 });
        };
        let stand = positions.nodes.get(*offset..offset + nodes.len())?;
        let piece = master
            .piece((positions, point.pair), (Standing::anew(own), 0, &Outlook::EVERYWHERE))?;
        let [depth, _] = chain_overclosure(chain, &piece, stand, own)?;
        let long = self.faces_about(place, u).map(|face| face.long()).fold(0.0, f64::max);
        let line = NearLine::about(master, (&piece, stand), 2.0 * long + depth.abs())?;
        let mut gap = |at| line.depth(at).map(|depth| -depth);
        let falls_away = self.falls_away((place, own), u, known, &mut gap)?;
        let falls_away = beyond(falls_away, round);
        let cut = if piece.kind == PieceKind::Corner { line.depth(own) } else { None };
        Some(MissedAt { falls_away, smoothed_away: cut.map_or(0.0, |cut| (cut - depth).abs()) })
    }

    /// How far the master of a slave node falls away from where it is met within half a face about the node, towards
    /// every corner of the face [L]; zero where it does not on some side.
    fn falls_away(
        &self,
        (place, own): (usize, [f64; 3]),
        u: &[f64],
        known: &mut [Option<Option<GapAt>>],
        gap: &mut impl FnMut([f64; 3]) -> Option<f64>,
    ) -> Option<f64> {
        let mut found: Option<(GapAt, Face)> = None;
        for face in self.faces_about(place, u) {
            let met = match face.number.and_then(|number| known.get_mut(number)) {
                Some(known) => *known.get_or_insert_with(|| face.nearest(gap)),
                None => face.nearest(gap),
            };
            let Some(met) = met else { continue };
            if found.is_none_or(|((least, _), _)| met.0 < least) {
                found = Some((met, face));
            }
        }
        let (met, face) = found?;
        let near = met.0 + AT_NODE * face.long();
        let Some(at_node) = gap(own).filter(|gap| *gap <= near) else {
            return Some(face.falls(met, None, gap));
        };
        // at the node itself the faces about it may lie along both flanks
        let (mut sum, mut count) = (0.0, 0.0);
        let level = mean(self.faces_about(place, u).map(|own| own.normal));
        for face in self.faces_about(place, u) {
            sum += face.falls((at_node, own), Some(level), gap);
            count += 1.0;
        }
        Some(sum / count)
    }

    /// The same of a sharp edge of a master in the plane that is held by itself, against the slave face that is
    /// nearest: how far the lines of the master on both sides of it are from the ends of the face.
    pub fn edge_falls_away(
        &self,
        place: usize,
        u: &[f64],
        positions: &MasterPositions,
    ) -> Option<MissedAt> {
        let point = &self.points[place];
        let (of, Carrier::Node { position, .. }) = (self.parent(point.pair), &point.carrier) else {
            return None;
        };
        let MasterSurface::Line { nodes, offset, beyond, itself: None, .. } = &self.masters[of]
        else {
            return None;
        };
        let own = beyond.own(nodes.len());
        let edge = own.start + nodes[own].iter().position(|(from, _)| from == position)?;
        let stand = positions.nodes.get(*offset..offset + nodes.len())?;
        let [a, b, c] = *stand.get(edge.checked_sub(1)?..edge + 2)? else { return None };
        let own = self.points.iter().filter(|point| point.pair == of && point.is_node());
        let faces = own.flat_map(|point| &point.faces).map(|&face| {
            let ends = self.slave_faces[face].places(u);
            let half = sub(ends[1], ends[0]).map(|own| 0.5 * own);
            (size(sub(mean(ends.iter().copied()), b)), half)
        });
        // of two that are as near the shorter one
        let order = |a: &(f64, [f64; 3]), b: &(f64, [f64; 3])| {
            a.0.total_cmp(&b.0).then(size(a.1).total_cmp(&size(b.1)))
        };
        let (_, half) = faces.min_by(order)?;
        let falls = [1.0, -1.0].map(|side| {
            let at = std::array::from_fn(|axis| b[axis] + side * half[axis]);
            let depth = depth_behind([a, b], at).min(depth_behind([b, c], at));
            (-depth).clamp(0.0, 2.0 * size(half))
        });
        // it is held itself: nothing of it is smoothed away
        Some(MissedAt { falls_away: falls[0].min(falls[1]), smoothed_away: 0.0 })
    }

    /// The faces about a slave node.
    fn faces_about<'a>(
        &'a self,
        place: usize,
        u: &'a [f64],
    ) -> impl Iterator<Item = Face> + Clone + 'a {
        let point = &self.points[place];
        let faces = point.faces.iter().map(move |&face| {
            let own = &self.slave_faces[face];
            Face::new(Some(face), (own.places(u), own.stands(u).0), 1.0 / own.parts)
        });
        let edges: &[[usize; 2]] =
            if point.faces.is_empty() { &self.edges[point.pair] } else { &[] };
        let about = edges.iter().filter(move |ends| ends.contains(&place));
        faces.chain(about.map(move |ends| {
            let [a, b] = ends.map(|end| self.place(&self.points[end], 0.0, u));
            let corners = Corners::of([a, b].into_iter());
            Face::new(None, (corners, [b[1] - a[1], a[0] - b[0], 0.0]), 1.0)
        }))
    }

    /// How deep a place stands in the analytical surface, or faces in space, that a slave node has [L]; `None` where it
    /// faces nothing.
    pub(super) fn depth_at(
        &self,
        point: &SlavePoint,
        at: [f64; 3],
        (u, positions): (&[f64], &MasterPositions),
        room: &mut FaceRoom,
    ) -> Option<f64> {
        let master = &self.masters[point.pair];
        match master {
            MasterSurface::Body { surface, .. } => surface.overclosure(&master.placed_body(u), at),
            MasterSurface::Faces { itself: None, .. } => {
                self.depth_in_faces(point, at, positions, room)
            }
            _ => None,
        }
    }
}

/// What is left of a length beyond another one [L].
fn beyond(length: f64, other: f64) -> f64 {
    (length - other).max(0.0)
}

/// How deep a place of the plane stands behind a line whose material is on the right [L].
fn depth_behind([from, to]: [[f64; 3]; 2], at: [f64; 3]) -> f64 {
    let (along, way) = (sub(to, from), sub(at, from));
    (along[1] * way[0] - along[0] * way[1]) / along[0].hypot(along[1])
}

/// The mean of places or directions.
fn mean(all: impl Iterator<Item = [f64; 3]> + Clone) -> [f64; 3] {
    let count = all.clone().count().max(1) as f64;
    std::array::from_fn(|axis| all.clone().map(|own| own[axis]).sum::<f64>() / count)
}

/// Places all over a face.
pub(super) fn places(corners: &[[f64; 3]]) -> impl Iterator<Item = [f64; 3]> + '_ {
    let (is_line, is_triangle) = (corners.len() == 2, corners.len() == 3);
    let count = PARTS[usize::from(!is_line)];
    let across = if is_line { 0 } else { count };
    let all = (0..=count).flat_map(move |i| (0..=across).map(move |j| [i, j]));
    all.filter(move |[i, j]| !is_triangle || i + j <= count).map(move |parts| {
        let [s, t] = parts.map(|part| part as f64 / count as f64);
        let shares = match corners.len() {
            2 => [1.0 - s, s, 0.0, 0.0],
            3 => [1.0 - s - t, s, t, 0.0],
            _ => [(1.0 - s) * (1.0 - t), s * (1.0 - t), s * t, (1.0 - s) * t],
        };
        let all = || corners.iter().zip(shares);
        std::array::from_fn(|axis| all().map(|(at, share)| share * at[axis]).sum())
    })
}
