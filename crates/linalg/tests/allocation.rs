//! What is done again with the same pattern allocates nothing.

// Helpers of tests may fail like tests.
#![allow(clippy::unwrap_used)]

use std::alloc::System;

use slideline_linalg::krylov::{Stop, Workspace, gmres};
use slideline_linalg::{BackEnd, DenseLu, Kind, Pattern, Use, analyse_with};
use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};

mod common;

use common::{bricks, grid};

#[global_allocator]
static COUNTER: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

fn allocations(work: impl FnOnce()) -> usize {
    let count = || {
        let stats = COUNTER.stats();
        stats.allocations + stats.reallocations
    };
    let before = count();
    work();
    count() - before
}

/// Requirement: the second factorisation with the same pattern, and every solution after the first
/// (one, many, transposed), allocate nothing, in every back end; nor does a second dense elimination
/// or a second GMRES. One test, so that no other thread allocates meanwhile. Tolerance: none.
#[test]
fn nothing_is_allocated_the_second_time() {
    let (pattern, values) = grid(40);
    let n = pattern.size();
    for kind in [Kind::Symmetric, Kind::Unsymmetric] {
        for back_end in [BackEnd::Banded, BackEnd::Sparse] {
            let unit = (0..n).map(|i| 1.0 + (i % 3) as f64).collect();
            let mut solver = analyse_with(&pattern, kind, back_end).with_units(unit);
            let mut block = vec![1.0; 6 * n];
            let mut round = |pattern: &Pattern| {
                let factored = solver.refactor(pattern, &values).is_ok();
                let solved = solver.solve(&mut block[..n]).is_ok()
                    && solver.solve_transpose(&mut block[..n]).is_ok()
                    && solver.solve_many(&mut block, 6).is_ok();
                assert!(factored && solved);
            };
            assert!(allocations(|| round(&pattern)) > 0, "the count counts");
            assert_eq!(allocations(|| round(&pattern)), 0, "{kind:?} {back_end:?}");
        }
    }
    let (space, of_space) = bricks(14);
    let mut solver = analyse_with(&space, Kind::Symmetric, BackEnd::Sparse);
    solver.set_use(Use::Few);
    let mut rhs = vec![1.0; space.size()];
    let mut round = || {
        assert!(solver.refactor(&space, &of_space).is_ok() && solver.solve(&mut rhs).is_ok());
        assert_eq!(solver.follow(&space, &of_space), Ok(true));
        assert!(solver.solve(&mut rhs).is_ok());
    };
    round();
    assert_eq!(allocations(round), 0, "single precision");
    let mut lu = DenseLu::default();
    let mut rhs = [1.0; 20];
    let mut eliminate = || {
        let matrix = lu.matrix_mut(20);
        (0..20).for_each(|i| matrix[21 * i] = 2.0);
        lu.factor();
        assert_eq!(lu.solve(&mut rhs), Ok(()));
    };
    eliminate();
    assert_eq!(allocations(eliminate), 0);
    let mut workspace = Workspace::for_iterations(20, 20);
    let stop = Stop { tolerance: 1e-10, iterations: 20 };
    let operator = |v: &[f64], w: &mut [f64]| {
        (0..20).for_each(|i| w[i] = (1.0 + i as f64) * v[i]);
    };
    let mut x = [0.0; 20];
    let count = allocations(|| {
        let copy = |v: &[f64], z: &mut [f64]| z.copy_from_slice(v);
        assert!(gmres(operator, copy, &[1.0; 20], &mut x, stop, &mut workspace).converged());
    });
    assert_eq!(count, 0);
}
