//! Corners and noses of rigid masters that pass between two slave nodes in an increment.
//!
//! ```text
//!    a           b     slave nodes
//!    o-----------o
//!          ^
//!          |  a corner of the master, deeper than their distance lets it
//! ```
//!
//! docs/theory.md section 5.8. (derived)

use super::crossing::{Missed, Sweep};
use super::master::MasterSurface;
use super::pairs::Contact;
use crate::state::PointState;

impl Contact {
    /// The first corner or nose of a rigid master that passed between two slave
    /// nodes deeper than their distance lets it.
    pub fn passed_between(&self, sweep: &Sweep<'_>) -> Option<Missed> {
        let mut first: Option<Missed> = None;
        for (pair, master) in self.masters.iter().enumerate() {
            let MasterSurface::Body { surface, .. } = master else { continue };
            if self.edges[pair].is_empty() {
                continue;
            }
            let bodies = (master.placed_body(sweep.from), master.placed_body(sweep.to));
            for &points in &self.edges[pair] {
                // a soft law lets the points themselves sink in
                let sunk = points.map(|place| -sweep.now[place].opening);
                let sunk = sunk.into_iter().filter(|depth| depth.is_finite()).fold(0.0, f64::max);
                let edge = |states: &[PointState]| points.map(|place| states[place].position);
                let edges = (edge(sweep.before), edge(sweep.now));
                let found = surface.noses().filter_map(|nose| {
                    let now = nose.reach(&bodies.1, edges.1)?;
                    let allowed = now.allowed + sunk;
                    if now.depth <= allowed {
                        return None;
                    }
                    let before = nose.reach(&bodies.0, edges.0)?;
                    let t = (allowed - before.depth) / (now.depth - before.depth);
                    let beside = before.beside + t * (now.beside - before.beside);
                    let passed = before.depth <= allowed;
                    (passed && (0.0..=1.0).contains(&beside)).then_some(t)
                });
                for fraction in found {
                    if first.is_none_or(|first| fraction < first.fraction) {
                        first = Some(Missed { pair, points, between: true, fraction });
                    }
                }
            }
        }
        first
    }
}
