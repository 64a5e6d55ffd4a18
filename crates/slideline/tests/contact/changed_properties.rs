//! Materials and pressure laws that change from step to step: `*CHANGE SOLID SECTION`, `*CHANGE
//! MATERIAL` with `*CHANGE PLASTIC`, `*CHANGE SURFACE BEHAVIOR`.
//!
//! Source: their pages; bars under one stress, by hand.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::two_blocks::{ALL, mesh, solved};
use slideline::model::{Dof, Model};
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, Severity, SolveOptions, Stop, resume, solve};
use std::ops::ControlFlow;

/// Of every increment: displacements of nodes 3 and 5 along the bar, the force of its foot, what is
/// left of the energies.
#[derive(Default)]
struct Bar(Vec<[f64; 4]>, Vec<slideline::Checkpoint<'static>>);

impl Observer for Bar {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Committed(frame) => {
                let nodes = &frame.model.nodes;
                let at = |label| frame.nodal.displacement(nodes.find(label).unwrap(), Dof::U2);
                let foot = |label| frame.nodal.reaction(nodes.find(label).unwrap(), Dof::U2);
                let left = frame.energy.balance;
                self.0.push([at(3), at(5), -foot(1) - foot(2), left]);
            }
            Event::Checkpoint(checkpoint) => self.1.push(checkpoint.owned()),
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

/// Two unit squares on one another, held at the foot along the bar alone.
fn bar(rest: &str) -> String {
    format!(
        "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 1., 1.\n4, 0., 1.\n5, 1., 2.\n6, 0., 2.\n*NSET, \
         NSET=TOP\n5, 6\n*ELEMENT, TYPE=CPS4, ELSET=BAR\n1, 1, 2, 3, 4\n2, 4, 3, 5, 6\n*ELSET, \
         ELSET=UPPER\n2\n*BOUNDARY\n1, 1, 2\n2, 2\n{rest}"
    )
}

fn read(deck: &str) -> Model {
    let read = Job::read_text("bar", deck, &ReadOptions::default());
    read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics))
}

fn walked(model: &Model) -> Bar {
    let mut rows = Bar::default();
    match solve(model, &SolveOptions::default(), &mut rows) {
        Ending::Completed(_) => rows,
        other => panic!("{other:?}"),
    }
}

/// The codes of the errors of a deck.
fn refused(deck: &str) -> Vec<&'static str> {
    let read = Job::read_text("refused", deck, &ReadOptions::default());
    let errors = read.diagnostics.iter().filter(|said| said.severity == Severity::Error);
    errors.map(|said| said.code.0).collect()
}

const ELASTIC: &str = "*SOLID SECTION, ELSET=BAR, MATERIAL=STIFF\n1.\n*MATERIAL, NAME=STIFF\n\
                       *ELASTIC\n1000., 0.\n*MATERIAL, NAME=SOFT\n*ELASTIC\n250., 0.\n*RESTART, \
                       WRITE\n*STEP\n*STATIC\n*CLOAD\nTOP, 2, 1.\n*END STEP\n";

/// Requirement: under a force F the lower half stays as it is and the upper one gives way as the other
/// material does, straight over the step; a third step with the first material brings it back. The
/// energies balance. Tolerance: rounding.
#[test]
fn a_part_of_a_section_becomes_of_another_material() {
    let change = |material: &str| {
        format!(
            "*STEP\n*STATIC, DIRECT\n0.5, 1.\n*CHANGE SOLID SECTION, ELSET=UPPER, \
             MATERIAL={material}\n*END STEP\n"
        )
    };
    let model = read(&bar(&(ELASTIC.to_owned() + &change("SOFT") + &change("STIFF"))));
    let walk = walked(&model);
    let (stiff, soft) = (2.0 / 1000.0, 2.0 / 250.0);
    let half = 0.5 * (stiff + soft);
    for (row, upper) in walk.0.iter().zip([stiff, half, soft, half, stiff]) {
        let [middle, top, foot, left] = *row;
        assert!((middle - stiff).abs() < 1e-14, "{row:?}");
        // what ramps is the force, not the stiffness: half of it at half of the step
        assert!((top - middle - upper).abs() < 1e-14, "{upper}: {row:?}");
        assert!((foot - 2.0).abs() < 1e-12, "{row:?}");
        assert!(left.abs() < 1e-15, "{row:?}");
    }
    assert_eq!(walk.0.len(), 5);
    // the same from the end of the first step
    let mut again = Bar::default();
    let from = walk.1[0].clone();
    let ending = resume(&model, &SolveOptions::default(), from, &mut again);
    assert!(matches!(ending, Some(Ending::Completed(_))), "{ending:?}");
    assert_eq!(again.0, walk.0[1..], "a resumed run has other sections");
}

/// A bar of steel stretched by 1 %, then what a step does to it.
fn steel(change: &str) -> String {
    bar(&format!("{STRETCHED}{change}*END STEP\n"))
}

/// The same of two trusses.
fn wire(change: &str) -> String {
    format!(
        "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 1., 1.\n5, 1., 2.\n*NSET, NSET=TOP\n5\n*ELEMENT, \
         TYPE=T2D2, ELSET=BAR\n1, 2, 3\n2, 3, 5\n*BOUNDARY\n1, 1, 2\n2, 1, 2\n3, 1\n5, 1\n\
         {STRETCHED}{change}*END STEP\n"
    )
}

