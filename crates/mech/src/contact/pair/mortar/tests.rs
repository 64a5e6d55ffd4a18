//! The mortar of a face against differences, balance and invariance.

use super::curve::{Curve, Place, cross, dot};
use super::face::{FIRST_MASTER, FacePlaces, MortarFace};
use super::integrals::{Integrals, Segment, Shares};
use super::pull::Direction;
use super::reference::Reference;
use super::sweep::{FaceTangent, SweepRoom};
use super::{Bound, Cover};
use crate::contact::points::Across;

/// Numbers between -1 and 1 that look random.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn place(&mut self, size: f64) -> Place<f64> {
        [size * self.next(), size * self.next()]
    }
}

/// A slave face with masters, in a list of places.
#[derive(Clone)]
struct Case {
    reference: Reference,
    places: Vec<Place<f64>>,
    counts: Vec<(usize, f64)>,
    open: [bool; 2],
    /// The first place of the node that stands at a place.
    first: Vec<usize>,
}

impl Case {
    fn count(&self) -> usize {
        self.reference.count()
    }

    /// The shape functions of a node; of some cases a neighbour's too.
    fn shares(&self, node: usize) -> Shares {
        let mut shares = Shares::of(node);
        if self.open[0] {
            shares.has[(node + 1) % self.count()] = true;
        }
        shares
    }

    fn face(&self) -> (FacePlaces<f64>, Vec<Curve<f64>>) {
        let p = &self.places;
        let places = FacePlaces {
            before: (!self.open[0]).then_some(p[0]),
            own: [p[1], p[2], p[3]],
            after: (!self.open[1]).then_some(p[4]),
        };
        let curve = |(k, &(count, weight)): (usize, &(usize, f64))| {
            let first = FIRST_MASTER + 3 * k;
            Curve { controls: [p[first], p[first + 1], p[first + 2]], count, weight }
        };
        (places, self.counts.iter().enumerate().map(curve).collect())
    }

    fn segments(&self) -> Vec<Segment> {
        let (places, curves) = self.face();
        let face = MortarFace { reference: &self.reference, places: &places, curves: &curves };
        Cover::default().find(&face).to_vec()
    }

