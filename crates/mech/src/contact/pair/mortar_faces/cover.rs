//! What faces a slave face.
//!
//! ```text
//!     ====o====         of several pieces on a line the nearest counts; where that one turns
//!      |  |  |          its back it hides what lies behind it, and what lies further behind
//!   o--+--+--+--o       the nearest part than the piece is long is left out
//! ```

use super::super::ends_within::{counts, fading};
use super::clip::{Overlap, Polygon, Window};
use super::ends::FaceEnds;
use super::face_places::FacePlaces;
use super::places::{dot, sub};
use super::places::{flat_cross, flat_sub};
use super::shapes::{MOST_CORNERS, MOST_NODES, edge_between, pieces};

/// Cosine of the angle between normals up to which a piece faces another one [1]; steeper ones hide
/// what is behind them.
const STEEP: f64 = 0.2;
/// The same from which on all counts. (choice)
const WHOLE: f64 = 2.0 * STEEP;
/// Lengths of the piece behind its nearest part at which the middle of a part counts less, and no more [1]: what leans
/// as far as all counts, and covers the whole piece, is not behind itself. (choice)
const FAR: [f64; 2] = [1.15, 1.75];
/// Cosine of that angle up to which a piece is seen at all [1]: from there on it is a line.
const EDGEWISE: f64 = 1e-3;
/// Parts of its own area that an overlap has in common with nearer ones from which on it counts less, and no more:
/// it is hidden [1]. (choice)
const HIDDEN: [f64; 2] = [0.25, 0.75];
/// Part of the thickness of the thinner part up to which a face may stand behind another one [1]: what is seen through
/// a part was not gone through; a little less than all of it, for parts are squeezed.
const WITHIN: f64 = 0.9;
/// Part of a piece by which the areas of overlaps may exceed it before any is hidden [1].
const ROUNDING: f64 = 1e-6;

/// A face that may face the slave.
#[derive(Debug, Clone, Copy)]
pub struct Faced {
    /// Its number.
    pub face: usize,
    /// Numbers of its nodes.
    pub nodes: [usize; MOST_NODES],
    /// Where it stands.
    pub places: FacePlaces<f64>,
    /// Where it is at an end of its surface.
    pub ends: FaceEnds,
    /// How thick its part is behind it [L].
    pub thickness: f64,
}

/// A slave face that looks for what it faces.
#[derive(Debug, Clone, Copy)]
pub struct Looking<'a> {
    /// Where it stands.
    pub places: &'a FacePlaces<f64>,
    /// Where it is at an end of its surface.
    pub ends: &'a FaceEnds,
    /// How thick its part is behind it [L].
    pub thickness: f64,
}

impl Faced {
    /// Numbers of its nodes.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes[..self.places.count]
    }
}

/// An overlap with its mean gap.
#[derive(Debug, Clone, Copy)]
struct Seen {
    overlap: Overlap,
    polygon: Polygon,
    gap: f64,
    /// How far it is from the slave where it is nearest [L].
    nearest: f64,
    faces: bool,
    /// How much of it nothing hides [1].
    shown: f64,
}

/// Where a piece of the slave is at an end of its surface.
struct PieceEnds {
    /// Its edges that are.
    edges: [bool; MOST_CORNERS],
    /// Its corners that are.
    corners: [bool; MOST_CORNERS],
}

impl PieceEnds {
    fn new(ends: &FaceEnds, count: usize, piece: usize) -> Self {
        let nodes = pieces(count)[piece];
        let is_end = |k: usize| {
            let next = nodes[(k + 1) % nodes.len()];
            edge_between(count, nodes[k], next).is_some_and(|edge| ends.edges[edge])
        };
        let of = |is: &dyn Fn(usize) -> bool| std::array::from_fn(|k| k < nodes.len() && is(k));
        Self { edges: of(&is_end), corners: of(&|k| ends.nodes[nodes[k]]) }
    }

