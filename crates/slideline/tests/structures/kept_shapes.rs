//! `*MPC` of types STRAIGHT, PLANE and MEANROT in large motion, on the deck of the keyword.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::{Dof, Model};
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::collections::HashMap;
use std::ops::ControlFlow;
use std::path::Path;

type Vector = [f64; 3];

/// Undeformed place, place and reaction of all nodes at the end, by label, and the iterations.
#[derive(Default)]
struct End {
    nodes: HashMap<u64, [Vector; 3]>,
}

impl Observer for End {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let along = [Dof::U1, Dof::U2, Dof::U3];
            let of_node = |node| {
                let before = frame.model.nodes.position(node);
                let motion = along.map(|dof| frame.nodal.displacement(node, dof));
                let reaction = along.map(|dof| frame.nodal.reaction(node, dof));
                let now = std::array::from_fn(|k| before[k] + motion[k]);
                (frame.model.nodes.label(node), [before, now, reaction])
            };
            self.nodes = (0..frame.model.nodes.len()).map(of_node).collect();
        }
        ControlFlow::Continue(())
    }
}

fn less(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] - b[k])
}

fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn centre(of: [Vector; 4]) -> Vector {
    std::array::from_fn(|k| of.iter().map(|own| own[k]).sum::<f64>() / 4.0)
}

/// A deck of the keywords, with a tight tolerance of forces.
fn keyword_deck(name: &str) -> Model {
    let deck = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/keywords").join(name);
    let read = Job::read(&deck, &ReadOptions::default());
    let mut model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
    for step in &mut model.steps {
        step.controls.field.r_n = 1e-10;
    }
    model
}

/// Requirement: after a twist by 0.8 and a bend the end section is plane, the edge straight, the mean
/// turn of the section what was prescribed, and the moment that the angle takes is in balance with the
/// supports about the section's centre: forces of a mean turn m are a moment m. Steps converge
/// quadratically: at most six iterations an increment. Source: docs/theory.md eqs (4.16) to (4.18).
#[test]
fn a_twisted_beam_keeps_its_shapes() {
    let model = keyword_deck("mpc_keeps_shapes.inp");
    let mut end = End::default();
    let Ending::Completed(totals) = solve(&model, &SolveOptions::default(), &mut end) else {
        panic!("not completed")
    };
    assert!(totals.iterations <= 6 * totals.increments, "{totals:?}");
    assert_eq!(totals.cutbacks, 0);
    let [before, now, reaction] =
        [0, 1, 2].map(|what| move |label: u64, end: &End| end.nodes[&label][what]);
    let section = [17, 18, 19, 20];
    let at = section.map(|label| now(label, &end));
    let [d, e, r] = [1, 2, 3].map(|k| less(at[k], at[0]));
    assert!(dot(cross(d, e), r).abs() < 1e-12, "{at:?}");
    // the edge has moved far, and no axis of the model is along it any more
    let edge = [10, 18, 14].map(|label| now(label, &end));
    let (whole, part) = (less(edge[1], edge[0]), less(edge[2], edge[0]));
    assert!(cross(whole, part).iter().all(|x| x.abs() < 1e-12), "{edge:?}");
    assert!(whole.iter().all(|x| x.abs() > 0.05), "{whole:?}");
    // independent of the solver's angle: the turn of each arm across the axis
    let centres = [centre(section.map(|label| before(label, &end))), centre(at)];
    let angle = |k: usize| {
        let [p, q] = [less(before(section[k], &end), centres[0]), less(at[k], centres[1])];
        q[2].atan2(q[1]) - p[2].atan2(p[1])
    };
    let tau = std::f64::consts::TAU;
    let mean = (0..4).map(|k| (angle(k) + 3.5 * tau) % tau - 0.5 * tau).sum::<f64>() / 4.0;
    assert!((mean - 0.8).abs() < 1e-12, "{mean}");
    let root = [1, 2, 3, 4]
        .map(|label| cross(less(now(label, &end), centres[1]), reaction(label, &end))[0]);
    let load = cross(less(now(19, &end), centres[1]), [0.0, -2.0, 0.0])[0];
    let moment = reaction(99, &end)[0];
    let left = root.iter().sum::<f64>() + load + moment;
    assert!(moment > 1.0 && left.abs() < 1e-7 * moment, "{moment} {left}");
}

/// Requirement: a bar between pins keeps its length to rounding, and what holds the mast at its other
/// end pulls along that bar. A tied node moves with its master, one between two others stays there.
#[test]
fn a_link_keeps_its_length_and_pulls_along_itself() {
    let mut end = End::default();
    let ending = solve(&keyword_deck("mpc_ties.inp"), &SolveOptions::default(), &mut end);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
    let now = |label: u64| end.nodes[&label][1];
    let bar = less(now(13), now(21));
    assert!((dot(bar, bar).sqrt() - 10.0).abs() < 1e-12, "{bar:?}");
    assert!(bar[0].abs() > 0.1, "it has turned: {bar:?}");
    let pull = end.nodes[&22][2];
    let across = cross(pull, bar)[2] / (dot(pull, pull) * dot(bar, bar)).sqrt();
    assert!(dot(pull, pull) > 1e-4 && across.abs() < 1e-7, "{pull:?} {across}");
    assert!(less(now(11), now(3)).iter().all(|x| x.abs() < 1e-13));
    let middle: Vector = std::array::from_fn(|k| 0.5 * (now(1)[k] + now(2)[k]));
    assert!(less(now(31), middle).iter().all(|x| x.abs() < 1e-13));
}
