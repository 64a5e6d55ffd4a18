//! Isotropic hardening: the yield stress over plastic strain.

/// Yield stress [F/L2] and plastic strain [1], line by line.
pub type Hardening = Vec<[f64; 2]>;

/// Yield stress and its slope at an equivalent plastic strain.
pub(super) fn yield_stress(table: &Hardening, strain: f64) -> [f64; 2] {
    let behind = table.iter().position(|line| line[1] > strain);
    match behind {
        Some(0) | None => [table.last().map_or(0.0, |line| line[0]), 0.0],
        Some(next) => {
            let ([low, from], [high, to]) = (table[next - 1], table[next]);
            let slope = (high - low) / (to - from);
            [low + slope * (strain - from), slope]
        }
    }
}
