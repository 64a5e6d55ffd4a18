//! One element: its physics, its places, its evaluation.

use super::Flux;
use slideline_mech::element::{
    AxialSpring, Beam21, Beam22, Beam23, BeamStrains, GroundSpring, Mixed,
};
use slideline_mech::section::BeamStiffness;
use std::ops::Range;

/// The most dofs an element has.
pub(super) const WIDTH: usize = 9;

/// Force and tangent (row by row) of an element.
type Slots<'a> = (&'a mut [f64], &'a mut [f64]);

/// Axial strain below which a stress counts as none [1].
const SLIGHT_STRAIN: f64 = 1e-9;
/// Part of the bending stiffness of a beam as long as the model that the
/// geometric stiffness of such a stress may be [1].
const SLIGHT_STIFFNESS: f64 = 1e-3;

/// How strains follow displacements.
#[derive(Clone, Copy, Debug)]
pub(super) enum Kinematics<'a> {
    /// Without NLGEOM: small displacements.
    Linear,
    /// Any displacement; the tangent is the derivative of the force.
    Exact,
    /// Any displacement; the geometric stiffness is that of these stresses.
    Mixed(&'a [f64]),
}

/// What an element is.
#[derive(Clone, Debug)]
pub(super) enum Shape {
    Beam21(Beam21),
    /// By far the largest, and rare.
    Beam22(Box<Beam22>),
    Beam23(Beam23),
    /// A spring to the ground and which of the element's variables it acts on.
    Ground(GroundSpring, usize),
    Axial(AxialSpring),
}

/// One element with its places in the structure's lists.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    pub shape: Shape,
    /// Number of its own variables and where their slots begin.
    pub variables: usize,
    pub first_own: usize,
    /// Where the places of its tangent begin.
    pub first_entry: usize,
    /// Where the estimates of its stresses begin.
    pub first_stress: usize,
}

impl Placed {
    pub fn width(&self) -> usize {
        self.variables
    }

    pub fn own(&self) -> Range<usize> {
        self.first_own..self.first_own + self.variables
    }

    pub fn entries(&self) -> Range<usize> {
        self.first_entry..self.first_entry + self.variables * self.variables
    }

    pub fn stresses(&self) -> Range<usize> {
        self.first_stress..self.first_stress + self.shape.stresses()
    }

    /// The stresses that a linear solution with the `change` of all dofs
    /// arrives at from displacements `u`.
    pub fn stresses_after(&self, (u, change): (&[f64], &[f64]), own: &[usize], into: &mut [f64]) {
        let mut moved = [0.0; WIDTH];
        let moved = &mut moved[..self.variables];
        moved.iter_mut().zip(own).for_each(|(value, &dof)| *value = change[dof]);
        self.shape.stresses_after(u, own, moved, into);
    }

    /// Counts the forces and moments at its nodes.
    #[inline]
    pub fn count(&self, force: &[f64], flux: &mut Flux) {
        match &self.shape {
            Shape::Beam21(_) | Shape::Beam22(_) | Shape::Beam23(_) => {
                for node in force.as_chunks::<3>().0 {
                    flux.force(node[0].hypot(node[1]));
                    flux.moment(node[2].abs());
                }
            }
            Shape::Axial(_) => {
                for node in force.as_chunks::<2>().0 {
                    flux.force(node[0].hypot(node[1]));
                }
            }
            Shape::Ground(_, component) => {
                flux.force(force.get(*component).map_or(0.0, |value| value.abs()));
            }
        }
    }

