//! The values that `*PARAMETER` gives to names: numbers, and what is computed of them.
//!
//! ```text
//!   width = 2.5
//!   area  = width*sqrt(3.0)/2      names of lines above, + - * / ** and functions
//!   steel = 'S235'                 a name of the deck
//! ```

use std::collections::HashMap;
use std::ops::Range;

/// What a name stands for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    Whole(i64),
    Real(f64),
    Text(String),
}

impl Value {
    /// As it is put into the deck.
    pub fn text(&self) -> String {
        match self {
            Self::Whole(number) => number.to_string(),
            Self::Real(number) => format!("{number:?}"),
            Self::Text(text) => text.clone(),
        }
    }

    #[allow(clippy::cast_precision_loss)] // a double is what Python makes of it, too
    pub fn real(&self) -> Result<f64, String> {
        match self {
            Self::Whole(number) => Ok(*number as f64),
            Self::Real(number) => Ok(*number),
            Self::Text(text) => Err(format!("'{text}' is no number")),
        }
    }
}

/// Names and their values.
pub(crate) type Values = HashMap<String, Value>;

/// The value of an expression; `Err`: why it has none, and what part of the text is to blame.
pub(crate) fn evaluate(text: &str, known: &Values) -> Result<Value, (String, Range<usize>)> {
    let whole = text.trim_end();
    let mut reader = Reader { rest: whole, known, depth: 0, piece: whole.len() };
    let value = reader.sum().and_then(|value| match reader.rest.trim_start() {
        "" => finite(value).inspect_err(|_| reader.piece = whole.trim_start().len()),
        rest => {
            let why = format!("`{rest}` is not understood");
            (reader.piece, reader.rest) = (rest.len(), "");
            Err(why)
        }
    });
    let begin = whole.len() - reader.piece;
    let piece = whole[begin..whole.len() - reader.rest.len()].trim_end();
    value.map_err(|why| (why, begin..begin + piece.len()))
}

/// Whether a word can be the name of a parameter.
pub(crate) fn is_name(word: &str) -> bool {
    word.starts_with(|first: char| first.is_ascii_alphabetic() || first == '_')
        && word.chars().all(in_name)
}

fn in_name(letter: char) -> bool {
    letter.is_ascii_alphanumeric() || letter == '_'
}

fn finite(value: Value) -> Result<Value, String> {
    match value {
        Value::Real(number) if !number.is_finite() => Err("it is not a finite number".to_owned()),
        value => Ok(value),
    }
}

/// Brackets, signs and powers within one another that are followed.
const DEEPEST: usize = 100;

struct Reader<'t> {
    rest: &'t str,
    known: &'t Values,
    depth: usize,
    /// What was left of the text where the piece that is looked at begins.
    piece: usize,
}

