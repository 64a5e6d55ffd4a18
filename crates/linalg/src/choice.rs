//! Which of the factorisations of this crate a pattern gets.

use crate::banded::Banded;
use crate::error::SolveError;
use crate::multigrid::Multigrid;
use crate::ordering::Layout;
use crate::pattern::Pattern;
use crate::solver::Solver;
use crate::sparse::{LARGEST_BAND, Sparse};
use crate::system::{Analyse, BackEnd, Interface, Kind, LinearSystem};
use rayon::ThreadPool;
use std::sync::Arc;

/// Banded factorisations with fewer operations are not worth a second analysis.
const SMALL: f64 = 2e6;

/// Multiplications with additions in a second where fronts are large (measured).
const LARGE_FRONTS: f64 = 2e10;

/// The factorisations of this crate, chosen by the predicted time; or one of them.
#[derive(Clone, Copy, Debug, Default)]
pub struct BuiltIn {
    /// The back end wanted; none: the one that is predicted to be faster.
    pub back_end: Option<BackEnd>,
}

impl Analyse for BuiltIn {
    fn analyse(&self, pattern: &Pattern, kind: Kind) -> Result<Box<dyn LinearSystem>, SolveError> {
        Ok(self.choose(pattern, kind, &Interface::default(), None))
    }

    fn analyse_for(
        &self,
        pattern: &Pattern,
        kind: Kind,
        interface: &Interface<'_>,
    ) -> Result<Box<dyn LinearSystem>, SolveError> {
        Ok(self.choose(pattern, kind, interface, None))
    }
}

/// The factorisations of this crate, chosen likewise, whose work the threads of a pool share. The
/// results have the bits of those without.
#[derive(Clone, Debug)]
pub struct OnThreads {
    /// The threads.
    pub pool: Arc<ThreadPool>,
}

impl Analyse for OnThreads {
    fn analyse(&self, pattern: &Pattern, kind: Kind) -> Result<Box<dyn LinearSystem>, SolveError> {
        self.analyse_for(pattern, kind, &Interface::default())
    }

    fn analyse_for(
        &self,
        pattern: &Pattern,
        kind: Kind,
        interface: &Interface<'_>,
    ) -> Result<Box<dyn LinearSystem>, SolveError> {
        Ok(BuiltIn::default().choose(pattern, kind, interface, Some(self.pool.clone())))
    }
}

impl BuiltIn {
    fn choose(
        &self,
        pattern: &Pattern,
        kind: Kind,
        interface: &Interface<'_>,
        pool: Option<Arc<ThreadPool>>,
    ) -> Box<dyn LinearSystem> {
        let on = interface.equations;
        if self.back_end == Some(BackEnd::Sparse)
            && let Some(sparse) = Sparse::new(pattern, kind, on, pool.clone())
        {
            return Box::new(sparse);
        }
        let of_factors = if interface.nearly_symmetric { Kind::Symmetric } else { kind };
        let layout = Layout::cheapest(pattern, kind);
        if self.back_end.is_none()
            && layout.operations(kind) > SMALL
            && let Some(sparse) = Sparse::new(pattern, of_factors, on, pool.clone())
            && (sparse_seconds(&sparse) < banded_seconds(&layout, kind)
                || layout.entries(kind) > LARGEST_BAND)
        {
            let iterates = kind == Kind::Symmetric && on.is_empty();
            return match iterates && iteration_pays(pattern, &sparse) {
                true => Box::new(Multigrid::new(pattern, sparse, pool)),
                false => Box::new(sparse),
            };
        }
        Box::new(Banded::new(pattern, kind, layout))
    }
}

/// Symbolic analysis, once for every pattern: orders the equations, predicts the work and chooses
/// the back end.
pub fn analyse(pattern: &Pattern, kind: Kind) -> Solver {
    Solver::new(pattern, BuiltIn::default().choose(pattern, kind, &Interface::default(), None))
}

/// Like [`analyse`] with the back end prescribed, for comparisons and tests. Where the sparse
/// library cannot analyse the pattern the banded back end is used.
pub fn analyse_with(pattern: &Pattern, kind: Kind, back_end: BackEnd) -> Solver {
    Solver::new(
        pattern,
        BuiltIn { back_end: Some(back_end) }.choose(pattern, kind, &Interface::default(), None),
    )
}

/// Whether an iteration is predicted to take less than half the time of a factorisation, which is
/// the surer way.
fn iteration_pays(pattern: &Pattern, sparse: &Sparse) -> bool {
    2.0 * Multigrid::seconds(pattern) < sparse.operations() / LARGE_FRONTS
}

/// Rough time of a banded factorisation [s]: short contiguous loops.
fn banded_seconds(layout: &Layout, kind: Kind) -> f64 {
    layout.operations(kind) / 8e9
}

/// Rough time of a sparse factorisation [s]: dense blocks are fast, the way there is not. The
/// constants are measured on plane grids.
fn sparse_seconds(sparse: &Sparse) -> f64 {
    sparse.operations() / 1e10 + sparse.entries() * 6e-9
}
