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
mod incompatible;
mod mean_dilation;
mod modes;
mod place;
mod plane_stress;
mod results;

pub use place::{Reference, smallest_jacobian};
pub use results::Told;

use super::cell::Cell;
use super::kernel::{Kernel, Response, Scale, Strains, Surroundings};
use super::quadrature::{HEX_8, Quadrature};
use crate::axes::Axes;
use crate::material::tensor::{Matrix, Moduli, Symmetric, dilation};
use crate::material::{Answer, Conditions, Material};
use crate::orientation::{Orientation, Oriented};
use place::{Place, Tables};

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
    elements: Vec<[[f64; D]; N]>,
}

/// A point of a deformed element, as forces and tangents are made of it.
#[derive(Debug, Clone, Copy)]
struct Point<const D: usize, const N: usize> {
    /// Undeformed volume it stands for [L3].
    weight: f64,
    /// Derivatives of the shape functions by deformed position, axis by axis [1/L].
    slopes: [[f64; N]; D],
    /// Shape functions over the deformed radius; zeros but for rings [1/L].
    hoop: [f64; N],
    /// H of the displacements, enhanced ones included.
    gradient: Matrix,
    /// J - 1, or the sum of small strains.
    dilation: f64,
    /// Kirchhoff stress that does work on the gradients of displacements.
    stress: Symmetric,
    /// The part of it that turns with them: all, or none where displacements are small.
    turning: Symmetric,
    /// Its moduli.
    moduli: Moduli,
    /// Energy per undeformed volume.
    energy: f64,
}

impl<const D: usize, const N: usize, const P: usize> Solids<D, N, P> {
    /// The elements on the undeformed positions of their nodes [L]; `None` where cell and rule
    /// have other numbers.
    pub fn new(recipe: Recipe, elements: impl Iterator<Item = [[f64; D]; N]>) -> Option<Self> {
        let fits =
            recipe.cell.nodes == N && recipe.cell.dimension == D && recipe.rule.points.len() == P;
        // the gradient at the centre of a quadrilateral is the mean one; of a hexahedron it is not
        let one = recipe.formulation.is_one_point() && D == 3;
        let tables = Box::new(Tables::new(recipe.cell, recipe.rule, one.then_some(&HEX_8)));
        fits.then(|| Self { recipe, tables, elements: elements.collect() })
    }

    fn is_ring(&self) -> bool {
        self.recipe.kinematics == Kinematics::Axisymmetric
    }

    /// Number of state variables of a point.
    fn point_states(&self) -> usize {
        let across = usize::from(self.recipe.kinematics == Kinematics::PlaneStress);
        self.recipe.material.states() + across
    }

    /// The undeformed element with the displacement gradients of `q`.
    fn places(&self, element: usize, q: &[f64], under: &Surroundings<'_>) -> [Place<D, N>; P] {
        let nodes = &self.elements[element];
        let large = under.strains != Strains::Linear;
        std::array::from_fn(|point| {
            let mut place = Place::mean(nodes, &self.tables.fine, &self.recipe)
                .unwrap_or_else(|| Place::new(nodes, &self.tables.points[point], &self.recipe));
            place.follow(q);
            place.axes = self.axes(nodes, &self.tables.points[point].shapes);
            place.conditions = Conditions { large, dt: under.dt, ..Conditions::default() };
            place
        })
    }

    /// Axes of the material at a point with those shape functions.
    fn axes(&self, nodes: &[[f64; D]; N], shapes: &[f64; N]) -> Option<Axes> {
        let orientation = self.recipe.orientation?;
        let point = std::array::from_fn(|k| {
            nodes.iter().zip(shapes).map(|(node, shape)| shape * node[k]).sum()
        });
        Some(orientation.at(nodes, point))
    }

    /// Asks the material, or solves for the strain across the plane first.
    fn ask(
        &self,
        gradient: &mut Matrix,
        place: &Place<D, N>,
        committed: &[f64],
        state: &mut [f64],
    ) -> Answer {
        let (under, axes) = (&place.conditions, place.axes);
        let material = Oriented { material: &self.recipe.material, axes };
        if self.recipe.kinematics == Kinematics::PlaneStress {
            plane_stress::ask(&material, gradient, under, (committed, state))
        } else {
            material.respond(gradient, under, committed, state)
        }
    }

