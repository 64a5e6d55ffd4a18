//! Solutions against dense elimination written here, and the naming of failures.

// Helpers of tests may fail like tests.
#![allow(clippy::unwrap_used)]

use crate::common::*;
use slideline_linalg::*;
use std::sync::Arc;

const BOTH: [BackEnd; 2] = [BackEnd::Banded, BackEnd::Sparse];

/// Solves with both back ends and the chosen one; error against dense elimination below 1e-9: the
/// random systems have condition numbers up to 1e5, rounding leaves 1e-11.
fn check(pattern: &Pattern, values: &[f64], kind: Kind) {
    let mut numbers = Numbers(7);
    let b: Vec<f64> = (0..pattern.size()).map(|_| numbers.next()).collect();
    let reference = eliminate(dense(pattern, values), b.clone());
    let solvers = BOTH.map(|back_end| analyse_with(pattern, kind, back_end));
    for mut solver in solvers.into_iter().chain([analyse(pattern, kind)]) {
        solver.refactor(pattern, values).unwrap();
        for _ in 0..2 {
            let mut x = b.clone();
            solver.solve(&mut x).unwrap();
            let e = error(&x, &reference);
            assert!(e < 1e-9, "{}: {e:e}", solver.description());
        }
        check_transpose(pattern, values, &mut solver, &b);
        check_block(&mut solver, &b);
    }
}

/// A transposed solution against dense elimination with the same bound.
fn check_transpose(pattern: &Pattern, values: &[f64], solver: &mut Solver, b: &[f64]) {
    let rows = dense(pattern, values);
    let columns = (0..b.len()).map(|j| rows.iter().map(|row| row[j]).collect()).collect();
    let reference = eliminate(columns, b.to_vec());
    let mut x = b.to_vec();
    solver.solve_transpose(&mut x).unwrap();
    let e = error(&x, &reference);
    assert!(e < 1e-9, "transposed {}: {e:e}", solver.description());
}

/// Many right-hand sides at once give each the solution that it gets alone: the same bits from the
/// banded factorisation, rounding from the sparse one, which uses dense kernels.
fn check_block(solver: &mut Solver, b: &[f64]) {
    let n = b.len();
    let columns = 7;
    let column = |c: usize| b.iter().map(move |b| b * (c as f64 - 2.5) + c as f64);
    let mut block: Vec<f64> = (0..columns).flat_map(column).collect();
    solver.solve_many(&mut block, columns).unwrap();
    for c in 0..columns {
        let mut alone: Vec<f64> = column(c).collect();
        solver.solve(&mut alone).unwrap();
        let together = &block[c * n..(c + 1) * n];
        if solver.description().back_end == BackEnd::Banded {
            assert_eq!(together, alone);
        }
        assert!(error(together, &alone) < 1e-9);
    }
    assert_eq!(
        solver.solve_many(&mut block, columns + 1),
        Err(SolveError::Size { expected: n * (columns + 1), found: n * columns })
    );
}

fn band(n: usize, width: usize) -> Pattern {
    Pattern::from_pairs(n, (0..n).flat_map(move |i| (1..=width).map(move |p| (i, i + p))))
}

#[test]
fn random_bands() {
    for seed in 0..30 {
        let mut numbers = Numbers(seed);
        let (n, width) = (1 + numbers.below(90), numbers.below(9));
        let pattern = band(n, width);
        let mut values = fill(&pattern, |i, j| numbers.next() + if i == j { 0.3 } else { 0.0 });
        check(&pattern, &values, Kind::Unsymmetric);
        symmetrise(&pattern, &mut values);
        check(&pattern, &values, Kind::Symmetric);
    }
}

#[test]
fn random_scattered_patterns() {
    for seed in 100..120 {
        let mut numbers = Numbers(seed);
        let n = 20 + numbers.below(60);
        let pairs: Vec<_> = (0..3 * n).map(|_| (numbers.below(n), numbers.below(n))).collect();
        let pattern = Pattern::from_pairs(n, pairs.into_iter());
        let values = fill(&pattern, |i, j| numbers.next() + if i == j { 4.0 } else { 0.0 });
        check(&pattern, &values, Kind::Unsymmetric);
    }
}

