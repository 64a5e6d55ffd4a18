//! The faces of a slave surface, and how control points follow nodes.

use crate::dofs::{DofMap, Translations};
use slideline_mech::contact::pair::Body;
use slideline_mech::contact::pair::mortar::Reference;
use slideline_mech::contact::points::Across;
use slideline_mech::rigid::PointMap;
use slideline_model::{ContactPair, Lumping, NodeIndex};
use std::collections::HashMap;

/// How a control point follows nodes, or a rigid body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Control {
    /// It is a node, by its place among those of its side.
    Node(usize),
    /// That of the middle node (the second) of a face: 2 x - (a + b)/2.
    Middle([usize; 3]),
    /// It rides on the rigid body [L].
    Body([f64; 3]),
}

impl Control {
    /// The nodes that it follows, with their weights [1].
    pub fn nodes(self) -> impl Iterator<Item = (usize, f64)> {
        let all = match self {
            Self::Node(node) => [Some((node, 1.0)), None, None],
            Self::Middle([a, middle, b]) => [Some((a, -0.5)), Some((middle, 2.0)), Some((b, -0.5))],
            Self::Body(_) => [None; 3],
        };
        all.into_iter().flatten()
    }

    /// Where it stands, by the places of the nodes and of the body [L].
    pub fn place(self, nodes: &[[f64; 3]], body: &Body) -> [f64; 3] {
        if let Self::Body(at) = self {
            return body.to_space(at);
        }
        let mut place = [0.0; 3];
        for (node, weight) in self.nodes() {
            place.iter_mut().zip(nodes[node]).for_each(|(sum, x)| *sum += weight * x);
        }
        place
    }

    /// Its derivatives by the rotation of the body: first and second [L].
    pub fn turning(self, body: &Body) -> [[f64; 3]; 2] {
        let Self::Body(at) = self else { return [[0.0; 3]; 2] };
        let PointMap::Arm { .. } = body.map(at) else { return [[0.0; 3]; 2] };
        let (centre, place) = (body.to_space(body.reference), body.to_space(at));
        let [x, y] = [0, 1].map(|axis| place[axis] - centre[axis]);
        [[-y, x, 0.0], [-x, -y, 0.0]]
    }
}

/// Faces of the slave, and curves of the master that these do not meet.
pub type ApartFaces = [Vec<bool>; 2];

/// A slave face.
#[derive(Clone, Debug)]
pub struct SlaveFace {
    /// Its control points.
    pub controls: [Control; 3],
    /// How many they are.
    pub count: usize,
    /// Places of its points among those of the pair.
    pub points: [usize; 3],
    /// The faces before and behind it, where the surface goes on smoothly.
    pub beside: [Option<usize>; 2],
    /// The face, undeformed.
    pub reference: Reference,
}

/// The slave surface of a pair.
#[derive(Clone, Debug)]
pub struct Mortar {
    /// Place of its pair in the model.
    pub pair: usize,
    /// Its first point; slave node by slave node, then those that corners add.
    pub first: usize,
    /// Its faces.
    pub faces: Vec<SlaveFace>,
    /// The faces of every point with the places of the point in them, at most two.
    pub of_point: Vec<[Option<(usize, usize)>; 2]>,
    /// Undeformed positions of the slave nodes [L].
    pub positions: Vec<[f64; 3]>,
    /// Their dofs.
    pub dofs: Vec<Translations>,
    /// Faces, and curves of the master, that do not meet.
    pub apart: Vec<ApartFaces>,
    across: Across,
}

impl Mortar {
    /// Whether a face meets a curve of the master.
    pub fn meets(&self, face: usize, curve: usize) -> bool {
        let has = |own: &[bool], place: usize| own.get(place).is_some_and(|&is_apart| is_apart);
        !self.apart.iter().any(|[faces, curves]| has(faces, face) && has(curves, curve))
    }

