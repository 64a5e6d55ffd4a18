//! The model before anything moves, and where its motions lead.
//!
//! ```text
//!   slave point x, gap, normal n  -- prescribed motion of both bodies -->
//!   travel of the slave relative to its master, along t and along n
//! ```

use crate::bodies::Bodies;
use crate::moments::Rehearsal;
use crate::motion::in_plane;
use crate::standing_in::{StandingIn, standing_in};
use slideline_model::{
    ContactPair, Dof, Master, MasterFaces, Model, NodeIndex, Prescribed, Presence, ProfilePoint,
    Step, SurfaceSegment,
};
use slideline_solve::observe::ContactRow;

/// A model with what is known of it before it runs.
pub struct Start<'a> {
    /// The model.
    pub model: &'a Model,
    /// Who moves with whom.
    pub bodies: Bodies,
    /// Contact points of every pair; empty where the solver refuses.
    pub points: Vec<ContactRow>,
    /// Diagonal of the box around all nodes [L].
    pub reach: f64,
    /// Every pair walked through the prescribed motions; `None` where these
    /// do not determine it.
    pub rehearsals: Vec<Option<Rehearsal>>,
    /// Bodies of solids that begin in one another.
    pub standing_in: Vec<StandingIn>,
}

impl<'a> Start<'a> {
    /// That of a model.
    pub fn of(model: &'a Model) -> Self {
        let (bodies, reach) = (Bodies::of(model, &Presence::default()), reach(model));
        Self {
            model,
            standing_in: standing_in(model, &bodies, reach),
            bodies,
            points: slideline_solve::initial_contact(model),
            reach,
            rehearsals: Vec::new(),
        }
    }

    /// Largest extent of nodes and rigid surfaces together [L].
    pub fn size(&self) -> f64 {
        let mut points: Vec<[f64; 3]> = self.model.nodes.iter().map(|node| node.position).collect();
        for pair in &self.model.contact_pairs {
            for surface in pair.rigid_surfaces() {
                points.push(raised(surface.start));
                points.extend(surface.segments.iter().map(|segment| raised(segment.end())));
            }
        }
        extent(points.into_iter())
    }

    /// Points of a pair that face their master.
    pub fn facing(&self, pair: usize) -> impl Iterator<Item = &ContactRow> {
        self.points.iter().filter(move |row| row.pair == pair && row.opening.is_finite())
    }

    /// Whether a contact pair has these two bodies on its sides.
    pub fn brings(&self, pair: &ContactPair, bodies: [NodeIndex; 2]) -> bool {
        let of_body = |body: NodeIndex| move |node: NodeIndex| self.bodies.of_node(node) == body;
        let is_slave = |body| pair.slave_places().any(of_body(body));
        let is_master = |body| pair.master.deforming_nodes().into_iter().any(of_body(body));
        let [one, other] = bodies;
        is_slave(one) && is_master(other) || is_slave(other) && is_master(one)
    }

    /// The point of a pair with the smallest gap.
    pub fn nearest(&self, pair: usize) -> Option<&ContactRow> {
        self.facing(pair).min_by(|a, b| a.opening.total_cmp(&b.opening))
    }

    /// Motion of `point` with the body of `node` at the end of a step,
    /// counted from the end of the step before [L]. `None`: nothing moves it.
    fn carried(
        &self,
        step: &Step,
        before: Option<&Step>,
        node: NodeIndex,
        point: [f64; 3],
    ) -> [f64; 3] {
        let end = self.place(step, node, point);
        let begin = before.map_or([0.0; 3], |step| self.place(step, node, point));
        less(end, begin)
    }

    /// Displacement of `point` if it goes rigidly with the prescribed nodes
    /// of the body of `node`; zero where the body is held or free.
    fn place(&self, step: &Step, node: NodeIndex, point: [f64; 3]) -> [f64; 3] {
        let body = self.bodies.of_node(node);
        let own = |p: &&Prescribed| self.bodies.of_node(p.node) == body && p.moves();
        let Some(driver) = step.prescribed.iter().find(own).map(|p| p.node) else {
            return [0.0; 3];
        };
        let value = |dof: Dof| {
            let given = step.prescribed.iter().find(|p| p.node == driver && p.dof == dof);
            given.map_or(0.0, |p| self.largest(p))
        };
        let at = self.model.nodes.position(driver);
        let (sin, cos) = value(Dof::UR3).sin_cos();
        let arm = [point[0] - at[0], point[1] - at[1]];
        let [x, y, _] = in_plane(self.model, driver, (value(Dof::U1), value(Dof::U2)));
        [x + (cos - 1.0) * arm[0] - sin * arm[1], y + sin * arm[0] + (cos - 1.0) * arm[1], 0.0]
    }

    /// The value of largest magnitude that a prescribed motion takes.
    pub fn largest(&self, prescribed: &Prescribed) -> f64 {
        let factors = prescribed.amplitude.and_then(|place| self.model.amplitudes.get(place));
        prescribed.value * factors.map_or(1.0, slideline_model::Amplitude::largest)
    }

