//! What a claim measures: numbers with what is required of them, and charts.

use crate::metrics::{order, peak};
use slideline::output::number::general;
use slideline::output::plot::{Axis, Mark, Panel, Series};

/// What is required of a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    /// Not above.
    AtMost(f64),
    /// Not below.
    AtLeast(f64),
    /// Between, ends included.
    Within(f64, f64),
    /// This number.
    Equal(f64),
    /// A statement is true: 1.
    True,
    /// Nothing: it is told for the reader.
    Told,
}

/// A number that was measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// What it is, with its unit; or a statement.
    pub quantity: String,
    /// How large it is.
    pub value: f64,
    /// What is required of it.
    pub limit: Limit,
}

impl Measured {
    /// Whether it is as required; what is not a number never is.
    pub fn holds(&self) -> bool {
        match self.limit {
            Limit::AtMost(limit) => self.value <= limit,
            Limit::AtLeast(limit) => self.value >= limit,
            Limit::Within(low, high) => (low..=high).contains(&self.value),
            Limit::Equal(limit) => self.value == limit,
            Limit::True => self.value == 1.0,
            Limit::Told => !self.value.is_nan(),
        }
    }

    /// The number in words.
    pub fn found(&self) -> String {
        match self.limit {
            Limit::True => if self.value == 1.0 { "true" } else { "false" }.to_owned(),
            _ => general(self.value, 4).to_string(),
        }
    }

    /// The requirement in words; empty where there is none.
    pub fn required(&self) -> String {
        let words = |value| general(value, 4);
        match self.limit {
            Limit::AtMost(limit) => format!("at most {}", words(limit)),
            Limit::AtLeast(limit) => format!("at least {}", words(limit)),
            Limit::Within(low, high) => format!("{} to {}", words(low), words(high)),
            Limit::Equal(limit) => words(limit).to_string(),
            Limit::True => "true".to_owned(),
            Limit::Told => String::new(),
        }
    }

    /// Which part of what is allowed is used, where that can be said.
    pub fn used(&self) -> Option<f64> {
        match self.limit {
            Limit::AtMost(limit) if limit > 0.0 && self.value >= 0.0 => Some(self.value / limit),
            Limit::AtLeast(limit) if limit > 0.0 && self.value > 0.0 => Some(limit / self.value),
            _ => None,
        }
    }
}

/// A chart under its title.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// What it shows.
    pub title: String,
    /// Frames, below one another.
    pub panels: Vec<Panel>,
}

/// A curve by its name.
pub type Named<'a> = (&'a str, &'a [f64]);

/// Errors over the number of elements, by name.
#[derive(Clone, Debug, PartialEq)]
pub struct Study {
    /// What is refined.
    pub name: String,
    /// Elements and error of each mesh.
    pub points: Vec<[f64; 2]>,
}

impl Study {
    /// Observed order: how fast the error falls with the number of elements
    /// (least squares slope of the logarithms).
    pub fn order(&self) -> f64 {
        -order(&self.points)
    }
}

/// What a claim has measured so far.
#[derive(Clone, Debug, Default)]
pub struct Record {
    measured: Vec<Measured>,
    charts: Vec<Chart>,
}

impl Record {
    /// The numbers, in the order in which they were recorded.
    pub fn measured(&self) -> &[Measured] {
        &self.measured
    }

    /// The charts.
    pub fn charts(&self) -> &[Chart] {
        &self.charts
    }

    /// A number that may not exceed `limit`.
    pub fn at_most(&mut self, quantity: impl Into<String>, value: f64, limit: f64) {
        self.push(quantity, value, Limit::AtMost(limit));
    }

    /// A number that may not fall below `limit`.
    pub fn at_least(&mut self, quantity: impl Into<String>, value: f64, limit: f64) {
        self.push(quantity, value, Limit::AtLeast(limit));
    }

    /// A number that lies between two others.
    pub fn within(&mut self, quantity: impl Into<String>, value: f64, [low, high]: [f64; 2]) {
        self.push(quantity, value, Limit::Within(low, high));
    }

    /// A count that must be met.
    pub fn equal(&mut self, quantity: impl Into<String>, value: usize, required: usize) {
        self.push(quantity, value as f64, Limit::Equal(required as f64));
    }

    /// A statement that must be true.
    pub fn holds(&mut self, statement: impl Into<String>, truth: bool) {
        self.push(statement, f64::from(u8::from(truth)), Limit::True);
    }

    /// A number of which nothing is required.
    pub fn tell(&mut self, quantity: impl Into<String>, value: f64) {
        self.push(quantity, value, Limit::Told);
    }

    fn push(&mut self, quantity: impl Into<String>, value: f64, limit: Limit) {
        self.measured.push(Measured { quantity: quantity.into(), value, limit });
    }

    /// A chart of one frame, its series in colours in their order.
    pub fn chart(&mut self, title: impl Into<String>, x: Axis, y: Axis, series: Vec<Series>) {
        let coloured = series.into_iter().enumerate();
        let series = coloured.map(|(colour, series)| Series { colour, ..series }).collect();
        self.frame(title, x, y, series);
    }

