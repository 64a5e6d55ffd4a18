//! Integration points that follow the closed part of their cells, differentiated.
//!
//! ```text
//!      cell
//!   |--[ x   x   x ]--|      an end stands where contact begins, h(xi, u) = h_0:
//!      ^           ^         xi' = ( h_0' - a u' ) / (dh/dxi)
//! ```
//!
//! docs/theory.md section 13, along beams.

use super::facing::Facing;
use super::kinematics::ContactKinematics;
use super::pairs::Contact;
use super::positions::MasterPositions;
use super::segment::{CELLS, SlaveSegment};
use crate::state::PointState;
use slideline_mech::contact::pair::History;
use slideline_mech::contact::points::integration_points::{GAUSS, POINTS};
use slideline_mech::contact::tangential::Tangential;
use std::ops::Range;

/// Places beside one on an element, in its length, and what they count in a derivative along it: its
/// error is of the fourth power, and rounding of what is differentiated a thousandfold.
const BESIDE: [(f64, f64); 4] = [
    (-2.0 * STEP, 1.0 / (12.0 * STEP)),
    (-STEP, -8.0 / (12.0 * STEP)),
    (STEP, 8.0 / (12.0 * STEP)),
    (2.0 * STEP, -1.0 / (12.0 * STEP)),
];
const STEP: f64 = 1e-3;
/// Part of an element within which an end stands where contact begins [1].
const STANDS: f64 = 1e-9;
/// Part of a cell by which rounding may take an end of it inside [1].
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Ends of closed parts inside cells, and the closed integration points.
#[derive(Clone, Debug, Default)]
pub struct MovingPoints {
    ends: Vec<MovingEnd>,
    points: Vec<MovingPoint>,
    entries: Vec<(usize, f64)>,
    /// Where places beside the points are looked at.
    room: ContactKinematics,
}

/// An end of the closed part of a cell, inside it.
#[derive(Clone, Debug)]
pub struct MovingEnd {
    /// The pair that it is of.
    pub pair: usize,
    /// How it follows the overclosure at which contact begins [1/L].
    pub by_begin: f64,
    /// How it follows dofs.
    row: Range<usize>,
    /// The points that follow it, among those that are kept.
    points: Range<usize>,
}

/// How a point follows an end: which, by which part of its way, and by how much of its area that grows.
#[derive(Clone, Copy, Debug)]
struct Follows {
    end: usize,
    part: f64,
    stretch: f64,
}

/// A closed integration point.
#[derive(Clone, Debug)]
pub struct MovingPoint {
    /// Its place among all points.
    pub place: usize,
    /// Slip of the increment [L].
    pub slip: Tangential,
    /// How overclosure and slip grow along the element [L].
    pub closes: f64,
    pub slides: f64,
    /// How its coordinates along the master do [L].
    pub along: Tangential,
    /// The ends that it follows.
    ends: [Option<Follows>; 2],
    /// How its force turns along the element, pressure and traction held [F].
    turned: Range<usize>,
    /// How the slip follows the dofs of the last commit [1].
    before: Range<usize>,
}

impl MovingPoint {
    /// How it moves along its element with rates of the ends.
    pub fn moves(&self, ends: &[f64]) -> f64 {
        self.ends.iter().flatten().map(|own| own.part * ends[own.end]).sum()
    }

    /// How its area grows with them, in parts of it.
    pub fn stretches(&self, ends: &[f64]) -> f64 {
        self.ends.iter().flatten().map(|own| own.stretch * ends[own.end]).sum()
    }

    /// The same with one of the ends alone.
    pub fn with_end(&self, end: usize) -> (f64, f64) {
        let own = self.ends.iter().flatten().find(|own| own.end == end);
        own.map_or((0.0, 0.0), |own| (own.part, own.stretch))
    }
}

impl MovingPoints {
    /// Forgets all.
    pub fn clear(&mut self) {
        self.ends.clear();
        self.points.clear();
        self.entries.clear();
    }

    /// The ends.
    pub fn ends(&self) -> &[MovingEnd] {
        &self.ends
    }

    /// The points that follow an end.
    pub fn of_end(&self, end: usize) -> &[MovingPoint] {
        &self.points[self.ends[end].points.clone()]
    }

    /// A closed integration point by its place among all points.
    pub fn of(&self, place: usize) -> Option<&MovingPoint> {
        let found = self.points.binary_search_by_key(&place, |own| own.place).ok()?;
        self.points.get(found)
    }

    /// How an end follows dofs.
    pub fn row(&self, end: usize) -> &[(usize, f64)] {
        &self.entries[self.ends[end].row.clone()]
    }

    /// How the force of a point turns along its element, by dofs [F].
    pub fn turned(&self, point: &MovingPoint) -> &[(usize, f64)] {
        &self.entries[point.turned.clone()]
    }

