//! Ends that went in through another side of the master.

use super::super::face::FacePlaces;
use super::super::reference::Reference;
use super::*;
use crate::contact::points::Across;

/// What counts of a face of length one that is an end of its surface, of which a line covers 0.4 from there on, at a height [L].
fn counting(height: f64) -> f64 {
    let own = [[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]];
    let reference = Reference::new(&own, Across::Width(1.0));
    let places = FacePlaces::new(None, &own, None);
    let curves = [Curve::new(&[[0.4, height, 0.0], [-1.0, height, 0.0]], 1.0)];
    let turned = [Curve::new(&[[-1.0, height, 0.0], [0.4, height, 0.0]], 1.0)];
    let covered = |curves: &[Curve<f64>]| {
        let face = MortarFace { reference: &reference, places: &places, curves };
        let mut cover = Cover::default();
        let segments = cover.find(&face).iter();
        segments.map(|own| own.counts * (own.bounds[1].at() - own.bounds[0].at())).sum::<f64>()
    };
    covered(&curves).max(covered(&turned))
}

/// Requirement: such an end counts as a whole up to as deep as wide, and less and less to nothing at twice that; one that is
/// in front counts however far.
#[test]
fn an_end_that_went_in_elsewhere_fades() {
    let over = |side: f64| -> Vec<f64> {
        (0..=600).map(|k| counting(side * (0.3 + 0.001 * f64::from(k)))).collect()
    };
    let [one, other] = [over(1.0), over(-1.0)];
    let (deep, front) = if one[600] < other[600] { (one, other) } else { (other, one) };
    assert!(front.iter().all(|own| (own - 0.4).abs() < 1e-12), "{front:?}");
    assert!(deep[..=100].iter().all(|own| (own - 0.4).abs() < 1e-12), "{deep:?}");
    assert!(deep[501..].iter().all(|own| *own == 0.0), "{deep:?}");
    // 1.5 / 400 of 0.4 at most from one to the next
    assert!(deep.windows(2).all(|two| (two[0] - two[1]).abs() < 0.002), "{deep:?}");
}
