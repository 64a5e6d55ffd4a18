//! Points that stand behind a master, or have no room between two.

use super::beyond::{Beyond, ChainNode};
use super::facing::Facing;
use super::kinematics::{ContactKinematics, PointKinematics};
use super::master::MasterSurface;
use super::pairs::{Contact, SlavePoint};
use super::positions::distance;
use super::thicknesses::Behind;
use crate::state::PointState;
use slideline_mech::contact::gap::offset::Offset;
use slideline_mech::contact::search::chain::Chain;
use slideline_mech::contact::search::pass::cross_faces;
use slideline_mech::contact::search::sweep::{cross_chain, cross_parts};
use slideline_mech::vector::{Vector, add, dot, scale, size};
use slideline_model::Presence;

/// Parts of a segment whose ends are held against another body.
const OUTLINE: usize = 64;

/// Cosine of the angle between normals from which on a face looks past another one [1]: of half a right angle.
const ASIDE: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Part of the size of its faces that a node may stand deep in a master before it is asked which way it came [1]. (choice)
const SMALL: f64 = 0.25;

/// Whether a slave node that faced nothing before lies behind what it faces now.
fn stands_behind(
    (point, offset): (&SlavePoint, Offset),
    before: &PointState,
    now: &PointKinematics,
) -> bool {
    let aside = before.along.is_none() && !before.closed && point.is_node();
    aside && now.faces && now.overclosure > offset.both()
}

impl Contact {
    /// Whether a node is on the other side of the part that it faces: further behind than that is thick, and every one of
    /// its own faces looks past what it faces, or sees it through its own part. One that is as deep and looks at it with less of its
    /// part behind it has sunk in through the master; where all look along with it, the master looks the wrong way. Both are said
    /// elsewhere; so is a part in the wrong place, `at_start`, where faces that could meet are not of the surfaces.
    ///
    /// ```text
    ///      slave            master
    ///     +-----------+    +------+
    ///     x           |    |      > faced      deeper behind it than both parts are thick: x looks away
    ///     +-----------+    +------+            from the master, through its own part
    /// ```
    ///
    /// So is one whose way to its place enters the part by another face first ([`Contact::sees_through_a_part`]).
    fn is_beyond(
        &self,
        point: &SlavePoint,
        (now, u): (&PointKinematics, &[f64]),
        at_start: bool,
    ) -> bool {
        let depth = now.overclosure + now.allowed - self.offsets[point.pair].both();
        if !point.is_node() || !now.faces || point.faces.is_empty() {
            return false;
        }
        let master = self.behind_faced(point.pair, now);
        let looks_past = |&face: &usize| {
            let own = self.slave_faces[face].stands(u).0;
            let along = dot(own, now.normal) / size(own);
            let slave = self.thicknesses.of_slave(face);
            let are_whole = master.has_far_side && slave.has_far_side;
            if along.abs() < ASIDE {
                true
            } else if along < 0.0 {
                depth > slave.thickness && (are_whole || !at_start)
            } else {
                master.has_far_side
            }
        };
        depth > master.thickness && point.faces.iter().all(looks_past)
            || self.sees_through_a_part((point, depth), (now, u))
    }

    /// Whether the way of a node to its place on the master, so deep [L], enters the master's part first: it stands outside, and sees
    /// a face from behind.
    ///
    /// ```text
    ///     ________________
    ///     faced \   ____ |     beyond the end of a surface, or beside a pointed tooth, the
    ///            \ /    x      nearest face before which the node stands is not its own side's
    ///             v
    /// ```
    fn sees_through_a_part(
        &self,
        (point, depth): (&SlavePoint, f64),
        (now, u): (&PointKinematics, &[f64]),
    ) -> bool {
        // faces in space, and lines that meet themselves, are looked at in this way by their search
        let MasterSurface::Line { chain, nodes, beyond, itself: None, .. } =
            &self.masters[point.pair]
        else {
            return false;
        };
        let sizes = point.faces.iter().map(|&face| self.slave_faces[face].stands(u).1);
        if depth <= SMALL * sizes.fold(f64::INFINITY, f64::min) {
            return false;
        }
        let place = add(now.position, scale(now.normal, now.overclosure + now.allowed));
        let (stands, mut enters) = (line(chain, nodes, beyond, u), false);
        cross_chain((&stands, &stands), (now.position, place), |own| enters |= own.inward);
        enters
    }

