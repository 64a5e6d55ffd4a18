//! Edges that a mesh of faces draws as they are, and those of something round, of which its faces are chords.
//!
//! ```text
//!    o-----o                           o----o_
//!           \        a ridge, or two         `o      three and more edges, one after the other:
//!            o-----o  of a chamfer              \     the surface is smoothed at them
//!                   \                            o
//! ```
//!
//! docs/theory.md section 5.9. (derived)

use super::edges::{MeshFace, edge, is_crease, middle};
use super::patch::MOST_CORNERS;
use super::round::{FLAT, ONWARD};
use crate::vector::{Vector, add, cross, dot, scale, size, sub};
use std::collections::HashMap;

/// Cosine of the angle from which on an edge lies across another one: 25 degrees.
const ASIDE: f64 = 0.906;
/// Cosine of the angle up to which an edge is the next one: 41 degrees.
const ALONG: f64 = 0.75;
/// Turn of an edge across over that of an edge, from which on it hides that [1]: more than the root of two, which the
/// edges between chamfers at right angles have.
const ACROSS: f64 = 1.5;
/// The same where it belongs to something round [1]: but for rounding the same.
const SAME: f64 = 0.999;

/// Faces that are joined at their edges.
pub(super) struct Joints<'a> {
    pub(super) faces: &'a [MeshFace],
    /// The face behind each edge.
    pub(super) neighbours: &'a [[Option<usize>; MOST_CORNERS]],
    /// Faces at every node, with the corner that they have there.
    pub(super) around: &'a HashMap<usize, Vec<(usize, usize)>>,
    /// Unit normals of the faces [1].
    pub(super) normals: &'a [Vector],
}

/// A face at an edge of it.
#[derive(Clone, Copy)]
struct Side {
    face: usize,
    edge: usize,
}

/// How a surface turns at an edge of a face.
#[derive(Clone, Copy, Default)]
struct Turn {
    /// Unit vector along the edge [1].
    along: Vector,
    /// The angle between the faces, negative in a valley; zero where the surface ends or has a crease [rad].
    angle: f64,
}

impl Joints<'_> {
    /// Which edges of each face are drawn as they are; `position` gives undeformed positions of nodes [L].
    pub(super) fn drawn(&self, position: impl Fn(usize) -> Vector) -> Vec<[bool; MOST_CORNERS]> {
        let turns: Vec<_> = (0..self.faces.len()).map(|own| self.turns(own, &position)).collect();
        let all = Turns { joints: self, turns: &turns, position };
        let of_face = |own: usize| {
            let is_drawn = |edge: usize| {
                let side = Side { face: own, edge };
                all.leads(side) && !all.is_round(side)
            };
            std::array::from_fn(|edge| edge < self.corners(own) && is_drawn(edge))
        };
        (0..self.faces.len()).map(of_face).collect()
    }

    fn corners(&self, face: usize) -> usize {
        self.faces[face].cell.faces.len()
    }

    /// The other side of an edge.
    fn behind(&self, Side { face, edge }: Side) -> Option<Side> {
        let other = self.neighbours[face][edge]?;
        let edge = self.neighbours[other].iter().position(|&own| own == Some(face))?;
        Some(Side { face: other, edge })
    }

    fn turns(&self, own: usize, position: impl Fn(usize) -> Vector) -> [Turn; MOST_CORNERS] {
        std::array::from_fn(|k| {
            let Some(other) = self.neighbours[own][k] else { return Turn::default() };
            let (a, b) = (self.normals[own], self.normals[other]);
            let [from, to] = edge(&self.faces[own], k).map(&position);
            let long = size(sub(to, from));
            if is_crease(a, b) || long <= 0.0 {
                return Turn::default();
            }
            let along = scale(sub(to, from), 1.0 / long);
            Turn { along, angle: dot(cross(a, b), along).atan2(dot(a, b)) }
        })
    }
}

/// The turns at all edges.
struct Turns<'a, P> {
    joints: &'a Joints<'a>,
    turns: &'a [[Turn; MOST_CORNERS]],
    position: P,
}

