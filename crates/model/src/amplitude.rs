//! Curves over time.
//!
//! ```text
//!   tabular        smooth step      periodic
//!      /\__             __           _   _
//!   __/             __/            / \_/ \
//! ```

use slideline_diag::Span;

/// `*AMPLITUDE`: factor against time.
#[derive(Clone, Debug, PartialEq)]
pub struct Amplitude {
    /// Name, upper case.
    pub name: String,
    /// The curve.
    pub curve: Curve,
    /// What is added to the time of the step [T]: where the step begins, for a curve over the
    /// total time.
    pub begins: f64,
    /// Whether it runs over the total time.
    pub total: bool,
    /// The card.
    pub origin: Span,
}

/// How the factor depends on time.
#[derive(Clone, Debug, PartialEq)]
pub enum Curve {
    /// (time [T], factor [1]), times ascending, at least one: linear between them and constant
    /// outside.
    Tabular(Vec<(f64, f64)>),
    /// The same points; between them x^3 (10 - 15 x + 6 x^2), which starts and ends at rest.
    SmoothStep(Vec<(f64, f64)>),
    /// A0 + sum A_n cos n w (t - t0) + B_n sin n w (t - t0) from t0 on, A0 before.
    Periodic {
        /// Angular frequency w [1/T].
        frequency: f64,
        /// Start t0 [T].
        start: f64,
        /// A0 [1].
        mean: f64,
        /// (A_n, B_n) [1].
        terms: Vec<(f64, f64)>,
    },
    /// A0 + A sin w1 (t - t0) sin w2 (t - t0) from t0 on, A0 before.
    Modulated {
        /// A0 [1].
        mean: f64,
        /// A [1].
        swing: f64,
        /// Start t0 [T].
        start: f64,
        /// Angular frequencies w1, w2 [1/T].
        frequencies: (f64, f64),
    },
    /// A0 + A exp(-(t - t0)/td) from t0 on, A0 before.
    Decay {
        /// A0 [1].
        mean: f64,
        /// A [1].
        swing: f64,
        /// Start t0 [T].
        start: f64,
        /// Decay time td [T].
        time: f64,
    },
}

impl Curve {
    /// The same curve, later by a time [T].
    pub fn delayed(&self, by: f64) -> Self {
        let mut later = self.clone();
        match &mut later {
            Self::Tabular(points) | Self::SmoothStep(points) => {
                points.iter_mut().for_each(|(time, _)| *time += by);
            }
            Self::Periodic { start, .. }
            | Self::Modulated { start, .. }
            | Self::Decay { start, .. } => *start += by,
        }
        later
    }

    /// The same curve with its times and its factors multiplied [1].
    pub fn scaled(mut self, time: f64, factor: f64) -> Self {
        match &mut self {
            Self::Tabular(points) | Self::SmoothStep(points) => {
                points.iter_mut().for_each(|own| *own = (own.0 * time, own.1 * factor));
            }
            Self::Periodic { frequency, start, mean, terms } => {
                (*frequency, *start, *mean) = (*frequency / time, *start * time, *mean * factor);
                terms.iter_mut().for_each(|own| *own = (own.0 * factor, own.1 * factor));
            }
            Self::Modulated { mean, swing, start, frequencies: (first, second) } => {
                (*mean, *swing, *start) = (*mean * factor, *swing * factor, *start * time);
                (*first, *second) = (*first / time, *second / time);
            }
            Self::Decay { mean, swing, start, time: own } => {
                (*mean, *swing) = (*mean * factor, *swing * factor);
                (*start, *own) = (*start * time, *own * time);
            }
        }
        self
    }
}

impl Amplitude {
    /// A table over the time of a step.
    pub fn tabular(name: &str, points: Vec<(f64, f64)>, origin: Span) -> Self {
        let (name, curve) = (name.to_owned(), Curve::Tabular(points));
        Self { name, curve, begins: 0.0, total: false, origin }
    }

    /// The factor of largest magnitude that it may reach [1].
    pub fn largest(&self) -> f64 {
        let larger = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
        match &self.curve {
            Curve::Tabular(points) | Curve::SmoothStep(points) => {
                let all = points.iter().map(|&(_, factor)| factor);
                all.reduce(larger).unwrap_or(1.0)
            }
            Curve::Periodic { mean, terms, .. } => {
                let swing: f64 = terms.iter().map(|(a, b)| a.hypot(*b)).sum();
                larger(mean + swing, mean - swing)
            }
            Curve::Modulated { mean, swing, .. } => larger(mean + swing, mean - swing),
            Curve::Decay { mean, swing, .. } => larger(mean + swing, *mean),
        }
    }

