//! The prescribed motions gone through without solving: where contact
//! would be in every increment, were the flexible parts not to deflect.
//!
//! ```text
//!   step, increment --> motions of both bodies --> gaps of all slaves
//!                                              --> the slave that carries
//! ```

use crate::moments::{Carrier, Moment, Rehearsal};
use crate::motion::motion;
use crate::start::{Start, length, less};
use slideline_mech::contact::gap::Linear;
use slideline_mech::contact::gap::offset::Offset;
use slideline_mech::contact::pair::{Body, RigidSurface, chain_overclosure};
use slideline_mech::contact::search::chain::{Chain, flat};
use slideline_mech::contact::search::nearest::Nearby;
use slideline_mech::contact::search::rigid::{RigidSegment, beyond_end};
use slideline_model::{ContactPair, Formulation, Master, NodeIndex, Step};
use slideline_solve::observe::ContactRow;

/// Increments of a step that are gone through at most.
const MOST: usize = 400;
/// Part of the size of a slave by which one node is deeper than another for more than rounding [1].
const ALIKE: f64 = 1e-9;
/// Gaps that are computed at most.
const EFFORT: usize = 4_000_000;

/// A master, ready to be asked.
enum MasterSurface {
    Body(RigidSurface, NodeIndex),
    Line(Chain, Vec<NodeIndex>),
}

/// Where a slave stands against its master.
enum Position {
    Facing {
        overclosure: f64,
        along: f64,
        trusted: bool,
    },
    /// Beyond an end by so much; whether that is the start.
    Off(f64, bool),
    Nothing,
}

/// Rehearses every pair, gaps that the solver left out filled before.
pub fn rehearse(start: &mut Start<'_>) {
    fill_places(start);
    let pairs = start.model.contact_pairs.iter();
    start.rehearsals = pairs.map(|pair| rehearsed(start, pair)).collect();
}

/// Walks a pair through all steps; `None` where its motions are not
/// prescribed in full.
fn rehearsed(start: &Start<'_>, pair: &ContactPair) -> Option<Rehearsal> {
    let slaves = pair.slave_nodes();
    let master_surface = master_surface(start, pair)?;
    let pieces = match &master_surface {
        MasterSurface::Body(surface, _) => surface.segments().len(),
        MasterSurface::Line(_, nodes) => nodes.len(),
    };
    let most = (EFFORT / (slaves.len() * pieces * start.model.steps.len()).max(1)).min(MOST);
    let places = arc_places(start, pair, &slaves);
    // a slave that fits its master is as deep everywhere, but for rounding: the first one stands for all
    let at = |node: &NodeIndex| start.model.nodes.position(*node);
    let far = |node: &NodeIndex| length(less(at(node), at(&slaves[0])));
    let alike = ALIKE * slaves.iter().map(far).fold(0.0, f64::max);
    let mut rehearsal = Rehearsal::default();
    let mut carried: Vec<bool> = vec![false; slaves.len()];
    for (number, step) in start.model.steps.iter().enumerate() {
        let count = increments(step).min(most.max(2));
        let before = usize::from(number > 0);
        for k in before..=count {
            let time = (number, k as f64 / count as f64);
            let moment = moment_at(
                start,
                pair,
                (&master_surface, &slaves, &places, alike),
                time,
                &mut carried,
            )?;
            rehearsal.moments.push(moment);
        }
    }
    Some(rehearsal)
}

/// Increments of a step, were all as long as the first one.
pub fn increments(step: &Step) -> usize {
    let procedure = &step.procedure;
    let each = (procedure.initial.min(procedure.maximum) / procedure.period).clamp(1e-6, 1.0);
    (1.0 / each - 1e-6).ceil().max(1.0) as usize
}