#[test]
fn bordered_systems() {
    for seed in 200..215 {
        let mut numbers = Numbers(seed);
        let (n, border) = (90, 1 + numbers.below(4));
        let chain =
            (0..n - border).flat_map(|i| (1..4).map(move |p| (i, (i + p).min(n - border - 1))));
        let star = (n - border..n).flat_map(|i| (0..n / 2).map(move |j| (i, 2 * j)));
        let pattern = Pattern::from_pairs(n, chain.chain(star));
        let mut values = fill(&pattern, |i, j| numbers.next() + if i == j { 2.0 } else { 0.0 });
        let solver = analyse(&pattern, Kind::Unsymmetric);
        assert_eq!(solver.description().border, border);
        check(&pattern, &values, Kind::Unsymmetric);
        symmetrise(&pattern, &mut values);
        check(&pattern, &values, Kind::Symmetric);
    }
}

#[test]
fn a_band_held_only_by_its_border() {
    // A free chain of springs (singular alone) whose nodes hang on one dense node fixed to ground.
    let n = 60;
    let chain = (0..n - 2).map(|i| (i, i + 1));
    let pattern = Pattern::from_pairs(n, chain.chain((0..n - 1).map(|i| (i, n - 1))));
    let mut values = vec![0.0; pattern.entries()];
    let mut spring = |i: usize, j: usize, k: f64| {
        for (r, c, s) in [(i, i, k), (j, j, k), (i, j, -k), (j, i, -k)] {
            values[pattern.position(r, c).unwrap()] += s;
        }
    };
    (0..n - 2).for_each(|i| spring(i, i + 1, 1.0));
    spring(3, n - 1, 1.0);
    values[pattern.position(3, 3).unwrap()] -= 1.0; // leaves the band singular
    values[pattern.position(n - 1, n - 1).unwrap()] += 1.0;
    for kind in [Kind::Symmetric, Kind::Unsymmetric] {
        assert_eq!(analyse(&pattern, kind).description().border, 1);
        check(&pattern, &values, kind);
    }
}

/// Chain of `n` springs to ground with multipliers on some dofs; multipliers numbered first.
fn saddle(n: usize, multipliers: usize, stiffness: f64) -> (Pattern, Vec<f64>) {
    let total = n + multipliers;
    let chain = (multipliers..total - 1).map(|i| (i, i + 1));
    let rows =
        (0..multipliers).flat_map(|m| [(m, multipliers + 3 * m), (m, multipliers + 3 * m + 1)]);
    let pattern = Pattern::from_pairs(total, chain.chain(rows));
    let values = fill(&pattern, |i, j| match (i.min(j) < multipliers, i == j) {
        (true, true) => 0.0,
        (true, false) => {
            if i.abs_diff(j) % 2 == 0 {
                1.0
            } else {
                -0.5
            }
        }
        (false, true) => 2.1 * stiffness,
        (false, false) => -stiffness,
    });
    (pattern, values)
}

#[test]
fn multipliers_with_zero_diagonals() {
    for multipliers in [1, 4, 9] {
        for stiffness in [1.0, 1e3] {
            let (pattern, values) = saddle(60, multipliers, stiffness);
            check(&pattern, &values, Kind::Symmetric);
            check(&pattern, &values, Kind::Unsymmetric);
            let mut sparse = analyse_with(&pattern, Kind::Symmetric, BackEnd::Sparse);
            let report = sparse.refactor(&pattern, &values).unwrap();
            // Inertia of a saddle matrix with definite stiffness: one negative per multiplier.
            assert_eq!(report.negative_pivots, Some(multipliers));
        }
    }
}

