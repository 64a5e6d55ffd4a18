//! Closed forms, their limits and sources.

mod citations;
mod exact;
mod limits;
mod linear;
