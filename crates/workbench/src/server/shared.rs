//! What all connections of a server share.

use super::door::Door;
use crate::bench::Bench;
use std::path::PathBuf;
use std::sync::atomic::AtomicUsize;

/// Makes a bench for every page that is opened.
pub type Benches = Box<dyn Fn() -> Bench + Send + Sync>;

/// What all connections share.
pub(super) struct Shared {
    /// Who may come in.
    pub door: Door,
    /// Makes their benches.
    pub benches: Benches,
    /// Where files are written.
    pub folder: PathBuf,
    /// Connections that are open.
    pub open: AtomicUsize,
}
