//! Numbers as text.

use std::io::Write as _;

/// Appends the shortest text that reads back to the same double, plain or
/// with an exponent, whichever is shorter (plain on a tie). Zero keeps its
/// sign; infinities are `inf` and `-inf`, and what is no number is `nan`.
pub fn push_shortest(text: &mut String, value: f64) {
    if !value.is_finite() {
        text.push_str(match value {
            f64::INFINITY => "inf",
            f64::NEG_INFINITY => "-inf",
            _ => "nan",
        });
        return;
    }
    let mut letters = [0_u8; 32];
    let mut rest = &mut letters[..];
    let _ = write!(rest, "{value:e}"); // the longest has 24 letters
    let length = 32 - rest.len();
    let written = std::str::from_utf8(&letters[..length]).unwrap_or_default();
    let (mantissa, exponent) = written.split_once('e').unwrap_or((written, "0"));
    let (sign, mantissa) =
        mantissa.strip_prefix('-').map_or(("", mantissa), |positive| ("-", positive));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let count = i32::try_from(mantissa.len()).unwrap_or(i32::MAX);
    let digits = if count > 1 { count - 1 } else { 1 }; // without the point
    let plain_length = match exponent {
        ..0 => digits - exponent + 1, // 0.00123
        _ if exponent + 1 >= digits => exponent + 1,
        _ => digits + 1,
    };
    text.push_str(sign);
    if plain_length > count + 1 + exponent_length(exponent) {
        text.push_str(mantissa);
        text.push('e');
        text.push_str(written.split_once('e').map_or("0", |(_, exponent)| exponent));
    } else {
        push_plain(text, mantissa, exponent);
    }
}

fn exponent_length(exponent: i32) -> i32 {
    let digits = exponent.abs().checked_ilog10().unwrap_or(0) as i32 + 1;
    digits + i32::from(exponent < 0)
}

/// Lays `d.ddd` times a power of ten out without an exponent.
fn push_plain(text: &mut String, mantissa: &str, exponent: i32) {
    let mut digits = mantissa.chars().filter(|c| *c != '.');
    if exponent < 0 {
        text.push_str("0.");
        text.extend((1..-exponent).map(|_| '0'));
        text.extend(digits);
        return;
    }
    for _ in 0..=exponent {
        text.push(digits.next().unwrap_or('0'));
    }
    let mut rest = digits.peekable();
    if rest.peek().is_some() {
        text.push('.');
        text.extend(rest);
    }
}

/// The shortest text that reads back to the same double.
pub fn shortest(value: f64) -> String {
    let mut text = String::new();
    push_shortest(&mut text, value);
    text
}

/// A number for people: at most `digits` significant digits, without
/// trailing zeros; an exponent only where the plain text would be long.
pub fn general(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return shortest(value);
    }
    let rounded = format!("{value:.*e}", digits.saturating_sub(1));
    shortest_or_plain(rounded.parse().unwrap_or(value), digits)
}

fn shortest_or_plain(value: f64, digits: usize) -> String {
    let magnitude = value.abs();
    let largest = 10_f64.powi(i32::try_from(digits).unwrap_or(17));
    if value == 0.0 {
        "0".to_owned() // also for -0: people do not mean it
    } else if (1e-4..largest).contains(&magnitude) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
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
            assert_eq!(shortest(value), text);
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
            for value in [f64::from_bits(state), f64::from((state >> 40) as u32) / 64.0] {
                if value.is_finite() {
                    let text = shortest(value);
                    assert_eq!(text.parse::<f64>().unwrap().to_bits(), value.to_bits(), "{text}");
                    assert!(text.len() <= format!("{value:e}").len(), "{text}");
                    assert!(text.len() <= format!("{value}").len(), "{text}");
                }
            }
        }
    }

    #[test]
    fn general_is_for_people() {
        assert_eq!(general(0.15000000000000002, 6), "0.15");
        assert_eq!(general(-0.0, 6), "0");
        assert_eq!(general(1.23456789e-7, 4), "1.235e-7");
        assert_eq!(general(258750.0, 6), "258750");
    }
}
