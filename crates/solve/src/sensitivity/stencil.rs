//! Differences between neighbours.
//!
//! ```text
//!   -2h   -h    0    h    2h
//!    o----o----x----o----o      f' = ( f(-2h) - 8 f(-h) + 8 f(h) - f(2h) ) / 12 h
//!              x----o----o      f' = ( -3 f(0) + 4 f(h) - f(2h) ) / 2 h
//! ```
//!
//! docs/theory.md eqs (13.5) and (13.8).

/// Where the neighbours stand, in steps.
pub const OFFSETS: [f64; 4] = [-2.0, -1.0, 1.0, 2.0];

/// Where the neighbours stand that differ in what the tangent does not know, in steps.
pub const PAIR: Sides = [-1.0, 1.0];
/// A number for each of the two neighbours of a pair.
pub type Sides = [f64; SIDES];
const SIDES: usize = 2;

/// On which side of the base the neighbours are asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// On both.
    Both,
    /// Below.
    Below,
    /// Above.
    Above,
}

/// What every neighbour, and the base, counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights {
    /// Those of the neighbours.
    pub near: [f64; 4],
    /// That of the base.
    pub base: f64,
}

impl Weights {
    /// Those of a side with a step `h`.
    pub fn of(side: Side, h: f64) -> Self {
        let (near, base, over) = match side {
            Side::Both => ([1.0, -8.0, 8.0, -1.0], 0.0, 12.0),
            Side::Below => ([1.0, -4.0, 0.0, 0.0], 3.0, 2.0),
            Side::Above => ([0.0, 0.0, 4.0, -1.0], -3.0, 2.0),
        };
        Self { near: near.map(|weight| weight / (over * h)), base: base / (over * h) }
    }

    /// The neighbours that count, with their weights.
    pub fn each(self) -> impl Iterator<Item = (usize, f64)> {
        self.near.into_iter().enumerate().filter(|(_, weight)| *weight != 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: both-sided differences are exact for polynomials up to the fourth degree,
    /// one-sided ones up to the second.
    #[test]
    fn polynomials_are_differentiated() {
        let at: f64 = 0.7;
        for (side, degree) in [(Side::Both, 4), (Side::Below, 2), (Side::Above, 2)] {
            let h = 0.25;
            let weights = Weights::of(side, h);
            let f = |x: f64| (0..=degree).map(|n| x.powi(n)).sum::<f64>();
            let exact: f64 = (1..=degree).map(|n| f64::from(n) * at.powi(n - 1)).sum();
            let near: f64 = weights.each().map(|(k, w)| w * f(at + OFFSETS[k] * h)).sum();
            let found = near + weights.base * f(at);
            assert!((found - exact).abs() < 1e-13, "{side:?}: {found} {exact}");
        }
    }
}
