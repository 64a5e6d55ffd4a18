//! Centrifugal forces of an element that turns about an axis, where its parts are at present.
//!
//! ```text
//!     |  o-----o              o-----o
//!     |  |     | ->   ->      |     | --->     omega^2 times mass times the way from the axis,
//!     |  o-----o              o-----o          which grows as the element moves outwards
//! ```
//! docs/theory.md eqs (4.28), (4.29).

/// Masses and the axis about which they turn; the size of the load is omega squared [1/T2].
#[derive(Clone, Debug, PartialEq)]
pub struct Turning {
    /// Masses of pairs of nodes, row by row: the integral of the density and both shape functions
    /// over the undeformed volume [M].
    masses: Vec<f64>,
    /// A point of the axis [L].
    point: [f64; 3],
    /// What of a way is across the axis.
    across: [[f64; 3]; 3],
}

impl Turning {
    /// Of these masses of pairs of nodes [M], about a point [L] and a unit direction.
    pub fn new(masses: Vec<f64>, point: [f64; 3], axis: [f64; 3]) -> Self {
        let across = |k: usize, l: usize| f64::from(u8::from(k == l)) - axis[k] * axis[l];
        let across = std::array::from_fn(|k| std::array::from_fn(|l| across(k, l)));
        Self { masses, point, across }
    }

    /// Forces on the nodes at `x` [L]: adds to `force` [F].
    pub fn push(&self, size: f64, x: &[[f64; 3]], force: &mut [[f64; 3]]) {
        let ways = x.iter().map(|x| {
            let arm: [f64; 3] = std::array::from_fn(|k| x[k] - self.point[k]);
            self.across.map(|row| row.iter().zip(arm).map(|(part, arm)| part * arm).sum::<f64>())
        });
        for (b, way) in ways.enumerate() {
            for (a, own) in force.iter_mut().enumerate() {
                let mass = size * self.masses[a * x.len() + b];
                own.iter_mut().zip(way).for_each(|(own, way)| *own += mass * way);
            }
        }
    }

    /// Their derivative by the positions of `count` nodes, which is symmetric: adds to `tangent`
    /// [F/L].
    pub fn stiffness(&self, size: f64, count: usize, tangent: &mut [f64]) {
        let width = 3 * count;
        for (i, row) in tangent.chunks_exact_mut(width).enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                let mass = self.masses[(i / 3) * count + j / 3];
                *entry += size * mass * self.across[i % 3][j % 3];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two nodes of masses 2 and 3 that know nothing of one another, and the whole derivative by
    /// differences: the force is linear in the place.
    #[test]
    fn forces_are_masses_times_ways_from_the_axis() {
        let turning = Turning::new(vec![2.0, 0.5, 0.5, 3.0], [1.0, 0.0, 7.0], [0.0, 0.6, 0.8]);
        let x = [[2.0, 1.0, 7.0], [1.0, -2.0, 5.0]];
        let at = |x: &[[f64; 3]]| {
            let mut force = [[0.0; 3]; 2];
            turning.push(4.0, x, &mut force);
            force
        };
        // ways: (1, .64, -.48), and (0, -.32, .24) of the second one
        let force = at(&x);
        let right = [[8.0, 4.48, -3.36], [2.0, -2.56, 1.92]];
        for (own, right) in force.as_flattened().iter().zip(right.as_flattened()) {
            assert!((own - right).abs() < 1e-12, "{force:?}");
        }
        let mut tangent = [0.0; 36];
        turning.stiffness(4.0, 2, &mut tangent);
        for j in 0..6 {
            let mut moved = x;
            moved[j / 3][j % 3] += 1.0;
            for (i, (new, old)) in
                at(&moved).as_flattened().iter().zip(force.as_flattened()).enumerate()
            {
                assert!((new - old - tangent[6 * i + j]).abs() < 1e-12, "{i} {j}");
                assert_eq!(tangent[6 * i + j], tangent[6 * j + i]);
            }
        }
    }
}