    /// Strains and section forces of a beam at its middle, (axial, shear,
    /// bending) each.
    pub fn section(&self, u: &[f64], own: &[usize], nlgeom: bool) -> Option<([f64; 3], [f64; 3])> {
        match &self.shape {
            Shape::Beam21(beam) => {
                let q = values(u, own)?;
                let strains = if nlgeom { beam.strains(&q) } else { beam.linear_strains(&q) };
                Some(section(&beam.stiffness, &strains))
            }
            Shape::Beam22(beam) => {
                let q = values(u, own)?;
                let strains = if nlgeom { beam.strains(&q) } else { beam.linear_strains(&q) };
                Some(section(&beam.stiffness, &strains))
            }
            Shape::Beam23(beam) => {
                let q = values(u, own)?;
                let (strains, forces) = if nlgeom {
                    (beam.strains(&q), beam.section_forces(&q))
                } else {
                    (beam.linear_strains(&q), beam.linear_section_forces(&q))
                };
                let strains = [strains.axial, strains.shear, strains.curvature];
                Some((strains, [forces.axial, forces.shear, forces.moment]))
            }
            Shape::Ground(..) | Shape::Axial(_) => None,
        }
    }
}

/// N = EA eps, V = K gam, M = EI kap beside the strains.
fn section(stiffness: &BeamStiffness, strains: &BeamStrains) -> ([f64; 3], [f64; 3]) {
    let of = [strains.axial, strains.shear, strains.curvature];
    (of, [stiffness.axial * of[0], stiffness.shear * of[1], stiffness.bending * of[2]])
}

/// The values of an element's `N` variables; `None` for another number.
fn values<const N: usize>(u: &[f64], own: &[usize]) -> Option<[f64; N]> {
    let own: &[usize; N] = own.try_into().ok()?;
    Some(own.map(|slot| u[slot]))
}

/// `slots` as the arrays of an element with `N` variables.
fn arrays<'a, const N: usize, const NN: usize>(
    (force, tangent): Slots<'a>,
) -> Option<(&'a mut [f64; N], &'a mut [f64; NN])> {
    Some((force.try_into().ok()?, tangent.try_into().ok()?))
}

impl Shape {
    /// How many stresses it has that can be estimated apart.
    pub fn stresses(&self) -> usize {
        match self {
            Self::Beam21(_) | Self::Beam23(_) => 3,
            Self::Beam22(_) => 6,
            Self::Ground(..) | Self::Axial(_) => 0,
        }
    }

    /// The axial stress that a beam without any is given: docs/theory.md
    /// eq. (3.30).
    pub fn slight_tension(&self, reach: f64) -> f64 {
        let BeamStiffness { axial, bending, .. } = match self {
            Self::Beam21(beam) => beam.stiffness,
            Self::Beam22(beam) => beam.stiffness,
            Self::Beam23(beam) => beam.stiffness(),
            Self::Ground(..) | Self::Axial(_) => return 0.0,
        };
        let by_bending = SLIGHT_STIFFNESS * bending / (reach * reach);
        (SLIGHT_STRAIN * axial).min(by_bending)
    }

    fn stresses_after(&self, u: &[f64], own: &[usize], change: &[f64], into: &mut [f64]) {
        match self {
            Self::Beam21(beam) => stresses_after(beam, u, own, change, into),
            Self::Beam22(beam) => stresses_after(beam.as_ref(), u, own, change, into),
            Self::Beam23(beam) => stresses_after(beam, u, own, change, into),
            Self::Ground(..) | Self::Axial(_) => None,
        };
    }

    /// Writes the force of the estimated stresses, where there are any.
    pub fn force_of_stresses(
        &self,
        u: &[f64],
        own: &[usize],
        kinematics: Kinematics<'_>,
        force: &mut [f64],
    ) -> bool {
        let Kinematics::Mixed(stresses) = kinematics else { return false };
        let done = match self {
            Self::Beam21(beam) => force_of_stresses(beam, u, own, stresses, force),
            Self::Beam22(beam) => force_of_stresses(beam.as_ref(), u, own, stresses, force),
            Self::Beam23(beam) => force_of_stresses(beam, u, own, stresses, force),
            Self::Ground(..) | Self::Axial(_) => None,
        };
        done.is_some()
    }

