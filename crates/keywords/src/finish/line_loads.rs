//! Loads on lines: beams and trusses take forces per length and, with their area, per volume.

use slideline_diag::{Code, Diagnostic};
use slideline_mech::element::space_beam::section_axes;
use slideline_mech::volume;
use slideline_model::{Dialect, ElementType, Kinematics, NodeIndex};

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

/// Part of the size of a section by which its centroid must be off its nodes to be told [1]. (choice)
const OFF: f64 = 1e-6;

/// Warns that the mass of beams is taken at their nodes where their centroid is elsewhere: its moment is left out.
pub(super) fn weighs_beside(section: &Section, line: &Distributed, draft: &mut Draft) {
    let Body::Beam { shape, .. } = &section.body else { return };
    let [x1, x2] = shape.centroid();
    let off = x1.hypot(x2);
    let is_off = off > OFF * shape.area().sqrt();
    if !is_off || !draft.log.first_time(&format!("weight of {}", section.set)) {
        return;
    }
    let message = format!(
        "the mass of the beams of {} acts at their nodes here, not at their centroid, which is {off:.4e} away: its moment is left out",
        section.set
    );
    let help = "put the nodes on the centroid and join them to the rest with *MPC BEAM, or give the moments with *CLOAD";
    draft.log.push(Diagnostic::warning(Code("SL0432"), message).at(line.origin).help(help));
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
    // a section without axes has been complained of; in the plane axis 1 points into the plane
    let along = |t: [f64; 3]| match row.is_beam() {
        true => [-t[1], t[0], 0.0],
        false => section_axes(t, first_axis).map_or([0.0; 3], |axes| axes[1 + axis]),
    };
    Some(volume::spread_along(&x, |_, t| along(t)))
}
