//! The day and the time of day, of the clock of the world (UTC).

use std::time::{SystemTime, UNIX_EPOCH};

const MONTHS: [&str; 12] = [
    "january",
    "february",
    "march",
    "april",
    "may",
    "june",
    "july",
    "august",
    "september",
    "october",
    "november",
    "december",
];

/// A day and a time of day as ccx writes them: `23.november.2026` and `13:10:22`.
pub(crate) fn now() -> [String; 2] {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    shown(seconds)
}

fn shown(seconds: u64) -> [String; 2] {
    let (days, of_day) = (seconds / 86400, seconds % 86400);
    let (year, month, day) = civil(days);
    let month = MONTHS.get(month).copied().unwrap_or_default();
    let (hour, minute, second) = (of_day / 3600, of_day / 60 % 60, of_day % 60);
    [format!("{day:02}.{month}.{year}"), format!("{hour:02}:{minute:02}:{second:02}")]
}

/// Year, month from 0 and day from 1 of a number of days since 1 January 1970, by walking the years:
/// a run asks once.
fn civil(mut days: u64) -> (u64, usize, u64) {
    let is_leap = |year: u64| {
        year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400))
    };
    let mut year = 1970;
    while days >= 365 + u64::from(is_leap(year)) {
        days -= 365 + u64::from(is_leap(year));
        year += 1;
    }
    let february = 28 + u64::from(is_leap(year));
    let lengths = [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let mut month = 0;
    for length in lengths {
        if days < length {
            break;
        }
        days -= length;
        month += 1;
    }
    (year, month, days + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source: `date -u -d @SECONDS` of coreutils; leap days, ends of years and of centuries.
    #[test]
    fn days_of_the_calendar() {
        let cases = [
            (0, "01.january.1970", "00:00:00"),
            (951_782_399, "28.february.2000", "23:59:59"),
            (951_782_400, "29.february.2000", "00:00:00"),
            (1_795_439_422, "23.november.2026", "13:10:22"),
            (4_107_542_400, "01.march.2100", "00:00:00"),
        ];
        for (seconds, day, time) in cases {
            assert_eq!(shown(seconds), [day, time]);
        }
    }
}
