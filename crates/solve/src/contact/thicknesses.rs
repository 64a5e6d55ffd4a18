//! How thick the parts of pairs are, in the plane: what `parts` measures.
//!
//! ```text
//!     o--v--o--v--o      a number behind every face
//!     |  .  |  .  |
//! ```

/// What is behind a face of a part.
#[derive(Clone, Copy, Debug)]
pub struct Behind {
    /// How thick the part is there [L]; infinite where nothing is known.
    pub thickness: f64,
    /// Whether the face at which it ends there is of the same surface.
    pub has_far_side: bool,
}

/// Part of a thickness by which another one may differ by rounding [1].
const AS_THICK: f64 = 1e-9;

impl Behind {
    pub(super) const UNKNOWN: Self = Self { thickness: f64::INFINITY, has_far_side: false };

    /// The thicker one; of two as thick, but for rounding, the far side is that of both.
    pub(super) fn or_thicker(self, other: Self) -> Self {
        let thicker = if other.thickness > self.thickness { other } else { self };
        let apart = (other.thickness - self.thickness).abs();
        match apart <= AS_THICK * thicker.thickness {
            true => Self { has_far_side: self.has_far_side && other.has_far_side, ..thicker },
            false => thicker,
        }
    }
}

/// How thick the parts of pairs are [L]; infinite where nothing is known.
#[derive(Clone, Debug, Default)]
pub struct Thicknesses {
    /// Behind the faces of every point that is spread over faces.
    pub(super) of_points: Vec<f64>,
    /// Behind the faces of slaves that meet their masters at nodes.
    pub(super) of_slaves: Vec<Behind>,
    /// Behind the segments of every master.
    pub(super) of_masters: Vec<Vec<Behind>>,
}

impl Thicknesses {
    /// Behind the faces of a point [L].
    pub fn of_point(&self, place: usize) -> f64 {
        self.of_points.get(place).copied().unwrap_or(f64::INFINITY)
    }

    /// Behind a face of a slave that meets its master at nodes.
    pub fn of_slave(&self, face: usize) -> Behind {
        self.of_slaves.get(face).copied().unwrap_or(Behind::UNKNOWN)
    }

    /// Behind a segment of a master, by its place among those of the master itself.
    pub fn of_master(&self, pair: usize, segment: usize) -> Behind {
        let own = self.of_masters.get(pair).and_then(|own| own.get(segment));
        own.copied().unwrap_or(Behind::UNKNOWN)
    }
}
