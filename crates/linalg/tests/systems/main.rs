//! Linear systems: solutions, orders, systems from outside.
#![allow(clippy::unwrap_used)] // a test may fail where it stands

#[path = "../common/mod.rs"]
mod common;
mod external;
mod solve;
