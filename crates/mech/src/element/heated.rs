//! Beams that expand, or whose moduli depend on temperature.
//!
//! ```text
//!    y ^   /   T(y) = T + y dT/dy      mean of both fibres:     axial strain of the free beam
//!      |  /                            difference over height:  its curvature, -a dT/dy
//!      | /
//!      +-----> T
//! ```
//!
//! An element at its temperatures is the cold one with other stiffnesses and with strains that it
//! has when it is free: docs/theory.md eqs. (3.63) and (3.64).

use super::beam_strains::BeamStrains;
use super::instances::{self, array};
use super::kernel::{
    Element, Failure, Kernel, Response, Scale, Strains, Surroundings, Temperature,
};
use crate::material::{Elastic, Expansion, between};
use crate::section::{BeamStiffness, SpaceStiffness};
use crate::turn::Turn;

/// What temperature does to the beams of a section.
#[derive(Clone, Debug, PartialEq)]
pub struct BeamHeat {
    /// How the material expands; `None`: it does not.
    pub expansion: Option<Expansion>,
    /// Elasticity over temperature [theta], ascending; of the first one are the stiffnesses of the
    /// elements.
    pub elastic: Vec<(f64, Elastic)>,
    /// Whether the transverse shear stiffness was given, and stays.
    pub given_shear: bool,
}

impl BeamHeat {
    /// Whether there is anything that temperature does.
    pub fn changes_anything(&self) -> bool {
        self.expansion.is_some() || self.elastic.len() > 1
    }

    /// The stiffnesses of an element at a temperature.
    pub(super) fn stiffness(&self, cold: &BeamStiffness, temperature: f64) -> BeamStiffness {
        let [stretch, shear] = self.softer(temperature);
        BeamStiffness {
            axial: stretch * cold.axial,
            shear: if self.given_shear { cold.shear } else { shear * cold.shear },
            bending: stretch * cold.bending,
            centroid: cold.centroid,
        }
    }

    /// The same of an element in space.
    pub(super) fn space_stiffness(
        &self,
        cold: &SpaceStiffness,
        temperature: f64,
    ) -> SpaceStiffness {
        let [stretch, shear] = self.softer(temperature);
        SpaceStiffness {
            axial: stretch * cold.axial,
            shear: if self.given_shear { cold.shear } else { cold.shear.map(|k| shear * k) },
            torsion: shear * cold.torsion,
            bending: cold.bending.map(|moment| stretch * moment),
            ..*cold
        }
    }

    /// Young's modulus and the shear modulus at a temperature as parts of those of the elements.
    fn softer(&self, temperature: f64) -> [f64; 2] {
        let Some((first, (low, high, part))) =
            self.elastic.first().zip(between(&self.elastic, temperature))
        else {
            return [1.0; 2];
        };
        let elastic = low.towards(high, part);
        [elastic.modulus / first.1.modulus, elastic.shear_modulus() / first.1.shear_modulus()]
    }

    /// Thermal strain of the free element between two temperatures [1].
    pub(super) fn strain(&self, now: f64, initial: f64) -> f64 {
        let Some(expansion) = &self.expansion else { return 0.0 };
        let [strain, ..] = expansion.strains(now, initial);
        strain
    }

    /// Strains of the free element, of two fibres at the radius of gyration about the centroid:
    /// docs/theory.md eq. (3.63).
    pub(super) fn free(
        &self,
        section: &BeamStiffness,
        now: Temperature,
        initial: Temperature,
    ) -> BeamStrains {
        let (mean, growth) = of_two_fibres(section.bending / section.axial, |from_centroid| {
            let y = section.centroid + from_centroid;
            let [now, before] = [now, initial].map(|at| at.value + y * at.slopes[0]);
            self.strain(now, before)
        });
        let curvature = -growth;
        let axial = mean + section.centroid * curvature;
        BeamStrains { axial, shear: 0.0, curvature }
    }

