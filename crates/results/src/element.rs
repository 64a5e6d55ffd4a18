//! Results of elements without a section: their fields as columns, and their stress
//! as a tensor.

use slideline_model::{ElementType, Location, NodeIndex};
use slideline_solve::observe::{BlockResults, Frame};
use std::collections::BTreeMap;

/// The blocks of a frame that are no beams and have results.
pub fn blocks<'a>(
    frame: &Frame<'a>,
) -> impl Iterator<Item = (&'static ElementType, &'a BlockResults)> + use<'a> {
    let (model, elements) = (frame.model, frame.elements);
    elements.iter().filter_map(move |results| {
        let kind = model.blocks.get(results.block)?.kind;
        (!kind.is_beam() && !kind.fields.is_empty()).then_some((kind, results))
    })
}

/// Every component of every field with its mean over the element.
pub fn means(
    kind: &'static ElementType,
    values: &[f64],
) -> impl Iterator<Item = (&'static str, f64)> {
    let mut first = 0;
    let mut all = Vec::with_capacity(values.len());
    for field in kind.fields {
        let own = &values[first..first + kind.values(field)];
        first += own.len();
        let (width, places) = (field.components.len(), own.len() / field.components.len());
        for (place, component) in field.components.iter().enumerate() {
            let sum: f64 = own.iter().skip(place).step_by(width).sum();
            all.push((*component, sum / places as f64));
        }
    }
    all.into_iter()
}

/// Stress at every integration point: xx, yy, zz, xy, yz, zx [F/L2], that of a truss along its
/// own axis; empty for
/// elements without such a stress.
pub fn stresses(kind: &ElementType, values: &[f64]) -> Vec<[f64; 6]> {
    const NAMES: [&str; 6] = ["S11", "S22", "S33", "S12", "S13", "S23"];
    let Some((field, first)) = kind.field("S") else { return Vec::new() };
    let width = field.components.len();
    let known = width != 2 && width != 3 && NAMES.starts_with(field.components);
    if !known || field.location != Location::Points {
        return Vec::new();
    }
    let own = &values[first..first + kind.values(field)];
    let tensor = |own: &[f64]| {
        let of = |k: usize| own.get(k).copied().unwrap_or(0.0);
        [of(0), of(1), of(2), of(3), of(5), of(4)]
    };
    own.chunks_exact(width).map(tensor).collect()
}

/// Mises stress of a tensor [F/L2].
pub fn mises([xx, yy, zz, xy, yz, zx]: [f64; 6]) -> f64 {
    let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
    (0.5 * normal + 3.0 * (xy * xy + yz * yz + zx * zx)).sqrt()
}

/// Stress at the nodes of solids [F/L2]: carried there from the integration points,
/// the mean of the elements that meet.
pub fn nodal_stresses(frame: &Frame<'_>) -> BTreeMap<NodeIndex, [f64; 6]> {
    let mut sums: BTreeMap<NodeIndex, ([f64; 6], f64)> = BTreeMap::new();
    // along a truss is no direction of the model
    for (kind, results) in blocks(frame).filter(|(kind, _)| !kind.is_truss()) {
        for (element, values) in results.elements(frame.model) {
            let points = stresses(kind, values);
            if points.is_empty() {
                continue;
            }
            let mut at_nodes = vec![0.0; element.nodes.len()];
            for component in 0..6 {
                let own: Vec<f64> = points.iter().map(|tensor| tensor[component]).collect();
                (kind.at_nodes)(&own, &mut at_nodes);
                for (node, value) in element.nodes.iter().zip(&at_nodes) {
                    let (sum, count) = sums.entry(*node).or_default();
                    sum[component] += value;
                    *count += 1.0 / 6.0;
                }
            }
        }
    }
    sums.into_iter().map(|(node, (sum, count))| (node, sum.map(|s| s / count.round()))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideline_model::types::CPE4;

    /// Requirement: columns are means over the points; a pull along z alone has its own size as
    /// Mises stress, an even pressure none.
    #[test]
    fn columns_and_mises_of_a_solid() {
        let mut values = [0.0; 36];
        values[..16].copy_from_slice(&[
            1.0, 0.0, 0.0, 0.5, 3.0, 0.0, 0.0, 0.5, 1.0, 4.0, 0.0, 0.5, 3.0, 0.0, 0.0, 0.5,
        ]);
        let columns: Vec<_> = means(&CPE4, &values).collect();
        assert_eq!(columns[..4], [("S11", 2.0), ("S22", 1.0), ("S33", 0.0), ("S12", 0.5)]);
        assert_eq!(columns.len(), 9);
        assert_eq!(stresses(&CPE4, &values)[2], [1.0, 4.0, 0.0, 0.5, 0.0, 0.0]);
        assert_eq!(mises([0.0, 0.0, -2.0, 0.0, 0.0, 0.0]), 2.0);
        assert_eq!(mises([3.0, 3.0, 3.0, 0.0, 0.0, 0.0]), 0.0);
    }
}
