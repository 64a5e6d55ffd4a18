//! Elements, materials and contact of one stencil, against closed forms and differences.

mod beams;
mod contact;
mod derivatives;
mod heated;
mod hourglass;
mod lines;
mod mixed;
mod offset;
mod orientation;
mod solids;
mod space_beams;
mod two_coefficients;
mod user_material;
