//! Bars in solids: closed forms of mixtures, and what lies outside.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::ops::ControlFlow;

/// Sum of the forces along x on the nodes at x = 3, and their moments about y and z.
#[derive(Default)]
struct Pull([f64; 3]);

impl Observer for Pull {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            self.0 = [0.0; 3];
            for (index, node) in frame.model.nodes.iter().enumerate() {
                let [x, y, z] = node.position;
                if x > 2.999 {
                    let force = frame.nodal.reaction(index, Dof::U1);
                    self.0 = [self.0[0] + force, self.0[1] + z * force, self.0[2] - y * force];
                }
            }
        }
        ControlFlow::Continue(())
    }
}

/// Two bricks 3 long, 1 wide and high, of E = 10, strained by 1 %; bars of E A = 2 in them.
fn deck(kind: &str, bars: &str, card: &str, step: &str) -> String {
    let plane = |x: f64, first: usize| -> String {
        let [a, b, c, d] = [first, first + 1, first + 2, first + 3];
        format!("{a}, {x:?}\n{b}, {x:?}, 1.\n{c}, {x:?}, 1., 1.\n{d}, {x:?}, 0., 1.\n")
    };
    format!(
        "*NODE\n{}{}{}{bars}*ELEMENT, TYPE={kind}, ELSET=SOLID\n1, 1, 2, 3, 4, 5, 6, 7, 8\n\
         2, 5, 6, 7, 8, 9, 10, 11, 12\n*ELEMENT, TYPE=T3D2, ELSET=BARS\n11, 21, 22\n12, 22, 23\n\
         13, 23, 24\n*SOLID SECTION, ELSET=SOLID, MATERIAL=SOFT\n*SOLID SECTION, ELSET=BARS, \
         MATERIAL=STIFF\n0.02\n*MATERIAL, NAME=SOFT\n*ELASTIC\n10., 0.\n*MATERIAL, NAME=STIFF\n\
         *ELASTIC\n100., 0.\n{card}*STEP{step}\n*STATIC\n1., 1.\n*BOUNDARY\n1, 1, 3\n2, 1\n3, 1\n\
         4, 1, 2\n9, 1, 1, 0.03\n10, 1, 1, 0.03\n11, 1, 1, 0.03\n12, 1, 1, 0.03\n*END STEP\n",
        plane(0.0, 1),
        plane(1.3, 5),
        plane(3.0, 9),
    )
}

const INSIDE: &str = "21, 0., .3, .6\n22, .8, .3, .6\n23, 1.9, .3, .6\n24, 3., .3, .6\n";
const CARD: &str = "*EMBEDDED ELEMENT, HOST ELSET=SOLID\nBARS\n";

fn pull(deck: &str) -> [f64; 3] {
    let read = Job::read_text("embedded", deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    let mut end = Pull::default();
    let ending = solve(&model, &SolveOptions::default(), &mut end);
    assert!(matches!(ending, Ending::Completed(_)), "{deck}\n{ending:?}");
    end.0
}

fn codes(deck: &str) -> Vec<&'static str> {
    let read = Job::read_text("embedded", deck, &ReadOptions::default());
    let errors =
        read.diagnostics.iter().filter(|own| own.severity == slideline::diag::Severity::Error);
    errors.map(|own| own.code.0).collect()
}

/// Requirement: an even strain is one of both: the force is (E A + E_b A_b) strain, and acts at the
/// place that they have in common, docs/theory.md section 4.2; bars cross from host to host
/// between their nodes. Also with hosts not named. 1e-9.
#[test]
fn bars_in_bricks_pull_with_them() {
    let expected = [0.12, 0.05 + 0.6 * 0.02, -0.05 - 0.3 * 0.02];
    for card in [CARD, "*EMBEDDED ELEMENT\n11, 12, 13\n"] {
        for kind in ["C3D8", "C3D8R"] {
            let found = pull(&deck(kind, INSIDE, card, ""));
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-9, "{kind} {found} {expected}");
            }
        }
    }
    let large = pull(&deck("C3D8", INSIDE, CARD, ", NLGEOM"))[0];
    assert!((large - 0.12).abs() < 2e-3 && large != 0.12, "{large}");
}

/// Requirement: a node a little outside follows the nearest place, one farther out is refused, and so
/// are hosts that are no solids. Source: Abaqus manual, EXTERIOR TOLERANCE.
#[test]
fn nodes_outside_of_their_hosts() {
    let outside = INSIDE.replace("24, 3.", "24, 3.03").replace(".3, .6", "-0.02, .6");
    assert!(codes(&deck("C3D8", &outside, CARD, "")).is_empty());
    let narrow = "*EMBEDDED ELEMENT, HOST ELSET=SOLID, EXTERIOR TOLERANCE=0.001\nBARS\n";
    assert_eq!(codes(&deck("C3D8", &outside, narrow, "")), ["SL0317"]);
    let wide = "*EMBEDDED ELEMENT, HOST ELSET=SOLID, ABSOLUTE EXTERIOR TOLERANCE=0.4\nBARS\n";
    let far = INSIDE.replace("24, 3.", "24, 3.3");
    assert_eq!(codes(&deck("C3D8", &far, CARD, "")), ["SL0317"]);
    assert!(codes(&deck("C3D8", &far, wide, "")).is_empty());
    let none = "*EMBEDDED ELEMENT, HOST ELSET=BARS\nBARS\n";
    assert_eq!(codes(&deck("C3D8", INSIDE, none, "")), ["SL0317"]);
}
