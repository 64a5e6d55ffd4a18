//! Elements that leave the model and are joined to the rest by constraints, `*MODEL CHANGE`.
//!
//! Source: docs/theory.md section 9.1, eq. (9.6): what they exert ramps off over the step, whatever
//! joins them. References: the same parts with nodes in common; springs in closed form.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::ops::ControlFlow;

/// What every increment left.
#[derive(Default)]
struct Rows {
    /// Of each node by its number: translations and their reactions.
    rows: Vec<Vec<(u64, [f64; 6])>>,
    balance: f64,
    said: Vec<&'static str>,
}

impl Observer for Rows {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Committed(frame) => {
                let of = |node| {
                    let [x, y, z] = [Dof::U1, Dof::U2, Dof::U3];
                    let u = [x, y, z].map(|dof| frame.nodal.displacement(node, dof));
                    let r = [x, y, z].map(|dof| frame.nodal.reaction(node, dof));
                    let label = frame.model.nodes.label(node);
                    (label, [u[0], u[1], u[2], r[0], r[1], r[2]])
                };
                self.rows.push((0..frame.model.nodes.len()).map(of).collect());
                self.balance = frame.energy.balance;
            }
            Event::Diagnosed(said) => self.said.push(said.code.0),
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

impl Rows {
    fn of(&self, increment: usize, label: u64) -> [f64; 6] {
        self.rows[increment].iter().find(|own| own.0 == label).unwrap().1
    }
}

fn ended(deck: &str) -> (Ending, Rows) {
    let read = Job::read_text("joined", deck, &ReadOptions::default());
    let mut model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    model.steps.iter_mut().for_each(|step| step.controls.field.r_n = 1e-11);
    let mut rows = Rows::default();
    (solve(&model, &SolveOptions::default(), &mut rows), rows)
}

fn run(deck: &str) -> Rows {
    let (ending, rows) = ended(deck);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}\n{deck}");
    rows
}

const LEAVE: &str = "*STEP\n*STATIC, DIRECT\n0.25, 1.\n*MODEL CHANGE, REMOVE\nUP\n*END STEP\n";

/// Blocks on one another, the upper one joined by some cards and pressed.
fn blocks(joint: &str) -> String {
    let upper = if joint.is_empty() { "4, 3, 13, 14" } else { "11, 12, 13, 14" };
    format!(
        "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 1., 1.\n4, 0., 1.\n11, 0., 1.\n12, 1., 1.\n13, 1., 2.\n\
         14, 0., 2.\n*ELEMENT, TYPE=CPS4, ELSET=LOW\n1, 1, 2, 3, 4\n*ELEMENT, TYPE=CPS4, ELSET=UP\n\
         2, {upper}\n*SOLID SECTION, ELSET=LOW, MATERIAL=M\n1.\n*SOLID SECTION, ELSET=UP, \
         MATERIAL=M\n1.\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n*SURFACE, NAME=BELOW\nLOW, S3\n\
         *SURFACE, NAME=ABOVE\nUP, S1\n{joint}*BOUNDARY\n1, 1, 2\n2, 1, 2\n*STEP\n*STATIC, DIRECT\n\
         1., 1.\n*BOUNDARY\n13, 1\n14, 1\n13, 2, 2, -0.02\n14, 2, 2, -0.02\n*END STEP\n{LEAVE}"
    )
}

/// Requirement: blocks pressed by d hold N = E A d/2; where the upper one leaves, N ramps off at the
/// base, with nodes in common, tied, by equations and by MPC alike. Closed form, 1e-11.
#[test]
fn what_is_joined_ramps_off() {
    let equation =
        |dof: usize| format!("2\n11, {dof}, 1., 4, {dof}, -1.\n2\n12, {dof}, 1., 3, {dof}, -1.\n");
    let joints = [
        String::new(),
        "*TIE, NAME=T\nABOVE, BELOW\n".to_owned(),
        "*TIE, NAME=T, TYPE=NODE TO SURFACE\nABOVE, BELOW\n".to_owned(),
        format!("*EQUATION\n{}{}", equation(1), equation(2)),
        "*MPC\nTIE, 11, 4\nTIE, 12, 3\n".to_owned(),
    ];
    for joint in joints {
        let rows = run(&blocks(&joint));
        for increment in 0..5 {
            let wanted = 10.0 * (1.0 - 0.25 * increment as f64);
            let base = rows.of(increment, 1)[4] + rows.of(increment, 2)[4];
            assert!((base - wanted).abs() < 1e-11, "{joint}, {increment}: {base}");
        }
        assert!(rows.balance.abs() < 1e-13, "{joint}: {}", rows.balance);
        assert!(!rows.said.contains(&"SL0603"), "{joint}: {:?}", rows.said);
    }
}

/// A brick whose lower face moves a node on a spring of the same stiffness.
fn brick(joint: &str) -> String {
    format!(
        "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n5, 0., 0., 1.\n\
         6, 1., 0., 1.\n7, 1., 1., 1.\n8, 0., 1., 1.\n50, 0.5, 0.5, 0.\n*ELEMENT, TYPE=C3D8, ELSET=UP\n\
         1, 1, 2, 3, 4, 5, 6, 7, 8\n*ELEMENT, TYPE=SPRING1, ELSET=SP\n100, 50\n*SPRING, ELSET=SP\n3\n\
         1000.\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n*SOLID SECTION, ELSET=UP, MATERIAL=M\n\
         *NSET, NSET=FACE\n1, 2, 3, 4\n*NSET, NSET=TOP\n5, 6, 7, 8\n*SURFACE, NAME=F\nUP, S1\n{joint}\
         *BOUNDARY\n50, 1, 2\n50, 4, 6\n*STEP\n*STATIC, DIRECT\n1., 1.\n*BOUNDARY\nTOP, 1, 2\n\
         TOP, 3, 3, -0.1\n*END STEP\n{LEAVE}"
    )
}

