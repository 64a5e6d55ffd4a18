//! The elements of a step, each with its own slot for force and tangent.
//!
//! ```text
//!   u --> element 1 --> [force | tangent]  \
//!   u --> element 2 --> [force | tangent]   >-- gather in fixed order --> f, K
//!   u --> element 3 --> [force | tangent]  /
//! ```
//!
//! Elements write slots of their own and a gather in fixed order sums them,
//! so that the sum has the same bits on any number of threads.

use crate::layout::{Carried, Layout};
use rayon::ThreadPool;
use rayon::prelude::*;
use slideline_linalg::Pattern;
use slideline_mech::element::{AxialSpring, Beam21, GroundSpring};
use slideline_mech::rigid::{Attachment, PointMap, push_forward};
use slideline_mech::section::{Rectangle, TransverseShear, rectangle_stiffness};
use slideline_model::{BeamBlock, Dof, ElementBlock, Model, NodeIndex, SpringBlock, SpringKind};

/// The most dofs an element has.
const WIDTH: usize = 6;
/// From this number of elements on, threads pay.
const PARALLEL: usize = 2000;

#[derive(Clone, Debug)]
enum Shape {
    Beam(Beam21),
    /// A spring to the ground and which of the element's variables it acts on.
    Ground(GroundSpring, usize),
    Axial(AxialSpring),
}

/// One element with its places in the full vector.
#[derive(Clone, Debug)]
struct Placed {
    shape: Shape,
    /// Number of its own variables.
    variables: usize,
    /// Slots of its own variables.
    own: [usize; WIDTH],
    /// Number of dofs its force goes to.
    width: usize,
    /// Slots its force goes to: those of the nodes that carry its own.
    targets: [usize; WIDTH],
    /// How its variables follow the carriers; empty where none is dependent.
    attachments: Vec<Attachment>,
    /// Place of each tangent entry in the matrix values; `usize::MAX`: none.
    entries: [usize; WIDTH * WIDTH],
}

/// A beam as output wants to see it.
#[derive(Clone, Debug)]
pub struct BeamReport {
    /// Place among the structure's elements.
    element: usize,
    /// Element label.
    pub label: u64,
    /// Its nodes.
    pub nodes: [NodeIndex; 2],
    /// Half its height [L].
    pub half_height: f64,
}

/// All elements of a step.
#[derive(Clone, Debug)]
pub struct Structure {
    elements: Vec<Placed>,
    beams: Vec<BeamReport>,
    nlgeom: bool,
    /// Largest EA/l [F/L], for the rounding floor of the residual.
    pub stiffest: f64,
    /// Length of the element that has it [L].
    pub stiffest_length: f64,
}

/// One element's contribution.
#[derive(Clone, Copy, Debug)]
pub struct Contribution {
    force: [f64; WIDTH],
    tangent: [f64; WIDTH * WIDTH],
    energy: f64,
}

impl Contribution {
    /// Nothing.
    pub const ZERO: Self = Self { force: [0.0; WIDTH], tangent: [0.0; WIDTH * WIDTH], energy: 0.0 };
}

impl Structure {
    /// Places every element that is not rigid as a whole.
    pub fn new(model: &Model, layout: &Layout, nlgeom: bool) -> Self {
        let mut structure = Self {
            elements: Vec::new(),
            beams: Vec::new(),
            nlgeom,
            stiffest: 0.0,
            stiffest_length: 0.0,
        };
        for block in &model.blocks {
            match block {
                ElementBlock::B21(block) => structure.place_beams(model, layout, block),
                ElementBlock::Spring(block) => structure.place_springs(model, layout, block),
            }
        }
        structure
    }

