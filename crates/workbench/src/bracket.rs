//! Two values between which a function has its zero, drawn together.
//!
//! Inverse quadratic interpolation through the last three values where that is safe, halves where
//! it is not: as few evaluations as Newton's method near a zero, and never more than a few times
//! those of halves. [T. R. Chandrupatla, Adv. Eng. Softw. 28 (1997) 145-149]

/// A value and the function there.
pub(crate) type Tried = [f64; 2];

/// Two values with zero between them, and the one before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bracket {
    /// The newest one.
    pub new: Tried,
    /// The nearest one on the other side.
    pub other: Tried,
    /// The one that was given up last.
    before: Option<Tried>,
}

impl Bracket {
    /// That of two values on both sides of zero.
    pub fn new(a: Tried, b: Tried) -> Self {
        Self { new: a, other: b, before: None }
    }

    /// Its length.
    pub fn length(&self) -> f64 {
        (self.new[0] - self.other[0]).abs()
    }

    /// Where to look next.
    pub fn next(&self) -> f64 {
        let ([x1, f1], [x2, f2]) = (self.new, self.other);
        let share = match self.before {
            None => f1 / (f1 - f2),
            Some([x3, f3]) => {
                let (xi, phi) = ((x1 - x2) / (x3 - x2), (f1 - f2) / (f3 - f2));
                let is_safe = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
                let through = f1 / (f2 - f1) * f3 / (f2 - f3)
                    + (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2);
                if is_safe { through } else { 0.5 }
            }
        };
        let share = if share > 0.0 && share < 1.0 { share } else { 0.5 };
        x1 + share * (x2 - x1)
    }

    /// Takes a value between its ends.
    pub fn take(&mut self, tried: Tried) {
        if tried[1] * self.new[1] > 0.0 {
            self.before = Some(self.new);
        } else {
            self.before = Some(self.other);
            self.other = self.new;
        }
        self.new = tried;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Evaluations until a function is small between two values.
    fn evaluations(function: &dyn Fn(f64) -> f64, [a, b]: [f64; 2]) -> usize {
        let mut bracket = Bracket::new([a, function(a)], [b, function(b)]);
        let mut count = 0;
        while bracket.new[1].abs() > 1e-9 && bracket.length() > 1e-12 && count < 200 {
            let next = bracket.next();
            bracket.take([next, function(next)]);
            assert!(bracket.new[1] * bracket.other[1] <= 0.0);
            count += 1;
        }
        count
    }

    /// Requirement: smooth functions take a handful of values, kinks and flat zeros no more than a few
    /// times those of halves, and a jump is drawn together.
    #[test]
    fn zeros_are_closed_in() {
        let smooth: [&dyn Fn(f64) -> f64; 3] =
            [&|x| x * x * x - 2.0, &|x| x.exp() - 3.0, &|x| 1.0 / x - 0.8];
        for function in smooth {
            let count = evaluations(function, [0.2, 3.0]);
            assert!(count <= 9, "{count}");
        }
        let hard: [&dyn Fn(f64) -> f64; 3] = [
            &|x| if x < 1.3 { 1e-3 * (x - 1.3) } else { 5.0 * (x - 1.3) },
            &|x: f64| (x - 1.1).powi(9),
            &|x| if x < 1.7 { -1.0 } else { 2.0 },
        ];
        for function in hard {
            let count = evaluations(function, [0.2, 3.0]);
            assert!(count <= 100, "{count}");
        }
    }
}