    /// What is behind what a point faces of a master, the thicker part.
    fn behind_faced(&self, pair: usize, now: &PointKinematics) -> Behind {
        let (MasterSurface::Line { nodes, beyond, itself: None, .. }, Some(Facing::Piece(piece))) =
            (&self.masters[pair], &now.facing)
        else {
            return Behind::UNKNOWN;
        };
        let last = nodes.len().saturating_sub(2);
        let own = piece.segments().map(|part| beyond.own_segment(part.min(last), nodes.len()));
        let behind = own.map(|part| self.thicknesses.of_master(pair, part));
        behind.reduce(Behind::or_thicker).unwrap_or(Behind::UNKNOWN)
    }

    /// Whether a point that did not touch faces something now through a part: a node, which had not sunk in before, the far
    /// side of the master's; a point that is spread over faces, and faced nothing before, a master further behind these than
    /// its own is thick.
    fn faces_through_a_part(
        &self,
        place: usize,
        before: &PointState,
        (now, u): (&PointKinematics, &[f64]),
    ) -> bool {
        let point = &self.points[place];
        let had_sunk_in = before.along.is_some() && before.allowed - before.opening > 0.0;
        let through = || match point.is_spread() {
            true => before.along.is_none() && now.overclosure > self.thicknesses.of_point(place),
            false => !had_sunk_in && self.is_beyond(point, (now, u), false),
        };
        !before.closed && now.faces && through()
    }

    /// Two rigid masters of the same slave nodes that stand deeper in one another
    /// than in the undeformed model and than their points sink in: their pairs,
    /// and how deep [L].
    pub fn without_room(&self, u: &[f64], points: &[PointState]) -> Option<([usize; 2], f64)> {
        let sunk = |pair: usize| {
            let own = self.points.iter().zip(points).filter(move |(point, _)| point.pair == pair);
            let depths = own.map(|(_, state)| -state.opening).filter(|depth| depth.is_finite());
            depths.fold(0.0_f64, f64::max)
        };
        self.opposed.iter().find_map(|&pairs| {
            let overlap = self.overlap(pairs, u);
            if overlap <= sunk(pairs[0]) + sunk(pairs[1]) {
                return None;
            }
            let undeformed = self.overlap(pairs, &vec![0.0; u.len()]);
            (overlap > undeformed + sunk(pairs[0]) + sunk(pairs[1])).then_some((pairs, overlap))
        })
    }

    /// How deep two rigid masters stand in one another [L]; zero where they do
    /// not, or are not rigid.
    pub fn overlap(&self, pairs: [usize; 2], u: &[f64]) -> f64 {
        let [first, second] = pairs.map(|pair| &self.masters[pair]);
        let within = |of: &MasterSurface, other: &MasterSurface| {
            let (MasterSurface::Body { surface, .. }, MasterSurface::Body { surface: own, .. }) =
                (of, other)
            else {
                return 0.0;
            };
            let (body, other) = (of.placed_body(u), other.placed_body(u));
            let ((a, reach), (b, other_reach)) = (surface.bounds(), own.bounds());
            if distance(body.to_space(a), other.to_space(b)) > reach + other_reach {
                return 0.0;
            }
            let places = surface.outline(OUTLINE);
            let depths = places.filter_map(|at| own.overclosure(&other, body.to_space(at)));
            depths.fold(0.0_f64, f64::max)
        };
        within(first, second).max(within(second, first))
    }

