//! Functions of two coordinates with their derivatives, by the rules of sum, product and chain.

/// A function of two coordinates with its first and second derivatives (11, 22, 12).
#[derive(Debug, Clone, Copy)]
pub struct Jet {
    /// Its value.
    pub value: f64,
    /// By each coordinate.
    pub first: [f64; 2],
    /// By both, twice.
    pub second: [f64; 3],
}

impl Jet {
    /// A constant.
    pub fn constant(value: f64) -> Self {
        Self { value, first: [0.0; 2], second: [0.0; 3] }
    }

    /// A coordinate.
    pub fn coordinate(value: f64, axis: usize) -> Self {
        let mut own = Self::constant(value);
        own.first[axis] = 1.0;
        own
    }

    /// The sum.
    pub fn plus(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            first: std::array::from_fn(|k| self.first[k] + other.first[k]),
            second: std::array::from_fn(|k| self.second[k] + other.second[k]),
        }
    }

    /// A multiple.
    pub fn times(self, factor: f64) -> Self {
        Self {
            value: factor * self.value,
            first: self.first.map(|d| factor * d),
            second: self.second.map(|d| factor * d),
        }
    }

    /// The product.
    pub fn by(self, other: Self) -> Self {
        let (f, g) = (self, other);
        let second = |k: usize, a: usize, b: usize| {
            f.second[k] * g.value
                + f.first[a] * g.first[b]
                + f.first[b] * g.first[a]
                + f.value * g.second[k]
        };
        Self {
            value: f.value * g.value,
            first: std::array::from_fn(|k| f.first[k] * g.value + f.value * g.first[k]),
            second: [second(0, 0, 0), second(1, 1, 1), second(2, 0, 1)],
        }
    }

    /// A function of it, by its value and its first and second derivatives.
    pub fn through(self, [value, first, second]: [f64; 3]) -> Self {
        let bend = |k: usize, a: usize, b: usize| {
            first * self.second[k] + second * self.first[a] * self.first[b]
        };
        Self {
            value,
            first: self.first.map(|slope| first * slope),
            second: [bend(0, 0, 0), bend(1, 1, 1), bend(2, 0, 1)],
        }
    }
}
