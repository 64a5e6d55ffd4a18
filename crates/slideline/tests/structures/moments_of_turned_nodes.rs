//! Reactions of nodes that turn in space about changing axes are moments about fixed axes.
//!
//! Source: docs/theory.md section 4.7; equilibrium.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::{Ending, Energies};
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::collections::BTreeMap;
use std::ops::ControlFlow;

/// Position, displacement and reaction of a node, six of each.
type Row = [[f64; 6]; 3];

/// Nodes by label, and energies.
type State = (BTreeMap<u64, Row>, Energies);

/// The states of all increments.
#[derive(Default)]
struct Watch(Vec<State>);

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let row = |node: usize| {
                let [x, y, z] = frame.model.nodes.position(node);
                let moved = Dof::ALL.map(|dof| frame.nodal.displacement(node, dof));
                let reaction = Dof::ALL.map(|dof| frame.nodal.reaction(node, dof));
                (frame.model.nodes.label(node), [[x, y, z, 0.0, 0.0, 0.0], moved, reaction])
            };
            self.0.push(((0..frame.model.nodes.len()).map(row).collect(), frame.energy));
        }
        ControlFlow::Continue(())
    }
}

fn run(deck: &str) -> Vec<State> {
    let (found, ending) = watch(deck);
    assert!(matches!(ending, Ending::Completed(_)), "{deck}\n{ending:?}");
    found
}

fn watch(deck: &str) -> (Vec<State>, Ending) {
    let read = Job::read_text("turned", deck, &ReadOptions::default());
    let mut model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    for step in &mut model.steps {
        (step.controls.field.r_n, step.controls.field.c_n) = (1e-10, 1e-7);
    }
    let mut watch = Watch::default();
    let ending = solve(&model, &SolveOptions::default(), &mut watch);
    (watch.0, ending)
}

/// A cantilever of four beams along x with these cards, its free end node 5.
fn cantilever(model: &str, steps: &str) -> String {
    format!(
        "*NODE\n1, 0., 0., 0.\n5, 1., 0., 0.\n*NGEN\n1, 5\n*ELEMENT, TYPE=B31, ELSET=B\n1, 1, 2\n\
         2, 2, 3\n3, 3, 4\n4, 4, 5\n*BEAM SECTION, SECTION=RECT, ELSET=B, MATERIAL=M\n.1, .08\n\
         *MATERIAL, NAME=M\n*ELASTIC\n1.E4, .3\n*NSET, NSET=TIP\n5\n{model}*BOUNDARY\n1, 1, 6\n{steps}"
    )
}

/// A step that moves the tip by `moved`, given in the axes of its dofs.
fn driven(moved: [f64; 6], card: &str) -> String {
    let lines: String =
        moved.iter().zip(1..).map(|(u, dof)| format!("5, {dof}, {dof}, {u:?}\n")).collect();
    format!("*STEP, NLGEOM, INC=1000\n*STATIC\n{card}\n*BOUNDARY\n{lines}*END STEP\n")
}

/// Sum of the forces and of their moments about the origin, over the sum of the magnitudes.
fn imbalance(nodes: &BTreeMap<u64, Row>) -> f64 {
    let (mut sums, mut size) = ([0.0; 6], 0.0);
    for [x, u, f] in nodes.values() {
        let at: Vec<f64> = x.iter().zip(u).map(|(x, u)| x + u).collect();
        for k in 0..3 {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            sums[k] += f[k];
            sums[k + 3] += f[k + 3] + at[i] * f[j] - at[j] * f[i];
            size += f[k].abs() + f[k + 3].abs();
        }
    }
    sums.iter().fold(0.0_f64, |most, sum| most.max(sum.abs())) / size
}

/// Requirement: the reactions of an end that is moved to where loads have moved it are these loads,
/// with axes of its own too. 1e-6.
#[test]
fn what_loads_do_reactions_show() {
    let loads = [0.02, -0.03, 0.05, 0.03, -0.06, 0.05];
    let lines: String = loads.iter().zip(1..).map(|(f, dof)| format!("5, {dof}, {f}\n")).collect();
    let load = format!("*STEP, NLGEOM\n*STATIC\n.25, 1.\n*CLOAD\n{lines}*END STEP\n");
    let [_, moved, _] = run(&cantilever("", &load)).last().unwrap().0[&5];
    assert!(moved[3..].iter().all(|turn| turn.abs() > 0.1), "{moved:?}");
    let transform = "*TRANSFORM, NSET=TIP\n0., 1., 0., 0., 0., 1.\n";
    let [a, b, c, d, e, f] = moved;
    for (card, moved) in [("", moved), (transform, [b, c, a, e, f, d])] {
        let end = run(&cantilever(card, &driven(moved, ".25, 1.")));
        let [_, _, reaction] = end.last().unwrap().0[&5];
        for (found, load) in reaction.iter().zip(loads) {
            assert!((found - load).abs() < 1e-6, "{card}: {reaction:?}");
        }
        assert!(end.iter().all(|(nodes, _)| imbalance(nodes) < 1e-8));
    }
}

/// Requirement: where a support of some rotations or of all is let go, the step begins where the one
/// before ended: a millionth of it moves the end by less than 1e-4. Lengths and turns are about 1.
#[test]
fn a_support_that_is_let_go_goes_on() {
    let pressed = driven([-0.1, 0.2, 0.1, 0.5, -0.6, 0.7], ".25, 1.");
    for kept in ["", "5, 1, 3\n5, 5, 5\n"] {
        let go = format!(
            "*STEP, NLGEOM, INC=1\n*STATIC\n1.E-6, 1.\n*BOUNDARY, OP=NEW\n1, 1, 6\n*BOUNDARY, \
             OP=NEW, FIXED\n{kept}*END STEP\n"
        );
        let (all, _) = watch(&cantilever("", &format!("{pressed}{go}")));
        let [end, begun] = [&all[3], &all[4]].map(|(nodes, _)| nodes[&5][1]);
        for (end, begun) in end.iter().zip(begun) {
            assert!((end - begun).abs() < 1e-4, "{kept}: {end} {begun}");
        }
    }
}

/// Requirement: an end that is turned by more than half a turn about changing axes is in balance,
/// its reactions do not leap, and the energy balances to a hundredth.
#[test]
fn beyond_half_a_turn() {
    let turned = [[-0.1, 0.0, 0.0, 2.4, 0.6, 0.3], [-0.3, 0.1, 0.0, 3.6, -0.9, 1.2]]
        .map(|moved| driven(moved, ".02, 1., 1.E-6, .02"));
    let all = run(&cantilever("", &turned.concat()));
    assert!(all.iter().all(|(nodes, _)| imbalance(nodes) < 1e-7));
    let reactions: Vec<[f64; 6]> = all.iter().map(|(nodes, _)| nodes[&5][2]).collect();
    let most = reactions.iter().flatten().fold(0.0_f64, |most, f| most.max(f.abs()));
    for pair in reactions.windows(2) {
        let leap =
            pair[0].iter().zip(pair[1]).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        assert!(leap < 0.1 * most, "{leap} of {most}");
    }
    let energy = all.last().unwrap().1;
    assert!(energy.balance.abs() < 0.01 * energy.external_work, "{energy:?}");
}
