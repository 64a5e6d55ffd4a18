//! Rigid motions that neither supports nor contact oppose.
//!
//! ```text
//!        | F
//!     ___v___        what presses holds across its faces; along them nothing does
//!    |_______| <->   without friction
//!    /////////
//! ```

use super::rigid_motions::{DEPENDENT, Motion, null_motions, rigid_motion};
use super::{Restraint, RigidMotion, length};
use slideline_model::{Dof, Model, NodeIndex, Step};

/// Part of a motion that contact meets along its normals below which it does not oppose it [1]: faces tilt by the
/// strains of what they belong to. (choice)
const OPPOSED: f64 = 1e-2;

/// A point of contact that faces its master.
pub struct Opposing {
    /// The translations that it follows, with its derivatives by them [1].
    pub terms: Vec<(NodeIndex, Dof, f64)>,
    /// Whether it presses.
    pub presses: bool,
    /// Whether it has friction.
    pub rubs: bool,
}

/// A motion that nothing opposes.
pub struct Unopposed {
    /// The motion.
    pub motion: RigidMotion,
    /// Whether contact presses on its body.
    pub is_pressed: bool,
}

impl Restraint {
    /// A rigid motion of a body that supports leave to it, and that points which press do not oppose, given where nodes
    /// stand: of one that is pressed, where there is one. Nothing is said of bodies that face nothing, that others hold in
    /// part, or where friction may hold.
    pub fn unopposed(
        &mut self,
        (model, step): (&Model, &Step),
        points: &[Opposing],
        place: impl Fn(NodeIndex) -> [f64; 3],
    ) -> Option<Unopposed> {
        let mut unpressed = None;
        for root in self.roots() {
            match self.unopposed_of((model, step), root, points, &place) {
                Some(found) if found.is_pressed => return Some(found),
                found => unpressed = unpressed.or(found),
            }
        }
        unpressed
    }

    /// The same of the body of a root.
    fn unopposed_of(
        &mut self,
        (model, step): (&Model, &Step),
        root: NodeIndex,
        points: &[Opposing],
        place: &impl Fn(NodeIndex) -> [f64; 3],
    ) -> Option<Unopposed> {
        let motions = self.motions(root);
        if motions.is_empty()
            || self.ties.group(root).len() > 1
            || self.is_sprung(model, step, root)
        {
            return None;
        }
        let members = self.members(model, root);
        // motions count by the way of what moves most
        let by_most = |motion: &Motion| {
            let (_, moved) = self.farthest(model, (root, &members), motion)?;
            Some(motion.map(|part| part / length(moved)))
        };
        let motions: Vec<Motion> = motions.iter().filter_map(by_most).collect();
        let rows = self.opposing(root, (&motions, points), place)?;
        let is_pressed = !rows.is_empty();
        let left = null_motions((rows, motions.len()), 0..motions.len(), OPPOSED);
        // supports know where nodes began, contact where they stand: what turns about a support is not judged
        let is_supported = self.rows.get(&root).is_some_and(|rows| !rows.is_empty());
        left.iter().find_map(|parts| {
            let sum: Motion = std::array::from_fn(|k| {
                parts.iter().zip(&motions).map(|(part, motion)| part * motion[k]).sum()
            });
            let turns = sum[3..].iter().any(|part| part.abs() > DEPENDENT);
            if is_supported && turns {
                return None;
            }
            let motion = self.of_body(model, (root, &members), &sum)?;
            Some(Unopposed { motion, is_pressed })
        })
    }

    /// What the points that press on the body of a root see of motions, a row each; `None`: it faces nothing, or one rubs.
    fn opposing(
        &mut self,
        root: NodeIndex,
        (motions, points): (&[Motion], &[Opposing]),
        place: &impl Fn(NodeIndex) -> [f64; 3],
    ) -> Option<Vec<f64>> {
        let (mut rows, mut is_met, origin) = (Vec::new(), false, place(root));
        for point in points {
            let (mut seen, mut weight) = ([0.0; 6], 0.0);
            for &(node, dof, factor) in &point.terms {
                if self.bodies.root(node) != root {
                    continue;
                }
                let at = place(node);
                let arm = std::array::from_fn(|axis| (at[axis] - origin[axis]) / self.size);
                let own = rigid_motion(dof, arm);
                seen.iter_mut().zip(own).for_each(|(sum, part)| *sum += factor * part);
                weight += factor.abs();
            }
            // a point with both sides on the body sees none of its motions
            if seen.iter().all(|part| part.abs() <= DEPENDENT * weight) {
                continue;
            }
            is_met = true;
            if !point.presses {
                continue;
            }
            if point.rubs {
                return None;
            }
            let row = motions
                .iter()
                .map(|motion| seen.iter().zip(motion).map(|(a, b)| a * b).sum::<f64>() / weight);
            rows.extend(row);
        }
        is_met.then_some(rows)
    }
}
