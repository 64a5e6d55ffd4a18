//! The mortar of faces in space against differences, balance, invariance and closed forms.

use super::clip::Overlap;
use super::couple::Couple;
use super::cover::{Cover, Faced, Looking};
use super::ends::{Ends, FaceEnds};
use super::face_places::FacePlaces;
use super::places::{Place, add_scaled, cross, dot, sub};
use super::pull::{Carried, Load};
use super::shapes::{MOST_CORNERS, MOST_NODES, corners, place_of};
use super::station::reference_areas;
use super::sums::Sums;
use super::sweep::{SweepRoom, Swept};

mod aligned;
mod cover;

/// Numbers between -1 and 1 that look random.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// A slave face and a face of the master above it.
#[derive(Clone)]
struct Case {
    slave: FacePlaces<f64>,
    master: FacePlaces<f64>,
    measure: [f64; MOST_NODES],
    ends: Ends,
}

/// A face over the unit square or a half of it, moved by `at` and shaken; `down`: it looks down.
fn face(
    nodes: usize,
    at: Place<f64>,
    shake: f64,
    down: bool,
    random: &mut Random,
) -> FacePlaces<f64> {
    let place = |node: usize| {
        let [x, y] = place_of(nodes, node);
        let [x, y] = if down { [y, x] } else { [x, y] };
        [x + at[0], y + at[1], at[2]]
    };
    let mut all: Vec<Place<f64>> = (0..nodes).map(place).collect();
    all.as_flattened_mut().iter_mut().for_each(|x| *x += shake * random.next());
    FacePlaces::new(&all)
}

fn looking<'a>(places: &'a FacePlaces<f64>, ends: &'a FaceEnds) -> Looking<'a> {
    Looking { places, ends, thickness: f64::INFINITY }
}

/// A face that ends at all its edges.
const ALL_ENDS: FaceEnds = FaceEnds { edges: [true; MOST_CORNERS], nodes: [true; MOST_NODES] };

impl Case {
    fn new(nodes: [usize; 2], shake: f64, random: &mut Random) -> Self {
        let slave = face(nodes[0], [0.0; 3], shake, false, random);
        let master = face(nodes[1], [0.31, 0.17, 0.2], shake, true, random);
        // a master of one face ends at its edges; where the slave ends is another case
        let ends = Ends { master: ALL_ENDS, ..Ends::default() };
        Self { slave, master, measure: reference_areas(&slave), ends }
    }

    fn overlaps(&self) -> Vec<Overlap> {
        let mut overlaps = Vec::new();
        let masters = [Faced {
            face: 0,
            nodes: [0; MOST_NODES],
            places: self.master,
            ends: self.ends.master,
            thickness: f64::INFINITY,
        }];
        Cover::default().find(looking(&self.slave, &self.ends.slave), &masters, &mut overlaps);
        assert!(!overlaps.is_empty());
        overlaps
    }

    fn couple(&self) -> Couple<'_, f64> {
        Couple { slave: &self.slave, measure: &self.measure, master: &self.master, ends: self.ends }
    }

    fn sums(&self, overlaps: &[Overlap]) -> Sums {
        let mut sums = Sums::default();
        overlaps.iter().for_each(|own| sums.add(&self.couple().sums(own).unwrap().0));
        sums
    }

    fn count(&self) -> usize {
        self.slave.count + self.master.count
    }

    fn moved(&self, node: usize, axis: usize, by: f64) -> Self {
        let mut moved = self.clone();
        match node.checked_sub(self.slave.count) {
            None => moved.slave.nodes[node][axis] += by,
            Some(node) => moved.master.nodes[node][axis] += by,
        }
        moved
    }

    fn pulled(&self, overlaps: &[Overlap], load: &Load<f64>) -> Vec<Place<f64>> {
        let mut into = vec![[0.0; 3]; self.count()];
        overlaps.iter().for_each(|own| assert!(self.couple().pull(own, &[*load], [&mut into])));
        into
    }

    fn psi(&self, overlaps: &[Overlap], load: &Load<f64>) -> f64 {
        let sums = self.sums(overlaps);
        (0..MOST_CORNERS).map(|k| load.gap[k] * sums.gaps[k] + load.area[k] * sums.areas[k]).sum()
    }

    fn places(&self) -> Vec<Place<f64>> {
        let own = self.slave.nodes[..self.slave.count].iter();
        own.chain(&self.master.nodes[..self.master.count]).copied().collect()
    }
}