/// Where rows of contact that is no contact of nodes stand before anything moves, which the solver does not say: gaps of
/// integrated contact that it has left out because they are far from closing, and places along masters of contact over
/// faces, whose rows have the slip there.
fn fill_places(start: &mut Start<'_>) {
    let mut filled = std::mem::take(&mut start.points);
    for (place, pair) in start.model.contact_pairs.iter().enumerate() {
        if pair.formulation == Formulation::NodeToSurface {
            continue;
        }
        let Some(master) = master_surface(start, pair) else { continue };
        let nodes = pair.master.deforming_nodes();
        let at: Vec<[f64; 3]> = nodes.iter().map(|&n| start.model.nodes.position(n)).collect();
        for row in filled.iter_mut().filter(|row| row.pair == place) {
            match &master {
                MasterSurface::Line(line, _) if pair.formulation == Formulation::Mortar => {
                    let piece = line.closest(&at, Nearby::Positions, row.position);
                    let gap =
                        piece.and_then(|own| chain_overclosure(line, &own, &at, row.position));
                    row.along = gap.map_or(row.along, |[_, along]| along);
                }
                MasterSurface::Body(surface, _)
                    if pair.formulation == Formulation::SurfaceToSurface
                        && row.opening.is_infinite() =>
                {
                    fill_gap(surface, (start.model.nodes.position(row.node), pair.offset), row);
                }
                _ => {}
            }
        }
    }
    start.points = filled;
}

/// The gap of a slave node, off its line by that much, to a surface that stands still.
fn fill_gap(surface: &RigidSurface, (point, offset): ([f64; 3], Offset), row: &mut ContactRow) {
    let still = Body::STILL;
    let facing = surface.closest(&still, point);
    let at = (point, offset);
    if let Some(gap) = facing.and_then(|facing| surface.gap::<Linear>(&still, &facing, at)) {
        row.opening = -gap.overclosure();
        row.normal = gap.normal();
        row.along = gap.along()[0];
        row.position = point;
    }
}

fn master_surface(start: &Start<'_>, pair: &ContactPair) -> Option<MasterSurface> {
    match &pair.master {
        // parts of solids bend: nothing is led along
        Master::Faces(_) | Master::Itself(_) => None,
        Master::RigidSurface(surface) => {
            Some(MasterSurface::Body(slideline_solve::rigid_surface(surface)?, surface.reference))
        }
        Master::SlideLine(line) => {
            let at: Vec<_> = line.nodes.iter().map(|&n| start.model.nodes.position(n)).collect();
            let mut chain = Chain::new(&at, line.smooth, line.extension)?;
            chain.is_ring = line.is_ring();
            Some(MasterSurface::Line(chain, line.nodes.clone()))
        }
    }
}

/// Arc coordinates of the slaves along their elements.
fn arc_places(start: &Start<'_>, pair: &ContactPair, slaves: &[NodeIndex]) -> Vec<f64> {
    let mut places = vec![0.0; slaves.len()];
    let place = |node| slaves.iter().position(|&own| own == node);
    for element in &pair.elements {
        let [a, b] = element.nodes.map(|node| start.model.nodes.position(node));
        if let (Some(from), Some(to)) = (place(element.nodes[0]), place(element.nodes[1])) {
            places[to] = places[from] + length(less(b, a));
        }
    }
    places
}

