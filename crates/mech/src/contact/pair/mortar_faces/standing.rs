//! Normal and tangential directions of a slave node.
//!
//! ```text
//!          n                 n: across the edges of all faces that meet at the node
//!     .----o---> t1          t: those of the last commit, turned with n the shortest way
//!     |   /                  and, once committed, with the surface in its plane
//! ```
//!
//! docs/theory.md eqs. (5.18) and (5.37)

use super::super::super::gap::face::{Turned, directions_across};
use super::super::super::search::faces::FacePlace;
use super::super::faces::{Footing, bearing, borne};
use crate::surface::axes::{self, Bearing};
use crate::vector::Vector;

/// How a slave node stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Standing {
    turned: Turned,
    /// How it would stand, were this committed; its normal is the outward one of the master.
    pub footing: Footing,
}

impl Standing {
    /// A node with this normal, from the master to the slave, and an edge of the slave that leaves
    /// it; `axis`: how axis 1 of the surface stands to that edge, where friction has coefficients along
    /// the axes; `before`: how it stood at the last commit. `None` where the edge is along the normal.
    pub fn new(
        normal: Vector,
        (edge, axis): (Vector, Option<Bearing>),
        before: Option<&Footing>,
    ) -> Option<Self> {
        let kept = before.and_then(|before| {
            Some((before, Turned::new(before.normal, before.directions(), normal)?))
        });
        let (turned, direction) = match kept {
            Some((before, turned)) => {
                (turned, borne(before, edge, normal).unwrap_or(turned.directions[0]))
            }
            None => {
                let near = axis.map_or(edge, |bearing| axes::axis(bearing, edge, normal));
                let turned = Turned::new(normal, directions_across(normal, near), normal)?;
                (turned, turned.directions[0])
            }
        };
        let place = FacePlace::default();
        let footing = Footing { place, normal, direction, bearing: [1.0, 0.0] };
        let bearing = bearing(&footing, edge);
        let is_sound = direction.iter().all(|x| x.is_finite());
        is_sound.then_some(Self { turned, footing: Footing { bearing, ..footing } })
    }

    /// Tangential directions [1].
    pub fn directions(&self) -> [Vector; 2] {
        self.turned.directions
    }

    /// The vector z with m . d t_k = z . d n.
    pub fn pull(&self, direction: usize, by: Vector) -> Vector {
        self.turned.pull(direction, by)
    }
}