    /// Turns slave nodes away from masters that they did not meet from the
    /// front: those that faced nothing at the last commit, as beyond an open end,
    /// and stand behind their master now without having crossed it. Where contact is spread over faces, a
    /// part of a face may be covered while its node is beside the master: that counts as behind where the own part
    /// lies between.
    ///
    /// ```text
    ///     front   o------------- master     a node that comes round the end
    ///     behind        <--- x              has not touched the front
    /// ```
    pub fn turn_away_from_behind(
        &self,
        (from, before): (&[f64], &[PointState]),
        u: &[f64],
        kinematics: &mut ContactKinematics,
    ) {
        for (place, point) in self.points.iter().enumerate() {
            let now = kinematics.points()[place];
            if stands_behind((point, self.offsets[point.pair]), &before[place], &now)
                || self.faces_through_a_part(place, &before[place], (&now, u))
            {
                let start = self.slave(point, 0.0, from).position;
                if !self.enters(point, (start, now.position), (from, u)) {
                    let mut own = kinematics.at_mut(place);
                    own.turn_away_in_place();
                    if point.is_node() {
                        own.point.behind = now.overclosure - self.offsets[point.pair].both();
                    }
                }
            }
        }
    }

    /// Turns slave nodes away when a step begins: of pairs that are new in it those behind the part of their
    /// master that look past it ([`Contact::is_beyond`]), of others those that stood behind when the step before
    /// ended, for to begin a step takes them to no front.
    ///
    /// ```text
    ///     --+------+ top        the node stands below the part, beyond the end of its bore, and
    ///   bore| part |            faces its top from behind, through all of it
    ///       +------+
    ///          x
    /// ```
    pub fn stay_behind(
        &self,
        presence: Option<&Presence>,
        (before, u): (&[PointState], &[f64]),
        kinematics: &mut ContactKinematics,
    ) {
        for (place, point) in self.points.iter().enumerate() {
            let now = kinematics.points()[place];
            let was_there = presence.is_some_and(|own| own.has_pair(self.parent(point.pair)));
            let stays = if was_there {
                stands_behind((point, self.offsets[point.pair]), &before[place], &now)
                    || self.faces_through_a_part(place, &before[place], (&now, u))
            } else {
                self.is_beyond(point, (&now, u), true)
            };
            if stays {
                kinematics.at_mut(place).turn_away_in_place();
            }
        }
    }

    /// Whether a way crosses a master from its front.
    fn enters(
        &self,
        point: &SlavePoint,
        (start, end): ([f64; 3], [f64; 3]),
        (from, to): (&[f64], &[f64]),
    ) -> bool {
        let mut inward = false;
        let master = &self.masters[point.pair];
        match master {
            MasterSurface::Nothing => {}
            MasterSurface::Faces { mesh, nodes, .. } => {
                let positions = |u: &[f64]| -> Vec<_> {
                    nodes.iter().map(|(at, dofs)| dofs.displace(*at, u)).collect()
                };
                let (before, after) = (positions(from), positions(to));
                let all = (0..mesh.faces().len()).filter(|&face| self.is_stopped(point, face));
                cross_faces(mesh, (&before, &after), all, (start, end), |crossing| {
                    inward |= crossing.inward;
                });
            }
            MasterSurface::Body { surface, .. } => {
                let local = |at: [f64; 3], u: &[f64]| master.placed_body(u).to_body(at);
                let way = (local(start, from), local(end, to));
                surface.crossings(way, |crossing, _| inward |= crossing.inward);
            }
            MasterSurface::Line { nodes, itself: Some(_), .. } => {
                let positions = |u: &[f64]| -> Vec<_> {
                    nodes.iter().map(|(at, dofs)| dofs.displace(*at, u)).collect()
                };
                let (before, after) = (positions(from), positions(to));
                let parts = (0..nodes.len() - 1).filter(|&part| self.is_stopped(point, part));
                cross_parts((&before, &after), parts, (start, end), |crossing| {
                    inward |= crossing.inward;
                });
            }
            MasterSurface::Line { chain, nodes, beyond, .. } => {
                let [before, after] = [from, to].map(|u| line(chain, nodes, beyond, u));
                cross_chain((&before, &after), (start, end), |crossing| inward |= crossing.inward);
            }
        }
        inward
    }
}

/// Where the nodes of a line stand, its ends prolonged [L].
fn line(chain: &Chain, nodes: &[ChainNode], beyond: &Beyond, u: &[f64]) -> Vec<Vector> {
    let own = nodes[beyond.own(nodes.len())].iter();
    chain.prolonged(own.map(|(at, dofs)| dofs.displace(*at, u)).collect())
}
