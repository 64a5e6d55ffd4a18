//! Who hears how far the study is.

use std::sync::atomic::{AtomicUsize, Ordering};

/// A piece of work that is done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Pieces done so far, this one included.
    pub done: usize,
    /// All pieces.
    pub total: usize,
    /// What was done.
    pub what: String,
}

/// Told of every piece of work that is done, from any thread.
pub type Tell<'a> = &'a (dyn Fn(&Progress) + Sync);

/// Counts pieces of work.
pub(crate) struct Count<'a> {
    done: AtomicUsize,
    total: usize,
    tell: Tell<'a>,
}

impl<'a> Count<'a> {
    pub fn new(total: usize, tell: Tell<'a>) -> Self {
        Self { done: AtomicUsize::new(0), total, tell }
    }

    pub fn tick(&self, what: String) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        (self.tell)(&Progress { done, total: self.total, what });
    }
}