    /// Factor at a time of the step.
    pub fn at(&self, time: f64) -> f64 {
        let time = time + self.begins;
        match &self.curve {
            Curve::Tabular(points) => between(points, time, |x| x),
            Curve::SmoothStep(points) => {
                between(points, time, |x| x * x * x * (10.0 + x * (6.0 * x - 15.0)))
            }
            Curve::Periodic { frequency, start, mean, terms } => {
                let angle = frequency * (time - start).max(0.0);
                let sum = terms.iter().zip(1_u32..).map(|((a, b), n)| {
                    let (sin, cos) = (f64::from(n) * angle).sin_cos();
                    a * cos + b * sin
                });
                if time < *start { *mean } else { mean + sum.sum::<f64>() }
            }
            Curve::Modulated { mean, swing, start, frequencies: (first, second) } => {
                let since = (time - start).max(0.0);
                mean + swing * (first * since).sin() * (second * since).sin()
            }
            Curve::Decay { mean, swing, start, time: decay } => {
                let part = if time < *start { 0.0 } else { (-(time - start) / decay).exp() };
                mean + swing * part
            }
        }
    }
}

/// The factor between the points around a time, by the part of the way between them.
fn between(points: &[(f64, f64)], time: f64, way: fn(f64) -> f64) -> f64 {
    let after = points.partition_point(|&(t, _)| t <= time);
    match (after.checked_sub(1).map(|k| points[k]), points.get(after)) {
        (None, Some(&(_, first))) => first,
        (Some((_, last)), None) => last,
        (Some((t0, a0)), Some(&(t1, a1))) => a0 + (a1 - a0) * way((time - t0) / (t1 - t0)),
        (None, None) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_between_and_constant_outside() {
        let ramp = Amplitude::tabular("A", vec![(1.0, 2.0), (3.0, 6.0)], Span::default());
        assert_eq!([0.0, 1.0, 2.0, 3.0, 9.0].map(|t| ramp.at(t)), [2.0, 2.0, 4.0, 6.0, 6.0]);
        let total = Amplitude { begins: 1.0, ..ramp };
        assert_eq!([0.0, 1.0, 2.0].map(|t| total.at(t)), [2.0, 4.0, 6.0]);
    }

    /// Requirement: a delayed curve has every value later by its delay, whatever its kind.
    #[test]
    fn a_delayed_curve_comes_later() {
        let curves = [
            Curve::Tabular(vec![(1.0, 2.0), (3.0, 6.0)]),
            Curve::SmoothStep(vec![(1.0, 2.0), (3.0, 6.0)]),
            Curve::Periodic { frequency: 2.0, start: 1.0, mean: 0.25, terms: vec![(0.5, 1.0)] },
            Curve::Modulated { mean: 1.0, swing: 2.0, start: 0.5, frequencies: (3.0, 5.0) },
            Curve::Decay { mean: 1.0, swing: 2.0, start: 0.5, time: 4.0 },
        ];
        for curve in curves {
            let later = curve.delayed(0.75);
            let own = Amplitude { curve, ..Amplitude::tabular("A", vec![], Span::default()) };
            let later = Amplitude { curve: later, ..own.clone() };
            for time in [0.0, 0.3, 0.5, 1.0, 1.7, 2.6, 4.0] {
                let difference = later.at(time + 0.75) - own.at(time);
                assert!(difference.abs() < 1e-14, "{:?} at {time}", own.curve);
            }
        }
    }

    /// Requirement: the smooth step is at rest at its points and half way in the middle; the
    /// periodic curve is its series. Source: Abaqus manual, `*AMPLITUDE`.
    #[test]
    fn smooth_and_periodic_curves() {
        let ramp = Amplitude::tabular("A", vec![], Span::default());
        let smooth =
            Amplitude { curve: Curve::SmoothStep(vec![(1.0, 2.0), (3.0, 6.0)]), ..ramp.clone() };
        assert_eq!([0.0, 1.0, 2.0, 3.0, 4.0].map(|t| smooth.at(t)), [2.0, 2.0, 4.0, 6.0, 6.0]);
        assert!((smooth.at(1.001) - 2.0).abs() < 1e-7);
        let terms = vec![(0.5, 1.0), (0.0, 2.0)];
        let curve = Curve::Periodic { frequency: 2.0, start: 1.0, mean: 0.25, terms };
        let wave = Amplitude { curve, ..ramp };
        assert_eq!([0.5, 1.0].map(|t| wave.at(t)), [0.25, 0.75]);
        let (s, c) = f64::sin_cos(0.6);
        let expected = 0.25 + 0.5 * c + s + 2.0 * f64::sin(1.2);
        assert!((wave.at(1.3) - expected).abs() < 1e-15);
        let curve = Curve::Decay { mean: 1.0, swing: 2.0, start: 0.5, time: 4.0 };
        let fading = Amplitude { curve, ..wave.clone() };
        assert_eq!([0.4, 0.5].map(|t| fading.at(t)), [1.0, 3.0]);
        assert!((fading.at(4.5) - 1.0 - 2.0 / std::f64::consts::E).abs() < 1e-15);
        let curve = Curve::Modulated { mean: 1.0, swing: 2.0, start: 0.5, frequencies: (3.0, 5.0) };
        let beat = Amplitude { curve, ..wave };
        assert_eq!([0.4, 0.5].map(|t| beat.at(t)), [1.0, 1.0]);
        assert!((beat.at(0.7) - 1.0 - 2.0 * f64::sin(0.6) * f64::sin(1.0)).abs() < 1e-15);
        assert_eq!([fading.largest(), beat.largest()], [3.0, 3.0]);
    }
}
