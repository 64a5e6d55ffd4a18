//! Solids: cell x quadrature x kinematics x formulation x material, one kernel.
//!
//! ```text
//!    4-------3        displacements q --> H = du/dX at every integration point
//!    | x   x |                              |  formulation: mean dilation, incompatible modes,
//!    | x   x |                              v  hourglass control, or none
//!    1-------2        material: stress tau, moduli c, state
//!                                           |
//!                                           v
//!        force  sum w tau : grad,   tangent  sum w grad : (c + 1 tau) : grad
//! ```
//!
//! grad: derivatives by position in the deformed body, w: undeformed volume of a point;
//! docs/theory.md section 3.5. Small displacements are the same with F = 1 and without the stress
//! in the tangent. Generic in the dimension `D`, the nodes `N` and the points `P`.

mod gather;
mod heat;
mod incompatible;
mod mean_dilation;
mod modes;
mod place;
mod plane_stress;
mod point;
mod results;

pub use heat::Interpolation;
pub use place::{Reference, smallest_jacobian};
pub use results::Told;

use super::cell::Cell;
use super::kernel::{Failure, Kernel, Response, Scale, Surroundings};
use super::quadrature::{HEX_8, QUAD_4, Quadrature};
use crate::material::Material;
use crate::orientation::Orientation;
use incompatible::Centre;
use place::{Place, Tables};
use point::{Point, States};

/// How strains follow displacements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kinematics {
    /// Nothing moves across the plane.
    PlaneStrain,
    /// No stress across the plane.
    PlaneStress,
    /// A ring about the second axis, the first coordinate its radius.
    Axisymmetric,
    /// Three dimensions.
    Space,
}

/// What is done about locking, or about too few points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Formulation {
    /// Nothing.
    Plain,
    /// One change of volume for all points, that of the element: no locking of next to
    /// incompressible materials.
    MeanDilation,
    /// Transposed incompatible modes, eliminated in the element: bending without locking.
    Incompatible,
    /// One point, held against its hourglass modes with the stiffness of elastic bending.
    Hourglass,
    /// The same with the small stiffness that CalculiX has, .032 E V sum (dN/dX)^2.
    SoftHourglass,
}

impl Formulation {
    /// Whether one point is held against hourglass modes.
    pub fn is_one_point(self) -> bool {
        matches!(self, Self::Hourglass | Self::SoftHourglass)
    }
}

/// What the elements of a block have in common.
#[derive(Debug, Clone, PartialEq)]
pub struct Recipe {
    /// Reference cell.
    pub cell: &'static Cell,
    /// Where it is integrated.
    pub rule: &'static Quadrature,
    /// How strains follow displacements.
    pub kinematics: Kinematics,
    /// What is done about locking.
    pub formulation: Formulation,
    /// Material.
    pub material: Material,
    /// Thickness out of the plane [L]; of no meaning elsewhere.
    pub thickness: f64,
    /// Strains as results tell them.
    pub told: Told,
    /// Axes of the material; `None`: those of the model.
    pub orientation: Option<Orientation>,
    /// How temperatures go from nodes to points.
    pub temperatures: Interpolation,
}

/// Number of state variables of an element with that many points.
pub fn states(
    (cell, rule): (&Cell, &Quadrature),
    (kinematics, formulation): (Kinematics, Formulation),
    material: &Material,
) -> usize {
    let across = usize::from(kinematics == Kinematics::PlaneStress);
    let modes = if formulation == Formulation::Incompatible { cell.dimension.pow(2) } else { 0 };
    rule.points.len() * (material.states() + across) + modes
}

/// The solids of a block.
#[derive(Debug, Clone)]
pub struct Solids<const D: usize, const N: usize, const P: usize> {
    recipe: Recipe,
    tables: Box<Tables<D, N, P>>,
    /// What the temperature of every node counts at every point.
    heat: Box<[[f64; N]; P]>,
    /// Means of the shape functions over the section of every ring of one point; none of others.
    means: Vec<[f64; N]>,
    elements: Vec<[[f64; D]; N]>,
    /// Their points before any displacement.
    places: Vec<[Place<D, N>; P]>,
    /// Their centres, where they have incompatible modes.
    centres: Vec<Centre<D, N>>,
}

impl<const D: usize, const N: usize, const P: usize> Solids<D, N, P> {
    /// The elements on the undeformed positions of their nodes [L]; `None` where cell and rule
    /// have other numbers.
    pub fn new(recipe: Recipe, elements: impl Iterator<Item = [[f64; D]; N]>) -> Option<Self> {
        let fits =
            recipe.cell.nodes == N && recipe.cell.dimension == D && recipe.rule.points.len() == P;
        if !fits {
            return None;
        }
        // the gradient at the centre of a plane quadrilateral is the mean one; of a ring, whose
        // volume grows with the radius, and of a hexahedron it is not
        let ring = recipe.kinematics == Kinematics::Axisymmetric;
        let fine = match (recipe.formulation.is_one_point(), D) {
            (true, 3) => Some(&HEX_8),
            (true, _) if ring => Some(&QUAD_4),
            _ => None,
        };
        let tables: Box<Tables<D, N, P>> = Box::new(Tables::new(recipe.cell, recipe.rule, fine));
        let elements: Vec<_> = elements.collect();
        let places = elements.iter().map(|nodes| {
            let mean = Place::mean(nodes, &tables.fine, &recipe);
            let at = |k: usize| Place::new(nodes, &tables.points[k], &recipe).0;
            std::array::from_fn(|point| mean.unwrap_or_else(|| at(point)))
        });
        let places = places.collect();
        let rings = elements.iter().filter(|_| ring && fine.is_some());
        let means = rings.map(|nodes| place::mean_shapes(nodes, &tables.fine)).collect();
        let with_modes = recipe.formulation == Formulation::Incompatible;
        let centres = elements.iter().filter(|_| with_modes);
        let centres = centres.map(|nodes| Centre::new(nodes, &tables.centre, &recipe)).collect();
        let heat = Box::new(heat::counts::<D, N, P>(&recipe));
        Some(Self { recipe, tables, heat, means, elements, places, centres })
    }