    /// Writes force and tangent by the element's own variables, returns the
    /// energy [F L].
    #[inline]
    pub fn evaluate(
        &self,
        u: &[f64],
        own: &[usize],
        kinematics: Kinematics<'_>,
        slots: Slots<'_>,
    ) -> f64 {
        if let Kinematics::Mixed(stresses) = kinematics {
            let mixed = match self {
                Self::Beam21(beam) => mixed(beam, u, own, stresses, slots),
                Self::Beam22(beam) => mixed(beam.as_ref(), u, own, stresses, slots),
                Self::Beam23(beam) => mixed(beam, u, own, stresses, slots),
                Self::Ground(..) | Self::Axial(_) => {
                    self.evaluate(u, own, Kinematics::Exact, slots).into()
                }
            };
            return mixed.unwrap_or(0.0);
        }
        let nlgeom = matches!(kinematics, Kinematics::Exact);
        match self {
            Self::Beam21(beam) => match (values(u, own), arrays(slots)) {
                (Some(q), Some((force, tangent))) if nlgeom => {
                    beam.force_and_tangent(&q, force, tangent)
                }
                (Some(q), Some((force, tangent))) => {
                    beam.linear_force_and_tangent(&q, force, tangent)
                }
                _ => 0.0,
            },
            Self::Beam22(beam) => match (values(u, own), arrays(slots)) {
                (Some(q), Some((force, tangent))) if nlgeom => {
                    beam.force_and_tangent(&q, force, tangent)
                }
                (Some(q), Some((force, tangent))) => {
                    beam.linear_force_and_tangent(&q, force, tangent)
                }
                _ => 0.0,
            },
            Self::Beam23(beam) => match (values(u, own), arrays(slots)) {
                (Some(q), Some((force, tangent))) if nlgeom => {
                    beam.force_and_tangent(&q, force, tangent)
                }
                (Some(q), Some((force, tangent))) => {
                    beam.linear_force_and_tangent(&q, force, tangent)
                }
                _ => 0.0,
            },
            Self::Axial(spring) => match (values(u, own), arrays(slots)) {
                (Some(q), Some((force, tangent))) if nlgeom => {
                    spring.force_and_tangent(&q, force, tangent)
                }
                (Some(q), Some((force, tangent))) => {
                    spring.linear_force_and_tangent(&q, force, tangent)
                }
                _ => 0.0,
            },
            Self::Ground(spring, component) => ground(spring, *component, u, own, slots),
        }
    }
}

fn mixed<const N: usize, const NN: usize, const S: usize>(
    element: &impl Mixed<N, NN, S>,
    u: &[f64],
    own: &[usize],
    stresses: &[f64],
    slots: Slots<'_>,
) -> Option<f64> {
    let (force, tangent) = arrays(slots)?;
    let stresses = stresses.try_into().ok()?;
    Some(element.force_and_mixed_tangent(&values(u, own)?, stresses, force, tangent))
}

fn stresses_after<const N: usize, const NN: usize, const S: usize>(
    element: &impl Mixed<N, NN, S>,
    u: &[f64],
    own: &[usize],
    change: &[f64],
    into: &mut [f64],
) -> Option<()> {
    let stresses = element.stresses_after(&values(u, own)?, change.try_into().ok()?);
    into.copy_from_slice(&stresses);
    Some(())
}

fn force_of_stresses<const N: usize, const NN: usize, const S: usize>(
    element: &impl Mixed<N, NN, S>,
    u: &[f64],
    own: &[usize],
    stresses: &[f64],
    force: &mut [f64],
) -> Option<()> {
    let of = element.force_of_stresses(&values(u, own)?, stresses.try_into().ok()?);
    force.copy_from_slice(&of);
    Some(())
}

fn ground(
    spring: &GroundSpring,
    component: usize,
    u: &[f64],
    own: &[usize],
    (force, tangent): Slots<'_>,
) -> f64 {
    let displacement = u[own[component]];
    let (value, stiffness) = spring.force_and_tangent(displacement);
    force.fill(0.0);
    tangent.fill(0.0);
    force[component] = value;
    tangent[component * (own.len() + 1)] = stiffness;
    spring.energy(displacement)
}
