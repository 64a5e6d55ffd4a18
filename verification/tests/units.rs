//! The same deck in other units.
//!
//! Requirement: reactions scale with the unit of force to rounding, and bit
//! for bit where both units are scaled by powers of two: no number in the
//! program has a dimension. Source: verification section 7. Tolerance for
//! m to mm: decimal numbers of the deck round differently, 1e-9 of the peak.

use slideline_verification::{Method, Push, Units, largest_difference, peak, run};

fn forces(push: &Push) -> Vec<f64> {
    let curve = run(&push.deck()).unwrap();
    let mut forces = curve.reaction(Push::CIRCLE, 2);
    forces.extend(curve.reaction(Push::CIRCLE, 1));
    forces
}

#[test]
fn millimetres() {
    for method in [Method::Irs, Method::Isl] {
        for mu in [0.0, 0.3] {
            let push = Push { mu, tolerance: Some(1e-12), ..Push::paper(method) };
            let (metre, units) = (forces(&push), Units { length: 1e3, force: 1.0 });
            let off = largest_difference(&metre, &forces(&Push { units, ..push })) / peak(&metre);
            println!("mm {method:?} mu {mu}: {off:.1e}");
            assert!(off < 1e-9, "{method:?} {mu}: {off:e}");
        }
    }
}

#[test]
fn powers_of_two_to_the_bit() {
    for method in [Method::Irs, Method::Isl] {
        for mu in [0.0, 0.3] {
            let push = Push { mu, ..Push::paper(method) };
            let metre = forces(&push);
            for units in [
                Units { length: 1024.0, force: 1.0 },
                Units { length: 1.0, force: 0.125 },
                Units { length: 0.25, force: 64.0 },
            ] {
                let scaled = forces(&Push { units, ..push });
                let same = metre.iter().zip(&scaled).all(|(a, b)| a * units.force == *b);
                let off = metre.iter().zip(&scaled);
                let off = off.map(|(a, b)| (a - b / units.force).abs()).fold(0.0, f64::max);
                assert!(same, "{method:?} mu {mu} {units:?}: off by {off:e}");
            }
        }
    }
}
