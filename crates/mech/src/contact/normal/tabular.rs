//! The tabular law: straight between pairs (pressure, overclosure), zero below the first, last slope
//! continued. Too few pairs carry nothing.

/// Slope of the straight part that begins at pair `i`.
fn slope(pairs: &[(f64, f64)], i: usize) -> f64 {
    let last = pairs.len().saturating_sub(2);
    let (p0, h0) = pairs[i.min(last)];
    let (p1, h1) = pairs[i.min(last) + 1];
    if h1 > h0 { (p1 - p0) / (h1 - h0) } else { 0.0 }
}

/// The pair at or below `h`.
fn part(pairs: &[(f64, f64)], h: f64) -> Option<usize> {
    if pairs.len() < 2 || h <= pairs[0].1 {
        return None;
    }
    Some(pairs.partition_point(|pair| pair.1 < h).clamp(1, pairs.len()) - 1)
}

/// Pressure and slope at the overclosure `h`.
pub(super) fn pressure(pairs: &[(f64, f64)], h: f64) -> (f64, f64) {
    let Some(i) = part(pairs, h) else { return (0.0, 0.0) };
    let steepness = slope(pairs, i);
    (pairs[i].0 + steepness * (h - pairs[i].1), steepness)
}

/// Integral of the pressure from the first pair to `h`.
pub(super) fn energy(pairs: &[(f64, f64)], h: f64) -> f64 {
    let Some(last) = part(pairs, h) else { return 0.0 };
    let mut sum = 0.0;
    for i in 0..=last {
        let end = if i == last { h } else { pairs[i + 1].1 };
        let d = end - pairs[i].1;
        sum += pairs[i].0 * d + 0.5 * slope(pairs, i) * d * d;
    }
    sum
}

/// Overclosure and dh/dp at the pressure `p` > 0; on a jump at the first pair (h, 0).
pub(super) fn inverse(pairs: &[(f64, f64)], p: f64) -> Option<(f64, f64)> {
    if pairs.len() < 2 {
        return None;
    }
    if p <= pairs[0].0 {
        return Some((pairs[0].1, 0.0));
    }
    let i = pairs.partition_point(|pair| pair.0 < p).clamp(1, pairs.len()) - 1;
    let steepness = slope(pairs, i);
    (steepness > 0.0).then(|| (pairs[i].1 + (p - pairs[i].0) / steepness, 1.0 / steepness))
}

/// The overclosure above which the pressure is positive.
pub(super) fn begins(pairs: &[(f64, f64)]) -> f64 {
    let first = pairs.iter().position(|pair| pair.0 > 0.0).unwrap_or(0);
    let start = if pairs.first().is_some_and(|pair| pair.0 > 0.0) { 0 } else { first.max(1) - 1 };
    pairs.get(start).map_or(0.0, |pair| pair.1)
}

/// Exact: the part is found on the axis z = h + p/kappa, which ascends with h.
pub(super) fn resolvent(pairs: &[(f64, f64)], z: f64, kappa: f64) -> (f64, f64) {
    if pairs.len() < 2 || z <= pairs[0].1 {
        return (0.0, 0.0);
    }
    let axis = |pair: &(f64, f64)| pair.1 + pair.0 / kappa;
    if z <= axis(&pairs[0]) {
        return (kappa * (z - pairs[0].1), kappa); // on the jump of the first pair
    }
    let i = pairs.partition_point(|pair| axis(pair) < z).clamp(1, pairs.len()) - 1;
    let steepness = slope(pairs, i);
    let by_z = steepness / (1.0 + steepness / kappa);
    (pairs[i].0 + by_z * (z - axis(&pairs[i])), by_z)
}
