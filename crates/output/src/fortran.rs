//! Numbers as Fortran's E format writes them, which programs around CalculiX read.

use crate::number::push_padded;
use std::fmt::Write as _;

/// A number in `digits` + 7 places as Fortran's E descriptor has it: the first digit stands behind
/// the point, `0.1234567E-02` with seven digits.
pub(crate) fn push_fortran(text: &mut String, value: f64, digits: usize) {
    let begin = text.len();
    let shown = format!("{:.*e}", digits.saturating_sub(1), value.abs());
    match shown
        .split_once('e')
        .and_then(|(digits, power)| Some((digits.replace('.', ""), power.parse::<i32>().ok()?)))
    {
        Some((digits, power)) => {
            let power = if value == 0.0 { 0 } else { power + 1 };
            let sign = if value < 0.0 { "-" } else { "" };
            let minus = if power < 0 { '-' } else { '+' };
            let _ = write!(text, "{sign}0.{digits}E{minus}{:02}", power.abs()); // takes any text
        }
        None => text.push_str(&shown), // no number
    }
    push_padded(text, begin, digits + 7);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: Fortran's places and digits. Source: E14.7 and E11.4 as ccx 2.20 prints them.
    #[test]
    fn the_first_digit_stands_behind_the_point() {
        let shown = |value, digits| {
            let mut text = String::new();
            push_fortran(&mut text, value, digits);
            text
        };
        assert_eq!(shown(1.0, 7), " 0.1000000E+01");
        assert_eq!(shown(-0.00123456789, 7), "-0.1234568E-02");
        assert_eq!(shown(0.0, 4), " 0.0000E+00");
        assert_eq!(shown(99.99999, 4), " 0.1000E+03");
    }
}
