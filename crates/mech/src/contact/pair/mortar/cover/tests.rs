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

/// What counts of a face of length one below a line and another one that goes on from it at x = 0.5, up to an end.
fn beside_a_corner(end: [f64; 2]) -> (f64, f64) {
    let own = [[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]];
    let reference = Reference::new(&own, Across::Width(1.0));
    let places = FacePlaces::new(Some([2.0, 0.0, 0.0]), &own, Some([-1.0, 0.0, 0.0]));
    let line = |a: [f64; 2], b: [f64; 2]| Curve::new(&[[a[0], a[1], 0.0], [b[0], b[1], 0.0]], 1.0);
    let counts = |curves: &[Curve<f64>]| {
        let face = MortarFace { reference: &reference, places: &places, curves };
        let mut cover = Cover::default();
        let of = |own: &Segment| own.counts * (own.bounds[1].at() - own.bounds[0].at());
        let side = |own: &&Segment| own.curve == 1;
        let found = cover.find(&face);
        (found.iter().map(of).sum::<f64>(), found.iter().filter(side).map(of).sum::<f64>())
    };
    // in either direction, for the face looks to one side only
    let (low, corner) = ([-1.0, 0.01], [0.5, 0.01]);
    let forth = counts(&[line(low, corner), line(corner, end)]);
    let back = counts(&[line(corner, low), line(end, corner)]);
    if forth.0 > back.0 { forth } else { back }
}

/// Requirement: the side of a corner fades as it turns away from the face, from 59 to 75 degrees, and
/// as it goes away, by half the length of the face to all of it; nowhere is there a leap.
#[test]
fn the_side_of_a_corner_fades() {
    let turned = |degrees: f64| {
        let angle = degrees.to_radians();
        let [far, up] = [0.4 * angle.cos(), 0.4 * angle.sin()];
        beside_a_corner([0.5 + far, 0.01 + up]).1 / far
    };
    let steps: Vec<f64> = (0..=800).map(|k| turned(f64::from(k) * 0.1)).collect();
    assert!(steps[..=580].iter().all(|own| (own - 1.0).abs() < 1e-9), "{steps:?}");
    assert!(steps[750..].iter().all(|own| *own == 0.0), "{steps:?}");
    assert!(steps.windows(2).all(|two| two[0] - two[1] > -1e-12 && two[0] - two[1] < 0.02));
    let apart = |by: f64| {
        let own = [[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]];
        let reference = Reference::new(&own, Across::Width(1.0));
        let places = FacePlaces::new(Some([2.0, 0.0, 0.0]), &own, Some([-1.0, 0.0, 0.0]));
        let step = |from: f64, to: f64, height: f64| {
            let (a, b) = ([from, height, 0.0], [to, height, 0.0]);
            [Curve::new(&[a, b], 1.0), Curve::new(&[b, a], 1.0)]
        };
        let [low, high] = [step(-1.0, 0.5, 0.01), step(0.5, 2.0, 0.01 + by)];
        let counts = |way: usize| {
            let curves = [low[way], high[way]];
            let face = MortarFace { reference: &reference, places: &places, curves: &curves };
            let mut cover = Cover::default();
            let of = |own: &Segment| own.counts * (own.bounds[1].at() - own.bounds[0].at());
            cover.find(&face).iter().map(of).sum::<f64>()
        };
        counts(0).max(counts(1)) - 0.5
    };
    let steps: Vec<f64> = (0..=1200).map(|k| apart(0.001 * f64::from(k))).collect();
    assert!(steps[..=500].iter().all(|own| (own - 0.5).abs() < 1e-9), "{steps:?}");
    assert!(steps[1001..].iter().all(|own| own.abs() < 1e-9), "{steps:?}");
    assert!(steps.windows(2).all(|two| (two[0] - two[1]).abs() < 0.004));
}

/// Requirement: as the nearest part of a face leaves it, what counts of the others does not leap.
#[test]
fn the_nearest_part_takes_nothing_with_it() {
    let counts = |shift: f64| {
        let own = [[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]];
        let reference = Reference::new(&own, Across::Width(1.0));
        let places = FacePlaces::new(Some([2.0, 0.0, 0.0]), &own, Some([-1.0, 0.0, 0.0]));
        // from a wedge that leaves the face at x = 0 up a slope of 45 degrees to a plateau
        let places_of = [[-1.0, 0.01], [shift, 0.01], [0.6 + shift, 0.61], [2.0, 0.61]];
        let curves: Vec<Curve<f64>> = places_of
            .windows(2)
            .map(|two| Curve::new(&[[two[1][0], two[1][1], 0.0], [two[0][0], two[0][1], 0.0]], 1.0))
            .collect();
        let turned: Vec<Curve<f64>> = places_of
            .windows(2)
            .map(|two| Curve::new(&[[two[0][0], two[0][1], 0.0], [two[1][0], two[1][1], 0.0]], 1.0))
            .collect();
        let of = |curves: &[Curve<f64>]| {
            let face = MortarFace { reference: &reference, places: &places, curves };
            let of = |own: &Segment| own.counts * (own.bounds[1].at() - own.bounds[0].at());
            Cover::default().find(&face).iter().map(of).sum::<f64>()
        };
        of(&curves).max(of(&turned))
    };
    let steps: Vec<f64> = (-100..=100).map(|k| counts(1e-4 * f64::from(k))).collect();
    assert!(steps.windows(2).all(|two| (two[0] - two[1]).abs() < 0.002), "{steps:?}");
}
