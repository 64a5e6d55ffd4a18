//! What `check` says before a run, and what a run's noise asks to be said
//! after it.
//!
//! ```text
//!   Model --> Start (bodies, contact points, rehearsed motions) --> findings SL04xx
//!   run   --> Noise (watches every increment)                   --> findings SL06xx
//! ```
//!
//! A finding is a diagnostic with numbers and physical words, and where one
//! card mends it, a [`Suggestion`] that `check --fix` can write. Nothing here
//! changes a model or a run.

mod alike;
mod apart;
mod bodies;
mod coarse;
mod corners;
mod distorted;
mod finding;
mod idle_loads;
mod locking;
mod mesh;
mod moments;
mod motion;
mod motion_in_space;
mod noise;
mod overclosure;
mod overconstraint;
mod overlap;
mod quadratic;
mod rehearsal;
mod rigid_motion;
mod roles;
mod sides;
mod solids_in_one_another;
mod standing_in;
mod start;
mod stroke;
mod time;
mod units;
mod unmerged;

pub use finding::{Finding, Place, Suggestion};
pub use noise::Noise;

use slideline_model::Model;

/// Everything the adviser finds in a model before it runs. A model that the
/// solver refuses is judged without its contact points.
pub fn advise(model: &Model) -> Vec<Finding> {
    let mut start = start::Start::of(model);
    let mut findings = Vec::new();
    if model.is_in_space() {
        // what lies about contact is judged in the plane alone
        overclosure::judge(&start, &mut findings);
        sides::judge(&start, &mut findings);
        solids_in_one_another::judge(&start, &mut findings);
        quadratic::judge(&start, &mut findings);
        coarse::judge(&start, &mut findings);
        distorted::judge(&start, &mut findings);
        unmerged::judge(&start, &mut findings);
        idle_loads::judge(&start, &mut findings);
        motion_in_space::judge(&start, &mut findings);
        apart::judge(&start, &mut findings);
        units::judge(&start, &mut findings);
        locking::judge(&start, &mut findings);
        time::judge(&start, &mut findings);
        return findings;
    }
    rehearsal::rehearse(&mut start);
    let parts: [fn(&start::Start<'_>, &mut Vec<Finding>); 17] = [
        overclosure::judge,
        roles::judge,
        overconstraint::judge,
        stroke::judge,
        sides::judge,
        coarse::judge,
        mesh::judge,
        distorted::judge,
        unmerged::judge,
        idle_loads::judge,
        rigid_motion::judge,
        overlap::judge,
        solids_in_one_another::judge,
        apart::judge,
        units::judge,
        locking::judge,
        time::judge,
    ];
    for part in parts {
        part(&start, &mut findings);
    }
    findings
}