    /// Rates of all ends with those of displacements, and of where contact begins for each pair.
    pub fn rates_of_ends(&self, moved: &[f64], begins: impl Fn(usize) -> f64, into: &mut Vec<f64>) {
        into.clear();
        into.extend(self.ends.iter().map(|own| {
            own.by_begin * begins(own.pair) + along(&self.entries[own.row.clone()], moved)
        }));
    }

    /// Rate of the slip of a point whose rows slide, and which moves along its element, with rates
    /// of the displacements of the last commit [L]; none where it faced nothing then.
    pub fn slides(&self, point: &MovingPoint, (slides, xi): (f64, f64), before: &[f64]) -> f64 {
        match &self.entries[point.before.clone()] {
            [] => 0.0,
            row => slides + xi * point.slides - along(row, before),
        }
    }

    /// Takes the points of a state at displacements `u.0` that began from `u.1`. `None`: an end stands
    /// where its overclosure has no slope, or not where contact begins, as at an end of the master.
    pub fn take(
        &mut self,
        contact: &Contact,
        u: [&[f64]; 2],
        (kinematics, points): (&ContactKinematics, &[PointState]),
    ) -> Option<()> {
        self.clear();
        if contact.segments.is_empty() {
            return Some(());
        }
        // it may be of another case of a study
        contact.forget(&mut self.room);
        for segment in &contact.segments {
            for cell in 0..CELLS {
                if let Some(part) = segment.closed_before(cell, points) {
                    self.take_points_of(contact, u, (kinematics, points), (segment, cell, part))?;
                }
            }
        }
        Some(())
    }

    fn take_points_of(
        &mut self,
        contact: &Contact,
        u: [&[f64]; 2],
        (kinematics, points): (&ContactKinematics, &[PointState]),
        (segment, cell, (begin, end)): (&SlaveSegment, usize, (f64, f64)),
    ) -> Option<()> {
        let first = segment.first + cell * POINTS;
        let own = self.points.len();
        let mut ends = [None; 2];
        for (into, (at, rest)) in ends.iter_mut().zip([(begin, 0.0), (end, 1.0)]) {
            if f64::abs(at - rest) > ROUNDING {
                *into = Some(self.ends.len());
                let xi = (cell as f64 + at) / CELLS as f64;
                self.take_end(contact, u[0], (segment.pair, first, xi))?;
            }
        }
        let length = (end - begin) / CELLS as f64;
        for (k, (t, _)) in GAUSS.into_iter().enumerate() {
            if !points[first + k].closed {
                return None;
            }
            let follows = |end: Option<usize>, part: f64, side: f64| {
                end.map(|end| Follows { end, part, stretch: side / length })
            };
            let ends = [follows(ends[0], 1.0 - t, -1.0), follows(ends[1], t, 1.0)];
            self.take_point(contact, u, (kinematics, points), (first + k, ends))?;
        }
        let all = own..self.points.len();
        ends.iter().flatten().for_each(|&end| self.ends[end].points = all.clone());
        Some(())
    }

    fn take_end(
        &mut self,
        contact: &Contact,
        u: &[f64],
        (pair, place, xi): (usize, usize, f64),
    ) -> Option<()> {
        let Self { ends, entries, room, .. } = self;
        let facing = contact.stand_along(place, (xi, None), u, room)?;
        let slope = BESIDE.into_iter().try_fold(0.0, |sum, (step, weight)| {
            let (overclosure, _) = contact.gap_beside(place, (xi + step, &facing), u)?;
            Some(sum + weight * overclosure)
        });
        let (stands, _) = contact.gap_beside(place, (xi, &facing), u)?;
        let begins = contact.laws[pair].normal.contact_begins();
        if (stands - begins).abs() > STANDS * slope?.abs() {
            return None; // it ends with what it faces, or where that leaps
        }
        let by_begin = 1.0 / slope?;
        let begin = entries.len();
        let rows = room.at(place).rows;
        let normal = rows.unknowns.iter().zip(rows.normal());
        entries.extend(normal.map(|(&dof, a)| (dof, -by_begin * a)));
        let row = begin..entries.len();
        ends.push(MovingEnd { pair, by_begin, row, points: 0..0 });
        by_begin.is_finite().then_some(())
    }

