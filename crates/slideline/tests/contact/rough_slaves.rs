//! A rigid rim of slaves dragged over a beam on which it must not slip.
//!
//! ```text
//!          .---.        hard contact, ROUGH: pressed 0.17 to 0.19 of a span of 1, then dragged by 0.15 to 0.2
//!     o----'-o-'----o   a beam, its left end clamped
//! ```
//!
//! Many slaves close on few elements while these roll up along the rim. Linearised at pressures that the
//! solution does not keep, such pairs were opened as a whole and no equilibrium was found (docs/theory.md 8.17).

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::observe::{Ending, Event, Observer, Stop};
use slideline::{Job, ReadOptions, SolveOptions, solve};
use std::f64::consts::PI;
use std::ops::ControlFlow;

/// Thirteen slaves on the lower part of a circle of radius 0.1 over a beam of twenty elements.
fn deck(press: f64, drag: f64, unit: f64) -> String {
    let mut deck = format!(
        "*HEADING\nrough rim\n*NODE\n1, 0.0, 0.0\n21, {:?}, 0.0\n*NGEN\n1, 21\n*ELEMENT, TYPE=B21, ELSET=BEAM\n\
         1, 1, 2\n*ELGEN, ELSET=BEAM\n1, 20\n*BEAM SECTION, SECTION=RECT, ELSET=BEAM, MATERIAL=M\n{:?}, {:?}\n\
         *MATERIAL, NAME=M\n*ELASTIC\n{:?}, 0.3\n*NODE\n9999, {:?}, {:?}\n*NODE, NSET=RIM\n",
        unit,
        0.1 * unit,
        0.05 * unit,
        1.0e9 / (unit * unit),
        0.54103 * unit,
        0.101 * unit,
    );
    for k in 0..13 {
        let turn = f64::from(k - 6) * 2.92_f64.to_radians() - 0.5 * PI;
        let [x, y] = [0.54103 + 0.1 * turn.cos(), 0.101 + 0.1 * turn.sin()];
        deck += &format!("{}, {:?}, {:?}\n", 9000 + k, x * unit, y * unit);
    }
    let step = |name: &str, along: f64| {
        format!(
            "*STEP, NLGEOM, INC=500\n{name}\n*STATIC\n0.25, 1.0\n*BOUNDARY\n1, 1, 6\n9999, 6\n\
             9999, 1, 1, {:?}\n9999, 2, 2, {:?}\n*END STEP\n",
            along * unit,
            -press * unit
        )
    };
    deck + &format!(
        "*MPC\nBEAM, RIM, 9999\n*ELEMENT, TYPE=ISL21, ELSET=C\n1001, 9000, 9001\n*ELGEN, ELSET=C\n1001, 12\n\
         *SLIDE LINE, TYPE=LINEAR, ELSET=C, SMOOTH=0.0, GENERATE\n1, 21, 1\n*INTERFACE, ELSET=C\n{:?}\n\
         *FRICTION, ROUGH\n{}{}",
        0.1 * unit,
        step("press", 0.0),
        step("drag", drag),
    )
}

#[derive(Default)]
struct Watch {
    imbalance: f64,
    balance: f64,
    work: f64,
    closed: usize,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            for pair in frame.pairs {
                let off = pair.force_imbalance.max(pair.moment_imbalance);
                self.imbalance = self.imbalance.max(off);
                self.closed = pair.closed;
            }
            (self.balance, self.work) = (frame.energy.balance.abs(), frame.energy.external_work);
        }
        ControlFlow::Continue(())
    }
}

/// Requirement: every deck of the family completes, in metres and in millimetres, with contact at its end and
/// forces and moments of the pair in balance.
#[test]
fn a_rough_rim_is_dragged_over_a_beam() {
    for unit in [1.0, 1000.0] {
        for (press, drag) in
            [(0.1746, 0.18), (0.178, 0.15), (0.1806, 0.18), (0.183, 0.2), (0.19, 0.15)]
        {
            let read = Job::read_text("rim", &deck(press, drag, unit), &ReadOptions::default());
            let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
            let mut watch = Watch::default();
            let ending = solve(&model, &SolveOptions::default(), &mut watch);
            assert!(matches!(ending, Ending::Completed(_)), "{unit} {press} {drag}: {ending:?}");
            assert!(watch.imbalance < 1e-9, "{unit} {press} {drag}: {:e}", watch.imbalance);
            assert!(watch.closed > 0 && watch.work > 0.0, "{unit} {press} {drag}");
        }
    }
}
