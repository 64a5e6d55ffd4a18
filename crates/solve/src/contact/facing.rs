//! What a slave point faces of its master.

use slideline_mech::contact::search::chain::{Piece, PieceKind};
use slideline_mech::contact::search::faces::FacePlace;
use slideline_mech::contact::search::rigid;

/// Where a point stands, and on what it did.
#[derive(Clone, Copy, Debug)]
pub struct Standing {
    /// Its place [L].
    pub at: [f64; 3],
    /// The segment of the line of master nodes, or of the rigid surface, on which it stood.
    pub on: Option<usize>,
}

impl Standing {
    /// A point that stood nowhere before.
    pub fn anew(at: [f64; 3]) -> Self {
        Self { at, on: None }
    }
}

/// What a point faces of its master.
#[derive(Clone, Copy, Debug)]
pub enum Facing {
    /// A part of a rigid surface.
    Surface(rigid::Facing),
    /// A piece of a chain.
    Piece(Piece),
    /// A place of a face.
    Face(FacePlace),
    /// Two edges that cross.
    Edges([usize; 2]),
}

impl Facing {
    /// The segment of a line of nodes or of a rigid surface that it is, or the curve in its place.
    pub fn segment(&self) -> Option<usize> {
        match self {
            Self::Surface(facing) => {
                (facing.part == rigid::Part::Interior).then_some(facing.segment)
            }
            Self::Piece(piece) => {
                let goes_along =
                    matches!(piece.kind, PieceKind::Straight | PieceKind::Curve { .. });
                goes_along.then_some(piece.index)
            }
            _ => None,
        }
    }
}