fn load(random: &mut Random, drags: f64) -> Load<f64> {
    let mut number = || random.next();
    let mut four = || std::array::from_fn(|_| number());
    let (gap, area) = (four(), four());
    let drag = std::array::from_fn(|_| std::array::from_fn(|_| drags * random.next()));
    Load { gap, area, drag }
}

fn cases() -> Vec<Case> {
    let mut random = Random(7);
    let kinds = [3, 4, 6, 8];
    let pairs = kinds.into_iter().flat_map(|a| kinds.map(|b| [a, b]));
    let mut all: Vec<Case> = pairs.map(|nodes| Case::new(nodes, 0.08, &mut random)).collect();
    all.extend([3, 4].map(|nodes| Case::new([nodes; 2], 0.2, &mut random)));
    // faces that end almost together, within the width in which bounds go over
    all.extend(kinds.into_iter().flat_map(|a| kinds.map(|b| [a, b])).map(|nodes| {
        let slave = face(nodes[0], [0.0; 3], 0.001, false, &mut random);
        let master = face(nodes[1], [-0.05, -0.04, 0.2], 0.004, true, &mut random);
        let ends = Ends { slave: ALL_ENDS, master: ALL_ENDS };
        Case { slave, master, measure: reference_areas(&slave), ends }
    }));
    all
}

/// What differences are known to, in parts of the largest: beside ends, functions change within a
/// hundredth of a face; edges between pieces of a face bound nothing, in the integrals to the error of the rule.
fn bound(case: &Case, usual: f64) -> f64 {
    match (case.ends.slave == FaceEnds::default(), case.master.count) {
        (_, 6..) => usual.max(PIECES),
        (true, _) => usual,
        (false, _) => 20.0 * usual,
    }
}

/// The error of the rule where pieces of a face meet [1].
const PIECES: f64 = 1e-4;

/// Requirement: gradients written by hand are those of the integrals, for all kinds of faces, bent and
/// covered in part. Tolerance: that of central differences.
#[test]
fn gradients_are_those_of_the_integrals() {
    let mut random = Random(3);
    for case in cases() {
        let (overlaps, load) = (case.overlaps(), load(&mut random, 0.0));
        let pulled = case.pulled(&overlaps, &load);
        let size = pulled.as_flattened().iter().fold(0.0, |most: f64, own| most.max(own.abs()));
        for (node, pulled) in pulled.iter().enumerate() {
            for axis in 0..3 {
                let psi = |by: f64| case.moved(node, axis, by).psi(&overlaps, &load);
                let step = 1e-5;
                let slope = (psi(step) - psi(-step)) / (2.0 * step);
                let off = (slope - pulled[axis]).abs();
                let kinds = (case.slave.count, case.master.count);
                assert!(
                    off < bound(&case, 1e-7) * size,
                    "{kinds:?} {node} {axis}: {slope} {pulled:?}"
                );
            }
        }
    }
}

