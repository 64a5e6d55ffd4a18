//! A friction law of the embedding program, through a deck: the example's own.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

#[allow(dead_code)] // its main is not called here
#[path = "../../examples/user_friction.rs"]
mod example;

use example::{Constants, DECK, NAME, pull};
use slideline::friction::{
    FrictionBatch, FrictionPoint, Tangential, Traction, UserFriction, UserFrictionError,
};
use slideline::observe::Ending;
use slideline::{Job, Quiet, ReadOptions, RunOptions, Severity, Status, TangentCheck, run};
use std::sync::Arc;

const CONSTANTS: Constants =
    Constants { fresh: 0.3, pressure: 10.0, left: 0.4, distance: 0.2, elastic_slip: 1e-3 };

/// Half of a contact element of length 1 and width 1.
const AREA: f64 = 0.5;

/// Requirement: F = A tau_crit(N/A, s) with s the distance slid: travel less
/// the elastic slip, which turns over twice at the reversal. Derived. Tolerance
/// 1e-9: backward Euler is exact here, for the limit depends on s alone.
#[test]
fn a_law_with_a_memory_gives_its_closed_form() {
    let read = Job::read_text("running_in", DECK, &ReadOptions::default());
    let (pulled, ending) = pull(&read.model.unwrap());
    let Ending::Completed(totals) = ending else { panic!("{ending:?}") };
    assert_eq!((totals.increments, totals.cutbacks), (21, 0));
    for (k, [travel, force]) in pulled.rows.iter().enumerate().skip(1) {
        let (slid, way) = match k {
            1..=10 => (travel - 1e-3, 1.0),
            _ => (0.5 - 1e-3 + (0.5 - travel) - 2e-3, -1.0),
        };
        let p = 10.0 / AREA;
        let worn = 0.4 + 0.6 * (-slid / 0.2).exp();
        let exact = way * AREA * 0.3 * p.powf(2.0 / 3.0) * 10f64.powf(1.0 / 3.0) * worn;
        assert!((force - exact).abs() < 1e-9 * exact.abs(), "row {k}: {force} {exact}");
    }
}

/// Requirement: the derivatives are those of the traction. Central differences
/// with 1e-6 of each variable are good to 1e-8 relative.
#[test]
fn its_derivatives_are_right() {
    let traction = |pressure: f64, slip: f64, elastic_slip: f64| {
        let (slip, elastic_slip) = (Tangential::along(slip), Tangential::along(elastic_slip));
        let mut tractions = [Traction::ZERO];
        let mut state = [0.0];
        example::RunningIn
            .update(&mut FrictionBatch {
                properties: &[0.3, 10.0, 0.4, 0.2, 1e-3],
                time: 1.0,
                dt: 0.1,
                points: &[FrictionPoint { pressure, slip, elastic_slip }],
                committed: &[0.07],
                state: &mut state,
                tractions: &mut tractions,
            })
            .unwrap();
        tractions[0]
    };
    for (p, slip, elastic) in [(20.0, 0.05, 2e-4), (3.0, -0.05, 2e-4), (20.0, 4e-4, -1e-4)] {
        let found = traction(p, slip, elastic);
        let by_p = (traction(p * (1.0 + 1e-6), slip, elastic).tau[0]
            - traction(p * (1.0 - 1e-6), slip, elastic).tau[0])
            / (2e-6 * p);
        let by_slip = (traction(p, slip * (1.0 + 1e-6), elastic).tau[0]
            - traction(p, slip * (1.0 - 1e-6), elastic).tau[0])
            / (2e-6 * slip);
        assert!((found.d_tau_d_pressure[0] / by_p - 1.0).abs() < 1e-7, "{by_p} {found:?}");
        assert!((found.d_tau_d_slip.at(0, 0) / by_slip - 1.0).abs() < 1e-7, "{by_slip} {found:?}");
    }
    assert_eq!(CONSTANTS, Constants::read(&[0.3, 10.0, 0.4, 0.2, 1e-3]).unwrap());
}

