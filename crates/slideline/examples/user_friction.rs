//! A friction law of one's own: rougher under light pressure, and smoother the
//! farther it has slid.
//!
//! ```text
//!        N
//!        v
//!     [block]--> u     tau_crit = mu0 p (p0/p)^(1/3) [r + (1 - r) exp(-s/s0)]
//!   ============
//! ```
//!
//! The power of the pressure is that of elastic round asperities; s is the
//! distance slid so far, the law's memory; r is what running in leaves.
//!
//! ```sh
//! cargo run --release -p slideline --example user_friction
//! ```

use slideline::friction::{FrictionBatch, FrictionPoint, Status, TangentialMap, Traction};
use slideline::friction::{UserFriction, UserFrictionError};
use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Model, Observer, ReadOptions, SolveOptions, Stop};
use std::ops::ControlFlow;
use std::sync::Arc;

/// The name of the law in a deck.
pub const NAME: &str = "RUNNING-IN";

/// Constants of the law: `*FRICTION, USER=RUNNING-IN, PROPERTIES=5, DEPVAR=1`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constants {
    /// Coefficient mu0 of the fresh surface at pressure p0 [1].
    pub fresh: f64,
    /// Pressure p0 [F/L2].
    pub pressure: f64,
    /// Part r of it that is left after running in [1].
    pub left: f64,
    /// Distance s0 of running in [L].
    pub distance: f64,
    /// Elastic slip gamma_crit of sticking [L].
    pub elastic_slip: f64,
}

impl Constants {
    /// From the data lines of the card.
    ///
    /// # Errors
    /// If there are not five, or not all of them are positive.
    pub fn read(properties: &[f64]) -> Result<Self, UserFrictionError> {
        match *properties {
            [fresh, pressure, left, distance, elastic_slip]
                if properties.iter().all(|value| *value > 0.0) =>
            {
                Ok(Self { fresh, pressure, left, distance, elastic_slip })
            }
            _ => Err(UserFrictionError {
                message: format!("{NAME} takes five positive constants, not {properties:?}"),
            }),
        }
    }

    /// Limit traction tau_crit [F/L2] at `pressure` [F/L2] after sliding by
    /// `slid` [L], with its derivatives by pressure [1] and distance [F/L3].
    pub fn limit(&self, pressure: f64, slid: f64) -> [f64; 3] {
        let rough = self.fresh * pressure * (self.pressure / pressure).cbrt();
        let fading = (1.0 - self.left) * (-slid / self.distance).exp();
        let worn = self.left + fading;
        [rough * worn, 2.0 / 3.0 * rough * worn / pressure, -rough * fading / self.distance]
    }

    /// Traction at a point that has slid by `slid` before, and how far it has
    /// slid now; backward Euler, elastic below the limit.
    fn answer(&self, point: &FrictionPoint, slid: f64) -> (Traction, f64) {
        let trial = point.elastic_slip + point.slip;
        if trial.size() <= self.elastic_slip {
            let [tau, by_pressure, _] = self.limit(point.pressure, slid);
            let part = trial / self.elastic_slip;
            let sticking = Traction {
                tau: tau * part,
                d_tau_d_slip: TangentialMap::isotropic(tau / self.elastic_slip),
                d_tau_d_pressure: by_pressure * part,
                elastic_slip: trial,
                dissipated_slip: 0.0,
                status: Status::Stick,
            };
            return (sticking, slid);
        }
        let (way, dissipated) = (trial.direction(), trial.size() - self.elastic_slip);
        let [tau, by_pressure, by_distance] = self.limit(point.pressure, slid + dissipated);
        let turning = TangentialMap::across(way, tau / trial.size());
        let sliding = Traction {
            tau: tau * way,
            d_tau_d_slip: by_distance * way.outer(way) + turning,
            d_tau_d_pressure: by_pressure * way,
            elastic_slip: self.elastic_slip * way,
            dissipated_slip: dissipated,
            status: Status::Slip,
        };
        (sliding, slid + dissipated)
    }
}

/// The law. It keeps nothing itself: the memory comes and goes with the batch.
pub struct RunningIn;

impl UserFriction for RunningIn {
    fn update(&self, batch: &mut FrictionBatch<'_>) -> Result<(), UserFrictionError> {
        let constants = Constants::read(batch.properties)?;
        for (k, point) in batch.points.iter().enumerate() {
            let (traction, slid) = constants.answer(point, batch.committed[k]);
            batch.tractions[k] = traction;
            batch.state[k] = slid;
        }
        Ok(())
    }
}

/// A block under 10 N is pulled by 0.5 m, and back.
pub const DECK: &str = "*HEADING
block on a plane, friction of one's own
*NODE
1, 0.0, 0.0
3, 0.0, 1.0
99, 0.0, -1.0
*RIGID SURFACE, ELSET=CONTACT, TYPE=SEGMENTS
START, -5.0, 0.0
LINE, 5.0, 0.0
*ELEMENT, TYPE=IRS21, ELSET=CONTACT
11, 1, 3, 99
*INTERFACE, ELSET=CONTACT
1.0
*FRICTION, USER=RUNNING-IN, PROPERTIES=5, DEPVAR=1
0.3, 10.0, 0.4, 0.2, 1.0E-3
*STEP, NLGEOM
PRESS
*STATIC
1.0, 1.0
*BOUNDARY
1, 1
1, 6
3, 1, 6
99, 1, 6
*CLOAD
1, 2, -10.0
*CONTROLS, PARAMETERS=FIELD
1.0E-12
*END STEP
*STEP, NLGEOM
PULL
*STATIC
0.1, 1.0, 1.0E-6, 0.1
*BOUNDARY
1, 1, 1, 0.5
*CONTROLS, PARAMETERS=FIELD
1.0E-12
*END STEP
*STEP, NLGEOM
BACK
*STATIC
0.1, 1.0, 1.0E-6, 0.1
*BOUNDARY
1, 1, 1, 0.0
*CONTROLS, PARAMETERS=FIELD
1.0E-12
*END STEP
";

/// Travel [L] and pulling force [F] of node 1 after every increment.
#[derive(Clone, Debug, Default)]
pub struct Pull {
    /// (travel, force).
    pub rows: Vec<[f64; 2]>,
}

impl Observer for Pull {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event
            && let Some(node) = frame.model.nodes.find(1)
        {
            let row =
                [frame.nodal.displacement(node, Dof::U1), frame.nodal.reaction(node, Dof::U1)];
            self.rows.push(row);
        }
        ControlFlow::Continue(())
    }
}

/// Runs a model with the law registered.
pub fn pull(model: &Model) -> (Pull, Ending) {
    let mut options = SolveOptions::default();
    options.user_frictions.register(NAME, Arc::new(RunningIn));
    let mut watch = Pull::default();
    let ending = slideline::solve(model, &options, &mut watch);
    (watch, ending)
}

fn main() {
    let read = Job::read_text("running_in", DECK, &ReadOptions::default());
    let Some(model) = read.model else {
        eprintln!("{:#?}", read.diagnostics);
        return;
    };
    let (pulled, ending) = pull(&model);
    println!("   travel      force");
    for [travel, force] in pulled.rows {
        println!("{travel:9.3} {force:10.6}");
    }
    println!("{ending:?}");
}