/// Requirement: a spring that a brick of its stiffness pressed by d/2 comes back linearly in time,
/// whatever takes the face of the brick to its node. Closed form, 1e-12.
#[test]
fn what_a_body_has_held_ramps_off() {
    let joints = [
        "*COUPLING, REF NODE=50, SURFACE=F, CONSTRAINT NAME=C\n*KINEMATIC\n",
        "*RIGID BODY, TIE NSET=FACE, REF NODE=50\n",
        "*MPC\nBEAM, FACE, 50\n",
    ];
    for joint in joints {
        let rows = run(&brick(joint));
        for increment in 0..5 {
            let wanted = -0.05 * (1.0 - 0.25 * increment as f64);
            let u = rows.of(increment, 50)[2];
            assert!((u - wanted).abs() < 1e-12, "{joint}, {increment}: {u}");
        }
    }
}

/// Requirement: nodes of a cloud that have lost their elements are named, with the card; their mean
/// motion alone holds none of them.
#[test]
fn a_cloud_without_elements_is_named() {
    let joint = "*COUPLING, REF NODE=50, SURFACE=F, CONSTRAINT NAME=C\n*DISTRIBUTING\n";
    let (ending, _) = ended(&brick(joint));
    let Ending::NotConverged(_, why) = ending else { panic!("{ending:?}") };
    assert_eq!(why.code.0, "SL0503", "{why:?}");
    assert!(why.message.contains("all its elements are absent"), "{why:?}");
}

/// Requirement: a beam in space that has been bent far and turned lets go of force and moment alike
/// where it shares a node and where an MPC joins its own, as far as the ramp goes without a jump:
/// moments about fixed axes are no potential. 1e-8 of the motion.
#[test]
fn moments_of_what_is_joined_ramp_off() {
    let deck = |joint: &str| {
        let start = if joint.is_empty() { 3 } else { 13 };
        let leave = LEAVE.replace("*STEP", "*STEP, NLGEOM");
        format!(
            "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 2., 0., 0.\n13, 2., 0., 0.\n4, 3., 0., 0.\n\
             5, 4., 0., 0.\n*ELEMENT, TYPE=B31, ELSET=LOW\n1, 1, 2\n2, 2, 3\n*ELEMENT, TYPE=B31, \
             ELSET=UP\n3, {start}, 4\n4, 4, 5\n*BEAM SECTION, SECTION=RECT, ELSET=LOW, MATERIAL=M\n\
             0.1, 0.05\n0., 1., 0.\n*BEAM SECTION, SECTION=RECT, ELSET=UP, MATERIAL=M\n0.1, 0.05\n\
             0., 1., 0.\n*MATERIAL, NAME=M\n*ELASTIC\n1.E6, 0.3\n{joint}*BOUNDARY\n1, 1, 6\n\
             *STEP, NLGEOM\n*STATIC, DIRECT\n0.125, 1.\n*BOUNDARY\n5, 1, 1, -0.8\n5, 2, 2, 1.2\n\
             5, 3, 3, 0.9\n5, 4, 4, 0.5\n*END STEP\n{}",
            leave.replace("*END STEP", "*BOUNDARY, OP=NEW\n1, 1, 6\n*END STEP")
        )
    };
    let (_, whole) = ended(&deck(""));
    assert!(whole.rows.len() > 10, "three quarters of the ramp: {}", whole.rows.len());
    for joint in ["*MPC\nBEAM, 13, 3\n", "*MPC\nTIE, 13, 3\n"] {
        let (_, joined) = ended(&deck(joint));
        assert!(joined.rows.len() > 10, "{joint}: {}", joined.rows.len());
        for (increment, label) in (0..11).flat_map(|k| [(k, 2), (k, 3)]) {
            let [one, other] = [&joined, &whole].map(|rows| rows.of(increment, label));
            for axis in 0..3 {
                let off = (one[axis] - other[axis]).abs();
                assert!(off < 1e-8, "{joint}, {increment}, node {label}: {one:?} {other:?}");
            }
        }
    }
}

/// Requirement: a load on a node that constraints join to absent elements alone is told (SL0383); one
/// that is joined to what is there is not, for it acts.
#[test]
fn loads_on_what_is_joined_are_told_where_they_move_nothing() {
    let said = |deck: &str| {
        let read = Job::read_text("joined", deck, &ReadOptions::default());
        read.diagnostics.iter().any(|own| own.code.0 == "SL0383")
    };
    let loaded = |deck: String, load: &str| {
        deck.replace(LEAVE, &LEAVE.replace("*END", &format!("*CLOAD\n{load}\n*END")))
    };
    let tie = "*TIE, NAME=T\nABOVE, BELOW\n";
    assert!(!said(&loaded(blocks(tie), "11, 2, 1.")));
    assert!(said(&loaded(blocks(tie), "14, 1, 1.")));
    let coupling = "*COUPLING, REF NODE=50, SURFACE=F, CONSTRAINT NAME=C\n*KINEMATIC\n";
    assert!(!said(&loaded(brick(coupling), "50, 3, 1.")));
    let alone = brick(coupling)
        .replace("*ELEMENT, TYPE=SPRING1, ELSET=SP\n100, 50\n*SPRING, ELSET=SP\n3\n1000.\n", "");
    assert!(said(&loaded(alone, "50, 3, 1.")));
}
