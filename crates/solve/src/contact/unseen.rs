//! What contact over faces does not see of an overlap, because it takes means.

use super::kinematics::ContactKinematics;
use super::master::MasterSurface;
use super::pairs::Contact;
use slideline_model::NodeIndex;

/// A slave face that lies in the master.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unseen {
    /// Place of its pair in the model.
    pub pair: usize,
    /// How deep beyond its mean overclosure, in sizes of the face [1].
    pub depth: f64,
    /// A node of it.
    pub node: NodeIndex,
}

impl Contact {
    /// Of every pair that is spread over faces, the slave face that lies deepest in the master beyond
    /// its mean.
    pub fn unseen<'a>(
        &'a self,
        kinematics: &'a ContactKinematics,
    ) -> impl Iterator<Item = Unseen> + 'a {
        let in_plane = self.mortars.iter().zip(&kinematics.mortars);
        let points = kinematics.points();
        let in_plane = in_plane.map(move |(own, room)| {
            let unseen = room.now.unseen(own, |point| points[own.first + point].faces);
            (own.pair, own.first, unseen)
        });
        let in_space = self.face_mortars.iter().zip(&kinematics.face_mortars);
        let in_space = in_space.map(|(own, room)| (own.pair, own.first, room.now.unseen(own)));
        let is_there = move |pair: usize| !matches!(self.masters[pair], MasterSurface::Nothing);
        let found = in_plane.chain(in_space).filter(move |&(pair, ..)| is_there(pair));
        found.filter_map(move |(pair, first, unseen)| {
            let (depth, point) = unseen?;
            Some(Unseen { pair, depth, node: self.points[first + point].node })
        })
    }
}