#[test]
fn units_do_not_make_a_system_singular() {
    // A multiplier beside a stiffness of 1e15: the pivot it leaves is 1e-15 of its row, and exact.
    let (pattern, values) = saddle(30, 3, 1e15);
    for kind in [Kind::Symmetric, Kind::Unsymmetric] {
        let mut solver = analyse_with(&pattern, kind, BackEnd::Banded);
        solver.refactor(&pattern, &values).unwrap();
        let mut x: Vec<f64> = (0..33).map(|i| if i < 3 { 1.0 } else { 1e15 }).collect();
        let reference = eliminate(dense(&pattern, &values), x.clone());
        solver.solve(&mut x).unwrap();
        assert!(error(&x[3..], &reference[3..]) < 1e-9);
    }
}

#[test]
fn negative_pivots_count_negative_eigenvalues() {
    // diag(L) with known signs under a congruence keeps its inertia (Sylvester); here a chain with
    // springs of both signs to ground, weakly coupled: Gershgorin gives the signs.
    let pattern = band(40, 2);
    let sign = |i: usize| if i % 7 == 3 { -1.0 } else { 1.0 };
    let values = fill(&pattern, |i, j| if i == j { sign(i) } else { 0.1 });
    for back_end in BOTH {
        let mut solver = analyse_with(&pattern, Kind::Symmetric, back_end);
        let report = solver.refactor(&pattern, &values).unwrap();
        assert_eq!(report.negative_pivots, Some(6), "{back_end:?}");
        assert!(report.smallest_pivot_ratio > 0.3);
    }
}

#[test]
fn larger_grids() {
    let (pattern, mut values) = grid(30);
    check(&pattern, &values, Kind::Symmetric);
    let mut numbers = Numbers(3);
    values.iter_mut().for_each(|v| *v *= 1.0 + 0.3 * numbers.next());
    check(&pattern, &values, Kind::Unsymmetric);
}

#[test]
fn the_large_choose_the_sparse() {
    let (pattern, values) = grid(120);
    for kind in [Kind::Symmetric, Kind::Unsymmetric] {
        let mut solver = analyse(&pattern, kind);
        assert_eq!(solver.description().back_end, BackEnd::Sparse);
        solver.refactor(&pattern, &values).unwrap();
        let x: Vec<f64> = (0..pattern.size()).map(|i| (i % 11) as f64 - 5.0).collect();
        let mut b = vec![0.0; x.len()];
        Matrix::new(&pattern, &values).multiply(&x, &mut b);
        solver.solve(&mut b).unwrap();
        assert!(error(&b, &x) < 1e-10);
    }
    let chain = band(3000, 5);
    assert_eq!(analyse(&chain, Kind::Unsymmetric).description().back_end, BackEnd::Banded);
}

fn all_ways() -> impl Iterator<Item = (Kind, BackEnd)> {
    [Kind::Symmetric, Kind::Unsymmetric].into_iter().flat_map(|k| BOTH.map(|b| (k, b)))
}

#[test]
fn an_empty_row_is_named() {
    // A dof that nothing holds: in the pattern, but its row and column are zero.
    let pattern = band(40, 3);
    for ((kind, back_end), wanted) in all_ways().flat_map(|w| [0, 13, 39].map(|e| (w, e))) {
        let values = fill(&pattern, |i, j| match (i == j, i == wanted || j == wanted) {
            (_, true) => 0.0,
            (true, _) => 7.0,
            _ => -1.0,
        });
        let result = analyse_with(&pattern, kind, back_end).refactor(&pattern, &values);
        assert_eq!(result, Err(SolveError::Singular { equation: wanted, ratio: 0.0 }));
    }
}

