//! An axis: which values it spans, where its ticks stand.

/// Where a fixed axis begins and ends. `from` stands at the left or lower end,
/// whichever number is larger.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Value at the left or lower end.
    pub from: f64,
    /// Value at the right or upper end.
    pub to: f64,
    /// Distance of ticks, positive.
    pub step: f64,
    /// Decimals of the numbers.
    pub decimals: usize,
}

/// What an axis shows and how.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Title, with the unit.
    pub title: String,
    /// Equal ratios, not equal differences, are equally long. Values that are
    /// not positive are left out.
    pub logarithmic: bool,
    /// What it spans; `None`: the values there are, with a little room.
    pub span: Option<Span>,
}

impl Axis {
    /// An axis on which equal differences are equally long.
    pub fn linear(title: impl Into<String>) -> Self {
        Self { title: title.into(), logarithmic: false, span: None }
    }

    /// An axis on which equal ratios are equally long.
    pub fn logarithmic(title: impl Into<String>) -> Self {
        Self { logarithmic: true, ..Self::linear(title) }
    }

    /// A linear axis that spans what it is told.
    pub fn fixed(
        title: impl Into<String>,
        [from, to]: [f64; 2],
        step: f64,
        decimals: usize,
    ) -> Self {
        Self { span: Some(Span { from, to, step, decimals }), ..Self::linear(title) }
    }

    /// Whether a value has a place on the axis.
    pub(crate) fn shows(&self, value: f64) -> bool {
        value.is_finite() && (!self.logarithmic || value > 0.0)
    }

    /// The axis around values.
    pub(crate) fn around(&self, values: impl Iterator<Item = f64>) -> Scale {
        let seen = values.filter(|value| self.shows(*value));
        let (logarithmic, span) = (self.logarithmic, self.span);
        let ends = match span {
            Some(Span { from, to, .. }) => [from, to],
            None => padded(seen.map(|value| if logarithmic { value.log10() } else { value })),
        };
        Scale { ends, logarithmic, span }
    }
}

/// The values, or their decimal logarithms, between the ends of an axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    ends: [f64; 2],
    logarithmic: bool,
    span: Option<Span>,
}

impl Scale {
    /// Place of a value, 0 at the lower end, 1 at the upper.
    pub fn place(&self, value: f64) -> f64 {
        let [low, high] = self.ends;
        let value = if self.logarithmic { value.log10() } else { value };
        (value - low) / (high - low)
    }

    /// Round numbers between the ends, about `count` of them where the axis is
    /// not fixed, each with its words.
    pub fn ticks(&self, count: f64) -> Vec<(f64, String)> {
        let minus = |words: String| words.replace('-', "\u{2212}");
        let Some(Span { from, to, step, decimals }) = self.span else {
            let values =
                if self.logarithmic { decades(self.ends) } else { ticks(self.ends, count) };
            return values.into_iter().map(|value| (value, minus(general(value)))).collect();
        };
        let pieces = ((to - from).abs() / step + 1e-9).floor() as i32;
        let sign = (to - from).signum();
        let values = (0..=pieces).map(|i| from + sign * step * f64::from(i));
        let number = |value: f64| {
            // the tick next to zero may carry a rounding error
            let shown = if value.abs() < 1e-9 * step { 0.0 } else { value };
            (value, minus(format!("{shown:.decimals$}")))
        };
        values.map(number).collect()
    }
}

/// At most six digits; an exponent only where the plain text would be long.
fn general(value: f64) -> String {
    let value: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    match value.abs() {
        0.0 => "0".to_owned(), // also for -0
        1e-4..1e6 => format!("{value}"),
        _ => format!("{value:e}"),
    }
}

fn padded(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let (low, high) =
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    if low > high {
        return [0.0, 1.0];
    }
    let pad = if high > low { 0.04 * (high - low) } else { (0.1 * high.abs()).max(1e-12) };
    [low - pad, high + pad]
}

fn ticks([low, high]: [f64; 2], count: f64) -> Vec<f64> {
    let raw = (high - low) / count;
    let power = 10_f64.powf(raw.log10().floor());
    let lead = raw / power;
    let step = power * [1.0, 2.0, 5.0].into_iter().find(|s| lead <= *s).unwrap_or(10.0);
    let first = (low / step).ceil() as i64;
    (0..30).map(|k| (first + k) as f64 * step).take_while(|value| *value <= high).collect()
}

/// Powers of ten; with 2 and 5 times them where there are few, only every
/// other one or fewer where there are many.
fn decades([low, high]: [f64; 2]) -> Vec<f64> {
    let leads: &[f64] = if high - low < 2.5 { &[1.0, 2.0, 5.0] } else { &[1.0] };
    let every = ((high - low) / 8.0).ceil().max(1.0) as i32;
    let (first, last) = (low.floor() as i32, high.ceil() as i32);
    let powers = (first..=last).filter(|power| power.rem_euclid(every) == 0);
    powers
        .flat_map(|power| leads.iter().map(move |lead| lead * 10_f64.powi(power)))
        .filter(|value| (low..=high).contains(&value.log10()))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        let found = ticks([-0.0312, 0.0012], 7.0);
        let expected = [-0.03, -0.025, -0.02, -0.015, -0.01, -0.005, 0.0];
        assert_eq!(found.len(), expected.len(), "{found:?}");
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
    }

    #[test]
    fn logarithmic_ticks_are_powers_of_ten_and_with_few_of_them_more() {
        let axis = Axis::logarithmic("elements");
        let few = axis.around([12.0, 192.0, 0.0, -1.0, f64::NAN].into_iter());
        let words: Vec<String> = few.ticks(7.0).into_iter().map(|(_, words)| words).collect();
        assert_eq!(words, ["20", "50", "100", "200"]);
        assert!((few.place(48.0) - 0.5).abs() < 1e-12, "the geometric mean is in the middle");
        let many = axis.around([1e-16, 1.0].into_iter());
        assert!(many.ticks(7.0).iter().all(|(tick, _)| (tick.log10() / 3.0).fract().abs() < 1e-9));
        assert!((3..=8).contains(&many.ticks(7.0).len()), "{:?}", many.ticks(7.0));
    }

    #[test]
    fn ticks_run_from_one_end_to_the_other_either_way() {
        let scale = |from, to| Axis::fixed("", [from, to], 10.0, 0).around(std::iter::empty());
        let values =
            |scale: Scale| scale.ticks(7.0).into_iter().map(|(v, _)| v).collect::<Vec<_>>();
        assert_eq!(values(scale(0.0, -30.0)), [0.0, -10.0, -20.0, -30.0]);
        assert_eq!(values(scale(-30.0, 5.0)), [-30.0, -20.0, -10.0, 0.0]);
        assert_eq!(scale(0.0, -30.0).ticks(7.0)[1].1, "\u{2212}10");
        assert_eq!(scale(0.0, -30.0).place(-15.0), 0.5);
    }
}
