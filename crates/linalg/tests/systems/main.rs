//! Linear systems: solutions, orders, systems from outside.

#[path = "../common/mod.rs"]
mod common;
mod external;
mod solve;