    fn with<T>(&self, act: impl Fn(&MortarFace<'_, f64>, &[Segment], &Integrals<f64>) -> T) -> T {
        let (places, curves) = self.face();
        let face = MortarFace { reference: &self.reference, places: &places, curves: &curves };
        let segments = self.segments();
        let mut integrals = Integrals::default();
        assert!(integrals.take(&face, &segments), "{segments:?}");
        act(&face, &segments, &integrals)
    }

    fn psi(&self, node: usize, by: &Direction<f64>) -> f64 {
        self.with(|_, _, integrals| {
            let n = integrals.normal(node, self.count());
            let t = [-n[1], n[0]];
            let r = integrals.gap_of(self.shares(node));
            -by.normal * dot(n, r)
                + by.tangent * dot(t, r)
                + by.area * integrals.area_of(self.shares(node))
        })
    }

    fn pulled(&self, node: usize, by: &Direction<f64>) -> Vec<Place<f64>> {
        self.with(|face, segments, integrals| {
            let mut into = vec![[0.0; 2]; self.places.len()];
            integrals.pull((face, segments), self.shares(node), by, &mut into);
            self.by_node(into)
        })
    }

    fn force(&self, node: usize, (pressure, depth, traction): (f64, f64, f64)) -> Vec<Place<f64>> {
        let by = Direction { normal: pressure, tangent: 0.0, area: -pressure * depth };
        let mut into = self.pulled(node, &by);
        self.with(|face, segments, integrals| {
            let mut own = vec![[0.0; 2]; self.places.len()];
            integrals.drag((face, segments), self.shares(node), traction, &mut own);
            self.by_node(own)
        })
        .into_iter()
        .zip(&mut into)
        .for_each(|(own, into)| *into = [into[0] + own[0], into[1] + own[1]]);
        into
    }

    /// With a node moved, which may stand at several places.
    fn moved(&self, place: usize, axis: usize, by: f64) -> Self {
        let mut moved = self.clone();
        for (own, first) in moved.places.iter_mut().zip(&self.first) {
            own[axis] += if *first == place { by } else { 0.0 };
        }
        moved
    }

    /// Derivatives by places summed to those by nodes.
    fn by_node(&self, by_place: Vec<Place<f64>>) -> Vec<Place<f64>> {
        let mut sum = vec![[0.0; 2]; by_place.len()];
        for (own, &first) in by_place.iter().zip(&self.first) {
            sum[first] = [sum[first][0] + own[0], sum[first][1] + own[1]];
        }
        sum
    }

    fn turned(&self, angle: f64, shift: Place<f64>) -> Self {
        let mut turned = self.clone();
        let (s, c) = angle.sin_cos();
        for [x, y] in &mut turned.places {
            (*x, *y) = (c * *x - s * *y + shift[0], s * *x + c * *y + shift[1]);
        }
        turned
    }
}

/// A face of unit length below curves that leave and overlap it, all of them disturbed.
fn case(random: &mut Random, number: usize) -> Case {
    let count = 2 + number % 2;
    let near = |random: &mut Random, x: f64, y: f64| {
        let [a, b] = random.place(0.06);
        [x + a, y + b]
    };
    // travel to the left: the outward normal, on its right, points up
    let middle = near(random, 0.5, 0.03);
    let mut places = vec![near(random, 1.4, 0.1), near(random, 1.0, 0.0)];
    if count == 3 {
        places.push(middle);
    }
    places.push(near(random, 0.0, 0.0));
    places.resize(4, [0.0; 2]);
    places.push(near(random, -0.5, 0.1));
    places.resize(FIRST_MASTER, [0.0; 2]);
    let controls: Vec<[f64; 3]> =
        places[1..1 + count].iter().map(|&[x, y]| [1.3 * x + 2.0, 0.9 * y, 0.0]).collect();
    let across = if number.is_multiple_of(3) { Across::Ring } else { Across::Width(0.7) };
    let reference = Reference::new(&controls, across);
    // sometimes the master begins or ends over the face
    let begin = if number % 4 == 1 { 0.8 } else { 1.6 };
    let end = if number % 5 == 2 { 0.3 } else { -0.6 };
    let mut counts = Vec::new();
    let nodes = 2 + number % 3;
    let mut from = near(random, begin, 0.02);
    let open = [number % 6 == 4, number % 6 == 5];
    // sometimes within what goes over into the end of the surface
    if number % 12 == 4 {
        from[0] = places[1][0] - 0.004;
    }
    for k in 0..nodes {
        let x = begin + (end - begin) * (k + 1) as f64 / nodes as f64;
        let mut to = near(random, x, 0.02);
        if number % 12 == 5 && k + 1 == nodes {
            to[0] = places[3][0] + 0.004;
        }
        let own = 2 + (number / 2 + k) % 2;
        let weight = if number % 7 == 3 { 0.8 } else { 1.0 };
        let half = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
        let between = near(random, half[0], half[1] + 0.02);
        let all = if own == 2 { [from, to, [0.0; 2]] } else { [from, between, to] };
        places.extend(all);
        counts.push((own, weight));
        from = to;
    }
    let mut first: Vec<usize> = (0..places.len()).collect();
    for k in 1..nodes {
        let before = FIRST_MASTER + 3 * (k - 1);
        first[FIRST_MASTER + 3 * k] = before + counts[k - 1].0 - 1;
    }
    Case { reference, places, counts, open, first }
}

fn cases() -> impl Iterator<Item = Case> {
    let mut random = Random(7);
    let mut all: Vec<Case> = (0..200).map(|number| case(&mut random, number)).collect();
    // what goes over into what is left out changes by more than the tangent knows
    let is_whole = |segments: &[Segment]| segments.iter().all(|own| own.counts == 1.0);
    all.retain(|case| !case.segments().is_empty() && is_whole(&case.segments()));
    assert!(all.len() > 190, "{}", all.len());
    all.into_iter()
}

/// Requirement: the derivatives by hand of weighted overclosure, weighted slip and area are
/// those of central differences, in 200 configurations, with faces covered in part, open ends,
/// arcs and middle nodes. Tolerance: that of the differences.
#[test]
fn gradients_are_those_of_differences() {
    let step = 1e-6;
    let (mut partly, mut several) = (0, 0);
    for (number, case) in cases().enumerate() {
        let segments = case.segments();
        let part: f64 = segments.iter().map(|s| s.bounds[1].at() - s.bounds[0].at()).sum();
        partly += usize::from(part < 0.95);
        several += usize::from(segments.len() > 1);
        let by = Direction { normal: 1.3, tangent: -0.6, area: 0.4 };
        for node in 0..case.count() {
            let pulled = case.pulled(node, &by);
            for (place, own) in pulled.iter().enumerate() {
                for (axis, own) in own.iter().enumerate() {
                    let psi = |by_step: f64| case.moved(place, axis, by_step).psi(node, &by);
                    let exact = (psi(step) - psi(-step)) / (2.0 * step);
                    let off = (own - exact).abs();
                    assert!(off < 2e-7, "{number} {node} {place} {axis}: {own} {exact}");
                }
            }
        }
    }
    assert!(partly > 40 && several > 100, "{partly} {several}");
}

/// Requirement: the distance that what faces a node now had before, by the weights of now, follows
/// places as differences say; a common motion of all places changes nothing. Tolerance: that of
/// differences.
#[test]
fn ways_since_the_last_commit_are_those_of_differences() {
    let step = 1e-6;
    let tangent = [0.8, -0.6];
    let mut random = Random(3);
    for (number, case) in cases().enumerate() {
        let mut before = case.clone();
        for place in &mut before.places {
            let [x, y] = random.place(0.05);
            *place = [place[0] + x, place[1] + y];
        }
        let (places, curves) = before.face();
        let own = MortarFace { reference: &case.reference, places: &places, curves: &curves };
        for node in 0..case.count() {
            let way = |now: &Case, factors: Option<(f64, f64)>| {
                now.with(|face, segments, integrals| {
                    let mut into = vec![[0.0; 2]; now.places.len()];
                    let at = (&own, now.shares(node));
                    let way = integrals.carried((face, segments), at, tangent, factors, &mut into);
                    (way, integrals.area_of(now.shares(node)), now.by_node(into))
                })
            };
            let (whole, _, pulled) = way(&case, Some((1.3, 0.4)));
            let turned = case.turned(0.4, [1.0, 2.0]);
            assert!((way(&turned, None).0 - whole).abs() < 1e-11);
            for (place, own) in pulled.iter().enumerate() {
                for (axis, own) in own.iter().enumerate() {
                    let psi = |by: f64| {
                        let (way, area, _) = way(&case.moved(place, axis, by), None);
                        1.3 * way + 0.4 * area
                    };
                    let exact = (psi(step) - psi(-step)) / (2.0 * step);
                    assert!((own - exact).abs() < 1e-6, "{number} {node} {place}: {own} {exact}");
                }
            }
        }
    }
}

/// Requirement: the tangent is the derivative of the force, with normal and tangential parts, in the
/// same configurations; that of the normal part is symmetric. Tolerance: that of the differences.
#[test]
fn tangents_are_those_of_differences() {
    let step = 1e-6;
    let (mut room, mut tangent) = (SweepRoom::default(), FaceTangent::default());
    for (number, case) in cases().enumerate() {
        let (places, curves) = case.face();
        let face = MortarFace { reference: &case.reference, places: &places, curves: &curves };
        let segments = case.segments();
        let columns = 2 * case.places.len();
        for node in 0..case.count() {
            let forces = (0.8, 0.3, if number % 2 == 0 { 0.5 } else { 0.0 });
            room.tangent((&face, &segments), case.shares(node), forces, &mut tangent);
            let force = case.force(node, forces);
            let sums = by_node(&case, &tangent.derivative);
            let largest = tangent.derivative.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
            for column in 0..columns {
                let (place, axis) = (column / 2, column % 2);
                let side = |by: f64| case.moved(place, axis, by).force(node, forces);
                let (above, below) = (side(step), side(-step));
                for row in 0..columns {
                    let at = |list: &[Place<f64>]| list[row / 2][row % 2];
                    let exact = (at(&above) - at(&below)) / (2.0 * step);
                    let own = sums[row * columns + column];
                    assert!(
                        (own - exact).abs() < 1e-5 * largest,
                        "{number} {row} {column} {own} {exact}"
                    );
                    let other = sums[column * columns + row];
                    let is_symmetric = (own - other).abs() < 1e-11 * largest;
                    assert!(forces.2 != 0.0 || is_symmetric, "{number} {own} {other}");
                }
            }
            for (own, force) in case.by_node(tangent.force.clone()).iter().zip(&force) {
                assert!((own[0] - force[0]).abs() + (own[1] - force[1]).abs() < 1e-12);
            }
        }
    }
}

/// A derivative by places summed to that by nodes.
fn by_node(case: &Case, derivative: &[f64]) -> Vec<f64> {
    let columns = 2 * case.places.len();
    let mut sum = vec![0.0; derivative.len()];
    let node = |component: usize| 2 * case.first[component / 2] + component % 2;
    for row in 0..columns {
        for column in 0..columns {
            sum[node(row) * columns + node(column)] += derivative[row * columns + column];
        }
    }
    sum
}

/// Requirement: forces of pressure and traction balance in force and moment, whatever the gap.
/// Tolerance: rounding.
#[test]
fn forces_balance() {
    for (number, case) in cases().enumerate() {
        for node in 0..case.count() {
            let force = case.force(node, (1.0, 0.2, 0.7));
            let sum = force.iter().fold([0.0; 2], |s, f| [s[0] + f[0], s[1] + f[1]]);
            let moment: f64 = case.places.iter().zip(&force).map(|(&x, &f)| cross(x, f)).sum();
            let most = force.iter().fold(0.0_f64, |m, f| m.max(f[0].abs()).max(f[1].abs()));
            let off = sum[0].abs().max(sum[1].abs()).max(moment.abs());
            assert!(off < 3e-12 * most.max(1.0), "{number} {node} {sum:?} {moment} {most}");
        }
    }
}

/// Requirement: overclosure, area and segments are those of the body moved as a whole.
#[test]
fn a_rigid_motion_changes_nothing() {
    let by = Direction { normal: 1.0, tangent: 0.3, area: 0.2 };
    for (number, case) in cases().enumerate() {
        let turned = case.turned(0.3 + number as f64, [3.0, -2.0]);
        for node in 0..case.count() {
            let (own, other) = (case.psi(node, &by), turned.psi(node, &by));
            assert!((own - other).abs() < 1e-11, "{number} {own} {other}");
        }
    }
}

/// Requirement: weighted gaps and areas are those of the integrals, against a straight line that
/// leans, over the covered part; a constant gap is the mean gap of every node. Source: the integrals of
/// t^k (1 - t)^l in closed form. Tolerance: rounding.
#[test]
fn weighted_gaps_are_integrals_of_shape_functions() {
    for count in [2, 3] {
        for (cut, lean) in [(-1.0, 0.05), (0.25, 0.05), (0.25, 0.0)] {
            let own = if count == 2 { vec![1.0, 0.0] } else { vec![1.0, 0.5, 0.0] };
            let controls: Vec<[f64; 3]> = own.iter().map(|&x| [x, 0.0, 0.0]).collect();
            let reference = Reference::new(&controls, Across::Width(2.0));
            let line = |x: f64| [x, 0.1 + lean * x, 0.0];
            let curves = [
                Curve::new(&[line(2.0), line(0.7)], 1.0),
                Curve::new(&[line(0.7), line(cut)], 1.0),
            ];
            let places = FacePlaces::new(None, &controls, None);
            let face = MortarFace { reference: &reference, places: &places, curves: &curves };
            let mut cover = Cover::default();
            let segments = cover.find(&face).to_vec();
            let mut integrals = Integrals::default();
            assert!(integrals.take(&face, &segments));
            let end = 1.0 - f64::max(cut, 0.0);
            let power = |k: i32| end.powi(k + 1) / f64::from(k + 1);
            // shape functions as polynomials of t
            let shapes: Vec<[f64; 3]> = match count {
                2 => vec![[1.0, -1.0, 0.0], [0.0, 1.0, 0.0]],
                _ => vec![[1.0, -2.0, 1.0], [0.0, 2.0, -2.0], [0.0, 0.0, 1.0]],
            };
            for (node, shape) in shapes.iter().enumerate() {
                let moment = |m: i32| -> f64 {
                    (0..3).map(|k| shape[k as usize] * power(k + m)).sum::<f64>() * 2.0
                };
                let gap = (0.1 + lean) * moment(0) - lean * moment(1);
                assert!((integrals.areas[node] - moment(0)).abs() < 1e-14);
                let found = integrals.gaps[node];
                assert!((found[1] - gap).abs() < 1e-15 && found[0].abs() < 1e-15, "{found:?}");
            }
        }
    }
}

/// Requirement: a curve that turns its back hides what lies behind it, a face that nothing faces
/// has no segments, and the foot of a step is left out.
#[test]
fn only_what_faces_the_slave_counts() {
    let controls = [[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]];
    let reference = Reference::new(&controls, Across::Width(1.0));
    let places = FacePlaces::new(None, &controls, None);
    let cover = |curves: &[Curve<f64>]| {
        let face = MortarFace { reference: &reference, places: &places, curves };
        Cover::default().find(&face).to_vec()
    };
    let line = |from: f64, to: f64, y: f64| Curve::new(&[[from, y, 0.0], [to, y, 0.0]], 1.0);
    // a body whose back is nearer than its front
    assert!(cover(&[line(2.0, -1.0, -0.5), line(-1.0, 2.0, -0.2)]).is_empty());
    assert_eq!(cover(&[line(2.0, -1.0, -0.2), line(-1.0, 2.0, -0.5)]).len(), 1);
    assert!(cover(&[line(3.0, 2.0, 0.1)]).is_empty());
    let step = cover(&[line(2.0, 0.4, 0.1), line(0.4, -1.0, 4.0)]);
    assert_eq!(step.len(), 1);
    assert!((step[0].bounds[1].at() - 0.6).abs() < 1e-14);
    assert_eq!(step[0].bounds[0], Bound::End(0));
}

/// Requirement: where a corner of the slave has sunk by rounding into one limb of a stepped master, and its side faces the other
/// limb, the far side of the first is left out, however narrow what sees it, at both ends of the face.
#[test]
fn the_far_side_of_a_limb_is_left_out_beside_another() {
    let controls = [[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]];
    let reference = Reference::new(&controls, Across::Width(1.0));
    let places = FacePlaces::new(None, &controls, None);
    let line = |from: f64, to: f64, y: f64| Curve::new(&[[from, y, 0.0], [to, y, 0.0]], 1.0);
    for sunk in [1e-10, 1e-3, 0.2] {
        for [far, near] in [
            [line(sunk, -2.0, -3.7), line(2.0, sunk, 0.3)],
            [line(3.0, 1.0 - sunk, -3.7), line(1.0 - sunk, -2.0, 0.3)],
        ] {
            let face = MortarFace { reference: &reference, places: &places, curves: &[far, near] };
            let mut cover = Cover::default();
            let found = cover.find(&face);
            assert!(found.len() == 1 && found[0].curve == 1 && found[0].counts == 1.0, "{sunk}");
        }
    }
}

/// Requirement: a round face meets nothing behind the place where its normals cross: a surface there,
/// wider than all its normals, has not been entered through the face.
#[test]
fn nothing_is_faced_behind_the_focus() {
    let controls = [[1.0, 0.0, 0.0], [0.5, 0.5, 0.0], [0.0, 0.0, 0.0]];
    let reference = Reference::new(&controls, Across::Width(1.0));
    let places = FacePlaces::new(None, &controls, None);
    let covered = |y: f64| {
        let curves = [Curve::new(&[[5.0, y, 0.0], [-5.0, y, 0.0]], 1.0)];
        let face = MortarFace { reference: &reference, places: &places, curves: &curves };
        Cover::default().find(&face).len()
    };
    // the normals at both ends cross at y = -0.5
    assert_eq!([1.0, 0.1, -0.2, -2.0].map(covered), [1, 1, 1, 0]);
}

/// Requirement: forces do not jump where the end of one curve and the beginning of the next pass a
/// node between two faces.
#[test]
fn forces_are_continuous_where_ends_pass_a_node() {
    let (c, s) = (15.0_f64.to_radians().cos(), 30.0_f64.to_radians());
    let arc = |from: f64, to: f64, shift: f64| {
        let at = |angle: f64, by: f64| {
            [5.0 * angle.sin() * by + shift, 5.0 - 5.0 * angle.cos() * by - 1e-3, 0.0]
        };
        Curve::new(&[at(from, 1.0), at(0.5 * (from + to), 1.0 / c), at(to, 1.0)], c)
    };
    let node = |x: f64| [x, 0.0, 0.0];
    let nodes = [0.04, 0.02, 0.0, -0.02, -0.04].map(node);
    let force = |shift: f64| {
        let curves = [arc(s, 0.0, shift), arc(0.0, -s, shift)];
        let (mut sum, mut area) = ([[0.0; 2]; 5], 0.0);
        for face in 1..3 {
            let own = [nodes[face], nodes[face + 1]];
            let reference = Reference::new(&own, Across::Width(1.0));
            let after = nodes.get(face + 2).copied();
            let places = FacePlaces::new(Some(nodes[face - 1]), &own, after);
            let face_of = MortarFace { reference: &reference, places: &places, curves: &curves };
            let mut cover = Cover::default();
            let segments = cover.find(&face_of).to_vec();
            let mut integrals = Integrals::default();
            assert!(integrals.take(&face_of, &segments));
            let mut into = vec![[0.0; 2]; FIRST_MASTER + 6];
            let by = Direction { normal: 1.0, tangent: 0.0, area: 0.0 };
            let shares = Shares::of(2 - face);
            integrals.pull((&face_of, &segments), shares, &by, &mut into);
            area += integrals.area_of(shares);
            for (slot, own) in [(0, face - 1), (1, face), (2, face + 1), (4, face + 2)] {
                if let Some(sum) = sum.get_mut(own) {
                    *sum = [sum[0] + into[slot][0], sum[1] + into[slot][1]];
                }
            }
        }
        assert!((area - 0.02).abs() < 1e-14, "{area}");
        sum
    };
    let middle = force(0.0);
    for shift in [-1e-5, -1e-7, -1e-9, -1e-15, 1e-15, 1e-9, 1e-7, 1e-5] {
        for (own, other) in force(shift).iter().zip(&middle) {
            let off = (own[0] - other[0]).abs() + (own[1] - other[1]).abs();
            assert!(off < 2.0 * shift.abs() + 1e-14, "{shift} {own:?} {other:?}");
        }
    }
}

/// Requirement: forces do not leap where the end of the master passes the end of the slave surface,
/// though what is faced there stands away from it; and both on one another are as one.
#[test]
fn forces_are_continuous_where_an_end_passes_the_end_of_the_surface() {
    let own = [[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]];
    let reference = Reference::new(&own, Across::Width(1.0));
    let places = FacePlaces::new(None, &own, None);
    let force = |end: usize, shift: f64| {
        let (mut from, mut to) = ([2.0, 0.2, 0.0], [-1.0, -0.1, 0.0]);
        *(if end == 0 { &mut from[0] } else { &mut to[0] }) = 1.0 - end as f64 + shift;
        let curves = [Curve::new(&[from, to], 1.0)];
        let face = MortarFace { reference: &reference, places: &places, curves: &curves };
        let segments = Cover::default().find(&face).to_vec();
        let mut integrals = Integrals::default();
        assert!(integrals.take(&face, &segments));
        let mut into = vec![[0.0; 2]; FIRST_MASTER + 3];
        let by = Direction { normal: 1.0, tangent: 0.0, area: 0.0 };
        for node in 0..2 {
            integrals.pull((&face, &segments), Shares::of(node), &by, &mut into);
        }
        (into, integrals.areas[0] + integrals.areas[1])
    };
    for end in 0..2 {
        let (middle, area) = force(end, 0.0);
        assert!((area - 1.0).abs() < 1e-14, "{area}");
        for shift in [-1e-5, -1e-7, -1e-9, 1e-9, 1e-7, 1e-5] {
            for (own, other) in force(end, shift).0.iter().zip(&middle) {
                let off = (own[0] - other[0]).abs() + (own[1] - other[1]).abs();
                assert!(off < 100.0 * f64::abs(shift) + 1e-13, "{end} {shift} {own:?} {other:?}");
            }
        }
        // away from the end all that is covered counts
        let inward = if end == 0 { -0.3 } else { 0.3 };
        let covered = force(end, inward).1;
        assert!((covered - 0.7).abs() < 1e-14, "{covered}");
    }
}

/// Requirement: what is hidden behind the master changes no force, also where its nodes project upon
/// those that are faced: the bottom of a block, below a node of its top in the middle of a slave face.
#[test]
fn what_is_hidden_moves_no_bound() {
    let own = [[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]];
    let reference = Reference::new(&own, Across::Width(1.0));
    let places = FacePlaces::new(None, &own, None);
    let line =
        |from: Place<f64>, to: Place<f64>| Curve::new(&[from, to].map(|[x, y]| [x, y, 0.0]), 1.0);
    let top = [line([2.0, 0.1], [0.5, -0.1]), line([0.5, -0.1], [-1.0, 0.1])];
    let force = |behind: &[Curve<f64>]| {
        let curves = [&top[..], behind].concat();
        let face = MortarFace { reference: &reference, places: &places, curves: &curves };
        let segments = Cover::default().find(&face).to_vec();
        let mut integrals = Integrals::default();
        assert!(integrals.take(&face, &segments));
        let mut into = vec![[0.0; 2]; FIRST_MASTER + 3 * curves.len()];
        let by = Direction { normal: 1.0, tangent: 0.0, area: 0.0 };
        integrals.pull((&face, &segments), Shares::of(0), &by, &mut into);
        into
    };
    let alone = force(&[]);
    for shift in [-1e-9, -1e-12, -1e-15, 0.0, 1e-15, 1e-12, 1e-9] {
        let x = 0.5 + shift;
        let both = force(&[line([-1.0, 3.0], [x, 3.0]), line([x, 3.0], [2.0, 3.0])]);
        for (own, other) in alone.iter().zip(&both) {
            let off = (own[0] - other[0]).abs() + (own[1] - other[1]).abs();
            assert!(off < 1e-13, "{shift} {own:?} {other:?}");
        }
    }
}
