//! A run on a terminal: a table that grows, and a last line below it.
//!
//! ```text
//!   STEP   INC        TIME  ITER  CLOSED   RESIDUAL       9999.U2      9999.RF2
//!      1     1        0.05     4       1    1.2e-09       -0.0015   -0.01203451
//!   [#########-----------]  45 %  0:03 left  9999.RF2 __..--==
//! ```
//!
//! Nothing is wider than the terminal: a line that wraps could not be taken
//! back, and a table that wraps cannot be read.

use slideline::output::number::general;
use std::fmt::Write as _;
use std::time::{Duration, Instant};

/// Most signs of the curve.
const CURVE: usize = 24;
/// Fewer signs than these are no curve.
const LEAST_CURVE: usize = 4;
/// Terminals narrower than this lose columns of the table.
const ROOMY: usize = 76;

/// What a row of the table tells.
#[derive(Clone, Debug, Default)]
pub(crate) struct Row {
    pub step: usize,
    pub increment: usize,
    /// Total time [T].
    pub time: f64,
    pub iterations: usize,
    /// Closed contact points.
    pub closed: usize,
    /// Largest residual [F].
    pub residual: f64,
    /// Driven motion and its reaction.
    pub driven: Option<[f64; 2]>,
}

/// Heading of the table; `names` are those of the driven motion and reaction.
pub(crate) fn heading(width: usize, names: Option<&[String; 2]>) -> String {
    let numbers = ["STEP", "INC", "TIME", "ITER", "CLOSED", "RESIDUAL"].map(str::to_owned);
    laid_out(width, &numbers, names)
}

impl Row {
    /// The row as a line of the table.
    pub fn line(&self, width: usize) -> String {
        let digits = if width < ROOMY { 4 } else { 6 };
        let numbers = [
            self.step.to_string(),
            self.increment.to_string(),
            general(self.time, digits).to_string(),
            self.iterations.to_string(),
            self.closed.to_string(),
            general(self.residual, 3).to_string(),
        ];
        let driven = self.driven.map(|driven| driven.map(|value| general(value, 7).to_string()));
        laid_out(width, &numbers, driven.as_ref())
    }
}

/// A line of the table: the motion goes first where there is little room,
/// then the residual.
fn laid_out(width: usize, numbers: &[String; 6], driven: Option<&[String; 2]>) -> String {
    let [step, increment, time, iterations, closed, residual] = numbers;
    let room = if width < ROOMY { 9 } else { 11 };
    let mut line = format!("{step:>4} {increment:>5} {time:>room$} {iterations:>5} {closed:>7}");
    if width >= 60 {
        let _ = write!(line, " {residual:>10}"); // a String takes any text
    }
    if let Some([motion, reaction]) = driven {
        if width >= ROOMY {
            let _ = write!(line, " {motion:>13}"); // as above
        }
        let _ = write!(line, " {reaction:>13}"); // as above
    }
    line
}

/// What the last line tells.
pub(crate) struct Live {
    began: Instant,
    /// Total time of all steps [T].
    whole: f64,
    /// Total time reached [T].
    reached: f64,
    /// Name of the driven reaction; empty without one.
    name: String,
    reactions: Vec<f64>,
    /// Whether the terminal shows more than ASCII.
    unicode: bool,
}

impl Live {
    /// A run that begins now.
    pub fn new() -> Self {
        let (whole, reached, name, reactions) = (0.0, 0.0, String::new(), Vec::new());
        Self { began: Instant::now(), whole, reached, name, reactions, unicode: unicode() }
    }

    /// A step begins: all steps together take `whole`; the curve is that of `name`.
    pub fn step(&mut self, whole: f64, name: Option<String>) {
        self.whole = whole;
        if let Some(name) = name
            && name != self.name
        {
            self.name = name;
            self.reactions.clear();
        }
    }

    /// An increment has converged.
    pub fn increment(&mut self, total_time: f64, reaction: Option<f64>) {
        self.reached = total_time;
        self.reactions.extend(reaction);
    }

    /// The last line, without its end.
    pub fn line(&self, width: usize) -> String {
        self.line_after(self.began.elapsed(), width)
    }

    fn line_after(&self, elapsed: Duration, width: usize) -> String {
        let part = if self.whole > 0.0 { (self.reached / self.whole).clamp(0.0, 1.0) } else { 0.0 };
        let (full, empty) = if self.unicode { ('\u{2588}', '\u{2591}') } else { ('#', '-') };
        let signs = if width < ROOMY { 10 } else { 20 };
        let full_signs = (1..=signs).filter(|&k| k as f64 <= part * signs as f64 + 1e-9).count();
        let bar = (0..signs).map(|k| if k < full_signs { full } else { empty });
        let mut line = format!("[{}] {:>3.0} %", bar.collect::<String>(), 100.0 * part);
        if part > 0.0 && part < 1.0 {
            let left = elapsed.as_secs_f64() * (1.0 - part) / part;
            let _ = write!(line, "  {} left", clock(left)); // a String takes any text
        }
        let taken = line.chars().count() + self.name.chars().count() + 3;
        let room = width.saturating_sub(taken + 1).min(CURVE);
        if !self.name.is_empty() && !self.reactions.is_empty() && room >= LEAST_CURVE {
            let _ = write!(line, "  {} {}", self.name, self.curve(room)); // as above
        }
        line.chars().take(width.saturating_sub(1)).collect()
    }

