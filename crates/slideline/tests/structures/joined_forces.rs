//! Forces at nodes that equations and rigid bodies join, and bodies that turn without NLGEOM,
//! beside numbers that ccx 2.20 prints for the same decks.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::{Dialect, Dof};
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::collections::HashMap;
use std::ops::ControlFlow;

const MOVES: [Dof; 3] = [Dof::U1, Dof::U2, Dof::U3];

/// Displacements and what is carried, of all nodes at the end, by label.
#[derive(Default)]
pub struct End(pub HashMap<u64, [[f64; 3]; 2]>);

impl Observer for End {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let of_node = |node| {
                let moved = MOVES.map(|dof| frame.nodal.displacement(node, dof));
                let carried = MOVES.map(|dof| frame.nodal.carried(node, dof));
                (frame.model.nodes.label(node), [moved, carried])
            };
            self.0 = (0..frame.model.nodes.len()).map(of_node).collect();
        }
        ControlFlow::Continue(())
    }
}

/// A cube of side 1, E = 1000, nu = 0.3, held at its bottom.
fn run(joined: &str, history: &str, dialect: Dialect) -> End {
    let deck = format!(
        "*NODE, NSET=ALL\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n\
         7, 1, 1, 1\n8, 0, 1, 1\n9, .5, .5, 1.\n10, .5, .5, 1.\n*ELEMENT, TYPE=C3D8, ELSET=E\n\
         1, 1, 2, 3, 4, 5, 6, 7, 8\n*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n\
         *SOLID SECTION, ELSET=E, MATERIAL=M\n*NSET, NSET=TOP\n5, 6, 7, 8\n\
         *BOUNDARY\n1, 1, 3\n2, 1, 3\n3, 1, 3\n4, 1, 3\n{joined}*STEP\n*STATIC\n{history}*END STEP\n"
    );
    solved_in(&deck, dialect)
}

/// The end of a deck of the dialect of Abaqus.
pub fn solved(deck: &str) -> End {
    solved_in(deck, Dialect::Abaqus)
}

fn solved_in(deck: &str, dialect: Dialect) -> End {
    let options = ReadOptions { dialect: Some(dialect), ..ReadOptions::default() };
    let job = Job::read_text("deck", deck, &options);
    let model = job.model.unwrap_or_else(|| panic!("{:?}", job.diagnostics));
    let mut end = End::default();
    let outcome = solve(&model, &SolveOptions::default(), &mut end);
    assert!(matches!(outcome, Ending::Completed(_)), "{outcome:?}");
    end
}

fn assert_near(own: [f64; 3], theirs: [f64; 3], within: f64) {
    let far = own.iter().zip(theirs).any(|(own, theirs)| (own - theirs).abs() > within);
    assert!(!far, "{own:?} in place of {theirs:?}");
}

#[test]
fn nodes_of_equations_show_what_their_elements_carry() {
    let joined = "*EQUATION\n2\n5, 3, 1., 6, 3, -1.\n2\n8, 3, 1, 7, 3, -.5\n";
    let history = "*BOUNDARY\n6, 3, 3, .1\n*CLOAD\n7, 3, 10.\n8, 1, 2.\n5, 3, 4.\n";
    let end = run(joined, history, Dialect::Calculix);
    let printed = [
        (1, [-5.830090, -4.378028, -20.74687]),
        (5, [0.0, 0.0, 19.82420]),
        (6, [0.0, 0.0, 20.70295]),
        (7, [0.0, 0.0, 6.987911]),
        (8, [2.0, 0.0, 6.024177]),
    ];
    printed.into_iter().for_each(|(node, ccx)| assert_near(end.0[&node][1], ccx, 1e-5));
    // in the dialect of Abaqus what supports and loads do stays
    let end = run(joined, history, Dialect::Abaqus);
    assert_near(end.0[&5][1], [0.0, 0.0, 4.0], 1e-9);
    assert_near(end.0[&7][1], [0.0, 0.0, 10.0], 1e-9);
}

#[test]
fn axes_of_nodes_change_nothing() {
    let joined = "*EQUATION\n2\n5, 3, 1., 6, 3, -1.\n";
    let turned = "*TRANSFORM, NSET=TOP, TYPE=R\n0., 1., 0., -1., 0., 0.\n";
    let history = "*CLOAD\n7, 3, 10.\n5, 3, 4.\n";
    let plain = run(joined, history, Dialect::Calculix);
    let turned = run(&format!("{turned}{joined}"), history, Dialect::Calculix);
    for (node, [moved, carried]) in plain.0 {
        assert_near(turned.0[&node][0], moved, 1e-12);
        assert_near(turned.0[&node][1], carried, 1e-9);
    }
}

#[test]
fn nodes_of_a_body_show_what_their_elements_carry_and_the_body_its_load() {
    let joined = "*RIGID BODY, NSET=TOP, REF NODE=9, ROT NODE=10\n";
    let end = run(joined, "*BOUNDARY\n9, 1, 2\n9, 3, 3, .1\n10, 1, 3\n", Dialect::Calculix);
    assert_near(end.0[&5][1], [-14.42308, -14.42308, 33.65385], 1e-5);
    assert_near(end.0[&7][1], [14.42308, 14.42308, 33.65385], 1e-5);
    assert_near(end.0[&9][1], [0.0, 0.0, 134.6154], 1e-4);
}

