//! Loads on lines: beams and trusses take forces per length and, with their area, per volume.

use slideline_diag::{Code, Diagnostic};
use slideline_mech::element::space_beam::section_axes;
use slideline_mech::vector::{add, cross, scale, size, sub};
use slideline_mech::volume;
use slideline_model::{Dialect, ElementType, Kinematics, NodeIndex, Shape};

use crate::distributed::{Distributed, Kind};
use crate::draft::{Body, Draft, Section};
use crate::rule::Subject;

/// Whether loads along elements of a row become forces on its nodes alone: those of a cubic beam
/// would be moments too.
pub(super) fn takes_loads(row: &ElementType) -> bool {
    let cubic = Kinematics::Beam { sheared: false };
    row.is_truss() || row.is_space_beam() || (row.is_beam() && row.kinematics != cubic)
}

/// Forces on the nodes of a line at `x` [L] of unit load: per length along an axis, or per volume
/// on an area [L2].
pub(super) fn spread(
    kind: Kind,
    area: f64,
    x: &[[f64; 3]],
    body: impl Fn([f64; 3]) -> [f64; 3],
) -> Vec<[f64; 3]> {
    match kind {
        Kind::Line(axis) => volume::spread_along(x, |_, _| unit(axis)),
        _ => volume::spread_along(x, |at, _| body(at).map(|force| area * force)),
    }
}

fn unit(axis: usize) -> [f64; 3] {
    std::array::from_fn(|k| if k == axis { 1.0 } else { 0.0 })
}

/// Part of the size of a section by which its centroid must be off its nodes, and sine of the angle between that way and the load, to
/// be told [1]. (choice)
const OFF: f64 = 1e-6;

/// Whether the centroid of a section is not at the nodes of its beams.
pub(super) fn is_beside(section: &Section) -> bool {
    match &section.body {
        Body::Beam { shape, .. } => {
            let [x1, x2] = shape.centroid();
            x1.hypot(x2) > OFF * shape.area().sqrt()
        }
        Body::Solid { .. } => false,
    }
}

/// Warns that forces per volume on a beam at `x` [L] act at its nodes where its centroid, which is beside these, gives them a
/// moment or another size.
pub(super) fn acts_beside(
    (section, own_axis): (&Section, Option<[f64; 3]>),
    x: &[[f64; 3]],
    (row, along): (&ElementType, Option<usize>),
    line: &Distributed,
    draft: &mut Draft,
) {
    let Body::Beam { shape, first_axis, .. } = &section.body else { return };
    let first_axis = own_axis.unwrap_or(*first_axis);
    let Some(off) = to_centroid(x, (row, first_axis), shape) else { return };
    let has_moment = |pull: [f64; 3]| size(cross(off, pull)) > OFF * size(off) * size(pull);
    let left_out = match line.kind {
        Kind::Gravity(direction) if has_moment(direction) => "its moment is left out",
        Kind::Body(_) if has_moment(along.map_or([0.0; 3], unit)) => "its moment is left out",
        Kind::Centrifugal(..) => "its other distance from the axis and its moment are left out",
        _ => return,
    };
    if line.value == 0.0
        || size(off) == 0.0
        || !draft.log.first_time(&format!("beside the nodes of {}", section.set))
    {
        return;
    }
    let message = format!(
        "this load acts at the nodes of the beams of {}, not at their centroid, which is {:.4e} away: {left_out}",
        section.set,
        size(off)
    );
    let help = "put the nodes on the centroid: describe the section about it, and join the nodes to the rest with *MPC BEAM";
    draft.log.push(Diagnostic::warning(Code("SL0432"), message).at(line.origin).help(help));
}

/// The way from the nodes of a beam to its centroid [L]; `None` where its section has no axes.
fn to_centroid(
    x: &[[f64; 3]],
    (row, first_axis): (&ElementType, [f64; 3]),
    shape: &Shape,
) -> Option<[f64; 3]> {
    let [x1, x2] = shape.centroid();
    let [first, second] = axes(sub(*x.last()?, *x.first()?), (row, first_axis))?;
    Some(add(scale(first, x1), scale(second, x2)))
}

/// Axes 1 and 2 of the section of a beam along a way; `None`: it has none. In the plane axis 1 points into it, and counts for nothing.
fn axes(way: [f64; 3], (row, first_axis): (&ElementType, [f64; 3])) -> Option<[[f64; 3]; 2]> {
    if row.is_beam() {
        return Some([[0.0; 3], scale([-way[1], way[0], 0.0], 1.0 / size(way))]);
    }
    section_axes(way, first_axis).map(|[_, first, second]| [first, second])
}

/// Forces of a unit force per length along axis 1 or 2 of the section of a beam; `None`, with a
/// complaint, where it leaves the plane or means something else. `own_axis`: axis 1 where the element
/// has one of its own.
pub(super) fn across(
    (nodes, section, row): (&[NodeIndex], &Section, &ElementType),
    own_axis: Option<[f64; 3]>,
    axis: usize,
    line: &Distributed,
    draft: &mut Draft,
) -> Option<Vec<[f64; 3]>> {
    let why = match draft.dialect {
        Dialect::Calculix => Some("is a pressure on the side of the expanded beam in CalculiX"),
        Dialect::Abaqus if axis == 0 && row.is_beam() => Some("acts across the plane of the model"),
        Dialect::Abaqus => None,
    };
    if let Some(why) = why {
        let message = format!("P{} on a {} element {why}: not supported", axis + 1, row.name());
        let error = Diagnostic::error(Code("SL0221"), message).at(line.origin);
        let help = "give the force per length along an axis of the model: PX, PY, PZ";
        draft.consequence(Subject::Elements, error.help(help));
        return None;
    }
    let Body::Beam { first_axis, .. } = section.body else { return None };
    let first_axis = own_axis.unwrap_or(first_axis);
    let x: Vec<[f64; 3]> = nodes.iter().map(|&node| draft.model.nodes.position(node)).collect();
    // a section without axes has been complained of
    let along = |t: [f64; 3]| axes(t, (row, first_axis)).map_or([0.0; 3], |own| own[axis]);
    Some(volume::spread_along(&x, |_, t| along(t)))
}
