//! Energy over the stroke, 200 increments.
//!
//! The work is the trapezoid of reaction and travel, the strain energy the sum
//! over the elements' strains and section forces, the contact energy theory's
//! integral of the law; only the friction work is the program's own number.

use slideline::output::plot::Axis;
use slideline_theory::ExponentialLaw;
use slideline_verification::{
    Claim, Curve, Group, Method, Push, Record, Row, run, series, trapezoid, worst,
};

const TRAPEZOID: &str = "0.1 %: the trapezoidal rule, which over a stroke whose force grows by a \
                         tenth an increment at its end errs by a few 1e-4.";

pub const GROUP: Group = Group {
    file: "energy",
    claims: &[
        Claim {
            name: "frictionless_work_is_stored",
            requirement: "Without friction the driver's work is the gain of strain energy and \
                          contact energy.",
            source: "Conservation of energy; the law's integral in closed form.",
            tolerance: TRAPEZOID,
            measure: frictionless_work_is_stored,
        },
        Claim {
            name: "friction_balances_and_never_gives",
            requirement: "With friction, what is not stored is dissipated; dissipation never \
                          falls.",
            source: "Conservation of energy; the second law.",
            tolerance: TRAPEZOID,
            measure: friction_balances_and_never_gives,
        },
        Claim {
            name: "the_programs_energies_are_ours",
            requirement: "Strain and contact energy in every increment, as the program reports \
                          them, are those of strains and openings.",
            source: "The same integrals, written again.",
            tolerance: "1e-9: rounding.",
            measure: the_programs_energies_are_ours,
        },
    ],
};

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

fn chart(record: &mut Record, curve: &Curve) {
    let travel: Vec<f64> = curve.displacement(Push::CIRCLE, 2).iter().map(|u| -1e3 * u).collect();
    let of = |energy: &dyn Fn(&Row) -> f64| -> Vec<f64> { curve.rows.iter().map(energy).collect() };
    let strain = of(&|row| curve.beam_energy(row));
    let contact = of(&contact_energy);
    let lost = of(&|row| row.energy.friction_dissipation);
    let work = of(&|row| row.energy.external_work);
    let curves = [("work", &work), ("strain", &strain), ("contact", &contact), ("friction", &lost)];
    let curves = curves.iter().map(|(name, values)| series(&travel, (name, values))).collect();
    record.chart(
        "Energies",
        Axis::linear("travel of the circle (mm)"),
        Axis::linear("energy (J)"),
        curves,
    );
}

fn frictionless_work_is_stored(record: &mut Record) {
    let curve = push(0.0);
    let [work, held, lost] = books(&curve);
    record.tell("work (J)", work);
    record.at_most("work that is not stored (%)", 100.0 * (held / work - 1.0).abs(), 0.1);
    record.holds("no friction work", lost == 0.0);
    chart(record, &curve);
}

fn friction_balances_and_never_gives(record: &mut Record) {
    let curve = push(0.3);
    let [work, held, lost] = books(&curve);
    record.tell("work (J)", work);
    record.tell("friction work (J)", lost);
    let off = 100.0 * ((held + lost) / work - 1.0).abs();
    record.at_most("work neither stored nor dissipated (%)", off, 0.1);
    let own = curve.rows.last().unwrap().energy.balance / work;
    record.tell("the same as the program reports it (%)", 100.0 * own);
    let dissipation: Vec<f64> =
        curve.rows.iter().map(|row| row.energy.friction_dissipation).collect();
    let rises = dissipation[0] >= 0.0 && dissipation.windows(2).all(|pair| pair[1] >= pair[0]);
    record.holds("dissipation never falls", rises);
    chart(record, &curve);
}

fn the_programs_energies_are_ours(record: &mut Record) {
    let curve = push(0.3);
    let off = |own: fn(&Row) -> f64, ours: &dyn Fn(&Row) -> f64| {
        worst(curve.rows.iter().map(|row| (own(row) / ours(row) - 1.0).abs()))
    };
    let strain = off(|row| row.energy.strain_energy, &|row| curve.beam_energy(row));
    record.at_most("strain energy, largest difference", strain, 1e-9);
    let contact = off(|row| row.energy.contact_energy, &contact_energy);
    record.at_most("contact energy, largest difference", contact, 1e-9);
}
