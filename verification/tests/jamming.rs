//! A weight pushed up a parabola, until it jams.
//!
//! ```text
//!        G
//!        v   /
//!   u ->[-] /   y = x2: tan a = 2 x
//!      ___./    mu tan a >= 1: no horizontal force moves it on
//! ```

use slideline::model::Dof;
use slideline::observe::{Ending, Event, Observer, Stop};
use slideline::output::plot::{Axis, Mark, Series};
use slideline::{Job, ReadOptions, SolveOptions};
use slideline_theory::closed::incline;
use slideline_verification::{Claim, Group, Record, worst};
use std::ops::ControlFlow;

const STATICS: &str = "F/G = (tan a + mu)/(1 - mu tan a), NAFEMS CGS-4 on a curve (derived).";
const POLE: &str = "1e-9 of the force, times what the pole makes of it, 1/(1 - mu tan a).";

pub const GROUP: Group = Group {
    file: "jamming",
    claims: &[
        Claim {
            name: "below_the_limit_it_goes_on",
            requirement: "With mu = 0.5 the weight is pushed to x = 0.9, before tan a = 1/mu: the \
                          force is the closed form's all the way.",
            source: STATICS,
            tolerance: POLE,
            measure: below_the_limit_it_goes_on,
        },
        Claim {
            name: "at_the_limit_it_is_told",
            requirement: "With more friction the force is the closed form's as far as there is \
                          one; then the run ends with SL0506, which names the node and a remedy, \
                          and keeps what converged to within an increment of the pole.",
            source: STATICS,
            tolerance: POLE,
            measure: at_the_limit_it_is_told,
        },
    ],
};

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

/// Rows, the largest error of the force against what is asked, the ending.
fn push(mu: f64, friction: &str) -> (Vec<[f64; 2]>, f64, Ending) {
    let read = Job::read_text("jam", &deck(mu, friction), &ReadOptions::default());
    let mut watch = Push::default();
    let model = read.model.unwrap();
    assert_eq!(model.nodes.find(1), Some(0));
    let ending = slideline::solve(&model, &SolveOptions::default(), &mut watch);
    let off = watch.0.iter().map(|&[x, force]| {
        let exact = incline::raising(2.0 * x, mu).unwrap() * (WEIGHT + x * x);
        (force / exact - 1.0).abs() * (1.0 - 2.0 * x * mu)
    });
    let off = worst(off);
    (watch.0, off, ending)
}

const STICKS: [&str; 2] = [", LAGRANGE", ", ELASTIC SLIP=1.0E-4"];

fn below_the_limit_it_goes_on(record: &mut Record) {
    for friction in STICKS {
        let (_, off, ending) = push(0.5, friction);
        record
            .holds(format!("mu 0.5{friction}: completed"), matches!(ending, Ending::Completed(_)));
        let what = format!("mu 0.5{friction}: error times (1 - mu tan a), largest");
        record.at_most(what, off, 1e-9);
    }
}

fn at_the_limit_it_is_told(record: &mut Record) {
    let mut curves = Vec::new();
    for mu in [0.6, 1.0, 1.2, 3.0] {
        for friction in STICKS {
            let (rows, off, ending) = push(mu, friction);
            let what = |what: &str| format!("mu {mu}{friction}: {what}");
            record.at_most(what("error times (1 - mu tan a), largest"), off, 1e-9);
            let Ending::NotConverged(totals, said) = ending else {
                record.holds(what("it is told"), false);
                continue;
            };
            let told = said.code.0 == "SL0506" && said.message.contains("node 1 ");
            record.holds(what("SL0506 names the node"), told);
            let placed = said.help.is_some() && said.span.is_some();
            record.holds(what("and a remedy, and the line of the deck"), placed);
            // results are kept to within an increment of the pole
            let reached = rows.last().unwrap()[0];
            record.within(what("reached x"), reached, [0.5 / mu - 0.05, 0.5 / mu]);
            record.equal(what("increments told"), totals.increments, rows.len() + 1);
            if friction == STICKS[0] {
                let name = format!("mu {mu}, jams at {:.3}", 0.5 / mu);
                curves.push(Series { name, points: rows, mark: Mark::Curve, colour: 0 });
            }
        }
    }
    let (x, y) = (Axis::linear("x"), Axis::logarithmic("force"));
    record.chart("Force until it jams", x, y, curves);
}
