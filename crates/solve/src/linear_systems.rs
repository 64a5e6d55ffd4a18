//! Linear systems of the embedding program.

use rayon::ThreadPool;
use slideline_linalg::{Analyse, BuiltIn, OnThreads};
use std::fmt;
use std::sync::Arc;

/// The factory of linear systems of a run: that of this program, or one that
/// the embedding program brings (of many processes, say).
#[derive(Clone, Default)]
pub struct LinearSystems(Option<Arc<dyn Analyse>>);

impl LinearSystems {
    /// Systems of the embedding program.
    pub fn external(factory: Arc<dyn Analyse>) -> Self {
        Self(Some(factory))
    }

    /// The same, those of this program sharing their work among the threads of a pool.
    pub(crate) fn on_threads(&self, pool: Option<&Arc<ThreadPool>>) -> Self {
        match (&self.0, pool) {
            (None, Some(pool)) => Self::external(Arc::new(OnThreads { pool: pool.clone() })),
            _ => self.clone(),
        }
    }

    /// What makes the systems.
    pub fn factory(&self) -> &dyn Analyse {
        match &self.0 {
            Some(factory) => factory.as_ref(),
            None => &BuiltIn { back_end: None },
        }
    }
}

impl fmt::Debug for LinearSystems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0.is_some() { "External" } else { "BuiltIn" })
    }
}

/// Equal are those that share one factory, and all of this program.
impl PartialEq for LinearSystems {
    fn eq(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Some(own), Some(other)) => Arc::ptr_eq(own, other),
            (own, other) => own.is_none() && other.is_none(),
        }
    }
}