    fn is_ring(&self) -> bool {
        self.recipe.kinematics == Kinematics::Axisymmetric
    }

    /// Number of state variables of a point.
    fn point_states(&self) -> usize {
        let across = usize::from(self.recipe.kinematics == Kinematics::PlaneStress);
        self.recipe.material.states() + across
    }

    /// The state variables of a point.
    fn of_point<'a>(&self, states: &'a [f64], point: usize) -> &'a [f64] {
        let width = self.point_states();
        states.get(width * point..width * (point + 1)).unwrap_or(&[])
    }

    /// Writes all points, with what the formulation makes of them; what joins all nodes beside
    /// them.
    #[inline(always)]
    fn points(
        &self,
        element: usize,
        q: &[f64],
        (under, committed, state): States<'_, '_>,
        points: &mut [Point<D, N>; P],
    ) -> Result<Option<gather::Joint<D, N>>, Failure> {
        let apart = place::apart(q);
        let places = &self.places[element];
        if self.recipe.formulation == Formulation::MeanDilation {
            let mut gradients = [[[0.0; 3]; 3]; P];
            for (k, (place, gradient)) in places.iter().zip(&mut gradients).enumerate() {
                *gradient = self.gradient([element, k], place, (q, &apart));
            }
            let states = (under, committed, state);
            return self.with_mean_dilation(element, &gradients, states, points).map(Some);
        }
        for (k, (place, point)) in places.iter().zip(points).enumerate() {
            let gradient = self.gradient([element, k], place, (q, &apart));
            self.answer([element, k], (place, &gradient), (under, committed, &mut *state), point)?;
        }
        Ok(None)
    }

    /// Force, tangent, trial state and energy.
    #[inline(always)]
    fn evaluate(&self, task: Task<'_>) -> Result<f64, Failure> {
        let Task { element, q, committed, under, into } = task;
        let Response { force, mut tangent, state } = into;
        let mut points = [Point::<D, N>::EMPTY; P];
        if self.recipe.formulation == Formulation::Incompatible {
            let into = Response { force, tangent, state };
            return self.with_modes(element, q, (committed, under), (&mut points, into));
        }
        let joint = self.points(element, q, (under, committed, state), &mut points)?;
        gather::force(&points, force);
        if let Some(tangent) = tangent.as_deref_mut() {
            gather::tangent(&points, self.is_ring(), joint.as_ref(), tangent);
        }
        let mut held = 0.0;
        if self.recipe.formulation.is_one_point() {
            held = self.hold_modes(element, q, (force, tangent));
        }
        Ok(energy(&points) + held)
    }
}

/// What an element is asked.
struct Task<'a> {
    element: usize,
    q: &'a [f64],
    committed: &'a [f64],
    under: &'a Surroundings<'a>,
    into: Response<'a>,
}

/// An evaluation in the widest vector instructions that the processor has: wider ones change no
/// bit, for every sum keeps its order.
struct Widened<'a, const D: usize, const N: usize, const P: usize>(&'a Solids<D, N, P>, Task<'a>);

impl<const D: usize, const N: usize, const P: usize> pulp::WithSimd for Widened<'_, D, N, P> {
    type Output = Result<f64, Failure>;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> Self::Output {
        self.0.evaluate(self.1)
    }
}

/// Energy of all points.
fn energy<const D: usize, const N: usize>(points: &[Point<D, N>]) -> f64 {
    points.iter().map(|point| point.weight * point.energy).sum()
}

impl<const D: usize, const N: usize, const P: usize> Kernel for Solids<D, N, P> {
    fn count(&self) -> usize {
        self.elements.len()
    }

    fn variables(&self) -> usize {
        D * N
    }

    fn respond(
        &self,
        element: usize,
        q: &[f64],
        committed: &[f64],
        under: &Surroundings<'_>,
        into: Response<'_>,
    ) -> Result<f64, Failure> {
        let task = Task { element, q, committed, under, into };
        pulp::Arch::new().dispatch(Widened(self, task))
    }

    fn scale(&self, element: usize) -> Scale {
        let places = &self.places[element];
        let volume: f64 = places.iter().map(|place| place.weight).sum();
        let content: f64 = places.iter().map(|place| place.content).sum();
        let length = content.powf(1.0 / D as f64);
        let stiffness = self.recipe.material.stiffest() * volume / (length * length);
        Scale { stiffness, length: Some(length) }
    }

    fn dissipated(
        &self,
        element: usize,
        q: &[f64],
        state: &[f64],
        under: &Surroundings<'_>,
    ) -> f64 {
        if !self.recipe.material.dissipates() {
            return 0.0;
        }
        let points = self.committed_points(element, (q, state), under);
        let points = points.iter().flatten();
        points.map(|point| point.weight * point.dissipation).sum()
    }

    fn results(
        &self,
        element: usize,
        q: &[f64],
        state: &[f64],
        under: &Surroundings<'_>,
        into: &mut [f64],
    ) {
        self.write_results(element, (q, state), under, into);
    }
}
