//! A `*DISTRIBUTING` coupling that turns far: what is lost of its moment is told.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::ops::ControlFlow;
use std::path::Path;

/// What is said, and at the end the moment of the supports of the root, and the turn of the tip [rad].
#[derive(Default)]
struct Watch {
    said: Vec<&'static str>,
    moment: f64,
    turn: f64,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Diagnosed(said) => self.said.push(said.code.0),
            Event::Committed(frame) => {
                let nodes = &frame.model.nodes;
                let of = |label: u64| {
                    let node = nodes.find(label).unwrap();
                    let motion = [Dof::U1, Dof::U2].map(|dof| frame.nodal.displacement(node, dof));
                    let pull = [Dof::U1, Dof::U2].map(|dof| frame.nodal.reaction(node, dof));
                    (nodes.get(node).position, motion, pull)
                };
                let own = [1, 11, 21].map(of);
                self.moment = own.iter().map(|(x, _, f)| x[0] * f[1] - x[1] * f[0]).sum();
                let [(low, down, _), (high, up, _)] = [9, 29].map(of);
                let side = [0, 1].map(|k| high[k] + up[k] - low[k] - down[k]);
                let before = [high[0] - low[0], high[1] - low[1]];
                let sine = before[0] * side[1] - before[1] * side[0];
                self.turn = sine.atan2(before[0] * side[0] + before[1] * side[1]);
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

fn deck() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/run/SL0623-turned.inp");
    std::fs::read_to_string(path).unwrap()
}

/// The deck of `corpus/run` with a moment, as it lies there or standing, of large motion or small.
fn run(moment: f64, stands: bool, kinematics: &str) -> Watch {
    let mut deck = deck()
        .replace("100, 6, 40.", &format!("100, 6, {moment}"))
        .replace("*STEP, NLGEOM", &format!("*STEP, NLGEOM={kinematics}"));
    if stands {
        let corners = [
            ("1, 0., 0.", "1, 0., 0."),
            ("9, 80., 0.", "9, 0., 80."),
            ("21, 0., 4.", "21, -4., 0."),
            ("29, 80., 4.", "29, -4., 80."),
            ("100, 80., 2.", "100, -2., 80."),
        ];
        for (lying, standing) in corners {
            deck = deck.replace(&format!("\n{lying}\n"), &format!("\n{standing}\n"));
        }
    }
    run_deck(&deck)
}

fn run_deck(deck: &str) -> Watch {
    let read = Job::read_text("deck", deck, &ReadOptions::default());
    let mut watch = Watch::default();
    let ending = solve(&read.model.unwrap(), &SolveOptions::default(), &mut watch);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
    watch
}

/// Requirement: the cosine of the turn is what arrives of a moment, as the page of SL0623 says, and from 0.1 on it is
/// told, once, however the strip lies; not of small turns, nor where all motion is small.
#[test]
fn a_mean_that_turned_far_is_told() {
    for (moment, stands) in [(40.0, false), (40.0, true), (-40.0, false)] {
        let far = run(moment, stands, "YES");
        assert!(far.turn.abs() > 0.25, "{}", far.turn);
        let arrived = -far.moment / moment;
        assert!((arrived - far.turn.cos()).abs() < 2e-3, "{arrived} {}", far.turn.cos());
        assert_eq!(far.said.iter().filter(|code| **code == "SL0623").count(), 1);
    }
    let near = run(10.0, false, "YES");
    assert!(near.turn < 0.1 && !near.said.contains(&"SL0623"), "{} {:?}", near.turn, near.said);
    assert!(!run(40.0, false, "NO").said.contains(&"SL0623"));
    // the mean displacement of the centre is exact for any turn
    let centre = |deck: &str| {
        deck.replace("*DISTRIBUTING\n1, 6\n", "*DISTRIBUTING\n1, 2\n")
            .replace("100, 6, 40.", "100, 2, 1.")
    };
    let pushed = run_deck(&centre(&deck()));
    assert!(pushed.turn > 0.25 && !pushed.said.contains(&"SL0623"), "{}", pushed.turn);
    let aside = run_deck(&centre(&deck()).replace("100, 80., 2.", "100, 80., 9."));
    assert!(aside.turn > 0.25 && aside.said.contains(&"SL0623"), "{}", aside.turn);
}
