//! The pattern of the tangent, with where elements enter it.

use crate::constraints::ConstraintNumbering;
use crate::contact::{Candidates, Cliques, Contact};
use crate::structure::ElementNumbering;
use slideline_linalg::Pattern;
use std::sync::Arc;

/// Which unknowns couple, by elements and by the contact that is near. A copy shares the
/// memory of the original.
#[derive(Clone, Debug)]
pub struct Coupling {
    /// Sparsity of the tangent.
    pub pattern: Pattern,
    /// Where every tangent entry of the elements goes.
    pub entries: Arc<[u32]>,
    /// Parts of their masters that points may touch, where these are not all.
    pub near: Arc<[Candidates]>,
    /// Unknowns that contact acts on, ascending.
    pub interface: Arc<[usize]>,
}

impl Coupling {
    /// The coupling of elements, and of contact points with the parts of their masters that
    /// are `near`.
    pub fn new(
        elements: &ElementNumbering,
        dependent: &[usize],
        constraints: &ConstraintNumbering,
        (contact, near): (&Contact, &[Candidates]),
    ) -> Self {
        // many points with prescribed dofs couple the same unknowns of their master
        let cliques = contact.cliques(near, constraints);
        let coupling = || cliques.iter().filter(|own| own.len() > 1);
        let mut several: Vec<&[usize]> = Vec::with_capacity(coupling().count());
        several.extend(coupling());
        several.sort_unstable();
        several.dedup();
        let (count, dofs) = elements.size_of_cliques();
        let mut own = Cliques::with_room(count, dofs);
        elements.cliques().for_each(|dofs| own.add(constraints, dofs));
        constraints.kept().for_each(|dof| own.add(constraints, [dof]));
        let pattern = Pattern::from_cliques(constraints.equations(), own.iter().chain(several));
        let entries = elements.entries(dependent, constraints, &pattern).into();
        let mut interface: Vec<usize> = cliques.iter().flatten().copied().collect();
        interface.sort_unstable();
        interface.dedup();
        Self { pattern, entries, near: near.into(), interface: interface.into() }
    }
}
