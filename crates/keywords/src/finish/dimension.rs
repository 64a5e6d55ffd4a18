//! Whether the model moves in a plane or in space, where the types of its elements do not say so.

use slideline_model::{ElementType, types};

use crate::draft::{Draft, ElementKind, Gap, Spring};

/// Springs and gaps are of the plane and of space: those whose nodes lie in no plane z = constant,
/// or that resist a motion out of it, are of space where no element of the plane stands beside them.
pub(super) fn dimension(draft: &mut Draft) {
    let undecided = !draft.elements.is_empty()
        && draft.elements.iter().all(|element| is_of_either(element.kind));
    if undecided && !draft.spatial {
        draft.spatial = leaves_the_plane(draft)
            || draft.springs.iter().any(|spring| resists_out_of_plane(spring, draft))
            || draft.gaps.iter().any(|gap| closes_out_of_plane(gap, draft));
    }
    draft.model.in_space = draft.spatial;
}

/// Whether elements of that type stand in plane models and in those of space.
fn is_of_either(kind: ElementKind) -> bool {
    match kind {
        ElementKind::Structural(row) => !row.joins(),
        _ => kind.is_dynamic(),
    }
}

/// Whether the nodes of the elements differ in their third coordinate.
fn leaves_the_plane(draft: &Draft) -> bool {
    let labels = draft.elements.iter().flat_map(|element| element.nodes());
    let found = labels.filter_map(|&label| draft.model.nodes.find(label));
    let mut heights = found.map(|node| draft.model.nodes.position(node)[2]);
    heights.next().is_some_and(|first| heights.any(|z| z != first))
}

/// Whether it resists a motion along axis 3 or a rotation about axis 1 or 2.
fn resists_out_of_plane(spring: &Spring, draft: &Draft) -> bool {
    let dof = spring.lines.first().and_then(|(numbers, _)| numbers.first());
    let out_of_plane = dof.is_some_and(|dof| [3.0, 4.0, 5.0].contains(dof));
    out_of_plane && has(&[&types::SPRING1, &types::SPRING2], &spring.set, draft)
}

/// Whether it closes along a direction, or across an axis, that is none of a plane model.
fn closes_out_of_plane(gap: &Gap, draft: &Draft) -> bool {
    gap.direction.is_some_and(|[x, y, z]| {
        (z != 0.0 && has(&[&types::GAPUNI], &gap.set, draft))
            || ((x != 0.0 || y != 0.0) && has(&[&types::GAPCYL], &gap.set, draft))
    })
}

/// Whether an element of these types is in a set.
fn has(rows: &[&'static ElementType], set: &str, draft: &Draft) -> bool {
    let members = draft.element_sets.members(set).unwrap_or_default();
    members.iter().any(|(label, _)| {
        let element = draft.element_by_label.get(label).map(|&index| draft.elements[index].kind);
        rows.iter().any(|&row| element == Some(ElementKind::Structural(row)))
    })
}
