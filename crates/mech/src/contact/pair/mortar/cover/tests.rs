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

/// What counts of a face of length one below a chain of places, of all and of its last line, between faces that go on.
fn below(chain: &[[f64; 2]]) -> (f64, f64) {
    let own = [[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]];
    let reference = Reference::new(&own, Across::Width(1.0));
    let places = FacePlaces::new(Some([2.0, 0.0, 0.0]), &own, Some([-1.0, 0.0, 0.0]));
    let curve = |a: [f64; 2], b: [f64; 2]| Curve::new(&[[a[0], a[1], 0.0], [b[0], b[1], 0.0]], 1.0);
    let counts = |curves: Vec<Curve<f64>>| {
        let face = MortarFace { reference: &reference, places: &places, curves: &curves };
        let of = |own: &Segment| own.counts * (own.bounds[1].at() - own.bounds[0].at());
        let mut cover = Cover::default();
        let found = cover.find(&face);
        let last = found.iter().filter(|own| own.curve + 1 == curves.len());
        (found.iter().map(of).sum::<f64>(), last.map(of).sum::<f64>())
    };
    // in either direction: the face looks to one side only
    let forth = counts(chain.windows(2).map(|two| curve(two[0], two[1])).collect());
    let back = counts(chain.windows(2).map(|two| curve(two[1], two[0])).collect());
    if forth.0 > back.0 { forth } else { back }
}

/// Requirement: the side of a corner fades as it turns away from the face, from 59 to 75 degrees, and so does
/// what leans over the whole face; a step fades as it goes away; nowhere is there a leap.
#[test]
fn the_side_of_a_corner_fades() {
    let side = |degrees: f64| {
        let angle = degrees.to_radians();
        let [far, up] = [0.4 * angle.cos(), 0.4 * angle.sin()];
        below(&[[-1.0, 0.01], [0.5, 0.01], [0.5 + far, 0.01 + up]]).1 / far
    };
    let whole = |degrees: f64| {
        let up = degrees.to_radians().tan();
        below(&[[-0.5, 0.01 - 0.5 * up], [1.5, 0.01 + 1.5 * up]]).0
    };
    let ways: [&dyn Fn(f64) -> f64; 2] = [&side, &whole];
    for way in ways {
        let steps: Vec<f64> = (0..=800).map(|k| way(f64::from(k) * 0.1)).collect();
        assert!(steps[..=580].iter().all(|own| (own - 1.0).abs() < 1e-9), "{steps:?}");
        assert!(steps[750..].iter().all(|own| *own == 0.0), "{steps:?}");
        assert!(steps.windows(2).all(|two| two[0] - two[1] > -1e-12 && two[0] - two[1] < 0.02));
    }
    let apart = |by: f64| {
        let low = below(&[[-1.0, 0.01], [0.5, 0.01]]).0;
        let step = [[-1.0, 0.01], [0.5, 0.01], [0.5, 0.01 + by], [2.0, 0.01 + by]];
        below(&step).0 - low
    };
    let steps: Vec<f64> = (0..=1400).map(|k| apart(0.001 * f64::from(k))).collect();
    assert!(steps[..=840].iter().all(|own| (own - 0.5).abs() < 1e-9), "{steps:?}");
    assert!(steps[1251..].iter().all(|own| own.abs() < 1e-9), "{steps:?}");
    assert!(steps.windows(2).all(|two| (two[0] - two[1]).abs() < 0.004));
}

/// Requirement: as the nearest part of a face leaves it, what counts of the others does not leap.
#[test]
fn the_nearest_part_takes_nothing_with_it() {
    // a flat that leaves the face at x = 0, a slope of 55 degrees and a plateau
    let counts =
        |shift: f64| below(&[[-1.0, 0.01], [shift, 0.01], [0.7 + shift, 1.01], [2.0, 1.01]]).0;
    let steps: Vec<f64> = (-100..=100).map(|k| counts(1e-4 * f64::from(k))).collect();
    assert!(steps.windows(2).all(|two| (two[0] - two[1]).abs() < 0.002), "{steps:?}");
}
