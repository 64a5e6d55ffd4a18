//! Solids, their materials and temperatures as they are compiled, against closed forms and differences.

mod heated;
mod hourglass;
mod orientation;
mod solids;
mod user_material;
