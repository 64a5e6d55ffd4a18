//! What a point and its master swept past each other in an increment.
//!
//! ```text
//!      o start                   o start
//!      |                          \
//!   .--x--.  in at the bottom      x--.
//!  (   |   )                     in   x out
//!   '--x--'  out at the top            \
//!      o end: it was passed through     o end
//! ```
//!
//! An evaluation looks at one configuration. What lies between the last commit
//! and a converged trial is looked at here, once an increment: the way of every
//! slave point relative to its master; `between` looks at corners of the master.
//! docs/theory.md section 5.8. (derived)

mod events;

use super::master::MasterSurface;
use super::pairs::{Carrier, Contact};
use super::positions::{MasterPositions, distance};
use crate::state::PointState;
use events::{Event, between};
use slideline_mech::vector::dot;

pub use events::{Sweep, SweepScratch};

/// A master that was passed through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Missed {
    /// Place of the pair in the model.
    pub pair: usize,
    /// Place of the slave point, or those of the two between which the master
    /// passed.
    pub points: [usize; 2],
    /// Whether a corner of the master passed between slave points.
    pub between: bool,
    /// Where in the increment contact began [1].
    pub fraction: f64,
}

/// Depth in spacings of slave points at which a path may cut a corner [1].
const CUT: f64 = 0.1;
/// Way round a corner over the way through it, up to which a path cut a
/// corner and did not go through a wall [1].
const ROUND: f64 = 3.0;
/// Cosine of the angle between the normals of two faces from which on these are both sides of a wall, and
/// no longer those of a corner [1]: 120 degrees.
const WALL: f64 = -0.5;
/// Places at which the depth of a path is looked at.
const SAMPLES: usize = 8;

impl Contact {
    /// The first master that a slave point passed through unseen in an
    /// increment: entered and left again, or entered and not faced at its end.
    pub fn passed_through(&self, sweep: &Sweep<'_>, scratch: &mut SweepScratch) -> Option<Missed> {
        self.find_events(sweep, scratch);
        let mut first: Option<Missed> = None;
        let mut rest = &scratch.events[..];
        let mut consider = |place: usize, events: &[(usize, Event)]| {
            let Some(fraction) = self.missed(place, sweep, events, &scratch.chains) else { return };
            if first.is_none_or(|first| fraction < first.fraction) {
                let pair = self.points[place].pair;
                first = Some(Missed { pair, points: [place; 2], between: false, fraction });
            }
        };
        while let Some(&(place, _)) = rest.first() {
            let count = rest.iter().take_while(|(other, _)| *other == place).count();
            let (own, others) = rest.split_at(count);
            consider(place, own);
            rest = others;
        }
        // what slid round a body without leaving it
        for (place, (before, now)) in sweep.before.iter().zip(sweep.now).enumerate() {
            let turned = dot(before.normal, now.normal) < 0.0;
            let may_slide = !self.points[place].is_integration_point() && !self.is_edge(place);
            if before.closed && now.closed && turned && may_slide {
                consider(place, &[]);
            }
        }
        first
    }

    /// Where in the increment a point entered a master that it passed through.
    fn missed(
        &self,
        place: usize,
        sweep: &Sweep<'_>,
        events: &[(usize, Event)],
        chains: &[MasterPositions; 2],
    ) -> Option<f64> {
        let mut entered = self
            .faces(place, (sweep.from, sweep.before), &chains[0], 0.0)
            .filter(|start| start.inward);
        for &(_, event) in events {
            match (event.inward, entered) {
                (true, None) => entered = Some(event),
                (false, Some(from)) => {
                    if self.is_through(place, [&from, &event], &chains[1]) {
                        return Some(from.fraction);
                    }
                    entered = None;
                }
                _ => {}
            }
        }
        let from = entered?;
        let (master, now) = (&self.masters[self.points[place].pair], &sweep.now[place]);
        if master.meets_itself() {
            // what it meets in front of it is another part of its surface; smoothed corners lie a
            // little behind the faces
            let point = &self.points[place];
            let met = self.met_itself(point, &chains[1]);
            let beyond = met.is_none_or(|depth| depth < -CUT * self.spacing[point.pair]);
            let beyond = beyond && !self.meets_corner(point.pair, &from);
            return (beyond && from.fraction > 0.0).then_some(from.fraction);
        }
        if matches!(master, MasterSurface::Line { .. }) && now.along.is_some() {
            return None; // it faces the line, whose corners are smoothed, on the side it stands
        }
        match self.faces(place, (sweep.to, sweep.now), &chains[1], 1.0) {
            Some(end) => self.is_through(place, [&from, &end], &chains[1]).then_some(from.fraction),
            // entered on the way, and at its end it faces nothing
            None if from.fraction > 0.0 => {
                let end = (sweep.to, sweep.now);
                let allowed = CUT * self.spacing[self.points[place].pair];
                let is_deep = || self.depth_without_contact(place, end, &chains[1]) > allowed;
                let of_faces = self.points[place].mortar.is_some();
                (!of_faces || is_deep()).then_some(from.fraction)
            }
            None => self.sinks(place, &from, sweep).then_some(from.fraction),
        }
    }

