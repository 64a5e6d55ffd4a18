//! Reference cells: what an element is made of before any physics.
//!
//! ```text
//!   point   1-----2   1--2--3    4-----3      3        4          6      8-----7
//!     o      line2     line3     |     |     / \      /|\        /|\    /|    /|
//!                                1-----2    1---2    1-|-3      4---5  5-----6 |
//!                                 quad4     tri3      \|/       | 3 |  | 4---|-3
//!                                                      2        1---2  1-----2
//!                                                     tet4      wedge6   hex8
//! ```
//!
//! Numbers of nodes, faces and integration points count from 1 in decks and from 0 here. Node and
//! face numbers are those of Abaqus; areas and volumes have a positive Jacobian.

mod areas;
mod cube;
mod line;
mod reference;
mod simplex;
mod volumes;
mod wedge;
mod within;

pub use areas::{QUAD4, QUAD8, TRI3, TRI6};
pub use line::{LINE2, LINE3, POINT, line3_shapes, line3_slopes};
pub use reference::{Cell, Piece};
pub use volumes::{HEX8, HEX20, TET4, TET10, WEDGE6, WEDGE15};
pub use within::{Within, within};

#[cfg(test)]
mod tests;
