//! Which faces of a master may a slave node meet? Those that look at one of its own faces.
//!
//! ```text
//!        |  slave  |          the corner's own faces look down and to the right: it meets the
//!        |_________o          top of the master, whose side looks to the right too
//!        |         |
//!        | master  |
//! ```
//!
//! docs/theory.md section 5.14. (derived)

use crate::vector::{Vector, dot, size};

/// Faces of a node that are remembered.
const MOST: usize = 12;
/// Cosine of the angle by which a face may be turned away from all that a node's faces look at, and
/// still be met: 60 degrees.
const TURNED: f64 = 0.5;
/// Part of a face by which a node may stand beyond a sharp edge of the master and meet it still, of
/// the master's face or of its own, whichever is smaller [1].
pub const BEYOND: f64 = 0.1;
/// Part of what lies behind a face by which a node may have sunk in beside its edge [1].
pub const SUNK: f64 = 0.5;

/// The unit normals of the faces about a slave node, and their size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outlook {
    normals: [Vector; MOST],
    count: usize,
    sizes: f64,
}

impl Outlook {
    /// That of a node whose faces are not known: it may meet all.
    pub const EVERYWHERE: Self = Self { normals: [[0.0; 3]; MOST], count: 0, sizes: 0.0 };

    /// What is known, or else that everything may be met.
    pub fn of(known: &Option<Self>) -> &Self {
        known.as_ref().unwrap_or(&Self::EVERYWHERE)
    }

    /// Adds a face by its normal, of any length, and its size [L].
    pub fn add(&mut self, normal: Vector, own: f64) {
        let length = size(normal);
        if length > 0.0 && self.count < MOST {
            self.normals[self.count] = normal.map(|x| x / length);
            self.count += 1;
            self.sizes += own;
        }
    }

    /// The same with all directions turned.
    pub fn turned(mut self, turn: impl Fn(Vector) -> Vector) -> Self {
        for normal in &mut self.normals[..self.count] {
            *normal = turn(*normal);
        }
        self
    }

    /// Whether no face is known.
    pub fn is_everywhere(&self) -> bool {
        self.count == 0
    }

    /// Mean size of the faces [L].
    pub fn size(&self) -> f64 {
        self.sizes / self.count.max(1) as f64
    }

    /// Whether a face of the master with that unit normal looks at one of the node's faces, or at
    /// what lies between two of them.
    pub fn meets(&self, normal: Vector) -> bool {
        if self.is_everywhere() {
            return true;
        }
        let own = &self.normals[..self.count];
        let against = |n: &Vector| -dot(*n, normal);
        let nearest = own.iter().map(against).fold(f64::NEG_INFINITY, f64::max);
        nearest > TURNED
            || own.iter().enumerate().any(|(k, a)| {
                own[..k].iter().any(|b| between(dot(*a, *b), [against(a), against(b)]) > TURNED)
            })
    }
}

/// Cosine of the angle of a direction to the nearest one between two unit vectors of cosine `c`, by
/// its cosines to both; -1 where that is one of them.
fn between(c: f64, [p, q]: [f64; 2]) -> f64 {
    let whole = 1.0 - c * c;
    let (s, t) = (p - c * q, q - c * p);
    if whole <= 1e-12 || s <= 0.0 || t <= 0.0 {
        return -1.0;
    }
    ((p * s + q * t) / whole).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(normals: &[Vector]) -> Outlook {
        let mut outlook = Outlook::EVERYWHERE;
        normals.iter().for_each(|&normal| outlook.add(normal, 2.0));
        outlook
    }

    /// Requirement: a corner meets what looks at one of its faces or between them, and not what
    /// looks the same way as one of them.
    #[test]
    fn a_corner_meets_what_looks_at_it() {
        let corner = of(&[[0.0, -3.0, 0.0], [0.5, 0.0, 0.0]]);
        assert!(corner.meets([0.0, 1.0, 0.0]) && corner.meets([-1.0, 0.0, 0.0]));
        assert!(corner.meets([-0.6, 0.8, 0.0]));
        assert!(!corner.meets([1.0, 0.0, 0.0]) && !corner.meets([0.0, -1.0, 0.0]));
        assert!(!corner.meets([0.0, 0.0, 1.0]));
        assert!((corner.size() - 2.0).abs() < 1e-15);
    }

    /// Requirement: the tip of a wedge meets what it points at, though its faces hardly look there.
    #[test]
    fn a_tip_meets_what_it_points_at() {
        let tip = of(&[[1.0, -0.2, 0.0], [-1.0, -0.2, 0.0]]);
        assert!(tip.meets([0.0, 1.0, 0.0]) && !tip.meets([0.0, -1.0, 0.0]));
        assert!(Outlook::EVERYWHERE.meets([0.0, -1.0, 0.0]));
    }
}
