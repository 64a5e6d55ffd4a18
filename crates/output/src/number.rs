//! Numbers as text.

use std::fmt::{self, Write as _};
use std::io::Write as _;

/// Digits that a decimal number needs at most to tell doubles apart.
const MOST: usize = 17;
/// Digits that any double tells apart: those of a decimal number come back.
const SURE: usize = 15;
/// Below, doubles have fewer digits.
const SMALL: f64 = 1e-290;
/// Letters of the longest text: a sign, `0.000`, digits.
const LETTERS: usize = 32;

/// A number as text, in place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Numeral {
    letters: [u8; LETTERS],
    length: usize,
}

impl Numeral {
    fn of(text: &str) -> Self {
        let mut own = Self { letters: [0; LETTERS], length: 0 };
        own.push(text.as_bytes());
        own
    }

    fn push(&mut self, letters: &[u8]) {
        let end = self.length + letters.len();
        if let Some(place) = self.letters.get_mut(self.length..end) {
            place.copy_from_slice(letters);
            self.length = end;
        }
    }

    fn push_zeros(&mut self, count: usize) {
        (0..count).for_each(|_| self.push(b"0"));
    }
}

impl std::ops::Deref for Numeral {
    type Target = str;

    fn deref(&self) -> &str {
        std::str::from_utf8(&self.letters[..self.length]).unwrap_or_default()
    }
}

impl fmt::Display for Numeral {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self)
    }
}

/// A finite number as d.ddd times a power of ten, without zeros at the end.
struct Decimal {
    negative: bool,
    digits: [u8; MOST],
    count: usize,
    exponent: i32,
}

impl Decimal {
    /// The fewest digits that read back to the same double.
    fn shortest(value: f64) -> Self {
        Self::read(zmij::Buffer::new().format_finite(value).as_bytes())
    }

    /// The nearest number of so many digits, at most [`SURE`].
    ///
    /// What has more is cut and counted up where the rest is more than half: no
    /// number of one digit more lies between the shortest text and the double, or
    /// it would be the shortest. Where the rest is half the double decides.
    fn rounded(value: f64, digits: usize) -> Self {
        let mut own = Self::shortest(value);
        if own.count <= digits {
            return own;
        }
        let rest = &own.digits[digits..own.count];
        if rest == b"5" {
            return Self::rounded_exactly(value, digits);
        }
        let up = rest[0] >= b'5';
        own.count = digits;
        if up {
            let nines = own.digits[..digits].iter().rev().take_while(|&&d| d == b'9').count();
            own.count -= nines;
            match own.count.checked_sub(1) {
                Some(last) => own.digits[last] += 1,
                None => (own.digits[0], own.count, own.exponent) = (b'1', 1, own.exponent + 1),
            }
        }
        own.without_zeros()
    }

    fn rounded_exactly(value: f64, digits: usize) -> Self {
        let mut letters = [0; LETTERS];
        let mut rest = &mut letters[..];
        let _ = write!(rest, "{value:.*e}", digits - 1); // the longest has 24 letters
        let length = LETTERS - rest.len();
        Self::read(&letters[..length])
    }

    /// Reads digits with or without a point and an exponent.
    fn read(text: &[u8]) -> Self {
        let mut own = Self { negative: false, digits: [0; MOST], count: 0, exponent: 0 };
        let (mut power, mut below, mut fraction) = (0, false, 0);
        // of the digits that count, how many stand before the point
        let mut whole = 0;
        for (place, &letter) in text.iter().enumerate() {
            match letter {
                b'-' => own.negative = true,
                b'.' => below = true,
                b'e' => {
                    let power_text = std::str::from_utf8(&text[place + 1..]).unwrap_or_default();
                    power = power_text.parse().unwrap_or(0);
                    break;
                }
                b'0' if own.count == 0 => fraction += i32::from(below),
                digit => {
                    if let Some(place) = own.digits.get_mut(own.count) {
                        *place = digit;
                        own.count += 1;
                    }
                    whole += i32::from(!below);
                }
            }
        }
        own.exponent = power + if whole > 0 { whole - 1 } else { -fraction - 1 };
        own.without_zeros()
    }

