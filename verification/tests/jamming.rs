//! A weight pushed up a parabola, until it jams.
//!
//! ```text
//!        G
//!        v   /
//!   u ->[-] /   y = x2: tan a = 2 x
//!      ___./    mu tan a >= 1: no horizontal force moves it on
//! ```
//!
//! Requirement: the force is F/G = (tan a + mu)/(1 - mu tan a) as far as there
//! is one; the run then ends with a diagnosis that names the node and a
//! remedy, and keeps what converged. Source: issue text, verification section
//! 6. Tolerance 1e-9 of the force, times what the pole makes of it,
//! 1/(1 - mu tan a).

use slideline::observe::{Ending, Event, Observer, Stop};
use slideline::{Job, ReadOptions, SolveOptions};
use slideline_theory::closed::incline;
use std::ops::ControlFlow;

use slideline::model::Dof;

const WEIGHT: f64 = 5.0;

/// Node 1 is moved by 1 in x from the foot of the parabola. A spring of 1 to
/// ground lifts or presses with its height; it is added to the weight.
fn deck(mu: f64, friction: &str) -> String {
    format!(
        "*HEADING\nweight on a parabola\n*NODE\n1, 0.0, 0.0\n2, 0.0, 9.0\n99, 0.0, -1.0\n\
         *ELEMENT, TYPE=SPRING1, ELSET=UP\n21, 1\n*SPRING, ELSET=UP\n2\n1.0\n\
         *RIGID SURFACE, ELSET=CONTACT, TYPE=SEGMENTS\nSTART, -1.0, 1.0\nPARAB, 0.0, 0.0, 1.0, 1.0\n\
         *ELEMENT, TYPE=IRS21, ELSET=CONTACT\n11, 1, 2, 99\n*INTERFACE, ELSET=CONTACT\n1.0\n\
         *FRICTION{friction}\n{mu:?}\n\
         *STEP, NLGEOM\n*STATIC\n1.0, 1.0\n*BOUNDARY\n1, 1\n1, 6\n2, 1, 6\n99, 1, 6\n\
         *CLOAD\n1, 2, {:?}\n*END STEP\n\
         *STEP, NLGEOM\n*STATIC\n0.05, 1.0, 1.0E-4, 0.05\n*BOUNDARY\n1, 1, 1, 0.9\n\
         *CONTROLS, PARAMETERS=FIELD\n1.0E-11\n*END STEP\n",
        -WEIGHT
    )
}

/// (place, force) of node 1 in step 2.
#[derive(Default)]
struct Push(Vec<[f64; 2]>);

impl Observer for Push {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event
            && frame.step == 2
        {
            let nodal = &frame.nodal;
            self.0.push([nodal.displacement(0, Dof::U1), nodal.reaction(0, Dof::U1)]);
        }
        ControlFlow::Continue(())
    }
}

fn push(mu: f64, friction: &str) -> (Vec<[f64; 2]>, Ending) {
    let read = Job::read_text("jam", &deck(mu, friction), &ReadOptions::default());
    let mut watch = Push::default();
    let model = read.model.unwrap();
    assert_eq!(model.nodes.find(1), Some(0));
    let ending = slideline::solve(&model, &SolveOptions::default(), &mut watch);
    for &[x, force] in &watch.0 {
        let exact = incline::raising(2.0 * x, mu).unwrap() * (WEIGHT + x * x);
        let pole = 1.0 / (1.0 - 2.0 * x * mu);
        let off = (force / exact - 1.0).abs();
        assert!(off < 1e-9 * pole, "mu {mu}{friction} at {x}: {force} {exact}, {off:e}");
    }
    (watch.0, ending)
}

#[test]
fn below_the_limit_it_goes_on() {
    for friction in [", LAGRANGE", ", ELASTIC SLIP=1.0E-4"] {
        let (rows, ending) = push(0.5, friction);
        assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
        println!("mu 0.5{friction}: {} increments, last {:?}", rows.len(), rows.last());
    }
}

#[test]
fn at_the_limit_it_is_told() {
    for mu in [0.6, 1.0, 1.2, 3.0] {
        for friction in [", LAGRANGE", ", ELASTIC SLIP=1.0E-4"] {
            let (rows, ending) = push(mu, friction);
            let Ending::NotConverged(totals, said) = ending else {
                panic!("mu {mu}{friction}: {ending:?}")
            };
            let [reached, force] = *rows.last().unwrap();
            println!(
                "mu {mu}{friction}: jams at {:.4}, kept to {reached:.4} with {force:.1}; {}: {}",
                0.5 / mu,
                said.code.0,
                said.message
            );
            assert_eq!(said.code.0, "SL0506", "mu {mu}{friction}");
            assert!(said.message.contains("node 1 "), "{}", said.message);
            assert!(said.help.is_some() && said.span.is_some());
            // results are kept to within an increment of the pole
            assert!(reached < 0.5 / mu && reached > 0.5 / mu - 0.05, "{reached}");
            assert_eq!(totals.increments, rows.len() + 1);
        }
    }
}