    fn place_beams(&mut self, model: &Model, layout: &Layout, block: &BeamBlock) {
        let section = &block.section;
        let rectangle =
            Rectangle { width: section.width, height: section.height, poisson: section.poisson };
        let shear = TransverseShear {
            slenderness: section.shear.slenderness_compensation,
            given: section.shear.stiffness,
            ..TransverseShear::default()
        };
        for element in &block.elements {
            let ends = element.nodes.map(|node| layout.carried_node(model, node));
            if ends[0].node == ends[1].node {
                continue; // both ends belong to one rigid body: nothing to strain
            }
            let reference = ends.map(|end| end.reference);
            let length = distance(reference[0], reference[1]);
            let stiffness = rectangle_stiffness(&rectangle, &section.material, &shear, length);
            let axial = stiffness.axial / length;
            if axial > self.stiffest {
                (self.stiffest, self.stiffest_length) = (axial, length);
            }
            let shape = Shape::Beam(Beam21::new(reference, stiffness));
            self.beams.push(BeamReport {
                element: self.elements.len(),
                label: element.label,
                nodes: element.nodes,
                half_height: 0.5 * section.height,
            });
            self.elements.push(place(layout, shape, &element.nodes, &ends, &Dof::PLANE));
        }
    }

    fn place_springs(&mut self, model: &Model, layout: &Layout, block: &SpringBlock) {
        let stiffness = block.stiffness;
        self.stiffest = self.stiffest.max(stiffness.abs());
        for element in &block.elements {
            let ends = element.nodes.map(|node| layout.carried_node(model, node));
            let placed = match block.kind {
                SpringKind::Ground(dof) => {
                    let dofs: &[Dof] =
                        if dof.is_rotation() { &[Dof::UR3] } else { &[Dof::U1, Dof::U2] };
                    let component = dofs.iter().position(|&own| own == dof).unwrap_or(0);
                    let shape = Shape::Ground(GroundSpring { stiffness }, component);
                    place(layout, shape, &element.nodes[..1], &ends[..1], dofs)
                }
                SpringKind::Axial => {
                    let reference = ends.map(|end| end.reference);
                    let shape = Shape::Axial(AxialSpring { reference, stiffness });
                    place(layout, shape, &element.nodes, &ends, &[Dof::U1, Dof::U2])
                }
            };
            self.elements.push(placed);
        }
    }

    /// Sets of slots that couple.
    pub fn cliques(&self) -> impl Iterator<Item = &[usize]> {
        self.elements.iter().map(|element| &element.targets[..element.width])
    }

    /// Finds every tangent entry's place in the matrix.
    pub fn find_entries(&mut self, layout: &Layout, pattern: &Pattern) {
        for element in &mut self.elements {
            let width = element.width;
            for i in 0..width {
                for j in 0..width {
                    let row = layout.equation(element.targets[i]);
                    let column = layout.equation(element.targets[j]);
                    element.entries[i * WIDTH + j] = match (row, column) {
                        (Some(row), Some(column)) => {
                            pattern.position(row, column).unwrap_or(usize::MAX)
                        }
                        _ => usize::MAX,
                    };
                }
            }
        }
    }

    /// Number of elements.
    pub fn len(&self) -> usize {
        self.elements.len()
    }

    /// Whether each slot belongs to an element (rounding grows with those).
    pub fn touched(&self, slots: usize) -> Vec<bool> {
        let mut touched = vec![false; slots];
        for element in &self.elements {
            for &slot in &element.targets[..element.width] {
                touched[slot] = true;
            }
        }
        touched
    }

    /// Evaluates every element at displacements `u`, each into its own place.
    pub fn evaluate(&self, u: &[f64], into: &mut [Contribution], pool: Option<&ThreadPool>) {
        let one = |(element, into): (&Placed, &mut Contribution)| {
            element.evaluate(u, self.nlgeom, into);
        };
        match pool.filter(|_| self.elements.len() >= PARALLEL) {
            Some(pool) => pool.install(|| self.elements.par_iter().zip(into).for_each(one)),
            None => self.elements.iter().zip(into).for_each(one),
        }
    }

    /// Sums forces into the full vector; returns the strain energy [F L].
    pub fn gather_force(&self, from: &[Contribution], force: &mut [f64]) -> f64 {
        let mut energy = 0.0;
        for (element, contribution) in self.elements.iter().zip(from) {
            for (&slot, value) in element.targets[..element.width].iter().zip(contribution.force) {
                force[slot] += value;
            }
            energy += contribution.energy;
        }
        energy
    }

