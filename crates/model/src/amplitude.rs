//! Curves over time.

use slideline_diag::Span;

/// `*AMPLITUDE`: factor against time, linear between its points and constant
/// outside them.
#[derive(Clone, Debug, PartialEq)]
pub struct Amplitude {
    /// Name, upper case.
    pub name: String,
    /// (time in the step [T], factor [1]), times ascending; at least one.
    pub points: Vec<(f64, f64)>,
    /// The card.
    pub origin: Span,
}

impl Amplitude {
    /// Factor at a time of the step.
    pub fn at(&self, time: f64) -> f64 {
        let after = self.points.partition_point(|&(t, _)| t <= time);
        match (after.checked_sub(1).map(|k| self.points[k]), self.points.get(after)) {
            (None, Some(&(_, first))) => first,
            (Some((_, last)), None) => last,
            (Some((t0, a0)), Some(&(t1, a1))) => a0 + (a1 - a0) * (time - t0) / (t1 - t0),
            (None, None) => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_between_and_constant_outside() {
        let ramp = Amplitude {
            name: "A".into(),
            points: vec![(1.0, 2.0), (3.0, 6.0)],
            origin: Span::default(),
        };
        assert_eq!([0.0, 1.0, 2.0, 3.0, 9.0].map(|t| ramp.at(t)), [2.0, 2.0, 4.0, 6.0, 6.0]);
    }
}
