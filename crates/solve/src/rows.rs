//! Contact points as output wants to see them: a row a slave node, and one each sharp edge that is held.
//!
//! ```text
//!   node contact:        a row is a point
//!   integrated contact:  a row gathers the integration_points beside a node,
//!                        weighted by its linear shape function
//! ```

use crate::contact::{
    Contact, ContactKinematics, PointRows, SEGMENT_POINTS, SlavePoint, SlaveSegment,
};
use crate::dofs::DofMap;
use crate::observe::results::{ContactRow, FrictionCall, Status};
use crate::state::{PointState, State};
use slideline_model::{Formulation, Model, NodeIndex};

/// Fills the rows of a committed state, pair by pair, with what its contact points push, if they were evaluated; sums of nodes are
/// scratch.
pub fn contact_rows(
    numbered: Numbered<'_>,
    contact: &Contact,
    (state, pushing): (&State, Option<&ContactKinematics>),
    (rows, gathered): (&mut Vec<ContactRow>, &mut Vec<Gathered>),
) {
    rows.clear();
    rows.reserve(contact.points.len());
    for (place, pair) in numbered.0.contact_pairs.iter().enumerate() {
        match pair.formulation {
            Formulation::NodeToSurface | Formulation::Mortar => {
                node_rows((numbered.1, contact), (state, pushing), place, rows)
            }
            Formulation::SurfaceToSurface => {
                gather_rows(numbered, contact, (state, place), gathered);
                rows.extend(gathered.drain(..).map(Gathered::finish));
            }
        }
    }
    edge_rows(contact, state, rows);
}

/// Adds the rows of sharp edges that are or were held, as what they do to the slaves: normal and directions are turned where
/// the edge is of the master.
fn edge_rows(contact: &Contact, state: &State, rows: &mut Vec<ContactRow>) {
    for place in contact.places_of_edges().filter(|&place| state.points[place].ever_closed) {
        let point = &contact.points[place];
        let sign = if contact.is_reversed(point.pair) { -1.0 } else { 1.0 };
        let row = row_of(point, &state.points[place], contact.parent(point.pair));
        let normal = row.normal.map(|own| sign * own);
        let directions = row.directions.map(|way| way.map(|own| sign * own));
        let node = contact.node_of(place, &state.points[place]);
        rows.push(ContactRow { node, normal, directions, ..row });
    }
}

/// A model with its dofs.
type Numbered<'a> = (&'a Model, &'a DofMap);

fn node_rows(
    (dofs, contact): (&DofMap, &Contact),
    (state, pushing): (&State, Option<&ContactKinematics>),
    pair: usize,
    rows: &mut Vec<ContactRow>,
) {
    let points = contact.points.iter().zip(&state.points).enumerate();
    let own = points.filter(|(_, (point, _))| point.pair == pair);
    rows.extend(own.map(|(place, (point, state))| {
        let row = row_of(point, state, pair);
        let pushing = pushing.filter(|_| state.closed && point.is_spread());
        match pushing.map(|all| pushed((dofs, contact), pair, all.at(place))) {
            Some(normal) => ContactRow { normal, ..row },
            None => row,
        }
    }));
}

/// Force on the slave of a point that is spread over faces, of a normal force of one: along the master, not along the normal of the
/// slave, and of length one where the covered area stands still. docs/theory.md eqs. (5.26), (5.36)
fn pushed((dofs, contact): (&DofMap, &Contact), pair: usize, point: PointRows<'_>) -> [f64; 3] {
    let mut force = [0.0; 3];
    let rows = point.rows;
    for (&own, by) in rows.unknowns.iter().zip(rows.normal()) {
        let (node, dof) = dofs.name(own);
        if !dof.is_rotation() && contact.is_spread_slave(pair, node) == Some(true) {
            // rows are by overclosure, which falls along the force
            force[dof as usize % 3] -= by;
        }
    }
    force
}

