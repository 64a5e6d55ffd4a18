//! Numbers, their ranges, and names of nodes.

use crate::number::{Numeral, general};
use slideline_model::{Model, NodeIndex};

/// A number with the digits of an echo.
pub(super) fn number(value: f64) -> Numeral {
    general(value, 9)
}

pub(super) fn extremes(values: &[f64]) -> Option<(f64, f64)> {
    let first = *values.first()?;
    Some(values.iter().fold((first, first), |(l, h), &v| (l.min(v), h.max(v))))
}

/// `a`, or `a to b` where they differ by more than rounding.
pub(super) fn range(low: f64, high: f64) -> String {
    let (low, high) = (number(low), number(high));
    if low == high { low.to_string() } else { format!("{low} to {high}") }
}

/// Node numbers; a row of consecutive ones as `first to last`.
pub fn labels(model: &Model, nodes: &[NodeIndex]) -> String {
    let labels: Vec<u64> = nodes.iter().map(|&node| model.nodes.label(node)).collect();
    let mut parts: Vec<String> = Vec::new();
    for row in labels.chunk_by(|a, b| a + 1 == *b) {
        match row {
            [first, .., last] if row.len() > 2 => parts.push(format!("{first} to {last}")),
            _ => parts.extend(row.iter().map(u64::to_string)),
        }
    }
    if parts.len() > 12 {
        let more = parts.len() - 11;
        parts.truncate(11);
        parts.push(format!("and {more} more"));
    }
    parts.join(", ")
}

/// `node 7`, or `nodes 7 to 9`.
pub(super) fn named(model: &Model, nodes: &[NodeIndex]) -> String {
    let noun = if nodes.len() == 1 { "node" } else { "nodes" };
    format!("{noun} {}", labels(model, nodes))
}
