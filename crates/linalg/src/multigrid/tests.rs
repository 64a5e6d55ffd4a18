use super::*;
use crate::conjugate::norm;
use crate::residual::worst_residual;

/// Springs between the neighbours of a cubic grid, along the way between them: a body whose rigid
/// motions cost nothing, held at one face (whose nodes are left out). Gives the pattern, the values
/// and the six motions.
fn body(side: usize) -> (Pattern, Vec<f64>, Vec<f64>) {
    let nodes = side.pow(3);
    let place = |v: usize| [v % side, v / side % side, v / side.pow(2)].map(|c| c as f64);
    let mut cliques = Vec::new();
    for v in 0..nodes {
        for w in v + 1..nodes.min(v + side * side + side + 2) {
            let [a, b] = [place(v), place(w)];
            if (0..3).all(|axis| (a[axis] - b[axis]).abs() <= 1.0) {
                cliques.push((v, w));
            }
        }
    }
    let dofs = |(v, w): (usize, usize)| -> Vec<usize> {
        [v, w].into_iter().flat_map(|v| 3 * v..3 * v + 3).collect()
    };
    let lists: Vec<Vec<usize>> = cliques.iter().map(|&pair| dofs(pair)).collect();
    let pattern = Pattern::from_cliques(3 * nodes, lists.iter());
    let mut values = vec![0.0; pattern.entries()];
    let mut add = |i: usize, j: usize, k: f64| values[pattern.position(i, j).unwrap()] += k;
    for &(v, w) in &cliques {
        let [a, b] = [place(v), place(w)];
        let way: [f64; 3] = std::array::from_fn(|axis| b[axis] - a[axis]);
        let square: f64 = way.iter().map(|d| d * d).sum();
        for i in 0..3 {
            for j in 0..3 {
                let k = way[i] * way[j] / (square * square);
                for (p, q, sign) in [(v, v, 1.0), (w, w, 1.0), (v, w, -1.0), (w, v, -1.0)] {
                    add(3 * p + i, 3 * q + j, sign * k);
                }
            }
        }
    }
    for v in 0..side * side {
        (0..3).for_each(|i| add(3 * v + i, 3 * v + i, 10.0)); // held elastically at one face
    }
    let mut motions = Vec::new();
    for axis in 0..3 {
        motions.extend((0..3 * nodes).map(|i| f64::from(u8::from(i % 3 == axis))));
    }
    for axis in 0..3 {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        motions.extend((0..3 * nodes).map(|i| match i % 3 {
            c if c == next => -place(i / 3)[last],
            c if c == last => place(i / 3)[next],
            _ => 0.0,
        }));
    }
    (pattern, values, motions)
}

fn sizes(matrix: Matrix<'_>) -> Vec<f64> {
    (0..matrix.pattern.size()).map(|i| matrix.row_size(i)).collect()
}

fn solved(threads: Option<usize>, spoil: impl Fn(&mut [f64], &Pattern)) -> (Vec<f64>, Multigrid) {
    let (pattern, mut values, motions) = body(13);
    spoil(&mut values, &pattern);
    let pool = threads.map(|threads| {
        Arc::new(rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap())
    });
    let direct = Sparse::new(&pattern, Kind::Symmetric, &[], None).unwrap();
    let mut system = Multigrid::new(&pattern, direct, pool);
    system.take_motions(&motions);
    let matrix = Matrix::new(&pattern, &values);
    let size = sizes(matrix);
    system.scatter(matrix);
    system.factor(matrix, &size).unwrap();
    let b: Vec<f64> = (0..pattern.size()).map(|i| ((i * 31) % 17) as f64 - 8.0).collect();
    let mut x = b.clone();
    system.solve(&mut x, 1).unwrap();
    let error = worst_residual(matrix, &size, &x, |i| b[i]);
    assert!(error < 1e-10, "{error:e}");
    (x, system)
}

/// Requirement: a definite system is solved by iteration to near rounding, in few iterations, which
/// the rigid motions make few: with the translations alone they are half as many again or more.
#[test]
fn rigid_motions_make_iterations_few() {
    let (_, system) = solved(None, |_, _| ());
    assert!(!system.factored && system.hierarchy.is_some());
    let (pattern, values, motions) = body(13);
    let iterations = |motions: &[f64]| {
        let hierarchy = Hierarchy::new(&pattern, &values, motions, false).unwrap();
        let mut room = hierarchy.room();
        // the rate of the stationary iteration, by its error after some cycles
        let n = pattern.size();
        let mut error: Vec<f64> = (0..n).map(|i| ((i * 29) % 23) as f64 - 11.0).collect();
        let (mut residual, mut z) = (vec![0.0; n], vec![0.0; n]);
        let begin = norm(&error);
        for _ in 0..12 {
            hierarchy.multiply(&error, &mut residual);
            hierarchy.precondition(&residual, &mut z, &mut room);
            error.iter_mut().zip(&z).for_each(|(e, z)| *e -= z);
        }
        (norm(&error) / begin).powf(1.0 / 12.0)
    };
    let (all, translations) = (iterations(&motions), iterations(&motions[..3 * pattern.size()]));
    assert!(all < 0.75, "{all}");
    assert!(all.ln() < 1.2 * translations.ln(), "{all} {translations}");
}

/// Requirement: the bits are the same without threads and on any number of them.
#[test]
fn threads_change_no_bit() {
    let (alone, _) = solved(None, |_, _| ());
    for threads in [1, 3] {
        let (shared, _) = solved(Some(threads), |_, _| ());
        assert!(alone.iter().zip(&shared).all(|(a, b)| a.to_bits() == b.to_bits()));
    }
}

/// Requirement: an indefinite matrix is met by the direct factorisation, and solved all the same.
#[test]
fn the_direct_factorisation_takes_over() {
    let (_, system) = solved(None, |values, pattern| {
        for i in 0..300 {
            values[pattern.position(i, i).unwrap()] -= 15.0;
        }
    });
    assert!(system.factored && system.hierarchy.is_none());
}
