//! The lines of `JOB.sta` of ccx: one for each attempt of an increment.

use crate::fortran::push_fortran;
use std::fmt::Write as _;

/// What stands above the lines.
pub(crate) const STA_HEADER: &str = "\
SUMMARY OF JOB INFORMATION
  STEP      INC     ATT  ITRS     TOT TIME     STEP TIME      INC TIME
";

/// Adds the line of an attempt: step, increment and its number, marked `U` where it was given up;
/// iterations; total time, time in the step and increment [T]. The times are those at its end; of an
/// attempt that was given up those that were reached before stand there, as ccx writes them.
pub(crate) fn push_attempt(
    text: &mut String,
    [step, increment, attempt]: [usize; 3],
    failed: bool,
    iterations: usize,
    [total, step_time, length]: [f64; 3],
) {
    let reached = |time: f64| if failed { (time - length).max(0.0) } else { time };
    let mark = if failed { 'U' } else { ' ' };
    // a String takes any text
    let _ = write!(text, "{step:>6}{increment:>11}{attempt:>6}{mark}{iterations:>5}");
    for time in [reached(total), reached(step_time), length] {
        text.push(' ');
        push_fortran(text, time, 6);
    }
    text.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: the columns of ccx. Source: the second line is one that ccx 2.20 wrote for its
    /// test deck contact2, step 2; that an attempt of 0.25 that it gave up at time 0 has the times 0, 0
    /// and 0.25, and one of 0.210938 at 0.570312 the times 0.570312 twice.
    #[test]
    fn a_line_has_the_columns_of_ccx() {
        let (mut text, times) = (String::new(), [1.35, 0.35, 0.15]);
        push_attempt(&mut text, [2, 3, 1], false, 2, times);
        push_attempt(&mut text, [2, 3, 1], true, 2, times);
        let rows: Vec<&str> = text.lines().collect();
        assert_eq!(
            rows[0],
            "     2          3     1     2  0.135000E+01  0.350000E+00  0.150000E+00"
        );
        assert_eq!(
            rows[1],
            "     2          3     1U    2  0.120000E+01  0.200000E+00  0.150000E+00"
        );
    }
}
