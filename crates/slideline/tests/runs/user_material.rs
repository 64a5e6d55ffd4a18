//! A material of the embedding program, through a run: the example's own.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

#[allow(dead_code)] // its main is not called here
#[path = "../../examples/user_material.rs"]
mod example;

use example::{Rows, SOFTENING, model};
use slideline::mech::material::Law as _;
use slideline::observe::Ending;
use slideline::{SolveOptions, solve};

/// Requirement: a cube between walls that is pulled, let back and pulled farther carries
/// F = (1 - d(k)) M ln(1 + u)/(1 + u), k the largest M ln(1 + u)^2/2 so far and M the modulus of
/// confined stretch. Source: closed form of the logarithmic strain. Tolerance: 1e-12, for all dofs
/// are prescribed.
#[test]
fn a_law_of_ones_own_softens() {
    let mut rows = Rows::default();
    let ending = solve(&model().unwrap(), &SolveOptions::default(), &mut rows);
    let Ending::Completed(totals) = ending else { panic!("{ending:?}") };
    assert_eq!((totals.increments, totals.cutbacks), (30, 0));
    let stiffness = SOFTENING.stiffest();
    let (mut largest, mut back) = (0.0_f64, [0.0; 2]);
    for (place, &[u, force]) in rows.0.iter().enumerate() {
        let strain = u.ln_1p();
        largest = largest.max(0.5 * stiffness * strain * strain);
        let exact = (1.0 - SOFTENING.softening(largest)) * stiffness * strain / (1.0 + u);
        assert!((force - exact).abs() < 1e-12 * exact, "{place}: {force} {exact}");
        // 0.12 on the way out and on the way back
        for (own, at) in back.iter_mut().zip([3, 18]) {
            if place == at {
                *own = force;
            }
        }
    }
    let [out, later] = back;
    assert!((rows.0[3][0] - rows.0[18][0]).abs() < 1e-15 && later < 0.9 * out, "{back:?}");
}
