//! Which parameter the spread of a response is owed to: indices of Sobol.
//!
//! A and B are independent points, A_i is A with the parameter i of B. Of a response f with the
//! variance V [Jansen 1999, as Saltelli et al. 2010 recommend]:
//!
//! ```text
//!   first  S_i = 1 - mean (f(B) - f(A_i))^2 / 2 V      what i alone does
//!   total  T_i =     mean (f(A) - f(A_i))^2 / 2 V      what i does with all others
//! ```

/// Mean and variance of numbers that come one after the other [Welford 1962].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    /// How many there were.
    pub count: u64,
    /// Their mean.
    pub mean: f64,
    squares: f64,
}

impl Moments {
    /// Takes a number in.
    #[allow(clippy::cast_precision_loss)] // counts are far below 2^53
    pub fn add(&mut self, value: f64) {
        self.count += 1;
        let from = value - self.mean;
        self.mean += from / self.count as f64;
        self.squares += from * (value - self.mean);
    }

    /// Variance of what they are taken from; none of fewer than two.
    #[allow(clippy::cast_precision_loss)] // as above
    pub fn variance(&self) -> Option<f64> {
        (self.count > 1).then(|| self.squares / (self.count - 1) as f64)
    }

    /// Standard error of the mean of independent numbers; none of fewer than two.
    #[allow(clippy::cast_precision_loss)] // as above
    pub fn error(&self) -> Option<f64> {
        self.variance().map(|variance| (variance / self.count as f64).sqrt())
    }
}

/// What a parameter has to do with the variance of a response, as shares of it [1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// What it does alone.
    pub first: f64,
    /// What it does alone and together with others.
    pub total: f64,
    /// Standard errors of both, as of independent points; those of a sequence of low discrepancy
    /// are smaller.
    pub errors: [f64; 2],
}

/// The sums behind the shares of all parameters, point by point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shares {
    all: Moments,
    /// Of each parameter, squares of f(B) - f(A_i) and of f(A) - f(A_i).
    squares: Vec<[Moments; 2]>,
}

impl Shares {
    /// Takes in what the response is at a point A, at its B, and at all its `A_i`.
    pub fn add(&mut self, [a, b]: [f64; 2], mixed: &[f64]) {
        self.all.add(a);
        self.all.add(b);
        self.squares.resize(mixed.len(), Default::default());
        for (own, value) in self.squares.iter_mut().zip(mixed) {
            own[0].add((b - value).powi(2));
            own[1].add((a - value).powi(2));
        }
    }

    /// Mean and variance of the response.
    pub fn moments(&self) -> Moments {
        self.all
    }

    /// The shares of the parameters; none of a response that does not vary.
    pub fn shares(&self) -> Option<Vec<Share>> {
        let twice = 2.0 * self.all.variance().filter(|variance| *variance > 0.0)?;
        let share = |[of_b, of_a]: &[Moments; 2]| {
            Some(Share {
                first: 1.0 - of_b.mean / twice,
                total: of_a.mean / twice,
                errors: [of_b.error()? / twice, of_a.error()? / twice],
            })
        };
        self.squares.iter().map(share).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: mean and variance of numbers far from zero. Source: 4, 7, 13, 16 have the mean
    /// 10 and the variance 30.
    #[test]
    fn moments_do_not_cancel() {
        let mut moments = Moments::default();
        [4.0, 7.0, 13.0, 16.0].iter().for_each(|value| moments.add(1e9 + value));
        assert!((moments.mean - 1e9 - 10.0).abs() < 1e-6);
        assert!((moments.variance().unwrap() - 30.0).abs() < 1e-6);
    }

    /// Source: f = x + 2 y of independent numbers that are 0 or 1 has the shares 1/5 and 4/5; all
    /// points with all others are a whole design.
    #[test]
    fn shares_of_a_sum() {
        let f = |[x, y]: [f64; 2]| x + 2.0 * y;
        let corners = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]];
        let mut shares = Shares::default();
        for _ in 0..1000 {
            for a in corners {
                for b in corners {
                    shares.add([f(a), f(b)], &[f([b[0], a[1]]), f([a[0], b[1]])]);
                }
            }
        }
        let found = shares.shares().unwrap();
        for (share, expected) in found.iter().zip([0.2, 0.8]) {
            assert!((share.first - expected).abs() < 1e-4, "{share:?}");
            assert!((share.total - expected).abs() < 1e-4, "{share:?}");
        }
        let mut same = Shares::default();
        (0..3).for_each(|_| same.add([2.0, 2.0], &[2.0]));
        assert_eq!(same.shares(), None);
    }
}