    /// Sums tangents into the matrix values.
    pub fn gather_tangent(&self, from: &[Contribution], values: &mut [f64]) {
        for (element, contribution) in self.elements.iter().zip(from) {
            for (&entry, value) in element.entries.iter().zip(contribution.tangent) {
                if let Some(sum) = values.get_mut(entry) {
                    *sum += value;
                }
            }
        }
    }

    /// Sums K v for a full vector v of slots into `product` (a first guess of
    /// what a prescribed motion does).
    pub fn multiply(&self, from: &[Contribution], v: &[f64], product: &mut [f64]) {
        for (element, contribution) in self.elements.iter().zip(from) {
            for i in 0..element.width {
                let row = &contribution.tangent[i * WIDTH..][..element.width];
                let sum: f64 = row.iter().zip(element.targets).map(|(k, slot)| k * v[slot]).sum();
                product[element.targets[i]] += sum;
            }
        }
    }

    /// Mean magnitude of the nodal forces and of the nodal moments of all
    /// elements, with the number of nodal vectors counted: the flux q.
    pub fn flux(&self, from: &[Contribution]) -> Flux {
        let mut flux = Flux::default();
        for (element, contribution) in self.elements.iter().zip(from) {
            let f = &contribution.force;
            match &element.shape {
                Shape::Beam(_) => {
                    flux.force(f[0].hypot(f[1]));
                    flux.force(f[3].hypot(f[4]));
                    flux.moment(f[2].abs());
                    flux.moment(f[5].abs());
                }
                Shape::Axial(_) => {
                    flux.force(f[0].hypot(f[1]));
                    flux.force(f[2].hypot(f[3]));
                }
                Shape::Ground(_, component) => flux.force(f[*component].abs()),
            }
        }
        flux
    }

    /// Section results of every beam.
    pub fn beam_rows<'a>(
        &'a self,
        u: &'a [f64],
    ) -> impl Iterator<Item = crate::observe::BeamRow> + 'a {
        self.beams.iter().map(move |beam| {
            let placed = &self.elements[beam.element];
            let q = placed.own.map(|slot| u[slot]);
            let mut row = crate::observe::BeamRow {
                label: beam.label,
                nodes: beam.nodes,
                ..crate::observe::BeamRow::default()
            };
            if let Shape::Beam(element) = &placed.shape {
                let strains =
                    if self.nlgeom { element.strains(&q) } else { element.linear_strains(&q) };
                let stiffness = element.stiffness;
                row.axial_force = stiffness.axial * strains.axial;
                row.shear_force = stiffness.shear * strains.shear;
                row.bending_moment = stiffness.bending * strains.curvature;
                row.strains = [strains.axial, strains.shear, strains.curvature];
                row.fibre_strain = strains.axial.abs() + strains.curvature.abs() * beam.half_height;
            }
            row
        })
    }
}

/// Mean nodal force and moment.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Flux {
    force: (f64, f64),
    moment: (f64, f64),
}

impl Flux {
    /// Counts a nodal force [F].
    pub fn force(&mut self, magnitude: f64) {
        self.force = (self.force.0 + magnitude, self.force.1 + 1.0);
    }

    /// Counts a nodal moment [F L].
    pub fn moment(&mut self, magnitude: f64) {
        self.moment = (self.moment.0 + magnitude, self.moment.1 + 1.0);
    }

    /// Mean force [F].
    pub fn mean_force(&self) -> f64 {
        if self.force.1 > 0.0 { self.force.0 / self.force.1 } else { 0.0 }
    }

    /// Mean moment [F L].
    pub fn mean_moment(&self) -> f64 {
        if self.moment.1 > 0.0 { self.moment.0 / self.moment.1 } else { 0.0 }
    }
}