const STRETCHED: &str = "*SOLID SECTION, ELSET=BAR, MATERIAL=STEEL\n1.\n*MATERIAL, NAME=STEEL\n\
                         *ELASTIC\n2.E5, 0.\n*PLASTIC\n200., 0.\n400., 0.1\n*MATERIAL, \
                         NAME=OTHER\n*ELASTIC\n2.E5, 0.\n*PLASTIC\n50., 0.\n150., 1.\n\
                         *MATERIAL, NAME=PLAIN\n*ELASTIC\n2.E5, 0.\n*STEP\n*STATIC\n0.25, 1.\n\
                         *BOUNDARY\nTOP, 2, 2, 0.02\n*END STEP\n*STEP\n*STATIC\n0.25, 1.\n";

/// Requirement: a bar held at a strain e carries E (e - p) = S(p), S the yield stress of the table that
/// holds; the plastic strain p never falls. Tolerance: that of equilibrium; in the plane, where the
/// difference of the forces ramps off across the bar too and its stress is not quite along it meanwhile,
/// 1e-4.
#[test]
fn yield_stresses_of_another_table_hold_with_the_plastic_strain_that_was() {
    // yield stress at no plastic strain, its slope, and a plastic strain that is there
    let held = |start: f64, slope: f64, before: f64| -> [f64; 2] {
        let p = ((2e5 * 0.01 - start) / (2e5 + slope)).max(before);
        [2e5 * (0.01 - p), p]
    };
    let [first, p] = held(200.0, 2000.0, 0.0);
    let lines = |lines: &str| format!("*CHANGE MATERIAL, NAME=STEEL\n*CHANGE PLASTIC\n{lines}\n");
    let cases = [
        (lines("100., 0.\n200., 0.1"), held(100.0, 1000.0, p)[0]),
        // elastic from where it is
        (lines("300., 0.\n300., 1."), first),
        ("*CHANGE SOLID SECTION, ELSET=BAR, MATERIAL=OTHER\n".to_owned(), held(50.0, 100.0, p)[0]),
    ];
    for (change, wanted) in cases {
        for (deck, tolerance) in [(wire(&change), 1e-9), (steel(&change), 1e-4)] {
            let walk = walked(&read(&deck));
            assert!((walk.0[3][2] / first - 1.0).abs() < 1e-9, "{:?}", walk.0);
            let force = walk.0.last().unwrap()[2];
            assert!((force / wanted - 1.0).abs() < tolerance, "{change} {force} {wanted}");
        }
    }
}

/// Requirement: what cannot change is named with its line, in one code each.
#[test]
fn what_cannot_change_is_named() {
    let plain = "*CHANGE SOLID SECTION, ELSET=BAR, MATERIAL=PLAIN\n";
    assert_eq!(refused(&steel(plain)), ["SL0309"], "what yields forgets");
    assert_eq!(refused(&steel("*CHANGE MATERIAL, NAME=STEEL\n")), ["SL0208"]);
    let lines = "\n*CHANGE PLASTIC\n1., 0.\n";
    assert_eq!(refused(&steel(&format!("*CHANGE MATERIAL, NAME=PLAIN{lines}"))), ["SL0309"]);
    assert_eq!(refused(&steel(&format!("*CHANGE MATERIAL, NAME=STEAL{lines}"))), ["SL0308"]);
    assert_eq!(refused(&steel("*CHANGE PLASTIC\n1., 0.\n")), ["SL0236"]);
    let nobody = "*CHANGE SOLID SECTION, ELSET=NOBODY, MATERIAL=PLAIN\n";
    assert_eq!(refused(&steel(nobody)), ["SL0308"]);
    let law = "*CHANGE SURFACE BEHAVIOR, INTERACTION=I\n";
    assert_eq!(refused(&steel(law)), ["SL0208"]);
    let behavior = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1.\n";
    assert_eq!(refused(&steel(&format!("{law}{behavior}"))), ["SL0328"]);
}

/// Requirement: blocks of stiffness E/2 in line, pressed by d, with a law of stiffness k between them
/// carry d/(2/E + 1/k), with that of the step. At nodes and over faces, in the plane and in space.
/// Surfaces that are tied until a step says otherwise carry pull until then, and nothing from then
/// on. Tolerance: that of equilibrium.
#[test]
fn a_pressure_law_holds_from_its_step_on() {
    const E: f64 = 1000.0;
    let through = |stiffness: f64, d: f64| d / (2.0 / E + 1.0 / stiffness);
    for (in_space, kind) in ALL {
        let up = if in_space { 3 } else { 2 };
        let deck = |law: &str, d: f64| {
            format!(
                "{}*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE={law}\n\
                 2000.\n*CONTACT PAIR, INTERACTION=I, TYPE={kind}\nUPPER, LOWER\n*STEP\n*STATIC\n\
                 *BOUNDARY\nLOW, 1, {up}\nHIGH, 1, {up}\nHIGH, {up}, {up}, {d:?}\n*END STEP\n*STEP\n\
                 *STATIC\n*CHANGE SURFACE BEHAVIOR, INTERACTION=I\n*SURFACE BEHAVIOR, \
                 PRESSURE-OVERCLOSURE=LINEAR\n500.\n*END STEP\n*STEP\n*STATIC\n*END STEP\n",
                mesh(in_space, 0.0)
            )
        };
        let forces = |law: &str, d: f64| -> Vec<f64> {
            solved(&deck(law, d)).force.iter().map(|force| force[up - 1]).collect()
        };
        let cases = [
            ("LINEAR", -0.01, [through(2000.0, 0.01), through(500.0, 0.01)]),
            ("TIED", 0.01, [-through(2000.0, 0.01), 0.0]),
        ];
        for (law, d, [first, then]) in cases {
            let forces = forces(law, d);
            for (force, wanted) in forces.iter().zip([first, then, then]) {
                assert!((force - wanted).abs() < 1e-9, "{kind} {in_space} {law}: {forces:?}");
            }
            assert_eq!(forces.len(), 3);
        }
    }
}
