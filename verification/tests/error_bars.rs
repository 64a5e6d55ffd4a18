//! Error bars hold the true error, the distance from the continuum C, which is
//! the limit of integrated contact.

use crate::references::{first_continuum, second_continuum};
use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::output::plot::{Axis, Mark, Series};
use slideline::{Job, Quiet, Reactions, ReadOptions, SolveOptions, error_bars};
use slideline_verification::{Claim, Group, Record, paper, run, series};

pub const GROUP: Group = Group {
    file: "error_bars",
    claims: &[
        Claim {
            name: "hold_the_true_error_and_are_not_idle",
            requirement: "The true error of the driven reaction lies inside the bar in at least \
                          95 % of the increments of both problems, with and without friction, and \
                          the bar is within a factor of 5 of it in at least half.",
            source: "The reference C, good to eight digits (docs/theory.md).",
            tolerance: "None of our own: the shares are the requirement.",
            measure: hold_the_true_error_and_are_not_idle,
        },
        Claim {
            name: "exist_for_slave_nodes",
            requirement: "The paper's own decks, slave nodes on the beam and on the circle, have \
                          bars too. They are noisier than an order can describe: what they hold is \
                          told, and required only to be there.",
            source: "The reference C, their limit as well.",
            tolerance: "None: a bar is there or not.",
            measure: exist_for_slave_nodes,
        },
    ],
};

/// (error, bar) of every increment after the start.
fn study(deck: &str, dof: Dof, exact: &[f64]) -> Vec<[f64; 2]> {
    let model = Job::read_text("study", deck, &ReadOptions::default()).model.unwrap();
    let options = SolveOptions::default();
    let mut found = Reactions::of(&model);
    let ending = slideline::solve(&model, &options, &mut found.watch(&mut Quiet));
    assert!(matches!(ending, Ending::Completed(_)));
    let bars = error_bars(&model, &found, &options, &mut Quiet).unwrap();
    let number = if dof == Dof::UR3 { 6 } else { dof.number() };
    let reaction = run(deck).unwrap().reaction(9999, number);
    let bars = bars.of(9999, dof).unwrap();
    assert_eq!((reaction.len(), bars.len()), (exact.len(), exact.len()));
    let errors = reaction.iter().zip(exact).map(|(found, exact)| found - exact);
    errors.zip(bars).map(|(error, &bar)| [error, bar]).collect()
}

fn hold_the_true_error_and_are_not_idle(record: &mut Record) {
    for (name, deck, dof, exact) in [
        ("circle, mu 0", paper::SURFACE_COARSE, Dof::U2, first_continuum(0.0, 20)),
        ("circle, mu 0.3", paper::SURFACE_COARSE_MU03, Dof::U2, first_continuum(0.3, 20)),
        ("cam, mu 0", paper::CAM_SURFACE, Dof::UR3, second_continuum(0.0)),
        ("cam, mu 0.3", paper::CAM_SURFACE_MU03, Dof::UR3, second_continuum(0.3)),
    ] {
        let rows = study(deck, dof, &exact);
        // before the touch there is neither an error nor a bar
        let touching: Vec<&[f64; 2]> = rows.iter().filter(|[error, _]| *error != 0.0).collect();
        let share = |holds: &dyn Fn(f64, f64) -> bool| {
            let count = touching.iter().filter(|[error, bar]| holds(error.abs(), *bar)).count();
            100.0 * count as f64 / touching.len() as f64
        };
        let inside = share(&|error, bar| error <= bar);
        let near = share(&|error, bar| bar <= 5.0 * error && error <= 5.0 * bar);
        record.tell(format!("{name}: increments in contact"), touching.len() as f64);
        record.at_least(format!("{name}: errors inside the bar (%)"), inside, 95.0);
        record.at_least(format!("{name}: bars within a factor of 5 (%)"), near, 50.0);
        chart(record, name, &rows);
    }
}

fn chart(record: &mut Record, name: &str, rows: &[[f64; 2]]) {
    let increments: Vec<f64> = (1..=rows.len()).map(|k| k as f64).collect();
    let of = |value: fn(&[f64; 2]) -> f64| -> Vec<f64> { rows.iter().map(value).collect() };
    let errors = of(|row| row[0].abs());
    let bars = Series { mark: Mark::Dashed, ..series(&increments, ("bar", &of(|row| row[1]))) };
    record.chart(
        format!("Error and bar: {name}"),
        Axis::linear("increment"),
        Axis::logarithmic(if name.starts_with("cam") { "RM3 (N m)" } else { "RF2 (N)" }),
        vec![series(&increments, ("true error", &errors)), bars],
    );
}

fn exist_for_slave_nodes(record: &mut Record) {
    for (name, deck) in [("IRS", paper::IRS_COARSE), ("ISL", paper::ISL_COARSE)] {
        let rows = study(deck, Dof::U2, &first_continuum(0.0, 20));
        let inside = rows.iter().filter(|[error, bar]| error.abs() <= *bar).count();
        record.tell(format!("{name}: errors inside the bar, of 20"), inside as f64);
        record.holds(format!("{name}: there are bars"), rows.iter().any(|[_, bar]| *bar > 0.0));
        chart(record, name, &rows);
    }
}
