//! Typed reading of one value, with the exact place in every error.

use slideline_diag::{Code, Diagnostic};

use crate::card::Field;

/// A real number: `1`, `+3`, `.5`, `1.`, `1e-3`, `1.D-3`.
///
/// # Errors
/// SL0116 where it is no number (also `nan` and `inf`), SL0118 where a double
/// cannot hold it.
pub fn number(field: &Field) -> Result<f64, Box<Diagnostic>> {
    parse_number(&field.text).map_err(|problem| {
        Box::new(match problem {
            Problem::Form => not_a_number(field),
            Problem::Size => too_large(field),
        })
    })
}

/// A whole number, such as a node number.
///
/// # Errors
/// SL0117 where it is no whole number, SL0118 where 64 bits cannot hold it.
pub fn integer(field: &Field) -> Result<i64, Box<Diagnostic>> {
    parse_integer(&field.text).map_err(|problem| {
        Box::new(match problem {
            Problem::Form => not_whole(field),
            Problem::Size => too_large(field),
        })
    })
}

/// A name or other text; blank is an error.
///
/// # Errors
/// SL0119 where the value is blank.
pub fn text(field: &Field) -> Result<&str, Box<Diagnostic>> {
    if field.text.is_empty() {
        let message = "a name is missing here";
        return Err(Box::new(Diagnostic::error(Code("SL0119"), message).at(field.span)));
    }
    Ok(&field.text)
}

/// Why a text is not the value asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Problem {
    /// It is not spelt like one.
    Form,
    /// It is one, but too large to be held.
    Size,
}

/// Reads a real number in Fortran or C spelling.
///
/// # Errors
/// [`Problem::Form`] or [`Problem::Size`].
pub fn parse_number(text: &str) -> Result<f64, Problem> {
    let bytes = text.as_bytes();
    let mantissa = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let whole = digits(&bytes[mantissa..]);
    let mut at = mantissa + whole;
    let mut fraction = 0;
    if bytes.get(at) == Some(&b'.') {
        fraction = digits(&bytes[at + 1..]);
        at += 1 + fraction;
    }
    if whole + fraction == 0 {
        return Err(Problem::Form);
    }
    if at < bytes.len() {
        at = exponent_end(bytes, at).ok_or(Problem::Form)?;
    }
    if at != bytes.len() {
        return Err(Problem::Form);
    }
    let value: f64 = text.replace(['d', 'D'], "e").parse().map_err(|_| Problem::Form)?;
    if value.is_finite() { Ok(value) } else { Err(Problem::Size) }
}

/// Reads a whole number.
///
/// # Errors
/// [`Problem::Form`] or [`Problem::Size`].
pub fn parse_integer(text: &str) -> Result<i64, Problem> {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    if unsigned.is_empty() || digits(unsigned.as_bytes()) != unsigned.len() {
        return Err(Problem::Form);
    }
    text.parse().map_err(|_| Problem::Size)
}

fn digits(bytes: &[u8]) -> usize {
    bytes.iter().take_while(|byte| byte.is_ascii_digit()).count()
}

fn exponent_end(bytes: &[u8], at: usize) -> Option<usize> {
    if !matches!(bytes.get(at), Some(b'e' | b'E' | b'd' | b'D')) {
        return None;
    }
    let sign = usize::from(matches!(bytes.get(at + 1), Some(b'+' | b'-')));
    let count = digits(&bytes[at + 1 + sign..]);
    (count > 0).then_some(at + 1 + sign + count)
}

fn not_a_number(field: &Field) -> Diagnostic {
    if field.text.is_empty() {
        return Diagnostic::error(Code("SL0119"), "a number is missing here").at(field.span);
    }
    Diagnostic::error(Code("SL0116"), format!("`{}` is not a number", shortened(&field.text)))
        .at(field.span)
        .help("write numbers like 25, 2.5E-3 or 2.5D-3, with a comma between values")
}

fn not_whole(field: &Field) -> Diagnostic {
    if field.text.is_empty() {
        return Diagnostic::error(Code("SL0119"), "a whole number is missing here").at(field.span);
    }
    let message = format!("`{}` is not a whole number", shortened(&field.text));
    Diagnostic::error(Code("SL0117"), message)
        .at(field.span)
        .help("numbers of nodes, elements and dofs are whole: 25, not 25.0")
}

fn too_large(field: &Field) -> Diagnostic {
    let message = format!("the number `{}` is too large", shortened(&field.text));
    Diagnostic::error(Code("SL0118"), message).at(field.span)
}

fn shortened(text: &str) -> String {
    const LONGEST: usize = 40;
    if text.chars().count() <= LONGEST {
        return text.to_owned();
    }
    text.chars().take(LONGEST).chain("...".chars()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_every_accepted_spelling() {
        let cases = [
            ("1", 1.0),
            ("+3", 3.0),
            (".5", 0.5),
            ("1.", 1.0),
            ("1e-3", 1e-3),
            ("1.D-3", 1e-3),
            ("-2.5d+2", -250.0),
            ("25.0E-3", 0.025),
            ("1e-400", 0.0),
        ];
        for (text, value) in cases {
            assert_eq!(parse_number(text), Ok(value), "{text}");
        }
    }

    #[test]
    fn what_is_no_number() {
        for text in
            ["", ".", "+", "e5", "1e", "1e+", "nan", "inf", "-inf", "1 2", "0x10", "1_0", "1.2.3"]
        {
            assert_eq!(parse_number(text), Err(Problem::Form), "{text}");
        }
        assert_eq!(parse_number("1e999"), Err(Problem::Size));
    }

    #[test]
    fn whole_numbers() {
        assert_eq!(parse_integer("+25"), Ok(25));
        assert_eq!(parse_integer("-3"), Ok(-3));
        for text in ["", "-", "25.0", "1e3", "x"] {
            assert_eq!(parse_integer(text), Err(Problem::Form), "{text}");
        }
        assert_eq!(parse_integer("99999999999999999999"), Err(Problem::Size));
    }
}