/// Its area is the one that its pressure acts on: of faces that are covered in part, that part.
fn row_of(point: &SlavePoint, state: &PointState, pair: usize) -> ContactRow {
    ContactRow {
        pair,
        node: point.node,
        status: state.status,
        ever_closed: state.ever_closed,
        opening: state.opening,
        pressure: state.pressure,
        shear: state.traction,
        slip: state.slip,
        directions: state.directions(),
        area: if state.area > 0.0 { state.area } else { point.area },
        friction: state.friction,
        position: state.position,
        normal: state.normal,
        along: state.along.unwrap_or_default()[0],
        dropped_work: state.dropped_work,
    }
}

/// Sums of a slave node of integrated contact.
#[derive(Clone, Copy, Default)]
pub struct Gathered {
    row: ContactRow,
    /// Normal force, for the weights of slip and place [F].
    force: f64,
}

fn gather_rows(
    numbered: Numbered<'_>,
    contact: &Contact,
    (state, pair): (&State, usize),
    gathered: &mut Vec<Gathered>,
) {
    let nodes = &contact.slave_nodes[pair];
    gathered.clear();
    gathered.resize(nodes.len(), Gathered::default());
    for (sum, &node) in gathered.iter_mut().zip(nodes) {
        sum.row.pair = pair;
        sum.row.node = node;
        sum.row.opening = f64::INFINITY;
        sum.row.position = current(numbered, state, node);
    }
    for segment in contact.segments.iter().filter(|segment| segment.pair == pair) {
        gather(contact, state, segment, gathered);
    }
}

fn gather(contact: &Contact, state: &State, segment: &SlaveSegment, gathered: &mut [Gathered]) {
    for k in segment.first..segment.first + SEGMENT_POINTS {
        let (integration_point, whole) = (&state.points[k], contact.points[k].area);
        if let Some(place) = segment.place_on_profile(integration_point.xi, &state.displacement) {
            gathered[segment.rows[0]].stand(integration_point, place);
        }
        for (row, share) in
            segment.rows.into_iter().zip([1.0 - integration_point.xi, integration_point.xi])
        {
            gathered[row].add(integration_point, whole, share);
        }
    }
}

impl Gathered {
    /// The row of a profile stands where that is deepest or nearest.
    fn stand(&mut self, integration_point: &PointState, place: [f64; 3]) {
        let opening = integration_point.opening;
        if opening.is_finite() && opening < self.row.opening {
            self.row.position = place;
        }
    }

    fn add(&mut self, integration_point: &PointState, whole: f64, share: f64) {
        let row = &mut self.row;
        let force = share * integration_point.area * integration_point.pressure;
        row.area += share * whole;
        row.pressure += force;
        row.shear += share * integration_point.area * integration_point.traction;
        row.slip += force * integration_point.slip;
        row.dropped_work += share * integration_point.dropped_work;
        row.ever_closed |= integration_point.ever_closed;
        self.force += force;
        if integration_point.opening.is_finite() && integration_point.opening < row.opening {
            row.opening = integration_point.opening;
            row.normal = integration_point.normal;
            row.directions = integration_point.directions();
            row.along = integration_point.along.unwrap_or_default()[0];
        }
        if integration_point.closed && share > 0.0 {
            if row.status != Status::Slip {
                row.status = integration_point.status;
            }
            if row.friction != FrictionCall::Dropped
                && integration_point.friction != FrictionCall::None
            {
                row.friction = integration_point.friction;
            }
        }
    }

    fn finish(mut self) -> ContactRow {
        if self.row.area > 0.0 {
            self.row.pressure /= self.row.area;
            self.row.shear = self.row.shear / self.row.area;
        }
        if self.force != 0.0 {
            self.row.slip = self.row.slip / self.force;
        }
        self.row
    }
}

fn current((model, dofs): Numbered<'_>, state: &State, node: NodeIndex) -> [f64; 3] {
    let from = model.nodes.get(node).position;
    let moved = dofs.translation(&state.displacement, node);
    std::array::from_fn(|axis| from[axis] + moved[axis])
}