    /// Whether a point goes into a line at a corner of it, and no deeper than it may cut one.
    fn meets_corner(&self, pair: usize, from: &Event) -> bool {
        let MasterSurface::Line { chain, .. } = &self.masters[pair] else { return false };
        let allowed = CUT * self.spacing[pair];
        let (part, at) = chain.part_at(from.along);
        let to_end = at.min(1.0 - at) * chain.reference_length(part);
        to_end <= allowed && (1.0 - from.fraction) * from.past <= allowed
    }

    /// What a point faces at an end of the way, `inward` where it is closed or
    /// overclosed there; `None` where it faces nothing.
    fn faces(
        &self,
        place: usize,
        (u, points): (&[f64], &[PointState]),
        chains: &MasterPositions,
        fraction: f64,
    ) -> Option<Event> {
        let point = &self.points[place];
        let (along, normal, position, inward) = match point.carrier {
            Carrier::Node { .. } => {
                let state = &points[place];
                let inward = state.closed || state.opening < 0.0;
                (state.along?, state.normal, state.position, inward)
            }
            Carrier::IntegrationPoint { .. } => {
                let kinematics = self.stands(place, u, chains);
                if !kinematics.faces {
                    return None;
                }
                (
                    kinematics.along,
                    kinematics.normal,
                    kinematics.position,
                    kinematics.overclosure > 0.0,
                )
            }
        };
        let (along, past) = (along[0], f64::INFINITY);
        let master = &self.masters[point.pair];
        if !matches!(master, MasterSurface::Body { .. }) {
            return Some(Event { fraction, along, normal, at: position, inward, past });
        }
        let body = master.placed_body(u);
        let (normal, at) = (body.turn_back(normal), body.to_body(position));
        Some(Event { fraction, along, normal, at, inward, past })
    }

    /// Whether a node that was closed and faces nothing now went down into its
    /// master: not where it slid off an open end, or stood so near to one that it
    /// cut no more than that end.
    fn sinks(&self, place: usize, from: &Event, sweep: &Sweep<'_>) -> bool {
        let point = &self.points[place];
        let master = &self.masters[point.pair];
        let MasterSurface::Body { surface, .. } = master else { return false };
        let allowed = CUT * self.spacing[point.pair];
        let to_end = from.along.min(surface.length() - from.along);
        let body = master.placed_body(sweep.to);
        // near an open end it slid off only if it lies beyond that end now
        let is_off = || surface.beyond_end(&body, sweep.now[place].position).is_some();
        let may_slide_off = surface.period().is_none() && to_end <= allowed;
        if point.is_integration_point() || (may_slide_off && is_off()) {
            return false;
        }
        let end = body.to_body(sweep.now[place].position);
        let depth = (1..SAMPLES).filter_map(|k| {
            let t = k as f64 / SAMPLES as f64;
            surface.depth(between(from.at, end, t))
        });
        depth.fold(0.0, f64::max) > allowed
    }

    /// Whether the way between two places of a master goes through its body:
    /// they face apart, and the way neither slides round the body nor cuts no
    /// more than a corner.
    fn is_through(&self, place: usize, [from, to]: [&Event; 2], now: &MasterPositions) -> bool {
        let pair = self.points[place].pair;
        let cosine = dot(from.normal, to.normal);
        let is_deep = || {
            let within = (to.fraction - from.fraction) * from.past.min(to.past);
            within > CUT * self.spacing[pair]
        };
        let is_wall = |straight: f64, period: Option<f64>| {
            let round = (to.along - from.along).abs();
            period.map_or(round, |period| round.min(period - round)) > ROUND * straight
        };
        if cosine >= 0.0 {
            return false;
        }
        let surface = match &self.masters[pair] {
            MasterSurface::Nothing => return false,
            MasterSurface::Faces { .. } => return cosine < WALL || is_deep(),
            MasterSurface::Line { chain, nodes, offset, .. } => {
                let line = &now.nodes[*offset..offset + nodes.len()];
                let [one, other] = [from, to].map(|event| {
                    let (part, along) = chain.part_at(event.along);
                    between(line[part], line[part + 1], along)
                });
                return is_wall(distance(one, other), chain.period()) || is_deep();
            }
            MasterSurface::Body { surface, .. } => surface,
        };
        if is_wall(distance(from.at, to.at), surface.period()) {
            return true;
        }
        let depth = (1..SAMPLES).map(|k| {
            let t = k as f64 / SAMPLES as f64;
            surface.depth(between(from.at, to.at, t)).unwrap_or(f64::INFINITY)
        });
        depth.fold(0.0, f64::max) > CUT * self.spacing[pair]
    }
}