    /// How far from one of the ends of a piece with these corners polygons reach at most, the end that they are
    /// nearest to [L]; infinite without ends.
    fn reach<'a>(
        &self,
        corners: &[[f64; 2]],
        polygons: impl Iterator<Item = &'a Polygon> + Clone,
    ) -> f64 {
        let farthest = |from_end: &dyn Fn([f64; 2]) -> f64| {
            let all = polygons.clone().flat_map(|own| own.places());
            all.map(|&at| from_end(at)).fold(0.0, f64::max)
        };
        let mut least = f64::INFINITY;
        for (k, &from) in corners.iter().enumerate() {
            let along = flat_sub(corners[(k + 1) % corners.len()], from);
            let length = along[0].hypot(along[1]);
            if self.edges[k] && length > 0.0 {
                let by_edge = |at| flat_cross(along, flat_sub(at, from)) / length;
                least = farthest(&by_edge).min(least);
            }
            if self.corners[k] {
                let by_corner = |at| {
                    let [x, y] = flat_sub(at, from);
                    x.hypot(y)
                };
                least = farthest(&by_corner).min(least);
            }
        }
        least
    }
}

/// The overlaps of a face, in a list that is used again.
#[derive(Debug, Clone, Default)]
pub struct Cover {
    seen: Vec<Seen>,
    /// Room for how much each of them counts [1].
    counts: Vec<f64>,
}

impl Cover {
    /// Adds the overlaps of a slave face with faces that may face it.
    pub fn find(&mut self, own: Looking<'_>, masters: &[Faced], overlaps: &mut Vec<Overlap>) {
        let Looking { places: slave, ends, thickness } = own;
        for piece in 0..pieces(slave.count).len() {
            let Some(window) = Window::new(slave, piece) else { continue };
            self.seen.clear();
            for (place, master) in masters.iter().enumerate() {
                for master_piece in 0..pieces(master.places.count).len() {
                    let thin = thickness.min(master.thickness);
                    self.see(
                        (piece, place, master_piece),
                        (slave, &window),
                        (&master.places, thin),
                    );
                }
            }
            self.leave_out_across(&window, &PieceEnds::new(ends, slave.count, piece));
            self.leave_out_far(&window);
            self.hide(&window);
            overlaps.extend(self.seen.iter().filter(|own| own.faces).map(|own| own.overlap));
        }
    }

    fn see(
        &mut self,
        (piece, place, master_piece): (usize, usize, usize),
        (slave, window): (&FacePlaces<f64>, &Window),
        (master, thin): (&FacePlaces<f64>, f64),
    ) {
        let Some(plane) = master.plane(master_piece) else { return };
        let across = dot(plane.normal, window.normal);
        if across.abs() < EDGEWISE {
            return;
        }
        let of_master = master.piece(master_piece);
        let cut = window.cut((piece, place, master_piece), &of_master);
        let Some((mut overlap, polygon)) = cut else { return };
        // from the plane of one piece to that of the other, in the middle of the polygon
        let (from, own) = (of_master.nodes[0], slave.piece(piece).nodes[0]);
        let gap_at = |at: [f64; 2]| {
            let upon = window.in_space(at);
            let height = dot(sub(own, upon), window.normal);
            dot(sub(from, upon), plane.normal) / across - height
        };
        let gap = gap_at(polygon.middle());
        let corners = polygon.places().iter().map(|&at| gap_at(at).abs());
        let nearest = corners.fold(gap.abs(), f64::min);
        let faces = across < -STEEP;
        let steep = if faces { (WHOLE + across) / (WHOLE - STEEP) } else { 0.0 };
        overlap.counts = fading(steep);
        if !(faces && gap < -WITHIN * thin) {
            self.seen.push(Seen { overlap, polygon, gap, nearest, faces, shown: 1.0 });
        }
    }

