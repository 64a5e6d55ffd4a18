//! The piece of a chain that a slave node faces about a sharp edge.
//!
//! ```text
//!                x  node, its face looks down       the nearest piece is the side, or the smoothed
//!     ----------.       . . . .                     corner; the node faces the top, which is
//!      master    |   BEYOND                         prolonged a little for it
//! ```
//!
//! docs/theory.md section 5.14. (derived)

use super::chain::{Chain, Piece, PieceKind, flat};
use super::nearest::Nearby;
use super::outlook::{BEYOND, Outlook, SUNK};
use super::{INSIDE, Point, cross, dot, project_line, project_quadratic, sub};
use crate::vector::Vector;

/// Turn from which on a node of a chain is a sharp edge [rad].
const SHARP: f64 = 50.0 * std::f64::consts::PI / 180.0;

/// The piece of a chain at these positions that a slave node at `point` faces: the nearest one
/// ([`Chain::closest`]), or at a ridge the segment `before`, on which it stood, or, about a sharp edge, the one on that side of it which looks at the node.
pub fn closest(
    chain: &Chain,
    positions: &[[f64; 3]],
    nearby: Nearby<'_>,
    (point, before, outlook): ([f64; 3], Option<usize>, &Outlook),
) -> Option<Piece> {
    let found = chain.closest(positions, nearby, point)?;
    let kept = before.and_then(|part| chain.kept(positions, flat(point), (&found, part)));
    let found = kept.unwrap_or(found);
    if outlook.is_everywhere() {
        return Some(found);
    }
    let about = About { chain, positions, point: flat(point), outlook };
    Some(about.other_side(&found).unwrap_or(found))
}

/// Whether a chain through these positions has a sharp edge.
pub fn is_sharp(mut positions: impl Iterator<Item = [f64; 3]>) -> bool {
    let (Some(first), Some(second)) = (positions.next(), positions.next()) else { return false };
    let mut last = [first, second];
    positions.any(|next| {
        let [before, here] = last;
        last = [here, next];
        turns_away(sub(flat(here), flat(before)), sub(flat(next), flat(here)))
    })
}

/// Whether an edge between these two ways is a sharp one; the outside is on their left.
pub(super) fn turns_away(before: Point, behind: Point) -> bool {
    cross(before, behind).atan2(dot(before, behind)) < -SHARP
}

/// How far the nose at an edge reaches beyond it [L], and what part that is of the segments before and
/// behind it, all undeformed.
pub fn reach(chain: &Chain, node: usize) -> (f64, [f64; 2]) {
    let [before, behind] = [node.saturating_sub(1), node].map(|part| chain.reference_length(part));
    let way = BEYOND * before.min(behind).min(chain.slave);
    (way, [way / before, way / behind])
}

/// Whether a chain turns away sharply at a node between its ends; the outside is on its left.
fn is_edge(positions: &[[f64; 3]], node: usize) -> bool {
    if node == 0 || node + 1 >= positions.len() {
        return false;
    }
    turns_away(along(positions, node - 1), along(positions, node))
}

fn along(positions: &[[f64; 3]], part: usize) -> Point {
    sub(flat(positions[part + 1]), flat(positions[part]))
}

fn length(way: Point) -> f64 {
    way[0].hypot(way[1])
}

/// A slave node about a chain.
struct About<'a> {
    chain: &'a Chain,
    positions: &'a [[f64; 3]],
    point: Point,
    outlook: &'a Outlook,
}

