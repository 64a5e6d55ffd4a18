//! Places of integration over an overlap.
//!
//! ```text
//!        v3-------v2        a polygon on the cell of the slave, in triangles about its first
//!       /   `.  .  \        corner; every place of integration faces one of the master along
//!      v0-------`--v1       the normal of the piece
//! ```
//!
//! docs/theory.md eqs. (5.30) to (5.33)

use super::clip::{Corner, MOST, Overlap};
use super::couple::Couple;
use super::face_places::{FacePlaces, Plane};
use super::over::identity;
use super::places::{Place, add_scaled, cross, dot, flat_add, flat_cross, flat_sub, scale, sub};
use super::shapes::{MOST_CORNERS, MOST_NODES, Shapes, corners, middle, pieces, place_of, shapes};
use crate::differentiate::Real;

/// Most iterations towards a projection.
const MOST_STEPS: usize = 30;
/// Step of a place on its cell below which it is found, near the origin [1].
const FOUND: f64 = 1e-13;
/// Roundings of a place that such a step may come to [1].
const ROUNDINGS: f64 = 8.0;
/// Cells that a projection may lie away from its own one [1].
const AWAY: f64 = 20.0;

/// Rules over triangles: two coordinates and the weight, by twice the area.
const THREE: &[[f64; 3]] = &[
    [1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0],
    [2.0 / 3.0, 1.0 / 6.0, 1.0 / 6.0],
    [1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0],
];
/// Exact to the sixth degree: with one of the fourth, forces leapt by up to 1e-4 of themselves where
/// overlaps of faces that are no parallelograms were cut in another way. [dunavant1985]
const TWELVE: &[[f64; 3]] = &[
    [0.063089014491502, 0.063089014491502, 0.025422453185103448],
    [0.063089014491502, 0.873821971016996, 0.025422453185103448],
    [0.873821971016996, 0.063089014491502, 0.025422453185103448],
    [0.24928674517091, 0.24928674517091, 0.05839313786318938],
    [0.24928674517091, 0.501426509658179, 0.05839313786318938],
    [0.501426509658179, 0.24928674517091, 0.05839313786318938],
    [0.053145049844817, 0.310352451033784, 0.04142553780918692],
    [0.053145049844817, 0.636502499121399, 0.04142553780918692],
    [0.310352451033784, 0.053145049844817, 0.04142553780918692],
    [0.310352451033784, 0.636502499121399, 0.04142553780918692],
    [0.636502499121399, 0.053145049844817, 0.04142553780918692],
    [0.636502499121399, 0.310352451033784, 0.04142553780918692],
];

/// Where a place is faced along a normal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Met<R> {
    /// Shape functions of what is faced.
    pub shapes: Shapes<R>,
    /// Its derivatives by the coordinates of the cell [L].
    pub along: [Place<R>; 2],
    /// From the place to it, along the normal [L].
    pub gap: R,
}

/// A corner of an overlap upon the cell of the slave.
#[derive(Debug, Clone, Copy)]
pub(super) struct OnCell<R> {
    pub at: [R; 2],
    /// Along the edge that it stands upon: 0 to 1.
    pub along: R,
    /// Derivative of where it stands by `along`, were it no end, [1]; of corners upon the piece: of
    /// the coordinates of the piece.
    pub slope: R,
    pub by: [[R; 2]; 2],
}

/// A place of integration.
#[derive(Debug, Clone, Copy)]
pub(super) struct Station<R> {
    /// The corners of its triangle with their weights.
    pub triangle: [usize; 3],
    pub fractions: [f64; 3],
    pub weight: f64,
    /// Twice the area of the triangle on the cell [1].
    pub twice: R,
    /// Shape functions of the slave, and those of its corners alone.
    pub slave: Shapes<R>,
    pub corners: Shapes<R>,
    /// Undeformed area by the coordinates, and its derivatives [L2].
    pub measure: R,
    pub measure_slope: [R; 2],
    /// Derivatives of the place by the coordinates [L].
    pub along: [Place<R>; 2],
    pub met: Met<R>,
}

/// An overlap in a configuration.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placed<R> {
    pub plane: Plane<R>,
    pub vertices: [OnCell<R>; MOST],
}

