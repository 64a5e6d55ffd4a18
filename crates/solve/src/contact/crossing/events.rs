//! Where the ways of slave points cross their masters in an increment.
//!
//! ```text
//!     p0 o             point and master on straight ways, in parts where something turns: each
//!         \            crossing with its place in the increment, its normal, and which way
//!   -------x------     it goes
//!           \
//!         p1 o
//! ```
//!
//! docs/theory.md section 5.8. (derived)

use crate::constraints::Constraints;
use crate::contact::master::MasterSurface;
use crate::contact::pairs::{Carrier, Contact};
use crate::contact::positions::MasterPositions;
use crate::state::PointState;
use slideline_mech::contact::pair::{Body, RigidSurface};
use slideline_mech::contact::search::chain::Chain;
use slideline_mech::contact::search::faces::near_way;
use slideline_mech::contact::search::outlook::Outlook;
use slideline_mech::contact::search::pass::cross_faces;
use slideline_mech::contact::search::sweep::{apart, cross_parts};
use slideline_mech::turn::Turn;
use slideline_mech::vector::{size, sub};

/// Both ends of an increment.
#[derive(Clone, Copy)]
pub struct Sweep<'a> {
    /// How dependent dofs follow the others on the way.
    pub constraints: Constraints<'a>,
    /// Dofs that are rotations.
    pub rotations: &'a [usize],
    /// What rotations in space count from, a node each; empty: all from rest.
    pub turns: &'a [Turn],
    /// Displacements at its beginning, a dof each.
    pub from: &'a [f64],
    /// At its end.
    pub to: &'a [f64],
    /// Contact points at its beginning.
    pub before: &'a [PointState],
    /// At its end.
    pub now: &'a [PointState],
}

/// Scratch of a sweep.
#[derive(Clone, Debug, Default)]
pub struct SweepScratch {
    /// Displacements at both ends of a part of the way.
    parts: [Vec<f64>; 2],
    /// Positions of chains there [L].
    pub(super) chains: [MasterPositions; 2],
    /// Crossings by slave points, in the order of the way.
    pub(super) events: Vec<(usize, Event)>,
    /// Parts of a deforming master near the way of a point.
    near: Vec<usize>,
}

/// Where a slave point enters or leaves a master, or stands at an end of its way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Event {
    /// Where in the increment [1].
    pub fraction: f64,
    /// Along the first direction of the master [L].
    pub along: f64,
    /// Outward normal of the master [1].
    pub normal: [f64; 3],
    /// In the frame of the body, of a rigid master [L].
    pub at: [f64; 3],
    /// Whether the point goes in, or is in.
    pub inward: bool,
    /// How far the point would go past a face that it crosses, over the whole increment [L]; not
    /// known of other masters and at the ends of the way.
    pub past: f64,
}

/// Largest turn of a dof in a part of the way that is taken as straight [1].
const TURN: f64 = 0.25;
/// The most parts.
const PARTS: usize = 64;

impl Contact {
    /// Fills in the crossings of all slave points, point by point in the order
    /// of the way.
    pub(super) fn find_events(&self, sweep: &Sweep<'_>, scratch: &mut SweepScratch) {
        let turned = |&dof: &usize| (sweep.to[dof] - sweep.from[dof]).abs();
        let turn = sweep.rotations.iter().map(turned).fold(0.0_f64, f64::max);
        let parts = ((turn / TURN).ceil() as usize).clamp(1, PARTS);
        scratch.events.clear();
        for part in 0..parts {
            for end in 0..2 {
                let fraction = (part + end) as f64 / parts as f64;
                let values = sweep.from.iter().zip(sweep.to).map(|(a, b)| a + fraction * (b - a));
                scratch.parts[end].clear();
                scratch.parts[end].extend(values);
                sweep.constraints.enforce(sweep.turns, &mut scratch.parts[end]);
                self.place_masters(&scratch.parts[end], &mut scratch.chains[end]);
            }
            let [from, to] = &mut scratch.chains;
            self.fit_ways(from, to);
            for pair in 0..self.own_pairs() {
                self.cross_pair(pair, (part, parts), scratch);
            }
        }
        scratch.events.sort_by(|a, b| (a.0.cmp(&b.0)).then(a.1.fraction.total_cmp(&b.1.fraction)));
    }

