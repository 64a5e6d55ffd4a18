//! Crossings in one configuration: which point is which, and its rows over dofs.
//!
//! docs/theory.md section 5.18

use super::allowed::gap_before;
use super::places::Found;
use super::sides::{EdgeCrossings, PlacedSides};
use crate::contact::before::Before;
use crate::contact::facing::Facing;
use crate::contact::kinematics::{ContactKinematics, PointRowsMut};
use crate::contact::pairs::Contact;
use slideline_mech::contact::pair::{EdgePoint, EdgesBefore};
use slideline_mech::contact::tangential::Tangential;

/// Nodes of a crossing and of the one of the last commit, by side and place.
const MOST_NODES: usize = 8;

impl Contact {
    /// Where all crossings stand at displacements `u`.
    pub(crate) fn locate_crossings(
        &self,
        u: &[f64],
        before: Before<'_>,
        into: &mut ContactKinematics,
    ) {
        let mut rooms = std::mem::take(&mut into.crossings);
        rooms.resize_with(self.crossings.len(), PlacedSides::default);
        for (own, placed) in self.crossings.iter().zip(&mut rooms) {
            let places = own.slots.iter().flat_map(Clone::clone);
            for place in places.clone() {
                let into = &mut into.at_mut(place);
                into.point.area = self.points[place].area;
                into.turn_away_in_place();
            }
            if own.is_absent {
                continue;
            }
            own.place(u, placed);
            let mut known: Vec<usize> = places.filter_map(|place| before.face(place)).collect();
            known.sort_unstable();
            let held = |edges| known.binary_search(&own.number(edges)).is_ok();
            let found = own.found(placed, held);
            let of_line = |own: &EdgeCrossings, found: &Found| own.lines(found.edges)[0];
            for group in found.chunk_by(|a, b| of_line(own, a) == of_line(own, b)) {
                let slots = own.slots[of_line(own, &group[0])].clone();
                for (place, found) in seated(own, slots, group, before) {
                    self.locate_crossing(
                        own,
                        (place, &found),
                        (u, before),
                        &mut into.at_mut(place),
                    );
                }
            }
        }
        into.crossings = rooms;
    }

    fn locate_crossing(
        &self,
        own: &EdgeCrossings,
        (place, found): (usize, &Found),
        (u, before): (&[f64], Before<'_>),
        into: &mut PointRowsMut<'_>,
    ) {
        let committed = before.points.get(place);
        let was_closed = committed.is_some_and(|before| before.closed);
        if !was_closed && self.came_from_elsewhere(own, found, (u, before)) {
            return;
        }
        let stood = committed.filter(|_| self.continues(own, place, found, before));
        let stood = stood.and_then(|point| Some((point.footing?, point.along?)));
        let edges_then = stood.map(|(footing, _)| own.edges(footing.place.face));
        let then = stood.map(|(footing, _)| EdgesBefore {
            ends: own.ends(own.edges(footing.place.face), u),
            at: footing.place.at,
        });
        let point = EdgePoint::new(found.gap, then);
        let origin = committed.and_then(|before| before.along).unwrap_or(Tangential::ZERO);
        into.point.faces = true;
        into.point.overclosure = -found.gap.gap;
        into.point.allow(self.crossing_allowance(own, (place, found), before));
        into.point.along = origin + point.slip;
        into.point.normal = found.gap.normal;
        into.point.position = point.position(own.slave.ends(found.edges[0], u));
        into.point.facing = Some(Facing::Edges(found.edges));
        into.point.footing = Some(point.footing(own.number(found.edges)));
        write_rows(own, (found.edges, edges_then), &point, into);
    }
}

impl Contact {
    /// Whether two edges that are not held stand in one another, and not by having met: what is deeper than an edge is long came
    /// from behind, as round an end; what is deeper than both bodies go behind their edges stands beyond the other one; and
    /// what was behind at the last commit and is deeper than it is far from an end of its line came in through
    /// another side there.
    fn came_from_elsewhere(
        &self,
        own: &EdgeCrossings,
        found: &Found,
        (u, before): (&[f64], Before<'_>),
    ) -> bool {
        let depth = -found.gap.gap;
        let came_from_front = || gap_before(own, found, before).is_some_and(|then| then.gap >= 0.0);
        depth > 0.0
            && (depth > self.spacing[own.of].min(found.reach)
                || depth > own.width(found, u) && !came_from_front())
    }
}

/// Writes the rows of a crossing over the dofs of its edges, then of those of the last commit.
fn write_rows(
    own: &EdgeCrossings,
    (edges, then): ([usize; 2], Option<[usize; 2]>),
    point: &EdgePoint,
    into: &mut PointRowsMut<'_>,
) {
    let ends = |edges: [usize; 2]| {
        let [slave, master] = [own.slave.edges[edges[0]].ends, own.master.edges[edges[1]].ends];
        [(0, slave[0]), (0, slave[1]), (1, master[0]), (1, master[1])]
    };
    let (mut nodes, mut count) = ([(0, 0); MOST_NODES], 4);
    nodes[..4].copy_from_slice(&ends(edges));
    let before = then.map_or([0; 4], |then| {
        ends(then).map(|end| {
            let known = nodes[..count].iter().position(|&own| own == end);
            known.unwrap_or_else(|| {
                nodes[count] = end;
                count += 1;
                count - 1
            })
        })
    });
    let mut dofs = [0; 3 * MOST_NODES];
    for (&(side, node), dofs) in nodes[..count].iter().zip(dofs.chunks_exact_mut(3)) {
        dofs.copy_from_slice(own.sides()[side].nodes[node].dofs.as_slice());
    }
    let width = 3 * count;
    let rows = into.rows.start(&dofs[..width]);
    point.rows(|row, is_before, end, value| {
        let node = if is_before { before[end] } else { end };
        let row = &mut rows[row * width + 3 * node..][..3];
        row.iter_mut().zip(value).for_each(|(into, value)| *into += value);
    });
}

/// The points that the crossings of a line are: those that they were in the last iteration, or at the last commit; new ones are
/// points that were none.
fn seated(
    own: &EdgeCrossings,
    slots: std::ops::Range<usize>,
    found: &[Found],
    before: Before<'_>,
) -> Vec<(usize, Found)> {
    let mut rest: Vec<Found> = found.to_vec();
    let mut seated = Vec::with_capacity(rest.len());
    let mut free: Vec<(usize, Option<[usize; 2]>)> =
        slots.map(|place| (place, before.face(place).map(|number| own.edges(number)))).collect();
    for exactly in [true, false] {
        free.retain(|&(place, known)| {
            let Some(known) = known else { return true };
            let away = |found: &Found| {
                found.edges.iter().zip(known).map(|(a, b)| a.abs_diff(b)).sum::<usize>()
            };
            let is_same = |found: &Found| match exactly {
                true => found.edges == known,
                false => own.lines(found.edges) == own.lines(known),
            };
            let of_line = rest.iter().enumerate().filter(|(_, found)| is_same(found));
            let Some((k, _)) = of_line.min_by_key(|(_, found)| away(found)) else { return true };
            seated.push((place, rest.remove(k)));
            false
        });
    }
    free.sort_by_key(|&(place, known)| (known.is_some(), place));
    seated.extend(free.into_iter().map(|(place, _)| place).zip(rest));
    seated
}