/// Requirement: the swept derivative is that of the force, drags included, and symmetric without them.
#[test]
fn swept_derivatives_are_those_of_the_force() {
    let mut random = Random(5);
    for case in cases() {
        for drags in [0.0, 1.0] {
            let (overlaps, load) = (case.overlaps(), load(&mut random, drags));
            let (mut room, mut swept) = (SweepRoom::default(), Swept::default());
            let wide = 3 * case.count();
            let mut whole = vec![0.0; wide * wide];
            let mut force = vec![[0.0; 3]; case.count()];
            for own in &overlaps {
                assert!(room.sweep(&case.couple(), own, &load, &mut swept));
                whole.iter_mut().zip(&swept.derivative).for_each(|(sum, own)| *sum += own);
                force.iter_mut().zip(&swept.force).for_each(|(a, b)| *a = add_scaled(*a, 1.0, *b));
            }
            let direct = case.pulled(&overlaps, &load);
            for (a, b) in force.as_flattened().iter().zip(direct.as_flattened()) {
                assert!((a - b).abs() < 1e-12);
            }
            let size = whole.iter().fold(0.0, |most: f64, own| most.max(own.abs()));
            for column in 0..wide {
                let (node, axis) = (column / 3, column % 3);
                let step = 1e-5;
                let at = |by: f64| case.moved(node, axis, by).pulled(&overlaps, &load);
                let (up, down) = (at(step), at(-step));
                for row in 0..wide {
                    let slope = (up[row / 3][row % 3] - down[row / 3][row % 3]) / (2.0 * step);
                    let own = whole[row * wide + column];
                    assert!(
                        (slope - own).abs() < bound(&case, 1e-6) * size,
                        "{row} {column} {slope} {own}"
                    );
                    let other = whole[column * wide + row];
                    assert!(drags > 0.0 || (own - other).abs() < bound(&case, 1e-11) * size);
                }
            }
        }
    }
}

/// Requirement: forces of gaps, areas and drags balance in force and moment, at any gap.
#[test]
fn forces_balance() {
    let mut random = Random(11);
    for case in cases() {
        let (overlaps, load) = (case.overlaps(), load(&mut random, 1.0));
        let forces = case.pulled(&overlaps, &load);
        let (mut sum, mut moment) = ([0.0; 3], [0.0; 3]);
        for (place, force) in case.places().into_iter().zip(forces) {
            sum = add_scaled(sum, 1.0, force);
            moment = add_scaled(moment, 1.0, cross(place, force));
        }
        assert!(dot(sum, sum).sqrt() < 1e-12, "{sum:?}");
        assert!(dot(moment, moment).sqrt() < 1e-12, "{moment:?}");
    }
}

/// Requirement: the derivative of the way that was carried is that of its integral.
#[test]
fn what_was_carried_follows_the_nodes() {
    let mut random = Random(13);
    for case in cases() {
        let overlaps = case.overlaps();
        let mut then = || -> [Place<f64>; MOST_NODES] {
            std::array::from_fn(|_| std::array::from_fn(|_| random.next()))
        };
        let (slave, master) = (then(), then());
        let direction = [0.3, -0.5, 0.2];
        let corner = corners(case.slave.count) - 1;
        let carried =
            Carried { corner, direction, factor: 0.7, area: -0.4, slave: &slave, master: &master };
        let psi = |case: &Case| -> f64 {
            let own = |own: &Overlap| {
                let (sums, weights) = case.couple().sums(own).unwrap();
                0.7 * dot(direction, weights.way(corner, &slave, &master))
                    - 0.4 * sums.areas[corner]
            };
            overlaps.iter().map(own).sum()
        };
        let mut pulled = vec![[0.0; 3]; case.count()];
        overlaps.iter().for_each(|own| {
            assert!(case.couple().pull_carried(own, &[carried], [&mut pulled]));
        });
        let size = pulled.as_flattened().iter().fold(0.0, |most: f64, own| most.max(own.abs()));
        for (node, by) in pulled.iter().enumerate() {
            for (axis, by) in by.iter().enumerate() {
                let at = |step: f64| psi(&case.moved(node, axis, step));
                let slope = (at(1e-5) - at(-1e-5)) / 2e-5;
                assert!(
                    (slope - by).abs() < bound(&case, 1e-7) * size,
                    "{node} {axis} {slope} {by}"
                );
            }
        }
    }
}

