//! Search and gap put together for faces in space: a point, what faces it, and the nodes that both
//! follow.
//!
//! ```text
//!      x-------> slip        X_c: where the point stood at the last commit, a place of its
//!      |      x              face that moves with it; slip = t . (x - X_c), t turned with n
//!   ---o------o-----
//!     X_c     X
//! ```
//!
//! [docs/theory.md, section 5.9]

use super::super::gap::face::{
    FaceGap, MOST_VARIABLES, NO_PARTS, Turned, add_to, directions_across,
};
use super::super::search::faces::FacePlace;
use super::super::tangential::Tangential;
use crate::surface::mesh::{FaceMesh, PlacedFace};
use crate::surface::patch::{Parts, Patch};
use crate::vector::{Vector, cross, dot, scale, size, sub};

/// Where a point stood on a surface of faces when its state was committed.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
pub struct Footing {
    /// The place that faced it.
    pub place: FacePlace,
    /// Unit normal there [1].
    pub normal: Vector,
    /// The first tangential direction there [1].
    pub direction: Vector,
    /// The first tangent of the face by both directions [1]: how the face stood in its plane.
    pub bearing: [f64; 2],
}

impl Footing {
    /// Both tangential directions.
    pub fn directions(&self) -> [Vector; 2] {
        [self.direction, cross(self.normal, self.direction)]
    }
}

/// Room for the faces of a point.
#[derive(Debug, Clone)]
pub struct FaceRoom {
    own: PlacedFace,
    before: PlacedFace,
    kernel: Vec<f64>,
    half: Vec<f64>,
}

impl Default for FaceRoom {
    fn default() -> Self {
        let (own, before) = (PlacedFace::EMPTY, PlacedFace::EMPTY);
        Self { own, before, kernel: Vec::new(), half: Vec::new() }
    }
}

impl FaceRoom {
    /// Room for one face, for searches.
    pub fn face(&mut self) -> &mut PlacedFace {
        &mut self.own
    }
}

/// A point against the face that faces it.
#[derive(Debug, Clone)]
pub struct FacePoint {
    gap: FaceGap,
    place: FacePlace,
    turned: Turned,
    /// Slip since the last commit [L].
    pub slip: Tangential,
    /// x - X_c [L].
    way: Vector,
    /// The face of the last commit, and where on it the point stood.
    before: Option<(Patch, FacePlace)>,
    footing: Footing,
}

impl FacePoint {
    /// The point at `point` before the place that faces it; `before` is where it stood. `None`
    /// where the face has collapsed.
    pub fn new(
        mesh: &FaceMesh,
        positions: &[Vector],
        (place, point): (FacePlace, Vector),
        before: Option<&Footing>,
        room: &mut FaceRoom,
    ) -> Option<Self> {
        let patch = mesh.place(place.face, positions, &mut room.own)?;
        let gap = FaceGap::new(patch, place.at, point)?;
        let tangent = gap.tangents()[0];
        let profile = |from: FacePlace| {
            let places = [from, place].map(|own| (own.face, own.at));
            mesh.profile((positions, gap.normal), places)
        };
        let axis = mesh.axis(place.face, gap.patch()).or_else(|| profile(place));
        let anew = || {
            let directions = directions_across(gap.normal, axis.unwrap_or(tangent));
            Turned::new(gap.normal, directions, gap.normal)
        };
        let kept = before.and_then(|before| {
            let carried = Turned::new(before.normal, before.directions(), gap.normal)?;
            let along = |near| along_profile(near, &carried, (before.normal, gap.normal));
            Some((before, profile(before.place).and_then(along).unwrap_or(carried)))
        });
        let Some((before, turned)) = kept else {
            let turned = anew()?;
            let direction = turned.directions[0];
            let footing = Footing { place, normal: gap.normal, direction, bearing: [1.0, 0.0] };
            let bearing = axis.map_or(footing.bearing, |_| bearing(&footing, tangent));
            let footing = Footing { bearing, ..footing };
            let (slip, way) = (Tangential::ZERO, [0.0; 3]);
            return Some(Self { gap, place, turned, slip, way, before: None, footing });
        };
        let from = mesh.place(before.place.face, positions, &mut room.before)?;
        let at = from.place(before.place.at);
        let way = sub(point, from.position(&at.value));
        let slip = Tangential(turned.directions.map(|t| dot(t, way)));
        let direction = carried(before, (&from, before.place.at), &turned, gap.normal);
        let along = |near| directions_across(gap.normal, alike(near, direction))[0];
        let direction = profile(place).map_or(direction, along);
        let footing = Footing { place, normal: gap.normal, direction, bearing: [1.0, 0.0] };
        let bearing = bearing(&footing, tangent);
        let footing = Footing { bearing, ..footing };
        Some(Self { gap, place, turned, slip, way, before: Some((from, before.place)), footing })
    }

