//! Slave points against their masters in one configuration, in dofs.
//!
//! ```text
//!   kernel variables (point, control points, rotation)
//!        |  attachments: how each follows dofs
//!   dofs of the state vector: h, sigma, directions and their gradients
//! ```

use super::edge_crossings::sides::PlacedSides;
use super::facing::Facing;
use super::mortar::rooms::{MortarRooms, MortarScratch};
use super::mortar_faces::rooms::{FaceMortarRooms, FaceScratch};
use super::operator::{ContactOperator, OperatorRows, OperatorRowsMut};
use super::shear::{Shear, TURNS};
use super::stencil::Stencil;
use slideline_mech::contact::gap::Linear;
use slideline_mech::contact::pair::{AnyGap, FaceRoom, Footing};
use slideline_mech::contact::tangential::Tangential;
use slideline_mech::rigid::push_gradients;
use std::ops::Deref;

/// All slave points against their masters in one configuration.
#[derive(Clone, Debug, Default)]
pub struct ContactKinematics {
    points: Vec<PointKinematics>,
    operator: ContactOperator,
    pub(super) room: FaceRoom,
    pub(super) unknowns: Vec<usize>,
    pub(super) mortars: Vec<MortarRooms>,
    pub(super) face_mortars: Vec<FaceMortarRooms>,
    pub(super) crossings: Vec<PlacedSides>,
}

/// A slave point against its master.
#[derive(Clone, Copy, Debug)]
pub struct PointKinematics {
    /// Whether it faces its master at all.
    pub faces: bool,
    /// Overclosure beyond what is allowed [L]; minus infinity where it faces nothing.
    pub overclosure: f64,
    /// What is allowed [L].
    pub allowed: f64,
    /// How far it stands behind a master to which it came beyond an end of that; zero of all others [L].
    pub behind: f64,
    /// Coordinates along the master [L].
    pub along: Tangential,
    /// Outward normal of the master [1].
    pub normal: [f64; 3],
    /// Position of the point [L].
    pub position: [f64; 3],
    /// Area it stands for [L2].
    pub area: f64,
    /// Where an integration point stands on its element, 0 to 1.
    pub xi: f64,
    /// What it faces.
    pub(super) facing: Option<Facing>,
    /// Where it would stand on faces, were this state committed.
    pub footing: Option<Footing>,
}

/// A point with its rows over dofs.
#[derive(Clone, Copy, Debug)]
pub struct PointRows<'a> {
    point: &'a PointKinematics,
    /// Its rows.
    pub rows: OperatorRows<'a>,
    /// Where the faces of all mortars stand.
    pub(super) mortars: &'a [MortarRooms],
    pub(super) face_mortars: &'a [FaceMortarRooms],
}

impl Deref for PointRows<'_> {
    type Target = PointKinematics;

    fn deref(&self) -> &PointKinematics {
        self.point
    }
}

/// A point with its rows, to be written.
pub(super) struct PointRowsMut<'a> {
    pub point: &'a mut PointKinematics,
    pub rows: OperatorRowsMut<'a>,
}

impl ContactKinematics {
    /// Points that face nothing, each with room for so many dofs.
    pub fn nowhere(points: usize, room: usize, directions: usize) -> Self {
        let mut new = Self::default();
        new.forget(points, room, directions);
        new
    }

    /// Becomes such ones, in the room they have.
    pub fn forget(&mut self, points: usize, room: usize, directions: usize) {
        self.points.clear();
        self.points.resize(points, PointKinematics::NOWHERE);
        self.forget_places();
        self.crossings.clear();
        self.operator.fit(points, room, directions);
    }

    /// Forgets where faces stood at the last commit: those of another model may have stood elsewhere at the
    /// same displacements.
    pub fn forget_places(&mut self) {
        self.mortars.iter_mut().for_each(MortarRooms::forget);
        self.face_mortars.iter_mut().for_each(FaceMortarRooms::forget);
    }

    /// A point with its rows.
    pub fn at(&self, place: usize) -> PointRows<'_> {
        let (point, rows) = (&self.points[place], self.operator.rows(place));
        PointRows { point, rows, mortars: &self.mortars, face_mortars: &self.face_mortars }
    }

    pub(super) fn at_mut(&mut self, place: usize) -> PointRowsMut<'_> {
        PointRowsMut { point: &mut self.points[place], rows: self.operator.rows_mut(place) }
    }

    /// The points, without their rows.
    pub fn points(&self) -> &[PointKinematics] {
        &self.points
    }

    /// The same, to be written.
    pub fn points_mut(&mut self) -> &mut [PointKinematics] {
        &mut self.points
    }

    /// All points with their rows.
    pub fn iter(&self) -> impl Iterator<Item = PointRows<'_>> {
        (0..self.points.len()).map(|place| self.at(place))
    }

    /// Takes over another configuration.
    pub fn copy_from(&mut self, other: &Self) {
        self.points.clone_from(&other.points);
        self.operator.copy_from(&other.operator);
        self.mortars.clone_from(&other.mortars);
        self.face_mortars.clone_from(&other.face_mortars);
    }

    /// Makes room for so many dofs at every point.
    pub(super) fn make_room(&mut self, unknowns: usize) {
        self.operator.make_room(unknowns);
    }
}

impl PointKinematics {
    /// A point that faces nothing.
    pub const NOWHERE: Self = Self {
        faces: false,
        overclosure: f64::NEG_INFINITY,
        allowed: 0.0,
        behind: 0.0,
        along: Tangential::ZERO,
        normal: [0.0; 3],
        position: [0.0; 3],
        area: 0.0,
        xi: 0.0,
        facing: None,
        footing: None,
    };
}