/// Faces of a square of side 2 in a plane at a height, `cells` a side, of so many nodes each.
fn paved(nodes: usize, cells: usize, height: f64, down: bool) -> Vec<FacePlaces<f64>> {
    let step = 2.0 / cells as f64;
    let mut all = Vec::new();
    let cells = (0..cells).flat_map(|i| (0..cells).map(move |j| [i, j]));
    for [i, j] in cells {
        let corner = [-1.0 + step * i as f64, -1.0 + step * j as f64];
        let halves: &[bool] = if corners(nodes) == 3 { &[false, true] } else { &[false] };
        for &half in halves {
            let place = |node: usize| {
                let [x, y] = place_of(nodes, node);
                let [x, y] = if down { [y, x] } else { [x, y] };
                let [x, y] = match (corners(nodes), half) {
                    (3, false) => [x, y],
                    (3, true) => [1.0 - x, 1.0 - y],
                    _ => [0.5 * (1.0 + x), 0.5 * (1.0 + y)],
                };
                [corner[0] + step * x, corner[1] + step * y, height]
            };
            let own: Vec<Place<f64>> = (0..nodes).map(place).collect();
            all.push(FacePlaces::new(&own));
        }
    }
    all
}

/// Requirement: faces that pave a square are covered to rounding by others that pave it: areas sum to
/// the whole, gaps to the whole times the distance, and the nodes of both sides have the weights
/// of a uniform pressure, also where edges lie on edges, and far from the origin; so it is where faces are a hundred times
/// as long as wide.
#[test]
fn faces_that_do_not_match_cover_one_another() {
    for nodes in [3, 4, 6, 8] {
        for other in [3, 4, 6, 8] {
            for cells in [[1, 1], [2, 2], [2, 3], [4, 3]] {
                for away in [0.0, 300.0, 1e5] {
                    cover_one_another([nodes, other], cells, (away, 1.0));
                    cover_one_another([nodes, other], cells, (away, 0.01));
                }
            }
        }
    }
}

fn cover_one_another([nodes, other]: [usize; 2], cells: [usize; 2], (away, width): (f64, f64)) {
    let shifted = |mut own: FacePlaces<f64>| {
        let way = [away, -0.7 * away, 0.4 * away];
        own.nodes[..own.count].iter_mut().for_each(|node| node[1] *= width);
        own.nodes[..own.count].iter_mut().for_each(|node| *node = add_scaled(*node, 1.0, way));
        own
    };
    let slaves: Vec<_> = paved(nodes, cells[0], 0.0, false).into_iter().map(shifted).collect();
    let master = |(face, places)| Faced {
        face,
        nodes: [0; MOST_NODES],
        places,
        ends: FaceEnds::default(),
        thickness: f64::INFINITY,
    };
    let masters = paved(other, cells[1], 0.25, true).into_iter().map(shifted);
    let masters: Vec<Faced> = masters.enumerate().map(master).collect();
    let (mut area, mut gap) = (0.0, 0.0);
    let mut on_masters = vec![0.0; masters.len() * MOST_NODES];
    for slave in &slaves {
        let measure = reference_areas(slave);
        let (mut overlaps, ends) = (Vec::new(), Ends::default());
        Cover::default().find(looking(slave, &ends.slave), &masters, &mut overlaps);
        for own in &overlaps {
            let master = &masters[own.master].places;
            let couple = Couple { slave, measure: &measure, master, ends };
            let (sums, weights) = couple.sums(own).unwrap();
            area += sums.areas.iter().sum::<f64>();
            gap += sums.gaps.iter().sum::<f64>();
            for (corner, node) in (0..4).flat_map(|c| (0..8).map(move |n| (c, n))) {
                on_masters[MOST_NODES * own.master + node] += weights.master[corner][node];
            }
        }
    }
    let bound = 1e-12 + 1e-14 * away;
    assert!((area - 4.0 * width).abs() < bound, "{nodes} {other} {cells:?} {away} {area}");
    assert!((gap - width).abs() < bound, "{nodes} {other} {cells:?} {away} {gap}");
    let whole = 4.0 * width / (masters.len() as f64);
    let [corner, middle] = match other {
        3 => [1.0 / 3.0, 0.0],
        4 => [0.25, 0.0],
        6 => [0.0, 1.0 / 3.0],
        _ => [-1.0 / 12.0, 1.0 / 3.0],
    };
    for (place, own) in on_masters.iter().enumerate() {
        let exact = match place % MOST_NODES {
            node if node < corners(other) => corner * whole,
            node if node < other => middle * whole,
            _ => 0.0,
        };
        assert!((own - exact).abs() < bound, "{nodes} {other} {away} {own} {exact}");
    }
}