    /// Leaves out what lies along an end of the slave and is deeper than it is wide, with all that is about as deep:
    /// the end went in through another side of the master than the one that it faces from inside. From as deep as
    /// wide on it counts less and less.
    ///
    /// ```text
    ///         |  slave  |
    ///     ----o---------o----      the sides of the slave, sunk by rounding or by what is allowed,
    ///     |     master      |      would face those of the master from within: not contact
    /// ```
    fn leave_out_across(&mut self, window: &Window, ends: &PieceEnds) {
        let mut all = std::mem::take(&mut self.counts);
        let of = |own: &Seen| {
            let depth = -own.gap;
            if !own.faces || depth <= 0.0 {
                return 1.0;
            }
            let by = counts(depth, ends.reach(window.corners(), self.about_as_deep(own)));
            if by == 1.0 {
                return by;
            }
            let covered: f64 = self.about_as_deep(own).map(Polygon::area).sum();
            let is_whole = covered >= (1.0 - ROUNDING) * window.area;
            if is_whole { 1.0 } else { by }
        };
        all.clear();
        all.extend(self.seen.iter().map(of));
        for (own, &by) in self.seen.iter_mut().zip(&all) {
            own.overlap.counts *= by;
            own.overlap.went_in_elsewhere = by < 1.0;
        }
        self.seen.retain(|own| own.overlap.counts > 0.0);
        self.counts = all;
    }

    /// What the slave faces at half the depth of an overlap and more.
    fn about_as_deep(&self, own: &Seen) -> impl Iterator<Item = &Polygon> + Clone {
        let least = 0.5 * own.gap;
        self.seen.iter().filter(move |other| other.faces && other.gap <= least).map(|o| &o.polygon)
    }

    fn leave_out_far(&mut self, window: &Window) {
        let length = longest_way(window.corners());
        // nearest also at corners: a sliver that goes has the gap of what is beside it, and takes nothing with it
        let near = self.seen.iter().map(|own| own.nearest).fold(f64::INFINITY, f64::min);
        let far = self.seen.iter().map(|own| own.gap.abs()).fold(0.0, f64::max);
        let far = f64::min(far, near + FAR[1] * length);
        // what hardly counts does not say where the nearest part is
        let of = |own: &Seen| far + own.overlap.counts * (own.nearest - far);
        let nearest = self.seen.iter().map(of).fold(f64::INFINITY, f64::min);
        for own in &mut self.seen {
            let behind = (own.gap.abs() - nearest) / length;
            own.overlap.counts *= fading((behind - FAR[0]) / (FAR[1] - FAR[0]));
        }
        self.seen.retain(|own| own.overlap.counts > 0.0);
    }

    /// Leaves out what is behind nearer pieces; what is so in part counts less.
    fn hide(&mut self, window: &Window) {
        if self.is_one_sheet(window) {
            return;
        }
        self.seen.sort_by(|a, b| a.gap.abs().total_cmp(&b.gap.abs()));
        let mut kept = 0;
        for place in 0..self.seen.len() {
            let own = self.seen[place];
            // what is shown of pieces that are kept all but tiles what they cover, so that common areas may be added
            let nearer = self.seen[..kept].iter();
            let common = |other: &Seen| other.shown * own.polygon.common(&other.polygon);
            let hidden: f64 = nearer.map(common).sum();
            let part = hidden / own.polygon.area();
            let by = fading((part - HIDDEN[0]) / (HIDDEN[1] - HIDDEN[0]));
            if by > 0.0 {
                self.seen[kept] = own;
                self.seen[kept].shown = by;
                self.seen[kept].overlap.counts *= by;
                kept += 1;
            }
        }
        self.seen.truncate(kept);
    }

    /// Whether no piece can be behind another one: all face the slave, are about as far, and do not cover
    /// more than there is.
    fn is_one_sheet(&self, window: &Window) -> bool {
        let gaps = self.seen.iter().map(|own| own.gap.abs());
        let (near, far) =
            gaps.fold((f64::INFINITY, 0.0), |(near, far), own| (own.min(near), own.max(far)));
        let whole: f64 = self.seen.iter().map(|own| own.polygon.area()).sum();
        self.seen.iter().all(|own| own.faces)
            && far - near <= window.area.sqrt()
            && whole <= (1.0 + ROUNDING) * window.area
    }
}

/// The longest way between two of these corners [L].
fn longest_way(corners: &[[f64; 2]]) -> f64 {
    let ways = corners.iter().flat_map(|a| corners.iter().map(move |b| flat_sub(*a, *b)));
    ways.map(|[x, y]| x.hypot(y)).fold(0.0, f64::max)
}