    /// The gap.
    pub fn gap(&self) -> &FaceGap {
        &self.gap
    }

    /// The place that faces the point.
    pub fn place(&self) -> FacePlace {
        self.place
    }

    /// Where the point would stand, were its state committed.
    pub fn footing(&self) -> Footing {
        self.footing
    }

    /// Tangential directions [1].
    pub fn directions(&self) -> [Vector; 2] {
        self.turned.directions
    }

    /// The face on which its slip is measured besides its own one.
    pub fn other_face(&self) -> Option<usize> {
        self.before.as_ref().map(|(_, place)| place.face).filter(|&face| face != self.place.face)
    }

    /// Rows of overclosure, slips and drags, in this order: `add(row, side, node, value)` with the
    /// side of the slave (0), of its face (1) or of the other face (2) and places in their stencils.
    pub fn rows(
        &self,
        mesh: &FaceMesh,
        room: &FaceRoom,
        mut add: impl FnMut(usize, usize, usize, Vector),
    ) {
        let mut own = |row: usize, parts: &Parts| {
            carry((mesh, self.place.face), &room.own, parts, |side, node, value| {
                add(row, side, node, value);
            });
        };
        own(0, &self.gap.gradient());
        for (k, &t) in self.turned.directions.iter().enumerate() {
            own(3 + k, &self.gap.drag(t));
            match &self.before {
                None => own(1 + k, &self.gap.drag(t)),
                Some(_) => {
                    let mut parts = self.gap.direction_follows(&self.turned, k, self.way);
                    parts[0] = crate::vector::add(parts[0], t);
                    own(1 + k, &parts);
                }
            }
        }
        let Some((patch, before)) = &self.before else { return };
        let other = if before.face == self.place.face { 1 } else { 2 };
        let weights = patch.place(before.at).value;
        for (k, &t) in self.turned.directions.iter().enumerate() {
            let mut parts = NO_PARTS;
            patch.pull(&weights, t, -1.0, &mut parts);
            carry((mesh, before.face), &room.before, &parts, |side, node, value| {
                if side > 0 {
                    add(1 + k, other, node, value);
                }
            });
        }
    }

    /// Derivative of `normal` dh + `tangential` . drags by the positions of the slave and of the
    /// stencil of its face: square, row-major, as many rows as three times their number.
    pub fn derivative(
        &self,
        mesh: &FaceMesh,
        (normal, tangential): (f64, Tangential),
        room: &mut FaceRoom,
        into: &mut Vec<f64>,
    ) {
        let face = self.place.face;
        let (width, wide) = (self.gap.width(), 3 * (1 + mesh.stencil(face).len()));
        let FaceRoom { own, kernel, half, .. } = room;
        kernel.clear();
        kernel.resize(width * width, 0.0);
        self.gap.derivative(normal, (&self.turned, tangential.0), kernel);
        // J' K J: columns first, then rows
        half.clear();
        half.resize(width * wide, 0.0);
        for (row, from) in half.chunks_exact_mut(wide).zip(kernel.chunks_exact(width)) {
            carry((mesh, face), own, &parts_of(from), |side, node, value| {
                add_at(row, side * (1 + node), value);
            });
        }
        into.clear();
        into.resize(wide * wide, 0.0);
        let mut column = [0.0; MOST_VARIABLES];
        for j in 0..wide {
            for (i, value) in column[..width].iter_mut().enumerate() {
                *value = half[i * wide + j];
            }
            carry((mesh, face), own, &parts_of(&column[..width]), |side, node, value| {
                let first = 3 * side * (1 + node);
                for (axis, value) in value.into_iter().enumerate() {
                    into[(first + axis) * wide + j] += value;
                }
            });
        }
        self.add_bends_of_normals(mesh, (normal, tangential), own, (into, wide));
    }

