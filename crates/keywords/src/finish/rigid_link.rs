//! A node that follows another one rigidly.

use slideline_diag::{Code, Diagnostic};
use slideline_model::{Dof, RigidLink};

use crate::draft::Draft;
use crate::rule::Subject;

/// Makes a node follow, unless it follows already.
pub(super) fn tie(link: RigidLink, draft: &mut Draft) {
    let RigidLink { dependent, origin, .. } = link;
    let dofs = || Dof::ALL.into_iter().filter(|&dof| link.follows[dof as usize]);
    let taken = dofs().find_map(|dof| draft.dependents.get(&(dependent, dof)).copied());
    if let Some(first) = taken {
        let label = draft.model.nodes.label(dependent);
        let message = format!("node {label} is a dependent node twice");
        let error = Diagnostic::error(Code("SL0316"), message).at(origin);
        let error = error.label(first, "linked here first");
        let error = super::equations::beside_cut(error, dependent, draft);
        draft.consequence(Subject::Links, error);
        return;
    }
    draft.dependents.extend(dofs().map(|dof| ((dependent, dof), origin)));
    draft.model.rigid_links.push(link);
}
