//! Ends and creases of surfaces, face by face.
//!
//! ```text
//!    o-----o-----o
//!    |     |     #      an edge behind which there is no face of the surface, or one that turns
//!    o-----o-----#      away sharply, is an end; so are its nodes
//! ```

use super::shapes::{MOST_CORNERS, MOST_NODES};

/// Where a face is at an end of its surface or at a crease of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FaceEnds {
    /// Its edges that are; each begins at the corner of its number.
    pub edges: [bool; MOST_CORNERS],
    /// Its nodes that are.
    pub nodes: [bool; MOST_NODES],
}

/// Where a slave face and what it faces are at ends of their surfaces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Ends {
    /// The face of the slave.
    pub slave: FaceEnds,
    /// That of the master.
    pub master: FaceEnds,
}
