//! Solve for: the value of a parameter with which a key figure becomes what is wanted.
//!
//! ```text
//!   f(p) = figure(p) - wanted      Newton with the exact slope of the first solve, then secants, as
//!     |        ___.                long as no two values stand on both sides of zero; from then on
//!     |  ___.-'                    within them
//!     '--------- p
//! ```
//!
//! Where the first solve has no exact slope, that of two neighbouring solves stands in for it.

use crate::answers::{overtaken, refused};
use crate::bracket::{Bracket, Tried};
use crate::deck::Opened;
use crate::outcome::figure;
use crate::quiet::Quiet;
use crate::rates::{LOST, differentiated};
use crate::solve::{OVERTAKEN, Room, quietly};
use crate::values::Values;
use serde_json::{Value, json};

/// Most steps, and how near is near enough, relative to what is wanted and to the range.
const STEPS: usize = 40;
const NEAR: f64 = 1e-6;
/// Distance of a neighbour, relative to the range.
const NEIGHBOUR: f64 = 1e-3;

/// One question for a value.
struct Aim<'a> {
    opened: &'a Opened,
    values: &'a Values,
    room: &'a mut Room,
    say: &'a mut dyn FnMut(&str) -> bool,
    place: usize,
    response: &'a str,
    wanted: f64,
    /// Value of the parameter and what was off there, of all solves.
    tried: Vec<Tried>,
    /// Why the last solve that failed has no figure.
    failure: Option<String>,
    /// Whether slopes are exact, and why they are not.
    exact: bool,
    because: Option<&'static str>,
}

/// Looks for the value of a parameter that gives a figure.
pub(crate) fn aim(
    opened: &Opened,
    values: &Values,
    room: &mut Room,
    (id, asked): (&Value, &Value),
    say: &mut dyn FnMut(&str) -> bool,
) -> Value {
    let word = |key: &str| asked.get(key).and_then(Value::as_str).unwrap_or_default();
    let (parameter, response) = (word("parameter"), word("response"));
    let place = opened.sliders.iter().position(|own| own.name == parameter);
    let Some(place) = place.filter(|place| !opened.sliders[*place].whole) else {
        return refused(id, &format!("{parameter} is no parameter that can follow"));
    };
    let Some(wanted) = asked.get("wanted").and_then(Value::as_f64) else {
        return refused(id, "the wanted value is missing");
    };
    let (tried, failure) = (Vec::new(), None);
    let (exact, because) = (word("slopes") != "differences", None);
    let mut aim =
        Aim { opened, values, room, say, place, response, wanted, tried, failure, exact, because };
    let found = aim.search();
    let steps = aim.tried.len();
    let nearest = aim.tried.iter().min_by(|a, b| a[1].abs().total_cmp(&b[1].abs())).copied();
    match (found, nearest) {
        (Err(why), _) if why == OVERTAKEN => overtaken(id),
        (Ok(true), Some([value, off])) => json!({
            "say": "aimed", "id": id, "parameter": parameter, "value": value,
            "reached": wanted + off, "steps": steps, "slopes": aim.slopes(), "because": aim.because,
        }),
        (found, nearest) => {
            let [low, high] = aim.ends();
            let range = format!("{parameter} from {low} to {high} does not reach it.");
            let why = found.err().or(aim.failure).unwrap_or(range);
            json!({
                "say": "missed", "id": id, "why": why, "parameter": parameter,
                "value": nearest.map(|own| own[0]),
                "nearest": nearest.map(|own| wanted + own[1]), "steps": steps,
            })
        }
    }
}

