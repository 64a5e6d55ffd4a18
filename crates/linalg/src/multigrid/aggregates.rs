//! Vertices that hang together, and the motions of each such set.

use super::rows::Rows;

/// Part of a motion's size in a set below which it is one of the others [1].
const DEPENDENT: f64 = 1e-8;

/// Sets of vertices: of each vertex the number of its set, and how many sets there are. A vertex
/// whose neighbours are all free begins a set with them; those that are left join a neighbour's, or
/// one another. `neighbours` lists those of a vertex.
pub(super) fn aggregate<'a>(
    vertices: usize,
    neighbours: impl Fn(usize) -> &'a [i32],
) -> (Vec<usize>, usize) {
    const FREE: usize = usize::MAX;
    let mut set = vec![FREE; vertices];
    let mut count = 0;
    let each = |v: usize| neighbours(v).iter().map(|&w| w as usize);
    for v in 0..vertices {
        if set[v] == FREE && each(v).all(|w| set[w] == FREE) {
            set[v] = count;
            each(v).for_each(|w| set[w] = count);
            count += 1;
        }
    }
    let first = set.clone();
    for (v, own) in set.iter_mut().enumerate() {
        if *own == FREE
            && let Some(near) = each(v).map(|w| first[w]).find(|&own| own != FREE)
        {
            *own = near;
        }
    }
    for v in 0..vertices {
        if set[v] == FREE {
            set[v] = count;
            for w in each(v) {
                if set[w] == FREE {
                    set[w] = count;
                }
            }
            count += 1;
        }
    }
    (set, count)
}

/// The motions of every set, made orthogonal: the prolongation that is not smooth yet, the motions
/// of the unknowns of the next level, and where the unknowns of each set begin.
pub(super) fn motions_of_sets(
    unknowns: &[Vec<usize>],
    motions: &[Vec<f64>],
    size: usize,
) -> (Rows, Vec<Vec<f64>>, Vec<usize>) {
    let mut entries: Vec<Vec<(u32, f64)>> = vec![Vec::new(); size];
    let mut coarse = vec![Vec::new(); motions.len()];
    let mut start = vec![0];
    for own in unknowns {
        let mut basis: Vec<Vec<f64>> = Vec::new();
        let first = start[start.len() - 1];
        for motion in motions {
            let mut left: Vec<f64> = own.iter().map(|&i| motion[i]).collect();
            let before = norm(&left);
            // once more for what rounding left
            for unit in basis.iter().chain(&basis) {
                let part: f64 = unit.iter().zip(&left).map(|(a, b)| a * b).sum();
                left.iter_mut().zip(unit).for_each(|(l, u)| *l -= part * u);
            }
            let size = norm(&left);
            if size > DEPENDENT * before && basis.len() < own.len() {
                basis.push(left.iter().map(|l| l / size).collect());
            }
        }
        for (motion, coarse) in motions.iter().zip(&mut coarse) {
            let part = |unit: &Vec<f64>| -> f64 {
                unit.iter().zip(own).map(|(unit, &i)| unit * motion[i]).sum()
            };
            coarse.extend(basis.iter().map(part));
        }
        for (column, unit) in (first..).zip(&basis) {
            own.iter().zip(unit).for_each(|(&i, &u)| entries[i].push((column as u32, u)));
        }
        start.push(first + basis.len());
    }
    let mut rows = Rows::empty(start[start.len() - 1]);
    for own in entries {
        for (column, value) in own {
            rows.column.push(column);
            rows.value.push(value);
        }
        rows.end_row();
    }
    (rows, coarse, start)
}

fn norm(a: &[f64]) -> f64 {
    a.iter().map(|a| a * a).sum::<f64>().sqrt()
}
