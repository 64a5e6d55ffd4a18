//! The bench, its exchange and its server.

mod bench;
mod exchange;
mod found;
mod loads;
mod server;