    /// The reactions as a curve of signs, the whole run in at most `most` of
    /// them; a sign is the mean of what falls into it.
    fn curve(&self, most: usize) -> String {
        let count = self.reactions.len();
        let signs = count.min(most);
        let means: Vec<f64> = (0..signs)
            .map(|k| &self.reactions[k * count / signs..(k + 1) * count / signs])
            .map(|part| part.iter().sum::<f64>() / part.len().max(1) as f64)
            .collect();
        let low = means.iter().copied().fold(f64::INFINITY, f64::min);
        let high = means.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let levels: Vec<char> = if self.unicode {
            ('\u{2581}'..='\u{2588}').collect()
        } else {
            "_.-~+=*#".chars().collect()
        };
        let sign = |value: &f64| {
            let place = if high > low { (value - low) / (high - low) } else { 0.0 };
            let level = (1..levels.len()).filter(|&k| place * 8.0 >= k as f64).count();
            levels.get(level).copied().unwrap_or(' ')
        };
        means.iter().map(sign).collect()
    }
}

/// `0:03`, `1:02:03`.
fn clock(seconds: f64) -> String {
    let seconds = Duration::try_from_secs_f64(seconds).map_or(0, |left| left.as_secs());
    let (hours, minutes, seconds) = (seconds / 3600, seconds / 60 % 60, seconds % 60);
    if hours > 0 {
        format!("{hours}:{minutes:02}:{seconds:02}")
    } else {
        format!("{minutes}:{seconds:02}")
    }
}

/// Whether the locale is one of UTF-8.
fn unicode() -> bool {
    let said = ["LC_ALL", "LC_CTYPE", "LANG"]
        .iter()
        .find_map(|name| std::env::var(name).ok().filter(|value| !value.is_empty()));
    said.is_some_and(|value| value.to_lowercase().replace('-', "").contains("utf8"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: share, time left at the pace so far, and the curve from
    /// its lowest to its highest value; no wider than a terminal of 80.
    #[test]
    fn the_line_tells_share_time_left_and_curve() {
        let mut live = Live { unicode: false, ..Live::new() };
        live.step(2.0, Some("9999.RF2".to_owned()));
        for k in 1_u32..=8 {
            live.increment(f64::from(k) / 16.0, Some(-f64::from(k)));
        }
        let line = live.line_after(Duration::from_secs(30), 80);
        assert_eq!(line, "[#####---------------]  25 %  1:30 left  9999.RF2 #*=+~-._");
        for k in 0_u32..1000 {
            live.increment(0.5, Some(f64::from(k)));
        }
        for width in [20, 40, 60, 75, 76, 80, 200] {
            let line = live.line_after(Duration::from_secs(360_000), width);
            assert!(line.len() < width, "{width}: {line}");
        }
        let line = live.line_after(Duration::from_secs(30), 60);
        assert!(line.starts_with("[##--------]  25 %  1:30 left  9999.RF2 __"), "{line}");
        assert!(line.ends_with('#') && line.len() == 59, "{line}");
        assert_eq!(clock(3723.9), "1:02:03");
    }

    /// Requirement: at 80 columns the table has all there is, at 60 increment,
    /// time, iterations, contact points, residual and reaction; headings stand
    /// over their numbers, and no number, however long, makes a line wrap.
    #[test]
    fn the_table_fits_the_terminal() {
        let names = ["9999.U2".to_owned(), "9999.RF2".to_owned()];
        let row = Row {
            step: 1,
            increment: 12,
            time: 0.6,
            iterations: 4,
            closed: 1,
            residual: 1.234e-9,
            driven: Some([-0.018, -1.234_567_8]),
        };
        assert_eq!(
            [heading(80, Some(&names)), row.line(80)],
            [
                "STEP   INC        TIME  ITER  CLOSED   RESIDUAL       9999.U2      9999.RF2",
                "   1    12         0.6     4       1    1.23e-9        -0.018     -1.234568",
            ]
        );
        assert_eq!(
            [heading(60, Some(&names)), row.line(60)],
            [
                "STEP   INC      TIME  ITER  CLOSED   RESIDUAL      9999.RF2",
                "   1    12       0.6     4       1    1.23e-9     -1.234568",
            ]
        );
        assert_eq!(
            [heading(50, Some(&names)), row.line(50)],
            [
                "STEP   INC      TIME  ITER  CLOSED      9999.RF2",
                "   1    12       0.6     4       1     -1.234568",
            ]
        );
        assert_eq!(heading(80, None).len(), 47);
        let long = Row {
            step: 1000,
            increment: 10_000,
            time: 1.234_567_89e-10,
            iterations: 10_000,
            closed: 1_000_000,
            residual: 1.234e-100,
            driven: Some([-1.234_567_891e-10; 2]),
        };
        for width in [48, 60, 76, 80] {
            assert!(long.line(width).len() <= width, "{width}: {}", long.line(width));
        }
    }
}
