//! Solutions on a few equations: only the fronts that they pass through take part.
//!
//! ```text
//!   o   o   o   o      o fronts, their parents above them are below one another in time:
//!    \ /     \ /       a right-hand side on equations of * enters there and goes up to the
//!     o       *        root; what is wanted there comes down the same way. All other fronts
//!      \     /         would add zeros, or find what nobody asks for.
//!       \   /
//!         *
//! ```
//!
//! [gilbert1988]: the solution has the bits of one with all fronts.

use super::Multifrontal;
use crate::precision::Real;

impl<T: Real> Multifrontal<T> {
    /// As [`Multifrontal::solve_one`] where the right-hand side is zero but on the interface; the
    /// solution is left there, and elsewhere nothing is.
    pub fn solve_on_path(
        &mut self,
        b: &mut [f64],
        enter: impl Fn(usize, f64) -> T,
        leave: impl Fn(usize, T) -> f64,
    ) {
        let Some(path) = self.path.clone() else { return self.solve_one(b, enter, leave, false) };
        let mut x = std::mem::take(&mut self.x);
        let mut rows = std::mem::take(&mut self.rows);
        let used = &mut x[..self.layout.fronts.order.len()];
        for &f in &path.fronts {
            let front = &self.layout.fronts.front[f as usize];
            used[front.first..front.first + front.columns].fill(T::ZERO);
        }
        for &(position, equation) in &path.equations {
            used[position as usize] = enter(equation as usize, b[equation as usize]);
        }
        let fronts = || path.fronts.iter().map(|&f| f as usize);
        fronts().for_each(|f| self.forward_one(f, used, &mut rows, false));
        fronts().rev().for_each(|f| self.backward_one(f, used, &mut rows, false));
        for &(position, equation) in &path.equations {
            b[equation as usize] = leave(equation as usize, used[position as usize]);
        }
        (self.x, self.rows) = (x, rows);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fronts::Tree;
    use crate::pattern::{Matrix, Pattern};
    use crate::system::Kind;

    /// Requirement: on the interface the solution has the bits of that with all fronts, which are
    /// more; in both symmetries.
    #[test]
    fn solutions_on_an_interface_are_those_of_all() {
        let side = 40;
        let own = |i: usize| [(i, i + 1), (i, i + side), (i, i + side + 1)];
        let pattern = Pattern::from_pairs(side * side, (0..side * side).flat_map(own));
        let interface: Vec<usize> = (0..side).map(|k| k * side + 7).collect();
        let mut values = vec![0.0; pattern.entries()];
        for kind in [Kind::Symmetric, Kind::Unsymmetric] {
            for i in 0..pattern.size() {
                for (e, &j) in (pattern.row_start()[i]..).zip(pattern.row(i)) {
                    let turned = if kind == Kind::Unsymmetric && i < j { 0.3 } else { 0.0 };
                    values[e] = if i == j { 8.0 } else { -1.0 + turned };
                }
            }
            let tree = crate::orders::best_tree(&pattern).unwrap();
            let mut factors = Multifrontal::<f64>::new(&pattern, kind, &tree, None)
                .unwrap()
                .with_path(&interface);
            let matrix = Matrix::new(&pattern, &values);
            factors.scatter(values.iter().copied()).unwrap();
            factors.factor(|i| matrix.row_size(i));
            let mut b = vec![0.0; pattern.size()];
            interface.iter().for_each(|&i| b[i] = (i % 13) as f64 - 6.0);
            let (mut all, mut few) = (b.clone(), b);
            factors.solve(&mut all, 1, false);
            factors.solve_on_path(&mut few, |_, b| b, |_, x| x);
            let path = factors.path.clone().unwrap();
            assert!(2 * path.fronts.len() < factors.layout.fronts.front.len());
            assert!(
                interface.iter().all(|&i| all[i].to_bits() == few[i].to_bits() && all[i] != 0.0)
            );
        }
    }

    /// Requirement: where the interface is eliminated last, its front is the whole path.
    #[test]
    fn an_interface_that_comes_last_is_one_front() {
        let side = 30;
        let own = |i: usize| [(i, i + 1), (i, i + side)];
        let pattern = Pattern::from_pairs(side * side, (0..side * side).flat_map(own));
        let interface: Vec<usize> = (0..side).map(|k| 7 * side + k).collect();
        let others = (0..side * side).filter(|i| i / side != 7);
        let order: Vec<usize> = others.chain(interface.iter().copied()).collect();
        let tree = Tree::new(&pattern, &order);
        let factors = Multifrontal::<f64>::new(&pattern, Kind::Symmetric, &tree, None).unwrap();
        assert!(factors.with_path(&interface).path.unwrap().fronts.len() < 4);
    }
}
