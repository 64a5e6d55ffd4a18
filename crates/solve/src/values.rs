//! The numbers of a model, as its solution wants them.
//!
//! ```text
//!   section, material, positions --> kernels     laws, friction, masters --> contact
//!   arms, equations              --> motion      sizes                   --> units
//! ```
//!
//! Taken from a model in the room of those before: a second model of the same outline
//! allocates nothing.

use crate::constraints::Motion;
use crate::contact::Contact;
use crate::loads::FaceLoads;
use crate::plan::{Numbering, Part, PlanMismatch};
use crate::restraint::loose::{Firmness, LooseBodies};
use crate::structure::Kernels;
use crate::users::UserFrictions;
use slideline_model::{ContactPair, Model, SurfaceSegment};

/// What the numbers of a model make of a plan.
#[derive(Debug, Default)]
pub struct Values {
    /// Elements.
    pub kernels: Kernels,
    /// Arms and coefficients of the constraints.
    pub motion: Motion,
    /// Contact: laws, masters and areas, with the dofs that they act on.
    pub contact: Contact,
    /// Faces that are pressed, of every step of the model.
    pub faces: Vec<FaceLoads>,
    /// Largest coordinate of the model [L].
    pub reach: f64,
    /// Length of the stiffest element, or else of the model [L].
    pub lever: f64,
    /// Natural unit of each unknown, for every step of the plan: see
    /// [`Problem::units`](crate::problem::Problem::units).
    pub units: Vec<Vec<f64>>,
    /// How firm loose bodies are, for every step of the model.
    pub loose: Vec<Vec<Firmness>>,
}

impl Values {
    /// Takes those of a model that the plan is of.
    ///
    /// Errors: a section that is none of its elements, a master without extent, a node out of the
    /// plane of a plane model.
    pub fn take(
        &mut self,
        plan: &Numbering,
        model: &Model,
        users: &UserFrictions,
    ) -> Result<(), PlanMismatch> {
        let mismatch = |part| PlanMismatch { part };
        let outside = model.nodes.iter().find(|node| node.position[2] != 0.0);
        if let Some(node) = outside.filter(|_| !model.is_in_space()) {
            return Err(mismatch(Part::OutOfPlane(node.label)));
        }
        let unfit = |block| mismatch(Part::Section(block));
        self.kernels.take(&plan.elements, model, (&[], &[])).map_err(unfit)?;
        for step in model.steps.iter().filter(|step| !step.sections.is_empty()) {
            let mut changed = Kernels::default();
            changed.take(&plan.elements, model, (&[], &step.sections)).map_err(unfit)?;
        }
        if let Some(step) = plan.steps.first() {
            self.motion.take(&step.constraints, model);
        }
        self.contact.take(model, &plan.dofs, users).map_err(Part::Master).map_err(mismatch)?;
        self.faces.clear();
        self.faces.extend(model.steps.iter().map(|step| FaceLoads::new(model, step, &plan.dofs)));
        let positions = model.nodes.iter().flat_map(|node| node.position);
        let all = positions.chain(surface_points(model));
        self.reach = all.fold(0.0, |largest: f64, x| largest.max(x.abs()));
        self.lever = match self.kernels.stiffest_length > 0.0 {
            true => self.kernels.stiffest_length,
            false => self.reach,
        };
        let lever = self.lever;
        self.units.resize_with(plan.steps.len(), Vec::new);
        for (units, step) in self.units.iter_mut().zip(&plan.steps) {
            let unit = |&dof: &usize| match plan.dofs.is_rotation(dof) {
                true if lever > 0.0 => 1.0 / lever,
                _ => 1.0,
            };
            units.clear();
            units.extend(step.constraints.dof_of_equation.iter().map(unit));
        }
        self.take_loose(plan, model);
        Ok(())
    }

    fn take_loose(&mut self, plan: &Numbering, model: &Model) {
        let Self { kernels, loose, lever, .. } = self;
        if plan.loose.iter().all(LooseBodies::is_empty) {
            return loose.clear();
        }
        let others = Firmness { stiffness: kernels.stiffest, length: *lever };
        loose.resize_with(plan.loose.len(), Vec::new);
        for (into, bodies) in loose.iter_mut().zip(&plan.loose).filter(|own| !own.1.is_empty()) {
            let elements = kernels.scales(&plan.elements).map(|(place, scale)| {
                let (stiffness, length) = (scale.stiffness, scale.length.unwrap_or(others.length));
                (place, Firmness { stiffness, length })
            });
            bodies.firmness(model, elements, (others, into));
        }
    }
}

/// Coordinates of the points of all rigid surfaces.
fn surface_points(model: &Model) -> impl Iterator<Item = f64> {
    let surfaces = model.contact_pairs.iter().flat_map(ContactPair::rigid_surfaces);
    surfaces.flat_map(|surface| {
        let ends = surface.segments.iter().flat_map(|segment| match *segment {
            SurfaceSegment::Line { end } => [end, end],
            SurfaceSegment::Circle { end, centre } => [end, centre],
            SurfaceSegment::Parabola { middle, end } => [middle, end],
        });
        std::iter::once(surface.start).chain(ends).flatten()
    })
}