    /// The slave surface of a pair with these slave nodes, without its numbers.
    pub fn new(
        (place, pair): (usize, &ContactPair),
        first: usize,
        (nodes, dofs): (&[NodeIndex], &DofMap),
    ) -> Self {
        let place_of: HashMap<_, _> =
            nodes.iter().enumerate().map(|(k, &node)| (node, k)).collect();
        let mut faces: Vec<SlaveFace> = Vec::new();
        let mut elements = pair.elements.iter();
        let face = |nodes: &[NodeIndex]| {
            let own: Vec<usize> = nodes.iter().map(|node| place_of[node]).collect();
            let node = |k: usize| own.get(k).copied().unwrap_or(0);
            let middle = match own.len() {
                3 => Control::Middle([node(0), node(1), node(2)]),
                _ => Control::Node(node(1)),
            };
            SlaveFace {
                controls: [Control::Node(node(0)), middle, Control::Node(node(2))],
                count: own.len(),
                points: [node(0), node(1), node(2)],
                beside: [None; 2],
                reference: Reference::new(&[[0.0; 3]; 3][..own.len()], Across::Width(1.0)),
            }
        };
        while let Some(element) = elements.next() {
            let [a, b] = element.nodes;
            match element.lumping {
                Lumping::ToMiddle => {
                    let last = elements.next().map_or(b, |next| next.nodes[1]);
                    faces.push(face(&[a, b, last]));
                }
                _ => faces.push(face(&[a, b])),
            }
        }
        let mut own = Self {
            pair: place,
            first,
            faces,
            of_point: vec![[None; 2]; nodes.len() + pair.corners.len()],
            positions: vec![[0.0; 3]; nodes.len()],
            dofs: nodes.iter().map(|&node| dofs.translations(node)).collect(),
            across: Across::Width(1.0),
            apart: Vec::new(),
        };
        let corners: Vec<usize> = pair.corners.iter().map(|node| place_of[node]).collect();
        own.join(&corners);
        own
    }

    /// Finds neighbours; at a corner each of both faces has a point of its own.
    fn join(&mut self, corners: &[usize]) {
        let nodes = self.positions.len();
        let ending: HashMap<usize, usize> = {
            let last = |face: &SlaveFace| face.points[face.count - 1];
            self.faces.iter().enumerate().map(|(k, face)| (last(face), k)).collect()
        };
        for next in 0..self.faces.len() {
            let node = self.faces[next].points[0];
            let Some(&before) = ending.get(&node).filter(|&&before| before != next) else {
                continue;
            };
            match corners.iter().position(|&corner| corner == node) {
                Some(corner) => self.faces[next].points[0] = nodes + corner,
                None => {
                    self.faces[next].beside[0] = Some(before);
                    self.faces[before].beside[1] = Some(next);
                }
            }
        }
        for (place, face) in self.faces.iter().enumerate() {
            for (node, &point) in face.points[..face.count].iter().enumerate() {
                let of_point = &mut self.of_point[point];
                let free = usize::from(of_point[0].is_some());
                of_point[free] = Some((place, node));
            }
        }
    }

    /// Takes the positions of its nodes and how far contact reaches across the plane; gives the areas
    /// of its points, covered as a whole: `add(point, area)` [L2].
    pub fn take(
        &mut self,
        positions: impl Iterator<Item = [f64; 3]>,
        across: Across,
        mut add: impl FnMut(usize, f64),
    ) {
        self.across = across;
        self.positions.clear();
        self.positions.extend(positions);
        for face in &mut self.faces {
            let place = |k: usize| face.controls[k].place(&self.positions, &Body::STILL);
            let controls = [0, 1, if face.count == 3 { 2 } else { 1 }].map(place);
            face.reference = Reference::new(&controls[..face.count], across);
            let areas = face.reference.areas();
            face.points[..face.count].iter().zip(areas).for_each(|(&point, area)| add(point, area));
        }
    }

    /// The control point before a face, its own, and the one behind it, in the order of places.
    pub fn controls(&self, face: usize) -> [Option<Control>; 5] {
        let own = &self.faces[face];
        let before = own.beside[0].map(|before| {
            let before = &self.faces[before];
            before.controls[before.count - 2]
        });
        let after = own.beside[1].map(|after| self.faces[after].controls[1]);
        let last = (own.count == 3).then_some(own.controls[2]);
        [before, Some(own.controls[0]), Some(own.controls[1]), last, after]
    }
}