    /// Rotation of the body of `node` in a step [1].
    pub fn rotation(&self, place: usize, node: NodeIndex) -> f64 {
        let body = self.bodies.of_node(node);
        let of = |step: &Step| {
            let own = step
                .prescribed
                .iter()
                .filter(|p| p.dof == Dof::UR3 && self.bodies.of_node(p.node) == body);
            own.map(|p| self.largest(p))
                .fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a })
        };
        let steps = &self.model.steps;
        of(&steps[place]) - place.checked_sub(1).map_or(0.0, |before| of(&steps[before]))
    }

    /// Travel of a slave point relative to its master in a step [L]; for
    /// slaves that stand on an arc it is that of the arc's centre.
    pub fn travel(&self, place: usize, pair: &ContactPair, row: &ContactRow) -> [f64; 3] {
        let steps = &self.model.steps;
        let (step, before) = (&steps[place], place.checked_sub(1).map(|k| &steps[k]));
        let master = match &pair.master {
            Master::RigidSurface(surface) => surface.reference,
            Master::SlideLine(line) => line.nodes.first().copied().unwrap_or(row.node),
            // its other parts go with it
            Master::Itself(_) | Master::Faces(MasterFaces { meets_itself: true, .. }) => row.node,
            Master::Faces(faces) => faces.first_node().unwrap_or(row.node),
        };
        let centre = arc_of(self.model, pair, row.node).map_or(row.position, |(centre, _)| centre);
        let slave = self.carried(step, before, row.node, centre);
        let centre = circle_of(pair).map_or(row.position, |(centre, _)| centre);
        let master = self.carried(step, before, master, centre);
        less(slave, master)
    }
}

/// Centre and radius of the tightest convex circle of a pair's rigid surface.
pub fn circle_of(pair: &ContactPair) -> Option<([f64; 3], f64)> {
    let Master::RigidSurface(surface) = &pair.master else { return None };
    let mut from = surface.start;
    let mut tightest: Option<([f64; 3], f64)> = None;
    for segment in &surface.segments {
        let end = match *segment {
            SurfaceSegment::Line { end } | SurfaceSegment::Parabola { end, .. } => end,
            SurfaceSegment::Circle { end, centre } => {
                let centre = raised(centre);
                let (a, b) = (less(raised(from), centre), less(raised(end), centre));
                let radius = length(a);
                let clockwise = a[0] * b[1] - a[1] * b[0] < 0.0;
                if clockwise && tightest.is_none_or(|(_, least)| radius < least) {
                    tightest = Some((centre, radius));
                }
                end
            }
        };
        from = end;
    }
    tightest
}

/// Centre and radius of the arc on which a slave and its neighbours stand;
/// `None` at the ends of the slaves and on straight rows.
pub fn arc_of(model: &Model, pair: &ContactPair, node: NodeIndex) -> Option<([f64; 3], f64)> {
    let other = |nodes: [NodeIndex; 2]| if nodes[0] == node { nodes[1] } else { nodes[0] };
    let mut beside =
        pair.elements.iter().filter(|e| e.nodes.contains(&node)).map(|e| other(e.nodes));
    let (before, after) = (beside.next()?, beside.next()?);
    let here = model.nodes.position(node);
    let (a, b) =
        (less(model.nodes.position(before), here), less(model.nodes.position(after), here));
    let area = 2.0 * (a[0] * b[1] - a[1] * b[0]);
    let (aa, bb) = (a[0] * a[0] + a[1] * a[1], b[0] * b[0] + b[1] * b[1]);
    if area.abs() < 1e-6 * (aa + bb) {
        return None;
    }
    let centre = [(b[1] * aa - a[1] * bb) / area, (a[0] * bb - b[0] * aa) / area];
    let radius = centre[0].hypot(centre[1]);
    Some(([here[0] + centre[0], here[1] + centre[1], here[2]], radius))
}

/// Average length of a pair's contact elements, or of the edges of its faces [L].
pub fn spacing(model: &Model, pair: &ContactPair) -> f64 {
    let edges = pair.faces.iter().flat_map(|face| {
        let corners = face.cell().map_or(0, |cell| cell.faces.len());
        (0..corners).map(move |k| [face.nodes[k], face.nodes[(k + 1) % corners]])
    });
    let all = pair.elements.iter().map(|element| element.nodes).chain(edges);
    let lengths = all.map(|[a, b]| length(less(model.nodes.position(b), model.nodes.position(a))));
    let (sum, count) = lengths.fold((0.0, 0_usize), |(sum, count), own| (sum + own, count + 1));
    sum / count.max(1) as f64
}

/// a - b.
pub fn less(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

/// A point of a profile in the plane, as a place in space.
fn raised([x, y]: ProfilePoint) -> [f64; 3] {
    [x, y, 0.0]
}

/// Length of a vector.
pub fn length(a: [f64; 3]) -> f64 {
    a[0].hypot(a[1]).hypot(a[2])
}

fn reach(model: &Model) -> f64 {
    extent(model.nodes.iter().map(|node| node.position))
}

/// Diagonal of the box around points [L].
fn extent(points: impl Iterator<Item = [f64; 3]>) -> f64 {
    let mut low = [f64::INFINITY; 3];
    let mut high = [f64::NEG_INFINITY; 3];
    for point in points {
        for axis in 0..3 {
            low[axis] = low[axis].min(point[axis]);
            high[axis] = high[axis].max(point[axis]);
        }
    }
    let extent = length(less(high, low));
    if extent.is_finite() { extent } else { 0.0 }
}
