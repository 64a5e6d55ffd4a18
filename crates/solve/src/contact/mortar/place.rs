//! The faces of a pair in a configuration, and their integrals.

use super::super::coverage::{LEAST_AREA, Release};
use super::super::pairs::Contact;
use super::curves::{MasterCurve, curves};
use super::slave::{Control, Mortar};
use slideline_mech::contact::pair::Body;
use slideline_mech::contact::pair::mortar::{
    Bound, Cover, Curve, FacePlaces, Integrals, MOST_CONTROLS, MortarFace, Segment, Shares,
};

/// A slave face in a configuration.
#[derive(Clone, Debug)]
pub struct FaceState {
    /// Its control points and those of its neighbours.
    pub places: FacePlaces<f64>,
    /// The curves near it, by their places in the master.
    pub near: Vec<usize>,
    /// The same where they stand.
    pub curves: Vec<Curve<f64>>,
    /// What of it is covered, by the curves near it.
    pub segments: Vec<Segment>,
    /// Integrals over that.
    pub integrals: Integrals<f64>,
    /// Whether there are any.
    pub is_covered: bool,
    /// Of every node whose shape functions it has; `None`: it carries no contact here.
    pub shares: [Option<Shares>; MOST_CONTROLS],
}

impl Default for FaceState {
    fn default() -> Self {
        Self {
            places: FacePlaces::new(None, &[], None),
            near: Vec::new(),
            curves: Vec::new(),
            segments: Vec::new(),
            integrals: Integrals::default(),
            is_covered: false,
            shares: [None; MOST_CONTROLS],
        }
    }
}

impl FaceState {
    /// The face with its curves.
    pub fn face<'a>(&'a self, mortar: &'a Mortar, face: usize) -> MortarFace<'a, f64> {
        let reference = &mortar.faces[face].reference;
        MortarFace { reference, places: &self.places, curves: &self.curves }
    }
}

/// The faces of the slave surface of a pair in a configuration.
#[derive(Clone, Debug, Default)]
pub struct MortarRoom {
    /// The faces.
    pub faces: Vec<FaceState>,
    /// Curves of the master, and where they stand.
    pub curves: Vec<MasterCurve>,
    placed: Vec<Curve<f64>>,
    nodes: Vec<[f64; 3]>,
    masters: Vec<[f64; 3]>,
    cover: Cover,
    used: Vec<usize>,
    areas: Vec<f64>,
}

/// What a point sums over its faces.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sums {
    /// Area [L2].
    pub area: f64,
    /// Weighted gap [L3].
    pub gap: [f64; 3],
    /// Outward normal [1].
    pub normal: [f64; 3],
}

impl Sums {
    /// Mean gap along the normal, positive when open [L].
    pub fn opening(&self) -> f64 {
        let along = self.normal.iter().zip(self.gap).map(|(n, r)| n * r);
        along.sum::<f64>() / self.area
    }
}

impl Contact {
    /// Places the faces of the mortar of a pair at displacements `u`.
    pub fn place_mortar(&self, mortar: &Mortar, u: &[f64], room: &mut MortarRoom) {
        let master = &self.masters[mortar.pair];
        let body = master.placed_body(u);
        curves(master, &mut room.curves);
        room.nodes.clear();
        let slaves = mortar.positions.iter().enumerate();
        room.nodes.extend(slaves.map(|(k, &at)| mortar.dofs[k].displace(at, u)));
        room.masters.clear();
        room.masters.extend(master.nodes().iter().map(|(at, dofs)| dofs.displace(*at, u)));
        room.placed.clear();
        room.placed.extend(room.curves.iter().map(|curve| {
            let last = curve.count - 1;
            let controls = [0, 1, last].map(|k| curve.controls[k].place(&room.masters, &body));
            Curve::new(&controls[..curve.count], curve.weight)
        }));
        room.faces.resize_with(mortar.faces.len(), FaceState::default);
        for face in 0..mortar.faces.len() {
            room.place_face(mortar, face);
        }
        room.share_out(mortar);
    }
}

impl MortarRoom {
    /// Gives the shape functions of nodes that have next to nothing of a face left to the node that
    /// has most of it.
    fn share_out(&mut self, mortar: &Mortar) {
        self.areas.clear();
        self.areas.resize(mortar.of_point.len(), 0.0);
        for (own, state) in mortar.faces.iter().zip(&self.faces) {
            if state.is_covered {
                let points = own.points[..own.count].iter();
                points
                    .zip(state.integrals.areas)
                    .for_each(|(&point, area)| self.areas[point] += area);
            }
        }
        for (own, state) in mortar.faces.iter().zip(&mut self.faces) {
            state.shares = [None; MOST_CONTROLS];
            if !state.is_covered {
                continue;
            }
            let area = |node: usize| self.areas[own.points[node]];
            let most = (0..own.count).max_by(|&a, &b| area(a).total_cmp(&area(b))).unwrap_or(0);
            let mut given = Shares::of(most);
            for node in (0..own.count).filter(|&node| node != most) {
                if area(node) < LEAST_AREA * area(most) {
                    given.has[node] = true;
                } else {
                    state.shares[node] = Some(Shares::of(node));
                }
            }
            state.shares[most] = Some(given);
        }
    }