impl Aim<'_> {
    /// The range of the parameter, and its value where that is outside.
    fn ends(&self) -> [f64; 2] {
        let ([low, high], own) = (self.opened.sliders[self.place].range, self.values.0[self.place]);
        [low.min(own), high.max(own)]
    }

    fn slopes(&self) -> &'static str {
        if self.exact { "exact" } else { "differences" }
    }

    /// What is off at a value; `None`: the run there has no such figure. `Err`: there is something
    /// newer to do.
    fn off(&mut self, value: f64) -> Result<Option<f64>, String> {
        let values = self.values.with(self.place, value);
        let found = quietly(self.opened, &values, self.room, self.say);
        self.took(value, found)
    }

    /// The same with the exact slope there, where it has one.
    fn off_and_slope(&mut self, value: f64) -> Result<Option<(f64, Option<f64>)>, String> {
        if !self.exact {
            return Ok(self.off(value)?.map(|off| (off, None)));
        }
        let values = self.values.with(self.place, value);
        let by = [self.place];
        let found = differentiated(self.opened, &values, self.room, &by, self.say);
        let (found, slope) = match found {
            Ok((quiet, mut rates)) => {
                let rates = rates.pop().flatten().ok_or(LOST);
                let slope = rates.and_then(|own| own.of(self.response, &quiet));
                (Ok(quiet), slope)
            }
            Err(why) => (Err(why), Err(LOST)),
        };
        self.because = slope.err();
        self.exact = slope.is_ok();
        let slope = slope.ok().filter(|own| *own != 0.0);
        Ok(self.took(value, found)?.map(|off| (off, slope)))
    }

    fn took(&mut self, value: f64, found: Result<Quiet, String>) -> Result<Option<f64>, String> {
        let found = match found {
            Ok(found) => found,
            Err(why) if why == OVERTAKEN => return Err(why),
            Err(why) => {
                self.failure = Some(why);
                return Ok(None);
            }
        };
        let off = figure(&found, self.response).map(|own| own - self.wanted);
        if let Some(off) = off {
            self.tried.push([value, off]);
        } else {
            self.failure = Some(format!("The run has no {}.", self.response));
        }
        Ok(off)
    }

    fn is_near(&self, off: f64) -> bool {
        off.abs() <= NEAR * self.wanted.abs().max(f64::MIN_POSITIVE)
    }

    /// Whether it was found.
    fn search(&mut self) -> Result<bool, String> {
        let [low, high] = self.ends();
        let mut value = self.values.0[self.place];
        let Some((mut off, mut slope)) = self.off_and_slope(value)? else { return Ok(false) };
        while self.tried.len() < STEPS {
            if self.is_near(off) {
                return Ok(true);
            }
            if let Some(bracket) = self.bracket() {
                return self.within(bracket);
            }
            if slope.is_none() {
                slope = self.slope(value, [low, high])?;
                if self.bracket().is_some() {
                    continue;
                }
            }
            let Some(along) = slope else { break };
            let next = (value - off / along).clamp(low, high);
            if next == value {
                break;
            }
            let Some(found) = self.off(next)? else { break };
            // what the last step found, in place of another derivative
            slope =
                Some((found - off) / (next - value)).filter(|own| own.is_finite() && *own != 0.0);
            (value, off) = (next, found);
        }
        // Newton has run against an end: what is wanted may lie beyond a peak
        for end in [low, high] {
            if self.bracket().is_none() && !self.tried.iter().any(|own| own[0] == end) {
                self.off(end)?;
            }
        }
        match self.bracket() {
            Some(bracket) => self.within(bracket),
            None => Ok(self.tried.iter().any(|own| self.is_near(own[1]))),
        }
    }

    /// Slope at a value by two neighbours; none where there is none.
    fn slope(&mut self, value: f64, [low, high]: [f64; 2]) -> Result<Option<f64>, String> {
        let step = NEIGHBOUR * (high - low);
        let ends = [(value - step).max(low), (value + step).min(high)];
        let (Some(below), Some(above)) = (self.off(ends[0])?, self.off(ends[1])?) else {
            return Ok(None);
        };
        let slope = (above - below) / (ends[1] - ends[0]);
        Ok((slope.is_finite() && slope != 0.0).then_some(slope))
    }

    /// The nearest two values tried with zero between them.
    fn bracket(&self) -> Option<[Tried; 2]> {
        let mut all = self.tried.clone();
        all.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let sides = all.windows(2).map(|own| [own[0], own[1]]);
        let across = sides.filter(|[a, b]| a[1] * b[1] <= 0.0);
        across.min_by(|a, b| (a[1][0] - a[0][0]).total_cmp(&(b[1][0] - b[0][0])))
    }

    /// Closes in between two values with zero between them.
    fn within(&mut self, [a, b]: [Tried; 2]) -> Result<bool, String> {
        let mut bracket = Bracket::new(a, b);
        let whole = bracket.length();
        while self.tried.len() < STEPS {
            if let Some(own) =
                [bracket.new, bracket.other].into_iter().find(|own| self.is_near(own[1]))
            {
                // the last one tried is what is told
                self.tried.retain(|one| one != &own);
                self.tried.push(own);
                return Ok(true);
            }
            let next = bracket.next();
            if next == bracket.new[0]
                || next == bracket.other[0]
                || bracket.length() <= 1e-12 * whole
            {
                break;
            }
            let Some(off) = self.off(next)? else { return Ok(false) };
            bracket.take([next, off]);
        }
        // a jump across what is wanted is no solution
        let (a, b) = (bracket.new[0], bracket.other[0]);
        let (a, b) = (a.min(b), a.max(b));
        self.failure = Some(format!("{} jumps across it between {a} and {b}.", self.response));
        Ok(false)
    }
}
