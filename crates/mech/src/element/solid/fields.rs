//! What changes of volume and pressures of an element are made of.
//!
//! ```text
//!   1 alone         one of them an element
//!   1, x, y (, z)   they vary along straight lines
//!
//!   orthonormal: (1/V) sum w f_a f_b is one for a = b, else nothing
//! ```
//!
//! Positions are undeformed ones, so that no numbering and no shape of the cell counts: docs/theory.md
//! eq. (3.33).

use super::place::{Place, Tables};

/// The most fields of an element: the constant one and one an axis.
pub(super) const MOST_FIELDS: usize = 4;

/// Those of an element beside the constant one, point by point.
pub(super) type Straight<const D: usize, const P: usize> = [[f64; P]; D];

/// The straight fields of an element on the undeformed positions of its nodes [L].
pub(super) fn straight<const D: usize, const N: usize, const P: usize>(
    nodes: &[[f64; D]; N],
    tables: &Tables<D, N, P>,
    places: &[Place<D, N>; P],
) -> Straight<D, P> {
    let shares = shares(places);
    let at = |axis: usize, point: usize| -> f64 {
        let shapes = tables.points[point].shapes.iter();
        shapes.zip(nodes).map(|(shape, node)| shape * (node[axis] - nodes[0][axis])).sum()
    };
    let mut fields: Straight<D, P> =
        std::array::from_fn(|axis| std::array::from_fn(|point| at(axis, point)));
    for a in 0..D {
        let (made, rest) = fields.split_at_mut(a);
        let Some(own) = rest.first_mut() else { continue };
        // twice: in a slender element the first round leaves what its slenderness magnifies
        for _ in 0..2 {
            let constant = mean(&shares, own, None);
            own.iter_mut().for_each(|value| *value -= constant);
            for other in &*made {
                let part = mean(&shares, own, Some(other));
                own.iter_mut().zip(other).for_each(|(value, other)| *value -= part * other);
            }
        }
        let size = mean(&shares, own, Some(own)).sqrt();
        own.iter_mut().for_each(|value| *value /= size);
    }
    fields
}

/// The parts of the undeformed volume that the points of an element stand for [1].
#[inline(always)]
pub(super) fn shares<const D: usize, const N: usize, const P: usize>(
    places: &[Place<D, N>; P],
) -> [f64; P] {
    let volume: f64 = places.iter().map(|place| place.weight).sum();
    std::array::from_fn(|k| places[k].weight / volume)
}

/// The mean over the volume of values at the points, times those of a field.
#[inline(always)]
fn mean<const P: usize>(shares: &[f64; P], values: &[f64; P], field: Option<&[f64; P]>) -> f64 {
    let products = shares.iter().zip(values).map(|(share, value)| share * value);
    match field {
        None => products.sum(),
        Some(field) => products.zip(field).map(|(product, f)| product * f).sum(),
    }
}

/// How much of each field is in values at the points: the constant one first.
#[inline(always)]
pub(super) fn parts<const P: usize>(
    shares: &[f64; P],
    values: &[f64; P],
    straight: &[[f64; P]],
) -> [f64; MOST_FIELDS] {
    let mut parts = [0.0; MOST_FIELDS];
    parts[0] = mean(shares, values, None);
    for (part, field) in parts[1..].iter_mut().zip(straight) {
        *part = mean(shares, values, Some(field));
    }
    parts
}

/// The values at the points that are made of so much of each field.
#[inline(always)]
pub(super) fn values<const P: usize>(parts: &[f64], straight: &[[f64; P]]) -> [f64; P] {
    let Some((constant, rest)) = parts.split_first() else { return [0.0; P] };
    let mut values = [*constant; P];
    for (part, field) in rest.iter().zip(straight) {
        values.iter_mut().zip(field).for_each(|(value, f)| *value += part * f);
    }
    values
}