impl Reader<'_> {
    /// Takes a sign off the text, if it comes next.
    fn takes(&mut self, sign: &str) -> bool {
        let rest = self.rest.trim_start();
        let found = rest.strip_prefix(sign);
        // one star of two is no sign
        let found = found.filter(|rest| sign != "*" || !rest.starts_with('*'));
        self.rest = found.unwrap_or(rest);
        found.is_some()
    }

    /// So many letters off the text.
    fn split(&mut self, count: usize) -> &str {
        let (taken, rest) = self.rest.split_at(count);
        self.rest = rest;
        taken
    }

    fn sum(&mut self) -> Result<Value, String> {
        let mut value = self.product()?;
        loop {
            let (whole, real): (Whole, fn(f64, f64) -> f64) = if self.takes("+") {
                (i64::checked_add, |a, b| a + b)
            } else if self.takes("-") {
                (i64::checked_sub, |a, b| a - b)
            } else {
                return Ok(value);
            };
            value = joined(&value, &self.product()?, whole, real)?;
        }
    }

    fn product(&mut self) -> Result<Value, String> {
        let mut value = self.signed()?;
        loop {
            if self.takes("*") {
                value = joined(&value, &self.signed()?, i64::checked_mul, |a, b| a * b)?;
            } else if self.takes("/") {
                value = quotient(&value, &self.signed()?)?;
            } else {
                return Ok(value);
            }
        }
    }

    fn signed(&mut self) -> Result<Value, String> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err("it is nested too deeply".to_owned());
        }
        let value = if self.takes("-") {
            let value = self.signed()?;
            joined(&Value::Whole(0), &value, i64::checked_sub, |_, b| -b)
        } else if self.takes("+") {
            self.signed()
        } else {
            self.power()
        };
        self.depth -= 1;
        value
    }

    fn power(&mut self) -> Result<Value, String> {
        let base = self.single()?;
        if !self.takes("**") {
            return Ok(base);
        }
        let exponent = self.signed()?;
        power(&base, &exponent)
    }

    /// A number, a name, a function, a text or what stands in brackets.
    fn single(&mut self) -> Result<Value, String> {
        if self.takes("(") {
            let value = self.sum()?;
            return if self.takes(")") { Ok(value) } else { Err("a `)` is missing".to_owned()) };
        }
        self.piece = self.rest.len();
        let first = self.rest.chars().next().ok_or("a value is missing")?;
        if first == '\'' || first == '"' {
            let end = self.rest[1..].find(first).ok_or("a quotation mark is missing")?;
            let text = self.split(end + 2);
            return Ok(Value::Text(text[1..=end].to_owned()));
        }
        if first.is_ascii_digit() || first == '.' {
            return self.number();
        }
        let end = self.rest.find(|letter| !in_name(letter)).unwrap_or(self.rest.len());
        let name = self.split(end).to_owned();
        if name.is_empty() {
            self.split(first.len_utf8());
            return Err(format!("`{first}` is not understood"));
        }
        if self.takes("(") {
            return self.function(&name);
        }
        match self.known.get(&name) {
            Some(value) => Ok(value.clone()),
            None if name == "pi" => Ok(Value::Real(std::f64::consts::PI)),
            None => Err(format!("`{name}` has no value above; capitals and small letters differ")),
        }
    }

    fn number(&mut self) -> Result<Value, String> {
        let mut end = 0;
        for (at, letter) in self.rest.char_indices() {
            let after_e = self.rest[..at].ends_with(['e', 'E']);
            let goes_on = letter.is_ascii_digit()
                || letter == '.'
                || (matches!(letter, 'e' | 'E') && at > 0)
                || (matches!(letter, '+' | '-') && after_e);
            if !goes_on {
                break;
            }
            end = at + 1;
        }
        let digits = self.split(end);
        let whole = digits.bytes().all(|byte| byte.is_ascii_digit());
        let number = match whole {
            true => digits.parse().ok().map(Value::Whole),
            false => digits.parse().ok().map(Value::Real),
        };
        let why =
            if whole { "too large for a whole number: write it with a point" } else { "no number" };
        number.ok_or_else(|| format!("`{digits}` is {why}"))
    }

    fn function(&mut self, name: &str) -> Result<Value, String> {
        let begin = self.piece;
        let mut given = vec![self.sum()?];
        while self.takes(",") {
            given.push(self.sum()?);
        }
        if !self.takes(")") {
            return Err("a `)` is missing".to_owned());
        }
        self.piece = begin;
        called(name, &given)
    }
}

type Whole = fn(i64, i64) -> Option<i64>;

/// Two values by one operation: whole numbers stay whole.
fn joined(a: &Value, b: &Value, whole: Whole, real: fn(f64, f64) -> f64) -> Result<Value, String> {
    match (a, b) {
        (Value::Whole(a), Value::Whole(b)) => {
            whole(*a, *b).map(Value::Whole).ok_or_else(|| "it is too large".to_owned())
        }
        _ => Ok(Value::Real(real(a.real()?, b.real()?))),
    }
}

/// Of two whole numbers only where nothing is left: some versions of Abaqus would drop the rest.
fn quotient(a: &Value, b: &Value) -> Result<Value, String> {
    if b.real()? == 0.0 {
        return Err("it is divided by zero".to_owned());
    }
    match (a, b) {
        (Value::Whole(a), Value::Whole(b)) => match a.checked_rem(*b) {
            Some(0) => Ok(Value::Whole(a / b)),
            _ => Err(format!(
                "{a}/{b} is a fraction in some versions of Abaqus and whole in others: write {a}.0/{b}"
            )),
        },
        _ => Ok(Value::Real(a.real()? / b.real()?)),
    }
}

fn power(base: &Value, exponent: &Value) -> Result<Value, String> {
    if let (Value::Whole(base), Value::Whole(own)) = (base, exponent)
        && let Ok(own) = u32::try_from(*own)
    {
        return base.checked_pow(own).map(Value::Whole).ok_or_else(|| "it is too large".to_owned());
    }
    Ok(Value::Real(base.real()?.powf(exponent.real()?)))
}