impl<P: Fn(usize) -> Vector> Turns<'_, P> {
    /// Whether the surface turns at an edge nearly as much as both faces turn across it, and less only where what is
    /// across is drawn too, as where chamfers meet: faces that lie askew on something round turn a little, and to
    /// either side.
    fn leads(&self, side: Side) -> bool {
        let Turn { along, angle } = self.turn(side);
        let turn = angle.abs();
        let hides = |other: Side| {
            let Turn { along: way, angle } = self.turn(other);
            let (is_across, across) = (dot(way, along).abs() < ASIDE, angle.abs());
            is_across
                && (across >= ACROSS * turn || (across >= SAME * turn && self.is_round(other)))
        };
        let both = [Some(side), self.joints.behind(side)].into_iter().flatten();
        let mut others = both.flat_map(|Side { face, .. }| {
            (0..self.joints.corners(face)).map(move |edge| Side { face, edge })
        });
        turn > FLAT && !others.any(hides)
    }

    /// Whether an edge is one of three or more at which the surface turns, one after the other.
    fn is_round(&self, side: Side) -> bool {
        let (here, there) =
            (self.onward(side), self.joints.behind(side).and_then(|s| self.onward(s)));
        let goes_on = |next: Option<Side>| next.and_then(|next| self.onward(next)).is_some();
        (here.is_some() && there.is_some()) || goes_on(here) || goes_on(there)
    }

    fn turn(&self, Side { face, edge }: Side) -> Turn {
        self.turns[face][edge]
    }

    /// Where the surface turns on beyond a face, to the same side: the far side of the edge there at which it turns most,
    /// or, about the tip of a triangle, the face beyond that.
    fn onward(&self, from: Side) -> Option<Side> {
        self.onward_at_edges(from).or_else(|| self.onward_about_tip(from))
    }

    /// An edge at the corners of the face that do not belong to the edge where it begins.
    fn onward_at_edges(&self, from: Side) -> Option<Side> {
        let Turn { along, angle } = self.turn(from);
        let corners = self.joints.corners(from.face);
        let apart = (0..corners).filter(|&k| k != from.edge && k != (from.edge + 1) % corners);
        let around =
            apart.flat_map(|k| &self.joints.around[&self.joints.faces[from.face].nodes[k]]);
        let sides = around.flat_map(|&(face, corner)| {
            let count = self.joints.corners(face);
            [corner, (corner + count - 1) % count].map(|edge| Side { face, edge })
        });
        let most = sides.filter_map(|side| {
            let Turn { along: other, angle: next } = self.turn(side);
            let part = dot(other, along).abs();
            (part >= ALONG).then_some((next * angle.signum() * part, side))
        });
        let (turn, found) = most.max_by(|a, b| a.0.total_cmp(&b.0))?;
        let [a, b] = edge(&self.joints.faces[from.face], from.edge).map(&self.position);
        let begin = scale(add(a, b), 0.5);
        let far =
            |side: &Side| size(sub(middle(&self.joints.faces[side.face], &self.position), begin));
        let sides = [Some(found), self.joints.behind(found)].into_iter().flatten();
        let farthest = sides.max_by(|a, b| far(a).total_cmp(&far(b)));
        farthest.filter(|_| turn > ONWARD * angle.abs())
    }

    /// A face about the tip of a triangle that shares no node with its foot: round tips are fans, whose faces turn
    /// a little each, and much over the tip.
    fn onward_about_tip(&self, from: Side) -> Option<Side> {
        let Joints { faces, around, normals, .. } = self.joints;
        let nodes = &faces[from.face].nodes;
        if self.joints.corners(from.face) != 3 {
            return None;
        }
        let Turn { along, angle } = self.turn(from);
        let foot = [nodes[from.edge], nodes[(from.edge + 1) % 3]];
        let is_beyond = |face: usize| !foot.iter().any(|node| faces[face].nodes.contains(node));
        let at_tip = around[&nodes[(from.edge + 2) % 3]].iter();
        let beyond = at_tip.filter(|(face, _)| is_beyond(*face)).filter_map(|&(face, corner)| {
            let edge_on = (corner + 1) % self.joints.corners(face);
            let [a, b] = edge(&faces[face], edge_on).map(&self.position);
            let part = (dot(sub(b, a), along) / size(sub(b, a))).abs();
            let (own, other) = (normals[from.face], normals[face]);
            let turn = dot(cross(other, own), along).atan2(dot(own, other)) * angle.signum();
            (part >= ALONG).then_some((turn * part, Side { face, edge: edge_on }))
        });
        let (turn, found) = beyond.max_by(|a, b| a.0.total_cmp(&b.0))?;
        (turn > ONWARD * angle.abs()).then_some(found)
    }
}

#[cfg(test)]
mod tests {
    use super::super::edges::{faces_around, neighbours, normal};
    use super::*;
    use crate::element::cell::{QUAD4, TRI3};
    use std::f64::consts::{PI, TAU};