    /// Adds the crossings of the slave points of a pair in a part of the way.
    fn cross_pair(&self, pair: usize, (part, parts): (usize, usize), scratch: &mut SweepScratch) {
        let SweepScratch { parts: u, chains, events, near } = scratch;
        let room = self.masters[pair].swept(u, chains);
        let share = |fraction: f64| (part as f64 + fraction) / parts as f64;
        for (place, point) in self.points.iter().enumerate().filter(|(_, p)| p.pair == pair) {
            if let Carrier::IntegrationPoint { segment } = point.carrier
                && apart(self.segments[segment].hull(u).as_flattened(), &room)
            {
                continue;
            }
            let xi = self.resting_place(place);
            let way = [0, 1].map(|end| self.place(point, xi, &u[end]));
            if apart(&way, &room) {
                continue;
            }
            let stops = |&part: &usize| self.is_stopped(point, part);
            match &self.masters[pair] {
                MasterSurface::Nothing => {}
                MasterSurface::Faces { mesh, nodes, offset, .. } => {
                    let range = *offset..offset + nodes.len();
                    let positions = (&chains[0].nodes[range.clone()], &chains[1].nodes[range]);
                    let Some(tree) = chains[0].face_tree(pair) else { continue };
                    near_way(tree, (way[0], way[1]), near);
                    let known = self.outlook(point, &u[1]);
                    let outlook = Outlook::of(&known);
                    let meets = |&face: &usize| {
                        outlook.meets(mesh.normal(face, positions.1)) && stops(&face)
                    };
                    let faces = near.iter().copied().filter(meets);
                    cross_faces(mesh, positions, faces, (way[0], way[1]), |crossing| {
                        let (normal, inward) = (crossing.normal, crossing.inward);
                        let (fraction, at) = (share(crossing.fraction), way[0]);
                        let nodes = &mesh.faces()[crossing.segment].nodes;
                        let past = parts as f64 * way_past(nodes, positions, way);
                        let event = Event { fraction, along: 0.0, normal, at, inward, past };
                        events.push((place, event));
                    });
                }
                MasterSurface::Body { surface, .. } => {
                    let bodies = [0, 1].map(|end| self.masters[pair].placed_body(&u[end]));
                    let known = self.outlook(point, &u[1]);
                    let outlook = Outlook::of(&known);
                    cross_body(surface, bodies, (way, outlook), |own| {
                        events.push((place, Event { fraction: share(own.fraction), ..own }));
                    });
                }
                MasterSurface::Line { chain, nodes, offset, .. } => {
                    let range = *offset..offset + nodes.len();
                    let positions = (&chains[0].nodes[range.clone()], &chains[1].nodes[range]);
                    chain.near_way(chains[0].tree(pair), (way[0], way[1]), near);
                    let own = near.iter().copied().filter(|&p| chain.is_own(p) && stops(&p));
                    cross_line(chain, (positions, own), way, |own| {
                        let (fraction, past) = (share(own.fraction), parts as f64 * own.past);
                        events.push((place, Event { fraction, past, ..own }));
                    });
                }
            }
        }
    }
}

/// Places of nodes at both ends of a part of the way [L].
type Ends<'a> = (&'a [[f64; 3]], &'a [[f64; 3]]);

/// How far a point goes past the nodes of a face on its way, at most [L].
fn way_past(nodes: &[usize], (before, after): Ends<'_>, way: [[f64; 3]; 2]) -> f64 {
    let moved = sub(way[1], way[0]);
    let past = |&node: &usize| size(sub(moved, sub(after[node], before[node])));
    nodes.iter().map(past).fold(0.0, f64::max)
}

/// The crossings of the way of a slave node through a rigid surface, by what its faces look at.
fn cross_body(
    surface: &RigidSurface,
    bodies: [Body; 2],
    (way, outlook): ([[f64; 3]; 2], &Outlook),
    mut each: impl FnMut(Event),
) {
    let outlook = outlook.turned(|normal| bodies[1].turn_back(normal));
    let local = [0, 1].map(|end| bodies[end].to_body(way[end]));
    surface.crossings((local[0], local[1]), |crossing, along| {
        if outlook.meets(crossing.normal) {
            let at = between(local[0], local[1], crossing.fraction);
            let (normal, inward, fraction) = (crossing.normal, crossing.inward, crossing.fraction);
            each(Event { fraction, along, normal, at, inward, past: f64::INFINITY });
        }
    });
}

/// The crossings of the way of a slave node through some parts of a line; how far it goes past them is that of this part of the way.
fn cross_line(
    chain: &Chain,
    (positions, parts): (Ends<'_>, impl Iterator<Item = usize>),
    way: [[f64; 3]; 2],
    mut each: impl FnMut(Event),
) {
    cross_parts(positions, parts, (way[0], way[1]), |crossing| {
        let start = chain.arc_coordinate(crossing.segment);
        let along = start + crossing.parameter * chain.reference_length(crossing.segment);
        let past = way_past(&[crossing.segment, crossing.segment + 1], positions, way);
        let (normal, inward, fraction) = (crossing.normal, crossing.inward, crossing.fraction);
        each(Event { fraction, along, normal, at: way[0], inward, past });
    });
}

/// The place at a fraction of the way from `a` to `b` [L].
pub(super) fn between(a: [f64; 3], b: [f64; 3], fraction: f64) -> [f64; 3] {
    std::array::from_fn(|c| a[c] + fraction * (b[c] - a[c]))
}