fn moment_at(
    start: &Start<'_>,
    pair: &ContactPair,
    (master_surface, slaves, places, alike): (&MasterSurface, &[NodeIndex], &[f64], f64),
    time: (usize, f64),
    carried: &mut [bool],
) -> Option<Moment> {
    let moved = |node| motion(start.model, &start.bodies, time, node);
    let first = *slaves.first()?;
    let one_body = slaves.iter().all(|&s| start.bodies.of_node(s) == start.bodies.of_node(first));
    let common = moved(first)?;
    let place = |node: NodeIndex, body: &Body| body.to_space(start.model.nodes.position(node));
    let chain: Vec<[f64; 3]> = match master_surface {
        MasterSurface::Body(..) => Vec::new(),
        MasterSurface::Line(_, nodes) => {
            let mut last = None; // neighbours belong to one body, mostly
            let at = |&node: &NodeIndex| {
                let own = start.bodies.of_node(node);
                let body = match last {
                    Some((of, body)) if of == own => body,
                    _ => moved(node)?,
                };
                last = Some((own, body));
                Some(place(node, &body))
            };
            nodes.iter().map(at).collect::<Option<_>>()?
        }
    };
    let master = match master_surface {
        MasterSurface::Body(_, reference) => moved(*reference)?,
        MasterSurface::Line(..) => common,
    };
    let reach = -pair.interaction.normal.contact_begins();
    let mut moment = Moment { step: time.0, carrier: None, off: None, range: None };
    let (mut deepest, mut sound) = (f64::NEG_INFINITY, false);
    let mut now = vec![false; slaves.len()];
    let mut off: Option<(f64, bool)> = None;
    for (k, &slave) in slaves.iter().enumerate() {
        let body = if one_body { common } else { moved(slave)? };
        match position(master_surface, &chain, &master, place(slave, &body)) {
            Position::Facing { overclosure, along, trusted } => {
                let overclosure = overclosure + pair.offset.both();
                let (low, high) = moment.range.unwrap_or((overclosure, overclosure));
                moment.range = Some((low.min(overclosure), high.max(overclosure)));
                if overclosure > -reach - alike {
                    now[k] = trusted;
                    if overclosure > deepest + alike {
                        (deepest, sound) = (overclosure, trusted);
                        moment.carrier = Some(Carrier { node: slave, slave: places[k], along });
                    }
                }
            }
            Position::Off(beyond, at_start) if carried[k] => {
                off = off.filter(|&(most, _)| most >= beyond).or(Some((beyond, at_start)));
            }
            Position::Off(..) | Position::Nothing => {}
        }
    }
    if moment.carrier.is_none() {
        moment.off = off;
    }
    // too deep in a round body to say where the real, bent part would be
    now.iter_mut().for_each(|carries| *carries &= sound);
    carried.copy_from_slice(&now);
    Some(moment)
}

fn position(
    master_surface: &MasterSurface,
    chain: &[[f64; 3]],
    master: &Body,
    point: [f64; 3],
) -> Position {
    match master_surface {
        MasterSurface::Body(surface, _) => {
            let at = master.to_body(point);
            let still = Body { reference: master.reference, dofs: [0.0; 3] };
            let facing = surface.closest(&still, at);
            let line = (at, Offset::NONE);
            if let Some((facing, gap)) = facing
                .and_then(|facing| Some((facing, surface.gap::<Linear>(&still, &facing, line)?)))
            {
                let overclosure = gap.overclosure();
                let radius = match surface.segments().get(facing.segment) {
                    Some(RigidSegment::Arc { radius, .. }) => *radius,
                    _ => f64::INFINITY,
                };
                let trusted = overclosure < 0.5 * radius;
                return Position::Facing { overclosure, along: gap.along()[0], trusted };
            }
            let size = surface.segments().iter().map(RigidSegment::length).fold(0.0, f64::max);
            match beyond_end(surface.segments(), flat(at)) {
                Some(end) if end.depth > 0.0 && end.depth < 0.5 * size => {
                    Position::Off(end.beyond, end.at_start)
                }
                _ => Position::Nothing,
            }
        }
        MasterSurface::Line(line, _) => {
            let piece = line.closest(chain, Nearby::Positions, point);
            let gap = piece.and_then(|piece| chain_overclosure(line, &piece, chain, point));
            if let Some([overclosure, along]) = gap {
                return Position::Facing { overclosure, along, trusted: true };
            }
            match line.beyond_end(chain, point) {
                Some(overclosure) if overclosure > 0.0 => {
                    let (beyond, at_start) = beyond_chain(chain, point);
                    Position::Off(beyond, at_start)
                }
                _ => Position::Nothing,
            }
        }
    }
}

/// How far a point lies beyond the nearer end of a chain, along it [L], and
/// whether that is its start.
fn beyond_chain(chain: &[[f64; 3]], point: [f64; 3]) -> (f64, bool) {
    let over = |end: [f64; 3], next: [f64; 3]| {
        let out = less(end, next);
        let d = less(point, end);
        (d[0] * out[0] + d[1] * out[1] + d[2] * out[2]) / length(out)
    };
    match chain {
        [first, second, ..] => {
            let end = over(chain[chain.len() - 1], chain[chain.len() - 2]);
            let start = over(*first, *second);
            (start.max(end), start > end)
        }
        _ => (0.0, false),
    }
}
