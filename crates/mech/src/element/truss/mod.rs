//! Trusses: bars that stretch and do not bend, exact for any displacement.
//!
//! ```text
//!   1 o=========o 2      1 o====o====o 3     W = sum w A |X'| omega(|x'| / |X'|)
//!     one point                 2   two points
//! ```
//!
//! X' and x' are the derivatives of the undeformed and the deformed axis by the coordinate of the
//! reference cell: docs/theory.md section 3.6. In the plane (`D` = 2) and in space.

use super::heated::weighted;
use super::kernel::{Failure, Kernel, Response, Scale, Surroundings};
use super::solid::Told;
use crate::material::{Conditions, Material};

/// What the trusses of a block have in common.
#[derive(Debug, Clone, PartialEq)]
pub struct Bar {
    /// Material, one without directions of its own.
    pub material: Material,
    /// Undeformed area of the section [L2].
    pub area: f64,
    /// Strains and stresses as results tell them.
    pub told: Told,
}

/// Derivatives of the shape functions at the points of a line of `N` nodes, and their weight.
fn slopes<const N: usize>(point: usize) -> ([f64; N], f64) {
    let mut slopes = [0.0; N];
    if N == 2 {
        slopes.copy_from_slice(&[-0.5, 0.5]);
        return (slopes, 2.0);
    }
    slopes.copy_from_slice(&super::cell::line3_slopes(place(point)));
    (slopes, 1.0)
}

/// Coordinate of one of two points of Gauss.
fn place(point: usize) -> f64 {
    let side = if point == 0 { -1.0 } else { 1.0 };
    side / 3.0_f64.sqrt()
}

/// The trusses of a block: `N` nodes, `P` points.
#[derive(Debug, Clone)]
pub struct Trusses<const D: usize, const N: usize, const P: usize> {
    bar: Bar,
    elements: Vec<[[f64; D]; N]>,
}

/// A point of the axis.
struct Point<const D: usize, const N: usize> {
    /// Derivatives of the shape functions.
    slopes: [f64; N],
    /// Undeformed volume that it stands for [L3].
    volume: f64,
    /// Stretch less one, or the small strain [1].
    stretch: f64,
    /// Derivative of the logarithm of the stretch, or of the small strain, by x' [1/L].
    gradient: [f64; D],
    /// What the square of the gradient becomes: 1/|x'|^2, or zero for small strains [1/L2].
    turning: f64,
}

impl<const D: usize, const N: usize, const P: usize> Trusses<D, N, P> {
    /// Trusses on the undeformed positions of their nodes [L]; `None` for other lines than those
    /// of two nodes and a point or three nodes and two points.
    pub fn new(bar: Bar, elements: impl Iterator<Item = [[f64; D]; N]>) -> Option<Self> {
        let known = (N, P) == (2, 1) || (N, P) == (3, 2);
        known.then(|| Self { bar, elements: elements.collect() })
    }

    fn point(&self, element: usize, point: usize, q: &[f64], large: bool) -> Point<D, N> {
        let (slopes, weight) = slopes::<N>(point);
        let nodes = &self.elements[element];
        let along = |at: &dyn Fn(usize, usize) -> f64| -> [f64; D] {
            std::array::from_fn(|k| (0..N).map(|a| slopes[a] * at(a, k)).sum())
        };
        // slopes sum to zero: differences keep the digits of elements far from the origin
        let before = along(&|a, k| nodes[a][k] - nodes[0][k]);
        let moved = along(&|a, k| q.get(D * a + k).unwrap_or(&0.0) - q.get(k).unwrap_or(&0.0));
        let square = dot(&before, &before);
        let length = square.sqrt();
        let volume = weight * self.bar.area * length;
        if !large {
            let gradient = before.map(|x| x / square);
            return Point {
                slopes,
                volume,
                stretch: dot(&gradient, &moved),
                gradient,
                turning: 0.0,
            };
        }
        let now: [f64; D] = std::array::from_fn(|k| before[k] + moved[k]);
        let current = dot(&now, &now);
        let grown = 2.0 * dot(&before, &moved) + dot(&moved, &moved);
        let stretch = grown / (length * (length + current.sqrt()));
        let gradient = now.map(|x| x / current);
        Point { slopes, volume, stretch, gradient, turning: 1.0 / current }
    }

    /// What the material answers under at a point: two nodes have their mean temperature, as they
    /// have one strain, and three what runs straight through the points.
    fn conditions(point: usize, under: &Surroundings<'_>) -> Conditions {
        let mut shapes = [0.5; N];
        if N == 3 {
            shapes.copy_from_slice(&super::cell::line3_shapes(place(point)));
        }
        let [temperature, initial] =
            [under.temperatures, under.initial].map(|nodes| weighted(&shapes, nodes).value);
        Conditions { large: under.is_large(), temperature, initial, clock: under.clock }
    }

    /// State variables of a point.
    fn of_point<'a>(&self, states: &'a [f64], point: usize) -> &'a [f64] {
        let width = self.bar.material.uniaxial_states();
        states.get(width * point..width * (point + 1)).unwrap_or(&[])
    }
}

