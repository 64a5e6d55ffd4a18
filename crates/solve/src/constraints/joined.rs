//! Dofs that the constraints of a deck join to others.

use super::linear::{LinearConstraint, Source};
use super::rigid::RigidLink;
use std::collections::BTreeSet;

/// Dofs that equations name and that follow rigid bodies, without those of the bodies, which stand for
/// all that follows them; and these.
pub fn joined(linear: &[LinearConstraint], rigid: &[RigidLink]) -> [Vec<usize>; 2] {
    let said = linear.iter().filter(|own| matches!(own.source, Source::Said(_)));
    let said = said.flat_map(|own| {
        own.terms.iter().map(|&(dof, _)| dof).chain(std::iter::once(own.dependent))
    });
    let follows = rigid.iter().flat_map(|link| link.dependent_dofs().map(|own| own.1));
    let bodies = rigid
        .iter()
        .flat_map(|link| (0..6).flat_map(|component| link.followed(component)).flatten());
    let bodies: BTreeSet<usize> = bodies.collect();
    let joined = said.chain(follows).filter(|dof| !bodies.contains(dof)).collect();
    [joined, bodies.into_iter().collect()]
}