    fn without_zeros(mut self) -> Self {
        while self.count > 0 && self.digits[self.count - 1] == b'0' {
            self.count -= 1;
        }
        if self.count == 0 {
            (self.digits[0], self.count, self.exponent) = (b'0', 1, 0);
        }
        self
    }
}

impl Decimal {
    /// Letters of a text with an exponent.
    fn scientific_length(&self) -> i32 {
        let power = self.exponent.unsigned_abs().checked_ilog10().unwrap_or(0) + 1;
        let point = usize::from(self.count > 1);
        (self.count + point + 1 + power as usize) as i32 + i32::from(self.exponent < 0)
    }

    /// Letters of a text without one.
    fn plain_length(&self) -> i32 {
        let digits = self.count as i32;
        match self.exponent {
            ..0 => digits - self.exponent + 1, // 0.00123
            _ if self.exponent + 1 >= digits => self.exponent + 1,
            _ => digits + 1,
        }
    }

    /// Plain or with an exponent.
    fn shortest_text(&self) -> Numeral {
        let is_plain = self.plain_length() <= self.scientific_length();
        if is_plain { self.plain() } else { self.scientific() }
    }

    fn plain(&self) -> Numeral {
        let mut text = Numeral::of(if self.negative { "-" } else { "" });
        let digits = &self.digits[..self.count];
        let Ok(power) = usize::try_from(self.exponent) else {
            text.push(b"0.");
            text.push_zeros(self.exponent.unsigned_abs() as usize - 1);
            text.push(digits);
            return text;
        };
        let (whole, rest) = digits.split_at(digits.len().min(power + 1));
        text.push(whole);
        text.push_zeros(power + 1 - whole.len());
        if !rest.is_empty() {
            text.push(b".");
            text.push(rest);
        }
        text
    }

    fn scientific(&self) -> Numeral {
        let mut text = Numeral::of(if self.negative { "-" } else { "" });
        text.push(&self.digits[..1]);
        if self.count > 1 {
            text.push(b".");
            text.push(&self.digits[1..self.count]);
        }
        text.push(if self.exponent < 0 { b"e-" } else { b"e" });
        let power = self.exponent.unsigned_abs();
        let mut unit = 10_u32.pow(power.checked_ilog10().unwrap_or(0));
        while unit > 0 {
            text.push(&[b'0' + (power / unit % 10) as u8]);
            unit /= 10;
        }
        text
    }
}

/// Infinities are `inf` and `-inf`, and what is no number is `nan`.
fn no_number(value: f64) -> Numeral {
    Numeral::of(match value {
        f64::INFINITY => "inf",
        f64::NEG_INFINITY => "-inf",
        _ => "nan",
    })
}

/// The shortest text that reads back to the same double, plain or with an
/// exponent, whichever is shorter (plain on a tie). Zero keeps its sign;
/// infinities are `inf` and `-inf`, and what is no number is `nan`.
pub fn shortest(value: f64) -> Numeral {
    if !value.is_finite() {
        return no_number(value);
    }
    let mut buffer = zmij::Buffer::new();
    let text = buffer.format_finite(value);
    match as_it_is(value, text) {
        true => Numeral::of(text.strip_suffix(".0").unwrap_or(text)),
        false => Decimal::read(text.as_bytes()).shortest_text(),
    }
}

/// Whether a plain text of all digits is the shortest one: none stands behind zeros, and whole
/// numbers have few.
fn as_it_is(value: f64, text: &str) -> bool {
    let size = value.abs();
    let is_short = size < 1e3 || !text.ends_with(".0");
    size >= 0.01 && is_short && !text.contains('e')
}

/// Appends the shortest text that reads back to the same double.
pub fn push_shortest(text: &mut String, value: f64) {
    text.push_str(&shortest(value));
}

/// A number for people: at most `digits` significant digits, without
/// trailing zeros; an exponent only where the plain text would be long.
pub fn general(value: f64, digits: usize) -> Numeral {
    if !value.is_finite() {
        return no_number(value);
    }
    let digits = digits.max(1);
    let decimal = if digits > SURE || value.abs() < SMALL {
        // not all of these digits are needed to tell the double
        let rounded = Decimal::rounded_exactly(value, digits.min(MOST)).scientific();
        Decimal::shortest(rounded.parse().unwrap_or(value))
    } else {
        Decimal::rounded(value, digits)
    };
    if decimal.digits[0] == b'0' {
        return Numeral::of("0"); // also for -0: people do not mean it
    }
    let is_plain = (-4..digits as i32).contains(&decimal.exponent);
    if is_plain { decimal.plain() } else { decimal.scientific() }
}

