//! Energy over the stroke, 200 increments.
//!
//! Requirement: work of the driver = strain energy + contact energy
//! (+ friction). Source: verification section 7. The work is the trapezoid of
//! reaction and travel, the strain energy the sum over the elements' strains
//! and section forces, the contact energy theory's integral of the law; only
//! the friction work is the program's own number. Tolerance: the trapezoidal
//! rule, which over a stroke whose force grows by a tenth an increment at its
//! end errs by a few 1e-4; 0.1 %.

use slideline_theory::ExponentialLaw;
use slideline_verification::{Curve, Method, Push, Row, run, trapezoid};

fn contact_energy(row: &Row) -> f64 {
    let law = ExponentialLaw::diehl();
    row.contact.iter().map(|point| point.area * law.at(-point.opening).energy).sum()
}

/// (work, strain + contact energy, friction work), from the first row to the last.
fn books(curve: &Curve) -> [f64; 3] {
    let (first, last) = (&curve.rows[0], curve.rows.last().unwrap());
    let work = trapezoid(&curve.displacement(Push::CIRCLE, 2), &curve.reaction(Push::CIRCLE, 2));
    let held = |row: &Row| curve.beam_energy(row) + contact_energy(row);
    let lost = |row: &Row| row.energy.friction_dissipation + row.energy.friction_elastic;
    [work, held(last) - held(first), lost(last) - lost(first)]
}

fn push(mu: f64) -> Curve {
    run(&Push { increments: 200, mu, ..Push::paper(Method::Isl) }.deck()).unwrap()
}

#[test]
fn frictionless_work_is_stored() {
    let [work, held, lost] = books(&push(0.0));
    println!("energy: work {work:.6} held {held:.6}, off {:.4} %", 100.0 * (held / work - 1.0));
    assert_eq!(lost, 0.0);
    assert!((held / work - 1.0).abs() < 1e-3, "{work} {held}");
}

#[test]
fn friction_balances_and_never_gives() {
    let curve = push(0.3);
    let [work, held, lost] = books(&curve);
    println!(
        "energy, mu 0.3: work {work:.6} held {held:.6} lost {lost:.6}, off {:.4} %, own balance {:.2e}",
        100.0 * ((held + lost) / work - 1.0),
        curve.rows.last().unwrap().energy.balance / work
    );
    assert!(((held + lost) / work - 1.0).abs() < 1e-3, "{work} {held} {lost}");
    let mut before = 0.0;
    for row in &curve.rows {
        let now = row.energy.friction_dissipation;
        assert!(now >= before, "increment {}: {now} < {before}", row.increment);
        before = now;
    }
}

/// The program's own energies against ours: the same integrals, 1e-9.
#[test]
fn the_programs_energies_are_ours() {
    let curve = push(0.3);
    for row in &curve.rows {
        let (strain, contact) = (curve.beam_energy(row), contact_energy(row));
        let own = row.energy;
        assert!((own.strain_energy - strain).abs() <= 1e-9 * strain, "{own:?} {strain}");
        assert!((own.contact_energy - contact).abs() <= 1e-9 * contact, "{own:?} {contact}");
    }
}