#[test]
fn bodies_turn_linearly_without_nlgeom() {
    let joined = "*RIGID BODY, NSET=TOP, REF NODE=9, ROT NODE=10\n";
    let loads = "*CLOAD\n9, 1, 10.\n9, 3, 5.\n10, 2, 10.\n";
    let end = run(joined, loads, Dialect::Calculix);
    let printed = [
        (5, [0.07800000, 0.0, 0.05571429]),
        (6, [0.07800000, 0.0, -0.04828571]),
        (9, [0.07800000, 0.0, 0.003714286]),
        (10, [0.0, 0.1040000, 0.0]),
    ];
    printed.into_iter().for_each(|(node, ccx)| assert_near(end.0[&node][0], ccx, 1e-8));
}

#[test]
fn bodies_in_the_plane_turn_linearly_without_nlgeom() {
    let end = |nlgeom: &str| {
        let deck = format!(
            "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 1., 1.\n4, 0., 1.\n9, 3., 5.\n*NSET, NSET=ALL\n1, 2, 3, 4\n\
             *ELEMENT, TYPE=CPS4, ELSET=E\n1, 1, 2, 3, 4\n*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n\
             *SOLID SECTION, ELSET=E, MATERIAL=M\n1.\n*RIGID BODY, TIE NSET=ALL, REF NODE=9\n\
             *STEP{nlgeom}\n*STATIC\n1., 1.\n*BOUNDARY\n9, 1, 2, 0.25\n9, 6, 6, 0.5\n*END STEP\n"
        );
        let job = Job::read_text("plane", &deck, &ReadOptions::default());
        let model = job.model.unwrap_or_else(|| panic!("{:?}", job.diagnostics));
        let mut end = End::default();
        solve(&model, &SolveOptions::default(), &mut end);
        end.0[&1][0]
    };
    // arm (-3, -5)
    assert_near(end(""), [0.25 + 0.5 * 5.0, 0.25 - 0.5 * 3.0, 0.0], 1e-12);
    let (s, c) = 0.5_f64.sin_cos();
    let exact = [0.25 - 3.0 * (c - 1.0) + 5.0 * s, 0.25 - 5.0 * (c - 1.0) - 3.0 * s, 0.0];
    assert_near(end(", NLGEOM"), exact, 1e-12);
}

/// Of nodes without elements that equations join ccx 2.20 shows no load; what supports do stays shown.
#[test]
fn references_of_couplings_show_no_load_of_their_own() {
    let surface = "*SURFACE, NAME=S\n1, S2\n*ORIENTATION, NAME=O\n.6, .8, 0., -.8, .6, 0.\n";
    let coupling = "*COUPLING, CONSTRAINT NAME=C, REF NODE=9, SURFACE=S, ORIENTATION=O\n";
    let turned = "*NSET, NSET=R\n9\n*TRANSFORM, NSET=R, TYPE=R\n.6, .8, 0., -.8, .6, 0.\n";
    // along the axes of the node (.6, .8) and (-.8, .6)
    let loads = "*CLOAD\n9, 1, 5.\n9, 2, -10.\n9, 3, 1.\n";
    let (kinematic, distributing) = ("*KINEMATIC\n1, 1\n3, 3\n", "*DISTRIBUTING\n1, 3\n");
    for (kind, held) in [(distributing, ""), (distributing, "9, 2, 3\n"), (kinematic, "9, 2, 2\n")]
    {
        let joined = format!("{surface}{coupling}{kind}{turned}");
        let end = run(&joined, &format!("*BOUNDARY\n{held}{loads}"), Dialect::Calculix);
        let supports = (1..=4).map(|node| end.0[&node][1]);
        let sum = supports.fold([11.0, -2.0, 1.0], |sum, own| [0, 1, 2].map(|k| sum[k] + own[k]));
        assert_near(end.0[&9][1], sum.map(|own| -own), 1e-9);
        if held.is_empty() {
            assert_near(sum, [0.0; 3], 1e-9);
        }
    }
}

/// The node of a body shows what the body carries, with the loads of all that follows it.
#[test]
fn a_body_shows_the_loads_of_what_follows_it() {
    let joined = "*RIGID BODY, NSET=TOP, REF NODE=9, ROT NODE=10\n";
    let history = "*BOUNDARY\n9, 1, 1, .01\n*CLOAD\n9, 1, 5.\n9, 2, 2.\n6, 1, 1.\n";
    let turned = "*NSET, NSET=R\n9\n*TRANSFORM, NSET=R, TYPE=R\n0., 1., 0., -1., 0., 0.\n";
    // the same along axes that are turned by a quarter
    let of_turned = "*BOUNDARY\n9, 2, 2, -.01\n*CLOAD\n9, 2, -5.\n9, 1, 2.\n6, 1, 1.\n";
    for (axes, history) in [("", history), (turned, of_turned)] {
        let end = run(&format!("{joined}{axes}"), history, Dialect::Calculix);
        let supports: f64 = (1..=4).map(|node| end.0[&node][1][0]).sum();
        assert_near(end.0[&9][1], [-supports, 2.0, 0.0], 1e-9);
    }
}