    /// What the forces on normals add as these turn with the nodes.
    fn add_bends_of_normals(
        &self,
        mesh: &FaceMesh,
        (normal, tangential): (f64, Tangential),
        own: &PlacedFace,
        (into, wide): (&mut [f64], usize),
    ) {
        let mut force = NO_PARTS;
        add_to(&mut force, &self.gap.gradient(), normal);
        for (t, tangential) in self.turned.directions.into_iter().zip(tangential.0) {
            if tangential != 0.0 {
                add_to(&mut force, &self.gap.drag(t), tangential);
            }
        }
        let first = 1 + self.gap.patch().nodes();
        for (corner, star) in own.normals.iter().enumerate() {
            let y = force[first + corner];
            mesh.star(self.place.face, corner).pull_twice(
                &own.positions,
                (star, y),
                |i, j, block| {
                    for (a, row) in block.into_iter().enumerate() {
                        for (b, value) in row.into_iter().enumerate() {
                            into[(3 * (1 + i) + a) * wide + 3 * (1 + j) + b] += value;
                        }
                    }
                },
            );
        }
    }
}

/// The first direction across `normal` to which a tangent has the bearing that it had to the
/// directions of a footing: what that is as the surface turns, in its plane too. `None` where the
/// tangent is along the normal. [docs/theory.md, section 5.9]
pub(super) fn borne(before: &Footing, tangent: Vector, normal: Vector) -> Option<Vector> {
    let across = sub(tangent, scale(normal, dot(tangent, normal)));
    let size = size(across);
    let [c, s] = before.bearing;
    let own = sub(scale(across, c), scale(cross(normal, across), s));
    (size > 0.0).then(|| scale(own, 1.0 / size))
}

/// The directions along the profile of a surface of revolution and across it, as ones that turned with the normal
/// from where it stood to where it stands; the profile is taken the way that is nearer to the directions that
/// were carried along. What turns about the normal is left out of derivatives.
fn along_profile(near: Vector, carried: &Turned, (from, to): (Vector, Vector)) -> Option<Turned> {
    let directions = directions_across(to, alike(near, carried.directions[0]));
    Turned::new(from, Turned::new(to, directions, from)?.directions, to)
}

/// A direction or the opposite one, which is nearer to another.
fn alike(near: Vector, other: Vector) -> Vector {
    if dot(near, other) < 0.0 { scale(near, -1.0) } else { near }
}

/// The first direction after an increment: it turns with the surface where the point stood, and from
/// there to the place that it faces with the normal, the shortest way. What turns at one place alone is
/// compared at that place: beside a tangent that stays as it is a direction that turns with the normal
/// seems to turn in the plane, by as much as the tangent happens to lean.
fn carried(
    before: &Footing,
    (patch, at): (&Patch, [f64; 2]),
    turned: &Turned,
    to: Vector,
) -> Vector {
    let first = turned.directions[0];
    let Some((tangents, normal)) = patch.frame(&patch.place(at)) else { return first };
    let Some(own) = borne(before, tangents[0], normal) else { return first };
    Turned::new(normal, [own, cross(normal, own)], to).map_or(first, |own| own.directions[0])
}

/// The first tangent of a face by the directions of a footing.
pub(super) fn bearing(footing: &Footing, tangent: Vector) -> [f64; 2] {
    let by = footing.directions().map(|t| dot(t, tangent));
    let size = by[0].hypot(by[1]);
    if size > 0.0 { by.map(|value| value / size) } else { [1.0, 0.0] }
}

/// Parts of a list of numbers.
fn parts_of(values: &[f64]) -> Parts {
    let mut parts = NO_PARTS;
    parts.as_flattened_mut()[..values.len()].copy_from_slice(values);
    parts
}

fn add_at(row: &mut [f64], place: usize, value: Vector) {
    row[3 * place..][..3].iter_mut().zip(value).for_each(|(into, value)| *into += value);
}

/// Carries forces on the parts of a gap to the slave (side 0) and the nodes of a face's stencil
/// (side 1): those on normals go to the nodes of their stars.
fn carry(
    (mesh, face): (&FaceMesh, usize),
    placed: &PlacedFace,
    parts: &Parts,
    mut add: impl FnMut(usize, usize, Vector),
) {
    add(0, 0, parts[0]);
    let nodes = mesh.faces()[face].nodes.len();
    for (node, &value) in parts[1..=nodes].iter().enumerate() {
        add(1, node, value);
    }
    for (corner, star) in placed.normals.iter().enumerate() {
        let y = parts[1 + nodes + corner];
        if y != [0.0; 3] {
            let own = mesh.star(face, corner);
            own.pull(&placed.positions, (star, y), |node, value| add(1, node, value));
        }
    }
}

#[cfg(test)]
mod tests;
