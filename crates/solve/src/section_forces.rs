//! What passes through the surfaces that a step asks about.
//!
//! ```text
//!    o-----o-----o
//!    |     |     |     the elements behind a surface hand their forces over
//!    o==f==o==f==o     at its nodes: these are what acts on them there
//! ```
//! docs/theory.md eq. (10.9).

use crate::newton::Scratch;
use crate::observe::results::SectionRow;
use crate::problem::Problem;
use crate::state::State;
use slideline_mech::pressure::MOST_NODES;
use slideline_model::{Dof, NodeIndex, SectionFace, SectionPrint};

/// Part of the area below which the sum of its normals is rounding [1].
const EVEN: f64 = 1e-10;

/// Fills a row for every request of the step, of a state that was just committed.
pub fn section_rows(plan: &Problem<'_>, state: &State, work: &Scratch, rows: &mut Vec<SectionRow>) {
    rows.clear();
    rows.extend(plan.step.output.section_prints.iter().map(|print| row(plan, state, work, print)));
}

fn row(plan: &Problem<'_>, state: &State, work: &Scratch, print: &SectionPrint) -> SectionRow {
    let place = |node: NodeIndex| {
        let at = plan.model.nodes.position(node);
        let moved = |dof| match plan.step.nlgeom {
            true => plan.dofs.read(&state.displacement, node, dof),
            false => 0.0,
        };
        let [x, y, z] = [Dof::U1, Dof::U2, Dof::U3].map(moved);
        [at[0] + x, at[1] + y, at[2] + z]
    };
    let mut row = SectionRow::default();
    for share in &print.shares {
        let forces = &work.evaluation.contributions;
        plan.structure.forces_of(share.element, forces, |node, force| {
            if share.nodes.contains(&node) {
                row.carried.add(force, place(node));
            }
        });
    }
    for face in &print.faces {
        row.cover(face, place);
    }
    row.take_means();
    row
}

impl SectionRow {
    /// Adds the area of a face, its centre and its normal.
    fn cover(&mut self, own: &SectionFace, place: impl Fn(NodeIndex) -> [f64; 3]) {
        let mut x = [[0.0; 3]; MOST_NODES];
        let count = own.nodes.len().min(MOST_NODES);
        x.iter_mut().zip(&own.nodes).for_each(|(x, &node)| *x = place(node));
        let (mut areas, mut against) = ([[0.0; 3]; MOST_NODES], [[0.0; 3]; MOST_NODES]);
        own.face.pull(|_| [1.0, 0.0, 0.0], &x[..count], &mut areas[..count]);
        own.face.press(1.0, &x[..count], &mut against[..count]);
        // the shares of the nodes in the area carry its first moment: places are interpolated alike
        for node in 0..count {
            self.area += areas[node][0];
            for axis in 0..3 {
                self.centre[axis] += areas[node][0] * x[node][axis];
                self.normal[axis] -= against[node][axis];
            }
        }
    }

    /// Turns sums over the area into means; the normal is given the length one, or none where faces
    /// look both ways.
    fn take_means(&mut self) {
        if self.area > 0.0 {
            self.centre = self.centre.map(|sum| sum / self.area);
        }
        let long = self.normal.iter().fold(0.0, |sum: f64, own| sum.hypot(*own));
        let scale = if long > EVEN * self.area { 1.0 / long } else { 0.0 };
        self.normal = self.normal.map(|sum| scale * sum);
    }
}