/// Undeformed area by the coordinates of the cell, at the nodes of a face [L2].
pub fn reference_areas(face: &FacePlaces<f64>) -> [f64; MOST_NODES] {
    std::array::from_fn(|node| match node < face.count {
        true => {
            let own = face.shapes(place_of(face.count, node));
            let across = cross(face.blend(&own.slope[0]), face.blend(&own.slope[1]));
            dot(across, across).sqrt()
        }
        false => 0.0,
    })
}

impl FacePlaces<f64> {
    /// Areas of the corners of a slave face that is covered as a whole, by its undeformed area at the
    /// nodes [L2].
    pub fn corner_areas(&self, measure: &[f64; MOST_NODES]) -> [f64; MOST_CORNERS] {
        let mut areas = [0.0; MOST_CORNERS];
        let count = corners(self.count);
        self.each_place(measure, |area, here, _| {
            let own = shapes(count, here).value;
            areas.iter_mut().zip(own).for_each(|(sum, by)| *sum += by * area);
        });
        areas
    }

    /// Calls with area, coordinates and shape functions of places all over a face, by its undeformed
    /// area at the nodes [L2].
    pub fn each_place(
        &self,
        measure: &[f64; MOST_NODES],
        mut call: impl FnMut(f64, [f64; 2], &[f64; MOST_NODES]),
    ) {
        let count = corners(self.count);
        for second in 1..count - 1 {
            let at = [0, second, second + 1].map(|k| place_of(count, k));
            let twice = flat_cross(flat_sub(at[1], at[0]), flat_sub(at[2], at[0]));
            for &[b, c, weight] in TWELVE {
                let here = flat_add(at[0], b, flat_sub(at[1], at[0]));
                let here = flat_add(here, c, flat_sub(at[2], at[0]));
                let own = self.shapes(here).value;
                let of_node = measure.iter().zip(own);
                let area = weight * twice * of_node.map(|(own, by)| own * by).sum::<f64>();
                call(area, here, &own);
            }
        }
    }
}

/// The coordinates of a piece of so many corners where its shape functions have these values.
fn place_upon<R: Real>(corners: usize, value: &[R; MOST_NODES]) -> [R; 2] {
    let blended = |axis: usize| {
        let of = value.iter().take(corners).enumerate();
        of.fold(R::from_f64(0.0), |sum, (k, &by)| {
            sum + by * R::from_f64(place_of(corners, k)[axis])
        })
    };
    [blended(0), blended(1)]
}

/// The place of a face on the line through `from` along `normal`, near the face; `None` where there
/// is none.
pub(super) fn meet<R: Real>(
    face: &FacePlaces<R>,
    from: Place<R>,
    normal: Place<R>,
) -> Option<Met<R>> {
    let value = |place: Place<R>| place.map(|x| x.value());
    let start = meet_by_value(&face.values(), value(from), value(normal))?;
    let at = start.map(R::from_f64);
    // from the value to its derivatives
    let at = flat_sub(at, step(face, from, normal, at).by);
    let own = face.shapes(at);
    let along = own.slope.map(|slope| face.blend(&slope));
    let gap = dot(sub(face.blend(&own.value), from), normal);
    Some(Met { shapes: own, along, gap })
}

fn meet_by_value(face: &FacePlaces<f64>, from: Place<f64>, normal: Place<f64>) -> Option<[f64; 2]> {
    let mut at = middle(face.count);
    // places far from the origin round, and the last steps with them
    let far = face.nodes[..face.count].iter().chain([&from]).flatten();
    let rounding = ROUNDINGS * f64::EPSILON * far.fold(0.0_f64, |most, x| most.max(x.abs()));
    for _ in 0..MOST_STEPS {
        let Step { tangents, across, by } = step(face, from, normal, at);
        if across == 0.0 || !by[0].is_finite() || !by[1].is_finite() {
            return None;
        }
        at = flat_sub(at, by);
        let walked = by[0].abs().max(by[1].abs());
        // a place that is off by its rounding is off by that over the height of the cell there
        let longest = tangents.into_iter().map(|own| dot(own, own)).fold(0.0, f64::max).sqrt();
        if walked <= FOUND.max(rounding * longest / across.abs()) {
            return Some(at);
        }
        if at[0].abs().max(at[1].abs()) > AWAY {
            return None;
        }
    }
    None
}