impl PointKinematics {
    /// The face of its master, or the segment of a line of nodes or a rigid surface, on which it stands; `None` where it
    /// faces none of them.
    pub fn stands_on(&self) -> Option<usize> {
        let face = self.footing.filter(|_| self.faces).map(|footing| footing.place.face);
        face.or_else(|| self.segment())
    }

    /// The segment of a line of master nodes or of a rigid surface on which it stands.
    pub fn segment(&self) -> Option<usize> {
        self.facing.filter(|_| self.faces)?.segment()
    }

    /// Takes off what is allowed of an overclosure that was just found [L].
    pub(super) fn allow(&mut self, allowed: f64) {
        self.allowed = allowed;
        self.overclosure -= allowed;
    }

    /// Takes a gap in.
    pub(super) fn take(&mut self, gap: &AnyGap<Linear>, facing: Facing, along: Tangential) {
        self.faces = true;
        self.overclosure = gap.overclosure();
        self.along = along;
        self.normal = gap.normal();
        self.facing = Some(facing);
    }
}

impl PointRows<'_> {
    /// Adds the force of a pressure and a traction on the point to a vector of all dofs [F].
    pub fn press(&self, pressure: f64, traction: Tangential, into: &mut [f64]) {
        let (normal, tangential) = (self.area * pressure, self.area * traction);
        self.push(normal, tangential, into);
    }

    /// Adds the forces of a normal and a tangential force on the point [F].
    pub fn push(&self, normal: f64, tangential: Tangential, into: &mut [f64]) {
        let rows = &self.rows;
        match rows.directions() {
            1 => {
                let forces = rows.normal().iter().zip(rows.force(0));
                for (&dof, (n, t)) in rows.unknowns.iter().zip(forces) {
                    into[dof] += normal * n + tangential[0] * t;
                }
            }
            _ => {
                for (k, &dof) in rows.unknowns.iter().enumerate() {
                    into[dof] += normal * rows.normal()[k]
                        + tangential[0] * rows.force(0)[k]
                        + tangential[1] * rows.force(1)[k];
                }
            }
        }
    }
}

impl PointRowsMut<'_> {
    /// The point faces nothing and stands for nothing.
    pub fn turn_away(&mut self) {
        self.turn_away_in_place();
        self.point.area = 0.0;
    }

    /// The point faces nothing, and stands for what it stood for.
    pub fn turn_away_in_place(&mut self) {
        self.point.faces = false;
        self.point.facing = None;
        self.point.footing = None;
        self.point.behind = 0.0;
        (self.point.overclosure, self.point.allowed) = (f64::NEG_INFINITY, 0.0);
        self.rows.clear();
    }

    /// Pushes the gradients of a gap from kernel variables to dofs.
    pub fn take(&mut self, gap: &AnyGap<Linear>, stencil: &Stencil<'_>, u: &[f64]) {
        let further = stencil.shear.map_or(&[][..], |shear| &shear.further);
        let (direct, from) = (stencil.dofs(), gap.derivatives());
        let count = direct.len() + further.len();
        let rows = match further.is_empty() {
            true => self.rows.start(direct),
            false => self.rows.start(&stencil.with_further()[..count]),
        };
        let gradients = [from.gradient, from.slip_gradient, from.direction];
        push_gradients(
            stencil.attachments(),
            stencil.values(),
            (&gradients, from.gradient.len()),
            (rows, count.max(1)),
        );
        if let Some(shear) = stencil.shear {
            self.follow_shear(shear, u);
        }
        if stencil.offset.slave != 0.0 {
            self.follow_section(stencil);
        }
    }

    /// Slip and friction of a surface that stands off its line follow the rotation of the section:
    /// docs/theory.md eq. (5.45).
    fn follow_section(&mut self, stencil: &Stencil<'_>) {
        let count = self.rows.unknowns().len();
        for (dof, weight) in stencil.section {
            let Some(place) = self.rows.unknowns().iter().position(|&own| own == dof) else {
                continue;
            };
            let arm = weight * stencil.offset.slave;
            let tangential = self.rows.values().chunks_exact_mut(count).skip(1);
            tangential.for_each(|row| row[place] += arm);
        }
    }

    /// Derivatives by the turns of a segment's ends become derivatives by all
    /// dofs that shear follows.
    fn follow_shear(&mut self, shear: &Shear, u: &[f64]) {
        let by_end = shear.gradients(self.rows.unknowns(), u);
        let count = self.rows.unknowns().len();
        for derivative in self.rows.values().chunks_exact_mut(count) {
            let by_turn = TURNS.map(|turn| derivative[turn]);
            for (factor, gradient) in by_turn.into_iter().zip(&by_end) {
                derivative.iter_mut().zip(gradient).for_each(|(sum, g)| *sum += factor * g);
            }
        }
    }
}

/// Scratch of [`Contact::geometric_tangent`](super::Contact::geometric_tangent).
#[derive(Clone, Debug, Default)]
pub struct GeometryScratch {
    /// The tangent, row-major.
    pub tangent: Vec<f64>,
    /// The same by the dofs that the gap follows directly, those of shear left out.
    pub(super) direct: Vec<f64>,
    pub(super) force: Vec<f64>,
    pub(super) room: FaceRoom,
    pub(super) kernel: Vec<f64>,
    pub(super) mortar: MortarScratch,
    pub(super) face_mortar: FaceScratch,
    /// Columns of a point by dof.
    pub(super) columns: Vec<usize>,
}