impl<const D: usize, const N: usize, const P: usize> Kernel for Trusses<D, N, P> {
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
        let large = under.is_large();
        let Response { force, mut tangent, state } = into;
        let width = self.bar.material.uniaxial_states();
        force.fill(0.0);
        if let Some(tangent) = tangent.as_deref_mut() {
            tangent.fill(0.0);
        }
        let mut energy = 0.0;
        for k in 0..P {
            let point = self.point(element, k, q, large);
            let conditions = Self::conditions(k, under);
            let own = state.get_mut(width * k..width * (k + 1)).unwrap_or_default();
            let before = self.of_point(committed, k);
            let answer = self.bar.material.uniaxial(point.stretch, &conditions, before, own);
            if !answer.energy.is_finite() {
                return Err(Failure::NoThickness(k));
            }
            energy += point.volume * answer.energy;
            let pull = point.volume * answer.stress;
            for (node, slope) in force.chunks_exact_mut(D).zip(point.slopes) {
                node.iter_mut().zip(point.gradient).for_each(|(f, g)| *f += pull * slope * g);
            }
            if let Some(tangent) = tangent.as_deref_mut() {
                let bends = if large { 2.0 * pull } else { 0.0 };
                point.stiffen(point.volume * answer.modulus - bends, pull, tangent);
            }
        }
        Ok(energy)
    }

    fn scale(&self, element: usize) -> Scale {
        let points = (0..P).map(|k| self.point(element, k, &[], false));
        let length = points.map(|point| point.volume / self.bar.area).sum::<f64>();
        Scale {
            stiffness: self.bar.material.stiffest() * self.bar.area / length,
            length: Some(length),
        }
    }

    fn creep_difference(&self, _element: usize, state: &[f64]) -> f64 {
        let own = |point| self.bar.material.creep_difference(self.of_point(state, point));
        (0..P).filter_map(own).fold(0.0, f64::max)
    }

    fn dissipated(
        &self,
        element: usize,
        q: &[f64],
        state: &[f64],
        under: &Surroundings<'_>,
    ) -> f64 {
        if !self.bar.material.dissipates() {
            return 0.0;
        }
        let mut scratch = state.to_vec();
        let width = self.bar.material.uniaxial_states();
        let taken = |k: usize| {
            let point = self.point(element, k, q, under.is_large());
            let own = scratch.get_mut(width * k..width * (k + 1)).unwrap_or_default();
            let before = self.of_point(state, k);
            let conditions = Self::conditions(k, under);
            let answer = self.bar.material.uniaxial(point.stretch, &conditions, before, own);
            point.volume * answer.dissipation
        };
        (0..P).map(taken).sum()
    }

    fn results(
        &self,
        element: usize,
        q: &[f64],
        state: &[f64],
        under: &Surroundings<'_>,
        into: &mut [f64],
    ) {
        let mut scratch = state.to_vec();
        let width = self.bar.material.uniaxial_states();
        for k in 0..P {
            let conditions = Self::conditions(k, under);
            let point = self.point(element, k, q, conditions.large);
            let own = scratch.get_mut(width * k..width * (k + 1)).unwrap_or_default();
            let before = self.of_point(state, k);
            let answer = self.bar.material.uniaxial(point.stretch, &conditions, before, own);
            let e = point.stretch;
            let across = answer.across;
            let (strains, volume) = match (self.bar.told, conditions.large) {
                (_, false) => ([e, across], 1.0),
                // the hot section shrinks at constant volume, as the manual has it
                (Told::Logarithmic, true) => {
                    ([e, across].map(f64::ln_1p), self.bar.material.thermal_volume(&conditions))
                }
                (Told::Green, true) => {
                    ([e, across].map(|e| e + 0.5 * e * e), (1.0 + e) * (1.0 + across).powi(2))
                }
            };
            let [plastic, creep] = self.bar.told.flowed(&self.bar.material, before);
            // field by field: stress, the strains of each point, plastic strain, creep strain
            let [along, across] = strains;
            let values = [
                (k, answer.stress / volume),
                (P + 2 * k, along),
                (P + 2 * k + 1, across),
                (3 * P + k, plastic),
                (4 * P + k, creep),
            ];
            for (place, value) in values {
                if let Some(entry) = into.get_mut(place) {
                    *entry = value;
                }
            }
        }
    }
}

impl<const D: usize, const N: usize> Point<D, N> {
    /// Adds along g g' + across 1/|x'|^2 for every pair of nodes.
    fn stiffen(&self, along: f64, across: f64, tangent: &mut [f64]) {
        let width = D * N;
        for (a, b) in (0..N).flat_map(|a| (0..N).map(move |b| (a, b))) {
            let both = self.slopes[a] * self.slopes[b];
            for i in 0..D {
                for j in 0..D {
                    let even = if i == j { across * self.turning } else { 0.0 };
                    let entry = along * self.gradient[i] * self.gradient[j] + even;
                    tangent[width * (D * a + i) + D * b + j] += both * entry;
                }
            }
        }
    }
}

fn dot<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
