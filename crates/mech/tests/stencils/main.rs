//! Beams, trusses and contact of one stencil, against closed forms and differences.

mod beams;
mod contact;
mod derivatives;
mod lines;
mod mixed;
mod offset;
mod space_beams;
mod two_coefficients;
