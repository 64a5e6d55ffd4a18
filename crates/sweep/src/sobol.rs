//! The sequence of Sobol, scrambled.
//!
//! Direction numbers: S. Joe and F. Y. Kuo, Constructing Sobol sequences with better
//! two-dimensional projections, SIAM J. Sci. Comput. 30 (2008), 2635-2654, the file
//! new-joe-kuo-6.21201. Scrambling: A. B. Owen, Randomly permuted (t,m,s)-nets and
//! (t,s)-sequences, Lecture Notes in Statistics 106 (1995), 299-317: every digit is turned or not,
//! which follows from the digits before it.

use crate::mixing::{joined, unit};

/// Directions that the table below has.
pub(crate) const MOST: usize = JOE_KUO.len() + 1;
/// Digits of a coordinate.
const DIGITS: u32 = 32;

/// Degree, coefficients of the polynomial, first numbers; of the second direction on.
const JOE_KUO: [(u32, u32, &[u32]); 30] = [
    (1, 0, &[1]),
    (2, 1, &[1, 3]),
    (3, 1, &[1, 3, 1]),
    (3, 2, &[1, 1, 1]),
    (4, 1, &[1, 1, 3, 3]),
    (4, 4, &[1, 3, 5, 13]),
    (5, 2, &[1, 1, 5, 5, 17]),
    (5, 4, &[1, 1, 5, 5, 5]),
    (5, 7, &[1, 1, 7, 11, 19]),
    (5, 11, &[1, 1, 5, 1, 1]),
    (5, 13, &[1, 1, 1, 3, 11]),
    (5, 14, &[1, 3, 5, 5, 31]),
    (6, 1, &[1, 3, 3, 9, 7, 49]),
    (6, 13, &[1, 1, 1, 15, 21, 21]),
    (6, 16, &[1, 3, 1, 13, 27, 49]),
    (6, 19, &[1, 1, 1, 15, 7, 5]),
    (6, 22, &[1, 3, 1, 15, 13, 25]),
    (6, 25, &[1, 1, 5, 5, 19, 61]),
    (7, 1, &[1, 3, 7, 11, 23, 15, 103]),
    (7, 4, &[1, 3, 7, 13, 13, 15, 69]),
    (7, 7, &[1, 1, 3, 13, 7, 35, 63]),
    (7, 8, &[1, 3, 5, 9, 1, 25, 53]),
    (7, 14, &[1, 3, 1, 13, 9, 35, 107]),
    (7, 19, &[1, 3, 1, 5, 27, 61, 31]),
    (7, 21, &[1, 1, 5, 11, 19, 41, 61]),
    (7, 28, &[1, 3, 5, 3, 3, 13, 69]),
    (7, 31, &[1, 1, 7, 13, 1, 19, 1]),
    (7, 32, &[1, 3, 7, 5, 13, 19, 59]),
    (7, 37, &[1, 1, 3, 9, 25, 29, 41]),
    (7, 41, &[1, 3, 5, 13, 23, 1, 55]),
];

/// Coordinate [1] of a scrambled point in a direction, between 0 and 1.
pub(crate) fn coordinate(point: u64, direction: usize, seed: u64) -> f64 {
    let digits = u64::from(scrambled(plain(point, direction), direction, seed));
    unit((digits << DIGITS) | (joined(&[seed, direction as u64, point]) >> DIGITS))
}

/// Digits of a point in a direction, the first one highest: those of the numbers of its binary
/// digits, added without carrying.
fn plain(point: u64, direction: usize) -> u32 {
    let numbers = numbers(direction);
    let taken = (0..DIGITS as usize).filter(|&digit| (point >> digit) & 1 == 1);
    taken.fold(0, |sum, digit| sum ^ numbers[digit])
}

/// Direction numbers, by the recurrence of the primitive polynomial (Joe and Kuo 2008, eq. 2).
fn numbers(direction: usize) -> [u32; DIGITS as usize] {
    let mut all: [u32; DIGITS as usize] = std::array::from_fn(|k| 1 << (DIGITS as usize - 1 - k));
    let Some(place) = direction.checked_sub(1) else { return all };
    let (degree, coefficients, first) = JOE_KUO[place];
    let s = degree as usize;
    for (k, &number) in first.iter().enumerate() {
        all[k] = number << (DIGITS as usize - 1 - k);
    }
    for k in s..DIGITS as usize {
        all[k] = all[k - s] ^ (all[k - s] >> s);
        for j in 1..s {
            if (coefficients >> (s - 1 - j)) & 1 == 1 {
                all[k] ^= all[k - j];
            }
        }
    }
    all
}

/// Every digit turned or not, as the digits before it say.
fn scrambled(digits: u32, direction: usize, seed: u64) -> u32 {
    (0..DIGITS).fold(0, |so_far, place| {
        let before = u64::from(digits) >> (DIGITS - place);
        let turns = joined(&[seed, direction as u64, u64::from(place), before]) & 1 == 1;
        let digit = (digits >> (DIGITS - 1 - place)) & 1;
        (so_far << 1) | (digit ^ u32::from(turns))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source: the first points as Joe and Kuo's own program prints them, in the order of binary
    /// digits in place of Gray's code.
    #[test]
    fn the_first_points() {
        let points: Vec<[f64; 3]> = (0..4)
            .map(|point| [0, 1, 2].map(|of| f64::from(plain(point, of)) * 2f64.powi(-32)))
            .collect();
        assert_eq!(points[..2], [[0.0; 3], [0.5; 3]]);
        assert_eq!(points[2..], [[0.25, 0.75, 0.75], [0.75, 0.25, 0.25]]);
    }

    /// Requirement: of 2^m points one lies in each of 2^m equal parts, in every direction,
    /// scrambled or not; and four of 16 points of two directions in each quarter.
    #[test]
    fn points_are_spread_evenly() {
        const COUNT: usize = 256;
        for direction in 0..MOST {
            for scrambles in [false, true] {
                let mut met = [0; COUNT];
                for point in 0..COUNT as u64 {
                    let digits = plain(point, direction);
                    let digits = if scrambles { scrambled(digits, direction, 3) } else { digits };
                    met[(digits >> 24) as usize] += 1;
                }
                assert_eq!(met, [1; COUNT], "direction {direction}");
            }
        }
        let mut met = [[0; 4]; 4];
        for point in 0..64 {
            let [x, y] = [0, 1].map(|of| (scrambled(plain(point, of), of, 5) >> 30) as usize);
            met[x][y] += 1;
        }
        assert_eq!(met, [[4; 4]; 4]);
    }
}