    fn take_point(
        &mut self,
        contact: &Contact,
        [u, u_before]: [&[f64]; 2],
        (kinematics, points): (&ContactKinematics, &[PointState]),
        (place, ends): (usize, [Option<Follows>; 2]),
    ) -> Option<()> {
        let Self { points: all, entries, room, .. } = self;
        let (from, now) = (kinematics.at(place), &points[place]);
        let begin = entries.len();
        let stood = contact.stand_along(place, (from.xi, None), u_before, room);
        if stood.is_some() {
            let rows = room.at(place).rows;
            entries.extend(rows.unknowns.iter().copied().zip(rows.slip(0).iter().copied()));
        }
        let slip = |along: Tangential, before: Option<Tangential>| {
            let history = History { along: before, ..History::default() };
            contact.change(&contact.points[place], &history, along)
        };
        let before = begin..entries.len();
        let along_before = stood.map(|_| room.points()[place].along);
        let mut own = MovingPoint {
            place,
            slip: slip(from.along, along_before),
            closes: 0.0,
            slides: 0.0,
            along: Tangential::ZERO,
            ends,
            turned: before.end..before.end,
            before,
        };
        if ends.iter().any(Option::is_some) {
            let facing = from.facing?;
            entries.extend(from.rows.unknowns.iter().map(|&dof| (dof, 0.0)));
            own.turned.end = entries.len();
            let force = (now.area * now.pressure, now.area * now.traction[0]);
            for (step, weight) in BESIDE {
                let xi = from.xi + step;
                let along_before = match &stood {
                    Some(stood) => Some(contact.gap_beside(place, (xi, stood), u_before)?.1),
                    None => None,
                };
                contact.stand_along(place, (xi, Some(facing)), u, room)?;
                let beside = room.at(place);
                own.closes += weight * beside.overclosure;
                own.along += weight * beside.along;
                own.slides += weight * slip(beside.along, along_before)[0];
                let forces = beside.rows.normal().iter().zip(beside.rows.force(0));
                for (entry, (a, b)) in entries[own.turned.clone()].iter_mut().zip(forces) {
                    entry.1 += weight * (force.0 * a + force.1 * b);
                }
            }
        }
        all.push(own);
        Some(())
    }
}

impl Contact {
    /// Whether rows and tractions of all points tell all of their motion, and the closed parts of cells how
    /// integration points move: nodes, and beams along which contact is integrated, in the plane, that
    /// obey laws of the house, with nothing allowed of their overclosures.
    pub fn is_told_by_rows(&self) -> bool {
        self.directions == 1
            && self.allowances.is_empty()
            && self.laws.iter().all(|laws| laws.user.is_none())
            && self.points.iter().all(|point| point.is_node() || point.is_integration_point())
            && self.segments.iter().all(|segment| {
                let laws = &self.laws[segment.pair];
                segment.is_of_beam()
                    && !self.keeps[segment.pair]
                    && laws.normal.pressure(0.0).is_some()
                    && !laws.friction.needs_multiplier()
            })
    }

    /// Whether rates tell the slips of all points: those of nodes are differences of positions.
    pub fn slips_by_rates(&self) -> bool {
        self.points.iter().all(super::pairs::SlavePoint::is_integration_point)
    }

    /// Lets an integration point stand at `xi` of its element with its rows, against what it faces there or what is
    /// given; what it faces. `None`: nothing.
    fn stand_along(
        &self,
        place: usize,
        (xi, facing): (f64, Option<Facing>),
        u: &[f64],
        into: &mut ContactKinematics,
    ) -> Option<Facing> {
        let point = &self.points[place];
        let mut stencil = self.slave(point, xi, u);
        let none = MasterPositions::default();
        let (gap, facing) = match facing {
            None => self.face(point, xi, u, &none, &mut stencil)?,
            Some(facing) => {
                let (slave, at) = (self.attachment(point, xi), (u, &none.nodes[..]));
                (self.masters[point.pair].gap(&facing, slave, at, &mut stencil)?, facing)
            }
        };
        let mut into = into.at_mut(place);
        (into.point.position, into.point.xi) = (stencil.position, xi);
        into.point.take(&gap, facing, stencil.along(&gap, u));
        into.take(&gap, &stencil, u);
        Some(facing)
    }

    /// Lets integration points stand where a state has them on their elements.
    pub fn stand_as(&self, points: &[PointState], u: &[f64], into: &mut ContactKinematics) {
        for (place, now) in points.iter().enumerate() {
            if self.points[place].is_integration_point() && into.points()[place].faces {
                self.stand_along(place, (now.xi, None), u, into);
                into.at_mut(place).point.area = now.area;
            }
        }
    }

    /// Overclosure and coordinates along the master of an integration point at `xi` of its element,
    /// against what it faces [L].
    fn gap_beside(
        &self,
        place: usize,
        (xi, facing): (f64, &Facing),
        u: &[f64],
    ) -> Option<(f64, Tangential)> {
        let point = &self.points[place];
        let mut stencil = self.slave(point, xi, u);
        let slave = self.attachment(point, xi);
        let gap = self.masters[point.pair].gap(facing, slave, (u, &[]), &mut stencil)?;
        Some((gap.overclosure(), stencil.along(&gap, u)))
    }
}

fn along(row: &[(usize, f64)], rates: &[f64]) -> f64 {
    row.iter().map(|&(dof, value)| value * rates[dof]).sum()
}
