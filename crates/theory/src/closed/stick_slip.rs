//! A block pressed on a surface and driven through a spring.
//!
//! ```text
//!      N
//!      v        k
//!   [block]--/\/\/\--> u(t)
//!   =======  mu
//! ```

/// Spring and friction of the block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block {
    /// Spring stiffness k [F/L].
    pub stiffness: f64,
    /// Normal force N [F].
    pub normal: f64,
    /// Coefficient of friction mu [-].
    pub mu: f64,
    /// Elastic slip gamma_crit at which friction is fully called [L]; zero for exact stick.
    pub elastic_slip: f64,
}

impl Block {
    /// Drive [L] at which the block first slips: mu N/k + gamma_crit.
    pub fn onset(&self) -> f64 {
        self.mu * self.normal / self.stiffness + self.elastic_slip
    }

    /// Spring force [F] after the drive has gone through the turning points
    /// `path` [L] from rest at zero: an elastic, perfectly plastic spring whose
    /// flexibility is 1/k + gamma_crit/(mu N) (derived).
    pub fn force(&self, path: &[f64]) -> f64 {
        let limit = self.mu * self.normal;
        if limit <= 0.0 {
            return 0.0;
        }
        let stiffness = limit / self.onset();
        let go = |(force, at): (f64, f64), to: &f64| {
            ((force + stiffness * (to - at)).clamp(-limit, limit), *to)
        };
        path.iter().fold((0.0, 0.0), go).0
    }

    /// Work [F L] lost in a closed cycle of amplitude `amplitude` [L]:
    /// 4 mu N (A - onset), zero if the block never slips.
    pub fn loop_work(&self, amplitude: f64) -> f64 {
        4.0 * self.mu * self.normal * (amplitude - self.onset()).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: verification section 6: sticks to u = mu N/k, then F = mu N;
    /// after reversal F falls with slope k and slips back after 2 mu N/k.
    #[test]
    fn loop_by_its_corners() {
        let block = Block { stiffness: 100.0, normal: 10.0, mu: 0.3, elastic_slip: 0.0 };
        assert!((block.onset() - 0.03).abs() < 1e-16);
        assert!((block.force(&[0.02]) - 2.0).abs() < 1e-13);
        assert_eq!(block.force(&[0.1]), 3.0);
        assert!((block.force(&[0.1, 0.09]) - 2.0).abs() < 1e-13);
        assert!((block.force(&[0.1, 0.04]) + 3.0).abs() < 1e-13);
        assert_eq!(block.force(&[0.1, -0.1]), -3.0);
    }

    /// The area of the loop is the work of the force around it.
    #[test]
    fn loop_area() {
        for elastic_slip in [0.0, 0.004] {
            let block = Block { stiffness: 100.0, normal: 10.0, mu: 0.3, elastic_slip };
            let (amplitude, n) = (0.1, 20_000);
            let mut work = 0.0;
            for i in 0..n {
                // back from +A to -A; the way forth does the same by symmetry
                let at = |i: usize| amplitude - 2.0 * amplitude * i as f64 / n as f64;
                let mean =
                    0.5 * (block.force(&[amplitude, at(i)]) + block.force(&[amplitude, at(i + 1)]));
                work += 2.0 * mean * (at(i + 1) - at(i));
            }
            assert!((work / block.loop_work(amplitude) - 1.0).abs() < 1e-6);
        }
    }
}
