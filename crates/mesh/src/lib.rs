//! Meshes that gmsh and other programs wrote, and the decks that are made of them.
//!
//! ```text
//!   mesh.msh (2.2, 4.1 ASCII) --+
//!   mesh.inp -------------------+--> Mesh { nodes, cells, groups } --> deck
//!                                           Wishes --------------------'
//! ```
//!
//! Reading reports the first thing that is wrong, with its line: behind it a mesh file has no
//! meaning.

mod corners;
mod deck;
mod fault;
mod inp;
mod lines;
mod mesh;
mod msh;
mod names;
mod parts;
mod shapes;
mod wishes;

pub use deck::deck;
pub use mesh::{Cell, Group, Mesh};
pub use wishes::Wishes;

use slideline_diag::{Diagnostic, Sources};

/// Reads a mesh: the format is told by the first characters of the text.
///
/// # Errors
/// SL0831 where the text is no mesh, or is damaged.
pub fn read(sources: &mut Sources, name: &str, bytes: &[u8]) -> Result<Mesh, Box<Diagnostic>> {
    if bytes.trim_ascii_start().starts_with(b"$") {
        msh::read(sources, name, bytes)
    } else {
        inp::read(sources, name, bytes)
    }
}