#[test]
fn two_dofs_that_move_together_are_named() {
    // Two neighbours joined by a spring and by nothing else: block [7 -7; -7 7], one of the two has
    // no pivot.
    let pattern = band(40, 3);
    for ((kind, back_end), first) in all_ways().flat_map(|w| [0, 13, 38].map(|e| (w, e))) {
        let inside = |i: usize| i == first || i == first + 1;
        let values = fill(&pattern, |i, j| match (i == j, inside(i), inside(j)) {
            (true, _, _) => 7.0,
            (_, true, true) => -7.0,
            (_, false, false) => -1.0,
            _ => 0.0,
        });
        let mut solver = analyse_with(&pattern, kind, back_end);
        match solver.refactor(&pattern, &values) {
            Err(SolveError::Singular { equation, ratio }) => {
                assert!(inside(equation), "{equation} {first} {kind:?} {back_end:?}");
                assert!(ratio < 1e-14);
            }
            other => panic!("{other:?}"),
        }
        assert_eq!(solver.solve(&mut [0.0; 40]), Err(SolveError::NotFactored));
    }
}

#[test]
fn a_zero_column_is_named() {
    let pattern = band(20, 2);
    let values = fill(&pattern, |i, j| {
        if j == 11 {
            0.0
        } else if i == j {
            5.0
        } else {
            1.0
        }
    });
    for back_end in BOTH {
        let mut solver = analyse_with(&pattern, Kind::Unsymmetric, back_end);
        match solver.refactor(&pattern, &values) {
            Err(SolveError::Singular { equation, .. }) => assert_eq!(equation, 11),
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn a_free_chain_is_singular() {
    // Rigid-body motion: springs between nodes, nothing to ground. Any equation may be named.
    let pattern = band(50, 1);
    let values = fill(&pattern, |i, j| match (i == j, i) {
        (true, 0 | 49) => 3.7,
        (true, _) => 7.4,
        _ => -3.7,
    });
    for kind in [Kind::Symmetric, Kind::Unsymmetric] {
        for back_end in BOTH {
            let result = analyse_with(&pattern, kind, back_end).refactor(&pattern, &values);
            assert!(matches!(result, Err(SolveError::Singular { .. })), "{kind:?} {back_end:?}");
        }
    }
}

#[test]
fn what_is_not_a_number_is_named() {
    let (pattern, mut values) = grid(6);
    let mut solver = analyse(&pattern, Kind::Symmetric);
    solver.refactor(&pattern, &values).unwrap();
    let mut b = vec![1.0; 36];
    b[5] = f64::INFINITY;
    assert_eq!(solver.solve(&mut b), Err(SolveError::NotFinite { equation: 5 }));
    values[pattern.position(17, 18).unwrap_or_else(|| pattern.position(17, 17).unwrap())] =
        f64::NAN;
    assert_eq!(solver.refactor(&pattern, &values), Err(SolveError::NotFinite { equation: 17 }));
    let wrong = solver.refactor(&pattern, &values[1..]);
    assert_eq!(wrong, Err(SolveError::Size { expected: values.len(), found: values.len() - 1 }));
    assert_eq!(solver.solve(&mut [0.0; 3]), Err(SolveError::Size { expected: 36, found: 3 }));
}

#[test]
fn same_bits_twice_and_after_other_values() {
    let (pattern, values) = saddle(50, 4, 10.0);
    let other: Vec<f64> = values.iter().map(|v| v + 0.5).collect();
    for (kind, back_end) in all_ways() {
        let solve = |before: bool| {
            let mut solver = analyse_with(&pattern, kind, back_end);
            if before {
                let _ = solver.refactor(&pattern, &other);
            }
            let report = solver.refactor(&pattern, &values).unwrap();
            let mut x: Vec<f64> = (0..54).map(|i| i as f64).collect();
            solver.solve(&mut x).unwrap();
            let bits: Vec<u64> = x.iter().map(|v| v.to_bits()).collect();
            (bits, report.smallest_pivot_ratio.to_bits(), report.smallest_pivot)
        };
        assert_eq!(solve(false), solve(false));
        assert_eq!(solve(false), solve(true));
    }
}

#[test]
fn patterns() {
    let pattern = Pattern::from_cliques(4, [vec![0, 2], vec![2, 3, 2]].iter());
    assert_eq!(pattern.row(0), [0, 2]);
    assert_eq!(pattern.row(1), [1]);
    assert_eq!(pattern.row(2), [0, 2, 3]);
    assert_eq!((pattern.size(), pattern.entries()), (4, 8));
    assert_eq!((pattern.position(2, 3), pattern.position(3, 1)), (Some(5), None));
    let mut solver = analyse(&Pattern::from_pairs(0, [].into_iter()), Kind::Symmetric);
    let empty = Pattern::from_pairs(0, [].into_iter());
    solver.refactor(&empty, &[]).unwrap();
    solver.solve(&mut []).unwrap();
    let values: Vec<f64> = (1..9).map(f64::from).collect();
    let (mut y, mut z) = ([0.0; 4], [0.0; 4]);
    let x = [1.0, -1.0, 2.0, 0.5];
    Matrix::new(&pattern, &values).multiply(&x, &mut y);
    Matrix::new(&pattern, &values).multiply_transpose(&x, &mut z);
    assert_eq!(y, [5.0, -3.0, 17.0, 18.0]);
    assert_eq!(z, [9.0, -3.0, 15.5, 16.0]);
}

/// Requirement: a further right-hand side gives the very solution that a checked one gives, before
/// and after a checked one and after another factorisation. Tolerance: none, the same operations.
#[test]
fn respond_is_solve() {
    let pattern = band(9, 2);
    let mut solver = analyse(&pattern, Kind::Symmetric);
    let rhs: [f64; 9] = std::array::from_fn(|i| 0.5 * i as f64 - 1.0);
    assert_eq!(solver.respond(&mut rhs.clone()), Err(SolveError::NotFactored));
    for factor in [1.0, 7.0] {
        let values = fill(&pattern, |i, j| if i == j { 9.0 * factor } else { -1.5 });
        solver.refactor(&pattern, &values).unwrap();
        let [mut first, mut checked, mut further] = [rhs; 3];
        solver.respond(&mut first).unwrap();
        solver.solve(&mut checked).unwrap();
        solver.respond(&mut further).unwrap();
        assert_eq!(first, checked);
        assert_eq!(further, checked);
    }
}

/// Requirement: a matrix near the one factored last is solved with its factors, to the residual
/// promised; one that is far or not definite is factored, and solved as if it always had been.
#[test]
fn a_matrix_near_the_last_is_not_factored() {
    let (pattern, values) = bricks(14);
    let mut solver = analyse(&pattern, Kind::Symmetric);
    assert_eq!(solver.follow(&pattern, &values), Ok(false), "nothing was factored");
    solver.refactor(&pattern, &values).unwrap();
    let changed = |by: f64| -> Vec<f64> {
        let spread = |i: usize, j: usize| 1.0 + by * ((i * j % 17) as f64 / 17.0);
        let rows = (0..pattern.size()).flat_map(|i| pattern.row(i).iter().map(move |&j| (i, j)));
        rows.zip(&values)
            .map(|((i, j), v)| if i == j { v * (1.0 + by) } else { v * spread(i, j) })
            .collect()
    };
    let x: Vec<f64> = (0..pattern.size()).map(|i| (i % 11) as f64 - 5.0).collect();
    let mut solve = |values: &[f64]| {
        assert_eq!(solver.follow(&pattern, values), Ok(true));
        let matrix = Matrix::new(&pattern, values);
        let (mut b, mut left) = (vec![0.0; x.len()], vec![0.0; x.len()]);
        matrix.multiply(&x, &mut b);
        let mut solution = b.clone();
        solver.solve(&mut solution).unwrap();
        matrix.multiply(&solution, &mut left);
        let norm = |v: &[f64]| v.iter().map(|v| v * v).sum::<f64>().sqrt();
        left.iter_mut().zip(&b).for_each(|(left, b)| *left -= b);
        (norm(&left) / norm(&b), solver.negative_pivots())
    };
    let (left, negative) = solve(&changed(0.1));
    assert!(left < 1e-8 && left > 1e-14 && negative == 0, "{left:e}");
    let upside_down: Vec<f64> = values.iter().map(|v| -v).collect();
    let (left, negative) = solve(&upside_down);
    assert!(left < 1e-12 && negative == pattern.size(), "{left:e} {negative}");
    assert_eq!(solver.follow(&pattern, &values), Ok(false), "the last one was not definite");
    let (plane, of_plane) = grid(60);
    let mut solver = analyse(&plane, Kind::Symmetric);
    solver.refactor(&plane, &of_plane).unwrap();
    assert_eq!(solver.follow(&plane, &of_plane), Ok(false), "it is as cheap to factor");
}

/// Requirement: where few solutions are wanted, a large definite matrix is solved as exactly as
/// without, with the same bits on any number of threads; one that is indefinite or singular is
/// reported as without; transposed and many right-hand sides too. Tolerance: residual 1e-11.
#[test]
fn few_solutions_are_as_exact_as_many() {
    let (pattern, values) = bricks(14);
    let n = pattern.size();
    let pool = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        OnThreads { pool: Arc::new(pool) }
    };
    let solver = |threads: usize, few: bool| {
        let mut solver = match threads {
            0 => analyse(&pattern, Kind::Symmetric),
            _ => Solver::analyse(&pattern, Kind::Symmetric, &pool(threads)),
        };
        solver.set_use(if few { Use::Few } else { Use::Many });
        solver
    };
    let b: Vec<f64> = (0..3 * n).map(|i| 1e-40 * ((i % 11) as f64 - 5.0)).collect();
    let matrix = Matrix::new(&pattern, &values);
    let left = |x: &[f64], b: &[f64]| {
        let mut product = vec![0.0; n];
        matrix.multiply(x, &mut product);
        let norm = |v: &[f64]| v.iter().map(|v| 1e80 * v * v).sum::<f64>().sqrt();
        product.iter_mut().zip(b).for_each(|(product, b)| *product -= b);
        norm(&product) / norm(b)
    };
    let mut bits = Vec::new();
    for threads in [0, 1, 2] {
        let mut solver = solver(threads, true);
        let report = solver.refactor(&pattern, &values).unwrap();
        assert_eq!(report.negative_pivots, Some(0));
        let mut x = b.clone();
        solver.solve(&mut x[..n]).unwrap();
        solver.solve_many(&mut x[n..], 2).unwrap();
        for (x, b) in x.chunks(n).zip(b.chunks(n)) {
            assert!(left(x, b) < 1e-11, "{threads}: {:e}", left(x, b));
        }
        bits.push(x.iter().map(|x| x.to_bits()).collect::<Vec<u64>>());
        let mut transposed = b[..n].to_vec();
        solver.solve_transpose(&mut transposed).unwrap();
        assert!(left(&transposed, &b[..n]) < 1e-12);
    }
    assert!(bits[0] == bits[1] && bits[1] == bits[2]);
    let mut without = solver(0, false);
    without.refactor(&pattern, &values).unwrap();
    let mut exact = b[..n].to_vec();
    without.solve(&mut exact).unwrap();
    let same = exact.iter().zip(&bits[0]).all(|(x, bits)| x.to_bits() == *bits);
    assert!(!same, "these are other factors");
    let upside_down: Vec<f64> = values.iter().map(|v| -v).collect();
    // without what exceeds the rest of a row nothing resists the same motion of all
    let mut floating = values.clone();
    for i in 0..n {
        let at = pattern.position(i, i).unwrap();
        floating[at] = (pattern.row(i).len() - 1) as f64;
    }
    for values in [&upside_down, &floating] {
        let [few, many] = [true, false].map(|few| solver(0, few).refactor(&pattern, values));
        assert_eq!(few, many);
    }
}
