//! Friction that changes from step to step, `*CHANGE FRICTION`.
//!
//! Source: docs/keywords/CHANGE-FRICTION.md. A block that slides on a table: the force that drags it
//! is the coefficient times the force that presses it.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::{Dialect, Dof, Model};
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, resume, solve};
use std::ops::ControlFlow;

/// Of every increment: step, time in it, drag and press on the table.
#[derive(Default)]
struct Rows(Vec<[f64; 4]>, Vec<slideline::Checkpoint<'static>>);

impl Observer for Rows {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Committed(frame) => {
                let table = frame.model.nodes.find(9).unwrap();
                let of = |dof| frame.nodal.reaction(table, dof);
                self.0.push([frame.step as f64, frame.step_time, -of(Dof::U1), of(Dof::U2)]);
            }
            Event::Checkpoint(checkpoint) => self.1.push(checkpoint.owned()),
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

/// A block pressed on a table and dragged 0.1 in each step, with the friction and these steps.
fn deck(friction: &str, steps: &[&str]) -> String {
    let mut deck = format!(
        "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 1., 1.\n4, 0., 1.\n9, 0.5, -1.\n*NSET, NSET=TOP\n3, 4\n\
         *ELEMENT, TYPE=CPE4, ELSET=B\n1, 1, 2, 3, 4\n*SOLID SECTION, ELSET=B, MATERIAL=M\n1.\n\
         *MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SURFACE, NAME=FOOT\nB, S1\n*SURFACE, \
         TYPE=SEGMENTS, NAME=TABLE\nSTART, -9., 0.\nLINE, 9., 0.\n*RIGID BODY, REF NODE=9, \
         ANALYTICAL SURFACE=TABLE\n*SURFACE INTERACTION, NAME=I\n{friction}*CONTACT PAIR, \
         INTERACTION=I\nFOOT, TABLE\n*BOUNDARY\n9, 1, 6\n"
    );
    for (number, step) in steps.iter().enumerate() {
        let (parameters, cards) = step.split_once('\n').unwrap();
        let drag = 0.1 * (number + 1) as f64;
        deck += &format!(
            "*STEP{parameters}\n*STATIC, DIRECT\n0.25, 1.\n*BOUNDARY\nTOP, 2, 2, -0.01\n\
             TOP, 1, 1, {drag:?}\n{cards}*END STEP\n"
        );
    }
    deck
}

fn model(deck: &str, dialect: Dialect) -> Model {
    let options = ReadOptions { dialect: Some(dialect), ..ReadOptions::default() };
    let read = Job::read_text("change", deck, &options);
    read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics))
}

fn walked(model: &Model) -> Rows {
    let mut rows = Rows::default();
    match solve(model, &SolveOptions::default(), &mut rows) {
        Ending::Completed(_) => rows,
        other => panic!("{other:?}"),
    }
}

fn change(law: &str) -> String {
    format!("\n*CHANGE FRICTION, INTERACTION=I\n{law}")
}

/// Requirement: while it slides the drag is mu times the press, with mu straight from the old to the
/// new one over the step; after the step it stays, and RESET leads back. Coulomb's law, 1e-9.
#[test]
fn the_coefficient_runs_over_the_step() {
    let down = change("*FRICTION\n0.1\n");
    let back = "\n*CHANGE FRICTION, INTERACTION=I, RESET\n";
    let steps = ["\n", &down, "\n", back, "\n"];
    let rows = walked(&model(&deck("*FRICTION\n0.5\n", &steps), Dialect::Abaqus)).0;
    for [step, time, drag, press] in rows.into_iter().filter(|row| row[0] > 1.0) {
        let mu = match step as usize {
            2 => 0.5 - 0.4 * time,
            3 => 0.1,
            4 => 0.1 + 0.4 * time,
            _ => 0.5,
        };
        assert!((drag - mu * press).abs() < 1e-9 * press, "{step} {time}: {drag} {mu} {press}");
    }
}

/// Requirement: friction begins where there was none, and ends; at once with AMPLITUDE=STEP and in
/// the dialect of CalculiX. Coulomb's law, 1e-9.
#[test]
fn friction_begins_and_ends() {
    let (on, off) = (change("*FRICTION\n0.3\n"), change("*FRICTION\n0.\n"));
    let at_once = format!(", AMPLITUDE=STEP{on}");
    type Coefficients = [fn(f64) -> f64; 3];
    let cases: [(Dialect, [&str; 3], Coefficients); 3] = [
        (Dialect::Abaqus, ["\n", &on, &off], [|_| 0.0, |t| 0.3 * t, |t| 0.3 - 0.3 * t]),
        (Dialect::Abaqus, ["\n", &at_once, &off], [|_| 0.0, |_| 0.3, |t| 0.3 - 0.3 * t]),
        (Dialect::Calculix, ["\n", &on, &off], [|_| 0.0, |_| 0.3, |_| 0.0]),
    ];
    for (dialect, steps, mu) in cases {
        for [step, time, drag, press] in walked(&model(&deck("", &steps), dialect)).0 {
            let mu = mu[step as usize - 1](time);
            assert!((drag - mu * press).abs() < 1e-9 * press, "{step} {time}: {drag} {mu} {press}");
        }
    }
}

/// Requirement: a run that is left in the middle of a change goes on to the same bits.
#[test]
fn a_saved_state_in_the_middle_of_a_change_goes_on_alike() {
    let down = change("*FRICTION\n0.1\n");
    let model = model(&deck("*FRICTION\n0.5\n", &["\n", &down, "\n"]), Dialect::Abaqus);
    let straight = walked(&model);
    for (place, from) in straight.1.into_iter().enumerate().take(11) {
        let mut rows = Rows::default();
        let ending = resume(&model, &SolveOptions::default(), from, &mut rows);
        assert!(matches!(ending, Some(Ending::Completed(_))), "{place}: {ending:?}");
        assert_eq!(rows.0, straight.0[place + 1..], "from {place} on");
    }
}