/// The value of a function of Python's `math` that decks use.
fn called(name: &str, given: &[Value]) -> Result<Value, String> {
    let one: Option<fn(f64) -> f64> = match name {
        "sqrt" => Some(f64::sqrt),
        "sin" => Some(f64::sin),
        "cos" => Some(f64::cos),
        "tan" => Some(f64::tan),
        "asin" => Some(f64::asin),
        "acos" => Some(f64::acos),
        "atan" => Some(f64::atan),
        "sinh" => Some(f64::sinh),
        "cosh" => Some(f64::cosh),
        "tanh" => Some(f64::tanh),
        "exp" => Some(f64::exp),
        "log" => Some(f64::ln),
        "log10" => Some(f64::log10),
        "float" => Some(|own| own),
        _ => None,
    };
    match (name, one, given) {
        (_, Some(of), [own]) => finite(Value::Real(of(own.real()?))),
        ("abs", _, [Value::Whole(own)]) => Ok(Value::Whole(own.saturating_abs())),
        ("abs", _, [own]) => Ok(Value::Real(own.real()?.abs())),
        ("int", _, [own]) => whole(own.real()?.trunc()),
        ("atan2", _, [y, x]) => Ok(Value::Real(y.real()?.atan2(x.real()?))),
        ("pow", _, [base, exponent]) => power(base, exponent),
        _ => Err(format!("`{name}` of {} values is not known", given.len())),
    }
}

/// A number without a fraction as a whole one.
#[allow(clippy::cast_possible_truncation)] // bounded before
fn whole(number: f64) -> Result<Value, String> {
    const MOST: f64 = 9.0e15; // doubles beyond are not all whole numbers
    if number.abs() <= MOST {
        Ok(Value::Whole(number as i64))
    } else {
        Err("it is too large".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Result<String, (String, Range<usize>)> {
        let known =
            [("a", Value::Whole(7)), ("b", Value::Real(0.5)), ("t", Value::Text("S".into()))];
        let known: Values = known.into_iter().map(|(name, own)| (name.to_owned(), own)).collect();
        evaluate(text, &known).map(|value| value.text())
    }

    /// Requirement: expressions have the values and the order of operations of Python; whole numbers
    /// stay whole. Source: Python reference, 6.17; Abaqus manual, parametric input.
    #[test]
    fn values() {
        for (text, value) in [
            ("1.5", "1.5"),
            (".5e-3", "0.0005"),
            ("12", "12"),
            ("1+2*3", "7"),
            ("(1 + 2)*3", "9"),
            ("2**3**2", "512"),
            ("-2**2", "-4"),
            ("2**-1", "0.5"),
            ("6/3", "2"),
            ("1.0/4", "0.25"),
            ("a*b", "3.5"),
            ("- a + 1", "-6"),
            ("sqrt(16.0)/2", "2.0"),
            ("int(7.9)", "7"),
            ("pow(2, 10)", "1024"),
            ("abs(-3)", "3"),
            ("10-2-3", "5"),
            ("2.0*-3", "-6.0"),
            ("t", "S"),
            ("'two words'", "two words"),
        ] {
            assert_eq!(of(text), Ok(value.to_owned()), "{text}");
        }
        let deep = format!("{}1{}", "(".repeat(5000), ")".repeat(5000));
        for text in [
            "",
            "1 +",
            "(1",
            "1)",
            "c",
            "A",
            "1/2",
            "1/0",
            "1.5.2",
            "sqrt(-1.0)",
            "sin()",
            "what(1)",
            "'open",
            "10**99",
            "t*2",
            "1e400",
            "$",
            "9999999999999999999",
            &deep,
        ] {
            assert!(of(text).is_err(), "{text}: {:?}", of(text));
        }
    }

    /// Requirement: what stands against an expression is the piece that is to blame.
    #[test]
    fn pieces() {
        for (text, piece) in [
            ("1 + c*2", "c"),
            ("2*(3 + 1.5.2)", "1.5.2"),
            ("99999999999999999999", "99999999999999999999"),
            ("1 + sqrt(-1.0)*a", "sqrt(-1.0)"),
            ("3 + what(1)", "what(1)"),
            ("1/0 + 2", "0"),
            ("1 2", "2"),
            ("2 + $", "$"),
            (" 1e300*1e300 ", "1e300*1e300"),
        ] {
            let (why, found) = of(text).expect_err(text);
            assert_eq!(text.get(found), Some(piece), "{text}: {why}");
        }
        assert!(of("99999999999999999999").expect_err("large").0.contains("too large"));
    }
}
