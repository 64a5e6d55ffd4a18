//! Numbers in so many places, as Fortran and C write them.
//!
//! ```text
//!   -1.23457E-03     sign, a digit, a point, digits, a power of ten
//! ```
//!
//! The digits are those of a whole number: the value times a power of ten. Where rounding of that
//! product could decide the last of them, the standard library writes them.

use crate::number::{push_padded, push_scientific};
use std::fmt::Write as _;

/// Powers of ten that a double holds exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];
/// The largest of them.
const MOST: i32 = 22;
/// Digits behind the point that are written this way at most.
const DIGITS: usize = 14;
/// More than a product with two of the powers rounds, over its size [1].
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Letters of the longest text.
const LETTERS: usize = 32;

/// A size times a power of ten; `None`: it is not one of two exact powers.
fn scaled(size: f64, power: i32) -> Option<f64> {
    let of = |power: i32| POWERS.get(power.unsigned_abs() as usize).copied();
    let first = power.clamp(-MOST, MOST);
    let by = |size: f64, power: i32| -> Option<f64> {
        Some(if power < 0 { size / of(power)? } else { size * of(power)? })
    };
    by(by(size, first)?, power - first)
}

/// The nearest whole number of `digits` + 1 digits to a positive number, and the power of ten of
/// its first one; `None`: rounding could decide.
fn nearest(size: f64, digits: usize) -> Option<(u64, i32)> {
    let binary = (size.to_bits() >> 52) as i32 - 1023;
    let mut power = (f64::from(binary) * std::f64::consts::LOG10_2).floor() as i32;
    let end = POWERS.get(digits + 1).filter(|_| digits <= DIGITS)?;
    let mut number = scaled(size, digits as i32 - power)?;
    if number >= *end {
        power += 1;
        number = scaled(size, digits as i32 - power)?;
    }
    let whole = number.floor();
    let rest = number - whole;
    if (rest - 0.5).abs() <= ROUNDING * number {
        return None;
    }
    let whole = if rest > 0.5 { whole + 1.0 } else { whole };
    Some(match whole >= *end {
        true => ((whole / 10.0) as u64, power + 1),
        false => (whole as u64, power),
    })
}

/// Writes a whole number over what fills its places, the last digit at the end.
fn write_digits(letters: &mut [u8], mut number: u64) {
    for letter in letters.iter_mut().rev() {
        *letter = b'0' + (number % 10) as u8;
        number /= 10;
    }
}

/// Appends a number in `digits` + 7 places; `None`: rounding could decide, or it has other places.
fn push_quickly(text: &mut String, value: f64, digits: usize) -> Option<()> {
    if digits == 0 || digits > DIGITS {
        return None;
    }
    let (number, power) = match value == 0.0 {
        true => (0, 0),
        false => nearest(value.abs(), digits)?,
    };
    if power.abs() > 99 {
        return None;
    }
    let mut letters = [b' '; LETTERS];
    let (end, width) = (digits + 3, digits + 7);
    if value.is_sign_negative() {
        letters[0] = b'-';
    }
    write_digits(&mut letters[2..end], number);
    (letters[1], letters[2]) = (letters[2], b'.');
    letters[end] = b'E';
    letters[end + 1] = if power < 0 { b'-' } else { b'+' };
    write_digits(&mut letters[end + 2..width], u64::from(power.unsigned_abs()));
    text.push_str(std::str::from_utf8(&letters[..width]).ok()?);
    Some(())
}

/// Appends a number in `digits` + 7 places as Fortran and C write it, `-1.23457E-03`. A power of
/// three digits takes one more place than others, for which there is a digit less.
pub fn push_exponent(text: &mut String, value: f64, digits: usize) {
    if push_quickly(text, value, digits).is_some() {
        return;
    }
    let begin = text.len();
    match value.is_finite() {
        true => push_power(text, value, digits),
        false => {
            let _ = write!(text, "{value}"); // a String takes any text: NaN, inf, -inf
        }
    }
    push_padded(text, begin, digits + 7);
}