impl Placed {
    fn evaluate(&self, u: &[f64], nlgeom: bool, into: &mut Contribution) {
        match &self.shape {
            Shape::Beam(beam) => {
                let q = self.own.map(|slot| u[slot]);
                let Contribution { force, tangent, .. } = into;
                into.energy = if nlgeom {
                    beam.force_and_tangent(&q, force, tangent)
                } else {
                    beam.linear_force_and_tangent(&q, force, tangent)
                };
            }
            Shape::Ground(spring, component) => {
                let displacement = u[self.own[*component]];
                let (force, stiffness) = spring.force_and_tangent(displacement);
                into.force[*component] = force;
                into.tangent[component * (WIDTH + 1)] = stiffness;
                into.energy = spring.energy(displacement);
            }
            Shape::Axial(spring) => evaluate_axial(spring, &self.own, u, nlgeom, into),
        }
        if !self.attachments.is_empty() {
            self.carry(u, into);
        }
    }

    /// Hands force and tangent of dependent nodes to their masters.
    fn carry(&self, u: &[f64], into: &mut Contribution) {
        let (n, m) = (self.variables, self.width);
        let dofs = self.targets.map(|slot| u[slot]);
        let gradient = into.force;
        let mut hessian = [0.0; WIDTH * WIDTH];
        for i in 0..n {
            hessian[n * i..][..n].copy_from_slice(&into.tangent[WIDTH * i..][..n]);
        }
        let (mut force, mut tangent) = ([0.0; WIDTH], [0.0; WIDTH * WIDTH]);
        push_forward(
            &self.attachments,
            &dofs[..m],
            &gradient[..n],
            &hessian[..n * n],
            &mut force,
            &mut tangent,
        );
        into.force = force;
        for i in 0..m {
            into.tangent[WIDTH * i..][..m].copy_from_slice(&tangent[m * i..][..m]);
        }
    }
}

fn evaluate_axial(
    spring: &AxialSpring,
    own: &[usize; WIDTH],
    u: &[f64],
    nlgeom: bool,
    into: &mut Contribution,
) {
    let q = [u[own[0]], u[own[1]], u[own[2]], u[own[3]]];
    let (mut force, mut tangent) = ([0.0; 4], [0.0; 16]);
    into.energy = if nlgeom {
        spring.force_and_tangent(&q, &mut force, &mut tangent)
    } else {
        spring.linear_force_and_tangent(&q, &mut force, &mut tangent)
    };
    into.force[..4].copy_from_slice(&force);
    for i in 0..4 {
        into.tangent[i * WIDTH..][..4].copy_from_slice(&tangent[4 * i..][..4]);
    }
}

fn place(
    layout: &Layout,
    shape: Shape,
    nodes: &[NodeIndex],
    ends: &[Carried],
    dofs: &[Dof],
) -> Placed {
    let mut placed = Placed {
        shape,
        variables: 0,
        own: [0; WIDTH],
        width: 0,
        targets: [0; WIDTH],
        attachments: Vec::new(),
        entries: [usize::MAX; WIDTH * WIDTH],
    };
    let dependent = ends.iter().any(|end| matches!(end.map, PointMap::Arm { .. }));
    let carrier_dofs = if dependent { layout.dofs } else { dofs };
    for (&node, end) in nodes.iter().zip(ends) {
        if dependent {
            placed.attachments.extend(attach(dofs, end.map, placed.width));
        }
        for slot in dofs.iter().filter_map(|&dof| layout.slot(node, dof)) {
            placed.own[placed.variables] = slot;
            placed.variables += 1;
        }
        for slot in carrier_dofs.iter().filter_map(|&dof| layout.slot(end.node, dof)) {
            placed.targets[placed.width] = slot;
            placed.width += 1;
        }
    }
    placed
}

/// How the variables `dofs` of a node follow the dofs of its carrier, the
/// first of which stands at `first`.
fn attach(dofs: &[Dof], map: PointMap, first: usize) -> Vec<Attachment> {
    let point = dofs.contains(&Dof::U1).then_some(Attachment::Point { map, first });
    let rotation = dofs.contains(&Dof::UR3).then_some(Attachment::Rotation { dof: first + 2 });
    point.into_iter().chain(rotation).collect()
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}