    /// What every point is let go by once less and less of it is covered.
    pub fn releases(&self, mortar: &Mortar, into: &mut Vec<Option<Release>>) {
        into.clear();
        into.resize(mortar.of_point.len(), None);
        for (place, own) in mortar.faces.iter().enumerate() {
            let state = &self.faces[place];
            let size = state.face(mortar, place).length();
            let points = (&own.points[..own.count], &own.reference.areas()[..], state.is_covered);
            Release::of_face(points, &self.areas, size, into);
        }
    }

    /// Area, weighted gap and normal of a point.
    pub fn sums(&self, mortar: &Mortar, point: usize) -> Sums {
        let mut sums = Sums::default();
        for &(face, node) in mortar.of_point[point].iter().flatten() {
            let state = &self.faces[face];
            let count = mortar.faces[face].count;
            let [x, y] = state.integrals.normal(node, count);
            sums.normal = [x, y, 0.0];
            if let Some(shares) = state.shares[node] {
                sums.area += state.integrals.area_of(shares);
                let [x, y] = state.integrals.gap_of(shares);
                sums.gap = [sums.gap[0] + x, sums.gap[1] + y, 0.0];
            }
        }
        sums
    }

    /// Where the curves of the master stand.
    pub fn placed(&self) -> &[Curve<f64>] {
        &self.placed
    }

    fn place_face(&mut self, mortar: &Mortar, face: usize) {
        let at = |control: Control| control.place(&self.nodes, &Body::STILL);
        let [before, first, second, third, after] = mortar.controls(face).map(|c| c.map(at));
        let own = [first, second, third].map(Option::unwrap_or_default);
        let state = &mut self.faces[face];
        state.places = FacePlaces::new(before, &own, after);
        state.near.clear();
        state.curves.clear();
        let count = mortar.faces[face].count;
        for (place, curve) in self.placed.iter().enumerate() {
            if may_face(&own[..count], curve) {
                state.near.push(place);
                state.curves.push(*curve);
            }
        }
        let reference = &mortar.faces[face].reference;
        let whole = MortarFace { reference, places: &state.places, curves: &state.curves };
        state.segments.clear();
        let found = self.cover.find(&whole).iter();
        let meets = |own: &&Segment| mortar.meets(face, state.near[own.curve]);
        state.segments.extend(found.filter(meets).copied());
        state.keep_used(&mut self.used);
        let whole = MortarFace { reference, places: &state.places, curves: &state.curves };
        state.is_covered = state.integrals.take(&whole, &state.segments);
    }
}

impl FaceState {
    /// Forgets curves that cover nothing.
    fn keep_used(&mut self, used: &mut Vec<usize>) {
        used.clear();
        let bounding = |bound: &Bound| match *bound {
            Bound::Projected { curve, .. } => Some(curve),
            Bound::End(_) => None,
        };
        for segment in &self.segments {
            used.push(segment.curve);
            used.extend(segment.bounds.iter().filter_map(bounding));
        }
        used.sort_unstable();
        used.dedup();
        for (place, &curve) in used.iter().enumerate() {
            self.near[place] = self.near[curve];
            self.curves[place] = self.curves[curve];
        }
        self.near.truncate(used.len());
        self.curves.truncate(used.len());
        let now = |curve: &mut usize| *curve = used.binary_search(curve).unwrap_or(0);
        for segment in &mut self.segments {
            now(&mut segment.curve);
            for bound in &mut segment.bounds {
                if let Bound::Projected { curve, .. } = bound {
                    now(curve);
                }
            }
        }
    }
}

/// Whether a curve may stand on the normals of a face, which lean by 45 degrees at most.
fn may_face(own: &[[f64; 3]], curve: &Curve<f64>) -> bool {
    let (a, b) = (own[0], own[own.len() - 1]);
    let chord = [b[0] - a[0], b[1] - a[1]];
    let length = chord[0].hypot(chord[1]);
    let (mut low, mut high, mut away) = (f64::INFINITY, f64::NEG_INFINITY, 0.0_f64);
    for [x, y] in &curve.controls[..curve.count] {
        let from = [x - a[0], y - a[1]];
        let along = (from[0] * chord[0] + from[1] * chord[1]) / length;
        (low, high) = (low.min(along), high.max(along));
        away = away.max((from[0] * chord[1] - from[1] * chord[0]).abs() / length);
    }
    low - away <= length && high + away >= 0.0
}