fn push_power(text: &mut String, value: f64, digits: usize) {
    let begin = text.len();
    push_scientific(text, value, digits);
    let Some(at) = text[begin..].find('e').map(|at| begin + at) else { return };
    let power: i32 = text[at + 1..].parse().unwrap_or_default();
    if power.abs() > 99 {
        text.truncate(begin);
        push_scientific(text, value, digits.saturating_sub(1));
    }
    let Some(at) = text[begin..].find('e').map(|at| begin + at) else { return };
    // rounding to a digit less may count the power up
    let power: i32 = text[at + 1..].parse().unwrap_or(power);
    text.truncate(at);
    let sign = if power < 0 { '-' } else { '+' };
    let _ = write!(text, "E{sign}{:02}", power.abs()); // a String takes any text
}

/// Appends a whole number behind blanks that fill so many places.
pub fn push_whole(text: &mut String, value: u64, width: usize) {
    let mut letters = [b' '; LETTERS];
    let (mut place, mut rest) = (LETTERS, value);
    loop {
        place -= 1;
        letters[place] = b'0' + (rest % 10) as u8;
        rest /= 10;
        if rest == 0 {
            break;
        }
    }
    let begin = place.min(LETTERS.saturating_sub(width));
    text.push_str(std::str::from_utf8(&letters[begin..]).unwrap_or_default());
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: as many places whatever the value, and the value is read back from them, to
    /// half of the last digit. Source: E12.5 of Fortran.
    #[test]
    fn numbers_in_fixed_places() {
        let shown = |value: f64| {
            let mut text = String::new();
            push_exponent(&mut text, value, 5);
            assert_eq!(text.len(), 12, "{text}");
            text
        };
        assert_eq!(shown(-1.234_567e-3), "-1.23457E-03");
        assert_eq!(shown(0.0), " 0.00000E+00");
        assert_eq!(shown(2.5e10), " 2.50000E+10");
        assert_eq!(shown(-3.0e-200), "-3.0000E-200");
        assert_eq!(shown(9.999_999e99), "1.0000E+100".to_owned().replace("1.", " 1."));
        assert_eq!((shown(f64::NAN).trim(), shown(-f64::INFINITY).trim()), ("NaN", "-inf"));
        let mut value = 1.234_567e-300_f64;
        while value < 1e300 {
            for own in [value, -value] {
                let back: f64 = shown(own).trim().parse().unwrap();
                assert!((back / own - 1.0).abs() <= 5.1e-5, "{own} {back}");
            }
            value *= 7.3;
        }
    }

    /// Requirement: the letters are those of the standard library, of any double, of numbers with
    /// few digits and about the middle of two, where the next digit decides. Exact.
    #[test]
    fn the_quick_way_writes_what_the_exact_one_does() {
        let mut state = 0x9E37_79B9_7F4A_7C15_u64;
        let mut quick = 0;
        for turn in 0..100_000_u64 {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            let digits = 1 + (turn % 9) as usize;
            let power = 10_f64.powi((turn % 50) as i32 - 25);
            let short = (state % 1_000_000) as f64;
            let middle = (short + 0.5) * power;
            let next = f64::from_bits(middle.to_bits() + turn % 3);
            let round = power * (1.0 - f64::EPSILON * (turn % 4) as f64);
            for value in [f64::from_bits(state), short * power, middle, -next, round, -0.0] {
                let (mut own, mut exact) = (String::new(), String::new());
                push_exponent(&mut own, value, digits);
                quick += usize::from(push_quickly(&mut String::new(), value, digits).is_some());
                if value.is_finite() {
                    push_power(&mut exact, value, digits);
                    push_padded(&mut exact, 0, digits + 7);
                    assert_eq!(own, exact, "{value:e} {digits}");
                }
            }
        }
        assert!(quick > 200_000, "{quick}");
    }

    #[test]
    fn whole_numbers_stand_at_the_end_of_their_places() {
        for (value, width) in [(0, 1), (7, 10), (123, 2), (u64::MAX, 10), (u64::MAX, 25)] {
            let mut text = String::new();
            push_whole(&mut text, value, width);
            assert_eq!(text, format!("{value:>width$}"));
        }
    }
}
