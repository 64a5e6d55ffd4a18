//! What a slave point faces of its master.

use slideline_mech::contact::search::chain::Piece;
use slideline_mech::contact::search::faces::FacePlace;
use slideline_mech::contact::search::rigid;

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