/// Newton's step towards a line.
struct Step<R> {
    /// Derivatives of the place by the coordinates of the cell [L].
    tangents: [Place<R>; 2],
    /// Their area across the line [L2].
    across: R,
    /// The step, to be taken off [1].
    by: [R; 2],
}

fn step<R: Real>(face: &FacePlaces<R>, from: Place<R>, normal: Place<R>, at: [R; 2]) -> Step<R> {
    let own = face.shapes(at);
    let tangents = own.slope.map(|slope| face.blend(&slope));
    let off = sub(face.blend(&own.value), from);
    let across = dot(cross(tangents[0], tangents[1]), normal);
    let by = [dot(cross(off, tangents[1]), normal), dot(cross(tangents[0], off), normal)];
    Step { tangents, across, by: by.map(|own| own / across) }
}

/// What `by` . d eta is by the vector that faced places move along: d eta . by = w . (d x - d y).
pub(super) fn lift<R: Real>(along: &[Place<R>; 2], normal: Place<R>, by: [R; 2]) -> Place<R> {
    let across = dot(cross(along[0], along[1]), normal);
    let first = scale(by[0], cross(along[1], normal));
    let whole = add_scaled(first, by[1], cross(normal, along[0]));
    scale(R::from_f64(1.0) / across, whole)
}

impl<R: Real> Couple<'_, R> {
    /// The overlap where it stands; `None` where a side has collapsed.
    pub(super) fn place(&self, overlap: &Overlap) -> Option<Placed<R>> {
        let plane = self.plane(overlap)?;
        let nothing = R::from_f64(0.0);
        let (one, by) = (R::from_f64(1.0), identity());
        let none = OnCell { at: [nothing; 2], along: nothing, slope: one, by };
        let mut vertices = [none; MOST];
        for (into, &corner) in vertices.iter_mut().zip(overlap.corners()) {
            *into = self.on_cell(overlap, corner, &plane)?;
        }
        Some(Placed { plane, vertices })
    }

    fn on_cell(&self, overlap: &Overlap, corner: Corner, plane: &Plane<R>) -> Option<OnCell<R>> {
        let piece = pieces(self.slave.count)[overlap.piece];
        let of_node = |k: usize| place_of(self.slave.count, piece[k % piece.len()]);
        let nothing = R::from_f64(0.0);
        let one = R::from_f64(1.0);
        let standing = |at: [R; 2], by| OnCell { at, along: nothing, slope: one, by };
        let upon = |edge: usize, along: R| {
            let [from, to] = [of_node(edge), of_node(edge + 1)];
            let way = flat_sub(to, from).map(R::from_f64);
            let (to, slope) = self.end_along(overlap, corner, (edge, along));
            OnCell { at: flat_add(from.map(R::from_f64), to, way), along, slope, by: identity() }
        };
        let (own, master) = self.pieces(overlap);
        let at = |k: usize| own.nodes[k % piece.len()];
        Some(match corner {
            Corner::Slave(k) => standing(of_node(k).map(R::from_f64), identity()),
            Corner::Master(k) => {
                let met = meet(&own, master.nodes[k], plane.normal)?;
                let upon = place_upon(piece.len(), &met.shapes.value);
                let (moved, by) = self.end_upon(overlap, corner, upon);
                let own = shapes::<R>(piece.len(), moved).value;
                let blended = |axis: usize| {
                    let of = own.iter().take(piece.len()).enumerate();
                    of.fold(nothing, |sum, (k, &by)| sum + by * R::from_f64(of_node(k)[axis]))
                };
                standing([blended(0), blended(1)], by)
            }
            Corner::Upon { edge, master: k } => {
                let (from, way) = (at(edge), sub(at(edge + 1), at(edge)));
                upon(edge, dot(sub(master.nodes[k], from), way) / dot(way, way))
            }
            Corner::Crossing { edge, master: [c, d] } => {
                let (from, way) = (at(edge), sub(at(edge + 1), at(edge)));
                let other = sub(master.nodes[d], master.nodes[c]);
                let off = dot(cross(sub(master.nodes[c], from), other), plane.normal);
                upon(edge, off / dot(cross(way, other), plane.normal))
            }
        })
    }

    /// Both pieces of an overlap.
    pub(super) fn pieces(&self, overlap: &Overlap) -> (FacePlaces<R>, FacePlaces<R>) {
        (self.slave.piece(overlap.piece), self.master.piece(overlap.master_piece))
    }

    /// Calls with every place of integration; false where one faces nothing.
    pub(super) fn stations(
        &self,
        overlap: &Overlap,
        placed: &Placed<R>,
        mut call: impl FnMut(&Station<R>),
    ) -> bool {
        let is_flat = self.slave.count == 3 && self.master.count == 3;
        let rule = if is_flat { THREE } else { TWELVE };
        for second in 1..overlap.corners().len() - 1 {
            let triangle = [0, second, second + 1];
            let at = triangle.map(|k| placed.vertices[k].at);
            let twice = flat_cross(flat_sub(at[1], at[0]), flat_sub(at[2], at[0]));
            for &[b, c, weight] in rule {
                let fractions = [1.0 - b - c, b, c];
                let here =
                    fractions.iter().zip(at).fold([R::from_f64(0.0); 2], |sum, (&fraction, at)| {
                        flat_add(sum, R::from_f64(fraction), at)
                    });
                let Some(station) = self.station(here, placed.plane.normal) else {
                    return false;
                };
                let weight = overlap.counts * weight;
                call(&Station { triangle, fractions, weight, twice, ..station });
            }
        }
        true
    }

    fn station(&self, at: [R; 2], normal: Place<R>) -> Option<Station<R>> {
        let slave = self.slave.shapes(at);
        let nothing = R::from_f64(0.0);
        let measured = |by: &[R; MOST_NODES]| {
            let of = self.measure.iter().zip(by);
            of.fold(nothing, |sum, (&own, &by)| sum + by * R::from_f64(own))
        };
        Some(Station {
            triangle: [0; 3],
            fractions: [0.0; 3],
            weight: 0.0,
            twice: nothing,
            corners: shapes(corners(self.slave.count), at),
            measure: measured(&slave.value),
            measure_slope: [measured(&slave.slope[0]), measured(&slave.slope[1])],
            along: slave.slope.map(|slope| self.slave.blend(&slope)),
            met: meet(self.master, self.slave.blend(&slave.value), normal)?,
            slave,
        })
    }
}