    /// The state variables of a point.
    fn of_point<'a>(&self, states: &'a [f64], point: usize) -> &'a [f64] {
        let width = self.point_states();
        states.get(width * point..width * (point + 1)).unwrap_or(&[])
    }

    /// Answers of all points, each to its own gradient of displacements.
    fn answers(
        &self,
        places: &[Place<D, N>; P],
        large: bool,
        (committed, state): (&[f64], &mut [f64]),
    ) -> [Point<D, N>; P] {
        let width = self.point_states();
        std::array::from_fn(|k| {
            let mut gradient = places[k].gradient;
            let own = state.get_mut(width * k..width * (k + 1)).unwrap_or_default();
            let answer = self.ask(&mut gradient, &places[k], self.of_point(committed, k), own);
            Point::new(&places[k], &gradient, large, &answer)
        })
    }

    /// All points, with what the formulation makes of them; `None` beside them where no linear
    /// combination of nodes is added to the tangent.
    fn points(
        &self,
        places: &[Place<D, N>; P],
        large: bool,
        states: (&[f64], &mut [f64]),
    ) -> ([Point<D, N>; P], Option<mean_dilation::Coupling<D, N>>) {
        if self.recipe.formulation == Formulation::MeanDilation {
            let (points, coupling) = self.with_mean_dilation(places, large, states);
            (points, Some(coupling))
        } else {
            (self.answers(places, large, states), None)
        }
    }
}

impl<const D: usize, const N: usize> Point<D, N> {
    /// A point that its own gradient moves.
    fn new(place: &Place<D, N>, gradient: &Matrix, large: bool, answer: &Answer) -> Self {
        let (slopes, hoop) =
            if large { place.deformed(gradient) } else { (place.slopes, place.over_radius) };
        let dilation = if large {
            dilation(gradient)
        } else {
            gradient[0][0] + gradient[1][1] + gradient[2][2]
        };
        Self {
            weight: place.weight,
            slopes,
            hoop,
            gradient: *gradient,
            dilation,
            stress: answer.stress,
            turning: if large { answer.stress } else { [0.0; 6] },
            moduli: answer.moduli,
            energy: answer.energy,
        }
    }
}

/// Energy of all points; no number where one is turned inside out.
fn energy<const D: usize, const N: usize>(points: &[Point<D, N>], large: bool) -> f64 {
    let folded = |j: f64| j <= -1.0 || j.is_nan();
    let inside_out = large && points.iter().any(|point| folded(point.dilation));
    if inside_out {
        return f64::NAN;
    }
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
    ) -> f64 {
        let large = under.strains != Strains::Linear;
        let places = self.places(element, q, under);
        if self.recipe.formulation == Formulation::Incompatible {
            return self.with_modes((element, &places), q, (committed, large), into);
        }
        let (points, coupling) = self.points(&places, large, (committed, into.state));
        gather::force(&points, into.force);
        let mut tangent = into.tangent;
        if let Some(tangent) = tangent.as_deref_mut() {
            gather::tangent(&points, self.is_ring(), tangent);
            if let Some(coupling) = &coupling {
                coupling.add_tangent(tangent);
            }
        }
        let mut held = 0.0;
        if self.recipe.formulation.is_one_point() {
            held = self.hold_modes((element, &places[0]), q, (into.force, tangent));
        }
        energy(&points, large) + held
    }

    fn scale(&self, element: usize) -> Scale {
        let places = self.places(element, &[], &Strains::Linear.into());
        let volume: f64 = places.iter().map(|place| place.weight).sum();
        let content: f64 = places.iter().map(|place| place.content).sum();
        let length = content.powf(1.0 / D as f64);
        let stiffness = self.recipe.material.stiffest() * volume / (length * length);
        Scale { stiffness, length: Some(length) }
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
