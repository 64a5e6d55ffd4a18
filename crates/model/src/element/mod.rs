//! Elements: their types, a row of the table each, and the blocks that hold them.

mod beams;
pub(crate) mod block;
pub(crate) mod element_type;
mod kernels;
pub(crate) mod other_names;
pub(crate) mod section;
mod solids;
mod space_beams;
mod springs;
pub(crate) mod table;
mod trusses;