    /// The same in space, in the order axial, shear along axes 1 and 2, twist, curvature about axes 1 and 2, of two fibres along
    /// each axis of the section. Fibres at x1, x2 stretch by k1 x2 - k2 x1. docs/theory.md eq. (3.109).
    pub(super) fn free_in_space(
        &self,
        section: &SpaceStiffness,
        now: Temperature,
        initial: Temperature,
    ) -> [f64; 6] {
        let centroid = section.centroid;
        let grown = |at: [f64; 2]| {
            let here = |own: Temperature| own.value + at[1] * own.slopes[0] + at[0] * own.slopes[1];
            self.strain(here(now), here(initial))
        };
        let [about_1, _, about_2] = section.bending;
        // along axis 2 bends about axis 1, along axis 1 about axis 2
        let [(mean_2, first), (mean_1, second)] =
            [(1, about_1), (0, about_2)].map(|(axis, bending)| {
                of_two_fibres(bending / section.axial, |from_centroid| {
                    let mut at = centroid;
                    at[axis] += from_centroid;
                    grown(at)
                })
            });
        let curvatures = [first, -second];
        let mean = mean_1 + mean_2 - grown(centroid);
        let axial = mean - curvatures[0] * centroid[1] + curvatures[1] * centroid[0];
        [axial, 0.0, 0.0, 0.0, curvatures[0], curvatures[1]]
    }
}

/// Mean strain of two fibres at the radius of gyration on both sides of the centroid, by its square [L2], and growth of the strain from
/// one to the other [1/L]: docs/theory.md eq. (3.63). A section without extent has none.
fn of_two_fibres(square: f64, strain: impl Fn(f64) -> f64) -> (f64, f64) {
    let gyration = square.sqrt();
    let [below, above] = [-gyration, gyration].map(strain);
    let growth = if gyration > 0.0 { 0.5 * (above - below) / gyration } else { 0.0 };
    (0.5 * (below + above), growth)
}

/// What nodes with those shares make of their temperatures.
#[inline(always)]
pub(super) fn weighted(shares: &[f64], nodes: &[Temperature]) -> Temperature {
    // of equal ones the sum is the same bits
    let Some(&first) = nodes.first() else { return Temperature::default() };
    shares.iter().zip(nodes).fold(first, |sum, (share, node)| Temperature {
        value: sum.value + share * (node.value - first.value),
        slopes: [0, 1].map(|k| sum.slopes[k] + share * (node.slopes[k] - first.slopes[k])),
    })
}

/// A beam that can be warmed.
pub trait Heated<const N: usize, const NN: usize>: Element<N, NN> + Copy {
    /// The same element at its temperatures.
    fn warmed(&self, heat: &BeamHeat, under: &Surroundings<'_>) -> Self;
}

/// Beams of one section.
#[derive(Clone, Debug)]
pub struct HeatedBeams<E, const N: usize, const NN: usize> {
    elements: Vec<E>,
    heat: BeamHeat,
}

impl<E: Heated<N, NN>, const N: usize, const NN: usize> HeatedBeams<E, N, NN> {
    /// Those elements, cold.
    pub fn new(elements: impl Iterator<Item = E>, heat: BeamHeat) -> Self {
        Self { elements: elements.collect(), heat }
    }

    fn warmed(&self, element: usize, under: &Surroundings<'_>) -> E {
        self.elements[element].warmed(&self.heat, under)
    }
}

impl<E: Heated<N, NN> + 'static, const N: usize, const NN: usize> Kernel for HeatedBeams<E, N, NN> {
    fn count(&self) -> usize {
        self.elements.len()
    }

    fn variables(&self) -> usize {
        N
    }

    fn estimate_size(&self) -> usize {
        self.elements.first().map_or(0, Element::estimate_size)
    }

    fn respond(
        &self,
        element: usize,
        q: &[f64],
        _committed: &[f64],
        under: &Surroundings<'_>,
        into: Response<'_>,
    ) -> Result<f64, Failure> {
        instances::respond(&self.warmed(element, under), q, under.strains, into)
    }

    fn force_of_stresses(
        &self,
        element: usize,
        (q, _): (&[f64], &[Turn]),
        stresses: &[f64],
        force: &mut [f64],
    ) -> bool {
        // stresses that are given depend on no law
        let Ok(force) = force.try_into() else { return false };
        self.elements[element].force_of_stresses(&array(q), stresses, force)
    }

    fn stresses_after(
        &self,
        element: usize,
        q: &[f64],
        change: &[f64],
        under: &Surroundings<'_>,
        into: &mut [f64],
    ) {
        self.warmed(element, under).stresses_after(&array(q), &array(change), into);
    }

    fn tighten(&self, element: usize, reach: f64, stresses: &mut [f64]) {
        self.elements[element].tighten(reach, stresses);
    }

    fn scale(&self, element: usize) -> Scale {
        self.elements[element].scale()
    }

    fn results(
        &self,
        element: usize,
        q: &[f64],
        _state: &[f64],
        under: &Surroundings<'_>,
        into: &mut [f64],
    ) {
        let linear = under.strains == Strains::Linear;
        self.warmed(element, under).results(&array(q), linear, into);
    }
}