/// Requirement: a law that gives no answer ends the run with its own words,
/// and what converged before stays; a law nobody registered is an error.
#[test]
fn no_answer_and_no_law() {
    let deck = DECK.replace("0.3, 10.0, 0.4", "0.3, 10.0, -0.4");
    let read = Job::read_text("running_in", &deck, &ReadOptions::default());
    let (_, ending) = pull(&read.model.unwrap());
    let Ending::NotConverged(_, said) = ending else { panic!("{ending:?}") };
    assert_eq!(said.code.0, "SL0505");
    assert!(said.message.contains("five positive constants"), "{}", said.message);
    assert!(said.span.is_some());

    let read = Job::read_text("running_in", DECK, &ReadOptions::default());
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("no_law");
    let options = RunOptions { folder: Some(folder), ..RunOptions::default() };
    let outcome = run(&read, &options, &mut Quiet);
    assert_eq!(outcome.status, Status::InputError);
    assert!(outcome.diagnostics[0].message.contains(NAME));
}

/// The example's law with a derivative that is a tenth too large.
#[derive(Debug)]
struct WrongSlope;

impl UserFriction for WrongSlope {
    fn update(&self, batch: &mut FrictionBatch<'_>) -> Result<(), UserFrictionError> {
        example::RunningIn.update(batch)?;
        for traction in batch.tractions.iter_mut() {
            traction.d_tau_d_slip = 1.1 * traction.d_tau_d_slip;
        }
        Ok(())
    }
}

/// Requirement: a tangent that is not the derivative of the residual is found
/// where it is asked for, and named: SL0906 once, as a warning, on the outcome
/// and in the files, with the entry and the contact point; the converged
/// increments stand. With the right derivative nothing is said.
#[test]
fn a_wrong_derivative_is_found() {
    let spring = "*NODE\n5, 1.0, 0.0\n*ELEMENT, TYPE=SPRINGA, ELSET=SPRING\n21, 1, 5\n\
                  *SPRING, ELSET=SPRING\n\n100.0\n*RIGID SURFACE";
    let deck = DECK
        .replacen("*RIGID SURFACE", spring, 1)
        .replacen("1, 1\n1, 6\n", "5, 1, 6\n1, 6\n", 1)
        .replace("1, 1, 1, 0", "5, 1, 1, 0");
    let read = Job::read_text("tangent", &deck, &ReadOptions::default());
    assert!(read.model.is_some(), "{:?}", read.diagnostics);
    let laws: [(Arc<dyn UserFriction>, usize); 2] =
        [(Arc::new(example::RunningIn), 0), (Arc::new(WrongSlope), 1)];
    for (law, expected) in laws {
        let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("wrong_slope");
        let mut options = RunOptions { folder: Some(folder), ..RunOptions::default() };
        options.solve.user_frictions.register(NAME, law);
        options.solve.check_tangent = TangentCheck::Every;
        let outcome = run(&read, &options, &mut Quiet);
        assert_eq!(outcome.status, Status::Completed, "{:?}", outcome.diagnostics);
        let said: Vec<_> =
            outcome.diagnostics.iter().filter(|said| said.code.0 == "SL0906").collect();
        assert_eq!(said.len(), expected, "{said:?}");
        let messages = std::fs::read_to_string(outcome.files.path(".msg")).unwrap();
        assert_eq!(messages.matches("SL0906").count(), expected);
        for said in said {
            assert_eq!(said.severity, Severity::Warning);
            assert!(
                said.message.contains("node 1") && said.message.contains("CONTACT"),
                "{said:?}"
            );
            assert!(said.help.as_ref().is_some_and(|help| help.contains("report")), "{said:?}");
            let summary = std::fs::read_to_string(outcome.files.path(".json")).unwrap();
            assert!(summary.contains("SL0906"), "{summary}");
        }
    }
}
