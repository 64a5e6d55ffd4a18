//! A step, prepared once: numbering, pattern, symbolic factorisation.

use crate::contact::Contact;
use crate::layout::{Layout, Role};
use crate::structure::Structure;
use crate::users::UserFrictions;
use rayon::ThreadPool;
use slideline_linalg::{Kind, Pattern, Solver, analyse};
use slideline_mech::contact::pair::Laws;
use slideline_model::{Amplitude, Master, Model, Step, SurfaceSegment};

/// Everything about a step that does not change from increment to increment.
pub struct Plan<'a> {
    /// The model.
    pub model: &'a Model,
    /// The step.
    pub step: &'a Step,
    /// Numbering.
    pub layout: Layout,
    /// Elements.
    pub structure: Structure,
    /// Contact.
    pub contact: Contact,
    /// Sparsity of the tangent.
    pub pattern: Pattern,
    /// Slots that belong to elements.
    pub elastic: Vec<bool>,
    /// Largest coordinate of the model [L].
    pub reach: f64,
    /// Threads for element loops; none: this one.
    pub pool: Option<&'a ThreadPool>,
    start: Vec<f64>,
    start_load: Vec<f64>,
}

impl<'a> Plan<'a> {
    /// Prepares a step that begins at the displacements and loads given.
    pub fn new(
        model: &'a Model,
        step: &'a Step,
        (start, start_load): (&[f64], &[f64]),
        users: &UserFrictions,
        pool: Option<&'a ThreadPool>,
    ) -> Self {
        let layout = Layout::new(model, step);
        let mut structure = Structure::new(model, &layout, step.nlgeom);
        let contact = Contact::new(model, &layout, users);
        let equations = |slots: &[usize]| -> Vec<usize> {
            slots.iter().filter_map(|&slot| layout.equation(slot)).collect()
        };
        let contact_cliques = contact.cliques();
        let cliques =
            structure.cliques().chain(contact_cliques.iter().map(Vec::as_slice)).map(equations);
        let pattern = Pattern::from_cliques(layout.equations(), cliques);
        structure.find_entries(&layout, &pattern);
        let elastic = structure.touched(layout.slots());
        let reach = model
            .nodes
            .iter()
            .flat_map(|node| node.position)
            .chain(surface_points(model))
            .fold(0.0, |largest: f64, x| largest.max(x.abs()));
        let (start, start_load) = (start.to_vec(), start_load.to_vec());
        Self {
            model,
            step,
            layout,
            structure,
            contact,
            pattern,
            elastic,
            reach,
            pool,
            start,
            start_load,
        }
    }

    /// Displacements and loads at the beginning of the step.
    pub fn start(&self) -> (&[f64], &[f64]) {
        (&self.start, &self.start_load)
    }

    /// Symbolic factorisation: unsymmetric where there is friction, unless
    /// the deck says `UNSYMM=NO`.
    pub fn analyse(&self) -> Solver {
        analyse(&self.pattern, if self.unsymmetric() { Kind::Unsymmetric } else { Kind::Symmetric })
    }

    /// Whether the tangent is factored as an unsymmetric matrix.
    pub fn unsymmetric(&self) -> bool {
        match self.step.unsymmetric {
            Some(said) => said,
            None => self.contact.laws.iter().any(Laws::has_friction),
        }
    }

    /// Whether friction is there and the deck wants a symmetric tangent.
    pub fn symmetrised(&self) -> bool {
        self.step.unsymmetric == Some(false) && self.contact.laws.iter().any(Laws::has_friction)
    }

    /// Replaces matrix values by their symmetric part.
    pub fn symmetrise(&self, values: &mut [f64]) {
        for i in 0..self.pattern.size() {
            let start = self.pattern.row_start()[i];
            for (k, &j) in self.pattern.row(i).iter().enumerate().filter(|&(_, &j)| j > i) {
                let Some(mirrored) = self.pattern.position(j, i) else { continue };
                let mean = 0.5 * (values[start + k] + values[mirrored]);
                values[start + k] = mean;
                values[mirrored] = mean;
            }
        }
    }

    /// Average length of the contact elements of a pair [L].
    pub fn contact_length(&self, pair: &slideline_model::ContactPair) -> f64 {
        crate::contact::average_element(self.model, pair)
    }

    /// Puts the prescribed values of a time of the step into `u`.
    pub fn prescribe(&self, step_time: f64, u: &mut [f64]) {
        for (slot, role) in self.layout.roles.iter().enumerate() {
            if let Role::Prescribed(place) = *role {
                let prescribed = &self.step.prescribed[place];
                let amplitude = prescribed.amplitude.map(|a| &self.model.amplitudes[a]);
                u[slot] = self.at(step_time, self.start[slot], prescribed.value, amplitude);
            }
        }
    }

    /// Puts the loads of a time of the step into `load`.
    pub fn load(&self, step_time: f64, load: &mut [f64]) {
        load.fill(0.0);
        for (slot, value) in load.iter_mut().enumerate() {
            // What the step before applied and this one does not fades out.
            *value = self.at(step_time, self.start_load[slot], 0.0, None);
        }
        for entry in &self.step.loads {
            let Some(slot) = self.layout.slot(entry.node, entry.dof) else { continue };
            let amplitude = entry.amplitude.map(|a| &self.model.amplitudes[a]);
            load[slot] = self.at(step_time, self.start_load[slot], entry.value, amplitude);
        }
    }

    /// A value between the start of the step and its end.
    fn at(&self, step_time: f64, start: f64, end: f64, amplitude: Option<&Amplitude>) -> f64 {
        let period = self.step.procedure.period;
        match amplitude {
            Some(amplitude) => end * amplitude.at(step_time),
            None if self.step.at_once || step_time >= period => end,
            None => start + (end - start) * (step_time / period),
        }
    }
}

/// Coordinates of the points of all rigid surfaces.
fn surface_points(model: &Model) -> impl Iterator<Item = f64> {
    let surfaces = model.contact_pairs.iter().filter_map(|pair| match &pair.master {
        Master::RigidSurface(surface) => Some(surface),
        Master::SlideLine(_) => None,
    });
    surfaces.flat_map(|surface| {
        let ends = surface.segments.iter().flat_map(|segment| match *segment {
            SurfaceSegment::Line { end } => [end, end],
            SurfaceSegment::Circle { end, centre } => [end, centre],
            SurfaceSegment::Parabola { middle, end } => [middle, end],
        });
        std::iter::once(surface.start).chain(ends).flatten()
    })
}
