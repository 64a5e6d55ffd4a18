//! Result files read back.

pub(crate) mod history;
pub mod problem;
pub(crate) mod state;
pub(crate) mod summary;
pub(crate) mod table;
