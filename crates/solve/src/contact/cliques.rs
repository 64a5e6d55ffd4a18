//! Which unknowns contact may couple.

use super::candidates::Candidates;
use super::master::MasterSurface;
use super::pairs::{Carrier, Contact};
use crate::constraints::ConstraintNumbering;

/// Sets of unknowns, one behind the other in one list.
#[derive(Clone, Debug, Default)]
pub struct Cliques {
    members: Vec<usize>,
    /// Where every set ends among the members.
    ends: Vec<usize>,
}

impl Cliques {
    /// None yet, with room for so many sets and members.
    pub fn with_room(sets: usize, members: usize) -> Self {
        Self { members: Vec::with_capacity(members), ends: Vec::with_capacity(sets) }
    }

    /// Adds the unknowns that a set of dofs depends on.
    pub fn add<'a>(
        &mut self,
        constraints: &ConstraintNumbering,
        dofs: impl IntoIterator<Item = &'a usize>,
    ) {
        dofs.into_iter().for_each(|&dof| constraints.equations_of(dof, &mut self.members));
        self.ends.push(self.members.len());
    }

    /// All sets, in the order in which they were added.
    pub fn iter(&self) -> impl Iterator<Item = &[usize]> {
        let begins = std::iter::once(0).chain(self.ends.iter().copied());
        begins.zip(&self.ends).map(|(begin, &end)| &self.members[begin..end])
    }
}

impl Contact {
    /// Sets of unknowns that may couple: of deforming masters with many parts,
    /// only what is `near`.
    pub fn cliques(&self, near: &[Candidates], constraints: &ConstraintNumbering) -> Cliques {
        let points = self.points.len();
        let mut cliques = Cliques::with_room(4 * points, 16 * points);
        for segment in &self.segments {
            if let MasterSurface::Body { dofs, .. } = &self.masters[segment.pair] {
                cliques.add(constraints, segment.all_dofs().chain(dofs));
            }
        }
        for (place, point) in self.points.iter().enumerate() {
            let Carrier::Node { dofs: own, section, .. } = &point.carrier else { continue };
            let turn =
                section.iter().take(1).filter(|(_, weight)| *weight != 0.0).map(|(dof, _)| dof);
            if let Some(mortar) = point.mortar {
                self.add_mortar_clique((mortar, place), near, constraints, &mut cliques);
                continue;
            }
            match &self.masters[point.pair] {
                MasterSurface::Nothing => {}
                MasterSurface::Faces { mesh, nodes, .. } => {
                    let Some(Candidates::Faces(faces)) = near.get(place) else { continue };
                    let mut all: Vec<usize> =
                        faces.iter().flat_map(|&face| mesh.stencil(face)).copied().collect();
                    all.sort_unstable();
                    all.dedup();
                    if !all.is_empty() {
                        let facing = all.iter().flat_map(|&node| nodes[node].1.as_slice());
                        cliques.add(constraints, own.as_slice().iter().chain(facing));
                    }
                }
                MasterSurface::Body { dofs, .. } => {
                    cliques.add(constraints, own.as_slice().iter().chain(turn).chain(dofs));
                }
                MasterSurface::Line { chain, nodes, beyond, .. } => {
                    let all = 0..nodes.len();
                    let range = match near.get(place) {
                        Some(Candidates::Nodes(range)) => range.clone(),
                        _ => all,
                    };
                    let window = range.len().min(chain.most_nodes()).max(1);
                    for first in range.start..(range.end + 1).saturating_sub(window) {
                        let part = first..first + window;
                        let rims = beyond.rims(part.clone(), nodes.len());
                        let facing = part.chain(rims).flat_map(|node| nodes[node].1.as_slice());
                        let own = own.as_slice().iter().chain(turn.clone());
                        cliques.add(constraints, own.chain(facing));
                    }
                }
            }
        }
        for own in near {
            if let Candidates::Met(dofs) = own {
                cliques.add(constraints, dofs);
            }
        }
        cliques
    }

    /// What a point that is spread over faces couples: their nodes, and those of the master that
    /// are near.
    fn add_mortar_clique(
        &self,
        (own, place): (usize, usize),
        near: &[Candidates],
        constraints: &ConstraintNumbering,
        cliques: &mut Cliques,
    ) {
        let pair = self.points[place].pair;
        if matches!(self.masters[pair], MasterSurface::Nothing) {
            return;
        }
        let mut all: Vec<usize> = Vec::new();
        if let MasterSurface::Faces { mesh, nodes, .. } = &self.masters[pair] {
            let Some(Candidates::Faces(faces)) = near.get(place).filter(|own| own.is_any()) else {
                return;
            };
            let mortar = &self.face_mortars[own];
            self.slaves_of_face_mortar(mortar, place - mortar.first, |node| {
                all.extend_from_slice(mortar.dofs[node].as_slice());
            });
            let of_faces = faces.iter().flat_map(|&face| &mesh.faces()[face].nodes);
            all.extend(of_faces.flat_map(|&node| nodes[node].1.as_slice()));
            all.sort_unstable();
            all.dedup();
            cliques.add(constraints, &all);
            return;
        }
        let mortar = &self.mortars[own];
        self.slaves_of_mortar(mortar, place - mortar.first, |node| {
            all.extend_from_slice(mortar.dofs[node].as_slice());
        });
        match &self.masters[mortar.pair] {
            MasterSurface::Body { dofs, .. } => all.extend_from_slice(dofs),
            MasterSurface::Line { nodes, .. } => {
                let Some(Candidates::Nodes(range)) = near.get(place) else { return };
                if range.is_empty() {
                    return;
                }
                all.extend(nodes[range.clone()].iter().flat_map(|(_, dofs)| dofs.as_slice()));
            }
            MasterSurface::Faces { .. } | MasterSurface::Nothing => return,
        }
        all.sort_unstable();
        all.dedup();
        cliques.add(constraints, &all);
    }
}