    fn frame(&mut self, title: impl Into<String>, x: Axis, y: Axis, series: Vec<Series>) {
        let panels = vec![Panel { x, y, height: 280.0, series }];
        self.charts.push(Chart { title: title.into(), panels });
    }

    /// Curves over `x`, and below how far they are from the reference, in
    /// percent of its peak. `axes` are the titles of both axes.
    pub fn comparison(
        &mut self,
        title: impl Into<String>,
        axes: [&str; 2],
        x: &[f64],
        curves: &[Named<'_>],
        reference: Named<'_>,
    ) {
        let (exact, scale) = (reference.1, 100.0 / peak(reference.1));
        let coloured = || curves.iter().enumerate();
        let curve = |(colour, curve): (usize, &Named<'_>)| Series { colour, ..series(x, *curve) };
        let mut upper: Vec<Series> = coloured().map(curve).collect();
        let colour = curves.len();
        upper.push(Series { mark: Mark::Guide, colour, ..series(x, reference) });
        let rest = |(colour, &(_, values)): (usize, &Named<'_>)| {
            let rest: Vec<f64> = values.iter().zip(exact).map(|(a, b)| scale * (a - b)).collect();
            Series { colour, ..series(x, ("", &rest)) }
        };
        let lower = coloured().map(rest).collect();
        let panel = |y: &str, height, series| Panel {
            x: Axis::linear(axes[0]),
            y: Axis::linear(y),
            height,
            series,
        };
        let panels =
            vec![panel(axes[1], 260.0, upper), panel("difference (% of peak)", 150.0, lower)];
        self.charts.push(Chart { title: title.into(), panels });
    }

    /// Errors over the number of elements, with the slopes that fit them.
    pub fn convergence(&mut self, title: impl Into<String>, error: &str, studies: &[Study]) {
        let coloured = || studies.iter().enumerate();
        let measured = coloured().map(|(colour, study)| Series {
            name: format!("{}: order {:.2}", study.name, study.order()),
            points: study.points.clone(),
            mark: Mark::Discs,
            colour,
        });
        let slopes = coloured().map(|(colour, study)| Series {
            name: String::new(),
            points: fitted(&study.points),
            mark: Mark::Guide,
            colour,
        });
        let series = measured.chain(slopes).collect();
        self.frame(title, Axis::logarithmic("elements"), Axis::logarithmic(error), series);
    }
}

/// A curve over `x` with its points.
pub fn series(x: &[f64], (name, y): Named<'_>) -> Series {
    let points = x.iter().zip(y).map(|(x, y)| [*x, *y]).collect();
    Series { name: name.to_owned(), points, mark: Mark::Curve, colour: 0 }
}

/// Ends of the line that fits the logarithms best.
fn fitted(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let slope = order(points);
    let mean = |k: usize| points.iter().map(|p| p[k].ln()).sum::<f64>() / points.len() as f64;
    let at = |x: f64| [x, (mean(1) + slope * (x.ln() - mean(0))).exp()];
    let xs = points.iter().map(|p| p[0]);
    let (low, high) = xs.fold((f64::INFINITY, 0.0_f64), |(l, h), x| (l.min(x), h.max(x)));
    vec![at(low), at(high)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: every kind of limit, met and missed, and in words.
    #[test]
    fn limits() {
        let one = |value, limit| Measured { quantity: "q".into(), value, limit };
        for (limit, good, bad, words) in [
            (Limit::AtMost(2.0), 2.0, 2.1, "at most 2"),
            (Limit::AtLeast(2.0), 2.0, 1.9, "at least 2"),
            (Limit::Within(1.0, 2.0), 1.5, 0.5, "1 to 2"),
            (Limit::Equal(3.0), 3.0, 4.0, "3"),
            (Limit::True, 1.0, 0.0, "true"),
            (Limit::Told, 1.0, f64::NAN, ""),
        ] {
            assert!(one(good, limit).holds() && !one(bad, limit).holds(), "{limit:?}");
            assert!(!one(f64::NAN, limit).holds(), "{limit:?}");
            assert_eq!(one(good, limit).required(), words);
        }
        assert_eq!(one(0.5, Limit::AtMost(2.0)).used(), Some(0.25));
        assert_eq!(one(8.0, Limit::AtLeast(2.0)).used(), Some(0.25));
        assert_eq!(one(8.0, Limit::Equal(8.0)).used(), None);
    }

    /// Requirement: the order of a power law is its exponent, and the fitted
    /// line goes through its points.
    #[test]
    fn order_of_a_power_law() {
        let points = [12.0, 24.0, 48.0].map(|n: f64| [n, 3.0 / (n * n)]).to_vec();
        let study = Study { name: "s".into(), points: points.clone() };
        assert!((study.order() - 2.0).abs() < 1e-12);
        let line = fitted(&points);
        assert!((line[0][1] / points[0][1] - 1.0).abs() < 1e-12);
        assert!((line[1][1] / points[2][1] - 1.0).abs() < 1e-12);
        let mut record = Record::default();
        record.convergence("c", "error", &[study]);
        assert_eq!(record.charts()[0].panels[0].series[0].name, "s: order 2.00");
    }
}