impl Couple<'_, f64> {
    /// Calls with area, shape functions of the slave, gap and shape functions of the master of places
    /// over an overlap.
    pub fn each_meeting(
        &self,
        overlap: &Overlap,
        mut call: impl FnMut(f64, &[f64; MOST_NODES], f64, &[f64; MOST_NODES]),
    ) {
        let Some(placed) = self.place(overlap) else { return };
        self.stations(overlap, &placed, |own| {
            let area = own.weight * own.twice * own.measure;
            call(area, &own.slave.value, own.met.gap, &own.met.shapes.value);
        });
    }

    /// The smallest gap at the corners of an overlap, which between flat faces is the smallest of all
    /// [L]; `None` where one of them faces nothing.
    pub fn least_gap(&self, overlap: &Overlap) -> Option<f64> {
        let placed = self.place(overlap)?;
        let mut corners = placed.vertices[..overlap.corners().len()].iter();
        corners.try_fold(f64::INFINITY, |least, corner| {
            let from = self.slave.blend(&self.slave.shapes(corner.at).value);
            Some(meet(self.master, from, placed.plane.normal)?.gap.min(least))
        })
    }
}

impl<R: Real> Station<R> {
    /// What a corner's function, weighted, is there: its part of the area [L2].
    pub fn share(&self, corner: usize) -> R {
        R::from_f64(self.weight) * self.twice * self.measure * self.corners.value[corner]
    }

    /// Values of the corners blended by their functions, and the derivatives of that.
    pub fn blend(&self, of: &[R; MOST_CORNERS]) -> (R, [R; 2]) {
        let sum = |by: &[R; MOST_NODES]| {
            let own = of.iter().zip(by);
            own.fold(R::from_f64(0.0), |sum, (&of, &by)| sum + of * by)
        };
        (sum(&self.corners.value), [sum(&self.corners.slope[0]), sum(&self.corners.slope[1])])
    }
}
