//! Faces of both sides of a pair that do not meet, though they hide what lies behind them.
//!
//! ```text
//!      | slave  |
//!   +--o~~~~x~~~o--+     the node x faces the top of the master, which it does not meet here, and
//!   |    master    |     not the sides of the master through it
//!   +--------------+
//! ```
//!
//! docs/theory.md section 5.6

use super::facing::Facing;
use super::master::MasterSurface;
use super::mortar::curves::curves;
use super::mortar::slave::{ApartFaces, Control, Mortar};
use super::pairs::{Apart, Contact, SlavePoint};
use slideline_model::{FacesByNodes, LeftOut, Master, Model, NodeIndex};

impl Contact {
    /// Notes what of the pairs, and of their edges, does not meet.
    pub(super) fn take_left_out(&mut self, model: &Model) {
        let own = model.contact_pairs.iter().map(|pair| (&pair.left_out, &pair.master));
        let edges = model.edge_pairs.iter().map(|edges| (&edges.left_out, &edges.met));
        let apart = own.chain(edges).map(|(left_out, master)| {
            left_out.iter().map(|own| apart(own, master)).collect::<Vec<_>>()
        });
        self.apart = apart.collect();
        let mut mortars = std::mem::take(&mut self.mortars);
        for mortar in &mut mortars {
            let pair = &model.contact_pairs[mortar.pair];
            let of_master = pair.master.deforming_nodes();
            let faces = |own| self.apart_faces(mortar, own, &of_master);
            mortar.apart = pair.left_out.iter().map(faces).collect();
        }
        self.mortars = mortars;
    }

    /// Slave faces of a mortar and curves of its master that do not meet.
    fn apart_faces(&self, mortar: &Mortar, own: &LeftOut, of_master: &[NodeIndex]) -> ApartFaces {
        let (slave, master) = (FacesByNodes::new(&own.slave), FacesByNodes::new(&own.master));
        let faces = mortar.faces.iter().map(|face| {
            let points = face.points[..face.count].iter();
            let nodes: Vec<_> = points.map(|own| self.points[mortar.first + own].node).collect();
            slave.has(&nodes)
        });
        let mut of_curves = Vec::new();
        curves(&self.masters[mortar.pair], &mut of_curves);
        let curves = of_curves.iter().map(|curve| {
            let controls = curve.controls[..curve.count].iter();
            let nodes = controls.flat_map(|control: &Control| control.nodes());
            master.has(&nodes.map(|(node, _)| of_master[node]).collect::<Vec<_>>())
        });
        [faces.collect(), curves.collect()]
    }

    /// Whether a slave node does not meet a part, or a face, of its master.
    pub(super) fn leaves_out(&self, point: &SlavePoint, part: usize) -> bool {
        let part = match &self.masters[point.pair] {
            MasterSurface::Line { nodes, beyond, itself: None, .. } => {
                beyond.own_segment(part, nodes.len())
            }
            _ => part,
        };
        let leaves = |own: &Apart| {
            own.parts.get(part).is_some_and(|&is_apart| is_apart) && own.nodes.contains(&point.node)
        };
        self.apart.get(point.pair).is_some_and(|all| all.iter().any(leaves))
    }

    /// Whether it does not meet what it faces.
    pub(super) fn leaves_out_faced(&self, point: &SlavePoint, facing: &Facing) -> bool {
        match facing {
            Facing::Surface(_) | Facing::Edges(_) => false,
            Facing::Face(place) => self.leaves_out(point, place.face),
            Facing::Piece(piece) => piece.segments().any(|part| self.leaves_out(point, part)),
        }
    }

    /// Whether a slave node can pass through a part or face of its master.
    pub(super) fn is_stopped(&self, point: &SlavePoint, part: usize) -> bool {
        self.masters[point.pair].stops(point.seat, part) && !self.leaves_out(point, part)
    }
}

fn apart(own: &LeftOut, master: &Master) -> Apart {
    let known = FacesByNodes::new(&own.master);
    let parts = match master {
        Master::SlideLine(line) => line.nodes.windows(2).map(|part| known.has(part)).collect(),
        Master::Faces(faces) => faces.faces.iter().map(|face| known.has(&face.nodes)).collect(),
        Master::RigidSurface(_) | Master::Itself(_) => Vec::new(),
    };
    Apart { nodes: own.slave.iter().flatten().copied().collect(), parts }
}
