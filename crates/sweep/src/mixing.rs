//! Numbers that look random and follow from a seed and a place alone.

/// A number of 64 bits that follows from another: the finaliser of SplitMix64
/// [Steele, Lea and Flood 2014].
pub(crate) fn mixed(number: u64) -> u64 {
    let mut z = number.wrapping_add(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// One of several numbers.
pub(crate) fn joined(numbers: &[u64]) -> u64 {
    numbers.iter().fold(0, |so_far, &number| mixed(so_far ^ mixed(number)))
}

/// A number of 64 bits as one between 0 and 1, neither of them [1].
#[allow(clippy::cast_precision_loss)] // 52 bits have their place in a double
pub(crate) fn unit(bits: u64) -> f64 {
    ((bits >> 12) as f64 + 0.5) * 2f64.powi(-52)
}

/// Rounds of a permutation.
const ROUNDS: u64 = 6;

/// Where `place` of `count` places goes in a permutation of them that follows from the seed: a
/// Feistel network over the next power of four, walked until it is back among the places.
pub(crate) fn permuted(place: u64, count: u64, seed: u64) -> u64 {
    let bits = 64 - count.saturating_sub(1).leading_zeros();
    let half = bits.div_ceil(2).max(1);
    let mut at = place;
    loop {
        at = exchanged(at, half, seed);
        if at < count {
            return at;
        }
    }
}

fn exchanged(number: u64, half: u32, seed: u64) -> u64 {
    let mask = (1 << half) - 1;
    let (mut high, mut low) = (number >> half, number & mask);
    for round in 0..ROUNDS {
        (high, low) = (low, high ^ (joined(&[seed, round, low]) & mask));
    }
    (high << half) | low
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: every place is taken once, whatever their number.
    #[test]
    fn a_permutation_takes_every_place_once() {
        for count in [1, 2, 3, 5, 16, 17, 1000, 1025] {
            let mut places: Vec<u64> = (0..count).map(|at| permuted(at, count, 7)).collect();
            places.sort_unstable();
            assert_eq!(places, (0..count).collect::<Vec<_>>());
        }
        let other = |seed| (0..100).map(|at| permuted(at, 100, seed)).collect::<Vec<_>>();
        assert_ne!(other(1), other(2));
    }

    #[test]
    fn ends_are_never_taken() {
        assert!(unit(0) > 0.0 && unit(u64::MAX) < 1.0);
    }
}