/// Appends blanks before what stands from `begin` on, to fill so many places.
pub fn push_padded(text: &mut String, begin: usize, width: usize) {
    const BLANKS: &str = "                                ";
    let missing = (begin + width).saturating_sub(text.len()).min(BLANKS.len());
    text.insert_str(begin, &BLANKS[..missing]);
}

/// Appends a number as d.ddd times a power of ten, `-1.23e-4`, with so many digits behind the point.
pub fn push_scientific(text: &mut String, value: f64, digits: usize) {
    let _ = write!(text, "{value:.digits$e}"); // a String takes any text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shorter_of_plain_and_exponent() {
        let cases = [
            (1.0, "1"),
            (0.0, "0"),
            (-0.0, "-0"),
            (0.05, "0.05"),
            (-0.030, "-0.03"),
            (1e-4, "1e-4"),
            (0.00123, "0.00123"),
            (0.000123, "1.23e-4"),
            (0.0123, "0.0123"),
            (1000.0, "1e3"),
            (100.0, "100"),
            (1234.5, "1234.5"),
            (120.0, "120"),
            (6.9e9, "6.9e9"),
            (0.1 + 0.2, "0.30000000000000004"),
            (f64::MIN_POSITIVE, "2.2250738585072014e-308"),
            (f64::INFINITY, "inf"),
        ];
        for (value, text) in cases {
            assert_eq!(&*shortest(value), text);
        }
    }

    /// Requirement: contract, "shortest text that reads back to the same
    /// double". Exact, hence no tolerance.
    #[test]
    fn every_text_reads_back_and_none_is_longer_than_the_standard_ones() {
        let mut state = 0x9E37_79B9_7F4A_7C15_u64;
        for _ in 0..200_000 {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            let small = f64::from((state >> 40) as u32) / 64.0;
            let few = (state % 2000) as f64 / 10_f64.powi((state >> 60) as i32 - 6);
            for value in [f64::from_bits(state), small, few, small * 1.1e-5] {
                if value.is_finite() {
                    let text = shortest(value);
                    assert_eq!(text.parse::<f64>().unwrap().to_bits(), value.to_bits(), "{text}");
                    assert!(text.len() <= format!("{value:e}").len(), "{text}");
                    assert!(text.len() <= format!("{value}").len(), "{text}");
                    assert_eq!(text, Decimal::shortest(value).shortest_text(), "{value:e}");
                }
            }
        }
    }

    #[test]
    fn general_is_for_people() {
        assert_eq!(&*general(0.15000000000000002, 6), "0.15");
        assert_eq!(&*general(-0.0, 6), "0");
        assert_eq!(&*general(1.23456789e-7, 4), "1.235e-7");
        assert_eq!(&*general(258750.0, 6), "258750");
    }

    /// Requirement: the nearest number of so many digits as the standard library
    /// finds it, also near the middle of two. Exact, hence no tolerance.
    #[test]
    fn digits_are_rounded_as_the_double_asks() {
        let mut state = 0x2545_F491_4F6C_DD1D_u64;
        for turn in 0..100_000_u64 {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            let digits = 1 + (turn % 9) as usize;
            let short = (state % 1_000_000) as f64 * 10_f64.powi((turn % 13) as i32 - 9);
            for value in [f64::from_bits(state), short, short + 0.5, 1.0 - 1.0 / (short + 2.0)] {
                if value.is_finite() && value.abs() > 1e-280 && value.abs() < 1e300 {
                    let expected: f64 = format!("{value:.*e}", digits - 1).parse().unwrap();
                    let text = general(value, digits);
                    assert_eq!(text.parse::<f64>().unwrap(), expected, "{value:e} {digits}");
                    assert!(text.len() <= format!("{expected:e}").len().max(digits + 6), "{text}");
                }
            }
        }
        assert_eq!(&*general(0.99996, 4), "1");
        assert_eq!(&*general(9.9996e7, 4), "1e8");
    }
}