    /// A net of faces over parameters, whole quadrilaterals or halves of them, outwards; `place` may leave gaps.
    fn net(
        [rows, columns]: [usize; 2],
        is_halved: bool,
        place: impl Fn(f64, f64) -> Vector,
    ) -> (Vec<MeshFace>, Vec<Vector>) {
        let node = |i: usize, j: usize| i * (columns + 1) + j;
        let at = |k: usize| {
            let (i, j) = (k / (columns + 1), k % (columns + 1));
            place(i as f64 / rows as f64, j as f64 / columns as f64)
        };
        let cells = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j)));
        let faces = cells.flat_map(|(i, j)| {
            let all = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
            let half =
                |own: [usize; 3]| MeshFace { cell: &TRI3, nodes: own.map(|k| all[k]).to_vec() };
            match (is_halved, (i + j) % 2) {
                (false, _) => vec![MeshFace { cell: &QUAD4, nodes: all.to_vec() }],
                (true, 0) => vec![half([0, 1, 2]), half([0, 2, 3])],
                (true, _) => vec![half([0, 1, 3]), half([1, 2, 3])],
            }
        });
        (faces.collect(), (0..(rows + 1) * (columns + 1)).map(at).collect())
    }

    /// How many edges are drawn, each counted from both sides.
    fn drawn((faces, nodes): &(Vec<MeshFace>, Vec<Vector>)) -> usize {
        let at = |node: usize| nodes[node];
        let (neighbours, around) = (neighbours(faces), faces_around(faces));
        let normals: Vec<_> = faces.iter().map(|face| normal(face, at)).collect();
        let joints = Joints { faces, neighbours: &neighbours, around: &around, normals: &normals };
        joints.drawn(at).into_iter().flatten().filter(|drawn| *drawn).count()
    }

    /// A profile drawn along y: directions of its sides [degrees], each one long.
    fn profile(sides: &[f64]) -> impl Fn(f64, f64) -> Vector {
        move |along, s| {
            let (mut at, way) = ([0.0, along, 0.0], s * sides.len() as f64);
            for (k, side) in sides.iter().enumerate() {
                let part = (way - k as f64).clamp(0.0, 1.0);
                at[0] -= part * side.to_radians().cos();
                at[2] += part * side.to_radians().sin();
            }
            at
        }
    }

    /// Requirement: ridges, valleys, chamfers and steps are drawn as they are, whatever the faces; arcs, also those that
    /// end in planes, are not, and no plane is.
    #[test]
    fn ridges_are_drawn_and_arcs_are_not() {
        let along = 3;
        let cases: [(&[f64], usize); 11] = [
            (&[0.0, 0.0, 0.0], 0),
            (&[10.0, -10.0], 1),
            (&[0.0, 0.0, 30.0, 30.0], 1),
            (&[0.0, 30.0, 0.0], 2),
            (&[0.0, 0.0, 20.0, 20.0, 0.0, 0.0], 2),
            (&[0.0, -40.0, -80.0], 2),
            (&[0.0, 0.0, -30.0, -30.0, -40.0, -40.0], 2),
            (&[0.0, -10.0, -30.0, -40.0], 0),
            (&[0.0, 0.0, -5.0, -15.0, -25.0, -30.0, -30.0], 0),
            (&[40.0, 30.0, 20.0, 10.0, 0.0, -10.0], 0),
            (&[0.0, 0.0, -40.0, -41.0, -42.0, -43.0, -44.0], 1),
        ];
        for ((sides, expected), is_halved) in
            cases.iter().flat_map(|own| [(own, false), (own, true)])
        {
            let mesh = net([along, sides.len()], is_halved, profile(sides));
            assert_eq!(drawn(&mesh), 2 * along * expected, "{sides:?} {is_halved}");
        }
    }

    /// Requirement: nothing is drawn on cylinders, spheres, rings and cones of any fineness.
    #[test]
    fn round_surfaces_have_no_ridges() {
        let cylinder = |s: f64, t: f64| [(PI * t).cos(), s, (PI * t).sin()];
        let ball = |s: f64, t: f64| {
            let (a, b) = (0.2 + 2.7 * s, TAU * t);
            [a.sin() * b.cos(), a.sin() * b.sin(), a.cos()]
        };
        let ring = |s: f64, t: f64| {
            let (a, b) = (TAU * s, PI * t);
            let r = 3.0 + a.cos();
            [r * b.cos(), r * b.sin(), a.sin()]
        };
        let cone = |s: f64, t: f64| {
            [(1.0 - 0.5 * s) * (PI * t).cos(), s, (1.0 - 0.5 * s) * (PI * t).sin()]
        };
        let skewed = |s: f64, t: f64| cylinder(s + 0.2 * t, t + 0.05 * (3.0 * s).sin());
        for (n, is_halved) in [6, 9, 16].into_iter().flat_map(|n| [(n, false), (n, true)]) {
            let meshes = [
                net([n / 2, n], is_halved, cylinder),
                net([n, 2 * n], is_halved, ball),
                net([2 * n, 2 * n], is_halved, ring),
                net([n / 2, n], is_halved, cone),
                net([n / 2, n], is_halved, skewed),
            ];
            assert_eq!(meshes.each_ref().map(drawn), [0; 5], "{n} {is_halved}");
        }
    }

    /// Faces through given places, moved, turned and scaled.
    fn solid(
        places: &[Vector],
        faces: &[&[usize]],
        turned: f64,
        unit: f64,
    ) -> (Vec<MeshFace>, Vec<Vector>) {
        let (s, c) = turned.sin_cos();
        let at = |&[x, y, z]: &Vector| [c * x - s * y + 0.1, s * x + c * y, z].map(|x| unit * x);
        let face = |nodes: &&[usize]| MeshFace {
            cell: if nodes.len() == 3 { &TRI3 } else { &QUAD4 },
            nodes: nodes.to_vec(),
        };
        (faces.iter().map(face).collect(), places.iter().map(at).collect())
    }

    /// Requirement: all edges of pyramids and of pads with chamfers around are drawn, however they stand.
    #[test]
    fn pyramids_and_pads_are_drawn() {
        let ring = |size: f64, z: f64| {
            [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
                .map(|[x, y]| [size * x, size * y, z])
        };
        for slope in [5.0_f64, 20.0, 30.0] {
            let fall = slope.to_radians().tan();
            for (turned, unit) in [(0.0, 1.0), (0.1, 1.0), (0.3, 1e3), (0.7, 1e-3)] {
                let mut places = vec![[0.0, 0.0, 0.0]];
                places.extend(ring(1.0, -fall));
                let hips: &[&[usize]] = &[&[1, 2, 0], &[2, 3, 0], &[3, 4, 0], &[4, 1, 0]];
                assert_eq!(drawn(&solid(&places, hips, turned, unit)), 8, "{slope} {turned}");
                let mut places = ring(1.0, -fall).to_vec();
                places.extend(ring(0.5, -0.5 * fall));
                let pad: &[&[usize]] =
                    &[&[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]];
                assert_eq!(drawn(&solid(&places, pad, turned, unit)), 16, "{slope} {turned}");
            }
        }
    }

    /// Requirement: round tips of triangles about a pole have no ridges.
    #[test]
    fn round_tips_have_no_ridges() {
        for (count, rings) in [12, 16, 24].into_iter().flat_map(|n| [(n, 2), (n, 3), (n, 5)]) {
            let (mut places, mut faces) = (vec![[0.0, 0.0, 1.0]], Vec::new());
            let node = |ring: usize, k: usize| {
                if ring == 0 { 0 } else { 1 + (ring - 1) * count + k % count }
            };
            for ring in 1..=rings {
                let polar = 0.5 * PI * ring as f64 / rings.max(3) as f64;
                for k in 0..count {
                    let round = TAU * k as f64 / count as f64;
                    places.push([
                        polar.sin() * round.cos(),
                        polar.sin() * round.sin(),
                        polar.cos(),
                    ]);
                    let [a, b] = [node(ring, k), node(ring, k + 1)];
                    let [c, d] = [node(ring - 1, k), node(ring - 1, k + 1)];
                    faces.push(if ring == 1 { vec![a, b, 0] } else { vec![a, b, d, c] });
                }
            }
            let faces: Vec<&[usize]> = faces.iter().map(|own| &own[..]).collect();
            assert_eq!(drawn(&solid(&places, &faces, 0.2, 1.0)), 0, "{count} {rings}");
        }
    }

    /// Requirement: the ridge of a plate whose other side is a cone is drawn all around.
    #[test]
    fn the_rim_of_a_disc_is_drawn() {
        let disc = |s: f64, t: f64| {
            let (r, z) = if s <= 0.5 { (1.0 - s, 0.0) } else { (s, -0.5 * (s - 0.5)) };
            let r = if s <= 0.5 { 0.1 + 0.8 * s } else { r };
            [r * (PI * t).cos(), r * (PI * t).sin(), z]
        };
        for is_halved in [false, true] {
            assert_eq!(drawn(&net([4, 12], is_halved, disc)), 2 * 12, "{is_halved}");
        }
    }
}
