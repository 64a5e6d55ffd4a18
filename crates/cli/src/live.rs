//! The last line of a run on a terminal.
//!
//! ```text
//!   [#########-----------]  45 %  0:03 left  9999.RF2 __..--==
//! ```

use std::fmt::Write as _;
use std::time::{Duration, Instant};

/// Signs of the bar.
const BAR: usize = 20;
/// Most signs of the curve.
const CURVE: usize = 24;

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

    /// The line, without its end.
    pub fn line(&self) -> String {
        self.line_after(self.began.elapsed())
    }

    fn line_after(&self, elapsed: Duration) -> String {
        let part = if self.whole > 0.0 { (self.reached / self.whole).clamp(0.0, 1.0) } else { 0.0 };
        let (full, empty) = if self.unicode { ('\u{2588}', '\u{2591}') } else { ('#', '-') };
        let full_signs = (1..=BAR).filter(|&k| k as f64 <= part * BAR as f64 + 1e-9).count();
        let bar = (0..BAR).map(|k| if k < full_signs { full } else { empty });
        let mut line = format!("[{}] {:>3.0} %", bar.collect::<String>(), 100.0 * part);
        if part > 0.0 && part < 1.0 {
            let left = elapsed.as_secs_f64() * (1.0 - part) / part;
            let _ = write!(line, "  {} left", clock(left)); // a String takes any text
        }
        if !self.name.is_empty() && !self.reactions.is_empty() {
            let _ = write!(line, "  {} {}", self.name, self.curve()); // as above
        }
        line
    }

    /// The reactions as a curve of signs, the whole run in at most
    /// [`CURVE`] of them; a sign is the mean of what falls into it.
    fn curve(&self) -> String {
        let count = self.reactions.len();
        let signs = count.min(CURVE);
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
        let line = live.line_after(Duration::from_secs(30));
        assert_eq!(line, "[#####---------------]  25 %  1:30 left  9999.RF2 #*=+~-._");
        for k in 0_u32..1000 {
            live.increment(0.5, Some(f64::from(k)));
        }
        assert!(live.line_after(Duration::from_secs(360_000)).len() < 80);
        assert_eq!(clock(3723.9), "1:02:03");
    }
}