impl About<'_> {
    /// Whether a part looks at the node.
    fn meets(&self, part: usize) -> bool {
        let [x, y] = along(self.positions, part);
        let whole = x.hypot(y);
        let normal: Vector = [-y / whole, x / whole, 0.0];
        self.outlook.meets(normal)
    }

    /// The straight part beyond a sharp edge that looks at the node, where the piece that was found
    /// does not.
    fn other_side(&self, found: &Piece) -> Option<Piece> {
        let node = found.index;
        match found.kind {
            PieceKind::Corner if !is_edge(self.positions, node) => None,
            PieceKind::Corner => match (self.meets(node - 1), self.meets(node)) {
                (true, false) => self.part(node - 1, node),
                (false, true) => self.part(node, node),
                _ => None,
            },
            PieceKind::Nose { .. } => None,
            PieceKind::Straight | PieceKind::Curve { .. } if self.meets(found.index) => None,
            PieceKind::Straight | PieceKind::Curve { .. } => {
                let sides = [self.edge(found.index, false), self.edge(found.index, true)];
                let found = sides.into_iter().flatten();
                let nearer = |a: &(f64, Piece), b: &(f64, Piece)| a.0.total_cmp(&b.0);
                found.min_by(nearer).map(|(_, piece)| piece)
            }
        }
    }

    /// The part behind the next sharp edge on the way from a part, and its distance: where the node
    /// has sunk in no deeper than half of that side.
    fn edge(&self, from: usize, ahead: bool) -> Option<(f64, Piece)> {
        let next = |part: usize| match ahead {
            true => Some(part + 1).filter(|part| part + 1 < self.positions.len()),
            false => part.checked_sub(1),
        };
        let mut part = from;
        let (node, other) = loop {
            let node = if ahead { part + 1 } else { part };
            let behind = next(part)?;
            if is_edge(self.positions, node) {
                break (node, behind);
            }
            part = behind;
        };
        if !self.meets(other) {
            return None;
        }
        let piece = self.part(other, node)?;
        let distance = self.distance(other);
        (distance <= SUNK * self.side(part, ahead)).then_some((distance, piece))
    }

    /// Length of a side from the sharp edge that its part ends at, `ahead` or before, to the other
    /// one [L].
    fn side(&self, part: usize, ahead: bool) -> f64 {
        let (mut part, mut sum) = (part, length(along(self.positions, part)));
        loop {
            let node = if ahead { part } else { part + 1 };
            if is_edge(self.positions, node) || node == 0 || node + 1 == self.positions.len() {
                return sum;
            }
            part = if ahead { part - 1 } else { part + 1 };
            sum += length(along(self.positions, part));
        }
    }

    /// Distance of the node from the line of a part [L].
    fn distance(&self, part: usize) -> f64 {
        let along = along(self.positions, part);
        cross(along, sub(self.point, flat(self.positions[part]))).abs() / length(along)
    }

    /// A straight part, prolonged a little beyond the edge at a node of it, or the nose behind that,
    /// where the slave node faces it.
    fn part(&self, part: usize, edge: usize) -> Option<Piece> {
        let (a, b) = (flat(self.positions[part]), flat(self.positions[part + 1]));
        let parameter = project_line(a, b, self.point)?;
        if self.distance(part) > SUNK * length(sub(b, a)) {
            return None;
        }
        let straight = Piece { index: part, kind: PieceKind::Straight, parameter };
        let ahead = edge != part;
        let (outside, other) =
            if ahead { (parameter - 1.0, parameter) } else { (-parameter, 1.0 - parameter) };
        if outside <= 0.0 {
            return (other >= -INSIDE).then_some(straight);
        }
        let (_, fractions) = reach(self.chain, edge);
        if outside <= fractions[usize::from(!ahead)] {
            return Some(straight);
        }
        let nose = self.nose(edge, fractions, ahead);
        let parameter = project_quadratic(&nose, self.point)?;
        Some(Piece { index: edge, kind: PieceKind::Nose { ahead }, parameter })
    }

    /// Control points of the nose at an edge: further along the segment that it prolongs, then down the
    /// other.
    fn nose(&self, node: usize, [before, behind]: [f64; 2], ahead: bool) -> [Point; 3] {
        let [a, x, b] = [node - 1, node, node + 1].map(|node| flat(self.positions[node]));
        let on = [0, 1].map(|c| before * (x[c] - a[c]));
        let down = [0, 1].map(|c| behind * (b[c] - x[c]));
        let at = |s: f64, t: f64| [0, 1].map(|c| x[c] + s * on[c] + t * down[c]);
        match ahead {
            true => [at(1.0, 0.0), at(2.0, 0.0), at(2.0, 1.0)],
            false => [at(-1.0, -2.0), at(0.0, -2.0), at(0.0, -1.0)],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A block 2 wide and 1 high, travelled over its top; the outside is on the left.
    const BLOCK: [[f64; 3]; 4] =
        [[0.0, -1.0, 0.0], [0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, -1.0, 0.0]];

    fn facing(at: [f64; 2], normals: &[Vector]) -> Option<(usize, PieceKind)> {
        let mut chain = Chain::new(&BLOCK, Some(0.2), 0.1)?;
        chain.slave = 1.0;
        let mut outlook = Outlook::EVERYWHERE;
        normals.iter().for_each(|&normal| outlook.add(normal, 1.0));
        let point = [at[0], at[1], 0.0];
        let found = closest(&chain, &BLOCK, Nearby::Positions, (point, None, &outlook))?;
        Some((found.index, found.kind))
    }

    /// Requirement: a corner that stands on an edge faces the top, prolonged, then its nose, then the
    /// side; one that stands beside faces the side; without faces the smoothed corner counts.
    #[test]
    fn a_corner_faces_the_top_that_it_stands_on() {
        let upon = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0]];
        let (top, nose) = ((1, PieceKind::Straight), (2, PieceKind::Nose { ahead: true }));
        assert_eq!(facing([2.0, -0.001], &upon), Some(top));
        assert_eq!(facing([2.05, -0.001], &upon), Some(top));
        assert_eq!(facing([2.15, -0.001], &upon), Some(nose));
        assert_eq!(facing([2.3, -0.5], &upon), Some((2, PieceKind::Straight)));
        let beside = [[0.0, -1.0, 0.0], [-1.0, 0.0, 0.0]];
        assert_eq!(facing([1.999, -0.4], &beside), Some((2, PieceKind::Straight)));
        assert_eq!(facing([2.0, -0.001], &[]), Some((2, PieceKind::Corner)));
        let left = [[0.0, -1.0, 0.0], [-1.0, 0.0, 0.0]];
        let other = (1, PieceKind::Nose { ahead: false });
        assert_eq!(facing([-0.15, -0.001], &left), Some(other));
    }

    /// Requirement: what lies deep beside a block is not drawn upon its top.
    #[test]
    fn what_stands_beside_stays_there() {
        let below = [[0.0, -1.0, 0.0]];
        assert_eq!(facing([2.01, -0.9], &below), Some((2, PieceKind::Straight)));
    }
}
