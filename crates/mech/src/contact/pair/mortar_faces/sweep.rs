//! Second derivatives: the gradient swept over the nodes of both sides.
//!
//! ```text
//!   nodes x seeds, four nodes at a time --> force, columns of its derivative
//! ```

use super::clip::Overlap;
use super::couple::Couple;
use super::face_places::FacePlaces;
use super::places::{Place, zero};
use super::pull::Load;
use super::shapes::MOST_NODES;
use crate::first_order::First;

/// Nodes of a sweep.
const AT_ONCE: usize = 4;
/// Directions of a sweep.
const WIDE: usize = 3 * AT_ONCE;
type Number = First<WIDE>;

/// A force on the nodes of both sides with its derivative.
#[derive(Debug, Clone, Default)]
pub struct Swept {
    /// The force, a node each, those of the slave first [F].
    pub force: Vec<Place<f64>>,
    /// Its derivative, square, by component [F/L].
    pub derivative: Vec<f64>,
}

/// Room for a sweep.
#[derive(Debug, Clone, Default)]
pub struct SweepRoom {
    force: Vec<Place<Number>>,
}

impl SweepRoom {
    /// The gradient of a load over an overlap and its derivative, the load kept; false where a place
    /// faces nothing.
    pub fn sweep(
        &mut self,
        couple: &Couple<'_, f64>,
        overlap: &Overlap,
        load: &Load<f64>,
        into: &mut Swept,
    ) -> bool {
        let (nodes, of_slave) = (couple.count(), couple.slave.count);
        let columns = 3 * nodes;
        into.force.clear();
        into.force.resize(nodes, zero());
        into.derivative.clear();
        into.derivative.resize(columns * columns, 0.0);
        let load = Load {
            gap: load.gap.map(Number::constant),
            area: load.area.map(Number::constant),
            drag: load.drag.map(|drag| drag.map(Number::constant)),
        };
        for first in (0..nodes).step_by(AT_ONCE) {
            let slave = seeded(couple.slave, (0, first));
            let master = seeded(couple.master, (of_slave, first));
            let (measure, ends) = (couple.measure, couple.ends);
            let own = Couple { slave: &slave, measure, master: &master, ends };
            self.force.clear();
            self.force.resize(nodes, zero());
            if !own.pull(overlap, &[load], [&mut self.force]) {
                return false;
            }
            let wide = WIDE.min(columns - 3 * first);
            for (node, force) in self.force.iter().enumerate() {
                into.force[node] = force.map(|own| own.value);
                for (axis, own) in force.iter().enumerate() {
                    let row = (3 * node + axis) * columns + 3 * first;
                    into.derivative[row..][..wide].copy_from_slice(&own.gradient[..wide]);
                }
            }
        }
        true
    }
}

/// A face whose nodes from `first` on are variables; its own begin at `begin` among those of both.
fn seeded(face: &FacePlaces<f64>, (begin, first): (usize, usize)) -> FacePlaces<Number> {
    let node = |node: usize| -> Place<Number> {
        std::array::from_fn(|axis| {
            let value = face.nodes[node][axis];
            match (begin + node).checked_sub(first) {
                Some(own) => Number::variable(value, 3 * own + axis),
                None => Number::constant(value),
            }
        })
    };
    let nodes: [Place<Number>; MOST_NODES] = std::array::from_fn(node);
    FacePlaces { nodes, count: face.count }
}
