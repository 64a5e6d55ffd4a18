//! The physics of one stencil: elements, sections, materials, contact, rigid maps.
//!
//! ```text
//!   displacements of a few nodes            force and tangent of the same dofs
//!        q  ------------------>  energy, gap, law  ------------------>  r, K
//! ```
//!
//! Arrays in, arrays out: no node numbers, no global dofs, no text, no state kept between calls.
//! An element is its strain energy, a gap its formula, a law its expression. Where speed asks for
//! it closed-form derivatives stand beside the formula and are tested against it.
//!
//! Dimension tags in brackets: F force, L length, T time, theta temperature, 1
//! dimensionless.

// Dimension tags such as [L] are no links.
#![allow(rustdoc::broken_intra_doc_links)]

pub mod axes;
pub mod best_fit;
pub mod contact;
pub mod differentiate;
pub mod element;
pub mod face_turn;
pub mod first_order;
pub mod frame_turn;
pub mod kept_shape;
pub mod material;
pub mod orientation;
pub mod pressure;
pub mod rigid;
pub mod rotation;
pub mod section;
pub mod section_load;
pub mod surface;
pub mod traction;
pub mod turn;
pub mod turning;
pub mod vector;
pub mod volume;
